"""Programs of axicontact.cohesive.rounded_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import rounded_cone as bodies

C0 = np.array(2.0)
C1 = np.array(3.0)
C2 = np.array(4.0)
RULE_0 = rule(((inf, 16),))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


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


def prepare_force_of_a(q, theta, b, E_star, dgamma, sigma_0):
    v7 = (4.0) * E_star
    v8 = np.tan(theta)
    v9 = v7 * v8
    v11 = (3.0) * b
    v12 = v9 / v11
    v23 = E_star * v8
    v25 = (4.0) * b
    v31 = b / (3.0)
    v38 = (2.0) * sigma_0
    return (q, b, v12, v23, v25, v31, v38)


def block_force_of_a(out, a, q, b, v12, v23, v25, v31, v38, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.multiply(a, out, t0)
        np.multiply(v12, t0, t0)
    if some36 != size:
        other36 = t1 if some36 else t0
        np.subtract(a, b, other36)
        np.add(a, b, t2)
        np.multiply(other36, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other36)
        np.arctan(other36, other36)
        np.multiply(out, other36, other36)
        np.multiply(v25, out, t3)
        np.add(t2, a, t4)
        np.multiply(C1, t4, t4)
        np.divide(t3, t4, t4)
        np.add(other36, t4, t4)
        np.multiply(v31, t2, t2)
        np.add(t4, t2, t2)
        np.multiply(v23, t2, other36)
        if some36:
            np.copyto(t0, other36, where=~m0)
    np.hypot(a, q, out)
    np.multiply(out, out, out)
    np.arctan2(q, a, t1)
    np.multiply(out, t1, t1)
    np.multiply(a, q, out)
    np.add(t1, out, out)
    np.multiply(v38, out, out)
    np.subtract(t0, out, out)


def prepare_force_of_a_q(theta, b, E_star, dgamma, sigma_0):
    v7 = (4.0) * E_star
    v8 = np.tan(theta)
    v9 = v7 * v8
    v11 = (3.0) * b
    v12 = v9 / v11
    v23 = E_star * v8
    v25 = (4.0) * b
    v31 = b / (3.0)
    v38 = (2.0) * sigma_0
    return (b, v12, v23, v25, v31, v38)


def block_force_of_a_q(out, a, q, b, v12, v23, v25, v31, v38, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_q = largest(q)
    if largest_q == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.multiply(a, out, t0)
        np.multiply(v12, t0, t0)
    if some36 != size:
        other36 = t1 if some36 else t0
        np.subtract(a, b, other36)
        np.add(a, b, t2)
        np.multiply(other36, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other36)
        np.arctan(other36, other36)
        np.multiply(out, other36, other36)
        np.multiply(v25, out, t3)
        np.add(t2, a, t4)
        np.multiply(C1, t4, t4)
        np.divide(t3, t4, t4)
        np.add(other36, t4, t4)
        np.multiply(v31, t2, t2)
        np.add(t4, t2, t2)
        np.multiply(v23, t2, other36)
        if some36:
            np.copyto(t0, other36, where=~m0)
    np.hypot(a, q, out)
    np.multiply(out, out, out)
    np.arctan2(q, a, t1)
    np.multiply(out, t1, t1)
    np.multiply(a, q, out)
    np.add(t1, out, out)
    np.multiply(v38, out, out)
    np.subtract(t0, out, out)


def prepare_force_of_all():
    return ()


def block_force_of_all(out, a, q, theta, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, m0):
    size = out.size
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_q = largest(q)
    if largest_q == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.less(a, b, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.multiply(C2, E_star, t1)
        np.multiply(t1, out, t1)
        np.multiply(C1, b, t2)
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
        np.multiply(C2, b, t5)
        np.multiply(t5, t0, t5)
        np.add(t3, a, t6)
        np.multiply(C1, t6, t6)
        np.divide(t5, t6, t6)
        np.add(other36, t6, t6)
        np.divide(b, C1, other36)
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
    if a.__class__ is q.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, q, theta, b, E_star, dgamma, sigma_0):
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
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, theta, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, b, E_star, dgamma, sigma_0):
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
            v7 = hypot(0.0, c)
            v8 = atan2(c, 0.0)
            v9 = 0.0 < b
            v10 = b - 0.0
            v14 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (b + 0.0))
            v15 = c - v14
            v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (c + v14))
            if v9:
                v24 = (atan2(v19 if v9 else c, b) if v9 else v8) if v7 > b else 0.0
                v26 = v24 if v24 < v8 or v24 != v24 else v8
            else:
                v26 = v8
            v27 = v8 - v26
            v33 = tan(theta)
            v36 = 2.0 * v33 / b
            v42 = []
            for node, weight in RULE_0(v27 / 1.0):
                v29 = node * v27
                v30 = v26 + v29
                v40 = v36 * (v7 * cos(v30)) * v30 * sin(v30)
                v42.append(weight * v40)
            v42 = fsum(v42) * v27
            v57 = 0.0 - b
            v61 = sqrt((v57 if v57 > 0.0 or v57 != v57 else 0.0) * (0.0 + b))
            v63 = v19 if v9 else hypot(v61, c)
            v64 = v63 if v9 else c
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
                v109 = 2.0 * b
                v124 = []
                for node, weight in RULE_1(v89 / 1.0):
                    v90 = node * v89
                    v93 = 0.5 * v90
                    v98 = v91 * cosh(v75 - v93) * sinh(v93)
                    v100 = v66 * cos(v98)
                    v102 = v66 * sin(v98)
                    v106 = sqrt(v103 + v100 * v100)
                    v122 = v33 * (atan(v100 / b) + v109 / (v100 + v106)) * v100 * v69 * cosh(v75 - v90) * atan2(v102, v106) * (v102 / v106)
                    v124.append(weight * v122)
                v124 = fsum(v124) * v89
                v157 = 0.6366197723675814 * v124
            else:
                v157 = 0.0
            v164 = sigma_0 / E_star
            v168 = 0.6366197723675814 * v7 * v42 + v157 - dgamma / sigma_0 - 1.2732395447351628 * v164 * c
            if v168 <= -(2.0 * v164 * c):
                value = v168
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
            v7 = hypot(0.0, c)
            v8 = atan2(c, 0.0)
            v9 = 0.0 < b
            v10 = b - 0.0
            v14 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (b + 0.0))
            v15 = c - v14
            v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (c + v14))
            if v9:
                v24 = (atan2(v19 if v9 else c, b) if v9 else v8) if v7 > b else 0.0
                v26 = v24 if v24 < v8 or v24 != v24 else v8
            else:
                v26 = v8
            v27 = v8 - v26
            v33 = tan(theta)
            v36 = 2.0 * v33 / b
            v42 = []
            for node, weight in RULE_0(v27 / 1.0):
                v29 = node * v27
                v30 = v26 + v29
                v40 = v36 * (v7 * cos(v30)) * v30 * sin(v30)
                v42.append(weight * v40)
            v42 = fsum(v42) * v27
            v57 = 0.0 - b
            v61 = sqrt((v57 if v57 > 0.0 or v57 != v57 else 0.0) * (0.0 + b))
            v63 = v19 if v9 else hypot(v61, c)
            v64 = v63 if v9 else c
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
                v109 = 2.0 * b
                v124 = []
                for node, weight in RULE_1(v89 / 1.0):
                    v90 = node * v89
                    v93 = 0.5 * v90
                    v98 = v91 * cosh(v75 - v93) * sinh(v93)
                    v100 = v66 * cos(v98)
                    v102 = v66 * sin(v98)
                    v106 = sqrt(v103 + v100 * v100)
                    v122 = v33 * (atan(v100 / b) + v109 / (v100 + v106)) * v100 * v69 * cosh(v75 - v90) * atan2(v102, v106) * (v102 / v106)
                    v124.append(weight * v122)
                v124 = fsum(v124) * v89
                v157 = 0.6366197723675814 * v124
            else:
                v157 = 0.0
            v164 = sigma_0 / E_star
            if 0.6366197723675814 * v7 * v42 + v157 - dgamma / sigma_0 - 1.2732395447351628 * v164 * c <= -(2.0 * v164 * c):
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
            v38 = tan(theta)
            v41 = 2.0 * v38 / b
            v47 = []
            for node, weight in RULE_0(v32 / 1.0):
                v34 = node * v32
                v35 = v31 + v34
                v45 = v41 * (v12 * cos(v35)) * v35 * sin(v35)
                v47.append(weight * v45)
            v47 = fsum(v47) * v32
            v62 = a - b
            v66 = sqrt((v62 if v62 > 0.0 or v62 != v62 else 0.0) * (a + b))
            v68 = v24 if v14 else hypot(v66, v11)
            v69 = v68 if v14 else v11
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
                v114 = 2.0 * b
                v129 = []
                for node, weight in RULE_1(v94 / 1.0):
                    v95 = node * v94
                    v98 = 0.5 * v95
                    v103 = v96 * cosh(v80 - v98) * sinh(v98)
                    v105 = v71 * cos(v103)
                    v107 = v71 * sin(v103)
                    v111 = sqrt(v108 + v105 * v105)
                    v127 = v38 * (atan(v105 / b) + v114 / (v105 + v111)) * v105 * v74 * cosh(v80 - v95) * atan2(v107, v111) * (v107 / v111)
                    v129.append(weight * v127)
                v129 = fsum(v129) * v94
                v162 = 0.6366197723675814 * v129
            else:
                v162 = 0.0
            value = sigma_0 * (0.6366197723675814 * v12 * v47 + v162 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, b, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 2, 'a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'): {
        ('a',): (('a',), prepare_force_of_a, block_force_of_a, 5, 1, (), False),
        ('a', 'q'): (('a', 'q'), prepare_force_of_a_q, block_force_of_a_q, 5, 1, (), False),
        ('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all, block_force_of_all, 7, 1, (), False),
    },
}
