"""Programs of axicontact.cohesive.capped_paraboloid."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import capped_paraboloid as bodies

C0 = np.array(2.0)
C1 = np.array(3.0)
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


def prepare_force_of_a(q, R1, R2, b, E_star, dgamma, sigma_0):
    v8 = (4.0) * E_star
    v10 = (3.0) * R1
    v11 = v8 / v10
    v20 = (2.0) * E_star
    v21 = v20 / v10
    v23 = R1 - R2
    v24 = v23 / R2
    v26 = np.square(b)
    v35 = (2.0) * sigma_0
    return (q, b, v11, v21, v24, v26, v35)


def block_force_of_a(out, a, q, b, v11, v21, v24, v26, v35, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, t0)
    np.less(a, b, m0)
    some33 = np.count_nonzero(m0)
    if some33:
        np.multiply(v11, t0, t1)
    if some33 != size:
        other33 = t2 if some33 else t1
        np.subtract(a, b, other33)
        np.add(a, b, t3)
        np.multiply(other33, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(C0, t0, other33)
        np.multiply(C0, out, t4)
        np.add(t4, v26, t4)
        np.multiply(v24, t4, t4)
        np.multiply(t4, t3, t3)
        np.add(other33, t3, t3)
        np.multiply(v21, t3, other33)
        if some33:
            np.copyto(t1, other33, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, out)
    np.multiply(t0, out, out)
    np.multiply(a, q, t0)
    np.add(out, t0, t0)
    np.multiply(v35, t0, t0)
    np.subtract(t1, t0, out)


def prepare_force_of_a_q(R1, R2, b, E_star, dgamma, sigma_0):
    v8 = (4.0) * E_star
    v10 = (3.0) * R1
    v11 = v8 / v10
    v20 = (2.0) * E_star
    v21 = v20 / v10
    v23 = R1 - R2
    v24 = v23 / R2
    v26 = np.square(b)
    v35 = (2.0) * sigma_0
    return (b, v11, v21, v24, v26, v35)


def block_force_of_a_q(out, a, q, b, v11, v21, v24, v26, v35, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_q = largest(q)
    if largest_q == np.inf:
        raise FloatingPointError
    np.multiply(a, out, t0)
    np.less(a, b, m0)
    some33 = np.count_nonzero(m0)
    if some33:
        np.multiply(v11, t0, t1)
    if some33 != size:
        other33 = t2 if some33 else t1
        np.subtract(a, b, other33)
        np.add(a, b, t3)
        np.multiply(other33, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(C0, t0, other33)
        np.multiply(C0, out, t4)
        np.add(t4, v26, t4)
        np.multiply(v24, t4, t4)
        np.multiply(t4, t3, t3)
        np.add(other33, t3, t3)
        np.multiply(v21, t3, other33)
        if some33:
            np.copyto(t1, other33, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, out)
    np.multiply(t0, out, out)
    np.multiply(a, q, t0)
    np.add(out, t0, t0)
    np.multiply(v35, t0, t0)
    np.subtract(t1, t0, out)


def prepare_force_of_all():
    return ()


def block_force_of_all(out, a, q, R1, R2, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0):
    size = out.size
    np.multiply(C1, R1, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_q = largest(q)
    if largest_q == np.inf:
        raise FloatingPointError
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
        np.multiply(C0, E_star, other33)
        np.divide(other33, out, other33)
        np.multiply(C0, t1, t5)
        np.subtract(R1, R2, t6)
        np.divide(t6, R2, t6)
        np.multiply(C0, t0, t7)
        np.square(b, t8)
        np.add(t7, t8, t8)
        np.multiply(t6, t8, t8)
        np.multiply(t8, t4, t4)
        np.add(t5, t4, t4)
        np.multiply(other33, t4, other33)
        if some33:
            np.copyto(t2, other33, where=~m0)
    np.hypot(a, q, t1)
    np.multiply(C0, sigma_0, t0)
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
    if a.__class__ is q.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, q, R1, R2, b, E_star, dgamma, sigma_0):
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
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, R1, R2, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, E_star, dgamma, sigma_0):
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
            v41 = []
            for node, weight in RULE_0(v28 / 1.0):
                v30 = node * v28
                v31 = v27 + v30
                v39 = 2.0 * (v8 * cos(v31)) / R1 * v31 * sin(v31)
                v41.append(weight * v39)
            v41 = fsum(v41) * v28
            v57 = 0.0 - b
            v61 = sqrt((v57 if v57 > 0.0 or v57 != v57 else 0.0) * (0.0 + b))
            v63 = v20 if v10 else hypot(v61, c)
            v64 = v63 if v10 else c
            v65 = v64 > 0.0
            if v65:
                v66 = v63 if v65 else b
                v67 = v64 if v65 else b
                v69 = asinh(b / v66)
                v73 = 1.5707963267948966 / v69
                v74 = atan2(v61, v67) / v69
                v75 = asinh(v73)
                v89 = asinh(atan2(v67, v61) / v69 * (v73 + v74) / (v73 * sqrt(1.0 + v74 * v74) + v74 * sqrt(1.0 + v73 * v73)))
                v91 = 2.0 * v69
                v103 = b * b
                v109 = R1 - R2
                v111 = R1 * R2
                v112 = 2.0 * v109 / v111
                v116 = b * b * v109
                v130 = []
                for node, weight in RULE_1(v89 / 1.0):
                    v90 = node * v89
                    v93 = 0.5 * v90
                    v98 = v91 * cosh(v75 - v93) * sinh(v93)
                    v100 = v66 * cos(v98)
                    v102 = v66 * sin(v98)
                    v106 = sqrt(v103 + v100 * v100)
                    v128 = (2.0 * v106 / R1 + v112 * v100 + v116 / (v111 * v100)) * v100 * v69 * cosh(v75 - v90) * atan2(v102, v106) * (v102 / v106)
                    v130.append(weight * v128)
                v130 = fsum(v130) * v89
                v164 = 0.6366197723675814 * v130
            else:
                v164 = 0.0
            v171 = sigma_0 / E_star
            v175 = 0.6366197723675814 * v8 * v41 + v164 - dgamma / sigma_0 - 1.2732395447351628 * v171 * c
            if v175 <= -(2.0 * v171 * c):
                value = v175
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
            v41 = []
            for node, weight in RULE_0(v28 / 1.0):
                v30 = node * v28
                v31 = v27 + v30
                v39 = 2.0 * (v8 * cos(v31)) / R1 * v31 * sin(v31)
                v41.append(weight * v39)
            v41 = fsum(v41) * v28
            v57 = 0.0 - b
            v61 = sqrt((v57 if v57 > 0.0 or v57 != v57 else 0.0) * (0.0 + b))
            v63 = v20 if v10 else hypot(v61, c)
            v64 = v63 if v10 else c
            v65 = v64 > 0.0
            if v65:
                v66 = v63 if v65 else b
                v67 = v64 if v65 else b
                v69 = asinh(b / v66)
                v73 = 1.5707963267948966 / v69
                v74 = atan2(v61, v67) / v69
                v75 = asinh(v73)
                v89 = asinh(atan2(v67, v61) / v69 * (v73 + v74) / (v73 * sqrt(1.0 + v74 * v74) + v74 * sqrt(1.0 + v73 * v73)))
                v91 = 2.0 * v69
                v103 = b * b
                v109 = R1 - R2
                v111 = R1 * R2
                v112 = 2.0 * v109 / v111
                v116 = b * b * v109
                v130 = []
                for node, weight in RULE_1(v89 / 1.0):
                    v90 = node * v89
                    v93 = 0.5 * v90
                    v98 = v91 * cosh(v75 - v93) * sinh(v93)
                    v100 = v66 * cos(v98)
                    v102 = v66 * sin(v98)
                    v106 = sqrt(v103 + v100 * v100)
                    v128 = (2.0 * v106 / R1 + v112 * v100 + v116 / (v111 * v100)) * v100 * v69 * cosh(v75 - v90) * atan2(v102, v106) * (v102 / v106)
                    v130.append(weight * v128)
                v130 = fsum(v130) * v89
                v164 = 0.6366197723675814 * v130
            else:
                v164 = 0.0
            v171 = sigma_0 / E_star
            if 0.6366197723675814 * v8 * v41 + v164 - dgamma / sigma_0 - 1.2732395447351628 * v171 * c <= -(2.0 * v171 * c):
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
            v46 = []
            for node, weight in RULE_0(v33 / 1.0):
                v35 = node * v33
                v36 = v32 + v35
                v44 = 2.0 * (v13 * cos(v36)) / R1 * v36 * sin(v36)
                v46.append(weight * v44)
            v46 = fsum(v46) * v33
            v62 = a - b
            v66 = sqrt((v62 if v62 > 0.0 or v62 != v62 else 0.0) * (a + b))
            v68 = v25 if v15 else hypot(v66, v12)
            v69 = v68 if v15 else v12
            v70 = v69 > 0.0
            if v70:
                v71 = v68 if v70 else b
                v72 = v69 if v70 else b
                v74 = asinh(b / v71)
                v78 = 1.5707963267948966 / v74
                v79 = atan2(v66, v72) / v74
                v80 = asinh(v78)
                v94 = asinh(atan2(v72, v66) / v74 * (v78 + v79) / (v78 * sqrt(1.0 + v79 * v79) + v79 * sqrt(1.0 + v78 * v78)))
                v96 = 2.0 * v74
                v108 = b * b
                v114 = R1 - R2
                v116 = R1 * R2
                v117 = 2.0 * v114 / v116
                v121 = b * b * v114
                v135 = []
                for node, weight in RULE_1(v94 / 1.0):
                    v95 = node * v94
                    v98 = 0.5 * v95
                    v103 = v96 * cosh(v80 - v98) * sinh(v98)
                    v105 = v71 * cos(v103)
                    v107 = v71 * sin(v103)
                    v111 = sqrt(v108 + v105 * v105)
                    v133 = (2.0 * v111 / R1 + v117 * v105 + v121 / (v116 * v105)) * v105 * v74 * cosh(v80 - v95) * atan2(v107, v111) * (v107 / v111)
                    v135.append(weight * v133)
                v135 = fsum(v135) * v94
                v169 = 0.6366197723675814 * v135
            else:
                v169 = 0.0
            value = sigma_0 * (0.6366197723675814 * v13 * v46 + v169 + 1.2732395447351628 * (sigma_0 / E_star) * v12 * (v14 - v12 / (v13 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R1, R2, b, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 2, 'a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'): {
        ('a',): (('a',), prepare_force_of_a, block_force_of_a, 5, 1, (), False),
        ('a', 'q'): (('a', 'q'), prepare_force_of_a_q, block_force_of_a_q, 5, 1, (), False),
        ('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all, block_force_of_all, 9, 1, (), False),
    },
}
