"""Bodies of axicontact.normal.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import fsum, inf, nan

from ...._programs.bodies._runtime.inverse import between, inverse_below
from ...._runtime.plain import rule, MATH as np

RULE_0 = rule(((inf, 32),))


def _slope(t, h, s):
    v3 = t / s
    v7 = v3 * v3
    v45 = ((((((((((((1.567077144036674e-13 * v7 + -3.840375691006307e-12) * v7 + 3.8015754128174666e-11) * v7 + -1.8423006918213799e-10) * v7 + 4.472469827763728e-10) * v7 + -1.1927516362741588e-09) * v7 + 6.225892246861416e-09) * v7 + 3.4413148480148793e-09) * v7 + -9.933344851449817e-08) * v7 + -5.127541706569233e-07) * v7 + 1.8119768160503268e-06) * v7 + 2.151585040783394e-05) * v7 + 4.61098799999374e-06) * v7
    v63 = v3 / ((((((v45 + -0.000684089638073553) * v7 + -0.002257495580553435) * v7 + 0.016931216930225715) * v7 + 0.17777777777782838) * v7 + 0.6666666666666656) * v7 + 1.0)
    return 2.0 * h / s * (v63 + (1.0 - 2.0 * v63 * v3) * v3)


def _depth(a, h, s):
    if a <= 1.5019752682686114 * s:
        v3 = a / s
        v9 = v3 * v3
        v47 = ((((((((((((1.567077144036674e-13 * v9 + -3.840375691006307e-12) * v9 + 3.8015754128174666e-11) * v9 + -1.8423006918213799e-10) * v9 + 4.472469827763728e-10) * v9 + -1.1927516362741588e-09) * v9 + 6.225892246861416e-09) * v9 + 3.4413148480148793e-09) * v9 + -9.933344851449817e-08) * v9 + -5.127541706569233e-07) * v9 + 1.8119768160503268e-06) * v9 + 2.151585040783394e-05) * v9 + 4.61098799999374e-06) * v9
        return 2.0 * h * (v3 / ((((((v47 + -0.000684089638073553) * v9 + -0.002257495580553435) * v9 + 0.016931216930225715) * v9 + 0.17777777777782838) * v9 + 0.6666666666666656) * v9 + 1.0)) * v3
    return nan


def _force(a, h, s, E_star):
    if a <= 1.5019752682686114 * s:
        v10 = 2.0 * h / s
        v74 = []
        for node, weight in RULE_0(a / 1.0):
            v7 = node * a
            v8 = v7 / s
            v11 = v8 * v8
            v49 = ((((((((((((1.567077144036674e-13 * v11 + -3.840375691006307e-12) * v11 + 3.8015754128174666e-11) * v11 + -1.8423006918213799e-10) * v11 + 4.472469827763728e-10) * v11 + -1.1927516362741588e-09) * v11 + 6.225892246861416e-09) * v11 + 3.4413148480148793e-09) * v11 + -9.933344851449817e-08) * v11 + -5.127541706569233e-07) * v11 + 1.8119768160503268e-06) * v11 + 2.151585040783394e-05) * v11 + 4.61098799999374e-06) * v11
            v66 = v8 / ((((((v49 + -0.000684089638073553) * v11 + -0.002257495580553435) * v11 + 0.016931216930225715) * v11 + 0.17777777777782838) * v11 + 0.6666666666666656) * v11 + 1.0)
            v73 = v7 * (v10 * (v66 + (1.0 - 2.0 * v66 * v8) * v8))
            v74.append(weight * v73)
        v74 = fsum(v74) * a
        return 2.0 * E_star * v74
    return nan


def _radius_from_depth(d, h, s):

    def curve(a):
        value = _depth(a, h, s)
        return (value, a * _slope(a, h, s) / value)

    def like(short):
        rest = (1.003776, 0.2435676, 0.7000671, -0.6766533, 4.031949, -6.599278, 3.971419, -0.793611)
        return between(np.log(short / 0.6348098), (1.575, 2.0), (0.4486, 2.0), -6.0, rest)
    largest = 1.5019752682686114 * s * np.ones_like(d)
    return inverse_below(curve, d, largest, (1.0, 2.0), like)


def _radius_from_force(F, h, s, E_star):

    def curve(a):
        value = _force(a, h, s, E_star)
        return (value, 2 * E_star * a ** 2 * _slope(a, h, s) / value)

    def like(short):
        rest = (0.9994039, 0.6765872, -1.514105, 16.18697, -61.13223, 108.1267, -95.20743, 32.86326)
        return between(np.log(short / 1.360193), (1.659, 2.0), (0.1392, 3.0), -6.0, rest)
    largest = 1.5019752682686114 * s * np.ones_like(F)
    return inverse_below(curve, F, largest, (1.0, 3.0), like)


def _force_from_depth(d, h, s, E_star):
    a = _radius_from_depth(d, h, s)
    change = 2 * E_star * a * (d - _depth(a, h, s)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, h, s, E_star) + change


def _depth_from_force(F, h, s, E_star):
    a = _radius_from_force(F, h, s, E_star)
    change = (F - _force(a, h, s, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, h, s) + change
