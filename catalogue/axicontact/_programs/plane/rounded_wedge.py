"""Programs of axicontact.plane.rounded_wedge."""

from __future__ import annotations

from math import asinh, atan, exp, expm1, fsum, inf, log1p, nan, nextafter, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.plane import rounded_wedge as bodies

C0 = np.array(2.0)
C1 = np.array(3.141592653589793)
C2 = np.array(4.0)
C3 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(L, a, theta, b):
    if L.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and L > 1e-30 and (L < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            if a <= L:
                if a > 0.0:
                    v9 = tan(theta)
                    v12 = v9 / (2.0 * b)
                    v52 = a > b
                    if a < L:
                        v4 = a if a < b or a != a else b
                        v5 = L - v4
                        v8 = sqrt(v5 * (v4 + L))
                        if v52:
                            v22 = a - b
                            v27 = sqrt((v22 if v22 > 0.0 or v22 != v22 else 0.0) * (a + b))
                            v28 = L - a
                            v32 = sqrt((v28 if v28 > 0.0 or v28 != v28 else 0.0) * (L + a))
                            v33 = b / L
                            v34 = v27 / v32
                            v36 = asinh(v34 / v33)
                            v40 = sqrt(1.0 + v34 * v34)
                            v44 = 0.0 - expm1(-2.0 * v36)
                            v47 = v44 if v44 > 0.0 else inf
                            v50 = 42.0 + asinh(v34)
                            v51 = v36 if v36 < v50 or v36 != v36 else v50
                            v69 = b * b
                            v74 = v33 / v34
                            v75 = v74 * v74
                            v83 = v9 / b
                            v92 = []
                            for node, weight in RULE_0(v51 / 1.0):
                                v53 = node * v51
                                v61 = exp(-v53) * (0.0 - expm1(-2.0 * (v36 - v53))) / v47
                                v62 = v34 * v61
                                v64 = 1.0 + v62 * v62
                                v66 = v40 / sqrt(v64)
                                v68 = v27 * v61 * v66
                                v72 = sqrt(v69 + v68 * v68)
                                v91 = v83 * v72 * atan(b / v68) * (v68 / v72 * (sqrt(v75 + v61 * v61) / v64)) * v66 * asinh(v32 * v66 / v72)
                                v92.append(weight * v91)
                            v92 = fsum(v92) * v51
                            v94 = v27 * v92
                        else:
                            v94 = 0.0
                        value = v12 * (v4 * v4) * (L / (v8 + L) + log1p((v5 + v8) / v4)) + 0.6366197723675814 * v94
                        if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                            return value
                        if value != value and ordinary(L, a, theta, b):
                            return value
                        return None
                    if v52:
                        return v9 * (a - b / 2.0)
                    return v12 * (a * a)
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def half_width_from_load(P, theta, b, E_star):
    if P.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and P > 1e-30 and (P < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._half_width_from_load(P, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(P, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v6 = tan(theta)
            v12 = a * a
            if a < b:
                return 3.141592653589793 * E_star * v6 / (4.0 * b) * v12
            v17 = sqrt((a - b) * (a + b))
            return E_star * v6 * (v17 + v12 * atan(b / v17) / b) / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_a(theta, b, E_star):
    v5 = (3.141592653589793) * E_star
    v6 = np.tan(theta)
    v7 = v5 * v6
    v9 = (4.0) * b
    v10 = v7 / v9
    v20 = E_star * v6
    v26 = v20 * (0.5)
    return (b, v10, v26)


def block_load_a(out, a, b, v10, v26, t0, t1, t2, m0):
    size = out.size
    np.square(a, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, b, m0)
    some29 = np.count_nonzero(m0)
    if some29:
        np.multiply(v10, t0, out)
    if some29 != size:
        other29 = t1 if some29 else out
        np.subtract(a, b, other29)
        np.add(a, b, t2)
        np.multiply(other29, t2, t2)
        np.sqrt(t2, t2)
        np.divide(b, t2, other29)
        np.arctan(other29, other29)
        np.multiply(t0, other29, other29)
        np.divide(other29, b, other29)
        np.add(t2, other29, other29)
        np.multiply(v26, other29, other29)
        if some29:
            np.copyto(out, other29, where=~m0)


def prepare_load_all():
    return ()


def block_load_all(out, a, theta, b, E_star, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.tan(theta, t0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(a, t1)
    np.less(a, b, m0)
    some28 = np.count_nonzero(m0)
    if some28:
        np.multiply(C1, E_star, out)
        np.multiply(out, t0, out)
        np.multiply(C2, b, t2)
        np.divide(out, t2, t2)
        np.multiply(t2, t1, out)
    if some28 != size:
        other28 = t2 if some28 else out
        np.subtract(a, b, other28)
        np.add(a, b, t3)
        np.multiply(other28, t3, t3)
        np.sqrt(t3, t3)
        np.divide(b, t3, other28)
        np.arctan(other28, other28)
        np.multiply(E_star, t0, t4)
        np.multiply(t1, other28, other28)
        np.divide(other28, b, other28)
        np.add(t3, other28, other28)
        np.multiply(t4, other28, other28)
        np.multiply(other28, C3, other28)
        if some28:
            np.copyto(out, other28, where=~m0)


def pressure(x, a, theta, b, E_star):
    if x.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if x < a:
                v5 = a if a < b or a != a else b
                v10 = tan(theta)
                v19 = nextafter(b, inf) if x == b else x
                if a > (v19 if v19 > b or v19 != v19 else b):
                    v20 = v19 < b
                    v24 = a - b
                    v28 = sqrt((v24 if v24 > 0.0 or v24 != v24 else 0.0) * (a + b))
                    if v20:
                        v34 = v28
                    else:
                        v29 = a - v19
                        v34 = sqrt((v29 if v29 > 0.0 or v29 != v29 else 0.0) * (a + v19))
                    v41 = asinh(v34 / sqrt(abs(v19 - b) * (v19 + b)))
                    v42 = 2.0 * (0.0 if v20 else 1.0)
                    v43 = 1.0 - v42
                    v48 = v42 - v43 * expm1(-2.0 * v41)
                    v50 = v48 if v48 > 0.0 else inf
                    v64 = b * b
                    v70 = v10 / b
                    v75 = []
                    for node, weight in RULE_0(v41 / 1.0):
                        v53 = node * v41
                        v63 = v28 * (exp(-v53) * (v42 - v43 * expm1(-2.0 * (v41 - v53))) / v50)
                        v67 = sqrt(v64 + v63 * v63)
                        v74 = v70 * v67 * atan(b / v63) * v63 / v67
                        v75.append(weight * v74)
                    v75 = fsum(v75) * v41
                    v76 = v75
                else:
                    v76 = 0.0
                value = (E_star * v10 / (2.0 * b) * sqrt((v5 - x) * (v5 + x)) if x < v5 else 0.0) + E_star / 3.141592653589793 * v76
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, theta, b, E_star):
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(x, theta, b):
    if x.__class__ is theta.__class__ is b.__class__ is float and x > 1e-30 and (x < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            v4 = tan(theta)
            if x > b:
                return v4 * (x - b / 2.0)
            return v4 / (2.0 * b) * (x * x)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(theta, b):
    v4 = np.tan(theta)
    v6 = b / (2.0)
    v9 = (2.0) * b
    v10 = v4 / v9
    return (b, v4, v6, v10)


def block_profile_x(out, x, b, v4, v6, v10, t0, m0):
    size = out.size
    np.greater(x, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some13 = np.count_nonzero(m0)
    if some13:
        np.subtract(x, v6, out)
        np.multiply(v4, out, out)
    if some13 != size:
        other13 = t0 if some13 else out
        np.square(x, other13)
        np.multiply(v10, other13, other13)
        if some13:
            np.copyto(out, other13, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, theta, b, t0, t1, t2, m0):
    size = out.size
    np.greater(x, b, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    some14 = np.count_nonzero(m0)
    if some14:
        np.multiply(b, C3, out)
        np.subtract(x, out, out)
        np.multiply(t0, out, out)
    if some14 != size:
        other14 = t1 if some14 else out
        np.multiply(C0, b, other14)
        np.divide(t0, other14, other14)
        np.square(x, t2)
        np.multiply(other14, t2, other14)
        if some14:
            np.copyto(out, other14, where=~m0)


def slope(x, a, theta, b):
    if x.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            v10 = tan(theta)
            v78 = v10 / b
            if x > a:
                v4 = a if a < b or a != a else b
                if a > b:
                    v17 = a - b
                    v22 = sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * (a + b))
                    v23 = x - a
                    v28 = b / x
                    v29 = v22 / sqrt((v23 if v23 > 0.0 or v23 != v23 else 0.0) * (x + a))
                    v31 = asinh(v29 / v28)
                    v35 = sqrt(1.0 + v29 * v29)
                    v39 = 0.0 - expm1(-2.0 * v31)
                    v42 = v39 if v39 > 0.0 else inf
                    v45 = 42.0 + asinh(v29)
                    v46 = v31 if v31 < v45 or v31 != v31 else v45
                    v64 = b * b
                    v69 = v28 / v29
                    v70 = v69 * v69
                    v82 = []
                    for node, weight in RULE_0(v46 / 1.0):
                        v48 = node * v46
                        v56 = exp(-v48) * (0.0 - expm1(-2.0 * (v31 - v48))) / v42
                        v57 = v29 * v56
                        v59 = 1.0 + v57 * v57
                        v63 = v22 * v56 * (v35 / sqrt(v59))
                        v67 = sqrt(v64 + v63 * v63)
                        v81 = v78 * v67 * atan(b / v63) * (v63 / v67 * (sqrt(v70 + v56 * v56) / v59))
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v46
                    v84 = v29 * v82
                else:
                    v84 = 0.0
                value = -v10 * (v4 * v4) / (b * (sqrt((x - v4) * (v4 + x)) + x)) - 0.6366197723675814 * v84
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and x > a)) and ordinary(x, a, theta, b):
                    return value
                return None
            return -(v10 if x > b else v78 * x)
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_load', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_load_a, block_load_a, 3, 1, (), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_load_all, block_load_all, 5, 1, (), False),
    },
    ('_profile', 1, 'x', 'theta', 'b'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 1, 1, (), False),
        ('x', 'theta', 'b'): (('x', 'theta', 'b'), prepare_profile_all, block_profile_all, 3, 1, (), False),
    },
}
