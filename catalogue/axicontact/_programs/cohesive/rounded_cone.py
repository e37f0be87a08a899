"""Programs of axicontact.cohesive.rounded_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import rounded_cone as bodies

C0 = np.array(2.0)
C1 = np.array(4.0)
C2 = np.array(3.0)
RULE_0 = rule(((0.45, 8), (inf, 16)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


def cohesive_radius(a, theta, b, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, theta, b, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, theta, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, theta, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v9 = tan(theta)
            v15 = a * a
            if a < b:
                v37 = 4.0 * E_star * v9 / (3.0 * b) * (a * v15)
            else:
                v21 = sqrt((a - b) * (a + b))
                v37 = E_star * v9 * (v15 * atan(v21 / b) + 4.0 * b * v15 / (3.0 * (v21 + a)) + b / 3.0 * v21)
            v38 = hypot(a, q)
            value = v37 - 2.0 * sigma_0 * (v38 * v38 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, theta, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, m0):
    size = out.size
    np.tan(theta, out)
    np.square(a, t0)
    np.less(a, b, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.multiply(C1, E_star, t1)
        np.multiply(t1, out, t1)
        np.multiply(C2, b, t2)
        np.divide(t1, t2, t2)
        np.multiply(a, t0, t1)
        np.multiply(t2, t1, t1)
    if some36 != size:
        other36 = t2 if some36 else t1
        np.subtract(a, b, other36)
        np.add(a, b, t3)
        np.multiply(other36, t3, t3)
        np.sqrt(t3, t3)
        np.divide(t3, b, other36)
        np.arctan(other36, other36)
        np.multiply(E_star, out, t4)
        np.multiply(t0, other36, other36)
        np.multiply(C1, b, t5)
        np.multiply(t5, t0, t5)
        np.add(t3, a, t6)
        np.multiply(C2, t6, t6)
        np.divide(t5, t6, t6)
        np.add(other36, t6, t6)
        np.divide(b, C2, other36)
        np.multiply(other36, t3, t3)
        np.add(t6, t3, t3)
        np.multiply(t4, t3, other36)
        if some36:
            np.copyto(t1, other36, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(C0, sigma_0, out)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, t2)
    np.multiply(t0, t2, t2)
    np.multiply(a, q, t0)
    np.add(t2, t0, t0)
    np.multiply(out, t0, t0)
    np.subtract(t1, t0, out)


def pressure(r, a, theta, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, theta, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(theta, b, E_star, dgamma, sigma_0, control):
    if theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and theta > 1e-30 and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(theta, b, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, theta, b, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, theta, b, E_star, dgamma, sigma_0):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star, dgamma, sigma_0):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, theta, b, E_star, dgamma, sigma_0):
    if c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v125 = 0.0
            else:
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
                v36 = tan(theta)
                v39 = 2.0 * v36 / b
                v45 = []
                for node, weight in RULE_0(v28 / 1.0):
                    v30 = node * v28
                    v31 = v27 + v30
                    v34 = abs(v8 * cos(v31))
                    v43 = v39 * (v34 if v34 < b or v34 != v34 else b) * v31 * sin(v31)
                    v45.append(weight * v43)
                v45 = fsum(v45) * v28
                v51 = 0.0 - b
                v55 = sqrt((v51 if v51 > 0.0 or v51 != v51 else 0.0) * (0.0 + b))
                v57 = v20 if v10 else hypot(v55, c)
                v58 = v57 if v10 else c
                v60 = v57 if v58 > 0.0 else b
                v62 = asinh(b / v60)
                v66 = 1.5707963267948966 / v62
                v67 = atan2(v55, v58) / v62
                v68 = asinh(v66)
                v82 = asinh(atan2(v58, v55) / v62 * (v66 + v67) / (v66 * sqrt(1.0 + v67 * v67) + v67 * sqrt(1.0 + v66 * v66)))
                v84 = 2.0 * v62
                v98 = b * b
                v104 = 2.0 * b
                v119 = []
                for node, weight in RULE_1(v82 / 1.0):
                    v83 = node * v82
                    v86 = 0.5 * v83
                    v91 = v84 * cosh(v68 - v86) * sinh(v86)
                    v92 = cos(v91)
                    v95 = v60 * (v92 if v92 > 1e-17 or v92 != v92 else 1e-17)
                    v97 = v60 * sin(v91)
                    v101 = sqrt(v98 + v95 * v95)
                    v117 = v36 * (atan(v95 / b) + v104 / (v95 + v101)) * v95 * v62 * cosh(v68 - v83) * atan2(v97, v101) * (v97 / v101)
                    v119.append(weight * v117)
                v119 = fsum(v119) * v82
                v125 = 0.6366197723675814 * v8 * v45 + 0.6366197723675814 * v119
            v128 = sigma_0 / E_star
            v132 = v125 - dgamma / sigma_0 - 1.2732395447351628 * v128 * c
            if v132 <= -(2.0 * v128 * c):
                value = v132
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, theta, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, theta, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, theta, b, E_star, dgamma, sigma_0):
    if c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v125 = 0.0
            else:
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
                v36 = tan(theta)
                v39 = 2.0 * v36 / b
                v45 = []
                for node, weight in RULE_0(v28 / 1.0):
                    v30 = node * v28
                    v31 = v27 + v30
                    v34 = abs(v8 * cos(v31))
                    v43 = v39 * (v34 if v34 < b or v34 != v34 else b) * v31 * sin(v31)
                    v45.append(weight * v43)
                v45 = fsum(v45) * v28
                v51 = 0.0 - b
                v55 = sqrt((v51 if v51 > 0.0 or v51 != v51 else 0.0) * (0.0 + b))
                v57 = v20 if v10 else hypot(v55, c)
                v58 = v57 if v10 else c
                v60 = v57 if v58 > 0.0 else b
                v62 = asinh(b / v60)
                v66 = 1.5707963267948966 / v62
                v67 = atan2(v55, v58) / v62
                v68 = asinh(v66)
                v82 = asinh(atan2(v58, v55) / v62 * (v66 + v67) / (v66 * sqrt(1.0 + v67 * v67) + v67 * sqrt(1.0 + v66 * v66)))
                v84 = 2.0 * v62
                v98 = b * b
                v104 = 2.0 * b
                v119 = []
                for node, weight in RULE_1(v82 / 1.0):
                    v83 = node * v82
                    v86 = 0.5 * v83
                    v91 = v84 * cosh(v68 - v86) * sinh(v86)
                    v92 = cos(v91)
                    v95 = v60 * (v92 if v92 > 1e-17 or v92 != v92 else 1e-17)
                    v97 = v60 * sin(v91)
                    v101 = sqrt(v98 + v95 * v95)
                    v117 = v36 * (atan(v95 / b) + v104 / (v95 + v101)) * v95 * v62 * cosh(v68 - v83) * atan2(v97, v101) * (v97 / v101)
                    v119.append(weight * v117)
                v119 = fsum(v119) * v82
                v125 = 0.6366197723675814 * v8 * v45 + 0.6366197723675814 * v119
            v128 = sigma_0 / E_star
            if v125 - dgamma / sigma_0 - 1.2732395447351628 * v128 * c <= -(2.0 * v128 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, theta, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, theta, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, theta, b, E_star, sigma_0):
    if a.__class__ is c.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = c - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (c + a))
            v12 = hypot(a, v11)
            v13 = atan2(v11, a)
            v14 = a < b
            v15 = b - a
            v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (b + a))
            v20 = v11 - v19
            v24 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (v11 + v19))
            if v14:
                v29 = (atan2(v24 if v14 else v11, b) if v14 else v13) if v12 > b else 0.0
                v31 = v29 if v29 < v13 or v29 != v29 else v13
            else:
                v31 = v13
            v32 = v13 - v31
            v40 = tan(theta)
            v43 = 2.0 * v40 / b
            v49 = []
            for node, weight in RULE_0(v32 / 1.0):
                v34 = node * v32
                v35 = v31 + v34
                v38 = abs(v12 * cos(v35))
                v47 = v43 * (v38 if v38 < b or v38 != v38 else b) * v35 * sin(v35)
                v49.append(weight * v47)
            v49 = fsum(v49) * v32
            v55 = a - b
            v59 = sqrt((v55 if v55 > 0.0 or v55 != v55 else 0.0) * (a + b))
            v61 = v24 if v14 else hypot(v59, v11)
            v62 = v61 if v14 else v11
            v64 = v61 if v62 > 0.0 else b
            v66 = asinh(b / v64)
            v70 = 1.5707963267948966 / v66
            v71 = atan2(v59, v62) / v66
            v72 = asinh(v70)
            v86 = asinh(atan2(v62, v59) / v66 * (v70 + v71) / (v70 * sqrt(1.0 + v71 * v71) + v71 * sqrt(1.0 + v70 * v70)))
            v88 = 2.0 * v66
            v102 = b * b
            v108 = 2.0 * b
            v123 = []
            for node, weight in RULE_1(v86 / 1.0):
                v87 = node * v86
                v90 = 0.5 * v87
                v95 = v88 * cosh(v72 - v90) * sinh(v90)
                v96 = cos(v95)
                v99 = v64 * (v96 if v96 > 1e-17 or v96 != v96 else 1e-17)
                v101 = v64 * sin(v95)
                v105 = sqrt(v102 + v99 * v99)
                v121 = v40 * (atan(v99 / b) + v108 / (v99 + v105)) * v99 * v66 * cosh(v72 - v87) * atan2(v101, v105) * (v101 / v105)
                v123.append(weight * v121)
            v123 = fsum(v123) * v86
            value = sigma_0 * (0.6366197723675814 * v12 * v49 + 0.6366197723675814 * v123 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 7, 1, (), False),
    },
}
