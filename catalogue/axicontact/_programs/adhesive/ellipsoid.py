"""Programs of axicontact.adhesive.ellipsoid."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import ellipsoid as bodies

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


def depth(a, h, b, E_star, dgamma):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return h / b * a * (log1p(2.0 * a / (b - a)) / 2.0) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(h, b, E_star, dgamma):
    v12 = h / b
    v17 = (6.283185307179586) * dgamma
    v18 = v17 / E_star
    v19 = np.sqrt(v18)
    return (b, v12, v19)


def block_depth_a(out, a, b, v12, v19, t0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(v12, a, out)
    np.multiply(out, t0, t0)
    np.sqrt(a, out)
    np.multiply(out, v19, out)
    np.subtract(t0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, h, b, E_star, dgamma, t0, t1):
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
    np.multiply(out, t0, t0)
    np.sqrt(a, out)
    np.multiply(C2, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def displacement(r, a, h, b, E_star, dgamma):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v94 = r > a
            if a <= b:
                v60 = h / b
                if v94:
                    v6 = r if r < b or r != r else b
                    if a < v6:
                        v7 = v6 - a
                        v13 = a / sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (v6 + a))
                        v14 = asinh(v13)
                        v19 = 0.0 - expm1(-2.0 * v14)
                        v22 = v19 if v19 > 0.0 else inf
                        v40 = r - b
                        v44 = sqrt((v40 if v40 > 0.0 or v40 != v40 else 0.0) * (r + b))
                        v46 = v44 * v44
                        v50 = b - r
                        v54 = sqrt((v50 if v50 > 0.0 or v50 != v50 else 0.0) * (b + r))
                        v55 = v54 * v54
                        v70 = []
                        for node, weight in RULE_0(v14 / 1.0):
                            v24 = node * v14
                            v33 = v13 * (exp(-v24) * (0.0 - expm1(-2.0 * (v14 - v24))) / v22)
                            v36 = sqrt(1.0 + v33 * v33)
                            v38 = v6 * (v33 / v36)
                            v39 = v6 / v36
                            v47 = v39 * v39
                            v57 = sqrt(v55 + v47)
                            v69 = (v60 * asinh(v38 / v57) + h * v38 / (v57 * v57)) * atan2(v38, sqrt(v46 + v47)) * (v39 / v36)
                            v70.append(weight * v69)
                        v70 = fsum(v70) * v14
                        v71 = v70
                    else:
                        v71 = inf
                    v95 = 0.6366197723675814 * v71
                else:
                    v81 = r / b
                    v95 = v60 * a * (log1p(2.0 * a / (b - a)) / 2.0) - h * (r * r) / (b * b * (sqrt((1.0 - v81) * (v81 + 1.0)) + 1.0))
                v97 = v95
            else:
                v97 = nan
            if v94:
                v98 = r - a
                v105 = 0.6366197723675814 * atan2(a, sqrt((v98 if v98 > 0.0 or v98 != v98 else 0.0) * (r + a)))
            else:
                v105 = 1.0
            value = v97 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * v105
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, h, b, E_star, dgamma):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v10 = log1p(2.0 * a / (b - a)) / 2.0
            v15 = a / b
            if v10 < 1.0:
                v21 = v10 * v10
                v56 = v15 * (v15 * v15) * ((((((1.0716932453474512e-06 * v21 + 0.00019982814521087247) * v21 + 0.007076196047699156) * v21 + 0.08608622548411103) * v21 + 0.3073858328214721) * v21 + 0.3333333333333333) / (((((2.565078604208634e-08 * v21 + 2.0203143566039827e-05) * v21 + 0.001617010334189783) * v21 + 0.03639274880225476) * v21 + 0.32215749846441627) * v21 + 1.0))
            else:
                v56 = v10 - v15
            value = E_star * h * (a * a * v10 / b + b * v56) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(h, b, E_star, dgamma):
    v12 = E_star * h
    v61 = (2.0) * E_star
    v65 = (6.283185307179586) * dgamma
    v66 = v65 / E_star
    v67 = np.sqrt(v66)
    return (b, v12, v61, v67)


def block_force_a(out, a, b, v12, v61, v67, t0, t1, t2, t3, t4, t5, m0, f0):
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
    np.less(t0, C3, m0)
    some57 = np.count_nonzero(m0)
    if some57:
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
    if some57 != size:
        other57 = t3 if some57 else t2
        np.subtract(t0, t1, other57)
        if some57:
            np.copyto(t2, other57, where=~m0)
    np.multiply(b, t2, t2)
    np.add(out, t2, t2)
    np.multiply(v12, t2, t2)
    np.multiply(v61, a, out)
    np.sqrt(a, t1)
    np.multiply(t1, v67, t1)
    np.multiply(out, t1, t1)
    np.subtract(t2, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, h, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0, f0):
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
    np.less(t0, C3, m0)
    some57 = np.count_nonzero(m0)
    if some57:
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
    if some57 != size:
        other57 = t4 if some57 else t3
        np.subtract(t0, t2, other57)
        if some57:
            np.copyto(t3, other57, where=~m0)
    np.multiply(b, t3, t3)
    np.add(t1, t3, t3)
    np.multiply(out, t3, t3)
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)
    np.sqrt(a, t1)
    np.multiply(C2, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(t1, t2, t2)
    np.multiply(out, t2, t2)
    np.subtract(t3, t2, out)


def pressure(r, a, h, b, E_star, dgamma):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = b - r
            v10 = a - r
            v11 = a + r
            v27 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * v11)
            v32 = b + sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (b + r))
            v33 = a + v27
            v34 = v33 / v32
            if a <= b:
                if r < a:
                    v37 = r * (r / v33) / v32
                    v38 = v34 * v34
                    v39 = v37 * v37
                    v45 = 0.13579013365982337 * v38 + -0.4846453962188766
                    v50 = v45 * v38 + 0.8293825948837366
                    v55 = v50 * v38 + -0.8745573865774817
                    v60 = v55 * v38 + 0.6371928816963097
                    v65 = v60 * v38 + -0.3332798652335896
                    v70 = v65 * v38 + 0.13289328569967984
                    v75 = v70 * v38 + -0.03710676078458442
                    v80 = v75 * v38 + 0.011089560042611895
                    v85 = v80 * v38 + 0.0012521687336059639
                    v90 = v85 * v38 + 0.0036572276005780893
                    v95 = v90 * v38 + 0.004425450516633092
                    v100 = v95 * v38 + 0.005918487051520244
                    v101 = ((((((((((((0.0 * v39 + 0.13579013365982337) * v39 + v45) * v39 + v50) * v39 + v55) * v39 + v60) * v39 + v65) * v39 + v70) * v39 + v75) * v39 + v80) * v39 + v85) * v39 + v90) * v39 + v95) * v39
                    v105 = v100 * v38 + 0.008264397984935742
                    v110 = v105 * v38 + 0.012345681107818056
                    v115 = v110 * v38 + 0.020408163224119494
                    v120 = v115 * v38 + 0.04000000000042643
                    v125 = v120 * v38 + 0.11111111111110937
                    v145 = E_star * h / 3.141592653589793 * (asinh(sqrt(v10 * v11) / sqrt((b - a) * (a + b))) / sqrt(v6 * (r + b)) + 2.0 * v27 / v32 * (v125 * v38 + 1.0 + v37 * (v37 + v34) * ((((((v101 + v100) * v39 + v105) * v39 + v110) * v39 + v115) * v39 + v120) * v39 + v125)) / b)
                else:
                    v145 = 0.0
                v148 = v145
            else:
                v148 = nan
            if r <= a:
                v154 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v161 = E_star * v154 / (3.141592653589793 * v27) if v154 > 0.0 else 0.0
            else:
                v161 = 0.0
            if v34 > 0.7:
                return None
            value = v148 - v161
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, h, b, E_star, dgamma):
    v14 = b - a
    v15 = a + b
    v16 = v14 * v15
    v17 = np.sqrt(v16)
    v18 = E_star * h
    v20 = v18 / (3.141592653589793)
    v146 = np.less_equal(a, b)
    v149 = np.sqrt(a)
    v151 = (6.283185307179586) * dgamma
    v152 = v151 / E_star
    v153 = np.sqrt(v152)
    v154 = v149 * v153
    v155 = np.greater(v154, (0.0))
    v156 = E_star * v154
    return (a, b, v17, v20, v146, v155, v156)


def block_pressure_r(out, r, a, b, v17, v20, v146, v155, v156, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.subtract(b, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, t0)
    np.add(a, r, t1)
    np.maximum(t0, f0, out=t2)
    np.multiply(t2, t1, t2)
    np.sqrt(t2, t2)
    np.maximum(out, f0, out=t3)
    np.add(b, r, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.add(b, t4, t4)
    np.add(a, t2, t3)
    np.divide(t3, t4, t5)
    np.greater(t5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v146:
        np.less(r, a, m1)
        some145 = np.count_nonzero(m1)
        if some145:
            np.add(r, b, t6)
            np.multiply(out, t6, t6)
            np.sqrt(t6, t6)
            np.multiply(t0, t1, t7)
            np.sqrt(t7, t7)
            np.divide(t7, v17, t7)
            np.arcsinh(t7, t7)
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
            np.divide(t9, b, t9)
            np.add(t6, t9, t9)
            np.multiply(v20, t9, t6)
        if some145 != size:
            np.copyto(t6, C16, where=~m1)
    else:
        np.copyto(t6, C35)
    np.less_equal(r, a, m1)
    some161 = np.count_nonzero(m1)
    if some161:
        if v155:
            np.multiply(C36, t2, t5)
            np.divide(v156, t5, t5)
        else:
            np.copyto(t5, C16)
    if some161 != size:
        np.copyto(t5, C16, where=~m1)
    np.subtract(t6, t5, out)


def prepare_pressure_r_a(h, b, E_star, dgamma):
    v18 = E_star * h
    v20 = v18 / (3.141592653589793)
    v151 = (6.283185307179586) * dgamma
    v152 = v151 / E_star
    v153 = np.sqrt(v152)
    return (b, E_star, v20, v153)


def block_pressure_r_a(out, r, a, b, E_star, v20, v153, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, m2, f0):
    size = out.size
    np.subtract(b, r, out)
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
    np.add(b, r, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.add(b, t4, t4)
    np.add(a, t2, t3)
    np.divide(t3, t4, t5)
    np.greater(t5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, b, m1)
    some148 = np.count_nonzero(m1)
    if some148:
        np.less(r, a, m2)
        some145 = np.count_nonzero(m2)
        if some145:
            np.add(r, b, t6)
            np.multiply(out, t6, t6)
            np.sqrt(t6, t6)
            np.multiply(t0, t1, t7)
            np.sqrt(t7, t7)
            np.subtract(b, a, t8)
            np.add(a, b, t9)
            np.multiply(t8, t9, t9)
            np.sqrt(t9, t9)
            np.divide(t7, t9, t9)
            np.arcsinh(t9, t9)
            np.divide(t9, t6, t6)
            np.divide(r, t3, t9)
            np.multiply(r, t9, t9)
            np.divide(t9, t4, t9)
            np.multiply(t5, t5, t7)
            np.multiply(t9, t9, t8)
            np.multiply(C16, t8, t10)
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
            np.add(t7, C3, t7)
            np.multiply(C0, t2, t11)
            np.divide(t11, t4, t11)
            np.add(t9, t5, t10)
            np.multiply(t9, t10, t10)
            np.multiply(t10, t8, t8)
            np.add(t7, t8, t8)
            np.multiply(t11, t8, t8)
            np.divide(t8, b, t8)
            np.add(t6, t8, t8)
            np.multiply(v20, t8, t6)
        if some145 != size:
            np.copyto(t6, C16, where=~m2)
    if some148 != size:
        np.copyto(t6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some161 = np.count_nonzero(m1)
    if some161:
        np.sqrt(a, t3)
        np.multiply(t3, v153, t3)
        np.greater(t3, C16, m2)
        some159 = np.count_nonzero(m2)
        if some159:
            np.multiply(E_star, t3, t5)
            np.multiply(C36, t2, t4)
            np.divide(t5, t4, t5)
        if some159 != size:
            np.copyto(t5, C16, where=~m2)
    if some161 != size:
        np.copyto(t5, C16, where=~m1)
    np.subtract(t6, t5, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, h, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, m0, m1, m2, f0):
    size = out.size
    np.subtract(b, r, out)
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
    np.add(b, r, t4)
    np.multiply(t3, t4, t4)
    np.sqrt(t4, t4)
    np.add(b, t4, t4)
    np.add(a, t2, t3)
    np.divide(t3, t4, t5)
    np.greater(t5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, b, m1)
    some148 = np.count_nonzero(m1)
    if some148:
        np.less(r, a, m2)
        some145 = np.count_nonzero(m2)
        if some145:
            np.add(r, b, t6)
            np.multiply(out, t6, t6)
            np.sqrt(t6, t6)
            np.multiply(t0, t1, t7)
            np.sqrt(t7, t7)
            np.subtract(b, a, t8)
            np.add(a, b, t9)
            np.multiply(t8, t9, t9)
            np.sqrt(t9, t9)
            np.multiply(E_star, h, t8)
            np.divide(t8, C36, t8)
            np.divide(t7, t9, t9)
            np.arcsinh(t9, t9)
            np.divide(t9, t6, t6)
            np.divide(r, t3, t9)
            np.multiply(r, t9, t9)
            np.divide(t9, t4, t9)
            np.multiply(t5, t5, t7)
            np.multiply(t9, t9, t10)
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
            np.add(t9, t5, t11)
            np.multiply(t9, t11, t11)
            np.multiply(t11, t10, t10)
            np.add(t7, t10, t10)
            np.multiply(t12, t10, t10)
            np.divide(t10, b, t10)
            np.add(t6, t10, t10)
            np.multiply(t8, t10, t6)
        if some145 != size:
            np.copyto(t6, C16, where=~m2)
    if some148 != size:
        np.copyto(t6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some161 = np.count_nonzero(m1)
    if some161:
        np.sqrt(a, t3)
        np.multiply(C2, dgamma, t4)
        np.divide(t4, E_star, t4)
        np.sqrt(t4, t4)
        np.multiply(t3, t4, t4)
        np.greater(t4, C16, m2)
        some159 = np.count_nonzero(m2)
        if some159:
            np.multiply(E_star, t4, t5)
            np.multiply(C36, t2, t3)
            np.divide(t5, t3, t5)
        if some159 != size:
            np.copyto(t5, C16, where=~m2)
    if some161 != size:
        np.copyto(t5, C16, where=~m1)
    np.subtract(t6, t5, out)


def pull_off_radius(h, b, E_star, dgamma, control):
    if h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and h > 1e-30 and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(h, b, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(h, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, h, b, E_star, dgamma):
    if d.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, h, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, h, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, h, b, E_star, dgamma):
    if F.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, h, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, h, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, h, b, E_star):
    if F.__class__ is h.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, h, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, h, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'h', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'h', 'b', 'E_star', 'dgamma'): (('a', 'h', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_force', 1, 'a', 'h', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 6, 1, (1.0,), False),
        ('a', 'h', 'b', 'E_star', 'dgamma'): (('a', 'h', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 7, 1, (1.0,), False),
    },
    ('_pressure', 2, 'r', 'a', 'h', 'b', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 12, 2, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 12, 3, (0.0,), False),
        ('r', 'a', 'h', 'b', 'E_star', 'dgamma'): (('r', 'a', 'h', 'b', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, 13, 3, (0.0,), False),
    },
}
