"""Programs of axicontact.normal.concave_quartic."""

from __future__ import annotations

from math import atan2, exp, expm1, fsum, inf, isfinite, log, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

C0 = np.array(np.nan)
C1 = np.array(56.0)
C2 = np.array(15.0)
C3 = np.array(0.999999999999999)
C4 = np.array(2.0)
C5 = np.array(8.0)
C6 = np.array(4.0)
C7 = np.array(3.0)
C8 = np.array(16.0)
C9 = np.array(64.0)
C10 = np.array(81.0)
C11 = np.array(5.0)
C12 = np.array(120.0)
C13 = np.array(80.0)
C14 = np.array(40.0)
C15 = np.array(45.0)
C16 = np.array(0.0)
C17 = np.array(9.0)
C18 = np.array(3.141592653589793)
C19 = np.array(0.5)
RULE_0 = rule(((inf, 64),))


def depth_from_force(F, a, h, E_star):
    if F.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 56.0 * E_star * h / 15.0 * a * 0.999999999999999 <= F:
                return F / (2.0 * E_star * a) - 8.0 * h / 15.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(a, h, E_star):
    v5 = (56.0) * E_star
    v6 = v5 * h
    v8 = v6 / (15.0)
    v9 = v8 * a
    v11 = v9 * (0.999999999999999)
    v14 = (2.0) * E_star
    v15 = v14 * a
    v18 = (8.0) * h
    v19 = v18 / (15.0)
    return (v11, v15, v19)


def block_depth_from_force_F(out, F, v11, v15, v19, m0):
    size = out.size
    np.less_equal(v11, F, m0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    some22 = np.count_nonzero(m0)
    if some22:
        np.divide(F, v15, out)
        np.subtract(out, v19, out)
    if some22 != size:
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
    some22 = np.count_nonzero(m0)
    if some22:
        np.multiply(C4, E_star, out)
        np.multiply(out, a, out)
        np.divide(F, out, out)
        np.multiply(C5, h, t0)
        np.divide(t0, C2, t0)
        np.subtract(out, t0, out)
    if some22 != size:
        np.copyto(out, C0, where=~m0)


def displacement(r, d, a, h):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            if 4.0 * h / 3.0 * 0.999999999999999 <= d:
                if r > a:
                    v4 = r - a
                    v14 = v4 / a
                    v21 = sqrt(log1p(v14) if isfinite(v14) else log(r) - log(a))
                    v27 = 8.4 / (sqrt(v21 * v21 + 8.4) + v21)
                    v35 = 2.0 * v21
                    v48 = []
                    for node, weight in RULE_0(v27 / 1.0):
                        v30 = node * v27
                        v31 = v21 + v30
                        v47 = exp(-5.0 * v30 * (v35 + v30)) * (2.0 * v31 / sqrt(-expm1(-2.0 * v31 * v31)))
                        v48.append(weight * v47)
                    v48 = fsum(v48) * v27
                    value = 0.6366197723675814 * (d * atan2(a, sqrt(v4 * (r + a))) + 8.0 * h / 3.0 * (a / r * v48))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h):
                        return value
                    return None
                if r <= a:
                    v57 = r * r
                    v60 = a * a
                    v64 = -h * (v57 * v57) / (v60 * v60)
                else:
                    v64 = nan
                value = d - v64
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
            if 4.0 * h / 3.0 * 0.999999999999999 <= d:
                return E_star * (d * d * a + 16.0 * h / 15.0 * d * a + 64.0 * (h * h) / 81.0 * a)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_d(a, h, E_star):
    v5 = (4.0) * h
    v7 = v5 / (3.0)
    v9 = v7 * (0.999999999999999)
    v15 = (16.0) * h
    v17 = v15 / (15.0)
    v21 = np.square(h)
    v23 = (64.0) * v21
    v25 = v23 / (81.0)
    v26 = v25 * a
    return (a, E_star, v9, v17, v26)


def block_energy_d(out, d, a, E_star, v9, v17, v26, t0, m0):
    size = out.size
    np.less_equal(v9, d, m0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.square(d, out)
        np.multiply(out, a, out)
        np.multiply(v17, d, t0)
        np.multiply(t0, a, t0)
        np.add(out, t0, t0)
        np.add(t0, v26, t0)
        np.multiply(E_star, t0, out)
    if some30 != size:
        np.copyto(out, C0, where=~m0)


def prepare_energy_all():
    return ()


def block_energy_all(out, d, a, h, E_star, t0, m0):
    size = out.size
    np.multiply(C6, h, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(t0, C7, t0)
    np.multiply(t0, C3, t0)
    np.less_equal(t0, d, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.square(d, out)
        np.multiply(out, a, out)
        np.multiply(C8, h, t0)
        np.divide(t0, C2, t0)
        np.multiply(t0, d, t0)
        np.multiply(t0, a, t0)
        np.add(out, t0, t0)
        np.square(h, out)
        np.multiply(C9, out, out)
        np.divide(out, C10, out)
        np.multiply(out, a, out)
        np.add(t0, out, out)
        np.multiply(E_star, out, out)
    if some30 != size:
        np.copyto(out, C0, where=~m0)


def force(d, a, h, E_star):
    if d.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 4.0 * h / 3.0 * 0.999999999999999 <= d:
                return 2.0 * E_star * a * (d + 8.0 * h / 15.0)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_d(a, h, E_star):
    v5 = (4.0) * h
    v7 = v5 / (3.0)
    v9 = v7 * (0.999999999999999)
    v12 = (2.0) * E_star
    v13 = v12 * a
    v15 = (8.0) * h
    v17 = v15 / (15.0)
    return (v9, v13, v17)


def block_force_d(out, d, v9, v13, v17, m0):
    size = out.size
    np.less_equal(v9, d, m0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some21 = np.count_nonzero(m0)
    if some21:
        np.add(d, v17, out)
        np.multiply(v13, out, out)
    if some21 != size:
        np.copyto(out, C0, where=~m0)


def prepare_force_all():
    return ()


def block_force_all(out, d, a, h, E_star, t0, m0):
    size = out.size
    np.multiply(C6, h, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(t0, C7, t0)
    np.multiply(t0, C3, t0)
    np.less_equal(t0, d, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.multiply(C4, E_star, out)
        np.multiply(out, a, out)
        np.multiply(C5, h, t0)
        np.divide(t0, C2, t0)
        np.add(d, t0, t0)
        np.multiply(out, t0, out)
    if some21 != size:
        np.copyto(out, C0, where=~m0)


def load_within(r, d, a, h, E_star):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v14 = 4.0 * h
            v42 = v14 / 3.0
            v48 = v42 * 0.999999999999999 <= d
            if v48:
                v40 = 2.0 * E_star
                if r < a:
                    v12 = r * r / (a + sqrt((a - r) * (a + r)))
                    v15 = a * a
                    v16 = v15 * v15
                    value = v40 * v12 * (d - v42 + v14 * (5.0 * v16 + v12 * (v12 * (120.0 * v15 + v12 * (16.0 * v12 - 80.0 * a)) - 40.0 * (a * v15))) / (45.0 * v16))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                if v48:
                    return v40 * a * (d + 8.0 * h / 15.0)
                return nan
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(d, a, h, E_star):
    v14 = (4.0) * h
    v15 = np.square(a)
    v16 = np.square(v15)
    v18 = (5.0) * v16
    v20 = (120.0) * v15
    v24 = (80.0) * a
    v30 = a * v15
    v32 = (40.0) * v30
    v38 = (45.0) * v16
    v40 = (2.0) * E_star
    v42 = v14 / (3.0)
    v43 = d - v42
    v47 = v42 * (0.999999999999999)
    v48 = np.less_equal(v47, d)
    v50 = v40 * a
    v52 = (8.0) * h
    v54 = v52 / (15.0)
    v55 = d + v54
    v56 = v50 * v55
    v58 = v56 if v48 else (np.nan)
    return (a, v14, v18, v20, v24, v32, v38, v40, v43, v48, v58)


def block_load_within_r(out, r, a, v14, v18, v20, v24, v32, v38, v40, v43, v48, v58, t0, m0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v48:
        np.less(r, a, m0)
        some59 = np.count_nonzero(m0)
        if some59:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.add(a, t0, t0)
            np.divide(out, t0, t0)
            np.multiply(C8, t0, out)
            np.subtract(out, v24, out)
            np.multiply(t0, out, out)
            np.add(v20, out, out)
            np.multiply(t0, out, out)
            np.subtract(out, v32, out)
            np.multiply(t0, out, out)
            np.add(v18, out, out)
            np.multiply(v14, out, out)
            np.divide(out, v38, out)
            np.multiply(v40, t0, t0)
            np.add(v43, out, out)
            np.multiply(t0, out, out)
        if some59 != size:
            np.copyto(out, v58, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_load_within_r_d(a, h, E_star):
    v14 = (4.0) * h
    v15 = np.square(a)
    v16 = np.square(v15)
    v18 = (5.0) * v16
    v20 = (120.0) * v15
    v24 = (80.0) * a
    v30 = a * v15
    v32 = (40.0) * v30
    v38 = (45.0) * v16
    v40 = (2.0) * E_star
    v42 = v14 / (3.0)
    v47 = v42 * (0.999999999999999)
    v50 = v40 * a
    v52 = (8.0) * h
    v54 = v52 / (15.0)
    return (a, v14, v18, v20, v24, v32, v38, v40, v42, v47, v50, v54)


def block_load_within_r_d(out, r, d, a, v14, v18, v20, v24, v32, v38, v40, v42, v47, v50, v54, t0, t1, m0, m1):
    size = out.size
    np.less_equal(v47, d, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some60 = np.count_nonzero(m0)
    if some60:
        np.less(r, a, m1)
        some59 = np.count_nonzero(m1)
        if some59:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.add(a, t0, t0)
            np.divide(out, t0, t0)
            np.multiply(C8, t0, out)
            np.subtract(out, v24, out)
            np.multiply(t0, out, out)
            np.add(v20, out, out)
            np.multiply(t0, out, out)
            np.subtract(out, v32, out)
            np.multiply(t0, out, out)
            np.add(v18, out, out)
            np.multiply(v14, out, out)
            np.divide(out, v38, out)
            np.multiply(v40, t0, t0)
            np.subtract(d, v42, t1)
            np.add(t1, out, out)
            np.multiply(t0, out, out)
        if some59 != size:
            other59 = t0 if some59 else out
            some58 = np.count_nonzero(m0)
            if some58:
                np.add(d, v54, other59)
                np.multiply(v50, other59, other59)
            if some58 != size:
                np.copyto(other59, C0, where=~m0)
            if some59:
                np.copyto(out, other59, where=~m1)
    if some60 != size:
        np.copyto(out, C0, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, d, a, h, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1):
    size = out.size
    np.multiply(C6, h, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(t0, C7, t1)
    np.multiply(t1, C3, t2)
    np.less_equal(t2, d, m0)
    some60 = np.count_nonzero(m0)
    if some60:
        np.multiply(C4, E_star, t2)
        np.less(r, a, m1)
        some59 = np.count_nonzero(m1)
        if some59:
            np.subtract(a, r, out)
            np.add(a, r, t3)
            np.multiply(out, t3, t3)
            np.sqrt(t3, t3)
            np.square(r, out)
            np.add(a, t3, t3)
            np.divide(out, t3, t3)
            np.square(a, out)
            np.square(out, t4)
            np.multiply(C11, t4, t5)
            np.multiply(C12, out, t6)
            np.multiply(C8, t3, t7)
            np.multiply(C13, a, t8)
            np.subtract(t7, t8, t8)
            np.multiply(t3, t8, t8)
            np.add(t6, t8, t8)
            np.multiply(t3, t8, t8)
            np.multiply(a, out, out)
            np.multiply(C14, out, out)
            np.subtract(t8, out, out)
            np.multiply(t3, out, out)
            np.add(t5, out, out)
            np.multiply(t0, out, out)
            np.multiply(C15, t4, t4)
            np.divide(out, t4, t4)
            np.multiply(t2, t3, t3)
            np.subtract(d, t1, out)
            np.add(out, t4, t4)
            np.multiply(t3, t4, out)
        if some59 != size:
            other59 = t4 if some59 else out
            some58 = np.count_nonzero(m0)
            if some58:
                np.multiply(t2, a, other59)
                np.multiply(C5, h, t3)
                np.divide(t3, C2, t3)
                np.add(d, t3, t3)
                np.multiply(other59, t3, other59)
            if some58 != size:
                np.copyto(other59, C0, where=~m0)
            if some59:
                np.copyto(out, other59, where=~m1)
    if some60 != size:
        np.copyto(out, C0, where=~m0)


def minimum_depth(h, a=1.0):
    if h.__class__ is a.__class__ is float and h > 1e-30 and (h < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            return 4.0 * h / 3.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_minimum_depth_all_signed():
    return ()


def block_minimum_depth_all_signed(out, h):
    np.multiply(C6, h, out)
    np.divide(out, C7, out)


def minimum_force(a, h, E_star):
    if a.__class__ is h.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 56.0 * E_star * h / 15.0 * a
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
            v10 = 4.0 * h
            v25 = v10 / 3.0
            if v25 * 0.999999999999999 <= d:
                if r <= a and d > 0.0:
                    v12 = 2.0 * r
                    v13 = v12 - a
                    v16 = a + v12
                    v19 = a * a
                    value = E_star / 3.141592653589793 * (d - v25 + v10 * (v13 * v13) * (v16 * v16) / (9.0 * (v19 * v19))) / sqrt((a - r) * (a + r))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, h, E_star):
    v10 = (4.0) * h
    v19 = np.square(a)
    v20 = np.square(v19)
    v22 = (9.0) * v20
    v25 = v10 / (3.0)
    v27 = v25 * (0.999999999999999)
    v28 = np.less_equal(v27, d)
    v31 = np.greater(d, (0.0))
    v34 = E_star / (3.141592653589793)
    v35 = d - v25
    return (a, v10, v22, v28, v31, v34, v35)


def block_pressure_r(out, r, a, v10, v22, v28, v31, v34, v35, t0, t1, m0):
    size = out.size
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if v28:
        np.less_equal(r, a, m0)
        np.bitwise_and(m0, v31, m0)
        some39 = np.count_nonzero(m0)
        if some39:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C4, r, out)
            np.subtract(out, a, t1)
            np.square(t1, t1)
            np.multiply(v10, t1, t1)
            np.add(a, out, out)
            np.square(out, out)
            np.multiply(t1, out, out)
            np.divide(out, v22, out)
            np.add(v35, out, out)
            np.multiply(v34, out, out)
            np.divide(out, t0, out)
        if some39 != size:
            np.copyto(out, C16, where=~m0)
    else:
        np.copyto(out, C0)


def prepare_pressure_r_d(a, h, E_star):
    v10 = (4.0) * h
    v19 = np.square(a)
    v20 = np.square(v19)
    v22 = (9.0) * v20
    v25 = v10 / (3.0)
    v27 = v25 * (0.999999999999999)
    v34 = E_star / (3.141592653589793)
    return (a, v10, v22, v25, v27, v34)


def block_pressure_r_d(out, r, d, a, v10, v22, v25, v27, v34, t0, t1, m0, m1, m2):
    size = out.size
    np.less_equal(v27, d, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some41 = np.count_nonzero(m0)
    if some41:
        np.less_equal(r, a, m1)
        np.greater(d, C16, m2)
        np.bitwise_and(m1, m2, m2)
        some39 = np.count_nonzero(m2)
        if some39:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(C4, r, out)
            np.subtract(out, a, t1)
            np.square(t1, t1)
            np.multiply(v10, t1, t1)
            np.add(a, out, out)
            np.square(out, out)
            np.multiply(t1, out, out)
            np.divide(out, v22, out)
            np.subtract(d, v25, t1)
            np.add(t1, out, out)
            np.multiply(v34, out, out)
            np.divide(out, t0, out)
        if some39 != size:
            np.copyto(out, C16, where=~m2)
    if some41 != size:
        np.copyto(out, C0, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, h, E_star, t0, t1, t2, t3, t4, m0, m1, m2):
    size = out.size
    np.multiply(C6, h, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(t0, C7, t1)
    np.multiply(t1, C3, t2)
    np.less_equal(t2, d, m0)
    some41 = np.count_nonzero(m0)
    if some41:
        np.less_equal(r, a, m1)
        np.greater(d, C16, m2)
        np.bitwise_and(m1, m2, m2)
        some39 = np.count_nonzero(m2)
        if some39:
            np.subtract(a, r, out)
            np.add(a, r, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.multiply(C4, r, out)
            np.subtract(out, a, t3)
            np.square(t3, t3)
            np.multiply(t0, t3, t3)
            np.add(a, out, out)
            np.square(out, out)
            np.multiply(t3, out, out)
            np.square(a, t3)
            np.square(t3, t3)
            np.multiply(C17, t3, t3)
            np.divide(out, t3, t3)
            np.divide(E_star, C18, out)
            np.subtract(d, t1, t4)
            np.add(t4, t3, t3)
            np.multiply(out, t3, t3)
            np.divide(t3, t2, out)
        if some39 != size:
            np.copyto(out, C16, where=~m2)
    if some41 != size:
        np.copyto(out, C0, where=~m0)


def profile(r, a, h):
    if r.__class__ is a.__class__ is h.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            if r <= a:
                v7 = r * r
                v10 = a * a
                return -h * (v7 * v7) / (v10 * v10)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(a, h):
    v4 = np.negative(h)
    v9 = np.square(a)
    v10 = np.square(v9)
    return (a, v4, v10)


def block_profile_r(out, r, a, v4, v10, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some13 = np.count_nonzero(m0)
    if some13:
        np.square(r, out)
        np.square(out, out)
        np.multiply(v4, out, out)
        np.divide(out, v10, out)
    if some13 != size:
        np.copyto(out, C0, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, a, h, t0, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some13 = np.count_nonzero(m0)
    if some13:
        np.negative(h, out)
        np.square(r, t0)
        np.square(t0, t0)
        np.multiply(out, t0, t0)
        np.square(a, out)
        np.square(out, out)
        np.divide(t0, out, out)
    if some13 != size:
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


def zero_radius(a, h=1.0):
    if a.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            return a / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_zero_radius_all_signed():
    return ()


def block_zero_radius_all_signed(out, a):
    np.multiply(a, C19, out)


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
        ('d', 'a', 'h', 'E_star'): (('d', 'a', 'h', 'E_star'), prepare_force_all, block_force_all, 1, 1, (), False),
    },
    ('_load_within', 2, 'r', 'd', 'a', 'h', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 1, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_load_within_r_d, block_load_within_r_d, 2, 2, (), False),
        ('r', 'd', 'a', 'h', 'E_star'): (('r', 'd', 'a', 'h', 'E_star'), prepare_load_within_all, block_load_within_all, 9, 2, (), False),
    },
    ('_minimum_depth', 0, 'h'): {
        ('h',): (('h',), prepare_minimum_depth_all_signed, block_minimum_depth_all_signed, 0, 0, (), False),
    },
    ('_minimum_force', 0, 'a', 'h', 'E_star'): {
        ('a', 'h', 'E_star'): (('a', 'h', 'E_star'), prepare_minimum_force_all_signed, block_minimum_force_all_signed, 0, 0, (), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'h', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 2, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 2, 3, (), False),
        ('r', 'd', 'a', 'h', 'E_star'): (('r', 'd', 'a', 'h', 'E_star'), prepare_pressure_all, block_pressure_all, 5, 3, (), False),
    },
    ('_profile', 1, 'r', 'a', 'h'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 1, (), False),
        ('r', 'a', 'h'): (('r', 'a', 'h'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_stiffness', 0, 'a', 'E_star'): {
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all_signed, block_stiffness_all_signed, 0, 0, (), False),
    },
    ('_zero_radius', 0, 'a'): {
        ('a',): (('a',), prepare_zero_radius_all_signed, block_zero_radius_all_signed, 0, 0, (), False),
    },
}
