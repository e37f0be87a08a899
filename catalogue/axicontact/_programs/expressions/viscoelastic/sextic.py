"""Formulas of axicontact.viscoelastic.sextic over an array library `xp`."""


def ramp_force_kelvin_voigt(xp, t, v, A, E, eta):
    v0 = t == 0.0
    v1 = v * t
    v2 = 0.8571428571428571 * v1
    v3 = 20.0 * v1
    v4 = v3 / A
    v5 = v4 > 0.0
    v6 = v4 < xp.inf
    v7 = v5 & v6
    v8 = v4 ** 0.16666666666666666
    v9 = v8 ** 6.0
    v10 = v8 ** 0.0
    v11 = v9 * v10
    v12 = v4 / v11
    v13 = v12 - 1.0
    v14 = v13 / 6.0
    v15 = v8 * v14
    v16 = v8 + v15
    v17 = xp.where(v7, v16, v8)
    v18 = v2 * v17
    v19 = eta * 1.1666666666666667
    v20 = v19 / t
    v21 = E + v20
    v22 = v18 * v21
    v23 = xp.where(v0, 0.0, v22)
    return v23


def step_force_kelvin_voigt(xp, t, d, A, E, eta):
    v0 = t > 0.0
    v1 = xp.where(v0, E, xp.inf)
    v2 = 0.8571428571428571 * d
    v3 = 20.0 * d
    v4 = v3 / A
    v5 = v4 > 0.0
    v6 = v4 < xp.inf
    v7 = v5 & v6
    v8 = v4 ** 0.16666666666666666
    v9 = v8 ** 6.0
    v10 = v8 ** 0.0
    v11 = v9 * v10
    v12 = v4 / v11
    v13 = v12 - 1.0
    v14 = v13 / 6.0
    v15 = v8 * v14
    v16 = v8 + v15
    v17 = xp.where(v7, v16, v8)
    v18 = v2 * v17
    v19 = v1 * v18
    return v19


def step_force_maxwell(xp, t, d, A, E, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E * v2
    v4 = 0.8571428571428571 * d
    v5 = 20.0 * d
    v6 = v5 / A
    v7 = v6 > 0.0
    v8 = v6 < xp.inf
    v9 = v7 & v8
    v10 = v6 ** 0.16666666666666666
    v11 = v10 ** 6.0
    v12 = v10 ** 0.0
    v13 = v11 * v12
    v14 = v6 / v13
    v15 = v14 - 1.0
    v16 = v15 / 6.0
    v17 = v10 * v16
    v18 = v10 + v17
    v19 = xp.where(v9, v18, v10)
    v20 = v4 * v19
    v21 = v3 * v20
    return v21


def step_force_power_creep(xp, t, d, A, E, alpha, t_0):
    v0 = t_0 / t
    v1 = v0 ** alpha
    v2 = E * v1
    v3 = 3.141592653589793 * alpha
    v4 = xp.sin(v3)
    v5 = v2 * v4
    v6 = v5 / v3
    v7 = 0.8571428571428571 * d
    v8 = 20.0 * d
    v9 = v8 / A
    v10 = v9 > 0.0
    v11 = v9 < xp.inf
    v12 = v10 & v11
    v13 = v9 ** 0.16666666666666666
    v14 = v13 ** 6.0
    v15 = v13 ** 0.0
    v16 = v14 * v15
    v17 = v9 / v16
    v18 = v17 - 1.0
    v19 = v18 / 6.0
    v20 = v13 * v19
    v21 = v13 + v20
    v22 = xp.where(v12, v21, v13)
    v23 = v7 * v22
    v24 = v6 * v23
    return v24


def step_force_standard_solid(xp, t, d, A, E_inf, E_1, tau):
    v0 = -t
    v1 = v0 / tau
    v2 = xp.exp(v1)
    v3 = E_1 * v2
    v4 = E_inf + v3
    v5 = 0.8571428571428571 * d
    v6 = 20.0 * d
    v7 = v6 / A
    v8 = v7 > 0.0
    v9 = v7 < xp.inf
    v10 = v8 & v9
    v11 = v7 ** 0.16666666666666666
    v12 = v11 ** 6.0
    v13 = v11 ** 0.0
    v14 = v12 * v13
    v15 = v7 / v14
    v16 = v15 - 1.0
    v17 = v16 / 6.0
    v18 = v11 * v17
    v19 = v11 + v18
    v20 = xp.where(v10, v19, v11)
    v21 = v5 * v20
    v22 = v4 * v21
    return v22


def step_load_radius_kelvin_voigt(xp, t, F, A, E, eta):
    v0 = -E
    v1 = v0 * t
    v2 = v1 / eta
    v3 = xp.expm1(v2)
    v4 = -v3
    v5 = v4 / E
    v6 = F * v5
    v7 = 35.0 * v6
    v8 = 192.0 * A
    v9 = v7 / v8
    v10 = v9 > 0.0
    v11 = v9 < xp.inf
    v12 = v10 & v11
    v13 = v9 ** 0.14285714285714285
    v14 = v13 ** 7.0
    v15 = v13 ** 0.0
    v16 = v14 * v15
    v17 = v9 / v16
    v18 = v17 - 1.0
    v19 = v18 / 7.0
    v20 = v13 * v19
    v21 = v13 + v20
    v22 = xp.where(v12, v21, v13)
    return v22


def step_load_radius_maxwell(xp, t, F, A, E, tau):
    v0 = t / tau
    v1 = 1.0 + v0
    v2 = v1 / E
    v3 = F * v2
    v4 = 35.0 * v3
    v5 = 192.0 * A
    v6 = v4 / v5
    v7 = v6 > 0.0
    v8 = v6 < xp.inf
    v9 = v7 & v8
    v10 = v6 ** 0.14285714285714285
    v11 = v10 ** 7.0
    v12 = v10 ** 0.0
    v13 = v11 * v12
    v14 = v6 / v13
    v15 = v14 - 1.0
    v16 = v15 / 7.0
    v17 = v10 * v16
    v18 = v10 + v17
    v19 = xp.where(v9, v18, v10)
    return v19


def step_load_radius_power_creep(xp, t, F, A, E, alpha, t_0):
    v0 = t / t_0
    v1 = v0 ** alpha
    v2 = v1 / E
    v3 = F * v2
    v4 = 35.0 * v3
    v5 = 192.0 * A
    v6 = v4 / v5
    v7 = v6 > 0.0
    v8 = v6 < xp.inf
    v9 = v7 & v8
    v10 = v6 ** 0.14285714285714285
    v11 = v10 ** 7.0
    v12 = v10 ** 0.0
    v13 = v11 * v12
    v14 = v6 / v13
    v15 = v14 - 1.0
    v16 = v15 / 7.0
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
    v12 = 35.0 * v11
    v13 = 192.0 * A
    v14 = v12 / v13
    v15 = v14 > 0.0
    v16 = v14 < xp.inf
    v17 = v15 & v16
    v18 = v14 ** 0.14285714285714285
    v19 = v18 ** 7.0
    v20 = v18 ** 0.0
    v21 = v19 * v20
    v22 = v14 / v21
    v23 = v22 - 1.0
    v24 = v23 / 7.0
    v25 = v18 * v24
    v26 = v18 + v25
    v27 = xp.where(v17, v26, v18)
    return v27
