"""Formulas of axicontact.plane.concave_parabola over an array library `xp`."""


def depth(xp, L, P, a, h, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = v0 * h
    v2 = v1 / 2.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = a <= L
    v6 = xp.where(v5, a, 0.5 * L)
    v7 = 2.0 * P
    v8 = L - v6
    v9 = v6 + L
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v8 + v11
    v13 = v12 / v6
    v14 = xp.log1p(v13)
    v15 = v7 * v14
    v16 = 3.141592653589793 * E_star
    v17 = v15 / v16
    v18 = h * L
    v19 = v11 + L
    v20 = v18 / v19
    v21 = v17 - v20
    v22 = xp.where(v5, 2.0 * L, a)
    v23 = xp.where(v5, v21, xp.nan)
    v24 = xp.where(v4, v23, xp.nan)
    return v24


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
    v5 = x <= a
    v6 = P > 0.0
    v7 = v5 & v6
    v8 = P - v2
    v9 = x ** 2.0
    v10 = v1 * v9
    v11 = a ** 2.0
    v12 = v10 / v11
    v13 = v8 + v12
    v14 = a - x
    v15 = a + x
    v16 = v14 * v15
    v17 = xp.sqrt(v16)
    v18 = 3.141592653589793 * v17
    v19 = v13 / v18
    v20 = xp.where(v7, v19, 0.0)
    v21 = xp.where(v4, v20, xp.nan)
    return v21


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
    v5 = x >= a
    v6 = xp.where(v5, x, 2.0 * a)
    v7 = P > 0.0
    v8 = (-2.0) * P
    v9 = 3.141592653589793 * E_star
    v10 = v6 - a
    v11 = a + v6
    v12 = v10 * v11
    v13 = xp.sqrt(v12)
    v14 = v9 * v13
    v15 = v8 / v14
    v16 = a ** 2.0
    v17 = h * v16
    v18 = v13 ** 2.0
    v19 = 2.0 * v18
    v20 = 2.0 * v6
    v21 = v20 * v13
    v22 = v19 + v21
    v23 = v22 + v16
    v24 = v23 * v13
    v25 = v17 / v24
    v26 = v15 - v25
    v27 = xp.where(v7, v26, 0.0)
    v28 = xp.where(v5, 0.5 * a, x)
    v29 = (-2.0) * h
    v30 = v29 * v28
    v31 = a ** 2.0
    v32 = v30 / v31
    v33 = -v32
    v34 = xp.where(v5, v27, v33)
    v35 = xp.where(v4, v34, xp.nan)
    return v35


def zero_distance(xp, a):
    v0 = 0.0 * a
    return v0
