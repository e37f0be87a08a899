"""Programs of axicontact.normal.truncated_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, nextafter, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.normal import truncated_cone as bodies

C0 = np.array(2.0)
C1 = np.array(3.141592653589793)
C2 = np.array(0.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, theta, b):
    if a.__class__ is theta.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            return tan(theta) * a * atan(sqrt((a - b) * (a + b)) / b)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, b):
    v9 = np.tan(theta)
    return (b, v9)


def block_depth_a(out, a, b, v9, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, t0)
    np.arctan(t0, t0)
    np.multiply(v9, a, out)
    np.multiply(out, t0, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, t0)
    np.arctan(t0, t0)
    np.tan(theta, out)
    np.multiply(out, a, out)
    np.multiply(out, t0, out)


def depth_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._depth_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, theta, b):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (b <= a):
        try:
            if a >= b:
                v4 = r - b
                v11 = a - b
                v13 = a + b
                v60 = tan(theta)
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
                        v62 = b * v60
                        v71 = []
                        for node, weight in RULE_0(v23 / 1.0):
                            v33 = node * v23
                            v42 = v21 * (exp(-v33) * (0.0 - expm1(-2.0 * (v23 - v33))) / v31)
                            v43 = v42 * v42
                            v45 = sqrt(1.0 + v43)
                            v47 = v9 * v42 / v45
                            v51 = sqrt(v48 + v47 * v47)
                            v70 = (v60 * atan(v47 / b) + v62 / v47) * v47 / v51 * atan2(v51, v9 / v45) * (sqrt(v52 + v43) / (v45 * v45 * v45))
                            v71.append(weight * v70)
                        v71 = fsum(v71) * v23
                        v73 = v9 * v71
                    else:
                        v73 = 0.0
                    value = 0.6366197723675814 * v73
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b):
                        return value
                    return None
                return v60 * a * atan(sqrt(v11 * v13) / b) - (0.0 if r < b else v60 * v4)
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                v4 = a - b
                v5 = a + b
                v10 = tan(theta)
                v12 = v10 * a * atan(sqrt(v4 * v5) / b)
                if a > b:
                    v16 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * v5)
                    v18 = asinh(v16 / b)
                    v23 = 0.0 - expm1(-2.0 * v18)
                    v26 = v23 if v23 > 0.0 else inf
                    v38 = b * b
                    v49 = []
                    for node, weight in RULE_0(v18 / 1.0):
                        v28 = node * v18
                        v37 = v16 * (exp(-v28) * (0.0 - expm1(-2.0 * (v18 - v28))) / v26)
                        v46 = v12 - v10 * sqrt(v38 + v37 * v37) * atan(v37 / b)
                        v48 = v46 * v46 * v37
                        v49.append(weight * v48)
                    v49 = fsum(v49) * v18
                    v50 = v49
                else:
                    v50 = 0.0
                value = E_star * (b * v12 * v12 + v50)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(a, theta, b, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            v7 = sqrt((a - b) * (a + b))
            return E_star * tan(theta) * (a * a * atan(v7 / b) + b * v7)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, b, E_star):
    v10 = np.tan(theta)
    v11 = E_star * v10
    return (b, v11)


def block_force_a(out, a, b, v11, t0, t1):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, out)
    np.arctan(out, out)
    np.square(a, t1)
    np.multiply(t1, out, out)
    np.multiply(b, t0, t0)
    np.add(out, t0, t0)
    np.multiply(v11, t0, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, t0, t1, t2):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, out)
    np.arctan(out, out)
    np.tan(theta, t1)
    np.multiply(E_star, t1, t1)
    np.square(a, t2)
    np.multiply(t2, out, out)
    np.multiply(b, t0, t0)
    np.add(out, t0, t0)
    np.multiply(t1, t0, out)


def force_from_depth(d, theta, b, E_star):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._force_from_depth(d, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, theta, b, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            if a >= b:
                v8 = nextafter(b, inf) if r == b else r
                v73 = tan(theta)
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
                    v75 = b * v73
                    v83 = []
                    for node, weight in RULE_0(v30 / 1.0):
                        v51 = node * v30
                        v53 = exp(-v51)
                        v56 = expm1(-2.0 * (v30 - v51))
                        v61 = v17 * (v53 * (v32 - v33 * v56) / v40)
                        v66 = v22 * (v53 * (v42 - v43 * v56) / v47)
                        v70 = sqrt(v67 + v61 * v61)
                        v82 = (v73 * atan(v61 / b) + v75 / v61) * (v61 / v70) * (v66 / (v70 + v66))
                        v83.append(weight * v82)
                    v83 = fsum(v83) * v30
                    v85 = v8 * v8 * v83
                else:
                    v85 = 0.0
                if r > b:
                    v87 = r if r < a or r != r else a
                    v88 = v87 if v87 > b or v87 != v87 else b
                    v92 = sqrt((v88 - b) * (v88 + b))
                    v101 = E_star * v73 * (v88 * v88 * atan(v92 / b) + b * v92)
                else:
                    v101 = 0.0
                value = v101 + 2.0 * E_star * v85
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star):
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, theta, b, E_star):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
        try:
            v7 = sqrt((a - b) * (a + b))
            return E_star * tan(theta) / 3.141592653589793 * (atan(v7 / b) + b * v7 / (a * a))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(theta, b, E_star):
    v10 = np.tan(theta)
    v11 = E_star * v10
    v13 = v11 / (3.141592653589793)
    return (b, v13)


def block_mean_pressure_a(out, a, b, v13, t0, t1):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, out)
    np.arctan(out, out)
    np.multiply(b, t0, t0)
    np.square(a, t1)
    np.divide(t0, t1, t1)
    np.add(out, t1, t1)
    np.multiply(v13, t1, out)


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, theta, b, E_star, t0, t1, t2):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, out)
    np.arctan(out, out)
    np.tan(theta, t1)
    np.multiply(E_star, t1, t1)
    np.divide(t1, C1, t1)
    np.multiply(b, t0, t0)
    np.square(a, t2)
    np.divide(t0, t2, t2)
    np.add(out, t2, t2)
    np.multiply(t1, t2, out)


def pressure(r, a, theta, b, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (b <= a):
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
                        v60 = tan(theta)
                        v62 = b * v60
                        v67 = []
                        for node, weight in RULE_0(v30 / 1.0):
                            v43 = node * v30
                            v53 = v17 * (exp(-v43) * (v32 - v33 * expm1(-2.0 * (v30 - v43))) / v40)
                            v66 = (v60 * atan(v53 / b) + v62 / v53) * v53 / sqrt(v54 + v53 * v53)
                            v67.append(weight * v66)
                        v67 = fsum(v67) * v30
                        v68 = v67
                    else:
                        v68 = 0.0
                    value = E_star / 3.141592653589793 * v68
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star):
                        return value
                    return None
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, theta, b):
    if r.__class__ is theta.__class__ is b.__class__ is float and r > 1e-30 and (r < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            if r < b:
                return 0.0
            return tan(theta) * (r - b)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(theta, b):
    v4 = np.tan(theta)
    return (b, v4)


def block_profile_r(out, r, b, v4, t0, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, C2)
    if some8 != size:
        other8 = t0 if some8 else out
        np.subtract(r, b, other8)
        np.multiply(v4, other8, other8)
        if some8:
            np.copyto(out, other8, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, theta, b, t0, t1, m0):
    size = out.size
    np.less(r, b, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some8 = np.count_nonzero(m0)
    if some8:
        np.copyto(out, C2)
    if some8 != size:
        other8 = t0 if some8 else out
        np.tan(theta, other8)
        np.subtract(r, b, t1)
        np.multiply(other8, t1, other8)
        if some8:
            np.copyto(out, other8, where=~m0)


def radius_from_depth(d, theta, b):
    if d.__class__ is theta.__class__ is b.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, theta, b):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star, theta=0.7853981633974483, b=1.0):
    if a.__class__ is E_star.__class__ is theta.__class__ is b.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (b <= a):
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
    ('_depth', 1, 'a', 'theta', 'b'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'theta', 'b'): (('a', 'theta', 'b'), prepare_depth_all, block_depth_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 0, (), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_force_all, block_force_all, 3, 0, (), False),
    },
    ('_mean_pressure', 1, 'a', 'theta', 'b', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 2, 0, (), False),
        ('a', 'theta', 'b', 'E_star'): (('a', 'theta', 'b', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 3, 0, (), False),
    },
    ('_profile', 1, 'r', 'theta', 'b'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 1, 1, (), False),
        ('r', 'theta', 'b'): (('r', 'theta', 'b'), prepare_profile_all, block_profile_all, 2, 1, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
