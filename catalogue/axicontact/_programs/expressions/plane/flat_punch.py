"""Formulas of axicontact.plane.flat_punch over an array library `xp`."""


def depth(xp, L, P, a, E_star):
    v0 = a <= L
    v1 = xp.where(v0, a, 0.5 * L)
    v2 = 2.0 * P
    v3 = L - v1
    v4 = v1 + L
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = v3 + v6
    v8 = v7 / v1
    v9 = xp.log1p(v8)
    v10 = v2 * v9
    v11 = 3.141592653589793 * E_star
    v12 = v10 / v11
    v13 = xp.where(v0, 2.0 * L, a)
    v14 = xp.where(v0, v12, xp.nan)
    return v14


def pressure(xp, x, P, a):
    v0 = x <= a
    v1 = P > 0.0
    v2 = v0 & v1
    v3 = a - x
    v4 = a + x
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = 3.141592653589793 * v6
    v8 = P / v7
    v9 = xp.where(v2, v8, 0.0)
    return v9


def profile(xp, x, a):
    v0 = x <= a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = xp.where(v0, 2.0 * a, x)
    v3 = xp.where(v0, 0.0, xp.nan)
    return v3


def slope(xp, x, P, a, E_star):
    v0 = x >= a
    v1 = xp.where(v0, x, 2.0 * a)
    v2 = P > 0.0
    v3 = (-2.0) * P
    v4 = 3.141592653589793 * E_star
    v5 = v1 - a
    v6 = a + v1
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = v4 * v8
    v10 = v3 / v9
    v11 = xp.where(v2, v10, 0.0)
    v12 = xp.where(v0, 0.5 * a, x)
    v13 = xp.where(v0, v11, 0.0)
    return v13
