"""Bodies of axicontact.normal.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.plain import MATH as np


def _depth(a, R):
    return a ** 2 / R


def _force(a, R, E_star):
    return 4 * E_star / (3 * R) * a ** 3


def _radius_from_depth(d, R):
    return np.sqrt(R * d)


def _radius_from_force(F, R, E_star):
    return np.cbrt(3 * R / (4 * E_star) * F)


def _force_from_depth(d, R, E_star):
    return 4 * E_star / 3 * d * np.sqrt(R * d)
