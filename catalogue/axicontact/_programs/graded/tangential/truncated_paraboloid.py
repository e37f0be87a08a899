"""Programs of axicontact.graded.tangential.truncated_paraboloid."""

from __future__ import annotations

from math import nan, pow, sqrt

import numpy as np

from ...._runtime.arrays.blocks import Program, largest

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


def block_full_slip_displacement_a(out, a, R, b, k, v8, v24, v26, w0, w1, m0, m1, f0):
    size = out.size
    np.greater_equal(a, b, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, b, out)
        np.maximum(out, f0, out=out)
        np.add(a, b, w0)
        np.multiply(out, w0, w0)
        np.sqrt(w0, w0)
        np.divide(w0, a, w0)
        np.multiply(a, a, out)
        np.greater(w0, C0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(w0, k, w1)
            np.multiply(w0, w1, w1)
        if some21 != size:
            np.copyto(w1, C0, where=~m1)
        np.multiply(out, w1, w1)
        np.divide(w1, v24, w1)
        np.add(w1, v26, w1)
        np.divide(w1, R, out)
    if some30 != size:
        np.copyto(out, C1, where=~m0)
    np.multiply(v8, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, b, H, H_x, k, mu, w0, w1, w2, m0, m1, f0):
    size = out.size
    np.divide(H, H_x, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.greater_equal(a, b, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(a, b, w0)
        np.maximum(w0, f0, out=w0)
        np.add(a, b, w1)
        np.multiply(w0, w1, w1)
        np.sqrt(w1, w1)
        np.divide(w1, a, w1)
        np.multiply(a, a, w0)
        np.greater(w1, C0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.power(w1, k, w2)
            np.multiply(w1, w2, w2)
        if some21 != size:
            np.copyto(w2, C0, where=~m1)
        np.multiply(w0, w2, w2)
        np.add(C2, k, w0)
        np.divide(w2, w0, w0)
        np.multiply(C0, b, w2)
        np.add(w0, w2, w2)
        np.divide(w2, R, w0)
    if some30 != size:
        np.copyto(w0, C1, where=~m0)
    np.multiply(out, w0, out)


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'b', 'H', 'H_x', 'k', 'mu'): {
        ('a',): Program(('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, scratch=2, masks=2, filled=(0.0,)),
        ('a', 'R', 'b', 'H', 'H_x', 'k', 'mu'): Program(('a', 'R', 'b', 'H', 'H_x', 'k', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, scratch=3, masks=2, filled=(0.0,)),
    },
}
