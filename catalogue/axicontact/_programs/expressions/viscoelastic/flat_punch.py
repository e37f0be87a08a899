"""Formulas of axicontact.viscoelastic.flat_punch over an array library `xp`."""


def ramp_force_kelvin_voigt(xp, t, v, a, E, eta):
    v0 = t == 0.0
    v1 = 2.0 * v
    v2 = v1 * a
    v3 = v2 * eta
    v4 = v * t
    v5 = 2.0 * v4
    v6 = v5 * a
    v7 = eta / t
    v8 = E + v7
    v9 = v6 * v8
    v10 = xp.where(v0, v3, v9)
    return v10


def step_force_kelvin_voigt(xp, t, d, a, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 2.0 * d
    v3 = v2 * a
    v4 = v1 * v3
    return v4


def step_force_maxwell(xp, t, d, a, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 2.0 * d
    v5 = v4 * a
    v6 = v3 * v5
    return v6


def step_force_power_creep(xp, t, d, a, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = 2.0 * d
    v8 = v7 * a
    v9 = v6 * v8
    return v9


def step_force_standard_solid(xp, t, d, a, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 2.0 * d
    v6 = v5 * a
    v7 = v4 * v6
    return v7
