"""Programs of axicontact.adhesive.concave_power."""

from __future__ import annotations

from math import sqrt

import numpy as np

from ..._runtime.arrays.blocks import Program, largest

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


def block_pull_off_depth_all_signed(out, a, h, n, E_star, dgamma, w0, w1, w2, w3, m0):
    size = out.size
    np.multiply(n, C0, out)
    np.add(out, C0, out)
    np.add(out, C1, w0)
    np.add(out, C0, w1)
    np.add(out, C2, w2)
    np.multiply(w1, w2, w2)
    np.less(out, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(out, C3, w1)
        np.multiply(out, w1, w1)
        np.divide(w1, w2, w1)
    if some24 != size:
        other24 = w3 if some24 else w1
        np.add(out, C4, other24)
        np.divide(other24, w2, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(w1, other24, where=~m0)
    np.sqrt(w0, w2)
    np.multiply(w1, w2, w2)
    np.multiply(w0, w0, w0)
    np.divide(C3, w0, w0)
    np.multiply(C5, w0, w1)
    np.add(w1, C6, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C7, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C8, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C9, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C10, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C11, w1)
    np.multiply(C12, w0, out)
    np.add(out, C13, out)
    np.multiply(out, w0, out)
    np.add(out, C14, out)
    np.multiply(out, w0, out)
    np.add(out, C15, out)
    np.multiply(out, w0, out)
    np.add(out, C16, out)
    np.multiply(out, w0, out)
    np.add(out, C17, out)
    np.multiply(out, w0, out)
    np.add(out, C3, out)
    np.divide(w1, out, out)
    np.multiply(w0, out, out)
    np.add(C3, out, out)
    np.multiply(w2, out, out)
    np.multiply(C18, h, w2)
    np.multiply(w2, out, out)
    np.sqrt(a, w2)
    np.multiply(C19, dgamma, w0)
    np.divide(w0, E_star, w0)
    np.sqrt(w0, w0)
    np.multiply(w2, w0, w0)
    np.subtract(out, w0, out)


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


def block_pull_off_force_all_signed(out, a, h, n, E_star, dgamma, w0, w1, w2, w3, m0):
    size = out.size
    np.multiply(n, C0, out)
    np.add(out, C0, out)
    np.add(out, C1, w0)
    np.add(out, C0, w1)
    np.add(out, C2, w2)
    np.multiply(w1, w2, w2)
    np.less(out, C3, m0)
    some24 = np.count_nonzero(m0)
    if some24:
        np.add(out, C3, w1)
        np.multiply(out, w1, w1)
        np.divide(w1, w2, w1)
    if some24 != size:
        other24 = w3 if some24 else w1
        np.add(out, C4, other24)
        np.divide(other24, w2, other24)
        np.subtract(C3, other24, other24)
        if some24:
            np.copyto(w1, other24, where=~m0)
    np.sqrt(w0, w2)
    np.multiply(w1, w2, w2)
    np.multiply(w0, w0, w0)
    np.divide(C3, w0, w0)
    np.multiply(C5, w0, w1)
    np.add(w1, C6, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C7, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C8, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C9, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C10, w1)
    np.multiply(w1, w0, w1)
    np.add(w1, C11, w1)
    np.multiply(C12, w0, out)
    np.add(out, C13, out)
    np.multiply(out, w0, out)
    np.add(out, C14, out)
    np.multiply(out, w0, out)
    np.add(out, C15, out)
    np.multiply(out, w0, out)
    np.add(out, C16, out)
    np.multiply(out, w0, out)
    np.add(out, C17, out)
    np.multiply(out, w0, out)
    np.add(out, C3, out)
    np.divide(w1, out, out)
    np.multiply(w0, out, out)
    np.add(C3, out, out)
    np.multiply(w2, out, out)
    np.multiply(C20, a, w2)
    np.multiply(C19, E_star, w0)
    np.multiply(w0, dgamma, w0)
    np.multiply(w0, a, w0)
    np.sqrt(w0, w0)
    np.multiply(w2, w0, w0)
    np.multiply(C21, E_star, w2)
    np.multiply(w2, n, w2)
    np.multiply(w2, h, w2)
    np.add(n, C3, w1)
    np.divide(w2, w1, w1)
    np.multiply(w1, a, w1)
    np.multiply(w1, out, out)
    np.subtract(w0, out, out)


BLOCKS = {
    ('_pull_off_depth', 0, 'a', 'h', 'n', 'E_star', 'dgamma'): {
        ('a', 'h', 'n', 'E_star', 'dgamma'): Program(('a', 'h', 'n', 'E_star', 'dgamma'), prepare_pull_off_depth_all_signed, block_pull_off_depth_all_signed, scratch=4, masks=1),
    },
    ('_pull_off_force', 0, 'a', 'h', 'n', 'E_star', 'dgamma'): {
        ('a', 'h', 'n', 'E_star', 'dgamma'): Program(('a', 'h', 'n', 'E_star', 'dgamma'), prepare_pull_off_force_all_signed, block_pull_off_force_all_signed, scratch=4, masks=1),
    },
}
