"""Programs of axicontact.normal.sphere."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import sphere as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
C2 = np.array(1.0)
C3 = np.array(1.0716932453474512e-06)
C4 = np.array(0.00019982814521087247)
C5 = np.array(0.007076196047699156)
C6 = np.array(0.08608622548411103)
C7 = np.array(0.3073858328214721)
C8 = np.array(0.3333333333333333)
C9 = np.array(2.565078604208634e-08)
C10 = np.array(2.0203143566039827e-05)
C11 = np.array(0.001617010334189783)
C12 = np.array(0.03639274880225476)
C13 = np.array(0.32215749846441627)
C14 = np.array(0.0)
C15 = np.array(3.141592653589793)
C16 = np.array(0.7)
C17 = np.array(0.13579013365982337)
C18 = np.array(-0.4846453962188766)
C19 = np.array(0.8293825948837366)
C20 = np.array(-0.8745573865774817)
C21 = np.array(0.6371928816963097)
C22 = np.array(-0.3332798652335896)
C23 = np.array(0.13289328569967984)
C24 = np.array(-0.03710676078458442)
C25 = np.array(0.011089560042611895)
C26 = np.array(0.0012521687336059639)
C27 = np.array(0.0036572276005780893)
C28 = np.array(0.004425450516633092)
C29 = np.array(0.005918487051520244)
C30 = np.array(0.008264397984935742)
C31 = np.array(0.012345681107818056)
C32 = np.array(0.020408163224119494)
C33 = np.array(0.04000000000042643)
C34 = np.array(0.11111111111110937)
C35 = np.array(np.nan)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R):
    if a.__class__ is R.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return a * (log1p(2.0 * a / (R - a)) / 2.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R):
    return (R,)


def block_depth_a(out, a, R, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(a, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(a, t0, out)


def depth_from_force(F, R, E_star):
    if F.__class__ is R.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R):
    if r.__class__ is a.__class__ is R.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            if a <= R:
                v39 = r + R
                v47 = R - r
                if r > a:
                    v3 = r if r < R or r != r else R
                    if a < v3:
                        v4 = v3 - a
                        v10 = a / sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (v3 + a))
                        v11 = asinh(v10)
                        v16 = 0.0 - expm1(-2.0 * v11)
                        v19 = v16 if v16 > 0.0 else inf
                        v37 = r - R
                        v41 = sqrt((v37 if v37 > 0.0 or v37 != v37 else 0.0) * v39)
                        v43 = v41 * v41
                        v51 = sqrt((v47 if v47 > 0.0 or v47 != v47 else 0.0) * (R + r))
                        v52 = v51 * v51
                        v65 = []
                        for node, weight in RULE_0(v11 / 1.0):
                            v21 = node * v11
                            v30 = v10 * (exp(-v21) * (0.0 - expm1(-2.0 * (v11 - v21))) / v19)
                            v33 = sqrt(1.0 + v30 * v30)
                            v35 = v3 * (v30 / v33)
                            v36 = v3 / v33
                            v44 = v36 * v36
                            v54 = sqrt(v52 + v44)
                            v64 = (asinh(v35 / v54) + R * v35 / (v54 * v54)) * atan2(v35, sqrt(v43 + v44)) * (v36 / v33)
                            v65.append(weight * v64)
                        v65 = fsum(v65) * v11
                        v66 = v65
                    else:
                        v66 = inf
                    value = 0.6366197723675814 * v66
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R):
                        return value
                    return None
                return a * (log1p(2.0 * a / (R - a)) / 2.0) - r * r / (sqrt(v47 * v39) + R)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= R:
                if a < R:
                    v5 = R - a
                    v9 = a * (log1p(2.0 * a / v5) / 2.0)
                    v15 = a / sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (R + a))
                    v16 = asinh(v15)
                    v21 = 0.0 - expm1(-2.0 * v16)
                    v24 = v21 if v21 > 0.0 else inf
                    v49 = []
                    for node, weight in RULE_0(v16 / 1.0):
                        v26 = node * v16
                        v35 = v15 * (exp(-v26) * (0.0 - expm1(-2.0 * (v16 - v26))) / v24)
                        v38 = sqrt(1.0 + v35 * v35)
                        v40 = R * (v35 / v38)
                        v45 = v9 - v40 * asinh(v40 / (R / v38))
                        v48 = v45 * v45 / (v38 * v38)
                        v49.append(weight * v48)
                    v49 = fsum(v49) * v16
                    v51 = R * v49
                else:
                    v51 = inf
                value = E_star * v51
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, R, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = log1p(2.0 * a / (R - a)) / 2.0
            v12 = a / R
            if v8 < 1.0:
                v18 = v8 * v8
                v53 = v12 * (v12 * v12) * ((((((1.0716932453474512e-06 * v18 + 0.00019982814521087247) * v18 + 0.007076196047699156) * v18 + 0.08608622548411103) * v18 + 0.3073858328214721) * v18 + 0.3333333333333333) / (((((2.565078604208634e-08 * v18 + 2.0203143566039827e-05) * v18 + 0.001617010334189783) * v18 + 0.03639274880225476) * v18 + 0.32215749846441627) * v18 + 1.0))
            else:
                v53 = v8 - v12
            value = E_star * (a * a * v8 + R * R * v53)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, E_star):
    v12 = np.square(R)
    return (R, E_star, v12)


def block_force_a(out, a, R, E_star, v12, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.square(a, out)
    np.multiply(out, t0, out)
    np.divide(a, R, t1)
    np.less(t0, C2, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(t0, f0, out=t2)
        np.multiply(t1, t1, t3)
        np.multiply(t1, t3, t3)
        np.multiply(t2, t2, t2)
        np.multiply(C3, t2, t4)
        np.add(t4, C4, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C5, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C6, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C7, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C8, t4)
        np.multiply(C9, t2, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C13, t5)
        np.multiply(t5, t2, t2)
        np.add(t2, C2, t2)
        np.divide(t4, t2, t2)
        np.multiply(t3, t2, t2)
    if some54 != size:
        other54 = t3 if some54 else t2
        np.subtract(t0, t1, other54)
        if some54:
            np.copyto(t2, other54, where=~m0)
    np.multiply(v12, t2, t2)
    np.add(out, t2, t2)
    np.multiply(E_star, t2, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.square(a, out)
    np.multiply(out, t0, out)
    np.square(R, t1)
    np.divide(a, R, t2)
    np.less(t0, C2, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(t0, f0, out=t3)
        np.multiply(t2, t2, t4)
        np.multiply(t2, t4, t4)
        np.multiply(t3, t3, t3)
        np.multiply(C3, t3, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C8, t5)
        np.multiply(C9, t3, t6)
        np.add(t6, C10, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t3, t3)
        np.add(t3, C2, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
    if some54 != size:
        other54 = t4 if some54 else t3
        np.subtract(t0, t2, other54)
        if some54:
            np.copyto(t3, other54, where=~m0)
    np.multiply(t1, t3, t3)
    np.add(out, t3, t3)
    np.multiply(E_star, t3, out)


def force_from_depth(d, R, E_star):
    if d.__class__ is R.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, R, E_star):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= R:
                v4 = r if r < a or r != r else a
                v5 = R - v4
                v11 = v4 / R
                v34 = v4 > 0.0
                v71 = v11 * v11
                if v34 and a < R:
                    v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (R + v4))
                    v12 = a - v4
                    v17 = R - a
                    v22 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (a + v4)) / sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (R + a))
                    v24 = asinh(v22 / v11)
                    v29 = 0.0 - expm1(-2.0 * v24)
                    v32 = v29 if v29 > 0.0 else inf
                    v33 = v4 * v4
                    v75 = []
                    for node, weight in RULE_0(v24 / 1.0):
                        v38 = node * v24
                        v47 = v22 * (exp(-v38) * (0.0 - expm1(-2.0 * (v24 - v38))) / v32)
                        v48 = v47 * v47
                        v50 = sqrt(1.0 + v48)
                        v52 = v10 * (v47 / v50)
                        v53 = v10 / v50
                        v56 = sqrt(v33 + v52 * v52)
                        v74 = (asinh(v56 / v53) + R * v56 / (v53 * v53)) * (v52 / (v56 + v52)) * (v53 / (v50 * v50 * v56)) * sqrt(v71 + v48)
                        v75.append(weight * v74)
                    v75 = fsum(v75) * v24
                    v77 = v33 * v75
                else:
                    v77 = inf if v34 else 0.0
                v82 = log1p(2.0 * v4 / v5) / 2.0
                if v82 < 1.0:
                    v89 = v82 * v82
                    v124 = v11 * v71 * ((((((1.0716932453474512e-06 * v89 + 0.00019982814521087247) * v89 + 0.007076196047699156) * v89 + 0.08608622548411103) * v89 + 0.3073858328214721) * v89 + 0.3333333333333333) / (((((2.565078604208634e-08 * v89 + 2.0203143566039827e-05) * v89 + 0.001617010334189783) * v89 + 0.03639274880225476) * v89 + 0.32215749846441627) * v89 + 1.0))
                else:
                    v124 = v82 - v11
                value = E_star * (v4 * v4 * v82 + R * R * v124) + 2.0 * E_star * v77
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a > 0.0:
                v10 = log1p(2.0 * a / (R - a)) / 2.0
                v11 = a * a
                v14 = a / R
                if v10 < 1.0:
                    v20 = v10 * v10
                    v55 = v14 * (v14 * v14) * ((((((1.0716932453474512e-06 * v20 + 0.00019982814521087247) * v20 + 0.007076196047699156) * v20 + 0.08608622548411103) * v20 + 0.3073858328214721) * v20 + 0.3333333333333333) / (((((2.565078604208634e-08 * v20 + 2.0203143566039827e-05) * v20 + 0.001617010334189783) * v20 + 0.03639274880225476) * v20 + 0.32215749846441627) * v20 + 1.0))
                else:
                    v55 = v10 - v14
                value = E_star * (v11 * v10 + R * R * v55) / (3.141592653589793 * v11)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R, E_star):
    v14 = np.square(R)
    return (R, E_star, v14)


def block_mean_pressure_a(out, a, R, E_star, v14, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.greater(a, C14, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some63 = np.count_nonzero(m0)
    if some63:
        np.multiply(C0, a, out)
        np.subtract(R, a, t0)
        np.divide(out, t0, t0)
        np.log1p(t0, t0)
        np.multiply(t0, C1, t0)
        np.square(a, out)
        np.multiply(out, t0, t1)
        np.divide(a, R, t2)
        np.less(t0, C2, m1)
        some56 = np.count_nonzero(m1)
        if some56:
            np.minimum(t0, f0, out=t3)
            np.multiply(t2, t2, t4)
            np.multiply(t2, t4, t4)
            np.multiply(t3, t3, t3)
            np.multiply(C3, t3, t5)
            np.add(t5, C4, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C5, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C6, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C7, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C8, t5)
            np.multiply(C9, t3, t6)
            np.add(t6, C10, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C11, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C12, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C13, t6)
            np.multiply(t6, t3, t3)
            np.add(t3, C2, t3)
            np.divide(t5, t3, t3)
            np.multiply(t4, t3, t3)
        if some56 != size:
            other56 = t4 if some56 else t3
            np.subtract(t0, t2, other56)
            if some56:
                np.copyto(t3, other56, where=~m1)
        np.multiply(v14, t3, t3)
        np.add(t1, t3, t3)
        np.multiply(E_star, t3, t3)
        np.multiply(C15, out, out)
        np.divide(t3, out, out)
    if some63 != size:
        np.copyto(out, C14, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.greater(a, C14, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some63 = np.count_nonzero(m0)
    if some63:
        np.multiply(C0, a, out)
        np.subtract(R, a, t0)
        np.divide(out, t0, t0)
        np.log1p(t0, t0)
        np.multiply(t0, C1, t0)
        np.square(a, out)
        np.multiply(out, t0, t1)
        np.square(R, t2)
        np.divide(a, R, t3)
        np.less(t0, C2, m1)
        some56 = np.count_nonzero(m1)
        if some56:
            np.minimum(t0, f0, out=t4)
            np.multiply(t3, t3, t5)
            np.multiply(t3, t5, t5)
            np.multiply(t4, t4, t4)
            np.multiply(C3, t4, t6)
            np.add(t6, C4, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C5, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C6, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C7, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C8, t6)
            np.multiply(C9, t4, t7)
            np.add(t7, C10, t7)
            np.multiply(t7, t4, t7)
            np.add(t7, C11, t7)
            np.multiply(t7, t4, t7)
            np.add(t7, C12, t7)
            np.multiply(t7, t4, t7)
            np.add(t7, C13, t7)
            np.multiply(t7, t4, t4)
            np.add(t4, C2, t4)
            np.divide(t6, t4, t4)
            np.multiply(t5, t4, t4)
        if some56 != size:
            other56 = t5 if some56 else t4
            np.subtract(t0, t3, other56)
            if some56:
                np.copyto(t4, other56, where=~m1)
        np.multiply(t2, t4, t4)
        np.add(t1, t4, t4)
        np.multiply(E_star, t4, t4)
        np.multiply(C15, out, out)
        np.divide(t4, out, out)
    if some63 != size:
        np.copyto(out, C14, where=~m0)


def pressure(r, a, R, E_star):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v4 = R - r
            v12 = a - r
            v13 = a + r
            v25 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * v13)
            v30 = R + sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (R + r))
            v31 = a + v25
            v32 = v31 / v30
            if v32 > 0.7:
                return None
            if a <= R:
                if r < a:
                    v35 = r * (r / v31) / v30
                    v36 = v32 * v32
                    v37 = v35 * v35
                    v43 = 0.13579013365982337 * v36 + -0.4846453962188766
                    v48 = v43 * v36 + 0.8293825948837366
                    v53 = v48 * v36 + -0.8745573865774817
                    v58 = v53 * v36 + 0.6371928816963097
                    v63 = v58 * v36 + -0.3332798652335896
                    v68 = v63 * v36 + 0.13289328569967984
                    v73 = v68 * v36 + -0.03710676078458442
                    v78 = v73 * v36 + 0.011089560042611895
                    v83 = v78 * v36 + 0.0012521687336059639
                    v88 = v83 * v36 + 0.0036572276005780893
                    v93 = v88 * v36 + 0.004425450516633092
                    v98 = v93 * v36 + 0.005918487051520244
                    v99 = ((((((((((((0.0 * v37 + 0.13579013365982337) * v37 + v43) * v37 + v48) * v37 + v53) * v37 + v58) * v37 + v63) * v37 + v68) * v37 + v73) * v37 + v78) * v37 + v83) * v37 + v88) * v37 + v93) * v37
                    v103 = v98 * v36 + 0.008264397984935742
                    v108 = v103 * v36 + 0.012345681107818056
                    v113 = v108 * v36 + 0.020408163224119494
                    v118 = v113 * v36 + 0.04000000000042643
                    v123 = v118 * v36 + 0.11111111111110937
                    value = E_star / 3.141592653589793 * (R * asinh(sqrt(v12 * v13) / sqrt((R - a) * (a + R))) / sqrt(v4 * (r + R)) + 2.0 * v25 / v30 * (v123 * v36 + 1.0 + v35 * (v35 + v32) * ((((((v99 + v98) * v37 + v103) * v37 + v108) * v37 + v113) * v37 + v118) * v37 + v123)))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, R, E_star):
    v8 = R - a
    v9 = a + R
    v10 = v8 * v9
    v11 = np.sqrt(v10)
    v17 = E_star / (3.141592653589793)
    v143 = np.less_equal(a, R)
    return (a, R, v11, v17, v143)


def block_pressure_r(out, r, a, R, v11, v17, v143, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.subtract(R, r, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t1)
    np.add(a, r, t2)
    np.maximum(t1, f0, out=t3)
    np.multiply(t3, t2, t3)
    np.sqrt(t3, t3)
    np.maximum(t0, f0, out=t4)
    np.add(R, r, t5)
    np.multiply(t4, t5, t5)
    np.sqrt(t5, t5)
    np.add(R, t5, t5)
    np.add(a, t3, t4)
    np.divide(t4, t5, t6)
    np.greater(t6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v143:
        np.less(r, a, m1)
        some142 = np.count_nonzero(m1)
        if some142:
            np.add(r, R, out)
            np.multiply(t0, out, out)
            np.sqrt(out, out)
            np.multiply(t1, t2, t7)
            np.sqrt(t7, t7)
            np.divide(t7, v11, t7)
            np.arcsinh(t7, t7)
            np.multiply(R, t7, t7)
            np.divide(t7, out, out)
            np.divide(r, t4, t7)
            np.multiply(r, t7, t7)
            np.divide(t7, t5, t7)
            np.multiply(t6, t6, t8)
            np.multiply(t7, t7, t9)
            np.multiply(C14, t9, t10)
            np.add(t10, C17, t10)
            np.multiply(C17, t8, t11)
            np.add(t11, C18, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C19, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C20, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C21, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C22, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C23, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C24, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C25, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C26, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C27, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C28, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C29, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C30, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C31, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C32, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C33, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C34, t11)
            np.multiply(t10, t9, t9)
            np.add(t9, t11, t9)
            np.multiply(t11, t8, t8)
            np.add(t8, C2, t8)
            np.multiply(C0, t3, t11)
            np.divide(t11, t5, t11)
            np.add(t7, t6, t10)
            np.multiply(t7, t10, t10)
            np.multiply(t10, t9, t9)
            np.add(t8, t9, t9)
            np.multiply(t11, t9, t9)
            np.add(out, t9, t9)
            np.multiply(v17, t9, out)
        if some142 != size:
            np.copyto(out, C14, where=~m1)
    else:
        np.copyto(out, C35)


def prepare_pressure_r_a(R, E_star):
    v17 = E_star / (3.141592653589793)
    return (R, v17)


def block_pressure_r_a(out, r, a, R, v17, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t1)
    np.add(a, r, t2)
    np.maximum(t1, f0, out=t3)
    np.multiply(t3, t2, t3)
    np.sqrt(t3, t3)
    np.maximum(t0, f0, out=t4)
    np.add(R, r, t5)
    np.multiply(t4, t5, t5)
    np.sqrt(t5, t5)
    np.add(R, t5, t5)
    np.add(a, t3, t4)
    np.divide(t4, t5, t6)
    np.greater(t6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some145 = np.count_nonzero(m1)
    if some145:
        np.less(r, a, m2)
        some142 = np.count_nonzero(m2)
        if some142:
            np.add(r, R, out)
            np.multiply(t0, out, out)
            np.sqrt(out, out)
            np.subtract(R, a, t7)
            np.add(a, R, t8)
            np.multiply(t7, t8, t8)
            np.sqrt(t8, t8)
            np.multiply(t1, t2, t7)
            np.sqrt(t7, t7)
            np.divide(t7, t8, t8)
            np.arcsinh(t8, t8)
            np.multiply(R, t8, t8)
            np.divide(t8, out, out)
            np.divide(r, t4, t8)
            np.multiply(r, t8, t8)
            np.divide(t8, t5, t8)
            np.multiply(t6, t6, t7)
            np.multiply(t8, t8, t9)
            np.multiply(C14, t9, t10)
            np.add(t10, C17, t10)
            np.multiply(C17, t7, t11)
            np.add(t11, C18, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C19, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C20, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C21, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C22, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C23, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C24, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C25, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C26, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C27, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C28, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C29, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C30, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C31, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C32, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C33, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C34, t11)
            np.multiply(t10, t9, t9)
            np.add(t9, t11, t9)
            np.multiply(t11, t7, t7)
            np.add(t7, C2, t7)
            np.multiply(C0, t3, t11)
            np.divide(t11, t5, t11)
            np.add(t8, t6, t10)
            np.multiply(t8, t10, t10)
            np.multiply(t10, t9, t9)
            np.add(t7, t9, t9)
            np.multiply(t11, t9, t9)
            np.add(out, t9, t9)
            np.multiply(v17, t9, out)
        if some142 != size:
            np.copyto(out, C14, where=~m2)
    if some145 != size:
        np.copyto(out, C35, where=~m1)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t1)
    np.add(a, r, t2)
    np.maximum(t1, f0, out=t3)
    np.multiply(t3, t2, t3)
    np.sqrt(t3, t3)
    np.maximum(t0, f0, out=t4)
    np.add(R, r, t5)
    np.multiply(t4, t5, t5)
    np.sqrt(t5, t5)
    np.add(R, t5, t5)
    np.add(a, t3, t4)
    np.divide(t4, t5, t6)
    np.greater(t6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some145 = np.count_nonzero(m1)
    if some145:
        np.less(r, a, m2)
        some142 = np.count_nonzero(m2)
        if some142:
            np.add(r, R, out)
            np.multiply(t0, out, out)
            np.sqrt(out, out)
            np.subtract(R, a, t7)
            np.add(a, R, t8)
            np.multiply(t7, t8, t8)
            np.sqrt(t8, t8)
            np.multiply(t1, t2, t7)
            np.sqrt(t7, t7)
            np.divide(E_star, C15, t9)
            np.divide(t7, t8, t8)
            np.arcsinh(t8, t8)
            np.multiply(R, t8, t8)
            np.divide(t8, out, out)
            np.divide(r, t4, t8)
            np.multiply(r, t8, t8)
            np.divide(t8, t5, t8)
            np.multiply(t6, t6, t7)
            np.multiply(t8, t8, t10)
            np.multiply(C14, t10, t11)
            np.add(t11, C17, t11)
            np.multiply(C17, t7, t12)
            np.add(t12, C18, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C19, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C20, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C21, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C22, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C23, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C24, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C25, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C26, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C27, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C28, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C29, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C30, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C31, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C32, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C33, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C34, t12)
            np.multiply(t11, t10, t10)
            np.add(t10, t12, t10)
            np.multiply(t12, t7, t7)
            np.add(t7, C2, t7)
            np.multiply(C0, t3, t12)
            np.divide(t12, t5, t12)
            np.add(t8, t6, t11)
            np.multiply(t8, t11, t11)
            np.multiply(t11, t10, t10)
            np.add(t7, t10, t10)
            np.multiply(t12, t10, t10)
            np.add(out, t10, t10)
            np.multiply(t9, t10, out)
        if some142 != size:
            np.copyto(out, C14, where=~m2)
    if some145 != size:
        np.copyto(out, C35, where=~m1)


def profile(r, R):
    if r.__class__ is R.__class__ is float and r > 1e-30 and (r < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return r * r / (sqrt((R - r) * (r + R)) + R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R):
    return (R,)


def block_profile_r(out, r, R, t0):
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, R, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.square(r, out)
    np.add(t0, R, t0)
    np.divide(out, t0, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, t0):
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, R, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.square(r, out)
    np.add(t0, R, t0)
    np.divide(out, t0, out)


def radius_from_depth(d, R):
    if d.__class__ is R.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, E_star):
    if F.__class__ is R.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, R=1.0):
    if a.__class__ is E_star.__class__ is R.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return 2.0 * E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_a(E_star):
    v3 = (2.0) * E_star
    return (v3,)


def block_stiffness_a(out, a, v3):
    np.multiply(v3, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, a, E_star):
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'R'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'R'): (('a', 'R'), prepare_depth_all, block_depth_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 6, 1, (1.0,), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_force_all, block_force_all, 7, 1, (1.0,), False),
    },
    ('_mean_pressure', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 7, 2, (1.0,), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 8, 2, (1.0,), False),
    },
    ('_pressure', 2, 'r', 'a', 'R', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 12, 2, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 12, 3, (0.0,), False),
        ('r', 'a', 'R', 'E_star'): (('r', 'a', 'R', 'E_star'), prepare_pressure_all, block_pressure_all, 13, 3, (0.0,), False),
    },
    ('_profile', 1, 'r', 'R'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 0, (), False),
        ('r', 'R'): (('r', 'R'), prepare_profile_all, block_profile_all, 1, 0, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
