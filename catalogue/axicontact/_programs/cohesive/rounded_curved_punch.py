"""Programs of axicontact.cohesive.rounded_curved_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import rounded_curved_punch as bodies

C0 = np.array(2.0)
C1 = np.array(4.0)
C2 = np.array(0.42)
C3 = np.array(0.0005288491342179178)
C4 = np.array(0.038096760299703034)
C5 = np.array(0.4065213849117787)
C6 = np.array(1.438682033198726)
C7 = np.array(1.9979042349620892)
C8 = np.array(0.9428090415820634)
C9 = np.array(0.006421883194715949)
C10 = np.array(0.15001504718401248)
C11 = np.array(0.9450913324352289)
C12 = np.array(2.37401087025821)
C13 = np.array(2.569097449054519)
C14 = np.array(1.0)
C15 = np.array(3.0)
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
            if a < b:
                v77 = 4.0 * E_star / v11 * v15
            else:
                v17 = a - b
                v19 = v17 * (a + b)
                v20 = sqrt(v19)
                v25 = v17 / b
                if v25 < 0.42:
                    v68 = v25 * sqrt(v25) * ((((((0.0005288491342179178 * v25 + 0.038096760299703034) * v25 + 0.4065213849117787) * v25 + 1.438682033198726) * v25 + 1.9979042349620892) * v25 + 0.9428090415820634) / (((((0.006421883194715949 * v25 + 0.15001504718401248) * v25 + 0.9450913324352289) * v25 + 2.37401087025821) * v25 + 2.569097449054519) * v25 + 1.0))
                else:
                    v28 = v20 / b
                    v68 = v28 - atan(v28)
                v77 = E_star * (4.0 * v15 / v11 + b / R2 * v14 * v68 + v19 * v20 / (3.0 * R2))
            v78 = hypot(a, q)
            value = v77 - 2.0 * sigma_0 * (v78 * v78 * atan2(q, a) + a * q)
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
    v22 = b / R2
    v71 = (3.0) * R2
    v78 = (2.0) * sigma_0
    return (q, b, E_star, v10, v11, v22, v71, v78)


def block_force_of_a(out, a, q, b, E_star, v10, v11, v22, v71, v78, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, m0, m1, f0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, t0)
    np.less(a, b, m0)
    some76 = np.count_nonzero(m0)
    if some76:
        np.multiply(v11, t0, t1)
    if some76 != size:
        other76 = t2 if some76 else t1
        np.subtract(a, b, other76)
        np.add(a, b, t3)
        np.multiply(other76, t3, t3)
        np.sqrt(t3, t4)
        np.multiply(C1, t0, t5)
        np.divide(t5, v10, t5)
        np.multiply(v22, out, t6)
        np.divide(other76, b, other76)
        np.less(other76, C2, m1)
        some67 = np.count_nonzero(m1)
        if some67:
            np.minimum(other76, f0, out=t7)
            np.sqrt(t7, t8)
            np.multiply(t7, t8, t8)
            np.multiply(C3, t7, t9)
            np.add(t9, C4, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C5, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C6, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C7, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C8, t9)
            np.multiply(C9, t7, t10)
            np.add(t10, C10, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C11, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C12, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C13, t10)
            np.multiply(t10, t7, t7)
            np.add(t7, C14, t7)
            np.divide(t9, t7, t7)
            np.multiply(t8, t7, t7)
        if some67 != size:
            other67 = t8 if some67 else t7
            np.divide(t4, b, other67)
            np.arctan(other67, t9)
            np.subtract(other67, t9, other67)
            if some67:
                np.copyto(t7, other67, where=~m1)
        np.multiply(t6, t7, t7)
        np.add(t5, t7, t7)
        np.multiply(t3, t4, t4)
        np.divide(t4, v71, t4)
        np.add(t7, t4, t4)
        np.multiply(E_star, t4, other76)
        if some76:
            np.copyto(t1, other76, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, out)
    np.multiply(t0, out, out)
    np.multiply(a, q, t0)
    np.add(out, t0, t0)
    np.multiply(v78, t0, t0)
    np.subtract(t1, t0, out)


def prepare_force_of_a_q(R1, R2, b, E_star, dgamma, sigma_0):
    v8 = (4.0) * E_star
    v10 = (3.0) * R1
    v11 = v8 / v10
    v22 = b / R2
    v71 = (3.0) * R2
    v78 = (2.0) * sigma_0
    return (b, E_star, v10, v11, v22, v71, v78)


def block_force_of_a_q(out, a, q, b, E_star, v10, v11, v22, v71, v78, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, m0, m1, f0):
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
    some76 = np.count_nonzero(m0)
    if some76:
        np.multiply(v11, t0, t1)
    if some76 != size:
        other76 = t2 if some76 else t1
        np.subtract(a, b, other76)
        np.add(a, b, t3)
        np.multiply(other76, t3, t3)
        np.sqrt(t3, t4)
        np.multiply(C1, t0, t5)
        np.divide(t5, v10, t5)
        np.multiply(v22, out, t6)
        np.divide(other76, b, other76)
        np.less(other76, C2, m1)
        some67 = np.count_nonzero(m1)
        if some67:
            np.minimum(other76, f0, out=t7)
            np.sqrt(t7, t8)
            np.multiply(t7, t8, t8)
            np.multiply(C3, t7, t9)
            np.add(t9, C4, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C5, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C6, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C7, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C8, t9)
            np.multiply(C9, t7, t10)
            np.add(t10, C10, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C11, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C12, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C13, t10)
            np.multiply(t10, t7, t7)
            np.add(t7, C14, t7)
            np.divide(t9, t7, t7)
            np.multiply(t8, t7, t7)
        if some67 != size:
            other67 = t8 if some67 else t7
            np.divide(t4, b, other67)
            np.arctan(other67, t9)
            np.subtract(other67, t9, other67)
            if some67:
                np.copyto(t7, other67, where=~m1)
        np.multiply(t6, t7, t7)
        np.add(t5, t7, t7)
        np.multiply(t3, t4, t4)
        np.divide(t4, v71, t4)
        np.add(t7, t4, t4)
        np.multiply(E_star, t4, other76)
        if some76:
            np.copyto(t1, other76, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, out)
    np.multiply(t0, out, out)
    np.multiply(a, q, t0)
    np.add(out, t0, t0)
    np.multiply(v78, t0, t0)
    np.subtract(t1, t0, out)


def prepare_force_of_all():
    return ()


def block_force_of_all(out, a, q, R1, R2, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.multiply(C15, R1, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_q = largest(q)
    if largest_q == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.multiply(a, t0, t1)
    np.less(a, b, m0)
    some76 = np.count_nonzero(m0)
    if some76:
        np.multiply(C1, E_star, t2)
        np.divide(t2, out, t2)
        np.multiply(t2, t1, t2)
    if some76 != size:
        other76 = t3 if some76 else t2
        np.subtract(a, b, other76)
        np.add(a, b, t4)
        np.multiply(other76, t4, t4)
        np.sqrt(t4, t5)
        np.multiply(C1, t1, t6)
        np.divide(t6, out, t6)
        np.divide(b, R2, t7)
        np.multiply(t7, t0, t7)
        np.divide(other76, b, other76)
        np.less(other76, C2, m1)
        some67 = np.count_nonzero(m1)
        if some67:
            np.minimum(other76, f0, out=t8)
            np.sqrt(t8, t9)
            np.multiply(t8, t9, t9)
            np.multiply(C3, t8, t10)
            np.add(t10, C4, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C5, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C6, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C7, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C8, t10)
            np.multiply(C9, t8, t11)
            np.add(t11, C10, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C11, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C12, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C13, t11)
            np.multiply(t11, t8, t8)
            np.add(t8, C14, t8)
            np.divide(t10, t8, t8)
            np.multiply(t9, t8, t8)
        if some67 != size:
            other67 = t9 if some67 else t8
            np.divide(t5, b, other67)
            np.arctan(other67, t10)
            np.subtract(other67, t10, other67)
            if some67:
                np.copyto(t8, other67, where=~m1)
        np.multiply(t7, t8, t8)
        np.add(t6, t8, t8)
        np.multiply(t4, t5, t5)
        np.multiply(C15, R2, t4)
        np.divide(t5, t4, t4)
        np.add(t8, t4, t4)
        np.multiply(E_star, t4, other76)
        if some76:
            np.copyto(t2, other76, where=~m0)
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
    if R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and R1 > 1e-30 and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
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
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
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
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
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
                v113 = b / R2
                v126 = []
                for node, weight in RULE_1(v89 / 1.0):
                    v90 = node * v89
                    v93 = 0.5 * v90
                    v98 = v91 * cosh(v75 - v93) * sinh(v93)
                    v100 = v66 * cos(v98)
                    v102 = v66 * sin(v98)
                    v106 = sqrt(v103 + v100 * v100)
                    v124 = (2.0 * v106 / R1 + 2.0 * v100 / R2 - v113 * atan2(v100, b)) * v100 * v69 * cosh(v75 - v90) * atan2(v102, v106) * (v102 / v106)
                    v126.append(weight * v124)
                v126 = fsum(v126) * v89
                v161 = 0.6366197723675814 * v126
            else:
                v161 = 0.0
            v168 = sigma_0 / E_star
            v172 = 0.6366197723675814 * v8 * v41 + v161 - dgamma / sigma_0 - 1.2732395447351628 * v168 * c
            if v172 <= -(2.0 * v168 * c):
                value = v172
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
                v113 = b / R2
                v126 = []
                for node, weight in RULE_1(v89 / 1.0):
                    v90 = node * v89
                    v93 = 0.5 * v90
                    v98 = v91 * cosh(v75 - v93) * sinh(v93)
                    v100 = v66 * cos(v98)
                    v102 = v66 * sin(v98)
                    v106 = sqrt(v103 + v100 * v100)
                    v124 = (2.0 * v106 / R1 + 2.0 * v100 / R2 - v113 * atan2(v100, b)) * v100 * v69 * cosh(v75 - v90) * atan2(v102, v106) * (v102 / v106)
                    v126.append(weight * v124)
                v126 = fsum(v126) * v89
                v161 = 0.6366197723675814 * v126
            else:
                v161 = 0.0
            v168 = sigma_0 / E_star
            if 0.6366197723675814 * v8 * v41 + v161 - dgamma / sigma_0 - 1.2732395447351628 * v168 * c <= -(2.0 * v168 * c):
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
                v118 = b / R2
                v131 = []
                for node, weight in RULE_1(v94 / 1.0):
                    v95 = node * v94
                    v98 = 0.5 * v95
                    v103 = v96 * cosh(v80 - v98) * sinh(v98)
                    v105 = v71 * cos(v103)
                    v107 = v71 * sin(v103)
                    v111 = sqrt(v108 + v105 * v105)
                    v129 = (2.0 * v111 / R1 + 2.0 * v105 / R2 - v118 * atan2(v105, b)) * v105 * v74 * cosh(v80 - v95) * atan2(v107, v111) * (v107 / v111)
                    v131.append(weight * v129)
                v131 = fsum(v131) * v94
                v166 = 0.6366197723675814 * v131
            else:
                v166 = 0.0
            value = sigma_0 * (0.6366197723675814 * v13 * v46 + v166 + 1.2732395447351628 * (sigma_0 / E_star) * v12 * (v14 - v12 / (v13 + a)))
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
        ('a',): (('a',), prepare_force_of_a, block_force_of_a, 11, 2, (0.42,), False),
        ('a', 'q'): (('a', 'q'), prepare_force_of_a_q, block_force_of_a_q, 11, 2, (0.42,), False),
        ('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all, block_force_of_all, 12, 2, (0.42,), False),
    },
}
