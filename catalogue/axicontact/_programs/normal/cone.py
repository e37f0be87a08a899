"""Programs of axicontact.normal.cone."""

from __future__ import annotations

from math import atan, log1p, sqrt, tan

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(3.141592653589793)
C1 = np.array(0.5)
C2 = np.array(2.0)
C3 = np.array(9.869604401089358)
C4 = np.array(12.0)
C5 = np.array(0.0)


def depth(a, theta):
    if a.__class__ is theta.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            return 3.141592653589793 * tan(theta) * a / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_a(theta):
    v2 = np.tan(theta)
    v4 = (3.141592653589793) * v2
    v8 = v4 * (0.5)
    return (v8,)


def block_depth_a(out, a, v8):
    np.multiply(v8, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_depth_all():
    return ()


def block_depth_all(out, a, theta):
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C0, out, out)
    np.multiply(out, a, out)
    np.multiply(out, C1, out)


def depth_from_force(F, theta, E_star):
    if F.__class__ is theta.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return sqrt(3.141592653589793 * tan(theta) / (2.0 * E_star) * F)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(theta, E_star):
    v3 = np.tan(theta)
    v5 = (3.141592653589793) * v3
    v7 = (2.0) * E_star
    v8 = v5 / v7
    return (v8,)


def block_depth_from_force_F(out, F, v8):
    np.multiply(v8, F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.sqrt(out, out)


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, theta, E_star, t0):
    np.tan(theta, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C0, out, out)
    np.multiply(C2, E_star, t0)
    np.divide(out, t0, t0)
    np.multiply(t0, F, t0)
    np.sqrt(t0, out)


def displacement(r, a, theta):
    if r.__class__ is a.__class__ is theta.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            v3 = tan(theta)
            if r > a:
                v10 = a / (r + sqrt((r - a) * (r + a)))
                return v3 * a * (2.0 * atan(v10) - v10)
            return 3.141592653589793 * v3 * a / 2.0 - v3 * r
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, theta):
    v3 = np.tan(theta)
    v4 = v3 * a
    v17 = (3.141592653589793) * v3
    v18 = v17 * a
    v19 = v18 / (2.0)
    return (a, v3, v4, v19)


def block_displacement_r(out, r, a, v3, v4, v19, t0, m0):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some23 = np.count_nonzero(m0)
    if some23:
        np.subtract(r, a, out)
        np.add(r, a, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(r, t0, t0)
        np.divide(a, t0, t0)
        np.arctan(t0, out)
        np.multiply(C2, out, out)
        np.subtract(out, t0, t0)
        np.multiply(v4, t0, out)
    if some23 != size:
        other23 = t0 if some23 else out
        np.multiply(v3, r, other23)
        np.subtract(v19, other23, other23)
        if some23:
            np.copyto(out, other23, where=~m0)


def prepare_displacement_r_a(theta):
    v3 = np.tan(theta)
    v17 = (3.141592653589793) * v3
    v20 = v17 * (0.5)
    return (v3, v20)


def block_displacement_r_a(out, r, a, v3, v20, t0, t1, m0):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some25 = np.count_nonzero(m0)
    if some25:
        np.multiply(v3, a, out)
        np.subtract(r, a, t0)
        np.add(r, a, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.add(r, t1, t1)
        np.divide(a, t1, t1)
        np.arctan(t1, t0)
        np.multiply(C2, t0, t0)
        np.subtract(t0, t1, t1)
        np.multiply(out, t1, out)
    if some25 != size:
        other25 = t1 if some25 else out
        np.multiply(v20, a, other25)
        np.multiply(v3, r, t0)
        np.subtract(other25, t0, other25)
        if some25:
            np.copyto(out, other25, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, theta, t0, t1, t2, m0):
    size = out.size
    np.tan(theta, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater(r, a, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.multiply(t0, a, out)
        np.subtract(r, a, t1)
        np.add(r, a, t2)
        np.multiply(t1, t2, t2)
        np.sqrt(t2, t2)
        np.add(r, t2, t2)
        np.divide(a, t2, t2)
        np.arctan(t2, t1)
        np.multiply(C2, t1, t1)
        np.subtract(t1, t2, t2)
        np.multiply(out, t2, out)
    if some24 != size:
        other24 = t2 if some24 else out
        np.multiply(C0, t0, other24)
        np.multiply(other24, a, other24)
        np.multiply(other24, C1, other24)
        np.multiply(t0, r, t1)
        np.subtract(other24, t1, other24)
        if some24:
            np.copyto(out, other24, where=~m0)


def energy(a, theta, E_star):
    if a.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = tan(theta)
            return 9.869604401089358 * E_star * (v5 * v5) / 12.0 * (a * (a * a))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_a(theta, E_star):
    v4 = (9.869604401089358) * E_star
    v5 = np.tan(theta)
    v7 = np.square(v5)
    v8 = v4 * v7
    v10 = v8 / (12.0)
    return (v10,)


def block_energy_a(out, a, v10):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, out)
    np.multiply(v10, out, out)


def prepare_energy_all():
    return ()


def block_energy_all(out, a, theta, E_star, t0):
    np.multiply(C3, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.square(t0, t0)
    np.multiply(out, t0, t0)
    np.divide(t0, C4, t0)
    np.square(a, out)
    np.multiply(a, out, out)
    np.multiply(t0, out, out)


def force(a, theta, E_star):
    if a.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 3.141592653589793 * E_star * tan(theta) * (a * a) / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_a(theta, E_star):
    v4 = (3.141592653589793) * E_star
    v5 = np.tan(theta)
    v6 = v4 * v5
    v11 = v6 * (0.5)
    return (v11,)


def block_force_a(out, a, v11):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v11, out, out)


def prepare_force_all():
    return ()


def block_force_all(out, a, theta, E_star, t0):
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(out, t0, t0)
    np.square(a, out)
    np.multiply(t0, out, out)
    np.multiply(out, C1, out)


def force_from_depth(d, theta, E_star):
    if d.__class__ is theta.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 2.0 * E_star / (3.141592653589793 * tan(theta)) * (d * d)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_from_depth_d(theta, E_star):
    v4 = (2.0) * E_star
    v5 = np.tan(theta)
    v7 = (3.141592653589793) * v5
    v8 = v4 / v7
    return (v8,)


def block_force_from_depth_d(out, d, v8):
    np.square(d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(v8, out, out)


def prepare_force_from_depth_all():
    return ()


def block_force_from_depth_all(out, d, theta, E_star, t0):
    np.multiply(C2, E_star, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(C0, t0, t0)
    np.divide(out, t0, t0)
    np.square(d, out)
    np.multiply(t0, out, out)


def load_within(r, a, theta, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v11 = 3.141592653589793 * E_star * tan(theta)
            if r < a:
                if r > 0.0:
                    v4 = a - r
                    v7 = sqrt(v4 * (a + r))
                    return v11 * (r * r) * (a / (v7 + a) + log1p((v4 + v7) / r)) / 2.0
                return 0.0
            return v11 * (a * a) / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(a, theta, E_star):
    v9 = (3.141592653589793) * E_star
    v10 = np.tan(theta)
    v11 = v9 * v10
    v28 = np.square(a)
    v29 = v11 * v28
    v30 = v29 / (2.0)
    return (a, v11, v30)


def block_load_within_r(out, r, a, v11, v30, t0, t1, t2, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some31 = np.count_nonzero(m0)
    if some31:
        np.greater(r, C5, m1)
        some27 = np.count_nonzero(m1)
        if some27:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, t1)
            np.multiply(v11, t1, t1)
            np.add(t0, a, t2)
            np.divide(a, t2, t2)
            np.add(out, t0, t0)
            np.divide(t0, r, t0)
            np.log1p(t0, t0)
            np.add(t2, t0, t0)
            np.multiply(t1, t0, t0)
            np.multiply(t0, C1, out)
        if some27 != size:
            np.copyto(out, C5, where=~m1)
    if some31 != size:
        np.copyto(out, v30, where=~m0)


def prepare_load_within_r_a(theta, E_star):
    v9 = (3.141592653589793) * E_star
    v10 = np.tan(theta)
    v11 = v9 * v10
    v30 = v11 * (0.5)
    return (v11, v30)


def block_load_within_r_a(out, r, a, v11, v30, t0, t1, t2, m0, m1):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some32 = np.count_nonzero(m0)
    if some32:
        np.greater(r, C5, m1)
        some27 = np.count_nonzero(m1)
        if some27:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, t1)
            np.multiply(v11, t1, t1)
            np.add(t0, a, t2)
            np.divide(a, t2, t2)
            np.add(out, t0, t0)
            np.divide(t0, r, t0)
            np.log1p(t0, t0)
            np.add(t2, t0, t0)
            np.multiply(t1, t0, t0)
            np.multiply(t0, C1, out)
        if some27 != size:
            np.copyto(out, C5, where=~m1)
    if some32 != size:
        other32 = t0 if some32 else out
        np.square(a, other32)
        np.multiply(v30, other32, other32)
        if some32:
            np.copyto(out, other32, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, a, theta, E_star, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.multiply(C0, E_star, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.tan(theta, t1)
    np.multiply(t0, t1, t1)
    np.less(r, a, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.greater(r, C5, m1)
        some27 = np.count_nonzero(m1)
        if some27:
            np.subtract(a, r, out)
            np.add(a, r, t0)
            np.multiply(out, t0, t0)
            np.sqrt(t0, t0)
            np.square(r, t2)
            np.multiply(t1, t2, t2)
            np.add(t0, a, t3)
            np.divide(a, t3, t3)
            np.add(out, t0, t0)
            np.divide(t0, r, t0)
            np.log1p(t0, t0)
            np.add(t3, t0, t0)
            np.multiply(t2, t0, t0)
            np.multiply(t0, C1, out)
        if some27 != size:
            np.copyto(out, C5, where=~m1)
    if some31 != size:
        other31 = t0 if some31 else out
        np.square(a, other31)
        np.multiply(t1, other31, other31)
        np.multiply(other31, C1, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def mean_pressure(a, theta, E_star):
    if a.__class__ is theta.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return E_star * tan(theta) / 2.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_mean_pressure_a(theta, E_star):
    v2 = np.tan(theta)
    v3 = E_star * v2
    v5 = v3 / (2.0)
    return (v5,)


def block_mean_pressure_a(out, a, v5):
    np.copyto(out, v5)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError


def prepare_mean_pressure_all():
    return ()


def block_mean_pressure_all(out, a, theta, E_star):
    np.tan(theta, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(E_star, out, out)
    np.multiply(out, C1, out)


def pressure(r, a, theta, E_star):
    if r.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r < a:
                v4 = a - r
                return E_star * tan(theta) * log1p((v4 + sqrt(v4 * (a + r))) / r) / 2.0
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(a, theta, E_star):
    v10 = np.tan(theta)
    v11 = E_star * v10
    v16 = v11 * (0.5)
    return (a, v16)


def block_pressure_r(out, r, a, v16, t0, f0):
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    if largest_r > a:
        np.maximum(out, f0, out=out)
    np.add(a, r, t0)
    np.multiply(out, t0, t0)
    np.sqrt(t0, t0)
    np.add(out, t0, t0)
    np.divide(t0, r, t0)
    np.log1p(t0, t0)
    np.multiply(v16, t0, out)


def prepare_pressure_r_a(theta, E_star):
    v9 = np.tan(theta)
    v10 = E_star * v9
    v17 = v10 * (0.5)
    return (v17,)


def block_pressure_r_a(out, r, a, v17, t0, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.add(out, t0, t0)
        np.divide(t0, r, t0)
        np.log1p(t0, t0)
        np.multiply(v17, t0, out)
    if some20 != size:
        np.copyto(out, C5, where=~m0)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, a, theta, E_star, t0, t1, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.tan(theta, t1)
        np.multiply(E_star, t1, t1)
        np.add(out, t0, t0)
        np.divide(t0, r, t0)
        np.log1p(t0, t0)
        np.multiply(t1, t0, t0)
        np.multiply(t0, C1, out)
    if some19 != size:
        np.copyto(out, C5, where=~m0)


def profile(r, theta):
    if r.__class__ is theta.__class__ is float and r > 1e-30 and (r < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            return tan(theta) * r
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(theta):
    v2 = np.tan(theta)
    return (v2,)


def block_profile_r(out, r, v2):
    np.multiply(v2, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError


def prepare_profile_all():
    return ()


def block_profile_all(out, r, theta):
    np.tan(theta, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.multiply(out, r, out)


def radius_from_depth(d, theta):
    if d.__class__ is theta.__class__ is float and d > 1e-30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
        try:
            return 2.0 * d / (3.141592653589793 * tan(theta))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_depth_d(theta):
    v4 = np.tan(theta)
    v6 = (3.141592653589793) * v4
    return (v6,)


def block_radius_from_depth_d(out, d, v6):
    np.multiply(C2, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.divide(out, v6, out)


def prepare_radius_from_depth_all():
    return ()


def block_radius_from_depth_all(out, d, theta, t0):
    np.multiply(C2, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(C0, t0, t0)
    np.divide(out, t0, out)


def radius_from_force(F, theta, E_star):
    if F.__class__ is theta.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return sqrt(2.0 * F / (3.141592653589793 * E_star * tan(theta)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_radius_from_force_F(theta, E_star):
    v6 = (3.141592653589793) * E_star
    v7 = np.tan(theta)
    v8 = v6 * v7
    return (v8,)


def block_radius_from_force_F(out, F, v8):
    np.multiply(C2, F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.divide(out, v8, out)
    np.sqrt(out, out)


def prepare_radius_from_force_all():
    return ()


def block_radius_from_force_all(out, F, theta, E_star, t0, t1):
    np.multiply(C2, F, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(C0, E_star, t0)
    np.tan(theta, t1)
    np.multiply(t0, t1, t1)
    np.divide(out, t1, t1)
    np.sqrt(t1, out)


def stiffness(a, E_star, theta=0.7853981633974483):
    if a.__class__ is E_star.__class__ is theta.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966):
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
    np.multiply(C2, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth', 1, 'a', 'theta'): {
        ('a',): (('a',), prepare_depth_a, block_depth_a, 0, 0, (), False),
        ('a', 'theta'): (('a', 'theta'), prepare_depth_all, block_depth_all, 0, 0, (), False),
    },
    ('_depth_from_force', 1, 'F', 'theta', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 0, 0, (), False),
        ('F', 'theta', 'E_star'): (('F', 'theta', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 1, 0, (), False),
    },
    ('_displacement', 2, 'r', 'a', 'theta'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 1, 1, (), False),
        ('r', 'a'): (('r', 'a'), prepare_displacement_r_a, block_displacement_r_a, 2, 1, (), False),
        ('r', 'a', 'theta'): (('r', 'a', 'theta'), prepare_displacement_all, block_displacement_all, 3, 1, (), False),
    },
    ('_energy', 1, 'a', 'theta', 'E_star'): {
        ('a',): (('a',), prepare_energy_a, block_energy_a, 0, 0, (), False),
        ('a', 'theta', 'E_star'): (('a', 'theta', 'E_star'), prepare_energy_all, block_energy_all, 1, 0, (), False),
    },
    ('_force', 1, 'a', 'theta', 'E_star'): {
        ('a',): (('a',), prepare_force_a, block_force_a, 0, 0, (), False),
        ('a', 'theta', 'E_star'): (('a', 'theta', 'E_star'), prepare_force_all, block_force_all, 1, 0, (), False),
    },
    ('_force_from_depth', 1, 'd', 'theta', 'E_star'): {
        ('d',): (('d',), prepare_force_from_depth_d, block_force_from_depth_d, 0, 0, (), False),
        ('d', 'theta', 'E_star'): (('d', 'theta', 'E_star'), prepare_force_from_depth_all, block_force_from_depth_all, 1, 0, (), False),
    },
    ('_load_within', 2, 'r', 'a', 'theta', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 3, 2, (), False),
        ('r', 'a'): (('r', 'a'), prepare_load_within_r_a, block_load_within_r_a, 3, 2, (), False),
        ('r', 'a', 'theta', 'E_star'): (('r', 'a', 'theta', 'E_star'), prepare_load_within_all, block_load_within_all, 4, 2, (), False),
    },
    ('_mean_pressure', 1, 'a', 'theta', 'E_star'): {
        ('a',): (('a',), prepare_mean_pressure_a, block_mean_pressure_a, 0, 0, (), False),
        ('a', 'theta', 'E_star'): (('a', 'theta', 'E_star'), prepare_mean_pressure_all, block_mean_pressure_all, 0, 0, (), False),
    },
    ('_pressure', 2, 'r', 'a', 'theta', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 1, 0, (0.0,), True),
        ('r', 'a'): (('r', 'a'), prepare_pressure_r_a, block_pressure_r_a, 1, 1, (), False),
        ('r', 'a', 'theta', 'E_star'): (('r', 'a', 'theta', 'E_star'), prepare_pressure_all, block_pressure_all, 2, 1, (), False),
    },
    ('_profile', 1, 'r', 'theta'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 0, (), False),
        ('r', 'theta'): (('r', 'theta'), prepare_profile_all, block_profile_all, 0, 0, (), False),
    },
    ('_radius_from_depth', 1, 'd', 'theta'): {
        ('d',): (('d',), prepare_radius_from_depth_d, block_radius_from_depth_d, 0, 0, (), False),
        ('d', 'theta'): (('d', 'theta'), prepare_radius_from_depth_all, block_radius_from_depth_all, 1, 0, (), False),
    },
    ('_radius_from_force', 1, 'F', 'theta', 'E_star'): {
        ('F',): (('F',), prepare_radius_from_force_F, block_radius_from_force_F, 0, 0, (), False),
        ('F', 'theta', 'E_star'): (('F', 'theta', 'E_star'), prepare_radius_from_force_all, block_radius_from_force_all, 2, 0, (), False),
    },
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
