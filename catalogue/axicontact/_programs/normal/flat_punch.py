"""Programs of axicontact.normal.flat_punch."""

from __future__ import annotations

from math import atan, nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(3.141592653589793)
C2 = np.array(0.0)
C3 = np.array(np.nan)


def depth_from_force(F, a, E_star):
    if F.__class__ is a.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return F / (2.0 * E_star * a)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_depth_from_force_F(a, E_star):
    v4 = (2.0) * E_star
    v5 = v4 * a
    return (v5,)


def block_depth_from_force_F(out, F, v5):
    np.divide(F, v5, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError


def prepare_depth_from_force_all():
    return ()


def block_depth_from_force_all(out, F, a, E_star):
    np.multiply(C0, E_star, out)
    largest_F = largest(F)
    if largest_F == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)
    np.divide(F, out, out)


def displacement(r, d, a):
    if r.__class__ is d.__class__ is a.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            if r > a:
                return 2.0 * d * atan(a / sqrt((r - a) * (a + r))) / 3.141592653589793
            value = d - (0.0 if r <= a else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(d, a):
    v10 = (2.0) * d
    return (d, a, v10)


def block_displacement_r(out, r, d, a, v10, t0, m0, m1):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(r, a, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(a, t0, t0)
        np.arctan(t0, t0)
        np.multiply(v10, t0, t0)
        np.divide(t0, C1, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.less_equal(r, a, m1)
        some17 = np.count_nonzero(m1)
        if some17:
            np.copyto(other20, C2)
        if some17 != size:
            np.copyto(other20, C3, where=~m1)
        np.subtract(d, other20, other20)
        if some20:
            np.copyto(out, other20, where=~m0)


def prepare_displacement_r_d(a):
    return (a,)


def block_displacement_r_d(out, r, d, a, t0, m0, m1):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(r, a, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(a, t0, t0)
        np.arctan(t0, t0)
        np.multiply(C0, d, out)
        np.multiply(out, t0, t0)
        np.divide(t0, C1, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.less_equal(r, a, m1)
        some17 = np.count_nonzero(m1)
        if some17:
            np.copyto(other20, C2)
        if some17 != size:
            np.copyto(other20, C3, where=~m1)
        np.subtract(d, other20, other20)
        if some20:
            np.copyto(out, other20, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, d, a, t0, m0, m1):
    size = out.size
    np.greater(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    some20 = np.count_nonzero(m0)
    if some20:
        np.subtract(r, a, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.divide(a, t0, t0)
        np.arctan(t0, t0)
        np.multiply(C0, d, out)
        np.multiply(out, t0, t0)
        np.divide(t0, C1, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.less_equal(r, a, m1)
        some17 = np.count_nonzero(m1)
        if some17:
            np.copyto(other20, C2)
        if some17 != size:
            np.copyto(other20, C3, where=~m1)
        np.subtract(d, other20, other20)
        if some20:
            np.copyto(out, other20, where=~m0)


def energy(d, a, E_star):
    if d.__class__ is a.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return E_star * (d * d) * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_energy_d(a, E_star):
    return (a, E_star)


def block_energy_d(out, d, a, E_star):
    np.square(d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(E_star, out, out)
    np.multiply(out, a, out)


def prepare_energy_all():
    return ()


def block_energy_all(out, d, a, E_star):
    np.square(d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(E_star, out, out)
    np.multiply(out, a, out)


def force(d, a, E_star):
    if d.__class__ is a.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 2.0 * E_star * d * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_d(a, E_star):
    v4 = (2.0) * E_star
    return (a, v4)


def block_force_d(out, d, a, v4):
    np.multiply(v4, d, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(out, a, out)


def prepare_force_all():
    return ()


def block_force_all(out, d, a, E_star):
    np.multiply(C0, E_star, out)
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(out, d, out)
    np.multiply(out, a, out)


def load_within(r, d, a, E_star):
    if r.__class__ is d.__class__ is a.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v10 = 2.0 * E_star * d
            if r < a:
                return v10 * (r * r) / (sqrt((a - r) * (a + r)) + a)
            return v10 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_load_within_r(d, a, E_star):
    v9 = (2.0) * E_star
    v10 = v9 * d
    v16 = v10 * a
    return (a, v10, v16)


def block_load_within_r(out, r, a, v10, v16, t0, m0):
    size = out.size
    np.less(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some17 = np.count_nonzero(m0)
    if some17:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.square(r, out)
        np.multiply(v10, out, out)
        np.add(t0, a, t0)
        np.divide(out, t0, out)
    if some17 != size:
        np.copyto(out, v16, where=~m0)


def prepare_load_within_r_d(a, E_star):
    v9 = (2.0) * E_star
    return (a, v9)


def block_load_within_r_d(out, r, d, a, v9, t0, t1, m0):
    size = out.size
    np.multiply(v9, d, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.less(r, a, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.subtract(a, r, out)
        np.add(a, r, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.square(r, out)
        np.multiply(t0, out, out)
        np.add(t1, a, t1)
        np.divide(out, t1, out)
    if some17 != size:
        other17 = t1 if some17 else out
        np.multiply(t0, a, other17)
        if some17:
            np.copyto(out, other17, where=~m0)


def prepare_load_within_all():
    return ()


def block_load_within_all(out, r, d, a, E_star, t0, t1, m0):
    size = out.size
    np.multiply(C0, E_star, t0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.multiply(t0, d, t0)
    np.less(r, a, m0)
    some17 = np.count_nonzero(m0)
    if some17:
        np.subtract(a, r, out)
        np.add(a, r, t1)
        np.multiply(out, t1, t1)
        np.sqrt(t1, t1)
        np.square(r, out)
        np.multiply(t0, out, out)
        np.add(t1, a, t1)
        np.divide(out, t1, out)
    if some17 != size:
        other17 = t1 if some17 else out
        np.multiply(t0, a, other17)
        if some17:
            np.copyto(out, other17, where=~m0)


def pressure(r, d, a, E_star):
    if r.__class__ is d.__class__ is a.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r <= a and d > 0.0:
                return E_star * d / (3.141592653589793 * sqrt((a - r) * (a + r)))
            return 0.0
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pressure_r(d, a, E_star):
    v10 = np.greater(d, (0.0))
    v12 = E_star * d
    return (a, v10, v12)


def block_pressure_r(out, r, a, v10, v12, t0, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    np.bitwise_and(m0, v10, m0)
    some16 = np.count_nonzero(m0)
    if some16:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(C1, t0, t0)
        np.divide(v12, t0, out)
    if some16 != size:
        np.copyto(out, C2, where=~m0)


def prepare_pressure_r_d(a, E_star):
    return (a, E_star)


def block_pressure_r_d(out, r, d, a, E_star, t0, m0, m1):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.greater(d, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some16 = np.count_nonzero(m1)
    if some16:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(E_star, d, out)
        np.multiply(C1, t0, t0)
        np.divide(out, t0, out)
    if some16 != size:
        np.copyto(out, C2, where=~m1)


def prepare_pressure_all():
    return ()


def block_pressure_all(out, r, d, a, E_star, t0, m0, m1):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    largest_d = largest(d)
    if largest_d == np.inf:
        raise FloatingPointError
    np.greater(d, C2, m1)
    np.bitwise_and(m0, m1, m1)
    some16 = np.count_nonzero(m1)
    if some16:
        np.subtract(a, r, out)
        np.add(a, r, t0)
        np.multiply(out, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(E_star, d, out)
        np.multiply(C1, t0, t0)
        np.divide(out, t0, out)
    if some16 != size:
        np.copyto(out, C2, where=~m1)


def profile(r, a):
    if r.__class__ is a.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            if r <= a:
                return 0.0
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(a):
    return (a,)


def block_profile_r(out, r, a, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some5 = np.count_nonzero(m0)
    if some5:
        np.copyto(out, C2)
    if some5 != size:
        np.copyto(out, C3, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, a, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some5 = np.count_nonzero(m0)
    if some5:
        np.copyto(out, C2)
    if some5 != size:
        np.copyto(out, C3, where=~m0)


def stiffness(a, E_star):
    if a.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            return 2.0 * E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_all_signed():
    return ()


def block_stiffness_all_signed(out, a, E_star):
    np.multiply(C0, E_star, out)
    np.multiply(out, a, out)


BLOCKS = {
    ('_depth_from_force', 1, 'F', 'a', 'E_star'): {
        ('F',): (('F',), prepare_depth_from_force_F, block_depth_from_force_F, 0, 0, (), False),
        ('F', 'a', 'E_star'): (('F', 'a', 'E_star'), prepare_depth_from_force_all, block_depth_from_force_all, 0, 0, (), False),
    },
    ('_displacement', 2, 'r', 'd', 'a'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 1, 2, (), False),
        ('r', 'd'): (('r', 'd'), prepare_displacement_r_d, block_displacement_r_d, 1, 2, (), False),
        ('r', 'd', 'a'): (('r', 'd', 'a'), prepare_displacement_all, block_displacement_all, 1, 2, (), False),
    },
    ('_energy', 1, 'd', 'a', 'E_star'): {
        ('d',): (('d',), prepare_energy_d, block_energy_d, 0, 0, (), False),
        ('d', 'a', 'E_star'): (('d', 'a', 'E_star'), prepare_energy_all, block_energy_all, 0, 0, (), False),
    },
    ('_force', 1, 'd', 'a', 'E_star'): {
        ('d',): (('d',), prepare_force_d, block_force_d, 0, 0, (), False),
        ('d', 'a', 'E_star'): (('d', 'a', 'E_star'), prepare_force_all, block_force_all, 0, 0, (), False),
    },
    ('_load_within', 2, 'r', 'd', 'a', 'E_star'): {
        ('r',): (('r',), prepare_load_within_r, block_load_within_r, 1, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_load_within_r_d, block_load_within_r_d, 2, 1, (), False),
        ('r', 'd', 'a', 'E_star'): (('r', 'd', 'a', 'E_star'), prepare_load_within_all, block_load_within_all, 2, 1, (), False),
    },
    ('_pressure', 2, 'r', 'd', 'a', 'E_star'): {
        ('r',): (('r',), prepare_pressure_r, block_pressure_r, 1, 1, (), False),
        ('r', 'd'): (('r', 'd'), prepare_pressure_r_d, block_pressure_r_d, 1, 2, (), False),
        ('r', 'd', 'a', 'E_star'): (('r', 'd', 'a', 'E_star'), prepare_pressure_all, block_pressure_all, 1, 2, (), False),
    },
    ('_profile', 1, 'r', 'a'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 1, (), False),
        ('r', 'a'): (('r', 'a'), prepare_profile_all, block_profile_all, 0, 1, (), False),
    },
    ('_stiffness', 0, 'a', 'E_star'): {
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all_signed, block_stiffness_all_signed, 0, 0, (), False),
    },
}
