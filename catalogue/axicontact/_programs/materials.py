"""Programs of axicontact.materials."""

from __future__ import annotations

from math import cbrt, sqrt

import numpy as np

from .._runtime.interface import largest, ordinary
from .._programs.bodies import materials as bodies

C0 = np.array(1.0)
C1 = np.array(2.0)
C2 = np.array(1.432394487827058)


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


def maugis_lambda(R, E_star, dgamma, sigma_0):
    if R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and R > 1e-30 and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v4 = sigma_0 / E_star
            return cbrt(1.432394487827058 * (v4 * v4) * (R * sigma_0 / dgamma))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_maugis_lambda_all_signed():
    return ()


def block_maugis_lambda_all_signed(out, R, E_star, dgamma, sigma_0, t0):
    np.divide(sigma_0, E_star, out)
    np.square(out, out)
    np.multiply(C2, out, out)
    np.multiply(R, sigma_0, t0)
    np.divide(t0, dgamma, t0)
    np.multiply(out, t0, t0)
    np.cbrt(t0, out)


def tabor(R, E_star, dgamma, z_0):
    if R.__class__ is E_star.__class__ is dgamma.__class__ is z_0.__class__ is float and R > 1e-30 and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (z_0 > 1e-30) and (z_0 < 1e+30):
        try:
            v6 = dgamma / E_star / z_0
            return cbrt(R / z_0 * (v6 * v6))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_tabor_all_signed():
    return ()


def block_tabor_all_signed(out, R, E_star, dgamma, z_0, t0):
    np.divide(R, z_0, out)
    np.divide(dgamma, E_star, t0)
    np.divide(t0, z_0, t0)
    np.square(t0, t0)
    np.multiply(out, t0, t0)
    np.cbrt(t0, out)


def transversely_isotropic_modulus(C_11, C_33, C_13, C_44):
    if C_11.__class__ is C_33.__class__ is C_13.__class__ is C_44.__class__ is float and C_11 > 1e-30 and (C_11 < 1e+30) and (C_33 > 1e-30) and (C_33 < 1e+30) and (C_13 > 1e-30) and (C_13 < 1e+30) and (C_44 > 1e-30) and (C_44 < 1e+30):
        try:
            v6 = C_11 * sqrt(C_33 / C_11)
            v7 = v6 + C_13
            return 2.0 * v7 * sqrt(C_44 / C_11 * ((v6 - C_13) / (v7 + 2.0 * C_44)))
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_transversely_isotropic_modulus_all_signed():
    return ()


def block_transversely_isotropic_modulus_all_signed(out, C_11, C_33, C_13, C_44, t0, t1, t2, t3):
    np.divide(C_33, C_11, out)
    np.sqrt(out, out)
    np.multiply(C_11, out, out)
    np.add(out, C_13, t0)
    np.subtract(out, C_13, out)
    np.multiply(C1, t0, t1)
    np.divide(C_44, C_11, t2)
    np.multiply(C1, C_44, t3)
    np.add(t0, t3, t3)
    np.divide(out, t3, t3)
    np.multiply(t2, t3, t3)
    np.sqrt(t3, t3)
    np.multiply(t1, t3, out)


BLOCKS = {
    ('_effective_modulus', 0, 'E_1', 'nu_1', 'E_2', 'nu_2'): {
        ('E_1', 'nu_1', 'E_2', 'nu_2'): (('E_1', 'nu_1', 'E_2', 'nu_2'), prepare_effective_modulus_all_signed, block_effective_modulus_all_signed, 2, 0, (), False),
    },
    ('_effective_shear_modulus', 0, 'E_1', 'nu_1', 'E_2', 'nu_2'): {
        ('E_1', 'nu_1', 'E_2', 'nu_2'): (('E_1', 'nu_1', 'E_2', 'nu_2'), prepare_effective_shear_modulus_all_signed, block_effective_shear_modulus_all_signed, 2, 0, (), False),
    },
    ('_maugis_lambda', 0, 'R', 'E_star', 'dgamma', 'sigma_0'): {
        ('R', 'E_star', 'dgamma', 'sigma_0'): (('R', 'E_star', 'dgamma', 'sigma_0'), prepare_maugis_lambda_all_signed, block_maugis_lambda_all_signed, 1, 0, (), False),
    },
    ('_tabor', 0, 'R', 'E_star', 'dgamma', 'z_0'): {
        ('R', 'E_star', 'dgamma', 'z_0'): (('R', 'E_star', 'dgamma', 'z_0'), prepare_tabor_all_signed, block_tabor_all_signed, 1, 0, (), False),
    },
    ('_transversely_isotropic_modulus', 0, 'C_11', 'C_33', 'C_13', 'C_44'): {
        ('C_11', 'C_33', 'C_13', 'C_44'): (('C_11', 'C_33', 'C_13', 'C_44'), prepare_transversely_isotropic_modulus_all_signed, block_transversely_isotropic_modulus_all_signed, 4, 0, (), False),
    },
}
