"""Programs of axicontact.normal.hyperboloid."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, sqrt, tan

import numpy as np

from ..._runtime.arrays.blocks import Program, largest
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
RULE_0 = rule(((0.4097463988641303, 8), (1.7123381635707111, 16), (3.012135102255693, 24), (4.256467450182103, 32), (9.015036632031958, 64)))


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


def block_depth_a(out, a, b, v5, w0):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.multiply(v5, a, w0)
    np.multiply(w0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, w0):
    np.divide(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.arctan(out, out)
    np.tan(theta, w0)
    np.multiply(w0, a, w0)
    np.multiply(w0, out, out)


def depth_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
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
                return None
            v71 = r * r
            return v49 * a * atan(a / b) - v49 * v71 / (sqrt(v71 + v55) + b)
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


def block_force_a(out, a, b, v6, v10, w0, w1, w2, w3, w4, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, w0)
    np.multiply(w0, out, out)
    np.divide(a, b, w0)
    np.less(w0, C1, m0)
    some58 = np.count_nonzero(m0)
    if some58:
        np.minimum(w0, f0, out=w1)
        np.multiply(w1, w1, w2)
        np.multiply(w1, w2, w1)
        np.multiply(C2, w2, w3)
        np.add(w3, C3, w3)
        np.multiply(w3, w2, w3)
        np.add(w3, C4, w3)
        np.multiply(w3, w2, w3)
        np.add(w3, C5, w3)
        np.multiply(w3, w2, w3)
        np.add(w3, C6, w3)
        np.multiply(w3, w2, w3)
        np.add(w3, C7, w3)
        np.multiply(w3, w2, w3)
        np.add(w3, C8, w3)
        np.multiply(C9, w2, w4)
        np.add(w4, C10, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C11, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C12, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C13, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C14, w4)
        np.multiply(w4, w2, w2)
        np.add(w2, C1, w2)
        np.divide(w3, w2, w2)
        np.multiply(w1, w2, w1)
    if some58 != size:
        other58 = w2 if some58 else w1
        np.arctan(w0, other58)
        np.subtract(w0, other58, other58)
        if some58:
            np.copyto(w1, other58, where=~m0)
    np.multiply(v10, w1, w1)
    np.add(out, w1, w1)
    np.multiply(v6, w1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, w0, w1, w2, w3, w4, w5, w6, m0, f0):
    size = out.size
    np.arctan2(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, w0)
    np.multiply(E_star, w0, w0)
    np.square(a, w1)
    np.multiply(w1, out, out)
    np.square(b, w1)
    np.divide(a, b, w2)
    np.less(w2, C1, m0)
    some58 = np.count_nonzero(m0)
    if some58:
        np.minimum(w2, f0, out=w3)
        np.multiply(w3, w3, w4)
        np.multiply(w3, w4, w3)
        np.multiply(C2, w4, w5)
        np.add(w5, C3, w5)
        np.multiply(w5, w4, w5)
        np.add(w5, C4, w5)
        np.multiply(w5, w4, w5)
        np.add(w5, C5, w5)
        np.multiply(w5, w4, w5)
        np.add(w5, C6, w5)
        np.multiply(w5, w4, w5)
        np.add(w5, C7, w5)
        np.multiply(w5, w4, w5)
        np.add(w5, C8, w5)
        np.multiply(C9, w4, w6)
        np.add(w6, C10, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C11, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C12, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C13, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C14, w6)
        np.multiply(w6, w4, w4)
        np.add(w4, C1, w4)
        np.divide(w5, w4, w4)
        np.multiply(w3, w4, w3)
    if some58 != size:
        other58 = w4 if some58 else w3
        np.arctan(w2, other58)
        np.subtract(w2, other58, other58)
        if some58:
            np.copyto(w3, other58, where=~m0)
    np.multiply(w1, w3, w3)
    np.add(out, w3, w3)
    np.multiply(w0, w3, out)


def force_from_depth(d, theta, b, E_star):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
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


def block_mean_pressure_a(out, a, b, v8, v12, w0, w1, w2, w3, w4, w5, m0, m1, f0):
    size = out.size
    np.greater(a, C15, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some67 = np.count_nonzero(m0)
    if some67:
        np.arctan2(a, b, out)
        np.square(a, w0)
        np.multiply(w0, out, out)
        np.divide(a, b, w1)
        np.less(w1, C1, m1)
        some60 = np.count_nonzero(m1)
        if some60:
            np.minimum(w1, f0, out=w2)
            np.multiply(w2, w2, w3)
            np.multiply(w2, w3, w2)
            np.multiply(C2, w3, w4)
            np.add(w4, C3, w4)
            np.multiply(w4, w3, w4)
            np.add(w4, C4, w4)
            np.multiply(w4, w3, w4)
            np.add(w4, C5, w4)
            np.multiply(w4, w3, w4)
            np.add(w4, C6, w4)
            np.multiply(w4, w3, w4)
            np.add(w4, C7, w4)
            np.multiply(w4, w3, w4)
            np.add(w4, C8, w4)
            np.multiply(C9, w3, w5)
            np.add(w5, C10, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C11, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C12, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C13, w5)
            np.multiply(w5, w3, w5)
            np.add(w5, C14, w5)
            np.multiply(w5, w3, w3)
            np.add(w3, C1, w3)
            np.divide(w4, w3, w3)
            np.multiply(w2, w3, w2)
        if some60 != size:
            other60 = w3 if some60 else w2
            np.arctan(w1, other60)
            np.subtract(w1, other60, other60)
            if some60:
                np.copyto(w2, other60, where=~m1)
        np.multiply(v12, w2, w2)
        np.add(out, w2, w2)
        np.multiply(v8, w2, w2)
        np.multiply(C16, w0, w0)
        np.divide(w2, w0, out)
    if some67 != size:
        np.copyto(out, C15, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, theta, b, E_star, w0, w1, w2, w3, w4, w5, w6, w7, m0, m1, f0):
    size = out.size
    np.greater(a, C15, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some67 = np.count_nonzero(m0)
    if some67:
        np.arctan2(a, b, out)
        np.tan(theta, w0)
        np.multiply(E_star, w0, w0)
        np.square(a, w1)
        np.multiply(w1, out, out)
        np.square(b, w2)
        np.divide(a, b, w3)
        np.less(w3, C1, m1)
        some60 = np.count_nonzero(m1)
        if some60:
            np.minimum(w3, f0, out=w4)
            np.multiply(w4, w4, w5)
            np.multiply(w4, w5, w4)
            np.multiply(C2, w5, w6)
            np.add(w6, C3, w6)
            np.multiply(w6, w5, w6)
            np.add(w6, C4, w6)
            np.multiply(w6, w5, w6)
            np.add(w6, C5, w6)
            np.multiply(w6, w5, w6)
            np.add(w6, C6, w6)
            np.multiply(w6, w5, w6)
            np.add(w6, C7, w6)
            np.multiply(w6, w5, w6)
            np.add(w6, C8, w6)
            np.multiply(C9, w5, w7)
            np.add(w7, C10, w7)
            np.multiply(w7, w5, w7)
            np.add(w7, C11, w7)
            np.multiply(w7, w5, w7)
            np.add(w7, C12, w7)
            np.multiply(w7, w5, w7)
            np.add(w7, C13, w7)
            np.multiply(w7, w5, w7)
            np.add(w7, C14, w7)
            np.multiply(w7, w5, w5)
            np.add(w5, C1, w5)
            np.divide(w6, w5, w5)
            np.multiply(w4, w5, w4)
        if some60 != size:
            other60 = w5 if some60 else w4
            np.arctan(w3, other60)
            np.subtract(w3, other60, other60)
            if some60:
                np.copyto(w4, other60, where=~m1)
        np.multiply(w2, w4, w4)
        np.add(out, w4, w4)
        np.multiply(w0, w4, w4)
        np.multiply(C16, w1, w1)
        np.divide(w4, w1, out)
    if some67 != size:
        np.copyto(out, C15, where=~m0)


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


def block_profile_r(out, r, b, v5, v8, w0):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(out, v5, w0)
    np.sqrt(w0, w0)
    np.multiply(v8, out, out)
    np.add(w0, b, w0)
    np.divide(out, w0, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, theta, b, w0, w1):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.square(b, w0)
    np.add(out, w0, w0)
    np.sqrt(w0, w0)
    np.tan(theta, w1)
    np.multiply(w1, out, out)
    np.add(w0, b, w0)
    np.divide(out, w0, out)


def radius_from_depth(d, theta, b):
    if d.__class__ is theta.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
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
        ('a',): Program(('a',), prepare_depth_a, block_depth_a, scratch=1),
        ('a', 'theta', 'b'): Program(('a', 'theta', 'b'), prepare_depth_all, block_depth_all, scratch=1),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): Program(('a',), prepare_force_a, block_force_a, scratch=5, masks=1, filled=(1.0,)),
        ('a', 'theta', 'b', 'E_star'): Program(('a', 'theta', 'b', 'E_star'), prepare_force_all, block_force_all, scratch=7, masks=1, filled=(1.0,)),
    },
    ('_mean_pressure', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): Program(('a',), prepare_mean_pressure_a, block_mean_pressure_a, scratch=6, masks=2, filled=(1.0,)),
        ('a', 'theta', 'b', 'E_star'): Program(('a', 'theta', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, scratch=8, masks=2, filled=(1.0,)),
    },
    ('_profile', 1, 'r', 'theta', 'b'): {
        ('r',): Program(('r',), prepare_profile_r, block_profile_r, scratch=1),
        ('r', 'theta', 'b'): Program(('r', 'theta', 'b'), prepare_profile_all, block_profile_all, scratch=2),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): Program(('a',), prepare_stiffness_a, block_stiffness_a),
        ('a', 'E_star'): Program(('a', 'E_star'), prepare_stiffness_all, block_stiffness_all),
    },
}
