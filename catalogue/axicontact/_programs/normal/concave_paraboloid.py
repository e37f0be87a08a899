"""Programs of axicontact.normal.concave_paraboloid."""

from __future__ import annotations

from math import atan2, exp, expm1, fsum, inf, isfinite, log, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

C0 = np.array(np.nan)
C1 = np.array(16.0)
C2 = np.array(3.0)
C3 = np.array(0.999999999999999)
C4 = np.array(2.0)
C5 = np.array(4.0)
C6 = np.array(5.0)
C7 = np.array(0.0)
C8 = np.array(3.141592653589793)
RULE_0 = rule(((inf, 64),))


def depth_from_force(F, a, h, E_star):
    if F.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 16.0 * E_star * h / 3.0 * a * 0.999999999999999 <= F:
                return F / (2.0 * E_star * a) - 2.0 * h / 3.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(a, h, E_star):
    v5 = (16.0) * E_star
    v6 = v5 * h
    v8 = v6 / (3.0)
    v9 = v8 * a
    v11 = v9 * (0.999999999999999)
    v14 = (2.0) * E_star
    v15 = v14 * a
    v17 = (2.0) * h
    v18 = v17 / (3.0)
    return (v11, v15, v18)


def block_depth_from_force_F(out, F, v11, v15, v18, m0):
    size = out.size
    np.less_equal(v11, F, m0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    some21 = np.count_nonzero(m0)
    if some21:
        np.divide(F, v15, out)
        np.subtract(out, v18, out)
    if some21 != size:
        np.copyto(out, C0, where=~m0)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, a, h, E_star, t0, m0):
    size = out.size
    np.multiply(C1, E_star, t0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(t0, h, t0)
    np.divide(t0, C2, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, C3, t0)
    np.less_equal(t0, F, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.multiply(C4, E_star, out)
        np.multiply(out, a, out)
        np.divide(F, out, out)
        np.multiply(C4, h, t0)
        np.divide(t0, C2, t0)
        np.subtract(out, t0, out)
    if some21 != size:
        np.copyto(out, C0, where=~m0)


def displacement(r, d, a, h):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            v11 = 2.0 * h
            if v11 * 0.999999999999999 <= d:
                if r > a:
                    v4 = r - a
                    v12 = v4 / a
                    v19 = sqrt(log1p(v12) if isfinite(v12) else log(r) - log(a))
                    v25 = 14.0 / (sqrt(v19 * v19 + 14.0) + v19)
                    v32 = 2.0 * v19
                    v45 = []
                    for node, weight in RULE_0(v25 / 1.0):
                        v28 = node * v25
                        v29 = v19 + v28
                        v44 = exp(-3.0 * v28 * (v32 + v28)) * (2.0 * v29 / sqrt(-expm1(-2.0 * v29 * v29)))
                        v45.append(weight * v44)
                    v45 = fsum(v45) * v25
                    value = 0.6366197723675814 * (d * atan2(a, sqrt(v4 * (r + a))) + v11 * (a / r * v45))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h):
                        return value
                    return None
                value = d - (-h * (r * r) / (a * a) if r <= a else nan)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(d, a, h, E_star):
    if d.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 2.0 * h * 0.999999999999999 <= d:
                return E_star * (d * d * a + 4.0 * h / 3.0 * d * a + 4.0 * (h * h) / 5.0 * a)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_d(a, h, E_star):
    v5 = (2.0) * h
    v7 = v5 * (0.999999999999999)
    v12 = (4.0) * h
    v14 = v12 / (3.0)
    v18 = np.square(h)
    v19 = (4.0) * v18
    v21 = v19 / (5.0)
    v22 = v21 * a
    return (a, E_star, v7, v14, v22)


def block_energy_d(out, d, a, E_star, v7, v14, v22, t0, m0):
    size = out.size
    np.less_equal(v7, d, m0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some26 = np.count_nonzero(m0)
    if some26:
        np.square(d, out)
        np.multiply(out, a, out)
        np.multiply(v14, d, t0)
        np.multiply(t0, a, t0)
        np.add(out, t0, t0)
        np.add(t0, v22, t0)
        np.multiply(E_star, t0, out)
    if some26 != size:
        np.copyto(out, C0, where=~m0)


def prepare_energy_all():
    return ()


def block_energy_all(out, d, a, h, E_star, t0, m0):
    size = out.size
    np.multiply(C4, h, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(t0, C3, t0)
    np.less_equal(t0, d, m0)
    some26 = np.count_nonzero(m0)
    if some26:
        np.square(d, out)
        np.multiply(out, a, out)
        np.multiply(C5, h, t0)
        np.divide(t0, C2, t0)
        np.multiply(t0, d, t0)
        np.multiply(t0, a, t0)
        np.add(out, t0, t0)
        np.square(h, out)
        np.multiply(C5, out, out)
        np.divide(out, C6, out)
        np.multiply(out, a, out)
        np.add(t0, out, out)
        np.multiply(E_star, out, out)
    if some26 != size:
        np.copyto(out, C0, where=~m0)


def force(d, a, h, E_star):
    if d.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = 2.0 * h
            if v5 * 0.999999999999999 <= d:
                return 2.0 * E_star * a * (d + v5 / 3.0)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_d(a, h, E_star):
    v5 = (2.0) * h
    v7 = v5 * (0.999999999999999)
    v9 = (2.0) * E_star
    v10 = v9 * a
    v12 = v5 / (3.0)
    return (v7, v10, v12)


def block_force_d(out, d, v7, v10, v12, m0):
    size = out.size
    np.less_equal(v7, d, m0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.add(d, v12, out)
        np.multiply(v10, out, out)
    if some16 != size:
        np.copyto(out, C0, where=~m0)


def prepare_force_all():
    return ()


def block_force_all(out, d, a, h, E_star, t0, t1, m0):
    size = out.size
    np.multiply(C4, h, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(t0, C3, t1)
    np.less_equal(t1, d, m0)
    some16 = np.count_nonzero(m0)
    if some16:
        np.multiply(C4, E_star, out)
        np.multiply(out, a, out)
        np.divide(t0, C2, t1)
        np.add(d, t1, t1)
        np.multiply(out, t1, out)
    if some16 != size:
        np.copyto(out, C0, where=~m0)


def load_within(r, d, a, h, E_star):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v25 = 2.0 * h
            v31 = v25 * 0.999999999999999 <= d
            if v31:
                v23 = 2.0 * E_star
                if r < a:
                    v8 = sqrt((a - r) * (a + r))
                    v12 = r * r / (a + v8)
                    value = v23 * v12 * (d - v25 + 4.0 * h * v12 * (v8 + 2.0 * a) / (3.0 * (a * a)))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                if v31:
                    return v23 * a * (d + v25 / 3.0)
                return nan
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(d, a, h, E_star):
    v14 = (4.0) * h
    v16 = (2.0) * a
    v19 = np.square(a)
    v21 = (3.0) * v19
    v23 = (2.0) * E_star
    v25 = (2.0) * h
    v26 = d - v25
    v30 = v25 * (0.999999999999999)
    v31 = np.less_equal(v30, d)
    v33 = v23 * a
    v34 = v25 / (3.0)
    v35 = d + v34
    v36 = v33 * v35
    v38 = v36 if v31 else (np.nan)
    return (a, v14, v16, v21, v23, v26, v31, v38)


def block_load_within_r(out, r, a, v14, v16, v21, v23, v26, v31, v38, t0, t1, m0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v31:
        np.less(r, a, m0)
        some39 = np.count_nonzero(m0)
        if some39:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.add(a, t0, t1)
            np.divide(out, t1, t1)
            np.multiply(v14, t1, out)
            np.add(t0, v16, t0)
            np.multiply(out, t0, t0)
            np.divide(t0, v21, t0)
            np.multiply(v23, t1, t1)
            np.add(v26, t0, t0)
            np.multiply(t1, t0, out)
        if some39 != size:
            np.copyto(out, v38, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_load_within_r_d(a, h, E_star):
    v14 = (4.0) * h
    v16 = (2.0) * a
    v19 = np.square(a)
    v21 = (3.0) * v19
    v23 = (2.0) * E_star
    v25 = (2.0) * h
    v30 = v25 * (0.999999999999999)
    v33 = v23 * a
    v34 = v25 / (3.0)
    return (a, v14, v16, v21, v23, v25, v30, v33, v34)


def block_load_within_r_d(out, r, d, a, v14, v16, v21, v23, v25, v30, v33, v34, t0, t1, m0, m1):
    size = out.size
    np.less_equal(v30, d, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some40 = np.count_nonzero(m0)
    if some40:
        np.less(r, a, m1)
        some39 = np.count_nonzero(m1)
        if some39:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.add(a, t0, t1)
            np.divide(out, t1, t1)
            np.multiply(v14, t1, out)
            np.add(t0, v16, t0)
            np.multiply(out, t0, t0)
            np.divide(t0, v21, t0)
            np.multiply(v23, t1, t1)
            np.subtract(d, v25, out)
            np.add(out, t0, t0)
            np.multiply(t1, t0, out)
        if some39 != size:
            other39 = t0 if some39 else out
            some38 = np.count_nonzero(m0)
            if some38:
                np.add(d, v34, other39)
                np.multiply(v33, other39, other39)
            if some38 != size:
                np.copyto(other39, C0, where=~m0)
            if some39:
                np.copyto(out, other39, where=~m1)
    if some40 != size:
        np.copyto(out, C0, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, d, a, h, E_star, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.multiply(C4, h, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(t0, C3, t1)
    np.less_equal(t1, d, m0)
    some40 = np.count_nonzero(m0)
    if some40:
        np.multiply(C4, E_star, t1)
        np.less(r, a, m1)
        some39 = np.count_nonzero(m1)
        if some39:
            np.subtract(a, r, out)
            np.add(a, r, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.square(r, out)
            np.add(a, t2, t3)
            np.divide(out, t3, t3)
            np.multiply(C5, h, out)
            np.multiply(out, t3, out)
            np.multiply(C4, a, t4)
            np.add(t2, t4, t4)
            np.multiply(out, t4, t4)
            np.square(a, out)
            np.multiply(C2, out, out)
            np.divide(t4, out, out)
            np.multiply(t1, t3, t3)
            np.subtract(d, t0, t4)
            np.add(t4, out, out)
            np.multiply(t3, out, out)
        if some39 != size:
            other39 = t3 if some39 else out
            some38 = np.count_nonzero(m0)
            if some38:
                np.multiply(t1, a, other39)
                np.divide(t0, C2, t4)
                np.add(d, t4, t4)
                np.multiply(other39, t4, other39)
            if some38 != size:
                np.copyto(other39, C0, where=~m0)
            if some39:
                np.copyto(out, other39, where=~m1)
    if some40 != size:
        np.copyto(out, C0, where=~m0)


def minimum_depth(h, a=1.0):
    if h.__class__ is a.__class__ is float and h > 1e-30 and (h < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            return 2.0 * h
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_depth_all_signed():
    return ()


def block_minimum_depth_all_signed(out, h):
    np.multiply(C4, h, out)


def minimum_force(a, h, E_star):
    if a.__class__ is h.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 16.0 * E_star * h / 3.0 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_force_all_signed():
    return ()


def block_minimum_force_all_signed(out, a, h, E_star):
    np.multiply(C1, E_star, out)
    np.multiply(out, h, out)
    np.divide(out, C2, out)
    np.multiply(out, a, out)


def pressure(r, d, a, h, E_star):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v16 = 2.0 * h
            if v16 * 0.999999999999999 <= d:
                if r <= a and d > 0.0:
                    return E_star / 3.141592653589793 * (d - v16 + 4.0 * h * (r * r) / (a * a)) / sqrt((a - r) * (a + r))
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, h, E_star):
    v10 = (4.0) * h
    v14 = np.square(a)
    v16 = (2.0) * h
    v18 = v16 * (0.999999999999999)
    v19 = np.less_equal(v18, d)
    v22 = np.greater(d, (0.0))
    v25 = E_star / (3.141592653589793)
    v26 = d - v16
    return (a, v10, v14, v19, v22, v25, v26)


def block_pressure_r(out, r, a, v10, v14, v19, v22, v25, v26, t0, m0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v19:
        np.less_equal(r, a, m0)
        np.bitwise_and(m0, v22, m0)
        some30 = np.count_nonzero(m0)
        if some30:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.multiply(v10, out, out)
            np.divide(out, v14, out)
            np.add(v26, out, out)
            np.multiply(v25, out, out)
            np.divide(out, t0, out)
        if some30 != size:
            np.copyto(out, C7, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_pressure_r_d(a, h, E_star):
    v10 = (4.0) * h
    v14 = np.square(a)
    v16 = (2.0) * h
    v18 = v16 * (0.999999999999999)
    v25 = E_star / (3.141592653589793)
    return (a, v10, v14, v16, v18, v25)


def block_pressure_r_d(out, r, d, a, v10, v14, v16, v18, v25, t0, t1, m0, m1, m2):
    size = out.size
    np.less_equal(v18, d, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some32 = np.count_nonzero(m0)
    if some32:
        np.less_equal(r, a, m1)
        np.greater(d, C7, m2)
        np.bitwise_and(m1, m2, m2)
        some30 = np.count_nonzero(m2)
        if some30:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.multiply(v10, out, out)
            np.divide(out, v14, out)
            np.subtract(d, v16, t1)
            np.add(t1, out, out)
            np.multiply(v25, out, out)
            np.divide(out, t0, out)
        if some30 != size:
            np.copyto(out, C7, where=~m2)
    if some32 != size:
        np.copyto(out, C0, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, h, E_star, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.multiply(C4, h, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(t0, C3, t1)
    np.less_equal(t1, d, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.less_equal(r, a, m1)
        np.greater(d, C7, m2)
        np.bitwise_and(m1, m2, m2)
        some30 = np.count_nonzero(m2)
        if some30:
            np.subtract(a, r, out)
            np.add(a, r, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.multiply(C5, h, out)
            np.square(r, t2)
            np.multiply(out, t2, t2)
            np.square(a, out)
            np.divide(t2, out, out)
            np.divide(E_star, C8, t2)
            np.subtract(d, t0, t3)
            np.add(t3, out, out)
            np.multiply(t2, out, out)
            np.divide(out, t1, out)
        if some30 != size:
            np.copyto(out, C7, where=~m2)
    if some32 != size:
        np.copyto(out, C0, where=~m0)


def profile(r, a, h):
    if r.__class__ is a.__class__ is h.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            if r <= a:
                return -h * (r * r) / (a * a)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(a, h):
    v4 = np.negative(h)
    v8 = np.square(a)
    return (a, v4, v8)


def block_profile_r(out, r, a, v4, v8, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.square(r, out)
        np.multiply(v4, out, out)
        np.divide(out, v8, out)
    if some11 != size:
        np.copyto(out, C0, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, a, h, t0, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.negative(h, out)
        np.square(r, t0)
        np.multiply(out, t0, t0)
        np.square(a, out)
        np.divide(t0, out, out)
    if some11 != size:
        np.copyto(out, C0, where=~m0)


def stiffness(a, E_star, h=1.0):
    if a.__class__ is E_star.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            return 2.0 * E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_all_signed():
    return ()


def block_stiffness_all_signed(out, a, E_star):
    np.multiply(C4, E_star, out)
    np.multiply(out, a, out)


def zero_radius(a=1.0, h=1.0):
    if a.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth_from_force', 1, 'F', 'a', 'h', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 0, 1, (), False),
        ('F', 'a', 'h', 'E_star'): (('F', 'a', 'h', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 1, 1, (), False),
    },
    ('_energy', 1, 'd', 'a', 'h', 'E_star'): {
        ('d',): (('d',), prepare_energy_d, block_energy_d, 1, 1, (), False),
        ('d', 'a', 'h', 'E_star'): (('d', 'a', 'h', 'E_star'), prepare_energy_all, block_energy_all, 1, 1, (), False),
    },
    ('_force', 1, 'd', 'a', 'h', 'E_star'): {
        ('d',): (('d',), prepare_force_d, block_force_d, 0, 1, (), False),
        ('d', 'a', 'h', 'E_star'): (('d', 'a', 'h', 'E_star'), prepare_force_all, block_force_all, 2, 1, (), False),
    },
    ('_load_within', 2, 'r', 'd', 'a', 'h', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 2, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_load_within_r_d, block_load_within_r_d, 2, 2, (), False),
        ('r', 'd', 'a', 'h', 'E_star'): (('r', 'd', 'a', 'h', 'E_star'), prepare_load_within_all, block_load_within_all, 5, 2, (), False),
    },
    ('_minimum_depth', 0, 'h'): {
        ('h',): (('h',), prepare_minimum_depth_all_signed, block_minimum_depth_all_signed, 0, 0, (), False),
    },
    ('_minimum_force', 0, 'a', 'h', 'E_star'): {
        ('a', 'h', 'E_star'): (('a', 'h', 'E_star'), prepare_minimum_force_all_signed, block_minimum_force_all_signed, 0, 0, (), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'h', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 1, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 2, 3, (), False),
        ('r', 'd', 'a', 'h', 'E_star'): (('r', 'd', 'a', 'h', 'E_star'), prepare_pressure_all, block_pressure_all, 4, 3, (), False),
    },
    ('_profile', 1, 'r', 'a', 'h'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 1, (), False),
        ('r', 'a', 'h'): (('r', 'a', 'h'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_stiffness', 0, 'a', 'E_star'): {
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all_signed, block_stiffness_all_signed, 0, 0, (), False),
    },
}
