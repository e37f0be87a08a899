"""Programs of axicontact.graded.normal.flat_punch."""

from __future__ import annotations

from math import inf, pow, sqrt

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.normal import flat_punch as bodies

C0 = np.array(2.0)
C1 = np.array(1.0)
C2 = np.array(0.0)
C3 = np.array(np.inf)
C4 = np.array(3.141592653589793)


def depth_from_force(F, a, H, k):
    if F.__class__ is a.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = F / (2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(a, H, k):
    v5 = (2.0) * H
    v7 = (1.0) + k
    v8 = v5 / v7
    v10 = np.greater(a, (0.0))
    v11 = np.power(a, k)
    v12 = a * v11
    v13 = v12 if v10 else (0.0)
    v14 = v8 * v13
    return (v14,)


def block_depth_from_force_F(out, F, v14):
    np.divide(F, v14, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, a, H, k, t0, m0):
    size = out.size
    np.multiply(C0, H, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.add(C1, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C2, m0)
    some13 = np.count_nonzero(m0)
    if some13:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some13 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(t0, out, out)
    np.divide(F, out, out)


def displacement(r, d, a, k):
    if r.__class__ is d.__class__ is a.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._displacement(r, d, a, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(d, a, H, k):
    if d.__class__ is a.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0) * d
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_d(a, H, k):
    v5 = (2.0) * H
    v7 = (1.0) + k
    v8 = v5 / v7
    v10 = np.greater(a, (0.0))
    v11 = np.power(a, k)
    v12 = a * v11
    v13 = v12 if v10 else (0.0)
    v14 = v8 * v13
    return (v14,)


def block_force_d(out, d, v14):
    np.multiply(v14, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError


def prepare_force_all():
    return ()


def block_force_all(out, d, a, H, k, t0, m0):
    size = out.size
    np.multiply(C0, H, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.add(C1, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C2, m0)
    some13 = np.count_nonzero(m0)
    if some13:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some13 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(t0, out, out)
    np.multiply(out, d, out)


def pressure(r, d, a, H, k):
    if r.__class__ is d.__class__ is a.__class__ is H.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            if d > 0.0:
                if r < a:
                    v7 = a - r
                    v11 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + r))
                    v21 = H / 3.141592653589793 * pow(v11, k) / v11
                else:
                    v21 = 0.0 if r > a else inf
                value = d * v21
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, H, k):
    v6 = np.greater(d, (0.0))
    v14 = H / (3.141592653589793)
    return (d, a, k, v6, v14)


def block_pressure_r(out, r, d, a, k, v6, v14, t0, m0, m1, f0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v6:
        np.less(r, a, m0)
        some21 = np.count_nonzero(m0)
        if some21:
            np.subtract(a, r, out)
            np.maximum(out, f0, out=out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(t0, k, out)
            np.multiply(v14, out, out)
            np.divide(out, t0, out)
        if some21 != size:
            other21 = t0 if some21 else out
            np.greater(r, a, m1)
            some20 = np.count_nonzero(m1)
            if some20:
                np.copyto(other21, C2)
            if some20 != size:
                np.copyto(other21, C3, where=~m1)
            if some21:
                np.copyto(out, other21, where=~m0)
        np.multiply(d, out, out)
    else:
        np.copyto(out, C2)


def prepare_pressure_r_d(a, H, k):
    v14 = H / (3.141592653589793)
    return (a, k, v14)


def block_pressure_r_d(out, r, d, a, k, v14, t0, m0, m1, m2, f0):
    size = out.size
    np.greater(d, C2, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        np.less(r, a, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.subtract(a, r, out)
            np.maximum(out, f0, out=out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(t0, k, out)
            np.multiply(v14, out, out)
            np.divide(out, t0, out)
        if some21 != size:
            other21 = t0 if some21 else out
            np.greater(r, a, m2)
            some20 = np.count_nonzero(m2)
            if some20:
                np.copyto(other21, C2)
            if some20 != size:
                np.copyto(other21, C3, where=~m2)
            if some21:
                np.copyto(out, other21, where=~m1)
        np.multiply(d, out, out)
    if some23 != size:
        np.copyto(out, C2, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, H, k, t0, t1, m0, m1, m2, f0):
    size = out.size
    np.greater(d, C2, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        np.less(r, a, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.subtract(a, r, out)
            np.maximum(out, f0, out=out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.divide(H, C4, out)
            np.power(t0, k, t1)
            np.multiply(out, t1, t1)
            np.divide(t1, t0, out)
        if some21 != size:
            other21 = t0 if some21 else out
            np.greater(r, a, m2)
            some20 = np.count_nonzero(m2)
            if some20:
                np.copyto(other21, C2)
            if some20 != size:
                np.copyto(other21, C3, where=~m2)
            if some21:
                np.copyto(out, other21, where=~m1)
        np.multiply(d, out, out)
    if some23 != size:
        np.copyto(out, C2, where=~m0)


def stiffness(a, H, k):
    if a.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_all_signed():
    return ()


def block_stiffness_all_signed(out, a, H, k, t0, m0):
    size = out.size
    np.multiply(C0, H, out)
    np.add(C1, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C2, m0)
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(t0, out, out)


BLOCKS = {
    ('_depth_from_force', 1, 'F', 'a', 'H', 'k'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 0, 0, (), False),
        ('F', 'a', 'H', 'k'): (('F', 'a', 'H', 'k'), prepare_depth_from_force_all, block_depth_from_force_all, 1, 1, (), False),
    },
    ('_force', 1, 'd', 'a', 'H', 'k'): {
        ('d',): (('d',), prepare_force_d, block_force_d, 0, 0, (), False),
        ('d', 'a', 'H', 'k'): (('d', 'a', 'H', 'k'), prepare_force_all, block_force_all, 1, 1, (), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'H', 'k'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 1, 2, (0.0,), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 1, 3, (0.0,), False),
        ('r', 'd', 'a', 'H', 'k'): (('r', 'd', 'a', 'H', 'k'), prepare_pressure_all, block_pressure_all, 2, 3, (0.0,), False),
    },
    ('_stiffness', 0, 'a', 'H', 'k'): {
        ('a', 'H', 'k'): (('a', 'H', 'k'), prepare_stiffness_all_signed, block_stiffness_all_signed, 1, 1, (), False),
    },
}
