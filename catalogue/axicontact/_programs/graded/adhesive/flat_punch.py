"""Programs of axicontact.graded.adhesive.flat_punch."""

from __future__ import annotations

from math import nan, pow, sqrt

import numpy as np

from ...._runtime.interface import largest

C0 = np.array(0.0)
C1 = np.array(6.283185307179586)
C2 = np.array(2.0)
C3 = np.array(1.0)
C4 = np.array(12.566370614359172)
C5 = np.array(np.nan)


def pull_off_depth(a, H, k, dgamma):
    if a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = -(sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_depth_all_signed():
    return ()


def block_pull_off_depth_all_signed(out, a, H, k, dgamma, t0, m0):
    size = out.size
    np.greater(a, C0, m0)
    some16 = np.count_nonzero(m0)
    if some16:
        np.multiply(C1, dgamma, out)
        np.divide(out, H, out)
        np.sqrt(out, out)
        np.sqrt(a, t0)
        np.multiply(out, t0, t0)
        np.negative(k, out)
        np.power(a, out, out)
        np.sqrt(out, out)
        np.multiply(t0, out, out)
    if some16 != size:
        np.copyto(out, C0, where=~m0)
    np.negative(out, out)


def pull_off_force(a, H, k, dgamma):
    if a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v10 = a > 0.0
            value = -(2.0 * H / (1.0 + k) * (a * pow(a, k) if v10 else 0.0)) * (sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if v10 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_force_all_signed():
    return ()


def block_pull_off_force_all_signed(out, a, H, k, dgamma, t0, t1, m0):
    size = out.size
    np.multiply(C2, H, out)
    np.add(C3, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C0, m0)
    some13 = np.count_nonzero(m0)
    if some13:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some13 != size:
        np.copyto(out, C0, where=~m0)
    np.multiply(t0, out, out)
    np.negative(out, out)
    some26 = np.count_nonzero(m0)
    if some26:
        np.multiply(C1, dgamma, t0)
        np.divide(t0, H, t0)
        np.sqrt(t0, t0)
        np.sqrt(a, t1)
        np.multiply(t0, t1, t1)
        np.negative(k, t0)
        np.power(a, t0, t0)
        np.sqrt(t0, t0)
        np.multiply(t1, t0, t0)
    if some26 != size:
        np.copyto(t0, C0, where=~m0)
    np.multiply(out, t0, out)


def work_of_adhesion_from_pull_off(F, a, H, k):
    if F.__class__ is a.__class__ is H.__class__ is k.__class__ is float and F > -1e+30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            v7 = 1.0 + k
            v10 = a > 0.0
            v14 = 2.0 * H / v7 * (a * pow(a, k) if v10 else 0.0)
            v25 = -v14 * (sqrt(0.0 / H) * sqrt(a) * sqrt(pow(a, -k)) if v10 else 0.0)
            if v25 >= F:
                v27 = v25 - F
                value = v7 / 12.566370614359172 * (v27 / v14) * (v27 / a / a)
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


def block_work_of_adhesion_from_pull_off_all_signed(out, F, a, H, k, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.multiply(C2, H, t0)
    np.add(C3, k, t1)
    np.divide(t0, t1, t0)
    np.greater(a, C0, m0)
    some13 = np.count_nonzero(m0)
    if some13:
        np.power(a, k, t2)
        np.multiply(a, t2, t2)
    if some13 != size:
        np.copyto(t2, C0, where=~m0)
    np.multiply(t0, t2, t2)
    np.negative(t2, t0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.divide(C0, H, t3)
        np.sqrt(t3, t3)
        np.sqrt(a, t4)
        np.multiply(t3, t4, t4)
        np.negative(k, t3)
        np.power(a, t3, t3)
        np.sqrt(t3, t3)
        np.multiply(t4, t3, t3)
    if some24 != size:
        np.copyto(t3, C0, where=~m0)
    np.multiply(t0, t3, t3)
    np.greater_equal(t3, F, m0)
    some36 = np.count_nonzero(m0)
    if some36:
        np.subtract(t3, F, out)
        np.divide(t1, C4, t0)
        np.divide(out, t2, t4)
        np.multiply(t0, t4, t4)
        np.divide(out, a, out)
        np.divide(out, a, out)
        np.multiply(t4, out, out)
    if some36 != size:
        np.copyto(out, C5, where=~m0)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'H', 'k', 'dgamma'): {
        ('a', 'H', 'k', 'dgamma'): (('a', 'H', 'k', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, 1, 1, (), False),
    },
    ('_pull_off_force', 0, 'a', 'H', 'k', 'dgamma'): {
        ('a', 'H', 'k', 'dgamma'): (('a', 'H', 'k', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, 2, 1, (), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'a', 'H', 'k'): {
        ('F', 'a', 'H', 'k'): (('F', 'a', 'H', 'k'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 5, 1, (), False),
    },
}
