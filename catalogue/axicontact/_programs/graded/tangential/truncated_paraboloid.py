"""Programs of axicontact.graded.tangential.truncated_paraboloid."""

from __future__ import annotations

from math import nan, pow, sqrt

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.tangential import truncated_paraboloid as bodies

C0 = np.array(0.0)
C1 = np.array(np.nan)
C2 = np.array(1.0)


def full_slip_displacement(a, R, b, H, H_x, k, mu):
    if a.__class__ is R.__class__ is b.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            if a >= b:
                v10 = a - b
                v16 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (a + b)) / a
                v30 = (a * a * (v16 * pow(v16, k) if v16 > 0.0 else 0.0) / (1.0 + k) + 0.0 * b) / R
            else:
                v30 = nan
            value = mu * (H / H_x) * v30
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, b, H, H_x, k, mu):
    v7 = H / H_x
    v8 = mu * v7
    v24 = (1.0) + k
    v26 = (0.0) * b
    return (R, b, k, v8, v24, v26)


def block_full_slip_displacement_a(out, a, R, b, k, v8, v24, v26, t0, t1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(t0, a, t0)
        np.multiply(a, a, out)
        np.greater(t0, C0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(t0, k, t1)
            np.multiply(t0, t1, t1)
        if some21 != size:
            np.copyto(t1, C0, where=~m1)
        np.multiply(out, t1, t1)
        np.divide(t1, v24, t1)
        np.add(t1, v26, t1)
        np.divide(t1, R, out)
    if some30 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(v8, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, b, H, H_x, k, mu, t0, t1, t2, m0, m1, f0):
    size = out.size
    np.divide(H, H_x, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.greater_equal(a, b, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, b, t0)
        np.maximum(t0, f0, out=t0)
        np.add(a, b, t1)
        np.multiply(t0, t1, t1)
        np.sqrt(t1, t1)
        np.divide(t1, a, t1)
        np.multiply(a, a, t0)
        np.greater(t1, C0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(t1, k, t2)
            np.multiply(t1, t2, t2)
        if some21 != size:
            np.copyto(t2, C0, where=~m1)
        np.multiply(t0, t2, t2)
        np.add(C2, k, t0)
        np.divide(t2, t0, t0)
        np.multiply(C0, b, t2)
        np.add(t0, t2, t2)
        np.divide(t2, R, t0)
    if some30 != size:
        np.copyto(t0, C1, where=~m0)
    np.multiply(out, t0, out)


def stick_radius(F_x, a, R, b, H, k, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            value = bodies._stick_radius(F_x, a, R, b, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, b, H, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, b, H, H_x, k, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            value = bodies._tangential_displacement(a, c, R, b, H, H_x, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, H, H_x, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R, b, H, k, mu):
    if a.__class__ is c.__class__ is R.__class__ is b.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and (b <= a):
        try:
            value = bodies._tangential_force(a, c, R, b, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, b, H, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'b', 'H', 'H_x', 'k', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 2, 2, (0.0,), False),
        ('a', 'R', 'b', 'H', 'H_x', 'k', 'mu'): (('a', 'R', 'b', 'H', 'H_x', 'k', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 3, 2, (0.0,), False),
    },
}
