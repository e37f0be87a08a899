"""Programs of axicontact.plane.wedge."""

from __future__ import annotations

from math import atan2, log1p, nan, sqrt, tan

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(np.nan)
C2 = np.array(2.0)
C3 = np.array(3.141592653589793)
C4 = np.array(-2.0)


def depth(L, a, theta):
    if L.__class__ is a.__class__ is theta.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            if a <= L:
                if a > 0.0:
                    v3 = L - a
                    v6 = sqrt(v3 * (a + L))
                    return 2.0 * tan(theta) / 3.141592653589793 * (L * atan2(a, v6) + a * log1p((v3 + v6) / a))
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(a, theta):
    v8 = np.tan(theta)
    v10 = (2.0) * v8
    v12 = v10 / (3.141592653589793)
    v21 = np.greater(a, (0.0))
    return (a, v12, v21)


def block_depth_L(out, L, a, v12, v21, t0, t1, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        if v21:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.arctan2(a, t0, t1)
            np.multiply(L, t1, t1)
            np.add(out, t0, t0)
            np.divide(t0, a, t0)
            np.log1p(t0, t0)
            np.multiply(a, t0, t0)
            np.add(t1, t0, t0)
            np.multiply(v12, t0, out)
        else:
            np.copyto(out, C0)
    if some25 != size:
        np.copyto(out, C1, where=~m0)


def prepare_depth_L_a(theta):
    v8 = np.tan(theta)
    v10 = (2.0) * v8
    v12 = v10 / (3.141592653589793)
    return (v12,)


def block_depth_L_a(out, L, a, v12, t0, t1, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        np.greater(a, C0, m1)
        some22 = np.count_nonzero(m1)
        if some22:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.arctan2(a, t0, t1)
            np.multiply(L, t1, t1)
            np.add(out, t0, t0)
            np.divide(t0, a, t0)
            np.log1p(t0, t0)
            np.multiply(a, t0, t0)
            np.add(t1, t0, t0)
            np.multiply(v12, t0, out)
        if some22 != size:
            np.copyto(out, C0, where=~m1)
    if some25 != size:
        np.copyto(out, C1, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, a, theta, t0, t1, t2, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        np.greater(a, C0, m1)
        some22 = np.count_nonzero(m1)
        if some22:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.arctan2(a, t0, t1)
            np.tan(theta, t2)
            np.multiply(C2, t2, t2)
            np.divide(t2, C3, t2)
            np.multiply(L, t1, t1)
            np.add(out, t0, t0)
            np.divide(t0, a, t0)
            np.log1p(t0, t0)
            np.multiply(a, t0, t0)
            np.add(t1, t0, t0)
            np.multiply(t2, t0, out)
        if some22 != size:
            np.copyto(out, C0, where=~m1)
    if some25 != size:
        np.copyto(out, C1, where=~m0)


def half_width_from_load(P, theta, E_star):
    if P.__class__ is theta.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return P / (E_star * tan(theta))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_half_width_from_load_P(theta, E_star):
    v3 = np.tan(theta)
    v4 = E_star * v3
    return (v4,)


def block_half_width_from_load_P(out, P, v4):
    np.divide(P, v4, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError


def prepare_half_width_from_load_all():
    return ()


def block_half_width_from_load_all(out, P, theta, E_star):
    np.tan(theta, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(E_star, out, out)
    np.divide(P, out, out)


def load(a, theta, E_star):
    if a.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return E_star * tan(theta) * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(theta, E_star):
    v3 = np.tan(theta)
    v4 = E_star * v3
    return (v4,)


def block_load_a(out, a, v4):
    np.multiply(v4, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_load_all():
    return ()


def block_load_all(out, a, theta, E_star):
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(E_star, out, out)
    np.multiply(out, a, out)


def pressure(x, a, theta, E_star):
    if x.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x < a:
                v4 = a - x
                return E_star * tan(theta) / 3.141592653589793 * log1p((v4 + sqrt(v4 * (a + x))) / x)
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(a, theta, E_star):
    v10 = np.tan(theta)
    v11 = E_star * v10
    v13 = v11 / (3.141592653589793)
    return (a, v13)


def block_pressure_x(out, x, a, v13, t0, f0):
    np.subtract(a, x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if largest_x > a:
        np.maximum(out, f0, out=out)
    np.add(a, x, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.add(out, t0, t0)
    np.divide(t0, x, t0)
    np.log1p(t0, t0)
    np.multiply(v13, t0, out)


def prepare_pressure_x_a(theta, E_star):
    v8 = np.tan(theta)
    v9 = E_star * v8
    v11 = v9 / (3.141592653589793)
    return (v11,)


def block_pressure_x_a(out, x, a, v11, t0, m0):
    size = out.size
    np.less(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(out, t0, t0)
        np.divide(t0, x, t0)
        np.log1p(t0, t0)
        np.multiply(v11, t0, out)
    if some18 != size:
        np.copyto(out, C0, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, a, theta, E_star, t0, t1, m0):
    size = out.size
    np.less(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some18 = np.count_nonzero(m0)
    if some18:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.tan(theta, t1)
        np.multiply(E_star, t1, t1)
        np.divide(t1, C3, t1)
        np.add(out, t0, t0)
        np.divide(t0, x, t0)
        np.log1p(t0, t0)
        np.multiply(t1, t0, out)
    if some18 != size:
        np.copyto(out, C0, where=~m0)


def profile(x, theta):
    if x.__class__ is theta.__class__ is float and x > 1e-30 and (x < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            return tan(theta) * x
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(theta):
    v2 = np.tan(theta)
    return (v2,)


def block_profile_x(out, x, v2):
    np.multiply(v2, x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError


def prepare_profile_all():
    return ()


def block_profile_all(out, x, theta):
    np.tan(theta, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(out, x, out)


def slope(x, a, theta):
    if x.__class__ is a.__class__ is theta.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            v8 = tan(theta)
            if x > a:
                return -2.0 * v8 / 3.141592653589793 * atan2(a, sqrt((x - a) * (a + x)))
            return -v8
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(a, theta):
    v8 = np.tan(theta)
    v10 = (-2.0) * v8
    v12 = v10 / (3.141592653589793)
    v15 = np.negative(v8)
    return (a, v12, v15)


def block_slope_x(out, x, a, v12, v15, t0, m0):
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
        np.arctan2(a, t0, t0)
        np.multiply(v12, t0, out)
    if some16 != size:
        np.copyto(out, v15, where=~m0)


def prepare_slope_x_a(theta):
    v8 = np.tan(theta)
    v10 = (-2.0) * v8
    v12 = v10 / (3.141592653589793)
    v15 = np.negative(v8)
    return (v12, v15)


def block_slope_x_a(out, x, a, v12, v15, t0, m0):
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
        np.arctan2(a, t0, t0)
        np.multiply(v12, t0, out)
    if some16 != size:
        np.copyto(out, v15, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, a, theta, t0, t1, m0):
    size = out.size
    np.tan(theta, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(x, a, m0)
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(x, a, out)
        np.add(a, x, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.arctan2(a, t1, t1)
        np.multiply(C4, t0, out)
        np.divide(out, C3, out)
        np.multiply(out, t1, out)
    if some16 != size:
        other16 = t1 if some16 else out
        np.negative(t0, other16)
        if some16:
            np.copyto(out, other16, where=~m0)


BLOCKS = {
    ('_depth', 2, 'L', 'a', 'theta'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 2, 1, (), False),
        ('L', 'a'): (('L', 'a'), prepare_depth_L_a, block_depth_L_a, 2, 2, (), False),
        ('L', 'a', 'theta'): (('L', 'a', 'theta'), prepare_depth_all, block_depth_all, 3, 2, (), False),
    },
    ('_half_width_from_load', 1, 'P', 'theta', 'E_star'): {
        ('P',): (('P',), prepare_half_width_from_load_P, block_half_width_from_load_P, 0, 0, (), False),
        ('P', 'theta', 'E_star'): (('P', 'theta', 'E_star'), prepare_half_width_from_load_all, block_half_width_from_load_all, 0, 0, (), False),
    },
    ('_load', 1, 'a', 'theta', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 0, 0, (), False),
        ('a', 'theta', 'E_star'): (('a', 'theta', 'E_star'), prepare_load_all, block_load_all, 0, 0, (), False),
    },
    ('_pressure', 2, 'x', 'a', 'theta', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 1, 0, (0.0,), True),
        ('x', 'a'): (('x', 'a'), prepare_pressure_x_a, block_pressure_x_a, 1, 1, (), False),
        ('x', 'a', 'theta', 'E_star'): (('x', 'a', 'theta', 'E_star'), prepare_pressure_all, block_pressure_all, 2, 1, (), False),
    },
    ('_profile', 1, 'x', 'theta'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 0, (), False),
        ('x', 'theta'): (('x', 'theta'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
    ('_slope', 2, 'x', 'a', 'theta'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 1, 1, (), False),
        ('x', 'a'): (('x', 'a'), prepare_slope_x_a, block_slope_x_a, 1, 1, (), False),
        ('x', 'a', 'theta'): (('x', 'a', 'theta'), prepare_slope_all, block_slope_all, 2, 1, (), False),
    },
}
