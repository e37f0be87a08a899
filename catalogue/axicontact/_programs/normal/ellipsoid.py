"""Programs of axicontact.normal.ellipsoid."""

from __future__ import annotations

from math import asinh, atan2, cosh, exp, expm1, fsum, inf, log1p, nan, sinh, sqrt, tanh

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


def peak_pressure(a, h, b, E_star):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v9 = b - a
            v14 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (b + a))
            v16 = asinh(a / v14)
            v18 = v16 if v16 < 40.0 or v16 != v16 else 40.0
            v20 = v18 - 1.7179204967675554
            v21 = v20 if v20 > 0.0 or v20 != v20 else 0.0
            if v21 > 0.8:
                v28 = cosh(v18)
                v33 = 0.03812728612374059 - (v18 * tanh(v18) - 1.0) / (v28 * v28)
                v34 = v33 if v33 > 0.0 or v33 != v33 else 0.0
                v125 = ((((((-53195.64116483364 * v34 + 18485.08434122529) * v34 + 59207.63481260677) * v34 + 17876.90896541072) * v34 + 1923.074008763512) * v34 + 85.36998480516608) * v34 + 1.329889984051219) / ((((((-9809.489595170257 * v34 + 93084.84736709161) * v34 + 74691.14995817501) * v34 + 17299.016817433552) * v34 + 1640.3784958292124) * v34 + 67.52528901476805) * v34 + 1.0)
            else:
                v23 = v21 if v21 < 0.8 or v21 != v21 else 0.8
                v125 = v18 - v23 * (((((((((0.017942334397165086 * v23 + 0.09990750072362801) * v23 + 0.5444629040821292) * v23 + 2.1371993915944367) * v23 + 6.125980425599675) * v23 + 13.482272517053174) * v23 + 16.571545092002584) * v23 + 9.5189968828819) * v23 + 2.0) / ((((((((0.018009433732159942 * v23 + 0.08953714875930008) * v23 + 0.505498100763311) * v23 + 1.837793059410041) * v23 + 5.320959603282673) * v23 + 10.425327577706595) * v23 + 10.870096444963094) * v23 + 5.3845732038762915) * v23 + 1.0))
            if v18 > 1.7179204967675554:
                v128 = sinh(v125) * v14 / a
                v135 = a * sqrt((1.0 - v128) * (1.0 + v128))
            else:
                v135 = 0.0
            v136 = a - v135
            v140 = sqrt((v136 if v136 > 0.0 or v136 != v136 else 0.0) * (a + v135))
            v141 = b - v135
            v146 = b + sqrt((v141 if v141 > 0.0 or v141 != v141 else 0.0) * (b + v135))
            v147 = a + v140
            v148 = v147 / v146
            if v148 > 0.7:
                return None
            if a <= b:
                if a > 0.0 and a < b:
                    v151 = v135 * (v135 / v147) / v146
                    v152 = v148 * v148
                    v153 = v151 * v151
                    v159 = 0.13579013365982337 * v152 + -0.4846453962188766
                    v164 = v159 * v152 + 0.8293825948837366
                    v169 = v164 * v152 + -0.8745573865774817
                    v174 = v169 * v152 + 0.6371928816963097
                    v179 = v174 * v152 + -0.3332798652335896
                    v184 = v179 * v152 + 0.13289328569967984
                    v189 = v184 * v152 + -0.03710676078458442
                    v194 = v189 * v152 + 0.011089560042611895
                    v199 = v194 * v152 + 0.0012521687336059639
                    v204 = v199 * v152 + 0.0036572276005780893
                    v209 = v204 * v152 + 0.004425450516633092
                    v214 = v209 * v152 + 0.005918487051520244
                    v215 = ((((((((((((0.0 * v153 + 0.13579013365982337) * v153 + v159) * v153 + v164) * v153 + v169) * v153 + v174) * v153 + v179) * v153 + v184) * v153 + v189) * v153 + v194) * v153 + v199) * v153 + v204) * v153 + v209) * v153
                    v219 = v214 * v152 + 0.008264397984935742
                    v224 = v219 * v152 + 0.012345681107818056
                    v229 = v224 * v152 + 0.020408163224119494
                    v234 = v229 * v152 + 0.04000000000042643
                    v239 = v234 * v152 + 0.11111111111110937
                    v260 = 2.0 * v140 / v146 * (v239 * v152 + 1.0 + v151 * (v151 + v148) * ((((((v215 + v214) * v153 + v219) * v153 + v224) * v153 + v229) * v153 + v234) * v153 + v239))
                else:
                    v260 = 0.0
                value = E_star * h / (3.141592653589793 * b) * (b * v125 / (v14 * cosh(v125)) + v260)
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


def prepare_peak_pressure_a(h, b, E_star):
    v5 = E_star * h
    v7 = (3.141592653589793) * b
    v8 = v5 / v7
    return (b, v8)


def block_peak_pressure_a(out, a, b, v8, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, m3, f0, f1, f2):
    size = out.size
    np.less_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.maximum(t0, f0, out=t0)
    np.add(b, a, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(a, t1, t0)
    np.arcsinh(t0, t0)
    np.minimum(t0, f1, out=t0)
    np.subtract(t0, C16, t2)
    np.maximum(t2, f0, out=t2)
    np.greater(t2, C17, m1)
    some125 = np.count_nonzero(m1)
    if some125:
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
    if some125 != size:
        other125 = t4 if some125 else t3
        np.minimum(t2, f2, out=other125)
        np.multiply(C32, other125, t5)
        np.add(t5, C33, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C34, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C35, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C36, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C37, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C38, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C39, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C0, t5)
        np.multiply(C40, other125, t6)
        np.add(t6, C41, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C42, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C43, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C44, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C45, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C46, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C47, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C2, t6)
        np.divide(t5, t6, t6)
        np.multiply(other125, t6, t6)
        np.subtract(t0, t6, other125)
        if some125:
            np.copyto(t3, other125, where=~m1)
    np.greater(t0, C16, m1)
    some135 = np.count_nonzero(m1)
    if some135:
        np.sinh(t3, t0)
        np.multiply(t0, t1, t0)
        np.divide(t0, a, t0)
        np.subtract(C2, t0, t2)
        np.add(C2, t0, t0)
        np.multiply(t2, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(a, t0, t0)
    if some135 != size:
        np.copyto(t0, C14, where=~m1)
    np.subtract(a, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(a, t0, t4)
    np.multiply(t2, t4, t4)
    np.sqrt(t4, t4)
    np.subtract(b, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(b, t0, t6)
    np.multiply(t2, t6, t6)
    np.sqrt(t6, t6)
    np.add(b, t6, t6)
    np.add(a, t4, t2)
    np.divide(t2, t6, t5)
    np.greater(t5, C48, m1)
    if np.count_nonzero(m1):
        raise FloatingPointError
    some264 = np.count_nonzero(m0)
    if some264:
        np.multiply(b, t3, out)
        np.cosh(t3, t7)
        np.multiply(t1, t7, t7)
        np.divide(out, t7, t7)
        np.greater(a, C14, m2)
        np.less(a, b, m3)
        np.bitwise_and(m2, m3, m3)
        some260 = np.count_nonzero(m3)
        if some260:
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
        if some260 != size:
            np.copyto(out, C14, where=~m3)
        np.add(t7, out, out)
        np.multiply(v8, out, out)
    if some264 != size:
        np.copyto(out, C67, where=~m0)


def prepare_peak_pressure_all():
    return ()


def block_peak_pressure_all(out, a, h, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, m0, m1, m2, m3, f0, f1, f2):
    size = out.size
    np.less_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.maximum(t0, f0, out=t0)
    np.add(b, a, t1)
    np.multiply(t0, t1, t1)
    np.sqrt(t1, t1)
    np.divide(a, t1, t0)
    np.arcsinh(t0, t0)
    np.minimum(t0, f1, out=t0)
    np.subtract(t0, C16, t2)
    np.maximum(t2, f0, out=t2)
    np.greater(t2, C17, m1)
    some125 = np.count_nonzero(m1)
    if some125:
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
    if some125 != size:
        other125 = t4 if some125 else t3
        np.minimum(t2, f2, out=other125)
        np.multiply(C32, other125, t5)
        np.add(t5, C33, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C34, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C35, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C36, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C37, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C38, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C39, t5)
        np.multiply(t5, other125, t5)
        np.add(t5, C0, t5)
        np.multiply(C40, other125, t6)
        np.add(t6, C41, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C42, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C43, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C44, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C45, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C46, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C47, t6)
        np.multiply(t6, other125, t6)
        np.add(t6, C2, t6)
        np.divide(t5, t6, t6)
        np.multiply(other125, t6, t6)
        np.subtract(t0, t6, other125)
        if some125:
            np.copyto(t3, other125, where=~m1)
    np.greater(t0, C16, m1)
    some135 = np.count_nonzero(m1)
    if some135:
        np.sinh(t3, t0)
        np.multiply(t0, t1, t0)
        np.divide(t0, a, t0)
        np.subtract(C2, t0, t2)
        np.add(C2, t0, t0)
        np.multiply(t2, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(a, t0, t0)
    if some135 != size:
        np.copyto(t0, C14, where=~m1)
    np.subtract(a, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(a, t0, t4)
    np.multiply(t2, t4, t4)
    np.sqrt(t4, t4)
    np.subtract(b, t0, t2)
    np.maximum(t2, f0, out=t2)
    np.add(b, t0, t6)
    np.multiply(t2, t6, t6)
    np.sqrt(t6, t6)
    np.add(b, t6, t6)
    np.add(a, t4, t2)
    np.divide(t2, t6, t5)
    np.greater(t5, C48, m1)
    if np.count_nonzero(m1):
        raise FloatingPointError
    some264 = np.count_nonzero(m0)
    if some264:
        np.multiply(E_star, h, out)
        np.multiply(C15, b, t7)
        np.divide(out, t7, t7)
        np.multiply(b, t3, out)
        np.cosh(t3, t8)
        np.multiply(t1, t8, t8)
        np.divide(out, t8, t8)
        np.greater(a, C14, m2)
        np.less(a, b, m3)
        np.bitwise_and(m2, m3, m3)
        some260 = np.count_nonzero(m3)
        if some260:
            np.divide(t0, t2, out)
            np.multiply(t0, out, out)
            np.divide(out, t6, out)
            np.multiply(t5, t5, t9)
            np.multiply(out, out, t10)
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
            np.add(out, t5, t11)
            np.multiply(out, t11, t11)
            np.multiply(t11, t10, t10)
            np.add(t9, t10, t10)
            np.multiply(t12, t10, out)
        if some260 != size:
            np.copyto(out, C14, where=~m3)
        np.add(t8, out, out)
        np.multiply(t7, out, out)
    if some264 != size:
        np.copyto(out, C67, where=~m0)


def peak_radius(a, b, h=1.0, E_star=1.0):
    if a.__class__ is b.__class__ is h.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (b > 1e-30) and (b < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a <= b:
                v3 = b - a
                v8 = sqrt((v3 if v3 > 0.0 or v3 != v3 else 0.0) * (b + a))
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


def prepare_peak_radius_a(b):
    return (b,)


def block_peak_radius_a(out, a, b, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0, f1, f2):
    size = out.size
    np.less_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some131 = np.count_nonzero(m0)
    if some131:
        np.subtract(b, a, t0)
        np.maximum(t0, f0, out=t0)
        np.add(b, a, t1)
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


def block_peak_radius_all(out, a, b, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0, f1, f2):
    size = out.size
    np.less_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some131 = np.count_nonzero(m0)
    if some131:
        np.subtract(b, a, t0)
        np.maximum(t0, f0, out=t0)
        np.add(b, a, t1)
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
    np.greater(t6, C48, m0)
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
            np.divide(t9, b, t9)
            np.add(out, t9, t9)
            np.multiply(v19, t9, out)
        if some144 != size:
            np.copyto(out, C14, where=~m1)
    else:
        np.copyto(out, C67)


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
    np.greater(t6, C48, m0)
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
            np.add(t10, C49, t10)
            np.multiply(C49, t7, t11)
            np.add(t11, C50, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C51, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C52, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C53, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C54, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C55, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C56, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C57, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C58, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C59, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C60, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C61, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C62, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C63, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C64, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C65, t11)
            np.multiply(t10, t8, t10)
            np.add(t10, t11, t10)
            np.multiply(t11, t7, t11)
            np.add(t11, C66, t11)
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
        np.copyto(out, C67, where=~m1)


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
    np.greater(t6, C48, m0)
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
        np.copyto(out, C67, where=~m1)


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
    ('_peak_pressure', 1, 'a', 'h', 'b', 'E_star'): {
        ('a',): (('a',), prepare_peak_pressure_a, block_peak_pressure_a, 12, 4, (0.0, 40.0, 0.8), False),
        ('a', 'h', 'b', 'E_star'): (('a', 'h', 'b', 'E_star'), prepare_peak_pressure_all, block_peak_pressure_all, 13, 4, (0.0, 40.0, 0.8), False),
    },
    ('_peak_radius', 1, 'a', 'b'): {
        ('a',): (('a',), prepare_peak_radius_a, block_peak_radius_a, 6, 3, (0.0, 40.0, 0.8), False),
        ('a', 'b'): (('a', 'b'), prepare_peak_radius_all, block_peak_radius_all, 6, 3, (0.0, 40.0, 0.8), False),
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
