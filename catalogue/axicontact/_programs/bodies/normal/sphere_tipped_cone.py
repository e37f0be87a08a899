"""Bodies of axicontact.normal.sphere_tipped_cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, cos, exp, expm1, fsum, inf, sin, tanh

from ...._programs.bodies._runtime.rules import pressure_integral_beyond
from ...._programs.bodies._runtime.shapes.across import inverse_across
from ...._programs.bodies._runtime.shapes.arcs import arc_strips
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _slope(t, root, R):
    return asinh(t / root) + R * t / (root * root)


def _slope_beyond(t, root, R, theta):
    v5 = R * sin(theta)
    v7 = R * cos(theta)
    v10 = v5 * v5
    return log1p((v10 / (root + t) + v10 / (v7 + R)) / (root + v7)) + v5 * atan2(root, v5) / v7 + v10 * R / (t * (v7 * v7) + R * root * v7)


def _depth_at(a, root, R, theta):
    v5 = R * sin(theta)
    if a < v5:
        return a * (log1p(2.0 * a / (R - a)) / 2.0)
    v7 = R * cos(theta)
    v10 = v5 * v5
    return a * (log1p((v10 / (root + a) + v10 / (v7 + R)) / (root + v7)) + v5 * atan2(root, v5) / v7)


def _depth(a, R, theta):
    v4 = R * sin(theta)
    v9 = R - a
    if a < v4:
        return a * (log1p(2.0 * a / v9) / 2.0)
    v6 = R * cos(theta)
    v16 = v6 * v6 - v9 * (R + a) if v6 < v4 else (a - v4) * (a + v4)
    v19 = sqrt(v16 if v16 > 0.0 or v16 != v16 else 0.0)
    v22 = v4 * v4
    return a * (log1p((v22 / (v19 + a) + v22 / (v6 + R)) / (v19 + v6)) + v4 * atan2(v19, v4) / v6)


def _force_at(a, reach, R, theta, E_star):
    v6 = R * sin(theta)
    v7 = a if a < v6 or a != a else v6
    v14 = R * cos(theta)
    v17 = asinh(v7 / (sqrt((R - v7) * (v7 + R)) if a < v6 else v14))
    v22 = tanh(v17)
    if v17 < 1.0:
        v28 = v17 * v17
        v63 = v22 * (v22 * v22) * ((((((1.0716932453474512e-06 * v28 + 0.00019982814521087247) * v28 + 0.007076196047699156) * v28 + 0.08608622548411103) * v28 + 0.3073858328214721) * v28 + 0.3333333333333333) / (((((2.565078604208634e-08 * v28 + 2.0203143566039827e-05) * v28 + 0.001617010334189783) * v28 + 0.03639274880225476) * v28 + 0.32215749846441627) * v28 + 1.0))
    else:
        v63 = v17 - v22
    v71 = 1.0 - 2.0 * theta / 3.141592653589793
    v73 = asinh(reach / v6)
    v78 = 0.0 - expm1(-2.0 * v73)
    v81 = v78 if v78 > 0.0 else inf
    v92 = v6 * v6
    v97 = v6 * v6
    v101 = v97 / (v14 + R)
    v109 = v97 * R
    v110 = v14 * v14
    v119 = []
    for node, weight in RULE_0(v73 / v71):
        v82 = node * v73
        v91 = reach * (exp(-v82) * (0.0 - expm1(-2.0 * (v73 - v82))) / v81)
        v95 = sqrt(v92 + v91 * v91)
        v118 = (log1p((v97 / (v91 + v95) + v101) / (v91 + v14)) + v6 * atan2(v91, v6) / v14 + v109 / (v95 * v110 + R * v91 * v14)) * v91 * v95
        v119.append(weight * v118)
    v119 = fsum(v119) * v73
    return E_star * (v7 * v7 * v17 + R * R * v63) + 2.0 * E_star * v119


def _force(a, R, theta, E_star):
    v5 = R * sin(theta)
    v7 = R * cos(theta)
    v17 = v7 * v7 - (R - a) * (R + a) if v7 < v5 else (a - v5) * (a + v5)
    v20 = sqrt(v17 if v17 > 0.0 or v17 != v17 else 0.0)
    v21 = a if a < v5 or a != a else v5
    v29 = asinh(v21 / (sqrt((R - v21) * (v21 + R)) if a < v5 else v7))
    v34 = tanh(v29)
    if v29 < 1.0:
        v40 = v29 * v29
        v75 = v34 * (v34 * v34) * ((((((1.0716932453474512e-06 * v40 + 0.00019982814521087247) * v40 + 0.007076196047699156) * v40 + 0.08608622548411103) * v40 + 0.3073858328214721) * v40 + 0.3333333333333333) / (((((2.565078604208634e-08 * v40 + 2.0203143566039827e-05) * v40 + 0.001617010334189783) * v40 + 0.03639274880225476) * v40 + 0.32215749846441627) * v40 + 1.0))
    else:
        v75 = v29 - v34
    v83 = 1.0 - 2.0 * theta / 3.141592653589793
    v85 = asinh(v20 / v5)
    v89 = 0.0 - expm1(-2.0 * v85)
    v92 = v89 if v89 > 0.0 else inf
    v103 = v5 * v5
    v108 = v5 * v5
    v112 = v108 / (v7 + R)
    v120 = v108 * R
    v121 = v7 * v7
    v130 = []
    for node, weight in RULE_0(v85 / v83):
        v93 = node * v85
        v102 = v20 * (exp(-v93) * (0.0 - expm1(-2.0 * (v85 - v93))) / v92)
        v106 = sqrt(v103 + v102 * v102)
        v129 = (log1p((v108 / (v102 + v106) + v112) / (v102 + v7)) + v5 * atan2(v102, v5) / v7 + v120 / (v106 * v121 + R * v102 * v7)) * v102 * v106
        v130.append(weight * v129)
    v130 = fsum(v130) * v85
    return E_star * (v21 * v21 * v29 + R * R * v75) + 2.0 * E_star * v130


def _pressure(r, a, R, theta, E_star):
    b = R * np.sin(theta)
    inner = np.minimum(a, b)
    root_Rr = np.sqrt((R - r) * (r + R))
    root = np.sqrt((R - inner) * (inner + R)) if a < b else R * np.cos(theta)
    root_ar = np.sqrt((inner - r) * (inner + r))
    within = E_star / np.pi * (R * np.arcsinh(root_ar / root) / root_Rr + arc_strips(r, inner, R))
    tip = within if r < inner else 0.0
    growth = pressure_integral_beyond(_slope_beyond, (R, theta), r, a, b, width=1.0 - 2.0 * theta / np.pi)
    return tip + E_star / np.pi * growth if r < a else 0.0


def _displacement(r, a, R, theta):
    v5 = R * sin(theta)
    v43 = r + R
    v51 = R - r
    v75 = r - v5
    v81 = a - v5
    v83 = a + v5
    v126 = R * cos(theta)
    v128 = v5 * v5
    v131 = v126 + R
    v132 = v128 / v131
    if r > a:
        v6 = a if a < v5 or a != a else v5
        v7 = r if r < R or r != r else R
        if v6 < v7:
            v8 = v7 - v6
            v14 = v6 / sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (v7 + v6))
            v15 = asinh(v14)
            v20 = 0.0 - expm1(-2.0 * v15)
            v23 = v20 if v20 > 0.0 else inf
            v41 = r - R
            v45 = sqrt((v41 if v41 > 0.0 or v41 != v41 else 0.0) * v43)
            v47 = v45 * v45
            v55 = sqrt((v51 if v51 > 0.0 or v51 != v51 else 0.0) * (R + r))
            v56 = v55 * v55
            v69 = []
            for node, weight in RULE_0(v15 / 1.0):
                v25 = node * v15
                v34 = v14 * (exp(-v25) * (0.0 - expm1(-2.0 * (v15 - v25))) / v23)
                v37 = sqrt(1.0 + v34 * v34)
                v39 = v7 * (v34 / v37)
                v40 = v7 / v37
                v48 = v40 * v40
                v58 = sqrt(v56 + v48)
                v68 = (asinh(v39 / v58) + R * v39 / (v58 * v58)) * atan2(v39, sqrt(v47 + v48)) * (v40 / v37)
                v69.append(weight * v68)
            v69 = fsum(v69) * v15
            v70 = v69
        else:
            v70 = inf
        if a > v5:
            v74 = 1.0 - 2.0 * theta / 3.141592653589793
            v79 = sqrt((v75 if v75 > 0.0 or v75 != v75 else 0.0) * (r + v5))
            v80 = v5 / r
            v86 = r - a
            v91 = sqrt((v81 if v81 > 0.0 or v81 != v81 else 0.0) * v83) / sqrt((v86 if v86 > 0.0 or v86 != v86 else 0.0) * (r + a))
            v93 = asinh(v91 / v80)
            v96 = 0.0 - expm1(-2.0 * v93)
            v98 = v96 if v96 > 0.0 else inf
            v115 = v5 * v5
            v119 = v80 * v80
            v140 = v128 * R
            v141 = v126 * v126
            v154 = []
            for node, weight in RULE_0(v93 / v74):
                v100 = node * v93
                v109 = v91 * (exp(-v100) * (0.0 - expm1(-2.0 * (v93 - v100))) / v98)
                v110 = v109 * v109
                v112 = sqrt(1.0 + v110)
                v114 = v79 * v109 / v112
                v118 = sqrt(v115 + v114 * v114)
                v153 = (log1p((v128 / (v114 + v118) + v132) / (v114 + v126)) + v5 * atan2(v114, v5) / v126 + v140 / (v118 * v141 + R * v114 * v126)) * v114 / v118 * atan2(v118, v79 / v112) * (sqrt(v119 + v110) / (v112 * v112 * v112))
                v154.append(weight * v153)
            v154 = fsum(v154) * v93
            v156 = v79 * v154
        else:
            v156 = 0.0
        return 0.6366197723675814 * (v70 + v156)
    v162 = R - a
    if a < v5:
        v187 = a * (log1p(2.0 * a / v162) / 2.0)
    else:
        v167 = v126 * v126 - v162 * (R + a) if v126 < v5 else v81 * v83
        v169 = sqrt(v167 if v167 > 0.0 or v167 != v167 else 0.0)
        v187 = a * (log1p((v128 / (v169 + a) + v132) / (v169 + v126)) + v5 * atan2(v169, v5) / v126)
    return v187 - (r * r / (sqrt(v51 * v43) + R) if r < v5 else v5 * (v75 / v126 + v5 / v131))


def _slope_at(a, root, R, theta):
    v5 = R * sin(theta)
    if a < v5:
        v9 = sqrt((R - a) * (R + a))
        return asinh(a / v9) + R * a / (v9 * v9)
    v19 = R * cos(theta)
    v21 = v5 * v5
    return log1p((v21 / (root + a) + v21 / (v19 + R)) / (root + v19)) + v5 * atan2(root, v5) / v19 + v21 * R / (a * (v19 * v19) + R * root * v19)


def _radius_from_depth(d, R, theta):
    b = R * np.sin(theta)

    def curve(a, root):
        rate = a * _slope_at(a, root, R, theta)
        return (_depth_at(a, root, R, theta), rate)
    return inverse_across(curve, d, b, 2.0, R, powers=(2.0, 1.0))


def _radius_from_force(F, R, theta, E_star):
    b = R * np.sin(theta)

    def curve(a, root):
        rate = 2 * E_star * a ** 2 * _slope_at(a, root, R, theta)
        return (_force_at(a, root, R, theta, E_star), rate)
    return inverse_across(curve, F, b, 3.0, R, powers=(2.0, 2.0))


def _force_from_depth(d, R, theta, E_star):
    a = _radius_from_depth(d, R, theta)
    change = 2 * E_star * a * (d - _depth(a, R, theta)) if (a > 0.0) & (a < np.inf) else 0.0
    return _force(a, R, theta, E_star) + change


def _depth_from_force(F, R, theta, E_star):
    a = _radius_from_force(F, R, theta, E_star)
    change = (F - _force(a, R, theta, E_star)) / (2 * E_star * a) if (a > 0.0) & (a < np.inf) else 0.0
    return _depth(a, R, theta) + change
