"""Programs of axicontact.cohesive.sphere_tipped_cone."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, log1p, nan, sin, sinh, sqrt, tanh

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import sphere_tipped_cone as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))
RULE_1 = rule(((inf, 64),))


def cohesive_radius(a, R, theta, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, R, theta, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R, theta, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, theta, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, R, theta, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v8 = R * sin(theta)
            v10 = R * cos(theta)
            v20 = v10 * v10 - (R - a) * (R + a) if v10 < v8 else (a - v8) * (a + v8)
            v23 = sqrt(v20 if v20 > 0.0 or v20 != v20 else 0.0)
            v24 = a if a < v8 or a != a else v8
            v32 = asinh(v24 / (sqrt((R - v24) * (v24 + R)) if a < v8 else v10))
            v37 = tanh(v32)
            if v32 < 1.0:
                v43 = v32 * v32
                v78 = v37 * (v37 * v37) * ((((((1.0716932453474512e-06 * v43 + 0.00019982814521087247) * v43 + 0.007076196047699156) * v43 + 0.08608622548411103) * v43 + 0.3073858328214721) * v43 + 0.3333333333333333) / (((((2.565078604208634e-08 * v43 + 2.0203143566039827e-05) * v43 + 0.001617010334189783) * v43 + 0.03639274880225476) * v43 + 0.32215749846441627) * v43 + 1.0))
            else:
                v78 = v32 - v37
            v86 = 1.0 - 2.0 * theta / 3.141592653589793
            v88 = asinh(v23 / v8)
            v92 = 0.0 - expm1(-2.0 * v88)
            v95 = v92 if v92 > 0.0 else inf
            v106 = v8 * v8
            v111 = v8 * v8
            v115 = v111 / (v10 + R)
            v123 = v111 * R
            v124 = v10 * v10
            v133 = []
            for node, weight in RULE_0(v88 / v86):
                v96 = node * v88
                v105 = v23 * (exp(-v96) * (0.0 - expm1(-2.0 * (v88 - v96))) / v95)
                v109 = sqrt(v106 + v105 * v105)
                v132 = (log1p((v111 / (v105 + v109) + v115) / (v105 + v10)) + v8 * atan2(v105, v8) / v10 + v123 / (v109 * v124 + R * v105 * v10)) * v105 * v109
                v133.append(weight * v132)
            v133 = fsum(v133) * v88
            v137 = hypot(a, q)
            value = E_star * (v24 * v24 * v32 + R * R * v78) + 2.0 * E_star * v133 - 2.0 * sigma_0 * (v137 * v137 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, q, R, theta, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, R, theta, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, R, theta, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R, theta, E_star, dgamma, sigma_0, control):
    if R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and R > 1e-30 and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(R, theta, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, R, theta, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, theta, E_star, dgamma, sigma_0):
    if d.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, theta, E_star, dgamma, sigma_0):
    if F.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, R, theta, E_star, dgamma, sigma_0):
    if c.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v8 = R * sin(theta)
            v9 = hypot(0.0, c)
            v10 = atan2(c, 0.0)
            v11 = 0.0 < v8
            v12 = v8 - 0.0
            v16 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (v8 + 0.0))
            v17 = c - v16
            v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (c + v16))
            if v11:
                v26 = (atan2(v21 if v11 else c, v8) if v11 else v10) if v9 > v8 else 0.0
                v28 = v26 if v26 < v10 or v26 != v26 else v10
            else:
                v28 = v10
            v29 = v10 - v28
            v51 = []
            for node, weight in RULE_1(v29 / 1.0):
                v31 = node * v29
                v32 = v28 + v31
                v34 = v9 * cos(v32)
                v35 = v34 if v34 < v8 or v34 != v34 else v8
                v39 = sqrt((R - v35) * (R + v35))
                v49 = (asinh(v35 / v39) + R * v35 / (v39 * v39)) * v32 * sin(v32)
                v51.append(weight * v49)
            v51 = fsum(v51) * v29
            v76 = 0.0 - v8
            v80 = sqrt((v76 if v76 > 0.0 or v76 != v76 else 0.0) * (0.0 + v8))
            v82 = v21 if v11 else hypot(v80, c)
            v83 = v82 if v11 else c
            v84 = v83 > 0.0
            if v84:
                v85 = v82 if v84 else v8
                v86 = v83 if v84 else v8
                v88 = asinh(v8 / v85)
                v92 = 1.5707963267948966 / v88
                v93 = atan2(v80, v86) / v88
                v94 = asinh(v92)
                v108 = asinh(atan2(v86, v80) / v88 * (v92 + v93) / (v92 * sqrt(1.0 + v93 * v93) + v93 * sqrt(1.0 + v92 * v92)))
                v110 = 2.0 * v88
                v122 = v8 * v8
                v127 = R * cos(theta)
                v129 = v8 * v8
                v133 = v129 / (v127 + R)
                v141 = v129 * R
                v142 = v127 * v127
                v159 = []
                for node, weight in RULE_0(v108 / 1.0):
                    v109 = node * v108
                    v112 = 0.5 * v109
                    v117 = v110 * cosh(v94 - v112) * sinh(v112)
                    v119 = v85 * cos(v117)
                    v121 = v85 * sin(v117)
                    v125 = sqrt(v122 + v119 * v119)
                    v157 = (log1p((v129 / (v119 + v125) + v133) / (v119 + v127)) + v8 * atan2(v119, v8) / v127 + v141 / (v125 * v142 + R * v119 * v127)) * v119 * v88 * cosh(v94 - v109) * atan2(v121, v125) * (v121 / v125)
                    v159.append(weight * v157)
                v159 = fsum(v159) * v108
                v202 = 0.6366197723675814 * v159
            else:
                v202 = 0.0
            v209 = sigma_0 / E_star
            v213 = 0.6366197723675814 * v9 * v51 + v202 - dgamma / sigma_0 - 1.2732395447351628 * v209 * c
            if v213 <= -(2.0 * v209 * c):
                value = v213
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R, theta, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R, theta, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, R, theta, E_star, dgamma, sigma_0):
    if c.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v8 = R * sin(theta)
            v9 = hypot(0.0, c)
            v10 = atan2(c, 0.0)
            v11 = 0.0 < v8
            v12 = v8 - 0.0
            v16 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (v8 + 0.0))
            v17 = c - v16
            v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (c + v16))
            if v11:
                v26 = (atan2(v21 if v11 else c, v8) if v11 else v10) if v9 > v8 else 0.0
                v28 = v26 if v26 < v10 or v26 != v26 else v10
            else:
                v28 = v10
            v29 = v10 - v28
            v51 = []
            for node, weight in RULE_1(v29 / 1.0):
                v31 = node * v29
                v32 = v28 + v31
                v34 = v9 * cos(v32)
                v35 = v34 if v34 < v8 or v34 != v34 else v8
                v39 = sqrt((R - v35) * (R + v35))
                v49 = (asinh(v35 / v39) + R * v35 / (v39 * v39)) * v32 * sin(v32)
                v51.append(weight * v49)
            v51 = fsum(v51) * v29
            v76 = 0.0 - v8
            v80 = sqrt((v76 if v76 > 0.0 or v76 != v76 else 0.0) * (0.0 + v8))
            v82 = v21 if v11 else hypot(v80, c)
            v83 = v82 if v11 else c
            v84 = v83 > 0.0
            if v84:
                v85 = v82 if v84 else v8
                v86 = v83 if v84 else v8
                v88 = asinh(v8 / v85)
                v92 = 1.5707963267948966 / v88
                v93 = atan2(v80, v86) / v88
                v94 = asinh(v92)
                v108 = asinh(atan2(v86, v80) / v88 * (v92 + v93) / (v92 * sqrt(1.0 + v93 * v93) + v93 * sqrt(1.0 + v92 * v92)))
                v110 = 2.0 * v88
                v122 = v8 * v8
                v127 = R * cos(theta)
                v129 = v8 * v8
                v133 = v129 / (v127 + R)
                v141 = v129 * R
                v142 = v127 * v127
                v159 = []
                for node, weight in RULE_0(v108 / 1.0):
                    v109 = node * v108
                    v112 = 0.5 * v109
                    v117 = v110 * cosh(v94 - v112) * sinh(v112)
                    v119 = v85 * cos(v117)
                    v121 = v85 * sin(v117)
                    v125 = sqrt(v122 + v119 * v119)
                    v157 = (log1p((v129 / (v119 + v125) + v133) / (v119 + v127)) + v8 * atan2(v119, v8) / v127 + v141 / (v125 * v142 + R * v119 * v127)) * v119 * v88 * cosh(v94 - v109) * atan2(v121, v125) * (v121 / v125)
                    v159.append(weight * v157)
                v159 = fsum(v159) * v108
                v202 = 0.6366197723675814 * v159
            else:
                v202 = 0.0
            v209 = sigma_0 / E_star
            if 0.6366197723675814 * v9 * v51 + v202 - dgamma / sigma_0 - 1.2732395447351628 * v209 * c <= -(2.0 * v209 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R, theta, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R, theta, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, R, theta, E_star, sigma_0):
    if a.__class__ is c.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = c - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (c + a))
            v12 = hypot(a, v11)
            v13 = atan2(v11, a)
            v15 = R * sin(theta)
            v16 = a < v15
            v17 = v15 - a
            v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (v15 + a))
            v22 = v11 - v21
            v26 = sqrt((v22 if v22 > 0.0 or v22 != v22 else 0.0) * (v11 + v21))
            if v16:
                v31 = (atan2(v26 if v16 else v11, v15) if v16 else v13) if v12 > v15 else 0.0
                v33 = v31 if v31 < v13 or v31 != v31 else v13
            else:
                v33 = v13
            v34 = v13 - v33
            v56 = []
            for node, weight in RULE_1(v34 / 1.0):
                v36 = node * v34
                v37 = v33 + v36
                v39 = v12 * cos(v37)
                v40 = v39 if v39 < v15 or v39 != v39 else v15
                v44 = sqrt((R - v40) * (R + v40))
                v54 = (asinh(v40 / v44) + R * v40 / (v44 * v44)) * v37 * sin(v37)
                v56.append(weight * v54)
            v56 = fsum(v56) * v34
            v81 = a - v15
            v85 = sqrt((v81 if v81 > 0.0 or v81 != v81 else 0.0) * (a + v15))
            v87 = v26 if v16 else hypot(v85, v11)
            v88 = v87 if v16 else v11
            v89 = v88 > 0.0
            if v89:
                v90 = v87 if v89 else v15
                v91 = v88 if v89 else v15
                v93 = asinh(v15 / v90)
                v97 = 1.5707963267948966 / v93
                v98 = atan2(v85, v91) / v93
                v99 = asinh(v97)
                v113 = asinh(atan2(v91, v85) / v93 * (v97 + v98) / (v97 * sqrt(1.0 + v98 * v98) + v98 * sqrt(1.0 + v97 * v97)))
                v115 = 2.0 * v93
                v127 = v15 * v15
                v132 = R * cos(theta)
                v134 = v15 * v15
                v138 = v134 / (v132 + R)
                v146 = v134 * R
                v147 = v132 * v132
                v164 = []
                for node, weight in RULE_0(v113 / 1.0):
                    v114 = node * v113
                    v117 = 0.5 * v114
                    v122 = v115 * cosh(v99 - v117) * sinh(v117)
                    v124 = v90 * cos(v122)
                    v126 = v90 * sin(v122)
                    v130 = sqrt(v127 + v124 * v124)
                    v162 = (log1p((v134 / (v124 + v130) + v138) / (v124 + v132)) + v15 * atan2(v124, v15) / v132 + v146 / (v130 * v147 + R * v124 * v132)) * v124 * v93 * cosh(v99 - v114) * atan2(v126, v130) * (v126 / v130)
                    v164.append(weight * v162)
                v164 = fsum(v164) * v113
                v207 = 0.6366197723675814 * v164
            else:
                v207 = 0.0
            value = sigma_0 * (0.6366197723675814 * v12 * v56 + v207 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, theta, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
