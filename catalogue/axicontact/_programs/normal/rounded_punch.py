"""Programs of axicontact.normal.rounded_punch."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, nextafter, sqrt

import numpy as np

from ..._runtime.arrays.blocks import Program, largest
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
C16 = np.array(0.5)
C17 = np.array(0.12827354898170515)
C18 = np.array(-0.08537629858560956)
C19 = np.array(-0.34978015250902605)
C20 = np.array(-0.10405059669273957)
C21 = np.array(-0.08765327937448042)
C22 = np.array(-0.4772419575052842)
C23 = np.array(0.38349751482672906)
C24 = np.array(1.0469984444287406)
C25 = np.array(0.794760015908848)
C26 = np.array(0.1149645347882279)
C27 = np.array(-0.06926472558036255)
C28 = np.array(-0.31444204894787914)
C29 = np.array(-0.2390379601501764)
C30 = np.array(0.04986013028191364)
C31 = np.array(-0.5656511106697105)
C32 = np.array(0.40679449633872505)
C33 = np.array(0.9810539884681267)
C34 = np.array(-0.4236107740803188)
C35 = np.array(-0.7280932856903389)
C36 = np.array(-0.5654421276068213)
C37 = np.array(2.6585313791299607)
C38 = np.array(3.041993387839565)
C39 = np.array(6.614635192925051)
C40 = np.array(3.2652455639861833)
C41 = np.array(3.7400666747981277)
C42 = np.array(0.7820861356091064)
C43 = np.array(0.6103669238924068)
C44 = np.array(-0.5666998006616584)
C45 = np.array(0.04536948009045464)
C46 = np.array(-2.400498198321689)
C47 = np.array(5.236318487533406)
C48 = np.array(-0.12866702903721514)
C49 = np.array(10.22650141856869)
C50 = np.array(1.6664471112564958)
C51 = np.array(5.805939962105047)
C52 = np.array(0.5497321630557888)
C53 = np.array(np.nan)
C54 = np.array(0.0)
RULE_0 = rule(((0.4097463988641303, 8), (1.7123381635707111, 16), (3.012135102255693, 24), (4.256467450182103, 32), (9.015036632031958, 64)))


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


def block_depth_a(out, a, b, v3, w0, w1, w2, w3, w4, w5, m0, f0):
    size = out.size
    np.multiply(v3, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.subtract(a, b, w0)
    np.divide(w0, b, w1)
    np.less(w1, C0, m0)
    some52 = np.count_nonzero(m0)
    if some52:
        np.minimum(w1, f0, out=w2)
        np.sqrt(w2, w3)
        np.multiply(w2, w3, w3)
        np.multiply(C1, w2, w4)
        np.add(w4, C2, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C3, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C4, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C5, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C6, w4)
        np.multiply(C7, w2, w5)
        np.add(w5, C8, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C9, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C10, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C11, w5)
        np.multiply(w5, w2, w2)
        np.add(w2, C12, w2)
        np.divide(w4, w2, w2)
        np.multiply(w3, w2, w2)
    if some52 != size:
        other52 = w3 if some52 else w2
        np.add(a, b, other52)
        np.multiply(w0, other52, other52)
        np.sqrt(other52, other52)
        np.divide(other52, b, other52)
        np.arctan(other52, w4)
        np.subtract(other52, w4, other52)
        if some52:
            np.copyto(w2, other52, where=~m0)
    np.multiply(out, w2, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, b, w0, w1, w2, w3, w4, w5, m0, f0):
    size = out.size
    np.divide(b, R, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)
    np.subtract(a, b, w0)
    np.divide(w0, b, w1)
    np.less(w1, C0, m0)
    some52 = np.count_nonzero(m0)
    if some52:
        np.minimum(w1, f0, out=w2)
        np.sqrt(w2, w3)
        np.multiply(w2, w3, w3)
        np.multiply(C1, w2, w4)
        np.add(w4, C2, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C3, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C4, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C5, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C6, w4)
        np.multiply(C7, w2, w5)
        np.add(w5, C8, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C9, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C10, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C11, w5)
        np.multiply(w5, w2, w2)
        np.add(w2, C12, w2)
        np.divide(w4, w2, w2)
        np.multiply(w3, w2, w2)
    if some52 != size:
        other52 = w3 if some52 else w2
        np.add(a, b, other52)
        np.multiply(w0, other52, other52)
        np.sqrt(other52, other52)
        np.divide(other52, b, other52)
        np.arctan(other52, w4)
        np.subtract(other52, w4, other52)
        if some52:
            np.copyto(w2, other52, where=~m0)
    np.multiply(out, w2, out)


def depth_from_force(F, R, b, E_star):
    if F.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
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


def block_force_a(out, a, b, v8, w0, w1, w2, w3, w4, w5, w6, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, w0)
    np.multiply(out, w0, w0)
    np.sqrt(w0, w1)
    np.square(a, w2)
    np.multiply(b, w2, w2)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.minimum(out, f0, out=w3)
        np.sqrt(w3, w4)
        np.multiply(w3, w4, w4)
        np.multiply(C1, w3, w5)
        np.add(w5, C2, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C3, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C4, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C5, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C6, w5)
        np.multiply(C7, w3, w6)
        np.add(w6, C8, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C9, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C10, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C11, w6)
        np.multiply(w6, w3, w3)
        np.add(w3, C12, w3)
        np.divide(w5, w3, w3)
        np.multiply(w4, w3, w3)
    if some55 != size:
        other55 = w4 if some55 else w3
        np.divide(w1, b, other55)
        np.arctan(other55, w5)
        np.subtract(other55, w5, other55)
        if some55:
            np.copyto(w3, other55, where=~m0)
    np.multiply(w2, w3, w3)
    np.multiply(w0, w1, w1)
    np.divide(w1, C14, w1)
    np.add(w3, w1, w1)
    np.multiply(v8, w1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, b, E_star, w0, w1, w2, w3, w4, w5, w6, w7, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, w0)
    np.multiply(out, w0, w0)
    np.sqrt(w0, w1)
    np.divide(E_star, R, w2)
    np.square(a, w3)
    np.multiply(b, w3, w3)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some55 = np.count_nonzero(m0)
    if some55:
        np.minimum(out, f0, out=w4)
        np.sqrt(w4, w5)
        np.multiply(w4, w5, w5)
        np.multiply(C1, w4, w6)
        np.add(w6, C2, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C3, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C4, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C5, w6)
        np.multiply(w6, w4, w6)
        np.add(w6, C6, w6)
        np.multiply(C7, w4, w7)
        np.add(w7, C8, w7)
        np.multiply(w7, w4, w7)
        np.add(w7, C9, w7)
        np.multiply(w7, w4, w7)
        np.add(w7, C10, w7)
        np.multiply(w7, w4, w7)
        np.add(w7, C11, w7)
        np.multiply(w7, w4, w4)
        np.add(w4, C12, w4)
        np.divide(w6, w4, w4)
        np.multiply(w5, w4, w4)
    if some55 != size:
        other55 = w5 if some55 else w4
        np.divide(w1, b, other55)
        np.arctan(other55, w6)
        np.subtract(other55, w6, other55)
        if some55:
            np.copyto(w4, other55, where=~m0)
    np.multiply(w3, w4, w4)
    np.multiply(w0, w1, w1)
    np.divide(w1, C14, w1)
    np.add(w4, w1, w1)
    np.multiply(w2, w1, out)


def force_from_depth(d, R, b, E_star):
    if d.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
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


def block_mean_pressure_a(out, a, b, v10, w0, w1, w2, w3, w4, w5, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, w0)
    np.multiply(out, w0, w0)
    np.sqrt(w0, w1)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(out, f0, out=w2)
        np.sqrt(w2, w3)
        np.multiply(w2, w3, w3)
        np.multiply(C1, w2, w4)
        np.add(w4, C2, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C3, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C4, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C5, w4)
        np.multiply(w4, w2, w4)
        np.add(w4, C6, w4)
        np.multiply(C7, w2, w5)
        np.add(w5, C8, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C9, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C10, w5)
        np.multiply(w5, w2, w5)
        np.add(w5, C11, w5)
        np.multiply(w5, w2, w2)
        np.add(w2, C12, w2)
        np.divide(w4, w2, w2)
        np.multiply(w3, w2, w2)
    if some54 != size:
        other54 = w3 if some54 else w2
        np.divide(w1, b, other54)
        np.arctan(other54, w4)
        np.subtract(other54, w4, other54)
        if some54:
            np.copyto(w2, other54, where=~m0)
    np.multiply(b, w2, w2)
    np.multiply(w0, w1, w1)
    np.square(a, w0)
    np.multiply(C14, w0, w0)
    np.divide(w1, w0, w0)
    np.add(w2, w0, w0)
    np.multiply(v10, w0, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, b, E_star, w0, w1, w2, w3, w4, w5, w6, m0, f0):
    size = out.size
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, w0)
    np.multiply(out, w0, w0)
    np.sqrt(w0, w1)
    np.multiply(C15, R, w2)
    np.divide(E_star, w2, w2)
    np.divide(out, b, out)
    np.less(out, C0, m0)
    some54 = np.count_nonzero(m0)
    if some54:
        np.minimum(out, f0, out=w3)
        np.sqrt(w3, w4)
        np.multiply(w3, w4, w4)
        np.multiply(C1, w3, w5)
        np.add(w5, C2, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C3, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C4, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C5, w5)
        np.multiply(w5, w3, w5)
        np.add(w5, C6, w5)
        np.multiply(C7, w3, w6)
        np.add(w6, C8, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C9, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C10, w6)
        np.multiply(w6, w3, w6)
        np.add(w6, C11, w6)
        np.multiply(w6, w3, w3)
        np.add(w3, C12, w3)
        np.divide(w5, w3, w3)
        np.multiply(w4, w3, w3)
    if some54 != size:
        other54 = w4 if some54 else w3
        np.divide(w1, b, other54)
        np.arctan(other54, w5)
        np.subtract(other54, w5, other54)
        if some54:
            np.copyto(w3, other54, where=~m0)
    np.multiply(b, w3, w3)
    np.multiply(w0, w1, w1)
    np.square(a, w0)
    np.multiply(C14, w0, w0)
    np.divide(w1, w0, w0)
    np.add(w3, w0, w0)
    np.multiply(w2, w0, out)


def peak_pressure(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
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
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def peak_radius(a, b, R=1.0, E_star=1.0):
    if a.__class__ is b.__class__ is R.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (b > 1e-30) and (b < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                v5 = sqrt(b / a)
                if v5 < 0.5:
                    v14 = 0.5 - v5
                    v122 = ((((((((0.12827354898170515 * v14 + -0.08537629858560956) * v14 + -0.34978015250902605) * v14 + -0.10405059669273957) * v14 + -0.08765327937448042) * v14 + -0.4772419575052842) * v14 + 0.38349751482672906) * v14 + 1.0469984444287406) * v14 + 0.794760015908848) / ((((((((0.1149645347882279 * v14 + -0.06926472558036255) * v14 + -0.31444204894787914) * v14 + -0.2390379601501764) * v14 + 0.04986013028191364) * v14 + -0.5656511106697105) * v14 + 0.40679449633872505) * v14 + 0.9810539884681267) * v14 + 1.0)
                else:
                    v8 = v5 if v5 > 0.5 or v5 != v5 else 0.5
                    v65 = 1.0 - (v8 if v8 < 1.0 or v8 != v8 else 1.0)
                    v122 = (((((((((-0.4236107740803188 * v65 + -0.7280932856903389) * v65 + -0.5654421276068213) * v65 + 2.6585313791299607) * v65 + 3.041993387839565) * v65 + 6.614635192925051) * v65 + 3.2652455639861833) * v65 + 3.7400666747981277) * v65 + 0.7820861356091064) * v65 + 0.6103669238924068) / (((((((((-0.5666998006616584 * v65 + 0.04536948009045464) * v65 + -2.400498198321689) * v65 + 5.236318487533406) * v65 + -0.12866702903721514) * v65 + 10.22650141856869) * v65 + 1.6664471112564958) * v65 + 5.805939962105047) * v65 + 0.5497321630557888) * v65 + 1.0)
                value = b + (a - b) * (v5 / (1.0 + v5) * v122)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_peak_radius_a(b):
    return (b,)


def block_peak_radius_a(out, a, b, w0, w1, w2, w3, w4, w5, m0, m1, f0, f1):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some127 = np.count_nonzero(m0)
    if some127:
        np.subtract(a, b, out)
        np.divide(b, a, w0)
        np.sqrt(w0, w0)
        np.add(C12, w0, w1)
        np.divide(w0, w1, w1)
        np.less(w0, C16, m1)
        some122 = np.count_nonzero(m1)
        if some122:
            np.minimum(w0, f0, out=w2)
            np.subtract(C16, w2, w2)
            np.multiply(C17, w2, w3)
            np.add(w3, C18, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C19, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C20, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C21, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C22, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C23, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C24, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C25, w3)
            np.multiply(C26, w2, w4)
            np.add(w4, C27, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C28, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C29, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C30, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C31, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C32, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C33, w4)
            np.multiply(w4, w2, w2)
            np.add(w2, C12, w2)
            np.divide(w3, w2, w2)
        if some122 != size:
            other122 = w3 if some122 else w2
            np.maximum(w0, f0, out=other122)
            np.minimum(other122, f1, out=other122)
            np.subtract(C12, other122, other122)
            np.multiply(C34, other122, w4)
            np.add(w4, C35, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C36, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C37, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C38, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C39, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C40, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C41, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C42, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C43, w4)
            np.multiply(C44, other122, w5)
            np.add(w5, C45, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C46, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C47, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C48, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C49, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C50, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C51, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C52, w5)
            np.multiply(w5, other122, other122)
            np.add(other122, C12, other122)
            np.divide(w4, other122, other122)
            if some122:
                np.copyto(w2, other122, where=~m1)
        np.multiply(w1, w2, w2)
        np.multiply(out, w2, w2)
        np.add(b, w2, out)
    if some127 != size:
        np.copyto(out, C53, where=~m0)


def prepare_peak_radius_all():
    return ()


def block_peak_radius_all(out, a, b, w0, w1, w2, w3, w4, w5, m0, m1, f0, f1):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some127 = np.count_nonzero(m0)
    if some127:
        np.subtract(a, b, out)
        np.divide(b, a, w0)
        np.sqrt(w0, w0)
        np.add(C12, w0, w1)
        np.divide(w0, w1, w1)
        np.less(w0, C16, m1)
        some122 = np.count_nonzero(m1)
        if some122:
            np.minimum(w0, f0, out=w2)
            np.subtract(C16, w2, w2)
            np.multiply(C17, w2, w3)
            np.add(w3, C18, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C19, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C20, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C21, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C22, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C23, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C24, w3)
            np.multiply(w3, w2, w3)
            np.add(w3, C25, w3)
            np.multiply(C26, w2, w4)
            np.add(w4, C27, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C28, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C29, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C30, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C31, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C32, w4)
            np.multiply(w4, w2, w4)
            np.add(w4, C33, w4)
            np.multiply(w4, w2, w2)
            np.add(w2, C12, w2)
            np.divide(w3, w2, w2)
        if some122 != size:
            other122 = w3 if some122 else w2
            np.maximum(w0, f0, out=other122)
            np.minimum(other122, f1, out=other122)
            np.subtract(C12, other122, other122)
            np.multiply(C34, other122, w4)
            np.add(w4, C35, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C36, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C37, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C38, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C39, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C40, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C41, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C42, w4)
            np.multiply(w4, other122, w4)
            np.add(w4, C43, w4)
            np.multiply(C44, other122, w5)
            np.add(w5, C45, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C46, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C47, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C48, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C49, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C50, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C51, w5)
            np.multiply(w5, other122, w5)
            np.add(w5, C52, w5)
            np.multiply(w5, other122, other122)
            np.add(other122, C12, other122)
            np.divide(w4, other122, other122)
            if some122:
                np.copyto(w2, other122, where=~m1)
        np.multiply(w1, w2, w2)
        np.multiply(out, w2, w2)
        np.add(b, w2, out)
    if some127 != size:
        np.copyto(out, C53, where=~m0)


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


def block_profile_r(out, r, b, v7, w0, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.copyto(out, C54)
    if some10 != size:
        other10 = w0 if some10 else out
        np.subtract(r, b, other10)
        np.square(other10, other10)
        np.divide(other10, v7, other10)
        if some10:
            np.copyto(out, other10, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, b, w0, w1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.copyto(out, C54)
    if some10 != size:
        other10 = w0 if some10 else out
        np.subtract(r, b, other10)
        np.square(other10, other10)
        np.multiply(C13, R, w1)
        np.divide(other10, w1, other10)
        if some10:
            np.copyto(out, other10, where=~m0)


def radius_from_depth(d, R, b):
    if d.__class__ is R.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
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
        ('a',): Program(('a',), prepare_depth_a, block_depth_a, scratch=6, masks=1, filled=(0.42,)),
        ('a', 'R', 'b'): Program(('a', 'R', 'b'), prepare_depth_all, block_depth_all, scratch=6, masks=1, filled=(0.42,)),
    },
    ('_force', 1, 'a', 'R', 'b', 'E_star'): {
        ('a',): Program(('a',), prepare_force_a, block_force_a, scratch=7, masks=1, filled=(0.42,)),
        ('a', 'R', 'b', 'E_star'): Program(('a', 'R', 'b', 'E_star'), prepare_force_all, block_force_all, scratch=8, masks=1, filled=(0.42,)),
    },
    ('_mean_pressure', 1, 'a', 'R', 'b', 'E_star'): {
        ('a',): Program(('a',), prepare_mean_pressure_a, block_mean_pressure_a, scratch=6, masks=1, filled=(0.42,)),
        ('a', 'R', 'b', 'E_star'): Program(('a', 'R', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, scratch=7, masks=1, filled=(0.42,)),
    },
    ('_peak_radius', 1, 'a', 'b'): {
        ('a',): Program(('a',), prepare_peak_radius_a, block_peak_radius_a, scratch=6, masks=2, filled=(0.5, 1.0)),
        ('a', 'b'): Program(('a', 'b'), prepare_peak_radius_all, block_peak_radius_all, scratch=6, masks=2, filled=(0.5, 1.0)),
    },
    ('_profile', 1, 'r', 'R', 'b'): {
        ('r',): Program(('r',), prepare_profile_r, block_profile_r, scratch=1, masks=1),
        ('r', 'R', 'b'): Program(('r', 'R', 'b'), prepare_profile_all, block_profile_all, scratch=2, masks=1),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): Program(('a',), prepare_stiffness_a, block_stiffness_a),
        ('a', 'E_star'): Program(('a', 'E_star'), prepare_stiffness_all, block_stiffness_all),
    },
}
