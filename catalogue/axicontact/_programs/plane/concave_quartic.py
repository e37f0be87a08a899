"""Programs of axicontact.plane.concave_quartic."""

from __future__ import annotations

from math import log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(3.0)
C2 = np.array(np.nan)
C3 = np.array(9.42477796076938)
C4 = np.array(0.125)
C5 = np.array(0.999999999999999)
C6 = np.array(3.141592653589793)
C7 = np.array(0.0)
C8 = np.array(8.0)
C9 = np.array(-2.0)
C10 = np.array(12.0)
C11 = np.array(-4.0)
C12 = np.array(0.5)


def depth(L, P, a, h, E_star):
    if L.__class__ is P.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and L > 1e-30 and (L < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 9.42477796076938 * E_star * h / 8.0 * 0.999999999999999 <= P:
                if a <= L:
                    v5 = L - a
                    v8 = sqrt(v5 * (a + L))
                    v18 = a * a
                    v21 = L * L
                    return 2.0 * P * log1p((v5 + v8) / a) / (3.141592653589793 * E_star) - h * L * (v18 + 3.0 * v21) / (2.0 * (v18 * v8 + 2.0 * (L * v21) + 2.0 * v21 * v8))
                return nan
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(P, a, h, E_star):
    v10 = (2.0) * P
    v16 = (3.141592653589793) * E_star
    v18 = np.square(a)
    v36 = (9.42477796076938) * E_star
    v37 = v36 * h
    v39 = v37 / (8.0)
    v41 = v39 * (0.999999999999999)
    v42 = np.less_equal(v41, P)
    return (a, h, v10, v16, v18, v42)


def block_depth_L(out, L, a, h, v10, v16, v18, v42, t0, t1, t2, t3, m0):
    size = out.size
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    if v42:
        np.less_equal(a, L, m0)
        some45 = np.count_nonzero(m0)
        if some45:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.add(out, t0, out)
            np.divide(out, a, out)
            np.log1p(out, out)
            np.multiply(v10, out, out)
            np.divide(out, v16, out)
            np.multiply(v18, t0, t1)
            np.square(L, t2)
            np.multiply(L, t2, t3)
            np.multiply(C0, t3, t3)
            np.add(t1, t3, t3)
            np.multiply(C0, t2, t1)
            np.multiply(t1, t0, t0)
            np.add(t3, t0, t0)
            np.multiply(h, L, t3)
            np.multiply(C1, t2, t2)
            np.add(v18, t2, t2)
            np.multiply(t3, t2, t2)
            np.multiply(C0, t0, t0)
            np.divide(t2, t0, t0)
            np.subtract(out, t0, out)
        if some45 != size:
            np.copyto(out, C2, where=~m0)
    else:
        np.copyto(out, C2)


def prepare_depth_L_P(a, h, E_star):
    v16 = (3.141592653589793) * E_star
    v18 = np.square(a)
    v36 = (9.42477796076938) * E_star
    v37 = v36 * h
    v39 = v37 / (8.0)
    v41 = v39 * (0.999999999999999)
    return (a, h, v16, v18, v41)


def block_depth_L_P(out, L, P, a, h, v16, v18, v41, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.less_equal(v41, P, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some46 = np.count_nonzero(m0)
    if some46:
        np.less_equal(a, L, m1)
        some45 = np.count_nonzero(m1)
        if some45:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C0, P, t1)
            np.add(out, t0, out)
            np.divide(out, a, out)
            np.log1p(out, out)
            np.multiply(t1, out, out)
            np.divide(out, v16, out)
            np.multiply(v18, t0, t1)
            np.square(L, t2)
            np.multiply(L, t2, t3)
            np.multiply(C0, t3, t3)
            np.add(t1, t3, t3)
            np.multiply(C0, t2, t1)
            np.multiply(t1, t0, t0)
            np.add(t3, t0, t0)
            np.multiply(h, L, t3)
            np.multiply(C1, t2, t2)
            np.add(v18, t2, t2)
            np.multiply(t3, t2, t2)
            np.multiply(C0, t0, t0)
            np.divide(t2, t0, t0)
            np.subtract(out, t0, out)
        if some45 != size:
            np.copyto(out, C2, where=~m1)
    if some46 != size:
        np.copyto(out, C2, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, P, a, h, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(C3, E_star, t0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t0)
    np.multiply(t0, C4, t0)
    np.multiply(t0, C5, t0)
    np.less_equal(t0, P, m0)
    some47 = np.count_nonzero(m0)
    if some47:
        np.less_equal(a, L, m1)
        some46 = np.count_nonzero(m1)
        if some46:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C0, P, t1)
            np.add(out, t0, out)
            np.divide(out, a, out)
            np.log1p(out, out)
            np.multiply(t1, out, out)
            np.multiply(C6, E_star, t1)
            np.divide(out, t1, t1)
            np.square(a, out)
            np.multiply(out, t0, t2)
            np.square(L, t3)
            np.multiply(L, t3, t4)
            np.multiply(C0, t4, t4)
            np.add(t2, t4, t4)
            np.multiply(C0, t3, t2)
            np.multiply(t2, t0, t0)
            np.add(t4, t0, t0)
            np.multiply(h, L, t4)
            np.multiply(C1, t3, t3)
            np.add(out, t3, t3)
            np.multiply(t4, t3, t3)
            np.multiply(C0, t0, t0)
            np.divide(t3, t0, t0)
            np.subtract(t1, t0, out)
        if some46 != size:
            np.copyto(out, C2, where=~m1)
    if some47 != size:
        np.copyto(out, C2, where=~m0)


def minimum_load(h, E_star, a=1.0):
    if h.__class__ is E_star.__class__ is a.__class__ is float and h > 1e-30 and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            return 9.42477796076938 * E_star * h / 8.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_load_all_signed():
    return ()


def block_minimum_load_all_signed(out, h, E_star):
    np.multiply(C3, E_star, out)
    np.multiply(out, h, out)
    np.multiply(out, C4, out)


def pressure(x, P, a, h, E_star):
    if x.__class__ is P.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v29 = 9.42477796076938 * E_star * h / 8.0
            if v29 * 0.999999999999999 <= P:
                if x <= a and P > 0.0:
                    v13 = 2.0 * x
                    v14 = v13 - a
                    v17 = a + v13
                    v21 = a * a
                    value = (P - v29 + 3.141592653589793 * E_star * h * (v14 * v14) * (v17 * v17) / (8.0 * (v21 * v21))) / (3.141592653589793 * sqrt((a - x) * (a + x)))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(P, a, h, E_star):
    v10 = (3.141592653589793) * E_star
    v11 = v10 * h
    v20 = np.square(a)
    v21 = np.square(v20)
    v23 = (8.0) * v21
    v26 = (9.42477796076938) * E_star
    v27 = v26 * h
    v28 = v27 / (8.0)
    v29 = P - v28
    v34 = v28 * (0.999999999999999)
    v35 = np.less_equal(v34, P)
    v38 = np.greater(P, (0.0))
    return (a, v11, v23, v29, v35, v38)


def block_pressure_x(out, x, a, v11, v23, v29, v35, v38, t0, t1, m0):
    size = out.size
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if v35:
        np.less_equal(x, a, m0)
        np.bitwise_and(m0, v38, m0)
        some40 = np.count_nonzero(m0)
        if some40:
            np.subtract(a, x, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C0, x, out)
            np.subtract(out, a, t1)
            np.square(t1, t1)
            np.multiply(v11, t1, t1)
            np.add(a, out, out)
            np.square(out, out)
            np.multiply(t1, out, out)
            np.divide(out, v23, out)
            np.add(v29, out, out)
            np.multiply(C6, t0, t0)
            np.divide(out, t0, out)
        if some40 != size:
            np.copyto(out, C7, where=~m0)
    else:
        np.copyto(out, C2)


def prepare_pressure_x_P(a, h, E_star):
    v10 = (3.141592653589793) * E_star
    v11 = v10 * h
    v20 = np.square(a)
    v21 = np.square(v20)
    v23 = (8.0) * v21
    v26 = (9.42477796076938) * E_star
    v27 = v26 * h
    v28 = v27 / (8.0)
    v34 = v28 * (0.999999999999999)
    return (a, v11, v23, v28, v34)


def block_pressure_x_P(out, x, P, a, v11, v23, v28, v34, t0, t1, m0, m1, m2):
    size = out.size
    np.less_equal(v34, P, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some42 = np.count_nonzero(m0)
    if some42:
        np.less_equal(x, a, m1)
        np.greater(P, C7, m2)
        np.bitwise_and(m1, m2, m2)
        some40 = np.count_nonzero(m2)
        if some40:
            np.subtract(a, x, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C0, x, out)
            np.subtract(out, a, t1)
            np.square(t1, t1)
            np.multiply(v11, t1, t1)
            np.add(a, out, out)
            np.square(out, out)
            np.multiply(t1, out, out)
            np.divide(out, v23, out)
            np.subtract(P, v28, t1)
            np.add(t1, out, out)
            np.multiply(C6, t0, t0)
            np.divide(out, t0, out)
        if some40 != size:
            np.copyto(out, C7, where=~m2)
    if some42 != size:
        np.copyto(out, C2, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, P, a, h, E_star, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.multiply(C3, E_star, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t0)
    np.multiply(t0, C4, t0)
    np.multiply(t0, C5, t1)
    np.less_equal(t1, P, m0)
    some43 = np.count_nonzero(m0)
    if some43:
        np.less_equal(x, a, m1)
        np.greater(P, C7, m2)
        np.bitwise_and(m1, m2, m2)
        some41 = np.count_nonzero(m2)
        if some41:
            np.subtract(a, x, out)
            np.add(a, x, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.multiply(C6, E_star, out)
            np.multiply(out, h, out)
            np.multiply(C0, x, t2)
            np.subtract(t2, a, t3)
            np.square(t3, t3)
            np.multiply(out, t3, t3)
            np.add(a, t2, t2)
            np.square(t2, t2)
            np.multiply(t3, t2, t2)
            np.square(a, t3)
            np.square(t3, t3)
            np.multiply(C8, t3, t3)
            np.divide(t2, t3, t3)
            np.subtract(P, t0, t2)
            np.add(t2, t3, t3)
            np.multiply(C6, t1, t1)
            np.divide(t3, t1, out)
        if some41 != size:
            np.copyto(out, C7, where=~m2)
    if some43 != size:
        np.copyto(out, C2, where=~m0)


def profile(x, a, h):
    if x.__class__ is a.__class__ is h.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            if x <= a:
                v7 = x * x
                v10 = a * a
                return -h * (v7 * v7) / (v10 * v10)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(a, h):
    v4 = np.negative(h)
    v9 = np.square(a)
    v10 = np.square(v9)
    return (a, v4, v10)


def block_profile_x(out, x, a, v4, v10, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some13 = np.count_nonzero(m0)
    if some13:
        np.square(x, out)
        np.square(out, out)
        np.multiply(v4, out, out)
        np.divide(out, v10, out)
    if some13 != size:
        np.copyto(out, C2, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, a, h, t0, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some13 = np.count_nonzero(m0)
    if some13:
        np.negative(h, out)
        np.square(x, t0)
        np.square(t0, t0)
        np.multiply(out, t0, t0)
        np.square(a, out)
        np.square(out, out)
        np.divide(t0, out, out)
    if some13 != size:
        np.copyto(out, C2, where=~m0)


def slope(x, P, a, h, E_star):
    if x.__class__ is P.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 9.42477796076938 * E_star * h / 8.0 * 0.999999999999999 <= P:
                v22 = x * x
                v23 = x * v22
                v27 = a * a
                v28 = v27 * v27
                if x >= a:
                    if P > 0.0:
                        v8 = sqrt((x - a) * (a + x))
                        v17 = v8 * v8
                        value = -2.0 * P / (3.141592653589793 * E_star * v8) - h * v27 * (v27 + 8.0 * v22) / (2.0 * (8.0 * (v17 * v17) + 8.0 * v23 * v8 + 3.0 * v28 + 12.0 * v27 * v17) * v8)
                        if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                            return value
                        return None
                    return 0.0
                return -(-4.0 * h * v23 / v28)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(P, a, h, E_star):
    v10 = (-2.0) * P
    v12 = (3.141592653589793) * E_star
    v26 = np.square(a)
    v27 = np.square(v26)
    v28 = (3.0) * v27
    v31 = (12.0) * v26
    v34 = h * v26
    v43 = np.greater(P, (0.0))
    v46 = (9.42477796076938) * E_star
    v47 = v46 * h
    v48 = v47 / (8.0)
    v50 = v48 * (0.999999999999999)
    v51 = np.less_equal(v50, P)
    v54 = (-4.0) * h
    return (a, v10, v12, v26, v27, v28, v31, v34, v43, v51, v54)


def block_slope_x(out, x, a, v10, v12, v26, v27, v28, v31, v34, v43, v51, v54, t0, t1, t2, t3, t4, t5, m0):
    size = out.size
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if v51:
        np.square(x, t0)
        np.multiply(x, t0, t1)
        np.greater_equal(x, a, m0)
        some58 = np.count_nonzero(m0)
        if some58:
            if v43:
                np.subtract(x, a, out)
                np.add(a, x, t2)
                np.multiply(out, t2, t2)
                np.sqrt(t2, t2)
                np.multiply(v12, t2, out)
                np.divide(v10, out, out)
                np.square(t2, t3)
                np.square(t3, t4)
                np.multiply(C8, t4, t4)
                np.multiply(C8, t1, t5)
                np.multiply(t5, t2, t5)
                np.add(t4, t5, t5)
                np.add(t5, v28, t5)
                np.multiply(v31, t3, t3)
                np.add(t5, t3, t3)
                np.multiply(C8, t0, t5)
                np.add(v26, t5, t5)
                np.multiply(v34, t5, t5)
                np.multiply(C0, t3, t3)
                np.multiply(t3, t2, t2)
                np.divide(t5, t2, t2)
                np.subtract(out, t2, out)
            else:
                np.copyto(out, C7)
        if some58 != size:
            other58 = t2 if some58 else out
            np.multiply(v54, t1, other58)
            np.divide(other58, v27, other58)
            np.negative(other58, other58)
            if some58:
                np.copyto(out, other58, where=~m0)
    else:
        np.copyto(out, C2)


def prepare_slope_x_P(a, h, E_star):
    v12 = (3.141592653589793) * E_star
    v26 = np.square(a)
    v27 = np.square(v26)
    v28 = (3.0) * v27
    v31 = (12.0) * v26
    v34 = h * v26
    v46 = (9.42477796076938) * E_star
    v47 = v46 * h
    v48 = v47 / (8.0)
    v50 = v48 * (0.999999999999999)
    v54 = (-4.0) * h
    return (a, v12, v26, v27, v28, v31, v34, v50, v54)


def block_slope_x_P(out, x, P, a, v12, v26, v27, v28, v31, v34, v50, v54, t0, t1, t2, t3, t4, t5, m0, m1, m2):
    size = out.size
    np.less_equal(v50, P, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    some60 = np.count_nonzero(m0)
    if some60:
        np.square(x, t0)
        np.multiply(x, t0, t1)
        np.greater_equal(x, a, m1)
        some58 = np.count_nonzero(m1)
        if some58:
            np.greater(P, C7, m2)
            some44 = np.count_nonzero(m2)
            if some44:
                np.subtract(x, a, out)
                np.add(a, x, t2)
                np.multiply(out, t2, t2)
                np.sqrt(t2, t2)
                np.multiply(C9, P, out)
                np.multiply(v12, t2, t3)
                np.divide(out, t3, t3)
                np.square(t2, out)
                np.square(out, t4)
                np.multiply(C8, t4, t4)
                np.multiply(C8, t1, t5)
                np.multiply(t5, t2, t5)
                np.add(t4, t5, t5)
                np.add(t5, v28, t5)
                np.multiply(v31, out, out)
                np.add(t5, out, out)
                np.multiply(C8, t0, t5)
                np.add(v26, t5, t5)
                np.multiply(v34, t5, t5)
                np.multiply(C0, out, out)
                np.multiply(out, t2, t2)
                np.divide(t5, t2, t2)
                np.subtract(t3, t2, out)
            if some44 != size:
                np.copyto(out, C7, where=~m2)
        if some58 != size:
            other58 = t2 if some58 else out
            np.multiply(v54, t1, other58)
            np.divide(other58, v27, other58)
            np.negative(other58, other58)
            if some58:
                np.copyto(out, other58, where=~m1)
    if some60 != size:
        np.copyto(out, C2, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, P, a, h, E_star, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, m2):
    size = out.size
    np.multiply(C3, E_star, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t0)
    np.multiply(t0, C4, t0)
    np.multiply(t0, C5, t0)
    np.less_equal(t0, P, m0)
    some61 = np.count_nonzero(m0)
    if some61:
        np.square(x, t0)
        np.multiply(x, t0, t1)
        np.square(a, t2)
        np.square(t2, t3)
        np.greater_equal(x, a, m1)
        some59 = np.count_nonzero(m1)
        if some59:
            np.greater(P, C7, m2)
            some44 = np.count_nonzero(m2)
            if some44:
                np.subtract(x, a, out)
                np.add(a, x, t4)
                np.multiply(out, t4, t4)
                np.sqrt(t4, t4)
                np.multiply(C9, P, out)
                np.multiply(C6, E_star, t5)
                np.multiply(t5, t4, t5)
                np.divide(out, t5, t5)
                np.square(t4, out)
                np.square(out, t6)
                np.multiply(C8, t6, t6)
                np.multiply(C8, t1, t7)
                np.multiply(t7, t4, t7)
                np.add(t6, t7, t7)
                np.multiply(C1, t3, t6)
                np.add(t7, t6, t6)
                np.multiply(C10, t2, t7)
                np.multiply(t7, out, out)
                np.add(t6, out, out)
                np.multiply(h, t2, t6)
                np.multiply(C8, t0, t7)
                np.add(t2, t7, t7)
                np.multiply(t6, t7, t7)
                np.multiply(C0, out, out)
                np.multiply(out, t4, t4)
                np.divide(t7, t4, t4)
                np.subtract(t5, t4, out)
            if some44 != size:
                np.copyto(out, C7, where=~m2)
        if some59 != size:
            other59 = t4 if some59 else out
            np.multiply(C11, h, other59)
            np.multiply(other59, t1, other59)
            np.divide(other59, t3, other59)
            np.negative(other59, other59)
            if some59:
                np.copyto(out, other59, where=~m1)
    if some61 != size:
        np.copyto(out, C2, where=~m0)


def zero_distance(a, h=1.0):
    if a.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            return a / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_zero_distance_all_signed():
    return ()


def block_zero_distance_all_signed(out, a):
    np.multiply(a, C12, out)


BLOCKS = {
    ('_depth', 2, 'L', 'P', 'a', 'h', 'E_star'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 4, 1, (), False),
        ('L', 'P'): (('L', 'P'), prepare_depth_L_P, block_depth_L_P, 4, 2, (), False),
        ('L', 'P', 'a', 'h', 'E_star'): (('L', 'P', 'a', 'h', 'E_star'), prepare_depth_all, block_depth_all, 5, 2, (), False),
    },
    ('_minimum_load', 0, 'h', 'E_star'): {
        ('h', 'E_star'): (('h', 'E_star'), prepare_minimum_load_all_signed, block_minimum_load_all_signed, 0, 0, (), False),
    },
    ('_pressure', 2, 'x', 'P', 'a', 'h', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 2, 1, (), False),
        ('x', 'P'): (('x', 'P'), prepare_pressure_x_P, block_pressure_x_P, 2, 3, (), False),
        ('x', 'P', 'a', 'h', 'E_star'): (('x', 'P', 'a', 'h', 'E_star'), prepare_pressure_all, block_pressure_all, 4, 3, (), False),
    },
    ('_profile', 1, 'x', 'a', 'h'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 1, (), False),
        ('x', 'a', 'h'): (('x', 'a', 'h'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_slope', 2, 'x', 'P', 'a', 'h', 'E_star'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 6, 1, (), False),
        ('x', 'P'): (('x', 'P'), prepare_slope_x_P, block_slope_x_P, 6, 3, (), False),
        ('x', 'P', 'a', 'h', 'E_star'): (('x', 'P', 'a', 'h', 'E_star'), prepare_slope_all, block_slope_all, 8, 3, (), False),
    },
    ('_zero_distance', 0, 'a'): {
        ('a',): (('a',), prepare_zero_distance_all_signed, block_zero_distance_all_signed, 0, 0, (), False),
    },
}
