"""Formulas of axicontact.viscoelastic.concave_paraboloid over an array library `xp`."""


def step_force_kelvin_voigt(xp, t, d, a, h, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 2.0 * h
    v3 = v2 * 0.999999999999999
    v4 = v3 <= d
    v5 = 2.0 * a
    v6 = v2 / 3.0
    v7 = d + v6
    v8 = v5 * v7
    v9 = xp.where(v4, v8, xp.nan)
    v10 = v1 * v9
    return v10


def step_force_maxwell(xp, t, d, a, h, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 2.0 * h
    v5 = v4 * 0.999999999999999
    v6 = v5 <= d
    v7 = 2.0 * a
    v8 = v4 / 3.0
    v9 = d + v8
    v10 = v7 * v9
    v11 = xp.where(v6, v10, xp.nan)
    v12 = v3 * v11
    return v12


def step_force_power_creep(xp, t, d, a, h, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = 2.0 * h
    v8 = v7 * 0.999999999999999
    v9 = v8 <= d
    v10 = 2.0 * a
    v11 = v7 / 3.0
    v12 = d + v11
    v13 = v10 * v12
    v14 = xp.where(v9, v13, xp.nan)
    v15 = v6 * v14
    return v15


def step_force_standard_solid(xp, t, d, a, h, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 2.0 * h
    v6 = v5 * 0.999999999999999
    v7 = v6 <= d
    v8 = 2.0 * a
    v9 = v5 / 3.0
    v10 = d + v9
    v11 = v8 * v10
    v12 = xp.where(v7, v11, xp.nan)
    v13 = v4 * v12
    return v13
