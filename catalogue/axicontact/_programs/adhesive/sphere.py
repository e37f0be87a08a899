"""Programs of axicontact.adhesive.sphere."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, log1p, nan, sqrt

import numpy as np

from ..._runtime.arrays.blocks import Program, largest
from ..._runtime.plain import rule

C0 = np.array(2.0)
C1 = np.array(0.5)
C2 = np.array(6.283185307179586)
C3 = np.array(1.0)
C4 = np.array(1.0716932453474512e-06)
C5 = np.array(0.00019982814521087247)
C6 = np.array(0.007076196047699156)
C7 = np.array(0.08608622548411103)
C8 = np.array(0.3073858328214721)
C9 = np.array(0.3333333333333333)
C10 = np.array(2.565078604208634e-08)
C11 = np.array(2.0203143566039827e-05)
C12 = np.array(0.001617010334189783)
C13 = np.array(0.03639274880225476)
C14 = np.array(0.32215749846441627)
C15 = np.array(0.7)
C16 = np.array(0.0)
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
C36 = np.array(3.141592653589793)
RULE_0 = rule(((0.4097463988641303, 8), (1.7123381635707111, 16), (3.012135102255693, 24), (4.256467450182103, 32), (9.015036632031958, 64)))


def depth(a, R, E_star, dgamma):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return a * (log1p(2.0 * a / (R - a)) / 2.0) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, E_star, dgamma):
    v14 = (6.283185307179586) * dgamma
    v15 = v14 / E_star
    v16 = np.sqrt(v15)
    return (R, v16)


def block_depth_a(out, a, R, v16, w0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.multiply(a, w0, w0)
    np.sqrt(a, out)
    np.multiply(out, v16, out)
    np.subtract(w0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, E_star, dgamma, w0, w1):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.multiply(a, w0, w0)
    np.sqrt(a, out)
    np.multiply(C2, dgamma, w1)
    np.divide(w1, E_star, w1)
    np.sqrt(w1, w1)
    np.multiply(out, w1, w1)
    np.subtract(w0, w1, out)


def displacement(r, a, R, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v84 = r > a
            if a <= R:
                v41 = r + R
                v49 = R - r
                if v84:
                    v5 = r if r < R or r != r else R
                    if a < v5:
                        v6 = v5 - a
                        v12 = a / sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (v5 + a))
                        v13 = asinh(v12)
                        v18 = 0.0 - expm1(-2.0 * v13)
                        v21 = v18 if v18 > 0.0 else inf
                        v39 = r - R
                        v43 = sqrt((v39 if v39 > 0.0 or v39 != v39 else 0.0) * v41)
                        v45 = v43 * v43
                        v53 = sqrt((v49 if v49 > 0.0 or v49 != v49 else 0.0) * (R + r))
                        v54 = v53 * v53
                        v67 = []
                        for node, weight in RULE_0(v13 / 1.0):
                            v23 = node * v13
                            v32 = v12 * (exp(-v23) * (0.0 - expm1(-2.0 * (v13 - v23))) / v21)
                            v35 = sqrt(1.0 + v32 * v32)
                            v37 = v5 * (v32 / v35)
                            v38 = v5 / v35
                            v46 = v38 * v38
                            v56 = sqrt(v54 + v46)
                            v66 = (asinh(v37 / v56) + R * v37 / (v56 * v56)) * atan2(v37, sqrt(v45 + v46)) * (v38 / v35)
                            v67.append(weight * v66)
                        v67 = fsum(v67) * v13
                        v68 = v67
                    else:
                        v68 = inf
                    v85 = 0.6366197723675814 * v68
                else:
                    v85 = a * (log1p(2.0 * a / (R - a)) / 2.0) - r * r / (sqrt(v49 * v41) + R)
                v87 = v85
            else:
                v87 = nan
            if v84:
                v88 = r - a
                v95 = 0.6366197723675814 * atan2(a, sqrt((v88 if v88 > 0.0 or v88 != v88 else 0.0) * (r + a)))
            else:
                v95 = 1.0
            value = v87 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * v95
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, E_star, dgamma):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v9 = log1p(2.0 * a / (R - a)) / 2.0
            v13 = a / R
            if v9 < 1.0:
                v19 = v9 * v9
                v54 = v13 * (v13 * v13) * ((((((1.0716932453474512e-06 * v19 + 0.00019982814521087247) * v19 + 0.007076196047699156) * v19 + 0.08608622548411103) * v19 + 0.3073858328214721) * v19 + 0.3333333333333333) / (((((2.565078604208634e-08 * v19 + 2.0203143566039827e-05) * v19 + 0.001617010334189783) * v19 + 0.03639274880225476) * v19 + 0.32215749846441627) * v19 + 1.0))
            else:
                v54 = v9 - v13
            value = E_star * (a * a * v9 + R * R * v54) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, E_star, dgamma):
    v13 = np.square(R)
    v59 = (2.0) * E_star
    v63 = (6.283185307179586) * dgamma
    v64 = v63 / E_star
    v65 = np.sqrt(v64)
    return (R, E_star, v13, v59, v65)


def block_force_a(out, a, R, E_star, v13, v59, v65, w0, w1, w2, w3, w4, w5, m0, f0):
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
    np.less(w0, C3, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.minimum(w0, f0, out=w2)
        np.multiply(w1, w1, w3)
        np.multiply(w1, w3, w3)
        np.multiply(w2, w2, w2)
        np.multiply(C4, w2, w4)
        np.add(w4, C5, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C6, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C7, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C8, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C9, w4)
        np.multiply(C10, w2, w5)
        np.add(w5, C11, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C12, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C13, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C14, w5)
        np.multiply(w5, w2, w2)
        np.add(w2, C3, w2)
        np.divide(w4, w2, w2)
        np.multiply(w3, w2, w2)
    if some55 != size:
        other55 = w3 if some55 else w2
        np.subtract(w0, w1, other55)
        if some55:
            np.copyto(w2, other55, where=~m0)
    np.multiply(v13, w2, w2)
    np.add(out, w2, w2)
    np.multiply(E_star, w2, w2)
    np.multiply(v59, a, out)
    np.sqrt(a, w1)
    np.multiply(w1, v65, w1)
    np.multiply(out, w1, w1)
    np.subtract(w2, w1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, E_star, dgamma, w0, w1, w2, w3, w4, w5, w6, m0, f0):
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
    np.less(w0, C3, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.minimum(w0, f0, out=w3)
        np.multiply(w2, w2, w4)
        np.multiply(w2, w4, w4)
        np.multiply(w3, w3, w3)
        np.multiply(C4, w3, w5)
        np.add(w5, C5, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C6, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C7, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C8, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C9, w5)
        np.multiply(C10, w3, w6)
        np.add(w6, C11, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C12, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C13, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C14, w6)
        np.multiply(w6, w3, w3)
        np.add(w3, C3, w3)
        np.divide(w5, w3, w3)
        np.multiply(w4, w3, w3)
    if some55 != size:
        other55 = w4 if some55 else w3
        np.subtract(w0, w2, other55)
        if some55:
            np.copyto(w3, other55, where=~m0)
    np.multiply(w1, w3, w3)
    np.add(out, w3, w3)
    np.multiply(E_star, w3, w3)
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)
    np.sqrt(a, w1)
    np.multiply(C2, dgamma, w2)
    np.divide(w2, E_star, w2)
    np.sqrt(w2, w2)
    np.multiply(w1, w2, w2)
    np.multiply(out, w2, w2)
    np.subtract(w3, w2, out)


def pressure(r, a, R, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v5 = R - r
            v13 = a - r
            v14 = a + r
            v26 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v14)
            v31 = R + sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (R + r))
            v32 = a + v26
            v33 = v32 / v31
            if a <= R:
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
                    v143 = E_star / 3.141592653589793 * (R * asinh(sqrt(v13 * v14) / sqrt((R - a) * (a + R))) / sqrt(v5 * (r + R)) + 2.0 * v26 / v31 * (v124 * v37 + 1.0 + v36 * (v36 + v33) * ((((((v100 + v99) * v38 + v104) * v38 + v109) * v38 + v114) * v38 + v119) * v38 + v124)))
                else:
                    v143 = 0.0
                v146 = v143
            else:
                v146 = nan
            if r <= a:
                v152 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v159 = E_star * v152 / (3.141592653589793 * v26) if v152 > 0.0 else 0.0
            else:
                v159 = 0.0
            if v33 > 0.7:
                return None
            value = v146 - v159
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, R, E_star, dgamma):
    v9 = R - a
    v10 = a + R
    v11 = v9 * v10
    v12 = np.sqrt(v11)
    v18 = E_star / (3.141592653589793)
    v144 = np.less_equal(a, R)
    v147 = np.sqrt(a)
    v149 = (6.283185307179586) * dgamma
    v150 = v149 / E_star
    v151 = np.sqrt(v150)
    v152 = v147 * v151
    v153 = np.greater(v152, (0.0))
    v154 = E_star * v152
    return (a, R, v12, v18, v144, v153, v154)


def block_pressure_r(out, r, a, R, v12, v18, v144, v153, v154, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, m0, m1, f0):
    size = out.size
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w0)
    np.add(a, r, w1)
    np.maximum(w0, f0, out=w2)
    np.multiply(w2, w1, w2)
    np.sqrt(w2, w2)
    np.maximum(out, f0, out=w3)
    np.add(R, r, w4)
    np.multiply(w3, w4, w4)
    np.sqrt(w4, w4)
    np.add(R, w4, w4)
    np.add(a, w2, w3)
    np.divide(w3, w4, w5)
    np.greater(w5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v144:
        np.less(r, a, m1)
        some143 = np.count_nonzero(m1)
        if some143:
            np.add(r, R, w6)
            np.multiply(out, w6, w6)
            np.sqrt(w6, w6)
            np.multiply(w0, w1, w7)
            np.sqrt(w7, w7)
            np.divide(w7, v12, w7)
            np.arcsinh(w7, w7)
            np.multiply(R, w7, w7)
            np.divide(w7, w6, w6)
            np.divide(r, w3, w7)
            np.multiply(r, w7, w7)
            np.divide(w7, w4, w7)
            np.multiply(w5, w5, w8)
            np.multiply(w7, w7, w9)
            np.multiply(C16, w9, w10)
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
            np.add(w8, C3, w8)
            np.multiply(C0, w2, w11)
            np.divide(w11, w4, w11)
            np.add(w7, w5, w10)
            np.multiply(w7, w10, w10)
            np.multiply(w10, w9, w9)
            np.add(w8, w9, w9)
            np.multiply(w11, w9, w9)
            np.add(w6, w9, w9)
            np.multiply(v18, w9, w6)
        if some143 != size:
            np.copyto(w6, C16, where=~m1)
    else:
        np.copyto(w6, C35)
    np.less_equal(r, a, m1)
    some159 = np.count_nonzero(m1)
    if some159:
        if v153:
            np.multiply(C36, w2, w5)
            np.divide(v154, w5, w5)
        else:
            np.copyto(w5, C16)
    if some159 != size:
        np.copyto(w5, C16, where=~m1)
    np.subtract(w6, w5, out)


def prepare_pressure_r_a(R, E_star, dgamma):
    v18 = E_star / (3.141592653589793)
    v149 = (6.283185307179586) * dgamma
    v150 = v149 / E_star
    v151 = np.sqrt(v150)
    return (R, E_star, v18, v151)


def block_pressure_r_a(out, r, a, R, E_star, v18, v151, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w0)
    np.add(a, r, w1)
    np.maximum(w0, f0, out=w2)
    np.multiply(w2, w1, w2)
    np.sqrt(w2, w2)
    np.maximum(out, f0, out=w3)
    np.add(R, r, w4)
    np.multiply(w3, w4, w4)
    np.sqrt(w4, w4)
    np.add(R, w4, w4)
    np.add(a, w2, w3)
    np.divide(w3, w4, w5)
    np.greater(w5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some146 = np.count_nonzero(m1)
    if some146:
        np.less(r, a, m2)
        some143 = np.count_nonzero(m2)
        if some143:
            np.add(r, R, w6)
            np.multiply(out, w6, w6)
            np.sqrt(w6, w6)
            np.subtract(R, a, w7)
            np.add(a, R, w8)
            np.multiply(w7, w8, w8)
            np.sqrt(w8, w8)
            np.multiply(w0, w1, w7)
            np.sqrt(w7, w7)
            np.divide(w7, w8, w8)
            np.arcsinh(w8, w8)
            np.multiply(R, w8, w8)
            np.divide(w8, w6, w6)
            np.divide(r, w3, w8)
            np.multiply(r, w8, w8)
            np.divide(w8, w4, w8)
            np.multiply(w5, w5, w7)
            np.multiply(w8, w8, w9)
            np.multiply(C16, w9, w10)
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
            np.add(w7, C3, w7)
            np.multiply(C0, w2, w11)
            np.divide(w11, w4, w11)
            np.add(w8, w5, w10)
            np.multiply(w8, w10, w10)
            np.multiply(w10, w9, w9)
            np.add(w7, w9, w9)
            np.multiply(w11, w9, w9)
            np.add(w6, w9, w9)
            np.multiply(v18, w9, w6)
        if some143 != size:
            np.copyto(w6, C16, where=~m2)
    if some146 != size:
        np.copyto(w6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some159 = np.count_nonzero(m1)
    if some159:
        np.sqrt(a, w3)
        np.multiply(w3, v151, w3)
        np.greater(w3, C16, m2)
        some157 = np.count_nonzero(m2)
        if some157:
            np.multiply(E_star, w3, w5)
            np.multiply(C36, w2, w4)
            np.divide(w5, w4, w5)
        if some157 != size:
            np.copyto(w5, C16, where=~m2)
    if some159 != size:
        np.copyto(w5, C16, where=~m1)
    np.subtract(w6, w5, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, R, E_star, dgamma, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w0)
    np.add(a, r, w1)
    np.maximum(w0, f0, out=w2)
    np.multiply(w2, w1, w2)
    np.sqrt(w2, w2)
    np.maximum(out, f0, out=w3)
    np.add(R, r, w4)
    np.multiply(w3, w4, w4)
    np.sqrt(w4, w4)
    np.add(R, w4, w4)
    np.add(a, w2, w3)
    np.divide(w3, w4, w5)
    np.greater(w5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some146 = np.count_nonzero(m1)
    if some146:
        np.less(r, a, m2)
        some143 = np.count_nonzero(m2)
        if some143:
            np.add(r, R, w6)
            np.multiply(out, w6, w6)
            np.sqrt(w6, w6)
            np.subtract(R, a, w7)
            np.add(a, R, w8)
            np.multiply(w7, w8, w8)
            np.sqrt(w8, w8)
            np.multiply(w0, w1, w7)
            np.sqrt(w7, w7)
            np.divide(E_star, C36, w9)
            np.divide(w7, w8, w8)
            np.arcsinh(w8, w8)
            np.multiply(R, w8, w8)
            np.divide(w8, w6, w6)
            np.divide(r, w3, w8)
            np.multiply(r, w8, w8)
            np.divide(w8, w4, w8)
            np.multiply(w5, w5, w7)
            np.multiply(w8, w8, w10)
            np.multiply(C16, w10, w11)
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
            np.add(w7, C3, w7)
            np.multiply(C0, w2, w12)
            np.divide(w12, w4, w12)
            np.add(w8, w5, w11)
            np.multiply(w8, w11, w11)
            np.multiply(w11, w10, w10)
            np.add(w7, w10, w10)
            np.multiply(w12, w10, w10)
            np.add(w6, w10, w10)
            np.multiply(w9, w10, w6)
        if some143 != size:
            np.copyto(w6, C16, where=~m2)
    if some146 != size:
        np.copyto(w6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some159 = np.count_nonzero(m1)
    if some159:
        np.sqrt(a, w3)
        np.multiply(C2, dgamma, w4)
        np.divide(w4, E_star, w4)
        np.sqrt(w4, w4)
        np.multiply(w3, w4, w4)
        np.greater(w4, C16, m2)
        some157 = np.count_nonzero(m2)
        if some157:
            np.multiply(E_star, w4, w5)
            np.multiply(C36, w2, w3)
            np.divide(w5, w3, w5)
        if some157 != size:
            np.copyto(w5, C16, where=~m2)
    if some159 != size:
        np.copyto(w5, C16, where=~m1)
    np.subtract(w6, w5, out)


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'E_star', 'dgamma'): {
        ('a',): Program(('a',), prepare_depth_a, block_depth_a, scratch=1),
        ('a', 'R', 'E_star', 'dgamma'): Program(('a', 'R', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, scratch=2),
    },
    ('_force', 1, 'a', 'R', 'E_star', 'dgamma'): {
        ('a',): Program(('a',), prepare_force_a, block_force_a, scratch=6, masks=1, filled=(1.0,)),
        ('a', 'R', 'E_star', 'dgamma'): Program(('a', 'R', 'E_star', 'dgamma'), prepare_force_all, block_force_all, scratch=7, masks=1, filled=(1.0,)),
    },
    ('_pressure', 2, 'r', 'a', 'R', 'E_star', 'dgamma'): {
        ('r',): Program(('r',), prepare_pressure_r, block_pressure_r, scratch=12, masks=2, filled=(0.0,)),
        ('r', 'a'): Program(('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, scratch=12, masks=3, filled=(0.0,)),
        ('r', 'a', 'R', 'E_star', 'dgamma'): Program(('r', 'a', 'R', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, scratch=13, masks=3, filled=(0.0,)),
    },
}
