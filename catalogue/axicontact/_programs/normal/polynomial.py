"""Programs of axicontact.normal.polynomial."""

from __future__ import annotations

import numpy as np

from ..._runtime.arrays.blocks import Program, largest

C0 = np.array(2.0)


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
        ('a',): Program(('a',), prepare_stiffness_a, block_stiffness_a),
        ('a', 'E_star'): Program(('a', 'E_star'), prepare_stiffness_all, block_stiffness_all),
    },
}
