"""Formulas of axicontact.viscoelastic.concave_paraboloid over an array library `xp`."""


def step_force_kelvin_voigt(xp, t, d, a, h, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 2.0 * h
    v3 = v2 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v6 = 2.0 * a
    v7 = v2 / 3.0
    v8 = d + v7
    v9 = v6 * v8
    v10 = xp.where(v4, 2.0 * d, v3)
    v11 = xp.where(v4, v9, xp.nan)
    v12 = v1 * v11
    return v12


def step_force_maxwell(xp, t, d, a, h, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 2.0 * h
    v5 = v4 * 0.999999999999999
    v6 = v5 <= d
    v7 = xp.where(v6, v5, 0.5 * d)
    v8 = 2.0 * a
    v9 = v4 / 3.0
    v10 = d + v9
    v11 = v8 * v10
    v12 = xp.where(v6, 2.0 * d, v5)
    v13 = xp.where(v6, v11, xp.nan)
    v14 = v3 * v13
    return v14


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
    v10 = xp.where(v9, v8, 0.5 * d)
    v11 = 2.0 * a
    v12 = v7 / 3.0
    v13 = d + v12
    v14 = v11 * v13
    v15 = xp.where(v9, 2.0 * d, v8)
    v16 = xp.where(v9, v14, xp.nan)
    v17 = v6 * v16
    return v17


def step_force_standard_solid(xp, t, d, a, h, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 2.0 * h
    v6 = v5 * 0.999999999999999
    v7 = v6 <= d
    v8 = xp.where(v7, v6, 0.5 * d)
    v9 = 2.0 * a
    v10 = v5 / 3.0
    v11 = d + v10
    v12 = v9 * v11
    v13 = xp.where(v7, 2.0 * d, v6)
    v14 = xp.where(v7, v12, xp.nan)
    v15 = v4 * v14
    return v15
