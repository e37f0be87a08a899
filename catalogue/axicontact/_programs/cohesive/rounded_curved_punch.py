"""Programs of axicontact.cohesive.rounded_curved_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import rounded_curved_punch as bodies

C0 = np.array(3.0)
C1 = np.array(2.0)
C2 = np.array(4.0)
C3 = np.array(0.42)
C4 = np.array(0.0005288491342179178)
C5 = np.array(0.038096760299703034)
C6 = np.array(0.4065213849117787)
C7 = np.array(1.438682033198726)
C8 = np.array(1.9979042349620892)
C9 = np.array(0.9428090415820634)
C10 = np.array(0.006421883194715949)
C11 = np.array(0.15001504718401248)
C12 = np.array(0.9450913324352289)
C13 = np.array(2.37401087025821)
C14 = np.array(2.569097449054519)
C15 = np.array(1.0)
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


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, R1, R2, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.multiply(C0, R1, out)
    np.square(a, t0)
    np.multiply(a, t0, t1)
    np.less(a, b, m0)
    some76 = np.count_nonzero(m0)
    if some76:
        np.multiply(C2, E_star, t2)
        np.divide(t2, out, t2)
        np.multiply(t2, t1, t2)
    if some76 != size:
        other76 = t3 if some76 else t2
        np.subtract(a, b, other76)
        np.add(a, b, t4)
        np.multiply(other76, t4, t4)
        np.sqrt(t4, t5)
        np.multiply(C2, t1, t6)
        np.divide(t6, out, t6)
        np.divide(b, R2, t7)
        np.multiply(t7, t0, t7)
        np.divide(other76, b, other76)
        np.less(other76, C3, m1)
        some67 = np.count_nonzero(m1)
        if some67:
            np.minimum(other76, f0, out=t8)
            np.sqrt(t8, t9)
            np.multiply(t8, t9, t9)
            np.multiply(C4, t8, t10)
            np.add(t10, C5, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C6, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C7, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C8, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C9, t10)
            np.multiply(C10, t8, t11)
            np.add(t11, C11, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C12, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C13, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C14, t11)
            np.multiply(t11, t8, t8)
            np.add(t8, C15, t8)
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
        np.multiply(C0, R2, t4)
        np.divide(t5, t4, t4)
        np.add(t8, t4, t4)
        np.multiply(E_star, t4, other76)
        if some76:
            np.copyto(t2, other76, where=~m0)
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
    if a.__class__ is q.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
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
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
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
            if c == 0.0:
                v126 = 0.0
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
                v107 = b / R2
                v120 = []
                for node, weight in RULE_1(v81 / 1.0):
                    v82 = node * v81
                    v85 = 0.5 * v82
                    v90 = v83 * cosh(v67 - v85) * sinh(v85)
                    v91 = cos(v90)
                    v94 = v59 * (v91 if v91 > 1e-17 or v91 != v91 else 1e-17)
                    v96 = v59 * sin(v90)
                    v100 = sqrt(v97 + v94 * v94)
                    v118 = (2.0 * v100 / R1 + 2.0 * v94 / R2 - v107 * atan2(v94, b)) * v94 * v61 * cosh(v67 - v82) * atan2(v96, v100) * (v96 / v100)
                    v120.append(weight * v118)
                v120 = fsum(v120) * v81
                v126 = 0.6366197723675814 * v9 * v44 + 0.6366197723675814 * v120
            v129 = sigma_0 / E_star
            v133 = v126 - dgamma / sigma_0 - 1.2732395447351628 * v129 * c
            if v133 <= -(2.0 * v129 * c):
                value = v133
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
                v126 = 0.0
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
                v107 = b / R2
                v120 = []
                for node, weight in RULE_1(v81 / 1.0):
                    v82 = node * v81
                    v85 = 0.5 * v82
                    v90 = v83 * cosh(v67 - v85) * sinh(v85)
                    v91 = cos(v90)
                    v94 = v59 * (v91 if v91 > 1e-17 or v91 != v91 else 1e-17)
                    v96 = v59 * sin(v90)
                    v100 = sqrt(v97 + v94 * v94)
                    v118 = (2.0 * v100 / R1 + 2.0 * v94 / R2 - v107 * atan2(v94, b)) * v94 * v61 * cosh(v67 - v82) * atan2(v96, v100) * (v96 / v100)
                    v120.append(weight * v118)
                v120 = fsum(v120) * v81
                v126 = 0.6366197723675814 * v9 * v44 + 0.6366197723675814 * v120
            v129 = sigma_0 / E_star
            if v126 - dgamma / sigma_0 - 1.2732395447351628 * v129 * c <= -(2.0 * v129 * c):
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
            v111 = b / R2
            v124 = []
            for node, weight in RULE_1(v85 / 1.0):
                v86 = node * v85
                v89 = 0.5 * v86
                v94 = v87 * cosh(v71 - v89) * sinh(v89)
                v95 = cos(v94)
                v98 = v63 * (v95 if v95 > 1e-17 or v95 != v95 else 1e-17)
                v100 = v63 * sin(v94)
                v104 = sqrt(v101 + v98 * v98)
                v122 = (2.0 * v104 / R1 + 2.0 * v98 / R2 - v111 * atan2(v98, b)) * v98 * v65 * cosh(v71 - v86) * atan2(v100, v104) * (v100 / v104)
                v124.append(weight * v122)
            v124 = fsum(v124) * v85
            value = sigma_0 * (0.6366197723675814 * v13 * v48 + 0.6366197723675814 * v124 + 1.2732395447351628 * (sigma_0 / E_star) * v12 * (v14 - v12 / (v13 + a)))
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
        ('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'R1', 'R2', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 12, 2, (0.42,), False),
    },
}
