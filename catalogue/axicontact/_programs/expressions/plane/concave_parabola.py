"""Formulas of axicontact.plane.concave_parabola over an array library `xp`."""


def profile(xp, x, a, h):
    v1 = x <= a
    v8 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, -h * xp.where(v1, x, 0.5 * a) ** 2.0 / a ** 2.0, xp.nan)


def pressure(xp, x, P, a, h, E_star):
    v2 = 3.141592653589793 * E_star * h
    v3 = v2 / 2.0
    v4 = v3 * 0.999999999999999
    v5 = v4 <= P
    v6 = xp.where(v5, v4, 0.5 * P)
    v20 = 3.141592653589793 * xp.sqrt((a - x) * (a + x))
    v23 = xp.where(v5, 2.0 * P, v4)
    v22 = xp.where((x <= a) & (P > 0.0), (P - v3 + v2 * x ** 2.0 / a ** 2.0) / v20, 0.0)
    return xp.where(v5, v22, xp.nan)


def profile_slope(xp, x, a, h):
    return -2.0 * h * x / a ** 2.0


def slope(xp, x, P, a, h, E_star):
    v1 = 3.141592653589793 * E_star
    v4 = v1 * h / 2.0 * 0.999999999999999
    v5 = v4 <= P
    v6 = xp.where(v5, v4, 0.5 * P)
    v7 = x >= a
    v8 = xp.where(v7, x, 2.0 * a)
    v9 = P > 0.0
    v15 = xp.sqrt((v8 - a) * (a + v8))
    v18 = a ** 2.0
    v27 = h * v18 / ((2.0 * v15 ** 2.0 + 2.0 * v8 * v15 + v18) * v15)
    v29 = xp.where(v9, -2.0 * xp.where(v9, P, 1.0) / (v1 * v15) - v27, 0.0)
    v34 = xp.where(v5, 2.0 * P, v4)
    v35 = xp.where(v5, xp.where(v7, v29, -profile_slope(xp, xp.where(v7, 0.5 * a, x), a, h)), xp.nan)
    return v35


def depth(xp, L, P, a, h, E_star):
    v1 = 3.141592653589793 * E_star
    v4 = v1 * h / 2.0 * 0.999999999999999
    v5 = v4 <= P
    v6 = xp.where(v5, v4, 0.5 * P)
    v7 = a <= L
    v8 = xp.where(v7, a, 0.5 * L)
    v10 = L - v8
    v13 = xp.sqrt(v10 * (v8 + L))
    v23 = xp.where(v7, 2.0 * L, a)
    v25 = xp.where(v5, 2.0 * P, v4)
    v24 = xp.where(v7, 2.0 * P * xp.log1p((v10 + v13) / v8) / v1 - h * L / (v13 + L), xp.nan)
    return xp.where(v5, v24, xp.nan)


def zero_distance(xp, a):
    return 0.0 * a


def minimum_load(xp, h, E_star):
    return 3.141592653589793 * E_star * h / 2.0
