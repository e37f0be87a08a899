"""Bodies of axicontact.normal.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....normal.paraboloid import Array
from ...._runtime.plain import MATH as np


def _depth(a: Array, R: Array) -> Array:
    return a ** 2 / R


def _force(a: Array, R: Array, E_star: Array) -> Array:
    return 4 * E_star / (3 * R) * a ** 3


def _radius_from_depth(d: Array, R: Array) -> Array:
    return np.sqrt(R * d)


def _radius_from_force(F: Array, R: Array, E_star: Array) -> Array:
    return np.cbrt(3 * R / (4 * E_star) * F)


def _force_from_depth(d: Array, R: Array, E_star: Array) -> Array:
    return 4 * E_star / 3 * d * np.sqrt(R * d)
