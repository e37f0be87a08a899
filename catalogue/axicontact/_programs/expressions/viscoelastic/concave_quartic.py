"""Formulas of axicontact.viscoelastic.concave_quartic over an array library `xp`."""


def step_force_kelvin_voigt(xp, t, d, a, h, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 4.0 * h
    v3 = v2 / 3.0
    v4 = v3 * 0.999999999999999
    v5 = v4 <= d
    v6 = xp.where(v5, v4, 0.5 * d)
    v7 = 2.0 * a
    v8 = 8.0 * h
    v9 = v8 / 15.0
    v10 = d + v9
    v11 = v7 * v10
    v12 = xp.where(v5, 2.0 * d, v4)
    v13 = xp.where(v5, v11, xp.nan)
    v14 = v1 * v13
    return v14


def step_force_maxwell(xp, t, d, a, h, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 4.0 * h
    v5 = v4 / 3.0
    v6 = v5 * 0.999999999999999
    v7 = v6 <= d
    v8 = xp.where(v7, v6, 0.5 * d)
    v9 = 2.0 * a
    v10 = 8.0 * h
    v11 = v10 / 15.0
    v12 = d + v11
    v13 = v9 * v12
    v14 = xp.where(v7, 2.0 * d, v6)
    v15 = xp.where(v7, v13, xp.nan)
    v16 = v3 * v15
    return v16


def step_force_power_creep(xp, t, d, a, h, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = 4.0 * h
    v8 = v7 / 3.0
    v9 = v8 * 0.999999999999999
    v10 = v9 <= d
    v11 = xp.where(v10, v9, 0.5 * d)
    v12 = 2.0 * a
    v13 = 8.0 * h
    v14 = v13 / 15.0
    v15 = d + v14
    v16 = v12 * v15
    v17 = xp.where(v10, 2.0 * d, v9)
    v18 = xp.where(v10, v16, xp.nan)
    v19 = v6 * v18
    return v19


def step_force_standard_solid(xp, t, d, a, h, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 4.0 * h
    v6 = v5 / 3.0
    v7 = v6 * 0.999999999999999
    v8 = v7 <= d
    v9 = xp.where(v8, v7, 0.5 * d)
    v10 = 2.0 * a
    v11 = 8.0 * h
    v12 = v11 / 15.0
    v13 = d + v12
    v14 = v10 * v13
    v15 = xp.where(v8, 2.0 * d, v7)
    v16 = xp.where(v8, v14, xp.nan)
    v17 = v4 * v16
    return v17
