"""Programs of axicontact.adhesive.rounded_curved_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import rounded_curved_punch as bodies

C0 = np.array(2.0)
C1 = np.array(0.42)
C2 = np.array(0.0005288491342179178)
C3 = np.array(0.038096760299703034)
C4 = np.array(0.4065213849117787)
C5 = np.array(1.438682033198726)
C6 = np.array(1.9979042349620892)
C7 = np.array(0.9428090415820634)
C8 = np.array(0.006421883194715949)
C9 = np.array(0.15001504718401248)
C10 = np.array(0.9450913324352289)
C11 = np.array(2.37401087025821)
C12 = np.array(2.569097449054519)
C13 = np.array(1.0)
C14 = np.array(6.283185307179586)
C15 = np.array(4.0)
C16 = np.array(3.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R1, R2, b, E_star, dgamma):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            if a < b:
                v63 = a * a / R1
            else:
                v11 = a - b
                v12 = v11 / b
                if v12 < 0.42:
                    v58 = v12 * sqrt(v12) * ((((((0.0005288491342179178 * v12 + 0.038096760299703034) * v12 + 0.4065213849117787) * v12 + 1.438682033198726) * v12 + 1.9979042349620892) * v12 + 0.9428090415820634) / (((((0.006421883194715949 * v12 + 0.15001504718401248) * v12 + 0.9450913324352289) * v12 + 2.37401087025821) * v12 + 2.569097449054519) * v12 + 1.0))
                else:
                    v18 = sqrt(v11 * (a + b)) / b
                    v58 = v18 - atan(v18)
                v63 = a * (a / R1 + b / R2 * v58)
            value = v63 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R1, R2, b, E_star, dgamma):
    v10 = b / R2
    v66 = (6.283185307179586) * dgamma
    v67 = v66 / E_star
    v68 = np.sqrt(v67)
    return (R1, b, v10, v68)


def block_depth_a(out, a, R1, b, v10, v68, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some63 = np.count_nonzero(m0)
    if some63:
        np.square(a, out)
        np.divide(out, R1, out)
    if some63 != size:
        other63 = t0 if some63 else out
        np.divide(a, R1, other63)
        np.subtract(a, b, t1)
        np.divide(t1, b, t2)
        np.less(t2, C1, m1)
        some58 = np.count_nonzero(m1)
        if some58:
            np.minimum(t2, f0, out=t3)
            np.sqrt(t3, t4)
            np.multiply(t3, t4, t4)
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
            np.multiply(C8, t3, t6)
            np.add(t6, C9, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C10, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C11, t6)
            np.multiply(t6, t3, t6)
            np.add(t6, C12, t6)
            np.multiply(t6, t3, t3)
            np.add(t3, C13, t3)
            np.divide(t5, t3, t3)
            np.multiply(t4, t3, t3)
        if some58 != size:
            other58 = t4 if some58 else t3
            np.add(a, b, other58)
            np.multiply(t1, other58, other58)
            np.sqrt(other58, other58)
            np.divide(other58, b, other58)
            np.arctan(other58, t5)
            np.subtract(other58, t5, other58)
            if some58:
                np.copyto(t3, other58, where=~m1)
        np.multiply(v10, t3, t3)
        np.add(other63, t3, t3)
        np.multiply(a, t3, other63)
        if some63:
            np.copyto(out, other63, where=~m0)
    np.sqrt(a, t0)
    np.multiply(t0, v68, t0)
    np.subtract(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R1, R2, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some63 = np.count_nonzero(m0)
    if some63:
        np.square(a, out)
        np.divide(out, R1, out)
    if some63 != size:
        other63 = t0 if some63 else out
        np.divide(a, R1, other63)
        np.divide(b, R2, t1)
        np.subtract(a, b, t2)
        np.divide(t2, b, t3)
        np.less(t3, C1, m1)
        some58 = np.count_nonzero(m1)
        if some58:
            np.minimum(t3, f0, out=t4)
            np.sqrt(t4, t5)
            np.multiply(t4, t5, t5)
            np.multiply(C2, t4, t6)
            np.add(t6, C3, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C4, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C5, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C6, t6)
            np.multiply(t6, t4, t6)
            np.add(t6, C7, t6)
            np.multiply(C8, t4, t7)
            np.add(t7, C9, t7)
            np.multiply(t7, t4, t7)
            np.add(t7, C10, t7)
            np.multiply(t7, t4, t7)
            np.add(t7, C11, t7)
            np.multiply(t7, t4, t7)
            np.add(t7, C12, t7)
            np.multiply(t7, t4, t4)
            np.add(t4, C13, t4)
            np.divide(t6, t4, t4)
            np.multiply(t5, t4, t4)
        if some58 != size:
            other58 = t5 if some58 else t4
            np.add(a, b, other58)
            np.multiply(t2, other58, other58)
            np.sqrt(other58, other58)
            np.divide(other58, b, other58)
            np.arctan(other58, t6)
            np.subtract(other58, t6, other58)
            if some58:
                np.copyto(t4, other58, where=~m1)
        np.multiply(t1, t4, t4)
        np.add(other63, t4, t4)
        np.multiply(a, t4, other63)
        if some63:
            np.copyto(out, other63, where=~m0)
    np.sqrt(a, t0)
    np.multiply(C14, dgamma, t4)
    np.divide(t4, E_star, t4)
    np.sqrt(t4, t4)
    np.multiply(t0, t4, t4)
    np.subtract(out, t4, out)


def displacement(r, a, R1, R2, b, E_star, dgamma):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v8 = r - b
            v15 = a - b
            v17 = a + b
            v20 = r - a
            v24 = sqrt((v20 if v20 > 0.0 or v20 != v20 else 0.0) * (r + a))
            v69 = b / R2
            v215 = r > a
            if v215:
                v7 = a if a < b or a != a else b
                if a > b:
                    v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (r + b))
                    v14 = b / r
                    v25 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * v17) / v24
                    v27 = asinh(v25 / v14)
                    v32 = 0.0 - expm1(-2.0 * v27)
                    v35 = v32 if v32 > 0.0 else inf
                    v52 = b * b
                    v56 = v14 * v14
                    v78 = []
                    for node, weight in RULE_0(v27 / 1.0):
                        v37 = node * v27
                        v46 = v25 * (exp(-v37) * (0.0 - expm1(-2.0 * (v27 - v37))) / v35)
                        v47 = v46 * v46
                        v49 = sqrt(1.0 + v47)
                        v51 = v13 * v46 / v49
                        v55 = sqrt(v52 + v51 * v51)
                        v77 = (2.0 * v55 / R1 + 2.0 * v51 / R2 - v69 * atan2(v51, b)) * v51 / v55 * atan2(v55, v13 / v49) * (sqrt(v56 + v47) / (v49 * v49 * v49))
                        v78.append(weight * v77)
                    v78 = fsum(v78) * v27
                    v80 = v13 * v78
                else:
                    v80 = 0.0
                v91 = v7 / (r + sqrt((r - v7) * (r + v7)))
                v93 = v91 * v91
                v216 = 2.0 * (v7 * v7) / (3.141592653589793 * R1) * (v7 / r * (0.6666666666666666 + v93 * (((((((((-0.7327347664453868 * v93 + -32.15553480435792) * v93 + -332.23363563146734) * v93 + -1070.7082873491413) * v93 + -85.27694715374247) * v93 + 5044.821368830373) * v93 + 8082.413158212496) * v93 + 3759.725330928701) * v93 + 0.26666666666720995) / ((((((((0.21387262524856868 * v93 + 32.12935731379798) * v93 + 746.8124983579742) * v93 + 6202.125133759036) * v93 + 23553.080984642995) * v93 + 44404.005348491315) * v93 + 40380.01430284195) * v93 + 14099.684276696918) * v93 + 1.0)))) + 0.6366197723675814 * v80
            else:
                if a < b:
                    v204 = a * a / R1
                else:
                    v155 = v15 / b
                    if v155 < 0.42:
                        v199 = v155 * sqrt(v155) * ((((((0.0005288491342179178 * v155 + 0.038096760299703034) * v155 + 0.4065213849117787) * v155 + 1.438682033198726) * v155 + 1.9979042349620892) * v155 + 0.9428090415820634) / (((((0.006421883194715949 * v155 + 0.15001504718401248) * v155 + 0.9450913324352289) * v155 + 2.37401087025821) * v155 + 2.569097449054519) * v155 + 1.0))
                    else:
                        v160 = sqrt(v15 * v17) / b
                        v199 = v160 - atan(v160)
                    v204 = a * (a / R1 + v69 * v199)
                v208 = r * r / (2.0 * R1)
                v216 = v204 - (v208 if r < b else v208 + v8 * v8 / (2.0 * R2))
            value = v216 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v24) if v215 else 1.0)
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
            if a < b:
                v75 = 4.0 * E_star / v9 * v13
            else:
                v15 = a - b
                v17 = v15 * (a + b)
                v18 = sqrt(v17)
                v23 = v15 / b
                if v23 < 0.42:
                    v66 = v23 * sqrt(v23) * ((((((0.0005288491342179178 * v23 + 0.038096760299703034) * v23 + 0.4065213849117787) * v23 + 1.438682033198726) * v23 + 1.9979042349620892) * v23 + 0.9428090415820634) / (((((0.006421883194715949 * v23 + 0.15001504718401248) * v23 + 0.9450913324352289) * v23 + 2.37401087025821) * v23 + 2.569097449054519) * v23 + 1.0))
                else:
                    v26 = v18 / b
                    v66 = v26 - atan(v26)
                v75 = E_star * (4.0 * v13 / v9 + b / R2 * v12 * v66 + v17 * v18 / (3.0 * R2))
            value = v75 - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R1, R2, b, E_star, dgamma):
    v7 = (4.0) * E_star
    v9 = (3.0) * R1
    v10 = v7 / v9
    v21 = b / R2
    v70 = (3.0) * R2
    v76 = (2.0) * E_star
    v80 = (6.283185307179586) * dgamma
    v81 = v80 / E_star
    v82 = np.sqrt(v81)
    return (b, E_star, v9, v10, v21, v70, v76, v82)


def block_force_a(out, a, b, E_star, v9, v10, v21, v70, v76, v82, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, m0, m1, f0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, t0)
    np.less(a, b, m0)
    some75 = np.count_nonzero(m0)
    if some75:
        np.multiply(v10, t0, t1)
    if some75 != size:
        other75 = t2 if some75 else t1
        np.subtract(a, b, other75)
        np.add(a, b, t3)
        np.multiply(other75, t3, t3)
        np.sqrt(t3, t4)
        np.multiply(C15, t0, t5)
        np.divide(t5, v9, t5)
        np.multiply(v21, out, t6)
        np.divide(other75, b, other75)
        np.less(other75, C1, m1)
        some66 = np.count_nonzero(m1)
        if some66:
            np.minimum(other75, f0, out=t7)
            np.sqrt(t7, t8)
            np.multiply(t7, t8, t8)
            np.multiply(C2, t7, t9)
            np.add(t9, C3, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C4, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C5, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C6, t9)
            np.multiply(t9, t7, t9)
            np.add(t9, C7, t9)
            np.multiply(C8, t7, t10)
            np.add(t10, C9, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C10, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C11, t10)
            np.multiply(t10, t7, t10)
            np.add(t10, C12, t10)
            np.multiply(t10, t7, t7)
            np.add(t7, C13, t7)
            np.divide(t9, t7, t7)
            np.multiply(t8, t7, t7)
        if some66 != size:
            other66 = t8 if some66 else t7
            np.divide(t4, b, other66)
            np.arctan(other66, t9)
            np.subtract(other66, t9, other66)
            if some66:
                np.copyto(t7, other66, where=~m1)
        np.multiply(t6, t7, t7)
        np.add(t5, t7, t7)
        np.multiply(t3, t4, t4)
        np.divide(t4, v70, t4)
        np.add(t7, t4, t4)
        np.multiply(E_star, t4, other75)
        if some75:
            np.copyto(t1, other75, where=~m0)
    np.multiply(v76, a, t0)
    np.sqrt(a, out)
    np.multiply(out, v82, out)
    np.multiply(t0, out, out)
    np.subtract(t1, out, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R1, R2, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.multiply(C16, R1, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t0)
    np.multiply(a, t0, t1)
    np.less(a, b, m0)
    some75 = np.count_nonzero(m0)
    if some75:
        np.multiply(C15, E_star, t2)
        np.divide(t2, out, t2)
        np.multiply(t2, t1, t2)
    if some75 != size:
        other75 = t3 if some75 else t2
        np.subtract(a, b, other75)
        np.add(a, b, t4)
        np.multiply(other75, t4, t4)
        np.sqrt(t4, t5)
        np.multiply(C15, t1, t6)
        np.divide(t6, out, t6)
        np.divide(b, R2, t7)
        np.multiply(t7, t0, t7)
        np.divide(other75, b, other75)
        np.less(other75, C1, m1)
        some66 = np.count_nonzero(m1)
        if some66:
            np.minimum(other75, f0, out=t8)
            np.sqrt(t8, t9)
            np.multiply(t8, t9, t9)
            np.multiply(C2, t8, t10)
            np.add(t10, C3, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C4, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C5, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C6, t10)
            np.multiply(t10, t8, t10)
            np.add(t10, C7, t10)
            np.multiply(C8, t8, t11)
            np.add(t11, C9, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C10, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C11, t11)
            np.multiply(t11, t8, t11)
            np.add(t11, C12, t11)
            np.multiply(t11, t8, t8)
            np.add(t8, C13, t8)
            np.divide(t10, t8, t8)
            np.multiply(t9, t8, t8)
        if some66 != size:
            other66 = t9 if some66 else t8
            np.divide(t5, b, other66)
            np.arctan(other66, t10)
            np.subtract(other66, t10, other66)
            if some66:
                np.copyto(t8, other66, where=~m1)
        np.multiply(t7, t8, t8)
        np.add(t6, t8, t8)
        np.multiply(t4, t5, t5)
        np.multiply(C16, R2, t4)
        np.divide(t5, t4, t4)
        np.add(t8, t4, t4)
        np.multiply(E_star, t4, other75)
        if some75:
            np.copyto(t2, other75, where=~m0)
    np.multiply(C0, E_star, t1)
    np.multiply(t1, a, t1)
    np.sqrt(a, t0)
    np.multiply(C14, dgamma, out)
    np.divide(out, E_star, out)
    np.sqrt(out, out)
    np.multiply(t0, out, out)
    np.multiply(t1, out, out)
    np.subtract(t2, out, out)


def pressure(r, a, R1, R2, b, E_star, dgamma):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            if r < a:
                v7 = a if a < b or a != a else b
                v24 = nextafter(b, inf) if r == b else r
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
                    v78 = b / R2
                    v83 = []
                    for node, weight in RULE_0(v45 / 1.0):
                        v57 = node * v45
                        v67 = v32 * (exp(-v57) * (v46 - v47 * expm1(-2.0 * (v45 - v57))) / v54)
                        v71 = sqrt(v68 + v67 * v67)
                        v82 = (2.0 * v71 / R1 + 2.0 * v67 / R2 - v78 * atan2(v67, b)) * v67 / v71
                        v83.append(weight * v82)
                    v83 = fsum(v83) * v45
                    v84 = v83
                else:
                    v84 = 0.0
                v89 = (2.0 * E_star / (3.141592653589793 * R1) * sqrt((v7 - r) * (v7 + r)) if r < v7 else 0.0) + E_star / 3.141592653589793 * v84
            else:
                v89 = 0.0
            if r <= a:
                v95 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                if v95 > 0.0:
                    v98 = a - r
                    v105 = E_star * v95 / (3.141592653589793 * sqrt((v98 if v98 > 0.0 or v98 != v98 else 0.0) * (a + r)))
                else:
                    v105 = 0.0
                v107 = v105
            else:
                v107 = 0.0
            value = v89 - v107
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R1, R2, b, E_star, dgamma, control):
    if R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and R1 > 1e-30 and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
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
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
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
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
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
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
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
        ('a',): (('a',), prepare_depth_a, block_depth_a, 7, 2, (0.42,), False),
        ('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): (('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 8, 2, (0.42,), False),
    },
    ('_force', 1, 'a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 11, 2, (0.42,), False),
        ('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'): (('a', 'R1', 'R2', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 12, 2, (0.42,), False),
    },
}
