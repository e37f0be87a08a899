"""Programs of axicontact.cohesive.hyperboloid."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, fsum, hypot, nan, sin, sinh, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import hyperboloid as bodies

C0 = np.array(2.0)
C1 = np.array(1.0)
C2 = np.array(2.229767813968649e-06)
C3 = np.array(0.0021043873129700233)
C4 = np.array(0.04325113828415611)
C5 = np.array(0.2725778671008127)
C6 = np.array(0.7123414383945195)
C7 = np.array(0.8116412201960678)
C8 = np.array(0.3333333333333333)
C9 = np.array(0.002445452808893491)
C10 = np.array(0.06453295925870227)
C11 = np.array(0.5368820963772863)
C12 = np.array(1.9680296155712274)
C13 = np.array(3.5294070829658954)
C14 = np.array(3.034923660588189)
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
            v14 = a / b
            if v14 < 1.0:
                v18 = v14 * v14
                v61 = v14 * v18 * (((((((2.229767813968649e-06 * v18 + 0.0021043873129700233) * v18 + 0.04325113828415611) * v18 + 0.2725778671008127) * v18 + 0.7123414383945195) * v18 + 0.8116412201960678) * v18 + 0.3333333333333333) / ((((((0.002445452808893491 * v18 + 0.06453295925870227) * v18 + 0.5368820963772863) * v18 + 1.9680296155712274) * v18 + 3.5294070829658954) * v18 + 3.034923660588189) * v18 + 1.0))
            else:
                v61 = v14 - atan(v14)
            v65 = hypot(a, q)
            value = E_star * tan(theta) * (a * a * atan2(a, b) + b * b * v61) - 2.0 * sigma_0 * (v65 * v65 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, theta, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    np.tan(theta, t0)
    np.multiply(E_star, t0, t0)
    np.square(a, t1)
    np.multiply(t1, out, out)
    np.square(b, t1)
    np.divide(a, b, t2)
    np.less(t2, C1, m0)
    some60 = np.count_nonzero(m0)
    if some60:
        np.minimum(t2, f0, out=t3)
        np.multiply(t3, t3, t4)
        np.multiply(t3, t4, t3)
        np.multiply(C2, t4, t5)
        np.add(t5, C3, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(C9, t4, t6)
        np.add(t6, C10, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t4, t4)
        np.add(t4, C1, t4)
        np.divide(t5, t4, t4)
        np.multiply(t3, t4, t3)
    if some60 != size:
        other60 = t4 if some60 else t3
        np.arctan(t2, other60)
        np.subtract(t2, other60, other60)
        if some60:
            np.copyto(t3, other60, where=~m0)
    np.multiply(t1, t3, t3)
    np.add(out, t3, t3)
    np.multiply(t0, t3, t3)
    np.hypot(a, q, t0)
    np.multiply(C0, sigma_0, out)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, t1)
    np.multiply(t0, t1, t1)
    np.multiply(a, q, t0)
    np.add(t1, t0, t0)
    np.multiply(out, t0, t0)
    np.subtract(t3, t0, out)


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
                v70 = 0.0
            else:
                v8 = hypot(0.0, c)
                v11 = asinh(b / v8)
                v14 = 1.5707963267948966 / v11
                v15 = atan2(0.0, c) / v11
                v16 = asinh(v14)
                v31 = asinh(atan2(c, 0.0) / v11 * (v14 + v15) / (v14 * sqrt(1.0 + v15 * v15) + v15 * sqrt(1.0 + v14 * v14)))
                v35 = 2.0 * v11
                v47 = tan(theta)
                v49 = b * v47
                v52 = b * b
                v64 = []
                for node, weight in RULE_0(v31 / 0.7):
                    v33 = node * v31
                    v37 = 0.5 * v33
                    v42 = v35 * cosh(v16 - v37) * sinh(v37)
                    v44 = v8 * cos(v42)
                    v62 = (v47 * atan(v44 / b) + v49 * v44 / (v44 * v44 + v52)) * v11 * cosh(v16 - v33) * v42 * sin(v42)
                    v64.append(weight * v62)
                v64 = fsum(v64) * v31
                v70 = 0.6366197723675814 * v8 * v64
            v73 = sigma_0 / E_star
            v77 = v70 - dgamma / sigma_0 - 1.2732395447351628 * v73 * c
            if v77 <= -(2.0 * v73 * c):
                value = v77
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
                v70 = 0.0
            else:
                v8 = hypot(0.0, c)
                v11 = asinh(b / v8)
                v14 = 1.5707963267948966 / v11
                v15 = atan2(0.0, c) / v11
                v16 = asinh(v14)
                v31 = asinh(atan2(c, 0.0) / v11 * (v14 + v15) / (v14 * sqrt(1.0 + v15 * v15) + v15 * sqrt(1.0 + v14 * v14)))
                v35 = 2.0 * v11
                v47 = tan(theta)
                v49 = b * v47
                v52 = b * b
                v64 = []
                for node, weight in RULE_0(v31 / 0.7):
                    v33 = node * v31
                    v37 = 0.5 * v33
                    v42 = v35 * cosh(v16 - v37) * sinh(v37)
                    v44 = v8 * cos(v42)
                    v62 = (v47 * atan(v44 / b) + v49 * v44 / (v44 * v44 + v52)) * v11 * cosh(v16 - v33) * v42 * sin(v42)
                    v64.append(weight * v62)
                v64 = fsum(v64) * v31
                v70 = 0.6366197723675814 * v8 * v64
            v73 = sigma_0 / E_star
            if v70 - dgamma / sigma_0 - 1.2732395447351628 * v73 * c <= -(2.0 * v73 * c):
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
            v15 = asinh(b / v12)
            v18 = 1.5707963267948966 / v15
            v19 = atan2(a, v11) / v15
            v20 = asinh(v18)
            v35 = asinh(v13 / v15 * (v18 + v19) / (v18 * sqrt(1.0 + v19 * v19) + v19 * sqrt(1.0 + v18 * v18)))
            v39 = 2.0 * v15
            v51 = tan(theta)
            v53 = b * v51
            v56 = b * b
            v68 = []
            for node, weight in RULE_0(v35 / 0.7):
                v37 = node * v35
                v41 = 0.5 * v37
                v46 = v39 * cosh(v20 - v41) * sinh(v41)
                v48 = v12 * cos(v46)
                v66 = (v51 * atan(v48 / b) + v53 * v48 / (v48 * v48 + v56)) * v15 * cosh(v20 - v37) * v46 * sin(v46)
                v68.append(weight * v66)
            v68 = fsum(v68) * v35
            value = sigma_0 * (0.6366197723675814 * v12 * v68 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
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
        ('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'theta', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 7, 1, (1.0,), False),
    },
}
