"""Programs of axicontact.cohesive.capped_paraboloid."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import capped_paraboloid as bodies

C0 = np.array(3.0)
C1 = np.array(2.0)
C2 = np.array(4.0)
RULE_0 = rule(((inf, 16),))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def cohesive_radius(a, R1, R2, b, E_star, dgamma, sigma_0):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, R1, R2, b, E_star, dgamma, sigma_0):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R1, R2, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R1, R2, b, E_star, dgamma, sigma_0):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, R1, R2, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v11 = 3.0 * R1
            v14 = a * a
            v15 = a * v14
            v35 = hypot(a, q)
            value = (4.0 * E_star / v11 * v15 if a < b else 2.0 * E_star / v11 * (2.0 * v15 + (R1 - R2) / R2 * (2.0 * v14 + b * b) * sqrt((a - b) * (a + b)))) - 2.0 * sigma_0 * (v35 * v35 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, R1, R2, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0):
    size = out.size
    np.multiply(C0, R1, out)
    np.square(a, t0)
    np.multiply(a, t0, t1)
    np.less(a, b, m0)
    some33 = np.count_nonzero(m0)
    if some33:
        np.multiply(C2, E_star, t2)
        np.divide(t2, out, t2)
        np.multiply(t2, t1, t2)
    if some33 != size:
        other33 = t3 if some33 else t2
        np.subtract(a, b, other33)
        np.add(a, b, t4)
        np.multiply(other33, t4, t4)
        np.sqrt(t4, t4)
        np.multiply(C1, E_star, other33)
        np.divide(other33, out, other33)
        np.multiply(C1, t1, t5)
        np.subtract(R1, R2, t6)
        np.divide(t6, R2, t6)
        np.multiply(C1, t0, t7)
        np.square(b, t8)
        np.add(t7, t8, t8)
        np.multiply(t6, t8, t8)
        np.multiply(t8, t4, t4)
        np.add(t5, t4, t4)
        np.multiply(other33, t4, other33)
        if some33:
            np.copyto(t2, other33, where=~m0)
    np.hypot(a, q, t1)
    np.multiply(C1, sigma_0, t0)
    np.multiply(t1, t1, t1)
    np.arctan2(q, a, out)
    np.multiply(t1, out, out)
    np.multiply(a, q, t1)
    np.add(out, t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(t2, t1, out)


def pressure(r, a, R1, R2, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, R1, R2, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30) and (sigma_0 > -1e+30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R1, R2, b, E_star, dgamma, sigma_0, control):
    if R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and R1 > -1e+30 and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30) and (sigma_0 > -1e+30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(R1, R2, b, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, R1, R2, b, E_star, dgamma, sigma_0):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30) and (sigma_0 > -1e+30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R1, R2, b, E_star, dgamma, sigma_0):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30) and (sigma_0 > -1e+30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R1, R2, b, E_star, dgamma, sigma_0):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30) and (sigma_0 > -1e+30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R1, R2, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, R1, R2, b, E_star, dgamma, sigma_0):
    if c.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v8 = hypot(0.0, c)
            v9 = atan2(c, 0.0)
            v10 = 0.0 < b
            v11 = b - 0.0
            v15 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * (b + 0.0))
            v16 = c - v15
            v20 = sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (c + v15))
            if v10:
                v25 = (atan2(v20 if v10 else c, b) if v10 else v9) if v8 > b else 0.0
                v27 = v25 if v25 < v9 or v25 != v25 else v9
            else:
                v27 = v9
            v28 = v9 - v27
            v42 = []
            for node, weight in RULE_0(v28 / 1.0):
                v30 = node * v28
                v31 = v27 + v30
                v33 = v8 * cos(v31)
                v40 = 2.0 * (v33 if v33 < b or v33 != v33 else b) / R1 * v31 * sin(v31)
                v42.append(weight * v40)
            v42 = fsum(v42) * v28
            v59 = 0.0 - b
            v63 = sqrt((v59 if v59 > 0.0 or v59 != v59 else 0.0) * (0.0 + b))
            v65 = v20 if v10 else hypot(v63, c)
            v66 = v65 if v10 else c
            v67 = v66 > 0.0
            if v67:
                v68 = v65 if v67 else b
                v69 = v66 if v67 else b
                v71 = asinh(b / v68)
                v75 = 1.5707963267948966 / v71
                v76 = atan2(v63, v69) / v71
                v77 = asinh(v75)
                v91 = asinh(atan2(v69, v63) / v71 * (v75 + v76) / (v75 * sqrt(1.0 + v76 * v76) + v76 * sqrt(1.0 + v75 * v75)))
                v93 = 2.0 * v71
                v105 = b * b
                v111 = R1 - R2
                v113 = R1 * R2
                v114 = 2.0 * v111 / v113
                v118 = b * b * v111
                v132 = []
                for node, weight in RULE_1(v91 / 1.0):
                    v92 = node * v91
                    v95 = 0.5 * v92
                    v100 = v93 * cosh(v77 - v95) * sinh(v95)
                    v102 = v68 * cos(v100)
                    v104 = v68 * sin(v100)
                    v108 = sqrt(v105 + v102 * v102)
                    v130 = (2.0 * v108 / R1 + v114 * v102 + v118 / (v113 * v102)) * v102 * v71 * cosh(v77 - v92) * atan2(v104, v108) * (v104 / v108)
                    v132.append(weight * v130)
                v132 = fsum(v132) * v91
                v166 = 0.6366197723675814 * v132
            else:
                v166 = 0.0
            v173 = sigma_0 / E_star
            v177 = 0.6366197723675814 * v8 * v42 + v166 - dgamma / sigma_0 - 1.2732395447351628 * v173 * c
            if v177 <= -(2.0 * v173 * c):
                value = v177
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R1, R2, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R1, R2, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, R1, R2, b, E_star, dgamma, sigma_0):
    if c.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v8 = hypot(0.0, c)
            v9 = atan2(c, 0.0)
            v10 = 0.0 < b
            v11 = b - 0.0
            v15 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * (b + 0.0))
            v16 = c - v15
            v20 = sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (c + v15))
            if v10:
                v25 = (atan2(v20 if v10 else c, b) if v10 else v9) if v8 > b else 0.0
                v27 = v25 if v25 < v9 or v25 != v25 else v9
            else:
                v27 = v9
            v28 = v9 - v27
            v42 = []
            for node, weight in RULE_0(v28 / 1.0):
                v30 = node * v28
                v31 = v27 + v30
                v33 = v8 * cos(v31)
                v40 = 2.0 * (v33 if v33 < b or v33 != v33 else b) / R1 * v31 * sin(v31)
                v42.append(weight * v40)
            v42 = fsum(v42) * v28
            v59 = 0.0 - b
            v63 = sqrt((v59 if v59 > 0.0 or v59 != v59 else 0.0) * (0.0 + b))
            v65 = v20 if v10 else hypot(v63, c)
            v66 = v65 if v10 else c
            v67 = v66 > 0.0
            if v67:
                v68 = v65 if v67 else b
                v69 = v66 if v67 else b
                v71 = asinh(b / v68)
                v75 = 1.5707963267948966 / v71
                v76 = atan2(v63, v69) / v71
                v77 = asinh(v75)
                v91 = asinh(atan2(v69, v63) / v71 * (v75 + v76) / (v75 * sqrt(1.0 + v76 * v76) + v76 * sqrt(1.0 + v75 * v75)))
                v93 = 2.0 * v71
                v105 = b * b
                v111 = R1 - R2
                v113 = R1 * R2
                v114 = 2.0 * v111 / v113
                v118 = b * b * v111
                v132 = []
                for node, weight in RULE_1(v91 / 1.0):
                    v92 = node * v91
                    v95 = 0.5 * v92
                    v100 = v93 * cosh(v77 - v95) * sinh(v95)
                    v102 = v68 * cos(v100)
                    v104 = v68 * sin(v100)
                    v108 = sqrt(v105 + v102 * v102)
                    v130 = (2.0 * v108 / R1 + v114 * v102 + v118 / (v113 * v102)) * v102 * v71 * cosh(v77 - v92) * atan2(v104, v108) * (v104 / v108)
                    v132.append(weight * v130)
                v132 = fsum(v132) * v91
                v166 = 0.6366197723675814 * v132
            else:
                v166 = 0.0
            v173 = sigma_0 / E_star
            if 0.6366197723675814 * v8 * v42 + v166 - dgamma / sigma_0 - 1.2732395447351628 * v173 * c <= -(2.0 * v173 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R1, R2, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R1, R2, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, R1, R2, b, E_star, sigma_0):
    if a.__class__ is c.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v7 = c - a
            v12 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (c + a))
            v13 = hypot(a, v12)
            v14 = atan2(v12, a)
            v15 = a < b
            v16 = b - a
            v20 = sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (b + a))
            v21 = v12 - v20
            v25 = sqrt((v21 if v21 > 0.0 or v21 != v21 else 0.0) * (v12 + v20))
            if v15:
                v30 = (atan2(v25 if v15 else v12, b) if v15 else v14) if v13 > b else 0.0
                v32 = v30 if v30 < v14 or v30 != v30 else v14
            else:
                v32 = v14
            v33 = v14 - v32
            v47 = []
            for node, weight in RULE_0(v33 / 1.0):
                v35 = node * v33
                v36 = v32 + v35
                v38 = v13 * cos(v36)
                v45 = 2.0 * (v38 if v38 < b or v38 != v38 else b) / R1 * v36 * sin(v36)
                v47.append(weight * v45)
            v47 = fsum(v47) * v33
            v64 = a - b
            v68 = sqrt((v64 if v64 > 0.0 or v64 != v64 else 0.0) * (a + b))
            v70 = v25 if v15 else hypot(v68, v12)
            v71 = v70 if v15 else v12
            v72 = v71 > 0.0
            if v72:
                v73 = v70 if v72 else b
                v74 = v71 if v72 else b
                v76 = asinh(b / v73)
                v80 = 1.5707963267948966 / v76
                v81 = atan2(v68, v74) / v76
                v82 = asinh(v80)
                v96 = asinh(atan2(v74, v68) / v76 * (v80 + v81) / (v80 * sqrt(1.0 + v81 * v81) + v81 * sqrt(1.0 + v80 * v80)))
                v98 = 2.0 * v76
                v110 = b * b
                v116 = R1 - R2
                v118 = R1 * R2
                v119 = 2.0 * v116 / v118
                v123 = b * b * v116
                v137 = []
                for node, weight in RULE_1(v96 / 1.0):
                    v97 = node * v96
                    v100 = 0.5 * v97
                    v105 = v98 * cosh(v82 - v100) * sinh(v100)
                    v107 = v73 * cos(v105)
                    v109 = v73 * sin(v105)
                    v113 = sqrt(v110 + v107 * v107)
                    v135 = (2.0 * v113 / R1 + v119 * v107 + v123 / (v118 * v107)) * v107 * v76 * cosh(v82 - v97) * atan2(v109, v113) * (v109 / v113)
                    v137.append(weight * v135)
                v137 = fsum(v137) * v96
                v171 = 0.6366197723675814 * v137
            else:
                v171 = 0.0
            value = sigma_0 * (0.6366197723675814 * v13 * v47 + v171 + 1.2732395447351628 * (sigma_0 / E_star) * v12 * (v14 - v12 / (v13 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R1, R2, b, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 9, 1, (), False),
    },
}
