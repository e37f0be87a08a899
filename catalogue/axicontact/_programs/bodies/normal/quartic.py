"""Bodies of axicontact.normal.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf, pow

from ...._runtime.plain import sqrt


def _depth(a, A):
    v8 = a * a
    return 8.0 * A / 3.0 * (v8 * v8)


def _force(a, A, E_star):
    return 64.0 * E_star * A / 15.0 * pow(a, 5.0)


def _radius_from_depth(d, A):
    return sqrt(sqrt(3.0 * d / (8.0 * A)))


def _radius_from_force(F, A, E_star):
    v8 = 15.0 * F / (64.0 * E_star * A)
    v10 = pow(v8, 0.2)
    if v8 > 0.0 and v8 < inf:
        return v10 + v10 * ((v8 / (pow(v10, 5.0) * pow(v10, 0.0)) - 1.0) / 5.0)
    return v10


def _force_from_depth(d, A, E_star):
    return 4.0 * E_star / 5.0 * d * sqrt(sqrt(6.0 * d / A))
