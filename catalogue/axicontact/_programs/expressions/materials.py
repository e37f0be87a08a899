"""Formulas of axicontact.materials over an array library `xp`."""

from ..._runtime.steps import rising


def effective_modulus(xp, E_1, nu_1, E_2, nu_2):
    return 1.0 / ((1.0 - nu_1) * (1.0 + nu_1) / E_1 + (1.0 - nu_2) * (1.0 + nu_2) / E_2)


def effective_shear_modulus(xp, E_1, nu_1, E_2, nu_2):
    return 2.0 / ((2.0 - nu_1) * (1.0 + nu_1) / E_1 + (2.0 - nu_2) * (1.0 + nu_2) / E_2)


def h_N(xp, k, nu):
    v1 = 1.0 + k
    v12 = xp.sin(3.141592653589793 * (1.0 - xp.absolute(k)) / 2.0)
    v14 = 1.0 - nu
    v19 = xp.sqrt(v1 * (v14 - k * nu) / v14)
    v24 = 3.0 + k
    v33 = rising(xp, 1.0, (v24 + v19) / 2.0 - 1.0) * rising(xp, 1.0, (v24 - v19) / 2.0 - 1.0)
    v13 = (v1 * rising(xp, 1.0, 1.0 + k / 2.0 - 1.0)) ** 2.0 * v12
    return v13 / (v19 * xp.sin(3.141592653589793 * v19 / 2.0) * v33)


def graded_modulus(xp, E_0, c_0, k, nu):
    return h_N(xp, k, nu) * E_0 / ((1.0 - nu) * (1.0 + nu) * c_0 ** k)
