"""Bodies of axicontact.normal.sextic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf, pow



def _depth(a, A):
    return 16.0 * A / 5.0 * pow(a, 6.0)


def _force(a, A, E_star):
    return 192.0 * E_star * A / 35.0 * pow(a, 7.0)


def _radius_from_depth(d, A):
    v6 = 5.0 * d / (16.0 * A)
    v8 = pow(v6, 0.16666666666666666)
    if v6 > 0.0 and v6 < inf:
        return v8 + v8 * ((v6 / (pow(v8, 6.0) * pow(v8, 0.0)) - 1.0) / 6.0)
    return v8


def _radius_from_force(F, A, E_star):
    v8 = 35.0 * F / (192.0 * E_star * A)
    v10 = pow(v8, 0.14285714285714285)
    if v8 > 0.0 and v8 < inf:
        return v10 + v10 * ((v8 / (pow(v10, 7.0) * pow(v10, 0.0)) - 1.0) / 7.0)
    return v10


def _force_from_depth(d, A, E_star):
    v10 = 20.0 * d / A
    v12 = pow(v10, 0.16666666666666666)
    return 6.0 * E_star / 7.0 * d * (v12 + v12 * ((v10 / (pow(v12, 6.0) * pow(v12, 0.0)) - 1.0) / 6.0) if v10 > 0.0 and v10 < inf else v12)
