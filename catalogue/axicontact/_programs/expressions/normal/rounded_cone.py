"""Formulas of axicontact.normal.rounded_cone over an array library `xp`."""


def depth(xp, a, theta, b):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = xp.tan(theta)
    v3 = v2 / b
    v4 = v1 ** 2.0
    v5 = v3 * v4
    v6 = xp.where(v0, 2.0 * b, a)
    v7 = xp.tan(theta)
    v8 = v7 * v6
    v9 = v6 - b
    v10 = v6 + b
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = v12 / b
    v14 = xp.arctan(v13)
    v15 = v12 + v6
    v16 = b / v15
    v17 = v14 + v16
    v18 = v8 * v17
    v19 = xp.where(v0, v5, v18)
    return v19


def force(xp, a, theta, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = xp.tan(theta)
    v4 = v2 * v3
    v5 = 3.0 * b
    v6 = v4 / v5
    v7 = v1 ** 2.0
    v8 = v1 * v7
    v9 = v6 * v8
    v10 = xp.where(v0, 2.0 * b, a)
    v11 = xp.tan(theta)
    v12 = E_star * v11
    v13 = v10 ** 2.0
    v14 = v10 - b
    v15 = v10 + b
    v16 = v14 * v15
    v17 = xp.sqrt(v16)
    v18 = v17 / b
    v19 = xp.arctan(v18)
    v20 = v13 * v19
    v21 = 4.0 * b
    v22 = v21 * v13
    v23 = v17 + v10
    v24 = 3.0 * v23
    v25 = v22 / v24
    v26 = v20 + v25
    v27 = b / 3.0
    v28 = v27 * v17
    v29 = v26 + v28
    v30 = v12 * v29
    v31 = xp.where(v0, v9, v30)
    return v31


def mean_pressure(xp, a, theta, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = xp.tan(theta)
    v4 = v2 * v3
    v5 = 9.42477796076938 * b
    v6 = v4 / v5
    v7 = v6 * v1
    v8 = xp.where(v0, 2.0 * b, a)
    v9 = xp.tan(theta)
    v10 = E_star * v9
    v11 = v10 / 3.141592653589793
    v12 = v8 - b
    v13 = v8 + b
    v14 = v12 * v13
    v15 = xp.sqrt(v14)
    v16 = v15 / b
    v17 = xp.arctan(v16)
    v18 = 4.0 * b
    v19 = v15 + v8
    v20 = 3.0 * v19
    v21 = v18 / v20
    v22 = v17 + v21
    v23 = b * v15
    v24 = v8 ** 2.0
    v25 = 3.0 * v24
    v26 = v23 / v25
    v27 = v22 + v26
    v28 = v11 * v27
    v29 = xp.where(v0, v7, v28)
    return v29


def profile(xp, r, theta, b):
    v0 = r < b
    v1 = xp.where(v0, r, 0.5 * b)
    v2 = xp.tan(theta)
    v3 = 2.0 * b
    v4 = v2 / v3
    v5 = v1 ** 2.0
    v6 = v4 * v5
    v7 = xp.where(v0, 2.0 * b, r)
    v8 = xp.tan(theta)
    v9 = b / 2.0
    v10 = v7 - v9
    v11 = v8 * v10
    v12 = xp.where(v0, v6, v11)
    return v12


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
