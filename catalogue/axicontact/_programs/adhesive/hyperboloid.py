"""Programs of axicontact.adhesive.hyperboloid."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import hyperboloid as bodies

C0 = np.array(6.283185307179586)
C1 = np.array(2.0)
C2 = np.array(1.0)
C3 = np.array(2.229767813968649e-06)
C4 = np.array(0.0021043873129700233)
C5 = np.array(0.04325113828415611)
C6 = np.array(0.2725778671008127)
C7 = np.array(0.7123414383945195)
C8 = np.array(0.8116412201960678)
C9 = np.array(0.3333333333333333)
C10 = np.array(0.002445452808893491)
C11 = np.array(0.06453295925870227)
C12 = np.array(0.5368820963772863)
C13 = np.array(1.9680296155712274)
C14 = np.array(3.5294070829658954)
C15 = np.array(3.034923660588189)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, theta, b, E_star, dgamma):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return tan(theta) * a * atan(a / b) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, b, E_star, dgamma):
    v7 = np.tan(theta)
    v12 = (6.283185307179586) * dgamma
    v13 = v12 / E_star
    v14 = np.sqrt(v13)
    return (b, v7, v14)


def block_depth_a(out, a, b, v7, v14, t0):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.multiply(v7, a, t0)
    np.multiply(t0, out, out)
    np.sqrt(a, t0)
    np.multiply(t0, v14, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, E_star, dgamma, t0, t1):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.tan(theta, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, out, out)
    np.sqrt(a, t0)
    np.multiply(C0, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def displacement(r, a, theta, b, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v11 = r - a
            v16 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * (r + a))
            v51 = tan(theta)
            v57 = b * b
            v80 = r > a
            if v80:
                v10 = b / sqrt(r * r + b * b)
                v17 = a / v16
                v19 = asinh(v17 / v10)
                v24 = 0.0 - expm1(-2.0 * v19)
                v27 = v24 if v24 > 0.0 else inf
                v41 = v10 * v10
                v53 = b * v51
                v64 = []
                for node, weight in RULE_0(v19 / 1.0):
                    v28 = node * v19
                    v37 = v17 * (exp(-v28) * (0.0 - expm1(-2.0 * (v19 - v28))) / v27)
                    v38 = v37 * v37
                    v40 = sqrt(1.0 + v38)
                    v48 = r * v37 / v40
                    v63 = (v51 * atan(v48 / b) + v53 * v48 / (v48 * v48 + v57)) * atan(v37) * (sqrt(v41 + v38) / (v40 * v40 * v40))
                    v64.append(weight * v63)
                v64 = fsum(v64) * v19
                v81 = 0.6366197723675814 * (r * v64)
            else:
                v73 = r * r
                v81 = v51 * a * atan(a / b) - v51 * v73 / (sqrt(v73 + v57) + b)
            value = v81 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v16) if v80 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star, dgamma):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v12 = a / b
            if v12 < 1.0:
                v16 = v12 * v12
                v59 = v12 * v16 * (((((((2.229767813968649e-06 * v16 + 0.0021043873129700233) * v16 + 0.04325113828415611) * v16 + 0.2725778671008127) * v16 + 0.7123414383945195) * v16 + 0.8116412201960678) * v16 + 0.3333333333333333) / ((((((0.002445452808893491 * v16 + 0.06453295925870227) * v16 + 0.5368820963772863) * v16 + 1.9680296155712274) * v16 + 3.5294070829658954) * v16 + 3.034923660588189) * v16 + 1.0))
            else:
                v59 = v12 - atan(v12)
            value = E_star * tan(theta) * (a * a * atan2(a, b) + b * b * v59) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, b, E_star, dgamma):
    v6 = np.tan(theta)
    v7 = E_star * v6
    v11 = np.square(b)
    v63 = (2.0) * E_star
    v67 = (6.283185307179586) * dgamma
    v68 = v67 / E_star
    v69 = np.sqrt(v68)
    return (b, v7, v11, v63, v69)


def block_force_a(out, a, b, v7, v11, v63, v69, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.multiply(t0, out, out)
    np.divide(a, b, t0)
    np.less(t0, C2, m0)
    some59 = np.count_nonzero(m0)
    if some59:
        np.minimum(t0, f0, out=t1)
        np.multiply(t1, t1, t2)
        np.multiply(t1, t2, t1)
        np.multiply(C3, t2, t3)
        np.add(t3, C4, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C5, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C8, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C9, t3)
        np.multiply(C10, t2, t4)
        np.add(t4, C11, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C12, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C13, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C14, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C15, t4)
        np.multiply(t4, t2, t2)
        np.add(t2, C2, t2)
        np.divide(t3, t2, t2)
        np.multiply(t1, t2, t1)
    if some59 != size:
        other59 = t2 if some59 else t1
        np.arctan(t0, other59)
        np.subtract(t0, other59, other59)
        if some59:
            np.copyto(t1, other59, where=~m0)
    np.multiply(v11, t1, t1)
    np.add(out, t1, t1)
    np.multiply(v7, t1, t1)
    np.multiply(v63, a, out)
    np.sqrt(a, t0)
    np.multiply(t0, v69, t0)
    np.multiply(out, t0, t0)
    np.subtract(t1, t0, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(E_star, t0, t0)
    np.square(a, t1)
    np.multiply(t1, out, out)
    np.square(b, t1)
    np.divide(a, b, t2)
    np.less(t2, C2, m0)
    some59 = np.count_nonzero(m0)
    if some59:
        np.minimum(t2, f0, out=t3)
        np.multiply(t3, t3, t4)
        np.multiply(t3, t4, t3)
        np.multiply(C3, t4, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C9, t5)
        np.multiply(C10, t4, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C15, t6)
        np.multiply(t6, t4, t4)
        np.add(t4, C2, t4)
        np.divide(t5, t4, t4)
        np.multiply(t3, t4, t3)
    if some59 != size:
        other59 = t4 if some59 else t3
        np.arctan(t2, other59)
        np.subtract(t2, other59, other59)
        if some59:
            np.copyto(t3, other59, where=~m0)
    np.multiply(t1, t3, t3)
    np.add(out, t3, t3)
    np.multiply(t0, t3, t3)
    np.multiply(C1, E_star, t0)
    np.multiply(t0, a, t0)
    np.sqrt(a, out)
    np.multiply(C0, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(t3, t1, out)


def pressure(r, a, theta, b, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v10 = a - r
            v15 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (a + r))
            if r < a:
                v6 = r * r
                v9 = sqrt(v6 + b * b)
                v17 = asinh(v15 / v9)
                v22 = 0.0 - expm1(-2.0 * v17)
                v25 = v22 if v22 > 0.0 else inf
                v41 = tan(theta)
                v43 = b * v41
                v47 = b * b
                v52 = v9 * v9
                v56 = []
                for node, weight in RULE_0(v17 / 1.0):
                    v26 = node * v17
                    v35 = v15 * (exp(-v26) * (0.0 - expm1(-2.0 * (v17 - v26))) / v25)
                    v36 = v35 * v35
                    v38 = sqrt(v6 + v36)
                    v55 = (v41 * atan(v38 / b) + v43 * v38 / (v38 * v38 + v47)) / v38 * sqrt(v52 + v36)
                    v56.append(weight * v55)
                v56 = fsum(v56) * v17
                v62 = E_star / 3.141592653589793 * v56
            else:
                v62 = 0.0
            if r <= a:
                v68 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v75 = E_star * v68 / (3.141592653589793 * v15) if v68 > 0.0 else 0.0
            else:
                v75 = 0.0
            value = v62 - v75
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(theta, b, E_star, dgamma, control):
    if theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and theta > 1e-30 and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(theta, b, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, theta, b, E_star, dgamma):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star, dgamma):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'theta', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'theta', 'b', 'E_star', 'dgamma'): (('a', 'theta', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 5, 1, (1.0,), False),
        ('a', 'theta', 'b', 'E_star', 'dgamma'): (('a', 'theta', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 7, 1, (1.0,), False),
    },
}
