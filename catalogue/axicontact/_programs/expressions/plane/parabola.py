"""Formulas of axicontact.plane.parabola over an array library `xp`."""


def profile(xp, x, R):
    return x ** 2.0 / (2.0 * R)


def load(xp, a, R, E_star):
    return 3.141592653589793 * E_star / (4.0 * R) * a ** 2.0


def pressure(xp, x, a, R, E_star):
    v1 = x < a
    v2 = xp.where(v1, x, 0.5 * a)
    v10 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, E_star / (2.0 * R) * xp.sqrt((a - v2) * (a + v2)), 0.0)


def slope(xp, x, a, R):
    v1 = x > a
    v2 = xp.where(v1, x, 2.0 * a)
    v11 = -a ** 2.0 / (R * (xp.sqrt((v2 - a) * (a + v2)) + v2))
    return xp.where(v1, v11, -(xp.where(v1, 0.5 * a, x) / R))


def depth(xp, L, a, R):
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v6 = L - v4
    v9 = xp.sqrt(v6 * (v4 + L))
    v20 = xp.where(v1, 2.0 * L, a)
    v19 = xp.where(v3, v4 ** 2.0 * (L / (v9 + L) + xp.log1p((v6 + v9) / v4)) / (2.0 * R), 0.0)
    return xp.where(v1, v19, xp.nan)


def half_width_from_load(xp, P, R, E_star):
    return xp.sqrt(4.0 * R / (3.141592653589793 * E_star) * P)
