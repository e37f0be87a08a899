"""Programs of axicontact.plane.eccentric_punch."""

from __future__ import annotations

from math import copysign, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.5)
C1 = np.array(2.0)
C2 = np.array(4.0)
C3 = np.array(0.0)
C4 = np.array(3.141592653589793)
C5 = np.array(1.0)
C6 = np.array(6.283185307179586)


def contact_width(a, e):
    if a.__class__ is e.__class__ is float and a > 1e-30 and (a < 1e+30) and (e > 1e-30) and (e < 1e+30):
        try:
            v2 = abs(e)
            if v2 < a / 2.0:
                return 2.0 * a
            return 4.0 * (a - v2)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_contact_width_all_signed():
    return ()


def block_contact_width_all_signed(out, a, e, t0, t1, m0):
    size = out.size
    np.absolute(e, t0)
    np.multiply(a, C0, t1)
    np.less(t0, t1, m0)
    some11 = np.count_nonzero(m0)
    if some11:
        np.multiply(C1, a, out)
    if some11 != size:
        other11 = t1 if some11 else out
        np.subtract(a, t0, other11)
        np.multiply(C2, other11, other11)
        if some11:
            np.copyto(out, other11, where=~m0)


def pressure(x, P, a, e):
    if x.__class__ is P.__class__ is a.__class__ is e.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (e > 1e-30) and (e < 1e+30):
        try:
            if x <= a and P > 0.0:
                v20 = abs(e)
                if v20 < a / 2.0:
                    v4 = a - x
                    return P * (x * (2.0 * e + a) + a * v4) / (3.141592653589793 * (a * a) * sqrt(v4 * (a + x)))
                v26 = copysign(1.0, e) * x
                v29 = 2.0 * (2.0 * v20 - a)
                v30 = v29 - a
                v36 = a + v26 - v29 if v30 < -a / 2.0 else v26 - v30
                value = P * sqrt((v36 if v36 > 0.0 or v36 != v36 else 0.0) / (a - v26)) / (6.283185307179586 * (a - v20))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_x(P, a, e):
    v9 = (2.0) * e
    v10 = v9 + a
    v15 = np.square(a)
    v17 = (3.141592653589793) * v15
    v20 = np.absolute(e)
    v21 = a - v20
    v23 = np.copysign((1.0), e)
    v24 = (2.0) * v20
    v25 = v24 - a
    v29 = (2.0) * v25
    v30 = v29 - a
    v31 = np.negative(a)
    v32 = v31 / (2.0)
    v33 = np.less(v30, v32)
    v43 = (6.283185307179586) * v21
    v45 = a / (2.0)
    v46 = np.less(v20, v45)
    v49 = np.greater(P, (0.0))
    return (P, a, v10, v17, v23, v29, v30, v33, v43, v46, v49)


def block_pressure_x(out, x, P, a, v10, v17, v23, v29, v30, v33, v43, v46, v49, t0, t1, m0, f0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v49, m0)
    some51 = np.count_nonzero(m0)
    if some51:
        if v46:
            np.subtract(a, x, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(x, v10, t1)
            np.multiply(a, out, out)
            np.add(t1, out, out)
            np.multiply(P, out, out)
            np.multiply(v17, t0, t0)
            np.divide(out, t0, out)
        else:
            np.multiply(v23, x, out)
            np.subtract(a, out, t0)
            if v33:
                np.add(a, out, t1)
                np.subtract(t1, v29, t1)
            else:
                np.subtract(out, v30, t1)
            np.maximum(t1, f0, out=t1)
            np.divide(t1, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(P, t0, t0)
            np.divide(t0, v43, out)
    if some51 != size:
        np.copyto(out, C3, where=~m0)


def prepare_pressure_x_P(a, e):
    v9 = (2.0) * e
    v10 = v9 + a
    v15 = np.square(a)
    v17 = (3.141592653589793) * v15
    v20 = np.absolute(e)
    v21 = a - v20
    v23 = np.copysign((1.0), e)
    v24 = (2.0) * v20
    v25 = v24 - a
    v29 = (2.0) * v25
    v30 = v29 - a
    v31 = np.negative(a)
    v32 = v31 / (2.0)
    v33 = np.less(v30, v32)
    v43 = (6.283185307179586) * v21
    v45 = a / (2.0)
    v46 = np.less(v20, v45)
    return (a, v10, v17, v23, v29, v30, v33, v43, v46)


def block_pressure_x_P(out, x, P, a, v10, v17, v23, v29, v30, v33, v43, v46, t0, t1, m0, m1, f0):
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
    some51 = np.count_nonzero(m1)
    if some51:
        if v46:
            np.subtract(a, x, out)
            np.add(a, x, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(x, v10, t1)
            np.multiply(a, out, out)
            np.add(t1, out, out)
            np.multiply(P, out, out)
            np.multiply(v17, t0, t0)
            np.divide(out, t0, out)
        else:
            np.multiply(v23, x, out)
            np.subtract(a, out, t0)
            if v33:
                np.add(a, out, t1)
                np.subtract(t1, v29, t1)
            else:
                np.subtract(out, v30, t1)
            np.maximum(t1, f0, out=t1)
            np.divide(t1, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(P, t0, t0)
            np.divide(t0, v43, out)
    if some51 != size:
        np.copyto(out, C3, where=~m1)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, x, P, a, e, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, m2, f0):
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
    some52 = np.count_nonzero(m1)
    if some52:
        np.absolute(e, t0)
        np.multiply(a, C0, t1)
        np.less(t0, t1, m0)
        some48 = np.count_nonzero(m0)
        if some48:
            np.subtract(a, x, out)
            np.add(a, x, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.multiply(C1, e, t2)
            np.add(t2, a, t2)
            np.multiply(x, t2, t2)
            np.multiply(a, out, out)
            np.add(t2, out, out)
            np.multiply(P, out, out)
            np.square(a, t2)
            np.multiply(C4, t2, t2)
            np.multiply(t2, t1, t1)
            np.divide(out, t1, out)
        if some48 != size:
            other48 = t1 if some48 else out
            np.subtract(a, t0, other48)
            np.copysign(C5, e, t2)
            np.multiply(C1, t0, t3)
            np.subtract(t3, a, t3)
            np.multiply(t2, x, t2)
            np.subtract(a, t2, t4)
            np.multiply(C1, t3, t3)
            np.subtract(t3, a, t5)
            np.negative(a, t6)
            np.multiply(t6, C0, t6)
            np.less(t5, t6, m2)
            some37 = np.count_nonzero(m2)
            if some37:
                np.add(a, t2, t6)
                np.subtract(t6, t3, t6)
            if some37 != size:
                other37 = t7 if some37 else t6
                np.subtract(t2, t5, other37)
                if some37:
                    np.copyto(t6, other37, where=~m2)
            np.maximum(t6, f0, out=t6)
            np.divide(t6, t4, t4)
            np.sqrt(t4, t4)
            np.multiply(P, t4, t4)
            np.multiply(C6, other48, other48)
            np.divide(t4, other48, other48)
            if some48:
                np.copyto(out, other48, where=~m0)
    if some52 != size:
        np.copyto(out, C3, where=~m1)


def tilt(P, a, e, E_star):
    if P.__class__ is a.__class__ is e.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (e > 1e-30) and (e < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v4 = abs(e)
            v15 = 3.141592653589793 * E_star
            if v4 < a / 2.0:
                return 4.0 * e * P / (v15 * (a * a))
            value = copysign(1.0, e) / (v15 * (a - v4)) * P
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tilt_P(a, e, E_star):
    v4 = np.absolute(e)
    v5 = a - v4
    v7 = np.copysign((1.0), e)
    v9 = a / (2.0)
    v10 = np.less(v4, v9)
    v12 = (4.0) * e
    v15 = (3.141592653589793) * E_star
    v16 = np.square(a)
    v17 = v15 * v16
    v19 = v15 * v5
    v20 = v7 / v19
    return (v10, v12, v17, v20)


def block_tilt_P(out, P, v10, v12, v17, v20):
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    if v10:
        np.multiply(v12, P, out)
        np.divide(out, v17, out)
    else:
        np.multiply(v20, P, out)


def prepare_tilt_all():
    return ()


def block_tilt_all(out, P, a, e, E_star, t0, t1, t2, t3, m0):
    size = out.size
    np.absolute(e, t0)
    largest_P = largest(P)
    if largest_P == np.inf:
        raise FloatingPointError
    np.multiply(a, C0, t1)
    np.less(t0, t1, m0)
    np.multiply(C4, E_star, t1)
    some23 = np.count_nonzero(m0)
    if some23:
        np.multiply(C2, e, out)
        np.multiply(out, P, out)
        np.square(a, t2)
        np.multiply(t1, t2, t2)
        np.divide(out, t2, out)
    if some23 != size:
        other23 = t2 if some23 else out
        np.subtract(a, t0, other23)
        np.copysign(C5, e, t3)
        np.multiply(t1, other23, other23)
        np.divide(t3, other23, other23)
        np.multiply(other23, P, other23)
        if some23:
            np.copyto(out, other23, where=~m0)


BLOCKS = {
    ('_contact_width', 0, 'a', 'e'): {
        ('a', 'e'): (('a', 'e'), prepare_contact_width_all_signed, block_contact_width_all_signed, 2, 1, (), False),
    },
    ('_pressure', 2, 'x', 'P', 'a', 'e'): {
        ('x',): (('x',), prepare_pressure_x, block_pressure_x, 2, 1, (0.0,), False),
        ('x', 'P'): (('x', 'P'), prepare_pressure_x_P, block_pressure_x_P, 2, 2, (0.0,), False),
        ('x', 'P', 'a', 'e'): (('x', 'P', 'a', 'e'), prepare_pressure_all, block_pressure_all, 8, 3, (0.0,), False),
    },
    ('_tilt', 1, 'P', 'a', 'e', 'E_star'): {
        ('P',): (('P',), prepare_tilt_P, block_tilt_P, 0, 0, (), False),
        ('P', 'a', 'e', 'E_star'): (('P', 'a', 'e', 'E_star'), prepare_tilt_all, block_tilt_all, 4, 1, (), False),
    },
}
