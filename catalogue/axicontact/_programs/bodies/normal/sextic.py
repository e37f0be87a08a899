"""Bodies of axicontact.normal.sextic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf, pow

from ...._runtime.plain import sqrt


def _depth(a, A):
    return 16.0 * A / 5.0 * pow(a, 6.0)


def _force(a, A, E_star):
    return 192.0 * E_star * A / 35.0 * pow(a, 7.0)


def _displacement(r, a, A):
    v8 = pow(a, 6.0)
    if r > a:
        v15 = a / (r + sqrt((r - a) * (r + a)))
        v17 = v15 * v15
        return 32.0 * A / 15.707963267948966 * v8 * (a / r * (0.8571428571428571 + v17 * (((((((((-1.2774361052403345 * v17 + -23.178809850601194) * v17 + -181.92316258227586) * v17 + -611.3425551498234) * v17 + -362.00165963521414) * v17 + 2098.825846649865) * v17 + 3992.6681072942106) * v17 + 2012.329045387071) * v17 + 0.44444444444468756) / ((((((((0.008653162919782199 * v17 + -0.42336499735873506) * v17 + 23.453299031698904) * v17 + 657.0260884407312) * v17 + 4128.7190564480725) * v17 + 10373.373159937977) * v17 + 11371.059137910102) * v17 + 4528.267624848188) * v17 + 1.0))))
    return 16.0 * A / 5.0 * v8 - A * pow(r, 6.0)


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
