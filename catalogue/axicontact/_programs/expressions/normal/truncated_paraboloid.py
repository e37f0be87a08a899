"""Formulas of axicontact.normal.truncated_paraboloid over an array library `xp`."""


def depth(xp, a, R, b):
    v0 = a - b
    v1 = a + b
    v2 = v0 * v1
    v3 = xp.sqrt(v2)
    v4 = a * v3
    v5 = v4 / R
    return v5


def force(xp, a, R, b, E_star):
    v0 = 2.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = 2.0 * v3
    v5 = b ** 2.0
    v6 = v4 + v5
    v7 = v2 * v6
    v8 = a - b
    v9 = a + b
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v7 * v11
    return v12


def mean_pressure(xp, a, R, b, E_star):
    v0 = 4.0 * E_star
    v1 = 9.42477796076938 * R
    v2 = v0 / v1
    v3 = a - b
    v4 = a + b
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = v2 * v6
    v8 = 2.0 * E_star
    v9 = b ** 2.0
    v10 = v8 * v9
    v11 = v10 * v6
    v12 = a ** 2.0
    v13 = 9.42477796076938 * v12
    v14 = v13 * R
    v15 = v11 / v14
    v16 = v7 + v15
    return v16


def profile(xp, r, R, b):
    v0 = r < b
    v1 = xp.where(v0, r, 0.5 * b)
    v2 = xp.where(v0, 2.0 * b, r)
    v3 = v2 - b
    v4 = v2 + b
    v5 = v3 * v4
    v6 = 2.0 * R
    v7 = v5 / v6
    v8 = xp.where(v0, 0.0, v7)
    return v8


def radius_from_depth(xp, d, R, b):
    v0 = b ** 2.0
    v1 = v0 ** 2.0
    v2 = R ** 2.0
    v3 = 4.0 * v2
    v4 = d ** 2.0
    v5 = v3 * v4
    v6 = v1 + v5
    v7 = xp.sqrt(v6)
    v8 = v7 / R
    v9 = v0 / R
    v10 = v8 + v9
    v11 = xp.sqrt(v10)
    v12 = 2.0 * R
    v13 = xp.sqrt(v12)
    v14 = v11 * v13
    v15 = v14 / 2.0
    return v15


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
