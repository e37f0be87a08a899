"""Bodies of axicontact.normal.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....normal.cone import Array
from ...._runtime.plain import MATH as np


def _depth(a: Array, theta: Array) -> Array:
    return np.pi * np.tan(theta) * a / 2


def _force(a: Array, theta: Array, E_star: Array) -> Array:
    return np.pi * E_star * np.tan(theta) * a ** 2 / 2


def _radius_from_depth(d: Array, theta: Array) -> Array:
    return 2 * d / (np.pi * np.tan(theta))


def _radius_from_force(F: Array, theta: Array, E_star: Array) -> Array:
    return np.sqrt(2 * F / (np.pi * E_star * np.tan(theta)))


def _force_from_depth(d: Array, theta: Array, E_star: Array) -> Array:
    return 2 * E_star / (np.pi * np.tan(theta)) * d ** 2
