"""Formulas of axicontact.materials over an array library `xp`."""


def effective_modulus(xp, E_1, nu_1, E_2, nu_2):
    v0 = 1.0 - nu_1
    v1 = 1.0 + nu_1
    v2 = v0 * v1
    v3 = v2 / E_1
    v4 = 1.0 - nu_2
    v5 = 1.0 + nu_2
    v6 = v4 * v5
    v7 = v6 / E_2
    v8 = v3 + v7
    v9 = 1.0 / v8
    return v9


def effective_shear_modulus(xp, E_1, nu_1, E_2, nu_2):
    v0 = 2.0 - nu_1
    v1 = 1.0 + nu_1
    v2 = v0 * v1
    v3 = v2 / E_1
    v4 = 2.0 - nu_2
    v5 = 1.0 + nu_2
    v6 = v4 * v5
    v7 = v6 / E_2
    v8 = v3 + v7
    v9 = 2.0 / v8
    return v9
