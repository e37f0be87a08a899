"""Bodies of axicontact.normal.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan, tan

from ...._runtime.plain import sqrt


def _depth(a, theta):
    return 3.141592653589793 * tan(theta) * a / 2.0


def _force(a, theta, E_star):
    return 3.141592653589793 * E_star * tan(theta) * (a * a) / 2.0


def _displacement(r, a, theta):
    v3 = tan(theta)
    if r > a:
        v10 = a / (r + sqrt((r - a) * (r + a)))
        return v3 * a * (2.0 * atan(v10) - v10)
    return 3.141592653589793 * v3 * a / 2.0 - v3 * r


def _radius_from_depth(d, theta):
    return 2.0 * d / (3.141592653589793 * tan(theta))


def _radius_from_force(F, theta, E_star):
    return sqrt(2.0 * F / (3.141592653589793 * E_star * tan(theta)))


def _force_from_depth(d, theta, E_star):
    return 2.0 * E_star / (3.141592653589793 * tan(theta)) * (d * d)
