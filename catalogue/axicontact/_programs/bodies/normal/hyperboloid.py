"""Bodies of axicontact.normal.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, tan

from ...._programs.bodies._runtime.inverse import inverse
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope(t, theta, b):
    v5 = tan(theta)
    return v5 * atan(t / b) + b * v5 * t / (t * t + b * b)


def _depth(a, theta, b):
    return tan(theta) * a * atan(a / b)


def _force(a, theta, b, E_star):
    v11 = a / b
    if v11 < 1.0:
        v15 = v11 * v11
        v58 = v11 * v15 * (((((((2.229767813968649e-06 * v15 + 0.0021043873129700233) * v15 + 0.04325113828415611) * v15 + 0.2725778671008127) * v15 + 0.7123414383945195) * v15 + 0.8116412201960678) * v15 + 0.3333333333333333) / ((((((0.002445452808893491 * v15 + 0.06453295925870227) * v15 + 0.5368820963772863) * v15 + 1.9680296155712274) * v15 + 3.5294070829658954) * v15 + 3.034923660588189) * v15 + 1.0))
    else:
        v58 = v11 - atan(v11)
    return E_star * tan(theta) * (a * a * atan2(a, b) + b * b * v58)


def _displacement(r, a, theta, b):
    v49 = tan(theta)
    v55 = b * b
    if r > a:
        v8 = b / sqrt(r * r + b * b)
        v9 = r - a
        v15 = a / sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (r + a))
        v17 = asinh(v15 / v8)
        v22 = 0.0 - expm1(-2.0 * v17)
        v25 = v22 if v22 > 0.0 else inf
        v39 = v8 * v8
        v51 = b * v49
        v62 = []
        for node, weight in RULE_0(v17 / 1.0):
            v26 = node * v17
            v35 = v15 * (exp(-v26) * (0.0 - expm1(-2.0 * (v17 - v26))) / v25)
            v36 = v35 * v35
            v38 = sqrt(1.0 + v36)
            v46 = r * v35 / v38
            v61 = (v49 * atan(v46 / b) + v51 * v46 / (v46 * v46 + v55)) * atan(v35) * (sqrt(v39 + v36) / (v38 * v38 * v38))
            v62.append(weight * v61)
        v62 = fsum(v62) * v17
        return 0.6366197723675814 * (r * v62)
    v71 = r * r
    return v49 * a * atan(a / b) - v49 * v71 / (sqrt(v71 + v55) + b)


def _radius_from_depth(d, theta, b):

    def curve(a):
        value = _depth(a, theta, b)
        return (value, a * _slope(a, theta, b) / value)
    return inverse(curve, d, b / 1000 * np.ones_like(d), (1.0, 2.0), smooth=True)


def _radius_from_force(F, theta, b, E_star):

    def curve(a):
        value = _force(a, theta, b, E_star)
        return (value, 2 * E_star * a ** 2 * _slope(a, theta, b) / value)
    return inverse(curve, F, b / 1000 * np.ones_like(F), (2.0, 3.0), smooth=True)


def _force_from_depth(d, theta, b, E_star):
    a = _radius_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth(a, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, theta, b, E_star) + change


def _depth_from_force(F, theta, b, E_star):
    a = _radius_from_force(F, theta, b, E_star)
    change = (F - _force(a, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, theta, b) + change
