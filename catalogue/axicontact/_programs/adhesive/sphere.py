"""Programs of axicontact.adhesive.sphere."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import sphere as bodies

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
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


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


def block_depth_a(out, a, R, v16, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(a, t0, t0)
    np.sqrt(a, out)
    np.multiply(out, v16, out)
    np.subtract(t0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, E_star, dgamma, t0, t1):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(a, t0, t0)
    np.sqrt(a, out)
    np.multiply(C2, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


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
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, E_star, dgamma):
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


def block_force_a(out, a, R, E_star, v13, v59, v65, t0, t1, t2, t3, t4, t5, m0, f0):
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
    np.less(t0, C3, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.minimum(t0, f0, out=t2)
        np.multiply(t1, t1, t3)
        np.multiply(t1, t3, t3)
        np.multiply(t2, t2, t2)
        np.multiply(C4, t2, t4)
        np.add(t4, C5, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C6, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C7, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C8, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C9, t4)
        np.multiply(C10, t2, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C13, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C14, t5)
        np.multiply(t5, t2, t2)
        np.add(t2, C3, t2)
        np.divide(t4, t2, t2)
        np.multiply(t3, t2, t2)
    if some55 != size:
        other55 = t3 if some55 else t2
        np.subtract(t0, t1, other55)
        if some55:
            np.copyto(t2, other55, where=~m0)
    np.multiply(v13, t2, t2)
    np.add(out, t2, t2)
    np.multiply(E_star, t2, t2)
    np.multiply(v59, a, out)
    np.sqrt(a, t1)
    np.multiply(t1, v65, t1)
    np.multiply(out, t1, t1)
    np.subtract(t2, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0, f0):
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
    np.less(t0, C3, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.minimum(t0, f0, out=t3)
        np.multiply(t2, t2, t4)
        np.multiply(t2, t4, t4)
        np.multiply(t3, t3, t3)
        np.multiply(C4, t3, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C9, t5)
        np.multiply(C10, t3, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t3, t3)
        np.add(t3, C3, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
    if some55 != size:
        other55 = t4 if some55 else t3
        np.subtract(t0, t2, other55)
        if some55:
            np.copyto(t3, other55, where=~m0)
    np.multiply(t1, t3, t3)
    np.add(out, t3, t3)
    np.multiply(E_star, t3, t3)
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)
    np.sqrt(a, t1)
    np.multiply(C2, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(t1, t2, t2)
    np.multiply(out, t2, t2)
    np.subtract(t3, t2, out)


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


def block_pressure_r(out, r, a, R, v12, v18, v144, v153, v154, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t0)
    np.add(a, r, t1)
    np.maximum(t0, f0, out=t2)
    np.multiply(t2, t1, t2)
    np.sqrt(t2, t2)
    np.maximum(out, f0, out=t3)
    np.add(R, r, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.add(R, t4, t4)
    np.add(a, t2, t3)
    np.divide(t3, t4, t5)
    np.greater(t5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v144:
        np.less(r, a, m1)
        some143 = np.count_nonzero(m1)
        if some143:
            np.add(r, R, t6)
            np.multiply(out, t6, t6)
            np.sqrt(t6, t6)
            np.multiply(t0, t1, t7)
            np.sqrt(t7, t7)
            np.divide(t7, v12, t7)
            np.arcsinh(t7, t7)
            np.multiply(R, t7, t7)
            np.divide(t7, t6, t6)
            np.divide(r, t3, t7)
            np.multiply(r, t7, t7)
            np.divide(t7, t4, t7)
            np.multiply(t5, t5, t8)
            np.multiply(t7, t7, t9)
            np.multiply(C16, t9, t10)
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
            np.add(t8, C3, t8)
            np.multiply(C0, t2, t11)
            np.divide(t11, t4, t11)
            np.add(t7, t5, t10)
            np.multiply(t7, t10, t10)
            np.multiply(t10, t9, t9)
            np.add(t8, t9, t9)
            np.multiply(t11, t9, t9)
            np.add(t6, t9, t9)
            np.multiply(v18, t9, t6)
        if some143 != size:
            np.copyto(t6, C16, where=~m1)
    else:
        np.copyto(t6, C35)
    np.less_equal(r, a, m1)
    some159 = np.count_nonzero(m1)
    if some159:
        if v153:
            np.multiply(C36, t2, t5)
            np.divide(v154, t5, t5)
        else:
            np.copyto(t5, C16)
    if some159 != size:
        np.copyto(t5, C16, where=~m1)
    np.subtract(t6, t5, out)


def prepare_pressure_r_a(R, E_star, dgamma):
    v18 = E_star / (3.141592653589793)
    v149 = (6.283185307179586) * dgamma
    v150 = v149 / E_star
    v151 = np.sqrt(v150)
    return (R, E_star, v18, v151)


def block_pressure_r_a(out, r, a, R, E_star, v18, v151, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t0)
    np.add(a, r, t1)
    np.maximum(t0, f0, out=t2)
    np.multiply(t2, t1, t2)
    np.sqrt(t2, t2)
    np.maximum(out, f0, out=t3)
    np.add(R, r, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.add(R, t4, t4)
    np.add(a, t2, t3)
    np.divide(t3, t4, t5)
    np.greater(t5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some146 = np.count_nonzero(m1)
    if some146:
        np.less(r, a, m2)
        some143 = np.count_nonzero(m2)
        if some143:
            np.add(r, R, t6)
            np.multiply(out, t6, t6)
            np.sqrt(t6, t6)
            np.subtract(R, a, t7)
            np.add(a, R, t8)
            np.multiply(t7, t8, t8)
            np.sqrt(t8, t8)
            np.multiply(t0, t1, t7)
            np.sqrt(t7, t7)
            np.divide(t7, t8, t8)
            np.arcsinh(t8, t8)
            np.multiply(R, t8, t8)
            np.divide(t8, t6, t6)
            np.divide(r, t3, t8)
            np.multiply(r, t8, t8)
            np.divide(t8, t4, t8)
            np.multiply(t5, t5, t7)
            np.multiply(t8, t8, t9)
            np.multiply(C16, t9, t10)
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
            np.add(t7, C3, t7)
            np.multiply(C0, t2, t11)
            np.divide(t11, t4, t11)
            np.add(t8, t5, t10)
            np.multiply(t8, t10, t10)
            np.multiply(t10, t9, t9)
            np.add(t7, t9, t9)
            np.multiply(t11, t9, t9)
            np.add(t6, t9, t9)
            np.multiply(v18, t9, t6)
        if some143 != size:
            np.copyto(t6, C16, where=~m2)
    if some146 != size:
        np.copyto(t6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some159 = np.count_nonzero(m1)
    if some159:
        np.sqrt(a, t3)
        np.multiply(t3, v151, t3)
        np.greater(t3, C16, m2)
        some157 = np.count_nonzero(m2)
        if some157:
            np.multiply(E_star, t3, t5)
            np.multiply(C36, t2, t4)
            np.divide(t5, t4, t5)
        if some157 != size:
            np.copyto(t5, C16, where=~m2)
    if some159 != size:
        np.copyto(t5, C16, where=~m1)
    np.subtract(t6, t5, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, R, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, m0, m1, m2, f0):
    size = out.size
    np.subtract(R, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t0)
    np.add(a, r, t1)
    np.maximum(t0, f0, out=t2)
    np.multiply(t2, t1, t2)
    np.sqrt(t2, t2)
    np.maximum(out, f0, out=t3)
    np.add(R, r, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.add(R, t4, t4)
    np.add(a, t2, t3)
    np.divide(t3, t4, t5)
    np.greater(t5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, R, m1)
    some146 = np.count_nonzero(m1)
    if some146:
        np.less(r, a, m2)
        some143 = np.count_nonzero(m2)
        if some143:
            np.add(r, R, t6)
            np.multiply(out, t6, t6)
            np.sqrt(t6, t6)
            np.subtract(R, a, t7)
            np.add(a, R, t8)
            np.multiply(t7, t8, t8)
            np.sqrt(t8, t8)
            np.multiply(t0, t1, t7)
            np.sqrt(t7, t7)
            np.divide(E_star, C36, t9)
            np.divide(t7, t8, t8)
            np.arcsinh(t8, t8)
            np.multiply(R, t8, t8)
            np.divide(t8, t6, t6)
            np.divide(r, t3, t8)
            np.multiply(r, t8, t8)
            np.divide(t8, t4, t8)
            np.multiply(t5, t5, t7)
            np.multiply(t8, t8, t10)
            np.multiply(C16, t10, t11)
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
            np.add(t7, C3, t7)
            np.multiply(C0, t2, t12)
            np.divide(t12, t4, t12)
            np.add(t8, t5, t11)
            np.multiply(t8, t11, t11)
            np.multiply(t11, t10, t10)
            np.add(t7, t10, t10)
            np.multiply(t12, t10, t10)
            np.add(t6, t10, t10)
            np.multiply(t9, t10, t6)
        if some143 != size:
            np.copyto(t6, C16, where=~m2)
    if some146 != size:
        np.copyto(t6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some159 = np.count_nonzero(m1)
    if some159:
        np.sqrt(a, t3)
        np.multiply(C2, dgamma, t4)
        np.divide(t4, E_star, t4)
        np.sqrt(t4, t4)
        np.multiply(t3, t4, t4)
        np.greater(t4, C16, m2)
        some157 = np.count_nonzero(m2)
        if some157:
            np.multiply(E_star, t4, t5)
            np.multiply(C36, t2, t3)
            np.divide(t5, t3, t5)
        if some157 != size:
            np.copyto(t5, C16, where=~m2)
    if some159 != size:
        np.copyto(t5, C16, where=~m1)
    np.subtract(t6, t5, out)


def pull_off_radius(R, E_star, dgamma, control):
    if R.__class__ is E_star.__class__ is dgamma.__class__ is float and R > 1e-30 and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(R, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, E_star, dgamma):
    if d.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, E_star, dgamma):
    if F.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, R, E_star):
    if F.__class__ is R.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, R, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'R', 'E_star', 'dgamma'): (('a', 'R', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_force', 1, 'a', 'R', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 6, 1, (1.0,), False),
        ('a', 'R', 'E_star', 'dgamma'): (('a', 'R', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 7, 1, (1.0,), False),
    },
    ('_pressure', 2, 'r', 'a', 'R', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 12, 2, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 12, 3, (0.0,), False),
        ('r', 'a', 'R', 'E_star', 'dgamma'): (('r', 'a', 'R', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, 13, 3, (0.0,), False),
    },
}
