"""Programs of axicontact.tangential.rounded_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, cosh, exp, expm1, fsum, inf, log1p, nan, nextafter, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import rounded_punch as bodies

C0 = np.array(0.42)
C1 = np.array(0.0005288491342179178)
C2 = np.array(0.038096760299703034)
C3 = np.array(0.4065213849117787)
C4 = np.array(1.438682033198726)
C5 = np.array(1.9979042349620892)
C6 = np.array(0.9428090415820634)
C7 = np.array(0.006421883194715949)
C8 = np.array(0.15001504718401248)
C9 = np.array(0.9450913324352289)
C10 = np.array(2.37401087025821)
C11 = np.array(2.569097449054519)
C12 = np.array(1.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, R, b, E_star, G_star, mu):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v10 = a - b
            v11 = v10 / b
            if v11 < 0.42:
                v57 = v11 * sqrt(v11) * ((((((0.0005288491342179178 * v11 + 0.038096760299703034) * v11 + 0.4065213849117787) * v11 + 1.438682033198726) * v11 + 1.9979042349620892) * v11 + 0.9428090415820634) / (((((0.006421883194715949 * v11 + 0.15001504718401248) * v11 + 0.9450913324352289) * v11 + 2.37401087025821) * v11 + 2.569097449054519) * v11 + 1.0))
            else:
                v17 = sqrt(v10 * (a + b)) / b
                v57 = v17 - atan(v17)
            value = mu * (E_star / G_star) * (b / R * a * v57)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, b, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v8 = b / R
    return (b, v7, v8)


def block_full_slip_displacement_a(out, a, b, v7, v8, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.multiply(v8, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, b, t0)
    np.divide(t0, b, t1)
    np.less(t1, C0, m0)
    some57 = np.count_nonzero(m0)
    if some57:
        np.minimum(t1, f0, out=t2)
        np.sqrt(t2, t3)
        np.multiply(t2, t3, t3)
        np.multiply(C1, t2, t4)
        np.add(t4, C2, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C3, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C4, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C5, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C6, t4)
        np.multiply(C7, t2, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t2, t2)
        np.add(t2, C12, t2)
        np.divide(t4, t2, t2)
        np.multiply(t3, t2, t2)
    if some57 != size:
        other57 = t3 if some57 else t2
        np.add(a, b, other57)
        np.multiply(t0, other57, other57)
        np.sqrt(other57, other57)
        np.divide(other57, b, other57)
        np.arctan(other57, t4)
        np.subtract(other57, t4, other57)
        if some57:
            np.copyto(t2, other57, where=~m0)
    np.multiply(out, t2, t2)
    np.multiply(v7, t2, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, b, E_star, G_star, mu, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.divide(b, R, t0)
    np.multiply(t0, a, t0)
    np.subtract(a, b, t1)
    np.divide(t1, b, t2)
    np.less(t2, C0, m0)
    some57 = np.count_nonzero(m0)
    if some57:
        np.minimum(t2, f0, out=t3)
        np.sqrt(t3, t4)
        np.multiply(t3, t4, t4)
        np.multiply(C1, t3, t5)
        np.add(t5, C2, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C3, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C6, t5)
        np.multiply(C7, t3, t6)
        np.add(t6, C8, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C9, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C10, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t3, t3)
        np.add(t3, C12, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
    if some57 != size:
        other57 = t4 if some57 else t3
        np.add(a, b, other57)
        np.multiply(t1, other57, other57)
        np.sqrt(other57, other57)
        np.divide(other57, b, other57)
        np.arctan(other57, t5)
        np.subtract(other57, t5, other57)
        if some57:
            np.copyto(t3, other57, where=~m0)
    np.multiply(t0, t3, t3)
    np.multiply(out, t3, out)


def stick_radius(F_x, a, R, b, E_star, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            value = bodies._stick_radius(F_x, a, R, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, b, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v7 = b / R
            v9 = a - b
            v10 = v9 / b
            v13 = a + b
            if v10 < 0.42:
                v56 = v10 * sqrt(v10) * ((((((0.0005288491342179178 * v10 + 0.038096760299703034) * v10 + 0.4065213849117787) * v10 + 1.438682033198726) * v10 + 1.9979042349620892) * v10 + 0.9428090415820634) / (((((0.006421883194715949 * v10 + 0.15001504718401248) * v10 + 0.9450913324352289) * v10 + 2.37401087025821) * v10 + 2.569097449054519) * v10 + 1.0))
            else:
                v16 = sqrt(v9 * v13) / b
                v56 = v16 - atan(v16)
            v57 = v7 * a * v56
            v59 = c - b
            v60 = v59 / b
            if v60 < 0.42:
                v93 = v60 * sqrt(v60) * ((((((0.0005288491342179178 * v60 + 0.038096760299703034) * v60 + 0.4065213849117787) * v60 + 1.438682033198726) * v60 + 1.9979042349620892) * v60 + 0.9428090415820634) / (((((0.006421883194715949 * v60 + 0.15001504718401248) * v60 + 0.9450913324352289) * v60 + 2.37401087025821) * v60 + 2.569097449054519) * v60 + 1.0))
            else:
                v65 = sqrt(v59 * (c + b)) / b
                v93 = v65 - atan(v65)
            v94 = v7 * c * v93
            v97 = v94 >= 0.25 * v57
            if v97:
                v98 = b if b > c or b != b else c
                v113 = a > v98
                v129 = v97 and v113
                if v129:
                    v99 = v98 - b
                    v104 = sqrt((v99 if v99 > 0.0 or v99 != v99 else 0.0) * (v98 + b))
                    v105 = v98 - 0.0
                    v109 = sqrt((v105 if v105 > 0.0 or v105 != v105 else 0.0) * (v98 + 0.0))
                    if v129:
                        v116 = (a - v98) * (a + v98)
                        if v113:
                            v120 = a - 0.0
                            v127 = v116 / (sqrt((v120 if v120 > 0.0 or v120 != v120 else 0.0) * (a + 0.0)) + v109)
                        else:
                            v127 = 0.0
                        v133 = log1p(((v116 / (sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * v13) + v104) if v113 else 0.0) + v127) / (v104 + v109))
                    else:
                        v133 = 0.0
                    v140 = b * b
                    v154 = []
                    for node, weight in RULE_0(v133 / 1.0):
                        v134 = node * v133
                        v139 = v104 * cosh(v134) + v109 * sinh(v134)
                        v143 = sqrt(v140 + v139 * v139)
                        v153 = (2.0 * v139 / R - v7 * atan2(v139, b)) * (v139 / v143) * pow(v143, 1.0)
                        v154.append(weight * v153)
                    v154 = fsum(v154) * v133
                    v155 = v154
                else:
                    v155 = 0.0
                v159 = v155
            else:
                v159 = v57 - v94
            value = mu * (E_star / G_star) * v159
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R, b, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v6 = a - b
            v7 = a + b
            v8 = v6 * v7
            v9 = sqrt(v8)
            v10 = E_star / R
            v14 = v6 / b
            if v14 < 0.42:
                v57 = v14 * sqrt(v14) * ((((((0.0005288491342179178 * v14 + 0.038096760299703034) * v14 + 0.4065213849117787) * v14 + 1.438682033198726) * v14 + 1.9979042349620892) * v14 + 0.9428090415820634) / (((((0.006421883194715949 * v14 + 0.15001504718401248) * v14 + 0.9450913324352289) * v14 + 2.37401087025821) * v14 + 2.569097449054519) * v14 + 1.0))
            else:
                v17 = v9 / b
                v57 = v17 - atan(v17)
            v63 = v10 * (b * (a * a) * v57 + v8 * v9 / 3.0)
            v64 = c - b
            v66 = v64 * (c + b)
            v67 = sqrt(v66)
            v70 = v64 / b
            if v70 < 0.42:
                v100 = v70 * sqrt(v70) * ((((((0.0005288491342179178 * v70 + 0.038096760299703034) * v70 + 0.4065213849117787) * v70 + 1.438682033198726) * v70 + 1.9979042349620892) * v70 + 0.9428090415820634) / (((((0.006421883194715949 * v70 + 0.15001504718401248) * v70 + 0.9450913324352289) * v70 + 2.37401087025821) * v70 + 2.569097449054519) * v70 + 1.0))
            else:
                v72 = v67 / b
                v100 = v72 - atan(v72)
            v105 = v10 * (b * (c * c) * v100 + v66 * v67 / 3.0)
            v108 = v105 >= 0.25 * v63
            if v108:
                v110 = b if b > c or b != b else c
                v125 = a > v110
                v141 = v108 and v125
                if v141:
                    v111 = v110 - b
                    v116 = sqrt((v111 if v111 > 0.0 or v111 != v111 else 0.0) * (v110 + b))
                    v117 = v110 - 0.0
                    v121 = sqrt((v117 if v117 > 0.0 or v117 != v117 else 0.0) * (v110 + 0.0))
                    if v141:
                        v128 = (a - v110) * (a + v110)
                        if v125:
                            v132 = a - 0.0
                            v139 = v128 / (sqrt((v132 if v132 > 0.0 or v132 != v132 else 0.0) * (a + 0.0)) + v121)
                        else:
                            v139 = 0.0
                        v145 = log1p(((v128 / (sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v7) + v116) if v125 else 0.0) + v139) / (v116 + v121))
                    else:
                        v145 = 0.0
                    v152 = b * b
                    v159 = b / R
                    v166 = []
                    for node, weight in RULE_0(v145 / 1.0):
                        v146 = node * v145
                        v151 = v116 * cosh(v146) + v121 * sinh(v146)
                        v155 = sqrt(v152 + v151 * v151)
                        v165 = (2.0 * v151 / R - v159 * atan2(v151, b)) * (v151 / v155) * (v155 * v155)
                        v166.append(weight * v165)
                    v166 = fsum(v166) * v145
                    v167 = v166
                else:
                    v167 = 0.0
                v170 = 2.0 * E_star * v167
            else:
                v170 = v63 - v105
            value = mu * v170
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            v10 = nextafter(b, inf) if r == b else r
            v11 = v10 < b
            v15 = a - b
            v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (a + b))
            v30 = sqrt(abs(v10 - b) * (v10 + b))
            v34 = 2.0 * (0.0 if v11 else 1.0)
            v35 = 1.0 - v34
            v43 = v10 if v10 > b or v10 != v10 else b
            v56 = b * b
            v63 = b / R
            v72 = E_star / 3.141592653589793
            if a >= b:
                if r < a:
                    if a > v43:
                        if v11:
                            v25 = v19
                        else:
                            v20 = a - v10
                            v25 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (a + v10))
                        v32 = asinh(v25 / v30)
                        v40 = v34 - v35 * expm1(-2.0 * v32)
                        v42 = v40 if v40 > 0.0 else inf
                        v68 = []
                        for node, weight in RULE_0(v32 / 1.0):
                            v45 = node * v32
                            v55 = v19 * (exp(-v45) * (v34 - v35 * expm1(-2.0 * (v32 - v45))) / v42)
                            v67 = (2.0 * v55 / R - v63 * atan2(v55, b)) * v55 / sqrt(v56 + v55 * v55)
                            v68.append(weight * v67)
                        v68 = fsum(v68) * v32
                        v69 = v68
                    else:
                        v69 = 0.0
                    v74 = v72 * v69
                else:
                    v74 = 0.0
                v77 = v74
            else:
                v77 = nan
            v121 = r < c
            if c >= b:
                if v121:
                    if c > v43:
                        v78 = c - b
                        v82 = sqrt((v78 if v78 > 0.0 or v78 != v78 else 0.0) * (c + b))
                        if v11:
                            v88 = v82
                        else:
                            v83 = c - v10
                            v88 = sqrt((v83 if v83 > 0.0 or v83 != v83 else 0.0) * (c + v10))
                        v90 = asinh(v88 / v30)
                        v94 = v34 - v35 * expm1(-2.0 * v90)
                        v96 = v94 if v94 > 0.0 else inf
                        v119 = []
                        for node, weight in RULE_0(v90 / 1.0):
                            v98 = node * v90
                            v108 = v82 * (exp(-v98) * (v34 - v35 * expm1(-2.0 * (v90 - v98))) / v96)
                            v118 = (2.0 * v108 / R - v63 * atan2(v108, b)) * v108 / sqrt(v56 + v108 * v108)
                            v119.append(weight * v118)
                        v119 = fsum(v119) * v90
                        v120 = v119
                    else:
                        v120 = 0.0
                    v123 = v72 * v120
                else:
                    v123 = 0.0
                v125 = v123
            else:
                v125 = nan
            v129 = v121 and v125 >= 0.25 * v77
            if v129:
                v130 = b if b > c or b != b else c
                v141 = a > v130
                v157 = v129 and v141
                if v157:
                    v131 = v130 - b
                    v135 = sqrt((v131 if v131 > 0.0 or v131 != v131 else 0.0) * (v130 + b))
                    v136 = v130 - r
                    v140 = sqrt((v136 if v136 > 0.0 or v136 != v136 else 0.0) * (v130 + r))
                    if v157:
                        v144 = (a - v130) * (a + v130)
                        if v141:
                            v148 = a - r
                            v155 = v144 / (sqrt((v148 if v148 > 0.0 or v148 != v148 else 0.0) * (a + r)) + v140)
                        else:
                            v155 = 0.0
                        v161 = log1p(((v144 / (v19 + v135) if v141 else 0.0) + v155) / (v135 + v140))
                    else:
                        v161 = 0.0
                    v180 = []
                    for node, weight in RULE_0(v161 / 1.0):
                        v162 = node * v161
                        v167 = v135 * cosh(v162) + v140 * sinh(v162)
                        v170 = sqrt(v56 + v167 * v167)
                        v179 = (2.0 * v167 / R - v63 * atan2(v167, b)) * (v167 / v170) * pow(v170, 0.0)
                        v180.append(weight * v179)
                    v180 = fsum(v180) * v161
                    v181 = v180
                else:
                    v181 = 0.0
                v184 = v72 * v181
            else:
                v184 = v77 - v125
            value = mu * v184
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'b', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 6, 1, (0.42,), False),
        ('a', 'R', 'b', 'E_star', 'G_star', 'mu'): (('a', 'R', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 7, 1, (0.42,), False),
    },
}
