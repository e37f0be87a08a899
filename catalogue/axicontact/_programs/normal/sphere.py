"""Programs of axicontact.normal.sphere."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, log1p, nan, sqrt

import numpy as np

from ..._runtime.arrays.blocks import Program, largest
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
RULE_0 = rule(((0.4097463988641303, 8), (1.7123381635707111, 16), (3.012135102255693, 24), (4.256467450182103, 32), (9.015036632031958, 64)))


def depth(a, R):
    if a.__class__ is R.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return a * (log1p(2.0 * a / (R - a)) / 2.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R):
    return (R,)


def block_depth_a(out, a, R, w0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.multiply(a, w0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, w0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.multiply(a, w0, out)


def depth_from_force(F, R, E_star):
    if F.__class__ is R.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
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
                    return None
                return a * (log1p(2.0 * a / (R - a)) / 2.0) - r * r / (sqrt(v47 * v39) + R)
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


def block_force_a(out, a, R, E_star, v12, w0, w1, w2, w3, w4, w5, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.square(a, out)
    np.multiply(out, w0, out)
    np.divide(a, R, w1)
    np.less(w0, C2, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(w0, f0, out=w2)
        np.multiply(w1, w1, w3)
        np.multiply(w1, w3, w3)
        np.multiply(w2, w2, w2)
        np.multiply(C3, w2, w4)
        np.add(w4, C4, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C5, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C6, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C7, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C8, w4)
        np.multiply(C9, w2, w5)
        np.add(w5, C10, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C11, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C12, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C13, w5)
        np.multiply(w5, w2, w2)
        np.add(w2, C2, w2)
        np.divide(w4, w2, w2)
        np.multiply(w3, w2, w2)
    if some54 != size:
        other54 = w3 if some54 else w2
        np.subtract(w0, w1, other54)
        if some54:
            np.copyto(w2, other54, where=~m0)
    np.multiply(v12, w2, w2)
    np.add(out, w2, w2)
    np.multiply(E_star, w2, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, E_star, w0, w1, w2, w3, w4, w5, w6, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.square(a, out)
    np.multiply(out, w0, out)
    np.square(R, w1)
    np.divide(a, R, w2)
    np.less(w0, C2, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(w0, f0, out=w3)
        np.multiply(w2, w2, w4)
        np.multiply(w2, w4, w4)
        np.multiply(w3, w3, w3)
        np.multiply(C3, w3, w5)
        np.add(w5, C4, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C5, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C6, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C7, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C8, w5)
        np.multiply(C9, w3, w6)
        np.add(w6, C10, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C11, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C12, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C13, w6)
        np.multiply(w6, w3, w3)
        np.add(w3, C2, w3)
        np.divide(w5, w3, w3)
        np.multiply(w4, w3, w3)
    if some54 != size:
        other54 = w4 if some54 else w3
        np.subtract(w0, w2, other54)
        if some54:
            np.copyto(w3, other54, where=~m0)
    np.multiply(w1, w3, w3)
    np.add(out, w3, w3)
    np.multiply(E_star, w3, out)


def force_from_depth(d, R, E_star):
    if d.__class__ is R.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
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


def block_mean_pressure_a(out, a, R, E_star, v14, w0, w1, w2, w3, w4, w5, w6, m0, m1, f0):
    size = out.size
    np.greater(a, C14, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some63 = np.count_nonzero(m0)
    if some63:
        np.multiply(C0, a, out)
        np.subtract(R, a, w0)
        np.divide(out, w0, w0)
        np.log1p(w0, w0)
        np.multiply(w0, C1, w0)
        np.square(a, out)
        np.multiply(out, w0, w1)
        np.divide(a, R, w2)
        np.less(w0, C2, m1)
        some56 = np.count_nonzero(m1)
        if some56:
            np.minimum(w0, f0, out=w3)
            np.multiply(w2, w2, w4)
            np.multiply(w2, w4, w4)
            np.multiply(w3, w3, w3)
            np.multiply(C3, w3, w5)
            np.add(w5, C4, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C5, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C6, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C7, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C8, w5)
            np.multiply(C9, w3, w6)
            np.add(w6, C10, w6)
            np.multiply(w6, w3, w6)
            np.add(w6, C11, w6)
            np.multiply(w6, w3, w6)
            np.add(w6, C12, w6)
            np.multiply(w6, w3, w6)
            np.add(w6, C13, w6)
            np.multiply(w6, w3, w3)
            np.add(w3, C2, w3)
            np.divide(w5, w3, w3)
            np.multiply(w4, w3, w3)
        if some56 != size:
            other56 = w4 if some56 else w3
            np.subtract(w0, w2, other56)
            if some56:
                np.copyto(w3, other56, where=~m1)
        np.multiply(v14, w3, w3)
        np.add(w1, w3, w3)
        np.multiply(E_star, w3, w3)
        np.multiply(C15, out, out)
        np.divide(w3, out, out)
    if some63 != size:
        np.copyto(out, C14, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, E_star, w0, w1, w2, w3, w4, w5, w6, w7, m0, m1, f0):
    size = out.size
    np.greater(a, C14, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some63 = np.count_nonzero(m0)
    if some63:
        np.multiply(C0, a, out)
        np.subtract(R, a, w0)
        np.divide(out, w0, w0)
        np.log1p(w0, w0)
        np.multiply(w0, C1, w0)
        np.square(a, out)
        np.multiply(out, w0, w1)
        np.square(R, w2)
        np.divide(a, R, w3)
        np.less(w0, C2, m1)
        some56 = np.count_nonzero(m1)
        if some56:
            np.minimum(w0, f0, out=w4)
            np.multiply(w3, w3, w5)
            np.multiply(w3, w5, w5)
            np.multiply(w4, w4, w4)
            np.multiply(C3, w4, w6)
            np.add(w6, C4, w6)
            np.multiply(w6, w4, w6)
            np.add(w6, C5, w6)
            np.multiply(w6, w4, w6)
            np.add(w6, C6, w6)
            np.multiply(w6, w4, w6)
            np.add(w6, C7, w6)
            np.multiply(w6, w4, w6)
            np.add(w6, C8, w6)
            np.multiply(C9, w4, w7)
            np.add(w7, C10, w7)
            np.multiply(w7, w4, w7)
            np.add(w7, C11, w7)
            np.multiply(w7, w4, w7)
            np.add(w7, C12, w7)
            np.multiply(w7, w4, w7)
            np.add(w7, C13, w7)
            np.multiply(w7, w4, w4)
            np.add(w4, C2, w4)
            np.divide(w6, w4, w4)
            np.multiply(w5, w4, w4)
        if some56 != size:
            other56 = w5 if some56 else w4
            np.subtract(w0, w3, other56)
            if some56:
                np.copyto(w4, other56, where=~m1)
        np.multiply(w2, w4, w4)
        np.add(w1, w4, w4)
        np.multiply(E_star, w4, w4)
        np.multiply(C15, out, out)
        np.divide(w4, out, out)
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


def block_pressure_r(out, r, a, R, v11, v17, v143, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, m0, m1, f0):
    size = out.size
    np.subtract(R, r, w0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w1)
    np.add(a, r, w2)
    np.maximum(w1, f0, out=w3)
    np.multiply(w3, w2, w3)
    np.sqrt(w3, w3)
    np.maximum(w0, f0, out=w4)
    np.add(R, r, w5)
    np.multiply(w4, w5, w5)
    np.sqrt(w5, w5)
    np.add(R, w5, w5)
    np.add(a, w3, w4)
    np.divide(w4, w5, w6)
    np.greater(w6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v143:
        np.less(r, a, m1)
        some142 = np.count_nonzero(m1)
        if some142:
            np.add(r, R, out)
            np.multiply(w0, out, out)
            np.sqrt(out, out)
            np.multiply(w1, w2, w7)
            np.sqrt(w7, w7)
            np.divide(w7, v11, w7)
            np.arcsinh(w7, w7)
            np.multiply(R, w7, w7)
            np.divide(w7, out, out)
            np.divide(r, w4, w7)
            np.multiply(r, w7, w7)
            np.divide(w7, w5, w7)
            np.multiply(w6, w6, w8)
            np.multiply(w7, w7, w9)
            np.multiply(C14, w9, w10)
            np.add(w10, C17, w10)
            np.multiply(C17, w8, w11)
            np.add(w11, C18, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C19, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C20, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C21, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C22, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C23, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C24, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C25, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C26, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C27, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C28, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C29, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C30, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C31, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C32, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C33, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w8, w11)
            np.add(w11, C34, w11)
            np.multiply(w10, w9, w9)
            np.add(w9, w11, w9)
            np.multiply(w11, w8, w8)
            np.add(w8, C2, w8)
            np.multiply(C0, w3, w11)
            np.divide(w11, w5, w11)
            np.add(w7, w6, w10)
            np.multiply(w7, w10, w10)
            np.multiply(w10, w9, w9)
            np.add(w8, w9, w9)
            np.multiply(w11, w9, w9)
            np.add(out, w9, w9)
            np.multiply(v17, w9, out)
        if some142 != size:
            np.copyto(out, C14, where=~m1)
    else:
        np.copyto(out, C35)


def prepare_pressure_r_a(R, E_star):
    v17 = E_star / (3.141592653589793)
    return (R, v17)


def block_pressure_r_a(out, r, a, R, v17, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, w0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w1)
    np.add(a, r, w2)
    np.maximum(w1, f0, out=w3)
    np.multiply(w3, w2, w3)
    np.sqrt(w3, w3)
    np.maximum(w0, f0, out=w4)
    np.add(R, r, w5)
    np.multiply(w4, w5, w5)
    np.sqrt(w5, w5)
    np.add(R, w5, w5)
    np.add(a, w3, w4)
    np.divide(w4, w5, w6)
    np.greater(w6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some145 = np.count_nonzero(m1)
    if some145:
        np.less(r, a, m2)
        some142 = np.count_nonzero(m2)
        if some142:
            np.add(r, R, out)
            np.multiply(w0, out, out)
            np.sqrt(out, out)
            np.subtract(R, a, w7)
            np.add(a, R, w8)
            np.multiply(w7, w8, w8)
            np.sqrt(w8, w8)
            np.multiply(w1, w2, w7)
            np.sqrt(w7, w7)
            np.divide(w7, w8, w8)
            np.arcsinh(w8, w8)
            np.multiply(R, w8, w8)
            np.divide(w8, out, out)
            np.divide(r, w4, w8)
            np.multiply(r, w8, w8)
            np.divide(w8, w5, w8)
            np.multiply(w6, w6, w7)
            np.multiply(w8, w8, w9)
            np.multiply(C14, w9, w10)
            np.add(w10, C17, w10)
            np.multiply(C17, w7, w11)
            np.add(w11, C18, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C19, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C20, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C21, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C22, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C23, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C24, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C25, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C26, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C27, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C28, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C29, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C30, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C31, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C32, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C33, w11)
            np.multiply(w10, w9, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C34, w11)
            np.multiply(w10, w9, w9)
            np.add(w9, w11, w9)
            np.multiply(w11, w7, w7)
            np.add(w7, C2, w7)
            np.multiply(C0, w3, w11)
            np.divide(w11, w5, w11)
            np.add(w8, w6, w10)
            np.multiply(w8, w10, w10)
            np.multiply(w10, w9, w9)
            np.add(w7, w9, w9)
            np.multiply(w11, w9, w9)
            np.add(out, w9, w9)
            np.multiply(v17, w9, out)
        if some142 != size:
            np.copyto(out, C14, where=~m2)
    if some145 != size:
        np.copyto(out, C35, where=~m1)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, R, E_star, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, w0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w1)
    np.add(a, r, w2)
    np.maximum(w1, f0, out=w3)
    np.multiply(w3, w2, w3)
    np.sqrt(w3, w3)
    np.maximum(w0, f0, out=w4)
    np.add(R, r, w5)
    np.multiply(w4, w5, w5)
    np.sqrt(w5, w5)
    np.add(R, w5, w5)
    np.add(a, w3, w4)
    np.divide(w4, w5, w6)
    np.greater(w6, C16, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some145 = np.count_nonzero(m1)
    if some145:
        np.less(r, a, m2)
        some142 = np.count_nonzero(m2)
        if some142:
            np.add(r, R, out)
            np.multiply(w0, out, out)
            np.sqrt(out, out)
            np.subtract(R, a, w7)
            np.add(a, R, w8)
            np.multiply(w7, w8, w8)
            np.sqrt(w8, w8)
            np.multiply(w1, w2, w7)
            np.sqrt(w7, w7)
            np.divide(E_star, C15, w9)
            np.divide(w7, w8, w8)
            np.arcsinh(w8, w8)
            np.multiply(R, w8, w8)
            np.divide(w8, out, out)
            np.divide(r, w4, w8)
            np.multiply(r, w8, w8)
            np.divide(w8, w5, w8)
            np.multiply(w6, w6, w7)
            np.multiply(w8, w8, w10)
            np.multiply(C14, w10, w11)
            np.add(w11, C17, w11)
            np.multiply(C17, w7, w12)
            np.add(w12, C18, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C19, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C20, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C21, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C22, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C23, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C24, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C25, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C26, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C27, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C28, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C29, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C30, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C31, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C32, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C33, w12)
            np.multiply(w11, w10, w11)
            np.add(w11, w12, w11)
            np.multiply(w12, w7, w12)
            np.add(w12, C34, w12)
            np.multiply(w11, w10, w10)
            np.add(w10, w12, w10)
            np.multiply(w12, w7, w7)
            np.add(w7, C2, w7)
            np.multiply(C0, w3, w12)
            np.divide(w12, w5, w12)
            np.add(w8, w6, w11)
            np.multiply(w8, w11, w11)
            np.multiply(w11, w10, w10)
            np.add(w7, w10, w10)
            np.multiply(w12, w10, w10)
            np.add(out, w10, w10)
            np.multiply(w9, w10, out)
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


def block_profile_r(out, r, R, w0):
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, R, w0)
    np.multiply(out, w0, w0)
    np.sqrt(w0, w0)
    np.square(r, out)
    np.add(w0, R, w0)
    np.divide(out, w0, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, w0):
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, R, w0)
    np.multiply(out, w0, w0)
    np.sqrt(w0, w0)
    np.square(r, out)
    np.add(w0, R, w0)
    np.divide(out, w0, out)


def radius_from_depth(d, R):
    if d.__class__ is R.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
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
        ('a',): Program(('a',), prepare_depth_a, block_depth_a, scratch=1),
        ('a', 'R'): Program(('a', 'R'), prepare_depth_all, block_depth_all, scratch=1),
    },
    ('_force', 1, 'a', 'R', 'E_star'): {
        ('a',): Program(('a',), prepare_force_a, block_force_a, scratch=6, masks=1, filled=(1.0,)),
        ('a', 'R', 'E_star'): Program(('a', 'R', 'E_star'), prepare_force_all, block_force_all, scratch=7, masks=1, filled=(1.0,)),
    },
    ('_mean_pressure', 1, 'a', 'R', 'E_star'): {
        ('a',): Program(('a',), prepare_mean_pressure_a, block_mean_pressure_a, scratch=7, masks=2, filled=(1.0,)),
        ('a', 'R', 'E_star'): Program(('a', 'R', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, scratch=8, masks=2, filled=(1.0,)),
    },
    ('_pressure', 2, 'r', 'a', 'R', 'E_star'): {
        ('r',): Program(('r',), prepare_pressure_r, block_pressure_r, scratch=12, masks=2, filled=(0.0,)),
        ('r', 'a'): Program(('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, scratch=12, masks=3, filled=(0.0,)),
        ('r', 'a', 'R', 'E_star'): Program(('r', 'a', 'R', 'E_star'), prepare_pressure_all, block_pressure_all, scratch=13, masks=3, filled=(0.0,)),
    },
    ('_profile', 1, 'r', 'R'): {
        ('r',): Program(('r',), prepare_profile_r, block_profile_r, scratch=1),
        ('r', 'R'): Program(('r', 'R'), prepare_profile_all, block_profile_all, scratch=1),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): Program(('a',), prepare_stiffness_a, block_stiffness_a),
        ('a', 'E_star'): Program(('a', 'E_star'), prepare_stiffness_all, block_stiffness_all),
    },
}
