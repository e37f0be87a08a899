"""Bodies of axicontact._runtime.functions over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.functions import Array, Sequence
from ...._runtime.plain import MATH as np


def rational(v: Array, top: Sequence[float], bottom: Sequence[float]) -> Array:
    """P(v)/Q(v) with coefficients in ascending order, for v >= 0; the terms of either do not cancel."""
    above, below = top[-1], bottom[-1]
    for coefficient in top[-2::-1]:
        above = above * v + coefficient
    for coefficient in bottom[-2::-1]:
        below = below * v + coefficient
    return above / below


def nth_root(x: Array, n: Array, more: int = 0) -> Array:
    """x**(1/(n + more)) for x >= 0; Newton's step makes good what the rounded exponent did, up to ln(x) units."""
    degree = n + more
    y = x ** (1.0 / degree)
    return np.where((x > 0.0) & (x < np.inf), y + y * ((x / (y**n * y**more) - 1.0) / degree), y)
