"""Bodies of axicontact.normal.ellipsoid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, nan, tanh

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._programs.bodies._runtime.shapes.arcs import arc_strips
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope(t, root, h, b):
    return h / b * asinh(t / root) + h * t / (root * root)


def _depth_at(a, root, h, b):
    return h / b * a * asinh(a / root)


def _depth(a, h, b):
    return h / b * a * (log1p(2.0 * a / (b - a)) / 2.0)


def _force_at(a, root, h, b, E_star):
    v6 = asinh(a / root)
    v8 = tanh(v6)
    if v6 < 1.0:
        v14 = v6 * v6
        v49 = v8 * (v8 * v8) * ((((((1.0716932453474512e-06 * v14 + 0.00019982814521087247) * v14 + 0.007076196047699156) * v14 + 0.08608622548411103) * v14 + 0.3073858328214721) * v14 + 0.3333333333333333) / (((((2.565078604208634e-08 * v14 + 2.0203143566039827e-05) * v14 + 0.001617010334189783) * v14 + 0.03639274880225476) * v14 + 0.32215749846441627) * v14 + 1.0))
    else:
        v49 = v6 - v8
    return E_star * h * (b * v49 + a * a * v6 / b)


def _force(a, h, b, E_star):
    v9 = log1p(2.0 * a / (b - a)) / 2.0
    v14 = a / b
    if v9 < 1.0:
        v20 = v9 * v9
        v55 = v14 * (v14 * v14) * ((((((1.0716932453474512e-06 * v20 + 0.00019982814521087247) * v20 + 0.007076196047699156) * v20 + 0.08608622548411103) * v20 + 0.3073858328214721) * v20 + 0.3333333333333333) / (((((2.565078604208634e-08 * v20 + 2.0203143566039827e-05) * v20 + 0.001617010334189783) * v20 + 0.03639274880225476) * v20 + 0.32215749846441627) * v20 + 1.0))
    else:
        v55 = v9 - v14
    return E_star * h * (a * a * v9 / b + b * v55)


def _pressure(r, a, h, b, E_star):
    root_br = np.sqrt((b - r) * (r + b))
    root = np.sqrt((a - r) * (a + r))
    root_ba = np.sqrt((b - a) * (a + b))
    pressed = E_star * h / np.pi * (np.arcsinh(root / root_ba) / root_br + arc_strips(r, a, b) / b)
    inside = pressed if r < a else 0.0
    return inside if a <= b else np.nan


def _displacement(r, a, h, b):
    if a <= b:
        v58 = h / b
        if r > a:
            v4 = r if r < b or r != r else b
            if a < v4:
                v5 = v4 - a
                v11 = a / sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (v4 + a))
                v12 = asinh(v11)
                v17 = 0.0 - expm1(-2.0 * v12)
                v20 = v17 if v17 > 0.0 else inf
                v38 = r - b
                v42 = sqrt((v38 if v38 > 0.0 or v38 != v38 else 0.0) * (r + b))
                v44 = v42 * v42
                v48 = b - r
                v52 = sqrt((v48 if v48 > 0.0 or v48 != v48 else 0.0) * (b + r))
                v53 = v52 * v52
                v68 = []
                for node, weight in RULE_0(v12 / 1.0):
                    v22 = node * v12
                    v31 = v11 * (exp(-v22) * (0.0 - expm1(-2.0 * (v12 - v22))) / v20)
                    v34 = sqrt(1.0 + v31 * v31)
                    v36 = v4 * (v31 / v34)
                    v37 = v4 / v34
                    v45 = v37 * v37
                    v55 = sqrt(v53 + v45)
                    v67 = (v58 * asinh(v36 / v55) + h * v36 / (v55 * v55)) * atan2(v36, sqrt(v44 + v45)) * (v37 / v34)
                    v68.append(weight * v67)
                v68 = fsum(v68) * v12
                v69 = v68
            else:
                v69 = inf
            return 0.6366197723675814 * v69
        v79 = r / b
        return v58 * a * (log1p(2.0 * a / (b - a)) / 2.0) - h * (r * r) / (b * b * (sqrt((1.0 - v79) * (v79 + 1.0)) + 1.0))
    return nan


def _contact_from_depth(d, h, b):
    """Contact radius a and its root sqrt(b**2 - a**2)."""

    def curve(t):
        a, root = (b * np.tanh(t), b / np.cosh(t))
        value = _depth_at(a, root, h, b)
        return (value, t * root * root / b * _slope(a, root, h, b) / value)
    rest = (0.9983865, 0.208363, -4.0282, 30.18372, -93.92268, 137.5431, -95.06062, 25.07439)
    start = between(np.log(d / curve(1.0)[0]), (1.313, 2.0), (1.313, 1.0), 3.75, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (b * np.tanh(t), b / np.cosh(t))


def _radius_from_depth(d, h, b):
    return _contact_from_depth(d, h, b)[0]


def _contact_from_force(F, h, b, E_star):
    """Contact radius a and its root sqrt(b**2 - a**2)."""

    def curve(t):
        a, root = (b * np.tanh(t), b / np.cosh(t))
        value = _force_at(a, root, h, b, E_star)
        return (value, 2 * E_star * a * t * root * root / b * _slope(a, root, h, b) / value)
    rest = (0.998775, 0.1558039, -2.915358, 22.20415, -66.84601, 91.96521, -58.34092, 13.75711)
    start = between(np.log(F / curve(1.0)[0]), (1.629, 3.0), (2.405, 1.0), 1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return (b * np.tanh(t), b / np.cosh(t))


def _radius_from_force(F, h, b, E_star):
    return _contact_from_force(F, h, b, E_star)[0]


def _force_from_depth(d, h, b, E_star):
    a, root = _contact_from_depth(d, h, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, h, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, h, b, E_star) + change


def _depth_from_force(F, h, b, E_star):
    a, root = _contact_from_force(F, h, b, E_star)
    change = (F - _force_at(a, root, h, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, h, b) + change
