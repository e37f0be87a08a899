"""Programs of axicontact.adhesive.truncated_cone."""

from __future__ import annotations

from math import asinh, atan, atan2, exp, expm1, fsum, inf, nan, nextafter, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.adhesive import truncated_cone as bodies

C0 = np.array(6.283185307179586)
C1 = np.array(2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def depth(a, theta, b, E_star, dgamma):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            return tan(theta) * a * atan(sqrt((a - b) * (a + b)) / b) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta, b, E_star, dgamma):
    v11 = np.tan(theta)
    v16 = (6.283185307179586) * dgamma
    v17 = v16 / E_star
    v18 = np.sqrt(v17)
    return (b, v11, v18)


def block_depth_a(out, a, b, v11, v18, t0):
    np.subtract(a, b, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(a, b, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.divide(t0, b, t0)
    np.arctan(t0, t0)
    np.multiply(v11, a, out)
    np.multiply(out, t0, t0)
    np.sqrt(a, out)
    np.multiply(out, v18, out)
    np.subtract(t0, out, out)


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta, b, E_star, dgamma, t0, t1):
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
    np.multiply(out, t0, t0)
    np.sqrt(a, out)
    np.multiply(C0, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def displacement(r, a, theta, b, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            v18 = r - a
            v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (r + a))
            v89 = r > a
            if a >= b:
                v6 = r - b
                v13 = a - b
                v15 = a + b
                v62 = tan(theta)
                if v89:
                    if a > b:
                        v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (r + b))
                        v12 = b / r
                        v23 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * v15) / v22
                        v25 = asinh(v23 / v12)
                        v30 = 0.0 - expm1(-2.0 * v25)
                        v33 = v30 if v30 > 0.0 else inf
                        v50 = b * b
                        v54 = v12 * v12
                        v64 = b * v62
                        v73 = []
                        for node, weight in RULE_0(v25 / 1.0):
                            v35 = node * v25
                            v44 = v23 * (exp(-v35) * (0.0 - expm1(-2.0 * (v25 - v35))) / v33)
                            v45 = v44 * v44
                            v47 = sqrt(1.0 + v45)
                            v49 = v11 * v44 / v47
                            v53 = sqrt(v50 + v49 * v49)
                            v72 = (v62 * atan(v49 / b) + v64 / v49) * v49 / v53 * atan2(v53, v11 / v47) * (sqrt(v54 + v45) / (v47 * v47 * v47))
                            v73.append(weight * v72)
                        v73 = fsum(v73) * v25
                        v75 = v11 * v73
                    else:
                        v75 = 0.0
                    v90 = 0.6366197723675814 * v75
                else:
                    v90 = v62 * a * atan(sqrt(v13 * v15) / b) - (0.0 if r < b else v62 * v6)
                v92 = v90
            else:
                v92 = nan
            value = v92 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star) * (0.6366197723675814 * atan2(a, v22) if v89 else 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, b, E_star, dgamma):
    if a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            v8 = sqrt((a - b) * (a + b))
            return E_star * tan(theta) * (a * a * atan(v8 / b) + b * v8) - 2.0 * E_star * a * (sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, b, E_star, dgamma):
    v11 = np.tan(theta)
    v12 = E_star * v11
    v19 = (2.0) * E_star
    v23 = (6.283185307179586) * dgamma
    v24 = v23 / E_star
    v25 = np.sqrt(v24)
    return (b, v12, v19, v25)


def block_force_a(out, a, b, v12, v19, v25, t0, t1):
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
    np.multiply(v12, t0, t0)
    np.multiply(v19, a, out)
    np.sqrt(a, t1)
    np.multiply(t1, v25, t1)
    np.multiply(out, t1, t1)
    np.subtract(t0, t1, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, b, E_star, dgamma, t0, t1, t2):
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
    np.multiply(t1, t0, t0)
    np.multiply(C1, E_star, t1)
    np.multiply(t1, a, t1)
    np.sqrt(a, out)
    np.multiply(C0, dgamma, t2)
    np.divide(t2, E_star, t2)
    np.sqrt(t2, t2)
    np.multiply(out, t2, t2)
    np.multiply(t1, t2, t2)
    np.subtract(t0, t2, out)


def pressure(r, a, theta, b, E_star, dgamma):
    if r.__class__ is a.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (b <= a):
        try:
            if a >= b:
                if r < a:
                    v6 = r == b
                    if v6 and a > b:
                        v75 = inf
                    else:
                        v9 = nextafter(b, inf) if v6 else r
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
                            v61 = tan(theta)
                            v63 = b * v61
                            v68 = []
                            for node, weight in RULE_0(v31 / 1.0):
                                v44 = node * v31
                                v54 = v18 * (exp(-v44) * (v33 - v34 * expm1(-2.0 * (v31 - v44))) / v41)
                                v67 = (v61 * atan(v54 / b) + v63 / v54) * v54 / sqrt(v55 + v54 * v54)
                                v68.append(weight * v67)
                            v68 = fsum(v68) * v31
                            v69 = v68
                        else:
                            v69 = 0.0
                        v75 = E_star / 3.141592653589793 * v69
                    v77 = v75
                else:
                    v77 = 0.0
                v80 = v77
            else:
                v80 = nan
            if r <= a:
                v86 = sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
                if v86 > 0.0:
                    v89 = a - r
                    v96 = E_star * v86 / (3.141592653589793 * sqrt((v89 if v89 > 0.0 or v89 != v89 else 0.0) * (a + r)))
                else:
                    v96 = 0.0
                v98 = v96
            else:
                v98 = 0.0
            value = v80 - v98
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, b, E_star, dgamma):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(theta, b, E_star, dgamma, control):
    if theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and theta > 1e-30 and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(theta, b, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, theta, b, E_star, dgamma):
    if d.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, b, E_star, dgamma):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, b, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, theta, b, E_star):
    if F.__class__ is theta.__class__ is b.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, theta, b, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, b, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_depth', 1, 'a', 'theta', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 1, 0, (), False),
        ('a', 'theta', 'b', 'E_star', 'dgamma'): (('a', 'theta', 'b', 'E_star', 'dgamma'), prepare_depth_all, block_depth_all, 2, 0, (), False),
    },
    ('_force', 1, 'a', 'theta', 'b', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 2, 0, (), False),
        ('a', 'theta', 'b', 'E_star', 'dgamma'): (('a', 'theta', 'b', 'E_star', 'dgamma'), prepare_force_all, block_force_all, 3, 0, (), False),
    },
}
