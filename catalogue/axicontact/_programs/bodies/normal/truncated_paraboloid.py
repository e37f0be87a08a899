"""Bodies of axicontact.normal.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, nan

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope_beyond(t, root, R, b):
    return 2.0 * root / R + b * b / (R * root)


def _depth_at(a, root, R):
    return a * root / R


def _depth(a, R, b):
    return a * sqrt((a - b) * (a + b)) / R


def _force_at(a, root, R, b, E_star):
    return 2.0 * E_star / (3.0 * R) * (2.0 * (a * a) + b * b) * root


def _force(a, R, b, E_star):
    return 2.0 * E_star / (3.0 * R) * (2.0 * (a * a) + b * b) * sqrt((a - b) * (a + b))


def _displacement(r, a, R, b):
    if a >= b:
        v4 = r - b
        v7 = r + b
        v11 = a - b
        v13 = a + b
        if r > a:
            if a > b:
                v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * v7)
                v10 = b / r
                v16 = r - a
                v21 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * v13) / sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (r + a))
                v23 = asinh(v21 / v10)
                v28 = 0.0 - expm1(-2.0 * v23)
                v31 = v28 if v28 > 0.0 else inf
                v48 = b * b
                v52 = v10 * v10
                v61 = b * b
                v71 = []
                for node, weight in RULE_0(v23 / 1.0):
                    v33 = node * v23
                    v42 = v21 * (exp(-v33) * (0.0 - expm1(-2.0 * (v23 - v33))) / v31)
                    v43 = v42 * v42
                    v45 = sqrt(1.0 + v43)
                    v47 = v9 * v42 / v45
                    v51 = sqrt(v48 + v47 * v47)
                    v70 = (2.0 * v47 / R + v61 / (R * v47)) * v47 / v51 * atan2(v51, v9 / v45) * (sqrt(v52 + v43) / (v45 * v45 * v45))
                    v71.append(weight * v70)
                v71 = fsum(v71) * v23
                v73 = v9 * v71
            else:
                v73 = 0.0
            return 0.6366197723675814 * v73
        return a * sqrt(v11 * v13) / R - (0.0 if r < b else v4 * v7 / (2.0 * R))
    return nan


def _radius_from_depth(d, R, b):
    v5 = b * b
    return sqrt(sqrt(v5 * v5 + 4.0 * (R * R) * (d * d)) / R + v5 / R) * sqrt(2.0 * R) / 2.0


def _contact_from_force(F, R, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, R, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value)
    rest = (0.9990587, 0.3089073, -0.7678073, 7.512052, -39.30687, 76.63965, -63.48232, 19.09787)
    start = between(np.log(F / curve(1.0)[0]), (0.6, 1.0), (0.4, 3.0), -1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, R, b, E_star):
    return _contact_from_force(F, R, b, E_star)[0]


def _contact_from_depth(d, R, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, R)
        return (value, root * root / a * _slope_beyond(a, root, R, b) / value)
    rest = (0.9996917, 0.05914493, 0.009062067, 1.353675, -12.15272, 28.05264, -25.52146, 8.200478)
    start = between(np.log(d / curve(1.0)[0]), (0.7071, 1.0), (0.7071, 2.0), -3.0, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _force_from_depth(d, R, b, E_star):
    a, root = _contact_from_depth(d, R, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, R)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F, R, b, E_star):
    a, root = _contact_from_force(F, R, b, E_star)
    change = (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, R) + change
