"""Programs of axicontact.cohesive.rounded_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import rounded_punch as bodies

C0 = np.array(0.0)
C1 = np.array(2.0)
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
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


def cohesive_radius(a, R, b, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, R, b, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, b, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, R, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if a < b:
                v67 = 0.0
            else:
                v8 = a - b
                v10 = v8 * (a + b)
                v11 = sqrt(v10)
                v16 = v8 / b
                if v16 < 0.42:
                    v59 = v16 * sqrt(v16) * ((((((0.0005288491342179178 * v16 + 0.038096760299703034) * v16 + 0.4065213849117787) * v16 + 1.438682033198726) * v16 + 1.9979042349620892) * v16 + 0.9428090415820634) / (((((0.006421883194715949 * v16 + 0.15001504718401248) * v16 + 0.9450913324352289) * v16 + 2.37401087025821) * v16 + 2.569097449054519) * v16 + 1.0))
                else:
                    v19 = v11 / b
                    v59 = v19 - atan(v19)
                v67 = E_star / R * (b * (a * a) * v59 + v10 * v11 / 3.0)
            v68 = hypot(a, q)
            value = v67 - 2.0 * sigma_0 * (v68 * v68 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, R, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    some66 = np.count_nonzero(m0)
    if some66:
        np.copyto(out, C0)
    if some66 != size:
        other66 = t0 if some66 else out
        np.subtract(a, b, other66)
        np.add(a, b, t1)
        np.multiply(other66, t1, t1)
        np.sqrt(t1, t2)
        np.divide(E_star, R, t3)
        np.square(a, t4)
        np.multiply(b, t4, t4)
        np.divide(other66, b, other66)
        np.less(other66, C2, m1)
        some58 = np.count_nonzero(m1)
        if some58:
            np.minimum(other66, f0, out=t5)
            np.sqrt(t5, t6)
            np.multiply(t5, t6, t6)
            np.multiply(C3, t5, t7)
            np.add(t7, C4, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C5, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C6, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C7, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C8, t7)
            np.multiply(C9, t5, t8)
            np.add(t8, C10, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C11, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C12, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C13, t8)
            np.multiply(t8, t5, t5)
            np.add(t5, C14, t5)
            np.divide(t7, t5, t5)
            np.multiply(t6, t5, t5)
        if some58 != size:
            other58 = t6 if some58 else t5
            np.divide(t2, b, other58)
            np.arctan(other58, t7)
            np.subtract(other58, t7, other58)
            if some58:
                np.copyto(t5, other58, where=~m1)
        np.multiply(t4, t5, t5)
        np.multiply(t1, t2, t2)
        np.divide(t2, C15, t2)
        np.add(t5, t2, t2)
        np.multiply(t3, t2, other66)
        if some66:
            np.copyto(out, other66, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(C1, sigma_0, t2)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, t3)
    np.multiply(t0, t3, t3)
    np.multiply(a, q, t0)
    np.add(t3, t0, t0)
    np.multiply(t2, t0, t0)
    np.subtract(out, t0, out)


def pressure(r, a, R, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, R, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R, b, E_star, dgamma, sigma_0, control):
    if R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and R > 1e-30 and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(R, b, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, R, b, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, b, E_star, dgamma, sigma_0):
    if d.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, b, E_star, dgamma, sigma_0):
    if F.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, R, b, E_star, dgamma, sigma_0):
    if c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v94 = 0.0
            else:
                v9 = 0.0 - b
                v13 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (0.0 + b))
                v19 = 0.0 < b
                if v19:
                    v14 = b - 0.0
                    v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (b + 0.0))
                    v20 = c - v18
                    v26 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (c + v18))
                else:
                    v26 = hypot(v13, c)
                v27 = v26 if v19 else c
                v29 = v26 if v27 > 0.0 else b
                v31 = asinh(b / v29)
                v35 = 1.5707963267948966 / v31
                v36 = atan2(v13, v27) / v31
                v37 = asinh(v35)
                v52 = asinh(atan2(v27, v13) / v31 * (v35 + v36) / (v35 * sqrt(1.0 + v36 * v36) + v36 * sqrt(1.0 + v35 * v35)))
                v55 = 2.0 * v31
                v69 = b * b
                v76 = b / R
                v89 = []
                for node, weight in RULE_0(v52 / 1.0):
                    v53 = node * v52
                    v57 = 0.5 * v53
                    v62 = v55 * cosh(v37 - v57) * sinh(v57)
                    v63 = cos(v62)
                    v66 = v29 * (v63 if v63 > 1e-17 or v63 != v63 else 1e-17)
                    v68 = v29 * sin(v62)
                    v72 = sqrt(v69 + v66 * v66)
                    v87 = (2.0 * v66 / R - v76 * atan2(v66, b)) * v66 * v31 * cosh(v37 - v53) * atan2(v68, v72) * (v68 / v72)
                    v89.append(weight * v87)
                v89 = fsum(v89) * v52
                v94 = 0.6366197723675814 * v89
            v97 = sigma_0 / E_star
            v101 = v94 - dgamma / sigma_0 - 1.2732395447351628 * v97 * c
            if v101 <= -(2.0 * v97 * c):
                value = v101
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, R, b, E_star, dgamma, sigma_0):
    if c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v94 = 0.0
            else:
                v9 = 0.0 - b
                v13 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (0.0 + b))
                v19 = 0.0 < b
                if v19:
                    v14 = b - 0.0
                    v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (b + 0.0))
                    v20 = c - v18
                    v26 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (c + v18))
                else:
                    v26 = hypot(v13, c)
                v27 = v26 if v19 else c
                v29 = v26 if v27 > 0.0 else b
                v31 = asinh(b / v29)
                v35 = 1.5707963267948966 / v31
                v36 = atan2(v13, v27) / v31
                v37 = asinh(v35)
                v52 = asinh(atan2(v27, v13) / v31 * (v35 + v36) / (v35 * sqrt(1.0 + v36 * v36) + v36 * sqrt(1.0 + v35 * v35)))
                v55 = 2.0 * v31
                v69 = b * b
                v76 = b / R
                v89 = []
                for node, weight in RULE_0(v52 / 1.0):
                    v53 = node * v52
                    v57 = 0.5 * v53
                    v62 = v55 * cosh(v37 - v57) * sinh(v57)
                    v63 = cos(v62)
                    v66 = v29 * (v63 if v63 > 1e-17 or v63 != v63 else 1e-17)
                    v68 = v29 * sin(v62)
                    v72 = sqrt(v69 + v66 * v66)
                    v87 = (2.0 * v66 / R - v76 * atan2(v66, b)) * v66 * v31 * cosh(v37 - v53) * atan2(v68, v72) * (v68 / v72)
                    v89.append(weight * v87)
                v89 = fsum(v89) * v52
                v94 = 0.6366197723675814 * v89
            v97 = sigma_0 / E_star
            if v94 - dgamma / sigma_0 - 1.2732395447351628 * v97 * c <= -(2.0 * v97 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, R, b, E_star, sigma_0):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = c - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (c + a))
            v13 = a - b
            v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (a + b))
            v23 = a < b
            if v23:
                v18 = b - a
                v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (b + a))
                v24 = v11 - v22
                v30 = sqrt((v24 if v24 > 0.0 or v24 != v24 else 0.0) * (v11 + v22))
            else:
                v30 = hypot(v17, v11)
            v31 = v30 if v23 else v11
            v33 = v30 if v31 > 0.0 else b
            v35 = asinh(b / v33)
            v39 = 1.5707963267948966 / v35
            v40 = atan2(v17, v31) / v35
            v41 = asinh(v39)
            v56 = asinh(atan2(v31, v17) / v35 * (v39 + v40) / (v39 * sqrt(1.0 + v40 * v40) + v40 * sqrt(1.0 + v39 * v39)))
            v59 = 2.0 * v35
            v73 = b * b
            v80 = b / R
            v93 = []
            for node, weight in RULE_0(v56 / 1.0):
                v57 = node * v56
                v61 = 0.5 * v57
                v66 = v59 * cosh(v41 - v61) * sinh(v61)
                v67 = cos(v66)
                v70 = v33 * (v67 if v67 > 1e-17 or v67 != v67 else 1e-17)
                v72 = v33 * sin(v66)
                v76 = sqrt(v73 + v70 * v70)
                v91 = (2.0 * v70 / R - v80 * atan2(v70, b)) * v70 * v35 * cosh(v41 - v57) * atan2(v72, v76) * (v72 / v76)
                v93.append(weight * v91)
            v93 = fsum(v93) * v56
            value = sigma_0 * (0.6366197723675814 * v93 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (atan2(v11, a) - v11 / (hypot(a, v11) + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'R', 'b', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'R', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'R', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 9, 2, (0.42,), False),
    },
}
