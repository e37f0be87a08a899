"""Programs of axicontact.adhesive.sphere_tipped_cone."""

from __future__ import annotations

from math import asinh, atan2, cos, exp, expm1, fsum, inf, log1p, nextafter, sin, sqrt, tanh

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import sphere_tipped_cone as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
C2 = np.array(6.283185307179586)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R, theta, E_star, dgamma):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = R * sin(theta)
            v11 = R - a
            if a < v6:
                v43 = a * (log1p(2.0 * a / v11) / 2.0)
            else:
                v8 = R * cos(theta)
                v18 = v8 * v8 - v11 * (R + a) if v8 < v6 else (a - v6) * (a + v6)
                v21 = sqrt(v18 if v18 > 0.0 or v18 != v18 else 0.0)
                v24 = v6 * v6
                v43 = a * (log1p((v24 / (v21 + a) + v24 / (v8 + R)) / (v21 + v8)) + v6 * atan2(v21, v6) / v8)
            value = v43 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, theta, E_star, dgamma):
    v5 = np.sin(theta)
    v6 = R * v5
    v7 = np.cos(theta)
    v8 = R * v7
    v9 = np.less(v8, v6)
    v10 = v8 * v8
    v24 = np.square(v6)
    v27 = v8 + R
    v28 = v24 / v27
    v47 = (6.283185307179586) * dgamma
    v48 = v47 / E_star
    v49 = np.sqrt(v48)
    return (R, v6, v8, v9, v10, v24, v28, v49)


def block_depth_a(out, a, R, v6, v8, v9, v10, v24, v28, v49, t0, t1, t2, t3, m0, f0):
    size = out.size
    np.subtract(R, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, v6, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.multiply(C0, a, t0)
        np.divide(t0, out, t0)
        np.log1p(t0, t0)
        np.multiply(t0, C1, t0)
        np.multiply(a, t0, t0)
    if some44 != size:
        other44 = t1 if some44 else t0
        if v9:
            np.add(R, a, other44)
            np.multiply(out, other44, other44)
            np.subtract(v10, other44, other44)
        else:
            np.subtract(a, v6, other44)
            np.add(a, v6, t2)
            np.multiply(other44, t2, other44)
        np.maximum(other44, f0, out=other44)
        np.sqrt(other44, other44)
        np.arctan2(other44, v6, t2)
        np.add(other44, a, t3)
        np.divide(v24, t3, t3)
        np.add(t3, v28, t3)
        np.add(other44, v8, other44)
        np.divide(t3, other44, other44)
        np.log1p(other44, other44)
        np.multiply(v6, t2, t2)
        np.divide(t2, v8, t2)
        np.add(other44, t2, t2)
        np.multiply(a, t2, other44)
        if some44:
            np.copyto(t0, other44, where=~m0)
    np.sqrt(a, out)
    np.multiply(out, v49, out)
    np.subtract(t0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, theta, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.sin(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(R, out, out)
    np.subtract(R, a, t0)
    np.less(a, out, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.multiply(C0, a, t1)
        np.divide(t1, t0, t1)
        np.log1p(t1, t1)
        np.multiply(t1, C1, t1)
        np.multiply(a, t1, t1)
    if some44 != size:
        other44 = t2 if some44 else t1
        np.cos(theta, other44)
        np.multiply(R, other44, other44)
        np.less(other44, out, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.multiply(other44, other44, t3)
            np.add(R, a, t4)
            np.multiply(t0, t4, t4)
            np.subtract(t3, t4, t3)
        if some18 != size:
            other18 = t4 if some18 else t3
            np.subtract(a, out, other18)
            np.add(a, out, t5)
            np.multiply(other18, t5, other18)
            if some18:
                np.copyto(t3, other18, where=~m1)
        np.maximum(t3, f0, out=t3)
        np.sqrt(t3, t3)
        np.arctan2(t3, out, t4)
        np.square(out, t5)
        np.add(t3, a, t6)
        np.divide(t5, t6, t6)
        np.add(other44, R, t7)
        np.divide(t5, t7, t7)
        np.add(t6, t7, t7)
        np.add(t3, other44, t3)
        np.divide(t7, t3, t3)
        np.log1p(t3, t3)
        np.multiply(out, t4, t4)
        np.divide(t4, other44, other44)
        np.add(t3, other44, other44)
        np.multiply(a, other44, other44)
        if some44:
            np.copyto(t1, other44, where=~m0)
    np.sqrt(a, t0)
    np.multiply(C2, dgamma, out)
    np.divide(out, E_star, out)
    np.sqrt(out, out)
    np.multiply(t0, out, out)
    np.subtract(t1, out, out)


def displacement(r, a, R, theta, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v7 = R * sin(theta)
            v45 = r + R
            v53 = R - r
            v77 = r - v7
            v83 = a - v7
            v85 = a + v7
            v88 = r - a
            v92 = sqrt((v88 if v88 > 0.0 or v88 != v88 else 0.0) * (r + a))
            v128 = R * cos(theta)
            v130 = v7 * v7
            v133 = v128 + R
            v134 = v130 / v133
            v202 = r > a
            if v202:
                v8 = a if a < v7 or a != a else v7
                v9 = r if r < R or r != r else R
                if v8 < v9:
                    v10 = v9 - v8
                    v16 = v8 / sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (v9 + v8))
                    v17 = asinh(v16)
                    v22 = 0.0 - expm1(-2.0 * v17)
                    v25 = v22 if v22 > 0.0 else inf
                    v43 = r - R
                    v47 = sqrt((v43 if v43 > 0.0 or v43 != v43 else 0.0) * v45)
                    v49 = v47 * v47
                    v57 = sqrt((v53 if v53 > 0.0 or v53 != v53 else 0.0) * (R + r))
                    v58 = v57 * v57
                    v71 = []
                    for node, weight in RULE_0(v17 / 1.0):
                        v27 = node * v17
                        v36 = v16 * (exp(-v27) * (0.0 - expm1(-2.0 * (v17 - v27))) / v25)
                        v39 = sqrt(1.0 + v36 * v36)
                        v41 = v9 * (v36 / v39)
                        v42 = v9 / v39
                        v50 = v42 * v42
                        v60 = sqrt(v58 + v50)
                        v70 = (asinh(v41 / v60) + R * v41 / (v60 * v60)) * atan2(v41, sqrt(v49 + v50)) * (v42 / v39)
                        v71.append(weight * v70)
                    v71 = fsum(v71) * v17
                    v72 = v71
                else:
                    v72 = inf
                if a > v7:
                    v76 = 1.0 - 2.0 * theta / 3.141592653589793
                    v81 = sqrt((v77 if v77 > 0.0 or v77 != v77 else 0.0) * (r + v7))
                    v82 = v7 / r
                    v93 = sqrt((v83 if v83 > 0.0 or v83 != v83 else 0.0) * v85) / v92
                    v95 = asinh(v93 / v82)
                    v98 = 0.0 - expm1(-2.0 * v95)
                    v100 = v98 if v98 > 0.0 else inf
                    v117 = v7 * v7
                    v121 = v82 * v82
                    v142 = v130 * R
                    v143 = v128 * v128
                    v156 = []
                    for node, weight in RULE_0(v95 / v76):
                        v102 = node * v95
                        v111 = v93 * (exp(-v102) * (0.0 - expm1(-2.0 * (v95 - v102))) / v100)
                        v112 = v111 * v111
                        v114 = sqrt(1.0 + v112)
                        v116 = v81 * v111 / v114
                        v120 = sqrt(v117 + v116 * v116)
                        v155 = (log1p((v130 / (v116 + v120) + v134) / (v116 + v128)) + v7 * atan2(v116, v7) / v128 + v142 / (v120 * v143 + R * v116 * v128)) * v116 / v120 * atan2(v120, v81 / v114) * (sqrt(v121 + v112) / (v114 * v114 * v114))
                        v156.append(weight * v155)
                    v156 = fsum(v156) * v95
                    v158 = v81 * v156
                else:
                    v158 = 0.0
                v203 = 0.6366197723675814 * (v72 + v158)
            else:
                v164 = R - a
                if a < v7:
                    v189 = a * (log1p(2.0 * a / v164) / 2.0)
                else:
                    v169 = v128 * v128 - v164 * (R + a) if v128 < v7 else v83 * v85
                    v171 = sqrt(v169 if v169 > 0.0 or v169 != v169 else 0.0)
                    v189 = a * (log1p((v130 / (v171 + a) + v134) / (v171 + v128)) + v7 * atan2(v171, v7) / v128)
                v203 = v189 - (r * r / (sqrt(v53 * v45) + R) if r < v7 else v7 * (v77 / v128 + v7 / v133))
            value = v203 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v92) if v202 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, theta, E_star, dgamma):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = R * sin(theta)
            v8 = R * cos(theta)
            v18 = v8 * v8 - (R - a) * (R + a) if v8 < v6 else (a - v6) * (a + v6)
            v21 = sqrt(v18 if v18 > 0.0 or v18 != v18 else 0.0)
            v22 = a if a < v6 or a != a else v6
            v30 = asinh(v22 / (sqrt((R - v22) * (v22 + R)) if a < v6 else v8))
            v35 = tanh(v30)
            if v30 < 1.0:
                v41 = v30 * v30
                v76 = v35 * (v35 * v35) * ((((((1.0716932453474512e-06 * v41 + 0.00019982814521087247) * v41 + 0.007076196047699156) * v41 + 0.08608622548411103) * v41 + 0.3073858328214721) * v41 + 0.3333333333333333) / (((((2.565078604208634e-08 * v41 + 2.0203143566039827e-05) * v41 + 0.001617010334189783) * v41 + 0.03639274880225476) * v41 + 0.32215749846441627) * v41 + 1.0))
            else:
                v76 = v30 - v35
            v80 = 2.0 * E_star
            v84 = 1.0 - 2.0 * theta / 3.141592653589793
            v86 = asinh(v21 / v6)
            v90 = 0.0 - expm1(-2.0 * v86)
            v93 = v90 if v90 > 0.0 else inf
            v104 = v6 * v6
            v109 = v6 * v6
            v113 = v109 / (v8 + R)
            v121 = v109 * R
            v122 = v8 * v8
            v131 = []
            for node, weight in RULE_0(v86 / v84):
                v94 = node * v86
                v103 = v21 * (exp(-v94) * (0.0 - expm1(-2.0 * (v86 - v94))) / v93)
                v107 = sqrt(v104 + v103 * v103)
                v130 = (log1p((v109 / (v103 + v107) + v113) / (v103 + v8)) + v6 * atan2(v103, v6) / v8 + v121 / (v107 * v122 + R * v103 * v8)) * v103 * v107
                v131.append(weight * v130)
            v131 = fsum(v131) * v86
            value = E_star * (v22 * v22 * v30 + R * R * v76) + v80 * v131 - v80 * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, R, theta, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v7 = R * sin(theta)
            v8 = a if a < v7 or a != a else v7
            v9 = R - r
            v21 = v8 - r
            v22 = v8 + r
            v34 = sqrt((v21 if v21 > 0.0 or v21 != v21 else 0.0) * v22)
            v39 = R + sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (R + r))
            v40 = v8 + v34
            v41 = v40 / v39
            if r < a:
                v19 = R * cos(theta)
                v26 = E_star / 3.141592653589793
                if r < v8:
                    v44 = r * (r / v40) / v39
                    v45 = v41 * v41
                    v46 = v44 * v44
                    v52 = 0.13579013365982337 * v45 + -0.4846453962188766
                    v57 = v52 * v45 + 0.8293825948837366
                    v62 = v57 * v45 + -0.8745573865774817
                    v67 = v62 * v45 + 0.6371928816963097
                    v72 = v67 * v45 + -0.3332798652335896
                    v77 = v72 * v45 + 0.13289328569967984
                    v82 = v77 * v45 + -0.03710676078458442
                    v87 = v82 * v45 + 0.011089560042611895
                    v92 = v87 * v45 + 0.0012521687336059639
                    v97 = v92 * v45 + 0.0036572276005780893
                    v102 = v97 * v45 + 0.004425450516633092
                    v107 = v102 * v45 + 0.005918487051520244
                    v108 = ((((((((((((0.0 * v46 + 0.13579013365982337) * v46 + v52) * v46 + v57) * v46 + v62) * v46 + v67) * v46 + v72) * v46 + v77) * v46 + v82) * v46 + v87) * v46 + v92) * v46 + v97) * v46 + v102) * v46
                    v112 = v107 * v45 + 0.008264397984935742
                    v117 = v112 * v45 + 0.012345681107818056
                    v122 = v117 * v45 + 0.020408163224119494
                    v127 = v122 * v45 + 0.04000000000042643
                    v132 = v127 * v45 + 0.11111111111110937
                    v151 = v26 * (R * asinh(sqrt(v21 * v22) / (sqrt((R - v8) * (v8 + R)) if a < v7 else v19)) / sqrt(v9 * (r + R)) + 2.0 * v34 / v39 * (v132 * v45 + 1.0 + v44 * (v44 + v41) * ((((((v108 + v107) * v46 + v112) * v46 + v117) * v46 + v122) * v46 + v127) * v46 + v132)))
                else:
                    v151 = 0.0
                v158 = nextafter(v7, inf) if r == v7 else r
                if a > (v158 if v158 > v7 or v158 != v158 else v7):
                    v154 = 1.0 - 2.0 * theta / 3.141592653589793
                    v159 = v158 < v7
                    v161 = a - v7
                    v165 = sqrt((v161 if v161 > 0.0 or v161 != v161 else 0.0) * (a + v7))
                    if v159:
                        v171 = v165
                    else:
                        v166 = a - v158
                        v171 = sqrt((v166 if v166 > 0.0 or v166 != v166 else 0.0) * (a + v158))
                    v178 = asinh(v171 / sqrt(abs(v158 - v7) * (v158 + v7)))
                    v179 = 2.0 * (0.0 if v159 else 1.0)
                    v180 = 1.0 - v179
                    v185 = v179 - v180 * expm1(-2.0 * v178)
                    v187 = v185 if v185 > 0.0 else inf
                    v201 = v7 * v7
                    v206 = v7 * v7
                    v210 = v206 / (v19 + R)
                    v218 = v206 * R
                    v219 = v19 * v19
                    v228 = []
                    for node, weight in RULE_0(v178 / v154):
                        v190 = node * v178
                        v200 = v165 * (exp(-v190) * (v179 - v180 * expm1(-2.0 * (v178 - v190))) / v187)
                        v204 = sqrt(v201 + v200 * v200)
                        v227 = (log1p((v206 / (v200 + v204) + v210) / (v200 + v19)) + v7 * atan2(v200, v7) / v19 + v218 / (v204 * v219 + R * v200 * v19)) * v200 / v204
                        v228.append(weight * v227)
                    v228 = fsum(v228) * v178
                    v229 = v228
                else:
                    v229 = 0.0
                v233 = v151 + v26 * v229
            else:
                v233 = 0.0
            if r <= a:
                v239 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                if v239 > 0.0:
                    v242 = a - r
                    v249 = E_star * v239 / (3.141592653589793 * sqrt((v242 if v242 > 0.0 or v242 != v242 else 0.0) * (a + r)))
                else:
                    v249 = 0.0
                v251 = v249
            else:
                v251 = 0.0
            if v41 > 0.7:
                return None
            value = v233 - v251
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R, theta, E_star, dgamma, control):
    if R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and R > 1e-30 and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(R, theta, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, theta, E_star, dgamma):
    if d.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, theta, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, theta, E_star, dgamma):
    if F.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, theta, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, R, theta, E_star):
    if F.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, R, theta, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, theta, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'theta', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 4, 1, (0.0,), False),
        ('a', 'R', 'theta', 'E_star', 'dgamma'): (('a', 'R', 'theta', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 8, 2, (0.0,), False),
    },
}
