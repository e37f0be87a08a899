"""Programs of axicontact.plane.sextic."""

from __future__ import annotations

from math import asinh, inf, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(5.0)
C1 = np.array(8.0)
C2 = np.array(2.0)
C3 = np.array(15.0)
C4 = np.array(40.0)
C5 = np.array(0.0)
C6 = np.array(np.nan)
C7 = np.array(3.0)
C8 = np.array(4.0)
C9 = np.array(9.0)
C10 = np.array(6.0)
C11 = np.array(0.125)
C12 = np.array(16.0)
C13 = np.array(0.16666666666666666)
C14 = np.array(np.inf)
C15 = np.array(1.0)
C16 = np.array(47.12388980384689)
C17 = np.array(0.0625)
C18 = np.array(-3.0)


def depth(L, a, A):
    if L.__class__ is a.__class__ is A.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            if a <= L:
                if a > 0.0:
                    v6 = sqrt((L - a) * (a + L))
                    v13 = a * a
                    v14 = v13 * v13
                    v17 = L * L
                    v18 = v17 * v17
                    value = A * pow(a, 6.0) * (15.0 * asinh(v6 / a) + L * (9.0 * v14 + 40.0 * v18 + 15.0 * v13 * v17) / (8.0 * pow(L, 5.0) + (3.0 * v14 + 8.0 * v18 + 4.0 * v13 * v17) * v6)) / 8.0
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_L(a, A):
    v13 = np.square(a)
    v14 = np.square(v13)
    v16 = (3.0) * v14
    v21 = (4.0) * v13
    v31 = (9.0) * v14
    v35 = (15.0) * v13
    v42 = np.power(a, (6.0))
    v43 = A * v42
    v46 = v43 * (0.125)
    v49 = np.greater(a, (0.0))
    return (a, v16, v21, v31, v35, v46, v49)


def block_depth_L(out, L, a, v16, v21, v31, v35, v46, v49, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    some53 = np.count_nonzero(m0)
    if some53:
        if v49:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(L, C0, out)
            np.multiply(C1, out, out)
            np.square(L, t1)
            np.square(t1, t2)
            np.multiply(C1, t2, t3)
            np.add(v16, t3, t3)
            np.multiply(v21, t1, t4)
            np.add(t3, t4, t4)
            np.multiply(t4, t0, t4)
            np.add(out, t4, t4)
            np.divide(t0, a, t0)
            np.arcsinh(t0, t0)
            np.multiply(C3, t0, t0)
            np.multiply(C4, t2, t2)
            np.add(v31, t2, t2)
            np.multiply(v35, t1, t1)
            np.add(t2, t1, t1)
            np.multiply(L, t1, t1)
            np.divide(t1, t4, t4)
            np.add(t0, t4, t4)
            np.multiply(v46, t4, out)
        else:
            np.copyto(out, C5)
    if some53 != size:
        np.copyto(out, C6, where=~m0)


def prepare_depth_L_a(A):
    return (A,)


def block_depth_L_a(out, L, a, A, t0, t1, t2, t3, t4, t5, t6, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some52 = np.count_nonzero(m0)
    if some52:
        np.greater(a, C5, m1)
        some49 = np.count_nonzero(m1)
        if some49:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(L, C0, out)
            np.multiply(C1, out, out)
            np.square(a, t1)
            np.square(t1, t2)
            np.multiply(C7, t2, t3)
            np.square(L, t4)
            np.square(t4, t5)
            np.multiply(C1, t5, t6)
            np.add(t3, t6, t6)
            np.multiply(C8, t1, t3)
            np.multiply(t3, t4, t3)
            np.add(t6, t3, t3)
            np.multiply(t3, t0, t3)
            np.add(out, t3, t3)
            np.divide(t0, a, t0)
            np.arcsinh(t0, t0)
            np.multiply(C3, t0, t0)
            np.multiply(C9, t2, t2)
            np.multiply(C4, t5, t5)
            np.add(t2, t5, t5)
            np.multiply(C3, t1, t1)
            np.multiply(t1, t4, t4)
            np.add(t5, t4, t4)
            np.multiply(L, t4, t4)
            np.divide(t4, t3, t3)
            np.add(t0, t3, t3)
            np.power(a, C10, t0)
            np.multiply(A, t0, t0)
            np.multiply(t0, t3, t3)
            np.multiply(t3, C11, out)
        if some49 != size:
            np.copyto(out, C5, where=~m1)
    if some52 != size:
        np.copyto(out, C6, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, L, a, A, t0, t1, t2, t3, t4, t5, t6, m0, m1):
    size = out.size
    np.less_equal(a, L, m0)
    largest_L = largest(L)
    if largest_L == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some52 = np.count_nonzero(m0)
    if some52:
        np.greater(a, C5, m1)
        some49 = np.count_nonzero(m1)
        if some49:
            np.subtract(L, a, out)
            np.add(a, L, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(L, C0, out)
            np.multiply(C1, out, out)
            np.square(a, t1)
            np.square(t1, t2)
            np.multiply(C7, t2, t3)
            np.square(L, t4)
            np.square(t4, t5)
            np.multiply(C1, t5, t6)
            np.add(t3, t6, t6)
            np.multiply(C8, t1, t3)
            np.multiply(t3, t4, t3)
            np.add(t6, t3, t3)
            np.multiply(t3, t0, t3)
            np.add(out, t3, t3)
            np.divide(t0, a, t0)
            np.arcsinh(t0, t0)
            np.multiply(C3, t0, t0)
            np.multiply(C9, t2, t2)
            np.multiply(C4, t5, t5)
            np.add(t2, t5, t5)
            np.multiply(C3, t1, t1)
            np.multiply(t1, t4, t4)
            np.add(t5, t4, t4)
            np.multiply(L, t4, t4)
            np.divide(t4, t3, t3)
            np.add(t0, t3, t3)
            np.power(a, C10, t0)
            np.multiply(A, t0, t0)
            np.multiply(t0, t3, t3)
            np.multiply(t3, C11, out)
        if some49 != size:
            np.copyto(out, C5, where=~m1)
    if some52 != size:
        np.copyto(out, C6, where=~m0)


def half_width_from_load(P, A, E_star):
    if P.__class__ is A.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = 16.0 * P / (47.12388980384689 * E_star * A)
            v10 = pow(v8, 0.16666666666666666)
            if v8 > 0.0 and v8 < inf:
                value = v10 + v10 * ((v8 / (pow(v10, 6.0) * pow(v10, 0.0)) - 1.0) / 6.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return v10
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_half_width_from_load_P(A, E_star):
    v6 = (47.12388980384689) * E_star
    v7 = v6 * A
    return (v7,)


def block_half_width_from_load_P(out, P, v7, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C12, P, t0)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.divide(t0, v7, t0)
    np.power(t0, C13, t1)
    np.greater(t0, C5, m0)
    np.less(t0, C14, m1)
    np.bitwise_and(m0, m1, m1)
    some26 = np.count_nonzero(m1)
    if some26:
        np.power(t1, C10, out)
        np.power(t1, C5, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C15, t2)
        np.divide(t2, C10, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some26 != size:
        np.copyto(out, t1, where=~m1)


def prepare_half_width_from_load_all():
    return ()


def block_half_width_from_load_all(out, P, A, E_star, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C12, P, t0)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(C16, E_star, t1)
    np.multiply(t1, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C13, t0)
    np.greater(t1, C5, m0)
    np.less(t1, C14, m1)
    np.bitwise_and(m0, m1, m1)
    some26 = np.count_nonzero(m1)
    if some26:
        np.power(t0, C10, out)
        np.power(t0, C5, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C15, t2)
        np.divide(t2, C10, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some26 != size:
        np.copyto(out, t0, where=~m1)


def load(a, A, E_star):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 47.12388980384689 * E_star * A * pow(a, 6.0) / 16.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(A, E_star):
    v4 = (47.12388980384689) * E_star
    v5 = v4 * A
    v11 = v5 * (0.0625)
    return (v11,)


def block_load_a(out, a, v11):
    np.power(a, C10, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v11, out, out)


def prepare_load_all():
    return ()


def block_load_all(out, a, A, E_star, t0):
    np.multiply(C16, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.power(a, C10, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, C17, out)


def pressure(x, a, A, E_star):
    if x.__class__ is a.__class__ is A.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x < a:
                v13 = a * a
                v17 = x * x
                return 3.0 * E_star * A * (3.0 * (v13 * v13) + 4.0 * v13 * v17 + 8.0 * (v17 * v17)) * sqrt((a - x) * (a + x)) / 8.0
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(a, A, E_star):
    v11 = (3.0) * E_star
    v12 = v11 * A
    v15 = np.square(a)
    v16 = np.square(v15)
    v17 = (3.0) * v16
    v18 = (4.0) * v15
    return (a, v12, v17, v18)


def block_pressure_x(out, x, a, v12, v17, v18, t0, t1, f0):
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
    np.multiply(v18, out, t1)
    np.add(v17, t1, t1)
    np.square(out, out)
    np.multiply(C1, out, out)
    np.add(t1, out, out)
    np.multiply(v12, out, out)
    np.multiply(out, t0, t0)
    np.multiply(t0, C11, out)


def prepare_pressure_x_a(A, E_star):
    v9 = (3.0) * E_star
    v10 = v9 * A
    return (v10,)


def block_pressure_x_a(out, x, a, v10, t0, t1, t2, m0):
    size = out.size
    np.less(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.square(a, out)
        np.square(out, t1)
        np.multiply(C7, t1, t1)
        np.multiply(C8, out, out)
        np.square(x, t2)
        np.multiply(out, t2, out)
        np.add(t1, out, out)
        np.square(t2, t2)
        np.multiply(C1, t2, t2)
        np.add(out, t2, t2)
        np.multiply(v10, t2, t2)
        np.multiply(t2, t0, t0)
        np.multiply(t0, C11, out)
    if some30 != size:
        np.copyto(out, C5, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, a, A, E_star, t0, t1, t2, t3, m0):
    size = out.size
    np.less(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, x, out)
        np.add(a, x, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C7, E_star, out)
        np.multiply(out, A, out)
        np.square(a, t1)
        np.square(t1, t2)
        np.multiply(C7, t2, t2)
        np.multiply(C8, t1, t1)
        np.square(x, t3)
        np.multiply(t1, t3, t1)
        np.add(t2, t1, t1)
        np.square(t3, t3)
        np.multiply(C1, t3, t3)
        np.add(t1, t3, t3)
        np.multiply(out, t3, t3)
        np.multiply(t3, t0, t0)
        np.multiply(t0, C11, out)
    if some30 != size:
        np.copyto(out, C5, where=~m0)


def profile(x, A):
    if x.__class__ is A.__class__ is float and x > 1e-30 and (x < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            return A * pow(x, 6.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(A):
    return (A,)


def block_profile_x(out, x, A):
    np.power(x, C10, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, A):
    np.power(x, C10, out)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def slope(x, a, A):
    if x.__class__ is a.__class__ is A.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            v25 = pow(x, 5.0)
            if x > a:
                v6 = sqrt((x - a) * (a + x))
                v9 = x * x
                v10 = v9 * v9
                v14 = a * a
                v15 = v14 * v14
                value = -3.0 * A * pow(a, 6.0) * (9.0 * v15 + 15.0 * v14 * v9 + 40.0 * v10) / (4.0 * (8.0 * v10 * v6 + 3.0 * v15 * v6 + 4.0 * v14 * v9 * v6 + 8.0 * v25))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return -(6.0 * A * v25)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(a, A):
    v14 = np.square(a)
    v15 = np.square(v14)
    v17 = (3.0) * v15
    v20 = (4.0) * v14
    v29 = (-3.0) * A
    v31 = np.power(a, (6.0))
    v32 = v29 * v31
    v34 = (9.0) * v15
    v36 = (15.0) * v14
    v46 = (6.0) * A
    return (a, v17, v20, v32, v34, v36, v46)


def block_slope_x(out, x, a, v17, v20, v32, v34, v36, v46, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.power(x, C0, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.greater(x, a, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.subtract(x, a, out)
        np.add(a, x, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.square(x, out)
        np.square(out, t2)
        np.multiply(C1, t2, t3)
        np.multiply(t3, t1, t3)
        np.multiply(v17, t1, t4)
        np.add(t3, t4, t4)
        np.multiply(v20, out, t3)
        np.multiply(t3, t1, t1)
        np.add(t4, t1, t1)
        np.multiply(C1, t0, t4)
        np.add(t1, t4, t4)
        np.multiply(v36, out, out)
        np.add(v34, out, out)
        np.multiply(C4, t2, t2)
        np.add(out, t2, t2)
        np.multiply(v32, t2, t2)
        np.multiply(C8, t4, t4)
        np.divide(t2, t4, out)
    if some49 != size:
        other49 = t4 if some49 else out
        np.multiply(v46, t0, other49)
        np.negative(other49, other49)
        if some49:
            np.copyto(out, other49, where=~m0)


def prepare_slope_x_a(A):
    v29 = (-3.0) * A
    v46 = (6.0) * A
    return (v29, v46)


def block_slope_x_a(out, x, a, v29, v46, t0, t1, t2, t3, t4, t5, t6, m0):
    size = out.size
    np.power(x, C0, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(x, a, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.subtract(x, a, out)
        np.add(a, x, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.square(x, out)
        np.square(out, t2)
        np.multiply(C1, t2, t3)
        np.multiply(t3, t1, t3)
        np.square(a, t4)
        np.square(t4, t5)
        np.multiply(C7, t5, t6)
        np.multiply(t6, t1, t6)
        np.add(t3, t6, t6)
        np.multiply(C8, t4, t3)
        np.multiply(t3, out, t3)
        np.multiply(t3, t1, t1)
        np.add(t6, t1, t1)
        np.multiply(C1, t0, t6)
        np.add(t1, t6, t6)
        np.power(a, C10, t1)
        np.multiply(v29, t1, t1)
        np.multiply(C9, t5, t5)
        np.multiply(C3, t4, t4)
        np.multiply(t4, out, out)
        np.add(t5, out, out)
        np.multiply(C4, t2, t2)
        np.add(out, t2, t2)
        np.multiply(t1, t2, t2)
        np.multiply(C8, t6, t6)
        np.divide(t2, t6, out)
    if some49 != size:
        other49 = t6 if some49 else out
        np.multiply(v46, t0, other49)
        np.negative(other49, other49)
        if some49:
            np.copyto(out, other49, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, a, A, t0, t1, t2, t3, t4, t5, t6, m0):
    size = out.size
    np.power(x, C0, t0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(x, a, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.subtract(x, a, out)
        np.add(a, x, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.square(x, out)
        np.square(out, t2)
        np.multiply(C1, t2, t3)
        np.multiply(t3, t1, t3)
        np.square(a, t4)
        np.square(t4, t5)
        np.multiply(C7, t5, t6)
        np.multiply(t6, t1, t6)
        np.add(t3, t6, t6)
        np.multiply(C8, t4, t3)
        np.multiply(t3, out, t3)
        np.multiply(t3, t1, t1)
        np.add(t6, t1, t1)
        np.multiply(C1, t0, t6)
        np.add(t1, t6, t6)
        np.multiply(C18, A, t1)
        np.power(a, C10, t3)
        np.multiply(t1, t3, t3)
        np.multiply(C9, t5, t5)
        np.multiply(C3, t4, t4)
        np.multiply(t4, out, out)
        np.add(t5, out, out)
        np.multiply(C4, t2, t2)
        np.add(out, t2, t2)
        np.multiply(t3, t2, t2)
        np.multiply(C8, t6, t6)
        np.divide(t2, t6, out)
    if some49 != size:
        other49 = t6 if some49 else out
        np.multiply(C10, A, other49)
        np.multiply(other49, t0, other49)
        np.negative(other49, other49)
        if some49:
            np.copyto(out, other49, where=~m0)


BLOCKS = {
    ('_depth', 2, 'L', 'a', 'A'): {
        ('L',): (('L',), prepare_depth_L, block_depth_L, 5, 1, (), False),
        ('L', 'a'): (('L', 'a'), prepare_depth_L_a, block_depth_L_a, 7, 2, (), False),
        ('L', 'a', 'A'): (('L', 'a', 'A'), prepare_depth_all, block_depth_all, 7, 2, (), False),
    },
    ('_half_width_from_load', 1, 'P', 'A', 'E_star'): {
        ('P',): (('P',), prepare_half_width_from_load_P, block_half_width_from_load_P, 3, 2, (), False),
        ('P', 'A', 'E_star'): (('P', 'A', 'E_star'), prepare_half_width_from_load_all, block_half_width_from_load_all, 3, 2, (), False),
    },
    ('_load', 1, 'a', 'A', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 0, 0, (), False),
        ('a', 'A', 'E_star'): (('a', 'A', 'E_star'), prepare_load_all, block_load_all, 1, 0, (), False),
    },
    ('_pressure', 2, 'x', 'a', 'A', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 2, 0, (0.0,), True),
        ('x', 'a'): (('x', 'a'), prepare_pressure_x_a, block_pressure_x_a, 3, 1, (), False),
        ('x', 'a', 'A', 'E_star'): (('x', 'a', 'A', 'E_star'), prepare_pressure_all, block_pressure_all, 4, 1, (), False),
    },
    ('_profile', 1, 'x', 'A'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 0, (), False),
        ('x', 'A'): (('x', 'A'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
    ('_slope', 2, 'x', 'a', 'A'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 5, 1, (), False),
        ('x', 'a'): (('x', 'a'), prepare_slope_x_a, block_slope_x_a, 7, 1, (), False),
        ('x', 'a', 'A'): (('x', 'a', 'A'), prepare_slope_all, block_slope_all, 7, 1, (), False),
    },
}
