"""Programs of axicontact.adhesive.concave_power."""

from __future__ import annotations

from math import nan, sqrt

import numpy as np

from ..._runtime.interface import largest

C0 = np.array(0.5)
C1 = np.array(1.75)
C2 = np.array(1.5)
C3 = np.array(1.0)
C4 = np.array(0.75)
C5 = np.array(0.01524698625788054)
C6 = np.array(0.5334320651111477)
C7 = np.array(2.250488865813539)
C8 = np.array(2.8612106440066865)
C9 = np.array(1.3794681629043655)
C10 = np.array(0.2596058532893223)
C11 = np.array(0.015624999999999823)
C12 = np.array(3.278794792785737)
C13 = np.array(49.328555418276075)
C14 = np.array(167.28648538571198)
C15 = np.array(195.37226190335065)
C16 = np.array(90.69722535867314)
C17 = np.array(16.763212110504565)
C18 = np.array(-1.7724538509055159)
C19 = np.array(6.283185307179586)
C20 = np.array(-2.0)
C21 = np.array(3.5449077018110318)
C22 = np.array(0.0)
C23 = np.array(2.0)
C24 = np.array(25.132741228718345)
C25 = np.array(np.nan)


def pull_off_depth(a, h, n, E_star, dgamma):
    if a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            return -1.7724538509055159 * h * ((v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))) - sqrt(a) * sqrt(6.283185307179586 * dgamma / E_star)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_depth_all_signed():
    return ()


def block_pull_off_depth_all_signed(out, a, h, n, E_star, dgamma, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C0, out)
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some24 != size:
        other24 = t3 if some24 else t1
        np.add(out, C4, other24)
        np.divide(other24, t2, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(t1, other24, where=~m0)
    np.sqrt(t0, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t0, t0)
    np.divide(C3, t0, t0)
    np.multiply(C5, t0, t1)
    np.add(t1, C6, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C7, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C8, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C9, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C10, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C11, t1)
    np.multiply(C12, t0, out)
    np.add(out, C13, out)
    np.multiply(out, t0, out)
    np.add(out, C14, out)
    np.multiply(out, t0, out)
    np.add(out, C15, out)
    np.multiply(out, t0, out)
    np.add(out, C16, out)
    np.multiply(out, t0, out)
    np.add(out, C17, out)
    np.multiply(out, t0, out)
    np.add(out, C3, out)
    np.divide(t1, out, out)
    np.multiply(t0, out, out)
    np.add(C3, out, out)
    np.multiply(t2, out, out)
    np.multiply(C18, h, t2)
    np.multiply(t2, out, out)
    np.sqrt(a, t2)
    np.multiply(C19, dgamma, t0)
    np.divide(t0, E_star, t0)
    np.sqrt(t0, t0)
    np.multiply(t2, t0, t0)
    np.subtract(out, t0, out)


def pull_off_force(a, h, n, E_star, dgamma):
    if a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            return -2.0 * a * sqrt(6.283185307179586 * E_star * dgamma * a) - 3.5449077018110318 * E_star * n * h / (n + 1.0) * a * ((v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0))))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_pull_off_force_all_signed():
    return ()


def block_pull_off_force_all_signed(out, a, h, n, E_star, dgamma, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C0, out)
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some24 != size:
        other24 = t3 if some24 else t1
        np.add(out, C4, other24)
        np.divide(other24, t2, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(t1, other24, where=~m0)
    np.sqrt(t0, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t0, t0)
    np.divide(C3, t0, t0)
    np.multiply(C5, t0, t1)
    np.add(t1, C6, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C7, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C8, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C9, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C10, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C11, t1)
    np.multiply(C12, t0, out)
    np.add(out, C13, out)
    np.multiply(out, t0, out)
    np.add(out, C14, out)
    np.multiply(out, t0, out)
    np.add(out, C15, out)
    np.multiply(out, t0, out)
    np.add(out, C16, out)
    np.multiply(out, t0, out)
    np.add(out, C17, out)
    np.multiply(out, t0, out)
    np.add(out, C3, out)
    np.divide(t1, out, out)
    np.multiply(t0, out, out)
    np.add(C3, out, out)
    np.multiply(t2, out, out)
    np.multiply(C20, a, t2)
    np.multiply(C19, E_star, t0)
    np.multiply(t0, dgamma, t0)
    np.multiply(t0, a, t0)
    np.sqrt(t0, t0)
    np.multiply(t2, t0, t0)
    np.multiply(C21, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, h, t2)
    np.add(n, C3, t1)
    np.divide(t2, t1, t1)
    np.multiply(t1, a, t1)
    np.multiply(t1, out, out)
    np.subtract(t0, out, out)


def work_of_adhesion_from_pull_off(F, a, h, n, E_star):
    if F.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            v87 = -2.0 * a * sqrt(6.283185307179586 * E_star * 0.0 * a) - 3.5449077018110318 * E_star * n * h / (n + 1.0) * a * ((v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0))))
            if v87 >= F:
                v90 = (v87 - F) / a
                value = v90 * v90 / (25.132741228718345 * E_star * a)
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


def block_work_of_adhesion_from_pull_off_all_signed(out, F, a, h, n, E_star, t0, t1, t2, t3, t4, m0):
    size = out.size
    np.multiply(n, C0, t0)
    np.add(t0, C0, t0)
    np.add(t0, C1, t1)
    np.add(t0, C0, t2)
    np.add(t0, C2, t3)
    np.multiply(t2, t3, t3)
    np.less(t0, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(t0, C3, t2)
        np.multiply(t0, t2, t2)
        np.divide(t2, t3, t2)
    if some24 != size:
        other24 = t4 if some24 else t2
        np.add(t0, C4, other24)
        np.divide(other24, t3, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(t2, other24, where=~m0)
    np.sqrt(t1, t3)
    np.multiply(t2, t3, t3)
    np.multiply(t1, t1, t1)
    np.divide(C3, t1, t1)
    np.multiply(C5, t1, t2)
    np.add(t2, C6, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C7, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C8, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C9, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C10, t2)
    np.multiply(t2, t1, t2)
    np.add(t2, C11, t2)
    np.multiply(C12, t1, t0)
    np.add(t0, C13, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C14, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C15, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C16, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C17, t0)
    np.multiply(t0, t1, t0)
    np.add(t0, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.add(C3, t0, t0)
    np.multiply(t3, t0, t0)
    np.multiply(C20, a, t3)
    np.multiply(C19, E_star, t1)
    np.multiply(t1, C22, t1)
    np.multiply(t1, a, t1)
    np.sqrt(t1, t1)
    np.multiply(t3, t1, t1)
    np.multiply(C21, E_star, t3)
    np.multiply(t3, n, t3)
    np.multiply(t3, h, t3)
    np.add(n, C3, t2)
    np.divide(t3, t2, t2)
    np.multiply(t2, a, t2)
    np.multiply(t2, t0, t0)
    np.subtract(t1, t0, t0)
    np.greater_equal(t0, F, m0)
    some97 = np.count_nonzero(m0)
    if some97:
        np.subtract(t0, F, out)
        np.divide(out, a, out)
        np.square(out, out)
        np.multiply(C24, E_star, t1)
        np.multiply(t1, a, t1)
        np.divide(out, t1, out)
    if some97 != size:
        np.copyto(out, C25, where=~m0)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'h', 'n', 'E_star', 'dgamma'): {
        ('a', 'h', 'n', 'E_star', 'dgamma'): (('a', 'h', 'n', 'E_star', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, 4, 1, (), False),
    },
    ('_pull_off_force', 0, 'a', 'h', 'n', 'E_star', 'dgamma'): {
        ('a', 'h', 'n', 'E_star', 'dgamma'): (('a', 'h', 'n', 'E_star', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, 4, 1, (), False),
    },
    ('_work_of_adhesion_from_pull_off', 0, 'F', 'a', 'h', 'n', 'E_star'): {
        ('F', 'a', 'h', 'n', 'E_star'): (('F', 'a', 'h', 'n', 'E_star'), prepare_work_of_adhesion_from_pull_off_all_signed, block_work_of_adhesion_from_pull_off_all_signed, 5, 1, (), False),
    },
}
