"""Programs of axicontact.plane.parabola."""

from __future__ import annotations

from math import log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(np.nan)
C2 = np.array(2.0)
C3 = np.array(4.0)
C4 = np.array(3.141592653589793)


def depth(L, a, R):
    if L.__class__ is a.__class__ is R.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            if a <= L:
                if a > 0.0:
                    v3 = L - a
                    v6 = sqrt(v3 * (a + L))
                    return a * a * (L / (v6 + L) + log1p((v3 + v6) / a)) / (2.0 * R)
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(a, R):
    v8 = np.square(a)
    v16 = (2.0) * R
    v19 = np.greater(a, (0.0))
    return (a, v8, v16, v19)


def block_depth_L(out, L, a, v8, v16, v19, t0, t1, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        if v19:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.add(t0, L, t1)
            np.divide(L, t1, t1)
            np.add(out, t0, t0)
            np.divide(t0, a, t0)
            np.log1p(t0, t0)
            np.add(t1, t0, t0)
            np.multiply(v8, t0, t0)
            np.divide(t0, v16, out)
        else:
            np.copyto(out, C0)
    if some23 != size:
        np.copyto(out, C1, where=~m0)


def prepare_depth_L_a(R):
    v16 = (2.0) * R
    return (v16,)


def block_depth_L_a(out, L, a, v16, t0, t1, t2, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        np.greater(a, C0, m1)
        some20 = np.count_nonzero(m1)
        if some20:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(a, t1)
            np.add(t0, L, t2)
            np.divide(L, t2, t2)
            np.add(out, t0, t0)
            np.divide(t0, a, t0)
            np.log1p(t0, t0)
            np.add(t2, t0, t0)
            np.multiply(t1, t0, t0)
            np.divide(t0, v16, out)
        if some20 != size:
            np.copyto(out, C0, where=~m1)
    if some23 != size:
        np.copyto(out, C1, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, a, R, t0, t1, t2, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        np.greater(a, C0, m1)
        some20 = np.count_nonzero(m1)
        if some20:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(a, t1)
            np.add(t0, L, t2)
            np.divide(L, t2, t2)
            np.add(out, t0, t0)
            np.divide(t0, a, t0)
            np.log1p(t0, t0)
            np.add(t2, t0, t0)
            np.multiply(t1, t0, t0)
            np.multiply(C2, R, t1)
            np.divide(t0, t1, out)
        if some20 != size:
            np.copyto(out, C0, where=~m1)
    if some23 != size:
        np.copyto(out, C1, where=~m0)


def half_width_from_load(P, R, E_star):
    if P.__class__ is R.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return sqrt(4.0 * R / (3.141592653589793 * E_star) * P)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_half_width_from_load_P(R, E_star):
    v4 = (4.0) * R
    v6 = (3.141592653589793) * E_star
    v7 = v4 / v6
    return (v7,)


def block_half_width_from_load_P(out, P, v7):
    np.multiply(v7, P, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)


def prepare_half_width_from_load_all():
    return ()


def block_half_width_from_load_all(out, P, R, E_star, t0):
    np.multiply(C3, R, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(C4, E_star, t0)
    np.divide(out, t0, t0)
    np.multiply(t0, P, t0)
    np.sqrt(t0, out)


def load(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 3.141592653589793 * E_star / (4.0 * R) * (a * a)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(R, E_star):
    v4 = (3.141592653589793) * E_star
    v6 = (4.0) * R
    v7 = v4 / v6
    return (v7,)


def block_load_a(out, a, v7):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)


def prepare_load_all():
    return ()


def block_load_all(out, a, R, E_star, t0):
    np.multiply(C4, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C3, R, t0)
    np.divide(out, t0, t0)
    np.square(a, out)
    np.multiply(t0, out, out)


def pressure(x, a, R, E_star):
    if x.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x < a:
                return E_star / (2.0 * R) * sqrt((a - x) * (a + x))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(a, R, E_star):
    v11 = (2.0) * R
    v12 = E_star / v11
    return (a, v12)


def block_pressure_x(out, x, a, v12, t0, f0):
    np.subtract(a, x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if largest_x > a:
        np.maximum(out, f0, out=out)
    np.add(a, x, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(v12, t0, out)


def prepare_pressure_x_a(R, E_star):
    v9 = (2.0) * R
    v10 = E_star / v9
    return (v10,)


def block_pressure_x_a(out, x, a, v10, t0, m0):
    size = out.size
    np.less(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some14 = np.count_nonzero(m0)
    if some14:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(v10, t0, out)
    if some14 != size:
        np.copyto(out, C0, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, a, R, E_star, t0, m0):
    size = out.size
    np.less(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some14 = np.count_nonzero(m0)
    if some14:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C2, R, out)
        np.divide(E_star, out, out)
        np.multiply(out, t0, out)
    if some14 != size:
        np.copyto(out, C0, where=~m0)


def profile(x, R):
    if x.__class__ is R.__class__ is float and x > 1e-30 and (x < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return x * x / (2.0 * R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(R):
    v4 = (2.0) * R
    return (v4,)


def block_profile_x(out, x, v4):
    np.square(x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.divide(out, v4, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, R, t0):
    np.square(x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(C2, R, t0)
    np.divide(out, t0, out)


def slope(x, a, R):
    if x.__class__ is a.__class__ is R.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            if x > a:
                return -(a * a) / (R * (sqrt((x - a) * (a + x)) + x))
            return -(x / R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(a, R):
    v9 = np.square(a)
    v10 = np.negative(v9)
    return (a, R, v10)


def block_slope_x(out, x, a, R, v10, t0, m0):
    size = out.size
    np.greater(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(x, a, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(t0, x, t0)
        np.multiply(R, t0, t0)
        np.divide(v10, t0, out)
    if some16 != size:
        other16 = t0 if some16 else out
        np.divide(x, R, other16)
        np.negative(other16, other16)
        if some16:
            np.copyto(out, other16, where=~m0)


def prepare_slope_x_a(R):
    return (R,)


def block_slope_x_a(out, x, a, R, t0, m0):
    size = out.size
    np.greater(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(x, a, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(t0, x, t0)
        np.square(a, out)
        np.negative(out, out)
        np.multiply(R, t0, t0)
        np.divide(out, t0, out)
    if some16 != size:
        other16 = t0 if some16 else out
        np.divide(x, R, other16)
        np.negative(other16, other16)
        if some16:
            np.copyto(out, other16, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, a, R, t0, m0):
    size = out.size
    np.greater(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(x, a, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(t0, x, t0)
        np.square(a, out)
        np.negative(out, out)
        np.multiply(R, t0, t0)
        np.divide(out, t0, out)
    if some16 != size:
        other16 = t0 if some16 else out
        np.divide(x, R, other16)
        np.negative(other16, other16)
        if some16:
            np.copyto(out, other16, where=~m0)


BLOCKS = {
    ('_depth', 2, 'L', 'a', 'R'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 2, 1, (), False),
        ('L', 'a'): (('L', 'a'), prepare_depth_L_a, block_depth_L_a, 3, 2, (), False),
        ('L', 'a', 'R'): (('L', 'a', 'R'), prepare_depth_all, block_depth_all, 3, 2, (), False),
    },
    ('_half_width_from_load', 1, 'P', 'R', 'E_star'): {
        ('P',): (('P',), prepare_half_width_from_load_P, block_half_width_from_load_P, 0, 0, (), False),
        ('P', 'R', 'E_star'): (('P', 'R', 'E_star'), prepare_half_width_from_load_all, block_half_width_from_load_all, 1, 0, (), False),
    },
    ('_load', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 0, 0, (), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_load_all, block_load_all, 1, 0, (), False),
    },
    ('_pressure', 2, 'x', 'a', 'R', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 1, 0, (0.0,), True),
        ('x', 'a'): (('x', 'a'), prepare_pressure_x_a, block_pressure_x_a, 1, 1, (), False),
        ('x', 'a', 'R', 'E_star'): (('x', 'a', 'R', 'E_star'), prepare_pressure_all, block_pressure_all, 1, 1, (), False),
    },
    ('_profile', 1, 'x', 'R'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 0, (), False),
        ('x', 'R'): (('x', 'R'), prepare_profile_all, block_profile_all, 1, 0, (), False),
    },
    ('_slope', 2, 'x', 'a', 'R'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 1, 1, (), False),
        ('x', 'a'): (('x', 'a'), prepare_slope_x_a, block_slope_x_a, 1, 1, (), False),
        ('x', 'a', 'R'): (('x', 'a', 'R'), prepare_slope_all, block_slope_all, 1, 1, (), False),
    },
}
