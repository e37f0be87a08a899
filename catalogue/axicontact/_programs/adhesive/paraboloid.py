"""Programs of axicontact.adhesive.paraboloid."""

from __future__ import annotations

from math import atan2, cbrt, nan, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.adhesive import paraboloid as bodies

C0 = np.array(2.0)
C1 = np.array(6.283185307179586)
C2 = np.array(-0.7327347664453868)
C3 = np.array(-32.15553480435792)
C4 = np.array(-332.23363563146734)
C5 = np.array(-1070.7082873491413)
C6 = np.array(-85.27694715374247)
C7 = np.array(5044.821368830373)
C8 = np.array(8082.413158212496)
C9 = np.array(3759.725330928701)
C10 = np.array(0.26666666666720995)
C11 = np.array(0.21387262524856868)
C12 = np.array(32.12935731379798)
C13 = np.array(746.8124983579742)
C14 = np.array(6202.125133759036)
C15 = np.array(23553.080984642995)
C16 = np.array(44404.005348491315)
C17 = np.array(40380.01430284195)
C18 = np.array(14099.684276696918)
C19 = np.array(1.0)
C20 = np.array(0.6666666666666666)
C21 = np.array(0.6366197723675814)
C22 = np.array(3.141592653589793)
C23 = np.array(4.0)
C24 = np.array(3.0)
C25 = np.array(0.0)
C26 = np.array(np.nan)
C27 = np.array(25.132741228718345)


def depth(a, R, E_star, dgamma):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return a * a / R - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, E_star, dgamma):
    v9 = (6.283185307179586) * dgamma
    v10 = v9 / E_star
    v11 = np.sqrt(v10)
    return (R, v11)


def block_depth_a(out, a, R, v11, t0):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)
    np.sqrt(a, t0)
    np.multiply(t0, v11, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, E_star, dgamma, t0, t1):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)
    np.sqrt(a, t0)
    np.multiply(C1, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def displacement(r, a, R, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v6 = a * a
            v11 = r - a
            v12 = r + a
            v80 = r > a
            if v80:
                v16 = a / (r + sqrt(v11 * v12))
                v18 = v16 * v16
                v81 = 2.0 * v6 / (3.141592653589793 * R) * (a / r * (0.6666666666666666 + v18 * (((((((((-0.7327347664453868 * v18 + -32.15553480435792) * v18 + -332.23363563146734) * v18 + -1070.7082873491413) * v18 + -85.27694715374247) * v18 + 5044.821368830373) * v18 + 8082.413158212496) * v18 + 3759.725330928701) * v18 + 0.26666666666720995) / ((((((((0.21387262524856868 * v18 + 32.12935731379798) * v18 + 746.8124983579742) * v18 + 6202.125133759036) * v18 + 23553.080984642995) * v18 + 44404.005348491315) * v18 + 40380.01430284195) * v18 + 14099.684276696918) * v18 + 1.0))))
            else:
                v81 = v6 / R - r * r / (2.0 * R)
            value = v81 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * v12)) if v80 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, R, E_star, dgamma):
    v6 = np.square(a)
    v7 = (2.0) * v6
    v9 = (3.141592653589793) * R
    v10 = v7 / v9
    v75 = v6 / R
    v77 = (2.0) * R
    v90 = np.sqrt(a)
    v92 = (6.283185307179586) * dgamma
    v93 = v92 / E_star
    v94 = np.sqrt(v93)
    v95 = v90 * v94
    return (a, v10, v75, v77, v95)


def block_displacement_r(out, r, a, v10, v75, v77, v95, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, a, t0)
    np.greater(r, a, m0)
    some81 = np.count_nonzero(m0)
    if some81:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.add(r, t1, t1)
        np.divide(a, t1, t1)
        np.divide(a, r, t2)
        np.multiply(t1, t1, t1)
        np.multiply(C2, t1, t3)
        np.add(t3, C3, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C4, t3)
        np.multiply(t3, t1, t3)
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
        np.multiply(C11, t1, t4)
        np.add(t4, C12, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C13, t4)
        np.multiply(t4, t1, t4)
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
        np.divide(t3, t4, t4)
        np.multiply(t1, t4, t4)
        np.add(C20, t4, t4)
        np.multiply(t2, t4, t4)
        np.multiply(v10, t4, t1)
    if some81 != size:
        other81 = t4 if some81 else t1
        np.square(r, other81)
        np.divide(other81, v77, other81)
        np.subtract(v75, other81, other81)
        if some81:
            np.copyto(t1, other81, where=~m0)
    some89 = np.count_nonzero(m0)
    if some89:
        np.maximum(out, f0, out=t4)
        np.multiply(t4, t0, t4)
        np.sqrt(t4, t4)
        np.arctan2(a, t4, t4)
        np.multiply(C21, t4, t4)
    if some89 != size:
        np.copyto(t4, C19, where=~m0)
    np.multiply(v95, t4, t4)
    np.subtract(t1, t4, out)


def prepare_displacement_r_a(R, E_star, dgamma):
    v9 = (3.141592653589793) * R
    v77 = (2.0) * R
    v92 = (6.283185307179586) * dgamma
    v93 = v92 / E_star
    v94 = np.sqrt(v93)
    return (R, v9, v77, v94)


def block_displacement_r_a(out, r, a, R, v9, v77, v94, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.square(a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some81 = np.count_nonzero(m0)
    if some81:
        np.multiply(C0, out, t2)
        np.divide(t2, v9, t2)
        np.multiply(t0, t1, t3)
        np.sqrt(t3, t3)
        np.add(r, t3, t3)
        np.divide(a, t3, t3)
        np.divide(a, r, t4)
        np.multiply(t3, t3, t3)
        np.multiply(C2, t3, t5)
        np.add(t5, C3, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t3, t5)
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
        np.multiply(C11, t3, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t3, t6)
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
        np.divide(t5, t6, t6)
        np.multiply(t3, t6, t6)
        np.add(C20, t6, t6)
        np.multiply(t4, t6, t6)
        np.multiply(t2, t6, t2)
    if some81 != size:
        other81 = t6 if some81 else t2
        np.divide(out, R, other81)
        np.square(r, t4)
        np.divide(t4, v77, t4)
        np.subtract(other81, t4, other81)
        if some81:
            np.copyto(t2, other81, where=~m0)
    some89 = np.count_nonzero(m0)
    if some89:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C21, out, out)
    if some89 != size:
        np.copyto(out, C19, where=~m0)
    np.sqrt(a, t1)
    np.multiply(t1, v94, t1)
    np.multiply(t1, out, out)
    np.subtract(t2, out, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, R, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.square(a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some81 = np.count_nonzero(m0)
    if some81:
        np.multiply(C0, out, t2)
        np.multiply(C22, R, t3)
        np.divide(t2, t3, t3)
        np.multiply(t0, t1, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.divide(a, r, t4)
        np.multiply(t2, t2, t2)
        np.multiply(C2, t2, t5)
        np.add(t5, C3, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C10, t5)
        np.multiply(C11, t2, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C14, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C15, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C16, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C17, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C18, t6)
        np.multiply(t6, t2, t6)
        np.add(t6, C19, t6)
        np.divide(t5, t6, t6)
        np.multiply(t2, t6, t6)
        np.add(C20, t6, t6)
        np.multiply(t4, t6, t6)
        np.multiply(t3, t6, t2)
    if some81 != size:
        other81 = t6 if some81 else t2
        np.divide(out, R, other81)
        np.square(r, t3)
        np.multiply(C0, R, t4)
        np.divide(t3, t4, t4)
        np.subtract(other81, t4, other81)
        if some81:
            np.copyto(t2, other81, where=~m0)
    some89 = np.count_nonzero(m0)
    if some89:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C21, out, out)
    if some89 != size:
        np.copyto(out, C19, where=~m0)
    np.sqrt(a, t1)
    np.multiply(C1, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t1, t0, t0)
    np.multiply(t0, out, out)
    np.subtract(t2, out, out)


def force(a, R, E_star, dgamma):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return 4.0 * E_star / (3.0 * R) * (a * (a * a)) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, E_star, dgamma):
    v5 = (4.0) * E_star
    v7 = (3.0) * R
    v8 = v5 / v7
    v13 = (2.0) * E_star
    v17 = (6.283185307179586) * dgamma
    v18 = v17 / E_star
    v19 = np.sqrt(v18)
    return (v8, v13, v19)


def block_force_a(out, a, v8, v13, v19, t0, t1):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, out)
    np.multiply(v8, out, out)
    np.multiply(v13, a, t0)
    np.sqrt(a, t1)
    np.multiply(t1, v19, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, E_star, dgamma, t0, t1, t2):
    np.multiply(C23, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C24, R, t0)
    np.divide(out, t0, t0)
    np.square(a, out)
    np.multiply(a, out, out)
    np.multiply(t0, out, out)
    np.multiply(C0, E_star, t0)
    np.multiply(t0, a, t0)
    np.sqrt(a, t1)
    np.multiply(C1, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t2, t2)
    np.subtract(out, t2, out)


def pressure(r, a, R, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v5 = a - r
            v6 = a + r
            if r <= a:
                v23 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v33 = E_star * v23 / (3.141592653589793 * sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * v6)) if v23 > 0.0 else 0.0
            else:
                v33 = 0.0
            return (2.0 * E_star / (3.141592653589793 * R) * sqrt(v5 * v6) if r < a else 0.0) - v33
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, R, E_star, dgamma):
    v11 = (2.0) * E_star
    v13 = (3.141592653589793) * R
    v14 = v11 / v13
    v18 = np.sqrt(a)
    v20 = (6.283185307179586) * dgamma
    v21 = v20 / E_star
    v22 = np.sqrt(v21)
    v23 = v18 * v22
    v24 = np.greater(v23, (0.0))
    v25 = E_star * v23
    return (a, v14, v24, v25)


def block_pressure_r(out, r, a, v14, v24, v25, t0, t1, t2, m0, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.multiply(v14, t1, t1)
    if some17 != size:
        np.copyto(t1, C25, where=~m0)
    np.less_equal(r, a, m0)
    some33 = np.count_nonzero(m0)
    if some33:
        if v24:
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C22, t2, t2)
            np.divide(v25, t2, t2)
        else:
            np.copyto(t2, C25)
    if some33 != size:
        np.copyto(t2, C25, where=~m0)
    np.subtract(t1, t2, out)


def prepare_pressure_r_a(R, E_star, dgamma):
    v11 = (2.0) * E_star
    v13 = (3.141592653589793) * R
    v14 = v11 / v13
    v20 = (6.283185307179586) * dgamma
    v21 = v20 / E_star
    v22 = np.sqrt(v21)
    return (E_star, v14, v22)


def block_pressure_r_a(out, r, a, E_star, v14, v22, t0, t1, t2, t3, t4, m0, m1, f0):
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
    some17 = np.count_nonzero(m0)
    if some17:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.multiply(v14, t1, t1)
    if some17 != size:
        np.copyto(t1, C25, where=~m0)
    np.less_equal(r, a, m0)
    some33 = np.count_nonzero(m0)
    if some33:
        np.sqrt(a, t3)
        np.multiply(t3, v22, t3)
        np.greater(t3, C25, m1)
        some31 = np.count_nonzero(m1)
        if some31:
            np.multiply(E_star, t3, t2)
            np.maximum(out, f0, out=t4)
            np.multiply(t4, t0, t4)
            np.sqrt(t4, t4)
            np.multiply(C22, t4, t4)
            np.divide(t2, t4, t2)
        if some31 != size:
            np.copyto(t2, C25, where=~m1)
    if some33 != size:
        np.copyto(t2, C25, where=~m0)
    np.subtract(t1, t2, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, R, E_star, dgamma, t0, t1, t2, t3, t4, m0, m1, f0):
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
    some17 = np.count_nonzero(m0)
    if some17:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.multiply(C0, E_star, t2)
        np.multiply(C22, R, t3)
        np.divide(t2, t3, t3)
        np.multiply(t3, t1, t1)
    if some17 != size:
        np.copyto(t1, C25, where=~m0)
    np.less_equal(r, a, m0)
    some33 = np.count_nonzero(m0)
    if some33:
        np.sqrt(a, t2)
        np.multiply(C1, dgamma, t4)
        np.divide(t4, E_star, t4)
        np.sqrt(t4, t4)
        np.multiply(t2, t4, t4)
        np.greater(t4, C25, m1)
        some31 = np.count_nonzero(m1)
        if some31:
            np.multiply(E_star, t4, t3)
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C22, t2, t2)
            np.divide(t3, t2, t3)
        if some31 != size:
            np.copyto(t3, C25, where=~m1)
    if some33 != size:
        np.copyto(t3, C25, where=~m0)
    np.subtract(t1, t3, out)


def pull_off_depth(a, R, E_star, dgamma, control):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_depth(a, R, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, R, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, R, E_star, dgamma, control):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_force(a, R, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, R, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


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
            if F == 0.0:
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            v7 = -F if F < 0.0 else nan
            v14 = cbrt(3.0 * R / (4.0 * E_star) * v7)
            v17 = (v7 + v7) / v14
            value = v17 * v17 / (25.132741228718345 * E_star * v14)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_work_of_adhesion_from_pull_off_all_signed():
    return ()


def block_work_of_adhesion_from_pull_off_all_signed(out, F, R, E_star, t0, t1, t2, m0, m1):
    size = out.size
    np.equal(F, C25, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.copyto(out, C25)
    if some24 != size:
        other24 = t0 if some24 else out
        np.less(F, C25, m1)
        some7 = np.count_nonzero(m1)
        if some7:
            np.negative(F, other24)
        if some7 != size:
            np.copyto(other24, C26, where=~m1)
        np.multiply(C24, R, t1)
        np.multiply(C23, E_star, t2)
        np.divide(t1, t2, t2)
        np.multiply(t2, other24, t2)
        np.cbrt(t2, t2)
        np.add(other24, other24, other24)
        np.divide(other24, t2, other24)
        np.square(other24, other24)
        np.multiply(C27, E_star, t1)
        np.multiply(t1, t2, t2)
        np.divide(other24, t2, other24)
        if some24:
            np.copyto(out, other24, where=~m0)


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'R', 'E_star', 'dgamma'): (('a', 'R', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_displacement', 2, 'r', 'a', 'R', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 5, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_displacement_r_a, block_displacement_r_a, 7, 1, (0.0,), False),
        ('r', 'a', 'R', 'E_star', 'dgamma'): (('r', 'a', 'R', 'E_star', 'dgamma'), prepare_displacement_all, block_displacement_all, 7, 1, (0.0,), False),
    },
    ('_force', 1, 'a', 'R', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 0, (), False),
        ('a', 'R', 'E_star', 'dgamma'): (('a', 'R', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 3, 0, (), False),
    },
    ('_pressure', 2, 'r', 'a', 'R', 'E_star', 'dgamma'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 3, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 5, 2, (0.0,), False),
        ('r', 'a', 'R', 'E_star', 'dgamma'): (('r', 'a', 'R', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, 5, 2, (0.0,), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'R', 'E_star'): {
        ('F', 'R', 'E_star'): (('F', 'R', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 3, 2, (), False),
    },
}
