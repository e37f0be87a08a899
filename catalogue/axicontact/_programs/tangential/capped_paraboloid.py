"""Programs of axicontact.tangential.capped_paraboloid."""

from __future__ import annotations

from math import asinh, cosh, exp, expm1, fsum, inf, log1p, nextafter, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import capped_paraboloid as bodies

C0 = np.array(2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, R1, R2, b, E_star, G_star, mu):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            return mu * (E_star / G_star) * (a * a / R1 if a < b else a * (a + (R1 - R2) / R2 * sqrt((a - b) * (a + b))) / R1)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R1, R2, b, E_star, G_star, mu):
    v7 = E_star / G_star
    v8 = mu * v7
    v16 = R1 - R2
    v17 = v16 / R2
    return (R1, b, v8, v17)


def block_full_slip_displacement_a(out, a, R1, b, v8, v17, t0, t1, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        np.square(a, out)
        np.divide(out, R1, out)
    if some23 != size:
        other23 = t0 if some23 else out
        np.subtract(a, b, other23)
        np.add(a, b, t1)
        np.multiply(other23, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(v17, t1, t1)
        np.add(a, t1, t1)
        np.multiply(a, t1, t1)
        np.divide(t1, R1, other23)
        if some23:
            np.copyto(out, other23, where=~m0)
    np.multiply(v8, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R1, R2, b, E_star, G_star, mu, t0, t1, t2, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.less(a, b, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.square(a, t0)
        np.divide(t0, R1, t0)
    if some23 != size:
        other23 = t1 if some23 else t0
        np.subtract(a, b, other23)
        np.add(a, b, t2)
        np.multiply(other23, t2, t2)
        np.sqrt(t2, t2)
        np.subtract(R1, R2, other23)
        np.divide(other23, R2, other23)
        np.multiply(other23, t2, t2)
        np.add(a, t2, t2)
        np.multiply(a, t2, t2)
        np.divide(t2, R1, other23)
        if some23:
            np.copyto(t0, other23, where=~m0)
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
            v11 = a - b
            v12 = a + b
            v15 = R1 - R2
            v16 = v15 / R2
            v22 = a * a / R1 if a < b else a * (a + v16 * sqrt(v11 * v12)) / R1
            v34 = c * c / R1 if c < b else c * (c + v16 * sqrt((c - b) * (c + b))) / R1
            v37 = v34 >= 0.25 * v22
            if v37:
                v38 = a if a < b or a != a else b
                v51 = v38 > c
                v61 = v37 and v51
                if v61:
                    v40 = c - 0.0
                    v44 = sqrt((v40 if v40 > 0.0 or v40 != v40 else 0.0) * (c + 0.0))
                    if v61:
                        v45 = v38 - c
                        if v51:
                            v46 = v38 - 0.0
                            v56 = v45 * (v38 + c) / (sqrt((v46 if v46 > 0.0 or v46 != v46 else 0.0) * (v38 + 0.0)) + v44)
                        else:
                            v56 = 0.0
                        v62 = log1p((v45 + v56) / (c + v44))
                    else:
                        v62 = 0.0
                    v74 = []
                    for node, weight in RULE_0(v62 / 1.0):
                        v64 = node * v62
                        v69 = c * cosh(v64) + v44 * sinh(v64)
                        v73 = 2.0 * v69 / R1 * pow(v69, 1.0)
                        v74.append(weight * v73)
                    v74 = fsum(v74) * v62
                    v75 = v74
                else:
                    v75 = 0.0
                v76 = b if b > c or b != b else c
                v90 = a > v76
                v106 = v37 and v90
                if v106:
                    v77 = v76 - b
                    v81 = sqrt((v77 if v77 > 0.0 or v77 != v77 else 0.0) * (v76 + b))
                    v82 = v76 - 0.0
                    v86 = sqrt((v82 if v82 > 0.0 or v82 != v82 else 0.0) * (v76 + 0.0))
                    if v106:
                        v93 = (a - v76) * (a + v76)
                        if v90:
                            v97 = a - 0.0
                            v104 = v93 / (sqrt((v97 if v97 > 0.0 or v97 != v97 else 0.0) * (a + 0.0)) + v86)
                        else:
                            v104 = 0.0
                        v110 = log1p(((v93 / (sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * v12) + v81) if v90 else 0.0) + v104) / (v81 + v86))
                    else:
                        v110 = 0.0
                    v117 = b * b
                    v124 = R1 * R2
                    v125 = 2.0 * v15 / v124
                    v129 = b * b * v15
                    v137 = []
                    for node, weight in RULE_0(v110 / 1.0):
                        v111 = node * v110
                        v116 = v81 * cosh(v111) + v86 * sinh(v111)
                        v120 = sqrt(v117 + v116 * v116)
                        v136 = (2.0 * v120 / R1 + v125 * v116 + v129 / (v124 * v116)) * (v116 / v120) * pow(v120, 1.0)
                        v137.append(weight * v136)
                    v137 = fsum(v137) * v110
                    v138 = v137
                else:
                    v138 = 0.0
                v143 = v75 + v138
            else:
                v143 = v22 - v34
            value = mu * (E_star / G_star) * v143
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
            v20 = 2.0 * E_star
            v21 = v20 / v10
            v23 = R1 - R2
            v24 = v23 / R2
            v26 = b * b
            v33 = v11 * v14 if a < b else v21 * (2.0 * v14 + v24 * (2.0 * v13 + v26) * sqrt(v16 * v17))
            v34 = c * c
            v35 = c * v34
            v49 = v11 * v35 if c < b else v21 * (2.0 * v35 + v24 * (2.0 * v34 + v26) * sqrt((c - b) * (c + b)))
            v52 = v49 >= 0.25 * v33
            if v52:
                v53 = a if a < b or a != a else b
                v66 = v53 > c
                v76 = v52 and v66
                if v76:
                    v55 = c - 0.0
                    v59 = sqrt((v55 if v55 > 0.0 or v55 != v55 else 0.0) * (c + 0.0))
                    if v76:
                        v60 = v53 - c
                        if v66:
                            v61 = v53 - 0.0
                            v71 = v60 * (v53 + c) / (sqrt((v61 if v61 > 0.0 or v61 != v61 else 0.0) * (v53 + 0.0)) + v59)
                        else:
                            v71 = 0.0
                        v77 = log1p((v60 + v71) / (c + v59))
                    else:
                        v77 = 0.0
                    v89 = []
                    for node, weight in RULE_0(v77 / 1.0):
                        v79 = node * v77
                        v84 = c * cosh(v79) + v59 * sinh(v79)
                        v88 = 2.0 * v84 / R1 * (v84 * v84)
                        v89.append(weight * v88)
                    v89 = fsum(v89) * v77
                    v90 = v89
                else:
                    v90 = 0.0
                v91 = b if b > c or b != b else c
                v105 = a > v91
                v121 = v52 and v105
                if v121:
                    v92 = v91 - b
                    v96 = sqrt((v92 if v92 > 0.0 or v92 != v92 else 0.0) * (v91 + b))
                    v97 = v91 - 0.0
                    v101 = sqrt((v97 if v97 > 0.0 or v97 != v97 else 0.0) * (v91 + 0.0))
                    if v121:
                        v108 = (a - v91) * (a + v91)
                        if v105:
                            v112 = a - 0.0
                            v119 = v108 / (sqrt((v112 if v112 > 0.0 or v112 != v112 else 0.0) * (a + 0.0)) + v101)
                        else:
                            v119 = 0.0
                        v125 = log1p(((v108 / (sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * v17) + v96) if v105 else 0.0) + v119) / (v96 + v101))
                    else:
                        v125 = 0.0
                    v132 = b * b
                    v139 = R1 * R2
                    v140 = 2.0 * v23 / v139
                    v143 = v26 * v23
                    v151 = []
                    for node, weight in RULE_0(v125 / 1.0):
                        v126 = node * v125
                        v131 = v96 * cosh(v126) + v101 * sinh(v126)
                        v135 = sqrt(v132 + v131 * v131)
                        v150 = (2.0 * v135 / R1 + v140 * v131 + v143 / (v139 * v131)) * (v131 / v135) * (v135 * v135)
                        v151.append(weight * v150)
                    v151 = fsum(v151) * v125
                    v152 = v151
                else:
                    v152 = 0.0
                v156 = v20 * (v90 + v152)
            else:
                v156 = v33 - v49
            value = mu * v156
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
            v22 = r == b
            v25 = nextafter(b, inf) if v22 else r
            v26 = v25 < b
            v29 = a - b
            v33 = sqrt((v29 if v29 > 0.0 or v29 != v29 else 0.0) * (a + b))
            v44 = sqrt(abs(v25 - b) * (v25 + b))
            v47 = 2.0 * (0.0 if v26 else 1.0)
            v48 = 1.0 - v47
            v56 = v25 if v25 > b or v25 != v25 else b
            v69 = b * b
            v75 = R1 - R2
            v77 = R1 * R2
            v78 = 2.0 * v75 / v77
            v82 = b * b * v75
            v92 = R1 > R2
            v94 = E_star / 3.141592653589793
            if r < a:
                if (v22 and a > b) and v92:
                    v97 = inf
                else:
                    if a > v56:
                        if v26:
                            v39 = v33
                        else:
                            v34 = a - v25
                            v39 = sqrt((v34 if v34 > 0.0 or v34 != v34 else 0.0) * (a + v25))
                        v46 = asinh(v39 / v44)
                        v53 = v47 - v48 * expm1(-2.0 * v46)
                        v55 = v53 if v53 > 0.0 else inf
                        v88 = []
                        for node, weight in RULE_0(v46 / 1.0):
                            v58 = node * v46
                            v68 = v33 * (exp(-v58) * (v47 - v48 * expm1(-2.0 * (v46 - v58))) / v55)
                            v72 = sqrt(v69 + v68 * v68)
                            v87 = (2.0 * v72 / R1 + v78 * v68 + v82 / (v77 * v68)) * v68 / v72
                            v88.append(weight * v87)
                        v88 = fsum(v88) * v46
                        v89 = v88
                    else:
                        v89 = 0.0
                    v97 = (v18 * sqrt(v9 * v10) if r < v8 else 0.0) + v94 * v89
                v99 = v97
            else:
                v99 = 0.0
            v159 = r < c
            if v159:
                if (v22 and c > b) and v92:
                    v158 = inf
                else:
                    v100 = c if c < b or c != c else b
                    if c > v56:
                        v108 = c - b
                        v112 = sqrt((v108 if v108 > 0.0 or v108 != v108 else 0.0) * (c + b))
                        if v26:
                            v118 = v112
                        else:
                            v113 = c - v25
                            v118 = sqrt((v113 if v113 > 0.0 or v113 != v113 else 0.0) * (c + v25))
                        v120 = asinh(v118 / v44)
                        v124 = v47 - v48 * expm1(-2.0 * v120)
                        v126 = v124 if v124 > 0.0 else inf
                        v151 = []
                        for node, weight in RULE_0(v120 / 1.0):
                            v128 = node * v120
                            v138 = v112 * (exp(-v128) * (v47 - v48 * expm1(-2.0 * (v120 - v128))) / v126)
                            v141 = sqrt(v69 + v138 * v138)
                            v150 = (2.0 * v141 / R1 + v78 * v138 + v82 / (v77 * v138)) * v138 / v141
                            v151.append(weight * v150)
                        v151 = fsum(v151) * v120
                        v152 = v151
                    else:
                        v152 = 0.0
                    v158 = (v18 * sqrt((v100 - r) * (v100 + r)) if r < v100 else 0.0) + v94 * v152
                v160 = v158
            else:
                v160 = 0.0
            v164 = v159 and v160 >= 0.25 * v99
            if v164:
                v174 = v8 > c
                v184 = v164 and v174
                if v184:
                    v165 = c - r
                    v169 = sqrt((v165 if v165 > 0.0 or v165 != v165 else 0.0) * (c + r))
                    if v184:
                        v170 = v8 - c
                        v185 = log1p((v170 + (v170 * (v8 + c) / (sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * v10) + v169) if v174 else 0.0)) / (c + v169))
                    else:
                        v185 = 0.0
                    v196 = []
                    for node, weight in RULE_0(v185 / 1.0):
                        v186 = node * v185
                        v191 = c * cosh(v186) + v169 * sinh(v186)
                        v195 = 2.0 * v191 / R1 * pow(v191, 0.0)
                        v196.append(weight * v195)
                    v196 = fsum(v196) * v185
                    v197 = v196
                else:
                    v197 = 0.0
                v198 = b if b > c or b != b else c
                v209 = a > v198
                v225 = v164 and v209
                if v225:
                    v199 = v198 - b
                    v203 = sqrt((v199 if v199 > 0.0 or v199 != v199 else 0.0) * (v198 + b))
                    v204 = v198 - r
                    v208 = sqrt((v204 if v204 > 0.0 or v204 != v204 else 0.0) * (v198 + r))
                    if v225:
                        v212 = (a - v198) * (a + v198)
                        if v209:
                            v216 = a - r
                            v223 = v212 / (sqrt((v216 if v216 > 0.0 or v216 != v216 else 0.0) * (a + r)) + v208)
                        else:
                            v223 = 0.0
                        v229 = log1p(((v212 / (v33 + v203) if v209 else 0.0) + v223) / (v203 + v208))
                    else:
                        v229 = 0.0
                    v250 = []
                    for node, weight in RULE_0(v229 / 1.0):
                        v230 = node * v229
                        v235 = v203 * cosh(v230) + v208 * sinh(v230)
                        v238 = sqrt(v69 + v235 * v235)
                        v249 = (2.0 * v238 / R1 + v78 * v235 + v82 / (v77 * v235)) * (v235 / v238) * pow(v238, 0.0)
                        v250.append(weight * v249)
                    v250 = fsum(v250) * v229
                    v251 = v250
                else:
                    v251 = 0.0
                v255 = v94 * (v197 + v251)
            else:
                v255 = v99 - v160
            value = mu * v255
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
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 2, 1, (), False),
        ('a', 'R1', 'R2', 'b', 'E_star', 'G_star', 'mu'): (('a', 'R1', 'R2', 'b', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 3, 1, (), False),
    },
}
