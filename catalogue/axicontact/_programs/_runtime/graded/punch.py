"""Programs of axicontact._runtime.graded.punch."""

from __future__ import annotations

from math import pow, sqrt

import numpy as np

from ...._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(6.283185307179586)


def graded_retraction(a, H, k, dgamma):
    if a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            if a > 0.0:
                value = sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_graded_retraction_all_signed():
    return ()


def block_graded_retraction_all_signed(out, a, H, k, dgamma, t0, m0):
    size = out.size
    np.greater(a, C0, m0)
    some16 = np.count_nonzero(m0)
    if some16:
        np.multiply(C1, dgamma, out)
        np.divide(out, H, out)
        np.sqrt(out, out)
        np.sqrt(a, t0)
        np.multiply(out, t0, t0)
        np.negative(k, out)
        np.power(a, out, out)
        np.sqrt(out, out)
        np.multiply(t0, out, out)
    if some16 != size:
        np.copyto(out, C0, where=~m0)


def prepare_graded_retraction_a(H, k, dgamma):
    v7 = (6.283185307179586) * dgamma
    v8 = v7 / H
    v9 = np.sqrt(v8)
    v12 = np.negative(k)
    return (v9, v12)


def block_graded_retraction_a(out, a, v9, v12, t0, m0):
    size = out.size
    np.greater(a, C0, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.sqrt(a, out)
        np.multiply(v9, out, out)
        np.power(a, v12, t0)
        np.sqrt(t0, t0)
        np.multiply(out, t0, out)
    if some16 != size:
        np.copyto(out, C0, where=~m0)


def prepare_graded_retraction_all():
    return ()


def block_graded_retraction_all(out, a, H, k, dgamma, t0, m0):
    size = out.size
    np.greater(a, C0, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some16 = np.count_nonzero(m0)
    if some16:
        np.multiply(C1, dgamma, out)
        np.divide(out, H, out)
        np.sqrt(out, out)
        np.sqrt(a, t0)
        np.multiply(out, t0, t0)
        np.negative(k, out)
        np.power(a, out, out)
        np.sqrt(out, out)
        np.multiply(t0, out, out)
    if some16 != size:
        np.copyto(out, C0, where=~m0)


BLOCKS = {
    ('graded_retraction', 0, 'a', 'H', 'k', 'dgamma'): {
        ('a', 'H', 'k', 'dgamma'): (('a', 'H', 'k', 'dgamma'), prepare_graded_retraction_all_signed, block_graded_retraction_all_signed, 1, 1, (), False),
    },
    ('graded_retraction', 1, 'a', 'H', 'k', 'dgamma'): {
        ('a',): (('a',), prepare_graded_retraction_a, block_graded_retraction_a, 1, 1, (), False),
        ('a', 'H', 'k', 'dgamma'): (('a', 'H', 'k', 'dgamma'), prepare_graded_retraction_all, block_graded_retraction_all, 1, 1, (), False),
    },
}
