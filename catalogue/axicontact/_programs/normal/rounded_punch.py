"""Programs of axicontact.normal.rounded_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import rounded_punch as bodies

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
C13 = np.array(2.0)
C14 = np.array(3.0)
C15 = np.array(3.141592653589793)
C16 = np.array(np.inf)
C17 = np.array(0.5)
C18 = np.array(0.12827354898170515)
C19 = np.array(-0.08537629858560956)
C20 = np.array(-0.34978015250902605)
C21 = np.array(-0.10405059669273957)
C22 = np.array(-0.08765327937448042)
C23 = np.array(-0.4772419575052842)
C24 = np.array(0.38349751482672906)
C25 = np.array(1.0469984444287406)
C26 = np.array(0.794760015908848)
C27 = np.array(0.1149645347882279)
C28 = np.array(-0.06926472558036255)
C29 = np.array(-0.31444204894787914)
C30 = np.array(-0.2390379601501764)
C31 = np.array(0.04986013028191364)
C32 = np.array(-0.5656511106697105)
C33 = np.array(0.40679449633872505)
C34 = np.array(0.9810539884681267)
C35 = np.array(-0.4236107740803188)
C36 = np.array(-0.7280932856903389)
C37 = np.array(-0.5654421276068213)
C38 = np.array(2.6585313791299607)
C39 = np.array(3.041993387839565)
C40 = np.array(6.614635192925051)
C41 = np.array(3.2652455639861833)
C42 = np.array(3.7400666747981277)
C43 = np.array(0.7820861356091064)
C44 = np.array(0.6103669238924068)
C45 = np.array(-0.5666998006616584)
C46 = np.array(0.04536948009045464)
C47 = np.array(-2.400498198321689)
C48 = np.array(5.236318487533406)
C49 = np.array(-0.12866702903721514)
C50 = np.array(10.22650141856869)
C51 = np.array(1.6664471112564958)
C52 = np.array(5.805939962105047)
C53 = np.array(0.5497321630557888)
C54 = np.array(np.nan)
C55 = np.array(0.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R, b):
    if a.__class__ is R.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            v5 = a - b
            v6 = v5 / b
            if v6 < 0.42:
                v52 = v6 * sqrt(v6) * ((((((0.0005288491342179178 * v6 + 0.038096760299703034) * v6 + 0.4065213849117787) * v6 + 1.438682033198726) * v6 + 1.9979042349620892) * v6 + 0.9428090415820634) / (((((0.006421883194715949 * v6 + 0.15001504718401248) * v6 + 0.9450913324352289) * v6 + 2.37401087025821) * v6 + 2.569097449054519) * v6 + 1.0))
            else:
                v12 = sqrt(v5 * (a + b)) / b
                v52 = v12 - atan(v12)
            value = b / R * a * v52
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, b):
    v3 = b / R
    return (b, v3)


def block_depth_a(out, a, b, v3, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.multiply(v3, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, b, t0)
    np.divide(t0, b, t1)
    np.less(t1, C0, m0)
    some52 = np.count_nonzero(m0)
    if some52:
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
    if some52 != size:
        other52 = t3 if some52 else t2
        np.add(a, b, other52)
        np.multiply(t0, other52, other52)
        np.sqrt(other52, other52)
        np.divide(other52, b, other52)
        np.arctan(other52, t4)
        np.subtract(other52, t4, other52)
        if some52:
            np.copyto(t2, other52, where=~m0)
    np.multiply(out, t2, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, b, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.divide(b, R, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)
    np.subtract(a, b, t0)
    np.divide(t0, b, t1)
    np.less(t1, C0, m0)
    some52 = np.count_nonzero(m0)
    if some52:
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
    if some52 != size:
        other52 = t3 if some52 else t2
        np.add(a, b, other52)
        np.multiply(t0, other52, other52)
        np.sqrt(other52, other52)
        np.divide(other52, b, other52)
        np.arctan(other52, t4)
        np.subtract(other52, t4, other52)
        if some52:
            np.copyto(t2, other52, where=~m0)
    np.multiply(out, t2, out)


def depth_from_force(F, R, b, E_star):
    if F.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R, b):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            if a >= b:
                v4 = r - b
                v11 = a - b
                v13 = a + b
                v62 = b / R
                if r > a:
                    if a > b:
                        v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (r + b))
                        v10 = b / r
                        v16 = r - a
                        v21 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * v13) / sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (r + a))
                        v23 = asinh(v21 / v10)
                        v28 = 0.0 - expm1(-2.0 * v23)
                        v31 = v28 if v28 > 0.0 else inf
                        v48 = b * b
                        v52 = v10 * v10
                        v71 = []
                        for node, weight in RULE_0(v23 / 1.0):
                            v33 = node * v23
                            v42 = v21 * (exp(-v33) * (0.0 - expm1(-2.0 * (v23 - v33))) / v31)
                            v43 = v42 * v42
                            v45 = sqrt(1.0 + v43)
                            v47 = v9 * v42 / v45
                            v51 = sqrt(v48 + v47 * v47)
                            v70 = (2.0 * v47 / R - v62 * atan2(v47, b)) * v47 / v51 * atan2(v51, v9 / v45) * (sqrt(v52 + v43) / (v45 * v45 * v45))
                            v71.append(weight * v70)
                        v71 = fsum(v71) * v23
                        v73 = v9 * v71
                    else:
                        v73 = 0.0
                    value = 0.6366197723675814 * v73
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b):
                        return value
                    return None
                v77 = v11 / b
                if v77 < 0.42:
                    v121 = v77 * sqrt(v77) * ((((((0.0005288491342179178 * v77 + 0.038096760299703034) * v77 + 0.4065213849117787) * v77 + 1.438682033198726) * v77 + 1.9979042349620892) * v77 + 0.9428090415820634) / (((((0.006421883194715949 * v77 + 0.15001504718401248) * v77 + 0.9450913324352289) * v77 + 2.37401087025821) * v77 + 2.569097449054519) * v77 + 1.0))
                else:
                    v82 = sqrt(v11 * v13) / b
                    v121 = v82 - atan(v82)
                value = v62 * a * v121 - (0.0 if r < b else v4 * v4 / (2.0 * R))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                v4 = b / R
                v6 = a - b
                v7 = v6 / b
                v10 = a + b
                if v7 < 0.42:
                    v53 = v7 * sqrt(v7) * ((((((0.0005288491342179178 * v7 + 0.038096760299703034) * v7 + 0.4065213849117787) * v7 + 1.438682033198726) * v7 + 1.9979042349620892) * v7 + 0.9428090415820634) / (((((0.006421883194715949 * v7 + 0.15001504718401248) * v7 + 0.9450913324352289) * v7 + 2.37401087025821) * v7 + 2.569097449054519) * v7 + 1.0))
                else:
                    v13 = sqrt(v6 * v10) / b
                    v53 = v13 - atan(v13)
                v54 = v4 * a * v53
                if a > b:
                    v58 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v10)
                    v60 = asinh(v58 / b)
                    v64 = 0.0 - expm1(-2.0 * v60)
                    v67 = v64 if v64 > 0.0 else inf
                    v79 = b * b
                    v135 = []
                    for node, weight in RULE_0(v60 / 1.0):
                        v69 = node * v60
                        v78 = v58 * (exp(-v69) * (0.0 - expm1(-2.0 * (v60 - v69))) / v67)
                        v84 = v78 / b
                        if v84 < 1.0:
                            v87 = v84 * v84
                            v130 = v84 * v87 * (((((((2.229767813968649e-06 * v87 + 0.0021043873129700233) * v87 + 0.04325113828415611) * v87 + 0.2725778671008127) * v87 + 0.7123414383945195) * v87 + 0.8116412201960678) * v87 + 0.3333333333333333) / ((((((0.002445452808893491 * v87 + 0.06453295925870227) * v87 + 0.5368820963772863) * v87 + 1.9680296155712274) * v87 + 3.5294070829658954) * v87 + 3.034923660588189) * v87 + 1.0))
                        else:
                            v130 = v84 - atan(v84)
                        v132 = v54 - v4 * sqrt(v79 + v78 * v78) * v130
                        v134 = v132 * v132 * v78
                        v135.append(weight * v134)
                    v135 = fsum(v135) * v60
                    v136 = v135
                else:
                    v136 = 0.0
                value = E_star * (b * v54 * v54 + v136)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, R, b, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            v4 = a - b
            v6 = v4 * (a + b)
            v7 = sqrt(v6)
            v12 = v4 / b
            if v12 < 0.42:
                v55 = v12 * sqrt(v12) * ((((((0.0005288491342179178 * v12 + 0.038096760299703034) * v12 + 0.4065213849117787) * v12 + 1.438682033198726) * v12 + 1.9979042349620892) * v12 + 0.9428090415820634) / (((((0.006421883194715949 * v12 + 0.15001504718401248) * v12 + 0.9450913324352289) * v12 + 2.37401087025821) * v12 + 2.569097449054519) * v12 + 1.0))
            else:
                v15 = v7 / b
                v55 = v15 - atan(v15)
            value = E_star / R * (b * (a * a) * v55 + v6 * v7 / 3.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, b, E_star):
    v8 = E_star / R
    return (b, v8)


def block_force_a(out, a, b, v8, t0, t1, t2, t3, t4, t5, t6, m0, f0):
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
    some55 = np.count_nonzero(m0)
    if some55:
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
    if some55 != size:
        other55 = t4 if some55 else t3
        np.divide(t1, b, other55)
        np.arctan(other55, t5)
        np.subtract(other55, t5, other55)
        if some55:
            np.copyto(t3, other55, where=~m0)
    np.multiply(t2, t3, t3)
    np.multiply(t0, t1, t1)
    np.divide(t1, C14, t1)
    np.add(t3, t1, t1)
    np.multiply(v8, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, b, E_star, t0, t1, t2, t3, t4, t5, t6, t7, m0, f0):
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
    some55 = np.count_nonzero(m0)
    if some55:
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
    if some55 != size:
        other55 = t5 if some55 else t4
        np.divide(t1, b, other55)
        np.arctan(other55, t6)
        np.subtract(other55, t6, other55)
        if some55:
            np.copyto(t4, other55, where=~m0)
    np.multiply(t3, t4, t4)
    np.multiply(t0, t1, t1)
    np.divide(t1, C14, t1)
    np.add(t4, t1, t1)
    np.multiply(t2, t1, out)


def force_from_depth(d, R, b, E_star):
    if d.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, R, b, E_star):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                v8 = nextafter(b, inf) if r == b else r
                if a > (v8 if v8 > b or v8 != v8 else b):
                    v9 = v8 < b
                    v12 = 0.0 if v9 else 1.0
                    v13 = a - b
                    v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (a + b))
                    v18 = a - v8
                    v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (a + v8))
                    v30 = asinh((v17 if v9 else v22) / sqrt(abs(v8 - b) * (v8 + b)))
                    v32 = 2.0 * v12
                    v33 = 1.0 - v32
                    v36 = expm1(-2.0 * v30)
                    v38 = v32 - v33 * v36
                    v40 = v38 if v38 > 0.0 else inf
                    v42 = 2.0 * (1.0 - v12)
                    v43 = 1.0 - v42
                    v45 = v42 - v43 * v36
                    v47 = v45 if v45 > 0.0 else inf
                    v67 = b * b
                    v74 = b / R
                    v82 = []
                    for node, weight in RULE_0(v30 / 1.0):
                        v51 = node * v30
                        v53 = exp(-v51)
                        v56 = expm1(-2.0 * (v30 - v51))
                        v61 = v17 * (v53 * (v32 - v33 * v56) / v40)
                        v66 = v22 * (v53 * (v42 - v43 * v56) / v47)
                        v70 = sqrt(v67 + v61 * v61)
                        v81 = (2.0 * v61 / R - v74 * atan2(v61, b)) * (v61 / v70) * (v66 / (v70 + v66))
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v30
                    v84 = v8 * v8 * v82
                else:
                    v84 = 0.0
                if r > b:
                    v86 = r if r < a or r != r else a
                    v87 = v86 if v86 > b or v86 != v86 else b
                    v88 = v87 - b
                    v90 = v88 * (v87 + b)
                    v91 = sqrt(v90)
                    v95 = v88 / b
                    if v95 < 0.42:
                        v137 = v95 * sqrt(v95) * ((((((0.0005288491342179178 * v95 + 0.038096760299703034) * v95 + 0.4065213849117787) * v95 + 1.438682033198726) * v95 + 1.9979042349620892) * v95 + 0.9428090415820634) / (((((0.006421883194715949 * v95 + 0.15001504718401248) * v95 + 0.9450913324352289) * v95 + 2.37401087025821) * v95 + 2.569097449054519) * v95 + 1.0))
                    else:
                        v98 = v91 / b
                        v137 = v98 - atan(v98)
                    v144 = E_star / R * (b * (v87 * v87) * v137 + v90 * v91 / 3.0)
                else:
                    v144 = 0.0
                value = v144 + 2.0 * E_star * v84
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            v4 = a - b
            v6 = v4 * (a + b)
            v7 = sqrt(v6)
            v11 = v4 / b
            if v11 < 0.42:
                v54 = v11 * sqrt(v11) * ((((((0.0005288491342179178 * v11 + 0.038096760299703034) * v11 + 0.4065213849117787) * v11 + 1.438682033198726) * v11 + 1.9979042349620892) * v11 + 0.9428090415820634) / (((((0.006421883194715949 * v11 + 0.15001504718401248) * v11 + 0.9450913324352289) * v11 + 2.37401087025821) * v11 + 2.569097449054519) * v11 + 1.0))
            else:
                v14 = v7 / b
                v54 = v14 - atan(v14)
            value = E_star / (3.141592653589793 * R) * (b * v54 + v6 * v7 / (3.0 * (a * a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R, b, E_star):
    v9 = (3.141592653589793) * R
    v10 = E_star / v9
    return (b, v10)


def block_mean_pressure_a(out, a, b, v10, t0, t1, t2, t3, t4, t5, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t1)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(out, f0, out=t2)
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
        np.divide(t1, b, other54)
        np.arctan(other54, t4)
        np.subtract(other54, t4, other54)
        if some54:
            np.copyto(t2, other54, where=~m0)
    np.multiply(b, t2, t2)
    np.multiply(t0, t1, t1)
    np.square(a, t0)
    np.multiply(C14, t0, t0)
    np.divide(t1, t0, t0)
    np.add(t2, t0, t0)
    np.multiply(v10, t0, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, b, E_star, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t1)
    np.multiply(C15, R, t2)
    np.divide(E_star, t2, t2)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some54 = np.count_nonzero(m0)
    if some54:
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
    if some54 != size:
        other54 = t4 if some54 else t3
        np.divide(t1, b, other54)
        np.arctan(other54, t5)
        np.subtract(other54, t5, other54)
        if some54:
            np.copyto(t3, other54, where=~m0)
    np.multiply(b, t3, t3)
    np.multiply(t0, t1, t1)
    np.square(a, t0)
    np.multiply(C14, t0, t0)
    np.divide(t1, t0, t0)
    np.add(t3, t0, t0)
    np.multiply(t2, t0, out)


def peak_pressure(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                if a < inf:
                    if a > b:
                        v5 = sqrt(b / a)
                        if v5 < 0.5:
                            v14 = 0.5 - v5
                            v122 = ((((((((0.12827354898170515 * v14 + -0.08537629858560956) * v14 + -0.34978015250902605) * v14 + -0.10405059669273957) * v14 + -0.08765327937448042) * v14 + -0.4772419575052842) * v14 + 0.38349751482672906) * v14 + 1.0469984444287406) * v14 + 0.794760015908848) / ((((((((0.1149645347882279 * v14 + -0.06926472558036255) * v14 + -0.31444204894787914) * v14 + -0.2390379601501764) * v14 + 0.04986013028191364) * v14 + -0.5656511106697105) * v14 + 0.40679449633872505) * v14 + 0.9810539884681267) * v14 + 1.0)
                        else:
                            v8 = v5 if v5 > 0.5 or v5 != v5 else 0.5
                            v65 = 1.0 - (v8 if v8 < 1.0 or v8 != v8 else 1.0)
                            v122 = (((((((((-0.4236107740803188 * v65 + -0.7280932856903389) * v65 + -0.5654421276068213) * v65 + 2.6585313791299607) * v65 + 3.041993387839565) * v65 + 6.614635192925051) * v65 + 3.2652455639861833) * v65 + 3.7400666747981277) * v65 + 0.7820861356091064) * v65 + 0.6103669238924068) / (((((((((-0.5666998006616584 * v65 + 0.04536948009045464) * v65 + -2.400498198321689) * v65 + 5.236318487533406) * v65 + -0.12866702903721514) * v65 + 10.22650141856869) * v65 + 1.6664471112564958) * v65 + 5.805939962105047) * v65 + 0.5497321630557888) * v65 + 1.0)
                        v123 = v5 / (1.0 + v5) * v122
                        v124 = a - b
                        v126 = b + v123 * v124
                        v131 = sqrt((v124 if v124 > 0.0 or v124 != v124 else 0.0) * (a + b))
                        v139 = asinh(sqrt((1.0 - v123) * (a + v126) / (v123 * (v126 + b))))
                        v146 = 2.0 - -1.0 * expm1(-2.0 * v139)
                        v149 = v146 if v146 > 0.0 else inf
                        v162 = b * b
                        v169 = b / R
                        v174 = []
                        for node, weight in RULE_0(v139 / 1.0):
                            v151 = node * v139
                            v161 = v131 * (exp(-v151) * (2.0 - -1.0 * expm1(-2.0 * (v139 - v151))) / v149)
                            v173 = (2.0 * v161 / R - v169 * atan2(v161, b)) * v161 / sqrt(v162 + v161 * v161)
                            v174.append(weight * v173)
                        v174 = fsum(v174) * v139
                        v175 = v174
                    else:
                        v175 = 0.0
                    value = E_star / 3.141592653589793 * v175
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if value != value and ordinary(a, R, b, E_star):
                        return value
                    return None
                return a
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_radius(a, b, R=1.0, E_star=1.0):
    if a.__class__ is b.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (b > 1e-30) and (b < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                if a < inf:
                    v7 = sqrt(b / a)
                    if v7 < 0.5:
                        v16 = 0.5 - v7
                        v124 = ((((((((0.12827354898170515 * v16 + -0.08537629858560956) * v16 + -0.34978015250902605) * v16 + -0.10405059669273957) * v16 + -0.08765327937448042) * v16 + -0.4772419575052842) * v16 + 0.38349751482672906) * v16 + 1.0469984444287406) * v16 + 0.794760015908848) / ((((((((0.1149645347882279 * v16 + -0.06926472558036255) * v16 + -0.31444204894787914) * v16 + -0.2390379601501764) * v16 + 0.04986013028191364) * v16 + -0.5656511106697105) * v16 + 0.40679449633872505) * v16 + 0.9810539884681267) * v16 + 1.0)
                    else:
                        v10 = v7 if v7 > 0.5 or v7 != v7 else 0.5
                        v67 = 1.0 - (v10 if v10 < 1.0 or v10 != v10 else 1.0)
                        v124 = (((((((((-0.4236107740803188 * v67 + -0.7280932856903389) * v67 + -0.5654421276068213) * v67 + 2.6585313791299607) * v67 + 3.041993387839565) * v67 + 6.614635192925051) * v67 + 3.2652455639861833) * v67 + 3.7400666747981277) * v67 + 0.7820861356091064) * v67 + 0.6103669238924068) / (((((((((-0.5666998006616584 * v67 + 0.04536948009045464) * v67 + -2.400498198321689) * v67 + 5.236318487533406) * v67 + -0.12866702903721514) * v67 + 10.22650141856869) * v67 + 1.6664471112564958) * v67 + 5.805939962105047) * v67 + 0.5497321630557888) * v67 + 1.0)
                    value = b + (a - b) * (v7 / (1.0 + v7) * v124)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    return None
                return a
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_a(b):
    return (b,)


def block_peak_radius_a(out, a, b, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0, f1):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some130 = np.count_nonzero(m0)
    if some130:
        np.less(a, C16, m1)
        some128 = np.count_nonzero(m1)
        if some128:
            np.subtract(a, b, out)
            np.divide(b, a, t0)
            np.sqrt(t0, t0)
            np.add(C12, t0, t1)
            np.divide(t0, t1, t1)
            np.less(t0, C17, m2)
            some124 = np.count_nonzero(m2)
            if some124:
                np.minimum(t0, f0, out=t2)
                np.subtract(C17, t2, t2)
                np.multiply(C18, t2, t3)
                np.add(t3, C19, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C20, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C21, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C22, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C23, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C24, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C25, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C26, t3)
                np.multiply(C27, t2, t4)
                np.add(t4, C28, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C29, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C30, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C31, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C32, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C33, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C34, t4)
                np.multiply(t4, t2, t2)
                np.add(t2, C12, t2)
                np.divide(t3, t2, t2)
            if some124 != size:
                other124 = t3 if some124 else t2
                np.maximum(t0, f0, out=other124)
                np.minimum(other124, f1, out=other124)
                np.subtract(C12, other124, other124)
                np.multiply(C35, other124, t4)
                np.add(t4, C36, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C37, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C38, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C39, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C40, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C41, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C42, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C43, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C44, t4)
                np.multiply(C45, other124, t5)
                np.add(t5, C46, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C47, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C48, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C49, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C50, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C51, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C52, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C53, t5)
                np.multiply(t5, other124, other124)
                np.add(other124, C12, other124)
                np.divide(t4, other124, other124)
                if some124:
                    np.copyto(t2, other124, where=~m2)
            np.multiply(t1, t2, t2)
            np.multiply(out, t2, t2)
            np.add(b, t2, out)
        if some128 != size:
            np.copyto(out, a, where=~m1)
    if some130 != size:
        np.copyto(out, C54, where=~m0)


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a, b, t0, t1, t2, t3, t4, t5, m0, m1, m2, f0, f1):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some130 = np.count_nonzero(m0)
    if some130:
        np.less(a, C16, m1)
        some128 = np.count_nonzero(m1)
        if some128:
            np.subtract(a, b, out)
            np.divide(b, a, t0)
            np.sqrt(t0, t0)
            np.add(C12, t0, t1)
            np.divide(t0, t1, t1)
            np.less(t0, C17, m2)
            some124 = np.count_nonzero(m2)
            if some124:
                np.minimum(t0, f0, out=t2)
                np.subtract(C17, t2, t2)
                np.multiply(C18, t2, t3)
                np.add(t3, C19, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C20, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C21, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C22, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C23, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C24, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C25, t3)
                np.multiply(t3, t2, t3)
                np.add(t3, C26, t3)
                np.multiply(C27, t2, t4)
                np.add(t4, C28, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C29, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C30, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C31, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C32, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C33, t4)
                np.multiply(t4, t2, t4)
                np.add(t4, C34, t4)
                np.multiply(t4, t2, t2)
                np.add(t2, C12, t2)
                np.divide(t3, t2, t2)
            if some124 != size:
                other124 = t3 if some124 else t2
                np.maximum(t0, f0, out=other124)
                np.minimum(other124, f1, out=other124)
                np.subtract(C12, other124, other124)
                np.multiply(C35, other124, t4)
                np.add(t4, C36, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C37, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C38, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C39, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C40, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C41, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C42, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C43, t4)
                np.multiply(t4, other124, t4)
                np.add(t4, C44, t4)
                np.multiply(C45, other124, t5)
                np.add(t5, C46, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C47, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C48, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C49, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C50, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C51, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C52, t5)
                np.multiply(t5, other124, t5)
                np.add(t5, C53, t5)
                np.multiply(t5, other124, other124)
                np.add(other124, C12, other124)
                np.divide(t4, other124, other124)
                if some124:
                    np.copyto(t2, other124, where=~m2)
            np.multiply(t1, t2, t2)
            np.multiply(out, t2, t2)
            np.add(b, t2, out)
        if some128 != size:
            np.copyto(out, a, where=~m1)
    if some130 != size:
        np.copyto(out, C54, where=~m0)


def pressure(r, a, R, b, E_star):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                if r < a:
                    v8 = nextafter(b, inf) if r == b else r
                    if a > (v8 if v8 > b or v8 != v8 else b):
                        v9 = v8 < b
                        v13 = a - b
                        v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (a + b))
                        if v9:
                            v23 = v17
                        else:
                            v18 = a - v8
                            v23 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (a + v8))
                        v30 = asinh(v23 / sqrt(abs(v8 - b) * (v8 + b)))
                        v32 = 2.0 * (0.0 if v9 else 1.0)
                        v33 = 1.0 - v32
                        v38 = v32 - v33 * expm1(-2.0 * v30)
                        v40 = v38 if v38 > 0.0 else inf
                        v54 = b * b
                        v61 = b / R
                        v66 = []
                        for node, weight in RULE_0(v30 / 1.0):
                            v43 = node * v30
                            v53 = v17 * (exp(-v43) * (v32 - v33 * expm1(-2.0 * (v30 - v43))) / v40)
                            v65 = (2.0 * v53 / R - v61 * atan2(v53, b)) * v53 / sqrt(v54 + v53 * v53)
                            v66.append(weight * v65)
                        v66 = fsum(v66) * v30
                        v67 = v66
                    else:
                        v67 = 0.0
                    value = E_star / 3.141592653589793 * v67
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, b, E_star):
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, R, b):
    if r.__class__ is R.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            if r < b:
                return 0.0
            v4 = r - b
            return v4 * v4 / (2.0 * R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R, b):
    v7 = (2.0) * R
    return (b, v7)


def block_profile_r(out, r, b, v7, t0, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.copyto(out, C55)
    if some10 != size:
        other10 = t0 if some10 else out
        np.subtract(r, b, other10)
        np.square(other10, other10)
        np.divide(other10, v7, other10)
        if some10:
            np.copyto(out, other10, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, b, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.copyto(out, C55)
    if some10 != size:
        other10 = t0 if some10 else out
        np.subtract(r, b, other10)
        np.square(other10, other10)
        np.multiply(C13, R, t1)
        np.divide(other10, t1, other10)
        if some10:
            np.copyto(out, other10, where=~m0)


def radius_from_depth(d, R, b):
    if d.__class__ is R.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, R, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, b, E_star):
    if F.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, R, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, R=1.0, b=1.0):
    if a.__class__ is E_star.__class__ is R.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
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
    np.multiply(C13, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 6, 1, (0.42,), False),
        ('a', 'R', 'b'): (('a', 'R', 'b'), prepare_depth_all, block_depth_all, 6, 1, (0.42,), False),
    },
    ('_force', 1, 'a', 'R', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 7, 1, (0.42,), False),
        ('a', 'R', 'b', 'E_star'): (('a', 'R', 'b', 'E_star'), prepare_force_all, block_force_all, 8, 1, (0.42,), False),
    },
    ('_mean_pressure', 1, 'a', 'R', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 6, 1, (0.42,), False),
        ('a', 'R', 'b', 'E_star'): (('a', 'R', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 7, 1, (0.42,), False),
    },
    ('_peak_radius', 1, 'a', 'b'): {
        ('a',): (('a',), prepare_peak_radius_a, block_peak_radius_a, 6, 3, (0.5, 1.0), False),
        ('a', 'b'): (('a', 'b'), prepare_peak_radius_all, block_peak_radius_all, 6, 3, (0.5, 1.0), False),
    },
    ('_profile', 1, 'r', 'R', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 1, (), False),
        ('r', 'R', 'b'): (('r', 'R', 'b'), prepare_profile_all, block_profile_all, 2, 1, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
