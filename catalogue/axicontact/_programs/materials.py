"""Programs of axicontact.materials."""

from __future__ import annotations

import numpy as np

from .._runtime.interface import largest, ordinary
from .._programs.bodies import materials as bodies

C0 = np.array(1.0)
C1 = np.array(2.0)


def effective_modulus(E_1, nu_1, E_2, nu_2):
    if E_1.__class__ is nu_1.__class__ is E_2.__class__ is nu_2.__class__ is float and E_1 > 1e-30 and (E_1 < 1e+30) and (nu_1 > 1e-30) and (nu_1 < 0.5) and (E_2 > 1e-30) and (E_2 < 1e+30) and (nu_2 > 1e-30) and (nu_2 < 0.5):
        try:
            return 1.0 / ((1.0 - nu_1) * (1.0 + nu_1) / E_1 + (1.0 - nu_2) * (1.0 + nu_2) / E_2)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_effective_modulus_all_signed():
    return ()


def block_effective_modulus_all_signed(out, E_1, nu_1, E_2, nu_2, t0, t1):
    np.subtract(C0, nu_1, out)
    np.add(C0, nu_1, t0)
    np.multiply(out, t0, t0)
    np.divide(t0, E_1, t0)
    np.subtract(C0, nu_2, out)
    np.add(C0, nu_2, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, E_2, t1)
    np.add(t0, t1, t1)
    np.divide(C0, t1, out)


def effective_shear_modulus(E_1, nu_1, E_2, nu_2):
    if E_1.__class__ is nu_1.__class__ is E_2.__class__ is nu_2.__class__ is float and E_1 > 1e-30 and (E_1 < 1e+30) and (nu_1 > 1e-30) and (nu_1 < 0.5) and (E_2 > 1e-30) and (E_2 < 1e+30) and (nu_2 > 1e-30) and (nu_2 < 0.5):
        try:
            return 2.0 / ((2.0 - nu_1) * (1.0 + nu_1) / E_1 + (2.0 - nu_2) * (1.0 + nu_2) / E_2)
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_effective_shear_modulus_all_signed():
    return ()


def block_effective_shear_modulus_all_signed(out, E_1, nu_1, E_2, nu_2, t0, t1):
    np.subtract(C1, nu_1, out)
    np.add(C0, nu_1, t0)
    np.multiply(out, t0, t0)
    np.divide(t0, E_1, t0)
    np.subtract(C1, nu_2, out)
    np.add(C0, nu_2, t1)
    np.multiply(out, t1, t1)
    np.divide(t1, E_2, t1)
    np.add(t0, t1, t1)
    np.divide(C1, t1, out)


def graded_modulus(E_0, c_0, k, nu):
    if E_0.__class__ is c_0.__class__ is k.__class__ is nu.__class__ is float and E_0 > 1e-30 and (E_0 < 1e+30) and (c_0 > 1e-30) and (c_0 < 1e+30) and (k > 1e-30) and (k < 1.0) and (nu > 1e-30) and (nu < 0.5):
        try:
            value = bodies._graded_modulus(E_0, c_0, k, nu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(E_0, c_0, k, nu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def h_N(k, nu):
    if k.__class__ is nu.__class__ is float and k > 1e-30 and (k < 1.0) and (nu > 1e-30) and (nu < 0.5):
        try:
            value = bodies._h_N(k, nu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(k, nu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_effective_modulus', 0, 'E_1', 'nu_1', 'E_2', 'nu_2'): {
        ('E_1', 'nu_1', 'E_2', 'nu_2'): (('E_1', 'nu_1', 'E_2', 'nu_2'), prepare_effective_modulus_all_signed, block_effective_modulus_all_signed, 2, 0, (), False),
    },
    ('_effective_shear_modulus', 0, 'E_1', 'nu_1', 'E_2', 'nu_2'): {
        ('E_1', 'nu_1', 'E_2', 'nu_2'): (('E_1', 'nu_1', 'E_2', 'nu_2'), prepare_effective_shear_modulus_all_signed, block_effective_shear_modulus_all_signed, 2, 0, (), False),
    },
}
