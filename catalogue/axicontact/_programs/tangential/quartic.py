"""Programs of axicontact.tangential.quartic."""

from __future__ import annotations

from math import expm1, inf, log1p, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(8.0)
C2 = np.array(3.0)
C3 = np.array(0.0)
C4 = np.array(np.nan)
C5 = np.array(15.0)
C6 = np.array(0.2)
C7 = np.array(np.inf)
C8 = np.array(5.0)
C9 = np.array(1.0)
C10 = np.array(2e-16)
C11 = np.array(64.0)
C12 = np.array(-4.0)
C13 = np.array(-5.0)
C14 = np.array(3.141592653589793)
C15 = np.array(32.0)
C16 = np.array(28.274333882308138)


def full_slip_displacement(a, A, E_star, G_star, mu):
    if a.__class__ is A.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v13 = a * a
            return mu * (E_star / G_star) * (8.0 * A / 3.0 * (v13 * v13))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(A, E_star, G_star, mu):
    v5 = E_star / G_star
    v6 = mu * v5
    v8 = (8.0) * A
    v10 = v8 / (3.0)
    return (v6, v10)


def block_full_slip_displacement_a(out, a, v6, v10):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(v10, out, out)
    np.multiply(v6, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, A, E_star, G_star, mu, t0, t1):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(C1, A, t0)
    np.divide(t0, C2, t0)
    np.square(a, t1)
    np.square(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, A, E_star, mu):
    if F_x.__class__ is a.__class__ is A.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            if F_x == 0.0 and a >= 0.0:
                return a
            v7 = 64.0 * E_star * A
            v12 = v7 / 15.0 * pow(a, 5.0)
            v14 = v12 - F_x / mu
            v20 = 0.0 if abs(v14) <= 2e-16 * v12 else v14
            v28 = 15.0 * (v20 if v20 >= 0.0 else nan) / v7
            v30 = pow(v28, 0.2)
            if v28 > 0.0 and v28 < inf:
                value = v30 + v30 * ((v28 / (pow(v30, 5.0) * pow(v30, 0.0)) - 1.0) / 5.0)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = v30
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stick_radius_F_x(a, A, E_star, mu):
    v6 = (64.0) * E_star
    v7 = v6 * A
    v9 = v7 / (15.0)
    v11 = np.power(a, (5.0))
    v12 = v9 * v11
    v17 = (2e-16) * v12
    v25 = np.greater_equal(a, (0.0))
    return (a, mu, v7, v12, v17, v25)


def block_stick_radius_F_x(out, F_x, a, mu, v7, v12, v17, v25, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.equal(F_x, C3, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v25, m0)
    some45 = np.count_nonzero(m0)
    if some45:
        np.copyto(out, a)
    if some45 != size:
        other45 = t0 if some45 else out
        np.divide(F_x, mu, t1)
        np.subtract(v12, t1, t1)
        np.absolute(t1, t2)
        np.less_equal(t2, v17, m1)
        some20 = np.count_nonzero(m1)
        if some20:
            np.copyto(t2, C3)
        if some20 != size:
            np.copyto(t2, t1, where=~m1)
        np.greater_equal(t2, C3, m1)
        some23 = np.count_nonzero(m1)
        if some23:
            np.copyto(t1, t2)
        if some23 != size:
            np.copyto(t1, C4, where=~m1)
        np.multiply(C5, t1, t1)
        np.divide(t1, v7, t1)
        np.power(t1, C6, t2)
        np.greater(t1, C3, m1)
        np.less(t1, C7, m2)
        np.bitwise_and(m1, m2, m2)
        some44 = np.count_nonzero(m2)
        if some44:
            np.power(t2, C8, other45)
            np.power(t2, C3, t3)
            np.multiply(other45, t3, t3)
            np.divide(t1, t3, t3)
            np.subtract(t3, C9, t3)
            np.divide(t3, C8, t3)
            np.multiply(t2, t3, t3)
            np.add(t2, t3, other45)
        if some44 != size:
            np.copyto(other45, t2, where=~m2)
        if some45:
            np.copyto(out, other45, where=~m0)


def prepare_stick_radius_F_x_a(A, E_star, mu):
    v6 = (64.0) * E_star
    v7 = v6 * A
    v9 = v7 / (15.0)
    return (mu, v7, v9)


def block_stick_radius_F_x_a(out, F_x, a, mu, v7, v9, t0, t1, t2, t3, m0, m1, m2):
    size = out.size
    np.equal(F_x, C3, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C3, m1)
    np.bitwise_and(m0, m1, m1)
    some45 = np.count_nonzero(m1)
    if some45:
        np.copyto(out, a)
    if some45 != size:
        other45 = t0 if some45 else out
        np.power(a, C8, t1)
        np.multiply(v9, t1, t1)
        np.divide(F_x, mu, t2)
        np.subtract(t1, t2, t2)
        np.absolute(t2, t3)
        np.multiply(C10, t1, t1)
        np.less_equal(t3, t1, m0)
        some20 = np.count_nonzero(m0)
        if some20:
            np.copyto(t1, C3)
        if some20 != size:
            np.copyto(t1, t2, where=~m0)
        np.greater_equal(t1, C3, m0)
        some23 = np.count_nonzero(m0)
        if some23:
            np.copyto(t2, t1)
        if some23 != size:
            np.copyto(t2, C4, where=~m0)
        np.multiply(C5, t2, t2)
        np.divide(t2, v7, t2)
        np.power(t2, C6, t1)
        np.greater(t2, C3, m0)
        np.less(t2, C7, m2)
        np.bitwise_and(m0, m2, m2)
        some44 = np.count_nonzero(m2)
        if some44:
            np.power(t1, C8, other45)
            np.power(t1, C3, t3)
            np.multiply(other45, t3, t3)
            np.divide(t2, t3, t3)
            np.subtract(t3, C9, t3)
            np.divide(t3, C8, t3)
            np.multiply(t1, t3, t3)
            np.add(t1, t3, other45)
        if some44 != size:
            np.copyto(other45, t1, where=~m2)
        if some45:
            np.copyto(out, other45, where=~m1)


def prepare_stick_radius_all():
    return ()


def block_stick_radius_all(out, F_x, a, A, E_star, mu, t0, t1, t2, t3, t4, m0, m1, m2):
    size = out.size
    np.equal(F_x, C3, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C3, m1)
    np.bitwise_and(m0, m1, m1)
    some45 = np.count_nonzero(m1)
    if some45:
        np.copyto(out, a)
    if some45 != size:
        other45 = t0 if some45 else out
        np.multiply(C11, E_star, t1)
        np.multiply(t1, A, t1)
        np.divide(t1, C5, t2)
        np.power(a, C8, t3)
        np.multiply(t2, t3, t3)
        np.divide(F_x, mu, t2)
        np.subtract(t3, t2, t2)
        np.absolute(t2, t4)
        np.multiply(C10, t3, t3)
        np.less_equal(t4, t3, m0)
        some20 = np.count_nonzero(m0)
        if some20:
            np.copyto(t3, C3)
        if some20 != size:
            np.copyto(t3, t2, where=~m0)
        np.greater_equal(t3, C3, m0)
        some23 = np.count_nonzero(m0)
        if some23:
            np.copyto(t2, t3)
        if some23 != size:
            np.copyto(t2, C4, where=~m0)
        np.multiply(C5, t2, t2)
        np.divide(t2, t1, t1)
        np.power(t1, C6, t2)
        np.greater(t1, C3, m0)
        np.less(t1, C7, m2)
        np.bitwise_and(m0, m2, m2)
        some44 = np.count_nonzero(m2)
        if some44:
            np.power(t2, C8, other45)
            np.power(t2, C3, t3)
            np.multiply(other45, t3, t3)
            np.divide(t1, t3, t3)
            np.subtract(t3, C9, t3)
            np.divide(t3, C8, t3)
            np.multiply(t2, t3, t3)
            np.add(t2, t3, other45)
        if some44 != size:
            np.copyto(other45, t2, where=~m2)
        if some45:
            np.copyto(out, other45, where=~m1)


def tangential_displacement(a, c, A, E_star, G_star, mu):
    if a.__class__ is c.__class__ is A.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v14 = a * a
            value = mu * (E_star / G_star) * (8.0 * A / 3.0 * (v14 * v14)) * -expm1(-4.0 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_displacement_a(c, A, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v9 = (8.0) * A
    v11 = v9 / (3.0)
    return (c, v7, v11)


def block_tangential_displacement_a(out, a, c, v7, v11, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(v11, out, out)
    np.multiply(v7, out, out)
    np.greater(a, c, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some22 != size:
        np.copyto(t0, C3, where=~m0)
    np.multiply(C12, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_a_c(A, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v9 = (8.0) * A
    v11 = v9 / (3.0)
    return (v7, v11)


def block_tangential_displacement_a_c(out, a, c, v7, v11, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.square(out, out)
    np.multiply(v11, out, out)
    np.multiply(v7, out, out)
    np.greater(a, c, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some22 != size:
        np.copyto(t0, C3, where=~m0)
    np.multiply(C12, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_all():
    return ()


def block_tangential_displacement_all(out, a, c, A, E_star, G_star, mu, t0, t1, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.multiply(C1, A, t0)
    np.divide(t0, C2, t0)
    np.square(a, t1)
    np.square(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(out, t1, t1)
    np.greater(a, c, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(a, c, out)
        np.divide(out, c, out)
        np.log1p(out, out)
    if some22 != size:
        np.copyto(out, C3, where=~m0)
    np.multiply(C12, out, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.multiply(t1, out, out)


def tangential_force(a, c, A, E_star, mu):
    if a.__class__ is c.__class__ is A.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = mu * (64.0 * E_star * A / 15.0 * pow(a, 5.0)) * -expm1(-5.0 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_force_a(c, A, E_star, mu):
    v6 = (64.0) * E_star
    v7 = v6 * A
    v9 = v7 / (15.0)
    return (c, mu, v9)


def block_tangential_force_a(out, a, c, mu, v9, t0, m0):
    size = out.size
    np.power(a, C8, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(v9, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some19 != size:
        np.copyto(t0, C3, where=~m0)
    np.multiply(C13, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_force_a_c(A, E_star, mu):
    v6 = (64.0) * E_star
    v7 = v6 * A
    v9 = v7 / (15.0)
    return (mu, v9)


def block_tangential_force_a_c(out, a, c, mu, v9, t0, m0):
    size = out.size
    np.power(a, C8, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(v9, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some19 != size:
        np.copyto(t0, C3, where=~m0)
    np.multiply(C13, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_force_all():
    return ()


def block_tangential_force_all(out, a, c, A, E_star, mu, t0, m0):
    size = out.size
    np.multiply(C11, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(out, A, out)
    np.divide(out, C5, out)
    np.power(a, C8, t0)
    np.multiply(out, t0, t0)
    np.multiply(mu, t0, t0)
    np.greater(a, c, m0)
    some19 = np.count_nonzero(m0)
    if some19:
        np.subtract(a, c, out)
        np.divide(out, c, out)
        np.log1p(out, out)
    if some19 != size:
        np.copyto(out, C3, where=~m0)
    np.multiply(C13, out, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.multiply(t0, out, out)


def traction(r, a, c, A, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is A.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v6 = a - r
            v7 = a + r
            if r < c:
                v34 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v7)
                v35 = c - r
                v46 = v34 + sqrt((v35 if v35 > 0.0 or v35 != v35 else 0.0) * (c + r))
                v61 = E_star / 3.141592653589793 * (32.0 * A / 3.0) * (((a - c) * (a + c) / v46 if a > c else 0.0) * ((2.0 * r * r + (a * a * 0.0 + 1.0) * v46 * v34 + c * c) / 3.0))
            else:
                v61 = 32.0 * E_star * A / 28.274333882308138 * (a * a + 2.0 * (r * r)) * sqrt(v6 * v7) if r < a else 0.0
            value = mu * v61
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_traction_r(a, c, A, E_star, mu):
    v12 = (32.0) * E_star
    v13 = v12 * A
    v15 = v13 / (28.274333882308138)
    v17 = np.square(a)
    v26 = E_star / (3.141592653589793)
    v27 = (32.0) * A
    v29 = v27 / (3.0)
    v31 = v26 * v29
    v40 = a * a
    v41 = v40 * (0.0)
    v42 = v41 + (1.0)
    v43 = c * c
    v52 = np.greater(a, c)
    v53 = a - c
    v54 = a + c
    v55 = v53 * v54
    return (a, c, mu, v15, v17, v31, v42, v43, v52, v55)


def block_traction_r(out, r, a, c, mu, v15, v17, v31, v42, v43, v52, v55, t0, t1, t2, t3, t4, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, c, m0)
    some61 = np.count_nonzero(m0)
    if some61:
        np.maximum(out, f0, out=t1)
        np.multiply(t1, t0, t1)
        np.sqrt(t1, t1)
        np.subtract(c, r, t2)
        np.maximum(t2, f0, out=t2)
        np.add(c, r, t3)
        np.multiply(t2, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(C0, r, t2)
        np.multiply(t2, r, t2)
        np.add(t1, t3, t3)
        np.multiply(v42, t3, t4)
        np.multiply(t4, t1, t1)
        np.add(t2, t1, t1)
        np.add(t1, v43, t1)
        np.divide(t1, C2, t1)
        if v52:
            np.divide(v55, t3, t2)
        else:
            np.copyto(t2, C3)
        np.multiply(t2, t1, t1)
        np.multiply(v31, t1, t1)
    if some61 != size:
        other61 = t2 if some61 else t1
        np.less(r, a, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.multiply(out, t0, other61)
            np.sqrt(other61, other61)
            np.square(r, t3)
            np.multiply(C0, t3, t3)
            np.add(v17, t3, t3)
            np.multiply(v15, t3, t3)
            np.multiply(t3, other61, other61)
        if some24 != size:
            np.copyto(other61, C3, where=~m1)
        if some61:
            np.copyto(t1, other61, where=~m0)
    np.multiply(mu, t1, out)


def prepare_traction_r_a_c(A, E_star, mu):
    v12 = (32.0) * E_star
    v13 = v12 * A
    v15 = v13 / (28.274333882308138)
    v26 = E_star / (3.141592653589793)
    v27 = (32.0) * A
    v29 = v27 / (3.0)
    v31 = v26 * v29
    return (mu, v15, v31)


def block_traction_r_a_c(out, r, a, c, mu, v15, v31, t0, t1, t2, t3, t4, t5, m0, m1, f0):
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
    some61 = np.count_nonzero(m0)
    if some61:
        np.maximum(out, f0, out=t1)
        np.multiply(t1, t0, t1)
        np.sqrt(t1, t1)
        np.subtract(c, r, t2)
        np.maximum(t2, f0, out=t2)
        np.add(c, r, t3)
        np.multiply(t2, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(a, a, t2)
        np.multiply(t2, C3, t2)
        np.add(t2, C9, t2)
        np.multiply(c, c, t4)
        np.multiply(C0, r, t5)
        np.multiply(t5, r, t5)
        np.add(t1, t3, t3)
        np.multiply(t2, t3, t2)
        np.multiply(t2, t1, t1)
        np.add(t5, t1, t1)
        np.add(t1, t4, t4)
        np.divide(t4, C2, t4)
        np.greater(a, c, m1)
        some57 = np.count_nonzero(m1)
        if some57:
            np.subtract(a, c, t1)
            np.add(a, c, t5)
            np.multiply(t1, t5, t5)
            np.divide(t5, t3, t1)
        if some57 != size:
            np.copyto(t1, C3, where=~m1)
        np.multiply(t1, t4, t4)
        np.multiply(v31, t4, t1)
    if some61 != size:
        other61 = t4 if some61 else t1
        np.less(r, a, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.multiply(out, t0, other61)
            np.sqrt(other61, other61)
            np.square(a, t3)
            np.square(r, t5)
            np.multiply(C0, t5, t5)
            np.add(t3, t5, t5)
            np.multiply(v15, t5, t5)
            np.multiply(t5, other61, other61)
        if some24 != size:
            np.copyto(other61, C3, where=~m1)
        if some61:
            np.copyto(t1, other61, where=~m0)
    np.multiply(mu, t1, out)


def prepare_traction_all():
    return ()


def block_traction_all(out, r, a, c, A, E_star, mu, t0, t1, t2, t3, t4, t5, t6, m0, m1, f0):
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
    some61 = np.count_nonzero(m0)
    if some61:
        np.divide(E_star, C14, t1)
        np.multiply(C15, A, t2)
        np.divide(t2, C2, t2)
        np.multiply(t1, t2, t2)
        np.maximum(out, f0, out=t1)
        np.multiply(t1, t0, t1)
        np.sqrt(t1, t1)
        np.subtract(c, r, t3)
        np.maximum(t3, f0, out=t3)
        np.add(c, r, t4)
        np.multiply(t3, t4, t4)
        np.sqrt(t4, t4)
        np.multiply(a, a, t3)
        np.multiply(t3, C3, t3)
        np.add(t3, C9, t3)
        np.multiply(c, c, t5)
        np.multiply(C0, r, t6)
        np.multiply(t6, r, t6)
        np.add(t1, t4, t4)
        np.multiply(t3, t4, t3)
        np.multiply(t3, t1, t1)
        np.add(t6, t1, t1)
        np.add(t1, t5, t5)
        np.divide(t5, C2, t5)
        np.greater(a, c, m1)
        some57 = np.count_nonzero(m1)
        if some57:
            np.subtract(a, c, t1)
            np.add(a, c, t6)
            np.multiply(t1, t6, t6)
            np.divide(t6, t4, t1)
        if some57 != size:
            np.copyto(t1, C3, where=~m1)
        np.multiply(t1, t5, t5)
        np.multiply(t2, t5, t1)
    if some61 != size:
        other61 = t5 if some61 else t1
        np.less(r, a, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.multiply(out, t0, other61)
            np.sqrt(other61, other61)
            np.multiply(C15, E_star, t2)
            np.multiply(t2, A, t2)
            np.divide(t2, C16, t2)
            np.square(a, t4)
            np.square(r, t6)
            np.multiply(C0, t6, t6)
            np.add(t4, t6, t6)
            np.multiply(t2, t6, t6)
            np.multiply(t6, other61, other61)
        if some24 != size:
            np.copyto(other61, C3, where=~m1)
        if some61:
            np.copyto(t1, other61, where=~m0)
    np.multiply(mu, t1, out)


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'A', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 0, 0, (), False),
        ('a', 'A', 'E_star', 'G_star', 'mu'): (('a', 'A', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 2, 0, (), False),
    },
    ('_stick_radius', 2, 'F_x', 'a', 'A', 'E_star', 'mu'): {
        ('F_x',): (('F_x',), prepare_stick_radius_F_x, block_stick_radius_F_x, 4, 3, (), False),
        ('F_x', 'a'): (('F_x', 'a'), prepare_stick_radius_F_x_a, block_stick_radius_F_x_a, 4, 3, (), False),
        ('F_x', 'a', 'A', 'E_star', 'mu'): (('F_x', 'a', 'A', 'E_star', 'mu'), prepare_stick_radius_all, block_stick_radius_all, 5, 3, (), False),
    },
    ('_tangential_displacement', 2, 'a', 'c', 'A', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_displacement_a, block_tangential_displacement_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_displacement_a_c, block_tangential_displacement_a_c, 1, 1, (), False),
        ('a', 'c', 'A', 'E_star', 'G_star', 'mu'): (('a', 'c', 'A', 'E_star', 'G_star', 'mu'), prepare_tangential_displacement_all, block_tangential_displacement_all, 2, 1, (), False),
    },
    ('_tangential_force', 2, 'a', 'c', 'A', 'E_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_force_a, block_tangential_force_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_force_a_c, block_tangential_force_a_c, 1, 1, (), False),
        ('a', 'c', 'A', 'E_star', 'mu'): (('a', 'c', 'A', 'E_star', 'mu'), prepare_tangential_force_all, block_tangential_force_all, 1, 1, (), False),
    },
    ('_traction', 3, 'r', 'a', 'c', 'A', 'E_star', 'mu'): {
        ('r',): (('r',), prepare_traction_r, block_traction_r, 5, 2, (0.0,), False),
        ('r', 'a', 'c'): (('r', 'a', 'c'), prepare_traction_r_a_c, block_traction_r_a_c, 6, 2, (0.0,), False),
        ('r', 'a', 'c', 'A', 'E_star', 'mu'): (('r', 'a', 'c', 'A', 'E_star', 'mu'), prepare_traction_all, block_traction_all, 7, 2, (0.0,), False),
    },
}
