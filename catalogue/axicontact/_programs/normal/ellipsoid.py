"""Programs of axicontact.normal.ellipsoid."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import ellipsoid as bodies

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


def depth(a, h, b):
    if a.__class__ is h.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            return h / b * a * (log1p(2.0 * a / (b - a)) / 2.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(h, b):
    v10 = h / b
    return (b, v10)


def block_depth_a(out, a, b, v10, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(v10, a, out)
    np.multiply(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, h, b, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.divide(h, b, out)
    np.multiply(out, a, out)
    np.multiply(out, t0, out)


def depth_from_force(F, h, b, E_star):
    if F.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, h, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, h, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, h, b):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            if a <= b:
                v58 = h / b
                if r > a:
                    v4 = r if r < b or r != r else b
                    if a < v4:
                        v5 = v4 - a
                        v11 = a / sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (v4 + a))
                        v12 = asinh(v11)
                        v17 = 0.0 - expm1(-2.0 * v12)
                        v20 = v17 if v17 > 0.0 else inf
                        v38 = r - b
                        v42 = sqrt((v38 if v38 > 0.0 or v38 != v38 else 0.0) * (r + b))
                        v44 = v42 * v42
                        v48 = b - r
                        v52 = sqrt((v48 if v48 > 0.0 or v48 != v48 else 0.0) * (b + r))
                        v53 = v52 * v52
                        v68 = []
                        for node, weight in RULE_0(v12 / 1.0):
                            v22 = node * v12
                            v31 = v11 * (exp(-v22) * (0.0 - expm1(-2.0 * (v12 - v22))) / v20)
                            v34 = sqrt(1.0 + v31 * v31)
                            v36 = v4 * (v31 / v34)
                            v37 = v4 / v34
                            v45 = v37 * v37
                            v55 = sqrt(v53 + v45)
                            v67 = (v58 * asinh(v36 / v55) + h * v36 / (v55 * v55)) * atan2(v36, sqrt(v44 + v45)) * (v37 / v34)
                            v68.append(weight * v67)
                        v68 = fsum(v68) * v12
                        v69 = v68
                    else:
                        v69 = inf
                    value = 0.6366197723675814 * v69
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, b):
                        return value
                    return None
                v79 = r / b
                return v58 * a * (log1p(2.0 * a / (b - a)) / 2.0) - h * (r * r) / (b * b * (sqrt((1.0 - v79) * (v79 + 1.0)) + 1.0))
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, h, b, E_star):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= b:
                if a < b:
                    v6 = b - a
                    v10 = h / b
                    v12 = v10 * a * (log1p(2.0 * a / v6) / 2.0)
                    v18 = a / sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (b + a))
                    v19 = asinh(v18)
                    v24 = 0.0 - expm1(-2.0 * v19)
                    v27 = v24 if v24 > 0.0 else inf
                    v53 = []
                    for node, weight in RULE_0(v19 / 1.0):
                        v29 = node * v19
                        v38 = v18 * (exp(-v29) * (0.0 - expm1(-2.0 * (v19 - v29))) / v27)
                        v41 = sqrt(1.0 + v38 * v38)
                        v43 = b * (v38 / v41)
                        v49 = v12 - v10 * v43 * asinh(v43 / (b / v41))
                        v52 = v49 * v49 / (v41 * v41)
                        v53.append(weight * v52)
                    v53 = fsum(v53) * v19
                    v55 = b * v53
                else:
                    v55 = inf
                value = E_star * v55
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, h, b, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, h, b, E_star):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v9 = log1p(2.0 * a / (b - a)) / 2.0
            v14 = a / b
            if v9 < 1.0:
                v20 = v9 * v9
                v55 = v14 * (v14 * v14) * ((((((1.0716932453474512e-06 * v20 + 0.00019982814521087247) * v20 + 0.007076196047699156) * v20 + 0.08608622548411103) * v20 + 0.3073858328214721) * v20 + 0.3333333333333333) / (((((2.565078604208634e-08 * v20 + 2.0203143566039827e-05) * v20 + 0.001617010334189783) * v20 + 0.03639274880225476) * v20 + 0.32215749846441627) * v20 + 1.0))
            else:
                v55 = v9 - v14
            value = E_star * h * (a * a * v9 / b + b * v55)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(h, b, E_star):
    v11 = E_star * h
    return (b, v11)


def block_force_a(out, a, b, v11, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.square(a, out)
    np.multiply(out, t0, out)
    np.divide(out, b, out)
    np.divide(a, b, t1)
    np.less(t0, C2, m0)
    some56 = np.count_nonzero(m0)
    if some56:
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
    if some56 != size:
        other56 = t3 if some56 else t2
        np.subtract(t0, t1, other56)
        if some56:
            np.copyto(t2, other56, where=~m0)
    np.multiply(b, t2, t2)
    np.add(out, t2, t2)
    np.multiply(v11, t2, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, h, b, E_star, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(E_star, h, out)
    np.square(a, t1)
    np.multiply(t1, t0, t1)
    np.divide(t1, b, t1)
    np.divide(a, b, t2)
    np.less(t0, C2, m0)
    some56 = np.count_nonzero(m0)
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
            np.copyto(t3, other56, where=~m0)
    np.multiply(b, t3, t3)
    np.add(t1, t3, t3)
    np.multiply(out, t3, out)


def force_from_depth(d, h, b, E_star):
    if d.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, h, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, h, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, h, b, E_star):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= b:
                v5 = r if r < a or r != r else a
                v6 = b - v5
                v12 = v5 / b
                v35 = v5 > 0.0
                v74 = v12 * v12
                if v35 and a < b:
                    v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (b + v5))
                    v13 = a - v5
                    v18 = b - a
                    v23 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (a + v5)) / sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (b + a))
                    v25 = asinh(v23 / v12)
                    v30 = 0.0 - expm1(-2.0 * v25)
                    v33 = v30 if v30 > 0.0 else inf
                    v34 = v5 * v5
                    v60 = h / b
                    v78 = []
                    for node, weight in RULE_0(v25 / 1.0):
                        v39 = node * v25
                        v48 = v23 * (exp(-v39) * (0.0 - expm1(-2.0 * (v25 - v39))) / v33)
                        v49 = v48 * v48
                        v51 = sqrt(1.0 + v49)
                        v53 = v11 * (v48 / v51)
                        v54 = v11 / v51
                        v57 = sqrt(v34 + v53 * v53)
                        v77 = (v60 * asinh(v57 / v54) + h * v57 / (v54 * v54)) * (v53 / (v57 + v53)) * (v54 / (v51 * v51 * v57)) * sqrt(v74 + v49)
                        v78.append(weight * v77)
                    v78 = fsum(v78) * v25
                    v80 = v34 * v78
                else:
                    v80 = inf if v35 else 0.0
                v85 = log1p(2.0 * v5 / v6) / 2.0
                if v85 < 1.0:
                    v93 = v85 * v85
                    v128 = v12 * v74 * ((((((1.0716932453474512e-06 * v93 + 0.00019982814521087247) * v93 + 0.007076196047699156) * v93 + 0.08608622548411103) * v93 + 0.3073858328214721) * v93 + 0.3333333333333333) / (((((2.565078604208634e-08 * v93 + 2.0203143566039827e-05) * v93 + 0.001617010334189783) * v93 + 0.03639274880225476) * v93 + 0.32215749846441627) * v93 + 1.0))
                else:
                    v128 = v85 - v12
                value = E_star * h * (v5 * v5 * v85 / b + b * v128) + 2.0 * E_star * v80
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, b, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, h, b, E_star):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a > 0.0:
                v11 = log1p(2.0 * a / (b - a)) / 2.0
                v13 = a * a
                v16 = a / b
                if v11 < 1.0:
                    v22 = v11 * v11
                    v57 = v16 * (v16 * v16) * ((((((1.0716932453474512e-06 * v22 + 0.00019982814521087247) * v22 + 0.007076196047699156) * v22 + 0.08608622548411103) * v22 + 0.3073858328214721) * v22 + 0.3333333333333333) / (((((2.565078604208634e-08 * v22 + 2.0203143566039827e-05) * v22 + 0.001617010334189783) * v22 + 0.03639274880225476) * v22 + 0.32215749846441627) * v22 + 1.0))
                else:
                    v57 = v11 - v16
                value = E_star * h * (v13 * v11 / b + b * v57) / (3.141592653589793 * v13)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(h, b, E_star):
    v13 = E_star * h
    return (b, v13)


def block_mean_pressure_a(out, a, b, v13, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.greater(a, C14, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some65 = np.count_nonzero(m0)
    if some65:
        np.multiply(C0, a, out)
        np.subtract(b, a, t0)
        np.divide(out, t0, t0)
        np.log1p(t0, t0)
        np.multiply(t0, C1, t0)
        np.square(a, out)
        np.multiply(out, t0, t1)
        np.divide(t1, b, t1)
        np.divide(a, b, t2)
        np.less(t0, C2, m1)
        some58 = np.count_nonzero(m1)
        if some58:
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
        if some58 != size:
            other58 = t4 if some58 else t3
            np.subtract(t0, t2, other58)
            if some58:
                np.copyto(t3, other58, where=~m1)
        np.multiply(b, t3, t3)
        np.add(t1, t3, t3)
        np.multiply(v13, t3, t3)
        np.multiply(C15, out, out)
        np.divide(t3, out, out)
    if some65 != size:
        np.copyto(out, C14, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, h, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.greater(a, C14, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some65 = np.count_nonzero(m0)
    if some65:
        np.multiply(C0, a, out)
        np.subtract(b, a, t0)
        np.divide(out, t0, t0)
        np.log1p(t0, t0)
        np.multiply(t0, C1, t0)
        np.multiply(E_star, h, out)
        np.square(a, t1)
        np.multiply(t1, t0, t2)
        np.divide(t2, b, t2)
        np.divide(a, b, t3)
        np.less(t0, C2, m1)
        some58 = np.count_nonzero(m1)
        if some58:
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
        if some58 != size:
            other58 = t5 if some58 else t4
            np.subtract(t0, t3, other58)
            if some58:
                np.copyto(t4, other58, where=~m1)
        np.multiply(b, t4, t4)
        np.add(t2, t4, t4)
        np.multiply(out, t4, t4)
        np.multiply(C15, t1, t1)
        np.divide(t4, t1, out)
    if some65 != size:
        np.copyto(out, C14, where=~m0)


def pressure(r, a, h, b, E_star):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = b - r
            v9 = a - r
            v10 = a + r
            v26 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * v10)
            v31 = b + sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (b + r))
            v32 = a + v26
            v33 = v32 / v31
            if v33 > 0.7:
                return None
            if a <= b:
                if r < a:
                    v36 = r * (r / v32) / v31
                    v37 = v33 * v33
                    v38 = v36 * v36
                    v44 = 0.13579013365982337 * v37 + -0.4846453962188766
                    v49 = v44 * v37 + 0.8293825948837366
                    v54 = v49 * v37 + -0.8745573865774817
                    v59 = v54 * v37 + 0.6371928816963097
                    v64 = v59 * v37 + -0.3332798652335896
                    v69 = v64 * v37 + 0.13289328569967984
                    v74 = v69 * v37 + -0.03710676078458442
                    v79 = v74 * v37 + 0.011089560042611895
                    v84 = v79 * v37 + 0.0012521687336059639
                    v89 = v84 * v37 + 0.0036572276005780893
                    v94 = v89 * v37 + 0.004425450516633092
                    v99 = v94 * v37 + 0.005918487051520244
                    v100 = ((((((((((((0.0 * v38 + 0.13579013365982337) * v38 + v44) * v38 + v49) * v38 + v54) * v38 + v59) * v38 + v64) * v38 + v69) * v38 + v74) * v38 + v79) * v38 + v84) * v38 + v89) * v38 + v94) * v38
                    v104 = v99 * v37 + 0.008264397984935742
                    v109 = v104 * v37 + 0.012345681107818056
                    v114 = v109 * v37 + 0.020408163224119494
                    v119 = v114 * v37 + 0.04000000000042643
                    v124 = v119 * v37 + 0.11111111111110937
                    value = E_star * h / 3.141592653589793 * (asinh(sqrt(v9 * v10) / sqrt((b - a) * (a + b))) / sqrt(v5 * (r + b)) + 2.0 * v26 / v31 * (v124 * v37 + 1.0 + v36 * (v36 + v33) * ((((((v100 + v99) * v38 + v104) * v38 + v109) * v38 + v114) * v38 + v119) * v38 + v124)) / b)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, h, b, E_star):
    v13 = b - a
    v14 = a + b
    v15 = v13 * v14
    v16 = np.sqrt(v15)
    v17 = E_star * h
    v19 = v17 / (3.141592653589793)
    v145 = np.less_equal(a, b)
    return (a, b, v16, v19, v145)


def block_pressure_r(out, r, a, b, v16, v19, v145, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.subtract(b, r, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t1)
    np.add(a, r, t2)
    np.maximum(t1, f0, out=t3)
    np.multiply(t3, t2, t3)
    np.sqrt(t3, t3)
    np.maximum(t0, f0, out=t4)
    np.add(b, r, t5)
    np.multiply(t4, t5, t5)
    np.sqrt(t5, t5)
    np.add(b, t5, t5)
    np.add(a, t3, t4)
    np.divide(t4, t5, t6)
    np.greater(t6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v145:
        np.less(r, a, m1)
        some144 = np.count_nonzero(m1)
        if some144:
            np.add(r, b, out)
            np.multiply(t0, out, out)
            np.sqrt(out, out)
            np.multiply(t1, t2, t7)
            np.sqrt(t7, t7)
            np.divide(t7, v16, t7)
            np.arcsinh(t7, t7)
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
            np.divide(t9, b, t9)
            np.add(out, t9, t9)
            np.multiply(v19, t9, out)
        if some144 != size:
            np.copyto(out, C14, where=~m1)
    else:
        np.copyto(out, C35)


def prepare_pressure_r_a(h, b, E_star):
    v17 = E_star * h
    v19 = v17 / (3.141592653589793)
    return (b, v19)


def block_pressure_r_a(out, r, a, b, v19, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, f0):
    size = out.size
    np.subtract(b, r, t0)
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
    np.add(b, r, t5)
    np.multiply(t4, t5, t5)
    np.sqrt(t5, t5)
    np.add(b, t5, t5)
    np.add(a, t3, t4)
    np.divide(t4, t5, t6)
    np.greater(t6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, b, m1)
    some147 = np.count_nonzero(m1)
    if some147:
        np.less(r, a, m2)
        some144 = np.count_nonzero(m2)
        if some144:
            np.add(r, b, out)
            np.multiply(t0, out, out)
            np.sqrt(out, out)
            np.multiply(t1, t2, t7)
            np.sqrt(t7, t7)
            np.subtract(b, a, t8)
            np.add(a, b, t9)
            np.multiply(t8, t9, t9)
            np.sqrt(t9, t9)
            np.divide(t7, t9, t9)
            np.arcsinh(t9, t9)
            np.divide(t9, out, out)
            np.divide(r, t4, t9)
            np.multiply(r, t9, t9)
            np.divide(t9, t5, t9)
            np.multiply(t6, t6, t7)
            np.multiply(t9, t9, t8)
            np.multiply(C14, t8, t10)
            np.add(t10, C17, t10)
            np.multiply(C17, t7, t11)
            np.add(t11, C18, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C19, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C20, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C21, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C22, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C23, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C24, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C25, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C26, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C27, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C28, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C29, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C30, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C31, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C32, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C33, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C34, t11)
            np.multiply(t10, t8, t8)
            np.add(t8, t11, t8)
            np.multiply(t11, t7, t7)
            np.add(t7, C2, t7)
            np.multiply(C0, t3, t11)
            np.divide(t11, t5, t11)
            np.add(t9, t6, t10)
            np.multiply(t9, t10, t10)
            np.multiply(t10, t8, t8)
            np.add(t7, t8, t8)
            np.multiply(t11, t8, t8)
            np.divide(t8, b, t8)
            np.add(out, t8, t8)
            np.multiply(v19, t8, out)
        if some144 != size:
            np.copyto(out, C14, where=~m2)
    if some147 != size:
        np.copyto(out, C35, where=~m1)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, h, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, m0, m1, m2, f0):
    size = out.size
    np.subtract(b, r, t0)
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
    np.add(b, r, t5)
    np.multiply(t4, t5, t5)
    np.sqrt(t5, t5)
    np.add(b, t5, t5)
    np.add(a, t3, t4)
    np.divide(t4, t5, t6)
    np.greater(t6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, b, m1)
    some147 = np.count_nonzero(m1)
    if some147:
        np.less(r, a, m2)
        some144 = np.count_nonzero(m2)
        if some144:
            np.add(r, b, out)
            np.multiply(t0, out, out)
            np.sqrt(out, out)
            np.multiply(t1, t2, t7)
            np.sqrt(t7, t7)
            np.subtract(b, a, t8)
            np.add(a, b, t9)
            np.multiply(t8, t9, t9)
            np.sqrt(t9, t9)
            np.multiply(E_star, h, t8)
            np.divide(t8, C15, t8)
            np.divide(t7, t9, t9)
            np.arcsinh(t9, t9)
            np.divide(t9, out, out)
            np.divide(r, t4, t9)
            np.multiply(r, t9, t9)
            np.divide(t9, t5, t9)
            np.multiply(t6, t6, t7)
            np.multiply(t9, t9, t10)
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
            np.add(t9, t6, t11)
            np.multiply(t9, t11, t11)
            np.multiply(t11, t10, t10)
            np.add(t7, t10, t10)
            np.multiply(t12, t10, t10)
            np.divide(t10, b, t10)
            np.add(out, t10, t10)
            np.multiply(t8, t10, out)
        if some144 != size:
            np.copyto(out, C14, where=~m2)
    if some147 != size:
        np.copyto(out, C35, where=~m1)


def profile(r, h, b):
    if r.__class__ is h.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            v3 = r / b
            return h * (r * r) / (b * b * (sqrt((1.0 - v3) * (v3 + 1.0)) + 1.0))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(h, b):
    v12 = np.square(b)
    return (h, b, v12)


def block_profile_r(out, r, h, b, v12, t0):
    np.divide(r, b, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(C2, out, t0)
    np.add(out, C2, out)
    np.multiply(t0, out, out)
    np.sqrt(out, out)
    np.square(r, t0)
    np.multiply(h, t0, t0)
    np.add(out, C2, out)
    np.multiply(v12, out, out)
    np.divide(t0, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, h, b, t0, t1):
    np.divide(r, b, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(C2, out, t0)
    np.add(out, C2, out)
    np.multiply(t0, out, out)
    np.sqrt(out, out)
    np.square(r, t0)
    np.multiply(h, t0, t0)
    np.square(b, t1)
    np.add(out, C2, out)
    np.multiply(t1, out, out)
    np.divide(t0, out, out)


def radius_from_depth(d, h, b):
    if d.__class__ is h.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, h, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, h, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, h, b, E_star):
    if F.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, h, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, h, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, h=1.0, b=1.0):
    if a.__class__ is E_star.__class__ is h.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30):
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
    ('_depth', 1, 'a', 'h', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'h', 'b'): (('a', 'h', 'b'), prepare_depth_all, block_depth_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'h', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 6, 1, (1.0,), False),
        ('a', 'h', 'b', 'E_star'): (('a', 'h', 'b', 'E_star'), prepare_force_all, block_force_all, 7, 1, (1.0,), False),
    },
    ('_mean_pressure', 1, 'a', 'h', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 7, 2, (1.0,), False),
        ('a', 'h', 'b', 'E_star'): (('a', 'h', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 8, 2, (1.0,), False),
    },
    ('_pressure', 2, 'r', 'a', 'h', 'b', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 12, 2, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 12, 3, (0.0,), False),
        ('r', 'a', 'h', 'b', 'E_star'): (('r', 'a', 'h', 'b', 'E_star'), prepare_pressure_all, block_pressure_all, 13, 3, (0.0,), False),
    },
    ('_profile', 1, 'r', 'h', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 0, (), False),
        ('r', 'h', 'b'): (('r', 'h', 'b'), prepare_profile_all, block_profile_all, 2, 0, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
