"""Programs of axicontact.tangential.rounded_cone."""

from __future__ import annotations

from math import asinh, atan, cosh, exp, expm1, fsum, inf, log1p, nextafter, pow, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import rounded_cone as bodies

C0 = np.array(2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, theta, b, E_star, G_star, mu):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v8 = tan(theta)
            if a < b:
                v25 = v8 / b * (a * a)
            else:
                v16 = sqrt((a - b) * (a + b))
                v25 = v8 * a * (atan(v16 / b) + b / (v16 + a))
            return mu * (E_star / G_star) * v25
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(theta, b, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v8 = np.tan(theta)
    v9 = v8 / b
    return (b, v7, v8, v9)


def block_full_slip_displacement_a(out, a, b, v7, v8, v9, t0, t1, t2, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        np.square(a, out)
        np.multiply(v9, out, out)
    if some25 != size:
        other25 = t0 if some25 else out
        np.subtract(a, b, other25)
        np.add(a, b, t1)
        np.multiply(other25, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, b, other25)
        np.arctan(other25, other25)
        np.multiply(v8, a, t2)
        np.add(t1, a, t1)
        np.divide(b, t1, t1)
        np.add(other25, t1, t1)
        np.multiply(t2, t1, other25)
        if some25:
            np.copyto(out, other25, where=~m0)
    np.multiply(v7, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, theta, b, E_star, G_star, mu, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.tan(theta, t0)
    np.less(a, b, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.divide(t0, b, t1)
        np.square(a, t2)
        np.multiply(t1, t2, t1)
    if some25 != size:
        other25 = t2 if some25 else t1
        np.subtract(a, b, other25)
        np.add(a, b, t3)
        np.multiply(other25, t3, t3)
        np.sqrt(t3, t3)
        np.divide(t3, b, other25)
        np.arctan(other25, other25)
        np.multiply(t0, a, t4)
        np.add(t3, a, t3)
        np.divide(b, t3, t3)
        np.add(other25, t3, t3)
        np.multiply(t4, t3, other25)
        if some25:
            np.copyto(t1, other25, where=~m0)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, theta, b, E_star, mu):
    if F_x.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, theta, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, theta, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, theta, b, E_star, G_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = tan(theta)
            v8 = v7 / b
            v12 = a - b
            v13 = a + b
            if a < b:
                v24 = v8 * (a * a)
            else:
                v15 = sqrt(v12 * v13)
                v24 = v7 * a * (atan(v15 / b) + b / (v15 + a))
            if c < b:
                v39 = v8 * (c * c)
            else:
                v30 = sqrt((c - b) * (c + b))
                v39 = v7 * c * (atan(v30 / b) + b / (v30 + c))
            v42 = v39 >= 0.25 * v24
            if v42:
                v43 = a if a < b or a != a else b
                v56 = v43 > c
                v66 = v42 and v56
                if v66:
                    v45 = c - 0.0
                    v49 = sqrt((v45 if v45 > 0.0 or v45 != v45 else 0.0) * (c + 0.0))
                    if v66:
                        v50 = v43 - c
                        if v56:
                            v51 = v43 - 0.0
                            v61 = v50 * (v43 + c) / (sqrt((v51 if v51 > 0.0 or v51 != v51 else 0.0) * (v43 + 0.0)) + v49)
                        else:
                            v61 = 0.0
                        v67 = log1p((v50 + v61) / (c + v49))
                    else:
                        v67 = 0.0
                    v76 = 2.0 * v7 / b
                    v80 = []
                    for node, weight in RULE_0(v67 / 1.0):
                        v69 = node * v67
                        v74 = c * cosh(v69) + v49 * sinh(v69)
                        v79 = v76 * v74 * pow(v74, 1.0)
                        v80.append(weight * v79)
                    v80 = fsum(v80) * v67
                    v81 = v80
                else:
                    v81 = 0.0
                v82 = b if b > c or b != b else c
                v96 = a > v82
                v112 = v42 and v96
                if v112:
                    v83 = v82 - b
                    v87 = sqrt((v83 if v83 > 0.0 or v83 != v83 else 0.0) * (v82 + b))
                    v88 = v82 - 0.0
                    v92 = sqrt((v88 if v88 > 0.0 or v88 != v88 else 0.0) * (v82 + 0.0))
                    if v112:
                        v99 = (a - v82) * (a + v82)
                        if v96:
                            v103 = a - 0.0
                            v110 = v99 / (sqrt((v103 if v103 > 0.0 or v103 != v103 else 0.0) * (a + 0.0)) + v92)
                        else:
                            v110 = 0.0
                        v116 = log1p(((v99 / (sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * v13) + v87) if v96 else 0.0) + v110) / (v87 + v92))
                    else:
                        v116 = 0.0
                    v123 = b * b
                    v129 = 2.0 * b
                    v138 = []
                    for node, weight in RULE_0(v116 / 1.0):
                        v117 = node * v116
                        v122 = v87 * cosh(v117) + v92 * sinh(v117)
                        v126 = sqrt(v123 + v122 * v122)
                        v137 = v7 * (atan(v122 / b) + v129 / (v122 + v126)) * (v122 / v126) * pow(v126, 1.0)
                        v138.append(weight * v137)
                    v138 = fsum(v138) * v116
                    v139 = v138
                else:
                    v139 = 0.0
                v144 = v81 + v139
            else:
                v144 = v24 - v39
            value = mu * (E_star / G_star) * v144
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, theta, b, E_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v8 = tan(theta)
            v12 = 4.0 * E_star * v8 / (3.0 * b)
            v14 = a * a
            v17 = a - b
            v18 = a + b
            v23 = E_star * v8
            v25 = 4.0 * b
            v31 = b / 3.0
            if a < b:
                v36 = v12 * (a * v14)
            else:
                v20 = sqrt(v17 * v18)
                v36 = v23 * (v14 * atan(v20 / b) + v25 * v14 / (3.0 * (v20 + a)) + v31 * v20)
            v37 = c * c
            if c < b:
                v56 = v12 * (c * v37)
            else:
                v43 = sqrt((c - b) * (c + b))
                v56 = v23 * (v37 * atan(v43 / b) + v25 * v37 / (3.0 * (v43 + c)) + v31 * v43)
            v59 = v56 >= 0.25 * v36
            if v59:
                v60 = a if a < b or a != a else b
                v73 = v60 > c
                v83 = v59 and v73
                if v83:
                    v62 = c - 0.0
                    v66 = sqrt((v62 if v62 > 0.0 or v62 != v62 else 0.0) * (c + 0.0))
                    if v83:
                        v67 = v60 - c
                        if v73:
                            v68 = v60 - 0.0
                            v78 = v67 * (v60 + c) / (sqrt((v68 if v68 > 0.0 or v68 != v68 else 0.0) * (v60 + 0.0)) + v66)
                        else:
                            v78 = 0.0
                        v84 = log1p((v67 + v78) / (c + v66))
                    else:
                        v84 = 0.0
                    v93 = 2.0 * v8 / b
                    v97 = []
                    for node, weight in RULE_0(v84 / 1.0):
                        v86 = node * v84
                        v91 = c * cosh(v86) + v66 * sinh(v86)
                        v96 = v93 * v91 * (v91 * v91)
                        v97.append(weight * v96)
                    v97 = fsum(v97) * v84
                    v98 = v97
                else:
                    v98 = 0.0
                v99 = b if b > c or b != b else c
                v113 = a > v99
                v129 = v59 and v113
                if v129:
                    v100 = v99 - b
                    v104 = sqrt((v100 if v100 > 0.0 or v100 != v100 else 0.0) * (v99 + b))
                    v105 = v99 - 0.0
                    v109 = sqrt((v105 if v105 > 0.0 or v105 != v105 else 0.0) * (v99 + 0.0))
                    if v129:
                        v116 = (a - v99) * (a + v99)
                        if v113:
                            v120 = a - 0.0
                            v127 = v116 / (sqrt((v120 if v120 > 0.0 or v120 != v120 else 0.0) * (a + 0.0)) + v109)
                        else:
                            v127 = 0.0
                        v133 = log1p(((v116 / (sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * v18) + v104) if v113 else 0.0) + v127) / (v104 + v109))
                    else:
                        v133 = 0.0
                    v140 = b * b
                    v146 = 2.0 * b
                    v155 = []
                    for node, weight in RULE_0(v133 / 1.0):
                        v134 = node * v133
                        v139 = v104 * cosh(v134) + v109 * sinh(v134)
                        v143 = sqrt(v140 + v139 * v139)
                        v154 = v8 * (atan(v139 / b) + v146 / (v139 + v143)) * (v139 / v143) * (v143 * v143)
                        v155.append(weight * v154)
                    v155 = fsum(v155) * v133
                    v156 = v155
                else:
                    v156 = 0.0
                v161 = 2.0 * E_star * (v98 + v156)
            else:
                v161 = v36 - v56
            value = mu * v161
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, theta, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = a if a < b or a != a else b
            v8 = v7 - r
            v9 = v7 + r
            v15 = tan(theta)
            v19 = 2.0 * E_star * v15 / (3.141592653589793 * b)
            v26 = nextafter(b, inf) if r == b else r
            v27 = v26 < b
            v30 = a - b
            v34 = sqrt((v30 if v30 > 0.0 or v30 != v30 else 0.0) * (a + b))
            v45 = sqrt(abs(v26 - b) * (v26 + b))
            v48 = 2.0 * (0.0 if v27 else 1.0)
            v49 = 1.0 - v48
            v57 = v26 if v26 > b or v26 != v26 else b
            v70 = b * b
            v76 = 2.0 * b
            v86 = E_star / 3.141592653589793
            if r < a:
                if a > v57:
                    if v27:
                        v40 = v34
                    else:
                        v35 = a - v26
                        v40 = sqrt((v35 if v35 > 0.0 or v35 != v35 else 0.0) * (a + v26))
                    v47 = asinh(v40 / v45)
                    v54 = v48 - v49 * expm1(-2.0 * v47)
                    v56 = v54 if v54 > 0.0 else inf
                    v83 = []
                    for node, weight in RULE_0(v47 / 1.0):
                        v59 = node * v47
                        v69 = v34 * (exp(-v59) * (v48 - v49 * expm1(-2.0 * (v47 - v59))) / v56)
                        v73 = sqrt(v70 + v69 * v69)
                        v82 = v15 * (atan(v69 / b) + v76 / (v69 + v73)) * v69 / v73
                        v83.append(weight * v82)
                    v83 = fsum(v83) * v47
                    v84 = v83
                else:
                    v84 = 0.0
                v89 = (v19 * sqrt(v8 * v9) if r < v7 else 0.0) + v86 * v84
            else:
                v89 = 0.0
            v142 = r < c
            if v142:
                v90 = c if c < b or c != c else b
                if c > v57:
                    v98 = c - b
                    v102 = sqrt((v98 if v98 > 0.0 or v98 != v98 else 0.0) * (c + b))
                    if v27:
                        v108 = v102
                    else:
                        v103 = c - v26
                        v108 = sqrt((v103 if v103 > 0.0 or v103 != v103 else 0.0) * (c + v26))
                    v110 = asinh(v108 / v45)
                    v114 = v48 - v49 * expm1(-2.0 * v110)
                    v116 = v114 if v114 > 0.0 else inf
                    v140 = []
                    for node, weight in RULE_0(v110 / 1.0):
                        v118 = node * v110
                        v128 = v102 * (exp(-v118) * (v48 - v49 * expm1(-2.0 * (v110 - v118))) / v116)
                        v131 = sqrt(v70 + v128 * v128)
                        v139 = v15 * (atan(v128 / b) + v76 / (v128 + v131)) * v128 / v131
                        v140.append(weight * v139)
                    v140 = fsum(v140) * v110
                    v141 = v140
                else:
                    v141 = 0.0
                v145 = (v19 * sqrt((v90 - r) * (v90 + r)) if r < v90 else 0.0) + v86 * v141
            else:
                v145 = 0.0
            v149 = v142 and v145 >= 0.25 * v89
            if v149:
                v159 = v7 > c
                v169 = v149 and v159
                if v169:
                    v150 = c - r
                    v154 = sqrt((v150 if v150 > 0.0 or v150 != v150 else 0.0) * (c + r))
                    if v169:
                        v155 = v7 - c
                        v170 = log1p((v155 + (v155 * (v7 + c) / (sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * v9) + v154) if v159 else 0.0)) / (c + v154))
                    else:
                        v170 = 0.0
                    v178 = 2.0 * v15 / b
                    v182 = []
                    for node, weight in RULE_0(v170 / 1.0):
                        v171 = node * v170
                        v176 = c * cosh(v171) + v154 * sinh(v171)
                        v181 = v178 * v176 * pow(v176, 0.0)
                        v182.append(weight * v181)
                    v182 = fsum(v182) * v170
                    v183 = v182
                else:
                    v183 = 0.0
                v184 = b if b > c or b != b else c
                v195 = a > v184
                v211 = v149 and v195
                if v211:
                    v185 = v184 - b
                    v189 = sqrt((v185 if v185 > 0.0 or v185 != v185 else 0.0) * (v184 + b))
                    v190 = v184 - r
                    v194 = sqrt((v190 if v190 > 0.0 or v190 != v190 else 0.0) * (v184 + r))
                    if v211:
                        v198 = (a - v184) * (a + v184)
                        if v195:
                            v202 = a - r
                            v209 = v198 / (sqrt((v202 if v202 > 0.0 or v202 != v202 else 0.0) * (a + r)) + v194)
                        else:
                            v209 = 0.0
                        v215 = log1p(((v198 / (v34 + v189) if v195 else 0.0) + v209) / (v189 + v194))
                    else:
                        v215 = 0.0
                    v235 = []
                    for node, weight in RULE_0(v215 / 1.0):
                        v216 = node * v215
                        v221 = v189 * cosh(v216) + v194 * sinh(v216)
                        v224 = sqrt(v70 + v221 * v221)
                        v234 = v15 * (atan(v221 / b) + v76 / (v221 + v224)) * (v221 / v224) * pow(v224, 0.0)
                        v235.append(weight * v234)
                    v235 = fsum(v235) * v215
                    v236 = v235
                else:
                    v236 = 0.0
                v240 = v86 * (v183 + v236)
            else:
                v240 = v89 - v145
            value = mu * v240
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, theta, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'theta', 'b', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 3, 1, (), False),
        ('a', 'theta', 'b', 'E_star', 'G_star', 'mu'): (('a', 'theta', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 5, 1, (), False),
    },
}
