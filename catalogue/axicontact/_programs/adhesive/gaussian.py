"""Programs of axicontact.adhesive.gaussian."""

from __future__ import annotations

from math import atan2, cos, expm1, fsum, inf, nan, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import gaussian as bodies

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
C22 = np.array(6.283185307179586)
RULE_0 = rule(((inf, 32),))


def depth(a, h, s, E_star, dgamma):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                v5 = a / s
                v11 = v5 * v5
                v49 = ((((((((((((1.567077144036674e-13 * v11 + -3.840375691006307e-12) * v11 + 3.8015754128174666e-11) * v11 + -1.8423006918213799e-10) * v11 + 4.472469827763728e-10) * v11 + -1.1927516362741588e-09) * v11 + 6.225892246861416e-09) * v11 + 3.4413148480148793e-09) * v11 + -9.933344851449817e-08) * v11 + -5.127541706569233e-07) * v11 + 1.8119768160503268e-06) * v11 + 2.151585040783394e-05) * v11 + 4.61098799999374e-06) * v11
                v71 = 2.0 * h * (v5 / ((((((v49 + -0.000684089638073553) * v11 + -0.002257495580553435) * v11 + 0.016931216930225715) * v11 + 0.17777777777782838) * v11 + 0.6666666666666656) * v11 + 1.0)) * v5
            else:
                v71 = nan
            value = v71 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(h, s, E_star, dgamma):
    v7 = (1.5019752682686114) * s
    v10 = (2.0) * h
    v74 = (6.283185307179586) * dgamma
    v75 = v74 / E_star
    v76 = np.sqrt(v75)
    return (s, v7, v10, v76)


def block_depth_a(out, a, s, v7, v10, v76, t0, t1, m0):
    size = out.size
    np.less_equal(a, v7, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some71 = np.count_nonzero(m0)
    if some71:
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
        np.multiply(v10, t0, t0)
        np.multiply(t0, out, out)
    if some71 != size:
        np.copyto(out, C19, where=~m0)
    np.sqrt(a, t0)
    np.multiply(t0, v76, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, h, s, E_star, dgamma, t0, t1, t2, m0):
    size = out.size
    np.multiply(C20, s, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less_equal(a, out, m0)
    some71 = np.count_nonzero(m0)
    if some71:
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
    if some71 != size:
        np.copyto(out, C19, where=~m0)
    np.sqrt(a, t1)
    np.multiply(C22, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t1, t0, t0)
    np.subtract(out, t0, out)


def displacement(r, a, h, s, E_star, dgamma):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = r - a
            v12 = atan2(a, sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (r + a)))
            v93 = a <= 1.5019752682686114 * s
            v144 = r > a
            if v93:
                v19 = 2.0 * h
                if v144:
                    v20 = v19 / s
                    v86 = []
                    for node, weight in RULE_0(v12 / 1.0):
                        v14 = node * v12
                        v17 = r * sin(v14) / s
                        v21 = v17 * v17
                        v59 = ((((((((((((1.567077144036674e-13 * v21 + -3.840375691006307e-12) * v21 + 3.8015754128174666e-11) * v21 + -1.8423006918213799e-10) * v21 + 4.472469827763728e-10) * v21 + -1.1927516362741588e-09) * v21 + 6.225892246861416e-09) * v21 + 3.4413148480148793e-09) * v21 + -9.933344851449817e-08) * v21 + -5.127541706569233e-07) * v21 + 1.8119768160503268e-06) * v21 + 2.151585040783394e-05) * v21 + 4.61098799999374e-06) * v21
                        v76 = v17 / ((((((v59 + -0.000684089638073553) * v21 + -0.002257495580553435) * v21 + 0.016931216930225715) * v21 + 0.17777777777782838) * v21 + 0.6666666666666656) * v21 + 1.0)
                        v85 = v20 * (v76 + (1.0 - 2.0 * v76 * v17) * v17) * v14 * cos(v14)
                        v86.append(weight * v85)
                    v86 = fsum(v86) * v12
                    v145 = 0.6366197723675814 * (r * v86)
                else:
                    if v93:
                        v90 = a / s
                        v94 = v90 * v90
                        v119 = ((((((((((((1.567077144036674e-13 * v94 + -3.840375691006307e-12) * v94 + 3.8015754128174666e-11) * v94 + -1.8423006918213799e-10) * v94 + 4.472469827763728e-10) * v94 + -1.1927516362741588e-09) * v94 + 6.225892246861416e-09) * v94 + 3.4413148480148793e-09) * v94 + -9.933344851449817e-08) * v94 + -5.127541706569233e-07) * v94 + 1.8119768160503268e-06) * v94 + 2.151585040783394e-05) * v94 + 4.61098799999374e-06) * v94
                        v135 = v19 * (v90 / ((((((v119 + -0.000684089638073553) * v94 + -0.002257495580553435) * v94 + 0.016931216930225715) * v94 + 0.17777777777782838) * v94 + 0.6666666666666656) * v94 + 1.0)) * v90
                    else:
                        v135 = nan
                    v145 = v135 - -h * expm1(-(r * r) / (s * s))
                v146 = v145
            else:
                v146 = nan
            value = v146 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * v12 if v144 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, h, s, E_star, dgamma):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = 2.0 * E_star
            if a <= 1.5019752682686114 * s:
                v11 = 2.0 * h / s
                v75 = []
                for node, weight in RULE_0(a / 1.0):
                    v8 = node * a
                    v9 = v8 / s
                    v12 = v9 * v9
                    v50 = ((((((((((((1.567077144036674e-13 * v12 + -3.840375691006307e-12) * v12 + 3.8015754128174666e-11) * v12 + -1.8423006918213799e-10) * v12 + 4.472469827763728e-10) * v12 + -1.1927516362741588e-09) * v12 + 6.225892246861416e-09) * v12 + 3.4413148480148793e-09) * v12 + -9.933344851449817e-08) * v12 + -5.127541706569233e-07) * v12 + 1.8119768160503268e-06) * v12 + 2.151585040783394e-05) * v12 + 4.61098799999374e-06) * v12
                    v67 = v9 / ((((((v50 + -0.000684089638073553) * v12 + -0.002257495580553435) * v12 + 0.016931216930225715) * v12 + 0.17777777777782838) * v12 + 0.6666666666666656) * v12 + 1.0)
                    v74 = v8 * (v11 * (v67 + (1.0 - 2.0 * v67 * v9) * v9))
                    v75.append(weight * v74)
                v75 = fsum(v75) * a
                v81 = v6 * v75
            else:
                v81 = nan
            value = v81 - v6 * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, s, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, h, s, E_star, dgamma):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = a - r
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (a + r))
            if a <= 1.5019752682686114 * s:
                if r < a:
                    v14 = r * r
                    v21 = 2.0 * h / s
                    v85 = []
                    for node, weight in RULE_0(v11 / 1.0):
                        v13 = node * v11
                        v17 = sqrt(v14 + v13 * v13)
                        v18 = v17 / s
                        v22 = v18 * v18
                        v60 = ((((((((((((1.567077144036674e-13 * v22 + -3.840375691006307e-12) * v22 + 3.8015754128174666e-11) * v22 + -1.8423006918213799e-10) * v22 + 4.472469827763728e-10) * v22 + -1.1927516362741588e-09) * v22 + 6.225892246861416e-09) * v22 + 3.4413148480148793e-09) * v22 + -9.933344851449817e-08) * v22 + -5.127541706569233e-07) * v22 + 1.8119768160503268e-06) * v22 + 2.151585040783394e-05) * v22 + 4.61098799999374e-06) * v22
                        v77 = v18 / ((((((v60 + -0.000684089638073553) * v22 + -0.002257495580553435) * v22 + 0.016931216930225715) * v22 + 0.17777777777782838) * v22 + 0.6666666666666656) * v22 + 1.0)
                        v84 = v21 * (v77 + (1.0 - 2.0 * v77 * v18) * v18) / v17
                        v85.append(weight * v84)
                    v85 = fsum(v85) * v11
                    v90 = E_star / 3.141592653589793 * v85
                else:
                    v90 = 0.0
                v95 = v90
            else:
                v95 = nan
            if r <= a:
                v101 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v108 = E_star * v101 / (3.141592653589793 * v11) if v101 > 0.0 else 0.0
            else:
                v108 = 0.0
            value = v95 - v108
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(h, s, E_star, dgamma, control):
    if h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and h > 1e-30 and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(h, s, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(h, s, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, h, s, E_star, dgamma):
    if d.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, h, s, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, h, s, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, h, s, E_star, dgamma):
    if F.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, h, s, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, h, s, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, h, s, E_star):
    if F.__class__ is h.__class__ is s.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, h, s, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, h, s, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'h', 's', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 2, 1, (), False),
        ('a', 'h', 's', 'E_star', 'dgamma'): (('a', 'h', 's', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 3, 1, (), False),
    },
}
