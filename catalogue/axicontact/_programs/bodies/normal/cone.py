"""Bodies of axicontact.normal.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._runtime.plain import MATH as np


def _depth(a, theta):
    return np.pi * np.tan(theta) * a / 2


def _force(a, theta, E_star):
    return np.pi * E_star * np.tan(theta) * a ** 2 / 2


def _radius_from_depth(d, theta):
    return 2 * d / (np.pi * np.tan(theta))


def _radius_from_force(F, theta, E_star):
    return np.sqrt(2 * F / (np.pi * E_star * np.tan(theta)))


def _force_from_depth(d, theta, E_star):
    return 2 * E_star / (np.pi * np.tan(theta)) * d ** 2
