"""Programs of axicontact.loads.punch."""

from __future__ import annotations

from math import atan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(2.0)
C1 = np.array(3.141592653589793)


def displacement(r, a, p_0, E_star):
    if r.__class__ is a.__class__ is p_0.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (p_0 > 1e-30) and (p_0 < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            if r > a:
                return 2.0 * p_0 / E_star * a * atan(a / sqrt((r - a) * (a + r)))
            return 3.141592653589793 * p_0 / E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_displacement_r(a, p_0, E_star):
    v11 = (2.0) * p_0
    v12 = v11 / E_star
    v13 = v12 * a
    v16 = (3.141592653589793) * p_0
    v17 = v16 / E_star
    v18 = v17 * a
    return (a, v13, v18)


def block_displacement_r(out, r, a, v13, v18, t0, m0):
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
        np.multiply(v13, t0, out)
    if some20 != size:
        np.copyto(out, v18, where=~m0)


def prepare_displacement_all():
    return ()


def block_displacement_all(out, r, a, p_0, E_star, t0, m0):
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
        np.multiply(C0, p_0, out)
        np.divide(out, E_star, out)
        np.multiply(out, a, out)
        np.multiply(out, t0, out)
    if some20 != size:
        other20 = t0 if some20 else out
        np.multiply(C1, p_0, other20)
        np.divide(other20, E_star, other20)
        np.multiply(other20, a, other20)
        if some20:
            np.copyto(out, other20, where=~m0)


BLOCKS = {
    ('_displacement', 1, 'r', 'a', 'p_0', 'E_star'): {
        ('r',): (('r',), prepare_displacement_r, block_displacement_r, 1, 1, (), False),
        ('r', 'a', 'p_0', 'E_star'): (('r', 'a', 'p_0', 'E_star'), prepare_displacement_all, block_displacement_all, 1, 1, (), False),
    },
}
