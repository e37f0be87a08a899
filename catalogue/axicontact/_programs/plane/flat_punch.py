"""Programs of axicontact.plane.flat_punch."""

from __future__ import annotations

from math import log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(np.nan)
C1 = np.array(2.0)
C2 = np.array(3.141592653589793)
C3 = np.array(0.0)
C4 = np.array(-2.0)


def depth(L, P, a, E_star):
    if L.__class__ is P.__class__ is a.__class__ is E_star.__class__ is float and L > 1e-30 and (L < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= L:
                v4 = L - a
                return 2.0 * P * log1p((v4 + sqrt(v4 * (a + L))) / a) / (3.141592653589793 * E_star)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(P, a, E_star):
    v9 = (2.0) * P
    v15 = (3.141592653589793) * E_star
    return (a, v9, v15)


def block_depth_L(out, L, a, v9, v15, t0, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(L, a, out)
        np.add(a, L, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(out, t0, t0)
        np.divide(t0, a, t0)
        np.log1p(t0, t0)
        np.multiply(v9, t0, t0)
        np.divide(t0, v15, out)
    if some19 != size:
        np.copyto(out, C0, where=~m0)


def prepare_depth_L_P(a, E_star):
    v15 = (3.141592653589793) * E_star
    return (a, v15)


def block_depth_L_P(out, L, P, a, v15, t0, t1, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(L, a, out)
        np.add(a, L, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C1, P, t1)
        np.add(out, t0, t0)
        np.divide(t0, a, t0)
        np.log1p(t0, t0)
        np.multiply(t1, t0, t0)
        np.divide(t0, v15, out)
    if some19 != size:
        np.copyto(out, C0, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, P, a, E_star, t0, t1, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(L, a, out)
        np.add(a, L, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C1, P, t1)
        np.add(out, t0, t0)
        np.divide(t0, a, t0)
        np.log1p(t0, t0)
        np.multiply(t1, t0, t0)
        np.multiply(C2, E_star, t1)
        np.divide(t0, t1, out)
    if some19 != size:
        np.copyto(out, C0, where=~m0)


def pressure(x, P, a):
    if x.__class__ is P.__class__ is a.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            if x <= a and P > 0.0:
                return P / (3.141592653589793 * sqrt((a - x) * (a + x)))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(P, a):
    v12 = np.greater(P, (0.0))
    return (P, a, v12)


def block_pressure_x(out, x, P, a, v12, t0, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v12, m0)
    some14 = np.count_nonzero(m0)
    if some14:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C2, t0, t0)
        np.divide(P, t0, out)
    if some14 != size:
        np.copyto(out, C3, where=~m0)


def prepare_pressure_x_P(a):
    return (a,)


def block_pressure_x_P(out, x, P, a, t0, m0, m1):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.greater(P, C3, m1)
    np.bitwise_and(m0, m1, m1)
    some14 = np.count_nonzero(m1)
    if some14:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C2, t0, t0)
        np.divide(P, t0, out)
    if some14 != size:
        np.copyto(out, C3, where=~m1)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, P, a, t0, m0, m1):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.greater(P, C3, m1)
    np.bitwise_and(m0, m1, m1)
    some14 = np.count_nonzero(m1)
    if some14:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C2, t0, t0)
        np.divide(P, t0, out)
    if some14 != size:
        np.copyto(out, C3, where=~m1)


def profile(x, a):
    if x.__class__ is a.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            if x <= a:
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(a):
    return (a,)


def block_profile_x(out, x, a, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some5 = np.count_nonzero(m0)
    if some5:
        np.copyto(out, C3)
    if some5 != size:
        np.copyto(out, C0, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, a, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some5 = np.count_nonzero(m0)
    if some5:
        np.copyto(out, C3)
    if some5 != size:
        np.copyto(out, C0, where=~m0)


def slope(x, P, a, E_star):
    if x.__class__ is P.__class__ is a.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x >= a:
                if P > 0.0:
                    return -2.0 * P / (3.141592653589793 * E_star * sqrt((x - a) * (a + x)))
                return 0.0
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(P, a, E_star):
    v9 = (-2.0) * P
    v11 = (3.141592653589793) * E_star
    v15 = np.greater(P, (0.0))
    return (a, v9, v11, v15)


def block_slope_x(out, x, a, v9, v11, v15, t0, m0):
    size = out.size
    np.greater_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        if v15:
            np.subtract(x, a, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(v11, t0, t0)
            np.divide(v9, t0, out)
        else:
            np.copyto(out, C3)
    if some18 != size:
        np.copyto(out, C3, where=~m0)


def prepare_slope_x_P(a, E_star):
    v11 = (3.141592653589793) * E_star
    return (a, v11)


def block_slope_x_P(out, x, P, a, v11, t0, m0, m1):
    size = out.size
    np.greater_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.greater(P, C3, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.subtract(x, a, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C4, P, out)
            np.multiply(v11, t0, t0)
            np.divide(out, t0, out)
        if some16 != size:
            np.copyto(out, C3, where=~m1)
    if some18 != size:
        np.copyto(out, C3, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, P, a, E_star, t0, t1, m0, m1):
    size = out.size
    np.greater_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.greater(P, C3, m1)
        some16 = np.count_nonzero(m1)
        if some16:
            np.subtract(x, a, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C4, P, out)
            np.multiply(C2, E_star, t1)
            np.multiply(t1, t0, t0)
            np.divide(out, t0, out)
        if some16 != size:
            np.copyto(out, C3, where=~m1)
    if some18 != size:
        np.copyto(out, C3, where=~m0)


BLOCKS = {
    ('_depth', 2, 'L', 'P', 'a', 'E_star'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 1, 1, (), False),
        ('L', 'P'): (('L', 'P'), prepare_depth_L_P, block_depth_L_P, 2, 1, (), False),
        ('L', 'P', 'a', 'E_star'): (('L', 'P', 'a', 'E_star'), prepare_depth_all, block_depth_all, 2, 1, (), False),
    },
    ('_pressure', 2, 'x', 'P', 'a'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 1, 1, (), False),
        ('x', 'P'): (('x', 'P'), prepare_pressure_x_P, block_pressure_x_P, 1, 2, (), False),
        ('x', 'P', 'a'): (('x', 'P', 'a'), prepare_pressure_all, block_pressure_all, 1, 2, (), False),
    },
    ('_profile', 1, 'x', 'a'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 1, (), False),
        ('x', 'a'): (('x', 'a'), prepare_profile_all, block_profile_all, 0, 1, (), False),
    },
    ('_slope', 2, 'x', 'P', 'a', 'E_star'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 1, 1, (), False),
        ('x', 'P'): (('x', 'P'), prepare_slope_x_P, block_slope_x_P, 1, 2, (), False),
        ('x', 'P', 'a', 'E_star'): (('x', 'P', 'a', 'E_star'), prepare_slope_all, block_slope_all, 2, 2, (), False),
    },
}
