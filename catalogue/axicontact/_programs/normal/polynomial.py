"""Programs of axicontact.normal.polynomial."""

from __future__ import annotations

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.normal import polynomial as bodies

C0 = np.array(2.0)


def depth(a, A):
    if a.__class__ is float and a > 1e-30 and (a < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._depth(a, A)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth_from_force(F, E_star, A):
    if F.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._depth_from_force(F, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, A):
    if r.__class__ is a.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._displacement(r, a, A)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(a, E_star, A):
    if a.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._energy(a, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, E_star, A):
    if a.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._force(a, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_from_depth(d, E_star, A):
    if d.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._force_from_depth(d, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, a, E_star, A):
    if r.__class__ is a.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._load_within(r, a, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def mean_pressure(a, E_star, A):
    if a.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._mean_pressure(a, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, E_star, A):
    if r.__class__ is a.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._pressure(r, a, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, A):
    if r.__class__ is float and r > 1e-30 and (r < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._profile(r, A)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(r):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, A):
    if d.__class__ is float and d > 1e-30 and (d < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_depth(d, A)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, E_star, A):
    if F.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_force(F, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, E_star):
    if a.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
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
    ('_stiffness', 1, 'a', 'E_star'): {
        ('a',): (('a',), prepare_stiffness_a, block_stiffness_a, 0, 0, (), False),
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all, block_stiffness_all, 0, 0, (), False),
    },
}
