"""Formulas of axicontact.tangential.paraboloid over an array library `xp`."""


def full_slip_displacement(xp, a, R, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a ** 2.0
    v3 = v2 / R
    v4 = v1 * v3
    return v4


def stick_radius(xp, F_x, a, R, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = 3.0 * R
    v4 = 4.0 * E_star
    v5 = v3 / v4
    v6 = v4 / v3
    v7 = a ** 2.0
    v8 = a * v7
    v9 = v6 * v8
    v10 = F_x / mu
    v11 = v9 - v10
    v12 = xp.absolute(v11)
    v13 = 2e-16 * v9
    v14 = v12 <= v13
    v15 = xp.where(v14, v12, 0.5 * v13)
    v16 = xp.where(v14, 2.0 * v13, v12)
    v17 = xp.where(v14, 0.0, v11)
    v18 = v17 >= 0.0
    v19 = xp.where(v18, v17, xp.nan)
    v20 = v5 * v19
    v21 = xp.cbrt(v20)
    v22 = xp.where(v2, a, v21)
    return v22


def tangential_displacement(xp, a, c, R, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a ** 2.0
    v3 = v2 / R
    v4 = v1 * v3
    v5 = a > c
    v6 = xp.where(v5, a, 2.0 * c)
    v7 = v6 - c
    v8 = v7 / c
    v9 = xp.log1p(v8)
    v10 = xp.where(v5, 0.5 * c, a)
    v11 = xp.where(v5, v9, 0.0)
    v12 = (-2.0) * v11
    v13 = xp.expm1(v12)
    v14 = -v13
    v15 = v4 * v14
    return v15


def tangential_force(xp, a, c, R, E_star, mu):
    v0 = 4.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    v6 = mu * v5
    v7 = a > c
    v8 = xp.where(v7, a, 2.0 * c)
    v9 = v8 - c
    v10 = v9 / c
    v11 = xp.log1p(v10)
    v12 = xp.where(v7, 0.5 * c, a)
    v13 = xp.where(v7, v11, 0.0)
    v14 = (-3.0) * v13
    v15 = xp.expm1(v14)
    v16 = -v15
    v17 = v6 * v16
    return v17


def traction(xp, r, a, c, R, E_star, mu):
    v0 = r < c
    v1 = xp.where(v0, r, 0.5 * c)
    v2 = E_star / 3.141592653589793
    v3 = 2.0 / R
    v4 = v2 * v3
    v5 = a > c
    v6 = xp.where(v5, a, 2.0 * c)
    v7 = v6 - c
    v8 = v6 + c
    v9 = v7 * v8
    v10 = v6 - v1
    v11 = xp.maximum(v10, 0.0)
    v12 = v6 + v1
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = c - v1
    v16 = xp.maximum(v15, 0.0)
    v17 = c + v1
    v18 = v16 * v17
    v19 = xp.sqrt(v18)
    v20 = v14 + v19
    v21 = v9 / v20
    v22 = xp.where(v5, 0.5 * c, a)
    v23 = xp.where(v5, v21, 0.0)
    v24 = v4 * v23
    v25 = xp.where(v0, 2.0 * c, r)
    v26 = v25 < a
    v27 = xp.where(v26, v25, 0.5 * a)
    v28 = 2.0 * E_star
    v29 = 3.141592653589793 * R
    v30 = v28 / v29
    v31 = a - v27
    v32 = a + v27
    v33 = v31 * v32
    v34 = xp.sqrt(v33)
    v35 = v30 * v34
    v36 = xp.where(v26, 2.0 * a, v25)
    v37 = xp.where(v26, v35, 0.0)
    v38 = xp.where(v0, v24, v37)
    v39 = mu * v38
    return v39
