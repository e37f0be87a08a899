"""Formulas of axicontact.plane.sextic over an array library `xp`."""


def profile(xp, x, A):
    return A * x ** 6.0


def load(xp, a, A, E_star):
    return 47.12388980384689 * E_star * A * a ** 6.0 / 16.0


def pressure(xp, x, a, A, E_star):
    v1 = x < a
    v2 = xp.where(v1, x, 0.5 * a)
    v5 = a ** 2.0
    v9 = v2 ** 2.0
    v15 = 3.0 * E_star * A * (3.0 * v5 ** 2.0 + 4.0 * v5 * v9 + 8.0 * v9 ** 2.0)
    v22 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, v15 * xp.sqrt((a - v2) * (a + v2)) / 8.0, 0.0)


def slope(xp, x, a, A):
    v1 = x > a
    v2 = xp.where(v1, x, 2.0 * a)
    v6 = a ** 2.0
    v7 = v6 ** 2.0
    v10 = v2 ** 2.0
    v13 = v10 ** 2.0
    v21 = xp.sqrt((v2 - a) * (a + v2))
    v32 = 8.0 * v13 * v21 + 3.0 * v7 * v21 + 4.0 * v6 * v10 * v21 + 8.0 * v2 ** 5.0
    v34 = -3.0 * A * a ** 6.0 * (9.0 * v7 + 15.0 * v6 * v10 + 40.0 * v13) / (4.0 * v32)
    return xp.where(v1, v34, -(6.0 * A * xp.where(v1, 0.5 * a, x) ** 5.0))


def depth(xp, L, a, A):
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v10 = xp.sqrt((L - v4) * (v4 + L))
    v14 = v4 ** 2.0
    v15 = v14 ** 2.0
    v17 = L ** 2.0
    v18 = v17 ** 2.0
    v34 = 8.0 * L ** 5.0 + (3.0 * v15 + 8.0 * v18 + 4.0 * v14 * v17) * v10
    v35 = L * (9.0 * v15 + 40.0 * v18 + 15.0 * v14 * v17) / v34
    v40 = xp.where(v1, 2.0 * L, a)
    v39 = xp.where(v3, A * v4 ** 6.0 * (15.0 * xp.arcsinh(v10 / v4) + v35) / 8.0, 0.0)
    return xp.where(v1, v39, xp.nan)


def half_width_from_load(xp, P, A, E_star):
    v4 = 16.0 * P / (47.12388980384689 * E_star * A)
    v8 = v4 ** 0.16666666666666666
    v16 = v8 + v8 * ((v4 / (v8 ** 6.0 * v8 ** 0.0) - 1.0) / 6.0)
    return xp.where((v4 > 0.0) & (v4 < xp.inf), v16, v8)
