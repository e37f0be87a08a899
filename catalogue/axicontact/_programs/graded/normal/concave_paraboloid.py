"""Programs of axicontact.graded.normal.concave_paraboloid."""

from __future__ import annotations

from math import inf, nan, pow, sqrt

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.normal import concave_paraboloid as bodies

C0 = np.array(-2.0)
C1 = np.array(1.0)
C2 = np.array(2.0)
C3 = np.array(0.0)
C4 = np.array(np.inf)
C5 = np.array(np.nan)
C6 = np.array(0.999999999999999)
C7 = np.array(4.0)
C8 = np.array(3.141592653589793)


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
            return -2.0 * h * (k - 1.0) / (v8 * v8) + 0.0 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_depth_all_signed():
    return ()


def block_minimum_depth_all_signed(out, a, h, k, t0):
    np.multiply(C0, h, out)
    np.subtract(k, C1, t0)
    np.multiply(out, t0, t0)
    np.add(k, C1, out)
    np.square(out, out)
    np.divide(t0, out, out)
    np.multiply(C3, a, t0)
    np.add(out, t0, out)


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
            v17 = -2.0 * h * (k - 1.0) / v13 + 0.0 * a
            if v17 * 0.999999999999999 <= d:
                if r < a:
                    v27 = a - r
                    v31 = sqrt((v27 if v27 > 0.0 or v27 != v27 else 0.0) * (a + r))
                    v41 = H / 3.141592653589793 * pow(v31, k) / v31
                else:
                    v41 = 0.0 if r > a else inf
                value = (d - v17 + 4.0 * h * (r * r) / (a * a * v13)) * v41
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, h, H, k):
    v7 = (-2.0) * h
    v9 = k - (1.0)
    v10 = v7 * v9
    v11 = k + (1.0)
    v13 = np.square(v11)
    v14 = v10 / v13
    v16 = (0.0) * a
    v17 = v14 + v16
    v19 = (4.0) * h
    v22 = np.square(a)
    v23 = v22 * v13
    v25 = d - v17
    v34 = H / (3.141592653589793)
    v44 = v17 * (0.999999999999999)
    v45 = np.less_equal(v44, d)
    return (a, k, v19, v23, v25, v34, v45)


def block_pressure_r(out, r, a, k, v19, v23, v25, v34, v45, t0, t1, m0, m1, f0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v45:
        np.square(r, out)
        np.multiply(v19, out, out)
        np.divide(out, v23, out)
        np.add(v25, out, out)
        np.less(r, a, m0)
        some41 = np.count_nonzero(m0)
        if some41:
            np.subtract(a, r, t0)
            np.maximum(t0, f0, out=t0)
            np.add(a, r, t1)
            np.multiply(t0, t1, t1)
            np.sqrt(t1, t1)
            np.power(t1, k, t0)
            np.multiply(v34, t0, t0)
            np.divide(t0, t1, t0)
        if some41 != size:
            other41 = t1 if some41 else t0
            np.greater(r, a, m1)
            some40 = np.count_nonzero(m1)
            if some40:
                np.copyto(other41, C3)
            if some40 != size:
                np.copyto(other41, C4, where=~m1)
            if some41:
                np.copyto(t0, other41, where=~m0)
        np.multiply(out, t0, out)
    else:
        np.copyto(out, C5)


def prepare_pressure_r_d(a, h, H, k):
    v7 = (-2.0) * h
    v9 = k - (1.0)
    v10 = v7 * v9
    v11 = k + (1.0)
    v13 = np.square(v11)
    v14 = v10 / v13
    v16 = (0.0) * a
    v17 = v14 + v16
    v19 = (4.0) * h
    v22 = np.square(a)
    v23 = v22 * v13
    v34 = H / (3.141592653589793)
    v44 = v17 * (0.999999999999999)
    return (a, k, v17, v19, v23, v34, v44)


def block_pressure_r_d(out, r, d, a, k, v17, v19, v23, v34, v44, t0, t1, m0, m1, m2, f0):
    size = out.size
    np.less_equal(v44, d, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some47 = np.count_nonzero(m0)
    if some47:
        np.square(r, out)
        np.multiply(v19, out, out)
        np.divide(out, v23, out)
        np.subtract(d, v17, t0)
        np.add(t0, out, out)
        np.less(r, a, m1)
        some41 = np.count_nonzero(m1)
        if some41:
            np.subtract(a, r, t0)
            np.maximum(t0, f0, out=t0)
            np.add(a, r, t1)
            np.multiply(t0, t1, t1)
            np.sqrt(t1, t1)
            np.power(t1, k, t0)
            np.multiply(v34, t0, t0)
            np.divide(t0, t1, t0)
        if some41 != size:
            other41 = t1 if some41 else t0
            np.greater(r, a, m2)
            some40 = np.count_nonzero(m2)
            if some40:
                np.copyto(other41, C3)
            if some40 != size:
                np.copyto(other41, C4, where=~m2)
            if some41:
                np.copyto(t0, other41, where=~m1)
        np.multiply(out, t0, out)
    if some47 != size:
        np.copyto(out, C5, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, h, H, k, t0, t1, t2, t3, t4, m0, m1, m2, f0):
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
    np.divide(t1, t0, t1)
    np.multiply(C3, a, t2)
    np.add(t1, t2, t2)
    np.multiply(t2, C6, t1)
    np.less_equal(t1, d, m0)
    some47 = np.count_nonzero(m0)
    if some47:
        np.multiply(C7, h, out)
        np.square(r, t1)
        np.multiply(out, t1, t1)
        np.square(a, out)
        np.multiply(out, t0, out)
        np.divide(t1, out, out)
        np.subtract(d, t2, t1)
        np.add(t1, out, out)
        np.less(r, a, m1)
        some41 = np.count_nonzero(m1)
        if some41:
            np.subtract(a, r, t1)
            np.maximum(t1, f0, out=t1)
            np.add(a, r, t3)
            np.multiply(t1, t3, t3)
            np.sqrt(t3, t3)
            np.divide(H, C8, t1)
            np.power(t3, k, t4)
            np.multiply(t1, t4, t4)
            np.divide(t4, t3, t1)
        if some41 != size:
            other41 = t3 if some41 else t1
            np.greater(r, a, m2)
            some40 = np.count_nonzero(m2)
            if some40:
                np.copyto(other41, C3)
            if some40 != size:
                np.copyto(other41, C4, where=~m2)
            if some41:
                np.copyto(t1, other41, where=~m1)
        np.multiply(out, t1, out)
    if some47 != size:
        np.copyto(out, C5, where=~m0)


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
    np.greater(a, C3, m0)
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C3, where=~m0)
    np.multiply(t0, out, out)


def zero_radius(a, h, k):
    if a.__class__ is h.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            return 0.0 * a + 0.0 * h
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_zero_radius_all_signed():
    return ()


def block_zero_radius_all_signed(out, a, h, k, t0):
    np.multiply(C3, a, out)
    np.multiply(C3, h, t0)
    np.add(out, t0, out)


BLOCKS = {
    ('_minimum_depth', 0, 'a', 'h', 'k'): {
        ('a', 'h', 'k'): (('a', 'h', 'k'), prepare_minimum_depth_all_signed, block_minimum_depth_all_signed, 1, 0, (), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'h', 'H', 'k'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 2, 2, (0.0,), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 2, 3, (0.0,), False),
        ('r', 'd', 'a', 'h', 'H', 'k'): (('r', 'd', 'a', 'h', 'H', 'k'), prepare_pressure_all, block_pressure_all, 5, 3, (0.0,), False),
    },
    ('_stiffness', 0, 'a', 'H', 'k'): {
        ('a', 'H', 'k'): (('a', 'H', 'k'), prepare_stiffness_all_signed, block_stiffness_all_signed, 1, 1, (), False),
    },
    ('_zero_radius', 0, 'a', 'h', 'k'): {
        ('a', 'h', 'k'): (('a', 'h', 'k'), prepare_zero_radius_all_signed, block_zero_radius_all_signed, 1, 0, (), False),
    },
}
