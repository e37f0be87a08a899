"""Bodies of axicontact.normal.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import cbrt

from ...._runtime.plain import sqrt


def _depth(a, R):
    return a * a / R


def _force(a, R, E_star):
    return 4.0 * E_star / (3.0 * R) * (a * (a * a))


def _radius_from_depth(d, R):
    return sqrt(R * d)


def _radius_from_force(F, R, E_star):
    return cbrt(3.0 * R / (4.0 * E_star) * F)


def _force_from_depth(d, R, E_star):
    return 4.0 * E_star / 3.0 * d * sqrt(R * d)
