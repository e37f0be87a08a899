"""Programs of axicontact.graded.normal.polynomial."""

from __future__ import annotations

from math import pow

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._programs.bodies.graded.normal import polynomial as bodies

C0 = np.array(0.0)
C1 = np.array(2.0)
C2 = np.array(1.0)


def depth(a, k, A):
    if a.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._depth(a, A, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth_from_force(F, H, k, A):
    if F.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._depth_from_force(F, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, k, A):
    if r.__class__ is a.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._displacement(r, a, A, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, H, k, A):
    if a.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._force(a, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_from_depth(d, H, k, A):
    if d.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._force_from_depth(d, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, H, k, A):
    if a.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._mean_pressure(a, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, H, k, A):
    if r.__class__ is a.__class__ is H.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._pressure(r, a, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, k, A):
    if d.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_depth(d, A, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, H, k, A):
    if F.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_force(F, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, H, k):
    if a.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_a(H, k):
    v4 = (2.0) * H
    v6 = (1.0) + k
    v7 = v4 / v6
    return (k, v7)


def block_stiffness_a(out, a, k, v7, m0):
    size = out.size
    np.greater(a, C0, m0)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C0, where=~m0)
    np.multiply(v7, out, out)


def prepare_stiffness_all():
    return ()


def block_stiffness_all(out, a, H, k, t0, m0):
    size = out.size
    np.multiply(C1, H, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.add(C2, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C0, m0)
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C0, where=~m0)
    np.multiply(t0, out, out)


BLOCKS = {
    ('_stiffness', 1, 'a', 'H', 'k'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 1, (), False),
        ('a', 'H', 'k'): (('a', 'H', 'k'), prepare_stiffness_all, block_stiffness_all, 1, 1, (), False),
    },
}
