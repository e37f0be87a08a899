"""Formulas of axicontact.plane.wedge over an array library `xp`."""


def profile(xp, x, theta):
    return xp.tan(theta) * x


def load(xp, a, theta, E_star):
    return E_star * xp.tan(theta) * a


def pressure(xp, x, a, theta, E_star):
    v1 = x < a
    v2 = xp.where(v1, x, 0.5 * a)
    v6 = a - v2
    v12 = xp.log1p((v6 + xp.sqrt(v6 * (a + v2))) / v2)
    v14 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, E_star * xp.tan(theta) / 3.141592653589793 * v12, 0.0)


def slope(xp, x, a, theta):
    v1 = x > a
    v2 = xp.where(v1, x, 2.0 * a)
    v10 = xp.arctan2(a, xp.sqrt((v2 - a) * (a + v2)))
    v12 = xp.where(v1, 0.5 * a, x)
    return xp.where(v1, -2.0 * xp.tan(theta) / 3.141592653589793 * v10, -xp.tan(theta))


def depth(xp, L, a, theta):
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v8 = L - v4
    v11 = xp.sqrt(v8 * (v4 + L))
    v18 = L * xp.arctan2(v4, v11) + v4 * xp.log1p((v8 + v11) / v4)
    v21 = xp.where(v1, 2.0 * L, a)
    v22 = xp.where(v1, xp.where(v3, 2.0 * xp.tan(theta) / 3.141592653589793 * v18, 0.0), xp.nan)
    return v22


def half_width_from_load(xp, P, theta, E_star):
    return P / (E_star * xp.tan(theta))
