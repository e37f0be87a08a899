"""Formulas of axicontact.plane.truncated_wedge over an array library `xp`."""


def half_width_from_load(xp, P, theta, b, E_star):
    v0 = P ** 2.0
    v1 = E_star ** 2.0
    v2 = xp.tan(theta)
    v3 = v2 ** 2.0
    v4 = v1 * v3
    v5 = v0 / v4
    v6 = b ** 2.0
    v7 = v5 + v6
    v8 = xp.sqrt(v7)
    return v8


def load(xp, a, theta, b, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = a - b
    v3 = a + b
    v4 = v2 * v3
    v5 = xp.sqrt(v4)
    v6 = v1 * v5
    return v6


def pressure(xp, x, a, theta, b, E_star):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = x < v1
    v3 = xp.where(v2, x, 0.5 * v1)
    v4 = v3 < b
    v5 = xp.where(v4, v3, 0.5 * b)
    v6 = xp.tan(theta)
    v7 = E_star * v6
    v8 = v7 / 3.141592653589793
    v9 = v1 - b
    v10 = v1 + b
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = b - v5
    v14 = v5 + b
    v15 = v13 * v14
    v16 = xp.sqrt(v15)
    v17 = v12 / v16
    v18 = xp.arcsinh(v17)
    v19 = v8 * v18
    v20 = xp.where(v4, 2.0 * b, v3)
    v21 = xp.tan(theta)
    v22 = E_star * v21
    v23 = v22 / 3.141592653589793
    v24 = v1 - v20
    v25 = v1 + v20
    v26 = v24 * v25
    v27 = xp.sqrt(v26)
    v28 = v20 - b
    v29 = v20 + b
    v30 = v28 * v29
    v31 = xp.sqrt(v30)
    v32 = v27 / v31
    v33 = xp.arcsinh(v32)
    v34 = v23 * v33
    v35 = xp.where(v4, v19, v34)
    v36 = xp.where(v2, 2.0 * v1, x)
    v37 = xp.where(v2, v35, 0.0)
    v38 = xp.where(v0, 0.5 * b, a)
    v39 = xp.where(v0, v37, xp.nan)
    return v39


def profile(xp, x, theta, b):
    v0 = x > b
    v1 = xp.where(v0, x, 2.0 * b)
    v2 = xp.tan(theta)
    v3 = v1 - b
    v4 = v2 * v3
    v5 = xp.where(v0, 0.5 * b, x)
    v6 = xp.where(v0, v4, 0.0)
    return v6


def slope(xp, x, a, theta, b):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = x > v1
    v3 = xp.where(v2, x, 2.0 * v1)
    v4 = xp.tan(theta)
    v5 = (-2.0) * v4
    v6 = v5 / 3.141592653589793
    v7 = v1 - b
    v8 = v1 + b
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v3 - v1
    v12 = v1 + v3
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = xp.arctan2(v10, v14)
    v16 = v6 * v15
    v17 = xp.where(v2, 0.5 * v1, x)
    v18 = v17 > b
    v19 = xp.where(v18, v17, 2.0 * b)
    v20 = xp.tan(theta)
    v21 = xp.where(v18, 0.5 * b, v17)
    v22 = xp.where(v18, v20, 0.0)
    v23 = -v22
    v24 = xp.where(v2, v16, v23)
    v25 = xp.where(v0, 0.5 * b, a)
    v26 = xp.where(v0, v24, xp.nan)
    return v26
