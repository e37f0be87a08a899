"""Programs of axicontact.tangential.rounded_curved_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, cosh, exp, expm1, fsum, inf, log1p, nextafter, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import rounded_curved_punch as bodies

C0 = np.array(2.0)
C1 = np.array(0.42)
C2 = np.array(0.0005288491342179178)
C3 = np.array(0.038096760299703034)
C4 = np.array(0.4065213849117787)
C5 = np.array(1.438682033198726)
C6 = np.array(1.9979042349620892)
C7 = np.array(0.9428090415820634)
C8 = np.array(0.006421883194715949)
C9 = np.array(0.15001504718401248)
C10 = np.array(0.9450913324352289)
C11 = np.array(2.37401087025821)
C12 = np.array(2.569097449054519)
C13 = np.array(1.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, R1, R2, b, E_star, G_star, mu):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            if a < b:
                v66 = a * a / R1
            else:
                v14 = a - b
                v15 = v14 / b
                if v15 < 0.42:
                    v61 = v15 * sqrt(v15) * ((((((0.0005288491342179178 * v15 + 0.038096760299703034) * v15 + 0.4065213849117787) * v15 + 1.438682033198726) * v15 + 1.9979042349620892) * v15 + 0.9428090415820634) / (((((0.006421883194715949 * v15 + 0.15001504718401248) * v15 + 0.9450913324352289) * v15 + 2.37401087025821) * v15 + 2.569097449054519) * v15 + 1.0))
                else:
                    v21 = sqrt(v14 * (a + b)) / b
                    v61 = v21 - atan(v21)
                v66 = a * (a / R1 + b / R2 * v61)
            value = mu * (E_star / G_star) * v66
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R1, R2, b, E_star, G_star, mu):
    v7 = E_star / G_star
    v8 = mu * v7
    v13 = b / R2
    return (R1, b, v8, v13)


def block_full_slip_displacement_a(out, a, R1, b, v8, v13, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some66 = np.count_nonzero(m0)
    if some66:
        np.square(a, out)
        np.divide(out, R1, out)
    if some66 != size:
        other66 = t0 if some66 else out
        np.divide(a, R1, other66)
        np.subtract(a, b, t1)
        np.divide(t1, b, t2)
        np.less(t2, C1, m1)
        some61 = np.count_nonzero(m1)
        if some61:
            np.minimum(t2, f0, out=t3)
            np.sqrt(t3, t4)
            np.multiply(t3, t4, t4)
            np.multiply(C2, t3, t5)
            np.add(t5, C3, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C4, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C5, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C6, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C7, t5)
            np.multiply(C8, t3, t6)
            np.add(t6, C9, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C10, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C11, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C12, t6)
            np.multiply(t6, t3, t3)
            np.add(t3, C13, t3)
            np.divide(t5, t3, t3)
            np.multiply(t4, t3, t3)
        if some61 != size:
            other61 = t4 if some61 else t3
            np.add(a, b, other61)
            np.multiply(t1, other61, other61)
            np.sqrt(other61, other61)
            np.divide(other61, b, other61)
            np.arctan(other61, t5)
            np.subtract(other61, t5, other61)
            if some61:
                np.copyto(t3, other61, where=~m1)
        np.multiply(v13, t3, t3)
        np.add(other66, t3, t3)
        np.multiply(a, t3, other66)
        if some66:
            np.copyto(out, other66, where=~m0)
    np.multiply(v8, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R1, R2, b, E_star, G_star, mu, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1, f0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.less(a, b, m0)
    some66 = np.count_nonzero(m0)
    if some66:
        np.square(a, t0)
        np.divide(t0, R1, t0)
    if some66 != size:
        other66 = t1 if some66 else t0
        np.divide(a, R1, other66)
        np.divide(b, R2, t2)
        np.subtract(a, b, t3)
        np.divide(t3, b, t4)
        np.less(t4, C1, m1)
        some61 = np.count_nonzero(m1)
        if some61:
            np.minimum(t4, f0, out=t5)
            np.sqrt(t5, t6)
            np.multiply(t5, t6, t6)
            np.multiply(C2, t5, t7)
            np.add(t7, C3, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C4, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C5, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C6, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C7, t7)
            np.multiply(C8, t5, t8)
            np.add(t8, C9, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C10, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C11, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C12, t8)
            np.multiply(t8, t5, t5)
            np.add(t5, C13, t5)
            np.divide(t7, t5, t5)
            np.multiply(t6, t5, t5)
        if some61 != size:
            other61 = t6 if some61 else t5
            np.add(a, b, other61)
            np.multiply(t3, other61, other61)
            np.sqrt(other61, other61)
            np.divide(other61, b, other61)
            np.arctan(other61, t7)
            np.subtract(other61, t7, other61)
            if some61:
                np.copyto(t5, other61, where=~m1)
        np.multiply(t2, t5, t5)
        np.add(other66, t5, t5)
        np.multiply(a, t5, other66)
        if some66:
            np.copyto(t0, other66, where=~m0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, R1, R2, b, E_star, mu):
    if F_x.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, R1, R2, b, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R1, R2, b, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R1, R2, b, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v12 = b / R2
            v13 = a - b
            v17 = a + b
            if a < b:
                v65 = a * a / R1
            else:
                v14 = v13 / b
                if v14 < 0.42:
                    v60 = v14 * sqrt(v14) * ((((((0.0005288491342179178 * v14 + 0.038096760299703034) * v14 + 0.4065213849117787) * v14 + 1.438682033198726) * v14 + 1.9979042349620892) * v14 + 0.9428090415820634) / (((((0.006421883194715949 * v14 + 0.15001504718401248) * v14 + 0.9450913324352289) * v14 + 2.37401087025821) * v14 + 2.569097449054519) * v14 + 1.0))
                else:
                    v20 = sqrt(v13 * v17) / b
                    v60 = v20 - atan(v20)
                v65 = a * (a / R1 + v12 * v60)
            if c < b:
                v108 = c * c / R1
            else:
                v69 = c - b
                v70 = v69 / b
                if v70 < 0.42:
                    v103 = v70 * sqrt(v70) * ((((((0.0005288491342179178 * v70 + 0.038096760299703034) * v70 + 0.4065213849117787) * v70 + 1.438682033198726) * v70 + 1.9979042349620892) * v70 + 0.9428090415820634) / (((((0.006421883194715949 * v70 + 0.15001504718401248) * v70 + 0.9450913324352289) * v70 + 2.37401087025821) * v70 + 2.569097449054519) * v70 + 1.0))
                else:
                    v75 = sqrt(v69 * (c + b)) / b
                    v103 = v75 - atan(v75)
                v108 = c * (c / R1 + v12 * v103)
            v111 = v108 >= 0.25 * v65
            if v111:
                v112 = a if a < b or a != a else b
                v125 = v112 > c
                v135 = v111 and v125
                if v135:
                    v114 = c - 0.0
                    v118 = sqrt((v114 if v114 > 0.0 or v114 != v114 else 0.0) * (c + 0.0))
                    if v135:
                        v119 = v112 - c
                        if v125:
                            v120 = v112 - 0.0
                            v130 = v119 * (v112 + c) / (sqrt((v120 if v120 > 0.0 or v120 != v120 else 0.0) * (v112 + 0.0)) + v118)
                        else:
                            v130 = 0.0
                        v136 = log1p((v119 + v130) / (c + v118))
                    else:
                        v136 = 0.0
                    v147 = []
                    for node, weight in RULE_0(v136 / 1.0):
                        v137 = node * v136
                        v142 = c * cosh(v137) + v118 * sinh(v137)
                        v146 = 2.0 * v142 / R1 * pow(v142, 1.0)
                        v147.append(weight * v146)
                    v147 = fsum(v147) * v136
                    v148 = v147
                else:
                    v148 = 0.0
                v149 = b if b > c or b != b else c
                v163 = a > v149
                v179 = v111 and v163
                if v179:
                    v150 = v149 - b
                    v154 = sqrt((v150 if v150 > 0.0 or v150 != v150 else 0.0) * (v149 + b))
                    v155 = v149 - 0.0
                    v159 = sqrt((v155 if v155 > 0.0 or v155 != v155 else 0.0) * (v149 + 0.0))
                    if v179:
                        v166 = (a - v149) * (a + v149)
                        if v163:
                            v170 = a - 0.0
                            v177 = v166 / (sqrt((v170 if v170 > 0.0 or v170 != v170 else 0.0) * (a + 0.0)) + v159)
                        else:
                            v177 = 0.0
                        v183 = log1p(((v166 / (sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v17) + v154) if v163 else 0.0) + v177) / (v154 + v159))
                    else:
                        v183 = 0.0
                    v190 = b * b
                    v206 = []
                    for node, weight in RULE_0(v183 / 1.0):
                        v184 = node * v183
                        v189 = v154 * cosh(v184) + v159 * sinh(v184)
                        v193 = sqrt(v190 + v189 * v189)
                        v205 = (2.0 * v193 / R1 + 2.0 * v189 / R2 - v12 * atan2(v189, b)) * (v189 / v193) * pow(v193, 1.0)
                        v206.append(weight * v205)
                    v206 = fsum(v206) * v183
                    v207 = v206
                else:
                    v207 = 0.0
                v212 = v148 + v207
            else:
                v212 = v65 - v108
            value = mu * (E_star / G_star) * v212
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R1, R2, b, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R1, R2, b, E_star, mu):
    if a.__class__ is c.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v10 = 3.0 * R1
            v11 = 4.0 * E_star / v10
            v13 = a * a
            v14 = a * v13
            v16 = a - b
            v17 = a + b
            v22 = b / R2
            v71 = 3.0 * R2
            if a < b:
                v76 = v11 * v14
            else:
                v18 = v16 * v17
                v19 = sqrt(v18)
                v24 = v16 / b
                if v24 < 0.42:
                    v67 = v24 * sqrt(v24) * ((((((0.0005288491342179178 * v24 + 0.038096760299703034) * v24 + 0.4065213849117787) * v24 + 1.438682033198726) * v24 + 1.9979042349620892) * v24 + 0.9428090415820634) / (((((0.006421883194715949 * v24 + 0.15001504718401248) * v24 + 0.9450913324352289) * v24 + 2.37401087025821) * v24 + 2.569097449054519) * v24 + 1.0))
                else:
                    v27 = v19 / b
                    v67 = v27 - atan(v27)
                v76 = E_star * (4.0 * v14 / v10 + v22 * v13 * v67 + v18 * v19 / v71)
            v77 = c * c
            v78 = c * v77
            if c < b:
                v125 = v11 * v78
            else:
                v80 = c - b
                v82 = v80 * (c + b)
                v83 = sqrt(v82)
                v87 = v80 / b
                if v87 < 0.42:
                    v117 = v87 * sqrt(v87) * ((((((0.0005288491342179178 * v87 + 0.038096760299703034) * v87 + 0.4065213849117787) * v87 + 1.438682033198726) * v87 + 1.9979042349620892) * v87 + 0.9428090415820634) / (((((0.006421883194715949 * v87 + 0.15001504718401248) * v87 + 0.9450913324352289) * v87 + 2.37401087025821) * v87 + 2.569097449054519) * v87 + 1.0))
                else:
                    v89 = v83 / b
                    v117 = v89 - atan(v89)
                v125 = E_star * (4.0 * v78 / v10 + v22 * v77 * v117 + v82 * v83 / v71)
            v128 = v125 >= 0.25 * v76
            if v128:
                v129 = a if a < b or a != a else b
                v142 = v129 > c
                v152 = v128 and v142
                if v152:
                    v131 = c - 0.0
                    v135 = sqrt((v131 if v131 > 0.0 or v131 != v131 else 0.0) * (c + 0.0))
                    if v152:
                        v136 = v129 - c
                        if v142:
                            v137 = v129 - 0.0
                            v147 = v136 * (v129 + c) / (sqrt((v137 if v137 > 0.0 or v137 != v137 else 0.0) * (v129 + 0.0)) + v135)
                        else:
                            v147 = 0.0
                        v153 = log1p((v136 + v147) / (c + v135))
                    else:
                        v153 = 0.0
                    v164 = []
                    for node, weight in RULE_0(v153 / 1.0):
                        v154 = node * v153
                        v159 = c * cosh(v154) + v135 * sinh(v154)
                        v163 = 2.0 * v159 / R1 * (v159 * v159)
                        v164.append(weight * v163)
                    v164 = fsum(v164) * v153
                    v165 = v164
                else:
                    v165 = 0.0
                v166 = b if b > c or b != b else c
                v180 = a > v166
                v196 = v128 and v180
                if v196:
                    v167 = v166 - b
                    v171 = sqrt((v167 if v167 > 0.0 or v167 != v167 else 0.0) * (v166 + b))
                    v172 = v166 - 0.0
                    v176 = sqrt((v172 if v172 > 0.0 or v172 != v172 else 0.0) * (v166 + 0.0))
                    if v196:
                        v183 = (a - v166) * (a + v166)
                        if v180:
                            v187 = a - 0.0
                            v194 = v183 / (sqrt((v187 if v187 > 0.0 or v187 != v187 else 0.0) * (a + 0.0)) + v176)
                        else:
                            v194 = 0.0
                        v200 = log1p(((v183 / (sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * v17) + v171) if v180 else 0.0) + v194) / (v171 + v176))
                    else:
                        v200 = 0.0
                    v207 = b * b
                    v223 = []
                    for node, weight in RULE_0(v200 / 1.0):
                        v201 = node * v200
                        v206 = v171 * cosh(v201) + v176 * sinh(v201)
                        v210 = sqrt(v207 + v206 * v206)
                        v222 = (2.0 * v210 / R1 + 2.0 * v206 / R2 - v22 * atan2(v206, b)) * (v206 / v210) * (v210 * v210)
                        v223.append(weight * v222)
                    v223 = fsum(v223) * v200
                    v224 = v223
                else:
                    v224 = 0.0
                v229 = 2.0 * E_star * (v165 + v224)
            else:
                v229 = v76 - v125
            value = mu * v229
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R1, R2, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R1, R2, b, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v8 = a if a < b or a != a else b
            v9 = v8 - r
            v10 = v8 + r
            v18 = 2.0 * E_star / (3.141592653589793 * R1)
            v25 = nextafter(b, inf) if r == b else r
            v26 = v25 < b
            v29 = a - b
            v33 = sqrt((v29 if v29 > 0.0 or v29 != v29 else 0.0) * (a + b))
            v44 = sqrt(abs(v25 - b) * (v25 + b))
            v47 = 2.0 * (0.0 if v26 else 1.0)
            v48 = 1.0 - v47
            v56 = v25 if v25 > b or v25 != v25 else b
            v69 = b * b
            v79 = b / R2
            v87 = E_star / 3.141592653589793
            if r < a:
                if a > v56:
                    if v26:
                        v39 = v33
                    else:
                        v34 = a - v25
                        v39 = sqrt((v34 if v34 > 0.0 or v34 != v34 else 0.0) * (a + v25))
                    v46 = asinh(v39 / v44)
                    v53 = v47 - v48 * expm1(-2.0 * v46)
                    v55 = v53 if v53 > 0.0 else inf
                    v84 = []
                    for node, weight in RULE_0(v46 / 1.0):
                        v58 = node * v46
                        v68 = v33 * (exp(-v58) * (v47 - v48 * expm1(-2.0 * (v46 - v58))) / v55)
                        v72 = sqrt(v69 + v68 * v68)
                        v83 = (2.0 * v72 / R1 + 2.0 * v68 / R2 - v79 * atan2(v68, b)) * v68 / v72
                        v84.append(weight * v83)
                    v84 = fsum(v84) * v46
                    v85 = v84
                else:
                    v85 = 0.0
                v90 = (v18 * sqrt(v9 * v10) if r < v8 else 0.0) + v87 * v85
            else:
                v90 = 0.0
            v145 = r < c
            if v145:
                v91 = c if c < b or c != c else b
                if c > v56:
                    v99 = c - b
                    v103 = sqrt((v99 if v99 > 0.0 or v99 != v99 else 0.0) * (c + b))
                    if v26:
                        v109 = v103
                    else:
                        v104 = c - v25
                        v109 = sqrt((v104 if v104 > 0.0 or v104 != v104 else 0.0) * (c + v25))
                    v111 = asinh(v109 / v44)
                    v115 = v47 - v48 * expm1(-2.0 * v111)
                    v117 = v115 if v115 > 0.0 else inf
                    v143 = []
                    for node, weight in RULE_0(v111 / 1.0):
                        v119 = node * v111
                        v129 = v103 * (exp(-v119) * (v47 - v48 * expm1(-2.0 * (v111 - v119))) / v117)
                        v132 = sqrt(v69 + v129 * v129)
                        v142 = (2.0 * v132 / R1 + 2.0 * v129 / R2 - v79 * atan2(v129, b)) * v129 / v132
                        v143.append(weight * v142)
                    v143 = fsum(v143) * v111
                    v144 = v143
                else:
                    v144 = 0.0
                v148 = (v18 * sqrt((v91 - r) * (v91 + r)) if r < v91 else 0.0) + v87 * v144
            else:
                v148 = 0.0
            v152 = v145 and v148 >= 0.25 * v90
            if v152:
                v162 = v8 > c
                v172 = v152 and v162
                if v172:
                    v153 = c - r
                    v157 = sqrt((v153 if v153 > 0.0 or v153 != v153 else 0.0) * (c + r))
                    if v172:
                        v158 = v8 - c
                        v173 = log1p((v158 + (v158 * (v8 + c) / (sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * v10) + v157) if v162 else 0.0)) / (c + v157))
                    else:
                        v173 = 0.0
                    v184 = []
                    for node, weight in RULE_0(v173 / 1.0):
                        v174 = node * v173
                        v179 = c * cosh(v174) + v157 * sinh(v174)
                        v183 = 2.0 * v179 / R1 * pow(v179, 0.0)
                        v184.append(weight * v183)
                    v184 = fsum(v184) * v173
                    v185 = v184
                else:
                    v185 = 0.0
                v186 = b if b > c or b != b else c
                v197 = a > v186
                v213 = v152 and v197
                if v213:
                    v187 = v186 - b
                    v191 = sqrt((v187 if v187 > 0.0 or v187 != v187 else 0.0) * (v186 + b))
                    v192 = v186 - r
                    v196 = sqrt((v192 if v192 > 0.0 or v192 != v192 else 0.0) * (v186 + r))
                    if v213:
                        v200 = (a - v186) * (a + v186)
                        if v197:
                            v204 = a - r
                            v211 = v200 / (sqrt((v204 if v204 > 0.0 or v204 != v204 else 0.0) * (a + r)) + v196)
                        else:
                            v211 = 0.0
                        v217 = log1p(((v200 / (v33 + v191) if v197 else 0.0) + v211) / (v191 + v196))
                    else:
                        v217 = 0.0
                    v239 = []
                    for node, weight in RULE_0(v217 / 1.0):
                        v218 = node * v217
                        v223 = v191 * cosh(v218) + v196 * sinh(v218)
                        v226 = sqrt(v69 + v223 * v223)
                        v238 = (2.0 * v226 / R1 + 2.0 * v223 / R2 - v79 * atan2(v223, b)) * (v223 / v226) * pow(v226, 0.0)
                        v239.append(weight * v238)
                    v239 = fsum(v239) * v217
                    v240 = v239
                else:
                    v240 = 0.0
                v244 = v87 * (v185 + v240)
            else:
                v244 = v90 - v148
            value = mu * v244
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R1, R2, b, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R1', 'R2', 'b', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 7, 2, (0.42,), False),
        ('a', 'R1', 'R2', 'b', 'E_star', 'G_star', 'mu'): (('a', 'R1', 'R2', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 9, 2, (0.42,), False),
    },
}
