"""Programs of axicontact.cohesive.truncated_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, nan, sin, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import truncated_cone as bodies

C0 = np.array(0.0)
C1 = np.array(2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


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
            if a < b:
                v23 = 0.0
            else:
                v11 = sqrt((a - b) * (a + b))
                v23 = E_star * tan(theta) * (a * a * atan(v11 / b) + b * v11)
            v24 = hypot(a, q)
            value = v23 - 2.0 * sigma_0 * (v24 * v24 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, theta, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, m0):
    size = out.size
    np.less(a, b, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.copyto(out, C0)
    if some22 != size:
        other22 = t0 if some22 else out
        np.subtract(a, b, other22)
        np.add(a, b, t1)
        np.multiply(other22, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, b, other22)
        np.arctan(other22, other22)
        np.tan(theta, t2)
        np.multiply(E_star, t2, t2)
        np.square(a, t3)
        np.multiply(t3, other22, other22)
        np.multiply(b, t1, t1)
        np.add(other22, t1, t1)
        np.multiply(t2, t1, other22)
        if some22:
            np.copyto(out, other22, where=~m0)
    np.hypot(a, q, t0)
    np.multiply(C1, sigma_0, t1)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, t2)
    np.multiply(t0, t2, t2)
    np.multiply(a, q, t0)
    np.add(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.subtract(out, t0, out)


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
                v95 = 0.0
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
                v75 = tan(theta)
                v77 = b * v75
                v90 = []
                for node, weight in RULE_0(v52 / 1.0):
                    v53 = node * v52
                    v57 = 0.5 * v53
                    v62 = v55 * cosh(v37 - v57) * sinh(v57)
                    v63 = cos(v62)
                    v66 = v29 * (v63 if v63 > 1e-17 or v63 != v63 else 1e-17)
                    v68 = v29 * sin(v62)
                    v72 = sqrt(v69 + v66 * v66)
                    v88 = (v75 * atan(v66 / b) + v77 / v66) * v66 * v31 * cosh(v37 - v53) * atan2(v68, v72) * (v68 / v72)
                    v90.append(weight * v88)
                v90 = fsum(v90) * v52
                v95 = 0.6366197723675814 * v90
            v98 = sigma_0 / E_star
            v102 = v95 - dgamma / sigma_0 - 1.2732395447351628 * v98 * c
            if v102 <= -(2.0 * v98 * c):
                value = v102
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
                v95 = 0.0
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
                v75 = tan(theta)
                v77 = b * v75
                v90 = []
                for node, weight in RULE_0(v52 / 1.0):
                    v53 = node * v52
                    v57 = 0.5 * v53
                    v62 = v55 * cosh(v37 - v57) * sinh(v57)
                    v63 = cos(v62)
                    v66 = v29 * (v63 if v63 > 1e-17 or v63 != v63 else 1e-17)
                    v68 = v29 * sin(v62)
                    v72 = sqrt(v69 + v66 * v66)
                    v88 = (v75 * atan(v66 / b) + v77 / v66) * v66 * v31 * cosh(v37 - v53) * atan2(v68, v72) * (v68 / v72)
                    v90.append(weight * v88)
                v90 = fsum(v90) * v52
                v95 = 0.6366197723675814 * v90
            v98 = sigma_0 / E_star
            if v95 - dgamma / sigma_0 - 1.2732395447351628 * v98 * c <= -(2.0 * v98 * c):
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
            v79 = tan(theta)
            v81 = b * v79
            v94 = []
            for node, weight in RULE_0(v56 / 1.0):
                v57 = node * v56
                v61 = 0.5 * v57
                v66 = v59 * cosh(v41 - v61) * sinh(v61)
                v67 = cos(v66)
                v70 = v33 * (v67 if v67 > 1e-17 or v67 != v67 else 1e-17)
                v72 = v33 * sin(v66)
                v76 = sqrt(v73 + v70 * v70)
                v92 = (v79 * atan(v70 / b) + v81 / v70) * v70 * v35 * cosh(v41 - v57) * atan2(v72, v76) * (v72 / v76)
                v94.append(weight * v92)
            v94 = fsum(v94) * v56
            value = sigma_0 * (0.6366197723675814 * v94 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (atan2(v11, a) - v11 / (hypot(a, v11) + a)))
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
        ('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 4, 1, (), False),
    },
}
