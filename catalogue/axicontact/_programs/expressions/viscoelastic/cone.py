"""Formulas of axicontact.viscoelastic.cone over an array library `xp`."""


def ramp_force_kelvin_voigt(xp, t, v, theta, E, eta):
    v0 = t == 0.0
    v1 = xp.tan(theta)
    v2 = 3.141592653589793 * v1
    v3 = 2.0 / v2
    v4 = v * t
    v5 = v4 ** 2.0
    v6 = v3 * v5
    v7 = eta * 2.0
    v8 = v7 / t
    v9 = E + v8
    v10 = v6 * v9
    v11 = xp.where(v0, 0.0, v10)
    return v11


def step_force_kelvin_voigt(xp, t, d, theta, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = xp.tan(theta)
    v3 = 3.141592653589793 * v2
    v4 = 2.0 / v3
    v5 = d ** 2.0
    v6 = v4 * v5
    v7 = v1 * v6
    return v7


def step_force_maxwell(xp, t, d, theta, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = xp.tan(theta)
    v5 = 3.141592653589793 * v4
    v6 = 2.0 / v5
    v7 = d ** 2.0
    v8 = v6 * v7
    v9 = v3 * v8
    return v9


def step_force_power_creep(xp, t, d, theta, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = xp.tan(theta)
    v8 = 3.141592653589793 * v7
    v9 = 2.0 / v8
    v10 = d ** 2.0
    v11 = v9 * v10
    v12 = v6 * v11
    return v12


def step_force_standard_solid(xp, t, d, theta, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = xp.tan(theta)
    v6 = 3.141592653589793 * v5
    v7 = 2.0 / v6
    v8 = d ** 2.0
    v9 = v7 * v8
    v10 = v4 * v9
    return v10


def step_load_radius_kelvin_voigt(xp, t, F, theta, E, eta):
    v0 = -E
    v1 = v0 * t
    v2 = v1 / eta
    v3 = xp.expm1(v2)
    v4 = -v3
    v5 = v4 / E
    v6 = F * v5
    v7 = 2.0 * v6
    v8 = xp.tan(theta)
    v9 = 3.141592653589793 * v8
    v10 = v7 / v9
    v11 = xp.sqrt(v10)
    return v11


def step_load_radius_maxwell(xp, t, F, theta, E, tau):
    v0 = t / tau
    v1 = 1.0 + v0
    v2 = v1 / E
    v3 = F * v2
    v4 = 2.0 * v3
    v5 = xp.tan(theta)
    v6 = 3.141592653589793 * v5
    v7 = v4 / v6
    v8 = xp.sqrt(v7)
    return v8


def step_load_radius_power_creep(xp, t, F, theta, E, alpha, t_0):
    v0 = t / t_0
    v1 = v0 ** alpha
    v2 = v1 / E
    v3 = F * v2
    v4 = 2.0 * v3
    v5 = xp.tan(theta)
    v6 = 3.141592653589793 * v5
    v7 = v4 / v6
    v8 = xp.sqrt(v7)
    return v8


def step_load_radius_standard_solid(xp, t, F, theta, E_inf, E_1, tau):
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
    v12 = 2.0 * v11
    v13 = xp.tan(theta)
    v14 = 3.141592653589793 * v13
    v15 = v12 / v14
    v16 = xp.sqrt(v15)
    return v16
