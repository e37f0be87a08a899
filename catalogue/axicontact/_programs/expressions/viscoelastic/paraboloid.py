"""Formulas of axicontact.viscoelastic.paraboloid over an array library `xp`."""


def ramp_force_kelvin_voigt(xp, t, v, R, E, eta):
    v0 = t == 0.0
    v1 = v * t
    v2 = 1.3333333333333333 * v1
    v3 = R * v1
    v4 = xp.sqrt(v3)
    v5 = v2 * v4
    v6 = eta * 1.5
    v7 = v6 / t
    v8 = E + v7
    v9 = v5 * v8
    v10 = xp.where(v0, 0.0, v9)
    return v10


def step_force_kelvin_voigt(xp, t, d, R, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 1.3333333333333333 * d
    v3 = R * d
    v4 = xp.sqrt(v3)
    v5 = v2 * v4
    v6 = v1 * v5
    return v6


def step_force_maxwell(xp, t, d, R, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 1.3333333333333333 * d
    v5 = R * d
    v6 = xp.sqrt(v5)
    v7 = v4 * v6
    v8 = v3 * v7
    return v8


def step_force_power_creep(xp, t, d, R, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = 1.3333333333333333 * d
    v8 = R * d
    v9 = xp.sqrt(v8)
    v10 = v7 * v9
    v11 = v6 * v10
    return v11


def step_force_standard_solid(xp, t, d, R, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 1.3333333333333333 * d
    v6 = R * d
    v7 = xp.sqrt(v6)
    v8 = v5 * v7
    v9 = v4 * v8
    return v9


def step_load_radius_kelvin_voigt(xp, t, F, R, E, eta):
    v0 = 3.0 * R
    v1 = v0 / 4.0
    v2 = -E
    v3 = v2 * t
    v4 = v3 / eta
    v5 = xp.expm1(v4)
    v6 = -v5
    v7 = v6 / E
    v8 = F * v7
    v9 = v1 * v8
    v10 = xp.cbrt(v9)
    return v10


def step_load_radius_maxwell(xp, t, F, R, E, tau):
    v0 = 3.0 * R
    v1 = v0 / 4.0
    v2 = t / tau
    v3 = 1.0 + v2
    v4 = v3 / E
    v5 = F * v4
    v6 = v1 * v5
    v7 = xp.cbrt(v6)
    return v7


def step_load_radius_power_creep(xp, t, F, R, E, alpha, t_0):
    v0 = 3.0 * R
    v1 = v0 / 4.0
    v2 = t / t_0
    v3 = v2 ** alpha
    v4 = v3 / E
    v5 = F * v4
    v6 = v1 * v5
    v7 = xp.cbrt(v6)
    return v7


def step_load_radius_standard_solid(xp, t, F, R, E_inf, E_1, tau):
    v0 = 3.0 * R
    v1 = v0 / 4.0
    v2 = E_inf + E_1
    v3 = 1.0 / v2
    v4 = E_1 / v2
    v5 = t / tau
    v6 = E_inf / v2
    v7 = v5 * v6
    v8 = -v7
    v9 = xp.expm1(v8)
    v10 = v4 * v9
    v11 = v10 / E_inf
    v12 = v3 - v11
    v13 = F * v12
    v14 = v1 * v13
    v15 = xp.cbrt(v14)
    return v15
