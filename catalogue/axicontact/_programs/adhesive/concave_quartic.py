"""Programs of axicontact.adhesive.concave_quartic."""

from __future__ import annotations

from math import nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(-8.0)
C1 = np.array(3.0)
C2 = np.array(6.283185307179586)
C3 = np.array(-2.0)
C4 = np.array(64.0)
C5 = np.array(15.0)
C6 = np.array(0.0)
C7 = np.array(2.0)
C8 = np.array(25.132741228718345)
C9 = np.array(np.nan)


def pull_off_depth(a, h, E_star, dgamma):
    if a.__class__ is h.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return -8.0 * h / 3.0 - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_depth_all_signed():
    return ()


def block_pull_off_depth_all_signed(out, a, h, E_star, dgamma, t0, t1):
    np.multiply(C0, h, out)
    np.divide(out, C1, out)
    np.sqrt(a, t0)
    np.multiply(C2, dgamma, t1)
    np.divide(t1, E_star, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.subtract(out, t1, out)


def pull_off_force(a, h, E_star, dgamma):
    if a.__class__ is h.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            return -2.0 * a * sqrt(6.283185307179586 * E_star * dgamma * a) - 64.0 * E_star * h / 15.0 * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_force_all_signed():
    return ()


def block_pull_off_force_all_signed(out, a, h, E_star, dgamma, t0):
    np.multiply(C3, a, out)
    np.multiply(C2, E_star, t0)
    np.multiply(t0, dgamma, t0)
    np.multiply(t0, a, t0)
    np.sqrt(t0, t0)
    np.multiply(out, t0, t0)
    np.multiply(C4, E_star, out)
    np.multiply(out, h, out)
    np.divide(out, C5, out)
    np.multiply(out, a, out)
    np.subtract(t0, out, out)


def work_of_adhesion_from_pull_off(F, a, h, E_star):
    if F.__class__ is a.__class__ is h.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v19 = -2.0 * a * sqrt(6.283185307179586 * E_star * 0.0 * a) - 64.0 * E_star * h / 15.0 * a
            if v19 >= F:
                v22 = (v19 - F) / a
                value = v22 * v22 / (25.132741228718345 * E_star * a)
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


def block_work_of_adhesion_from_pull_off_all_signed(out, F, a, h, E_star, t0, t1, m0):
    size = out.size
    np.multiply(C3, a, t0)
    np.multiply(C2, E_star, t1)
    np.multiply(t1, C6, t1)
    np.multiply(t1, a, t1)
    np.sqrt(t1, t1)
    np.multiply(t0, t1, t1)
    np.multiply(C4, E_star, t0)
    np.multiply(t0, h, t0)
    np.divide(t0, C5, t0)
    np.multiply(t0, a, t0)
    np.subtract(t1, t0, t0)
    np.greater_equal(t0, F, m0)
    some30 = np.count_nonzero(m0)
    if some30:
        np.subtract(t0, F, out)
        np.divide(out, a, out)
        np.square(out, out)
        np.multiply(C8, E_star, t1)
        np.multiply(t1, a, t1)
        np.divide(out, t1, out)
    if some30 != size:
        np.copyto(out, C9, where=~m0)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'h', 'E_star', 'dgamma'): {
        ('a', 'h', 'E_star', 'dgamma'): (('a', 'h', 'E_star', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, 2, 0, (), False),
    },
    ('_pull_off_force', 0, 'a', 'h', 'E_star', 'dgamma'): {
        ('a', 'h', 'E_star', 'dgamma'): (('a', 'h', 'E_star', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, 1, 0, (), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'a', 'h', 'E_star'): {
        ('F', 'a', 'h', 'E_star'): (('F', 'a', 'h', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 2, 1, (), False),
    },
}
