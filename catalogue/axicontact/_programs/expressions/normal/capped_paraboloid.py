"""Formulas of axicontact.normal.capped_paraboloid over an array library `xp`."""


def depth(xp, a, R1, R2, b):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = v1 ** 2.0
    v3 = v2 / R1
    v4 = xp.where(v0, 2.0 * b, a)
    v5 = R1 - R2
    v6 = v5 / R2
    v7 = v4 - b
    v8 = v4 + b
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v6 * v10
    v12 = v4 + v11
    v13 = v4 * v12
    v14 = v13 / R1
    v15 = xp.where(v0, v3, v14)
    return v15


def force(xp, a, R1, R2, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = 3.0 * R1
    v4 = v2 / v3
    v5 = v1 ** 2.0
    v6 = v1 * v5
    v7 = v4 * v6
    v8 = xp.where(v0, 2.0 * b, a)
    v9 = 2.0 * E_star
    v10 = 3.0 * R1
    v11 = v9 / v10
    v12 = v8 ** 2.0
    v13 = v8 * v12
    v14 = 2.0 * v13
    v15 = R1 - R2
    v16 = v15 / R2
    v17 = 2.0 * v12
    v18 = b ** 2.0
    v19 = v17 + v18
    v20 = v16 * v19
    v21 = v8 - b
    v22 = v8 + b
    v23 = v21 * v22
    v24 = xp.sqrt(v23)
    v25 = v20 * v24
    v26 = v14 + v25
    v27 = v11 * v26
    v28 = xp.where(v0, v7, v27)
    return v28


def mean_pressure(xp, a, R1, R2, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = 9.42477796076938 * R1
    v4 = v2 / v3
    v5 = v4 * v1
    v6 = xp.where(v0, 2.0 * b, a)
    v7 = 2.0 * E_star
    v8 = 9.42477796076938 * R1
    v9 = v7 / v8
    v10 = 2.0 * v6
    v11 = R1 - R2
    v12 = v6 ** 2.0
    v13 = 2.0 * v12
    v14 = b ** 2.0
    v15 = v13 + v14
    v16 = v11 * v15
    v17 = v6 - b
    v18 = v6 + b
    v19 = v17 * v18
    v20 = xp.sqrt(v19)
    v21 = v16 * v20
    v22 = v12 * R2
    v23 = v21 / v22
    v24 = v10 + v23
    v25 = v9 * v24
    v26 = xp.where(v0, v5, v25)
    return v26


def profile(xp, r, R1, R2, b):
    v0 = r < b
    v1 = xp.where(v0, r, 0.5 * b)
    v2 = v1 ** 2.0
    v3 = 2.0 * R1
    v4 = v2 / v3
    v5 = xp.where(v0, 2.0 * b, r)
    v6 = b ** 2.0
    v7 = 2.0 * R1
    v8 = v6 / v7
    v9 = v5 - b
    v10 = v5 + b
    v11 = v9 * v10
    v12 = 2.0 * R2
    v13 = v11 / v12
    v14 = v8 + v13
    v15 = xp.where(v0, v4, v14)
    return v15


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
