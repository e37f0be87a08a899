"""Programs of axicontact.adhesive.rounded_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import rounded_punch as bodies

C0 = np.array(0.42)
C1 = np.array(0.0005288491342179178)
C2 = np.array(0.038096760299703034)
C3 = np.array(0.4065213849117787)
C4 = np.array(1.438682033198726)
C5 = np.array(1.9979042349620892)
C6 = np.array(0.9428090415820634)
C7 = np.array(0.006421883194715949)
C8 = np.array(0.15001504718401248)
C9 = np.array(0.9450913324352289)
C10 = np.array(2.37401087025821)
C11 = np.array(2.569097449054519)
C12 = np.array(1.0)
C13 = np.array(6.283185307179586)
C14 = np.array(2.0)
C15 = np.array(3.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R, b, E_star, dgamma):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            v7 = a - b
            v8 = v7 / b
            if v8 < 0.42:
                v54 = v8 * sqrt(v8) * ((((((0.0005288491342179178 * v8 + 0.038096760299703034) * v8 + 0.4065213849117787) * v8 + 1.438682033198726) * v8 + 1.9979042349620892) * v8 + 0.9428090415820634) / (((((0.006421883194715949 * v8 + 0.15001504718401248) * v8 + 0.9450913324352289) * v8 + 2.37401087025821) * v8 + 2.569097449054519) * v8 + 1.0))
            else:
                v14 = sqrt(v7 * (a + b)) / b
                v54 = v14 - atan(v14)
            value = b / R * a * v54 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, b, E_star, dgamma):
    v5 = b / R
    v58 = (6.283185307179586) * dgamma
    v59 = v58 / E_star
    v60 = np.sqrt(v59)
    return (b, v5, v60)


def block_depth_a(out, a, b, v5, v60, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.multiply(v5, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, b, t0)
    np.divide(t0, b, t1)
    np.less(t1, C0, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(t1, f0, out=t2)
        np.sqrt(t2, t3)
        np.multiply(t2, t3, t3)
        np.multiply(C1, t2, t4)
        np.add(t4, C2, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C3, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C4, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C5, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C6, t4)
        np.multiply(C7, t2, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t2, t2)
        np.add(t2, C12, t2)
        np.divide(t4, t2, t2)
        np.multiply(t3, t2, t2)
    if some54 != size:
        other54 = t3 if some54 else t2
        np.add(a, b, other54)
        np.multiply(t0, other54, other54)
        np.sqrt(other54, other54)
        np.divide(other54, b, other54)
        np.arctan(other54, t4)
        np.subtract(other54, t4, other54)
        if some54:
            np.copyto(t2, other54, where=~m0)
    np.multiply(out, t2, t2)
    np.sqrt(a, out)
    np.multiply(out, v60, out)
    np.subtract(t2, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.divide(b, R, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)
    np.subtract(a, b, t0)
    np.divide(t0, b, t1)
    np.less(t1, C0, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(t1, f0, out=t2)
        np.sqrt(t2, t3)
        np.multiply(t2, t3, t3)
        np.multiply(C1, t2, t4)
        np.add(t4, C2, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C3, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C4, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C5, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C6, t4)
        np.multiply(C7, t2, t5)
        np.add(t5, C8, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C9, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t2, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t2, t2)
        np.add(t2, C12, t2)
        np.divide(t4, t2, t2)
        np.multiply(t3, t2, t2)
    if some54 != size:
        other54 = t3 if some54 else t2
        np.add(a, b, other54)
        np.multiply(t0, other54, other54)
        np.sqrt(other54, other54)
        np.divide(other54, b, other54)
        np.arctan(other54, t4)
        np.subtract(other54, t4, other54)
        if some54:
            np.copyto(t2, other54, where=~m0)
    np.multiply(out, t2, t2)
    np.sqrt(a, out)
    np.multiply(C13, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.subtract(t2, t1, out)


def displacement(r, a, R, b, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            v18 = r - a
            v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (r + a))
            v132 = r > a
            if a >= b:
                v6 = r - b
                v13 = a - b
                v15 = a + b
                v64 = b / R
                if v132:
                    if a > b:
                        v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (r + b))
                        v12 = b / r
                        v23 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v15) / v22
                        v25 = asinh(v23 / v12)
                        v30 = 0.0 - expm1(-2.0 * v25)
                        v33 = v30 if v30 > 0.0 else inf
                        v50 = b * b
                        v54 = v12 * v12
                        v73 = []
                        for node, weight in RULE_0(v25 / 1.0):
                            v35 = node * v25
                            v44 = v23 * (exp(-v35) * (0.0 - expm1(-2.0 * (v25 - v35))) / v33)
                            v45 = v44 * v44
                            v47 = sqrt(1.0 + v45)
                            v49 = v11 * v44 / v47
                            v53 = sqrt(v50 + v49 * v49)
                            v72 = (2.0 * v49 / R - v64 * atan2(v49, b)) * v49 / v53 * atan2(v53, v11 / v47) * (sqrt(v54 + v45) / (v47 * v47 * v47))
                            v73.append(weight * v72)
                        v73 = fsum(v73) * v25
                        v75 = v11 * v73
                    else:
                        v75 = 0.0
                    v133 = 0.6366197723675814 * v75
                else:
                    v79 = v13 / b
                    if v79 < 0.42:
                        v123 = v79 * sqrt(v79) * ((((((0.0005288491342179178 * v79 + 0.038096760299703034) * v79 + 0.4065213849117787) * v79 + 1.438682033198726) * v79 + 1.9979042349620892) * v79 + 0.9428090415820634) / (((((0.006421883194715949 * v79 + 0.15001504718401248) * v79 + 0.9450913324352289) * v79 + 2.37401087025821) * v79 + 2.569097449054519) * v79 + 1.0))
                    else:
                        v84 = sqrt(v13 * v15) / b
                        v123 = v84 - atan(v84)
                    v133 = v64 * a * v123 - (0.0 if r < b else v6 * v6 / (2.0 * R))
                v135 = v133
            else:
                v135 = nan
            value = v135 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v22) if v132 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, b, E_star, dgamma):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            v5 = a - b
            v7 = v5 * (a + b)
            v8 = sqrt(v7)
            v13 = v5 / b
            if v13 < 0.42:
                v56 = v13 * sqrt(v13) * ((((((0.0005288491342179178 * v13 + 0.038096760299703034) * v13 + 0.4065213849117787) * v13 + 1.438682033198726) * v13 + 1.9979042349620892) * v13 + 0.9428090415820634) / (((((0.006421883194715949 * v13 + 0.15001504718401248) * v13 + 0.9450913324352289) * v13 + 2.37401087025821) * v13 + 2.569097449054519) * v13 + 1.0))
            else:
                v16 = v8 / b
                v56 = v16 - atan(v16)
            value = E_star / R * (b * (a * a) * v56 + v7 * v8 / 3.0) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, b, E_star, dgamma):
    v9 = E_star / R
    v63 = (2.0) * E_star
    v67 = (6.283185307179586) * dgamma
    v68 = v67 / E_star
    v69 = np.sqrt(v68)
    return (b, v9, v63, v69)


def block_force_a(out, a, b, v9, v63, v69, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t1)
    np.square(a, t2)
    np.multiply(b, t2, t2)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some56 = np.count_nonzero(m0)
    if some56:
        np.minimum(out, f0, out=t3)
        np.sqrt(t3, t4)
        np.multiply(t3, t4, t4)
        np.multiply(C1, t3, t5)
        np.add(t5, C2, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C3, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C6, t5)
        np.multiply(C7, t3, t6)
        np.add(t6, C8, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C9, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C10, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t3, t3)
        np.add(t3, C12, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
    if some56 != size:
        other56 = t4 if some56 else t3
        np.divide(t1, b, other56)
        np.arctan(other56, t5)
        np.subtract(other56, t5, other56)
        if some56:
            np.copyto(t3, other56, where=~m0)
    np.multiply(t2, t3, t3)
    np.multiply(t0, t1, t1)
    np.divide(t1, C15, t1)
    np.add(t3, t1, t1)
    np.multiply(v9, t1, t1)
    np.multiply(v63, a, t3)
    np.sqrt(a, t0)
    np.multiply(t0, v69, t0)
    np.multiply(t3, t0, t0)
    np.subtract(t1, t0, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, b, E_star, dgamma, t0, t1, t2, t3, t4, t5, t6, t7, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t1)
    np.divide(E_star, R, t2)
    np.square(a, t3)
    np.multiply(b, t3, t3)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some56 = np.count_nonzero(m0)
    if some56:
        np.minimum(out, f0, out=t4)
        np.sqrt(t4, t5)
        np.multiply(t4, t5, t5)
        np.multiply(C1, t4, t6)
        np.add(t6, C2, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C3, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C4, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C5, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C6, t6)
        np.multiply(C7, t4, t7)
        np.add(t7, C8, t7)
        np.multiply(t7, t4, t7)
        np.add(t7, C9, t7)
        np.multiply(t7, t4, t7)
        np.add(t7, C10, t7)
        np.multiply(t7, t4, t7)
        np.add(t7, C11, t7)
        np.multiply(t7, t4, t4)
        np.add(t4, C12, t4)
        np.divide(t6, t4, t4)
        np.multiply(t5, t4, t4)
    if some56 != size:
        other56 = t5 if some56 else t4
        np.divide(t1, b, other56)
        np.arctan(other56, t6)
        np.subtract(other56, t6, other56)
        if some56:
            np.copyto(t4, other56, where=~m0)
    np.multiply(t3, t4, t4)
    np.multiply(t0, t1, t1)
    np.divide(t1, C15, t1)
    np.add(t4, t1, t1)
    np.multiply(t2, t1, t1)
    np.multiply(C14, E_star, t2)
    np.multiply(t2, a, t2)
    np.sqrt(a, t4)
    np.multiply(C13, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t4, t0, t0)
    np.multiply(t2, t0, t0)
    np.subtract(t1, t0, out)


def pressure(r, a, R, b, E_star, dgamma):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            if a >= b:
                if r < a:
                    v9 = nextafter(b, inf) if r == b else r
                    if a > (v9 if v9 > b or v9 != v9 else b):
                        v10 = v9 < b
                        v14 = a - b
                        v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (a + b))
                        if v10:
                            v24 = v18
                        else:
                            v19 = a - v9
                            v24 = sqrt((v19 if v19 > 0.0 or v19 != v19 else 0.0) * (a + v9))
                        v31 = asinh(v24 / sqrt(abs(v9 - b) * (v9 + b)))
                        v33 = 2.0 * (0.0 if v10 else 1.0)
                        v34 = 1.0 - v33
                        v39 = v33 - v34 * expm1(-2.0 * v31)
                        v41 = v39 if v39 > 0.0 else inf
                        v55 = b * b
                        v62 = b / R
                        v67 = []
                        for node, weight in RULE_0(v31 / 1.0):
                            v44 = node * v31
                            v54 = v18 * (exp(-v44) * (v33 - v34 * expm1(-2.0 * (v31 - v44))) / v41)
                            v66 = (2.0 * v54 / R - v62 * atan2(v54, b)) * v54 / sqrt(v55 + v54 * v54)
                            v67.append(weight * v66)
                        v67 = fsum(v67) * v31
                        v68 = v67
                    else:
                        v68 = 0.0
                    v73 = E_star / 3.141592653589793 * v68
                else:
                    v73 = 0.0
                v76 = v73
            else:
                v76 = nan
            if r <= a:
                v82 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                if v82 > 0.0:
                    v85 = a - r
                    v92 = E_star * v82 / (3.141592653589793 * sqrt((v85 if v85 > 0.0 or v85 != v85 else 0.0) * (a + r)))
                else:
                    v92 = 0.0
                v94 = v92
            else:
                v94 = 0.0
            value = v76 - v94
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R, b, E_star, dgamma, control):
    if R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and R > 1e-30 and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(R, b, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, b, E_star, dgamma):
    if d.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, b, E_star, dgamma):
    if F.__class__ is R.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, R, b, E_star):
    if F.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 6, 1, (0.42,), False),
        ('a', 'R', 'b', 'E_star', 'dgamma'): (('a', 'R', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 6, 1, (0.42,), False),
    },
    ('_force', 1, 'a', 'R', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 7, 1, (0.42,), False),
        ('a', 'R', 'b', 'E_star', 'dgamma'): (('a', 'R', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 8, 1, (0.42,), False),
    },
}
