"""Programs of axicontact.adhesive.quartic."""

from __future__ import annotations

from math import atan2, inf, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.adhesive import quartic as bodies

C0 = np.array(2.0)
C1 = np.array(8.0)
C2 = np.array(3.0)
C3 = np.array(6.283185307179586)
C4 = np.array(-4.320959889429597)
C5 = np.array(-106.53004831006083)
C6 = np.array(-683.6776777243583)
C7 = np.array(-1307.862063615897)
C8 = np.array(1123.6903304493044)
C9 = np.array(6598.931700123421)
C10 = np.array(7450.127483097781)
C11 = np.array(2696.481329529376)
C12 = np.array(0.3809523809520408)
C13 = np.array(-0.06548708381580395)
C14 = np.array(10.743349921788495)
C15 = np.array(655.5477291446655)
C16 = np.array(5580.132341984832)
C17 = np.array(18919.75045798054)
C18 = np.array(30703.596314182465)
C19 = np.array(23803.775464413437)
C20 = np.array(7078.863490014608)
C21 = np.array(1.0)
C22 = np.array(0.8)
C23 = np.array(0.6366197723675814)
C24 = np.array(16.0)
C25 = np.array(9.42477796076938)
C26 = np.array(5.0)
C27 = np.array(64.0)
C28 = np.array(15.0)
C29 = np.array(0.0)
C30 = np.array(3.141592653589793)
C31 = np.array(32.0)
C32 = np.array(28.274333882308138)
C33 = np.array(np.nan)
C34 = np.array(7.0)
C35 = np.array(0.2)
C36 = np.array(np.inf)
C37 = np.array(25.132741228718345)


def depth(a, A, E_star, dgamma):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v10 = a * a
            return 8.0 * A / 3.0 * (v10 * v10) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(A, E_star, dgamma):
    v5 = (8.0) * A
    v7 = v5 / (3.0)
    v14 = (6.283185307179586) * dgamma
    v15 = v14 / E_star
    v16 = np.sqrt(v15)
    return (v7, v16)


def block_depth_a(out, a, v7, v16, t0):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(v7, out, out)
    np.sqrt(a, t0)
    np.multiply(t0, v16, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, A, E_star, dgamma, t0, t1):
    np.multiply(C1, A, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, C2, out)
    np.square(a, t0)
    np.square(t0, t0)
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
            v11 = a * a
            v12 = v11 * v11
            v14 = r - a
            v15 = r + a
            v87 = r > a
            if v87:
                v19 = a / (r + sqrt(v14 * v15))
                v21 = v19 * v19
                v88 = 16.0 * A / 9.42477796076938 * v12 * (a / r * (0.8 + v21 * (((((((((-4.320959889429597 * v21 + -106.53004831006083) * v21 + -683.6776777243583) * v21 + -1307.862063615897) * v21 + 1123.6903304493044) * v21 + 6598.931700123421) * v21 + 7450.127483097781) * v21 + 2696.481329529376) * v21 + 0.3809523809520408) / ((((((((-0.06548708381580395 * v21 + 10.743349921788495) * v21 + 655.5477291446655) * v21 + 5580.132341984832) * v21 + 18919.75045798054) * v21 + 30703.596314182465) * v21 + 23803.775464413437) * v21 + 7078.863490014608) * v21 + 1.0))))
            else:
                v83 = r * r
                v88 = 8.0 * A / 3.0 * v12 - A * (v83 * v83)
            value = v88 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * v15)) if v87 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, A, E_star, dgamma):
    v6 = (16.0) * A
    v8 = v6 / (9.42477796076938)
    v10 = np.square(a)
    v11 = np.square(v10)
    v12 = v8 * v11
    v78 = (8.0) * A
    v80 = v78 / (3.0)
    v81 = v80 * v11
    v96 = np.sqrt(a)
    v98 = (6.283185307179586) * dgamma
    v99 = v98 / E_star
    v100 = np.sqrt(v99)
    v101 = v96 * v100
    return (a, A, v12, v81, v101)


def block_displacement_r(out, r, a, A, v12, v81, v101, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.subtract(r, a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(r, a, t0)
    np.greater(r, a, m0)
    some87 = np.count_nonzero(m0)
    if some87:
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
        np.multiply(v12, t4, t1)
    if some87 != size:
        other87 = t4 if some87 else t1
        np.square(r, other87)
        np.square(other87, other87)
        np.multiply(A, other87, other87)
        np.subtract(v81, other87, other87)
        if some87:
            np.copyto(t1, other87, where=~m0)
    some95 = np.count_nonzero(m0)
    if some95:
        np.maximum(out, f0, out=t4)
        np.multiply(t4, t0, t4)
        np.sqrt(t4, t4)
        np.arctan2(a, t4, t4)
        np.multiply(C23, t4, t4)
    if some95 != size:
        np.copyto(t4, C21, where=~m0)
    np.multiply(v101, t4, t4)
    np.subtract(t1, t4, out)


def prepare_displacement_r_a(A, E_star, dgamma):
    v6 = (16.0) * A
    v8 = v6 / (9.42477796076938)
    v78 = (8.0) * A
    v80 = v78 / (3.0)
    v98 = (6.283185307179586) * dgamma
    v99 = v98 / E_star
    v100 = np.sqrt(v99)
    return (A, v8, v80, v100)


def block_displacement_r_a(out, r, a, A, v8, v80, v100, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.square(a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some87 = np.count_nonzero(m0)
    if some87:
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
    if some87 != size:
        other87 = t6 if some87 else t2
        np.multiply(v80, out, other87)
        np.square(r, t4)
        np.square(t4, t4)
        np.multiply(A, t4, t4)
        np.subtract(other87, t4, other87)
        if some87:
            np.copyto(t2, other87, where=~m0)
    some95 = np.count_nonzero(m0)
    if some95:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C23, out, out)
    if some95 != size:
        np.copyto(out, C21, where=~m0)
    np.sqrt(a, t1)
    np.multiply(t1, v100, t1)
    np.multiply(t1, out, out)
    np.subtract(t2, out, out)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, A, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.square(a, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.subtract(r, a, t0)
    np.add(r, a, t1)
    np.greater(r, a, m0)
    some87 = np.count_nonzero(m0)
    if some87:
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
    if some87 != size:
        other87 = t6 if some87 else t2
        np.multiply(C1, A, other87)
        np.divide(other87, C2, other87)
        np.multiply(other87, out, other87)
        np.square(r, t4)
        np.square(t4, t4)
        np.multiply(A, t4, t4)
        np.subtract(other87, t4, other87)
        if some87:
            np.copyto(t2, other87, where=~m0)
    some95 = np.count_nonzero(m0)
    if some95:
        np.maximum(t0, f0, out=out)
        np.multiply(out, t1, out)
        np.sqrt(out, out)
        np.arctan2(a, out, out)
        np.multiply(C23, out, out)
    if some95 != size:
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
            return 64.0 * E_star * A / 15.0 * pow(a, 5.0) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(A, E_star, dgamma):
    v5 = (64.0) * E_star
    v6 = v5 * A
    v8 = v6 / (15.0)
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
    np.multiply(C0, E_star, out)
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
            if r <= a:
                v29 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                v40 = E_star * v29 / (3.141592653589793 * sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * v6)) if v29 > 0.0 else 0.0
            else:
                v40 = 0.0
            return (32.0 * E_star * A / 28.274333882308138 * (a * a + 2.0 * (r * r)) * sqrt(v5 * v6) if r < a else 0.0) - v40
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, A, E_star, dgamma):
    v11 = (32.0) * E_star
    v12 = v11 * A
    v14 = v12 / (28.274333882308138)
    v16 = np.square(a)
    v24 = np.sqrt(a)
    v26 = (6.283185307179586) * dgamma
    v27 = v26 / E_star
    v28 = np.sqrt(v27)
    v29 = v24 * v28
    v30 = np.greater(v29, (0.0))
    v31 = E_star * v29
    return (a, v14, v16, v30, v31)


def block_pressure_r(out, r, a, v14, v16, v30, v31, t0, t1, t2, m0, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, a, m0)
    some23 = np.count_nonzero(m0)
    if some23:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.square(r, t2)
        np.multiply(C0, t2, t2)
        np.add(v16, t2, t2)
        np.multiply(v14, t2, t2)
        np.multiply(t2, t1, t1)
    if some23 != size:
        np.copyto(t1, C29, where=~m0)
    np.less_equal(r, a, m0)
    some40 = np.count_nonzero(m0)
    if some40:
        if v30:
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C30, t2, t2)
            np.divide(v31, t2, t2)
        else:
            np.copyto(t2, C29)
    if some40 != size:
        np.copyto(t2, C29, where=~m0)
    np.subtract(t1, t2, out)


def prepare_pressure_r_a(A, E_star, dgamma):
    v11 = (32.0) * E_star
    v12 = v11 * A
    v14 = v12 / (28.274333882308138)
    v26 = (6.283185307179586) * dgamma
    v27 = v26 / E_star
    v28 = np.sqrt(v27)
    return (E_star, v14, v28)


def block_pressure_r_a(out, r, a, E_star, v14, v28, t0, t1, t2, t3, t4, m0, m1, f0):
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
    some23 = np.count_nonzero(m0)
    if some23:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.square(a, t2)
        np.square(r, t3)
        np.multiply(C0, t3, t3)
        np.add(t2, t3, t3)
        np.multiply(v14, t3, t3)
        np.multiply(t3, t1, t1)
    if some23 != size:
        np.copyto(t1, C29, where=~m0)
    np.less_equal(r, a, m0)
    some40 = np.count_nonzero(m0)
    if some40:
        np.sqrt(a, t2)
        np.multiply(t2, v28, t2)
        np.greater(t2, C29, m1)
        some38 = np.count_nonzero(m1)
        if some38:
            np.multiply(E_star, t2, t3)
            np.maximum(out, f0, out=t4)
            np.multiply(t4, t0, t4)
            np.sqrt(t4, t4)
            np.multiply(C30, t4, t4)
            np.divide(t3, t4, t3)
        if some38 != size:
            np.copyto(t3, C29, where=~m1)
    if some40 != size:
        np.copyto(t3, C29, where=~m0)
    np.subtract(t1, t3, out)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, A, E_star, dgamma, t0, t1, t2, t3, t4, m0, m1, f0):
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
    some23 = np.count_nonzero(m0)
    if some23:
        np.multiply(out, t0, t1)
        np.sqrt(t1, t1)
        np.multiply(C31, E_star, t2)
        np.multiply(t2, A, t2)
        np.divide(t2, C32, t2)
        np.square(a, t3)
        np.square(r, t4)
        np.multiply(C0, t4, t4)
        np.add(t3, t4, t4)
        np.multiply(t2, t4, t4)
        np.multiply(t4, t1, t1)
    if some23 != size:
        np.copyto(t1, C29, where=~m0)
    np.less_equal(r, a, m0)
    some40 = np.count_nonzero(m0)
    if some40:
        np.sqrt(a, t2)
        np.multiply(C3, dgamma, t3)
        np.divide(t3, E_star, t3)
        np.sqrt(t3, t3)
        np.multiply(t2, t3, t3)
        np.greater(t3, C29, m1)
        some38 = np.count_nonzero(m1)
        if some38:
            np.multiply(E_star, t3, t4)
            np.maximum(out, f0, out=t2)
            np.multiply(t2, t0, t2)
            np.sqrt(t2, t2)
            np.multiply(C30, t2, t2)
            np.divide(t4, t2, t4)
        if some38 != size:
            np.copyto(t4, C29, where=~m1)
    if some40 != size:
        np.copyto(t4, C29, where=~m0)
    np.subtract(t1, t4, out)


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
            v11 = 3.0 * v7 / 7.0
            v17 = 15.0 * v11 / (64.0 * E_star * A)
            v19 = pow(v17, 0.2)
            v34 = v19 + v19 * ((v17 / (pow(v19, 5.0) * pow(v19, 0.0)) - 1.0) / 5.0) if v17 > 0.0 and v17 < inf else v19
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
    np.equal(F, C29, m0)
    some44 = np.count_nonzero(m0)
    if some44:
        np.copyto(out, C29)
    if some44 != size:
        other44 = t0 if some44 else out
        np.less(F, C29, m1)
        some7 = np.count_nonzero(m1)
        if some7:
            np.negative(F, other44)
        if some7 != size:
            np.copyto(other44, C33, where=~m1)
        np.multiply(C2, other44, t1)
        np.divide(t1, C34, t1)
        np.multiply(C28, t1, t2)
        np.multiply(C27, E_star, t3)
        np.multiply(t3, A, t3)
        np.divide(t2, t3, t3)
        np.power(t3, C35, t2)
        np.greater(t3, C29, m1)
        np.less(t3, C36, m2)
        np.bitwise_and(m1, m2, m2)
        some34 = np.count_nonzero(m2)
        if some34:
            np.power(t2, C26, t4)
            np.power(t2, C29, t5)
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
        np.multiply(C37, E_star, other44)
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
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 3, 1, (0.0,), False),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 5, 2, (0.0,), False),
        ('r', 'a', 'A', 'E_star', 'dgamma'): (('r', 'a', 'A', 'E_star', 'dgamma'), prepare_pressure_all, block_pressure_all, 5, 2, (0.0,), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'A', 'E_star'): {
        ('F', 'A', 'E_star'): (('F', 'A', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 6, 3, (), False),
    },
}
