"""Formulas of axicontact.plane.parabola over an array library `xp`."""


def depth(xp, L, a, R):
    v0 = a <= L
    v1 = xp.where(v0, a, 0.5 * L)
    v2 = v1 > 0.0
    v3 = v1 ** 2.0
    v4 = L - v1
    v5 = v1 + L
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v7 + L
    v9 = L / v8
    v10 = v4 + v7
    v11 = v10 / v1
    v12 = xp.log1p(v11)
    v13 = v9 + v12
    v14 = v3 * v13
    v15 = 2.0 * R
    v16 = v14 / v15
    v17 = xp.where(v2, v16, 0.0)
    v18 = xp.where(v0, 2.0 * L, a)
    v19 = xp.where(v0, v17, xp.nan)
    return v19


def half_width_from_load(xp, P, R, E_star):
    v0 = 4.0 * R
    v1 = 3.141592653589793 * E_star
    v2 = v0 / v1
    v3 = v2 * P
    v4 = xp.sqrt(v3)
    return v4


def load(xp, a, R, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = 4.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = v2 * v3
    return v4


def pressure(xp, x, a, R, E_star):
    v0 = x < a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = 2.0 * R
    v3 = E_star / v2
    v4 = a - v1
    v5 = a + v1
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v3 * v7
    v9 = xp.where(v0, 2.0 * a, x)
    v10 = xp.where(v0, v8, 0.0)
    return v10


def profile(xp, x, R):
    v0 = x ** 2.0
    v1 = 2.0 * R
    v2 = v0 / v1
    return v2


def slope(xp, x, a, R):
    v0 = x > a
    v1 = xp.where(v0, x, 2.0 * a)
    v2 = a ** 2.0
    v3 = -v2
    v4 = v1 - a
    v5 = a + v1
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v7 + v1
    v9 = R * v8
    v10 = v3 / v9
    v11 = xp.where(v0, 0.5 * a, x)
    v12 = v11 / R
    v13 = -v12
    v14 = xp.where(v0, v10, v13)
    return v14
