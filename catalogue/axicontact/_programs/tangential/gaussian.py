"""Programs of axicontact.tangential.gaussian."""

from __future__ import annotations

from math import cosh, fsum, inf, log1p, nan, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import gaussian as bodies

C0 = np.array(1.567077144036674e-13)
C1 = np.array(-3.840375691006307e-12)
C2 = np.array(3.8015754128174666e-11)
C3 = np.array(-1.8423006918213799e-10)
C4 = np.array(4.472469827763728e-10)
C5 = np.array(-1.1927516362741588e-09)
C6 = np.array(6.225892246861416e-09)
C7 = np.array(3.4413148480148793e-09)
C8 = np.array(-9.933344851449817e-08)
C9 = np.array(-5.127541706569233e-07)
C10 = np.array(1.8119768160503268e-06)
C11 = np.array(2.151585040783394e-05)
C12 = np.array(4.61098799999374e-06)
C13 = np.array(-0.000684089638073553)
C14 = np.array(-0.002257495580553435)
C15 = np.array(0.016931216930225715)
C16 = np.array(0.17777777777782838)
C17 = np.array(0.6666666666666656)
C18 = np.array(1.0)
C19 = np.array(np.nan)
C20 = np.array(1.5019752682686114)
C21 = np.array(2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))
RULE_1 = rule(((inf, 32),))


def full_slip_displacement(a, h, s, E_star, G_star, mu):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                v8 = a / s
                v14 = v8 * v8
                v52 = ((((((((((((1.567077144036674e-13 * v14 + -3.840375691006307e-12) * v14 + 3.8015754128174666e-11) * v14 + -1.8423006918213799e-10) * v14 + 4.472469827763728e-10) * v14 + -1.1927516362741588e-09) * v14 + 6.225892246861416e-09) * v14 + 3.4413148480148793e-09) * v14 + -9.933344851449817e-08) * v14 + -5.127541706569233e-07) * v14 + 1.8119768160503268e-06) * v14 + 2.151585040783394e-05) * v14 + 4.61098799999374e-06) * v14
                v74 = 2.0 * h * (v8 / ((((((v52 + -0.000684089638073553) * v14 + -0.002257495580553435) * v14 + 0.016931216930225715) * v14 + 0.17777777777782838) * v14 + 0.6666666666666656) * v14 + 1.0)) * v8
            else:
                v74 = nan
            value = mu * (E_star / G_star) * v74
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(h, s, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v10 = (1.5019752682686114) * s
    v13 = (2.0) * h
    return (s, v7, v10, v13)


def block_full_slip_displacement_a(out, a, s, v7, v10, v13, t0, t1, m0):
    size = out.size
    np.less_equal(a, v10, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some74 = np.count_nonzero(m0)
    if some74:
        np.divide(a, s, out)
        np.multiply(out, out, t0)
        np.multiply(C0, t0, t1)
        np.add(t1, C1, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C2, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C3, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C4, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C5, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C6, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C7, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C8, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C9, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C10, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C11, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C12, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C13, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C14, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C15, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C16, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C17, t1)
        np.multiply(t1, t0, t0)
        np.add(t0, C18, t0)
        np.divide(out, t0, t0)
        np.multiply(v13, t0, t0)
        np.multiply(t0, out, out)
    if some74 != size:
        np.copyto(out, C19, where=~m0)
    np.multiply(v7, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, h, s, E_star, G_star, mu, t0, t1, t2, t3, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(C20, s, t0)
    np.less_equal(a, t0, m0)
    some74 = np.count_nonzero(m0)
    if some74:
        np.divide(a, s, t0)
        np.multiply(C21, h, t1)
        np.multiply(t0, t0, t2)
        np.multiply(C0, t2, t3)
        np.add(t3, C1, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C2, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C3, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C4, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C5, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C8, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C9, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C11, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C12, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C13, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C14, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C17, t3)
        np.multiply(t3, t2, t2)
        np.add(t2, C18, t2)
        np.divide(t0, t2, t2)
        np.multiply(t1, t2, t2)
        np.multiply(t2, t0, t0)
    if some74 != size:
        np.copyto(t0, C19, where=~m0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, h, s, E_star, mu):
    if F_x.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, h, s, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, h, s, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, h, s, E_star, G_star, mu):
    if a.__class__ is c.__class__ is h.__class__ is s.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v9 = 1.5019752682686114 * s
            v12 = 2.0 * h
            if a <= v9:
                v7 = a / s
                v13 = v7 * v7
                v51 = ((((((((((((1.567077144036674e-13 * v13 + -3.840375691006307e-12) * v13 + 3.8015754128174666e-11) * v13 + -1.8423006918213799e-10) * v13 + 4.472469827763728e-10) * v13 + -1.1927516362741588e-09) * v13 + 6.225892246861416e-09) * v13 + 3.4413148480148793e-09) * v13 + -9.933344851449817e-08) * v13 + -5.127541706569233e-07) * v13 + 1.8119768160503268e-06) * v13 + 2.151585040783394e-05) * v13 + 4.61098799999374e-06) * v13
                v73 = v12 * (v7 / ((((((v51 + -0.000684089638073553) * v13 + -0.002257495580553435) * v13 + 0.016931216930225715) * v13 + 0.17777777777782838) * v13 + 0.6666666666666656) * v13 + 1.0)) * v7
            else:
                v73 = nan
            if c <= v9:
                v74 = c / s
                v76 = v74 * v74
                v101 = ((((((((((((1.567077144036674e-13 * v76 + -3.840375691006307e-12) * v76 + 3.8015754128174666e-11) * v76 + -1.8423006918213799e-10) * v76 + 4.472469827763728e-10) * v76 + -1.1927516362741588e-09) * v76 + 6.225892246861416e-09) * v76 + 3.4413148480148793e-09) * v76 + -9.933344851449817e-08) * v76 + -5.127541706569233e-07) * v76 + 1.8119768160503268e-06) * v76 + 2.151585040783394e-05) * v76 + 4.61098799999374e-06) * v76
                v116 = v12 * (v74 / ((((((v101 + -0.000684089638073553) * v76 + -0.002257495580553435) * v76 + 0.016931216930225715) * v76 + 0.17777777777782838) * v76 + 0.6666666666666656) * v76 + 1.0)) * v74
            else:
                v116 = nan
            v119 = v116 >= 0.25 * v73
            if v119:
                v132 = a > c
                v142 = v119 and v132
                if v142:
                    v121 = c - 0.0
                    v125 = sqrt((v121 if v121 > 0.0 or v121 != v121 else 0.0) * (c + 0.0))
                    if v142:
                        v126 = a - c
                        if v132:
                            v127 = a - 0.0
                            v137 = v126 * (a + c) / (sqrt((v127 if v127 > 0.0 or v127 != v127 else 0.0) * (a + 0.0)) + v125)
                        else:
                            v137 = 0.0
                        v143 = log1p((v126 + v137) / (c + v125))
                    else:
                        v143 = 0.0
                    v151 = v12 / s
                    v198 = []
                    for node, weight in RULE_0(v143 / 1.0):
                        v144 = node * v143
                        v149 = c * cosh(v144) + v125 * sinh(v144)
                        v150 = v149 / s
                        v152 = v150 * v150
                        v177 = ((((((((((((1.567077144036674e-13 * v152 + -3.840375691006307e-12) * v152 + 3.8015754128174666e-11) * v152 + -1.8423006918213799e-10) * v152 + 4.472469827763728e-10) * v152 + -1.1927516362741588e-09) * v152 + 6.225892246861416e-09) * v152 + 3.4413148480148793e-09) * v152 + -9.933344851449817e-08) * v152 + -5.127541706569233e-07) * v152 + 1.8119768160503268e-06) * v152 + 2.151585040783394e-05) * v152 + 4.61098799999374e-06) * v152
                        v189 = v150 / ((((((v177 + -0.000684089638073553) * v152 + -0.002257495580553435) * v152 + 0.016931216930225715) * v152 + 0.17777777777782838) * v152 + 0.6666666666666656) * v152 + 1.0)
                        v197 = v151 * (v189 + (1.0 - 2.0 * v189 * v150) * v150) * pow(v149, 1.0)
                        v198.append(weight * v197)
                    v198 = fsum(v198) * v143
                    v199 = v198
                else:
                    v199 = 0.0
                v203 = v199
            else:
                v203 = v73 - v116
            value = mu * (E_star / G_star) * v203
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, s, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, h, s, E_star, mu):
    if a.__class__ is c.__class__ is h.__class__ is s.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = 2.0 * E_star
            v12 = 2.0 * h / s
            v79 = 1.5019752682686114 * s
            if a <= v79:
                v76 = []
                for node, weight in RULE_1(a / 1.0):
                    v9 = node * a
                    v10 = v9 / s
                    v13 = v10 * v10
                    v51 = ((((((((((((1.567077144036674e-13 * v13 + -3.840375691006307e-12) * v13 + 3.8015754128174666e-11) * v13 + -1.8423006918213799e-10) * v13 + 4.472469827763728e-10) * v13 + -1.1927516362741588e-09) * v13 + 6.225892246861416e-09) * v13 + 3.4413148480148793e-09) * v13 + -9.933344851449817e-08) * v13 + -5.127541706569233e-07) * v13 + 1.8119768160503268e-06) * v13 + 2.151585040783394e-05) * v13 + 4.61098799999374e-06) * v13
                    v68 = v10 / ((((((v51 + -0.000684089638073553) * v13 + -0.002257495580553435) * v13 + 0.016931216930225715) * v13 + 0.17777777777782838) * v13 + 0.6666666666666656) * v13 + 1.0)
                    v75 = v9 * (v12 * (v68 + (1.0 - 2.0 * v68 * v10) * v10))
                    v76.append(weight * v75)
                v76 = fsum(v76) * a
                v82 = v7 * v76
            else:
                v82 = nan
            if c <= v79:
                v130 = []
                for node, weight in RULE_1(c / 1.0):
                    v83 = node * c
                    v84 = v83 / s
                    v85 = v84 * v84
                    v110 = ((((((((((((1.567077144036674e-13 * v85 + -3.840375691006307e-12) * v85 + 3.8015754128174666e-11) * v85 + -1.8423006918213799e-10) * v85 + 4.472469827763728e-10) * v85 + -1.1927516362741588e-09) * v85 + 6.225892246861416e-09) * v85 + 3.4413148480148793e-09) * v85 + -9.933344851449817e-08) * v85 + -5.127541706569233e-07) * v85 + 1.8119768160503268e-06) * v85 + 2.151585040783394e-05) * v85 + 4.61098799999374e-06) * v85
                    v122 = v84 / ((((((v110 + -0.000684089638073553) * v85 + -0.002257495580553435) * v85 + 0.016931216930225715) * v85 + 0.17777777777782838) * v85 + 0.6666666666666656) * v85 + 1.0)
                    v129 = v83 * (v12 * (v122 + (1.0 - 2.0 * v122 * v84) * v84))
                    v130.append(weight * v129)
                v130 = fsum(v130) * c
                v133 = v7 * v130
            else:
                v133 = nan
            v136 = v133 >= 0.25 * v82
            if v136:
                v149 = a > c
                v159 = v136 and v149
                if v159:
                    v138 = c - 0.0
                    v142 = sqrt((v138 if v138 > 0.0 or v138 != v138 else 0.0) * (c + 0.0))
                    if v159:
                        v143 = a - c
                        if v149:
                            v144 = a - 0.0
                            v154 = v143 * (a + c) / (sqrt((v144 if v144 > 0.0 or v144 != v144 else 0.0) * (a + 0.0)) + v142)
                        else:
                            v154 = 0.0
                        v160 = log1p((v143 + v154) / (c + v142))
                    else:
                        v160 = 0.0
                    v214 = []
                    for node, weight in RULE_0(v160 / 1.0):
                        v161 = node * v160
                        v166 = c * cosh(v161) + v142 * sinh(v161)
                        v167 = v166 / s
                        v168 = v167 * v167
                        v193 = ((((((((((((1.567077144036674e-13 * v168 + -3.840375691006307e-12) * v168 + 3.8015754128174666e-11) * v168 + -1.8423006918213799e-10) * v168 + 4.472469827763728e-10) * v168 + -1.1927516362741588e-09) * v168 + 6.225892246861416e-09) * v168 + 3.4413148480148793e-09) * v168 + -9.933344851449817e-08) * v168 + -5.127541706569233e-07) * v168 + 1.8119768160503268e-06) * v168 + 2.151585040783394e-05) * v168 + 4.61098799999374e-06) * v168
                        v205 = v167 / ((((((v193 + -0.000684089638073553) * v168 + -0.002257495580553435) * v168 + 0.016931216930225715) * v168 + 0.17777777777782838) * v168 + 0.6666666666666656) * v168 + 1.0)
                        v213 = v12 * (v205 + (1.0 - 2.0 * v205 * v167) * v167) * (v166 * v166)
                        v214.append(weight * v213)
                    v214 = fsum(v214) * v160
                    v215 = v214
                else:
                    v215 = 0.0
                v218 = v7 * v215
            else:
                v218 = v82 - v133
            value = mu * v218
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, s, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, h, s, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is h.__class__ is s.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = a - r
            v12 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + r))
            v15 = r * r
            v22 = 2.0 * h / s
            v89 = E_star / 3.141592653589793
            v93 = 1.5019752682686114 * s
            if a <= v93:
                if r < a:
                    v86 = []
                    for node, weight in RULE_1(v12 / 1.0):
                        v14 = node * v12
                        v18 = sqrt(v15 + v14 * v14)
                        v19 = v18 / s
                        v23 = v19 * v19
                        v61 = ((((((((((((1.567077144036674e-13 * v23 + -3.840375691006307e-12) * v23 + 3.8015754128174666e-11) * v23 + -1.8423006918213799e-10) * v23 + 4.472469827763728e-10) * v23 + -1.1927516362741588e-09) * v23 + 6.225892246861416e-09) * v23 + 3.4413148480148793e-09) * v23 + -9.933344851449817e-08) * v23 + -5.127541706569233e-07) * v23 + 1.8119768160503268e-06) * v23 + 2.151585040783394e-05) * v23 + 4.61098799999374e-06) * v23
                        v78 = v19 / ((((((v61 + -0.000684089638073553) * v23 + -0.002257495580553435) * v23 + 0.016931216930225715) * v23 + 0.17777777777782838) * v23 + 0.6666666666666656) * v23 + 1.0)
                        v85 = v22 * (v78 + (1.0 - 2.0 * v78 * v19) * v19) / v18
                        v86.append(weight * v85)
                    v86 = fsum(v86) * v12
                    v91 = v89 * v86
                else:
                    v91 = 0.0
                v96 = v91
            else:
                v96 = nan
            v97 = c - r
            v101 = sqrt((v97 if v97 > 0.0 or v97 != v97 else 0.0) * (c + r))
            v153 = r < c
            if c <= v93:
                if v153:
                    v152 = []
                    for node, weight in RULE_1(v101 / 1.0):
                        v102 = node * v101
                        v105 = sqrt(v15 + v102 * v102)
                        v106 = v105 / s
                        v107 = v106 * v106
                        v132 = ((((((((((((1.567077144036674e-13 * v107 + -3.840375691006307e-12) * v107 + 3.8015754128174666e-11) * v107 + -1.8423006918213799e-10) * v107 + 4.472469827763728e-10) * v107 + -1.1927516362741588e-09) * v107 + 6.225892246861416e-09) * v107 + 3.4413148480148793e-09) * v107 + -9.933344851449817e-08) * v107 + -5.127541706569233e-07) * v107 + 1.8119768160503268e-06) * v107 + 2.151585040783394e-05) * v107 + 4.61098799999374e-06) * v107
                        v144 = v106 / ((((((v132 + -0.000684089638073553) * v107 + -0.002257495580553435) * v107 + 0.016931216930225715) * v107 + 0.17777777777782838) * v107 + 0.6666666666666656) * v107 + 1.0)
                        v151 = v22 * (v144 + (1.0 - 2.0 * v144 * v106) * v106) / v105
                        v152.append(weight * v151)
                    v152 = fsum(v152) * v101
                    v155 = v89 * v152
                else:
                    v155 = 0.0
                v157 = v155
            else:
                v157 = nan
            v161 = v153 and v157 >= 0.25 * v96
            if v161:
                v163 = a > c
                v173 = v161 and v163
                if v173:
                    if v173:
                        v162 = a - c
                        v174 = log1p((v162 + (v162 * (a + c) / (v12 + v101) if v163 else 0.0)) / (c + v101))
                    else:
                        v174 = 0.0
                    v228 = []
                    for node, weight in RULE_0(v174 / 1.0):
                        v175 = node * v174
                        v180 = c * cosh(v175) + v101 * sinh(v175)
                        v181 = v180 / s
                        v182 = v181 * v181
                        v207 = ((((((((((((1.567077144036674e-13 * v182 + -3.840375691006307e-12) * v182 + 3.8015754128174666e-11) * v182 + -1.8423006918213799e-10) * v182 + 4.472469827763728e-10) * v182 + -1.1927516362741588e-09) * v182 + 6.225892246861416e-09) * v182 + 3.4413148480148793e-09) * v182 + -9.933344851449817e-08) * v182 + -5.127541706569233e-07) * v182 + 1.8119768160503268e-06) * v182 + 2.151585040783394e-05) * v182 + 4.61098799999374e-06) * v182
                        v219 = v181 / ((((((v207 + -0.000684089638073553) * v182 + -0.002257495580553435) * v182 + 0.016931216930225715) * v182 + 0.17777777777782838) * v182 + 0.6666666666666656) * v182 + 1.0)
                        v227 = v22 * (v219 + (1.0 - 2.0 * v219 * v181) * v181) * pow(v180, 0.0)
                        v228.append(weight * v227)
                    v228 = fsum(v228) * v174
                    v229 = v228
                else:
                    v229 = 0.0
                v232 = v89 * v229
            else:
                v232 = v96 - v157
            value = mu * v232
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, h, s, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'h', 's', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 2, 1, (), False),
        ('a', 'h', 's', 'E_star', 'G_star', 'mu'): (('a', 'h', 's', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 4, 1, (), False),
    },
}
