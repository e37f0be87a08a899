"""Formulas of axicontact.plane.quartic over an array library `xp`."""


def profile(xp, x, A):
    return A * (x ** 2.0) ** 2.0


def load(xp, a, A, E_star):
    return 9.42477796076938 * E_star * A * (a ** 2.0) ** 2.0 / 4.0


def pressure(xp, x, a, A, E_star):
    v1 = x < a
    v2 = xp.where(v1, x, 0.5 * a)
    v14 = xp.where(v1, 2.0 * a, x)
    v13 = E_star * A * (a ** 2.0 + 2.0 * v2 ** 2.0) * xp.sqrt((a - v2) * (a + v2))
    return xp.where(v1, v13, 0.0)


def profile_slope(xp, x, A):
    return 4.0 * A * (x * x ** 2.0)


def slope(xp, x, a, A):
    v1 = x > a
    v2 = xp.where(v1, x, 2.0 * a)
    v4 = a ** 2.0
    v7 = v2 ** 2.0
    v15 = xp.sqrt((v2 - a) * (a + v2))
    v21 = 2.0 * v7 * v15 + v4 * v15 + 2.0 * (v2 * v7)
    v22 = -2.0 * A * v4 ** 2.0 * (v4 + 3.0 * v7) / v21
    return xp.where(v1, v22, -profile_slope(xp, xp.where(v1, 0.5 * a, x), A))


def depth(xp, L, a, A):
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v5 = v4 ** 2.0
    v11 = xp.sqrt((L - v4) * (v4 + L))
    v15 = L ** 2.0
    v25 = L * (v5 + 3.0 * v15) / (2.0 * (L * v15) + (v5 + 2.0 * v15) * v11)
    v30 = xp.where(v1, 2.0 * L, a)
    v29 = xp.where(v3, A * v5 ** 2.0 * (3.0 * xp.arcsinh(v11 / v4) + v25) / 2.0, 0.0)
    return xp.where(v1, v29, xp.nan)


def half_width_from_load(xp, P, A, E_star):
    return xp.sqrt(xp.sqrt(4.0 * P / (9.42477796076938 * E_star * A)))
