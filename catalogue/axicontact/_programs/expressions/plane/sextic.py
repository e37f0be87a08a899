"""Formulas of axicontact.plane.sextic over an array library `xp`."""


def depth(xp, L, a, A):
    v0 = a <= L
    v1 = xp.where(v0, a, 0.5 * L)
    v2 = v1 > 0.0
    v3 = v1 ** 6.0
    v4 = A * v3
    v5 = L - v1
    v6 = v1 + L
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = v8 / v1
    v10 = xp.arcsinh(v9)
    v11 = 15.0 * v10
    v12 = v1 ** 2.0
    v13 = v12 ** 2.0
    v14 = 9.0 * v13
    v15 = L ** 2.0
    v16 = v15 ** 2.0
    v17 = 40.0 * v16
    v18 = v14 + v17
    v19 = 15.0 * v12
    v20 = v19 * v15
    v21 = v18 + v20
    v22 = L * v21
    v23 = L ** 5.0
    v24 = 8.0 * v23
    v25 = 3.0 * v13
    v26 = 8.0 * v16
    v27 = v25 + v26
    v28 = 4.0 * v12
    v29 = v28 * v15
    v30 = v27 + v29
    v31 = v30 * v8
    v32 = v24 + v31
    v33 = v22 / v32
    v34 = v11 + v33
    v35 = v4 * v34
    v36 = v35 / 8.0
    v37 = xp.where(v2, v36, 0.0)
    v38 = xp.where(v0, 2.0 * L, a)
    v39 = xp.where(v0, v37, xp.nan)
    return v39


def half_width_from_load(xp, P, A, E_star):
    v0 = 16.0 * P
    v1 = 47.12388980384689 * E_star
    v2 = v1 * A
    v3 = v0 / v2
    v4 = v3 > 0.0
    v5 = v3 < xp.inf
    v6 = v4 & v5
    v7 = v3 ** 0.16666666666666666
    v8 = v7 ** 6.0
    v9 = v7 ** 0.0
    v10 = v8 * v9
    v11 = v3 / v10
    v12 = v11 - 1.0
    v13 = v12 / 6.0
    v14 = v7 * v13
    v15 = v7 + v14
    v16 = xp.where(v6, v15, v7)
    return v16


def load(xp, a, A, E_star):
    v0 = 47.12388980384689 * E_star
    v1 = v0 * A
    v2 = a ** 6.0
    v3 = v1 * v2
    v4 = v3 / 16.0
    return v4


def pressure(xp, x, a, A, E_star):
    v0 = x < a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = 3.0 * E_star
    v3 = v2 * A
    v4 = a ** 2.0
    v5 = v4 ** 2.0
    v6 = 3.0 * v5
    v7 = 4.0 * v4
    v8 = v1 ** 2.0
    v9 = v7 * v8
    v10 = v6 + v9
    v11 = v8 ** 2.0
    v12 = 8.0 * v11
    v13 = v10 + v12
    v14 = v3 * v13
    v15 = a - v1
    v16 = a + v1
    v17 = v15 * v16
    v18 = xp.sqrt(v17)
    v19 = v14 * v18
    v20 = v19 / 8.0
    v21 = xp.where(v0, 2.0 * a, x)
    v22 = xp.where(v0, v20, 0.0)
    return v22


def profile(xp, x, A):
    v0 = x ** 6.0
    v1 = A * v0
    return v1


def slope(xp, x, a, A):
    v0 = x > a
    v1 = xp.where(v0, x, 2.0 * a)
    v2 = (-3.0) * A
    v3 = a ** 6.0
    v4 = v2 * v3
    v5 = a ** 2.0
    v6 = v5 ** 2.0
    v7 = 9.0 * v6
    v8 = 15.0 * v5
    v9 = v1 ** 2.0
    v10 = v8 * v9
    v11 = v7 + v10
    v12 = v9 ** 2.0
    v13 = 40.0 * v12
    v14 = v11 + v13
    v15 = v4 * v14
    v16 = 8.0 * v12
    v17 = v1 - a
    v18 = a + v1
    v19 = v17 * v18
    v20 = xp.sqrt(v19)
    v21 = v16 * v20
    v22 = 3.0 * v6
    v23 = v22 * v20
    v24 = v21 + v23
    v25 = 4.0 * v5
    v26 = v25 * v9
    v27 = v26 * v20
    v28 = v24 + v27
    v29 = v1 ** 5.0
    v30 = 8.0 * v29
    v31 = v28 + v30
    v32 = 4.0 * v31
    v33 = v15 / v32
    v34 = xp.where(v0, 0.5 * a, x)
    v35 = 6.0 * A
    v36 = v34 ** 5.0
    v37 = v35 * v36
    v38 = -v37
    v39 = xp.where(v0, v33, v38)
    return v39
