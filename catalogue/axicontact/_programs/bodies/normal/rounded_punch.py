"""Bodies of axicontact.normal.rounded_punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan

from ...._programs.bodies._runtime.inverse import between, inverse
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope_beyond(t, root, R, b):
    return 2.0 * root / R - b / R * atan2(root, b)


def _depth_at(a, root, R, b):
    v6 = root / b
    if v6 < 1.0:
        v10 = v6 * v6
        v53 = v6 * v10 * (((((((2.229767813968649e-06 * v10 + 0.0021043873129700233) * v10 + 0.04325113828415611) * v10 + 0.2725778671008127) * v10 + 0.7123414383945195) * v10 + 0.8116412201960678) * v10 + 0.3333333333333333) / ((((((0.002445452808893491 * v10 + 0.06453295925870227) * v10 + 0.5368820963772863) * v10 + 1.9680296155712274) * v10 + 3.5294070829658954) * v10 + 3.034923660588189) * v10 + 1.0))
    else:
        v53 = v6 - atan(v6)
    return b / R * a * v53


def _depth(a, R, b):
    v5 = a - b
    v6 = v5 / b
    if v6 < 0.42:
        v52 = v6 * sqrt(v6) * ((((((0.0005288491342179178 * v6 + 0.038096760299703034) * v6 + 0.4065213849117787) * v6 + 1.438682033198726) * v6 + 1.9979042349620892) * v6 + 0.9428090415820634) / (((((0.006421883194715949 * v6 + 0.15001504718401248) * v6 + 0.9450913324352289) * v6 + 2.37401087025821) * v6 + 2.569097449054519) * v6 + 1.0))
    else:
        v12 = sqrt(v5 * (a + b)) / b
        v52 = v12 - atan(v12)
    return b / R * a * v52


def _force_at(a, root, R, b, E_star):
    v13 = root / b
    if v13 < 1.0:
        v17 = v13 * v13
        v60 = v13 * v17 * (((((((2.229767813968649e-06 * v17 + 0.0021043873129700233) * v17 + 0.04325113828415611) * v17 + 0.2725778671008127) * v17 + 0.7123414383945195) * v17 + 0.8116412201960678) * v17 + 0.3333333333333333) / ((((((0.002445452808893491 * v17 + 0.06453295925870227) * v17 + 0.5368820963772863) * v17 + 1.9680296155712274) * v17 + 3.5294070829658954) * v17 + 3.034923660588189) * v17 + 1.0))
    else:
        v60 = v13 - atan(v13)
    return E_star / R * (root * (root * root) / 3.0 + b * (a * a) * v60)


def _force(a, R, b, E_star):
    v4 = a - b
    v6 = v4 * (a + b)
    v7 = sqrt(v6)
    v12 = v4 / b
    if v12 < 0.42:
        v55 = v12 * sqrt(v12) * ((((((0.0005288491342179178 * v12 + 0.038096760299703034) * v12 + 0.4065213849117787) * v12 + 1.438682033198726) * v12 + 1.9979042349620892) * v12 + 0.9428090415820634) / (((((0.006421883194715949 * v12 + 0.15001504718401248) * v12 + 0.9450913324352289) * v12 + 2.37401087025821) * v12 + 2.569097449054519) * v12 + 1.0))
    else:
        v15 = v7 / b
        v55 = v15 - atan(v15)
    return E_star / R * (b * (a * a) * v55 + v6 * v7 / 3.0)


def _displacement(r, a, R, b):
    if a >= b:
        v4 = r - b
        v11 = a - b
        v13 = a + b
        v62 = b / R
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
                v71 = []
                for node, weight in RULE_0(v23 / 1.0):
                    v33 = node * v23
                    v42 = v21 * (exp(-v33) * (0.0 - expm1(-2.0 * (v23 - v33))) / v31)
                    v43 = v42 * v42
                    v45 = sqrt(1.0 + v43)
                    v47 = v9 * v42 / v45
                    v51 = sqrt(v48 + v47 * v47)
                    v70 = (2.0 * v47 / R - v62 * atan2(v47, b)) * v47 / v51 * atan2(v51, v9 / v45) * (sqrt(v52 + v43) / (v45 * v45 * v45))
                    v71.append(weight * v70)
                v71 = fsum(v71) * v23
                v73 = v9 * v71
            else:
                v73 = 0.0
            return 0.6366197723675814 * v73
        v77 = v11 / b
        if v77 < 0.42:
            v121 = v77 * sqrt(v77) * ((((((0.0005288491342179178 * v77 + 0.038096760299703034) * v77 + 0.4065213849117787) * v77 + 1.438682033198726) * v77 + 1.9979042349620892) * v77 + 0.9428090415820634) / (((((0.006421883194715949 * v77 + 0.15001504718401248) * v77 + 0.9450913324352289) * v77 + 2.37401087025821) * v77 + 2.569097449054519) * v77 + 1.0))
        else:
            v82 = sqrt(v11 * v13) / b
            v121 = v82 - atan(v82)
        return v62 * a * v121 - (0.0 if r < b else v4 * v4 / (2.0 * R))
    return nan


def _contact_from_depth(d, R, b):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _depth_at(a, root, R, b)
        return (value, root * root / a * _slope_beyond(a, root, R, b) / value)
    rest = (0.9999152, -0.002147146, -0.02265958, -0.0720644, 0.3108858, -0.6900221, 1.077435, -0.6001833)
    start = between(np.log(d / curve(1.0)[0]), (1.098, 3.0), (3.295, 2.0), 3.5, rest)
    t = inverse(curve, d, start, (2.0, 4.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_depth(d, R, b):
    return _contact_from_depth(d, R, b)[0]


def _contact_from_force(F, R, b, E_star):
    """Contact radius a and its root sqrt(a**2 - b**2)."""

    def curve(t):
        a, root = (b * np.sqrt(1.0 + t * t), b * t)
        value = _force_at(a, root, R, b, E_star)
        return (value, 2 * E_star * root * root * _slope_beyond(a, root, R, b) / value)
    rest = (0.9634905, 0.003191853, -0.1218583, 0.3231377, -1.571447, 2.059576, -1.105184, 0.2138332)
    start = between(np.log(F / curve(1.0)[0]), (0.8743, 3.0), (1.749, 3.0), 6.0, rest)
    t = inverse(curve, F, start, (3.0, 4.0), smooth=True)
    return (b * np.sqrt(1.0 + t * t), b * t)


def _radius_from_force(F, R, b, E_star):
    return _contact_from_force(F, R, b, E_star)[0]


def _force_from_depth(d, R, b, E_star):
    a, root = _contact_from_depth(d, R, b)
    change = 2 * E_star * a * (d - _depth_at(a, root, R, b)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force_at(a, root, R, b, E_star) + change


def _depth_from_force(F, R, b, E_star):
    a, root = _contact_from_force(F, R, b, E_star)
    change = (F - _force_at(a, root, R, b, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth_at(a, root, R, b) + change
