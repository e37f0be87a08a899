"""Programs of axicontact.normal.capped_cylinder."""

from __future__ import annotations

from math import atan2, cbrt, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest

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
C28 = np.array(5.0)
C29 = np.array(8.0)
C30 = np.array(15.0)
C31 = np.array(-2.0)
C32 = np.array(3.141592653589793)


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


def block_depth_from_force_F(out, F, v12, v19, v23, v25, t0, m0):
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
        other28 = t0 if some28 else out
        np.divide(F, v23, other28)
        np.add(other28, v25, other28)
        if some28:
            np.copyto(out, other28, where=~m0)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, a, R, E_star, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(C2, E_star, t0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C3, R, t1)
    np.divide(t0, t1, t0)
    np.square(a, t2)
    np.multiply(a, t2, t3)
    np.multiply(t0, t3, t3)
    np.greater(t3, F, m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.square(F, out)
        np.multiply(C1, out, out)
        np.square(E_star, t3)
        np.multiply(C4, t3, t3)
        np.multiply(t3, R, t3)
        np.divide(out, t3, t3)
        np.cbrt(t3, out)
    if some28 != size:
        other28 = t3 if some28 else out
        np.multiply(C0, E_star, other28)
        np.multiply(other28, a, other28)
        np.divide(F, other28, other28)
        np.divide(t2, t1, t0)
        np.add(other28, t0, other28)
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


def block_displacement_r(out, r, d, a, v40, v44, v115, v116, v125, t0, t1, t2, m0, m1):
    size = out.size
    np.greater(r, v40, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some130 = np.count_nonzero(m0)
    if some130:
        np.subtract(r, v40, out)
        np.add(r, v40, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(r, t0, t0)
        np.divide(v40, t0, t0)
        np.divide(v40, r, out)
        np.multiply(t0, t0, t0)
        np.multiply(C5, t0, t1)
        np.add(t1, C6, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C7, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C8, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C9, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C10, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C11, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C12, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C13, t1)
        np.multiply(C14, t0, t2)
        np.add(t2, C15, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C16, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C17, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C18, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C19, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C20, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C21, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C22, t2)
        np.divide(t1, t2, t2)
        np.multiply(t0, t2, t2)
        np.add(C23, t2, t2)
        np.multiply(out, t2, t2)
        np.multiply(v44, t2, t2)
        if v115:
            np.subtract(r, a, out)
            np.add(r, a, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.arctan2(a, t0, t0)
            np.multiply(v116, t0, out)
        else:
            np.copyto(out, C24)
        np.add(t2, out, out)
        np.multiply(C25, out, out)
    if some130 != size:
        other130 = t2 if some130 else out
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


def block_displacement_r_d(out, r, d, a, R, v5, v10, v11, v35, v43, v125, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.multiply(R, d, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(t0, t1)
    np.minimum(t1, a, out=t1)
    np.greater(r, t1, m0)
    some130 = np.count_nonzero(m0)
    if some130:
        np.subtract(t0, v5, out)
        np.multiply(C27, d, t2)
        np.subtract(t2, d, t3)
        np.subtract(t2, t3, t3)
        np.subtract(d, t3, t2)
        np.multiply(v10, t3, t4)
        np.subtract(t4, t0, t4)
        np.multiply(v10, t2, t5)
        np.add(t4, t5, t5)
        np.multiply(v11, t3, t3)
        np.add(t5, t3, t3)
        np.multiply(v11, t2, t2)
        np.add(t3, t2, t2)
        np.subtract(t2, v35, t2)
        np.add(out, t2, t2)
        np.divide(t2, R, t2)
        np.minimum(d, v43, out=out)
        np.subtract(r, t1, t3)
        np.add(r, t1, t5)
        np.multiply(t3, t5, t5)
        np.sqrt(t5, t5)
        np.add(r, t5, t5)
        np.divide(t1, t5, t5)
        np.divide(t1, r, t3)
        np.multiply(t5, t5, t5)
        np.multiply(C5, t5, t4)
        np.add(t4, C6, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C7, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C8, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C9, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C10, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C11, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C12, t4)
        np.multiply(t4, t5, t4)
        np.add(t4, C13, t4)
        np.multiply(C14, t5, t6)
        np.add(t6, C15, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C16, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C17, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C18, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C19, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C20, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C21, t6)
        np.multiply(t6, t5, t6)
        np.add(t6, C22, t6)
        np.divide(t4, t6, t6)
        np.multiply(t5, t6, t6)
        np.add(C23, t6, t6)
        np.multiply(t3, t6, t6)
        np.multiply(out, t6, t6)
        np.greater(t2, C24, m1)
        some118 = np.count_nonzero(m1)
        if some118:
            np.subtract(r, a, out)
            np.add(r, a, t3)
            np.multiply(out, t3, t3)
            np.sqrt(t3, t3)
            np.arctan2(a, t3, t3)
            np.maximum(t2, f0, out=out)
            np.multiply(out, t3, out)
        if some118 != size:
            np.copyto(out, C24, where=~m1)
        np.add(t6, out, out)
        np.multiply(C25, out, out)
    if some130 != size:
        other130 = t6 if some130 else out
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


def block_displacement_all(out, r, d, a, R, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.multiply(R, d, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(t0, t1)
    np.minimum(t1, a, out=t1)
    np.greater(r, t1, m0)
    some130 = np.count_nonzero(m0)
    if some130:
        np.multiply(a, a, out)
        np.subtract(t0, out, t2)
        np.multiply(C27, R, t3)
        np.subtract(t3, R, t4)
        np.subtract(t3, t4, t4)
        np.subtract(R, t4, t3)
        np.multiply(C27, d, t5)
        np.subtract(t5, d, t6)
        np.subtract(t5, t6, t6)
        np.subtract(d, t6, t5)
        np.multiply(t4, t6, t7)
        np.subtract(t7, t0, t7)
        np.multiply(t4, t5, t4)
        np.add(t7, t4, t4)
        np.multiply(t3, t6, t6)
        np.add(t4, t6, t6)
        np.multiply(t3, t5, t5)
        np.add(t6, t5, t5)
        np.multiply(C27, a, t6)
        np.subtract(t6, a, t3)
        np.subtract(t6, t3, t3)
        np.subtract(a, t3, t6)
        np.multiply(t3, t3, t4)
        np.subtract(t4, out, out)
        np.multiply(t3, t6, t4)
        np.add(out, t4, t4)
        np.multiply(t6, t3, t3)
        np.add(t4, t3, t3)
        np.multiply(t6, t6, t6)
        np.add(t3, t6, t6)
        np.subtract(t5, t6, t6)
        np.add(t2, t6, t6)
        np.divide(t6, R, t6)
        np.square(a, t2)
        np.divide(t2, R, t2)
        np.minimum(d, t2, out=t2)
        np.subtract(r, t1, t5)
        np.add(r, t1, t3)
        np.multiply(t5, t3, t3)
        np.sqrt(t3, t3)
        np.add(r, t3, t3)
        np.divide(t1, t3, t3)
        np.divide(t1, r, t5)
        np.multiply(t3, t3, t3)
        np.multiply(C5, t3, t4)
        np.add(t4, C6, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C7, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C8, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C9, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C10, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C11, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C12, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C13, t4)
        np.multiply(C14, t3, out)
        np.add(out, C15, out)
        np.multiply(out, t3, out)
        np.add(out, C16, out)
        np.multiply(out, t3, out)
        np.add(out, C17, out)
        np.multiply(out, t3, out)
        np.add(out, C18, out)
        np.multiply(out, t3, out)
        np.add(out, C19, out)
        np.multiply(out, t3, out)
        np.add(out, C20, out)
        np.multiply(out, t3, out)
        np.add(out, C21, out)
        np.multiply(out, t3, out)
        np.add(out, C22, out)
        np.divide(t4, out, out)
        np.multiply(t3, out, out)
        np.add(C23, out, out)
        np.multiply(t5, out, out)
        np.multiply(t2, out, out)
        np.greater(t6, C24, m1)
        some118 = np.count_nonzero(m1)
        if some118:
            np.subtract(r, a, t2)
            np.add(r, a, t5)
            np.multiply(t2, t5, t5)
            np.sqrt(t5, t5)
            np.arctan2(a, t5, t5)
            np.maximum(t6, f0, out=t2)
            np.multiply(t2, t5, t2)
        if some118 != size:
            np.copyto(t2, C24, where=~m1)
        np.add(out, t2, t2)
        np.multiply(C25, t2, out)
    if some130 != size:
        other130 = t2 if some130 else out
        np.less_equal(r, a, m1)
        some128 = np.count_nonzero(m1)
        if some128:
            np.square(r, other130)
            np.multiply(C0, R, t6)
            np.divide(other130, t6, other130)
        if some128 != size:
            np.copyto(other130, C26, where=~m1)
        np.subtract(d, other130, other130)
        if some130:
            np.copyto(out, other130, where=~m0)


def energy(d, a, R, E_star):
    if d.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v4 = R * d
            v5 = sqrt(v4)
            v10 = R * R
            if v5 > a:
                v23 = a * a
                v31 = -E_star / (3.0 * v10) * a * (v23 - v4) * (v23 + 3.0 * R * d)
            else:
                v31 = 0.0
            return 8.0 * E_star / (15.0 * v10) * pow(v5 if v5 < a or v5 != v5 else a, 5.0) + v31
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_d(a, R, E_star):
    v8 = (8.0) * E_star
    v10 = np.square(R)
    v12 = (15.0) * v10
    v13 = v8 / v12
    v18 = np.negative(E_star)
    v20 = (3.0) * v10
    v21 = v18 / v20
    v22 = v21 * a
    v23 = np.square(a)
    v26 = (3.0) * R
    return (a, R, v13, v22, v23, v26)


def block_energy_d(out, d, a, R, v13, v22, v23, v26, t0, t1, t2, m0):
    size = out.size
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, t0)
    np.minimum(t0, a, out=t1)
    np.power(t1, C28, t1)
    np.multiply(v13, t1, t1)
    np.greater(t0, a, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.subtract(v23, out, t0)
        np.multiply(v22, t0, t0)
        np.multiply(v26, d, t2)
        np.add(v23, t2, t2)
        np.multiply(t0, t2, t0)
    if some31 != size:
        np.copyto(t0, C24, where=~m0)
    np.add(t1, t0, out)


def prepare_energy_all():
    return ()


def block_energy_all(out, d, a, R, E_star, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, t0)
    np.minimum(t0, a, out=t1)
    np.multiply(C29, E_star, t2)
    np.square(R, t3)
    np.multiply(C30, t3, t4)
    np.divide(t2, t4, t4)
    np.power(t1, C28, t1)
    np.multiply(t4, t1, t1)
    np.greater(t0, a, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.negative(E_star, t0)
        np.multiply(C3, t3, t4)
        np.divide(t0, t4, t4)
        np.multiply(t4, a, t4)
        np.square(a, t0)
        np.subtract(t0, out, t2)
        np.multiply(t4, t2, t2)
        np.multiply(C3, R, t4)
        np.multiply(t4, d, t4)
        np.add(t0, t4, t4)
        np.multiply(t2, t4, t0)
    if some31 != size:
        np.copyto(t0, C24, where=~m0)
    np.add(t1, t0, out)


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


def block_force_d(out, d, a, R, v5, v10, v11, v35, v44, v48, v52, t0, t1, t2, t3, t4, f0):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.subtract(out, v5, t0)
    np.multiply(C27, d, t1)
    np.subtract(t1, d, t2)
    np.subtract(t1, t2, t2)
    np.subtract(d, t2, t1)
    np.multiply(v10, t2, t3)
    np.subtract(t3, out, t3)
    np.multiply(v10, t1, t4)
    np.add(t3, t4, t4)
    np.multiply(v11, t2, t2)
    np.add(t4, t2, t2)
    np.multiply(v11, t1, t1)
    np.add(t2, t1, t1)
    np.subtract(t1, v35, t1)
    np.add(t0, t1, t1)
    np.divide(t1, R, t1)
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(v44, out, out)
    np.minimum(d, v48, out=t0)
    np.multiply(out, t0, t0)
    np.maximum(t1, f0, out=t1)
    np.multiply(v52, t1, t1)
    np.add(t0, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, d, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, f0):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(a, a, t0)
    np.subtract(out, t0, t1)
    np.multiply(C27, R, t2)
    np.subtract(t2, R, t3)
    np.subtract(t2, t3, t3)
    np.subtract(R, t3, t2)
    np.multiply(C27, d, t4)
    np.subtract(t4, d, t5)
    np.subtract(t4, t5, t5)
    np.subtract(d, t5, t4)
    np.multiply(t3, t5, t6)
    np.subtract(t6, out, t6)
    np.multiply(t3, t4, t3)
    np.add(t6, t3, t3)
    np.multiply(t2, t5, t5)
    np.add(t3, t5, t5)
    np.multiply(t2, t4, t4)
    np.add(t5, t4, t4)
    np.multiply(C27, a, t5)
    np.subtract(t5, a, t2)
    np.subtract(t5, t2, t2)
    np.subtract(a, t2, t5)
    np.multiply(t2, t2, t3)
    np.subtract(t3, t0, t0)
    np.multiply(t2, t5, t3)
    np.add(t0, t3, t3)
    np.multiply(t5, t2, t2)
    np.add(t3, t2, t2)
    np.multiply(t5, t5, t5)
    np.add(t2, t5, t5)
    np.subtract(t4, t5, t5)
    np.add(t1, t5, t5)
    np.divide(t5, R, t5)
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(C2, E_star, t1)
    np.divide(t1, C3, t1)
    np.multiply(t1, out, out)
    np.square(a, t1)
    np.divide(t1, R, t1)
    np.minimum(d, t1, out=t1)
    np.multiply(out, t1, t1)
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)
    np.maximum(t5, f0, out=t5)
    np.multiply(out, t5, t5)
    np.add(t1, t5, out)


def load_within(r, d, a, R, E_star):
    if r.__class__ is d.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = R * d
            v6 = sqrt(v5)
            v7 = v6 if v6 < a or v6 != v6 else a
            v17 = 4.0 * E_star
            v33 = a * a
            if r < v7:
                v15 = sqrt((v7 - r) * (v7 + r))
                v22 = r * r
                return v17 / (3.0 * R) * v22 * (v15 + v7 * v7 / (v7 + v15)) + (-2.0 * E_star * v22 * (v33 - v5) / (R * (sqrt((a - r) * (a + r)) + a)) if v6 > a else 0.0)
            v43 = a * a
            v46 = 134217729.0 * R
            v48 = v46 - (v46 - R)
            v49 = R - v48
            v50 = 134217729.0 * d
            v52 = v50 - (v50 - d)
            v53 = d - v52
            v62 = 134217729.0 * a
            v64 = v62 - (v62 - a)
            v65 = a - v64
            v76 = (v5 - v43 + (v48 * v52 - v5 + v48 * v53 + v49 * v52 + v49 * v53 - (v64 * v64 - v43 + v64 * v65 + v65 * v64 + v65 * v65))) / R
            v79 = v33 / R
            value = v17 / 3.0 * v7 * (d if d < v79 or d != d else v79) + 2.0 * E_star * a * (v76 if v76 > 0.0 or v76 != v76 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(d, a, R, E_star):
    v5 = R * d
    v6 = np.sqrt(v5)
    v7 = np.minimum(v6, a)
    v17 = (4.0) * E_star
    v19 = (3.0) * R
    v20 = v17 / v19
    v24 = np.square(v7)
    v29 = np.greater(v6, a)
    v31 = (-2.0) * E_star
    v33 = np.square(a)
    v34 = v33 - v5
    v43 = a * a
    v44 = v5 - v43
    v46 = (134217729.0) * R
    v47 = v46 - R
    v48 = v46 - v47
    v49 = R - v48
    v50 = (134217729.0) * d
    v51 = v50 - d
    v52 = v50 - v51
    v53 = d - v52
    v54 = v48 * v52
    v55 = v54 - v5
    v56 = v48 * v53
    v57 = v55 + v56
    v58 = v49 * v52
    v59 = v57 + v58
    v60 = v49 * v53
    v61 = v59 + v60
    v62 = (134217729.0) * a
    v63 = v62 - a
    v64 = v62 - v63
    v65 = a - v64
    v66 = v64 * v64
    v67 = v66 - v43
    v68 = v64 * v65
    v69 = v67 + v68
    v70 = v65 * v64
    v71 = v69 + v70
    v72 = v65 * v65
    v73 = v71 + v72
    v74 = v61 - v73
    v75 = v44 + v74
    v76 = v75 / R
    v77 = v17 / (3.0)
    v78 = v77 * v7
    v79 = v33 / R
    v80 = np.minimum(d, v79)
    v81 = v78 * v80
    v82 = (2.0) * E_star
    v83 = v82 * a
    v84 = np.maximum(v76, (0.0))
    v85 = v83 * v84
    v86 = v81 + v85
    return (a, R, v7, v20, v24, v29, v31, v34, v86)


def block_load_within_r(out, r, a, R, v7, v20, v24, v29, v31, v34, v86, t0, t1, t2, m0):
    size = out.size
    np.less(r, v7, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some87 = np.count_nonzero(m0)
    if some87:
        np.subtract(v7, r, out)
        np.add(v7, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.square(r, out)
        np.multiply(v20, out, t1)
        np.add(v7, t0, t2)
        np.divide(v24, t2, t2)
        np.add(t0, t2, t2)
        np.multiply(t1, t2, t2)
        if v29:
            np.subtract(a, r, t1)
            np.add(a, r, t0)
            np.multiply(t1, t0, t0)
            np.sqrt(t0, t0)
            np.multiply(v31, out, t1)
            np.multiply(t1, v34, t1)
            np.add(t0, a, t0)
            np.multiply(R, t0, t0)
            np.divide(t1, t0, t1)
        else:
            np.copyto(t1, C24)
        np.add(t2, t1, out)
    if some87 != size:
        np.copyto(out, v86, where=~m0)


def prepare_load_within_r_d(a, R, E_star):
    v17 = (4.0) * E_star
    v19 = (3.0) * R
    v20 = v17 / v19
    v31 = (-2.0) * E_star
    v33 = np.square(a)
    v43 = a * a
    v46 = (134217729.0) * R
    v47 = v46 - R
    v48 = v46 - v47
    v49 = R - v48
    v62 = (134217729.0) * a
    v63 = v62 - a
    v64 = v62 - v63
    v65 = a - v64
    v66 = v64 * v64
    v67 = v66 - v43
    v68 = v64 * v65
    v69 = v67 + v68
    v70 = v65 * v64
    v71 = v69 + v70
    v72 = v65 * v65
    v73 = v71 + v72
    v77 = v17 / (3.0)
    v79 = v33 / R
    v82 = (2.0) * E_star
    v83 = v82 * a
    return (a, R, v20, v31, v33, v43, v48, v49, v73, v77, v79, v83)


def block_load_within_r_d(out, r, d, a, R, v20, v31, v33, v43, v48, v49, v73, v77, v79, v83, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.multiply(R, d, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(t0, t1)
    np.minimum(t1, a, out=t2)
    np.less(r, t2, m0)
    some87 = np.count_nonzero(m0)
    if some87:
        np.subtract(t2, r, out)
        np.add(t2, r, t3)
        np.multiply(out, t3, t3)
        np.sqrt(t3, t3)
        np.square(r, out)
        np.multiply(v20, out, t4)
        np.square(t2, t5)
        np.add(t2, t3, t6)
        np.divide(t5, t6, t6)
        np.add(t3, t6, t6)
        np.multiply(t4, t6, t6)
        np.greater(t1, a, m1)
        some40 = np.count_nonzero(m1)
        if some40:
            np.subtract(a, r, t4)
            np.add(a, r, t3)
            np.multiply(t4, t3, t3)
            np.sqrt(t3, t3)
            np.multiply(v31, out, t4)
            np.subtract(v33, t0, t5)
            np.multiply(t4, t5, t5)
            np.add(t3, a, t3)
            np.multiply(R, t3, t3)
            np.divide(t5, t3, t4)
        if some40 != size:
            np.copyto(t4, C24, where=~m1)
        np.add(t6, t4, out)
    if some87 != size:
        other87 = t4 if some87 else out
        np.subtract(t0, v43, other87)
        np.multiply(C27, d, t6)
        np.subtract(t6, d, t3)
        np.subtract(t6, t3, t3)
        np.subtract(d, t3, t6)
        np.multiply(v48, t3, t5)
        np.subtract(t5, t0, t5)
        np.multiply(v48, t6, t7)
        np.add(t5, t7, t7)
        np.multiply(v49, t3, t3)
        np.add(t7, t3, t3)
        np.multiply(v49, t6, t6)
        np.add(t3, t6, t6)
        np.subtract(t6, v73, t6)
        np.add(other87, t6, t6)
        np.divide(t6, R, t6)
        np.multiply(v77, t2, other87)
        np.minimum(d, v79, out=t3)
        np.multiply(other87, t3, t3)
        np.maximum(t6, f0, out=t6)
        np.multiply(v83, t6, t6)
        np.add(t3, t6, other87)
        if some87:
            np.copyto(out, other87, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, d, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.multiply(R, d, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(t0, t1)
    np.minimum(t1, a, out=t2)
    np.multiply(C2, E_star, t3)
    np.square(a, t4)
    np.less(r, t2, m0)
    some87 = np.count_nonzero(m0)
    if some87:
        np.subtract(t2, r, out)
        np.add(t2, r, t5)
        np.multiply(out, t5, t5)
        np.sqrt(t5, t5)
        np.multiply(C3, R, out)
        np.divide(t3, out, out)
        np.square(r, t6)
        np.multiply(out, t6, out)
        np.square(t2, t7)
        np.add(t2, t5, t8)
        np.divide(t7, t8, t8)
        np.add(t5, t8, t8)
        np.multiply(out, t8, t8)
        np.greater(t1, a, m1)
        some40 = np.count_nonzero(m1)
        if some40:
            np.subtract(a, r, out)
            np.add(a, r, t5)
            np.multiply(out, t5, t5)
            np.sqrt(t5, t5)
            np.multiply(C31, E_star, out)
            np.multiply(out, t6, out)
            np.subtract(t4, t0, t7)
            np.multiply(out, t7, t7)
            np.add(t5, a, t5)
            np.multiply(R, t5, t5)
            np.divide(t7, t5, out)
        if some40 != size:
            np.copyto(out, C24, where=~m1)
        np.add(t8, out, out)
    if some87 != size:
        other87 = t8 if some87 else out
        np.multiply(a, a, other87)
        np.subtract(t0, other87, t6)
        np.multiply(C27, R, t5)
        np.subtract(t5, R, t7)
        np.subtract(t5, t7, t7)
        np.subtract(R, t7, t5)
        np.multiply(C27, d, t9)
        np.subtract(t9, d, t10)
        np.subtract(t9, t10, t10)
        np.subtract(d, t10, t9)
        np.multiply(t7, t10, t11)
        np.subtract(t11, t0, t11)
        np.multiply(t7, t9, t7)
        np.add(t11, t7, t7)
        np.multiply(t5, t10, t10)
        np.add(t7, t10, t10)
        np.multiply(t5, t9, t9)
        np.add(t10, t9, t9)
        np.multiply(C27, a, t10)
        np.subtract(t10, a, t5)
        np.subtract(t10, t5, t5)
        np.subtract(a, t5, t10)
        np.multiply(t5, t5, t7)
        np.subtract(t7, other87, other87)
        np.multiply(t5, t10, t7)
        np.add(other87, t7, t7)
        np.multiply(t10, t5, t5)
        np.add(t7, t5, t5)
        np.multiply(t10, t10, t10)
        np.add(t5, t10, t10)
        np.subtract(t9, t10, t10)
        np.add(t6, t10, t10)
        np.divide(t10, R, t10)
        np.divide(t3, C3, t6)
        np.multiply(t6, t2, t6)
        np.divide(t4, R, t9)
        np.minimum(d, t9, out=t9)
        np.multiply(t6, t9, t9)
        np.multiply(C0, E_star, t6)
        np.multiply(t6, a, t6)
        np.maximum(t10, f0, out=t10)
        np.multiply(t6, t10, t10)
        np.add(t9, t10, other87)
        if some87:
            np.copyto(out, other87, where=~m0)


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


def block_pressure_r(out, r, a, v5, v24, v41, v65, v68, v71, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some77 = np.count_nonzero(m0)
    if some77:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        if v41:
            np.copyto(out, t0)
        else:
            np.multiply(r, r, out)
            np.subtract(v5, out, t1)
            np.multiply(C27, r, t2)
            np.subtract(t2, r, t3)
            np.subtract(t2, t3, t3)
            np.subtract(r, t3, t2)
            np.multiply(t3, t3, t4)
            np.subtract(t4, out, out)
            np.multiply(t3, t2, t4)
            np.add(out, t4, t4)
            np.multiply(t2, t3, t3)
            np.add(t4, t3, t3)
            np.multiply(t2, t2, t2)
            np.add(t3, t2, t2)
            np.subtract(v24, t2, t2)
            np.add(t1, t2, out)
        np.maximum(out, f0, out=out)
        np.sqrt(out, out)
        np.multiply(v65, out, out)
        np.divide(out, v68, out)
        if v41:
            np.sqrt(t0, t2)
            np.divide(v71, t2, t2)
        else:
            np.copyto(t2, C24)
        np.add(out, t2, out)
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


def block_pressure_r_d(out, r, d, a, R, v6, v11, v12, v36, v65, v68, v70, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1, f0):
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
        np.subtract(out, v6, t0)
        np.multiply(C27, d, t1)
        np.subtract(t1, d, t2)
        np.subtract(t1, t2, t2)
        np.subtract(d, t2, t1)
        np.multiply(v11, t2, t3)
        np.subtract(t3, out, t3)
        np.multiply(v11, t1, t4)
        np.add(t3, t4, t4)
        np.multiply(v12, t2, t2)
        np.add(t4, t2, t2)
        np.multiply(v12, t1, t1)
        np.add(t2, t1, t1)
        np.subtract(t1, v36, t2)
        np.add(t0, t2, t2)
        np.divide(t2, R, t2)
        np.greater(t2, C24, m1)
        np.subtract(a, r, t0)
        np.add(a, r, t4)
        np.multiply(t0, t4, t4)
        some61 = np.count_nonzero(m1)
        if some61:
            np.copyto(t0, t4)
        if some61 != size:
            other61 = t3 if some61 else t0
            np.multiply(r, r, other61)
            np.subtract(out, other61, t5)
            np.multiply(C27, r, t6)
            np.subtract(t6, r, t7)
            np.subtract(t6, t7, t7)
            np.subtract(r, t7, t6)
            np.multiply(t7, t7, t8)
            np.subtract(t8, other61, other61)
            np.multiply(t7, t6, t8)
            np.add(other61, t8, t8)
            np.multiply(t6, t7, t7)
            np.add(t8, t7, t7)
            np.multiply(t6, t6, t6)
            np.add(t7, t6, t6)
            np.subtract(t1, t6, t6)
            np.add(t5, t6, other61)
            if some61:
                np.copyto(t0, other61, where=~m1)
        np.maximum(t0, f0, out=t0)
        np.sqrt(t0, t0)
        np.multiply(v65, t0, t0)
        np.divide(t0, v68, t0)
        some74 = np.count_nonzero(m1)
        if some74:
            np.multiply(v70, t2, t1)
            np.sqrt(t4, out)
            np.divide(t1, out, t1)
        if some74 != size:
            np.copyto(t1, C24, where=~m1)
        np.add(t0, t1, out)
    if some77 != size:
        np.copyto(out, C24, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, R, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1, f0):
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
        np.multiply(a, a, t0)
        np.subtract(out, t0, t1)
        np.multiply(C27, R, t2)
        np.subtract(t2, R, t3)
        np.subtract(t2, t3, t3)
        np.subtract(R, t3, t2)
        np.multiply(C27, d, t4)
        np.subtract(t4, d, t5)
        np.subtract(t4, t5, t5)
        np.subtract(d, t5, t4)
        np.multiply(t3, t5, t6)
        np.subtract(t6, out, t6)
        np.multiply(t3, t4, t3)
        np.add(t6, t3, t3)
        np.multiply(t2, t5, t5)
        np.add(t3, t5, t5)
        np.multiply(t2, t4, t4)
        np.add(t5, t4, t4)
        np.multiply(C27, a, t5)
        np.subtract(t5, a, t2)
        np.subtract(t5, t2, t2)
        np.subtract(a, t2, t5)
        np.multiply(t2, t2, t3)
        np.subtract(t3, t0, t0)
        np.multiply(t2, t5, t3)
        np.add(t0, t3, t3)
        np.multiply(t5, t2, t2)
        np.add(t3, t2, t2)
        np.multiply(t5, t5, t5)
        np.add(t2, t5, t5)
        np.subtract(t4, t5, t5)
        np.add(t1, t5, t5)
        np.divide(t5, R, t5)
        np.greater(t5, C24, m1)
        np.subtract(a, r, t1)
        np.add(a, r, t2)
        np.multiply(t1, t2, t2)
        some61 = np.count_nonzero(m1)
        if some61:
            np.copyto(t1, t2)
        if some61 != size:
            other61 = t3 if some61 else t1
            np.multiply(r, r, other61)
            np.subtract(out, other61, t0)
            np.multiply(C27, r, t6)
            np.subtract(t6, r, t7)
            np.subtract(t6, t7, t7)
            np.subtract(r, t7, t6)
            np.multiply(t7, t7, t8)
            np.subtract(t8, other61, other61)
            np.multiply(t7, t6, t8)
            np.add(other61, t8, t8)
            np.multiply(t6, t7, t7)
            np.add(t8, t7, t7)
            np.multiply(t6, t6, t6)
            np.add(t7, t6, t6)
            np.subtract(t4, t6, t6)
            np.add(t0, t6, other61)
            if some61:
                np.copyto(t1, other61, where=~m1)
        np.maximum(t1, f0, out=t1)
        np.sqrt(t1, t1)
        np.multiply(C0, E_star, t4)
        np.multiply(t4, t1, t1)
        np.multiply(C32, R, t4)
        np.divide(t1, t4, t4)
        some74 = np.count_nonzero(m1)
        if some74:
            np.divide(E_star, C32, t1)
            np.multiply(t1, t5, t1)
            np.sqrt(t2, out)
            np.divide(t1, out, t1)
        if some74 != size:
            np.copyto(t1, C24, where=~m1)
        np.add(t4, t1, out)
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


def block_profile_all(out, r, a, R, t0, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some9 = np.count_nonzero(m0)
    if some9:
        np.square(r, out)
        np.multiply(C0, R, t0)
        np.divide(out, t0, out)
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


def block_stiffness_all(out, d, a, R, E_star, t0):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)
    np.minimum(out, a, out=out)
    np.multiply(C0, E_star, t0)
    np.multiply(t0, out, out)


BLOCKS = {
    ('_depth_from_force', 1, 'F', 'a', 'R', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 1, 1, (), False),
        ('F', 'a', 'R', 'E_star'): (('F', 'a', 'R', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 4, 1, (), False),
    },
    ('_displacement', 2, 'r', 'd', 'a', 'R'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 3, 2, (), False),
        ('r', 'd'): (('r', 'd'), prepare_displacement_r_d, block_displacement_r_d, 7, 2, (0.0,), False),
        ('r', 'd', 'a', 'R'): (('r', 'd', 'a', 'R'), prepare_displacement_all, block_displacement_all, 8, 2, (0.0,), False),
    },
    ('_energy', 1, 'd', 'a', 'R', 'E_star'): {
        ('d',): (('d',), prepare_energy_d, block_energy_d, 3, 1, (), False),
        ('d', 'a', 'R', 'E_star'): (('d', 'a', 'R', 'E_star'), prepare_energy_all, block_energy_all, 5, 1, (), False),
    },
    ('_force', 1, 'd', 'a', 'R', 'E_star'): {
        ('d',): (('d',), prepare_force_d, block_force_d, 5, 0, (0.0,), False),
        ('d', 'a', 'R', 'E_star'): (('d', 'a', 'R', 'E_star'), prepare_force_all, block_force_all, 7, 0, (0.0,), False),
    },
    ('_load_within', 2, 'r', 'd', 'a', 'R', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 3, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_load_within_r_d, block_load_within_r_d, 8, 2, (0.0,), False),
        ('r', 'd', 'a', 'R', 'E_star'): (('r', 'd', 'a', 'R', 'E_star'), prepare_load_within_all, block_load_within_all, 12, 2, (0.0,), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'R', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 5, 1, (0.0,), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 9, 2, (0.0,), False),
        ('r', 'd', 'a', 'R', 'E_star'): (('r', 'd', 'a', 'R', 'E_star'), prepare_pressure_all, block_pressure_all, 9, 2, (0.0,), False),
    },
    ('_profile', 1, 'r', 'a', 'R'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 1, (), False),
        ('r', 'a', 'R'): (('r', 'a', 'R'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_stiffness', 1, 'd', 'a', 'R', 'E_star'): {
        ('d',): (('d',), prepare_stiffness_d, block_stiffness_d, 0, 0, (), False),
        ('d', 'a', 'R', 'E_star'): (('d', 'a', 'R', 'E_star'), prepare_stiffness_all, block_stiffness_all, 1, 0, (), False),
    },
}
