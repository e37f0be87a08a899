"""Programs of axicontact._runtime.physics.adhesion."""

from __future__ import annotations

from math import sqrt

import numpy as np

from ...._runtime.interface import largest

C0 = np.array(6.283185307179586)


def hess_retraction(a, E_star, dgamma):
    if a.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_hess_retraction_all_signed():
    return ()


def block_hess_retraction_all_signed(out, a, E_star, dgamma, t0):
    np.sqrt(a, out)
    np.multiply(C0, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, out)


def prepare_hess_retraction_a(E_star, dgamma):
    v5 = (6.283185307179586) * dgamma
    v6 = v5 / E_star
    v7 = np.sqrt(v6)
    return (v7,)


def block_hess_retraction_a(out, a, v7):
    np.sqrt(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(out, v7, out)


def prepare_hess_retraction_all():
    return ()


def block_hess_retraction_all(out, a, E_star, dgamma, t0):
    np.sqrt(a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(C0, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, out)


BLOCKS = {
    ('hess_retraction', 0, 'a', 'E_star', 'dgamma'): {
        ('a', 'E_star', 'dgamma'): (('a', 'E_star', 'dgamma'), prepare_hess_retraction_all_signed, block_hess_retraction_all_signed, 1, 0, (), False),
    },
    ('hess_retraction', 1, 'a', 'E_star', 'dgamma'): {
        ('a',): (('a',), prepare_hess_retraction_a, block_hess_retraction_a, 0, 0, (), False),
        ('a', 'E_star', 'dgamma'): (('a', 'E_star', 'dgamma'), prepare_hess_retraction_all, block_hess_retraction_all, 1, 0, (), False),
    },
}
