"""Formulas of axicontact.tangential.cone over an array library `xp`."""


def full_slip_displacement(xp, a, theta, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.tan(theta)
    v3 = 3.141592653589793 * v2
    v4 = v3 * a
    v5 = v4 / 2.0
    v6 = v1 * v5
    return v6


def stick_radius(xp, F_x, a, theta, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = 3.141592653589793 * E_star
    v4 = xp.tan(theta)
    v5 = v3 * v4
    v6 = a ** 2.0
    v7 = v5 * v6
    v8 = v7 / 2.0
    v9 = F_x / mu
    v10 = v8 - v9
    v11 = xp.absolute(v10)
    v12 = 2e-16 * v8
    v13 = v11 <= v12
    v14 = xp.where(v13, v11, 0.5 * v12)
    v15 = xp.where(v13, 2.0 * v12, v11)
    v16 = xp.where(v13, 0.0, v10)
    v17 = v16 >= 0.0
    v18 = xp.where(v17, v16, xp.nan)
    v19 = 2.0 * v18
    v20 = v19 / v5
    v21 = xp.sqrt(v20)
    v22 = xp.where(v2, a, v21)
    return v22


def tangential_displacement(xp, a, c, theta, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.tan(theta)
    v3 = 3.141592653589793 * v2
    v4 = v3 * a
    v5 = v4 / 2.0
    v6 = v1 * v5
    v7 = a > c
    v8 = xp.where(v7, a, 2.0 * c)
    v9 = v8 - c
    v10 = v9 / c
    v11 = xp.log1p(v10)
    v12 = xp.where(v7, 0.5 * c, a)
    v13 = xp.where(v7, v11, 0.0)
    v14 = (-1.0) * v13
    v15 = xp.expm1(v14)
    v16 = -v15
    v17 = v6 * v16
    return v17


def tangential_force(xp, a, c, theta, E_star, mu):
    v0 = 3.141592653589793 * E_star
    v1 = xp.tan(theta)
    v2 = v0 * v1
    v3 = a ** 2.0
    v4 = v2 * v3
    v5 = v4 / 2.0
    v6 = mu * v5
    v7 = a > c
    v8 = xp.where(v7, a, 2.0 * c)
    v9 = v8 - c
    v10 = v9 / c
    v11 = xp.log1p(v10)
    v12 = xp.where(v7, 0.5 * c, a)
    v13 = xp.where(v7, v11, 0.0)
    v14 = (-2.0) * v13
    v15 = xp.expm1(v14)
    v16 = -v15
    v17 = v6 * v16
    return v17


def traction(xp, r, a, c, theta, E_star, mu):
    v0 = r < c
    v1 = xp.where(v0, r, 0.5 * c)
    v2 = E_star / 3.141592653589793
    v3 = xp.tan(theta)
    v4 = 3.141592653589793 * v3
    v5 = v4 / 2.0
    v6 = v2 * v5
    v7 = a - c
    v8 = a > c
    v9 = xp.where(v8, a, 2.0 * c)
    v10 = v9 - c
    v11 = v9 + c
    v12 = v10 * v11
    v13 = v9 - v1
    v14 = xp.maximum(v13, 0.0)
    v15 = v9 + v1
    v16 = v14 * v15
    v17 = xp.sqrt(v16)
    v18 = c - v1
    v19 = xp.maximum(v18, 0.0)
    v20 = c + v1
    v21 = v19 * v20
    v22 = xp.sqrt(v21)
    v23 = v17 + v22
    v24 = v12 / v23
    v25 = xp.where(v8, 0.5 * c, a)
    v26 = xp.where(v8, v24, 0.0)
    v27 = v7 + v26
    v28 = c - v1
    v29 = xp.maximum(v28, 0.0)
    v30 = c + v1
    v31 = v29 * v30
    v32 = xp.sqrt(v31)
    v33 = c + v32
    v34 = v27 / v33
    v35 = xp.log1p(v34)
    v36 = v6 * v35
    v37 = xp.where(v0, 2.0 * c, r)
    v38 = v37 < a
    v39 = xp.where(v38, v37, 0.5 * a)
    v40 = xp.tan(theta)
    v41 = E_star * v40
    v42 = a - v39
    v43 = a + v39
    v44 = v42 * v43
    v45 = xp.sqrt(v44)
    v46 = v42 + v45
    v47 = v46 / v39
    v48 = xp.log1p(v47)
    v49 = v41 * v48
    v50 = v49 / 2.0
    v51 = xp.where(v38, 2.0 * a, v37)
    v52 = xp.where(v38, v50, 0.0)
    v53 = xp.where(v0, v36, v52)
    v54 = mu * v53
    return v54
