"""Bodies of axicontact._runtime.integrals over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.integrals import Array
from ...._runtime.plain import MATH as np


def difference_root(x: Array, y: Array) -> Array:
    """sqrt(x**2 - y**2), and zero for x < y."""
    return np.sqrt(np.maximum(x - y, 0.0) * (x + y))
