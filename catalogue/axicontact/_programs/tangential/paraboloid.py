"""Programs of axicontact.tangential.paraboloid."""

from __future__ import annotations

from math import cbrt, expm1, log1p, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(0.0)
C2 = np.array(np.nan)
C3 = np.array(2e-16)
C4 = np.array(4.0)
C5 = np.array(3.0)
C6 = np.array(-2.0)
C7 = np.array(-3.0)
C8 = np.array(3.141592653589793)


def full_slip_displacement(a, R, E_star, G_star, mu):
    if a.__class__ is R.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            return mu * (E_star / G_star) * (a * a / R)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, E_star, G_star, mu):
    v5 = E_star / G_star
    v6 = mu * v5
    return (R, v6)


def block_full_slip_displacement_a(out, a, R, v6):
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)
    np.multiply(v6, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, E_star, G_star, mu, t0):
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.square(a, t0)
    np.divide(t0, R, t0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, R, E_star, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            if F_x == 0.0 and a >= 0.0:
                return a
            v6 = 4.0 * E_star
            v8 = 3.0 * R
            v13 = v6 / v8 * (a * (a * a))
            v15 = v13 - F_x / mu
            v21 = 0.0 if abs(v15) <= 2e-16 * v13 else v15
            value = cbrt(v8 / v6 * (v21 if v21 >= 0.0 else nan))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stick_radius_F_x(a, R, E_star, mu):
    v6 = (4.0) * E_star
    v8 = (3.0) * R
    v9 = v6 / v8
    v11 = np.square(a)
    v12 = a * v11
    v13 = v9 * v12
    v18 = (2e-16) * v13
    v26 = np.greater_equal(a, (0.0))
    v28 = v8 / v6
    return (a, mu, v13, v18, v26, v28)


def block_stick_radius_F_x(out, F_x, a, mu, v13, v18, v26, v28, t0, t1, m0, m1):
    size = out.size
    np.equal(F_x, C1, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v26, m0)
    some31 = np.count_nonzero(m0)
    if some31:
        np.copyto(out, a)
    if some31 != size:
        other31 = t0 if some31 else out
        np.divide(F_x, mu, other31)
        np.subtract(v13, other31, other31)
        np.absolute(other31, t1)
        np.less_equal(t1, v18, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.copyto(t1, C1)
        if some21 != size:
            np.copyto(t1, other31, where=~m1)
        np.greater_equal(t1, C1, m1)
        some24 = np.count_nonzero(m1)
        if some24:
            np.copyto(other31, t1)
        if some24 != size:
            np.copyto(other31, C2, where=~m1)
        np.multiply(v28, other31, other31)
        np.cbrt(other31, other31)
        if some31:
            np.copyto(out, other31, where=~m0)


def prepare_stick_radius_F_x_a(R, E_star, mu):
    v6 = (4.0) * E_star
    v8 = (3.0) * R
    v9 = v6 / v8
    v28 = v8 / v6
    return (mu, v9, v28)


def block_stick_radius_F_x_a(out, F_x, a, mu, v9, v28, t0, t1, t2, m0, m1):
    size = out.size
    np.equal(F_x, C1, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C1, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.copyto(out, a)
    if some31 != size:
        other31 = t0 if some31 else out
        np.square(a, other31)
        np.multiply(a, other31, other31)
        np.multiply(v9, other31, other31)
        np.divide(F_x, mu, t1)
        np.subtract(other31, t1, t1)
        np.absolute(t1, t2)
        np.multiply(C3, other31, other31)
        np.less_equal(t2, other31, m0)
        some21 = np.count_nonzero(m0)
        if some21:
            np.copyto(other31, C1)
        if some21 != size:
            np.copyto(other31, t1, where=~m0)
        np.greater_equal(other31, C1, m0)
        some24 = np.count_nonzero(m0)
        if some24:
            np.copyto(t1, other31)
        if some24 != size:
            np.copyto(t1, C2, where=~m0)
        np.multiply(v28, t1, t1)
        np.cbrt(t1, other31)
        if some31:
            np.copyto(out, other31, where=~m1)


def prepare_stick_radius_all():
    return ()


def block_stick_radius_all(out, F_x, a, R, E_star, mu, t0, t1, t2, t3, t4, m0, m1):
    size = out.size
    np.equal(F_x, C1, m0)
    largest_F_x = largest(F_x)
    if largest_F_x == np.inf:
        raise FloatingPointError
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(a, C1, m1)
    np.bitwise_and(m0, m1, m1)
    some31 = np.count_nonzero(m1)
    if some31:
        np.copyto(out, a)
    if some31 != size:
        other31 = t0 if some31 else out
        np.multiply(C4, E_star, other31)
        np.multiply(C5, R, t1)
        np.divide(other31, t1, t2)
        np.square(a, t3)
        np.multiply(a, t3, t3)
        np.multiply(t2, t3, t3)
        np.divide(F_x, mu, t2)
        np.subtract(t3, t2, t2)
        np.absolute(t2, t4)
        np.multiply(C3, t3, t3)
        np.less_equal(t4, t3, m0)
        some21 = np.count_nonzero(m0)
        if some21:
            np.copyto(t3, C1)
        if some21 != size:
            np.copyto(t3, t2, where=~m0)
        np.greater_equal(t3, C1, m0)
        some24 = np.count_nonzero(m0)
        if some24:
            np.copyto(t2, t3)
        if some24 != size:
            np.copyto(t2, C2, where=~m0)
        np.divide(t1, other31, other31)
        np.multiply(other31, t2, t2)
        np.cbrt(t2, other31)
        if some31:
            np.copyto(out, other31, where=~m1)


def tangential_displacement(a, c, R, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = mu * (E_star / G_star) * (a * a / R) * -expm1(-2.0 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_displacement_a(c, R, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    return (c, R, v7)


def block_tangential_displacement_a(out, a, c, R, v7, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)
    np.multiply(v7, out, out)
    np.greater(a, c, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some17 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(C6, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_a_c(R, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    return (R, v7)


def block_tangential_displacement_a_c(out, a, c, R, v7, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.divide(out, R, out)
    np.multiply(v7, out, out)
    np.greater(a, c, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some17 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(C6, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_displacement_all():
    return ()


def block_tangential_displacement_all(out, a, c, R, E_star, G_star, mu, t0, m0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.square(a, t0)
    np.divide(t0, R, t0)
    np.multiply(out, t0, t0)
    np.greater(a, c, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.subtract(a, c, out)
        np.divide(out, c, out)
        np.log1p(out, out)
    if some17 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(C6, out, out)
    np.expm1(out, out)
    np.negative(out, out)
    np.multiply(t0, out, out)


def tangential_force(a, c, R, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = mu * (4.0 * E_star / (3.0 * R) * (a * (a * a))) * -expm1(-3.0 * (log1p((a - c) / c) if a > c else 0.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tangential_force_a(c, R, E_star, mu):
    v6 = (4.0) * E_star
    v8 = (3.0) * R
    v9 = v6 / v8
    return (c, mu, v9)


def block_tangential_force_a(out, a, c, mu, v9, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(a, out, out)
    np.multiply(v9, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some20 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(C7, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_force_a_c(R, E_star, mu):
    v6 = (4.0) * E_star
    v8 = (3.0) * R
    v9 = v6 / v8
    return (mu, v9)


def block_tangential_force_a_c(out, a, c, mu, v9, t0, m0):
    size = out.size
    np.square(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(a, out, out)
    np.multiply(v9, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some20 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(C7, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def prepare_tangential_force_all():
    return ()


def block_tangential_force_all(out, a, c, R, E_star, mu, t0, m0):
    size = out.size
    np.multiply(C4, E_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    largest_c = largest(c)
    if largest_c == np.inf:
        raise FloatingPointError
    np.multiply(C5, R, t0)
    np.divide(out, t0, t0)
    np.square(a, out)
    np.multiply(a, out, out)
    np.multiply(t0, out, out)
    np.multiply(mu, out, out)
    np.greater(a, c, m0)
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(a, c, t0)
        np.divide(t0, c, t0)
        np.log1p(t0, t0)
    if some20 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(C7, t0, t0)
    np.expm1(t0, t0)
    np.negative(t0, t0)
    np.multiply(out, t0, out)


def traction(r, a, c, R, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v6 = a - r
            v7 = a + r
            if r < c:
                if a > c:
                    v29 = c - r
                    v36 = (a - c) * (a + c) / (sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * v7) + sqrt((v29 if v29 > 0.0 or v29 != v29 else 0.0) * (c + r)))
                else:
                    v36 = 0.0
                v39 = E_star / 3.141592653589793 * (2.0 / R) * v36
            else:
                v39 = 2.0 * E_star / (3.141592653589793 * R) * sqrt(v6 * v7) if r < a else 0.0
            return mu * v39
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_traction_r(a, c, R, E_star, mu):
    v12 = (2.0) * E_star
    v14 = (3.141592653589793) * R
    v15 = v12 / v14
    v19 = E_star / (3.141592653589793)
    v20 = (2.0) / R
    v21 = v19 * v20
    v22 = np.greater(a, c)
    v23 = a - c
    v24 = a + c
    v25 = v23 * v24
    return (a, c, mu, v15, v21, v22, v25)


def block_traction_r(out, r, a, c, mu, v15, v21, v22, v25, t0, t1, t2, t3, m0, m1, f0):
    size = out.size
    np.subtract(a, r, out)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.add(a, r, t0)
    np.less(r, c, m0)
    some39 = np.count_nonzero(m0)
    if some39:
        if v22:
            np.maximum(out, f0, out=t1)
            np.multiply(t1, t0, t1)
            np.sqrt(t1, t1)
            np.subtract(c, r, t2)
            np.maximum(t2, f0, out=t2)
            np.add(c, r, t3)
            np.multiply(t2, t3, t3)
            np.sqrt(t3, t3)
            np.add(t1, t3, t3)
            np.divide(v25, t3, t1)
        else:
            np.copyto(t1, C1)
        np.multiply(v21, t1, t1)
    if some39 != size:
        other39 = t3 if some39 else t1
        np.less(r, a, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.multiply(out, t0, other39)
            np.sqrt(other39, other39)
            np.multiply(v15, other39, other39)
        if some18 != size:
            np.copyto(other39, C1, where=~m1)
        if some39:
            np.copyto(t1, other39, where=~m0)
    np.multiply(mu, t1, out)


def prepare_traction_r_a_c(R, E_star, mu):
    v12 = (2.0) * E_star
    v14 = (3.141592653589793) * R
    v15 = v12 / v14
    v19 = E_star / (3.141592653589793)
    v20 = (2.0) / R
    v21 = v19 * v20
    return (mu, v15, v21)


def block_traction_r_a_c(out, r, a, c, mu, v15, v21, t0, t1, t2, t3, t4, m0, m1, f0):
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
    some39 = np.count_nonzero(m0)
    if some39:
        np.greater(a, c, m1)
        some36 = np.count_nonzero(m1)
        if some36:
            np.subtract(a, c, t1)
            np.add(a, c, t2)
            np.multiply(t1, t2, t2)
            np.maximum(out, f0, out=t1)
            np.multiply(t1, t0, t1)
            np.sqrt(t1, t1)
            np.subtract(c, r, t3)
            np.maximum(t3, f0, out=t3)
            np.add(c, r, t4)
            np.multiply(t3, t4, t4)
            np.sqrt(t4, t4)
            np.add(t1, t4, t4)
            np.divide(t2, t4, t1)
        if some36 != size:
            np.copyto(t1, C1, where=~m1)
        np.multiply(v21, t1, t1)
    if some39 != size:
        other39 = t4 if some39 else t1
        np.less(r, a, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.multiply(out, t0, other39)
            np.sqrt(other39, other39)
            np.multiply(v15, other39, other39)
        if some18 != size:
            np.copyto(other39, C1, where=~m1)
        if some39:
            np.copyto(t1, other39, where=~m0)
    np.multiply(mu, t1, out)


def prepare_traction_all():
    return ()


def block_traction_all(out, r, a, c, R, E_star, mu, t0, t1, t2, t3, t4, t5, m0, m1, f0):
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
    some39 = np.count_nonzero(m0)
    if some39:
        np.divide(E_star, C8, t1)
        np.divide(C0, R, t2)
        np.multiply(t1, t2, t2)
        np.greater(a, c, m1)
        some36 = np.count_nonzero(m1)
        if some36:
            np.subtract(a, c, t1)
            np.add(a, c, t3)
            np.multiply(t1, t3, t3)
            np.maximum(out, f0, out=t1)
            np.multiply(t1, t0, t1)
            np.sqrt(t1, t1)
            np.subtract(c, r, t4)
            np.maximum(t4, f0, out=t4)
            np.add(c, r, t5)
            np.multiply(t4, t5, t5)
            np.sqrt(t5, t5)
            np.add(t1, t5, t5)
            np.divide(t3, t5, t1)
        if some36 != size:
            np.copyto(t1, C1, where=~m1)
        np.multiply(t2, t1, t1)
    if some39 != size:
        other39 = t2 if some39 else t1
        np.less(r, a, m1)
        some18 = np.count_nonzero(m1)
        if some18:
            np.multiply(out, t0, other39)
            np.sqrt(other39, other39)
            np.multiply(C0, E_star, t5)
            np.multiply(C8, R, t3)
            np.divide(t5, t3, t3)
            np.multiply(t3, other39, other39)
        if some18 != size:
            np.copyto(other39, C1, where=~m1)
        if some39:
            np.copyto(t1, other39, where=~m0)
    np.multiply(mu, t1, out)


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 0, 0, (), False),
        ('a', 'R', 'E_star', 'G_star', 'mu'): (('a', 'R', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 1, 0, (), False),
    },
    ('_stick_radius', 2, 'F_x', 'a', 'R', 'E_star', 'mu'): {
        ('F_x',): (('F_x',), prepare_stick_radius_F_x, block_stick_radius_F_x, 2, 2, (), False),
        ('F_x', 'a'): (('F_x', 'a'), prepare_stick_radius_F_x_a, block_stick_radius_F_x_a, 3, 2, (), False),
        ('F_x', 'a', 'R', 'E_star', 'mu'): (('F_x', 'a', 'R', 'E_star', 'mu'), prepare_stick_radius_all, block_stick_radius_all, 5, 2, (), False),
    },
    ('_tangential_displacement', 2, 'a', 'c', 'R', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_displacement_a, block_tangential_displacement_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_displacement_a_c, block_tangential_displacement_a_c, 1, 1, (), False),
        ('a', 'c', 'R', 'E_star', 'G_star', 'mu'): (('a', 'c', 'R', 'E_star', 'G_star', 'mu'), prepare_tangential_displacement_all, block_tangential_displacement_all, 1, 1, (), False),
    },
    ('_tangential_force', 2, 'a', 'c', 'R', 'E_star', 'mu'): {
        ('a',): (('a',), prepare_tangential_force_a, block_tangential_force_a, 1, 1, (), False),
        ('a', 'c'): (('a', 'c'), prepare_tangential_force_a_c, block_tangential_force_a_c, 1, 1, (), False),
        ('a', 'c', 'R', 'E_star', 'mu'): (('a', 'c', 'R', 'E_star', 'mu'), prepare_tangential_force_all, block_tangential_force_all, 1, 1, (), False),
    },
    ('_traction', 3, 'r', 'a', 'c', 'R', 'E_star', 'mu'): {
        ('r',): (('r',), prepare_traction_r, block_traction_r, 4, 2, (0.0,), False),
        ('r', 'a', 'c'): (('r', 'a', 'c'), prepare_traction_r_a_c, block_traction_r_a_c, 5, 2, (0.0,), False),
        ('r', 'a', 'c', 'R', 'E_star', 'mu'): (('r', 'a', 'c', 'R', 'E_star', 'mu'), prepare_traction_all, block_traction_all, 6, 2, (0.0,), False),
    },
}
