"""Programs of axicontact.graded.adhesive.truncated_paraboloid."""

from __future__ import annotations

from math import nan, pow, sqrt

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.adhesive import truncated_paraboloid as bodies

C0 = np.array(0.0)
C1 = np.array(np.nan)
C2 = np.array(1.0)
C3 = np.array(6.283185307179586)
C4 = np.array(2.0)
C5 = np.array(3.0)


def depth(a, R, b, H, k, dgamma):
    if a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            if a >= b:
                v7 = a - b
                v13 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + b)) / a
                v27 = (a * a * (v13 * pow(v13, k) if v13 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b) / R
            else:
                v27 = nan
            value = v27 - (sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, b, H, k, dgamma):
    v21 = (1.0) + k
    v23 = (0.0) * b
    v30 = (6.283185307179586) * dgamma
    v31 = v30 / H
    v32 = np.sqrt(v31)
    v35 = np.negative(k)
    return (R, b, k, v21, v23, v32, v35)


def block_depth_a(out, a, R, b, k, v21, v23, v32, v35, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(t0, a, t0)
        np.multiply(a, a, out)
        np.greater(t0, C0, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.power(t0, k, t1)
            np.multiply(t0, t1, t1)
        if some18 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(out, t1, t1)
        np.divide(t1, v21, t1)
        np.add(t1, v23, t1)
        np.divide(t1, R, out)
    if some27 != size:
        np.copyto(out, C1, where=~m0)
    np.greater(a, C0, m0)
    some39 = np.count_nonzero(m0)
    if some39:
        np.sqrt(a, t1)
        np.multiply(v32, t1, t1)
        np.power(a, v35, t0)
        np.sqrt(t0, t0)
        np.multiply(t1, t0, t1)
    if some39 != size:
        np.copyto(t1, C0, where=~m0)
    np.subtract(out, t1, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, b, H, k, dgamma, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(t0, a, t0)
        np.multiply(a, a, out)
        np.greater(t0, C0, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.power(t0, k, t1)
            np.multiply(t0, t1, t1)
        if some18 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(out, t1, t1)
        np.add(C2, k, out)
        np.divide(t1, out, out)
        np.multiply(C0, b, t1)
        np.add(out, t1, t1)
        np.divide(t1, R, out)
    if some27 != size:
        np.copyto(out, C1, where=~m0)
    np.greater(a, C0, m0)
    some39 = np.count_nonzero(m0)
    if some39:
        np.multiply(C3, dgamma, t1)
        np.divide(t1, H, t1)
        np.sqrt(t1, t1)
        np.sqrt(a, t0)
        np.multiply(t1, t0, t0)
        np.negative(k, t1)
        np.power(a, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(t0, t1, t1)
    if some39 != size:
        np.copyto(t1, C0, where=~m0)
    np.subtract(out, t1, out)


def displacement(r, a, R, b, H, k, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            value = bodies._displacement(r, a, R, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, b, H, k, dgamma):
    if a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            v16 = a > 0.0
            v19 = a * pow(a, k) if v16 else 0.0
            v29 = 1.0 + k
            v41 = 2.0 * H / v29
            if a >= b:
                v7 = a - b
                v14 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (a + b)) / (a if a > b or a != a else b)
                v27 = 3.0 + k
                v44 = v41 * ((a * a * v19 * (v14 * pow(v14, k) if v14 > 0.0 else 0.0) * (v27 - v29 * (v14 * v14)) / (v29 * v27) + 0.0 * b) / R)
            else:
                v44 = nan
            value = v44 - v41 * v19 * (sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if v16 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, b, H, k, dgamma):
    v27 = (3.0) + k
    v29 = (1.0) + k
    v35 = v29 * v27
    v37 = (0.0) * b
    v40 = (2.0) * H
    v41 = v40 / v29
    v47 = (6.283185307179586) * dgamma
    v48 = v47 / H
    v49 = np.sqrt(v48)
    v52 = np.negative(k)
    return (R, b, k, v27, v29, v35, v37, v41, v49, v52)


def block_force_a(out, a, R, b, k, v27, v29, v35, v37, v41, v49, v52, t0, t1, t2, m0, m1, m2, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(a, C0, m1)
    some19 = np.count_nonzero(m1)
    if some19:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some19 != size:
        np.copyto(out, C0, where=~m1)
    some44 = np.count_nonzero(m0)
    if some44:
        np.subtract(a, b, t0)
        np.maximum(t0, f0, out=t0)
        np.add(a, b, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.maximum(a, b, out=t0)
        np.divide(t1, t0, t0)
        np.multiply(a, a, t1)
        np.multiply(t1, out, t1)
        np.greater(t0, C0, m2)
        some24 = np.count_nonzero(m2)
        if some24:
            np.power(t0, k, t2)
            np.multiply(t0, t2, t2)
        if some24 != size:
            np.copyto(t2, C0, where=~m2)
        np.multiply(t1, t2, t2)
        np.square(t0, t0)
        np.multiply(v29, t0, t0)
        np.subtract(v27, t0, t0)
        np.multiply(t2, t0, t0)
        np.divide(t0, v35, t0)
        np.add(t0, v37, t0)
        np.divide(t0, R, t0)
        np.multiply(v41, t0, t0)
    if some44 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(v41, out, out)
    some56 = np.count_nonzero(m1)
    if some56:
        np.sqrt(a, t2)
        np.multiply(v49, t2, t2)
        np.power(a, v52, t1)
        np.sqrt(t1, t1)
        np.multiply(t2, t1, t2)
    if some56 != size:
        np.copyto(t2, C0, where=~m1)
    np.multiply(out, t2, t2)
    np.subtract(t0, t2, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, b, H, k, dgamma, t0, t1, t2, t3, t4, m0, m1, m2, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(a, C0, m1)
    some19 = np.count_nonzero(m1)
    if some19:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some19 != size:
        np.copyto(out, C0, where=~m1)
    np.add(C2, k, t0)
    np.multiply(C4, H, t1)
    np.divide(t1, t0, t1)
    some44 = np.count_nonzero(m0)
    if some44:
        np.subtract(a, b, t2)
        np.maximum(t2, f0, out=t2)
        np.add(a, b, t3)
        np.multiply(t2, t3, t3)
        np.sqrt(t3, t3)
        np.maximum(a, b, out=t2)
        np.divide(t3, t2, t2)
        np.multiply(a, a, t3)
        np.multiply(t3, out, t3)
        np.greater(t2, C0, m2)
        some24 = np.count_nonzero(m2)
        if some24:
            np.power(t2, k, t4)
            np.multiply(t2, t4, t4)
        if some24 != size:
            np.copyto(t4, C0, where=~m2)
        np.multiply(t3, t4, t4)
        np.add(C5, k, t3)
        np.square(t2, t2)
        np.multiply(t0, t2, t2)
        np.subtract(t3, t2, t2)
        np.multiply(t4, t2, t2)
        np.multiply(t0, t3, t3)
        np.divide(t2, t3, t3)
        np.multiply(C0, b, t2)
        np.add(t3, t2, t2)
        np.divide(t2, R, t2)
        np.multiply(t1, t2, t2)
    if some44 != size:
        np.copyto(t2, C1, where=~m0)
    np.multiply(t1, out, out)
    some56 = np.count_nonzero(m1)
    if some56:
        np.multiply(C3, dgamma, t1)
        np.divide(t1, H, t1)
        np.sqrt(t1, t1)
        np.sqrt(a, t0)
        np.multiply(t1, t0, t0)
        np.negative(k, t1)
        np.power(a, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(t0, t1, t1)
    if some56 != size:
        np.copyto(t1, C0, where=~m1)
    np.multiply(out, t1, t1)
    np.subtract(t2, t1, out)


def pressure(r, a, R, b, H, k, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            value = bodies._pressure(r, a, R, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R, b, H, k, dgamma, control):
    if R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and R > 1e-30 and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(R, b, H, k, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, b, H, k, dgamma):
    if d.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, b, H, k, dgamma):
    if F.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, R, b, H, k):
    if F.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, R, b, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, b, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'b', 'H', 'k', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 2, 2, (0.0,), False),
        ('a', 'R', 'b', 'H', 'k', 'dgamma'): (('a', 'R', 'b', 'H', 'k', 'dgamma'), prepare_depth_all, block_depth_all, 2, 2, (0.0,), False),
    },
    ('_force', 1, 'a', 'R', 'b', 'H', 'k', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 3, 3, (0.0,), False),
        ('a', 'R', 'b', 'H', 'k', 'dgamma'): (('a', 'R', 'b', 'H', 'k', 'dgamma'), prepare_force_all, block_force_all, 5, 3, (0.0,), False),
    },
}
