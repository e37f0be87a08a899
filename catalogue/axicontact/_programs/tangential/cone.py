"""Programs of axicontact.tangential.cone."""

from __future__ import annotations

from math import expm1, log1p, nan, sqrt, tan

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(3.141592653589793)
C1 = np.array(0.5)
C2 = np.array(0.0)
C3 = np.array(np.nan)
C4 = np.array(2.0)
C5 = np.array(2e-16)
C6 = np.array(-1.0)
C7 = np.array(-2.0)
C8 = np.array(1.5707963267948966)


def full_slip_displacement(a, theta, E_star, G_star, mu):
    if a.__class__ is theta.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            return mu * (E_star / G_star) * (3.141592653589793 * tan(theta) * a / 2.0)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(theta, E_star, G_star, mu):
    v5 = E_star / G_star
    v6 = mu * v5
    v7 = np.tan(theta)
    v9 = (3.141592653589793) * v7
    v13 = v9 * (0.5)
    return (v6, v13)


def block_full_slip_displacement_a(out, a, v6, v13):
    np.multiply(v13, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v6, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, theta, E_star, G_star, mu, t0):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.tan(theta, t0)
    np.multiply(C0, t0, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, C1, t0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, theta, E_star, mu):
    if F_x.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            if F_x == 0.0 and a >= 0.0:
                return a
            v8 = 3.141592653589793 * E_star * tan(theta)
            v12 = v8 * (a * a) / 2.0
            v14 = v12 - F_x / mu
            v20 = 0.0 if abs(v14) <= 2e-16 * v12 else v14
            value = sqrt(2.0 * (v20 if v20 >= 0.0 else nan) / v8)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stick_radius_F_x(a, theta, E_star, mu):
    v6 = (3.141592653589793) * E_star
    v7 = np.tan(theta)
    v8 = v6 * v7
    v10 = np.square(a)
    v11 = v8 * v10
    v12 = v11 / (2.0)
    v17 = (2e-16) * v12
    v25 = np.greater_equal(a, (0.0))
    return (a, mu, v8, v12, v17, v25)


def block_stick_radius_F_x(out, F_x, a, mu, v8, v12, v17, v25, t0, t1, m0, m1):
    size = out.size
    np.equal(F_x, C2, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v25, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.copyto(out, a)
    if some30 != size:
        other30 = t0 if some30 else out
        np.divide(F_x, mu, other30)
        np.subtract(v12, other30, other30)
        np.absolute(other30, t1)
        np.less_equal(t1, v17, m1)
        some20 = np.count_nonzero(m1)
        if some20:
            np.copyto(t1, C2)
        if some20 != size:
            np.copyto(t1, other30, where=~m1)
        np.greater_equal(t1, C2, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.copyto(other30, t1)
        if some23 != size:
            np.copyto(other30, C3, where=~m1)
        np.multiply(C4, other30, other30)
        np.divide(other30, v8, other30)
        np.sqrt(other30, other30)
        if some30:
            np.copyto(out, other30, where=~m0)


def prepare_stick_radius_F_x_a(theta, E_star, mu):
    v6 = (3.141592653589793) * E_star
    v7 = np.tan(theta)
    v8 = v6 * v7
    v13 = v8 * (0.5)
    return (mu, v8, v13)


def block_stick_radius_F_x_a(out, F_x, a, mu, v8, v13, t0, t1, t2, m0, m1):
    size = out.size
    np.equal(F_x, C2, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some32 = np.count_nonzero(m1)
    if some32:
        np.copyto(out, a)
    if some32 != size:
        other32 = t0 if some32 else out
        np.square(a, other32)
        np.multiply(v13, other32, other32)
        np.divide(F_x, mu, t1)
        np.subtract(other32, t1, t1)
        np.absolute(t1, t2)
        np.multiply(C5, other32, other32)
        np.less_equal(t2, other32, m0)
        some22 = np.count_nonzero(m0)
        if some22:
            np.copyto(other32, C2)
        if some22 != size:
            np.copyto(other32, t1, where=~m0)
        np.greater_equal(other32, C2, m0)
        some25 = np.count_nonzero(m0)
        if some25:
            np.copyto(t1, other32)
        if some25 != size:
            np.copyto(t1, C3, where=~m0)
        np.multiply(C4, t1, t1)
        np.divide(t1, v8, t1)
        np.sqrt(t1, other32)
        if some32:
            np.copyto(out, other32, where=~m1)


def prepare_stick_radius_all():
    return ()


def block_stick_radius_all(out, F_x, a, theta, E_star, mu, t0, t1, t2, t3, m0, m1):
    size = out.size
    np.equal(F_x, C2, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.copyto(out, a)
    if some31 != size:
        other31 = t0 if some31 else out
        np.multiply(C0, E_star, other31)
        np.tan(theta, t1)
        np.multiply(other31, t1, t1)
        np.square(a, other31)
        np.multiply(t1, other31, other31)
        np.multiply(other31, C1, other31)
        np.divide(F_x, mu, t2)
        np.subtract(other31, t2, t2)
        np.absolute(t2, t3)
        np.multiply(C5, other31, other31)
        np.less_equal(t3, other31, m0)
        some21 = np.count_nonzero(m0)
        if some21:
            np.copyto(other31, C2)
        if some21 != size:
            np.copyto(other31, t2, where=~m0)
        np.greater_equal(other31, C2, m0)
        some24 = np.count_nonzero(m0)
        if some24:
            np.copyto(t2, other31)
        if some24 != size:
            np.copyto(t2, C3, where=~m0)
        np.multiply(C4, t2, t2)
        np.divide(t2, t1, t1)
        np.sqrt(t1, other31)
        if some31:
            np.copyto(out, other31, where=~m1)


def tangential_displacement(a, c, theta, E_star, G_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = mu * (E_star / G_star) * (3.141592653589793 * tan(theta) * a / 2.0) * -expm1(-1.0 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_displacement_a(c, theta, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v8 = np.tan(theta)
    v10 = (3.141592653589793) * v8
    v14 = v10 * (0.5)
    return (c, v7, v14)


def block_tangential_displacement_a(out, a, c, v7, v14, t0, m0):
    size = out.size
    np.multiply(v14, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)
    np.greater(a, c, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some22 != size:
        np.copyto(t0, C2, where=~m0)
    np.multiply(C6, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_a_c(theta, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v8 = np.tan(theta)
    v10 = (3.141592653589793) * v8
    v14 = v10 * (0.5)
    return (v7, v14)


def block_tangential_displacement_a_c(out, a, c, v7, v14, t0, m0):
    size = out.size
    np.multiply(v14, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(v7, out, out)
    np.greater(a, c, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some22 != size:
        np.copyto(t0, C2, where=~m0)
    np.multiply(C6, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_all():
    return ()


def block_tangential_displacement_all(out, a, c, theta, E_star, G_star, mu, t0, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.tan(theta, t0)
    np.multiply(C0, t0, t0)
    np.multiply(t0, a, t0)
    np.multiply(t0, C1, t0)
    np.multiply(out, t0, t0)
    np.greater(a, c, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.subtract(a, c, out)
        np.divide(out, c, out)
        np.log1p(out, out)
    if some21 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(C6, out, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.multiply(t0, out, out)


def tangential_force(a, c, theta, E_star, mu):
    if a.__class__ is c.__class__ is theta.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = mu * (3.141592653589793 * E_star * tan(theta) * (a * a) / 2.0) * -expm1(-2.0 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_force_a(c, theta, E_star, mu):
    v6 = (3.141592653589793) * E_star
    v7 = np.tan(theta)
    v8 = v6 * v7
    v13 = v8 * (0.5)
    return (c, mu, v13)


def block_tangential_force_a(out, a, c, mu, v13, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v13, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some21 != size:
        np.copyto(t0, C2, where=~m0)
    np.multiply(C7, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_force_a_c(theta, E_star, mu):
    v6 = (3.141592653589793) * E_star
    v7 = np.tan(theta)
    v8 = v6 * v7
    v13 = v8 * (0.5)
    return (mu, v13)


def block_tangential_force_a_c(out, a, c, mu, v13, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(v13, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some21 = np.count_nonzero(m0)
    if some21:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some21 != size:
        np.copyto(t0, C2, where=~m0)
    np.multiply(C7, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_force_all():
    return ()


def block_tangential_force_all(out, a, c, theta, E_star, mu, t0, m0):
    size = out.size
    np.multiply(C0, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.tan(theta, t0)
    np.multiply(out, t0, t0)
    np.square(a, out)
    np.multiply(t0, out, out)
    np.multiply(out, C1, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some20 != size:
        np.copyto(t0, C2, where=~m0)
    np.multiply(C7, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def traction(r, a, c, theta, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is theta.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v6 = a - r
            v7 = a + r
            v11 = tan(theta)
            if r < c:
                v26 = a - c
                v33 = c - r
                v37 = sqrt((v33 if v33 > 0.0 or v33 != v33 else 0.0) * (c + r))
                v47 = E_star / 3.141592653589793 * (3.141592653589793 * v11 / 2.0) * log1p((v26 + (v26 * (a + c) / (sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v7) + v37) if a > c else 0.0)) / (c + v37))
            else:
                v47 = E_star * v11 * log1p((v6 + sqrt(v6 * v7)) / r) / 2.0 if r < a else 0.0
            return mu * v47
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_traction_r(a, c, theta, E_star, mu):
    v11 = np.tan(theta)
    v12 = E_star * v11
    v19 = v12 * (0.5)
    v24 = E_star / (3.141592653589793)
    v25 = (3.141592653589793) * v11
    v26 = v25 / (2.0)
    v27 = v24 * v26
    v28 = a - c
    v29 = np.greater(a, c)
    v30 = a + c
    v31 = v28 * v30
    return (a, c, mu, v19, v27, v28, v29, v31)


def block_traction_r(out, r, a, c, mu, v19, v27, v28, v29, v31, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, c, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.subtract(c, r, t1)
        np.maximum(t1, f0, out=t1)
        np.add(c, r, t2)
        np.multiply(t1, t2, t2)
        np.sqrt(t2, t2)
        if v29:
            np.maximum(out, f0, out=t1)
            np.multiply(t1, t0, t1)
            np.sqrt(t1, t1)
            np.add(t1, t2, t1)
            np.divide(v31, t1, t1)
        else:
            np.copyto(t1, C2)
        np.add(v28, t1, t1)
        np.add(c, t2, t2)
        np.divide(t1, t2, t2)
        np.log1p(t2, t2)
        np.multiply(v27, t2, t1)
    if some49 != size:
        other49 = t2 if some49 else t1
        np.less(r, a, m1)
        some22 = np.count_nonzero(m1)
        if some22:
            np.multiply(out, t0, other49)
            np.sqrt(other49, other49)
            np.add(out, other49, other49)
            np.divide(other49, r, other49)
            np.log1p(other49, other49)
            np.multiply(v19, other49, other49)
        if some22 != size:
            np.copyto(other49, C2, where=~m1)
        if some49:
            np.copyto(t1, other49, where=~m0)
    np.multiply(mu, t1, out)


def prepare_traction_r_a_c(theta, E_star, mu):
    v11 = np.tan(theta)
    v12 = E_star * v11
    v19 = v12 * (0.5)
    v24 = E_star / (3.141592653589793)
    v25 = (3.141592653589793) * v11
    v26 = v25 / (2.0)
    v27 = v24 * v26
    return (mu, v19, v27)


def block_traction_r_a_c(out, r, a, c, mu, v19, v27, t0, t1, t2, t3, t4, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, c, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.subtract(a, c, t1)
        np.greater(a, c, m1)
        np.subtract(c, r, t2)
        np.maximum(t2, f0, out=t2)
        np.add(c, r, t3)
        np.multiply(t2, t3, t3)
        np.sqrt(t3, t3)
        some42 = np.count_nonzero(m1)
        if some42:
            np.add(a, c, t2)
            np.multiply(t1, t2, t2)
            np.maximum(out, f0, out=t4)
            np.multiply(t4, t0, t4)
            np.sqrt(t4, t4)
            np.add(t4, t3, t4)
            np.divide(t2, t4, t2)
        if some42 != size:
            np.copyto(t2, C2, where=~m1)
        np.add(t1, t2, t2)
        np.add(c, t3, t3)
        np.divide(t2, t3, t3)
        np.log1p(t3, t3)
        np.multiply(v27, t3, t1)
    if some49 != size:
        other49 = t3 if some49 else t1
        np.less(r, a, m1)
        some22 = np.count_nonzero(m1)
        if some22:
            np.multiply(out, t0, other49)
            np.sqrt(other49, other49)
            np.add(out, other49, other49)
            np.divide(other49, r, other49)
            np.log1p(other49, other49)
            np.multiply(v19, other49, other49)
        if some22 != size:
            np.copyto(other49, C2, where=~m1)
        if some49:
            np.copyto(t1, other49, where=~m0)
    np.multiply(mu, t1, out)


def prepare_traction_all():
    return ()


def block_traction_all(out, r, a, c, theta, E_star, mu, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.tan(theta, t1)
    np.less(r, c, m0)
    some49 = np.count_nonzero(m0)
    if some49:
        np.divide(E_star, C0, t2)
        np.multiply(C8, t1, t3)
        np.multiply(t2, t3, t3)
        np.subtract(a, c, t2)
        np.greater(a, c, m1)
        np.subtract(c, r, t4)
        np.maximum(t4, f0, out=t4)
        np.add(c, r, t5)
        np.multiply(t4, t5, t5)
        np.sqrt(t5, t5)
        some42 = np.count_nonzero(m1)
        if some42:
            np.add(a, c, t4)
            np.multiply(t2, t4, t4)
            np.maximum(out, f0, out=t6)
            np.multiply(t6, t0, t6)
            np.sqrt(t6, t6)
            np.add(t6, t5, t6)
            np.divide(t4, t6, t4)
        if some42 != size:
            np.copyto(t4, C2, where=~m1)
        np.add(t2, t4, t4)
        np.add(c, t5, t5)
        np.divide(t4, t5, t5)
        np.log1p(t5, t5)
        np.multiply(t3, t5, t2)
    if some49 != size:
        other49 = t5 if some49 else t2
        np.less(r, a, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.multiply(out, t0, other49)
            np.sqrt(other49, other49)
            np.multiply(E_star, t1, t3)
            np.add(out, other49, other49)
            np.divide(other49, r, other49)
            np.log1p(other49, other49)
            np.multiply(t3, other49, other49)
            np.multiply(other49, C1, other49)
        if some21 != size:
            np.copyto(other49, C2, where=~m1)
        if some49:
            np.copyto(t2, other49, where=~m0)
    np.multiply(mu, t2, out)


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'theta', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 0, 0, (), False),
        ('a', 'theta', 'E_star', 'G_star', 'mu'): (('a', 'theta', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 1, 0, (), False),
    },
    ('_stick_radius', 2, 'F_x', 'a', 'theta', 'E_star', 'mu'): {
        ('F_x',): (('F_x',), prepare_stick_radius_F_x, block_stick_radius_F_x, 2, 2, (), False),
        ('F_x', 'a'): (('F_x', 'a'), prepare_stick_radius_F_x_a, block_stick_radius_F_x_a, 3, 2, (), False),
        ('F_x', 'a', 'theta', 'E_star', 'mu'): (('F_x', 'a', 'theta', 'E_star', 'mu'), prepare_stick_radius_all, block_stick_radius_all, 4, 2, (), False),
    },
    ('_tangential_displacement', 2, 'a', 'c', 'theta', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_displacement_a, block_tangential_displacement_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_displacement_a_c, block_tangential_displacement_a_c, 1, 1, (), False),
        ('a', 'c', 'theta', 'E_star', 'G_star', 'mu'): (('a', 'c', 'theta', 'E_star', 'G_star', 'mu'), prepare_tangential_displacement_all, block_tangential_displacement_all, 1, 1, (), False),
    },
    ('_tangential_force', 2, 'a', 'c', 'theta', 'E_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_force_a, block_tangential_force_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_force_a_c, block_tangential_force_a_c, 1, 1, (), False),
        ('a', 'c', 'theta', 'E_star', 'mu'): (('a', 'c', 'theta', 'E_star', 'mu'), prepare_tangential_force_all, block_tangential_force_all, 1, 1, (), False),
    },
    ('_traction', 3, 'r', 'a', 'c', 'theta', 'E_star', 'mu'): {
        ('r',): (('r',), prepare_traction_r, block_traction_r, 3, 2, (0.0,), False),
        ('r', 'a', 'c'): (('r', 'a', 'c'), prepare_traction_r_a_c, block_traction_r_a_c, 5, 2, (0.0,), False),
        ('r', 'a', 'c', 'theta', 'E_star', 'mu'): (('r', 'a', 'c', 'theta', 'E_star', 'mu'), prepare_traction_all, block_traction_all, 7, 2, (0.0,), False),
    },
}
