"""Programs of axicontact.normal.paraboloid."""

from __future__ import annotations

from math import cbrt, pow, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(9.0)
C2 = np.array(16.0)
C3 = np.array(-0.7327347664453868)
C4 = np.array(-32.15553480435792)
C5 = np.array(-332.23363563146734)
C6 = np.array(-1070.7082873491413)
C7 = np.array(-85.27694715374247)
C8 = np.array(5044.821368830373)
C9 = np.array(8082.413158212496)
C10 = np.array(3759.725330928701)
C11 = np.array(0.26666666666720995)
C12 = np.array(0.21387262524856868)
C13 = np.array(32.12935731379798)
C14 = np.array(746.8124983579742)
C15 = np.array(6202.125133759036)
C16 = np.array(23553.080984642995)
C17 = np.array(44404.005348491315)
C18 = np.array(40380.01430284195)
C19 = np.array(14099.684276696918)
C20 = np.array(1.0)
C21 = np.array(0.6666666666666666)
C22 = np.array(3.141592653589793)
C23 = np.array(5.0)
C24 = np.array(8.0)
C25 = np.array(15.0)
C26 = np.array(4.0)
C27 = np.array(3.0)
C28 = np.array(0.0)
C29 = np.array(9.42477796076938)


def depth(a, R):
    if a.__class__ is R.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return a * a / R
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R):
    return (R,)


def block_depth_a(out, a, R):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)


def depth_from_force(F, R, E_star):
    if F.__class__ is R.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return cbrt(9.0 * (F * F) / (16.0 * (E_star * E_star) * R))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(R, E_star):
    v7 = np.square(E_star)
    v9 = (16.0) * v7
    v10 = v9 * R
    return (v10,)


def block_depth_from_force_F(out, F, v10):
    np.square(F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C1, out, out)
    np.divide(out, v10, out)
    np.cbrt(out, out)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, R, E_star, t0):
    np.square(F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C1, out, out)
    np.square(E_star, t0)
    np.multiply(C2, t0, t0)
    np.multiply(t0, R, t0)
    np.divide(out, t0, t0)
    np.cbrt(t0, out)


def displacement(r, a, R):
    if r.__class__ is a.__class__ is R.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            v4 = a * a
            if r > a:
                v14 = a / (r + sqrt((r - a) * (r + a)))
                v16 = v14 * v14
                value = 2.0 * v4 / (3.141592653589793 * R) * (a / r * (0.6666666666666666 + v16 * (((((((((-0.7327347664453868 * v16 + -32.15553480435792) * v16 + -332.23363563146734) * v16 + -1070.7082873491413) * v16 + -85.27694715374247) * v16 + 5044.821368830373) * v16 + 8082.413158212496) * v16 + 3759.725330928701) * v16 + 0.26666666666720995) / ((((((((0.21387262524856868 * v16 + 32.12935731379798) * v16 + 746.8124983579742) * v16 + 6202.125133759036) * v16 + 23553.080984642995) * v16 + 44404.005348491315) * v16 + 40380.01430284195) * v16 + 14099.684276696918) * v16 + 1.0))))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return v4 / R - r * r / (2.0 * R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, R):
    v4 = np.square(a)
    v5 = (2.0) * v4
    v7 = (3.141592653589793) * R
    v8 = v5 / v7
    v73 = v4 / R
    v75 = (2.0) * R
    return (a, v8, v73, v75)


def block_displacement_r(out, r, a, v8, v73, v75, t0, t1, t2, m0):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some79 = np.count_nonzero(m0)
    if some79:
        np.subtract(r, a, out)
        np.add(r, a, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(r, t0, t0)
        np.divide(a, t0, t0)
        np.divide(a, r, out)
        np.multiply(t0, t0, t0)
        np.multiply(C3, t0, t1)
        np.add(t1, C4, t1)
        np.multiply(t1, t0, t1)
        np.add(t1, C5, t1)
        np.multiply(t1, t0, t1)
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
        np.multiply(C12, t0, t2)
        np.add(t2, C13, t2)
        np.multiply(t2, t0, t2)
        np.add(t2, C14, t2)
        np.multiply(t2, t0, t2)
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
        np.divide(t1, t2, t2)
        np.multiply(t0, t2, t2)
        np.add(C21, t2, t2)
        np.multiply(out, t2, t2)
        np.multiply(v8, t2, out)
    if some79 != size:
        other79 = t2 if some79 else out
        np.square(r, other79)
        np.divide(other79, v75, other79)
        np.subtract(v73, other79, other79)
        if some79:
            np.copyto(out, other79, where=~m0)


def prepare_displacement_r_a(R):
    v7 = (3.141592653589793) * R
    v75 = (2.0) * R
    return (R, v7, v75)


def block_displacement_r_a(out, r, a, R, v7, v75, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(r, a, m0)
    some79 = np.count_nonzero(m0)
    if some79:
        np.multiply(C0, t0, out)
        np.divide(out, v7, out)
        np.subtract(r, a, t1)
        np.add(r, a, t2)
        np.multiply(t1, t2, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.divide(a, r, t1)
        np.multiply(t2, t2, t2)
        np.multiply(C3, t2, t3)
        np.add(t3, C4, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C5, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C8, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C9, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C11, t3)
        np.multiply(C12, t2, t4)
        np.add(t4, C13, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C14, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C15, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C16, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C17, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C18, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C19, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C20, t4)
        np.divide(t3, t4, t4)
        np.multiply(t2, t4, t4)
        np.add(C21, t4, t4)
        np.multiply(t1, t4, t4)
        np.multiply(out, t4, out)
    if some79 != size:
        other79 = t4 if some79 else out
        np.divide(t0, R, other79)
        np.square(r, t1)
        np.divide(t1, v75, t1)
        np.subtract(other79, t1, other79)
        if some79:
            np.copyto(out, other79, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, R, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(r, a, m0)
    some79 = np.count_nonzero(m0)
    if some79:
        np.multiply(C0, t0, out)
        np.multiply(C22, R, t1)
        np.divide(out, t1, t1)
        np.subtract(r, a, out)
        np.add(r, a, t2)
        np.multiply(out, t2, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.divide(a, r, out)
        np.multiply(t2, t2, t2)
        np.multiply(C3, t2, t3)
        np.add(t3, C4, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C5, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C6, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C7, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C8, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C9, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t2, t3)
        np.add(t3, C11, t3)
        np.multiply(C12, t2, t4)
        np.add(t4, C13, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C14, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C15, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C16, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C17, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C18, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C19, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C20, t4)
        np.divide(t3, t4, t4)
        np.multiply(t2, t4, t4)
        np.add(C21, t4, t4)
        np.multiply(out, t4, t4)
        np.multiply(t1, t4, out)
    if some79 != size:
        other79 = t4 if some79 else out
        np.divide(t0, R, other79)
        np.square(r, t1)
        np.multiply(C0, R, t2)
        np.divide(t1, t2, t2)
        np.subtract(other79, t2, other79)
        if some79:
            np.copyto(out, other79, where=~m0)


def energy(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 8.0 * E_star / (15.0 * (R * R)) * pow(a, 5.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_a(R, E_star):
    v4 = (8.0) * E_star
    v6 = np.square(R)
    v8 = (15.0) * v6
    v9 = v4 / v8
    return (v9,)


def block_energy_a(out, a, v9):
    np.power(a, C23, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v9, out, out)


def prepare_energy_all():
    return ()


def block_energy_all(out, a, R, E_star, t0):
    np.multiply(C24, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(R, t0)
    np.multiply(C25, t0, t0)
    np.divide(out, t0, t0)
    np.power(a, C23, out)
    np.multiply(t0, out, out)


def force(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 4.0 * E_star / (3.0 * R) * (a * (a * a))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, E_star):
    v4 = (4.0) * E_star
    v6 = (3.0) * R
    v7 = v4 / v6
    return (v7,)


def block_force_a(out, a, v7):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, out)
    np.multiply(v7, out, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, E_star, t0):
    np.multiply(C26, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C27, R, t0)
    np.divide(out, t0, t0)
    np.square(a, out)
    np.multiply(a, out, out)
    np.multiply(t0, out, out)


def force_from_depth(d, R, E_star):
    if d.__class__ is R.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 4.0 * E_star / 3.0 * d * sqrt(R * d)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_from_depth_d(R, E_star):
    v4 = (4.0) * E_star
    v6 = v4 / (3.0)
    return (R, v6)


def block_force_from_depth_d(out, d, R, v6, t0):
    np.multiply(v6, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(R, d, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, out)


def prepare_force_from_depth_all():
    return ()


def block_force_from_depth_all(out, d, R, E_star, t0):
    np.multiply(C26, E_star, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(out, C27, out)
    np.multiply(out, d, out)
    np.multiply(R, d, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, out)


def load_within(r, a, R, E_star):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v15 = 4.0 * E_star / (3.0 * R)
            v19 = a * a
            if r < a:
                if r > 0.0:
                    v7 = sqrt((a - r) * (a + r))
                    return v15 * (r * r) * (v7 + v19 / (v7 + a))
                return 0.0
            return v15 * (a * v19)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(a, R, E_star):
    v12 = (4.0) * E_star
    v14 = (3.0) * R
    v15 = v12 / v14
    v19 = np.square(a)
    v25 = a * v19
    v26 = v15 * v25
    return (a, v15, v19, v26)


def block_load_within_r(out, r, a, v15, v19, v26, t0, t1, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some27 = np.count_nonzero(m0)
    if some27:
        np.greater(r, C28, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, out)
            np.multiply(v15, out, out)
            np.add(t0, a, t1)
            np.divide(v19, t1, t1)
            np.add(t0, t1, t1)
            np.multiply(out, t1, out)
        if some24 != size:
            np.copyto(out, C28, where=~m1)
    if some27 != size:
        np.copyto(out, v26, where=~m0)


def prepare_load_within_r_a(R, E_star):
    v12 = (4.0) * E_star
    v14 = (3.0) * R
    v15 = v12 / v14
    return (v15,)


def block_load_within_r_a(out, r, a, v15, t0, t1, t2, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.greater(r, C28, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.subtract(a, r, out)
            np.add(a, r, t1)
            np.multiply(out, t1, t1)
            np.sqrt(t1, t1)
            np.square(r, out)
            np.multiply(v15, out, out)
            np.add(t1, a, t2)
            np.divide(t0, t2, t2)
            np.add(t1, t2, t2)
            np.multiply(out, t2, out)
        if some24 != size:
            np.copyto(out, C28, where=~m1)
    if some27 != size:
        other27 = t2 if some27 else out
        np.multiply(a, t0, other27)
        np.multiply(v15, other27, other27)
        if some27:
            np.copyto(out, other27, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, a, R, E_star, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C26, E_star, t0)
    np.multiply(C27, R, t1)
    np.divide(t0, t1, t1)
    np.square(a, t0)
    some27 = np.count_nonzero(m0)
    if some27:
        np.greater(r, C28, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.subtract(a, r, out)
            np.add(a, r, t2)
            np.multiply(out, t2, t2)
            np.sqrt(t2, t2)
            np.square(r, out)
            np.multiply(t1, out, out)
            np.add(t2, a, t3)
            np.divide(t0, t3, t3)
            np.add(t2, t3, t3)
            np.multiply(out, t3, out)
        if some24 != size:
            np.copyto(out, C28, where=~m1)
    if some27 != size:
        other27 = t3 if some27 else out
        np.multiply(a, t0, other27)
        np.multiply(t1, other27, other27)
        if some27:
            np.copyto(out, other27, where=~m0)


def mean_pressure(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 4.0 * E_star / (9.42477796076938 * R) * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R, E_star):
    v4 = (4.0) * E_star
    v6 = (9.42477796076938) * R
    v7 = v4 / v6
    return (v7,)


def block_mean_pressure_a(out, a, v7):
    np.multiply(v7, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, E_star, t0):
    np.multiply(C26, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C29, R, t0)
    np.divide(out, t0, t0)
    np.multiply(t0, a, out)


def peak_pressure(a, R, E_star):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if 0.0 < a:
                return 2.0 * E_star / (3.141592653589793 * R) * sqrt((a - 0.0) * (a + 0.0))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_pressure_a(R, E_star):
    v10 = (2.0) * E_star
    v12 = (3.141592653589793) * R
    v13 = v10 / v12
    return (v13,)


def block_peak_pressure_a(out, a, v13, t0, m0):
    size = out.size
    np.less(C28, a, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some15 = np.count_nonzero(m0)
    if some15:
        np.subtract(a, C28, out)
        np.add(a, C28, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(v13, t0, out)
    if some15 != size:
        np.copyto(out, C28, where=~m0)


def prepare_peak_pressure_all():
    return ()


def block_peak_pressure_all(out, a, R, E_star, t0, t1, m0):
    size = out.size
    np.less(C28, a, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some15 = np.count_nonzero(m0)
    if some15:
        np.subtract(a, C28, out)
        np.add(a, C28, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C0, E_star, out)
        np.multiply(C22, R, t1)
        np.divide(out, t1, t1)
        np.multiply(t1, t0, out)
    if some15 != size:
        np.copyto(out, C28, where=~m0)


def peak_radius(a, R=1.0, E_star=1.0):
    if a.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a):
    np.copyto(out, C28)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def pressure(r, a, R, E_star):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                return 2.0 * E_star / (3.141592653589793 * R) * sqrt((a - r) * (a + r))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, R, E_star):
    v11 = (2.0) * E_star
    v13 = (3.141592653589793) * R
    v14 = v11 / v13
    return (a, v14)


def block_pressure_r(out, r, a, v14, t0, f0):
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if largest_r > a:
        np.maximum(out, f0, out=out)
    np.add(a, r, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(v14, t0, out)


def prepare_pressure_r_a(R, E_star):
    v10 = (2.0) * E_star
    v12 = (3.141592653589793) * R
    v13 = v10 / v12
    return (v13,)


def block_pressure_r_a(out, r, a, v13, t0, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(v13, t0, out)
    if some16 != size:
        np.copyto(out, C28, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, R, E_star, t0, t1, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C0, E_star, out)
        np.multiply(C22, R, t1)
        np.divide(out, t1, t1)
        np.multiply(t1, t0, out)
    if some16 != size:
        np.copyto(out, C28, where=~m0)


def profile(r, R):
    if r.__class__ is R.__class__ is float and r > 1e-30 and (r < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return r * r / (2.0 * R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R):
    v4 = (2.0) * R
    return (v4,)


def block_profile_r(out, r, v4):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.divide(out, v4, out)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, t0):
    np.square(r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(C0, R, t0)
    np.divide(out, t0, out)


def radius_from_depth(d, R):
    if d.__class__ is R.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30):
        try:
            return sqrt(R * d)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_depth_d(R):
    return (R,)


def block_radius_from_depth_d(out, d, R):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)


def prepare_radius_from_depth_all():
    return ()


def block_radius_from_depth_all(out, d, R):
    np.multiply(R, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)


def radius_from_force(F, R, E_star):
    if F.__class__ is R.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return cbrt(3.0 * R / (4.0 * E_star) * F)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_force_F(R, E_star):
    v4 = (3.0) * R
    v6 = (4.0) * E_star
    v7 = v4 / v6
    return (v7,)


def block_radius_from_force_F(out, F, v7):
    np.multiply(v7, F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.cbrt(out, out)


def prepare_radius_from_force_all():
    return ()


def block_radius_from_force_all(out, F, R, E_star, t0):
    np.multiply(C27, R, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C26, E_star, t0)
    np.divide(out, t0, t0)
    np.multiply(t0, F, t0)
    np.cbrt(t0, out)


def stiffness(a, E_star, R=1.0):
    if a.__class__ is E_star.__class__ is R.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (R > 1e-30) and (R < 1e+30):
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
    ('_depth', 1, 'a', 'R'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 0, 0, (), False),
        ('a', 'R'): (('a', 'R'), prepare_depth_all, block_depth_all, 0, 0, (), False),
    },
    ('_depth_from_force', 1, 'F', 'R', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 0, 0, (), False),
        ('F', 'R', 'E_star'): (('F', 'R', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 1, 0, (), False),
    },
    ('_displacement', 2, 'r', 'a', 'R'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 3, 1, (), False),
        ('r', 'a'): (('r', 'a'), prepare_displacement_r_a, block_displacement_r_a, 5, 1, (), False),
        ('r', 'a', 'R'): (('r', 'a', 'R'), prepare_displacement_all, block_displacement_all, 5, 1, (), False),
    },
    ('_energy', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_energy_a, block_energy_a, 0, 0, (), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_energy_all, block_energy_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 0, 0, (), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_force_all, block_force_all, 1, 0, (), False),
    },
    ('_force_from_depth', 1, 'd', 'R', 'E_star'): {
        ('d',): (('d',), prepare_force_from_depth_d, block_force_from_depth_d, 1, 0, (), False),
        ('d', 'R', 'E_star'): (('d', 'R', 'E_star'), prepare_force_from_depth_all, block_force_from_depth_all, 1, 0, (), False),
    },
    ('_load_within', 2, 'r', 'a', 'R', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 2, 2, (), False),
        ('r', 'a'): (('r', 'a'), prepare_load_within_r_a, block_load_within_r_a, 3, 2, (), False),
        ('r', 'a', 'R', 'E_star'): (('r', 'a', 'R', 'E_star'), prepare_load_within_all, block_load_within_all, 4, 2, (), False),
    },
    ('_mean_pressure', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 0, 0, (), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 1, 0, (), False),
    },
    ('_peak_pressure', 1, 'a', 'R', 'E_star'): {
        ('a',): (('a',), prepare_peak_pressure_a, block_peak_pressure_a, 1, 1, (), False),
        ('a', 'R', 'E_star'): (('a', 'R', 'E_star'), prepare_peak_pressure_all, block_peak_pressure_all, 2, 1, (), False),
    },
    ('_peak_radius', 1, 'a'): {
        ('a',): (('a',), prepare_peak_radius_all, block_peak_radius_all, 0, 0, (), False),
    },
    ('_pressure', 2, 'r', 'a', 'R', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 1, 0, (0.0,), True),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 1, 1, (), False),
        ('r', 'a', 'R', 'E_star'): (('r', 'a', 'R', 'E_star'), prepare_pressure_all, block_pressure_all, 2, 1, (), False),
    },
    ('_profile', 1, 'r', 'R'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 0, (), False),
        ('r', 'R'): (('r', 'R'), prepare_profile_all, block_profile_all, 1, 0, (), False),
    },
    ('_radius_from_depth', 1, 'd', 'R'): {
        ('d',): (('d',), prepare_radius_from_depth_d, block_radius_from_depth_d, 0, 0, (), False),
        ('d', 'R'): (('d', 'R'), prepare_radius_from_depth_all, block_radius_from_depth_all, 0, 0, (), False),
    },
    ('_radius_from_force', 1, 'F', 'R', 'E_star'): {
        ('F',): (('F',), prepare_radius_from_force_F, block_radius_from_force_F, 0, 0, (), False),
        ('F', 'R', 'E_star'): (('F', 'R', 'E_star'), prepare_radius_from_force_all, block_radius_from_force_all, 1, 0, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
