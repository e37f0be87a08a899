"""Programs of axicontact.cohesive.gaussian."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, nan, sin, sqrt

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import gaussian as bodies

RULE_0 = rule(((inf, 32),))


def cohesive_radius(a, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, h, s, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, h, s, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_force(a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(h, s, E_star, dgamma, sigma_0, control):
    if h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and h > 1e-30 and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(h, s, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, h, s, E_star, dgamma, sigma_0):
    if d.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, h, s, E_star, dgamma, sigma_0):
    if F.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, h, s, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, h, s, E_star, dgamma, sigma_0):
    if c.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v7 = hypot(0.0, c)
            v8 = atan2(c, 0.0)
            v16 = 2.0 * h / s
            v83 = []
            for node, weight in RULE_0(v8 / 1.0):
                v10 = node * v8
                v13 = v7 * cos(v10) / s
                v17 = v13 * v13
                v55 = ((((((((((((1.567077144036674e-13 * v17 + -3.840375691006307e-12) * v17 + 3.8015754128174666e-11) * v17 + -1.8423006918213799e-10) * v17 + 4.472469827763728e-10) * v17 + -1.1927516362741588e-09) * v17 + 6.225892246861416e-09) * v17 + 3.4413148480148793e-09) * v17 + -9.933344851449817e-08) * v17 + -5.127541706569233e-07) * v17 + 1.8119768160503268e-06) * v17 + 2.151585040783394e-05) * v17 + 4.61098799999374e-06) * v17
                v72 = v13 / ((((((v55 + -0.000684089638073553) * v17 + -0.002257495580553435) * v17 + 0.016931216930225715) * v17 + 0.17777777777782838) * v17 + 0.6666666666666656) * v17 + 1.0)
                v81 = v16 * (v72 + (1.0 - 2.0 * v72 * v13) * v13) * v10 * sin(v10)
                v83.append(weight * v81)
            v83 = fsum(v83) * v8
            v143 = sigma_0 / E_star
            v147 = 0.6366197723675814 * v7 * v83 - dgamma / sigma_0 - 1.2732395447351628 * v143 * c
            if v147 <= -(2.0 * v143 * c):
                value = v147
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, h, s, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, h, s, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, h, s, E_star, dgamma, sigma_0):
    if c.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v7 = hypot(0.0, c)
            v8 = atan2(c, 0.0)
            v16 = 2.0 * h / s
            v83 = []
            for node, weight in RULE_0(v8 / 1.0):
                v10 = node * v8
                v13 = v7 * cos(v10) / s
                v17 = v13 * v13
                v55 = ((((((((((((1.567077144036674e-13 * v17 + -3.840375691006307e-12) * v17 + 3.8015754128174666e-11) * v17 + -1.8423006918213799e-10) * v17 + 4.472469827763728e-10) * v17 + -1.1927516362741588e-09) * v17 + 6.225892246861416e-09) * v17 + 3.4413148480148793e-09) * v17 + -9.933344851449817e-08) * v17 + -5.127541706569233e-07) * v17 + 1.8119768160503268e-06) * v17 + 2.151585040783394e-05) * v17 + 4.61098799999374e-06) * v17
                v72 = v13 / ((((((v55 + -0.000684089638073553) * v17 + -0.002257495580553435) * v17 + 0.016931216930225715) * v17 + 0.17777777777782838) * v17 + 0.6666666666666656) * v17 + 1.0)
                v81 = v16 * (v72 + (1.0 - 2.0 * v72 * v13) * v13) * v10 * sin(v10)
                v83.append(weight * v81)
            v83 = fsum(v83) * v8
            v143 = sigma_0 / E_star
            if 0.6366197723675814 * v7 * v83 - dgamma / sigma_0 - 1.2732395447351628 * v143 * c <= -(2.0 * v143 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, h, s, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, h, s, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, h, s, E_star, sigma_0):
    if a.__class__ is c.__class__ is h.__class__ is s.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = c - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (c + a))
            v12 = hypot(a, v11)
            v13 = atan2(v11, a)
            v21 = 2.0 * h / s
            v88 = []
            for node, weight in RULE_0(v13 / 1.0):
                v15 = node * v13
                v18 = v12 * cos(v15) / s
                v22 = v18 * v18
                v60 = ((((((((((((1.567077144036674e-13 * v22 + -3.840375691006307e-12) * v22 + 3.8015754128174666e-11) * v22 + -1.8423006918213799e-10) * v22 + 4.472469827763728e-10) * v22 + -1.1927516362741588e-09) * v22 + 6.225892246861416e-09) * v22 + 3.4413148480148793e-09) * v22 + -9.933344851449817e-08) * v22 + -5.127541706569233e-07) * v22 + 1.8119768160503268e-06) * v22 + 2.151585040783394e-05) * v22 + 4.61098799999374e-06) * v22
                v77 = v18 / ((((((v60 + -0.000684089638073553) * v22 + -0.002257495580553435) * v22 + 0.016931216930225715) * v22 + 0.17777777777782838) * v22 + 0.6666666666666656) * v22 + 1.0)
                v86 = v21 * (v77 + (1.0 - 2.0 * v77 * v18) * v18) * v15 * sin(v15)
                v88.append(weight * v86)
            v88 = fsum(v88) * v13
            value = sigma_0 * (0.6366197723675814 * v12 * v88 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, s, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
