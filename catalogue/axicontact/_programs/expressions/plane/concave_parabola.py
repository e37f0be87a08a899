"""Formulas of axicontact.plane.concave_parabola over an array library `xp`."""


def depth(xp, L, P, a, h, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = v0 * h
    v2 = v1 / 2.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = xp.where(v4, v3, 0.5 * P)
    v6 = a <= L
    v7 = xp.where(v6, a, 0.5 * L)
    v8 = 2.0 * P
    v9 = L - v7
    v10 = v7 + L
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = v9 + v12
    v14 = v13 / v7
    v15 = xp.log1p(v14)
    v16 = v8 * v15
    v17 = v16 / v0
    v18 = h * L
    v19 = v12 + L
    v20 = v18 / v19
    v21 = v17 - v20
    v22 = xp.where(v6, 2.0 * L, a)
    v23 = xp.where(v6, v21, xp.nan)
    v24 = xp.where(v4, 2.0 * P, v3)
    v25 = xp.where(v4, v23, xp.nan)
    return v25


def minimum_load(xp, h, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = v0 * h
    v2 = v1 / 2.0
    return v2


def pressure(xp, x, P, a, h, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = v0 * h
    v2 = v1 / 2.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = xp.where(v4, v3, 0.5 * P)
    v6 = x <= a
    v7 = P > 0.0
    v8 = v6 & v7
    v9 = P - v2
    v10 = x ** 2.0
    v11 = v1 * v10
    v12 = a ** 2.0
    v13 = v11 / v12
    v14 = v9 + v13
    v15 = a - x
    v16 = a + x
    v17 = v15 * v16
    v18 = xp.sqrt(v17)
    v19 = 3.141592653589793 * v18
    v20 = v14 / v19
    v21 = xp.where(v8, v20, 0.0)
    v22 = xp.where(v4, 2.0 * P, v3)
    v23 = xp.where(v4, v21, xp.nan)
    return v23


def profile(xp, x, a, h):
    v0 = x <= a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = -h
    v3 = v1 ** 2.0
    v4 = v2 * v3
    v5 = a ** 2.0
    v6 = v4 / v5
    v7 = xp.where(v0, 2.0 * a, x)
    v8 = xp.where(v0, v6, xp.nan)
    return v8


def slope(xp, x, P, a, h, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = v0 * h
    v2 = v1 / 2.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = xp.where(v4, v3, 0.5 * P)
    v6 = x >= a
    v7 = xp.where(v6, x, 2.0 * a)
    v8 = P > 0.0
    v9 = (-2.0) * P
    v10 = v7 - a
    v11 = a + v7
    v12 = v10 * v11
    v13 = xp.sqrt(v12)
    v14 = v0 * v13
    v15 = v9 / v14
    v16 = a ** 2.0
    v17 = h * v16
    v18 = v13 ** 2.0
    v19 = 2.0 * v18
    v20 = 2.0 * v7
    v21 = v20 * v13
    v22 = v19 + v21
    v23 = v22 + v16
    v24 = v23 * v13
    v25 = v17 / v24
    v26 = v15 - v25
    v27 = xp.where(v8, v26, 0.0)
    v28 = xp.where(v6, 0.5 * a, x)
    v29 = (-2.0) * h
    v30 = v29 * v28
    v31 = a ** 2.0
    v32 = v30 / v31
    v33 = -v32
    v34 = xp.where(v6, v27, v33)
    v35 = xp.where(v4, 2.0 * P, v3)
    v36 = xp.where(v4, v34, xp.nan)
    return v36


def zero_distance(xp, a):
    v0 = 0.0 * a
    return v0
