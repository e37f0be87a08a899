"""Programs of axicontact.cohesive.gaussian."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, nan, sin, sqrt

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import gaussian as bodies

RULE_0 = rule(((inf, 32),))
RULE_1 = rule(((0.5, 16), (inf, 32)))


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


def force_of(a, q, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if a <= 1.5019752682686114 * s:
                v13 = 2.0 * h / s
                v77 = []
                for node, weight in RULE_0(a / 1.0):
                    v10 = node * a
                    v11 = v10 / s
                    v14 = v11 * v11
                    v52 = ((((((((((((1.567077144036674e-13 * v14 + -3.840375691006307e-12) * v14 + 3.8015754128174666e-11) * v14 + -1.8423006918213799e-10) * v14 + 4.472469827763728e-10) * v14 + -1.1927516362741588e-09) * v14 + 6.225892246861416e-09) * v14 + 3.4413148480148793e-09) * v14 + -9.933344851449817e-08) * v14 + -5.127541706569233e-07) * v14 + 1.8119768160503268e-06) * v14 + 2.151585040783394e-05) * v14 + 4.61098799999374e-06) * v14
                    v69 = v11 / ((((((v52 + -0.000684089638073553) * v14 + -0.002257495580553435) * v14 + 0.016931216930225715) * v14 + 0.17777777777782838) * v14 + 0.6666666666666656) * v14 + 1.0)
                    v76 = v10 * (v13 * (v69 + (1.0 - 2.0 * v69 * v11) * v11))
                    v77.append(weight * v76)
                v77 = fsum(v77) * a
                v83 = 2.0 * E_star * v77
            else:
                v83 = nan
            v84 = hypot(a, q)
            value = v83 - 2.0 * sigma_0 * (v84 * v84 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, q, h, s, E_star, dgamma, sigma_0):
                return value
            return None
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


def pull_off_depth(a, q, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, h, s, E_star, dgamma, sigma_0):
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


def pull_off_zone(a, h, s, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is s.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, h, s, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, h, s, E_star, dgamma, sigma_0):
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
            if c == 0.0:
                v91 = 0.0
            else:
                v8 = hypot(0.0, c)
                v9 = atan2(c, 0.0)
                v18 = 2.0 * h / s
                v85 = []
                for node, weight in RULE_1(v9 / 1.0):
                    v11 = node * v9
                    v12 = 0.0 + v11
                    v15 = v8 * cos(v12) / s
                    v19 = v15 * v15
                    v57 = ((((((((((((1.567077144036674e-13 * v19 + -3.840375691006307e-12) * v19 + 3.8015754128174666e-11) * v19 + -1.8423006918213799e-10) * v19 + 4.472469827763728e-10) * v19 + -1.1927516362741588e-09) * v19 + 6.225892246861416e-09) * v19 + 3.4413148480148793e-09) * v19 + -9.933344851449817e-08) * v19 + -5.127541706569233e-07) * v19 + 1.8119768160503268e-06) * v19 + 2.151585040783394e-05) * v19 + 4.61098799999374e-06) * v19
                    v74 = v15 / ((((((v57 + -0.000684089638073553) * v19 + -0.002257495580553435) * v19 + 0.016931216930225715) * v19 + 0.17777777777782838) * v19 + 0.6666666666666656) * v19 + 1.0)
                    v83 = v18 * (v74 + (1.0 - 2.0 * v74 * v15) * v15) * v12 * sin(v12)
                    v85.append(weight * v83)
                v85 = fsum(v85) * v9
                v91 = 0.6366197723675814 * v8 * v85
            v94 = sigma_0 / E_star
            v98 = v91 - dgamma / sigma_0 - 1.2732395447351628 * v94 * c
            if v98 <= -(2.0 * v94 * c):
                value = v98
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
            if c == 0.0:
                v91 = 0.0
            else:
                v8 = hypot(0.0, c)
                v9 = atan2(c, 0.0)
                v18 = 2.0 * h / s
                v85 = []
                for node, weight in RULE_1(v9 / 1.0):
                    v11 = node * v9
                    v12 = 0.0 + v11
                    v15 = v8 * cos(v12) / s
                    v19 = v15 * v15
                    v57 = ((((((((((((1.567077144036674e-13 * v19 + -3.840375691006307e-12) * v19 + 3.8015754128174666e-11) * v19 + -1.8423006918213799e-10) * v19 + 4.472469827763728e-10) * v19 + -1.1927516362741588e-09) * v19 + 6.225892246861416e-09) * v19 + 3.4413148480148793e-09) * v19 + -9.933344851449817e-08) * v19 + -5.127541706569233e-07) * v19 + 1.8119768160503268e-06) * v19 + 2.151585040783394e-05) * v19 + 4.61098799999374e-06) * v19
                    v74 = v15 / ((((((v57 + -0.000684089638073553) * v19 + -0.002257495580553435) * v19 + 0.016931216930225715) * v19 + 0.17777777777782838) * v19 + 0.6666666666666656) * v19 + 1.0)
                    v83 = v18 * (v74 + (1.0 - 2.0 * v74 * v15) * v15) * v12 * sin(v12)
                    v85.append(weight * v83)
                v85 = fsum(v85) * v9
                v91 = 0.6366197723675814 * v8 * v85
            v94 = sigma_0 / E_star
            if v91 - dgamma / sigma_0 - 1.2732395447351628 * v94 * c <= -(2.0 * v94 * c):
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
            v22 = 2.0 * h / s
            v89 = []
            for node, weight in RULE_1(v13 / 1.0):
                v15 = node * v13
                v16 = 0.0 + v15
                v19 = v12 * cos(v16) / s
                v23 = v19 * v19
                v61 = ((((((((((((1.567077144036674e-13 * v23 + -3.840375691006307e-12) * v23 + 3.8015754128174666e-11) * v23 + -1.8423006918213799e-10) * v23 + 4.472469827763728e-10) * v23 + -1.1927516362741588e-09) * v23 + 6.225892246861416e-09) * v23 + 3.4413148480148793e-09) * v23 + -9.933344851449817e-08) * v23 + -5.127541706569233e-07) * v23 + 1.8119768160503268e-06) * v23 + 2.151585040783394e-05) * v23 + 4.61098799999374e-06) * v23
                v78 = v19 / ((((((v61 + -0.000684089638073553) * v23 + -0.002257495580553435) * v23 + 0.016931216930225715) * v23 + 0.17777777777782838) * v23 + 0.6666666666666656) * v23 + 1.0)
                v87 = v22 * (v78 + (1.0 - 2.0 * v78 * v19) * v19) * v16 * sin(v16)
                v89.append(weight * v87)
            v89 = fsum(v89) * v13
            value = sigma_0 * (0.6366197723675814 * v12 * v89 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, s, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
