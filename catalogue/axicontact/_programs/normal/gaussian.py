"""Programs of axicontact.normal.gaussian."""

from __future__ import annotations

from math import asinh, atan2, cos, exp, expm1, fsum, inf, nan, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import gaussian as bodies

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
C22 = np.array(0.0)
RULE_0 = rule(((inf, 32),))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, h, s):
    if a.__class__ is h.__class__ is s.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                v3 = a / s
                v9 = v3 * v3
                v47 = ((((((((((((1.567077144036674e-13 * v9 + -3.840375691006307e-12) * v9 + 3.8015754128174666e-11) * v9 + -1.8423006918213799e-10) * v9 + 4.472469827763728e-10) * v9 + -1.1927516362741588e-09) * v9 + 6.225892246861416e-09) * v9 + 3.4413148480148793e-09) * v9 + -9.933344851449817e-08) * v9 + -5.127541706569233e-07) * v9 + 1.8119768160503268e-06) * v9 + 2.151585040783394e-05) * v9 + 4.61098799999374e-06) * v9
                value = 2.0 * h * (v3 / ((((((v47 + -0.000684089638073553) * v9 + -0.002257495580553435) * v9 + 0.016931216930225715) * v9 + 0.17777777777782838) * v9 + 0.6666666666666656) * v9 + 1.0)) * v3
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(h, s):
    v5 = (1.5019752682686114) * s
    v8 = (2.0) * h
    return (s, v5, v8)


def block_depth_a(out, a, s, v5, v8, t0, t1, m0):
    size = out.size
    np.less_equal(a, v5, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some69 = np.count_nonzero(m0)
    if some69:
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
        np.multiply(v8, t0, t0)
        np.multiply(t0, out, out)
    if some69 != size:
        np.copyto(out, C19, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, h, s, t0, t1, t2, m0):
    size = out.size
    np.multiply(C20, s, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less_equal(a, t0, m0)
    some69 = np.count_nonzero(m0)
    if some69:
        np.divide(a, s, out)
        np.multiply(C21, h, t0)
        np.multiply(out, out, t1)
        np.multiply(C0, t1, t2)
        np.add(t2, C1, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C2, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C3, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C4, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C5, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C6, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C7, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C8, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C9, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C10, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C11, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C12, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C13, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C14, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C15, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C16, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C17, t2)
        np.multiply(t2, t1, t1)
        np.add(t1, C18, t1)
        np.divide(out, t1, t1)
        np.multiply(t0, t1, t1)
        np.multiply(t1, out, out)
    if some69 != size:
        np.copyto(out, C19, where=~m0)


def depth_from_force(F, h, s, E_star):
    if F.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, h, s, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, h, s, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, h, s):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30):
        try:
            v91 = a <= 1.5019752682686114 * s
            if v91:
                v17 = 2.0 * h
                if r > a:
                    v4 = r - a
                    v10 = atan2(a, sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (r + a)))
                    v18 = v17 / s
                    v84 = []
                    for node, weight in RULE_0(v10 / 1.0):
                        v12 = node * v10
                        v15 = r * sin(v12) / s
                        v19 = v15 * v15
                        v57 = ((((((((((((1.567077144036674e-13 * v19 + -3.840375691006307e-12) * v19 + 3.8015754128174666e-11) * v19 + -1.8423006918213799e-10) * v19 + 4.472469827763728e-10) * v19 + -1.1927516362741588e-09) * v19 + 6.225892246861416e-09) * v19 + 3.4413148480148793e-09) * v19 + -9.933344851449817e-08) * v19 + -5.127541706569233e-07) * v19 + 1.8119768160503268e-06) * v19 + 2.151585040783394e-05) * v19 + 4.61098799999374e-06) * v19
                        v74 = v15 / ((((((v57 + -0.000684089638073553) * v19 + -0.002257495580553435) * v19 + 0.016931216930225715) * v19 + 0.17777777777782838) * v19 + 0.6666666666666656) * v19 + 1.0)
                        v83 = v18 * (v74 + (1.0 - 2.0 * v74 * v15) * v15) * v12 * cos(v12)
                        v84.append(weight * v83)
                    v84 = fsum(v84) * v10
                    value = 0.6366197723675814 * (r * v84)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s):
                        return value
                    return None
                if v91:
                    v88 = a / s
                    v92 = v88 * v88
                    v117 = ((((((((((((1.567077144036674e-13 * v92 + -3.840375691006307e-12) * v92 + 3.8015754128174666e-11) * v92 + -1.8423006918213799e-10) * v92 + 4.472469827763728e-10) * v92 + -1.1927516362741588e-09) * v92 + 6.225892246861416e-09) * v92 + 3.4413148480148793e-09) * v92 + -9.933344851449817e-08) * v92 + -5.127541706569233e-07) * v92 + 1.8119768160503268e-06) * v92 + 2.151585040783394e-05) * v92 + 4.61098799999374e-06) * v92
                    v133 = v17 * (v88 / ((((((v117 + -0.000684089638073553) * v92 + -0.002257495580553435) * v92 + 0.016931216930225715) * v92 + 0.17777777777782838) * v92 + 0.6666666666666656) * v92 + 1.0)) * v88
                else:
                    v133 = nan
                value = v133 - -h * expm1(-(r * r) / (s * s))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, h, s, E_star):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = 1.5019752682686114 * s
            v7 = a <= v6
            if v7:
                v9 = 2.0 * h
                if v7:
                    v4 = a / s
                    v10 = v4 * v4
                    v48 = ((((((((((((1.567077144036674e-13 * v10 + -3.840375691006307e-12) * v10 + 3.8015754128174666e-11) * v10 + -1.8423006918213799e-10) * v10 + 4.472469827763728e-10) * v10 + -1.1927516362741588e-09) * v10 + 6.225892246861416e-09) * v10 + 3.4413148480148793e-09) * v10 + -9.933344851449817e-08) * v10 + -5.127541706569233e-07) * v10 + 1.8119768160503268e-06) * v10 + 2.151585040783394e-05) * v10 + 4.61098799999374e-06) * v10
                    v70 = v9 * (v4 / ((((((v48 + -0.000684089638073553) * v10 + -0.002257495580553435) * v10 + 0.016931216930225715) * v10 + 0.17777777777782838) * v10 + 0.6666666666666656) * v10 + 1.0)) * v4
                else:
                    v70 = nan
                v72 = asinh(a / a)
                v77 = 0.0 - expm1(-2.0 * v72)
                v80 = v77 if v77 > 0.0 else inf
                v136 = a * a
                v141 = []
                for node, weight in RULE_1(v72 / 1.0):
                    v81 = node * v72
                    v90 = a * (exp(-v81) * (0.0 - expm1(-2.0 * (v72 - v81))) / v80)
                    if v90 <= v6:
                        v91 = v90 / s
                        v93 = v91 * v91
                        v118 = ((((((((((((1.567077144036674e-13 * v93 + -3.840375691006307e-12) * v93 + 3.8015754128174666e-11) * v93 + -1.8423006918213799e-10) * v93 + 4.472469827763728e-10) * v93 + -1.1927516362741588e-09) * v93 + 6.225892246861416e-09) * v93 + 3.4413148480148793e-09) * v93 + -9.933344851449817e-08) * v93 + -5.127541706569233e-07) * v93 + 1.8119768160503268e-06) * v93 + 2.151585040783394e-05) * v93 + 4.61098799999374e-06) * v93
                        v133 = v9 * (v91 / ((((((v118 + -0.000684089638073553) * v93 + -0.002257495580553435) * v93 + 0.016931216930225715) * v93 + 0.17777777777782838) * v93 + 0.6666666666666656) * v93 + 1.0)) * v91
                    else:
                        v133 = nan
                    v134 = v70 - v133
                    v140 = v134 * v134 * sqrt(v136 + v90 * v90)
                    v141.append(weight * v140)
                v141 = fsum(v141) * v72
                value = E_star * v141
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, h, s, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, h, s, E_star):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                v10 = 2.0 * h / s
                v74 = []
                for node, weight in RULE_0(a / 1.0):
                    v7 = node * a
                    v8 = v7 / s
                    v11 = v8 * v8
                    v49 = ((((((((((((1.567077144036674e-13 * v11 + -3.840375691006307e-12) * v11 + 3.8015754128174666e-11) * v11 + -1.8423006918213799e-10) * v11 + 4.472469827763728e-10) * v11 + -1.1927516362741588e-09) * v11 + 6.225892246861416e-09) * v11 + 3.4413148480148793e-09) * v11 + -9.933344851449817e-08) * v11 + -5.127541706569233e-07) * v11 + 1.8119768160503268e-06) * v11 + 2.151585040783394e-05) * v11 + 4.61098799999374e-06) * v11
                    v66 = v8 / ((((((v49 + -0.000684089638073553) * v11 + -0.002257495580553435) * v11 + 0.016931216930225715) * v11 + 0.17777777777782838) * v11 + 0.6666666666666656) * v11 + 1.0)
                    v73 = v7 * (v10 * (v66 + (1.0 - 2.0 * v66 * v8) * v8))
                    v74.append(weight * v73)
                v74 = fsum(v74) * a
                value = 2.0 * E_star * v74
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, h, s, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def force_from_depth(d, h, s, E_star):
    if d.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, h, s, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, h, s, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, h, s, E_star):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v110 = 1.5019752682686114 * s
            if a <= v110:
                v5 = r if r < a or r != r else a
                v40 = 2.0 * h / s
                if v5 > 0.0:
                    v6 = a - v5
                    v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (a + v5))
                    v13 = asinh(v11 / v5)
                    v18 = 0.0 - expm1(-2.0 * v13)
                    v21 = v18 if v18 > 0.0 else inf
                    v22 = v5 * v5
                    v106 = []
                    for node, weight in RULE_1(v13 / 1.0):
                        v24 = node * v13
                        v33 = v11 * (exp(-v24) * (0.0 - expm1(-2.0 * (v13 - v24))) / v21)
                        v36 = sqrt(v22 + v33 * v33)
                        v37 = v36 / s
                        v41 = v37 * v37
                        v79 = ((((((((((((1.567077144036674e-13 * v41 + -3.840375691006307e-12) * v41 + 3.8015754128174666e-11) * v41 + -1.8423006918213799e-10) * v41 + 4.472469827763728e-10) * v41 + -1.1927516362741588e-09) * v41 + 6.225892246861416e-09) * v41 + 3.4413148480148793e-09) * v41 + -9.933344851449817e-08) * v41 + -5.127541706569233e-07) * v41 + 1.8119768160503268e-06) * v41 + 2.151585040783394e-05) * v41 + 4.61098799999374e-06) * v41
                        v96 = v37 / ((((((v79 + -0.000684089638073553) * v41 + -0.002257495580553435) * v41 + 0.016931216930225715) * v41 + 0.17777777777782838) * v41 + 0.6666666666666656) * v41 + 1.0)
                        v105 = v40 * (v96 + (1.0 - 2.0 * v96 * v37) * v37) * (v33 / (v36 + v33))
                        v106.append(weight * v105)
                    v106 = fsum(v106) * v13
                    v108 = v22 * v106
                else:
                    v108 = 0.0
                v112 = 2.0 * E_star
                if v5 <= v110:
                    v160 = []
                    for node, weight in RULE_0(v5 / 1.0):
                        v113 = node * v5
                        v114 = v113 / s
                        v115 = v114 * v114
                        v140 = ((((((((((((1.567077144036674e-13 * v115 + -3.840375691006307e-12) * v115 + 3.8015754128174666e-11) * v115 + -1.8423006918213799e-10) * v115 + 4.472469827763728e-10) * v115 + -1.1927516362741588e-09) * v115 + 6.225892246861416e-09) * v115 + 3.4413148480148793e-09) * v115 + -9.933344851449817e-08) * v115 + -5.127541706569233e-07) * v115 + 1.8119768160503268e-06) * v115 + 2.151585040783394e-05) * v115 + 4.61098799999374e-06) * v115
                        v152 = v114 / ((((((v140 + -0.000684089638073553) * v115 + -0.002257495580553435) * v115 + 0.016931216930225715) * v115 + 0.17777777777782838) * v115 + 0.6666666666666656) * v115 + 1.0)
                        v159 = v113 * (v40 * (v152 + (1.0 - 2.0 * v152 * v114) * v114))
                        v160.append(weight * v159)
                    v160 = fsum(v160) * v5
                    v164 = v112 * v160
                else:
                    v164 = nan
                value = v164 + v112 * v108
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, h, s, E_star):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a > 0.0:
                if a <= 1.5019752682686114 * s:
                    v12 = 2.0 * h / s
                    v76 = []
                    for node, weight in RULE_0(a / 1.0):
                        v9 = node * a
                        v10 = v9 / s
                        v13 = v10 * v10
                        v51 = ((((((((((((1.567077144036674e-13 * v13 + -3.840375691006307e-12) * v13 + 3.8015754128174666e-11) * v13 + -1.8423006918213799e-10) * v13 + 4.472469827763728e-10) * v13 + -1.1927516362741588e-09) * v13 + 6.225892246861416e-09) * v13 + 3.4413148480148793e-09) * v13 + -9.933344851449817e-08) * v13 + -5.127541706569233e-07) * v13 + 1.8119768160503268e-06) * v13 + 2.151585040783394e-05) * v13 + 4.61098799999374e-06) * v13
                        v68 = v10 / ((((((v51 + -0.000684089638073553) * v13 + -0.002257495580553435) * v13 + 0.016931216930225715) * v13 + 0.17777777777782838) * v13 + 0.6666666666666656) * v13 + 1.0)
                        v75 = v9 * (v12 * (v68 + (1.0 - 2.0 * v68 * v10) * v10))
                        v76.append(weight * v75)
                    v76 = fsum(v76) * a
                    v82 = 2.0 * E_star * v76
                else:
                    v82 = nan
                value = v82 / (3.141592653589793 * (a * a))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, h, s, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_pressure(a, h, s, E_star):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                if 0.0 < a:
                    v5 = a - 0.0
                    v9 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (a + 0.0))
                    v18 = 2.0 * h / s
                    v82 = []
                    for node, weight in RULE_0(v9 / 1.0):
                        v11 = node * v9
                        v14 = sqrt(0.0 + v11 * v11)
                        v15 = v14 / s
                        v19 = v15 * v15
                        v57 = ((((((((((((1.567077144036674e-13 * v19 + -3.840375691006307e-12) * v19 + 3.8015754128174666e-11) * v19 + -1.8423006918213799e-10) * v19 + 4.472469827763728e-10) * v19 + -1.1927516362741588e-09) * v19 + 6.225892246861416e-09) * v19 + 3.4413148480148793e-09) * v19 + -9.933344851449817e-08) * v19 + -5.127541706569233e-07) * v19 + 1.8119768160503268e-06) * v19 + 2.151585040783394e-05) * v19 + 4.61098799999374e-06) * v19
                        v74 = v15 / ((((((v57 + -0.000684089638073553) * v19 + -0.002257495580553435) * v19 + 0.016931216930225715) * v19 + 0.17777777777782838) * v19 + 0.6666666666666656) * v19 + 1.0)
                        v81 = v18 * (v74 + (1.0 - 2.0 * v74 * v15) * v15) / v14
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v9
                    value = E_star / 3.141592653589793 * v82
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if value != value and ordinary(a, h, s, E_star):
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_radius(a, s, h=1.0, E_star=1.0):
    if a.__class__ is s.__class__ is h.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (s > 1e-30) and (s < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_a(s):
    v3 = (1.5019752682686114) * s
    return (v3,)


def block_peak_radius_a(out, a, v3, m0):
    size = out.size
    np.less_equal(a, v3, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some7 = np.count_nonzero(m0)
    if some7:
        np.copyto(out, C22)
    if some7 != size:
        np.copyto(out, C19, where=~m0)


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a, s, t0, m0):
    size = out.size
    np.multiply(C20, s, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less_equal(a, t0, m0)
    some7 = np.count_nonzero(m0)
    if some7:
        np.copyto(out, C22)
    if some7 != size:
        np.copyto(out, C19, where=~m0)


def pressure(r, a, h, s, E_star):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                if r < a:
                    v5 = a - r
                    v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (a + r))
                    v13 = r * r
                    v20 = 2.0 * h / s
                    v84 = []
                    for node, weight in RULE_0(v10 / 1.0):
                        v12 = node * v10
                        v16 = sqrt(v13 + v12 * v12)
                        v17 = v16 / s
                        v21 = v17 * v17
                        v59 = ((((((((((((1.567077144036674e-13 * v21 + -3.840375691006307e-12) * v21 + 3.8015754128174666e-11) * v21 + -1.8423006918213799e-10) * v21 + 4.472469827763728e-10) * v21 + -1.1927516362741588e-09) * v21 + 6.225892246861416e-09) * v21 + 3.4413148480148793e-09) * v21 + -9.933344851449817e-08) * v21 + -5.127541706569233e-07) * v21 + 1.8119768160503268e-06) * v21 + 2.151585040783394e-05) * v21 + 4.61098799999374e-06) * v21
                        v76 = v17 / ((((((v59 + -0.000684089638073553) * v21 + -0.002257495580553435) * v21 + 0.016931216930225715) * v21 + 0.17777777777782838) * v21 + 0.6666666666666656) * v21 + 1.0)
                        v83 = v20 * (v76 + (1.0 - 2.0 * v76 * v17) * v17) / v16
                        v84.append(weight * v83)
                    v84 = fsum(v84) * v10
                    value = E_star / 3.141592653589793 * v84
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s, E_star):
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, h, s):
    if r.__class__ is h.__class__ is s.__class__ is float and r > 1e-30 and (r < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30):
        try:
            value = -h * expm1(-(r * r) / (s * s))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(h, s):
    v3 = np.negative(h)
    v7 = np.square(s)
    return (v3, v7)


def block_profile_r(out, r, v3, v7):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.negative(out, out)
    np.divide(out, v7, out)
    np.expm1(out, out)
    np.multiply(v3, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, h, s, t0, t1):
    np.negative(h, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.square(r, t0)
    np.negative(t0, t0)
    np.square(s, t1)
    np.divide(t0, t1, t1)
    np.expm1(t1, t1)
    np.multiply(out, t1, out)


def radius_from_depth(d, h, s):
    if d.__class__ is h.__class__ is s.__class__ is float and d > 1e-30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30):
        try:
            value = bodies._radius_from_depth(d, h, s)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, h, s):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, h, s, E_star):
    if F.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, h, s, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, h, s, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, s, E_star, h=1.0):
    if a.__class__ is s.__class__ is E_star.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                return 2.0 * E_star * a
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_a(s, E_star):
    v4 = (1.5019752682686114) * s
    v7 = (2.0) * E_star
    return (v4, v7)


def block_stiffness_a(out, a, v4, v7, m0):
    size = out.size
    np.less_equal(a, v4, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.multiply(v7, a, out)
    if some10 != size:
        np.copyto(out, C19, where=~m0)


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, a, s, E_star, t0, m0):
    size = out.size
    np.multiply(C20, s, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less_equal(a, t0, m0)
    some10 = np.count_nonzero(m0)
    if some10:
        np.multiply(C21, E_star, out)
        np.multiply(out, a, out)
    if some10 != size:
        np.copyto(out, C19, where=~m0)


BLOCKS = {
    ('_depth', 1, 'a', 'h', 's'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 2, 1, (), False),
        ('a', 'h', 's'): (('a', 'h', 's'), prepare_depth_all, block_depth_all, 3, 1, (), False),
    },
    ('_peak_radius', 1, 'a', 's'): {
        ('a',): (('a',), prepare_peak_radius_a, block_peak_radius_a, 0, 1, (), False),
        ('a', 's'): (('a', 's'), prepare_peak_radius_all, block_peak_radius_all, 1, 1, (), False),
    },
    ('_profile', 1, 'r', 'h', 's'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 0, (), False),
        ('r', 'h', 's'): (('r', 'h', 's'), prepare_profile_all, block_profile_all, 2, 0, (), False),
    },
    ('_stiffness', 1, 'a', 's', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 1, (), False),
        ('a', 's', 'E_star'): (('a', 's', 'E_star'), prepare_stiffness_all, block_stiffness_all, 1, 1, (), False),
    },
}
