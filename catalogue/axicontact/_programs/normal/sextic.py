"""Programs of axicontact.normal.sextic."""

from __future__ import annotations

from math import inf, pow, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(6.0)
C1 = np.array(16.0)
C2 = np.array(5.0)
C3 = np.array(0.0)
C4 = np.array(np.inf)
C5 = np.array(0.14285714285714285)
C6 = np.array(7.0)
C7 = np.array(1.0)
C8 = np.array(117649.0)
C9 = np.array(933120.0)
C10 = np.array(-1.2774361052403345)
C11 = np.array(-23.178809850601194)
C12 = np.array(-181.92316258227586)
C13 = np.array(-611.3425551498234)
C14 = np.array(-362.00165963521414)
C15 = np.array(2098.825846649865)
C16 = np.array(3992.6681072942106)
C17 = np.array(2012.329045387071)
C18 = np.array(0.44444444444468756)
C19 = np.array(0.008653162919782199)
C20 = np.array(-0.42336499735873506)
C21 = np.array(23.453299031698904)
C22 = np.array(657.0260884407312)
C23 = np.array(4128.7190564480725)
C24 = np.array(10373.373159937977)
C25 = np.array(11371.059137910102)
C26 = np.array(4528.267624848188)
C27 = np.array(0.8571428571428571)
C28 = np.array(32.0)
C29 = np.array(15.707963267948966)
C30 = np.array(13.0)
C31 = np.array(18432.0)
C32 = np.array(2.0)
C33 = np.array(2275.0)
C34 = np.array(192.0)
C35 = np.array(35.0)
C36 = np.array(20.0)
C37 = np.array(0.16666666666666666)
C38 = np.array(8.0)
C39 = np.array(15.0)
C40 = np.array(3.0)
C41 = np.array(4.0)
C42 = np.array(64.0)
C43 = np.array(175.0)
C44 = np.array(109.95574287564276)
C45 = np.array(1.1260325006104943)
C46 = np.array(151.42562584220406)
C47 = np.array(78.53981633974483)
C48 = np.array(0.8264458251405348)


def depth(a, A):
    if a.__class__ is A.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            return 16.0 * A / 5.0 * pow(a, 6.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(A):
    v3 = (16.0) * A
    v5 = v3 / (5.0)
    return (v5,)


def block_depth_a(out, a, v5):
    np.power(a, C0, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v5, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, A, t0):
    np.multiply(C1, A, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, C2, out)
    np.power(a, C0, t0)
    np.multiply(out, t0, out)


def depth_from_force(F, A, E_star):
    if F.__class__ is A.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v3 = F / E_star
            v8 = v3 > 0.0 and v3 < inf
            if v8:
                v10 = pow(v3, 0.14285714285714285)
                v23 = v3 / (v10 + v10 * ((v3 / (pow(v10, 7.0) * pow(v10, 0.0)) - 1.0) / 7.0) if v8 else v10)
            else:
                v23 = v3
            v27 = 117649.0 * A / 933120.0
            v28 = pow(v27, 0.14285714285714285)
            value = v23 * (v28 + v28 * ((v27 / (pow(v28, 7.0) * pow(v28, 0.0)) - 1.0) / 7.0) if v27 > 0.0 and v27 < inf else v28)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(A, E_star):
    v25 = (117649.0) * A
    v27 = v25 / (933120.0)
    v28 = np.power(v27, (0.14285714285714285))
    v29 = np.greater(v27, (0.0))
    v30 = np.less(v27, (np.inf))
    v31 = np.bitwise_and(v29, v30)
    v32 = np.power(v28, (7.0))
    v33 = np.power(v28, (0.0))
    v34 = v32 * v33
    v35 = v27 / v34
    v36 = v35 - (1.0)
    v37 = v36 / (7.0)
    v38 = v28 * v37
    v39 = v28 + v38
    v40 = v39 if v31 else v28
    return (E_star, v40)


def block_depth_from_force_F(out, F, E_star, v40, t0, t1, t2, m0, m1):
    size = out.size
    np.divide(F, E_star, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.greater(out, C3, m0)
    np.less(out, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some23 = np.count_nonzero(m1)
    if some23:
        np.power(out, C5, t0)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(t0, C6, t1)
            np.power(t0, C3, t2)
            np.multiply(t1, t2, t2)
            np.divide(out, t2, t2)
            np.subtract(t2, C7, t2)
            np.divide(t2, C6, t2)
            np.multiply(t0, t2, t2)
            np.add(t0, t2, t1)
        if some21 != size:
            np.copyto(t1, t0, where=~m1)
        np.divide(out, t1, t0)
    if some23 != size:
        np.copyto(t0, out, where=~m1)
    np.multiply(t0, v40, out)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, A, E_star, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.divide(F, E_star, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.greater(out, C3, m0)
    np.less(out, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some23 = np.count_nonzero(m1)
    if some23:
        np.power(out, C5, t0)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(t0, C6, t1)
            np.power(t0, C3, t2)
            np.multiply(t1, t2, t2)
            np.divide(out, t2, t2)
            np.subtract(t2, C7, t2)
            np.divide(t2, C6, t2)
            np.multiply(t0, t2, t2)
            np.add(t0, t2, t1)
        if some21 != size:
            np.copyto(t1, t0, where=~m1)
        np.divide(out, t1, t0)
    if some23 != size:
        np.copyto(t0, out, where=~m1)
    np.multiply(C8, A, out)
    np.divide(out, C9, out)
    np.power(out, C5, t1)
    np.greater(out, C3, m1)
    np.less(out, C4, m0)
    np.bitwise_and(m1, m0, m0)
    some40 = np.count_nonzero(m0)
    if some40:
        np.power(t1, C6, t2)
        np.power(t1, C3, t3)
        np.multiply(t2, t3, t3)
        np.divide(out, t3, t3)
        np.subtract(t3, C7, t3)
        np.divide(t3, C6, t3)
        np.multiply(t1, t3, t3)
        np.add(t1, t3, t2)
    if some40 != size:
        np.copyto(t2, t1, where=~m0)
    np.multiply(t0, t2, out)


def displacement(r, a, A):
    if r.__class__ is a.__class__ is A.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            v8 = pow(a, 6.0)
            if r > a:
                v15 = a / (r + sqrt((r - a) * (r + a)))
                v17 = v15 * v15
                value = 32.0 * A / 15.707963267948966 * v8 * (a / r * (0.8571428571428571 + v17 * (((((((((-1.2774361052403345 * v17 + -23.178809850601194) * v17 + -181.92316258227586) * v17 + -611.3425551498234) * v17 + -362.00165963521414) * v17 + 2098.825846649865) * v17 + 3992.6681072942106) * v17 + 2012.329045387071) * v17 + 0.44444444444468756) / ((((((((0.008653162919782199 * v17 + -0.42336499735873506) * v17 + 23.453299031698904) * v17 + 657.0260884407312) * v17 + 4128.7190564480725) * v17 + 10373.373159937977) * v17 + 11371.059137910102) * v17 + 4528.267624848188) * v17 + 1.0))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 16.0 * A / 5.0 * v8 - A * pow(r, 6.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, A):
    v4 = (32.0) * A
    v6 = v4 / (15.707963267948966)
    v8 = np.power(a, (6.0))
    v9 = v6 * v8
    v75 = (16.0) * A
    v77 = v75 / (5.0)
    v78 = v77 * v8
    return (a, A, v9, v78)


def block_displacement_r(out, r, a, A, v9, v78, t0, t1, t2, m0):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some83 = np.count_nonzero(m0)
    if some83:
        np.subtract(r, a, out)
        np.add(r, a, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(r, t0, t0)
        np.divide(a, t0, t0)
        np.divide(a, r, out)
        np.multiply(t0, t0, t0)
        np.multiply(C10, t0, t1)
        np.add(t1, C11, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C12, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C13, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C14, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C15, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C16, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C17, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C18, t1)
        np.multiply(C19, t0, t2)
        np.add(t2, C20, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C21, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C22, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C23, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C24, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C25, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C26, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C7, t2)
        np.divide(t1, t2, t2)
        np.multiply(t0, t2, t2)
        np.add(C27, t2, t2)
        np.multiply(out, t2, t2)
        np.multiply(v9, t2, out)
    if some83 != size:
        other83 = t2 if some83 else out
        np.power(r, C0, other83)
        np.multiply(A, other83, other83)
        np.subtract(v78, other83, other83)
        if some83:
            np.copyto(out, other83, where=~m0)


def prepare_displacement_r_a(A):
    v4 = (32.0) * A
    v6 = v4 / (15.707963267948966)
    v75 = (16.0) * A
    v77 = v75 / (5.0)
    return (A, v6, v77)


def block_displacement_r_a(out, r, a, A, v6, v77, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.power(a, C0, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(r, a, m0)
    some83 = np.count_nonzero(m0)
    if some83:
        np.multiply(v6, t0, out)
        np.subtract(r, a, t1)
        np.add(r, a, t2)
        np.multiply(t1, t2, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.divide(a, r, t1)
        np.multiply(t2, t2, t2)
        np.multiply(C10, t2, t3)
        np.add(t3, C11, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C12, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C13, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C14, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C17, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C18, t3)
        np.multiply(C19, t2, t4)
        np.add(t4, C20, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C21, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C22, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C23, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C24, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C25, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C26, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C7, t4)
        np.divide(t3, t4, t4)
        np.multiply(t2, t4, t4)
        np.add(C27, t4, t4)
        np.multiply(t1, t4, t4)
        np.multiply(out, t4, out)
    if some83 != size:
        other83 = t4 if some83 else out
        np.multiply(v77, t0, other83)
        np.power(r, C0, t1)
        np.multiply(A, t1, t1)
        np.subtract(other83, t1, other83)
        if some83:
            np.copyto(out, other83, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, A, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.power(a, C0, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(r, a, m0)
    some83 = np.count_nonzero(m0)
    if some83:
        np.multiply(C28, A, out)
        np.divide(out, C29, out)
        np.multiply(out, t0, out)
        np.subtract(r, a, t1)
        np.add(r, a, t2)
        np.multiply(t1, t2, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.divide(a, r, t1)
        np.multiply(t2, t2, t2)
        np.multiply(C10, t2, t3)
        np.add(t3, C11, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C12, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C13, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C14, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C16, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C17, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C18, t3)
        np.multiply(C19, t2, t4)
        np.add(t4, C20, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C21, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C22, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C23, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C24, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C25, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C26, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C7, t4)
        np.divide(t3, t4, t4)
        np.multiply(t2, t4, t4)
        np.add(C27, t4, t4)
        np.multiply(t1, t4, t4)
        np.multiply(out, t4, out)
    if some83 != size:
        other83 = t4 if some83 else out
        np.multiply(C1, A, other83)
        np.divide(other83, C2, other83)
        np.multiply(other83, t0, other83)
        np.power(r, C0, t1)
        np.multiply(A, t1, t1)
        np.subtract(other83, t1, other83)
        if some83:
            np.copyto(out, other83, where=~m0)


def energy(a, A, E_star):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = 18432.0 * E_star * (A * A) / 2275.0 * pow(a, 13.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_a(A, E_star):
    v4 = (18432.0) * E_star
    v6 = np.square(A)
    v7 = v4 * v6
    v9 = v7 / (2275.0)
    return (v9,)


def block_energy_a(out, a, v9):
    np.power(a, C30, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v9, out, out)


def prepare_energy_all():
    return ()


def block_energy_all(out, a, A, E_star, t0):
    np.multiply(C31, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(A, t0)
    np.multiply(out, t0, t0)
    np.divide(t0, C33, t0)
    np.power(a, C30, out)
    np.multiply(t0, out, out)


def force(a, A, E_star):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 192.0 * E_star * A / 35.0 * pow(a, 7.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(A, E_star):
    v4 = (192.0) * E_star
    v5 = v4 * A
    v7 = v5 / (35.0)
    return (v7,)


def block_force_a(out, a, v7):
    np.power(a, C6, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, A, E_star, t0):
    np.multiply(C34, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.divide(out, C35, out)
    np.power(a, C6, t0)
    np.multiply(out, t0, out)


def force_from_depth(d, A, E_star):
    if d.__class__ is A.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v10 = 20.0 * d / A
            v12 = pow(v10, 0.16666666666666666)
            value = 6.0 * E_star / 7.0 * d * (v12 + v12 * ((v10 / (pow(v12, 6.0) * pow(v12, 0.0)) - 1.0) / 6.0) if v10 > 0.0 and v10 < inf else v12)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_from_depth_d(A, E_star):
    v4 = (6.0) * E_star
    v6 = v4 / (7.0)
    return (A, v6)


def block_force_from_depth_d(out, d, A, v6, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.multiply(v6, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(C36, d, t0)
    np.divide(t0, A, t0)
    np.power(t0, C37, t1)
    np.greater(t0, C3, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some27 = np.count_nonzero(m1)
    if some27:
        np.power(t1, C0, t2)
        np.power(t1, C3, t3)
        np.multiply(t2, t3, t3)
        np.divide(t0, t3, t3)
        np.subtract(t3, C7, t3)
        np.divide(t3, C0, t3)
        np.multiply(t1, t3, t3)
        np.add(t1, t3, t2)
    if some27 != size:
        np.copyto(t2, t1, where=~m1)
    np.multiply(out, t2, out)


def prepare_force_from_depth_all():
    return ()


def block_force_from_depth_all(out, d, A, E_star, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.multiply(C0, E_star, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(out, C6, out)
    np.multiply(out, d, out)
    np.multiply(C36, d, t0)
    np.divide(t0, A, t0)
    np.power(t0, C37, t1)
    np.greater(t0, C3, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some27 = np.count_nonzero(m1)
    if some27:
        np.power(t1, C0, t2)
        np.power(t1, C3, t3)
        np.multiply(t2, t3, t3)
        np.divide(t0, t3, t3)
        np.subtract(t3, C7, t3)
        np.divide(t3, C0, t3)
        np.multiply(t1, t3, t3)
        np.add(t1, t3, t2)
    if some27 != size:
        np.copyto(t2, t1, where=~m1)
    np.multiply(out, t2, out)


def load_within(r, a, A, E_star):
    if r.__class__ is a.__class__ is A.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                if r > 0.0:
                    v7 = sqrt((a - r) * (a + r))
                    v16 = a * a
                    v23 = r * r
                    value = 64.0 * E_star * A / 175.0 * v23 * (15.0 * pow(a, 6.0) / (v7 + a) + 3.0 * (v16 * v16) * v7 + 4.0 * v16 * v23 * v7 + 8.0 * (v23 * v23) * v7)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return 0.0
            return 192.0 * E_star * A / 35.0 * pow(a, 7.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(a, A, E_star):
    v9 = np.power(a, (6.0))
    v11 = (15.0) * v9
    v16 = np.square(a)
    v17 = np.square(v16)
    v19 = (3.0) * v17
    v22 = (4.0) * v16
    v36 = (64.0) * E_star
    v37 = v36 * A
    v39 = v37 / (175.0)
    v44 = (192.0) * E_star
    v45 = v44 * A
    v47 = v45 / (35.0)
    v49 = np.power(a, (7.0))
    v50 = v47 * v49
    return (a, v11, v19, v22, v39, v50)


def block_load_within_r(out, r, a, v11, v19, v22, v39, v50, t0, t1, t2, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some51 = np.count_nonzero(m0)
    if some51:
        np.greater(r, C3, m1)
        some42 = np.count_nonzero(m1)
        if some42:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.add(t0, a, out)
            np.divide(v11, out, out)
            np.multiply(v19, t0, t1)
            np.add(out, t1, t1)
            np.square(r, out)
            np.multiply(v22, out, t2)
            np.multiply(t2, t0, t2)
            np.add(t1, t2, t2)
            np.square(out, t1)
            np.multiply(C38, t1, t1)
            np.multiply(t1, t0, t0)
            np.add(t2, t0, t0)
            np.multiply(v39, out, out)
            np.multiply(out, t0, out)
        if some42 != size:
            np.copyto(out, C3, where=~m1)
    if some51 != size:
        np.copyto(out, v50, where=~m0)


def prepare_load_within_r_a(A, E_star):
    v36 = (64.0) * E_star
    v37 = v36 * A
    v39 = v37 / (175.0)
    v44 = (192.0) * E_star
    v45 = v44 * A
    v47 = v45 / (35.0)
    return (v39, v47)


def block_load_within_r_a(out, r, a, v39, v47, t0, t1, t2, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some51 = np.count_nonzero(m0)
    if some51:
        np.greater(r, C3, m1)
        some42 = np.count_nonzero(m1)
        if some42:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(a, C0, out)
            np.multiply(C39, out, out)
            np.add(t0, a, t1)
            np.divide(out, t1, t1)
            np.square(a, out)
            np.square(out, t2)
            np.multiply(C40, t2, t2)
            np.multiply(t2, t0, t2)
            np.add(t1, t2, t2)
            np.multiply(C41, out, out)
            np.square(r, t1)
            np.multiply(out, t1, out)
            np.multiply(out, t0, out)
            np.add(t2, out, out)
            np.square(t1, t2)
            np.multiply(C38, t2, t2)
            np.multiply(t2, t0, t0)
            np.add(out, t0, t0)
            np.multiply(v39, t1, t1)
            np.multiply(t1, t0, out)
        if some42 != size:
            np.copyto(out, C3, where=~m1)
    if some51 != size:
        other51 = t0 if some51 else out
        np.power(a, C6, other51)
        np.multiply(v47, other51, other51)
        if some51:
            np.copyto(out, other51, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, a, A, E_star, t0, t1, t2, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some51 = np.count_nonzero(m0)
    if some51:
        np.greater(r, C3, m1)
        some42 = np.count_nonzero(m1)
        if some42:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.power(a, C0, out)
            np.multiply(C39, out, out)
            np.add(t0, a, t1)
            np.divide(out, t1, t1)
            np.square(a, out)
            np.square(out, t2)
            np.multiply(C40, t2, t2)
            np.multiply(t2, t0, t2)
            np.add(t1, t2, t2)
            np.multiply(C41, out, out)
            np.square(r, t1)
            np.multiply(out, t1, out)
            np.multiply(out, t0, out)
            np.add(t2, out, out)
            np.square(t1, t2)
            np.multiply(C38, t2, t2)
            np.multiply(t2, t0, t0)
            np.add(out, t0, t0)
            np.multiply(C42, E_star, out)
            np.multiply(out, A, out)
            np.divide(out, C43, out)
            np.multiply(out, t1, t1)
            np.multiply(t1, t0, out)
        if some42 != size:
            np.copyto(out, C3, where=~m1)
    if some51 != size:
        other51 = t0 if some51 else out
        np.multiply(C34, E_star, other51)
        np.multiply(other51, A, other51)
        np.divide(other51, C35, other51)
        np.power(a, C6, t1)
        np.multiply(other51, t1, other51)
        if some51:
            np.copyto(out, other51, where=~m0)


def mean_pressure(a, A, E_star):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 192.0 * E_star * A / 109.95574287564276 * pow(a, 5.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(A, E_star):
    v4 = (192.0) * E_star
    v5 = v4 * A
    v7 = v5 / (109.95574287564276)
    return (v7,)


def block_mean_pressure_a(out, a, v7):
    np.power(a, C2, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, A, E_star, t0):
    np.multiply(C34, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.divide(out, C44, out)
    np.power(a, C2, t0)
    np.multiply(out, t0, out)


def peak_pressure(a, A, E_star):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 151.42562584220406 * E_star * A / 78.53981633974483 * pow(a, 5.0) * 1.1260325006104943
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_pressure_a(A, E_star):
    v4 = (151.42562584220406) * E_star
    v5 = v4 * A
    v7 = v5 / (78.53981633974483)
    return (v7,)


def block_peak_pressure_a(out, a, v7):
    np.power(a, C2, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)
    np.multiply(out, C45, out)


def prepare_peak_pressure_all():
    return ()


def block_peak_pressure_all(out, a, A, E_star, t0):
    np.multiply(C46, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.divide(out, C47, out)
    np.power(a, C2, t0)
    np.multiply(out, t0, t0)
    np.multiply(t0, C45, out)


def peak_radius(a, A=1.0, E_star=1.0):
    if a.__class__ is A.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return a * 1.6528916502810695 / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a):
    np.multiply(a, C48, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def pressure(r, a, A, E_star):
    if r.__class__ is a.__class__ is A.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v16 = a * a
                v21 = r * r
                return 32.0 * E_star * A / 78.53981633974483 * (3.0 * (v16 * v16) + 4.0 * v16 * v21 + 8.0 * (v21 * v21)) * sqrt((a - r) * (a + r))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, A, E_star):
    v11 = (32.0) * E_star
    v12 = v11 * A
    v14 = v12 / (78.53981633974483)
    v17 = np.square(a)
    v18 = np.square(v17)
    v20 = (3.0) * v18
    v21 = (4.0) * v17
    return (a, v14, v20, v21)


def block_pressure_r(out, r, a, v14, v20, v21, t0, t1, f0):
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if largest_r > a:
        np.maximum(out, f0, out=out)
    np.add(a, r, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.square(r, out)
    np.multiply(v21, out, t1)
    np.add(v20, t1, t1)
    np.square(out, out)
    np.multiply(C38, out, out)
    np.add(t1, out, out)
    np.multiply(v14, out, out)
    np.multiply(out, t0, out)


def prepare_pressure_r_a(A, E_star):
    v10 = (32.0) * E_star
    v11 = v10 * A
    v13 = v11 / (78.53981633974483)
    return (v13,)


def block_pressure_r_a(out, r, a, v13, t0, t1, t2, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some31 = np.count_nonzero(m0)
    if some31:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.square(a, out)
        np.square(out, t1)
        np.multiply(C40, t1, t1)
        np.multiply(C41, out, out)
        np.square(r, t2)
        np.multiply(out, t2, out)
        np.add(t1, out, out)
        np.square(t2, t2)
        np.multiply(C38, t2, t2)
        np.add(out, t2, t2)
        np.multiply(v13, t2, t2)
        np.multiply(t2, t0, out)
    if some31 != size:
        np.copyto(out, C3, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, A, E_star, t0, t1, t2, t3, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some31 = np.count_nonzero(m0)
    if some31:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C28, E_star, out)
        np.multiply(out, A, out)
        np.divide(out, C47, out)
        np.square(a, t1)
        np.square(t1, t2)
        np.multiply(C40, t2, t2)
        np.multiply(C41, t1, t1)
        np.square(r, t3)
        np.multiply(t1, t3, t1)
        np.add(t2, t1, t1)
        np.square(t3, t3)
        np.multiply(C38, t3, t3)
        np.add(t1, t3, t3)
        np.multiply(out, t3, t3)
        np.multiply(t3, t0, out)
    if some31 != size:
        np.copyto(out, C3, where=~m0)


def profile(r, A):
    if r.__class__ is A.__class__ is float and r > 1e-30 and (r < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            return A * pow(r, 6.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(A):
    return (A,)


def block_profile_r(out, r, A):
    np.power(r, C0, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, A):
    np.power(r, C0, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(A, out, out)


def radius_from_depth(d, A):
    if d.__class__ is A.__class__ is float and d > 1e-30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30):
        try:
            v6 = 5.0 * d / (16.0 * A)
            v8 = pow(v6, 0.16666666666666666)
            if v6 > 0.0 and v6 < inf:
                value = v8 + v8 * ((v6 / (pow(v8, 6.0) * pow(v8, 0.0)) - 1.0) / 6.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return v8
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_depth_d(A):
    v5 = (16.0) * A
    return (v5,)


def block_radius_from_depth_d(out, d, v5, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C2, d, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(t0, v5, t0)
    np.power(t0, C37, t1)
    np.greater(t0, C3, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some24 = np.count_nonzero(m1)
    if some24:
        np.power(t1, C0, out)
        np.power(t1, C3, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C7, t2)
        np.divide(t2, C0, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some24 != size:
        np.copyto(out, t1, where=~m1)


def prepare_radius_from_depth_all():
    return ()


def block_radius_from_depth_all(out, d, A, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C2, d, t0)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(C1, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C37, t0)
    np.greater(t1, C3, m0)
    np.less(t1, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some24 = np.count_nonzero(m1)
    if some24:
        np.power(t0, C0, out)
        np.power(t0, C3, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C7, t2)
        np.divide(t2, C0, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some24 != size:
        np.copyto(out, t0, where=~m1)


def radius_from_force(F, A, E_star):
    if F.__class__ is A.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = 35.0 * F / (192.0 * E_star * A)
            v10 = pow(v8, 0.14285714285714285)
            if v8 > 0.0 and v8 < inf:
                value = v10 + v10 * ((v8 / (pow(v10, 7.0) * pow(v10, 0.0)) - 1.0) / 7.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return v10
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_force_F(A, E_star):
    v6 = (192.0) * E_star
    v7 = v6 * A
    return (v7,)


def block_radius_from_force_F(out, F, v7, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C35, F, t0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.divide(t0, v7, t0)
    np.power(t0, C5, t1)
    np.greater(t0, C3, m0)
    np.less(t0, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some26 = np.count_nonzero(m1)
    if some26:
        np.power(t1, C6, out)
        np.power(t1, C3, t2)
        np.multiply(out, t2, t2)
        np.divide(t0, t2, t2)
        np.subtract(t2, C7, t2)
        np.divide(t2, C6, t2)
        np.multiply(t1, t2, t2)
        np.add(t1, t2, out)
    if some26 != size:
        np.copyto(out, t1, where=~m1)


def prepare_radius_from_force_all():
    return ()


def block_radius_from_force_all(out, F, A, E_star, t0, t1, t2, m0, m1):
    size = out.size
    np.multiply(C35, F, t0)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C34, E_star, t1)
    np.multiply(t1, A, t1)
    np.divide(t0, t1, t1)
    np.power(t1, C5, t0)
    np.greater(t1, C3, m0)
    np.less(t1, C4, m1)
    np.bitwise_and(m0, m1, m1)
    some26 = np.count_nonzero(m1)
    if some26:
        np.power(t0, C6, out)
        np.power(t0, C3, t2)
        np.multiply(out, t2, t2)
        np.divide(t1, t2, t2)
        np.subtract(t2, C7, t2)
        np.divide(t2, C6, t2)
        np.multiply(t0, t2, t2)
        np.add(t0, t2, out)
    if some26 != size:
        np.copyto(out, t0, where=~m1)


def stiffness(a, E_star, A=1.0):
    if a.__class__ is E_star.__class__ is A.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (A > 1e-30) and (A < 1e+30):
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
    np.multiply(C32, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'A'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 0, 0, (), False),
        ('a', 'A'): (('a', 'A'), prepare_depth_all, block_depth_all, 1, 0, (), False),
    },
    ('_depth_from_force', 1, 'F', 'A', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 3, 2, (), False),
        ('F', 'A', 'E_star'): (('F', 'A', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 4, 2, (), False),
    },
    ('_displacement', 2, 'r', 'a', 'A'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 3, 1, (), False),
        ('r', 'a'): (('r', 'a'), prepare_displacement_r_a, block_displacement_r_a, 5, 1, (), False),
        ('r', 'a', 'A'): (('r', 'a', 'A'), prepare_displacement_all, block_displacement_all, 5, 1, (), False),
    },
    ('_energy', 1, 'a', 'A', 'E_star'): {
        ('a',): (('a',), prepare_energy_a, block_energy_a, 0, 0, (), False),
        ('a', 'A', 'E_star'): (('a', 'A', 'E_star'), prepare_energy_all, block_energy_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'A', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 0, 0, (), False),
        ('a', 'A', 'E_star'): (('a', 'A', 'E_star'), prepare_force_all, block_force_all, 1, 0, (), False),
    },
    ('_force_from_depth', 1, 'd', 'A', 'E_star'): {
        ('d',): (('d',), prepare_force_from_depth_d, block_force_from_depth_d, 4, 2, (), False),
        ('d', 'A', 'E_star'): (('d', 'A', 'E_star'), prepare_force_from_depth_all, block_force_from_depth_all, 4, 2, (), False),
    },
    ('_load_within', 2, 'r', 'a', 'A', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 3, 2, (), False),
        ('r', 'a'): (('r', 'a'), prepare_load_within_r_a, block_load_within_r_a, 3, 2, (), False),
        ('r', 'a', 'A', 'E_star'): (('r', 'a', 'A', 'E_star'), prepare_load_within_all, block_load_within_all, 3, 2, (), False),
    },
    ('_mean_pressure', 1, 'a', 'A', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 0, 0, (), False),
        ('a', 'A', 'E_star'): (('a', 'A', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 1, 0, (), False),
    },
    ('_peak_pressure', 1, 'a', 'A', 'E_star'): {
        ('a',): (('a',), prepare_peak_pressure_a, block_peak_pressure_a, 0, 0, (), False),
        ('a', 'A', 'E_star'): (('a', 'A', 'E_star'), prepare_peak_pressure_all, block_peak_pressure_all, 1, 0, (), False),
    },
    ('_peak_radius', 1, 'a'): {
        ('a',): (('a',), prepare_peak_radius_all, block_peak_radius_all, 0, 0, (), False),
    },
    ('_pressure', 2, 'r', 'a', 'A', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 2, 0, (0.0,), True),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 3, 1, (), False),
        ('r', 'a', 'A', 'E_star'): (('r', 'a', 'A', 'E_star'), prepare_pressure_all, block_pressure_all, 4, 1, (), False),
    },
    ('_profile', 1, 'r', 'A'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 0, (), False),
        ('r', 'A'): (('r', 'A'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
    ('_radius_from_depth', 1, 'd', 'A'): {
        ('d',): (('d',), prepare_radius_from_depth_d, block_radius_from_depth_d, 3, 2, (), False),
        ('d', 'A'): (('d', 'A'), prepare_radius_from_depth_all, block_radius_from_depth_all, 3, 2, (), False),
    },
    ('_radius_from_force', 1, 'F', 'A', 'E_star'): {
        ('F',): (('F',), prepare_radius_from_force_F, block_radius_from_force_F, 3, 2, (), False),
        ('F', 'A', 'E_star'): (('F', 'A', 'E_star'), prepare_radius_from_force_all, block_radius_from_force_all, 3, 2, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
