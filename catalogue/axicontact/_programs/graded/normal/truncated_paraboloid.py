"""Programs of axicontact.graded.normal.truncated_paraboloid."""

from __future__ import annotations

from math import nan, pow, sqrt

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.normal import truncated_paraboloid as bodies

C0 = np.array(0.0)
C1 = np.array(np.nan)
C2 = np.array(1.0)
C3 = np.array(2.0)
C4 = np.array(3.0)
C5 = np.array(3.141592653589793)


def depth(a, R, b, k):
    if a.__class__ is R.__class__ is b.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (k > 1e-30) and (k < 1.0) and (b <= a):
        try:
            if a >= b:
                v5 = a - b
                v11 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (a + b)) / a
                value = (a * a * (v11 * pow(v11, k) if v11 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b) / R
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, b, k):
    v19 = (1.0) + k
    v21 = (0.0) * b
    return (R, b, k, v19, v21)


def block_depth_a(out, a, R, b, k, v19, v21, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(t0, a, t0)
        np.multiply(a, a, out)
        np.greater(t0, C0, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.power(t0, k, t1)
            np.multiply(t0, t1, t1)
        if some16 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(out, t1, t1)
        np.divide(t1, v19, t1)
        np.add(t1, v21, t1)
        np.divide(t1, R, out)
    if some25 != size:
        np.copyto(out, C1, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, b, k, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(t0, a, t0)
        np.multiply(a, a, out)
        np.greater(t0, C0, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.power(t0, k, t1)
            np.multiply(t0, t1, t1)
        if some16 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(out, t1, t1)
        np.add(C2, k, out)
        np.divide(t1, out, out)
        np.multiply(C0, b, t1)
        np.add(out, t1, t1)
        np.divide(t1, R, out)
    if some25 != size:
        np.copyto(out, C1, where=~m0)


def depth_from_force(F, R, b, H, k):
    if F.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._depth_from_force(F, R, b, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, b, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R, b, k):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (k > 1e-30) and (k < 1.0) and (b <= a):
        try:
            value = bodies._displacement(r, a, R, b, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, b, H, k):
    if a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (b <= a):
        try:
            if a >= b:
                v6 = a - b
                v13 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (a + b)) / (a if a > b or a != a else b)
                v26 = 3.0 + k
                v28 = 1.0 + k
                value = 2.0 * H / v28 * ((a * a * (a * pow(a, k) if a > 0.0 else 0.0) * (v13 * pow(v13, k) if v13 > 0.0 else 0.0) * (v26 - v28 * (v13 * v13)) / (v28 * v26) + 0.0 * b) / R)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, b, H, k):
    v26 = (3.0) + k
    v28 = (1.0) + k
    v34 = v28 * v26
    v36 = (0.0) * b
    v39 = (2.0) * H
    v40 = v39 / v28
    return (R, b, k, v26, v28, v34, v36, v40)


def block_force_a(out, a, R, b, k, v26, v28, v34, v36, v40, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some43 = np.count_nonzero(m0)
    if some43:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.maximum(a, b, out=out)
        np.divide(t0, out, out)
        np.multiply(a, a, t0)
        np.greater(a, C0, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.power(a, k, t1)
            np.multiply(a, t1, t1)
        if some18 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(t0, t1, t1)
        np.greater(out, C0, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.power(out, k, t0)
            np.multiply(out, t0, t0)
        if some23 != size:
            np.copyto(t0, C0, where=~m1)
        np.multiply(t1, t0, t0)
        np.square(out, out)
        np.multiply(v28, out, out)
        np.subtract(v26, out, out)
        np.multiply(t0, out, out)
        np.divide(out, v34, out)
        np.add(out, v36, out)
        np.divide(out, R, out)
        np.multiply(v40, out, out)
    if some43 != size:
        np.copyto(out, C1, where=~m0)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, b, H, k, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some43 = np.count_nonzero(m0)
    if some43:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.maximum(a, b, out=out)
        np.divide(t0, out, out)
        np.multiply(a, a, t0)
        np.greater(a, C0, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.power(a, k, t1)
            np.multiply(a, t1, t1)
        if some18 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(t0, t1, t1)
        np.greater(out, C0, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.power(out, k, t0)
            np.multiply(out, t0, t0)
        if some23 != size:
            np.copyto(t0, C0, where=~m1)
        np.multiply(t1, t0, t0)
        np.add(C4, k, t1)
        np.add(C2, k, t2)
        np.square(out, out)
        np.multiply(t2, out, out)
        np.subtract(t1, out, out)
        np.multiply(t0, out, out)
        np.multiply(t2, t1, t1)
        np.divide(out, t1, t1)
        np.multiply(C0, b, out)
        np.add(t1, out, out)
        np.divide(out, R, out)
        np.multiply(C3, H, t1)
        np.divide(t1, t2, t2)
        np.multiply(t2, out, out)
    if some43 != size:
        np.copyto(out, C1, where=~m0)


def force_from_depth(d, R, b, H, k):
    if d.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._force_from_depth(d, R, b, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, b, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, R, b, H, k):
    if a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (b <= a):
        try:
            if a >= b:
                v6 = a - b
                v13 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (a + b)) / (a if a > b or a != a else b)
                v26 = 3.0 + k
                v28 = 1.0 + k
                v43 = 2.0 * H / v28 * ((a * a * (a * pow(a, k) if a > 0.0 else 0.0) * (v13 * pow(v13, k) if v13 > 0.0 else 0.0) * (v26 - v28 * (v13 * v13)) / (v28 * v26) + 0.0 * b) / R)
            else:
                v43 = nan
            value = v43 / (3.141592653589793 * a * a)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R, b, H, k):
    v26 = (3.0) + k
    v28 = (1.0) + k
    v34 = v28 * v26
    v36 = (0.0) * b
    v39 = (2.0) * H
    v40 = v39 / v28
    return (R, b, k, v26, v28, v34, v36, v40)


def block_mean_pressure_a(out, a, R, b, k, v26, v28, v34, v36, v40, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some43 = np.count_nonzero(m0)
    if some43:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.maximum(a, b, out=out)
        np.divide(t0, out, out)
        np.multiply(a, a, t0)
        np.greater(a, C0, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.power(a, k, t1)
            np.multiply(a, t1, t1)
        if some18 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(t0, t1, t1)
        np.greater(out, C0, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.power(out, k, t0)
            np.multiply(out, t0, t0)
        if some23 != size:
            np.copyto(t0, C0, where=~m1)
        np.multiply(t1, t0, t0)
        np.square(out, out)
        np.multiply(v28, out, out)
        np.subtract(v26, out, out)
        np.multiply(t0, out, out)
        np.divide(out, v34, out)
        np.add(out, v36, out)
        np.divide(out, R, out)
        np.multiply(v40, out, out)
    if some43 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(C5, a, t0)
    np.multiply(t0, a, t0)
    np.divide(out, t0, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, b, H, k, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some43 = np.count_nonzero(m0)
    if some43:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.maximum(a, b, out=out)
        np.divide(t0, out, out)
        np.multiply(a, a, t0)
        np.greater(a, C0, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.power(a, k, t1)
            np.multiply(a, t1, t1)
        if some18 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(t0, t1, t1)
        np.greater(out, C0, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.power(out, k, t0)
            np.multiply(out, t0, t0)
        if some23 != size:
            np.copyto(t0, C0, where=~m1)
        np.multiply(t1, t0, t0)
        np.add(C4, k, t1)
        np.add(C2, k, t2)
        np.square(out, out)
        np.multiply(t2, out, out)
        np.subtract(t1, out, out)
        np.multiply(t0, out, out)
        np.multiply(t2, t1, t1)
        np.divide(out, t1, t1)
        np.multiply(C0, b, out)
        np.add(t1, out, out)
        np.divide(out, R, out)
        np.multiply(C3, H, t1)
        np.divide(t1, t2, t2)
        np.multiply(t2, out, out)
    if some43 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(C5, a, t2)
    np.multiply(t2, a, t2)
    np.divide(out, t2, out)


def pressure(r, a, R, b, H, k):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (b <= a):
        try:
            value = bodies._pressure(r, a, R, b, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, b, k):
    if d.__class__ is R.__class__ is b.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._radius_from_depth(d, R, b, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, b, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, b, H, k):
    if F.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._radius_from_force(F, R, b, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, b, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, H, k, R=1.0, b=1.0):
    if a.__class__ is H.__class__ is k.__class__ is R.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            value = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_a(H, k):
    v4 = (2.0) * H
    v6 = (1.0) + k
    v7 = v4 / v6
    return (k, v7)


def block_stiffness_a(out, a, k, v7, m0):
    size = out.size
    np.greater(a, C0, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C0, where=~m0)
    np.multiply(v7, out, out)


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, a, H, k, t0, m0):
    size = out.size
    np.multiply(C3, H, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(C2, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C0, m0)
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C0, where=~m0)
    np.multiply(t0, out, out)


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'b', 'k'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 2, 2, (0.0,), False),
        ('a', 'R', 'b', 'k'): (('a', 'R', 'b', 'k'), prepare_depth_all, block_depth_all, 2, 2, (0.0,), False),
    },
    ('_force', 1, 'a', 'R', 'b', 'H', 'k'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 2, (0.0,), False),
        ('a', 'R', 'b', 'H', 'k'): (('a', 'R', 'b', 'H', 'k'), prepare_force_all, block_force_all, 3, 2, (0.0,), False),
    },
    ('_mean_pressure', 1, 'a', 'R', 'b', 'H', 'k'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 2, 2, (0.0,), False),
        ('a', 'R', 'b', 'H', 'k'): (('a', 'R', 'b', 'H', 'k'), prepare_mean_pressure_all, block_mean_pressure_all, 3, 2, (0.0,), False),
    },
    ('_stiffness', 1, 'a', 'H', 'k'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 1, (), False),
        ('a', 'H', 'k'): (('a', 'H', 'k'), prepare_stiffness_all, block_stiffness_all, 1, 1, (), False),
    },
}
