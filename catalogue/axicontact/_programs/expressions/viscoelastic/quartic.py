"""Formulas of axicontact.viscoelastic.quartic over an array library `xp`."""


def ramp_force_kelvin_voigt(xp, t, v, A, E, eta):
    v0 = t == 0.0
    v1 = v * t
    v2 = 0.8 * v1
    v3 = 6.0 * v1
    v4 = v3 / A
    v5 = xp.sqrt(v4)
    v6 = xp.sqrt(v5)
    v7 = v2 * v6
    v8 = eta * 1.25
    v9 = v8 / t
    v10 = E + v9
    v11 = v7 * v10
    v12 = xp.where(v0, 0.0, v11)
    return v12


def step_force_kelvin_voigt(xp, t, d, A, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 0.8 * d
    v3 = 6.0 * d
    v4 = v3 / A
    v5 = xp.sqrt(v4)
    v6 = xp.sqrt(v5)
    v7 = v2 * v6
    v8 = v1 * v7
    return v8


def step_force_maxwell(xp, t, d, A, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 0.8 * d
    v5 = 6.0 * d
    v6 = v5 / A
    v7 = xp.sqrt(v6)
    v8 = xp.sqrt(v7)
    v9 = v4 * v8
    v10 = v3 * v9
    return v10


def step_force_power_creep(xp, t, d, A, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = 0.8 * d
    v8 = 6.0 * d
    v9 = v8 / A
    v10 = xp.sqrt(v9)
    v11 = xp.sqrt(v10)
    v12 = v7 * v11
    v13 = v6 * v12
    return v13


def step_force_standard_solid(xp, t, d, A, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 0.8 * d
    v6 = 6.0 * d
    v7 = v6 / A
    v8 = xp.sqrt(v7)
    v9 = xp.sqrt(v8)
    v10 = v5 * v9
    v11 = v4 * v10
    return v11


def step_load_radius_kelvin_voigt(xp, t, F, A, E, eta):
    v0 = -E
    v1 = v0 * t
    v2 = v1 / eta
    v3 = xp.expm1(v2)
    v4 = -v3
    v5 = v4 / E
    v6 = F * v5
    v7 = 15.0 * v6
    v8 = 64.0 * A
    v9 = v7 / v8
    v10 = v9 > 0.0
    v11 = v9 < xp.inf
    v12 = v10 & v11
    v13 = v9 ** 0.2
    v14 = v13 ** 5.0
    v15 = v13 ** 0.0
    v16 = v14 * v15
    v17 = v9 / v16
    v18 = v17 - 1.0
    v19 = v18 / 5.0
    v20 = v13 * v19
    v21 = v13 + v20
    v22 = xp.where(v12, v21, v13)
    return v22


def step_load_radius_maxwell(xp, t, F, A, E, tau):
    v0 = t / tau
    v1 = 1.0 + v0
    v2 = v1 / E
    v3 = F * v2
    v4 = 15.0 * v3
    v5 = 64.0 * A
    v6 = v4 / v5
    v7 = v6 > 0.0
    v8 = v6 < xp.inf
    v9 = v7 & v8
    v10 = v6 ** 0.2
    v11 = v10 ** 5.0
    v12 = v10 ** 0.0
    v13 = v11 * v12
    v14 = v6 / v13
    v15 = v14 - 1.0
    v16 = v15 / 5.0
    v17 = v10 * v16
    v18 = v10 + v17
    v19 = xp.where(v9, v18, v10)
    return v19


def step_load_radius_power_creep(xp, t, F, A, E, alpha, t_0):
    v0 = t / t_0
    v1 = v0 ** alpha
    v2 = v1 / E
    v3 = F * v2
    v4 = 15.0 * v3
    v5 = 64.0 * A
    v6 = v4 / v5
    v7 = v6 > 0.0
    v8 = v6 < xp.inf
    v9 = v7 & v8
    v10 = v6 ** 0.2
    v11 = v10 ** 5.0
    v12 = v10 ** 0.0
    v13 = v11 * v12
    v14 = v6 / v13
    v15 = v14 - 1.0
    v16 = v15 / 5.0
    v17 = v10 * v16
    v18 = v10 + v17
    v19 = xp.where(v9, v18, v10)
    return v19


def step_load_radius_standard_solid(xp, t, F, A, E_inf, E_1, tau):
    v0 = E_inf + E_1
    v1 = 1.0 / v0
    v2 = E_1 / v0
    v3 = t / tau
    v4 = E_inf / v0
    v5 = v3 * v4
    v6 = -v5
    v7 = xp.expm1(v6)
    v8 = v2 * v7
    v9 = v8 / E_inf
    v10 = v1 - v9
    v11 = F * v10
    v12 = 15.0 * v11
    v13 = 64.0 * A
    v14 = v12 / v13
    v15 = v14 > 0.0
    v16 = v14 < xp.inf
    v17 = v15 & v16
    v18 = v14 ** 0.2
    v19 = v18 ** 5.0
    v20 = v18 ** 0.0
    v21 = v19 * v20
    v22 = v14 / v21
    v23 = v22 - 1.0
    v24 = v23 / 5.0
    v25 = v18 * v24
    v26 = v18 + v25
    v27 = xp.where(v17, v26, v18)
    return v27
