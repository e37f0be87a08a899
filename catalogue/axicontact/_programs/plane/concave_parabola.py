"""Programs of axicontact.plane.concave_parabola."""

from __future__ import annotations

from math import log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(np.nan)
C1 = np.array(2.0)
C2 = np.array(3.141592653589793)
C3 = np.array(0.5)
C4 = np.array(0.999999999999999)
C5 = np.array(0.0)
C6 = np.array(-2.0)


def depth(L, P, a, h, E_star):
    if L.__class__ is P.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and L > 1e-30 and (L < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v16 = 3.141592653589793 * E_star
            if v16 * h / 2.0 * 0.999999999999999 <= P:
                if a <= L:
                    v5 = L - a
                    v8 = sqrt(v5 * (a + L))
                    return 2.0 * P * log1p((v5 + v8) / a) / v16 - h * L / (v8 + L)
                return nan
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(P, a, h, E_star):
    v10 = (2.0) * P
    v16 = (3.141592653589793) * E_star
    v22 = v16 * h
    v23 = v22 / (2.0)
    v25 = v23 * (0.999999999999999)
    v26 = np.less_equal(v25, P)
    return (a, h, v10, v16, v26)


def block_depth_L(out, L, a, h, v10, v16, v26, t0, t1, m0):
    size = out.size
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    if v26:
        np.less_equal(a, L, m0)
        some29 = np.count_nonzero(m0)
        if some29:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.add(out, t0, out)
            np.divide(out, a, out)
            np.log1p(out, out)
            np.multiply(v10, out, out)
            np.divide(out, v16, out)
            np.add(t0, L, t0)
            np.multiply(h, L, t1)
            np.divide(t1, t0, t0)
            np.subtract(out, t0, out)
        if some29 != size:
            np.copyto(out, C0, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_depth_L_P(a, h, E_star):
    v16 = (3.141592653589793) * E_star
    v22 = v16 * h
    v23 = v22 / (2.0)
    v25 = v23 * (0.999999999999999)
    return (a, h, v16, v25)


def block_depth_L_P(out, L, P, a, h, v16, v25, t0, t1, m0, m1):
    size = out.size
    np.less_equal(v25, P, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.less_equal(a, L, m1)
        some29 = np.count_nonzero(m1)
        if some29:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C1, P, t1)
            np.add(out, t0, out)
            np.divide(out, a, out)
            np.log1p(out, out)
            np.multiply(t1, out, out)
            np.divide(out, v16, out)
            np.add(t0, L, t0)
            np.multiply(h, L, t1)
            np.divide(t1, t0, t0)
            np.subtract(out, t0, out)
        if some29 != size:
            np.copyto(out, C0, where=~m1)
    if some30 != size:
        np.copyto(out, C0, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, P, a, h, E_star, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C2, E_star, t0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t1)
    np.multiply(t1, C3, t1)
    np.multiply(t1, C4, t1)
    np.less_equal(t1, P, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.less_equal(a, L, m1)
        some30 = np.count_nonzero(m1)
        if some30:
            np.subtract(L, a, out)
            np.add(a, L, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.multiply(C1, P, t2)
            np.add(out, t1, out)
            np.divide(out, a, out)
            np.log1p(out, out)
            np.multiply(t2, out, out)
            np.divide(out, t0, out)
            np.add(t1, L, t1)
            np.multiply(h, L, t2)
            np.divide(t2, t1, t1)
            np.subtract(out, t1, out)
        if some30 != size:
            np.copyto(out, C0, where=~m1)
    if some31 != size:
        np.copyto(out, C0, where=~m0)


def minimum_load(h, E_star, a=1.0):
    if h.__class__ is E_star.__class__ is a.__class__ is float and h > 1e-30 and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            return 3.141592653589793 * E_star * h / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_load_all_signed():
    return ()


def block_minimum_load_all_signed(out, h, E_star):
    np.multiply(C2, E_star, out)
    np.multiply(out, h, out)
    np.multiply(out, C3, out)


def pressure(x, P, a, h, E_star):
    if x.__class__ is P.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v11 = 3.141592653589793 * E_star * h
            v17 = v11 / 2.0
            if v17 * 0.999999999999999 <= P:
                if x <= a and P > 0.0:
                    return (P - v17 + v11 * (x * x) / (a * a)) / (3.141592653589793 * sqrt((a - x) * (a + x)))
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(P, a, h, E_star):
    v10 = (3.141592653589793) * E_star
    v11 = v10 * h
    v15 = np.square(a)
    v17 = v11 / (2.0)
    v18 = P - v17
    v23 = v17 * (0.999999999999999)
    v24 = np.less_equal(v23, P)
    v27 = np.greater(P, (0.0))
    return (a, v11, v15, v18, v24, v27)


def block_pressure_x(out, x, a, v11, v15, v18, v24, v27, t0, m0):
    size = out.size
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if v24:
        np.less_equal(x, a, m0)
        np.bitwise_and(m0, v27, m0)
        some29 = np.count_nonzero(m0)
        if some29:
            np.subtract(a, x, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(x, out)
            np.multiply(v11, out, out)
            np.divide(out, v15, out)
            np.add(v18, out, out)
            np.multiply(C2, t0, t0)
            np.divide(out, t0, out)
        if some29 != size:
            np.copyto(out, C5, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_pressure_x_P(a, h, E_star):
    v10 = (3.141592653589793) * E_star
    v11 = v10 * h
    v15 = np.square(a)
    v17 = v11 / (2.0)
    v23 = v17 * (0.999999999999999)
    return (a, v11, v15, v17, v23)


def block_pressure_x_P(out, x, P, a, v11, v15, v17, v23, t0, t1, m0, m1, m2):
    size = out.size
    np.less_equal(v23, P, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some31 = np.count_nonzero(m0)
    if some31:
        np.less_equal(x, a, m1)
        np.greater(P, C5, m2)
        np.bitwise_and(m1, m2, m2)
        some29 = np.count_nonzero(m2)
        if some29:
            np.subtract(a, x, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(x, out)
            np.multiply(v11, out, out)
            np.divide(out, v15, out)
            np.subtract(P, v17, t1)
            np.add(t1, out, out)
            np.multiply(C2, t0, t0)
            np.divide(out, t0, out)
        if some29 != size:
            np.copyto(out, C5, where=~m2)
    if some31 != size:
        np.copyto(out, C0, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, P, a, h, E_star, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.multiply(C2, E_star, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t0)
    np.multiply(t0, C3, t1)
    np.multiply(t1, C4, t2)
    np.less_equal(t2, P, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.less_equal(x, a, m1)
        np.greater(P, C5, m2)
        np.bitwise_and(m1, m2, m2)
        some30 = np.count_nonzero(m2)
        if some30:
            np.subtract(a, x, out)
            np.add(a, x, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.square(x, out)
            np.multiply(t0, out, out)
            np.square(a, t3)
            np.divide(out, t3, t3)
            np.subtract(P, t1, out)
            np.add(out, t3, t3)
            np.multiply(C2, t2, t2)
            np.divide(t3, t2, out)
        if some30 != size:
            np.copyto(out, C5, where=~m2)
    if some32 != size:
        np.copyto(out, C0, where=~m0)


def profile(x, a, h):
    if x.__class__ is a.__class__ is h.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            if x <= a:
                return -h * (x * x) / (a * a)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(a, h):
    v4 = np.negative(h)
    v8 = np.square(a)
    return (a, v4, v8)


def block_profile_x(out, x, a, v4, v8, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.square(x, out)
        np.multiply(v4, out, out)
        np.divide(out, v8, out)
    if some11 != size:
        np.copyto(out, C0, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, a, h, t0, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.negative(h, out)
        np.square(x, t0)
        np.multiply(out, t0, t0)
        np.square(a, out)
        np.divide(t0, out, out)
    if some11 != size:
        np.copyto(out, C0, where=~m0)


def slope(x, P, a, h, E_star):
    if x.__class__ is P.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v12 = 3.141592653589793 * E_star
            if v12 * h / 2.0 * 0.999999999999999 <= P:
                v21 = a * a
                if x >= a:
                    if P > 0.0:
                        v8 = sqrt((x - a) * (a + x))
                        return -2.0 * P / (v12 * v8) - h * v21 / ((2.0 * (v8 * v8) + 2.0 * x * v8 + v21) * v8)
                    return 0.0
                return -(-2.0 * h * x / v21)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(P, a, h, E_star):
    v10 = (-2.0) * P
    v12 = (3.141592653589793) * E_star
    v21 = np.square(a)
    v23 = h * v21
    v28 = np.greater(P, (0.0))
    v30 = v12 * h
    v31 = v30 / (2.0)
    v33 = v31 * (0.999999999999999)
    v34 = np.less_equal(v33, P)
    v36 = (-2.0) * h
    return (a, v10, v12, v21, v23, v28, v34, v36)


def block_slope_x(out, x, a, v10, v12, v21, v23, v28, v34, v36, t0, t1, t2, m0):
    size = out.size
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if v34:
        np.greater_equal(x, a, m0)
        some40 = np.count_nonzero(m0)
        if some40:
            if v28:
                np.subtract(x, a, out)
                np.add(a, x, t0)
                np.multiply(out, t0, t0)
                np.sqrt(t0, t0)
                np.multiply(v12, t0, out)
                np.divide(v10, out, out)
                np.square(t0, t1)
                np.multiply(C1, t1, t1)
                np.multiply(C1, x, t2)
                np.multiply(t2, t0, t2)
                np.add(t1, t2, t2)
                np.add(t2, v21, t2)
                np.multiply(t2, t0, t0)
                np.divide(v23, t0, t0)
                np.subtract(out, t0, out)
            else:
                np.copyto(out, C5)
        if some40 != size:
            other40 = t0 if some40 else out
            np.multiply(v36, x, other40)
            np.divide(other40, v21, other40)
            np.negative(other40, other40)
            if some40:
                np.copyto(out, other40, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_slope_x_P(a, h, E_star):
    v12 = (3.141592653589793) * E_star
    v21 = np.square(a)
    v23 = h * v21
    v30 = v12 * h
    v31 = v30 / (2.0)
    v33 = v31 * (0.999999999999999)
    v36 = (-2.0) * h
    return (a, v12, v21, v23, v33, v36)


def block_slope_x_P(out, x, P, a, v12, v21, v23, v33, v36, t0, t1, t2, m0, m1, m2):
    size = out.size
    np.less_equal(v33, P, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some42 = np.count_nonzero(m0)
    if some42:
        np.greater_equal(x, a, m1)
        some40 = np.count_nonzero(m1)
        if some40:
            np.greater(P, C5, m2)
            some29 = np.count_nonzero(m2)
            if some29:
                np.subtract(x, a, out)
                np.add(a, x, t0)
                np.multiply(out, t0, t0)
                np.sqrt(t0, t0)
                np.multiply(C6, P, out)
                np.multiply(v12, t0, t1)
                np.divide(out, t1, t1)
                np.square(t0, out)
                np.multiply(C1, out, out)
                np.multiply(C1, x, t2)
                np.multiply(t2, t0, t2)
                np.add(out, t2, t2)
                np.add(t2, v21, t2)
                np.multiply(t2, t0, t0)
                np.divide(v23, t0, t0)
                np.subtract(t1, t0, out)
            if some29 != size:
                np.copyto(out, C5, where=~m2)
        if some40 != size:
            other40 = t0 if some40 else out
            np.multiply(v36, x, other40)
            np.divide(other40, v21, other40)
            np.negative(other40, other40)
            if some40:
                np.copyto(out, other40, where=~m1)
    if some42 != size:
        np.copyto(out, C0, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, P, a, h, E_star, t0, t1, t2, t3, t4, m0, m1, m2):
    size = out.size
    np.multiply(C2, E_star, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t1)
    np.multiply(t1, C3, t1)
    np.multiply(t1, C4, t1)
    np.less_equal(t1, P, m0)
    some43 = np.count_nonzero(m0)
    if some43:
        np.square(a, t1)
        np.greater_equal(x, a, m1)
        some41 = np.count_nonzero(m1)
        if some41:
            np.greater(P, C5, m2)
            some29 = np.count_nonzero(m2)
            if some29:
                np.subtract(x, a, out)
                np.add(a, x, t2)
                np.multiply(out, t2, t2)
                np.sqrt(t2, t2)
                np.multiply(C6, P, out)
                np.multiply(t0, t2, t3)
                np.divide(out, t3, t3)
                np.square(t2, out)
                np.multiply(C1, out, out)
                np.multiply(C1, x, t4)
                np.multiply(t4, t2, t4)
                np.add(out, t4, t4)
                np.add(t4, t1, t4)
                np.multiply(h, t1, out)
                np.multiply(t4, t2, t2)
                np.divide(out, t2, t2)
                np.subtract(t3, t2, out)
            if some29 != size:
                np.copyto(out, C5, where=~m2)
        if some41 != size:
            other41 = t2 if some41 else out
            np.multiply(C6, h, other41)
            np.multiply(other41, x, other41)
            np.divide(other41, t1, other41)
            np.negative(other41, other41)
            if some41:
                np.copyto(out, other41, where=~m1)
    if some43 != size:
        np.copyto(out, C0, where=~m0)


def zero_distance(a, h=1.0):
    if a.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            return 0.0 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_zero_distance_all_signed():
    return ()


def block_zero_distance_all_signed(out, a):
    np.multiply(C5, a, out)


BLOCKS = {
    ('_depth', 2, 'L', 'P', 'a', 'h', 'E_star'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 2, 1, (), False),
        ('L', 'P'): (('L', 'P'), prepare_depth_L_P, block_depth_L_P, 2, 2, (), False),
        ('L', 'P', 'a', 'h', 'E_star'): (('L', 'P', 'a', 'h', 'E_star'), prepare_depth_all, block_depth_all, 3, 2, (), False),
    },
    ('_minimum_load', 0, 'h', 'E_star'): {
        ('h', 'E_star'): (('h', 'E_star'), prepare_minimum_load_all_signed, block_minimum_load_all_signed, 0, 0, (), False),
    },
    ('_pressure', 2, 'x', 'P', 'a', 'h', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 1, 1, (), False),
        ('x', 'P'): (('x', 'P'), prepare_pressure_x_P, block_pressure_x_P, 2, 3, (), False),
        ('x', 'P', 'a', 'h', 'E_star'): (('x', 'P', 'a', 'h', 'E_star'), prepare_pressure_all, block_pressure_all, 4, 3, (), False),
    },
    ('_profile', 1, 'x', 'a', 'h'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 1, (), False),
        ('x', 'a', 'h'): (('x', 'a', 'h'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_slope', 2, 'x', 'P', 'a', 'h', 'E_star'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 3, 1, (), False),
        ('x', 'P'): (('x', 'P'), prepare_slope_x_P, block_slope_x_P, 3, 3, (), False),
        ('x', 'P', 'a', 'h', 'E_star'): (('x', 'P', 'a', 'h', 'E_star'), prepare_slope_all, block_slope_all, 5, 3, (), False),
    },
    ('_zero_distance', 0, 'a'): {
        ('a',): (('a',), prepare_zero_distance_all_signed, block_zero_distance_all_signed, 0, 0, (), False),
    },
}
