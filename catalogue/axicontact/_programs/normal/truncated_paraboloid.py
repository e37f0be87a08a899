"""Programs of axicontact.normal.truncated_paraboloid."""

from __future__ import annotations

from math import asinh, atan2, exp, expm1, fsum, inf, nan, nextafter, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import truncated_paraboloid as bodies

C0 = np.array(2.0)
C1 = np.array(3.0)
C2 = np.array(9.42477796076938)
C3 = np.array(4.0)
C4 = np.array(0.0)
C5 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, R, b):
    if a.__class__ is R.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            return a * sqrt((a - b) * (a + b)) / R
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(R, b):
    return (R, b)


def block_depth_a(out, a, R, b, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(a, t0, t0)
    np.divide(t0, R, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, R, b, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(a, t0, t0)
    np.divide(t0, R, out)


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
                v7 = r + b
                v11 = a - b
                v13 = a + b
                if r > a:
                    if a > b:
                        v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * v7)
                        v10 = b / r
                        v16 = r - a
                        v21 = sqrt((v11 if v11 > 0.0 or v11 != v11 else 0.0) * v13) / sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * (r + a))
                        v23 = asinh(v21 / v10)
                        v28 = 0.0 - expm1(-2.0 * v23)
                        v31 = v28 if v28 > 0.0 else inf
                        v48 = b * b
                        v52 = v10 * v10
                        v61 = b * b
                        v71 = []
                        for node, weight in RULE_0(v23 / 1.0):
                            v33 = node * v23
                            v42 = v21 * (exp(-v33) * (0.0 - expm1(-2.0 * (v23 - v33))) / v31)
                            v43 = v42 * v42
                            v45 = sqrt(1.0 + v43)
                            v47 = v9 * v42 / v45
                            v51 = sqrt(v48 + v47 * v47)
                            v70 = (2.0 * v47 / R + v61 / (R * v47)) * v47 / v51 * atan2(v51, v9 / v45) * (sqrt(v52 + v43) / (v45 * v45 * v45))
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
                return a * sqrt(v11 * v13) / R - (0.0 if r < b else v4 * v7 / (2.0 * R))
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, R, b, E_star):
    if a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                v4 = a - b
                v5 = a + b
                v9 = a * sqrt(v4 * v5) / R
                if a > b:
                    v13 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * v5)
                    v15 = asinh(v13 / b)
                    v20 = 0.0 - expm1(-2.0 * v15)
                    v23 = v20 if v20 > 0.0 else inf
                    v35 = b * b
                    v44 = []
                    for node, weight in RULE_0(v15 / 1.0):
                        v25 = node * v15
                        v34 = v13 * (exp(-v25) * (0.0 - expm1(-2.0 * (v15 - v25))) / v23)
                        v41 = v9 - sqrt(v35 + v34 * v34) * v34 / R
                        v43 = v41 * v41 * v34
                        v44.append(weight * v43)
                    v44 = fsum(v44) * v15
                    v45 = v44
                else:
                    v45 = 0.0
                value = E_star * (b * v9 * v9 + v45)
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
            return 2.0 * E_star / (3.0 * R) * (2.0 * (a * a) + b * b) * sqrt((a - b) * (a + b))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(R, b, E_star):
    v9 = (2.0) * E_star
    v11 = (3.0) * R
    v12 = v9 / v11
    v15 = np.square(b)
    return (b, v12, v15)


def block_force_a(out, a, b, v12, v15, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.square(a, out)
    np.multiply(C0, out, out)
    np.add(out, v15, out)
    np.multiply(v12, out, out)
    np.multiply(out, t0, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, R, b, E_star, t0, t1, t2):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(C0, E_star, out)
    np.multiply(C1, R, t1)
    np.divide(out, t1, t1)
    np.square(a, out)
    np.multiply(C0, out, out)
    np.square(b, t2)
    np.add(out, t2, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t2, t0, out)


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
                v73 = b * b
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
                    v82 = []
                    for node, weight in RULE_0(v30 / 1.0):
                        v51 = node * v30
                        v53 = exp(-v51)
                        v56 = expm1(-2.0 * (v30 - v51))
                        v61 = v17 * (v53 * (v32 - v33 * v56) / v40)
                        v66 = v22 * (v53 * (v42 - v43 * v56) / v47)
                        v70 = sqrt(v67 + v61 * v61)
                        v81 = (2.0 * v61 / R + v73 / (R * v61)) * (v61 / v70) * (v66 / (v70 + v66))
                        v82.append(weight * v81)
                    v82 = fsum(v82) * v30
                    v84 = v8 * v8 * v82
                else:
                    v84 = 0.0
                v92 = 2.0 * E_star
                if r > b:
                    v86 = r if r < a or r != r else a
                    v87 = v86 if v86 > b or v86 != v86 else b
                    v101 = v92 / (3.0 * R) * (2.0 * (v87 * v87) + v73) * sqrt((v87 - b) * (v87 + b))
                else:
                    v101 = 0.0
                value = v101 + v92 * v84
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
            v7 = sqrt((a - b) * (a + b))
            return 4.0 * E_star / (9.42477796076938 * R) * v7 + 2.0 * E_star * (b * b) * v7 / (9.42477796076938 * (a * a) * R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(R, b, E_star):
    v9 = (4.0) * E_star
    v11 = (9.42477796076938) * R
    v12 = v9 / v11
    v15 = (2.0) * E_star
    v16 = np.square(b)
    v17 = v15 * v16
    return (R, b, v12, v17)


def block_mean_pressure_a(out, a, R, b, v12, v17, t0, t1):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(v12, t0, out)
    np.multiply(v17, t0, t0)
    np.square(a, t1)
    np.multiply(C2, t1, t1)
    np.multiply(t1, R, t1)
    np.divide(t0, t1, t1)
    np.add(out, t1, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, R, b, E_star, t0, t1, t2):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.multiply(C3, E_star, out)
    np.multiply(C2, R, t1)
    np.divide(out, t1, t1)
    np.multiply(t1, t0, t1)
    np.multiply(C0, E_star, out)
    np.square(b, t2)
    np.multiply(out, t2, t2)
    np.multiply(t2, t0, t0)
    np.square(a, t2)
    np.multiply(C2, t2, t2)
    np.multiply(t2, R, t2)
    np.divide(t0, t2, t2)
    np.add(t1, t2, out)


def pressure(r, a, R, b, E_star):
    if r.__class__ is a.__class__ is R.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                if r < a:
                    v5 = r == b
                    if v5 and a > b:
                        return inf
                    v8 = nextafter(b, inf) if v5 else r
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
                        v60 = b * b
                        v66 = []
                        for node, weight in RULE_0(v30 / 1.0):
                            v43 = node * v30
                            v53 = v17 * (exp(-v43) * (v32 - v33 * expm1(-2.0 * (v30 - v43))) / v40)
                            v65 = (2.0 * v53 / R + v60 / (R * v53)) * v53 / sqrt(v54 + v53 * v53)
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
            return (r - b) * (r + b) / (2.0 * R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(R, b):
    v8 = (2.0) * R
    return (b, v8)


def block_profile_r(out, r, b, v8, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.copyto(out, C4)
    if some11 != size:
        other11 = t0 if some11 else out
        np.subtract(r, b, other11)
        np.add(r, b, t1)
        np.multiply(other11, t1, t1)
        np.divide(t1, v8, other11)
        if some11:
            np.copyto(out, other11, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, R, b, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.copyto(out, C4)
    if some11 != size:
        other11 = t0 if some11 else out
        np.subtract(r, b, other11)
        np.add(r, b, t1)
        np.multiply(other11, t1, t1)
        np.multiply(C0, R, other11)
        np.divide(t1, other11, other11)
        if some11:
            np.copyto(out, other11, where=~m0)


def radius_from_depth(d, R, b):
    if d.__class__ is R.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30):
        try:
            v5 = b * b
            return sqrt(sqrt(v5 * v5 + 4.0 * (R * R) * (d * d)) / R + v5 / R) * sqrt(2.0 * R) / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_depth_d(R, b):
    v5 = np.square(b)
    v6 = np.square(v5)
    v7 = np.square(R)
    v8 = (4.0) * v7
    v14 = v5 / R
    v17 = (2.0) * R
    v18 = np.sqrt(v17)
    v21 = v18 * (0.5)
    return (R, v6, v8, v14, v21)


def block_radius_from_depth_d(out, d, R, v6, v8, v14, v21):
    np.square(d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(v8, out, out)
    np.add(v6, out, out)
    np.sqrt(out, out)
    np.divide(out, R, out)
    np.add(out, v14, out)
    np.sqrt(out, out)
    np.multiply(out, v21, out)


def prepare_radius_from_depth_all():
    return ()


def block_radius_from_depth_all(out, d, R, b, t0, t1, t2):
    np.square(b, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.square(out, t0)
    np.square(R, t1)
    np.multiply(C3, t1, t1)
    np.square(d, t2)
    np.multiply(t1, t2, t2)
    np.add(t0, t2, t2)
    np.sqrt(t2, t2)
    np.divide(t2, R, t2)
    np.divide(out, R, out)
    np.add(t2, out, out)
    np.sqrt(out, out)
    np.multiply(C0, R, t2)
    np.sqrt(t2, t2)
    np.multiply(out, t2, t2)
    np.multiply(t2, C5, out)


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
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'R', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'R', 'b'): (('a', 'R', 'b'), prepare_depth_all, block_depth_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'R', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 1, 0, (), False),
        ('a', 'R', 'b', 'E_star'): (('a', 'R', 'b', 'E_star'), prepare_force_all, block_force_all, 3, 0, (), False),
    },
    ('_mean_pressure', 1, 'a', 'R', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 2, 0, (), False),
        ('a', 'R', 'b', 'E_star'): (('a', 'R', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 3, 0, (), False),
    },
    ('_profile', 1, 'r', 'R', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 2, 1, (), False),
        ('r', 'R', 'b'): (('r', 'R', 'b'), prepare_profile_all, block_profile_all, 2, 1, (), False),
    },
    ('_radius_from_depth', 1, 'd', 'R', 'b'): {
        ('d',): (('d',), prepare_radius_from_depth_d, block_radius_from_depth_d, 0, 0, (), False),
        ('d', 'R', 'b'): (('d', 'R', 'b'), prepare_radius_from_depth_all, block_radius_from_depth_all, 3, 0, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
