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
RULE_0 = rule(((0.45, 8), (inf, 16)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


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
            if c == 0.0:
                v130 = 0.0
            else:
                v9 = hypot(0.0, c)
                v10 = atan2(c, 0.0)
                v11 = 0.0 < b
                v12 = b - 0.0
                v16 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (b + 0.0))
                v17 = c - v16
                v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (c + v16))
                if v11:
                    v26 = (atan2(v21 if v11 else c, b) if v11 else v10) if v9 > b else 0.0
                    v28 = v26 if v26 < v10 or v26 != v26 else v10
                else:
                    v28 = v10
                v29 = v10 - v28
                v44 = []
                for node, weight in RULE_0(v29 / 1.0):
                    v31 = node * v29
                    v32 = v28 + v31
                    v35 = abs(v9 * cos(v32))
                    v42 = 2.0 * (v35 if v35 < b or v35 != v35 else b) / R1 * v32 * sin(v32)
                    v44.append(weight * v42)
                v44 = fsum(v44) * v29
                v50 = 0.0 - b
                v54 = sqrt((v50 if v50 > 0.0 or v50 != v50 else 0.0) * (0.0 + b))
                v56 = v21 if v11 else hypot(v54, c)
                v57 = v56 if v11 else c
                v59 = v56 if v57 > 0.0 else b
                v61 = asinh(b / v59)
                v65 = 1.5707963267948966 / v61
                v66 = atan2(v54, v57) / v61
                v67 = asinh(v65)
                v81 = asinh(atan2(v57, v54) / v61 * (v65 + v66) / (v65 * sqrt(1.0 + v66 * v66) + v66 * sqrt(1.0 + v65 * v65)))
                v83 = 2.0 * v61
                v97 = b * b
                v103 = R1 - R2
                v105 = R1 * R2
                v106 = 2.0 * v103 / v105
                v110 = b * b * v103
                v124 = []
                for node, weight in RULE_1(v81 / 1.0):
                    v82 = node * v81
                    v85 = 0.5 * v82
                    v90 = v83 * cosh(v67 - v85) * sinh(v85)
                    v91 = cos(v90)
                    v94 = v59 * (v91 if v91 > 1e-17 or v91 != v91 else 1e-17)
                    v96 = v59 * sin(v90)
                    v100 = sqrt(v97 + v94 * v94)
                    v122 = (2.0 * v100 / R1 + v106 * v94 + v110 / (v105 * v94)) * v94 * v61 * cosh(v67 - v82) * atan2(v96, v100) * (v96 / v100)
                    v124.append(weight * v122)
                v124 = fsum(v124) * v81
                v130 = 0.6366197723675814 * v9 * v44 + 0.6366197723675814 * v124
            v133 = sigma_0 / E_star
            v137 = v130 - dgamma / sigma_0 - 1.2732395447351628 * v133 * c
            if v137 <= -(2.0 * v133 * c):
                value = v137
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
            if c == 0.0:
                v130 = 0.0
            else:
                v9 = hypot(0.0, c)
                v10 = atan2(c, 0.0)
                v11 = 0.0 < b
                v12 = b - 0.0
                v16 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (b + 0.0))
                v17 = c - v16
                v21 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (c + v16))
                if v11:
                    v26 = (atan2(v21 if v11 else c, b) if v11 else v10) if v9 > b else 0.0
                    v28 = v26 if v26 < v10 or v26 != v26 else v10
                else:
                    v28 = v10
                v29 = v10 - v28
                v44 = []
                for node, weight in RULE_0(v29 / 1.0):
                    v31 = node * v29
                    v32 = v28 + v31
                    v35 = abs(v9 * cos(v32))
                    v42 = 2.0 * (v35 if v35 < b or v35 != v35 else b) / R1 * v32 * sin(v32)
                    v44.append(weight * v42)
                v44 = fsum(v44) * v29
                v50 = 0.0 - b
                v54 = sqrt((v50 if v50 > 0.0 or v50 != v50 else 0.0) * (0.0 + b))
                v56 = v21 if v11 else hypot(v54, c)
                v57 = v56 if v11 else c
                v59 = v56 if v57 > 0.0 else b
                v61 = asinh(b / v59)
                v65 = 1.5707963267948966 / v61
                v66 = atan2(v54, v57) / v61
                v67 = asinh(v65)
                v81 = asinh(atan2(v57, v54) / v61 * (v65 + v66) / (v65 * sqrt(1.0 + v66 * v66) + v66 * sqrt(1.0 + v65 * v65)))
                v83 = 2.0 * v61
                v97 = b * b
                v103 = R1 - R2
                v105 = R1 * R2
                v106 = 2.0 * v103 / v105
                v110 = b * b * v103
                v124 = []
                for node, weight in RULE_1(v81 / 1.0):
                    v82 = node * v81
                    v85 = 0.5 * v82
                    v90 = v83 * cosh(v67 - v85) * sinh(v85)
                    v91 = cos(v90)
                    v94 = v59 * (v91 if v91 > 1e-17 or v91 != v91 else 1e-17)
                    v96 = v59 * sin(v90)
                    v100 = sqrt(v97 + v94 * v94)
                    v122 = (2.0 * v100 / R1 + v106 * v94 + v110 / (v105 * v94)) * v94 * v61 * cosh(v67 - v82) * atan2(v96, v100) * (v96 / v100)
                    v124.append(weight * v122)
                v124 = fsum(v124) * v81
                v130 = 0.6366197723675814 * v9 * v44 + 0.6366197723675814 * v124
            v133 = sigma_0 / E_star
            if v130 - dgamma / sigma_0 - 1.2732395447351628 * v133 * c <= -(2.0 * v133 * c):
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
            v48 = []
            for node, weight in RULE_0(v33 / 1.0):
                v35 = node * v33
                v36 = v32 + v35
                v39 = abs(v13 * cos(v36))
                v46 = 2.0 * (v39 if v39 < b or v39 != v39 else b) / R1 * v36 * sin(v36)
                v48.append(weight * v46)
            v48 = fsum(v48) * v33
            v54 = a - b
            v58 = sqrt((v54 if v54 > 0.0 or v54 != v54 else 0.0) * (a + b))
            v60 = v25 if v15 else hypot(v58, v12)
            v61 = v60 if v15 else v12
            v63 = v60 if v61 > 0.0 else b
            v65 = asinh(b / v63)
            v69 = 1.5707963267948966 / v65
            v70 = atan2(v58, v61) / v65
            v71 = asinh(v69)
            v85 = asinh(atan2(v61, v58) / v65 * (v69 + v70) / (v69 * sqrt(1.0 + v70 * v70) + v70 * sqrt(1.0 + v69 * v69)))
            v87 = 2.0 * v65
            v101 = b * b
            v107 = R1 - R2
            v109 = R1 * R2
            v110 = 2.0 * v107 / v109
            v114 = b * b * v107
            v128 = []
            for node, weight in RULE_1(v85 / 1.0):
                v86 = node * v85
                v89 = 0.5 * v86
                v94 = v87 * cosh(v71 - v89) * sinh(v89)
                v95 = cos(v94)
                v98 = v63 * (v95 if v95 > 1e-17 or v95 != v95 else 1e-17)
                v100 = v63 * sin(v94)
                v104 = sqrt(v101 + v98 * v98)
                v126 = (2.0 * v104 / R1 + v110 * v98 + v114 / (v109 * v98)) * v98 * v65 * cosh(v71 - v86) * atan2(v100, v104) * (v100 / v104)
                v128.append(weight * v126)
            v128 = fsum(v128) * v85
            value = sigma_0 * (0.6366197723675814 * v13 * v48 + 0.6366197723675814 * v128 + 1.2732395447351628 * (sigma_0 / E_star) * v12 * (v14 - v12 / (v13 + a)))
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
