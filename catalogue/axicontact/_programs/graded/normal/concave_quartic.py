"""Programs of axicontact.graded.normal.concave_quartic."""

from __future__ import annotations

from math import inf, nan, pow, sqrt

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.normal import concave_quartic as bodies

C0 = np.array(-4.0)
C1 = np.array(1.0)
C2 = np.array(2.0)
C3 = np.array(3.0)
C4 = np.array(0.0)
C5 = np.array(4.0)
C6 = np.array(np.inf)
C7 = np.array(np.nan)
C8 = np.array(0.999999999999999)
C9 = np.array(3.141592653589793)
C10 = np.array(0.5)


def depth_from_force(F, a, h, H, k):
    if F.__class__ is a.__class__ is h.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._depth_from_force(F, a, h, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, a, h, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, d, a, h, k):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._displacement(r, d, a, h, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(d, a, h, H, k):
    if d.__class__ is a.__class__ is h.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._force(d, a, h, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, a, h, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def minimum_depth(a, h, k):
    if a.__class__ is h.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            v8 = k + 1.0
            return -4.0 * h * (k - 1.0) / (v8 * v8 * (k + 3.0)) + 0.0 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_depth_all_signed():
    return ()


def block_minimum_depth_all_signed(out, a, h, k, t0, t1):
    np.multiply(C0, h, out)
    np.subtract(k, C1, t0)
    np.multiply(out, t0, t0)
    np.add(k, C1, out)
    np.square(out, out)
    np.add(k, C3, t1)
    np.multiply(out, t1, t1)
    np.divide(t0, t1, t1)
    np.multiply(C4, a, t0)
    np.add(t1, t0, out)


def minimum_force(a, h, H, k):
    if a.__class__ is h.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._minimum_force(a, h, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, d, a, h, H, k):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is H.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            v11 = k + 1.0
            v13 = v11 * v11
            v15 = k + 3.0
            v20 = -4.0 * h * (k - 1.0) / (v13 * v15) + 0.0 * a
            if v20 * 0.999999999999999 <= d:
                v23 = a * a
                v28 = k * v23 + 4.0 * (r * r) - v23
                if r < a:
                    v38 = a - r
                    v42 = sqrt((v38 if v38 > 0.0 or v38 != v38 else 0.0) * (a + r))
                    v52 = H / 3.141592653589793 * pow(v42, k) / v42
                else:
                    v52 = 0.0 if r > a else inf
                value = (d - v20 + 4.0 * h * (v28 * v28) / (v23 * v23 * v13 * (v15 * v15))) * v52
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, h, H, k):
    v7 = (-4.0) * h
    v9 = k - (1.0)
    v10 = v7 * v9
    v11 = k + (1.0)
    v13 = np.square(v11)
    v15 = k + (3.0)
    v16 = v13 * v15
    v17 = v10 / v16
    v19 = (0.0) * a
    v20 = v17 + v19
    v22 = (4.0) * h
    v23 = np.square(a)
    v24 = k * v23
    v31 = np.square(v23)
    v32 = v31 * v13
    v33 = np.square(v15)
    v34 = v32 * v33
    v36 = d - v20
    v45 = H / (3.141592653589793)
    v55 = v20 * (0.999999999999999)
    v56 = np.less_equal(v55, d)
    return (a, k, v22, v23, v24, v34, v36, v45, v56)


def block_pressure_r(out, r, a, k, v22, v23, v24, v34, v36, v45, v56, t0, t1, m0, m1, f0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v56:
        np.square(r, out)
        np.multiply(C5, out, out)
        np.add(v24, out, out)
        np.subtract(out, v23, out)
        np.square(out, out)
        np.multiply(v22, out, out)
        np.divide(out, v34, out)
        np.add(v36, out, out)
        np.less(r, a, m0)
        some52 = np.count_nonzero(m0)
        if some52:
            np.subtract(a, r, t0)
            np.maximum(t0, f0, out=t0)
            np.add(a, r, t1)
            np.multiply(t0, t1, t1)
            np.sqrt(t1, t1)
            np.power(t1, k, t0)
            np.multiply(v45, t0, t0)
            np.divide(t0, t1, t0)
        if some52 != size:
            other52 = t1 if some52 else t0
            np.greater(r, a, m1)
            some51 = np.count_nonzero(m1)
            if some51:
                np.copyto(other52, C4)
            if some51 != size:
                np.copyto(other52, C6, where=~m1)
            if some52:
                np.copyto(t0, other52, where=~m0)
        np.multiply(out, t0, out)
    else:
        np.copyto(out, C7)


def prepare_pressure_r_d(a, h, H, k):
    v7 = (-4.0) * h
    v9 = k - (1.0)
    v10 = v7 * v9
    v11 = k + (1.0)
    v13 = np.square(v11)
    v15 = k + (3.0)
    v16 = v13 * v15
    v17 = v10 / v16
    v19 = (0.0) * a
    v20 = v17 + v19
    v22 = (4.0) * h
    v23 = np.square(a)
    v24 = k * v23
    v31 = np.square(v23)
    v32 = v31 * v13
    v33 = np.square(v15)
    v34 = v32 * v33
    v45 = H / (3.141592653589793)
    v55 = v20 * (0.999999999999999)
    return (a, k, v20, v22, v23, v24, v34, v45, v55)


def block_pressure_r_d(out, r, d, a, k, v20, v22, v23, v24, v34, v45, v55, t0, t1, m0, m1, m2, f0):
    size = out.size
    np.less_equal(v55, d, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some58 = np.count_nonzero(m0)
    if some58:
        np.square(r, out)
        np.multiply(C5, out, out)
        np.add(v24, out, out)
        np.subtract(out, v23, out)
        np.square(out, out)
        np.multiply(v22, out, out)
        np.divide(out, v34, out)
        np.subtract(d, v20, t0)
        np.add(t0, out, out)
        np.less(r, a, m1)
        some52 = np.count_nonzero(m1)
        if some52:
            np.subtract(a, r, t0)
            np.maximum(t0, f0, out=t0)
            np.add(a, r, t1)
            np.multiply(t0, t1, t1)
            np.sqrt(t1, t1)
            np.power(t1, k, t0)
            np.multiply(v45, t0, t0)
            np.divide(t0, t1, t0)
        if some52 != size:
            other52 = t1 if some52 else t0
            np.greater(r, a, m2)
            some51 = np.count_nonzero(m2)
            if some51:
                np.copyto(other52, C4)
            if some51 != size:
                np.copyto(other52, C6, where=~m2)
            if some52:
                np.copyto(t0, other52, where=~m1)
        np.multiply(out, t0, out)
    if some58 != size:
        np.copyto(out, C7, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, h, H, k, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0):
    size = out.size
    np.multiply(C0, h, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.subtract(k, C1, t1)
    np.multiply(t0, t1, t1)
    np.add(k, C1, t0)
    np.square(t0, t0)
    np.add(k, C3, t2)
    np.multiply(t0, t2, t3)
    np.divide(t1, t3, t3)
    np.multiply(C4, a, t1)
    np.add(t3, t1, t1)
    np.multiply(t1, C8, t3)
    np.less_equal(t3, d, m0)
    some58 = np.count_nonzero(m0)
    if some58:
        np.multiply(C5, h, out)
        np.square(a, t3)
        np.multiply(k, t3, t4)
        np.square(r, t5)
        np.multiply(C5, t5, t5)
        np.add(t4, t5, t5)
        np.subtract(t5, t3, t5)
        np.square(t5, t5)
        np.multiply(out, t5, t5)
        np.square(t3, t3)
        np.multiply(t3, t0, t3)
        np.square(t2, out)
        np.multiply(t3, out, out)
        np.divide(t5, out, out)
        np.subtract(d, t1, t5)
        np.add(t5, out, out)
        np.less(r, a, m1)
        some52 = np.count_nonzero(m1)
        if some52:
            np.subtract(a, r, t5)
            np.maximum(t5, f0, out=t5)
            np.add(a, r, t3)
            np.multiply(t5, t3, t3)
            np.sqrt(t3, t3)
            np.divide(H, C9, t5)
            np.power(t3, k, t4)
            np.multiply(t5, t4, t4)
            np.divide(t4, t3, t5)
        if some52 != size:
            other52 = t3 if some52 else t5
            np.greater(r, a, m2)
            some51 = np.count_nonzero(m2)
            if some51:
                np.copyto(other52, C4)
            if some51 != size:
                np.copyto(other52, C6, where=~m2)
            if some52:
                np.copyto(t5, other52, where=~m1)
        np.multiply(out, t5, out)
    if some58 != size:
        np.copyto(out, C7, where=~m0)


def stiffness(a, H, k, h=1.0):
    if a.__class__ is H.__class__ is k.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (h > 1e-30) and (h < 1e+30):
        try:
            value = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_all_signed():
    return ()


def block_stiffness_all_signed(out, a, H, k, t0, m0):
    size = out.size
    np.multiply(C2, H, out)
    np.add(C1, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C4, m0)
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C4, where=~m0)
    np.multiply(t0, out, out)


def zero_radius(a, h, k):
    if a.__class__ is h.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            return a * sqrt(1.0 - k) / 2.0 + 0.0 * h
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_zero_radius_all_signed():
    return ()


def block_zero_radius_all_signed(out, a, h, k, t0):
    np.subtract(C1, k, out)
    np.sqrt(out, out)
    np.multiply(a, out, out)
    np.multiply(out, C10, out)
    np.multiply(C4, h, t0)
    np.add(out, t0, out)


BLOCKS = {
    ('_minimum_depth', 0, 'a', 'h', 'k'): {
        ('a', 'h', 'k'): (('a', 'h', 'k'), prepare_minimum_depth_all_signed, block_minimum_depth_all_signed, 2, 0, (), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'h', 'H', 'k'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 2, 2, (0.0,), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 2, 3, (0.0,), False),
        ('r', 'd', 'a', 'h', 'H', 'k'): (('r', 'd', 'a', 'h', 'H', 'k'), prepare_pressure_all, block_pressure_all, 6, 3, (0.0,), False),
    },
    ('_stiffness', 0, 'a', 'H', 'k'): {
        ('a', 'H', 'k'): (('a', 'H', 'k'), prepare_stiffness_all_signed, block_stiffness_all_signed, 1, 1, (), False),
    },
    ('_zero_radius', 0, 'a', 'h', 'k'): {
        ('a', 'h', 'k'): (('a', 'h', 'k'), prepare_zero_radius_all_signed, block_zero_radius_all_signed, 1, 0, (), False),
    },
}
