"""Bodies of axicontact._runtime.integrals over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.integrals import Course
from ...._runtime.plain import sqrt, MATH as np


def of_pressure(a, b):
    """Inside and outside the break at b; next to it where the contact has hardly passed it, r says too little."""
    if not a > b * (1.0 + 1e-06):
        return (None, 0.0, a)
    return (Course(b, (a - b) * (a + b), True, a, b * b), 0.0, a)


def of_displacement(a, *other):
    """Outside the contact."""
    return (Course(a, a * a, False), a, np.inf)


def difference_root(x, y):
    v2 = x - y
    return sqrt((v2 if v2 > 0.0 or v2 != v2 else 0.0) * (x + y))
