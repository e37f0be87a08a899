"""Programs of axicontact.adhesive.capped_paraboloid."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import capped_paraboloid as bodies

C0 = np.array(2.0)
C1 = np.array(6.283185307179586)
C2 = np.array(3.0)
C3 = np.array(4.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R1, R2, b, E_star, dgamma):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return (a * a / R1 if a < b else a * (a + (R1 - R2) / R2 * sqrt((a - b) * (a + b))) / R1) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R1, R2, b, E_star, dgamma):
    v13 = R1 - R2
    v14 = v13 / R2
    v23 = (6.283185307179586) * dgamma
    v24 = v23 / E_star
    v25 = np.sqrt(v24)
    return (R1, b, v14, v25)


def block_depth_a(out, a, R1, b, v14, v25, t0, t1, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.square(a, out)
        np.divide(out, R1, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.subtract(a, b, other20)
        np.add(a, b, t1)
        np.multiply(other20, t1, t1)
        np.sqrt(t1, t1)
        np.multiply(v14, t1, t1)
        np.add(a, t1, t1)
        np.multiply(a, t1, t1)
        np.divide(t1, R1, other20)
        if some20:
            np.copyto(out, other20, where=~m0)
    np.sqrt(a, t0)
    np.multiply(t0, v25, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R1, R2, b, E_star, dgamma, t0, t1, m0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.square(a, out)
        np.divide(out, R1, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.subtract(a, b, other20)
        np.add(a, b, t1)
        np.multiply(other20, t1, t1)
        np.sqrt(t1, t1)
        np.subtract(R1, R2, other20)
        np.divide(other20, R2, other20)
        np.multiply(other20, t1, t1)
        np.add(a, t1, t1)
        np.multiply(a, t1, t1)
        np.divide(t1, R1, other20)
        if some20:
            np.copyto(out, other20, where=~m0)
    np.sqrt(a, t0)
    np.multiply(C1, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def displacement(r, a, R1, R2, b, E_star, dgamma):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v8 = r - b
            v11 = r + b
            v15 = a - b
            v17 = a + b
            v20 = r - a
            v24 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (r + a))
            v65 = R1 - R2
            v71 = b * b
            v178 = r > a
            if v178:
                v7 = a if a < b or a != a else b
                if a > b:
                    v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * v11)
                    v14 = b / r
                    v25 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * v17) / v24
                    v27 = asinh(v25 / v14)
                    v32 = 0.0 - expm1(-2.0 * v27)
                    v35 = v32 if v32 > 0.0 else inf
                    v52 = b * b
                    v56 = v14 * v14
                    v67 = R1 * R2
                    v68 = 2.0 * v65 / v67
                    v72 = v71 * v65
                    v82 = []
                    for node, weight in RULE_0(v27 / 1.0):
                        v37 = node * v27
                        v46 = v25 * (exp(-v37) * (0.0 - expm1(-2.0 * (v27 - v37))) / v35)
                        v47 = v46 * v46
                        v49 = sqrt(1.0 + v47)
                        v51 = v13 * v46 / v49
                        v55 = sqrt(v52 + v51 * v51)
                        v81 = (2.0 * v55 / R1 + v68 * v51 + v72 / (v67 * v51)) * v51 / v55 * atan2(v55, v13 / v49) * (sqrt(v56 + v47) / (v49 * v49 * v49))
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v27
                    v84 = v13 * v82
                else:
                    v84 = 0.0
                v95 = v7 / (r + sqrt((r - v7) * (r + v7)))
                v97 = v95 * v95
                v179 = 2.0 * (v7 * v7) / (3.141592653589793 * R1) * (v7 / r * (0.6666666666666666 + v97 * (((((((((-0.7327347664453868 * v97 + -32.15553480435792) * v97 + -332.23363563146734) * v97 + -1070.7082873491413) * v97 + -85.27694715374247) * v97 + 5044.821368830373) * v97 + 8082.413158212496) * v97 + 3759.725330928701) * v97 + 0.26666666666720995) / ((((((((0.21387262524856868 * v97 + 32.12935731379798) * v97 + 746.8124983579742) * v97 + 6202.125133759036) * v97 + 23553.080984642995) * v97 + 44404.005348491315) * v97 + 40380.01430284195) * v97 + 14099.684276696918) * v97 + 1.0)))) + 0.6366197723675814 * v84
            else:
                v169 = 2.0 * R1
                v179 = (a * a / R1 if a < b else a * (a + v65 / R2 * sqrt(v15 * v17)) / R1) - (r * r / v169 if r < b else v71 / v169 + v8 * v11 / (2.0 * R2))
            value = v179 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v24) if v178 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R1, R2, b, E_star, dgamma):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v9 = 3.0 * R1
            v12 = a * a
            v13 = a * v12
            v19 = 2.0 * E_star
            return (4.0 * E_star / v9 * v13 if a < b else v19 / v9 * (2.0 * v13 + (R1 - R2) / R2 * (2.0 * v12 + b * b) * sqrt((a - b) * (a + b)))) - v19 * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R1, R2, b, E_star, dgamma):
    v7 = (4.0) * E_star
    v9 = (3.0) * R1
    v10 = v7 / v9
    v19 = (2.0) * E_star
    v20 = v19 / v9
    v22 = R1 - R2
    v23 = v22 / R2
    v25 = np.square(b)
    v36 = (6.283185307179586) * dgamma
    v37 = v36 / E_star
    v38 = np.sqrt(v37)
    return (b, v10, v19, v20, v23, v25, v38)


def block_force_a(out, a, b, v10, v19, v20, v23, v25, v38, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, t0)
    np.less(a, b, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.multiply(v10, t0, t1)
    if some32 != size:
        other32 = t2 if some32 else t1
        np.subtract(a, b, other32)
        np.add(a, b, t3)
        np.multiply(other32, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(C0, t0, other32)
        np.multiply(C0, out, t4)
        np.add(t4, v25, t4)
        np.multiply(v23, t4, t4)
        np.multiply(t4, t3, t3)
        np.add(other32, t3, t3)
        np.multiply(v20, t3, other32)
        if some32:
            np.copyto(t1, other32, where=~m0)
    np.multiply(v19, a, t0)
    np.sqrt(a, out)
    np.multiply(out, v38, out)
    np.multiply(t0, out, out)
    np.subtract(t1, out, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R1, R2, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, m0):
    size = out.size
    np.multiply(C2, R1, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.multiply(a, t0, t1)
    np.multiply(C0, E_star, t2)
    np.less(a, b, m0)
    some32 = np.count_nonzero(m0)
    if some32:
        np.multiply(C3, E_star, t3)
        np.divide(t3, out, t3)
        np.multiply(t3, t1, t3)
    if some32 != size:
        other32 = t4 if some32 else t3
        np.subtract(a, b, other32)
        np.add(a, b, t5)
        np.multiply(other32, t5, t5)
        np.sqrt(t5, t5)
        np.divide(t2, out, other32)
        np.multiply(C0, t1, t6)
        np.subtract(R1, R2, t7)
        np.divide(t7, R2, t7)
        np.multiply(C0, t0, t8)
        np.square(b, t9)
        np.add(t8, t9, t9)
        np.multiply(t7, t9, t9)
        np.multiply(t9, t5, t5)
        np.add(t6, t5, t5)
        np.multiply(other32, t5, other32)
        if some32:
            np.copyto(t3, other32, where=~m0)
    np.multiply(t2, a, t2)
    np.sqrt(a, t1)
    np.multiply(C1, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t1, t0, t0)
    np.multiply(t2, t0, t0)
    np.subtract(t3, t0, out)


def pressure(r, a, R1, R2, b, E_star, dgamma):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            if r < a:
                v21 = r == b
                if (v21 and a > b) and R1 > R2:
                    v96 = inf
                else:
                    v7 = a if a < b or a != a else b
                    v24 = nextafter(b, inf) if v21 else r
                    if a > (v24 if v24 > b or v24 != v24 else b):
                        v25 = v24 < b
                        v28 = a - b
                        v32 = sqrt((v28 if v28 > 0.0 or v28 != v28 else 0.0) * (a + b))
                        if v25:
                            v38 = v32
                        else:
                            v33 = a - v24
                            v38 = sqrt((v33 if v33 > 0.0 or v33 != v33 else 0.0) * (a + v24))
                        v45 = asinh(v38 / sqrt(abs(v24 - b) * (v24 + b)))
                        v46 = 2.0 * (0.0 if v25 else 1.0)
                        v47 = 1.0 - v46
                        v52 = v46 - v47 * expm1(-2.0 * v45)
                        v54 = v52 if v52 > 0.0 else inf
                        v68 = b * b
                        v74 = R1 - R2
                        v76 = R1 * R2
                        v77 = 2.0 * v74 / v76
                        v81 = b * b * v74
                        v87 = []
                        for node, weight in RULE_0(v45 / 1.0):
                            v57 = node * v45
                            v67 = v32 * (exp(-v57) * (v46 - v47 * expm1(-2.0 * (v45 - v57))) / v54)
                            v71 = sqrt(v68 + v67 * v67)
                            v86 = (2.0 * v71 / R1 + v77 * v67 + v81 / (v76 * v67)) * v67 / v71
                            v87.append(weight * v86)
                        v87 = fsum(v87) * v45
                        v88 = v87
                    else:
                        v88 = 0.0
                    v96 = (2.0 * E_star / (3.141592653589793 * R1) * sqrt((v7 - r) * (v7 + r)) if r < v7 else 0.0) + E_star / 3.141592653589793 * v88
                v98 = v96
            else:
                v98 = 0.0
            if r <= a:
                v104 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                if v104 > 0.0:
                    v107 = a - r
                    v114 = E_star * v104 / (3.141592653589793 * sqrt((v107 if v107 > 0.0 or v107 != v107 else 0.0) * (a + r)))
                else:
                    v114 = 0.0
                v116 = v114
            else:
                v116 = 0.0
            value = v98 - v116
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R1, R2, b, E_star, dgamma, control):
    if R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and R1 > -1e+30 and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(R1, R2, b, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R1, R2, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R1, R2, b, E_star, dgamma):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R1, R2, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R1, R2, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R1, R2, b, E_star, dgamma):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, R1, R2, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R1, R2, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, R1, R2, b, E_star):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (E_star > -1e+30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 2, 1, (), False),
        ('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): (('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 1, (), False),
    },
    ('_force', 1, 'a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 5, 1, (), False),
        ('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): (('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 10, 1, (), False),
    },
}
