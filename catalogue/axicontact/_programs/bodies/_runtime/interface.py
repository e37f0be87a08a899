"""Bodies of axicontact._runtime.interface over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.plain import MATH as np


def either(condition, x, y):
    """x() where the condition holds and y() elsewhere; what is chosen nowhere is not asked for."""
    if np.all(condition):
        return x()
    return (x() if condition else y()) if np.any(condition) else y()
