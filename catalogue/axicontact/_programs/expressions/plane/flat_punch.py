"""Formulas of axicontact.plane.flat_punch over an array library `xp`."""


def profile(xp, x, a):
    v1 = x <= a
    v2 = xp.where(v1, x, 0.5 * a)
    v3 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, 0.0, xp.nan)


def pressure(xp, x, P, a):
    v10 = xp.where((x <= a) & (P > 0.0), P / (3.141592653589793 * xp.sqrt((a - x) * (a + x))), 0.0)
    return v10


def slope(xp, x, P, a, E_star):
    v1 = x >= a
    v2 = xp.where(v1, x, 2.0 * a)
    v3 = P > 0.0
    v11 = 3.141592653589793 * E_star * xp.sqrt((v2 - a) * (a + v2))
    v14 = xp.where(v1, 0.5 * a, x)
    return xp.where(v1, xp.where(v3, -2.0 * xp.where(v3, P, 1.0) / v11, 0.0), 0.0)


def depth(xp, L, P, a, E_star):
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v4 = L - v2
    v14 = xp.where(v1, 2.0 * L, a)
    v13 = 2.0 * P * xp.log1p((v4 + xp.sqrt(v4 * (v2 + L))) / v2) / (3.141592653589793 * E_star)
    return xp.where(v1, v13, xp.nan)
