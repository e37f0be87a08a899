"""Programs of axicontact.plane.truncated_wedge."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

C0 = np.array(2.0)
C1 = np.array(0.0)
C2 = np.array(np.nan)
C3 = np.array(3.141592653589793)
C4 = np.array(-2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(L, a, theta, b):
    if L.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            v7 = a - b
            v10 = a + b
            v13 = L - a
            v67 = tan(theta)
            v89 = a >= b
            v90 = a <= L
            if a < 128.0 * b:
                if v89:
                    if v90:
                        v37 = a > b
                        if a < L:
                            if v37:
                                v12 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v10)
                                v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (L + a))
                                v18 = b / L
                                v19 = v12 / v17
                                v21 = asinh(v19 / v18)
                                v25 = sqrt(1.0 + v19 * v19)
                                v29 = 0.0 - expm1(-2.0 * v21)
                                v32 = v29 if v29 > 0.0 else inf
                                v35 = 42.0 + asinh(v19)
                                v36 = v21 if v21 < v35 or v21 != v21 else v35
                                v54 = b * b
                                v59 = v18 / v19
                                v61 = v59 * v59
                                v69 = b * b
                                v80 = []
                                for node, weight in RULE_0(v36 / 1.0):
                                    v38 = node * v36
                                    v46 = exp(-v38) * (0.0 - expm1(-2.0 * (v21 - v38))) / v32
                                    v47 = v19 * v46
                                    v49 = 1.0 + v47 * v47
                                    v51 = v25 / sqrt(v49)
                                    v53 = v12 * v46 * v51
                                    v57 = sqrt(v54 + v53 * v53)
                                    v79 = v67 * sqrt(v53 * v53 + v69) / v53 * (v53 / v57 * (sqrt(v61 + v46 * v46) / v49)) * v51 * asinh(v17 * v51 / v57)
                                    v80.append(weight * v79)
                                v80 = fsum(v80) * v36
                                v82 = v12 * v80
                            else:
                                v82 = 0.0
                            value = 0.6366197723675814 * v82
                            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                                return value
                            if value != value and ordinary(L, a, theta, b):
                                return value
                            return None
                        if v37:
                            return v67 * v7
                        return 0.0
                    return nan
                return nan
            if v89:
                if v90:
                    v96 = sqrt(v13 * (a + L))
                    v98 = sqrt(v7 * v10)
                    return 2.0 * v67 / 3.141592653589793 * (asinh(v96 / a) * v98 + L * atan(v98 / v96) - b * atan(L * v98 / (b * v96)))
                return nan
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def half_width_from_load(P, theta, b, E_star):
    if P.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = tan(theta)
            return sqrt(P * P / (E_star * E_star * (v7 * v7)) + b * b)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_half_width_from_load_P(theta, b, E_star):
    v6 = np.square(E_star)
    v7 = np.tan(theta)
    v8 = np.square(v7)
    v9 = v6 * v8
    v11 = np.square(b)
    return (v9, v11)


def block_half_width_from_load_P(out, P, v9, v11):
    np.square(P, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.divide(out, v9, out)
    np.add(out, v11, out)
    np.sqrt(out, out)


def prepare_half_width_from_load_all():
    return ()


def block_half_width_from_load_all(out, P, theta, b, E_star, t0, t1):
    np.square(P, out)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.square(E_star, t0)
    np.tan(theta, t1)
    np.square(t1, t1)
    np.multiply(t0, t1, t1)
    np.divide(out, t1, t1)
    np.square(b, out)
    np.add(t1, out, out)
    np.sqrt(out, out)


def load(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            return E_star * tan(theta) * sqrt((a - b) * (a + b))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(theta, b, E_star):
    v8 = np.tan(theta)
    v9 = E_star * v8
    return (b, v9)


def block_load_a(out, a, b, v9, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(v9, t0, out)


def prepare_load_all():
    return ()


def block_load_all(out, a, theta, b, E_star, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.tan(theta, out)
    np.multiply(E_star, out, out)
    np.multiply(out, t0, out)


def pressure(x, a, theta, b, E_star):
    if x.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                if x < a:
                    v10 = x + b
                    v16 = E_star * tan(theta) / 3.141592653589793
                    if x < b:
                        return v16 * asinh(sqrt((a - b) * (a + b)) / sqrt((b - x) * v10))
                    return v16 * asinh(sqrt((a - x) * (a + x)) / sqrt((x - b) * v10))
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(a, theta, b, E_star):
    v5 = a - b
    v6 = a + b
    v7 = v5 * v6
    v8 = np.sqrt(v7)
    v13 = np.tan(theta)
    v14 = E_star * v13
    v16 = v14 / (3.141592653589793)
    v32 = np.greater_equal(a, b)
    return (a, b, v8, v16, v32)


def block_pressure_x(out, x, a, b, v8, v16, v32, t0, t1, t2, m0, m1):
    size = out.size
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if v32:
        np.less(x, a, m0)
        some35 = np.count_nonzero(m0)
        if some35:
            np.add(x, b, t0)
            np.less(x, b, m1)
            some31 = np.count_nonzero(m1)
            if some31:
                np.subtract(b, x, out)
                np.multiply(out, t0, out)
                np.sqrt(out, out)
                np.divide(v8, out, out)
                np.arcsinh(out, out)
                np.multiply(v16, out, out)
            if some31 != size:
                other31 = t1 if some31 else out
                np.subtract(a, x, other31)
                np.add(a, x, t2)
                np.multiply(other31, t2, t2)
                np.sqrt(t2, t2)
                np.subtract(x, b, other31)
                np.multiply(other31, t0, other31)
                np.sqrt(other31, other31)
                np.divide(t2, other31, other31)
                np.arcsinh(other31, other31)
                np.multiply(v16, other31, other31)
                if some31:
                    np.copyto(out, other31, where=~m1)
        if some35 != size:
            np.copyto(out, C1, where=~m0)
    else:
        np.copyto(out, C2)


def prepare_pressure_x_a(theta, b, E_star):
    v13 = np.tan(theta)
    v14 = E_star * v13
    v16 = v14 / (3.141592653589793)
    return (b, v16)


def block_pressure_x_a(out, x, a, b, v16, t0, t1, t2, m0, m1, m2):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some37 = np.count_nonzero(m0)
    if some37:
        np.less(x, a, m1)
        some35 = np.count_nonzero(m1)
        if some35:
            np.add(x, b, t0)
            np.less(x, b, m2)
            some31 = np.count_nonzero(m2)
            if some31:
                np.subtract(a, b, out)
                np.add(a, b, t1)
                np.multiply(out, t1, t1)
                np.sqrt(t1, t1)
                np.subtract(b, x, out)
                np.multiply(out, t0, out)
                np.sqrt(out, out)
                np.divide(t1, out, out)
                np.arcsinh(out, out)
                np.multiply(v16, out, out)
            if some31 != size:
                other31 = t1 if some31 else out
                np.subtract(a, x, other31)
                np.add(a, x, t2)
                np.multiply(other31, t2, t2)
                np.sqrt(t2, t2)
                np.subtract(x, b, other31)
                np.multiply(other31, t0, other31)
                np.sqrt(other31, other31)
                np.divide(t2, other31, other31)
                np.arcsinh(other31, other31)
                np.multiply(v16, other31, other31)
                if some31:
                    np.copyto(out, other31, where=~m2)
        if some35 != size:
            np.copyto(out, C1, where=~m1)
    if some37 != size:
        np.copyto(out, C2, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, a, theta, b, E_star, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some37 = np.count_nonzero(m0)
    if some37:
        np.less(x, a, m1)
        some35 = np.count_nonzero(m1)
        if some35:
            np.add(x, b, t0)
            np.tan(theta, t1)
            np.multiply(E_star, t1, t1)
            np.divide(t1, C3, t1)
            np.less(x, b, m2)
            some31 = np.count_nonzero(m2)
            if some31:
                np.subtract(a, b, out)
                np.add(a, b, t2)
                np.multiply(out, t2, t2)
                np.sqrt(t2, t2)
                np.subtract(b, x, out)
                np.multiply(out, t0, out)
                np.sqrt(out, out)
                np.divide(t2, out, out)
                np.arcsinh(out, out)
                np.multiply(t1, out, out)
            if some31 != size:
                other31 = t2 if some31 else out
                np.subtract(a, x, other31)
                np.add(a, x, t3)
                np.multiply(other31, t3, t3)
                np.sqrt(t3, t3)
                np.subtract(x, b, other31)
                np.multiply(other31, t0, other31)
                np.sqrt(other31, other31)
                np.divide(t3, other31, other31)
                np.arcsinh(other31, other31)
                np.multiply(t1, other31, other31)
                if some31:
                    np.copyto(out, other31, where=~m2)
        if some35 != size:
            np.copyto(out, C1, where=~m1)
    if some37 != size:
        np.copyto(out, C2, where=~m0)


def profile(x, theta, b):
    if x.__class__ is theta.__class__ is b.__class__ is float and x > 1e-30 and (x < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            if x > b:
                return tan(theta) * (x - b)
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(theta, b):
    v4 = np.tan(theta)
    return (b, v4)


def block_profile_x(out, x, b, v4, m0):
    size = out.size
    np.greater(x, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.subtract(x, b, out)
        np.multiply(v4, out, out)
    if some8 != size:
        np.copyto(out, C1, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, theta, b, t0, m0):
    size = out.size
    np.greater(x, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.tan(theta, out)
        np.subtract(x, b, t0)
        np.multiply(out, t0, out)
    if some8 != size:
        np.copyto(out, C1, where=~m0)


def slope(x, a, theta, b):
    if x.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            if a >= b:
                v12 = tan(theta)
                if x > a:
                    return -2.0 * v12 / 3.141592653589793 * atan2(sqrt((a - b) * (a + b)), sqrt((x - a) * (a + x)))
                return -(v12 if x > b else 0.0)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slope_x(a, theta, b):
    v4 = a - b
    v5 = a + b
    v6 = v4 * v5
    v7 = np.sqrt(v6)
    v12 = np.tan(theta)
    v14 = (-2.0) * v12
    v16 = v14 / (3.141592653589793)
    v19 = np.greater_equal(a, b)
    return (a, b, v7, v12, v16, v19)


def block_slope_x(out, x, a, b, v7, v12, v16, v19, t0, m0, m1):
    size = out.size
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    if v19:
        np.greater(x, a, m0)
        some25 = np.count_nonzero(m0)
        if some25:
            np.subtract(x, a, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.arctan2(v7, t0, t0)
            np.multiply(v16, t0, out)
        if some25 != size:
            other25 = t0 if some25 else out
            np.greater(x, b, m1)
            some23 = np.count_nonzero(m1)
            if some23:
                np.copyto(other25, v12)
            if some23 != size:
                np.copyto(other25, C1, where=~m1)
            np.negative(other25, other25)
            if some25:
                np.copyto(out, other25, where=~m0)
    else:
        np.copyto(out, C2)


def prepare_slope_x_a(theta, b):
    v12 = np.tan(theta)
    v14 = (-2.0) * v12
    v16 = v14 / (3.141592653589793)
    return (b, v12, v16)


def block_slope_x_a(out, x, a, b, v12, v16, t0, t1, m0, m1, m2):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.greater(x, a, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            np.subtract(a, b, out)
            np.add(a, b, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.subtract(x, a, out)
            np.add(a, x, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.arctan2(t0, t1, t1)
            np.multiply(v16, t1, out)
        if some25 != size:
            other25 = t1 if some25 else out
            np.greater(x, b, m2)
            some23 = np.count_nonzero(m2)
            if some23:
                np.copyto(other25, v12)
            if some23 != size:
                np.copyto(other25, C1, where=~m2)
            np.negative(other25, other25)
            if some25:
                np.copyto(out, other25, where=~m1)
    if some27 != size:
        np.copyto(out, C2, where=~m0)


def prepare_slope_all():
    return ()


def block_slope_all(out, x, a, theta, b, t0, t1, t2, m0, m1, m2):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.tan(theta, t0)
        np.greater(x, a, m1)
        some25 = np.count_nonzero(m1)
        if some25:
            np.subtract(a, b, out)
            np.add(a, b, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.subtract(x, a, out)
            np.add(a, x, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.multiply(C4, t0, out)
            np.divide(out, C3, out)
            np.arctan2(t1, t2, t2)
            np.multiply(out, t2, out)
        if some25 != size:
            other25 = t2 if some25 else out
            np.greater(x, b, m2)
            some23 = np.count_nonzero(m2)
            if some23:
                np.copyto(other25, t0)
            if some23 != size:
                np.copyto(other25, C1, where=~m2)
            np.negative(other25, other25)
            if some25:
                np.copyto(out, other25, where=~m1)
    if some27 != size:
        np.copyto(out, C2, where=~m0)


BLOCKS = {
    ('_half_width_from_load', 1, 'P', 'theta', 'b', 'E_star'): {
        ('P',): (('P',), prepare_half_width_from_load_P, block_half_width_from_load_P, 0, 0, (), False),
        ('P', 'theta', 'b', 'E_star'): (('P', 'theta', 'b', 'E_star'), prepare_half_width_from_load_all, block_half_width_from_load_all, 2, 0, (), False),
    },
    ('_load', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 1, 0, (), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_load_all, block_load_all, 1, 0, (), False),
    },
    ('_pressure', 2, 'x', 'a', 'theta', 'b', 'E_star'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 3, 2, (), False),
        ('x', 'a'): (('x', 'a'), prepare_pressure_x_a, block_pressure_x_a, 3, 3, (), False),
        ('x', 'a', 'theta', 'b', 'E_star'): (('x', 'a', 'theta', 'b', 'E_star'), prepare_pressure_all, block_pressure_all, 4, 3, (), False),
    },
    ('_profile', 1, 'x', 'theta', 'b'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 1, (), False),
        ('x', 'theta', 'b'): (('x', 'theta', 'b'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_slope', 2, 'x', 'a', 'theta', 'b'): {
        ('x',): (('x',), prepare_slope_x, block_slope_x, 1, 2, (), False),
        ('x', 'a'): (('x', 'a'), prepare_slope_x_a, block_slope_x_a, 2, 3, (), False),
        ('x', 'a', 'theta', 'b'): (('x', 'a', 'theta', 'b'), prepare_slope_all, block_slope_all, 3, 3, (), False),
    },
}
