"""Bodies of axicontact.normal.truncated_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, tan

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope_beyond(t, root, theta, b):
    v6 = tan(theta)
    return v6 * atan(root / b) + b * v6 / root


def _depth_at(a, root, theta, b):
    return tan(theta) * a * atan(root / b)


def _depth(a, theta, b):
    return tan(theta) * a * atan(sqrt((a - b) * (a + b)) / b)


def _force_at(a, root, theta, b, E_star):
    return E_star * tan(theta) * (a * a * atan(root / b) + b * root)


def _force(a, theta, b, E_star):
    v7 = sqrt((a - b) * (a + b))
    return E_star * tan(theta) * (a * a * atan(v7 / b) + b * v7)


def _displacement(r, a, theta, b):
    if a >= b:
        v4 = r - b
        v11 = a - b
        v13 = a + b
        v60 = tan(theta)
        if r > a:
            if a > b:
                v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (r + b))
                v10 = b / r
                v16 = r - a
                v21 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * v13) / sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (r + a))
                v23 = asinh(v21 / v10)
                v28 = 0.0 - expm1(-2.0 * v23)
                v31 = v28 if v28 > 0.0 else inf
                v48 = b * b
                v52 = v10 * v10
                v62 = b * v60
                v71 = []
                for node, weight in RULE_0(v23 / 1.0):
                    v33 = node * v23
                    v42 = v21 * (exp(-v33) * (0.0 - expm1(-2.0 * (v23 - v33))) / v31)
                    v43 = v42 * v42
                    v45 = sqrt(1.0 + v43)
                    v47 = v9 * v42 / v45
                    v51 = sqrt(v48 + v47 * v47)
                    v70 = (v60 * atan(v47 / b) + v62 / v47) * v47 / v51 * atan2(v51, v9 / v45) * (sqrt(v52 + v43) / (v45 * v45 * v45))
                    v71.append(weight * v70)
                v71 = fsum(v71) * v23
                v73 = v9 * v71
            else:
                v73 = 0.0
            return 0.6366197723675814 * v73
        return v60 * a * atan(sqrt(v11 * v13) / b) - (0.0 if r < b else v60 * v4)
    return nan


def _contact_from_depth(d, theta, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, theta, b)
        return (value, root * root / a * _slope_beyond(a, root, theta, b) / value)
    rest = (1.587574, -0.008072401, -0.4352508, -3.570796, 8.66489, -8.150206, 3.403791, -0.4812051)
    start = between(np.log(d / curve(1.0)[0]), (0.9003, 1.0), (1.414, 1.0), -6.0, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_depth(d, theta, b):
    return _contact_from_depth(d, theta, b)[0]


def _contact_from_force(F, theta, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, theta, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, theta, b) / value)
    rest = (0.9995205, 0.100541, -0.3986471, 4.536442, -19.76727, 34.2219, -25.89697, 7.204481)
    start = between(np.log(F / curve(1.0)[0]), (0.778, 1.0), (0.611, 2.0), -2.75, rest)
    t = inverse(curve, F, start, (1.0, 2.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, theta, b, E_star):
    return _contact_from_force(F, theta, b, E_star)[0]


def _force_from_depth(d, theta, b, E_star):
    a, root = _contact_from_depth(d, theta, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, theta, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, theta, b, E_star) + change


def _depth_from_force(F, theta, b, E_star):
    a, root = _contact_from_force(F, theta, b, E_star)
    change = (F - _force_at(a, root, theta, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, theta, b) + change
