"""Programs of axicontact.torsion.paraboloid."""

from __future__ import annotations

from math import log, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.torsion import paraboloid as bodies

C0 = np.array(2.0)
C1 = np.array(0.7853981633974483)
C2 = np.array(1e-08)
C3 = np.array(4.0)
C4 = np.array(1.0)
C5 = np.array(0.0)
C6 = np.array(3.141592653589793)


def full_slip_torque(a, R, E_star, mu):
    if a.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v10 = a * a
            return 0.7853981633974483 * E_star * mu / R * (v10 * v10)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_torque_a(R, E_star, mu):
    v5 = (0.7853981633974483) * E_star
    v6 = v5 * mu
    v7 = v6 / R
    return (v7,)


def block_full_slip_torque_a(out, a, v7):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(v7, out, out)


def prepare_full_slip_torque_all():
    return ()


def block_full_slip_torque_all(out, a, R, E_star, mu, t0):
    np.multiply(C1, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, mu, out)
    np.divide(out, R, out)
    np.square(a, t0)
    np.square(t0, t0)
    np.multiply(out, t0, out)


def slip_angle(a, c, R, E_star, G, mu):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is G.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G > 1e-30) and (G < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v11 = c / a
            v13 = v11 < 1e-08
            if v13:
                v141 = log(4.0 / v11) - 1.0
            else:
                v20 = 1.0 if v13 else v11
                v24 = v20 if v20 > 1e-09 or v20 != v20 else 1e-09
                v25 = 1.0 + v24
                v27 = 2.0 * v25
                v29 = 2.0 * sqrt(v24)
                v32 = 2.0 + v27 / v25
                v35 = 2.0 * (v27 + 2.0 * v29)
                v36 = v29 + v25
                v38 = 2.0 * sqrt(v29 * v25)
                v41 = v32 + v35 / v36
                v44 = 2.0 * (v35 + v32 * v38)
                v45 = v38 + v36
                v47 = 2.0 * sqrt(v38 * v36)
                v50 = v41 + v44 / v45
                v53 = 2.0 * (v44 + v41 * v47)
                v54 = v47 + v45
                v56 = 2.0 * sqrt(v47 * v45)
                v59 = v50 + v53 / v54
                v62 = 2.0 * (v53 + v50 * v56)
                v63 = v56 + v54
                v65 = 2.0 * sqrt(v56 * v54)
                v68 = v59 + v62 / v63
                v71 = 2.0 * (v62 + v59 * v65)
                v72 = v65 + v63
                v74 = 2.0 * sqrt(v65 * v63)
                v77 = v68 + v71 / v72
                v80 = 2.0 * (v71 + v68 * v74)
                v81 = v74 + v72
                v83 = 2.0 * sqrt(v74 * v72)
                v90 = v83 + v81
                v93 = v90 * v90
                v97 = 2.0 * (0.0 + v24)
                v99 = 1.0 + v97 / v25
                v101 = 2.0 * (v97 + v29)
                v103 = v99 + v101 / v36
                v106 = 2.0 * (v101 + v99 * v38)
                v108 = v103 + v106 / v45
                v111 = 2.0 * (v106 + v103 * v47)
                v113 = v108 + v111 / v54
                v116 = 2.0 * (v111 + v108 * v56)
                v118 = v113 + v116 / v63
                v121 = 2.0 * (v116 + v113 * v65)
                v123 = v118 + v121 / v72
                v126 = 2.0 * (v121 + v118 * v74)
                v141 = 0.7853981633974483 * ((a - c) / a * ((a + c) / a)) * ((2.0 * (v80 + v77 * v83) + (v77 + v80 / v81) * v90) / v93 - (2.0 * (v126 + v123 * v83) + (v123 + v126 / v81) * v90) / v93)
            value = E_star * mu / R / (3.141592653589793 * G) * (a * v141)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_slip_angle_a(c, R, E_star, G, mu):
    v6 = E_star * mu
    v7 = v6 / R
    v9 = (3.141592653589793) * G
    v10 = v7 / v9
    return (c, v10)


def block_slip_angle_a(out, a, c, v10, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, m0, f0):
    size = out.size
    np.divide(c, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(out, C2, m0)
    some140 = np.count_nonzero(m0)
    if some140:
        np.divide(C3, out, t0)
        np.log(t0, t0)
        np.subtract(t0, C4, t0)
    if some140 != size:
        other140 = t1 if some140 else t0
        np.subtract(a, c, other140)
        np.divide(other140, a, other140)
        np.add(a, c, t2)
        np.divide(t2, a, t2)
        np.multiply(other140, t2, t2)
        some20 = np.count_nonzero(m0)
        if some20:
            np.copyto(other140, C4)
        if some20 != size:
            np.copyto(other140, out, where=~m0)
        np.multiply(C1, t2, t2)
        np.maximum(other140, f0, out=other140)
        np.add(C4, other140, t3)
        np.multiply(C0, t3, t4)
        np.sqrt(other140, t5)
        np.multiply(C0, t5, t5)
        np.multiply(t5, t3, t6)
        np.divide(t4, t3, t7)
        np.add(C0, t7, t7)
        np.multiply(C0, t5, t8)
        np.add(t4, t8, t8)
        np.multiply(C0, t8, t8)
        np.add(t5, t3, t4)
        np.sqrt(t6, t6)
        np.multiply(C0, t6, t6)
        np.multiply(t6, t4, t9)
        np.divide(t8, t4, t10)
        np.add(t7, t10, t10)
        np.multiply(t7, t6, t7)
        np.add(t8, t7, t7)
        np.multiply(C0, t7, t7)
        np.add(t6, t4, t8)
        np.sqrt(t9, t9)
        np.multiply(C0, t9, t9)
        np.multiply(t9, t8, t11)
        np.divide(t7, t8, t12)
        np.add(t10, t12, t12)
        np.multiply(t10, t9, t10)
        np.add(t7, t10, t10)
        np.multiply(C0, t10, t10)
        np.add(t9, t8, t7)
        np.sqrt(t11, t11)
        np.multiply(C0, t11, t11)
        np.multiply(t11, t7, t13)
        np.divide(t10, t7, t14)
        np.add(t12, t14, t14)
        np.multiply(t12, t11, t12)
        np.add(t10, t12, t12)
        np.multiply(C0, t12, t12)
        np.add(t11, t7, t10)
        np.sqrt(t13, t13)
        np.multiply(C0, t13, t13)
        np.multiply(t13, t10, t15)
        np.divide(t12, t10, t16)
        np.add(t14, t16, t16)
        np.multiply(t14, t13, t14)
        np.add(t12, t14, t14)
        np.multiply(C0, t14, t14)
        np.add(t13, t10, t12)
        np.sqrt(t15, t15)
        np.multiply(C0, t15, t15)
        np.multiply(t15, t12, t17)
        np.divide(t14, t12, t18)
        np.add(t16, t18, t18)
        np.multiply(t16, t15, t16)
        np.add(t14, t16, t16)
        np.multiply(C0, t16, t16)
        np.add(t15, t12, t14)
        np.sqrt(t17, t17)
        np.multiply(C0, t17, t17)
        np.divide(t16, t14, t19)
        np.add(t18, t19, t19)
        np.multiply(t18, t17, t18)
        np.add(t16, t18, t18)
        np.multiply(C0, t18, t18)
        np.add(t17, t14, t16)
        np.multiply(t19, t16, t19)
        np.add(t18, t19, t19)
        np.multiply(t16, t16, t18)
        np.divide(t19, t18, t19)
        np.add(C5, other140, other140)
        np.multiply(C0, other140, other140)
        np.divide(other140, t3, t3)
        np.add(C4, t3, t3)
        np.add(other140, t5, t5)
        np.multiply(C0, t5, t5)
        np.divide(t5, t4, t4)
        np.add(t3, t4, t4)
        np.multiply(t3, t6, t6)
        np.add(t5, t6, t6)
        np.multiply(C0, t6, t6)
        np.divide(t6, t8, t8)
        np.add(t4, t8, t8)
        np.multiply(t4, t9, t9)
        np.add(t6, t9, t9)
        np.multiply(C0, t9, t9)
        np.divide(t9, t7, t7)
        np.add(t8, t7, t7)
        np.multiply(t8, t11, t11)
        np.add(t9, t11, t11)
        np.multiply(C0, t11, t11)
        np.divide(t11, t10, t10)
        np.add(t7, t10, t10)
        np.multiply(t7, t13, t13)
        np.add(t11, t13, t13)
        np.multiply(C0, t13, t13)
        np.divide(t13, t12, t12)
        np.add(t10, t12, t12)
        np.multiply(t10, t15, t15)
        np.add(t13, t15, t15)
        np.multiply(C0, t15, t15)
        np.divide(t15, t14, t14)
        np.add(t12, t14, t14)
        np.multiply(t12, t17, t17)
        np.add(t15, t17, t17)
        np.multiply(C0, t17, t17)
        np.multiply(t14, t16, t16)
        np.add(t17, t16, t16)
        np.divide(t16, t18, t18)
        np.subtract(t19, t18, t18)
        np.multiply(t2, t18, other140)
        if some140:
            np.copyto(t0, other140, where=~m0)
    np.multiply(a, t0, t0)
    np.multiply(v10, t0, out)


def prepare_slip_angle_a_c(R, E_star, G, mu):
    v6 = E_star * mu
    v7 = v6 / R
    v9 = (3.141592653589793) * G
    v10 = v7 / v9
    return (v10,)


def block_slip_angle_a_c(out, a, c, v10, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, m0, f0):
    size = out.size
    np.divide(c, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.less(out, C2, m0)
    some140 = np.count_nonzero(m0)
    if some140:
        np.divide(C3, out, t0)
        np.log(t0, t0)
        np.subtract(t0, C4, t0)
    if some140 != size:
        other140 = t1 if some140 else t0
        np.subtract(a, c, other140)
        np.divide(other140, a, other140)
        np.add(a, c, t2)
        np.divide(t2, a, t2)
        np.multiply(other140, t2, t2)
        some20 = np.count_nonzero(m0)
        if some20:
            np.copyto(other140, C4)
        if some20 != size:
            np.copyto(other140, out, where=~m0)
        np.multiply(C1, t2, t2)
        np.maximum(other140, f0, out=other140)
        np.add(C4, other140, t3)
        np.multiply(C0, t3, t4)
        np.sqrt(other140, t5)
        np.multiply(C0, t5, t5)
        np.multiply(t5, t3, t6)
        np.divide(t4, t3, t7)
        np.add(C0, t7, t7)
        np.multiply(C0, t5, t8)
        np.add(t4, t8, t8)
        np.multiply(C0, t8, t8)
        np.add(t5, t3, t4)
        np.sqrt(t6, t6)
        np.multiply(C0, t6, t6)
        np.multiply(t6, t4, t9)
        np.divide(t8, t4, t10)
        np.add(t7, t10, t10)
        np.multiply(t7, t6, t7)
        np.add(t8, t7, t7)
        np.multiply(C0, t7, t7)
        np.add(t6, t4, t8)
        np.sqrt(t9, t9)
        np.multiply(C0, t9, t9)
        np.multiply(t9, t8, t11)
        np.divide(t7, t8, t12)
        np.add(t10, t12, t12)
        np.multiply(t10, t9, t10)
        np.add(t7, t10, t10)
        np.multiply(C0, t10, t10)
        np.add(t9, t8, t7)
        np.sqrt(t11, t11)
        np.multiply(C0, t11, t11)
        np.multiply(t11, t7, t13)
        np.divide(t10, t7, t14)
        np.add(t12, t14, t14)
        np.multiply(t12, t11, t12)
        np.add(t10, t12, t12)
        np.multiply(C0, t12, t12)
        np.add(t11, t7, t10)
        np.sqrt(t13, t13)
        np.multiply(C0, t13, t13)
        np.multiply(t13, t10, t15)
        np.divide(t12, t10, t16)
        np.add(t14, t16, t16)
        np.multiply(t14, t13, t14)
        np.add(t12, t14, t14)
        np.multiply(C0, t14, t14)
        np.add(t13, t10, t12)
        np.sqrt(t15, t15)
        np.multiply(C0, t15, t15)
        np.multiply(t15, t12, t17)
        np.divide(t14, t12, t18)
        np.add(t16, t18, t18)
        np.multiply(t16, t15, t16)
        np.add(t14, t16, t16)
        np.multiply(C0, t16, t16)
        np.add(t15, t12, t14)
        np.sqrt(t17, t17)
        np.multiply(C0, t17, t17)
        np.divide(t16, t14, t19)
        np.add(t18, t19, t19)
        np.multiply(t18, t17, t18)
        np.add(t16, t18, t18)
        np.multiply(C0, t18, t18)
        np.add(t17, t14, t16)
        np.multiply(t19, t16, t19)
        np.add(t18, t19, t19)
        np.multiply(t16, t16, t18)
        np.divide(t19, t18, t19)
        np.add(C5, other140, other140)
        np.multiply(C0, other140, other140)
        np.divide(other140, t3, t3)
        np.add(C4, t3, t3)
        np.add(other140, t5, t5)
        np.multiply(C0, t5, t5)
        np.divide(t5, t4, t4)
        np.add(t3, t4, t4)
        np.multiply(t3, t6, t6)
        np.add(t5, t6, t6)
        np.multiply(C0, t6, t6)
        np.divide(t6, t8, t8)
        np.add(t4, t8, t8)
        np.multiply(t4, t9, t9)
        np.add(t6, t9, t9)
        np.multiply(C0, t9, t9)
        np.divide(t9, t7, t7)
        np.add(t8, t7, t7)
        np.multiply(t8, t11, t11)
        np.add(t9, t11, t11)
        np.multiply(C0, t11, t11)
        np.divide(t11, t10, t10)
        np.add(t7, t10, t10)
        np.multiply(t7, t13, t13)
        np.add(t11, t13, t13)
        np.multiply(C0, t13, t13)
        np.divide(t13, t12, t12)
        np.add(t10, t12, t12)
        np.multiply(t10, t15, t15)
        np.add(t13, t15, t15)
        np.multiply(C0, t15, t15)
        np.divide(t15, t14, t14)
        np.add(t12, t14, t14)
        np.multiply(t12, t17, t17)
        np.add(t15, t17, t17)
        np.multiply(C0, t17, t17)
        np.multiply(t14, t16, t16)
        np.add(t17, t16, t16)
        np.divide(t16, t18, t18)
        np.subtract(t19, t18, t18)
        np.multiply(t2, t18, other140)
        if some140:
            np.copyto(t0, other140, where=~m0)
    np.multiply(a, t0, t0)
    np.multiply(v10, t0, out)


def prepare_slip_angle_all():
    return ()


def block_slip_angle_all(out, a, c, R, E_star, G, mu, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, m0, f0):
    size = out.size
    np.multiply(E_star, mu, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)
    np.multiply(C6, G, t0)
    np.divide(out, t0, t0)
    np.divide(c, a, out)
    np.less(out, C2, m0)
    some140 = np.count_nonzero(m0)
    if some140:
        np.divide(C3, out, t1)
        np.log(t1, t1)
        np.subtract(t1, C4, t1)
    if some140 != size:
        other140 = t2 if some140 else t1
        np.subtract(a, c, other140)
        np.divide(other140, a, other140)
        np.add(a, c, t3)
        np.divide(t3, a, t3)
        np.multiply(other140, t3, t3)
        some20 = np.count_nonzero(m0)
        if some20:
            np.copyto(other140, C4)
        if some20 != size:
            np.copyto(other140, out, where=~m0)
        np.multiply(C1, t3, t3)
        np.maximum(other140, f0, out=other140)
        np.add(C4, other140, t4)
        np.multiply(C0, t4, t5)
        np.sqrt(other140, t6)
        np.multiply(C0, t6, t6)
        np.multiply(t6, t4, t7)
        np.divide(t5, t4, t8)
        np.add(C0, t8, t8)
        np.multiply(C0, t6, t9)
        np.add(t5, t9, t9)
        np.multiply(C0, t9, t9)
        np.add(t6, t4, t5)
        np.sqrt(t7, t7)
        np.multiply(C0, t7, t7)
        np.multiply(t7, t5, t10)
        np.divide(t9, t5, t11)
        np.add(t8, t11, t11)
        np.multiply(t8, t7, t8)
        np.add(t9, t8, t8)
        np.multiply(C0, t8, t8)
        np.add(t7, t5, t9)
        np.sqrt(t10, t10)
        np.multiply(C0, t10, t10)
        np.multiply(t10, t9, t12)
        np.divide(t8, t9, t13)
        np.add(t11, t13, t13)
        np.multiply(t11, t10, t11)
        np.add(t8, t11, t11)
        np.multiply(C0, t11, t11)
        np.add(t10, t9, t8)
        np.sqrt(t12, t12)
        np.multiply(C0, t12, t12)
        np.multiply(t12, t8, t14)
        np.divide(t11, t8, t15)
        np.add(t13, t15, t15)
        np.multiply(t13, t12, t13)
        np.add(t11, t13, t13)
        np.multiply(C0, t13, t13)
        np.add(t12, t8, t11)
        np.sqrt(t14, t14)
        np.multiply(C0, t14, t14)
        np.multiply(t14, t11, t16)
        np.divide(t13, t11, t17)
        np.add(t15, t17, t17)
        np.multiply(t15, t14, t15)
        np.add(t13, t15, t15)
        np.multiply(C0, t15, t15)
        np.add(t14, t11, t13)
        np.sqrt(t16, t16)
        np.multiply(C0, t16, t16)
        np.multiply(t16, t13, t18)
        np.divide(t15, t13, t19)
        np.add(t17, t19, t19)
        np.multiply(t17, t16, t17)
        np.add(t15, t17, t17)
        np.multiply(C0, t17, t17)
        np.add(t16, t13, t15)
        np.sqrt(t18, t18)
        np.multiply(C0, t18, t18)
        np.divide(t17, t15, t20)
        np.add(t19, t20, t20)
        np.multiply(t19, t18, t19)
        np.add(t17, t19, t19)
        np.multiply(C0, t19, t19)
        np.add(t18, t15, t17)
        np.multiply(t20, t17, t20)
        np.add(t19, t20, t20)
        np.multiply(t17, t17, t19)
        np.divide(t20, t19, t20)
        np.add(C5, other140, other140)
        np.multiply(C0, other140, other140)
        np.divide(other140, t4, t4)
        np.add(C4, t4, t4)
        np.add(other140, t6, t6)
        np.multiply(C0, t6, t6)
        np.divide(t6, t5, t5)
        np.add(t4, t5, t5)
        np.multiply(t4, t7, t7)
        np.add(t6, t7, t7)
        np.multiply(C0, t7, t7)
        np.divide(t7, t9, t9)
        np.add(t5, t9, t9)
        np.multiply(t5, t10, t10)
        np.add(t7, t10, t10)
        np.multiply(C0, t10, t10)
        np.divide(t10, t8, t8)
        np.add(t9, t8, t8)
        np.multiply(t9, t12, t12)
        np.add(t10, t12, t12)
        np.multiply(C0, t12, t12)
        np.divide(t12, t11, t11)
        np.add(t8, t11, t11)
        np.multiply(t8, t14, t14)
        np.add(t12, t14, t14)
        np.multiply(C0, t14, t14)
        np.divide(t14, t13, t13)
        np.add(t11, t13, t13)
        np.multiply(t11, t16, t16)
        np.add(t14, t16, t16)
        np.multiply(C0, t16, t16)
        np.divide(t16, t15, t15)
        np.add(t13, t15, t15)
        np.multiply(t13, t18, t18)
        np.add(t16, t18, t18)
        np.multiply(C0, t18, t18)
        np.multiply(t15, t17, t17)
        np.add(t18, t17, t17)
        np.divide(t17, t19, t19)
        np.subtract(t20, t19, t19)
        np.multiply(t3, t19, other140)
        if some140:
            np.copyto(t1, other140, where=~m0)
    np.multiply(a, t1, t1)
    np.multiply(t0, t1, out)


def torque(a, c, R, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._torque(a, c, R, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._traction(r, a, c, R, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_torque', 1, 'a', 'R', 'E_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_torque_a, block_full_slip_torque_a, 0, 0, (), False),
        ('a', 'R', 'E_star', 'mu'): (('a', 'R', 'E_star', 'mu'), prepare_full_slip_torque_all, block_full_slip_torque_all, 1, 0, (), False),
    },
    ('_slip_angle', 2, 'a', 'c', 'R', 'E_star', 'G', 'mu'): {
        ('a',): (('a',), prepare_slip_angle_a, block_slip_angle_a, 20, 1, (1e-09,), False),
        ('a', 'c'): (('a', 'c'), prepare_slip_angle_a_c, block_slip_angle_a_c, 20, 1, (1e-09,), False),
        ('a', 'c', 'R', 'E_star', 'G', 'mu'): (('a', 'c', 'R', 'E_star', 'G', 'mu'), prepare_slip_angle_all, block_slip_angle_all, 21, 1, (1e-09,), False),
    },
}
