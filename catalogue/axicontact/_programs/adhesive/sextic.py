"""Programs of axicontact.adhesive.sextic."""

from __future__ import annotations

from math import atan2, inf, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.adhesive import sextic as bodies

C0 = np.array(6.0)
C1 = np.array(16.0)
C2 = np.array(5.0)
C3 = np.array(6.283185307179586)
C4 = np.array(-1.2774361052403345)
C5 = np.array(-23.178809850601194)
C6 = np.array(-181.92316258227586)
C7 = np.array(-611.3425551498234)
C8 = np.array(-362.00165963521414)
C9 = np.array(2098.825846649865)
C10 = np.array(3992.6681072942106)
C11 = np.array(2012.329045387071)
C12 = np.array(0.44444444444468756)
C13 = np.array(0.008653162919782199)
C14 = np.array(-0.42336499735873506)
C15 = np.array(23.453299031698904)
C16 = np.array(657.0260884407312)
C17 = np.array(4128.7190564480725)
C18 = np.array(10373.373159937977)
C19 = np.array(11371.059137910102)
C20 = np.array(4528.267624848188)
C21 = np.array(1.0)
C22 = np.array(0.8571428571428571)
C23 = np.array(0.6366197723675814)
C24 = np.array(32.0)
C25 = np.array(15.707963267948966)
C26 = np.array(7.0)
C27 = np.array(192.0)
C28 = np.array(35.0)
C29 = np.array(2.0)
C30 = np.array(8.0)
C31 = np.array(0.0)
C32 = np.array(3.141592653589793)
C33 = np.array(3.0)
C34 = np.array(4.0)
C35 = np.array(78.53981633974483)
C36 = np.array(np.nan)
C37 = np.array(11.0)
C38 = np.array(0.14285714285714285)
C39 = np.array(np.inf)
C40 = np.array(25.132741228718345)


def depth(a, A, E_star, dgamma):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return 16.0 * A / 5.0 * pow(a, 6.0) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(A, E_star, dgamma):
    v5 = (16.0) * A
    v7 = v5 / (5.0)
    v13 = (6.283185307179586) * dgamma
    v14 = v13 / E_star
    v15 = np.sqrt(v14)
    return (v7, v15)


def block_depth_a(out, a, v7, v15, t0):
    np.power(a, C0, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)
    np.sqrt(a, t0)
    np.multiply(t0, v15, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, A, E_star, dgamma, t0, t1):
    np.multiply(C1, A, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, C2, out)
    np.power(a, C0, t0)
    np.multiply(out, t0, t0)
    np.sqrt(a, out)
    np.multiply(C3, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def displacement(r, a, A, E_star, dgamma):
    if r.__class__ is a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v10 = pow(a, 6.0)
            v12 = r - a
            v13 = r + a
            v84 = r > a
            if v84:
                v17 = a / (r + sqrt(v12 * v13))
                v19 = v17 * v17
                v85 = 32.0 * A / 15.707963267948966 * v10 * (a / r * (0.8571428571428571 + v19 * (((((((((-1.2774361052403345 * v19 + -23.178809850601194) * v19 + -181.92316258227586) * v19 + -611.3425551498234) * v19 + -362.00165963521414) * v19 + 2098.825846649865) * v19 + 3992.6681072942106) * v19 + 2012.329045387071) * v19 + 0.44444444444468756) / ((((((((0.008653162919782199 * v19 + -0.42336499735873506) * v19 + 23.453299031698904) * v19 + 657.0260884407312) * v19 + 4128.7190564480725) * v19 + 10373.373159937977) * v19 + 11371.059137910102) * v19 + 4528.267624848188) * v19 + 1.0))))
            else:
                v85 = 16.0 * A / 5.0 * v10 - A * pow(r, 6.0)
            value = v85 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * v13)) if v84 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, A, E_star, dgamma):
    v6 = (32.0) * A
    v8 = v6 / (15.707963267948966)
    v10 = np.power(a, (6.0))
    v11 = v8 * v10
    v77 = (16.0) * A
    v79 = v77 / (5.0)
    v80 = v79 * v10
    v94 = np.sqrt(a)
    v96 = (6.283185307179586) * dgamma
    v97 = v96 / E_star
    v98 = np.sqrt(v97)
    v99 = v94 * v98
    return (a, A, v11, v80, v99)


def block_displacement_r(out, r, a, A, v11, v80, v99, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, a, t0)
    np.greater(r, a, m0)
    some85 = np.count_nonzero(m0)
    if some85:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.add(r, t1, t1)
        np.divide(a, t1, t1)
        np.divide(a, r, t2)
        np.multiply(t1, t1, t1)
        np.multiply(C4, t1, t3)
        np.add(t3, C5, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C8, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C9, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C11, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C12, t3)
        np.multiply(C13, t1, t4)
        np.add(t4, C14, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C15, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C16, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C17, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C18, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C19, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C20, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C21, t4)
        np.divide(t3, t4, t4)
        np.multiply(t1, t4, t4)
        np.add(C22, t4, t4)
        np.multiply(t2, t4, t4)
        np.multiply(v11, t4, t1)
    if some85 != size:
        other85 = t4 if some85 else t1
        np.power(r, C0, other85)
        np.multiply(A, other85, other85)
        np.subtract(v80, other85, other85)
        if some85:
            np.copyto(t1, other85, where=~m0)
    some93 = np.count_nonzero(m0)
    if some93:
        np.maximum(out, f0, out=t4)
        np.multiply(t4, t0, t4)
        np.sqrt(t4, t4)
        np.arctan2(a, t4, t4)
        np.multiply(C23, t4, t4)
    if some93 != size:
        np.copyto(t4, C21, where=~m0)
    np.multiply(v99, t4, t4)
    np.subtract(t1, t4, out)


def prepare_displacement_r_a(A, E_star, dgamma):
    v6 = (32.0) * A
    v8 = v6 / (15.707963267948966)
    v77 = (16.0) * A
    v79 = v77 / (5.0)
    v96 = (6.283185307179586) * dgamma
    v97 = v96 / E_star
    v98 = np.sqrt(v97)
    return (A, v8, v79, v98)


def block_displacement_r_a(out, r, a, A, v8, v79, v98, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.power(a, C0, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some85 = np.count_nonzero(m0)
    if some85:
        np.multiply(v8, out, t2)
        np.multiply(t0, t1, t3)
        np.sqrt(t3, t3)
        np.add(r, t3, t3)
        np.divide(a, t3, t3)
        np.divide(a, r, t4)
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
        np.multiply(t5, t3, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C12, t5)
        np.multiply(C13, t3, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C15, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C16, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C17, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C18, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C19, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C20, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C21, t6)
        np.divide(t5, t6, t6)
        np.multiply(t3, t6, t6)
        np.add(C22, t6, t6)
        np.multiply(t4, t6, t6)
        np.multiply(t2, t6, t2)
    if some85 != size:
        other85 = t6 if some85 else t2
        np.multiply(v79, out, other85)
        np.power(r, C0, t4)
        np.multiply(A, t4, t4)
        np.subtract(other85, t4, other85)
        if some85:
            np.copyto(t2, other85, where=~m0)
    some93 = np.count_nonzero(m0)
    if some93:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C23, out, out)
    if some93 != size:
        np.copyto(out, C21, where=~m0)
    np.sqrt(a, t1)
    np.multiply(t1, v98, t1)
    np.multiply(t1, out, out)
    np.subtract(t2, out, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, A, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.power(a, C0, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some85 = np.count_nonzero(m0)
    if some85:
        np.multiply(C24, A, t2)
        np.divide(t2, C25, t2)
        np.multiply(t2, out, t2)
        np.multiply(t0, t1, t3)
        np.sqrt(t3, t3)
        np.add(r, t3, t3)
        np.divide(a, t3, t3)
        np.divide(a, r, t4)
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
        np.multiply(t5, t3, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C12, t5)
        np.multiply(C13, t3, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C15, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C16, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C17, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C18, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C19, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C20, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C21, t6)
        np.divide(t5, t6, t6)
        np.multiply(t3, t6, t6)
        np.add(C22, t6, t6)
        np.multiply(t4, t6, t6)
        np.multiply(t2, t6, t2)
    if some85 != size:
        other85 = t6 if some85 else t2
        np.multiply(C1, A, other85)
        np.divide(other85, C2, other85)
        np.multiply(other85, out, other85)
        np.power(r, C0, t4)
        np.multiply(A, t4, t4)
        np.subtract(other85, t4, other85)
        if some85:
            np.copyto(t2, other85, where=~m0)
    some93 = np.count_nonzero(m0)
    if some93:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C23, out, out)
    if some93 != size:
        np.copyto(out, C21, where=~m0)
    np.sqrt(a, t1)
    np.multiply(C3, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t1, t0, t0)
    np.multiply(t0, out, out)
    np.subtract(t2, out, out)


def force(a, A, E_star, dgamma):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return 192.0 * E_star * A / 35.0 * pow(a, 7.0) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(A, E_star, dgamma):
    v5 = (192.0) * E_star
    v6 = v5 * A
    v8 = v6 / (35.0)
    v13 = (2.0) * E_star
    v17 = (6.283185307179586) * dgamma
    v18 = v17 / E_star
    v19 = np.sqrt(v18)
    return (v8, v13, v19)


def block_force_a(out, a, v8, v13, v19, t0, t1):
    np.power(a, C26, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v8, out, out)
    np.multiply(v13, a, t0)
    np.sqrt(a, t1)
    np.multiply(t1, v19, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, A, E_star, dgamma, t0, t1, t2):
    np.multiply(C27, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.divide(out, C28, out)
    np.power(a, C26, t0)
    np.multiply(out, t0, t0)
    np.multiply(C29, E_star, out)
    np.multiply(out, a, out)
    np.sqrt(a, t1)
    np.multiply(C3, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(t1, t2, t2)
    np.multiply(out, t2, t2)
    np.subtract(t0, t2, out)


def pressure(r, a, A, E_star, dgamma):
    if r.__class__ is a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v5 = a - r
            v6 = a + r
            if r < a:
                v17 = a * a
                v22 = r * r
                v32 = 32.0 * E_star * A / 78.53981633974483 * (3.0 * (v17 * v17) + 4.0 * v17 * v22 + 8.0 * (v22 * v22)) * sqrt(v5 * v6)
            else:
                v32 = 0.0
            if r <= a:
                v38 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v49 = E_star * v38 / (3.141592653589793 * sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * v6)) if v38 > 0.0 else 0.0
            else:
                v49 = 0.0
            return v32 - v49
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, A, E_star, dgamma):
    v11 = (32.0) * E_star
    v12 = v11 * A
    v14 = v12 / (78.53981633974483)
    v17 = np.square(a)
    v18 = np.square(v17)
    v20 = (3.0) * v18
    v21 = (4.0) * v17
    v33 = np.sqrt(a)
    v35 = (6.283185307179586) * dgamma
    v36 = v35 / E_star
    v37 = np.sqrt(v36)
    v38 = v33 * v37
    v39 = np.greater(v38, (0.0))
    v40 = E_star * v38
    return (a, v14, v20, v21, v39, v40)


def block_pressure_r(out, r, a, v14, v20, v21, v39, v40, t0, t1, t2, t3, m0, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.square(r, t2)
        np.multiply(v21, t2, t3)
        np.add(v20, t3, t3)
        np.square(t2, t2)
        np.multiply(C30, t2, t2)
        np.add(t3, t2, t2)
        np.multiply(v14, t2, t2)
        np.multiply(t2, t1, t1)
    if some32 != size:
        np.copyto(t1, C31, where=~m0)
    np.less_equal(r, a, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        if v39:
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C32, t2, t2)
            np.divide(v40, t2, t2)
        else:
            np.copyto(t2, C31)
    if some49 != size:
        np.copyto(t2, C31, where=~m0)
    np.subtract(t1, t2, out)


def prepare_pressure_r_a(A, E_star, dgamma):
    v11 = (32.0) * E_star
    v12 = v11 * A
    v14 = v12 / (78.53981633974483)
    v35 = (6.283185307179586) * dgamma
    v36 = v35 / E_star
    v37 = np.sqrt(v36)
    return (E_star, v14, v37)


def block_pressure_r_a(out, r, a, E_star, v14, v37, t0, t1, t2, t3, t4, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.square(a, t2)
        np.square(t2, t3)
        np.multiply(C33, t3, t3)
        np.multiply(C34, t2, t2)
        np.square(r, t4)
        np.multiply(t2, t4, t2)
        np.add(t3, t2, t2)
        np.square(t4, t4)
        np.multiply(C30, t4, t4)
        np.add(t2, t4, t4)
        np.multiply(v14, t4, t4)
        np.multiply(t4, t1, t1)
    if some32 != size:
        np.copyto(t1, C31, where=~m0)
    np.less_equal(r, a, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.sqrt(a, t2)
        np.multiply(t2, v37, t2)
        np.greater(t2, C31, m1)
        some47 = np.count_nonzero(m1)
        if some47:
            np.multiply(E_star, t2, t4)
            np.maximum(out, f0, out=t3)
            np.multiply(t3, t0, t3)
            np.sqrt(t3, t3)
            np.multiply(C32, t3, t3)
            np.divide(t4, t3, t4)
        if some47 != size:
            np.copyto(t4, C31, where=~m1)
    if some49 != size:
        np.copyto(t4, C31, where=~m0)
    np.subtract(t1, t4, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, A, E_star, dgamma, t0, t1, t2, t3, t4, t5, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.multiply(C24, E_star, t2)
        np.multiply(t2, A, t2)
        np.divide(t2, C35, t2)
        np.square(a, t3)
        np.square(t3, t4)
        np.multiply(C33, t4, t4)
        np.multiply(C34, t3, t3)
        np.square(r, t5)
        np.multiply(t3, t5, t3)
        np.add(t4, t3, t3)
        np.square(t5, t5)
        np.multiply(C30, t5, t5)
        np.add(t3, t5, t5)
        np.multiply(t2, t5, t5)
        np.multiply(t5, t1, t1)
    if some32 != size:
        np.copyto(t1, C31, where=~m0)
    np.less_equal(r, a, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.sqrt(a, t2)
        np.multiply(C3, dgamma, t3)
        np.divide(t3, E_star, t3)
        np.sqrt(t3, t3)
        np.multiply(t2, t3, t3)
        np.greater(t3, C31, m1)
        some47 = np.count_nonzero(m1)
        if some47:
            np.multiply(E_star, t3, t5)
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C32, t2, t2)
            np.divide(t5, t2, t5)
        if some47 != size:
            np.copyto(t5, C31, where=~m1)
    if some49 != size:
        np.copyto(t5, C31, where=~m0)
    np.subtract(t1, t5, out)


def pull_off_depth(a, A, E_star, dgamma, control):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_depth(a, A, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, A, E_star, dgamma, control):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_force(a, A, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(A, E_star, dgamma, control):
    if A.__class__ is E_star.__class__ is dgamma.__class__ is float and A > 1e-30 and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(A, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(A, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, A, E_star, dgamma):
    if d.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, A, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, A, E_star, dgamma):
    if F.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, A, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, A, E_star):
    if F.__class__ is A.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if F == 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v7 = -F if F < 0.0 else nan
            v11 = 3.0 * v7 / 11.0
            v17 = 35.0 * v11 / (192.0 * E_star * A)
            v19 = pow(v17, 0.14285714285714285)
            v34 = v19 + v19 * ((v17 / (pow(v19, 7.0) * pow(v19, 0.0)) - 1.0) / 7.0) if v17 > 0.0 and v17 < inf else v19
            v37 = (v7 + v11) / v34
            value = v37 * v37 / (25.132741228718345 * E_star * v34)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_work_of_adhesion_from_pull_off_all_signed():
    return ()


def block_work_of_adhesion_from_pull_off_all_signed(out, F, A, E_star, t0, t1, t2, t3, t4, t5, m0, m1, m2):
    size = out.size
    np.equal(F, C31, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.copyto(out, C31)
    if some44 != size:
        other44 = t0 if some44 else out
        np.less(F, C31, m1)
        some7 = np.count_nonzero(m1)
        if some7:
            np.negative(F, other44)
        if some7 != size:
            np.copyto(other44, C36, where=~m1)
        np.multiply(C33, other44, t1)
        np.divide(t1, C37, t1)
        np.multiply(C28, t1, t2)
        np.multiply(C27, E_star, t3)
        np.multiply(t3, A, t3)
        np.divide(t2, t3, t3)
        np.power(t3, C38, t2)
        np.greater(t3, C31, m1)
        np.less(t3, C39, m2)
        np.bitwise_and(m1, m2, m2)
        some34 = np.count_nonzero(m2)
        if some34:
            np.power(t2, C26, t4)
            np.power(t2, C31, t5)
            np.multiply(t4, t5, t5)
            np.divide(t3, t5, t5)
            np.subtract(t5, C21, t5)
            np.divide(t5, C26, t5)
            np.multiply(t2, t5, t5)
            np.add(t2, t5, t4)
        if some34 != size:
            np.copyto(t4, t2, where=~m2)
        np.add(other44, t1, t1)
        np.divide(t1, t4, t1)
        np.square(t1, t1)
        np.multiply(C40, E_star, other44)
        np.multiply(other44, t4, t4)
        np.divide(t1, t4, other44)
        if some44:
            np.copyto(out, other44, where=~m0)


BLOCKS = {
    ('_depth', 1, 'a', 'A', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'A', 'E_star', 'dgamma'): (('a', 'A', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_displacement', 2, 'r', 'a', 'A', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 5, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_displacement_r_a, block_displacement_r_a, 7, 1, (0.0,), False),
        ('r', 'a', 'A', 'E_star', 'dgamma'): (('r', 'a', 'A', 'E_star', 'dgamma'), prepare_displacement_all, block_displacement_all, 7, 1, (0.0,), False),
    },
    ('_force', 1, 'a', 'A', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 0, (), False),
        ('a', 'A', 'E_star', 'dgamma'): (('a', 'A', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 3, 0, (), False),
    },
    ('_pressure', 2, 'r', 'a', 'A', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 4, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 5, 2, (0.0,), False),
        ('r', 'a', 'A', 'E_star', 'dgamma'): (('r', 'a', 'A', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, 6, 2, (0.0,), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'A', 'E_star'): {
        ('F', 'A', 'E_star'): (('F', 'A', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 6, 3, (), False),
    },
}
