"""Programs of axicontact.normal.sphere_tipped_cone."""

from __future__ import annotations

from math import asinh, atan2, cos, exp, expm1, fsum, inf, log1p, nextafter, sin, sqrt, tanh

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import sphere_tipped_cone as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R, theta):
    if a.__class__ is R.__class__ is theta.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            v4 = R * sin(theta)
            v9 = R - a
            if a < v4:
                return a * (log1p(2.0 * a / v9) / 2.0)
            v6 = R * cos(theta)
            v16 = v6 * v6 - v9 * (R + a) if v6 < v4 else (a - v4) * (a + v4)
            v19 = sqrt(v16 if v16 > 0.0 or v16 != v16 else 0.0)
            v22 = v4 * v4
            value = a * (log1p((v22 / (v19 + a) + v22 / (v6 + R)) / (v19 + v6)) + v4 * atan2(v19, v4) / v6)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, theta):
    v3 = np.sin(theta)
    v4 = R * v3
    v5 = np.cos(theta)
    v6 = R * v5
    v7 = np.less(v6, v4)
    v8 = v6 * v6
    v22 = np.square(v4)
    v25 = v6 + R
    v26 = v22 / v25
    return (R, v4, v6, v7, v8, v22, v26)


def block_depth_a(out, a, R, v4, v6, v7, v8, v22, v26, t0, t1, t2, t3, m0, f0):
    size = out.size
    np.subtract(R, a, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, v4, m0)
    some42 = np.count_nonzero(m0)
    if some42:
        np.multiply(C0, a, out)
        np.divide(out, t0, out)
        np.log1p(out, out)
        np.multiply(out, C1, out)
        np.multiply(a, out, out)
    if some42 != size:
        other42 = t1 if some42 else out
        if v7:
            np.add(R, a, other42)
            np.multiply(t0, other42, other42)
            np.subtract(v8, other42, other42)
        else:
            np.subtract(a, v4, other42)
            np.add(a, v4, t2)
            np.multiply(other42, t2, other42)
        np.maximum(other42, f0, out=other42)
        np.sqrt(other42, other42)
        np.arctan2(other42, v4, t2)
        np.add(other42, a, t3)
        np.divide(v22, t3, t3)
        np.add(t3, v26, t3)
        np.add(other42, v6, other42)
        np.divide(t3, other42, other42)
        np.log1p(other42, other42)
        np.multiply(v4, t2, t2)
        np.divide(t2, v6, t2)
        np.add(other42, t2, t2)
        np.multiply(a, t2, other42)
        if some42:
            np.copyto(out, other42, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, theta, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.sin(theta, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(R, t0, t0)
    np.subtract(R, a, t1)
    np.less(a, t0, m0)
    some42 = np.count_nonzero(m0)
    if some42:
        np.multiply(C0, a, out)
        np.divide(out, t1, out)
        np.log1p(out, out)
        np.multiply(out, C1, out)
        np.multiply(a, out, out)
    if some42 != size:
        other42 = t2 if some42 else out
        np.cos(theta, other42)
        np.multiply(R, other42, other42)
        np.less(other42, t0, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.multiply(other42, other42, t3)
            np.add(R, a, t4)
            np.multiply(t1, t4, t4)
            np.subtract(t3, t4, t3)
        if some16 != size:
            other16 = t4 if some16 else t3
            np.subtract(a, t0, other16)
            np.add(a, t0, t5)
            np.multiply(other16, t5, other16)
            if some16:
                np.copyto(t3, other16, where=~m1)
        np.maximum(t3, f0, out=t3)
        np.sqrt(t3, t3)
        np.arctan2(t3, t0, t4)
        np.square(t0, t5)
        np.add(t3, a, t6)
        np.divide(t5, t6, t6)
        np.add(other42, R, t7)
        np.divide(t5, t7, t7)
        np.add(t6, t7, t7)
        np.add(t3, other42, t3)
        np.divide(t7, t3, t3)
        np.log1p(t3, t3)
        np.multiply(t0, t4, t4)
        np.divide(t4, other42, other42)
        np.add(t3, other42, other42)
        np.multiply(a, other42, other42)
        if some42:
            np.copyto(out, other42, where=~m0)


def depth_from_force(F, R, theta, E_star):
    if F.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R, theta, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, theta, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R, theta):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
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
                value = 0.6366197723675814 * (v70 + v156)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta):
                    return value
                return None
            v162 = R - a
            if a < v5:
                v187 = a * (log1p(2.0 * a / v162) / 2.0)
            else:
                v167 = v126 * v126 - v162 * (R + a) if v126 < v5 else v81 * v83
                v169 = sqrt(v167 if v167 > 0.0 or v167 != v167 else 0.0)
                v187 = a * (log1p((v128 / (v169 + a) + v132) / (v169 + v126)) + v5 * atan2(v169, v5) / v126)
            value = v187 - (r * r / (sqrt(v51 * v43) + R) if r < v5 else v5 * (v75 / v126 + v5 / v131))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, R, theta, E_star):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = R * sin(theta)
            v7 = R * cos(theta)
            v8 = v7 < v5
            v9 = v7 * v7
            v10 = R - a
            v14 = a - v5
            v15 = a + v5
            v23 = v5 * v5
            v27 = v23 / (v7 + R)
            if a < v5:
                v42 = a * (log1p(2.0 * a / v10) / 2.0)
            else:
                v17 = v9 - v10 * (R + a) if v8 else v14 * v15
                v20 = sqrt(v17 if v17 > 0.0 or v17 != v17 else 0.0)
                v42 = a * (log1p((v23 / (v20 + a) + v27) / (v20 + v7)) + v5 * atan2(v20, v5) / v7)
            v43 = a if a < v5 or a != a else v5
            v48 = 1.0 - 2.0 * theta / 3.141592653589793
            v50 = asinh(v43 / R)
            v54 = 0.0 - expm1(-2.0 * v50)
            v57 = v54 if v54 > 0.0 else inf
            v98 = R * R
            v103 = []
            for node, weight in RULE_0(v50 / v48):
                v58 = node * v50
                v67 = v43 * (exp(-v58) * (0.0 - expm1(-2.0 * (v50 - v58))) / v57)
                v68 = R - v67
                if v67 < v5:
                    v95 = v67 * (log1p(2.0 * v67 / v68) / 2.0)
                else:
                    v75 = v9 - v68 * (R + v67) if v8 else (v67 - v5) * (v67 + v5)
                    v77 = sqrt(v75 if v75 > 0.0 or v75 != v75 else 0.0)
                    v95 = v67 * (log1p((v23 / (v77 + v67) + v27) / (v77 + v7)) + v5 * atan2(v77, v5) / v7)
                v96 = v42 - v95
                v102 = v96 * v96 * sqrt(v98 + v67 * v67)
                v103.append(weight * v102)
            v103 = fsum(v103) * v50
            if a > v5:
                v107 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * v15)
                v109 = asinh(v107 / v5)
                v112 = 0.0 - expm1(-2.0 * v109)
                v114 = v112 if v112 > 0.0 else inf
                v126 = v5 * v5
                v152 = []
                for node, weight in RULE_0(v109 / v48):
                    v116 = node * v109
                    v125 = v107 * (exp(-v116) * (0.0 - expm1(-2.0 * (v109 - v116))) / v114)
                    v129 = sqrt(v126 + v125 * v125)
                    v149 = v42 - (v129 * (log1p(2.0 * v129 / (R - v129)) / 2.0) if v129 < v5 else v129 * (log1p((v23 / (v125 + v129) + v27) / (v125 + v7)) + v5 * atan2(v125, v5) / v7))
                    v151 = v149 * v149 * v125
                    v152.append(weight * v151)
                v152 = fsum(v152) * v109
                v153 = v152
            else:
                v153 = 0.0
            value = E_star * (v103 + v153)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, theta, E_star):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
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
            value = E_star * (v21 * v21 * v29 + R * R * v75) + 2.0 * E_star * v130
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, theta, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force_from_depth(d, R, theta, E_star):
    if d.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R, theta, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, theta, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, R, theta, E_star):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = R * sin(theta)
            v7 = a if a < v6 or a != a else v6
            v8 = r if r < v7 or r != r else v7
            v38 = v8 > 0.0
            if v38 and v7 < R:
                v9 = R - v8
                v14 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (R + v8))
                v15 = v8 / R
                v16 = v7 - v8
                v21 = R - v7
                v26 = sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (v7 + v8)) / sqrt((v21 if v21 > 0.0 or v21 != v21 else 0.0) * (R + v7))
                v28 = asinh(v26 / v15)
                v33 = 0.0 - expm1(-2.0 * v28)
                v36 = v33 if v33 > 0.0 else inf
                v37 = v8 * v8
                v75 = v15 * v15
                v79 = []
                for node, weight in RULE_0(v28 / 1.0):
                    v42 = node * v28
                    v51 = v26 * (exp(-v42) * (0.0 - expm1(-2.0 * (v28 - v42))) / v36)
                    v52 = v51 * v51
                    v54 = sqrt(1.0 + v52)
                    v56 = v14 * (v51 / v54)
                    v57 = v14 / v54
                    v60 = sqrt(v37 + v56 * v56)
                    v78 = (asinh(v60 / v57) + R * v60 / (v57 * v57)) * (v56 / (v60 + v56)) * (v57 / (v54 * v54 * v60)) * sqrt(v75 + v52)
                    v79.append(weight * v78)
                v79 = fsum(v79) * v28
                v81 = v37 * v79
            else:
                v81 = inf if v38 else 0.0
            v85 = 1.0 - 2.0 * theta / 3.141592653589793
            v88 = nextafter(v6, inf) if r == v6 else r
            v143 = v6 * v6
            v148 = R * cos(theta)
            v150 = v6 * v6
            v154 = v150 / (v148 + R)
            v162 = v150 * R
            v163 = v148 * v148
            if a > (v88 if v88 > v6 or v88 != v88 else v6):
                v89 = v88 < v6
                v90 = 0.0 if v89 else 1.0
                v91 = a - v6
                v95 = sqrt((v91 if v91 > 0.0 or v91 != v91 else 0.0) * (a + v6))
                v96 = a - v88
                v100 = sqrt((v96 if v96 > 0.0 or v96 != v96 else 0.0) * (a + v88))
                v108 = asinh((v95 if v89 else v100) / sqrt(abs(v88 - v6) * (v88 + v6)))
                v109 = 2.0 * v90
                v110 = 1.0 - v109
                v112 = expm1(-2.0 * v108)
                v114 = v109 - v110 * v112
                v116 = v114 if v114 > 0.0 else inf
                v118 = 2.0 * (1.0 - v90)
                v119 = 1.0 - v118
                v121 = v118 - v119 * v112
                v123 = v121 if v121 > 0.0 else inf
                v175 = []
                for node, weight in RULE_0(v108 / v85):
                    v127 = node * v108
                    v129 = exp(-v127)
                    v132 = expm1(-2.0 * (v108 - v127))
                    v137 = v95 * (v129 * (v109 - v110 * v132) / v116)
                    v142 = v100 * (v129 * (v118 - v119 * v132) / v123)
                    v146 = sqrt(v143 + v137 * v137)
                    v174 = (log1p((v150 / (v137 + v146) + v154) / (v137 + v148)) + v6 * atan2(v137, v6) / v148 + v162 / (v146 * v163 + R * v137 * v148)) * (v137 / v146) * (v142 / (v146 + v142))
                    v175.append(weight * v174)
                v175 = fsum(v175) * v108
                v177 = v88 * v88 * v175
            else:
                v177 = 0.0
            v178 = r if r < a or r != r else a
            v188 = v148 * v148 - (R - v178) * (R + v178) if v148 < v6 else (v178 - v6) * (v178 + v6)
            v190 = sqrt(v188 if v188 > 0.0 or v188 != v188 else 0.0)
            v191 = v178 if v178 < v6 or v178 != v178 else v6
            v199 = asinh(v191 / (sqrt((R - v191) * (v191 + R)) if v178 < v6 else v148))
            v203 = tanh(v199)
            if v199 < 1.0:
                v208 = v199 * v199
                v243 = v203 * (v203 * v203) * ((((((1.0716932453474512e-06 * v208 + 0.00019982814521087247) * v208 + 0.007076196047699156) * v208 + 0.08608622548411103) * v208 + 0.3073858328214721) * v208 + 0.3333333333333333) / (((((2.565078604208634e-08 * v208 + 2.0203143566039827e-05) * v208 + 0.001617010334189783) * v208 + 0.03639274880225476) * v208 + 0.32215749846441627) * v208 + 1.0))
            else:
                v243 = v199 - v203
            v247 = 2.0 * E_star
            v249 = asinh(v190 / v6)
            v252 = 0.0 - expm1(-2.0 * v249)
            v254 = v252 if v252 > 0.0 else inf
            v286 = []
            for node, weight in RULE_0(v249 / v85):
                v255 = node * v249
                v264 = v190 * (exp(-v255) * (0.0 - expm1(-2.0 * (v249 - v255))) / v254)
                v267 = sqrt(v143 + v264 * v264)
                v285 = (log1p((v150 / (v264 + v267) + v154) / (v264 + v148)) + v6 * atan2(v264, v6) / v148 + v162 / (v267 * v163 + R * v264 * v148)) * v264 * v267
                v286.append(weight * v285)
            v286 = fsum(v286) * v249
            value = E_star * (v191 * v191 * v199 + R * R * v243) + v247 * v286 + v247 * (v81 + v177)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, R, theta, E_star):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a > 0.0:
                v7 = R * sin(theta)
                v9 = R * cos(theta)
                v19 = v9 * v9 - (R - a) * (R + a) if v9 < v7 else (a - v7) * (a + v7)
                v21 = sqrt(v19 if v19 > 0.0 or v19 != v19 else 0.0)
                v22 = a if a < v7 or a != a else v7
                v30 = asinh(v22 / (sqrt((R - v22) * (v22 + R)) if a < v7 else v9))
                v35 = tanh(v30)
                if v30 < 1.0:
                    v41 = v30 * v30
                    v76 = v35 * (v35 * v35) * ((((((1.0716932453474512e-06 * v41 + 0.00019982814521087247) * v41 + 0.007076196047699156) * v41 + 0.08608622548411103) * v41 + 0.3073858328214721) * v41 + 0.3333333333333333) / (((((2.565078604208634e-08 * v41 + 2.0203143566039827e-05) * v41 + 0.001617010334189783) * v41 + 0.03639274880225476) * v41 + 0.32215749846441627) * v41 + 1.0))
                else:
                    v76 = v30 - v35
                v84 = 1.0 - 2.0 * theta / 3.141592653589793
                v86 = asinh(v21 / v7)
                v90 = 0.0 - expm1(-2.0 * v86)
                v93 = v90 if v90 > 0.0 else inf
                v104 = v7 * v7
                v109 = v7 * v7
                v113 = v109 / (v9 + R)
                v121 = v109 * R
                v122 = v9 * v9
                v131 = []
                for node, weight in RULE_0(v86 / v84):
                    v94 = node * v86
                    v103 = v21 * (exp(-v94) * (0.0 - expm1(-2.0 * (v86 - v94))) / v93)
                    v107 = sqrt(v104 + v103 * v103)
                    v130 = (log1p((v109 / (v103 + v107) + v113) / (v103 + v9)) + v7 * atan2(v103, v7) / v9 + v121 / (v107 * v122 + R * v103 * v9)) * v103 * v107
                    v131.append(weight * v130)
                v131 = fsum(v131) * v86
                value = (E_star * (v22 * v22 * v30 + R * R * v76) + 2.0 * E_star * v131) / (3.141592653589793 * (a * a))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, R, theta, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, R, theta, E_star):
    if r.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = R * sin(theta)
            v7 = a if a < v6 or a != a else v6
            v8 = R - r
            v20 = v7 - r
            v21 = v7 + r
            v33 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * v21)
            v38 = R + sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (R + r))
            v39 = v7 + v33
            v40 = v39 / v38
            if v40 > 0.7:
                return None
            if r < a:
                v18 = R * cos(theta)
                v25 = E_star / 3.141592653589793
                if r < v7:
                    v43 = r * (r / v39) / v38
                    v44 = v40 * v40
                    v45 = v43 * v43
                    v51 = 0.13579013365982337 * v44 + -0.4846453962188766
                    v56 = v51 * v44 + 0.8293825948837366
                    v61 = v56 * v44 + -0.8745573865774817
                    v66 = v61 * v44 + 0.6371928816963097
                    v71 = v66 * v44 + -0.3332798652335896
                    v76 = v71 * v44 + 0.13289328569967984
                    v81 = v76 * v44 + -0.03710676078458442
                    v86 = v81 * v44 + 0.011089560042611895
                    v91 = v86 * v44 + 0.0012521687336059639
                    v96 = v91 * v44 + 0.0036572276005780893
                    v101 = v96 * v44 + 0.004425450516633092
                    v106 = v101 * v44 + 0.005918487051520244
                    v107 = ((((((((((((0.0 * v45 + 0.13579013365982337) * v45 + v51) * v45 + v56) * v45 + v61) * v45 + v66) * v45 + v71) * v45 + v76) * v45 + v81) * v45 + v86) * v45 + v91) * v45 + v96) * v45 + v101) * v45
                    v111 = v106 * v44 + 0.008264397984935742
                    v116 = v111 * v44 + 0.012345681107818056
                    v121 = v116 * v44 + 0.020408163224119494
                    v126 = v121 * v44 + 0.04000000000042643
                    v131 = v126 * v44 + 0.11111111111110937
                    v150 = v25 * (R * asinh(sqrt(v20 * v21) / (sqrt((R - v7) * (v7 + R)) if a < v6 else v18)) / sqrt(v8 * (r + R)) + 2.0 * v33 / v38 * (v131 * v44 + 1.0 + v43 * (v43 + v40) * ((((((v107 + v106) * v45 + v111) * v45 + v116) * v45 + v121) * v45 + v126) * v45 + v131)))
                else:
                    v150 = 0.0
                v157 = nextafter(v6, inf) if r == v6 else r
                if a > (v157 if v157 > v6 or v157 != v157 else v6):
                    v153 = 1.0 - 2.0 * theta / 3.141592653589793
                    v158 = v157 < v6
                    v160 = a - v6
                    v164 = sqrt((v160 if v160 > 0.0 or v160 != v160 else 0.0) * (a + v6))
                    if v158:
                        v170 = v164
                    else:
                        v165 = a - v157
                        v170 = sqrt((v165 if v165 > 0.0 or v165 != v165 else 0.0) * (a + v157))
                    v177 = asinh(v170 / sqrt(abs(v157 - v6) * (v157 + v6)))
                    v178 = 2.0 * (0.0 if v158 else 1.0)
                    v179 = 1.0 - v178
                    v184 = v178 - v179 * expm1(-2.0 * v177)
                    v186 = v184 if v184 > 0.0 else inf
                    v200 = v6 * v6
                    v205 = v6 * v6
                    v209 = v205 / (v18 + R)
                    v217 = v205 * R
                    v218 = v18 * v18
                    v227 = []
                    for node, weight in RULE_0(v177 / v153):
                        v189 = node * v177
                        v199 = v164 * (exp(-v189) * (v178 - v179 * expm1(-2.0 * (v177 - v189))) / v186)
                        v203 = sqrt(v200 + v199 * v199)
                        v226 = (log1p((v205 / (v199 + v203) + v209) / (v199 + v18)) + v6 * atan2(v199, v6) / v18 + v217 / (v203 * v218 + R * v199 * v18)) * v199 / v203
                        v227.append(weight * v226)
                    v227 = fsum(v227) * v177
                    v228 = v227
                else:
                    v228 = 0.0
                value = v150 + v25 * v228
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, theta, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, R, theta):
    if r.__class__ is R.__class__ is theta.__class__ is float and r > 1e-30 and (r < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            v4 = R * sin(theta)
            if r < v4:
                return r * r / (sqrt((R - r) * (r + R)) + R)
            v10 = R * cos(theta)
            value = v4 * ((r - v4) / v10 + v4 / (v10 + R))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R, theta):
    v3 = np.sin(theta)
    v4 = R * v3
    v9 = np.cos(theta)
    v10 = R * v9
    v18 = v10 + R
    v19 = v4 / v18
    return (R, v4, v10, v19)


def block_profile_r(out, r, R, v4, v10, v19, t0, m0):
    size = out.size
    np.less(r, v4, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(R, r, out)
        np.add(r, R, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.square(r, out)
        np.add(t0, R, t0)
        np.divide(out, t0, out)
    if some22 != size:
        other22 = t0 if some22 else out
        np.subtract(r, v4, other22)
        np.divide(other22, v10, other22)
        np.add(other22, v19, other22)
        np.multiply(v4, other22, other22)
        if some22:
            np.copyto(out, other22, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, theta, t0, t1, t2, m0):
    size = out.size
    np.sin(theta, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(R, t0, t0)
    np.less(r, t0, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(R, r, out)
        np.add(r, R, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.square(r, out)
        np.add(t1, R, t1)
        np.divide(out, t1, out)
    if some22 != size:
        other22 = t1 if some22 else out
        np.cos(theta, other22)
        np.multiply(R, other22, other22)
        np.subtract(r, t0, t2)
        np.divide(t2, other22, t2)
        np.add(other22, R, other22)
        np.divide(t0, other22, other22)
        np.add(t2, other22, other22)
        np.multiply(t0, other22, other22)
        if some22:
            np.copyto(out, other22, where=~m0)


def radius_from_depth(d, R, theta):
    if d.__class__ is R.__class__ is theta.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            value = bodies._radius_from_depth(d, R, theta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, theta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, theta, E_star):
    if F.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, theta, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, theta, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, R=1.0, theta=0.7853981633974483):
    if a.__class__ is E_star.__class__ is R.__class__ is theta.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            return 2.0 * E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_a(E_star):
    v3 = (2.0) * E_star
    return (v3,)


def block_stiffness_a(out, a, v3):
    np.multiply(v3, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, a, E_star):
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'theta'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 4, 1, (0.0,), False),
        ('a', 'R', 'theta'): (('a', 'R', 'theta'), prepare_depth_all, block_depth_all, 8, 2, (0.0,), False),
    },
    ('_profile', 1, 'r', 'R', 'theta'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 1, (), False),
        ('r', 'R', 'theta'): (('r', 'R', 'theta'), prepare_profile_all, block_profile_all, 3, 1, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
