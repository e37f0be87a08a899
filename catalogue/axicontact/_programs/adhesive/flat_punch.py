"""Programs of axicontact.adhesive.flat_punch."""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(6.283185307179586)
C1 = np.array(-2.0)


def pull_off_depth(a, E_star, dgamma):
    if a.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return -(sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_depth_all_signed():
    return ()


def block_pull_off_depth_all_signed(out, a, E_star, dgamma, t0):
    np.sqrt(a, out)
    np.multiply(C0, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, t0)
    np.negative(t0, out)


def pull_off_force(a, E_star, dgamma):
    if a.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return -2.0 * a * sqrt(6.283185307179586 * E_star * dgamma * a)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_force_all_signed():
    return ()


def block_pull_off_force_all_signed(out, a, E_star, dgamma, t0):
    np.multiply(C1, a, out)
    np.multiply(C0, E_star, t0)
    np.multiply(t0, dgamma, t0)
    np.multiply(t0, a, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, out)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'E_star', 'dgamma'): {
        ('a', 'E_star', 'dgamma'): (('a', 'E_star', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, 1, 0, (), False),
    },
    ('_pull_off_force', 0, 'a', 'E_star', 'dgamma'): {
        ('a', 'E_star', 'dgamma'): (('a', 'E_star', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, 1, 0, (), False),
    },
}
