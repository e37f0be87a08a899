"""Formulas of axicontact.normal.concave_quartic over an array library `xp`."""


def depth_from_force(xp, F, a, h, E_star):
    v0 = 56.0 * E_star
    v1 = v0 * h
    v2 = v1 / 15.0
    v3 = v2 * a
    v4 = v3 * 0.999999999999999
    v5 = v4 <= F
    v6 = 2.0 * E_star
    v7 = v6 * a
    v8 = F / v7
    v9 = 8.0 * h
    v10 = v9 / 15.0
    v11 = v8 - v10
    v12 = xp.where(v5, v11, xp.nan)
    return v12


def force(xp, d, a, h, E_star):
    v0 = 4.0 * h
    v1 = v0 / 3.0
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = 2.0 * E_star
    v5 = v4 * a
    v6 = 8.0 * h
    v7 = v6 / 15.0
    v8 = d + v7
    v9 = v5 * v8
    v10 = xp.where(v3, v9, xp.nan)
    return v10


def minimum_depth(xp, h):
    v0 = 4.0 * h
    v1 = v0 / 3.0
    return v1


def minimum_force(xp, a, h, E_star):
    v0 = 56.0 * E_star
    v1 = v0 * h
    v2 = v1 / 15.0
    v3 = v2 * a
    return v3


def pressure(xp, r, d, a, h, E_star):
    v0 = 4.0 * h
    v1 = v0 / 3.0
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = r <= a
    v5 = d > 0.0
    v6 = v4 & v5
    v7 = E_star / 3.141592653589793
    v8 = d - v1
    v9 = 2.0 * r
    v10 = v9 - a
    v11 = v10 ** 2.0
    v12 = v0 * v11
    v13 = a + v9
    v14 = v13 ** 2.0
    v15 = v12 * v14
    v16 = a ** 2.0
    v17 = v16 ** 2.0
    v18 = 9.0 * v17
    v19 = v15 / v18
    v20 = v8 + v19
    v21 = v7 * v20
    v22 = a - r
    v23 = a + r
    v24 = v22 * v23
    v25 = xp.sqrt(v24)
    v26 = v21 / v25
    v27 = xp.where(v6, v26, 0.0)
    v28 = xp.where(v3, v27, xp.nan)
    return v28


def profile(xp, r, a, h):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = -h
    v3 = v1 ** 2.0
    v4 = v3 ** 2.0
    v5 = v2 * v4
    v6 = a ** 2.0
    v7 = v6 ** 2.0
    v8 = v5 / v7
    v9 = xp.where(v0, 2.0 * a, r)
    v10 = xp.where(v0, v8, xp.nan)
    return v10


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1


def zero_radius(xp, a):
    v0 = a / 2.0
    return v0
