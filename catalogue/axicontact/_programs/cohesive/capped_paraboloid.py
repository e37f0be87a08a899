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
            v43 = []
            for node, weight in RULE_0(v28 / 1.0):
                v30 = node * v28
                v31 = v27 + v30
                v34 = abs(v8 * cos(v31))
                v41 = 2.0 * (v34 if v34 < b or v34 != v34 else b) / R1 * v31 * sin(v31)
                v43.append(weight * v41)
            v43 = fsum(v43) * v28
            v49 = 0.0 - b
            v53 = sqrt((v49 if v49 > 0.0 or v49 != v49 else 0.0) * (0.0 + b))
            v55 = v20 if v10 else hypot(v53, c)
            v56 = v55 if v10 else c
            v58 = v55 if v56 > 0.0 else b
            v60 = asinh(b / v58)
            v64 = 1.5707963267948966 / v60
            v65 = atan2(v53, v56) / v60
            v66 = asinh(v64)
            v80 = asinh(atan2(v56, v53) / v60 * (v64 + v65) / (v64 * sqrt(1.0 + v65 * v65) + v65 * sqrt(1.0 + v64 * v64)))
            v82 = 2.0 * v60
            v96 = b * b
            v102 = R1 - R2
            v104 = R1 * R2
            v105 = 2.0 * v102 / v104
            v109 = b * b * v102
            v123 = []
            for node, weight in RULE_1(v80 / 1.0):
                v81 = node * v80
                v84 = 0.5 * v81
                v89 = v82 * cosh(v66 - v84) * sinh(v84)
                v90 = cos(v89)
                v93 = v58 * (v90 if v90 > 1e-17 or v90 != v90 else 1e-17)
                v95 = v58 * sin(v89)
                v99 = sqrt(v96 + v93 * v93)
                v121 = (2.0 * v99 / R1 + v105 * v93 + v109 / (v104 * v93)) * v93 * v60 * cosh(v66 - v81) * atan2(v95, v99) * (v95 / v99)
                v123.append(weight * v121)
            v123 = fsum(v123) * v80
            v131 = sigma_0 / E_star
            v135 = 0.6366197723675814 * v8 * v43 + 0.6366197723675814 * v123 - dgamma / sigma_0 - 1.2732395447351628 * v131 * c
            if v135 <= -(2.0 * v131 * c):
                value = v135
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
            v43 = []
            for node, weight in RULE_0(v28 / 1.0):
                v30 = node * v28
                v31 = v27 + v30
                v34 = abs(v8 * cos(v31))
                v41 = 2.0 * (v34 if v34 < b or v34 != v34 else b) / R1 * v31 * sin(v31)
                v43.append(weight * v41)
            v43 = fsum(v43) * v28
            v49 = 0.0 - b
            v53 = sqrt((v49 if v49 > 0.0 or v49 != v49 else 0.0) * (0.0 + b))
            v55 = v20 if v10 else hypot(v53, c)
            v56 = v55 if v10 else c
            v58 = v55 if v56 > 0.0 else b
            v60 = asinh(b / v58)
            v64 = 1.5707963267948966 / v60
            v65 = atan2(v53, v56) / v60
            v66 = asinh(v64)
            v80 = asinh(atan2(v56, v53) / v60 * (v64 + v65) / (v64 * sqrt(1.0 + v65 * v65) + v65 * sqrt(1.0 + v64 * v64)))
            v82 = 2.0 * v60
            v96 = b * b
            v102 = R1 - R2
            v104 = R1 * R2
            v105 = 2.0 * v102 / v104
            v109 = b * b * v102
            v123 = []
            for node, weight in RULE_1(v80 / 1.0):
                v81 = node * v80
                v84 = 0.5 * v81
                v89 = v82 * cosh(v66 - v84) * sinh(v84)
                v90 = cos(v89)
                v93 = v58 * (v90 if v90 > 1e-17 or v90 != v90 else 1e-17)
                v95 = v58 * sin(v89)
                v99 = sqrt(v96 + v93 * v93)
                v121 = (2.0 * v99 / R1 + v105 * v93 + v109 / (v104 * v93)) * v93 * v60 * cosh(v66 - v81) * atan2(v95, v99) * (v95 / v99)
                v123.append(weight * v121)
            v123 = fsum(v123) * v80
            v131 = sigma_0 / E_star
            if 0.6366197723675814 * v8 * v43 + 0.6366197723675814 * v123 - dgamma / sigma_0 - 1.2732395447351628 * v131 * c <= -(2.0 * v131 * c):
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
