"""Formulas of axicontact.plane.quartic over an array library `xp`."""


def depth(xp, L, a, A):
    v0 = a <= L
    v1 = xp.where(v0, a, 0.5 * L)
    v2 = v1 > 0.0
    v3 = v1 ** 2.0
    v4 = v3 ** 2.0
    v5 = A * v4
    v6 = L - v1
    v7 = v1 + L
    v8 = v6 * v7
    v9 = xp.sqrt(v8)
    v10 = v9 / v1
    v11 = xp.arcsinh(v10)
    v12 = 3.0 * v11
    v13 = L ** 2.0
    v14 = 3.0 * v13
    v15 = v3 + v14
    v16 = L * v15
    v17 = L * v13
    v18 = 2.0 * v17
    v19 = 2.0 * v13
    v20 = v3 + v19
    v21 = v20 * v9
    v22 = v18 + v21
    v23 = v16 / v22
    v24 = v12 + v23
    v25 = v5 * v24
    v26 = v25 / 2.0
    v27 = xp.where(v2, v26, 0.0)
    v28 = xp.where(v0, 2.0 * L, a)
    v29 = xp.where(v0, v27, xp.nan)
    return v29


def half_width_from_load(xp, P, A, E_star):
    v0 = 4.0 * P
    v1 = 9.42477796076938 * E_star
    v2 = v1 * A
    v3 = v0 / v2
    v4 = xp.sqrt(v3)
    v5 = xp.sqrt(v4)
    return v5


def load(xp, a, A, E_star):
    v0 = 9.42477796076938 * E_star
    v1 = v0 * A
    v2 = a ** 2.0
    v3 = v2 ** 2.0
    v4 = v1 * v3
    v5 = v4 / 4.0
    return v5


def pressure(xp, x, a, A, E_star):
    v0 = x < a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = E_star * A
    v3 = a ** 2.0
    v4 = v1 ** 2.0
    v5 = 2.0 * v4
    v6 = v3 + v5
    v7 = v2 * v6
    v8 = a - v1
    v9 = a + v1
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v7 * v11
    v13 = xp.where(v0, 2.0 * a, x)
    v14 = xp.where(v0, v12, 0.0)
    return v14


def profile(xp, x, A):
    v0 = x ** 2.0
    v1 = v0 ** 2.0
    v2 = A * v1
    return v2


def slope(xp, x, a, A):
    v0 = x > a
    v1 = xp.where(v0, x, 2.0 * a)
    v2 = (-2.0) * A
    v3 = a ** 2.0
    v4 = v3 ** 2.0
    v5 = v2 * v4
    v6 = v1 ** 2.0
    v7 = 3.0 * v6
    v8 = v3 + v7
    v9 = v5 * v8
    v10 = 2.0 * v6
    v11 = v1 - a
    v12 = a + v1
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = v10 * v14
    v16 = v3 * v14
    v17 = v15 + v16
    v18 = v1 * v6
    v19 = 2.0 * v18
    v20 = v17 + v19
    v21 = v9 / v20
    v22 = xp.where(v0, 0.5 * a, x)
    v23 = 4.0 * A
    v24 = v22 ** 2.0
    v25 = v22 * v24
    v26 = v23 * v25
    v27 = -v26
    v28 = xp.where(v0, v21, v27)
    return v28
