"""Programs of axicontact.adhesive.concave_paraboloid."""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(-2.0)
C1 = np.array(6.283185307179586)
C2 = np.array(8.0)
C3 = np.array(3.0)


def pull_off_depth(a, h, E_star, dgamma):
    if a.__class__ is h.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return -2.0 * h - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_depth_all_signed():
    return ()


def block_pull_off_depth_all_signed(out, a, h, E_star, dgamma, t0, t1):
    np.multiply(C0, h, out)
    np.sqrt(a, t0)
    np.multiply(C1, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def pull_off_force(a, h, E_star, dgamma):
    if a.__class__ is h.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return -2.0 * a * sqrt(6.283185307179586 * E_star * dgamma * a) - 8.0 * E_star * h / 3.0 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_force_all_signed():
    return ()


def block_pull_off_force_all_signed(out, a, h, E_star, dgamma, t0):
    np.multiply(C0, a, out)
    np.multiply(C1, E_star, t0)
    np.multiply(t0, dgamma, t0)
    np.multiply(t0, a, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, t0)
    np.multiply(C2, E_star, out)
    np.multiply(out, h, out)
    np.divide(out, C3, out)
    np.multiply(out, a, out)
    np.subtract(t0, out, out)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'h', 'E_star', 'dgamma'): {
        ('a', 'h', 'E_star', 'dgamma'): (('a', 'h', 'E_star', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, 2, 0, (), False),
    },
    ('_pull_off_force', 0, 'a', 'h', 'E_star', 'dgamma'): {
        ('a', 'h', 'E_star', 'dgamma'): (('a', 'h', 'E_star', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, 1, 0, (), False),
    },
}
