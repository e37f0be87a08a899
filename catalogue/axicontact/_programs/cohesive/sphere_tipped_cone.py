"""Programs of axicontact.cohesive.sphere_tipped_cone."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, log1p, nan, sin, sinh, sqrt, tanh

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import sphere_tipped_cone as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


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
            if c == 0.0:
                v162 = 0.0
            else:
                v9 = R * sin(theta)
                v10 = hypot(0.0, c)
                v11 = atan2(c, 0.0)
                v12 = 0.0 < v9
                v13 = v9 - 0.0
                v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (v9 + 0.0))
                v18 = c - v17
                v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (c + v17))
                if v12:
                    v27 = (atan2(v22 if v12 else c, v9) if v12 else v11) if v10 > v9 else 0.0
                    v29 = v27 if v27 < v11 or v27 != v27 else v11
                else:
                    v29 = v11
                v30 = v11 - v29
                v31 = v10 if v10 > R or v10 != v10 else R
                v39 = 0.6366197723675814 * (R - v9) / sqrt((v31 - v9) * (v31 + v9))
                v43 = v30 / 9.0 + 1e-300
                v44 = v39 if v39 > v43 or v39 != v39 else v43
                v66 = []
                for node, weight in RULE_0(v30 / v44):
                    v45 = node * v30
                    v46 = v29 + v45
                    v49 = abs(v10 * cos(v46))
                    v50 = v49 if v49 < v9 or v49 != v49 else v9
                    v54 = sqrt((R - v50) * (R + v50))
                    v64 = (asinh(v50 / v54) + R * v50 / (v54 * v54)) * v46 * sin(v46)
                    v66.append(weight * v64)
                v66 = fsum(v66) * v30
                v71 = 0.0 - v9
                v75 = sqrt((v71 if v71 > 0.0 or v71 != v71 else 0.0) * (0.0 + v9))
                v77 = v22 if v12 else hypot(v75, c)
                v78 = v77 if v12 else c
                v80 = v77 if v78 > 0.0 else v9
                v82 = asinh(v9 / v80)
                v86 = 1.5707963267948966 / v82
                v87 = atan2(v75, v78) / v82
                v88 = asinh(v86)
                v103 = asinh(atan2(v78, v75) / v82 * (v86 + v87) / (v86 * sqrt(1.0 + v87 * v87) + v87 * sqrt(1.0 + v86 * v86)))
                v105 = 2.0 * v82
                v119 = v9 * v9
                v124 = R * cos(theta)
                v126 = v9 * v9
                v130 = v126 / (v124 + R)
                v138 = v126 * R
                v139 = v124 * v124
                v156 = []
                for node, weight in RULE_1(v103 / 1.0):
                    v104 = node * v103
                    v107 = 0.5 * v104
                    v112 = v105 * cosh(v88 - v107) * sinh(v107)
                    v113 = cos(v112)
                    v116 = v80 * (v113 if v113 > 1e-17 or v113 != v113 else 1e-17)
                    v118 = v80 * sin(v112)
                    v122 = sqrt(v119 + v116 * v116)
                    v154 = (log1p((v126 / (v116 + v122) + v130) / (v116 + v124)) + v9 * atan2(v116, v9) / v124 + v138 / (v122 * v139 + R * v116 * v124)) * v116 * v82 * cosh(v88 - v104) * atan2(v118, v122) * (v118 / v122)
                    v156.append(weight * v154)
                v156 = fsum(v156) * v103
                v162 = 0.6366197723675814 * v10 * v66 + 0.6366197723675814 * v156
            v165 = sigma_0 / E_star
            v169 = v162 - dgamma / sigma_0 - 1.2732395447351628 * v165 * c
            if v169 <= -(2.0 * v165 * c):
                value = v169
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
            if c == 0.0:
                v162 = 0.0
            else:
                v9 = R * sin(theta)
                v10 = hypot(0.0, c)
                v11 = atan2(c, 0.0)
                v12 = 0.0 < v9
                v13 = v9 - 0.0
                v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (v9 + 0.0))
                v18 = c - v17
                v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (c + v17))
                if v12:
                    v27 = (atan2(v22 if v12 else c, v9) if v12 else v11) if v10 > v9 else 0.0
                    v29 = v27 if v27 < v11 or v27 != v27 else v11
                else:
                    v29 = v11
                v30 = v11 - v29
                v31 = v10 if v10 > R or v10 != v10 else R
                v39 = 0.6366197723675814 * (R - v9) / sqrt((v31 - v9) * (v31 + v9))
                v43 = v30 / 9.0 + 1e-300
                v44 = v39 if v39 > v43 or v39 != v39 else v43
                v66 = []
                for node, weight in RULE_0(v30 / v44):
                    v45 = node * v30
                    v46 = v29 + v45
                    v49 = abs(v10 * cos(v46))
                    v50 = v49 if v49 < v9 or v49 != v49 else v9
                    v54 = sqrt((R - v50) * (R + v50))
                    v64 = (asinh(v50 / v54) + R * v50 / (v54 * v54)) * v46 * sin(v46)
                    v66.append(weight * v64)
                v66 = fsum(v66) * v30
                v71 = 0.0 - v9
                v75 = sqrt((v71 if v71 > 0.0 or v71 != v71 else 0.0) * (0.0 + v9))
                v77 = v22 if v12 else hypot(v75, c)
                v78 = v77 if v12 else c
                v80 = v77 if v78 > 0.0 else v9
                v82 = asinh(v9 / v80)
                v86 = 1.5707963267948966 / v82
                v87 = atan2(v75, v78) / v82
                v88 = asinh(v86)
                v103 = asinh(atan2(v78, v75) / v82 * (v86 + v87) / (v86 * sqrt(1.0 + v87 * v87) + v87 * sqrt(1.0 + v86 * v86)))
                v105 = 2.0 * v82
                v119 = v9 * v9
                v124 = R * cos(theta)
                v126 = v9 * v9
                v130 = v126 / (v124 + R)
                v138 = v126 * R
                v139 = v124 * v124
                v156 = []
                for node, weight in RULE_1(v103 / 1.0):
                    v104 = node * v103
                    v107 = 0.5 * v104
                    v112 = v105 * cosh(v88 - v107) * sinh(v107)
                    v113 = cos(v112)
                    v116 = v80 * (v113 if v113 > 1e-17 or v113 != v113 else 1e-17)
                    v118 = v80 * sin(v112)
                    v122 = sqrt(v119 + v116 * v116)
                    v154 = (log1p((v126 / (v116 + v122) + v130) / (v116 + v124)) + v9 * atan2(v116, v9) / v124 + v138 / (v122 * v139 + R * v116 * v124)) * v116 * v82 * cosh(v88 - v104) * atan2(v118, v122) * (v118 / v122)
                    v156.append(weight * v154)
                v156 = fsum(v156) * v103
                v162 = 0.6366197723675814 * v10 * v66 + 0.6366197723675814 * v156
            v165 = sigma_0 / E_star
            if v162 - dgamma / sigma_0 - 1.2732395447351628 * v165 * c <= -(2.0 * v165 * c):
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
            v13 = R * sin(theta)
            v14 = hypot(a, v11)
            v15 = atan2(v11, a)
            v16 = a < v13
            v17 = v13 - a
            v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (v13 + a))
            v22 = v11 - v21
            v26 = sqrt((v22 if v22 > 0.0 or v22 != v22 else 0.0) * (v11 + v21))
            if v16:
                v31 = (atan2(v26 if v16 else v11, v13) if v16 else v15) if v14 > v13 else 0.0
                v33 = v31 if v31 < v15 or v31 != v31 else v15
            else:
                v33 = v15
            v34 = v15 - v33
            v35 = v14 if v14 > R or v14 != v14 else R
            v43 = 0.6366197723675814 * (R - v13) / sqrt((v35 - v13) * (v35 + v13))
            v47 = v34 / 9.0 + 1e-300
            v48 = v43 if v43 > v47 or v43 != v43 else v47
            v70 = []
            for node, weight in RULE_0(v34 / v48):
                v49 = node * v34
                v50 = v33 + v49
                v53 = abs(v14 * cos(v50))
                v54 = v53 if v53 < v13 or v53 != v53 else v13
                v58 = sqrt((R - v54) * (R + v54))
                v68 = (asinh(v54 / v58) + R * v54 / (v58 * v58)) * v50 * sin(v50)
                v70.append(weight * v68)
            v70 = fsum(v70) * v34
            v75 = a - v13
            v79 = sqrt((v75 if v75 > 0.0 or v75 != v75 else 0.0) * (a + v13))
            v81 = v26 if v16 else hypot(v79, v11)
            v82 = v81 if v16 else v11
            v84 = v81 if v82 > 0.0 else v13
            v86 = asinh(v13 / v84)
            v90 = 1.5707963267948966 / v86
            v91 = atan2(v79, v82) / v86
            v92 = asinh(v90)
            v107 = asinh(atan2(v82, v79) / v86 * (v90 + v91) / (v90 * sqrt(1.0 + v91 * v91) + v91 * sqrt(1.0 + v90 * v90)))
            v109 = 2.0 * v86
            v123 = v13 * v13
            v128 = R * cos(theta)
            v130 = v13 * v13
            v134 = v130 / (v128 + R)
            v142 = v130 * R
            v143 = v128 * v128
            v160 = []
            for node, weight in RULE_1(v107 / 1.0):
                v108 = node * v107
                v111 = 0.5 * v108
                v116 = v109 * cosh(v92 - v111) * sinh(v111)
                v117 = cos(v116)
                v120 = v84 * (v117 if v117 > 1e-17 or v117 != v117 else 1e-17)
                v122 = v84 * sin(v116)
                v126 = sqrt(v123 + v120 * v120)
                v158 = (log1p((v130 / (v120 + v126) + v134) / (v120 + v128)) + v13 * atan2(v120, v13) / v128 + v142 / (v126 * v143 + R * v120 * v128)) * v120 * v86 * cosh(v92 - v108) * atan2(v122, v126) * (v122 / v126)
                v160.append(weight * v158)
            v160 = fsum(v160) * v107
            value = sigma_0 * (0.6366197723675814 * v14 * v70 + 0.6366197723675814 * v160 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v15 - v11 / (v14 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, theta, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
