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
            v34 = tan(theta)
            v37 = 2.0 * v34 / b
            v43 = []
            for node, weight in RULE_0(v27 / 1.0):
                v29 = node * v27
                v30 = v26 + v29
                v32 = v7 * cos(v30)
                v41 = v37 * (v32 if v32 < b or v32 != v32 else b) * v30 * sin(v30)
                v43.append(weight * v41)
            v43 = fsum(v43) * v27
            v59 = 0.0 - b
            v63 = sqrt((v59 if v59 > 0.0 or v59 != v59 else 0.0) * (0.0 + b))
            v65 = v19 if v9 else hypot(v63, c)
            v66 = v65 if v9 else c
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
                v111 = 2.0 * b
                v126 = []
                for node, weight in RULE_1(v91 / 1.0):
                    v92 = node * v91
                    v95 = 0.5 * v92
                    v100 = v93 * cosh(v77 - v95) * sinh(v95)
                    v102 = v68 * cos(v100)
                    v104 = v68 * sin(v100)
                    v108 = sqrt(v105 + v102 * v102)
                    v124 = v34 * (atan(v102 / b) + v111 / (v102 + v108)) * v102 * v71 * cosh(v77 - v92) * atan2(v104, v108) * (v104 / v108)
                    v126.append(weight * v124)
                v126 = fsum(v126) * v91
                v159 = 0.6366197723675814 * v126
            else:
                v159 = 0.0
            v166 = sigma_0 / E_star
            v170 = 0.6366197723675814 * v7 * v43 + v159 - dgamma / sigma_0 - 1.2732395447351628 * v166 * c
            if v170 <= -(2.0 * v166 * c):
                value = v170
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
            v34 = tan(theta)
            v37 = 2.0 * v34 / b
            v43 = []
            for node, weight in RULE_0(v27 / 1.0):
                v29 = node * v27
                v30 = v26 + v29
                v32 = v7 * cos(v30)
                v41 = v37 * (v32 if v32 < b or v32 != v32 else b) * v30 * sin(v30)
                v43.append(weight * v41)
            v43 = fsum(v43) * v27
            v59 = 0.0 - b
            v63 = sqrt((v59 if v59 > 0.0 or v59 != v59 else 0.0) * (0.0 + b))
            v65 = v19 if v9 else hypot(v63, c)
            v66 = v65 if v9 else c
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
                v111 = 2.0 * b
                v126 = []
                for node, weight in RULE_1(v91 / 1.0):
                    v92 = node * v91
                    v95 = 0.5 * v92
                    v100 = v93 * cosh(v77 - v95) * sinh(v95)
                    v102 = v68 * cos(v100)
                    v104 = v68 * sin(v100)
                    v108 = sqrt(v105 + v102 * v102)
                    v124 = v34 * (atan(v102 / b) + v111 / (v102 + v108)) * v102 * v71 * cosh(v77 - v92) * atan2(v104, v108) * (v104 / v108)
                    v126.append(weight * v124)
                v126 = fsum(v126) * v91
                v159 = 0.6366197723675814 * v126
            else:
                v159 = 0.0
            v166 = sigma_0 / E_star
            if 0.6366197723675814 * v7 * v43 + v159 - dgamma / sigma_0 - 1.2732395447351628 * v166 * c <= -(2.0 * v166 * c):
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
            v39 = tan(theta)
            v42 = 2.0 * v39 / b
            v48 = []
            for node, weight in RULE_0(v32 / 1.0):
                v34 = node * v32
                v35 = v31 + v34
                v37 = v12 * cos(v35)
                v46 = v42 * (v37 if v37 < b or v37 != v37 else b) * v35 * sin(v35)
                v48.append(weight * v46)
            v48 = fsum(v48) * v32
            v64 = a - b
            v68 = sqrt((v64 if v64 > 0.0 or v64 != v64 else 0.0) * (a + b))
            v70 = v24 if v14 else hypot(v68, v11)
            v71 = v70 if v14 else v11
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
                v116 = 2.0 * b
                v131 = []
                for node, weight in RULE_1(v96 / 1.0):
                    v97 = node * v96
                    v100 = 0.5 * v97
                    v105 = v98 * cosh(v82 - v100) * sinh(v100)
                    v107 = v73 * cos(v105)
                    v109 = v73 * sin(v105)
                    v113 = sqrt(v110 + v107 * v107)
                    v129 = v39 * (atan(v107 / b) + v116 / (v107 + v113)) * v107 * v76 * cosh(v82 - v97) * atan2(v109, v113) * (v109 / v113)
                    v131.append(weight * v129)
                v131 = fsum(v131) * v96
                v164 = 0.6366197723675814 * v131
            else:
                v164 = 0.0
            value = sigma_0 * (0.6366197723675814 * v12 * v48 + v164 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
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
