"""Bodies of axicontact.normal.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.functions import nth_root
from ...._runtime.plain import MATH as np


def _depth(a, A):
    return 8 * A / 3 * a ** 4


def _force(a, A, E_star):
    return 64 * E_star * A / 15 * a ** 5


def _radius_from_depth(d, A):
    return np.sqrt(np.sqrt(3 * d / (8 * A)))


def _radius_from_force(F, A, E_star):
    return nth_root(15 * F / (64 * E_star * A), 5)


def _force_from_depth(d, A, E_star):
    return 4 * E_star / 5 * d * np.sqrt(np.sqrt(6 * d / A))
