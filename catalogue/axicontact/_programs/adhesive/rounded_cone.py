"""Programs of axicontact.adhesive.rounded_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nextafter, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import rounded_cone as bodies

C0 = np.array(2.0)
C1 = np.array(6.283185307179586)
C2 = np.array(3.0)
C3 = np.array(4.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, theta, b, E_star, dgamma):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v5 = tan(theta)
            if a < b:
                v22 = v5 / b * (a * a)
            else:
                v13 = sqrt((a - b) * (a + b))
                v22 = v5 * a * (atan(v13 / b) + b / (v13 + a))
            return v22 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, b, E_star, dgamma):
    v5 = np.tan(theta)
    v6 = v5 / b
    v25 = (6.283185307179586) * dgamma
    v26 = v25 / E_star
    v27 = np.sqrt(v26)
    return (b, v5, v6, v27)


def block_depth_a(out, a, b, v5, v6, v27, t0, t1, t2, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some22 = np.count_nonzero(m0)
    if some22:
        np.square(a, out)
        np.multiply(v6, out, out)
    if some22 != size:
        other22 = t0 if some22 else out
        np.subtract(a, b, other22)
        np.add(a, b, t1)
        np.multiply(other22, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, b, other22)
        np.arctan(other22, other22)
        np.multiply(v5, a, t2)
        np.add(t1, a, t1)
        np.divide(b, t1, t1)
        np.add(other22, t1, t1)
        np.multiply(t2, t1, other22)
        if some22:
            np.copyto(out, other22, where=~m0)
    np.sqrt(a, t0)
    np.multiply(t0, v27, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, E_star, dgamma, t0, t1, t2, t3, m0):
    size = out.size
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.divide(out, b, t0)
        np.square(a, t1)
        np.multiply(t0, t1, t0)
    if some22 != size:
        other22 = t1 if some22 else t0
        np.subtract(a, b, other22)
        np.add(a, b, t2)
        np.multiply(other22, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other22)
        np.arctan(other22, other22)
        np.multiply(out, a, t3)
        np.add(t2, a, t2)
        np.divide(b, t2, t2)
        np.add(other22, t2, t2)
        np.multiply(t3, t2, other22)
        if some22:
            np.copyto(t0, other22, where=~m0)
    np.sqrt(a, out)
    np.multiply(C1, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def displacement(r, a, theta, b, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v14 = a - b
            v16 = a + b
            v19 = r - a
            v23 = sqrt((v19 if v19 > 0.0 or v19 != v19 else 0.0) * (r + a))
            v63 = tan(theta)
            v65 = 2.0 * b
            v174 = r > a
            if v174:
                v6 = a if a < b or a != a else b
                if a > b:
                    v7 = r - b
                    v12 = sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * (r + b))
                    v13 = b / r
                    v24 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * v16) / v23
                    v26 = asinh(v24 / v13)
                    v31 = 0.0 - expm1(-2.0 * v26)
                    v34 = v31 if v31 > 0.0 else inf
                    v51 = b * b
                    v55 = v13 * v13
                    v76 = []
                    for node, weight in RULE_0(v26 / 1.0):
                        v36 = node * v26
                        v45 = v24 * (exp(-v36) * (0.0 - expm1(-2.0 * (v26 - v36))) / v34)
                        v46 = v45 * v45
                        v48 = sqrt(1.0 + v46)
                        v50 = v12 * v45 / v48
                        v54 = sqrt(v51 + v50 * v50)
                        v75 = v63 * (atan(v50 / b) + v65 / (v50 + v54)) * v50 / v54 * atan2(v54, v12 / v48) * (sqrt(v55 + v46) / (v48 * v48 * v48))
                        v76.append(weight * v75)
                    v76 = fsum(v76) * v26
                    v78 = v12 * v76
                else:
                    v78 = 0.0
                v90 = v6 / (r + sqrt((r - v6) * (r + v6)))
                v92 = v90 * v90
                v175 = 2.0 * v63 / (3.141592653589793 * b) * (v6 * v6) * (v6 / r * (0.6666666666666666 + v92 * (((((((((-0.7327347664453868 * v92 + -32.15553480435792) * v92 + -332.23363563146734) * v92 + -1070.7082873491413) * v92 + -85.27694715374247) * v92 + 5044.821368830373) * v92 + 8082.413158212496) * v92 + 3759.725330928701) * v92 + 0.26666666666720995) / ((((((((0.21387262524856868 * v92 + 32.12935731379798) * v92 + 746.8124983579742) * v92 + 6202.125133759036) * v92 + 23553.080984642995) * v92 + 44404.005348491315) * v92 + 40380.01430284195) * v92 + 14099.684276696918) * v92 + 1.0)))) + 0.6366197723675814 * v78
            else:
                if a < b:
                    v164 = v63 / b * (a * a)
                else:
                    v155 = sqrt(v14 * v16)
                    v164 = v63 * a * (atan(v155 / b) + b / (v155 + a))
                v175 = v164 - (v63 / v65 * (r * r) if r < b else v63 * (r - b / 2.0))
            value = v175 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v23) if v174 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star, dgamma):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v7 = tan(theta)
            v13 = a * a
            if a < b:
                v35 = 4.0 * E_star * v7 / (3.0 * b) * (a * v13)
            else:
                v19 = sqrt((a - b) * (a + b))
                v35 = E_star * v7 * (v13 * atan(v19 / b) + 4.0 * b * v13 / (3.0 * (v19 + a)) + b / 3.0 * v19)
            return v35 - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, b, E_star, dgamma):
    v6 = (4.0) * E_star
    v7 = np.tan(theta)
    v8 = v6 * v7
    v10 = (3.0) * b
    v11 = v8 / v10
    v22 = E_star * v7
    v24 = (4.0) * b
    v30 = b / (3.0)
    v36 = (2.0) * E_star
    v40 = (6.283185307179586) * dgamma
    v41 = v40 / E_star
    v42 = np.sqrt(v41)
    return (b, v11, v22, v24, v30, v36, v42)


def block_force_a(out, a, b, v11, v22, v24, v30, v36, v42, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some35 = np.count_nonzero(m0)
    if some35:
        np.multiply(a, out, t0)
        np.multiply(v11, t0, t0)
    if some35 != size:
        other35 = t1 if some35 else t0
        np.subtract(a, b, other35)
        np.add(a, b, t2)
        np.multiply(other35, t2, t2)
        np.sqrt(t2, t2)
        np.divide(t2, b, other35)
        np.arctan(other35, other35)
        np.multiply(out, other35, other35)
        np.multiply(v24, out, t3)
        np.add(t2, a, t4)
        np.multiply(C2, t4, t4)
        np.divide(t3, t4, t4)
        np.add(other35, t4, t4)
        np.multiply(v30, t2, t2)
        np.add(t4, t2, t2)
        np.multiply(v22, t2, other35)
        if some35:
            np.copyto(t0, other35, where=~m0)
    np.multiply(v36, a, out)
    np.sqrt(a, t1)
    np.multiply(t1, v42, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, m0):
    size = out.size
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.less(a, b, m0)
    some35 = np.count_nonzero(m0)
    if some35:
        np.multiply(C3, E_star, t1)
        np.multiply(t1, out, t1)
        np.multiply(C2, b, t2)
        np.divide(t1, t2, t2)
        np.multiply(a, t0, t1)
        np.multiply(t2, t1, t1)
    if some35 != size:
        other35 = t2 if some35 else t1
        np.subtract(a, b, other35)
        np.add(a, b, t3)
        np.multiply(other35, t3, t3)
        np.sqrt(t3, t3)
        np.divide(t3, b, other35)
        np.arctan(other35, other35)
        np.multiply(E_star, out, t4)
        np.multiply(t0, other35, other35)
        np.multiply(C3, b, t5)
        np.multiply(t5, t0, t5)
        np.add(t3, a, t6)
        np.multiply(C2, t6, t6)
        np.divide(t5, t6, t6)
        np.add(other35, t6, t6)
        np.divide(b, C2, other35)
        np.multiply(other35, t3, t3)
        np.add(t6, t3, t3)
        np.multiply(t4, t3, other35)
        if some35:
            np.copyto(t1, other35, where=~m0)
    np.multiply(C0, E_star, t0)
    np.multiply(t0, a, t0)
    np.sqrt(a, out)
    np.multiply(C1, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(out, t2, t2)
    np.multiply(t0, t2, t2)
    np.subtract(t1, t2, out)


def pressure(r, a, theta, b, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            if r < a:
                v6 = a if a < b or a != a else b
                v14 = tan(theta)
                v25 = nextafter(b, inf) if r == b else r
                if a > (v25 if v25 > b or v25 != v25 else b):
                    v26 = v25 < b
                    v29 = a - b
                    v33 = sqrt((v29 if v29 > 0.0 or v29 != v29 else 0.0) * (a + b))
                    if v26:
                        v39 = v33
                    else:
                        v34 = a - v25
                        v39 = sqrt((v34 if v34 > 0.0 or v34 != v34 else 0.0) * (a + v25))
                    v46 = asinh(v39 / sqrt(abs(v25 - b) * (v25 + b)))
                    v47 = 2.0 * (0.0 if v26 else 1.0)
                    v48 = 1.0 - v47
                    v53 = v47 - v48 * expm1(-2.0 * v46)
                    v55 = v53 if v53 > 0.0 else inf
                    v69 = b * b
                    v75 = 2.0 * b
                    v82 = []
                    for node, weight in RULE_0(v46 / 1.0):
                        v58 = node * v46
                        v68 = v33 * (exp(-v58) * (v47 - v48 * expm1(-2.0 * (v46 - v58))) / v55)
                        v72 = sqrt(v69 + v68 * v68)
                        v81 = v14 * (atan(v68 / b) + v75 / (v68 + v72)) * v68 / v72
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v46
                    v83 = v82
                else:
                    v83 = 0.0
                v88 = (2.0 * E_star * v14 / (3.141592653589793 * b) * sqrt((v6 - r) * (v6 + r)) if r < v6 else 0.0) + E_star / 3.141592653589793 * v83
            else:
                v88 = 0.0
            if r <= a:
                v94 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                if v94 > 0.0:
                    v97 = a - r
                    v104 = E_star * v94 / (3.141592653589793 * sqrt((v97 if v97 > 0.0 or v97 != v97 else 0.0) * (a + r)))
                else:
                    v104 = 0.0
                v106 = v104
            else:
                v106 = 0.0
            value = v88 - v106
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(theta, b, E_star, dgamma, control):
    if theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and theta > 1e-30 and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(theta, b, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, theta, b, E_star, dgamma):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star, dgamma):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'theta', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 3, 1, (), False),
        ('a', 'theta', 'b', 'E_star', 'dgamma'): (('a', 'theta', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 4, 1, (), False),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 5, 1, (), False),
        ('a', 'theta', 'b', 'E_star', 'dgamma'): (('a', 'theta', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 7, 1, (), False),
    },
}
