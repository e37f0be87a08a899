"""Bodies of axicontact.normal.sphere over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, nan, tanh

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._programs.bodies._runtime.shapes.arcs import arc_strips
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope(t, root, R):
    return asinh(t / root) + R * t / (root * root)


def _depth_at(a, root):
    return a * asinh(a / root)


def _depth(a, R):
    return a * (log1p(2.0 * a / (R - a)) / 2.0)


def _force_at(a, root, R, E_star):
    v5 = asinh(a / root)
    v10 = tanh(v5)
    if v5 < 1.0:
        v16 = v5 * v5
        v51 = v10 * (v10 * v10) * ((((((1.0716932453474512e-06 * v16 + 0.00019982814521087247) * v16 + 0.007076196047699156) * v16 + 0.08608622548411103) * v16 + 0.3073858328214721) * v16 + 0.3333333333333333) / (((((2.565078604208634e-08 * v16 + 2.0203143566039827e-05) * v16 + 0.001617010334189783) * v16 + 0.03639274880225476) * v16 + 0.32215749846441627) * v16 + 1.0))
    else:
        v51 = v5 - v10
    return E_star * (a * a * v5 + R * R * v51)


def _force(a, R, E_star):
    v8 = log1p(2.0 * a / (R - a)) / 2.0
    v12 = a / R
    if v8 < 1.0:
        v18 = v8 * v8
        v53 = v12 * (v12 * v12) * ((((((1.0716932453474512e-06 * v18 + 0.00019982814521087247) * v18 + 0.007076196047699156) * v18 + 0.08608622548411103) * v18 + 0.3073858328214721) * v18 + 0.3333333333333333) / (((((2.565078604208634e-08 * v18 + 2.0203143566039827e-05) * v18 + 0.001617010334189783) * v18 + 0.03639274880225476) * v18 + 0.32215749846441627) * v18 + 1.0))
    else:
        v53 = v8 - v12
    return E_star * (a * a * v8 + R * R * v53)


def _pressure(r, a, R, E_star):
    root_Rr = np.sqrt((R - r) * (r + R))
    root = np.sqrt((R - a) * (a + R))
    root_ar = np.sqrt((a - r) * (a + r))
    pressed = E_star / np.pi * (R * np.arcsinh(root_ar / root) / root_Rr + arc_strips(r, a, R))
    inside = pressed if r < a else 0.0
    return inside if a <= R else np.nan


def _displacement(r, a, R):
    if a <= R:
        v39 = r + R
        v47 = R - r
        if r > a:
            v3 = r if r < R or r != r else R
            if a < v3:
                v4 = v3 - a
                v10 = a / sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (v3 + a))
                v11 = asinh(v10)
                v16 = 0.0 - expm1(-2.0 * v11)
                v19 = v16 if v16 > 0.0 else inf
                v37 = r - R
                v41 = sqrt((v37 if v37 > 0.0 or v37 != v37 else 0.0) * v39)
                v43 = v41 * v41
                v51 = sqrt((v47 if v47 > 0.0 or v47 != v47 else 0.0) * (R + r))
                v52 = v51 * v51
                v65 = []
                for node, weight in RULE_0(v11 / 1.0):
                    v21 = node * v11
                    v30 = v10 * (exp(-v21) * (0.0 - expm1(-2.0 * (v11 - v21))) / v19)
                    v33 = sqrt(1.0 + v30 * v30)
                    v35 = v3 * (v30 / v33)
                    v36 = v3 / v33
                    v44 = v36 * v36
                    v54 = sqrt(v52 + v44)
                    v64 = (asinh(v35 / v54) + R * v35 / (v54 * v54)) * atan2(v35, sqrt(v43 + v44)) * (v36 / v33)
                    v65.append(weight * v64)
                v65 = fsum(v65) * v11
                v66 = v65
            else:
                v66 = inf
            return 0.6366197723675814 * v66
        return a * (log1p(2.0 * a / (R - a)) / 2.0) - r * r / (sqrt(v47 * v39) + R)
    return nan


def _contact_from_depth(d, R):
    """Contact radius a and its root sqrt(R**2 - a**2)."""

    def curve(t):
        a, root = (R * np.tanh(t), R / np.cosh(t))
        value = _depth_at(a, root)
        return (value, t * root * root / R * _slope(a, root, R) / value)
    rest = (0.9983865, 0.208363, -4.0282, 30.18372, -93.92268, 137.5431, -95.06062, 25.07439)
    start = between(np.log(d / curve(1.0)[0]), (1.313, 2.0), (1.313, 1.0), 3.75, rest)
    t = inverse(curve, d, start, (1.0, 2.0), smooth=True)
    return (R * np.tanh(t), R / np.cosh(t))


def _radius_from_depth(d, R):
    return _contact_from_depth(d, R)[0]


def _contact_from_force(F, R, E_star):
    """Contact radius a and its root sqrt(R**2 - a**2)."""

    def curve(t):
        a, root = (R * np.tanh(t), R / np.cosh(t))
        value = _force_at(a, root, R, E_star)
        return (value, 2 * E_star * a * t * root * root / R * _slope(a, root, R) / value)
    rest = (0.998775, 0.1558039, -2.915358, 22.20415, -66.84601, 91.96521, -58.34092, 13.75711)
    start = between(np.log(F / curve(1.0)[0]), (1.629, 3.0), (2.405, 1.0), 1.75, rest)
    t = inverse(curve, F, start, (1.0, 3.0), smooth=True)
    return (R * np.tanh(t), R / np.cosh(t))


def _radius_from_force(F, R, E_star):
    return _contact_from_force(F, R, E_star)[0]


def _force_from_depth(d, R, E_star):
    a, root = _contact_from_depth(d, R)
    change = 2 * E_star * a * (d - _depth_at(a, root)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, E_star) + change


def _depth_from_force(F, R, E_star):
    a, root = _contact_from_force(F, R, E_star)
    change = (F - _force_at(a, root, R, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root) + change
