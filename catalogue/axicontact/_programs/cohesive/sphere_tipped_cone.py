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
    if a.__class__ is q.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, q, R, theta, E_star, dgamma, sigma_0):
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
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, R, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star, dgamma, sigma_0):
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
            v50 = []
            for node, weight in RULE_1(v29 / 1.0):
                v31 = node * v29
                v32 = v28 + v31
                v34 = v9 * cos(v32)
                v38 = sqrt((R - v34) * (R + v34))
                v48 = (asinh(v34 / v38) + R * v34 / (v38 * v38)) * v32 * sin(v32)
                v50.append(weight * v48)
            v50 = fsum(v50) * v29
            v74 = 0.0 - v8
            v78 = sqrt((v74 if v74 > 0.0 or v74 != v74 else 0.0) * (0.0 + v8))
            v80 = v21 if v11 else hypot(v78, c)
            v81 = v80 if v11 else c
            v82 = v81 > 0.0
            if v82:
                v83 = v80 if v82 else v8
                v84 = v81 if v82 else v8
                v86 = asinh(v8 / v83)
                v90 = 1.5707963267948966 / v86
                v91 = atan2(v78, v84) / v86
                v92 = asinh(v90)
                v106 = asinh(atan2(v84, v78) / v86 * (v90 + v91) / (v90 * sqrt(1.0 + v91 * v91) + v91 * sqrt(1.0 + v90 * v90)))
                v108 = 2.0 * v86
                v120 = v8 * v8
                v125 = R * cos(theta)
                v127 = v8 * v8
                v131 = v127 / (v125 + R)
                v139 = v127 * R
                v140 = v125 * v125
                v157 = []
                for node, weight in RULE_0(v106 / 1.0):
                    v107 = node * v106
                    v110 = 0.5 * v107
                    v115 = v108 * cosh(v92 - v110) * sinh(v110)
                    v117 = v83 * cos(v115)
                    v119 = v83 * sin(v115)
                    v123 = sqrt(v120 + v117 * v117)
                    v155 = (log1p((v127 / (v117 + v123) + v131) / (v117 + v125)) + v8 * atan2(v117, v8) / v125 + v139 / (v123 * v140 + R * v117 * v125)) * v117 * v86 * cosh(v92 - v107) * atan2(v119, v123) * (v119 / v123)
                    v157.append(weight * v155)
                v157 = fsum(v157) * v106
                v200 = 0.6366197723675814 * v157
            else:
                v200 = 0.0
            v207 = sigma_0 / E_star
            v211 = 0.6366197723675814 * v9 * v50 + v200 - dgamma / sigma_0 - 1.2732395447351628 * v207 * c
            if v211 <= -(2.0 * v207 * c):
                value = v211
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
            v50 = []
            for node, weight in RULE_1(v29 / 1.0):
                v31 = node * v29
                v32 = v28 + v31
                v34 = v9 * cos(v32)
                v38 = sqrt((R - v34) * (R + v34))
                v48 = (asinh(v34 / v38) + R * v34 / (v38 * v38)) * v32 * sin(v32)
                v50.append(weight * v48)
            v50 = fsum(v50) * v29
            v74 = 0.0 - v8
            v78 = sqrt((v74 if v74 > 0.0 or v74 != v74 else 0.0) * (0.0 + v8))
            v80 = v21 if v11 else hypot(v78, c)
            v81 = v80 if v11 else c
            v82 = v81 > 0.0
            if v82:
                v83 = v80 if v82 else v8
                v84 = v81 if v82 else v8
                v86 = asinh(v8 / v83)
                v90 = 1.5707963267948966 / v86
                v91 = atan2(v78, v84) / v86
                v92 = asinh(v90)
                v106 = asinh(atan2(v84, v78) / v86 * (v90 + v91) / (v90 * sqrt(1.0 + v91 * v91) + v91 * sqrt(1.0 + v90 * v90)))
                v108 = 2.0 * v86
                v120 = v8 * v8
                v125 = R * cos(theta)
                v127 = v8 * v8
                v131 = v127 / (v125 + R)
                v139 = v127 * R
                v140 = v125 * v125
                v157 = []
                for node, weight in RULE_0(v106 / 1.0):
                    v107 = node * v106
                    v110 = 0.5 * v107
                    v115 = v108 * cosh(v92 - v110) * sinh(v110)
                    v117 = v83 * cos(v115)
                    v119 = v83 * sin(v115)
                    v123 = sqrt(v120 + v117 * v117)
                    v155 = (log1p((v127 / (v117 + v123) + v131) / (v117 + v125)) + v8 * atan2(v117, v8) / v125 + v139 / (v123 * v140 + R * v117 * v125)) * v117 * v86 * cosh(v92 - v107) * atan2(v119, v123) * (v119 / v123)
                    v157.append(weight * v155)
                v157 = fsum(v157) * v106
                v200 = 0.6366197723675814 * v157
            else:
                v200 = 0.0
            v207 = sigma_0 / E_star
            if 0.6366197723675814 * v9 * v50 + v200 - dgamma / sigma_0 - 1.2732395447351628 * v207 * c <= -(2.0 * v207 * c):
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
            v55 = []
            for node, weight in RULE_1(v34 / 1.0):
                v36 = node * v34
                v37 = v33 + v36
                v39 = v12 * cos(v37)
                v43 = sqrt((R - v39) * (R + v39))
                v53 = (asinh(v39 / v43) + R * v39 / (v43 * v43)) * v37 * sin(v37)
                v55.append(weight * v53)
            v55 = fsum(v55) * v34
            v79 = a - v15
            v83 = sqrt((v79 if v79 > 0.0 or v79 != v79 else 0.0) * (a + v15))
            v85 = v26 if v16 else hypot(v83, v11)
            v86 = v85 if v16 else v11
            v87 = v86 > 0.0
            if v87:
                v88 = v85 if v87 else v15
                v89 = v86 if v87 else v15
                v91 = asinh(v15 / v88)
                v95 = 1.5707963267948966 / v91
                v96 = atan2(v83, v89) / v91
                v97 = asinh(v95)
                v111 = asinh(atan2(v89, v83) / v91 * (v95 + v96) / (v95 * sqrt(1.0 + v96 * v96) + v96 * sqrt(1.0 + v95 * v95)))
                v113 = 2.0 * v91
                v125 = v15 * v15
                v130 = R * cos(theta)
                v132 = v15 * v15
                v136 = v132 / (v130 + R)
                v144 = v132 * R
                v145 = v130 * v130
                v162 = []
                for node, weight in RULE_0(v111 / 1.0):
                    v112 = node * v111
                    v115 = 0.5 * v112
                    v120 = v113 * cosh(v97 - v115) * sinh(v115)
                    v122 = v88 * cos(v120)
                    v124 = v88 * sin(v120)
                    v128 = sqrt(v125 + v122 * v122)
                    v160 = (log1p((v132 / (v122 + v128) + v136) / (v122 + v130)) + v15 * atan2(v122, v15) / v130 + v144 / (v128 * v145 + R * v122 * v130)) * v122 * v91 * cosh(v97 - v112) * atan2(v124, v128) * (v124 / v128)
                    v162.append(weight * v160)
                v162 = fsum(v162) * v111
                v205 = 0.6366197723675814 * v162
            else:
                v205 = 0.0
            value = sigma_0 * (0.6366197723675814 * v12 * v55 + v205 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, theta, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
