"""Programs of axicontact.adhesive.ellipsoid."""

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


def block_depth_a(out, a, b, v12, v19, w0):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.multiply(v12, a, out)
    np.multiply(out, w0, w0)
    np.sqrt(a, out)
    np.multiply(out, v19, out)
    np.subtract(w0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, h, b, E_star, dgamma, w0, w1):
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.divide(h, b, out)
    np.multiply(out, a, out)
    np.multiply(out, w0, w0)
    np.sqrt(a, out)
    np.multiply(C2, dgamma, w1)
    np.divide(w1, E_star, w1)
    np.sqrt(w1, w1)
    np.multiply(out, w1, w1)
    np.subtract(w0, w1, out)


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


def block_force_a(out, a, b, v12, v61, v67, w0, w1, w2, w3, w4, w5, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.square(a, out)
    np.multiply(out, w0, out)
    np.divide(out, b, out)
    np.divide(a, b, w1)
    np.less(w0, C3, m0)
    some57 = np.count_nonzero(m0)
    if some57:
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
    if some57 != size:
        other57 = w3 if some57 else w2
        np.subtract(w0, w1, other57)
        if some57:
            np.copyto(w2, other57, where=~m0)
    np.multiply(b, w2, w2)
    np.add(out, w2, w2)
    np.multiply(v12, w2, w2)
    np.multiply(v61, a, out)
    np.sqrt(a, w1)
    np.multiply(w1, v67, w1)
    np.multiply(out, w1, w1)
    np.subtract(w2, w1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, h, b, E_star, dgamma, w0, w1, w2, w3, w4, w5, w6, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(b, a, w0)
    np.divide(out, w0, w0)
    np.log1p(w0, w0)
    np.multiply(w0, C1, w0)
    np.multiply(E_star, h, out)
    np.square(a, w1)
    np.multiply(w1, w0, w1)
    np.divide(w1, b, w1)
    np.divide(a, b, w2)
    np.less(w0, C3, m0)
    some57 = np.count_nonzero(m0)
    if some57:
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
    if some57 != size:
        other57 = w4 if some57 else w3
        np.subtract(w0, w2, other57)
        if some57:
            np.copyto(w3, other57, where=~m0)
    np.multiply(b, w3, w3)
    np.add(w1, w3, w3)
    np.multiply(out, w3, w3)
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)
    np.sqrt(a, w1)
    np.multiply(C2, dgamma, w2)
    np.divide(w2, E_star, w2)
    np.sqrt(w2, w2)
    np.multiply(w1, w2, w2)
    np.multiply(out, w2, w2)
    np.subtract(w3, w2, out)


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


def block_pressure_r(out, r, a, b, v17, v20, v146, v155, v156, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, m0, m1, f0):
    size = out.size
    np.subtract(b, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.subtract(a, r, w0)
    np.add(a, r, w1)
    np.maximum(w0, f0, out=w2)
    np.multiply(w2, w1, w2)
    np.sqrt(w2, w2)
    np.maximum(out, f0, out=w3)
    np.add(b, r, w4)
    np.multiply(w3, w4, w4)
    np.sqrt(w4, w4)
    np.add(b, w4, w4)
    np.add(a, w2, w3)
    np.divide(w3, w4, w5)
    np.greater(w5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    if v146:
        np.less(r, a, m1)
        some145 = np.count_nonzero(m1)
        if some145:
            np.add(r, b, w6)
            np.multiply(out, w6, w6)
            np.sqrt(w6, w6)
            np.multiply(w0, w1, w7)
            np.sqrt(w7, w7)
            np.divide(w7, v17, w7)
            np.arcsinh(w7, w7)
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
            np.divide(w9, b, w9)
            np.add(w6, w9, w9)
            np.multiply(v20, w9, w6)
        if some145 != size:
            np.copyto(w6, C16, where=~m1)
    else:
        np.copyto(w6, C35)
    np.less_equal(r, a, m1)
    some161 = np.count_nonzero(m1)
    if some161:
        if v155:
            np.multiply(C36, w2, w5)
            np.divide(v156, w5, w5)
        else:
            np.copyto(w5, C16)
    if some161 != size:
        np.copyto(w5, C16, where=~m1)
    np.subtract(w6, w5, out)


def prepare_pressure_r_a(h, b, E_star, dgamma):
    v18 = E_star * h
    v20 = v18 / (3.141592653589793)
    v151 = (6.283185307179586) * dgamma
    v152 = v151 / E_star
    v153 = np.sqrt(v152)
    return (b, E_star, v20, v153)


def block_pressure_r_a(out, r, a, b, E_star, v20, v153, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, m0, m1, m2, f0):
    size = out.size
    np.subtract(b, r, out)
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
    np.add(b, r, w4)
    np.multiply(w3, w4, w4)
    np.sqrt(w4, w4)
    np.add(b, w4, w4)
    np.add(a, w2, w3)
    np.divide(w3, w4, w5)
    np.greater(w5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, b, m1)
    some148 = np.count_nonzero(m1)
    if some148:
        np.less(r, a, m2)
        some145 = np.count_nonzero(m2)
        if some145:
            np.add(r, b, w6)
            np.multiply(out, w6, w6)
            np.sqrt(w6, w6)
            np.multiply(w0, w1, w7)
            np.sqrt(w7, w7)
            np.subtract(b, a, w8)
            np.add(a, b, w9)
            np.multiply(w8, w9, w9)
            np.sqrt(w9, w9)
            np.divide(w7, w9, w9)
            np.arcsinh(w9, w9)
            np.divide(w9, w6, w6)
            np.divide(r, w3, w9)
            np.multiply(r, w9, w9)
            np.divide(w9, w4, w9)
            np.multiply(w5, w5, w7)
            np.multiply(w9, w9, w8)
            np.multiply(C16, w8, w10)
            np.add(w10, C17, w10)
            np.multiply(C17, w7, w11)
            np.add(w11, C18, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C19, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C20, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C21, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C22, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C23, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C24, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C25, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C26, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C27, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C28, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C29, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C30, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C31, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C32, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C33, w11)
            np.multiply(w10, w8, w10)
            np.add(w10, w11, w10)
            np.multiply(w11, w7, w11)
            np.add(w11, C34, w11)
            np.multiply(w10, w8, w8)
            np.add(w8, w11, w8)
            np.multiply(w11, w7, w7)
            np.add(w7, C3, w7)
            np.multiply(C0, w2, w11)
            np.divide(w11, w4, w11)
            np.add(w9, w5, w10)
            np.multiply(w9, w10, w10)
            np.multiply(w10, w8, w8)
            np.add(w7, w8, w8)
            np.multiply(w11, w8, w8)
            np.divide(w8, b, w8)
            np.add(w6, w8, w8)
            np.multiply(v20, w8, w6)
        if some145 != size:
            np.copyto(w6, C16, where=~m2)
    if some148 != size:
        np.copyto(w6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some161 = np.count_nonzero(m1)
    if some161:
        np.sqrt(a, w3)
        np.multiply(w3, v153, w3)
        np.greater(w3, C16, m2)
        some159 = np.count_nonzero(m2)
        if some159:
            np.multiply(E_star, w3, w5)
            np.multiply(C36, w2, w4)
            np.divide(w5, w4, w5)
        if some159 != size:
            np.copyto(w5, C16, where=~m2)
    if some161 != size:
        np.copyto(w5, C16, where=~m1)
    np.subtract(w6, w5, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, h, b, E_star, dgamma, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, m0, m1, m2, f0):
    size = out.size
    np.subtract(b, r, out)
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
    np.add(b, r, w4)
    np.multiply(w3, w4, w4)
    np.sqrt(w4, w4)
    np.add(b, w4, w4)
    np.add(a, w2, w3)
    np.divide(w3, w4, w5)
    np.greater(w5, C15, m0)
    if np.count_nonzero(m0):
        raise FloatingPointError
    np.less_equal(a, b, m1)
    some148 = np.count_nonzero(m1)
    if some148:
        np.less(r, a, m2)
        some145 = np.count_nonzero(m2)
        if some145:
            np.add(r, b, w6)
            np.multiply(out, w6, w6)
            np.sqrt(w6, w6)
            np.multiply(w0, w1, w7)
            np.sqrt(w7, w7)
            np.subtract(b, a, w8)
            np.add(a, b, w9)
            np.multiply(w8, w9, w9)
            np.sqrt(w9, w9)
            np.multiply(E_star, h, w8)
            np.divide(w8, C36, w8)
            np.divide(w7, w9, w9)
            np.arcsinh(w9, w9)
            np.divide(w9, w6, w6)
            np.divide(r, w3, w9)
            np.multiply(r, w9, w9)
            np.divide(w9, w4, w9)
            np.multiply(w5, w5, w7)
            np.multiply(w9, w9, w10)
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
            np.add(w9, w5, w11)
            np.multiply(w9, w11, w11)
            np.multiply(w11, w10, w10)
            np.add(w7, w10, w10)
            np.multiply(w12, w10, w10)
            np.divide(w10, b, w10)
            np.add(w6, w10, w10)
            np.multiply(w8, w10, w6)
        if some145 != size:
            np.copyto(w6, C16, where=~m2)
    if some148 != size:
        np.copyto(w6, C35, where=~m1)
    np.less_equal(r, a, m1)
    some161 = np.count_nonzero(m1)
    if some161:
        np.sqrt(a, w3)
        np.multiply(C2, dgamma, w4)
        np.divide(w4, E_star, w4)
        np.sqrt(w4, w4)
        np.multiply(w3, w4, w4)
        np.greater(w4, C16, m2)
        some159 = np.count_nonzero(m2)
        if some159:
            np.multiply(E_star, w4, w5)
            np.multiply(C36, w2, w3)
            np.divide(w5, w3, w5)
        if some159 != size:
            np.copyto(w5, C16, where=~m2)
    if some161 != size:
        np.copyto(w5, C16, where=~m1)
    np.subtract(w6, w5, out)


BLOCKS = {
    ('_depth', 1, 'a', 'h', 'b', 'E_star', 'dgamma'): {
        ('a',): Program(('a',), prepare_depth_a, block_depth_a, scratch=1),
        ('a', 'h', 'b', 'E_star', 'dgamma'): Program(('a', 'h', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, scratch=2),
    },
    ('_force', 1, 'a', 'h', 'b', 'E_star', 'dgamma'): {
        ('a',): Program(('a',), prepare_force_a, block_force_a, scratch=6, masks=1, filled=(1.0,)),
        ('a', 'h', 'b', 'E_star', 'dgamma'): Program(('a', 'h', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, scratch=7, masks=1, filled=(1.0,)),
    },
    ('_pressure', 2, 'r', 'a', 'h', 'b', 'E_star', 'dgamma'): {
        ('r',): Program(('r',), prepare_pressure_r, block_pressure_r, scratch=12, masks=2, filled=(0.0,)),
        ('r', 'a'): Program(('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, scratch=12, masks=3, filled=(0.0,)),
        ('r', 'a', 'h', 'b', 'E_star', 'dgamma'): Program(('r', 'a', 'h', 'b', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, scratch=13, masks=3, filled=(0.0,)),
    },
}
