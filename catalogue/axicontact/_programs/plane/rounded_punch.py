"""Programs of axicontact.plane.rounded_punch."""

from __future__ import annotations

from math import asinh, atan, exp, expm1, fsum, inf, nan, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.plane import rounded_punch as bodies

C0 = np.array(2.0)
C1 = np.array(0.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(L, a, R, b):
    if L.__class__ is a.__class__ is R.__class__ is b.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            if a >= b:
                if a <= L:
                    v4 = a - b
                    v34 = a > b
                    if a < L:
                        if v34:
                            v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + b))
                            v10 = L - a
                            v14 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (L + a))
                            v15 = b / L
                            v16 = v9 / v14
                            v18 = asinh(v16 / v15)
                            v22 = sqrt(1.0 + v16 * v16)
                            v26 = 0.0 - expm1(-2.0 * v18)
                            v29 = v26 if v26 > 0.0 else inf
                            v32 = 42.0 + asinh(v16)
                            v33 = v18 if v18 < v32 or v18 != v18 else v32
                            v51 = b * b
                            v56 = v15 / v16
                            v58 = v56 * v56
                            v74 = []
                            for node, weight in RULE_0(v33 / 1.0):
                                v35 = node * v33
                                v43 = exp(-v35) * (0.0 - expm1(-2.0 * (v18 - v35))) / v29
                                v44 = v16 * v43
                                v46 = 1.0 + v44 * v44
                                v48 = v22 / sqrt(v46)
                                v50 = v9 * v43 * v48
                                v54 = sqrt(v51 + v50 * v50)
                                v73 = v54 * atan(v50 / b) / R * (v50 / v54 * (sqrt(v58 + v43 * v43) / v46)) * v48 * asinh(v14 * v48 / v54)
                                v74.append(weight * v73)
                            v74 = fsum(v74) * v33
                            v76 = v9 * v74
                        else:
                            v76 = 0.0
                        value = 0.6366197723675814 * v76
                        if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                            return value
                        if value != value and ordinary(L, a, R, b):
                            return value
                        return None
                    if v34:
                        return v4 * v4 / (2.0 * R)
                    return 0.0
                return nan
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def half_width_from_load(P, R, b, E_star):
    if P.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._half_width_from_load(P, R, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(P, R, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            v10 = sqrt((a - b) * (a + b))
            v11 = v10 / b
            if a < 2.0 * b:
                v12 = asinh(v11)
                v18 = 0.0 - expm1(-2.0 * v12)
                v21 = v18 if v18 > 0.0 else inf
                v23 = v12 if v12 < 42.0 or v12 != v12 else 42.0
                v34 = b * b
                v43 = []
                for node, weight in RULE_0(v23 / 1.0):
                    v24 = node * v23
                    v33 = v10 * (exp(-v24) * (0.0 - expm1(-2.0 * (v12 - v24))) / v21)
                    v42 = sqrt(v34 + v33 * v33) * atan(v33 / b) / R * v33
                    v43.append(weight * v42)
                v43 = fsum(v43) * v23
                value = E_star * v43
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, R, b, E_star):
                    return value
                return None
            return E_star / (2.0 * R) * (a * a * atan(v11) - b * v10)
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(x, a, R, b, E_star):
    if x.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                if x < a:
                    v8 = nextafter(b, inf) if x == b else x
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
                        v64 = []
                        for node, weight in RULE_0(v30 / 1.0):
                            v43 = node * v30
                            v53 = v17 * (exp(-v43) * (v32 - v33 * expm1(-2.0 * (v30 - v43))) / v40)
                            v57 = sqrt(v54 + v53 * v53)
                            v63 = v57 * atan(v53 / b) / R * v53 / v57
                            v64.append(weight * v63)
                        v64 = fsum(v64) * v30
                        v65 = v64
                    else:
                        v65 = 0.0
                    value = E_star / 3.141592653589793 * v65
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, R, b, E_star):
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(x, R, b):
    if x.__class__ is R.__class__ is b.__class__ is float and x > 1e-30 and (x < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            if x > b:
                v4 = x - b
                return v4 * v4 / (2.0 * R)
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(R, b):
    v7 = (2.0) * R
    return (b, v7)


def block_profile_x(out, x, b, v7, m0):
    size = out.size
    np.greater(x, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.subtract(x, b, out)
        np.square(out, out)
        np.divide(out, v7, out)
    if some10 != size:
        np.copyto(out, C1, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, R, b, t0, m0):
    size = out.size
    np.greater(x, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.subtract(x, b, out)
        np.square(out, out)
        np.multiply(C0, R, t0)
        np.divide(out, t0, out)
    if some10 != size:
        np.copyto(out, C1, where=~m0)


def slope(x, a, R, b):
    if x.__class__ is a.__class__ is R.__class__ is b.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            if a >= b:
                if x > a:
                    if a > b:
                        v4 = a - b
                        v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + b))
                        v10 = x - a
                        v15 = b / x
                        v16 = v9 / sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (x + a))
                        v18 = asinh(v16 / v15)
                        v22 = sqrt(1.0 + v16 * v16)
                        v26 = 0.0 - expm1(-2.0 * v18)
                        v29 = v26 if v26 > 0.0 else inf
                        v32 = 42.0 + asinh(v16)
                        v33 = v18 if v18 < v32 or v18 != v18 else v32
                        v51 = b * b
                        v56 = v15 / v16
                        v58 = v56 * v56
                        v69 = []
                        for node, weight in RULE_0(v33 / 1.0):
                            v35 = node * v33
                            v43 = exp(-v35) * (0.0 - expm1(-2.0 * (v18 - v35))) / v29
                            v44 = v16 * v43
                            v46 = 1.0 + v44 * v44
                            v50 = v9 * v43 * (v22 / sqrt(v46))
                            v54 = sqrt(v51 + v50 * v50)
                            v68 = v54 * atan(v50 / b) / R * (v50 / v54 * (sqrt(v58 + v43 * v43) / v46))
                            v69.append(weight * v68)
                        v69 = fsum(v69) * v33
                        v71 = v16 * v69
                    else:
                        v71 = 0.0
                    value = -0.6366197723675814 * v71
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, R, b):
                        return value
                    return None
                return -((x - b) / R if x > b else 0.0)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_profile', 1, 'x', 'R', 'b'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 1, (), False),
        ('x', 'R', 'b'): (('x', 'R', 'b'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
}
