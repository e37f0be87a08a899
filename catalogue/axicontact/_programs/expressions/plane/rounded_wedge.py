"""Formulas of axicontact.plane.rounded_wedge over an array library `xp`."""


def load(xp, a, theta, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 3.141592653589793 * E_star
    v3 = xp.tan(theta)
    v4 = v2 * v3
    v5 = 4.0 * b
    v6 = v4 / v5
    v7 = v1 ** 2.0
    v8 = v6 * v7
    v9 = xp.where(v0, 2.0 * b, a)
    v10 = xp.tan(theta)
    v11 = E_star * v10
    v12 = v9 - b
    v13 = v9 + b
    v14 = v12 * v13
    v15 = xp.sqrt(v14)
    v16 = v9 ** 2.0
    v17 = b / v15
    v18 = xp.arctan(v17)
    v19 = v16 * v18
    v20 = v19 / b
    v21 = v15 + v20
    v22 = v11 * v21
    v23 = v22 / 2.0
    v24 = xp.where(v0, v8, v23)
    return v24


def profile(xp, x, theta, b):
    v0 = x > b
    v1 = xp.where(v0, x, 2.0 * b)
    v2 = xp.tan(theta)
    v3 = b / 2.0
    v4 = v1 - v3
    v5 = v2 * v4
    v6 = xp.where(v0, 0.5 * b, x)
    v7 = xp.tan(theta)
    v8 = 2.0 * b
    v9 = v7 / v8
    v10 = v6 ** 2.0
    v11 = v9 * v10
    v12 = xp.where(v0, v5, v11)
    return v12
