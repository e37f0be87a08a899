"""Formulas of axicontact.materials over an array library `xp`."""

from ..._runtime.steps import rising


def effective_modulus(xp, E_1, nu_1, E_2, nu_2):
    return 1.0 / ((1.0 - nu_1) * (1.0 + nu_1) / E_1 + (1.0 - nu_2) * (1.0 + nu_2) / E_2)


def transversely_isotropic_modulus(xp, C_11, C_33, C_13, C_44):
    v3 = C_11 * xp.sqrt(C_33 / C_11)
    v4 = v3 + C_13
    return 2.0 * v4 * xp.sqrt(C_44 / C_11 * ((v3 - C_13) / (v4 + 2.0 * C_44)))


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


def tabor(xp, R, E_star, dgamma, z_0):
    return xp.cbrt(R / z_0 * (dgamma / E_star / z_0) ** 2.0)


def maugis_lambda(xp, R, E_star, dgamma, sigma_0):
    return xp.cbrt(1.432394487827058 * (sigma_0 / E_star) ** 2.0 * (R * sigma_0 / dgamma))
