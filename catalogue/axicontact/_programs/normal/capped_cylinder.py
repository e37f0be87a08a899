"""Programs of axicontact.normal.capped_cylinder."""

from __future__ import annotations

from math import atan2, cbrt, nan, sqrt

import numpy as np

from ..._runtime.arrays.blocks import Program, largest

C0 = np.array(2.0)
C1 = np.array(9.0)
C2 = np.array(4.0)
C3 = np.array(3.0)
C4 = np.array(16.0)
C5 = np.array(-0.7327347664453868)
C6 = np.array(-32.15553480435792)
C7 = np.array(-332.23363563146734)
C8 = np.array(-1070.7082873491413)
C9 = np.array(-85.27694715374247)
C10 = np.array(5044.821368830373)
C11 = np.array(8082.413158212496)
C12 = np.array(3759.725330928701)
C13 = np.array(0.26666666666720995)
C14 = np.array(0.21387262524856868)
C15 = np.array(32.12935731379798)
C16 = np.array(746.8124983579742)
C17 = np.array(6202.125133759036)
C18 = np.array(23553.080984642995)
C19 = np.array(44404.005348491315)
C20 = np.array(40380.01430284195)
C21 = np.array(14099.684276696918)
C22 = np.array(1.0)
C23 = np.array(0.6666666666666666)
C24 = np.array(0.0)
C25 = np.array(0.6366197723675814)
C26 = np.array(np.nan)
C27 = np.array(134217729.0)
C28 = np.array(3.141592653589793)


def depth_from_force(F, a, R, E_star):
    if F.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v7 = 3.0 * R
            v10 = a * a
            if 4.0 * E_star / v7 * (a * v10) > F:
                return cbrt(9.0 * (F * F) / (16.0 * (E_star * E_star) * R))
            return F / (2.0 * E_star * a) + v10 / v7
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(a, R, E_star):
    v5 = (4.0) * E_star
    v7 = (3.0) * R
    v8 = v5 / v7
    v10 = np.square(a)
    v11 = a * v10
    v12 = v8 * v11
    v16 = np.square(E_star)
    v18 = (16.0) * v16
    v19 = v18 * R
    v22 = (2.0) * E_star
    v23 = v22 * a
    v25 = v10 / v7
    return (v12, v19, v23, v25)


def block_depth_from_force_F(out, F, v12, v19, v23, v25, w0, m0):
    size = out.size
    np.greater(v12, F, m0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    some28 = np.count_nonzero(m0)
    if some28:
        np.square(F, out)
        np.multiply(C1, out, out)
        np.divide(out, v19, out)
        np.cbrt(out, out)
    if some28 != size:
        other28 = w0 if some28 else out
        np.divide(F, v23, other28)
        np.add(other28, v25, other28)
        if some28:
            np.copyto(out, other28, where=~m0)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, a, R, E_star, w0, w1, w2, w3, m0):
    size = out.size
    np.multiply(C2, E_star, w0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C3, R, w1)
    np.divide(w0, w1, w0)
    np.square(a, w2)
    np.multiply(a, w2, w3)
    np.multiply(w0, w3, w3)
    np.greater(w3, F, m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.square(F, out)
        np.multiply(C1, out, out)
        np.square(E_star, w3)
        np.multiply(C4, w3, w3)
        np.multiply(w3, R, w3)
        np.divide(out, w3, w3)
        np.cbrt(w3, out)
    if some28 != size:
        other28 = w3 if some28 else out
        np.multiply(C0, E_star, other28)
        np.multiply(other28, a, other28)
        np.divide(F, other28, other28)
        np.divide(w2, w1, w0)
        np.add(other28, w0, other28)
        if some28:
            np.copyto(out, other28, where=~m0)


def displacement(r, d, a, R):
    if r.__class__ is d.__class__ is a.__class__ is R.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            v4 = R * d
            v39 = sqrt(v4)
            v40 = v39 if v39 < a or v39 != v39 else a
            if r > v40:
                v5 = a * a
                v8 = 134217729.0 * R
                v10 = v8 - (v8 - R)
                v11 = R - v10
                v12 = 134217729.0 * d
                v14 = v12 - (v12 - d)
                v15 = d - v14
                v24 = 134217729.0 * a
                v26 = v24 - (v24 - a)
                v27 = a - v26
                v38 = (v4 - v5 + (v10 * v14 - v4 + v10 * v15 + v11 * v14 + v11 * v15 - (v26 * v26 - v5 + v26 * v27 + v27 * v26 + v27 * v27))) / R
                v43 = a * a / R
                v50 = v40 / (r + sqrt((r - v40) * (r + v40)))
                v52 = v50 * v50
                value = 0.6366197723675814 * ((d if d < v43 or d != d else v43) * (v40 / r * (0.6666666666666666 + v52 * (((((((((-0.7327347664453868 * v52 + -32.15553480435792) * v52 + -332.23363563146734) * v52 + -1070.7082873491413) * v52 + -85.27694715374247) * v52 + 5044.821368830373) * v52 + 8082.413158212496) * v52 + 3759.725330928701) * v52 + 0.26666666666720995) / ((((((((0.21387262524856868 * v52 + 32.12935731379798) * v52 + 746.8124983579742) * v52 + 6202.125133759036) * v52 + 23553.080984642995) * v52 + 44404.005348491315) * v52 + 40380.01430284195) * v52 + 14099.684276696918) * v52 + 1.0)))) + ((v38 if v38 > 0.0 or v38 != v38 else 0.0) * atan2(a, sqrt((r - a) * (r + a))) if v38 > 0.0 else 0.0))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = d - (r * r / (2.0 * R) if r <= a else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(d, a, R):
    v4 = R * d
    v5 = a * a
    v6 = v4 - v5
    v8 = (134217729.0) * R
    v9 = v8 - R
    v10 = v8 - v9
    v11 = R - v10
    v12 = (134217729.0) * d
    v13 = v12 - d
    v14 = v12 - v13
    v15 = d - v14
    v16 = v10 * v14
    v17 = v16 - v4
    v18 = v10 * v15
    v19 = v17 + v18
    v20 = v11 * v14
    v21 = v19 + v20
    v22 = v11 * v15
    v23 = v21 + v22
    v24 = (134217729.0) * a
    v25 = v24 - a
    v26 = v24 - v25
    v27 = a - v26
    v28 = v26 * v26
    v29 = v28 - v5
    v30 = v26 * v27
    v31 = v29 + v30
    v32 = v27 * v26
    v33 = v31 + v32
    v34 = v27 * v27
    v35 = v33 + v34
    v36 = v23 - v35
    v37 = v6 + v36
    v38 = v37 / R
    v39 = np.sqrt(v4)
    v40 = np.minimum(v39, a)
    v42 = np.square(a)
    v43 = v42 / R
    v44 = np.minimum(d, v43)
    v115 = np.greater(v38, (0.0))
    v116 = np.maximum(v38, (0.0))
    v125 = (2.0) * R
    return (d, a, v40, v44, v115, v116, v125)


def block_displacement_r(out, r, d, a, v40, v44, v115, v116, v125, w0, w1, w2, m0, m1):
    size = out.size
    np.greater(r, v40, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some130 = np.count_nonzero(m0)
    if some130:
        np.subtract(r, v40, out)
        np.add(r, v40, w0)
        np.multiply(out, w0, w0)
        np.sqrt(w0, w0)
        np.add(r, w0, w0)
        np.divide(v40, w0, w0)
        np.divide(v40, r, out)
        np.multiply(w0, w0, w0)
        np.multiply(C5, w0, w1)
        np.add(w1, C6, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C7, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C8, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C9, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C10, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C11, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C12, w1)
        np.multiply(w1, w0, w1)
        np.add(w1, C13, w1)
        np.multiply(C14, w0, w2)
        np.add(w2, C15, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C16, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C17, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C18, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C19, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C20, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C21, w2)
        np.multiply(w2, w0, w2)
        np.add(w2, C22, w2)
        np.divide(w1, w2, w2)
        np.multiply(w0, w2, w2)
        np.add(C23, w2, w2)
        np.multiply(out, w2, w2)
        np.multiply(v44, w2, w2)
        if v115:
            np.subtract(r, a, out)
            np.add(r, a, w0)
            np.multiply(out, w0, w0)
            np.sqrt(w0, w0)
            np.arctan2(a, w0, w0)
            np.multiply(v116, w0, out)
        else:
            np.copyto(out, C24)
        np.add(w2, out, out)
        np.multiply(C25, out, out)
    if some130 != size:
        other130 = w2 if some130 else out
        np.less_equal(r, a, m1)
        some128 = np.count_nonzero(m1)
        if some128:
            np.square(r, other130)
            np.divide(other130, v125, other130)
        if some128 != size:
            np.copyto(other130, C26, where=~m1)
        np.subtract(d, other130, other130)
        if some130:
            np.copyto(out, other130, where=~m0)


def prepare_displacement_r_d(a, R):
    v5 = a * a
    v8 = (134217729.0) * R
    v9 = v8 - R
    v10 = v8 - v9
    v11 = R - v10
    v24 = (134217729.0) * a
    v25 = v24 - a
    v26 = v24 - v25
    v27 = a - v26
    v28 = v26 * v26
    v29 = v28 - v5
    v30 = v26 * v27
    v31 = v29 + v30
    v32 = v27 * v26
    v33 = v31 + v32
    v34 = v27 * v27
    v35 = v33 + v34
    v42 = np.square(a)
    v43 = v42 / R
    v125 = (2.0) * R
    return (a, R, v5, v10, v11, v35, v43, v125)


def block_displacement_r_d(out, r, d, a, R, v5, v10, v11, v35, v43, v125, w0, w1, w2, w3, w4, w5, w6, m0, m1, f0):
    size = out.size
    np.multiply(R, d, w0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(w0, w1)
    np.minimum(w1, a, out=w1)
    np.greater(r, w1, m0)
    some130 = np.count_nonzero(m0)
    if some130:
        np.subtract(w0, v5, out)
        np.multiply(C27, d, w2)
        np.subtract(w2, d, w3)
        np.subtract(w2, w3, w3)
        np.subtract(d, w3, w2)
        np.multiply(v10, w3, w4)
        np.subtract(w4, w0, w4)
        np.multiply(v10, w2, w5)
        np.add(w4, w5, w5)
        np.multiply(v11, w3, w3)
        np.add(w5, w3, w3)
        np.multiply(v11, w2, w2)
        np.add(w3, w2, w2)
        np.subtract(w2, v35, w2)
        np.add(out, w2, w2)
        np.divide(w2, R, w2)
        np.minimum(d, v43, out=out)
        np.subtract(r, w1, w3)
        np.add(r, w1, w5)
        np.multiply(w3, w5, w5)
        np.sqrt(w5, w5)
        np.add(r, w5, w5)
        np.divide(w1, w5, w5)
        np.divide(w1, r, w3)
        np.multiply(w5, w5, w5)
        np.multiply(C5, w5, w4)
        np.add(w4, C6, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C7, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C8, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C9, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C10, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C11, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C12, w4)
        np.multiply(w4, w5, w4)
        np.add(w4, C13, w4)
        np.multiply(C14, w5, w6)
        np.add(w6, C15, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C16, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C17, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C18, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C19, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C20, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C21, w6)
        np.multiply(w6, w5, w6)
        np.add(w6, C22, w6)
        np.divide(w4, w6, w6)
        np.multiply(w5, w6, w6)
        np.add(C23, w6, w6)
        np.multiply(w3, w6, w6)
        np.multiply(out, w6, w6)
        np.greater(w2, C24, m1)
        some118 = np.count_nonzero(m1)
        if some118:
            np.subtract(r, a, out)
            np.add(r, a, w3)
            np.multiply(out, w3, w3)
            np.sqrt(w3, w3)
            np.arctan2(a, w3, w3)
            np.maximum(w2, f0, out=out)
            np.multiply(out, w3, out)
        if some118 != size:
            np.copyto(out, C24, where=~m1)
        np.add(w6, out, out)
        np.multiply(C25, out, out)
    if some130 != size:
        other130 = w6 if some130 else out
        np.less_equal(r, a, m1)
        some128 = np.count_nonzero(m1)
        if some128:
            np.square(r, other130)
            np.divide(other130, v125, other130)
        if some128 != size:
            np.copyto(other130, C26, where=~m1)
        np.subtract(d, other130, other130)
        if some130:
            np.copyto(out, other130, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, d, a, R, w0, w1, w2, w3, w4, w5, w6, w7, m0, m1, f0):
    size = out.size
    np.multiply(R, d, w0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(w0, w1)
    np.minimum(w1, a, out=w1)
    np.greater(r, w1, m0)
    some130 = np.count_nonzero(m0)
    if some130:
        np.multiply(a, a, out)
        np.subtract(w0, out, w2)
        np.multiply(C27, R, w3)
        np.subtract(w3, R, w4)
        np.subtract(w3, w4, w4)
        np.subtract(R, w4, w3)
        np.multiply(C27, d, w5)
        np.subtract(w5, d, w6)
        np.subtract(w5, w6, w6)
        np.subtract(d, w6, w5)
        np.multiply(w4, w6, w7)
        np.subtract(w7, w0, w7)
        np.multiply(w4, w5, w4)
        np.add(w7, w4, w4)
        np.multiply(w3, w6, w6)
        np.add(w4, w6, w6)
        np.multiply(w3, w5, w5)
        np.add(w6, w5, w5)
        np.multiply(C27, a, w6)
        np.subtract(w6, a, w3)
        np.subtract(w6, w3, w3)
        np.subtract(a, w3, w6)
        np.multiply(w3, w3, w4)
        np.subtract(w4, out, out)
        np.multiply(w3, w6, w4)
        np.add(out, w4, w4)
        np.multiply(w6, w3, w3)
        np.add(w4, w3, w3)
        np.multiply(w6, w6, w6)
        np.add(w3, w6, w6)
        np.subtract(w5, w6, w6)
        np.add(w2, w6, w6)
        np.divide(w6, R, w6)
        np.square(a, w2)
        np.divide(w2, R, w2)
        np.minimum(d, w2, out=w2)
        np.subtract(r, w1, w5)
        np.add(r, w1, w3)
        np.multiply(w5, w3, w3)
        np.sqrt(w3, w3)
        np.add(r, w3, w3)
        np.divide(w1, w3, w3)
        np.divide(w1, r, w5)
        np.multiply(w3, w3, w3)
        np.multiply(C5, w3, w4)
        np.add(w4, C6, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C7, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C8, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C9, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C10, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C11, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C12, w4)
        np.multiply(w4, w3, w4)
        np.add(w4, C13, w4)
        np.multiply(C14, w3, out)
        np.add(out, C15, out)
        np.multiply(out, w3, out)
        np.add(out, C16, out)
        np.multiply(out, w3, out)
        np.add(out, C17, out)
        np.multiply(out, w3, out)
        np.add(out, C18, out)
        np.multiply(out, w3, out)
        np.add(out, C19, out)
        np.multiply(out, w3, out)
        np.add(out, C20, out)
        np.multiply(out, w3, out)
        np.add(out, C21, out)
        np.multiply(out, w3, out)
        np.add(out, C22, out)
        np.divide(w4, out, out)
        np.multiply(w3, out, out)
        np.add(C23, out, out)
        np.multiply(w5, out, out)
        np.multiply(w2, out, out)
        np.greater(w6, C24, m1)
        some118 = np.count_nonzero(m1)
        if some118:
            np.subtract(r, a, w2)
            np.add(r, a, w5)
            np.multiply(w2, w5, w5)
            np.sqrt(w5, w5)
            np.arctan2(a, w5, w5)
            np.maximum(w6, f0, out=w2)
            np.multiply(w2, w5, w2)
        if some118 != size:
            np.copyto(w2, C24, where=~m1)
        np.add(out, w2, w2)
        np.multiply(C25, w2, out)
    if some130 != size:
        other130 = w2 if some130 else out
        np.less_equal(r, a, m1)
        some128 = np.count_nonzero(m1)
        if some128:
            np.square(r, other130)
            np.multiply(C0, R, w6)
            np.divide(other130, w6, other130)
        if some128 != size:
            np.copyto(other130, C26, where=~m1)
        np.subtract(d, other130, other130)
        if some130:
            np.copyto(out, other130, where=~m0)


def force(d, a, R, E_star):
    if d.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v4 = R * d
            v5 = a * a
            v8 = 134217729.0 * R
            v10 = v8 - (v8 - R)
            v11 = R - v10
            v12 = 134217729.0 * d
            v14 = v12 - (v12 - d)
            v15 = d - v14
            v24 = 134217729.0 * a
            v26 = v24 - (v24 - a)
            v27 = a - v26
            v38 = (v4 - v5 + (v10 * v14 - v4 + v10 * v15 + v11 * v14 + v11 * v15 - (v26 * v26 - v5 + v26 * v27 + v27 * v26 + v27 * v27))) / R
            v39 = sqrt(v4)
            v48 = a * a / R
            value = 4.0 * E_star / 3.0 * (v39 if v39 < a or v39 != v39 else a) * (d if d < v48 or d != d else v48) + 2.0 * E_star * a * (v38 if v38 > 0.0 or v38 != v38 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_d(a, R, E_star):
    v5 = a * a
    v8 = (134217729.0) * R
    v9 = v8 - R
    v10 = v8 - v9
    v11 = R - v10
    v24 = (134217729.0) * a
    v25 = v24 - a
    v26 = v24 - v25
    v27 = a - v26
    v28 = v26 * v26
    v29 = v28 - v5
    v30 = v26 * v27
    v31 = v29 + v30
    v32 = v27 * v26
    v33 = v31 + v32
    v34 = v27 * v27
    v35 = v33 + v34
    v42 = (4.0) * E_star
    v44 = v42 / (3.0)
    v47 = np.square(a)
    v48 = v47 / R
    v51 = (2.0) * E_star
    v52 = v51 * a
    return (a, R, v5, v10, v11, v35, v44, v48, v52)


def block_force_d(out, d, a, R, v5, v10, v11, v35, v44, v48, v52, w0, w1, w2, w3, w4, f0):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.subtract(out, v5, w0)
    np.multiply(C27, d, w1)
    np.subtract(w1, d, w2)
    np.subtract(w1, w2, w2)
    np.subtract(d, w2, w1)
    np.multiply(v10, w2, w3)
    np.subtract(w3, out, w3)
    np.multiply(v10, w1, w4)
    np.add(w3, w4, w4)
    np.multiply(v11, w2, w2)
    np.add(w4, w2, w2)
    np.multiply(v11, w1, w1)
    np.add(w2, w1, w1)
    np.subtract(w1, v35, w1)
    np.add(w0, w1, w1)
    np.divide(w1, R, w1)
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(v44, out, out)
    np.minimum(d, v48, out=w0)
    np.multiply(out, w0, w0)
    np.maximum(w1, f0, out=w1)
    np.multiply(v52, w1, w1)
    np.add(w0, w1, out)


def prepare_force_all():
    return ()


def block_force_all(out, d, a, R, E_star, w0, w1, w2, w3, w4, w5, w6, f0):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(a, a, w0)
    np.subtract(out, w0, w1)
    np.multiply(C27, R, w2)
    np.subtract(w2, R, w3)
    np.subtract(w2, w3, w3)
    np.subtract(R, w3, w2)
    np.multiply(C27, d, w4)
    np.subtract(w4, d, w5)
    np.subtract(w4, w5, w5)
    np.subtract(d, w5, w4)
    np.multiply(w3, w5, w6)
    np.subtract(w6, out, w6)
    np.multiply(w3, w4, w3)
    np.add(w6, w3, w3)
    np.multiply(w2, w5, w5)
    np.add(w3, w5, w5)
    np.multiply(w2, w4, w4)
    np.add(w5, w4, w4)
    np.multiply(C27, a, w5)
    np.subtract(w5, a, w2)
    np.subtract(w5, w2, w2)
    np.subtract(a, w2, w5)
    np.multiply(w2, w2, w3)
    np.subtract(w3, w0, w0)
    np.multiply(w2, w5, w3)
    np.add(w0, w3, w3)
    np.multiply(w5, w2, w2)
    np.add(w3, w2, w2)
    np.multiply(w5, w5, w5)
    np.add(w2, w5, w5)
    np.subtract(w4, w5, w5)
    np.add(w1, w5, w5)
    np.divide(w5, R, w5)
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(C2, E_star, w1)
    np.divide(w1, C3, w1)
    np.multiply(w1, out, out)
    np.square(a, w1)
    np.divide(w1, R, w1)
    np.minimum(d, w1, out=w1)
    np.multiply(out, w1, w1)
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)
    np.maximum(w5, f0, out=w5)
    np.multiply(out, w5, w5)
    np.add(w1, w5, out)


def pressure(r, d, a, R, E_star):
    if r.__class__ is d.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r <= a:
                v5 = R * d
                v6 = a * a
                v9 = 134217729.0 * R
                v11 = v9 - (v9 - R)
                v12 = R - v11
                v13 = 134217729.0 * d
                v15 = v13 - (v13 - d)
                v16 = d - v15
                v24 = v11 * v15 - v5 + v11 * v16 + v12 * v15 + v12 * v16
                v25 = 134217729.0 * a
                v27 = v25 - (v25 - a)
                v28 = a - v27
                v39 = (v5 - v6 + (v24 - (v27 * v27 - v6 + v27 * v28 + v28 * v27 + v28 * v28))) / R
                v41 = v39 > 0.0
                v44 = (a - r) * (a + r)
                if v41:
                    v61 = v44
                else:
                    v45 = r * r
                    v47 = 134217729.0 * r
                    v49 = v47 - (v47 - r)
                    v50 = r - v49
                    v61 = v5 - v45 + (v24 - (v49 * v49 - v45 + v49 * v50 + v50 * v49 + v50 * v50))
                value = 2.0 * E_star * sqrt(v61 if v61 > 0.0 or v61 != v61 else 0.0) / (3.141592653589793 * R) + (E_star / 3.141592653589793 * v39 / sqrt(v44) if v41 else 0.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, R, E_star):
    v5 = R * d
    v6 = a * a
    v7 = v5 - v6
    v9 = (134217729.0) * R
    v10 = v9 - R
    v11 = v9 - v10
    v12 = R - v11
    v13 = (134217729.0) * d
    v14 = v13 - d
    v15 = v13 - v14
    v16 = d - v15
    v17 = v11 * v15
    v18 = v17 - v5
    v19 = v11 * v16
    v20 = v18 + v19
    v21 = v12 * v15
    v22 = v20 + v21
    v23 = v12 * v16
    v24 = v22 + v23
    v25 = (134217729.0) * a
    v26 = v25 - a
    v27 = v25 - v26
    v28 = a - v27
    v29 = v27 * v27
    v30 = v29 - v6
    v31 = v27 * v28
    v32 = v30 + v31
    v33 = v28 * v27
    v34 = v32 + v33
    v35 = v28 * v28
    v36 = v34 + v35
    v37 = v24 - v36
    v38 = v7 + v37
    v39 = v38 / R
    v41 = np.greater(v39, (0.0))
    v65 = (2.0) * E_star
    v68 = (3.141592653589793) * R
    v70 = E_star / (3.141592653589793)
    v71 = v70 * v39
    return (a, v5, v24, v41, v65, v68, v71)


def block_pressure_r(out, r, a, v5, v24, v41, v65, v68, v71, w0, w1, w2, w3, w4, m0, f0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some77 = np.count_nonzero(m0)
    if some77:
        np.subtract(a, r, out)
        np.add(a, r, w0)
        np.multiply(out, w0, w0)
        if v41:
            np.copyto(out, w0)
        else:
            np.multiply(r, r, out)
            np.subtract(v5, out, w1)
            np.multiply(C27, r, w2)
            np.subtract(w2, r, w3)
            np.subtract(w2, w3, w3)
            np.subtract(r, w3, w2)
            np.multiply(w3, w3, w4)
            np.subtract(w4, out, out)
            np.multiply(w3, w2, w4)
            np.add(out, w4, w4)
            np.multiply(w2, w3, w3)
            np.add(w4, w3, w3)
            np.multiply(w2, w2, w2)
            np.add(w3, w2, w2)
            np.subtract(v24, w2, w2)
            np.add(w1, w2, out)
        np.maximum(out, f0, out=out)
        np.sqrt(out, out)
        np.multiply(v65, out, out)
        np.divide(out, v68, out)
        if v41:
            np.sqrt(w0, w2)
            np.divide(v71, w2, w2)
        else:
            np.copyto(w2, C24)
        np.add(out, w2, out)
    if some77 != size:
        np.copyto(out, C24, where=~m0)


def prepare_pressure_r_d(a, R, E_star):
    v6 = a * a
    v9 = (134217729.0) * R
    v10 = v9 - R
    v11 = v9 - v10
    v12 = R - v11
    v25 = (134217729.0) * a
    v26 = v25 - a
    v27 = v25 - v26
    v28 = a - v27
    v29 = v27 * v27
    v30 = v29 - v6
    v31 = v27 * v28
    v32 = v30 + v31
    v33 = v28 * v27
    v34 = v32 + v33
    v35 = v28 * v28
    v36 = v34 + v35
    v65 = (2.0) * E_star
    v68 = (3.141592653589793) * R
    v70 = E_star / (3.141592653589793)
    return (a, R, v6, v11, v12, v36, v65, v68, v70)


def block_pressure_r_d(out, r, d, a, R, v6, v11, v12, v36, v65, v68, v70, w0, w1, w2, w3, w4, w5, w6, w7, w8, m0, m1, f0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some77 = np.count_nonzero(m0)
    if some77:
        np.multiply(R, d, out)
        np.subtract(out, v6, w0)
        np.multiply(C27, d, w1)
        np.subtract(w1, d, w2)
        np.subtract(w1, w2, w2)
        np.subtract(d, w2, w1)
        np.multiply(v11, w2, w3)
        np.subtract(w3, out, w3)
        np.multiply(v11, w1, w4)
        np.add(w3, w4, w4)
        np.multiply(v12, w2, w2)
        np.add(w4, w2, w2)
        np.multiply(v12, w1, w1)
        np.add(w2, w1, w1)
        np.subtract(w1, v36, w2)
        np.add(w0, w2, w2)
        np.divide(w2, R, w2)
        np.greater(w2, C24, m1)
        np.subtract(a, r, w0)
        np.add(a, r, w4)
        np.multiply(w0, w4, w4)
        some61 = np.count_nonzero(m1)
        if some61:
            np.copyto(w0, w4)
        if some61 != size:
            other61 = w3 if some61 else w0
            np.multiply(r, r, other61)
            np.subtract(out, other61, w5)
            np.multiply(C27, r, w6)
            np.subtract(w6, r, w7)
            np.subtract(w6, w7, w7)
            np.subtract(r, w7, w6)
            np.multiply(w7, w7, w8)
            np.subtract(w8, other61, other61)
            np.multiply(w7, w6, w8)
            np.add(other61, w8, w8)
            np.multiply(w6, w7, w7)
            np.add(w8, w7, w7)
            np.multiply(w6, w6, w6)
            np.add(w7, w6, w6)
            np.subtract(w1, w6, w6)
            np.add(w5, w6, other61)
            if some61:
                np.copyto(w0, other61, where=~m1)
        np.maximum(w0, f0, out=w0)
        np.sqrt(w0, w0)
        np.multiply(v65, w0, w0)
        np.divide(w0, v68, w0)
        some74 = np.count_nonzero(m1)
        if some74:
            np.multiply(v70, w2, w1)
            np.sqrt(w4, out)
            np.divide(w1, out, w1)
        if some74 != size:
            np.copyto(w1, C24, where=~m1)
        np.add(w0, w1, out)
    if some77 != size:
        np.copyto(out, C24, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, R, E_star, w0, w1, w2, w3, w4, w5, w6, w7, w8, m0, m1, f0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some77 = np.count_nonzero(m0)
    if some77:
        np.multiply(R, d, out)
        np.multiply(a, a, w0)
        np.subtract(out, w0, w1)
        np.multiply(C27, R, w2)
        np.subtract(w2, R, w3)
        np.subtract(w2, w3, w3)
        np.subtract(R, w3, w2)
        np.multiply(C27, d, w4)
        np.subtract(w4, d, w5)
        np.subtract(w4, w5, w5)
        np.subtract(d, w5, w4)
        np.multiply(w3, w5, w6)
        np.subtract(w6, out, w6)
        np.multiply(w3, w4, w3)
        np.add(w6, w3, w3)
        np.multiply(w2, w5, w5)
        np.add(w3, w5, w5)
        np.multiply(w2, w4, w4)
        np.add(w5, w4, w4)
        np.multiply(C27, a, w5)
        np.subtract(w5, a, w2)
        np.subtract(w5, w2, w2)
        np.subtract(a, w2, w5)
        np.multiply(w2, w2, w3)
        np.subtract(w3, w0, w0)
        np.multiply(w2, w5, w3)
        np.add(w0, w3, w3)
        np.multiply(w5, w2, w2)
        np.add(w3, w2, w2)
        np.multiply(w5, w5, w5)
        np.add(w2, w5, w5)
        np.subtract(w4, w5, w5)
        np.add(w1, w5, w5)
        np.divide(w5, R, w5)
        np.greater(w5, C24, m1)
        np.subtract(a, r, w1)
        np.add(a, r, w2)
        np.multiply(w1, w2, w2)
        some61 = np.count_nonzero(m1)
        if some61:
            np.copyto(w1, w2)
        if some61 != size:
            other61 = w3 if some61 else w1
            np.multiply(r, r, other61)
            np.subtract(out, other61, w0)
            np.multiply(C27, r, w6)
            np.subtract(w6, r, w7)
            np.subtract(w6, w7, w7)
            np.subtract(r, w7, w6)
            np.multiply(w7, w7, w8)
            np.subtract(w8, other61, other61)
            np.multiply(w7, w6, w8)
            np.add(other61, w8, w8)
            np.multiply(w6, w7, w7)
            np.add(w8, w7, w7)
            np.multiply(w6, w6, w6)
            np.add(w7, w6, w6)
            np.subtract(w4, w6, w6)
            np.add(w0, w6, other61)
            if some61:
                np.copyto(w1, other61, where=~m1)
        np.maximum(w1, f0, out=w1)
        np.sqrt(w1, w1)
        np.multiply(C0, E_star, w4)
        np.multiply(w4, w1, w1)
        np.multiply(C28, R, w4)
        np.divide(w1, w4, w4)
        some74 = np.count_nonzero(m1)
        if some74:
            np.divide(E_star, C28, w1)
            np.multiply(w1, w5, w1)
            np.sqrt(w2, out)
            np.divide(w1, out, w1)
        if some74 != size:
            np.copyto(w1, C24, where=~m1)
        np.add(w4, w1, out)
    if some77 != size:
        np.copyto(out, C24, where=~m0)


def profile(r, a, R):
    if r.__class__ is a.__class__ is R.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            if r <= a:
                return r * r / (2.0 * R)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(a, R):
    v6 = (2.0) * R
    return (a, v6)


def block_profile_r(out, r, a, v6, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some9 = np.count_nonzero(m0)
    if some9:
        np.square(r, out)
        np.divide(out, v6, out)
    if some9 != size:
        np.copyto(out, C26, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, a, R, w0, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some9 = np.count_nonzero(m0)
    if some9:
        np.square(r, out)
        np.multiply(C0, R, w0)
        np.divide(out, w0, out)
    if some9 != size:
        np.copyto(out, C26, where=~m0)


def stiffness(d, a, R, E_star):
    if d.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = sqrt(R * d)
            return 2.0 * E_star * (v5 if v5 < a or v5 != v5 else a)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_d(a, R, E_star):
    v8 = (2.0) * E_star
    return (a, R, v8)


def block_stiffness_d(out, d, a, R, v8):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(v8, out, out)


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, d, a, R, E_star, w0):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(C0, E_star, w0)
    np.multiply(w0, out, out)


BLOCKS = {
    ('_depth_from_force', 1, 'F', 'a', 'R', 'E_star'): {
        ('F',): Program(('F',), prepare_depth_from_force_F, block_depth_from_force_F, scratch=1, masks=1),
        ('F', 'a', 'R', 'E_star'): Program(('F', 'a', 'R', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, scratch=4, masks=1),
    },
    ('_displacement', 2, 'r', 'd', 'a', 'R'): {
        ('r',): Program(('r',), prepare_displacement_r, block_displacement_r, scratch=3, masks=2),
        ('r', 'd'): Program(('r', 'd'), prepare_displacement_r_d, block_displacement_r_d, scratch=7, masks=2, filled=(0.0,)),
        ('r', 'd', 'a', 'R'): Program(('r', 'd', 'a', 'R'), prepare_displacement_all, block_displacement_all, scratch=8, masks=2, filled=(0.0,)),
    },
    ('_force', 1, 'd', 'a', 'R', 'E_star'): {
        ('d',): Program(('d',), prepare_force_d, block_force_d, scratch=5, filled=(0.0,)),
        ('d', 'a', 'R', 'E_star'): Program(('d', 'a', 'R', 'E_star'), prepare_force_all, block_force_all, scratch=7, filled=(0.0,)),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'R', 'E_star'): {
        ('r',): Program(('r',), prepare_pressure_r, block_pressure_r, scratch=5, masks=1, filled=(0.0,)),
        ('r', 'd'): Program(('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, scratch=9, masks=2, filled=(0.0,)),
        ('r', 'd', 'a', 'R', 'E_star'): Program(('r', 'd', 'a', 'R', 'E_star'), prepare_pressure_all, block_pressure_all, scratch=9, masks=2, filled=(0.0,)),
    },
    ('_profile', 1, 'r', 'a', 'R'): {
        ('r',): Program(('r',), prepare_profile_r, block_profile_r, masks=1),
        ('r', 'a', 'R'): Program(('r', 'a', 'R'), prepare_profile_all, block_profile_all, scratch=1, masks=1),
    },
    ('_stiffness', 1, 'd', 'a', 'R', 'E_star'): {
        ('d',): Program(('d',), prepare_stiffness_d, block_stiffness_d),
        ('d', 'a', 'R', 'E_star'): Program(('d', 'a', 'R', 'E_star'), prepare_stiffness_all, block_stiffness_all, scratch=1),
    },
}
