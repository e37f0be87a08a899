"""Programs of axicontact.normal.sphere."""

from __future__ import annotations

from math import asinh, atan2, cosh, exp, expm1, fsum, inf, log1p, nan, sinh, sqrt, tanh

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
C16 = np.array(1.7179204967675554)
C17 = np.array(0.8)
C18 = np.array(0.03812728612374059)
C19 = np.array(-53195.64116483364)
C20 = np.array(18485.08434122529)
C21 = np.array(59207.63481260677)
C22 = np.array(17876.90896541072)
C23 = np.array(1923.074008763512)
C24 = np.array(85.36998480516608)
C25 = np.array(1.329889984051219)
C26 = np.array(-9809.489595170257)
C27 = np.array(93084.84736709161)
C28 = np.array(74691.14995817501)
C29 = np.array(17299.016817433552)
C30 = np.array(1640.3784958292124)
C31 = np.array(67.52528901476805)
C32 = np.array(0.017942334397165086)
C33 = np.array(0.09990750072362801)
C34 = np.array(0.5444629040821292)
C35 = np.array(2.1371993915944367)
C36 = np.array(6.125980425599675)
C37 = np.array(13.482272517053174)
C38 = np.array(16.571545092002584)
C39 = np.array(9.5189968828819)
C40 = np.array(0.018009433732159942)
C41 = np.array(0.08953714875930008)
C42 = np.array(0.505498100763311)
C43 = np.array(1.837793059410041)
C44 = np.array(5.320959603282673)
C45 = np.array(10.425327577706595)
C46 = np.array(10.870096444963094)
C47 = np.array(5.3845732038762915)
C48 = np.array(0.7)
C49 = np.array(0.13579013365982337)
C50 = np.array(-0.4846453962188766)
C51 = np.array(0.8293825948837366)
C52 = np.array(-0.8745573865774817)
C53 = np.array(0.6371928816963097)
C54 = np.array(-0.3332798652335896)
C55 = np.array(0.13289328569967984)
C56 = np.array(-0.03710676078458442)
C57 = np.array(0.011089560042611895)
C58 = np.array(0.0012521687336059639)
C59 = np.array(0.0036572276005780893)
C60 = np.array(0.004425450516633092)
C61 = np.array(0.005918487051520244)
C62 = np.array(0.008264397984935742)
C63 = np.array(0.012345681107818056)
C64 = np.array(0.020408163224119494)
C65 = np.array(0.04000000000042643)
C66 = np.array(0.11111111111110937)
C67 = np.array(np.nan)
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


def peak_pressure(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = R - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (R + a))
            v13 = asinh(a / v11)
            v15 = v13 if v13 < 40.0 or v13 != v13 else 40.0
            v17 = v15 - 1.7179204967675554
            v18 = v17 if v17 > 0.0 or v17 != v17 else 0.0
            if v18 > 0.8:
                v25 = cosh(v15)
                v30 = 0.03812728612374059 - (v15 * tanh(v15) - 1.0) / (v25 * v25)
                v31 = v30 if v30 > 0.0 or v30 != v30 else 0.0
                v122 = ((((((-53195.64116483364 * v31 + 18485.08434122529) * v31 + 59207.63481260677) * v31 + 17876.90896541072) * v31 + 1923.074008763512) * v31 + 85.36998480516608) * v31 + 1.329889984051219) / ((((((-9809.489595170257 * v31 + 93084.84736709161) * v31 + 74691.14995817501) * v31 + 17299.016817433552) * v31 + 1640.3784958292124) * v31 + 67.52528901476805) * v31 + 1.0)
            else:
                v20 = v18 if v18 < 0.8 or v18 != v18 else 0.8
                v122 = v15 - v20 * (((((((((0.017942334397165086 * v20 + 0.09990750072362801) * v20 + 0.5444629040821292) * v20 + 2.1371993915944367) * v20 + 6.125980425599675) * v20 + 13.482272517053174) * v20 + 16.571545092002584) * v20 + 9.5189968828819) * v20 + 2.0) / ((((((((0.018009433732159942 * v20 + 0.08953714875930008) * v20 + 0.505498100763311) * v20 + 1.837793059410041) * v20 + 5.320959603282673) * v20 + 10.425327577706595) * v20 + 10.870096444963094) * v20 + 5.3845732038762915) * v20 + 1.0))
            if v15 > 1.7179204967675554:
                v125 = sinh(v122) * v11 / a
                v132 = a * sqrt((1.0 - v125) * (1.0 + v125))
            else:
                v132 = 0.0
            v133 = a - v132
            v137 = sqrt((v133 if v133 > 0.0 or v133 != v133 else 0.0) * (a + v132))
            v138 = R - v132
            v143 = R + sqrt((v138 if v138 > 0.0 or v138 != v138 else 0.0) * (R + v132))
            v144 = a + v137
            v145 = v144 / v143
            if v145 > 0.7:
                return None
            if a <= R:
                if a > 0.0 and a < R:
                    v148 = v132 * (v132 / v144) / v143
                    v149 = v145 * v145
                    v150 = v148 * v148
                    v156 = 0.13579013365982337 * v149 + -0.4846453962188766
                    v161 = v156 * v149 + 0.8293825948837366
                    v166 = v161 * v149 + -0.8745573865774817
                    v171 = v166 * v149 + 0.6371928816963097
                    v176 = v171 * v149 + -0.3332798652335896
                    v181 = v176 * v149 + 0.13289328569967984
                    v186 = v181 * v149 + -0.03710676078458442
                    v191 = v186 * v149 + 0.011089560042611895
                    v196 = v191 * v149 + 0.0012521687336059639
                    v201 = v196 * v149 + 0.0036572276005780893
                    v206 = v201 * v149 + 0.004425450516633092
                    v211 = v206 * v149 + 0.005918487051520244
                    v212 = ((((((((((((0.0 * v150 + 0.13579013365982337) * v150 + v156) * v150 + v161) * v150 + v166) * v150 + v171) * v150 + v176) * v150 + v181) * v150 + v186) * v150 + v191) * v150 + v196) * v150 + v201) * v150 + v206) * v150
                    v216 = v211 * v149 + 0.008264397984935742
                    v221 = v216 * v149 + 0.012345681107818056
                    v226 = v221 * v149 + 0.020408163224119494
                    v231 = v226 * v149 + 0.04000000000042643
                    v236 = v231 * v149 + 0.11111111111110937
                    v257 = 2.0 * v137 / v143 * (v236 * v149 + 1.0 + v148 * (v148 + v145) * ((((((v212 + v211) * v150 + v216) * v150 + v221) * v150 + v226) * v150 + v231) * v150 + v236))
                else:
                    v257 = 0.0
                value = E_star / 3.141592653589793 * (R * v122 / (v11 * cosh(v122)) + v257)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_pressure_a(R, E_star):
    v5 = E_star / (3.141592653589793)
    return (R, v5)


def block_peak_pressure_a(out, a, R, v5, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, m3, f0, f1, f2):
    size = out.size
    np.less_equal(a, R, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.maximum(t0, f0, out=t0)
    np.add(R, a, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(a, t1, t0)
    np.arcsinh(t0, t0)
    np.minimum(t0, f1, out=t0)
    np.subtract(t0, C16, t2)
    np.maximum(t2, f0, out=t2)
    np.greater(t2, C17, m1)
    some122 = np.count_nonzero(m1)
    if some122:
        np.tanh(t0, t3)
        np.multiply(t0, t3, t3)
        np.subtract(t3, C2, t3)
        np.cosh(t0, t4)
        np.square(t4, t4)
        np.divide(t3, t4, t4)
        np.subtract(C18, t4, t4)
        np.maximum(t4, f0, out=t4)
        np.multiply(C19, t4, t3)
        np.add(t3, C20, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C21, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C22, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C23, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C24, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C25, t3)
        np.multiply(C26, t4, t5)
        np.add(t5, C27, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C28, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C29, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C30, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C31, t5)
        np.multiply(t5, t4, t4)
        np.add(t4, C2, t4)
        np.divide(t3, t4, t3)
    if some122 != size:
        other122 = t4 if some122 else t3
        np.minimum(t2, f2, out=other122)
        np.multiply(C32, other122, t5)
        np.add(t5, C33, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C34, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C35, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C36, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C37, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C38, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C39, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C0, t5)
        np.multiply(C40, other122, t6)
        np.add(t6, C41, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C42, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C43, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C44, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C45, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C46, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C47, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C2, t6)
        np.divide(t5, t6, t6)
        np.multiply(other122, t6, t6)
        np.subtract(t0, t6, other122)
        if some122:
            np.copyto(t3, other122, where=~m1)
    np.greater(t0, C16, m1)
    some132 = np.count_nonzero(m1)
    if some132:
        np.sinh(t3, t0)
        np.multiply(t0, t1, t0)
        np.divide(t0, a, t0)
        np.subtract(C2, t0, t2)
        np.add(C2, t0, t0)
        np.multiply(t2, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(a, t0, t0)
    if some132 != size:
        np.copyto(t0, C14, where=~m1)
    np.subtract(a, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(a, t0, t4)
    np.multiply(t2, t4, t4)
    np.sqrt(t4, t4)
    np.subtract(R, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(R, t0, t6)
    np.multiply(t2, t6, t6)
    np.sqrt(t6, t6)
    np.add(R, t6, t6)
    np.add(a, t4, t2)
    np.divide(t2, t6, t5)
    np.greater(t5, C48, m1)
    if np.count_nonzero(m1):
        raise FloatingPointError
    some261 = np.count_nonzero(m0)
    if some261:
        np.multiply(R, t3, out)
        np.cosh(t3, t7)
        np.multiply(t1, t7, t7)
        np.divide(out, t7, t7)
        np.greater(a, C14, m2)
        np.less(a, R, m3)
        np.bitwise_and(m2, m3, m3)
        some257 = np.count_nonzero(m3)
        if some257:
            np.divide(t0, t2, out)
            np.multiply(t0, out, out)
            np.divide(out, t6, out)
            np.multiply(t5, t5, t8)
            np.multiply(out, out, t9)
            np.multiply(C14, t9, t10)
            np.add(t10, C49, t10)
            np.multiply(C49, t8, t11)
            np.add(t11, C50, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C51, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C52, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C53, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C54, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C55, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C56, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C57, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C58, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C59, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C60, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C61, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C62, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C63, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C64, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C65, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C66, t11)
            np.multiply(t10, t9, t9)
            np.add(t9, t11, t9)
            np.multiply(t11, t8, t8)
            np.add(t8, C2, t8)
            np.multiply(C0, t4, t11)
            np.divide(t11, t6, t11)
            np.add(out, t5, t10)
            np.multiply(out, t10, t10)
            np.multiply(t10, t9, t9)
            np.add(t8, t9, t9)
            np.multiply(t11, t9, out)
        if some257 != size:
            np.copyto(out, C14, where=~m3)
        np.add(t7, out, out)
        np.multiply(v5, out, out)
    if some261 != size:
        np.copyto(out, C67, where=~m0)


def prepare_peak_pressure_all():
    return ()


def block_peak_pressure_all(out, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, m0, m1, m2, m3, f0, f1, f2):
    size = out.size
    np.less_equal(a, R, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.maximum(t0, f0, out=t0)
    np.add(R, a, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(a, t1, t0)
    np.arcsinh(t0, t0)
    np.minimum(t0, f1, out=t0)
    np.subtract(t0, C16, t2)
    np.maximum(t2, f0, out=t2)
    np.greater(t2, C17, m1)
    some122 = np.count_nonzero(m1)
    if some122:
        np.tanh(t0, t3)
        np.multiply(t0, t3, t3)
        np.subtract(t3, C2, t3)
        np.cosh(t0, t4)
        np.square(t4, t4)
        np.divide(t3, t4, t4)
        np.subtract(C18, t4, t4)
        np.maximum(t4, f0, out=t4)
        np.multiply(C19, t4, t3)
        np.add(t3, C20, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C21, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C22, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C23, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C24, t3)
        np.multiply(t3, t4, t3)
        np.add(t3, C25, t3)
        np.multiply(C26, t4, t5)
        np.add(t5, C27, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C28, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C29, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C30, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C31, t5)
        np.multiply(t5, t4, t4)
        np.add(t4, C2, t4)
        np.divide(t3, t4, t3)
    if some122 != size:
        other122 = t4 if some122 else t3
        np.minimum(t2, f2, out=other122)
        np.multiply(C32, other122, t5)
        np.add(t5, C33, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C34, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C35, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C36, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C37, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C38, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C39, t5)
        np.multiply(t5, other122, t5)
        np.add(t5, C0, t5)
        np.multiply(C40, other122, t6)
        np.add(t6, C41, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C42, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C43, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C44, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C45, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C46, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C47, t6)
        np.multiply(t6, other122, t6)
        np.add(t6, C2, t6)
        np.divide(t5, t6, t6)
        np.multiply(other122, t6, t6)
        np.subtract(t0, t6, other122)
        if some122:
            np.copyto(t3, other122, where=~m1)
    np.greater(t0, C16, m1)
    some132 = np.count_nonzero(m1)
    if some132:
        np.sinh(t3, t0)
        np.multiply(t0, t1, t0)
        np.divide(t0, a, t0)
        np.subtract(C2, t0, t2)
        np.add(C2, t0, t0)
        np.multiply(t2, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(a, t0, t0)
    if some132 != size:
        np.copyto(t0, C14, where=~m1)
    np.subtract(a, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(a, t0, t4)
    np.multiply(t2, t4, t4)
    np.sqrt(t4, t4)
    np.subtract(R, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(R, t0, t6)
    np.multiply(t2, t6, t6)
    np.sqrt(t6, t6)
    np.add(R, t6, t6)
    np.add(a, t4, t2)
    np.divide(t2, t6, t5)
    np.greater(t5, C48, m1)
    if np.count_nonzero(m1):
        raise FloatingPointError
    some261 = np.count_nonzero(m0)
    if some261:
        np.divide(E_star, C15, out)
        np.multiply(R, t3, t7)
        np.cosh(t3, t8)
        np.multiply(t1, t8, t8)
        np.divide(t7, t8, t8)
        np.greater(a, C14, m2)
        np.less(a, R, m3)
        np.bitwise_and(m2, m3, m3)
        some257 = np.count_nonzero(m3)
        if some257:
            np.divide(t0, t2, t7)
            np.multiply(t0, t7, t7)
            np.divide(t7, t6, t7)
            np.multiply(t5, t5, t9)
            np.multiply(t7, t7, t10)
            np.multiply(C14, t10, t11)
            np.add(t11, C49, t11)
            np.multiply(C49, t9, t12)
            np.add(t12, C50, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C51, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C52, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C53, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C54, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C55, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C56, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C57, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C58, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C59, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C60, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C61, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C62, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C63, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C64, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C65, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t9, t12)
            np.add(t12, C66, t12)
            np.multiply(t11, t10, t10)
            np.add(t10, t12, t10)
            np.multiply(t12, t9, t9)
            np.add(t9, C2, t9)
            np.multiply(C0, t4, t12)
            np.divide(t12, t6, t12)
            np.add(t7, t5, t11)
            np.multiply(t7, t11, t11)
            np.multiply(t11, t10, t10)
            np.add(t9, t10, t10)
            np.multiply(t12, t10, t7)
        if some257 != size:
            np.copyto(t7, C14, where=~m3)
        np.add(t8, t7, t7)
        np.multiply(out, t7, out)
    if some261 != size:
        np.copyto(out, C67, where=~m0)


def peak_radius(a, R, E_star=1.0):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= R:
                v3 = R - a
                v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (R + a))
                v10 = asinh(a / v8)
                v12 = v10 if v10 < 40.0 or v10 != v10 else 40.0
                if v12 > 1.7179204967675554:
                    v14 = v12 - 1.7179204967675554
                    v15 = v14 if v14 > 0.0 or v14 != v14 else 0.0
                    if v15 > 0.8:
                        v22 = cosh(v12)
                        v27 = 0.03812728612374059 - (v12 * tanh(v12) - 1.0) / (v22 * v22)
                        v28 = v27 if v27 > 0.0 or v27 != v27 else 0.0
                        v119 = ((((((-53195.64116483364 * v28 + 18485.08434122529) * v28 + 59207.63481260677) * v28 + 17876.90896541072) * v28 + 1923.074008763512) * v28 + 85.36998480516608) * v28 + 1.329889984051219) / ((((((-9809.489595170257 * v28 + 93084.84736709161) * v28 + 74691.14995817501) * v28 + 17299.016817433552) * v28 + 1640.3784958292124) * v28 + 67.52528901476805) * v28 + 1.0)
                    else:
                        v17 = v15 if v15 < 0.8 or v15 != v15 else 0.8
                        v119 = v12 - v17 * (((((((((0.017942334397165086 * v17 + 0.09990750072362801) * v17 + 0.5444629040821292) * v17 + 2.1371993915944367) * v17 + 6.125980425599675) * v17 + 13.482272517053174) * v17 + 16.571545092002584) * v17 + 9.5189968828819) * v17 + 2.0) / ((((((((0.018009433732159942 * v17 + 0.08953714875930008) * v17 + 0.505498100763311) * v17 + 1.837793059410041) * v17 + 5.320959603282673) * v17 + 10.425327577706595) * v17 + 10.870096444963094) * v17 + 5.3845732038762915) * v17 + 1.0))
                    v122 = sinh(v119) * v8 / a
                    value = a * sqrt((1.0 - v122) * (1.0 + v122))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_a(R):
    return (R,)


def block_peak_radius_a(out, a, R, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0, f1, f2):
    size = out.size
    np.less_equal(a, R, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some131 = np.count_nonzero(m0)
    if some131:
        np.subtract(R, a, t0)
        np.maximum(t0, f0, out=t0)
        np.add(R, a, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.divide(a, t1, t0)
        np.arcsinh(t0, t0)
        np.minimum(t0, f1, out=t0)
        np.greater(t0, C16, m1)
        some129 = np.count_nonzero(m1)
        if some129:
            np.subtract(t0, C16, out)
            np.maximum(out, f0, out=out)
            np.greater(out, C17, m2)
            some119 = np.count_nonzero(m2)
            if some119:
                np.tanh(t0, t2)
                np.multiply(t0, t2, t2)
                np.subtract(t2, C2, t2)
                np.cosh(t0, t3)
                np.square(t3, t3)
                np.divide(t2, t3, t3)
                np.subtract(C18, t3, t3)
                np.maximum(t3, f0, out=t3)
                np.multiply(C19, t3, t2)
                np.add(t2, C20, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C21, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C22, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C23, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C24, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C25, t2)
                np.multiply(C26, t3, t4)
                np.add(t4, C27, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C28, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C29, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C30, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C31, t4)
                np.multiply(t4, t3, t3)
                np.add(t3, C2, t3)
                np.divide(t2, t3, t2)
            if some119 != size:
                other119 = t3 if some119 else t2
                np.minimum(out, f2, out=other119)
                np.multiply(C32, other119, t4)
                np.add(t4, C33, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C34, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C35, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C36, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C37, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C38, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C39, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C0, t4)
                np.multiply(C40, other119, t5)
                np.add(t5, C41, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C42, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C43, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C44, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C45, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C46, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C47, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C2, t5)
                np.divide(t4, t5, t5)
                np.multiply(other119, t5, t5)
                np.subtract(t0, t5, other119)
                if some119:
                    np.copyto(t2, other119, where=~m2)
            np.sinh(t2, t2)
            np.multiply(t2, t1, t2)
            np.divide(t2, a, t2)
            np.subtract(C2, t2, out)
            np.add(C2, t2, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.multiply(a, t2, out)
        if some129 != size:
            np.copyto(out, C14, where=~m1)
    if some131 != size:
        np.copyto(out, C67, where=~m0)


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a, R, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0, f1, f2):
    size = out.size
    np.less_equal(a, R, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some131 = np.count_nonzero(m0)
    if some131:
        np.subtract(R, a, t0)
        np.maximum(t0, f0, out=t0)
        np.add(R, a, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.divide(a, t1, t0)
        np.arcsinh(t0, t0)
        np.minimum(t0, f1, out=t0)
        np.greater(t0, C16, m1)
        some129 = np.count_nonzero(m1)
        if some129:
            np.subtract(t0, C16, out)
            np.maximum(out, f0, out=out)
            np.greater(out, C17, m2)
            some119 = np.count_nonzero(m2)
            if some119:
                np.tanh(t0, t2)
                np.multiply(t0, t2, t2)
                np.subtract(t2, C2, t2)
                np.cosh(t0, t3)
                np.square(t3, t3)
                np.divide(t2, t3, t3)
                np.subtract(C18, t3, t3)
                np.maximum(t3, f0, out=t3)
                np.multiply(C19, t3, t2)
                np.add(t2, C20, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C21, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C22, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C23, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C24, t2)
                np.multiply(t2, t3, t2)
                np.add(t2, C25, t2)
                np.multiply(C26, t3, t4)
                np.add(t4, C27, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C28, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C29, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C30, t4)
                np.multiply(t4, t3, t4)
                np.add(t4, C31, t4)
                np.multiply(t4, t3, t3)
                np.add(t3, C2, t3)
                np.divide(t2, t3, t2)
            if some119 != size:
                other119 = t3 if some119 else t2
                np.minimum(out, f2, out=other119)
                np.multiply(C32, other119, t4)
                np.add(t4, C33, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C34, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C35, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C36, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C37, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C38, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C39, t4)
                np.multiply(t4, other119, t4)
                np.add(t4, C0, t4)
                np.multiply(C40, other119, t5)
                np.add(t5, C41, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C42, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C43, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C44, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C45, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C46, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C47, t5)
                np.multiply(t5, other119, t5)
                np.add(t5, C2, t5)
                np.divide(t4, t5, t5)
                np.multiply(other119, t5, t5)
                np.subtract(t0, t5, other119)
                if some119:
                    np.copyto(t2, other119, where=~m2)
            np.sinh(t2, t2)
            np.multiply(t2, t1, t2)
            np.divide(t2, a, t2)
            np.subtract(C2, t2, out)
            np.add(C2, t2, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.multiply(a, t2, out)
        if some129 != size:
            np.copyto(out, C14, where=~m1)
    if some131 != size:
        np.copyto(out, C67, where=~m0)


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
    np.greater(t6, C48, m0)
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
            np.add(t10, C49, t10)
            np.multiply(C49, t8, t11)
            np.add(t11, C50, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C51, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C52, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C53, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C54, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C55, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C56, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C57, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C58, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C59, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C60, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C61, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C62, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C63, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C64, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C65, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t8, t11)
            np.add(t11, C66, t11)
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
        np.copyto(out, C67)


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
    np.greater(t6, C48, m0)
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
            np.add(t10, C49, t10)
            np.multiply(C49, t7, t11)
            np.add(t11, C50, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C51, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C52, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C53, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C54, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C55, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C56, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C57, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C58, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C59, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C60, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C61, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C62, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C63, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C64, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C65, t11)
            np.multiply(t10, t9, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C66, t11)
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
        np.copyto(out, C67, where=~m1)


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
    np.greater(t6, C48, m0)
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
            np.add(t11, C49, t11)
            np.multiply(C49, t7, t12)
            np.add(t12, C50, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C51, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C52, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C53, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C54, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C55, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C56, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C57, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C58, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C59, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C60, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C61, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C62, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C63, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C64, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C65, t12)
            np.multiply(t11, t10, t11)
            np.add(t11, t12, t11)
            np.multiply(t12, t7, t12)
            np.add(t12, C66, t12)
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
        np.copyto(out, C67, where=~m1)


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
    ('_peak_pressure', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_peak_pressure_a, block_peak_pressure_a, 12, 4, (0.0, 40.0, 0.8), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_peak_pressure_all, block_peak_pressure_all, 13, 4, (0.0, 40.0, 0.8), False),
    },
    ('_peak_radius', 1, 'a', 'R'): {
        ('a',): (('a',), prepare_peak_radius_a, block_peak_radius_a, 6, 3, (0.0, 40.0, 0.8), False),
        ('a', 'R'): (('a', 'R'), prepare_peak_radius_all, block_peak_radius_all, 6, 3, (0.0, 40.0, 0.8), False),
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
