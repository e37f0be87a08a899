"""Programs of axicontact.plane.quartic."""

from __future__ import annotations

from math import asinh, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(3.0)
C2 = np.array(0.0)
C3 = np.array(np.nan)
C4 = np.array(0.5)
C5 = np.array(4.0)
C6 = np.array(9.42477796076938)
C7 = np.array(0.25)
C8 = np.array(-2.0)


def depth(L, a, A):
    if L.__class__ is a.__class__ is A.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            if a <= L:
                if a > 0.0:
                    v6 = sqrt((L - a) * (a + L))
                    v9 = L * L
                    v12 = a * a
                    value = A * (v12 * v12) * (3.0 * asinh(v6 / a) + L * (v12 + 3.0 * v9) / (2.0 * (L * v9) + (v12 + 2.0 * v9) * v6)) / 2.0
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(a, A):
    v12 = np.square(a)
    v17 = np.square(v12)
    v18 = A * v17
    v29 = v18 * (0.5)
    v32 = np.greater(a, (0.0))
    return (a, v12, v29, v32)


def block_depth_L(out, L, a, v12, v29, v32, t0, t1, t2, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    some36 = np.count_nonzero(m0)
    if some36:
        if v32:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(L, out)
            np.multiply(L, out, t1)
            np.multiply(C0, t1, t1)
            np.multiply(C0, out, t2)
            np.add(v12, t2, t2)
            np.multiply(t2, t0, t2)
            np.add(t1, t2, t2)
            np.divide(t0, a, t0)
            np.arcsinh(t0, t0)
            np.multiply(C1, t0, t0)
            np.multiply(C1, out, out)
            np.add(v12, out, out)
            np.multiply(L, out, out)
            np.divide(out, t2, t2)
            np.add(t0, t2, t2)
            np.multiply(v29, t2, out)
        else:
            np.copyto(out, C2)
    if some36 != size:
        np.copyto(out, C3, where=~m0)


def prepare_depth_L_a(A):
    return (A,)


def block_depth_L_a(out, L, a, A, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some35 = np.count_nonzero(m0)
    if some35:
        np.greater(a, C2, m1)
        some32 = np.count_nonzero(m1)
        if some32:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(L, out)
            np.multiply(L, out, t1)
            np.multiply(C0, t1, t1)
            np.square(a, t2)
            np.multiply(C0, out, t3)
            np.add(t2, t3, t3)
            np.multiply(t3, t0, t3)
            np.add(t1, t3, t3)
            np.square(t2, t1)
            np.multiply(A, t1, t1)
            np.divide(t0, a, t0)
            np.arcsinh(t0, t0)
            np.multiply(C1, t0, t0)
            np.multiply(C1, out, out)
            np.add(t2, out, out)
            np.multiply(L, out, out)
            np.divide(out, t3, t3)
            np.add(t0, t3, t3)
            np.multiply(t1, t3, t3)
            np.multiply(t3, C4, out)
        if some32 != size:
            np.copyto(out, C2, where=~m1)
    if some35 != size:
        np.copyto(out, C3, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, a, A, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some35 = np.count_nonzero(m0)
    if some35:
        np.greater(a, C2, m1)
        some32 = np.count_nonzero(m1)
        if some32:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(L, out)
            np.multiply(L, out, t1)
            np.multiply(C0, t1, t1)
            np.square(a, t2)
            np.multiply(C0, out, t3)
            np.add(t2, t3, t3)
            np.multiply(t3, t0, t3)
            np.add(t1, t3, t3)
            np.square(t2, t1)
            np.multiply(A, t1, t1)
            np.divide(t0, a, t0)
            np.arcsinh(t0, t0)
            np.multiply(C1, t0, t0)
            np.multiply(C1, out, out)
            np.add(t2, out, out)
            np.multiply(L, out, out)
            np.divide(out, t3, t3)
            np.add(t0, t3, t3)
            np.multiply(t1, t3, t3)
            np.multiply(t3, C4, out)
        if some32 != size:
            np.copyto(out, C2, where=~m1)
    if some35 != size:
        np.copyto(out, C3, where=~m0)


def half_width_from_load(P, A, E_star):
    if P.__class__ is A.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return sqrt(sqrt(4.0 * P / (9.42477796076938 * E_star * A)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_half_width_from_load_P(A, E_star):
    v6 = (9.42477796076938) * E_star
    v7 = v6 * A
    return (v7,)


def block_half_width_from_load_P(out, P, v7):
    np.multiply(C5, P, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.divide(out, v7, out)
    np.sqrt(out, out)
    np.sqrt(out, out)


def prepare_half_width_from_load_all():
    return ()


def block_half_width_from_load_all(out, P, A, E_star, t0):
    np.multiply(C5, P, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(C6, E_star, t0)
    np.multiply(t0, A, t0)
    np.divide(out, t0, t0)
    np.sqrt(t0, t0)
    np.sqrt(t0, out)


def load(a, A, E_star):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = a * a
            return 9.42477796076938 * E_star * A * (v8 * v8) / 4.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(A, E_star):
    v4 = (9.42477796076938) * E_star
    v5 = v4 * A
    v12 = v5 * (0.25)
    return (v12,)


def block_load_a(out, a, v12):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(v12, out, out)


def prepare_load_all():
    return ()


def block_load_all(out, a, A, E_star, t0):
    np.multiply(C6, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.square(a, t0)
    np.square(t0, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, C7, out)


def pressure(x, a, A, E_star):
    if x.__class__ is a.__class__ is A.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x < a:
                return E_star * A * (a * a + 2.0 * (x * x)) * sqrt((a - x) * (a + x))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(a, A, E_star):
    v10 = E_star * A
    v12 = np.square(a)
    return (a, v10, v12)


def block_pressure_x(out, x, a, v10, v12, t0, f0):
    np.subtract(a, x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if largest_x > a:
        np.maximum(out, f0, out=out)
    np.add(a, x, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.square(x, out)
    np.multiply(C0, out, out)
    np.add(v12, out, out)
    np.multiply(v10, out, out)
    np.multiply(out, t0, out)


def prepare_pressure_x_a(A, E_star):
    v8 = E_star * A
    return (v8,)


def block_pressure_x_a(out, x, a, v8, t0, t1, m0):
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
        np.square(a, out)
        np.square(x, t1)
        np.multiply(C0, t1, t1)
        np.add(out, t1, t1)
        np.multiply(v8, t1, t1)
        np.multiply(t1, t0, out)
    if some18 != size:
        np.copyto(out, C2, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, a, A, E_star, t0, t1, t2, m0):
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
        np.multiply(E_star, A, out)
        np.square(a, t1)
        np.square(x, t2)
        np.multiply(C0, t2, t2)
        np.add(t1, t2, t2)
        np.multiply(out, t2, t2)
        np.multiply(t2, t0, out)
    if some18 != size:
        np.copyto(out, C2, where=~m0)


def profile(x, A):
    if x.__class__ is A.__class__ is float and x > 1e-30 and (x < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            v4 = x * x
            return A * (v4 * v4)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(A):
    return (A,)


def block_profile_x(out, x, A):
    np.square(x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(A, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, A):
    np.square(x, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(A, out, out)


def slope(x, a, A):
    if x.__class__ is a.__class__ is A.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            v8 = x * x
            v15 = x * v8
            if x > a:
                v6 = sqrt((x - a) * (a + x))
                v11 = a * a
                value = -2.0 * A * (v11 * v11) * (v11 + 3.0 * v8) / (2.0 * v8 * v6 + v11 * v6 + 2.0 * v15)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return -(4.0 * A * v15)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(a, A):
    v11 = np.square(a)
    v19 = (-2.0) * A
    v21 = np.square(v11)
    v22 = v19 * v21
    v28 = (4.0) * A
    return (a, v11, v22, v28)


def block_slope_x(out, x, a, v11, v22, v28, t0, t1, t2, m0):
    size = out.size
    np.square(x, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(x, t0, t1)
    np.greater(x, a, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.subtract(x, a, out)
        np.add(a, x, t2)
        np.multiply(out, t2, t2)
        np.sqrt(t2, t2)
        np.multiply(C0, t0, out)
        np.multiply(out, t2, out)
        np.multiply(v11, t2, t2)
        np.add(out, t2, t2)
        np.multiply(C0, t1, out)
        np.add(t2, out, out)
        np.multiply(C1, t0, t2)
        np.add(v11, t2, t2)
        np.multiply(v22, t2, t2)
        np.divide(t2, out, out)
    if some31 != size:
        other31 = t2 if some31 else out
        np.multiply(v28, t1, other31)
        np.negative(other31, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def prepare_slope_x_a(A):
    v19 = (-2.0) * A
    v28 = (4.0) * A
    return (v19, v28)


def block_slope_x_a(out, x, a, v19, v28, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(x, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(x, t0, t1)
    np.greater(x, a, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.subtract(x, a, out)
        np.add(a, x, t2)
        np.multiply(out, t2, t2)
        np.sqrt(t2, t2)
        np.multiply(C0, t0, out)
        np.multiply(out, t2, out)
        np.square(a, t3)
        np.multiply(t3, t2, t2)
        np.add(out, t2, t2)
        np.multiply(C0, t1, out)
        np.add(t2, out, out)
        np.square(t3, t2)
        np.multiply(v19, t2, t2)
        np.multiply(C1, t0, t4)
        np.add(t3, t4, t4)
        np.multiply(t2, t4, t4)
        np.divide(t4, out, out)
    if some31 != size:
        other31 = t4 if some31 else out
        np.multiply(v28, t1, other31)
        np.negative(other31, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, a, A, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(x, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(x, t0, t1)
    np.greater(x, a, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.subtract(x, a, out)
        np.add(a, x, t2)
        np.multiply(out, t2, t2)
        np.sqrt(t2, t2)
        np.multiply(C0, t0, out)
        np.multiply(out, t2, out)
        np.square(a, t3)
        np.multiply(t3, t2, t2)
        np.add(out, t2, t2)
        np.multiply(C0, t1, out)
        np.add(t2, out, out)
        np.multiply(C8, A, t2)
        np.square(t3, t4)
        np.multiply(t2, t4, t4)
        np.multiply(C1, t0, t2)
        np.add(t3, t2, t2)
        np.multiply(t4, t2, t2)
        np.divide(t2, out, out)
    if some31 != size:
        other31 = t2 if some31 else out
        np.multiply(C5, A, other31)
        np.multiply(other31, t1, other31)
        np.negative(other31, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


BLOCKS = {
    ('_depth', 2, 'L', 'a', 'A'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 3, 1, (), False),
        ('L', 'a'): (('L', 'a'), prepare_depth_L_a, block_depth_L_a, 4, 2, (), False),
        ('L', 'a', 'A'): (('L', 'a', 'A'), prepare_depth_all, block_depth_all, 4, 2, (), False),
    },
    ('_half_width_from_load', 1, 'P', 'A', 'E_star'): {
        ('P',): (('P',), prepare_half_width_from_load_P, block_half_width_from_load_P, 0, 0, (), False),
        ('P', 'A', 'E_star'): (('P', 'A', 'E_star'), prepare_half_width_from_load_all, block_half_width_from_load_all, 1, 0, (), False),
    },
    ('_load', 1, 'a', 'A', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 0, 0, (), False),
        ('a', 'A', 'E_star'): (('a', 'A', 'E_star'), prepare_load_all, block_load_all, 1, 0, (), False),
    },
    ('_pressure', 2, 'x', 'a', 'A', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 1, 0, (0.0,), True),
        ('x', 'a'): (('x', 'a'), prepare_pressure_x_a, block_pressure_x_a, 2, 1, (), False),
        ('x', 'a', 'A', 'E_star'): (('x', 'a', 'A', 'E_star'), prepare_pressure_all, block_pressure_all, 3, 1, (), False),
    },
    ('_profile', 1, 'x', 'A'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 0, (), False),
        ('x', 'A'): (('x', 'A'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
    ('_slope', 2, 'x', 'a', 'A'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 3, 1, (), False),
        ('x', 'a'): (('x', 'a'), prepare_slope_x_a, block_slope_x_a, 5, 1, (), False),
        ('x', 'a', 'A'): (('x', 'a', 'A'), prepare_slope_all, block_slope_all, 5, 1, (), False),
    },
}
