"""Formulas of axicontact.plane.wedge over an array library `xp`."""


def depth(xp, L, a, theta):
    v0 = a <= L
    v1 = xp.where(v0, a, 0.5 * L)
    v2 = v1 > 0.0
    v3 = xp.tan(theta)
    v4 = 2.0 * v3
    v5 = v4 / 3.141592653589793
    v6 = L - v1
    v7 = v1 + L
    v8 = v6 * v7
    v9 = xp.sqrt(v8)
    v10 = xp.arctan2(v1, v9)
    v11 = L * v10
    v12 = v6 + v9
    v13 = v12 / v1
    v14 = xp.log1p(v13)
    v15 = v1 * v14
    v16 = v11 + v15
    v17 = v5 * v16
    v18 = xp.where(v2, v17, 0.0)
    v19 = xp.where(v0, 2.0 * L, a)
    v20 = xp.where(v0, v18, xp.nan)
    return v20


def half_width_from_load(xp, P, theta, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = P / v1
    return v2


def load(xp, a, theta, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = v1 * a
    return v2


def pressure(xp, x, a, theta, E_star):
    v0 = x < a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = xp.tan(theta)
    v3 = E_star * v2
    v4 = v3 / 3.141592653589793
    v5 = a - v1
    v6 = a + v1
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = v5 + v8
    v10 = v9 / v1
    v11 = xp.log1p(v10)
    v12 = v4 * v11
    v13 = xp.where(v0, 2.0 * a, x)
    v14 = xp.where(v0, v12, 0.0)
    return v14


def profile(xp, x, theta):
    v0 = xp.tan(theta)
    v1 = v0 * x
    return v1


def slope(xp, x, a, theta):
    v0 = x > a
    v1 = xp.where(v0, x, 2.0 * a)
    v2 = xp.tan(theta)
    v3 = (-2.0) * v2
    v4 = v3 / 3.141592653589793
    v5 = v1 - a
    v6 = a + v1
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = xp.arctan2(a, v8)
    v10 = v4 * v9
    v11 = xp.where(v0, 0.5 * a, x)
    v12 = xp.tan(theta)
    v13 = -v12
    v14 = xp.where(v0, v10, v13)
    return v14
