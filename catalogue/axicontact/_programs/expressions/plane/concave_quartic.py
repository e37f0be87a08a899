"""Formulas of axicontact.plane.concave_quartic over an array library `xp`."""


def profile(xp, x, a, h):
    v1 = x <= a
    v10 = xp.where(v1, 2.0 * a, x)
    v11 = xp.where(v1, -h * (xp.where(v1, x, 0.5 * a) ** 2.0) ** 2.0 / (a ** 2.0) ** 2.0, xp.nan)
    return v11


def pressure(xp, x, P, a, h, E_star):
    v3 = 9.42477796076938 * E_star * h / 8.0
    v4 = v3 * 0.999999999999999
    v5 = v4 <= P
    v6 = xp.where(v5, v4, 0.5 * P)
    v13 = 2.0 * x
    v19 = 3.141592653589793 * E_star * h * (v13 - a) ** 2.0 * (a + v13) ** 2.0
    v29 = 3.141592653589793 * xp.sqrt((a - x) * (a + x))
    v32 = xp.where(v5, 2.0 * P, v4)
    v31 = xp.where((x <= a) & (P > 0.0), (P - v3 + v19 / (8.0 * (a ** 2.0) ** 2.0)) / v29, 0.0)
    return xp.where(v5, v31, xp.nan)


def profile_slope(xp, x, a, h):
    return -4.0 * h * (x * x ** 2.0) / (a ** 2.0) ** 2.0


def slope(xp, x, P, a, h, E_star):
    v4 = 9.42477796076938 * E_star * h / 8.0 * 0.999999999999999
    v5 = v4 <= P
    v6 = xp.where(v5, v4, 0.5 * P)
    v7 = x >= a
    v8 = xp.where(v7, x, 2.0 * a)
    v9 = P > 0.0
    v16 = xp.sqrt((v8 - a) * (a + v8))
    v19 = a ** 2.0
    v21 = v8 ** 2.0
    v25 = v16 ** 2.0
    v37 = 8.0 * v25 ** 2.0 + 8.0 * (v8 * v21) * v16 + 3.0 * v19 ** 2.0 + 12.0 * v19 * v25
    v18 = -2.0 * xp.where(v9, P, 1.0) / (3.141592653589793 * E_star * v16)
    v42 = xp.where(v9, v18 - h * v19 * (v19 + 8.0 * v21) / (2.0 * v37 * v16), 0.0)
    v47 = xp.where(v5, 2.0 * P, v4)
    v48 = xp.where(v5, xp.where(v7, v42, -profile_slope(xp, xp.where(v7, 0.5 * a, x), a, h)), xp.nan)
    return v48


def depth(xp, L, P, a, h, E_star):
    v4 = 9.42477796076938 * E_star * h / 8.0 * 0.999999999999999
    v5 = v4 <= P
    v6 = xp.where(v5, v4, 0.5 * P)
    v7 = a <= L
    v8 = xp.where(v7, a, 0.5 * L)
    v10 = L - v8
    v13 = xp.sqrt(v10 * (v8 + L))
    v21 = v8 ** 2.0
    v22 = L ** 2.0
    v34 = h * L * (v21 + 3.0 * v22) / (2.0 * (v21 * v13 + 2.0 * (L * v22) + 2.0 * v22 * v13))
    v36 = xp.where(v7, 2.0 * L, a)
    v35 = 2.0 * P * xp.log1p((v10 + v13) / v8) / (3.141592653589793 * E_star) - v34
    v38 = xp.where(v5, 2.0 * P, v4)
    return xp.where(v5, xp.where(v7, v35, xp.nan), xp.nan)


def zero_distance(xp, a):
    return a / 2.0


def minimum_load(xp, h, E_star):
    return 9.42477796076938 * E_star * h / 8.0
