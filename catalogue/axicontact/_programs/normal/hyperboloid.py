"""Programs of axicontact.normal.hyperboloid."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import hyperboloid as bodies

C0 = np.array(2.0)
C1 = np.array(1.0)
C2 = np.array(2.229767813968649e-06)
C3 = np.array(0.0021043873129700233)
C4 = np.array(0.04325113828415611)
C5 = np.array(0.2725778671008127)
C6 = np.array(0.7123414383945195)
C7 = np.array(0.8116412201960678)
C8 = np.array(0.3333333333333333)
C9 = np.array(0.002445452808893491)
C10 = np.array(0.06453295925870227)
C11 = np.array(0.5368820963772863)
C12 = np.array(1.9680296155712274)
C13 = np.array(3.5294070829658954)
C14 = np.array(3.034923660588189)
C15 = np.array(0.0)
C16 = np.array(3.141592653589793)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, theta, b):
    if a.__class__ is theta.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            return tan(theta) * a * atan(a / b)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, b):
    v5 = np.tan(theta)
    return (b, v5)


def block_depth_a(out, a, b, v5, t0):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.multiply(v5, a, t0)
    np.multiply(t0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, t0):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.tan(theta, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, out, out)


def depth_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, theta, b):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            v49 = tan(theta)
            v55 = b * b
            if r > a:
                v8 = b / sqrt(r * r + b * b)
                v9 = r - a
                v15 = a / sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (r + a))
                v17 = asinh(v15 / v8)
                v22 = 0.0 - expm1(-2.0 * v17)
                v25 = v22 if v22 > 0.0 else inf
                v39 = v8 * v8
                v51 = b * v49
                v62 = []
                for node, weight in RULE_0(v17 / 1.0):
                    v26 = node * v17
                    v35 = v15 * (exp(-v26) * (0.0 - expm1(-2.0 * (v17 - v26))) / v25)
                    v36 = v35 * v35
                    v38 = sqrt(1.0 + v36)
                    v46 = r * v35 / v38
                    v61 = (v49 * atan(v46 / b) + v51 * v46 / (v46 * v46 + v55)) * atan(v35) * (sqrt(v39 + v36) / (v38 * v38 * v38))
                    v62.append(weight * v61)
                v62 = fsum(v62) * v17
                value = 0.6366197723675814 * (r * v62)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b):
                    return value
                return None
            v71 = r * r
            return v49 * a * atan(a / b) - v49 * v71 / (sqrt(v71 + v55) + b)
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v4 = a / b
            v6 = tan(theta)
            v8 = v6 * a * atan(v4)
            v9 = asinh(v4)
            v15 = 0.0 - expm1(-2.0 * v9)
            v18 = v15 if v15 > 0.0 else inf
            v35 = b * b
            v40 = []
            for node, weight in RULE_0(v9 / 1.0):
                v19 = node * v9
                v28 = a * (exp(-v19) * (0.0 - expm1(-2.0 * (v9 - v19))) / v18)
                v33 = v8 - v6 * v28 * atan(v28 / b)
                v39 = v33 * v33 * sqrt(v35 + v28 * v28)
                v40.append(weight * v39)
            v40 = fsum(v40) * v9
            value = E_star * v40
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v11 = a / b
            if v11 < 1.0:
                v15 = v11 * v11
                v58 = v11 * v15 * (((((((2.229767813968649e-06 * v15 + 0.0021043873129700233) * v15 + 0.04325113828415611) * v15 + 0.2725778671008127) * v15 + 0.7123414383945195) * v15 + 0.8116412201960678) * v15 + 0.3333333333333333) / ((((((0.002445452808893491 * v15 + 0.06453295925870227) * v15 + 0.5368820963772863) * v15 + 1.9680296155712274) * v15 + 3.5294070829658954) * v15 + 3.034923660588189) * v15 + 1.0))
            else:
                v58 = v11 - atan(v11)
            value = E_star * tan(theta) * (a * a * atan2(a, b) + b * b * v58)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, b, E_star):
    v5 = np.tan(theta)
    v6 = E_star * v5
    v10 = np.square(b)
    return (b, v6, v10)


def block_force_a(out, a, b, v6, v10, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.multiply(t0, out, out)
    np.divide(a, b, t0)
    np.less(t0, C1, m0)
    some58 = np.count_nonzero(m0)
    if some58:
        np.minimum(t0, f0, out=t1)
        np.multiply(t1, t1, t2)
        np.multiply(t1, t2, t1)
        np.multiply(C2, t2, t3)
        np.add(t3, C3, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C4, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C5, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C8, t3)
        np.multiply(C9, t2, t4)
        np.add(t4, C10, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C11, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C12, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C13, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C14, t4)
        np.multiply(t4, t2, t2)
        np.add(t2, C1, t2)
        np.divide(t3, t2, t2)
        np.multiply(t1, t2, t1)
    if some58 != size:
        other58 = t2 if some58 else t1
        np.arctan(t0, other58)
        np.subtract(t0, other58, other58)
        if some58:
            np.copyto(t1, other58, where=~m0)
    np.multiply(v10, t1, t1)
    np.add(out, t1, t1)
    np.multiply(v6, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(E_star, t0, t0)
    np.square(a, t1)
    np.multiply(t1, out, out)
    np.square(b, t1)
    np.divide(a, b, t2)
    np.less(t2, C1, m0)
    some58 = np.count_nonzero(m0)
    if some58:
        np.minimum(t2, f0, out=t3)
        np.multiply(t3, t3, t4)
        np.multiply(t3, t4, t3)
        np.multiply(C2, t4, t5)
        np.add(t5, C3, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t4, t5)
        np.add(t5, C8, t5)
        np.multiply(C9, t4, t6)
        np.add(t6, C10, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t4, t4)
        np.add(t4, C1, t4)
        np.divide(t5, t4, t4)
        np.multiply(t3, t4, t3)
    if some58 != size:
        other58 = t4 if some58 else t3
        np.arctan(t2, other58)
        np.subtract(t2, other58, other58)
        if some58:
            np.copyto(t3, other58, where=~m0)
    np.multiply(t1, t3, t3)
    np.add(out, t3, t3)
    np.multiply(t0, t3, out)


def force_from_depth(d, theta, b, E_star):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, theta, b, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = r if r < a or r != r else a
            v39 = tan(theta)
            v45 = b * b
            if v5 > 0.0:
                v6 = a - v5
                v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (a + v5))
                v13 = asinh(v11 / v5)
                v18 = 0.0 - expm1(-2.0 * v13)
                v21 = v18 if v18 > 0.0 else inf
                v22 = v5 * v5
                v41 = b * v39
                v52 = []
                for node, weight in RULE_0(v13 / 1.0):
                    v24 = node * v13
                    v33 = v11 * (exp(-v24) * (0.0 - expm1(-2.0 * (v13 - v24))) / v21)
                    v36 = sqrt(v22 + v33 * v33)
                    v51 = (v39 * atan(v36 / b) + v41 * v36 / (v36 * v36 + v45)) * (v33 / (v36 + v33))
                    v52.append(weight * v51)
                v52 = fsum(v52) * v13
                v54 = v22 * v52
            else:
                v54 = 0.0
            v59 = v5 / b
            if v59 < 1.0:
                v62 = v59 * v59
                v105 = v59 * v62 * (((((((2.229767813968649e-06 * v62 + 0.0021043873129700233) * v62 + 0.04325113828415611) * v62 + 0.2725778671008127) * v62 + 0.7123414383945195) * v62 + 0.8116412201960678) * v62 + 0.3333333333333333) / ((((((0.002445452808893491 * v62 + 0.06453295925870227) * v62 + 0.5368820963772863) * v62 + 1.9680296155712274) * v62 + 3.5294070829658954) * v62 + 3.034923660588189) * v62 + 1.0))
            else:
                v105 = v59 - atan(v59)
            value = E_star * v39 * (v5 * v5 * atan2(v5, b) + v45 * v105) + 2.0 * E_star * v54
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a > 0.0:
                v10 = a * a
                v13 = a / b
                if v13 < 1.0:
                    v17 = v13 * v13
                    v60 = v13 * v17 * (((((((2.229767813968649e-06 * v17 + 0.0021043873129700233) * v17 + 0.04325113828415611) * v17 + 0.2725778671008127) * v17 + 0.7123414383945195) * v17 + 0.8116412201960678) * v17 + 0.3333333333333333) / ((((((0.002445452808893491 * v17 + 0.06453295925870227) * v17 + 0.5368820963772863) * v17 + 1.9680296155712274) * v17 + 3.5294070829658954) * v17 + 3.034923660588189) * v17 + 1.0))
                else:
                    v60 = v13 - atan(v13)
                value = E_star * tan(theta) * (v10 * atan2(a, b) + b * b * v60) / (3.141592653589793 * v10)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(theta, b, E_star):
    v7 = np.tan(theta)
    v8 = E_star * v7
    v12 = np.square(b)
    return (b, v8, v12)


def block_mean_pressure_a(out, a, b, v8, v12, t0, t1, t2, t3, t4, t5, m0, m1, f0):
    size = out.size
    np.greater(a, C15, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some67 = np.count_nonzero(m0)
    if some67:
        np.arctan2(a, b, out)
        np.square(a, t0)
        np.multiply(t0, out, out)
        np.divide(a, b, t1)
        np.less(t1, C1, m1)
        some60 = np.count_nonzero(m1)
        if some60:
            np.minimum(t1, f0, out=t2)
            np.multiply(t2, t2, t3)
            np.multiply(t2, t3, t2)
            np.multiply(C2, t3, t4)
            np.add(t4, C3, t4)
            np.multiply(t4, t3, t4)
            np.add(t4, C4, t4)
            np.multiply(t4, t3, t4)
            np.add(t4, C5, t4)
            np.multiply(t4, t3, t4)
            np.add(t4, C6, t4)
            np.multiply(t4, t3, t4)
            np.add(t4, C7, t4)
            np.multiply(t4, t3, t4)
            np.add(t4, C8, t4)
            np.multiply(C9, t3, t5)
            np.add(t5, C10, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C11, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C12, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C13, t5)
            np.multiply(t5, t3, t5)
            np.add(t5, C14, t5)
            np.multiply(t5, t3, t3)
            np.add(t3, C1, t3)
            np.divide(t4, t3, t3)
            np.multiply(t2, t3, t2)
        if some60 != size:
            other60 = t3 if some60 else t2
            np.arctan(t1, other60)
            np.subtract(t1, other60, other60)
            if some60:
                np.copyto(t2, other60, where=~m1)
        np.multiply(v12, t2, t2)
        np.add(out, t2, t2)
        np.multiply(v8, t2, t2)
        np.multiply(C16, t0, t0)
        np.divide(t2, t0, out)
    if some67 != size:
        np.copyto(out, C15, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, theta, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.greater(a, C15, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some67 = np.count_nonzero(m0)
    if some67:
        np.arctan2(a, b, out)
        np.tan(theta, t0)
        np.multiply(E_star, t0, t0)
        np.square(a, t1)
        np.multiply(t1, out, out)
        np.square(b, t2)
        np.divide(a, b, t3)
        np.less(t3, C1, m1)
        some60 = np.count_nonzero(m1)
        if some60:
            np.minimum(t3, f0, out=t4)
            np.multiply(t4, t4, t5)
            np.multiply(t4, t5, t4)
            np.multiply(C2, t5, t6)
            np.add(t6, C3, t6)
            np.multiply(t6, t5, t6)
            np.add(t6, C4, t6)
            np.multiply(t6, t5, t6)
            np.add(t6, C5, t6)
            np.multiply(t6, t5, t6)
            np.add(t6, C6, t6)
            np.multiply(t6, t5, t6)
            np.add(t6, C7, t6)
            np.multiply(t6, t5, t6)
            np.add(t6, C8, t6)
            np.multiply(C9, t5, t7)
            np.add(t7, C10, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C11, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C12, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C13, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C14, t7)
            np.multiply(t7, t5, t5)
            np.add(t5, C1, t5)
            np.divide(t6, t5, t5)
            np.multiply(t4, t5, t4)
        if some60 != size:
            other60 = t5 if some60 else t4
            np.arctan(t3, other60)
            np.subtract(t3, other60, other60)
            if some60:
                np.copyto(t4, other60, where=~m1)
        np.multiply(t2, t4, t4)
        np.add(out, t4, t4)
        np.multiply(t0, t4, t4)
        np.multiply(C16, t1, t1)
        np.divide(t4, t1, out)
    if some67 != size:
        np.copyto(out, C15, where=~m0)


def peak_pressure(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 0.0 < a:
                v7 = sqrt(0.0 + b * b)
                v8 = a - 0.0
                v12 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (a + 0.0))
                v14 = asinh(v12 / v7)
                v19 = 0.0 - expm1(-2.0 * v14)
                v22 = v19 if v19 > 0.0 else inf
                v38 = tan(theta)
                v40 = b * v38
                v44 = b * b
                v49 = v7 * v7
                v53 = []
                for node, weight in RULE_0(v14 / 1.0):
                    v23 = node * v14
                    v32 = v12 * (exp(-v23) * (0.0 - expm1(-2.0 * (v14 - v23))) / v22)
                    v33 = v32 * v32
                    v35 = sqrt(0.0 + v33)
                    v52 = (v38 * atan(v35 / b) + v40 * v35 / (v35 * v35 + v44)) / v35 * sqrt(v49 + v33)
                    v53.append(weight * v52)
                v53 = fsum(v53) * v14
                value = E_star / 3.141592653589793 * v53
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, theta, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_radius(a, theta=0.7853981633974483, b=1.0, E_star=1.0):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a):
    np.copyto(out, C15)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def pressure(r, a, theta, b, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v5 = r * r
                v8 = sqrt(v5 + b * b)
                v9 = a - r
                v14 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (a + r))
                v16 = asinh(v14 / v8)
                v21 = 0.0 - expm1(-2.0 * v16)
                v24 = v21 if v21 > 0.0 else inf
                v40 = tan(theta)
                v42 = b * v40
                v46 = b * b
                v51 = v8 * v8
                v55 = []
                for node, weight in RULE_0(v16 / 1.0):
                    v25 = node * v16
                    v34 = v14 * (exp(-v25) * (0.0 - expm1(-2.0 * (v16 - v25))) / v24)
                    v35 = v34 * v34
                    v37 = sqrt(v5 + v35)
                    v54 = (v40 * atan(v37 / b) + v42 * v37 / (v37 * v37 + v46)) / v37 * sqrt(v51 + v35)
                    v55.append(weight * v54)
                v55 = fsum(v55) * v16
                value = E_star / 3.141592653589793 * v55
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, theta, b):
    if r.__class__ is theta.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            v4 = r * r
            return tan(theta) * v4 / (sqrt(v4 + b * b) + b)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(theta, b):
    v5 = np.square(b)
    v8 = np.tan(theta)
    return (b, v5, v8)


def block_profile_r(out, r, b, v5, v8, t0):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(out, v5, t0)
    np.sqrt(t0, t0)
    np.multiply(v8, out, out)
    np.add(t0, b, t0)
    np.divide(out, t0, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, theta, b, t0, t1):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.square(b, t0)
    np.add(out, t0, t0)
    np.sqrt(t0, t0)
    np.tan(theta, t1)
    np.multiply(t1, out, out)
    np.add(t0, b, t0)
    np.divide(out, t0, out)


def radius_from_depth(d, theta, b):
    if d.__class__ is theta.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, theta, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, theta=0.7853981633974483, b=1.0):
    if a.__class__ is E_star.__class__ is theta.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
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
    ('_depth', 1, 'a', 'theta', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'theta', 'b'): (('a', 'theta', 'b'), prepare_depth_all, block_depth_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 5, 1, (1.0,), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_force_all, block_force_all, 7, 1, (1.0,), False),
    },
    ('_mean_pressure', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 6, 2, (1.0,), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 8, 2, (1.0,), False),
    },
    ('_peak_radius', 1, 'a'): {
        ('a',): (('a',), prepare_peak_radius_all, block_peak_radius_all, 0, 0, (), False),
    },
    ('_profile', 1, 'r', 'theta', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 0, (), False),
        ('r', 'theta', 'b'): (('r', 'theta', 'b'), prepare_profile_all, block_profile_all, 2, 0, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
