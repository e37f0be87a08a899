"""Bodies of axicontact._runtime.integrals over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.integrals import Course
from ...._runtime.plain import MATH as np


def of_displacement(a, *other):
    """Outside the contact."""
    return (Course(a, a * a, False), a, np.inf)


def difference_root(x, y):
    """sqrt(x**2 - y**2), and zero for x < y."""
    return np.sqrt(np.maximum(x - y, 0.0) * (x + y))
