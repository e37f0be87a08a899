"""Programs of axicontact.normal.rounded_curved_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import rounded_curved_punch as bodies

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
C14 = np.array(4.0)
C15 = np.array(3.0)
C16 = np.array(9.42477796076938)
C17 = np.array(3.141592653589793)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R1, R2, b):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            if a < b:
                return a * a / R1
            v9 = a - b
            v10 = v9 / b
            if v10 < 0.42:
                v56 = v10 * sqrt(v10) * ((((((0.0005288491342179178 * v10 + 0.038096760299703034) * v10 + 0.4065213849117787) * v10 + 1.438682033198726) * v10 + 1.9979042349620892) * v10 + 0.9428090415820634) / (((((0.006421883194715949 * v10 + 0.15001504718401248) * v10 + 0.9450913324352289) * v10 + 2.37401087025821) * v10 + 2.569097449054519) * v10 + 1.0))
            else:
                v16 = sqrt(v9 * (a + b)) / b
                v56 = v16 - atan(v16)
            value = a * (a / R1 + b / R2 * v56)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R1, R2, b):
    v8 = b / R2
    return (R1, b, v8)


def block_depth_a(out, a, R1, b, v8, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some61 = np.count_nonzero(m0)
    if some61:
        np.square(a, out)
        np.divide(out, R1, out)
    if some61 != size:
        other61 = t0 if some61 else out
        np.divide(a, R1, other61)
        np.subtract(a, b, t1)
        np.divide(t1, b, t2)
        np.less(t2, C1, m1)
        some56 = np.count_nonzero(m1)
        if some56:
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
        if some56 != size:
            other56 = t4 if some56 else t3
            np.add(a, b, other56)
            np.multiply(t1, other56, other56)
            np.sqrt(other56, other56)
            np.divide(other56, b, other56)
            np.arctan(other56, t5)
            np.subtract(other56, t5, other56)
            if some56:
                np.copyto(t3, other56, where=~m1)
        np.multiply(v8, t3, t3)
        np.add(other61, t3, t3)
        np.multiply(a, t3, other61)
        if some61:
            np.copyto(out, other61, where=~m0)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R1, R2, b, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some61 = np.count_nonzero(m0)
    if some61:
        np.square(a, out)
        np.divide(out, R1, out)
    if some61 != size:
        other61 = t0 if some61 else out
        np.divide(a, R1, other61)
        np.divide(b, R2, t1)
        np.subtract(a, b, t2)
        np.divide(t2, b, t3)
        np.less(t3, C1, m1)
        some56 = np.count_nonzero(m1)
        if some56:
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
        if some56 != size:
            other56 = t5 if some56 else t4
            np.add(a, b, other56)
            np.multiply(t2, other56, other56)
            np.sqrt(other56, other56)
            np.divide(other56, b, other56)
            np.arctan(other56, t6)
            np.subtract(other56, t6, other56)
            if some56:
                np.copyto(t4, other56, where=~m1)
        np.multiply(t1, t4, t4)
        np.add(other61, t4, t4)
        np.multiply(a, t4, other61)
        if some61:
            np.copyto(out, other61, where=~m0)


def depth_from_force(F, R1, R2, b, E_star):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R1, R2, b):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            v6 = r - b
            v13 = a - b
            v15 = a + b
            v67 = b / R2
            if r > a:
                v5 = a if a < b or a != a else b
                if a > b:
                    v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (r + b))
                    v12 = b / r
                    v18 = r - a
                    v23 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v15) / sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (r + a))
                    v25 = asinh(v23 / v12)
                    v30 = 0.0 - expm1(-2.0 * v25)
                    v33 = v30 if v30 > 0.0 else inf
                    v50 = b * b
                    v54 = v12 * v12
                    v76 = []
                    for node, weight in RULE_0(v25 / 1.0):
                        v35 = node * v25
                        v44 = v23 * (exp(-v35) * (0.0 - expm1(-2.0 * (v25 - v35))) / v33)
                        v45 = v44 * v44
                        v47 = sqrt(1.0 + v45)
                        v49 = v11 * v44 / v47
                        v53 = sqrt(v50 + v49 * v49)
                        v75 = (2.0 * v53 / R1 + 2.0 * v49 / R2 - v67 * atan2(v49, b)) * v49 / v53 * atan2(v53, v11 / v47) * (sqrt(v54 + v45) / (v47 * v47 * v47))
                        v76.append(weight * v75)
                    v76 = fsum(v76) * v25
                    v78 = v11 * v76
                else:
                    v78 = 0.0
                v89 = v5 / (r + sqrt((r - v5) * (r + v5)))
                v91 = v89 * v89
                value = 2.0 * (v5 * v5) / (3.141592653589793 * R1) * (v5 / r * (0.6666666666666666 + v91 * (((((((((-0.7327347664453868 * v91 + -32.15553480435792) * v91 + -332.23363563146734) * v91 + -1070.7082873491413) * v91 + -85.27694715374247) * v91 + 5044.821368830373) * v91 + 8082.413158212496) * v91 + 3759.725330928701) * v91 + 0.26666666666720995) / ((((((((0.21387262524856868 * v91 + 32.12935731379798) * v91 + 746.8124983579742) * v91 + 6202.125133759036) * v91 + 23553.080984642995) * v91 + 44404.005348491315) * v91 + 40380.01430284195) * v91 + 14099.684276696918) * v91 + 1.0)))) + 0.6366197723675814 * v78
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b):
                    return value
                return None
            if a < b:
                v202 = a * a / R1
            else:
                v153 = v13 / b
                if v153 < 0.42:
                    v197 = v153 * sqrt(v153) * ((((((0.0005288491342179178 * v153 + 0.038096760299703034) * v153 + 0.4065213849117787) * v153 + 1.438682033198726) * v153 + 1.9979042349620892) * v153 + 0.9428090415820634) / (((((0.006421883194715949 * v153 + 0.15001504718401248) * v153 + 0.9450913324352289) * v153 + 2.37401087025821) * v153 + 2.569097449054519) * v153 + 1.0))
                else:
                    v158 = sqrt(v13 * v15) / b
                    v197 = v158 - atan(v158)
                v202 = a * (a / R1 + v67 * v197)
            v206 = r * r / (2.0 * R1)
            value = v202 - (v206 if r < b else v206 + v6 * v6 / (2.0 * R2))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, R1, R2, b, E_star):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v9 = b / R2
            v10 = a - b
            v14 = a + b
            if a < b:
                v62 = a * a / R1
            else:
                v11 = v10 / b
                if v11 < 0.42:
                    v57 = v11 * sqrt(v11) * ((((((0.0005288491342179178 * v11 + 0.038096760299703034) * v11 + 0.4065213849117787) * v11 + 1.438682033198726) * v11 + 1.9979042349620892) * v11 + 0.9428090415820634) / (((((0.006421883194715949 * v11 + 0.15001504718401248) * v11 + 0.9450913324352289) * v11 + 2.37401087025821) * v11 + 2.569097449054519) * v11 + 1.0))
                else:
                    v17 = sqrt(v10 * v14) / b
                    v57 = v17 - atan(v17)
                v62 = a * (a / R1 + v9 * v57)
            v63 = a if a < b or a != a else b
            v65 = asinh(v63 / v63)
            v70 = 0.0 - expm1(-2.0 * v65)
            v73 = v70 if v70 > 0.0 else inf
            v129 = v63 * v63
            v134 = []
            for node, weight in RULE_0(v65 / 1.0):
                v74 = node * v65
                v83 = v63 * (exp(-v74) * (0.0 - expm1(-2.0 * (v65 - v74))) / v73)
                if v83 < b:
                    v126 = v83 * v83 / R1
                else:
                    v87 = v83 - b
                    v88 = v87 / b
                    if v88 < 0.42:
                        v121 = v88 * sqrt(v88) * ((((((0.0005288491342179178 * v88 + 0.038096760299703034) * v88 + 0.4065213849117787) * v88 + 1.438682033198726) * v88 + 1.9979042349620892) * v88 + 0.9428090415820634) / (((((0.006421883194715949 * v88 + 0.15001504718401248) * v88 + 0.9450913324352289) * v88 + 2.37401087025821) * v88 + 2.569097449054519) * v88 + 1.0))
                    else:
                        v93 = sqrt(v87 * (v83 + b)) / b
                        v121 = v93 - atan(v93)
                    v126 = v83 * (v83 / R1 + v9 * v121)
                v127 = v62 - v126
                v133 = v127 * v127 * sqrt(v129 + v83 * v83)
                v134.append(weight * v133)
            v134 = fsum(v134) * v65
            if a > b:
                v138 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * v14)
                v140 = asinh(v138 / b)
                v143 = 0.0 - expm1(-2.0 * v140)
                v145 = v143 if v143 > 0.0 else inf
                v157 = b * b
                v215 = []
                for node, weight in RULE_0(v140 / 1.0):
                    v147 = node * v140
                    v156 = v138 * (exp(-v147) * (0.0 - expm1(-2.0 * (v140 - v147))) / v145)
                    v160 = sqrt(v157 + v156 * v156)
                    v162 = v156 / b
                    if v162 < 1.0:
                        v165 = v162 * v162
                        v208 = v162 * v165 * (((((((2.229767813968649e-06 * v165 + 0.0021043873129700233) * v165 + 0.04325113828415611) * v165 + 0.2725778671008127) * v165 + 0.7123414383945195) * v165 + 0.8116412201960678) * v165 + 0.3333333333333333) / ((((((0.002445452808893491 * v165 + 0.06453295925870227) * v165 + 0.5368820963772863) * v165 + 1.9680296155712274) * v165 + 3.5294070829658954) * v165 + 3.034923660588189) * v165 + 1.0))
                    else:
                        v208 = v162 - atan(v162)
                    v212 = v62 - v160 * (v160 / R1 + v9 * v208)
                    v214 = v212 * v212 * v156
                    v215.append(weight * v214)
                v215 = fsum(v215) * v140
                v216 = v215
            else:
                v216 = 0.0
            value = E_star * (v134 + v216)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R1, R2, b, E_star):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = 3.0 * R1
            v11 = a * a
            v12 = a * v11
            if a < b:
                return 4.0 * E_star / v8 * v12
            v14 = a - b
            v16 = v14 * (a + b)
            v17 = sqrt(v16)
            v22 = v14 / b
            if v22 < 0.42:
                v65 = v22 * sqrt(v22) * ((((((0.0005288491342179178 * v22 + 0.038096760299703034) * v22 + 0.4065213849117787) * v22 + 1.438682033198726) * v22 + 1.9979042349620892) * v22 + 0.9428090415820634) / (((((0.006421883194715949 * v22 + 0.15001504718401248) * v22 + 0.9450913324352289) * v22 + 2.37401087025821) * v22 + 2.569097449054519) * v22 + 1.0))
            else:
                v25 = v17 / b
                v65 = v25 - atan(v25)
            value = E_star * (4.0 * v12 / v8 + b / R2 * v11 * v65 + v16 * v17 / (3.0 * R2))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R1, R2, b, E_star):
    v6 = (4.0) * E_star
    v8 = (3.0) * R1
    v9 = v6 / v8
    v20 = b / R2
    v69 = (3.0) * R2
    return (b, E_star, v8, v9, v20, v69)


def block_force_a(out, a, b, E_star, v8, v9, v20, v69, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, m0, m1, f0):
    size = out.size
    np.square(a, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, t0, t1)
    np.less(a, b, m0)
    some74 = np.count_nonzero(m0)
    if some74:
        np.multiply(v9, t1, out)
    if some74 != size:
        other74 = t2 if some74 else out
        np.subtract(a, b, other74)
        np.add(a, b, t3)
        np.multiply(other74, t3, t3)
        np.sqrt(t3, t4)
        np.multiply(C14, t1, t5)
        np.divide(t5, v8, t5)
        np.multiply(v20, t0, t6)
        np.divide(other74, b, other74)
        np.less(other74, C1, m1)
        some65 = np.count_nonzero(m1)
        if some65:
            np.minimum(other74, f0, out=t7)
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
        if some65 != size:
            other65 = t8 if some65 else t7
            np.divide(t4, b, other65)
            np.arctan(other65, t9)
            np.subtract(other65, t9, other65)
            if some65:
                np.copyto(t7, other65, where=~m1)
        np.multiply(t6, t7, t7)
        np.add(t5, t7, t7)
        np.multiply(t3, t4, t4)
        np.divide(t4, v69, t4)
        np.add(t7, t4, t4)
        np.multiply(E_star, t4, other74)
        if some74:
            np.copyto(out, other74, where=~m0)


def prepare_force_all():
    return ()


def block_force_all(out, a, R1, R2, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, m0, m1, f0):
    size = out.size
    np.multiply(C15, R1, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t1)
    np.multiply(a, t1, t2)
    np.less(a, b, m0)
    some74 = np.count_nonzero(m0)
    if some74:
        np.multiply(C14, E_star, out)
        np.divide(out, t0, out)
        np.multiply(out, t2, out)
    if some74 != size:
        other74 = t3 if some74 else out
        np.subtract(a, b, other74)
        np.add(a, b, t4)
        np.multiply(other74, t4, t4)
        np.sqrt(t4, t5)
        np.multiply(C14, t2, t6)
        np.divide(t6, t0, t6)
        np.divide(b, R2, t7)
        np.multiply(t7, t1, t7)
        np.divide(other74, b, other74)
        np.less(other74, C1, m1)
        some65 = np.count_nonzero(m1)
        if some65:
            np.minimum(other74, f0, out=t8)
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
        if some65 != size:
            other65 = t9 if some65 else t8
            np.divide(t5, b, other65)
            np.arctan(other65, t10)
            np.subtract(other65, t10, other65)
            if some65:
                np.copyto(t8, other65, where=~m1)
        np.multiply(t7, t8, t8)
        np.add(t6, t8, t8)
        np.multiply(t4, t5, t5)
        np.multiply(C15, R2, t4)
        np.divide(t5, t4, t4)
        np.add(t8, t4, t4)
        np.multiply(E_star, t4, other74)
        if some74:
            np.copyto(out, other74, where=~m0)


def force_from_depth(d, R1, R2, b, E_star):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, R1, R2, b, E_star):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = a if a < b or a != a else b
            v7 = r if r < v6 or r != r else v6
            if v7 > 0.0:
                v8 = v6 - v7
                v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (v6 + v7))
                v15 = asinh(v13 / v7)
                v20 = 0.0 - expm1(-2.0 * v15)
                v23 = v20 if v20 > 0.0 else inf
                v24 = v7 * v7
                v45 = []
                for node, weight in RULE_0(v15 / 1.0):
                    v26 = node * v15
                    v35 = v13 * (exp(-v26) * (0.0 - expm1(-2.0 * (v15 - v26))) / v23)
                    v38 = sqrt(v24 + v35 * v35)
                    v44 = 2.0 * v38 / R1 * (v35 / (v38 + v35))
                    v45.append(weight * v44)
                v45 = fsum(v45) * v15
                v47 = v24 * v45
            else:
                v47 = 0.0
            v50 = nextafter(b, inf) if r == b else r
            v115 = b / R2
            if a > (v50 if v50 > b or v50 != v50 else b):
                v51 = v50 < b
                v52 = 0.0 if v51 else 1.0
                v53 = a - b
                v57 = sqrt((v53 if v53 > 0.0 or v53 != v53 else 0.0) * (a + b))
                v58 = a - v50
                v62 = sqrt((v58 if v58 > 0.0 or v58 != v58 else 0.0) * (a + v50))
                v70 = asinh((v57 if v51 else v62) / sqrt(abs(v50 - b) * (v50 + b)))
                v71 = 2.0 * v52
                v72 = 1.0 - v71
                v74 = expm1(-2.0 * v70)
                v76 = v71 - v72 * v74
                v78 = v76 if v76 > 0.0 else inf
                v80 = 2.0 * (1.0 - v52)
                v81 = 1.0 - v80
                v83 = v80 - v81 * v74
                v85 = v83 if v83 > 0.0 else inf
                v105 = b * b
                v123 = []
                for node, weight in RULE_0(v70 / 1.0):
                    v89 = node * v70
                    v91 = exp(-v89)
                    v94 = expm1(-2.0 * (v70 - v89))
                    v99 = v57 * (v91 * (v71 - v72 * v94) / v78)
                    v104 = v62 * (v91 * (v80 - v81 * v94) / v85)
                    v108 = sqrt(v105 + v99 * v99)
                    v122 = (2.0 * v108 / R1 + 2.0 * v99 / R2 - v115 * atan2(v99, b)) * (v99 / v108) * (v104 / (v108 + v104))
                    v123.append(weight * v122)
                v123 = fsum(v123) * v70
                v125 = v50 * v50 * v123
            else:
                v125 = 0.0
            v126 = r if r < a or r != r else a
            v130 = 3.0 * R1
            v132 = v126 * v126
            v133 = v126 * v132
            if v126 < b:
                v193 = 4.0 * E_star / v130 * v133
            else:
                v135 = v126 - b
                v137 = v135 * (v126 + b)
                v138 = sqrt(v137)
                v142 = v135 / b
                if v142 < 0.42:
                    v184 = v142 * sqrt(v142) * ((((((0.0005288491342179178 * v142 + 0.038096760299703034) * v142 + 0.4065213849117787) * v142 + 1.438682033198726) * v142 + 1.9979042349620892) * v142 + 0.9428090415820634) / (((((0.006421883194715949 * v142 + 0.15001504718401248) * v142 + 0.9450913324352289) * v142 + 2.37401087025821) * v142 + 2.569097449054519) * v142 + 1.0))
                else:
                    v145 = v138 / b
                    v184 = v145 - atan(v145)
                v193 = E_star * (4.0 * v133 / v130 + v115 * v132 * v184 + v137 * v138 / (3.0 * R2))
            value = v193 + 2.0 * E_star * (v47 + v125)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, R1, R2, b, E_star):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if a < b:
                return 4.0 * E_star / (9.42477796076938 * R1) * a
            v11 = a - b
            v13 = v11 * (a + b)
            v14 = sqrt(v13)
            v20 = v11 / b
            if v20 < 0.42:
                v63 = v20 * sqrt(v20) * ((((((0.0005288491342179178 * v20 + 0.038096760299703034) * v20 + 0.4065213849117787) * v20 + 1.438682033198726) * v20 + 1.9979042349620892) * v20 + 0.9428090415820634) / (((((0.006421883194715949 * v20 + 0.15001504718401248) * v20 + 0.9450913324352289) * v20 + 2.37401087025821) * v20 + 2.569097449054519) * v20 + 1.0))
            else:
                v23 = v14 / b
                v63 = v23 - atan(v23)
            value = E_star / 3.141592653589793 * (4.0 * a / (3.0 * R1) + b / R2 * v63 + v13 * v14 / (3.0 * (a * a) * R2))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R1, R2, b, E_star):
    v6 = (4.0) * E_star
    v8 = (9.42477796076938) * R1
    v9 = v6 / v8
    v17 = (3.0) * R1
    v19 = b / R2
    v74 = E_star / (3.141592653589793)
    return (R2, b, v9, v17, v19, v74)


def block_mean_pressure_a(out, a, R2, b, v9, v17, v19, v74, t0, t1, t2, t3, t4, t5, t6, t7, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some77 = np.count_nonzero(m0)
    if some77:
        np.multiply(v9, a, out)
    if some77 != size:
        other77 = t0 if some77 else out
        np.subtract(a, b, other77)
        np.add(a, b, t1)
        np.multiply(other77, t1, t1)
        np.sqrt(t1, t2)
        np.multiply(C14, a, t3)
        np.divide(t3, v17, t3)
        np.divide(other77, b, other77)
        np.less(other77, C1, m1)
        some63 = np.count_nonzero(m1)
        if some63:
            np.minimum(other77, f0, out=t4)
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
        if some63 != size:
            other63 = t5 if some63 else t4
            np.divide(t2, b, other63)
            np.arctan(other63, t6)
            np.subtract(other63, t6, other63)
            if some63:
                np.copyto(t4, other63, where=~m1)
        np.multiply(v19, t4, t4)
        np.add(t3, t4, t4)
        np.multiply(t1, t2, t2)
        np.square(a, t1)
        np.multiply(C15, t1, t1)
        np.multiply(t1, R2, t1)
        np.divide(t2, t1, t1)
        np.add(t4, t1, t1)
        np.multiply(v74, t1, other77)
        if some77:
            np.copyto(out, other77, where=~m0)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R1, R2, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1, f0):
    size = out.size
    np.less(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some77 = np.count_nonzero(m0)
    if some77:
        np.multiply(C14, E_star, out)
        np.multiply(C16, R1, t0)
        np.divide(out, t0, t0)
        np.multiply(t0, a, out)
    if some77 != size:
        other77 = t0 if some77 else out
        np.subtract(a, b, other77)
        np.add(a, b, t1)
        np.multiply(other77, t1, t1)
        np.sqrt(t1, t2)
        np.multiply(C14, a, t3)
        np.multiply(C15, R1, t4)
        np.divide(t3, t4, t4)
        np.divide(b, R2, t3)
        np.divide(other77, b, other77)
        np.less(other77, C1, m1)
        some63 = np.count_nonzero(m1)
        if some63:
            np.minimum(other77, f0, out=t5)
            np.sqrt(t5, t6)
            np.multiply(t5, t6, t6)
            np.multiply(C2, t5, t7)
            np.add(t7, C3, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C4, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C5, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C6, t7)
            np.multiply(t7, t5, t7)
            np.add(t7, C7, t7)
            np.multiply(C8, t5, t8)
            np.add(t8, C9, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C10, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C11, t8)
            np.multiply(t8, t5, t8)
            np.add(t8, C12, t8)
            np.multiply(t8, t5, t5)
            np.add(t5, C13, t5)
            np.divide(t7, t5, t5)
            np.multiply(t6, t5, t5)
        if some63 != size:
            other63 = t6 if some63 else t5
            np.divide(t2, b, other63)
            np.arctan(other63, t7)
            np.subtract(other63, t7, other63)
            if some63:
                np.copyto(t5, other63, where=~m1)
        np.multiply(t3, t5, t5)
        np.add(t4, t5, t5)
        np.multiply(t1, t2, t2)
        np.square(a, t1)
        np.multiply(C15, t1, t1)
        np.multiply(t1, R2, t1)
        np.divide(t2, t1, t1)
        np.add(t5, t1, t1)
        np.divide(E_star, C17, t5)
        np.multiply(t5, t1, other77)
        if some77:
            np.copyto(out, other77, where=~m0)


def pressure(r, a, R1, R2, b, E_star):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v6 = a if a < b or a != a else b
                v23 = nextafter(b, inf) if r == b else r
                if a > (v23 if v23 > b or v23 != v23 else b):
                    v24 = v23 < b
                    v27 = a - b
                    v31 = sqrt((v27 if v27 > 0.0 or v27 != v27 else 0.0) * (a + b))
                    if v24:
                        v37 = v31
                    else:
                        v32 = a - v23
                        v37 = sqrt((v32 if v32 > 0.0 or v32 != v32 else 0.0) * (a + v23))
                    v44 = asinh(v37 / sqrt(abs(v23 - b) * (v23 + b)))
                    v45 = 2.0 * (0.0 if v24 else 1.0)
                    v46 = 1.0 - v45
                    v51 = v45 - v46 * expm1(-2.0 * v44)
                    v53 = v51 if v51 > 0.0 else inf
                    v67 = b * b
                    v77 = b / R2
                    v82 = []
                    for node, weight in RULE_0(v44 / 1.0):
                        v56 = node * v44
                        v66 = v31 * (exp(-v56) * (v45 - v46 * expm1(-2.0 * (v44 - v56))) / v53)
                        v70 = sqrt(v67 + v66 * v66)
                        v81 = (2.0 * v70 / R1 + 2.0 * v66 / R2 - v77 * atan2(v66, b)) * v66 / v70
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v44
                    v83 = v82
                else:
                    v83 = 0.0
                value = (2.0 * E_star / (3.141592653589793 * R1) * sqrt((v6 - r) * (v6 + r)) if r < v6 else 0.0) + E_star / 3.141592653589793 * v83
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, R1, R2, b):
    if r.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            v8 = r * r / (2.0 * R1)
            if r < b:
                return v8
            v9 = r - b
            return v8 + v9 * v9 / (2.0 * R2)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R1, R2, b):
    v7 = (2.0) * R1
    v11 = (2.0) * R2
    return (b, v7, v11)


def block_profile_r(out, r, b, v7, v11, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.square(r, t0)
    np.divide(t0, v7, t0)
    some14 = np.count_nonzero(m0)
    if some14:
        np.copyto(out, t0)
    if some14 != size:
        other14 = t1 if some14 else out
        np.subtract(r, b, other14)
        np.square(other14, other14)
        np.divide(other14, v11, other14)
        np.add(t0, other14, other14)
        if some14:
            np.copyto(out, other14, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R1, R2, b, t0, t1, t2, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.square(r, t0)
    np.multiply(C0, R1, t1)
    np.divide(t0, t1, t1)
    some14 = np.count_nonzero(m0)
    if some14:
        np.copyto(out, t1)
    if some14 != size:
        other14 = t0 if some14 else out
        np.subtract(r, b, other14)
        np.square(other14, other14)
        np.multiply(C0, R2, t2)
        np.divide(other14, t2, t2)
        np.add(t1, t2, other14)
        if some14:
            np.copyto(out, other14, where=~m0)


def radius_from_depth(d, R1, R2, b):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R1, R2, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R1, R2, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R1, R2, b, E_star):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, R1, R2, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R1, R2, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, R1=1.0, R2=1.0, b=1.0):
    if a.__class__ is E_star.__class__ is R1.__class__ is R2.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30):
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
    ('_depth', 1, 'a', 'R1', 'R2', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 7, 2, (0.42,), False),
        ('a', 'R1', 'R2', 'b'): (('a', 'R1', 'R2', 'b'), prepare_depth_all, block_depth_all, 8, 2, (0.42,), False),
    },
    ('_force', 1, 'a', 'R1', 'R2', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 11, 2, (0.42,), False),
        ('a', 'R1', 'R2', 'b', 'E_star'): (('a', 'R1', 'R2', 'b', 'E_star'), prepare_force_all, block_force_all, 12, 2, (0.42,), False),
    },
    ('_mean_pressure', 1, 'a', 'R1', 'R2', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 8, 2, (0.42,), False),
        ('a', 'R1', 'R2', 'b', 'E_star'): (('a', 'R1', 'R2', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 9, 2, (0.42,), False),
    },
    ('_profile', 1, 'r', 'R1', 'R2', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 2, 1, (), False),
        ('r', 'R1', 'R2', 'b'): (('r', 'R1', 'R2', 'b'), prepare_profile_all, block_profile_all, 3, 1, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
