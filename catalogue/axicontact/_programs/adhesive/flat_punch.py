"""Programs of axicontact.adhesive.flat_punch."""

from __future__ import annotations

from math import nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(6.283185307179586)
C1 = np.array(-2.0)
C2 = np.array(0.0)
C3 = np.array(2.0)
C4 = np.array(25.132741228718345)
C5 = np.array(np.nan)


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


def work_of_adhesion_from_pull_off(F, a, E_star):
    if F.__class__ is a.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v11 = -2.0 * a * sqrt(6.283185307179586 * E_star * 0.0 * a)
            if v11 >= F:
                v14 = (v11 - F) / a
                value = v14 * v14 / (25.132741228718345 * E_star * a)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_work_of_adhesion_from_pull_off_all_signed():
    return ()


def block_work_of_adhesion_from_pull_off_all_signed(out, F, a, E_star, t0, t1, m0):
    size = out.size
    np.multiply(C1, a, t0)
    np.multiply(C0, E_star, t1)
    np.multiply(t1, C2, t1)
    np.multiply(t1, a, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.greater_equal(t1, F, m0)
    some22 = np.count_nonzero(m0)
    if some22:
        np.subtract(t1, F, out)
        np.divide(out, a, out)
        np.square(out, out)
        np.multiply(C4, E_star, t0)
        np.multiply(t0, a, t0)
        np.divide(out, t0, out)
    if some22 != size:
        np.copyto(out, C5, where=~m0)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'E_star', 'dgamma'): {
        ('a', 'E_star', 'dgamma'): (('a', 'E_star', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, 1, 0, (), False),
    },
    ('_pull_off_force', 0, 'a', 'E_star', 'dgamma'): {
        ('a', 'E_star', 'dgamma'): (('a', 'E_star', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, 1, 0, (), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'a', 'E_star'): {
        ('F', 'a', 'E_star'): (('F', 'a', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 2, 1, (), False),
    },
}
