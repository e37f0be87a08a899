"""Programs of axicontact.adhesive.cone."""

from __future__ import annotations

from math import atan, atan2, log1p, nan, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.adhesive import cone as bodies

C0 = np.array(3.141592653589793)
C1 = np.array(0.5)
C2 = np.array(6.283185307179586)
C3 = np.array(2.0)
C4 = np.array(0.6366197723675814)
C5 = np.array(1.0)
C6 = np.array(0.0)
C7 = np.array(np.nan)
C8 = np.array(3.0)
C9 = np.array(25.132741228718345)


def depth(a, theta, E_star, dgamma):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return 3.141592653589793 * tan(theta) * a / 2.0 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, E_star, dgamma):
    v4 = np.tan(theta)
    v6 = (3.141592653589793) * v4
    v10 = v6 * (0.5)
    v14 = (6.283185307179586) * dgamma
    v15 = v14 / E_star
    v16 = np.sqrt(v15)
    return (v10, v16)


def block_depth_a(out, a, v10, v16, t0):
    np.multiply(v10, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.sqrt(a, t0)
    np.multiply(t0, v16, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, E_star, dgamma, t0, t1):
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C0, out, out)
    np.multiply(out, a, out)
    np.multiply(out, C1, out)
    np.sqrt(a, t0)
    np.multiply(C2, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def displacement(r, a, theta, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v5 = tan(theta)
            v7 = r - a
            v8 = r + a
            v24 = r > a
            if v24:
                v12 = a / (r + sqrt(v7 * v8))
                v25 = v5 * a * (2.0 * atan(v12) - v12)
            else:
                v25 = 3.141592653589793 * v5 * a / 2.0 - v5 * r
            return v25 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8)) if v24 else 1.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, theta, E_star, dgamma):
    v5 = np.tan(theta)
    v6 = v5 * a
    v19 = (3.141592653589793) * v5
    v20 = v19 * a
    v21 = v20 / (2.0)
    v35 = np.sqrt(a)
    v37 = (6.283185307179586) * dgamma
    v38 = v37 / E_star
    v39 = np.sqrt(v38)
    v40 = v35 * v39
    return (a, v5, v6, v21, v40)


def block_displacement_r(out, r, a, v5, v6, v21, v40, t0, t1, t2, m0, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, a, t0)
    np.greater(r, a, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.add(r, t1, t1)
        np.divide(a, t1, t1)
        np.arctan(t1, t2)
        np.multiply(C3, t2, t2)
        np.subtract(t2, t1, t1)
        np.multiply(v6, t1, t1)
    if some25 != size:
        other25 = t2 if some25 else t1
        np.multiply(v5, r, other25)
        np.subtract(v21, other25, other25)
        if some25:
            np.copyto(t1, other25, where=~m0)
    some34 = np.count_nonzero(m0)
    if some34:
        np.maximum(out, f0, out=t2)
        np.multiply(t2, t0, t2)
        np.sqrt(t2, t2)
        np.arctan2(a, t2, t2)
        np.multiply(C4, t2, t2)
    if some34 != size:
        np.copyto(t2, C5, where=~m0)
    np.multiply(v40, t2, t2)
    np.subtract(t1, t2, out)


def prepare_displacement_r_a(theta, E_star, dgamma):
    v5 = np.tan(theta)
    v19 = (3.141592653589793) * v5
    v22 = v19 * (0.5)
    v39 = (6.283185307179586) * dgamma
    v40 = v39 / E_star
    v41 = np.sqrt(v40)
    return (v5, v22, v41)


def block_displacement_r_a(out, r, a, v5, v22, v41, t0, t1, t2, t3, m0, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(r, a, t0)
    np.greater(r, a, m0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.multiply(v5, a, t1)
        np.multiply(out, t0, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.arctan(t2, t3)
        np.multiply(C3, t3, t3)
        np.subtract(t3, t2, t2)
        np.multiply(t1, t2, t1)
    if some27 != size:
        other27 = t2 if some27 else t1
        np.multiply(v22, a, other27)
        np.multiply(v5, r, t3)
        np.subtract(other27, t3, other27)
        if some27:
            np.copyto(t1, other27, where=~m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.maximum(out, f0, out=t2)
        np.multiply(t2, t0, t2)
        np.sqrt(t2, t2)
        np.arctan2(a, t2, t2)
        np.multiply(C4, t2, t2)
    if some36 != size:
        np.copyto(t2, C5, where=~m0)
    np.sqrt(a, t0)
    np.multiply(t0, v41, t0)
    np.multiply(t0, t2, t2)
    np.subtract(t1, t2, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, theta, E_star, dgamma, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.tan(theta, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some26 = np.count_nonzero(m0)
    if some26:
        np.multiply(out, a, t2)
        np.multiply(t0, t1, t3)
        np.sqrt(t3, t3)
        np.add(r, t3, t3)
        np.divide(a, t3, t3)
        np.arctan(t3, t4)
        np.multiply(C3, t4, t4)
        np.subtract(t4, t3, t3)
        np.multiply(t2, t3, t2)
    if some26 != size:
        other26 = t3 if some26 else t2
        np.multiply(C0, out, other26)
        np.multiply(other26, a, other26)
        np.multiply(other26, C1, other26)
        np.multiply(out, r, t4)
        np.subtract(other26, t4, other26)
        if some26:
            np.copyto(t2, other26, where=~m0)
    some35 = np.count_nonzero(m0)
    if some35:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C4, out, out)
    if some35 != size:
        np.copyto(out, C5, where=~m0)
    np.sqrt(a, t1)
    np.multiply(C2, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t1, t0, t0)
    np.multiply(t0, out, out)
    np.subtract(t2, out, out)


def force(a, theta, E_star, dgamma):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return 3.141592653589793 * E_star * tan(theta) * (a * a) / 2.0 - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, E_star, dgamma):
    v5 = (3.141592653589793) * E_star
    v6 = np.tan(theta)
    v7 = v5 * v6
    v12 = v7 * (0.5)
    v14 = (2.0) * E_star
    v18 = (6.283185307179586) * dgamma
    v19 = v18 / E_star
    v20 = np.sqrt(v19)
    return (v12, v14, v20)


def block_force_a(out, a, v12, v14, v20, t0, t1):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v12, out, out)
    np.multiply(v14, a, t0)
    np.sqrt(a, t1)
    np.multiply(t1, v20, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, E_star, dgamma, t0, t1, t2):
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(out, t0, t0)
    np.square(a, out)
    np.multiply(t0, out, out)
    np.multiply(out, C1, out)
    np.multiply(C3, E_star, t0)
    np.multiply(t0, a, t0)
    np.sqrt(a, t1)
    np.multiply(C2, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t2, t2)
    np.subtract(out, t2, out)


def pressure(r, a, theta, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v5 = a - r
            v6 = a + r
            if r <= a:
                v25 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v36 = E_star * v25 / (3.141592653589793 * sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * v6)) if v25 > 0.0 else 0.0
            else:
                v36 = 0.0
            return (E_star * tan(theta) * log1p((v5 + sqrt(v5 * v6)) / r) / 2.0 if r < a else 0.0) - v36
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, theta, E_star, dgamma):
    v10 = np.tan(theta)
    v11 = E_star * v10
    v18 = v11 * (0.5)
    v22 = np.sqrt(a)
    v24 = (6.283185307179586) * dgamma
    v25 = v24 / E_star
    v26 = np.sqrt(v25)
    v27 = v22 * v26
    v28 = np.greater(v27, (0.0))
    v29 = E_star * v27
    return (a, v18, v28, v29)


def block_pressure_r(out, r, a, v18, v28, v29, t0, t1, t2, m0, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.add(out, t1, t1)
        np.divide(t1, r, t1)
        np.log1p(t1, t1)
        np.multiply(v18, t1, t1)
    if some21 != size:
        np.copyto(t1, C6, where=~m0)
    np.less_equal(r, a, m0)
    some38 = np.count_nonzero(m0)
    if some38:
        if v28:
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C0, t2, t2)
            np.divide(v29, t2, t2)
        else:
            np.copyto(t2, C6)
    if some38 != size:
        np.copyto(t2, C6, where=~m0)
    np.subtract(t1, t2, out)


def prepare_pressure_r_a(theta, E_star, dgamma):
    v10 = np.tan(theta)
    v11 = E_star * v10
    v18 = v11 * (0.5)
    v24 = (6.283185307179586) * dgamma
    v25 = v24 / E_star
    v26 = np.sqrt(v25)
    return (E_star, v18, v26)


def block_pressure_r_a(out, r, a, E_star, v18, v26, t0, t1, t2, t3, t4, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.add(out, t1, t1)
        np.divide(t1, r, t1)
        np.log1p(t1, t1)
        np.multiply(v18, t1, t1)
    if some21 != size:
        np.copyto(t1, C6, where=~m0)
    np.less_equal(r, a, m0)
    some38 = np.count_nonzero(m0)
    if some38:
        np.sqrt(a, t3)
        np.multiply(t3, v26, t3)
        np.greater(t3, C6, m1)
        some36 = np.count_nonzero(m1)
        if some36:
            np.multiply(E_star, t3, t2)
            np.maximum(out, f0, out=t4)
            np.multiply(t4, t0, t4)
            np.sqrt(t4, t4)
            np.multiply(C0, t4, t4)
            np.divide(t2, t4, t2)
        if some36 != size:
            np.copyto(t2, C6, where=~m1)
    if some38 != size:
        np.copyto(t2, C6, where=~m0)
    np.subtract(t1, t2, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, theta, E_star, dgamma, t0, t1, t2, t3, t4, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.tan(theta, t2)
        np.multiply(E_star, t2, t2)
        np.add(out, t1, t1)
        np.divide(t1, r, t1)
        np.log1p(t1, t1)
        np.multiply(t2, t1, t1)
        np.multiply(t1, C1, t1)
    if some20 != size:
        np.copyto(t1, C6, where=~m0)
    np.less_equal(r, a, m0)
    some37 = np.count_nonzero(m0)
    if some37:
        np.sqrt(a, t3)
        np.multiply(C2, dgamma, t4)
        np.divide(t4, E_star, t4)
        np.sqrt(t4, t4)
        np.multiply(t3, t4, t4)
        np.greater(t4, C6, m1)
        some35 = np.count_nonzero(m1)
        if some35:
            np.multiply(E_star, t4, t2)
            np.maximum(out, f0, out=t3)
            np.multiply(t3, t0, t3)
            np.sqrt(t3, t3)
            np.multiply(C0, t3, t3)
            np.divide(t2, t3, t2)
        if some35 != size:
            np.copyto(t2, C6, where=~m1)
    if some37 != size:
        np.copyto(t2, C6, where=~m0)
    np.subtract(t1, t2, out)


def pull_off_depth(a, theta, E_star, dgamma, control):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_depth(a, theta, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, theta, E_star, dgamma, control):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_force(a, theta, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(theta, E_star, dgamma, control):
    if theta.__class__ is E_star.__class__ is dgamma.__class__ is float and theta > 1e-30 and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(theta, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, theta, E_star, dgamma):
    if d.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, E_star, dgamma):
    if F.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, theta, E_star):
    if F.__class__ is theta.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if F == 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v7 = -F if F < 0.0 else nan
            v9 = 3.0 * v7
            v17 = sqrt(2.0 * v9 / (3.141592653589793 * E_star * tan(theta)))
            v20 = (v7 + v9) / v17
            value = v20 * v20 / (25.132741228718345 * E_star * v17)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_work_of_adhesion_from_pull_off_all_signed():
    return ()


def block_work_of_adhesion_from_pull_off_all_signed(out, F, theta, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.equal(F, C6, m0)
    some26 = np.count_nonzero(m0)
    if some26:
        np.copyto(out, C6)
    if some26 != size:
        other26 = t0 if some26 else out
        np.less(F, C6, m1)
        some7 = np.count_nonzero(m1)
        if some7:
            np.negative(F, other26)
        if some7 != size:
            np.copyto(other26, C7, where=~m1)
        np.multiply(C8, other26, t1)
        np.multiply(C3, t1, t2)
        np.multiply(C0, E_star, t3)
        np.tan(theta, t4)
        np.multiply(t3, t4, t4)
        np.divide(t2, t4, t4)
        np.sqrt(t4, t4)
        np.add(other26, t1, t1)
        np.divide(t1, t4, t1)
        np.square(t1, t1)
        np.multiply(C9, E_star, other26)
        np.multiply(other26, t4, t4)
        np.divide(t1, t4, other26)
        if some26:
            np.copyto(out, other26, where=~m0)


BLOCKS = {
    ('_depth', 1, 'a', 'theta', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'theta', 'E_star', 'dgamma'): (('a', 'theta', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_displacement', 2, 'r', 'a', 'theta', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 3, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_displacement_r_a, block_displacement_r_a, 4, 1, (0.0,), False),
        ('r', 'a', 'theta', 'E_star', 'dgamma'): (('r', 'a', 'theta', 'E_star', 'dgamma'), prepare_displacement_all, block_displacement_all, 5, 1, (0.0,), False),
    },
    ('_force', 1, 'a', 'theta', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 0, (), False),
        ('a', 'theta', 'E_star', 'dgamma'): (('a', 'theta', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 3, 0, (), False),
    },
    ('_pressure', 2, 'r', 'a', 'theta', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 3, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 5, 2, (0.0,), False),
        ('r', 'a', 'theta', 'E_star', 'dgamma'): (('r', 'a', 'theta', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, 5, 2, (0.0,), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'theta', 'E_star'): {
        ('F', 'theta', 'E_star'): (('F', 'theta', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 5, 2, (), False),
    },
}
