"""Formulas of axicontact.normal.flat_punch over an array library `xp`."""


def depth_from_force(xp, F, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    v2 = F / v1
    return v2


def displacement(xp, r, d, a):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = 2.0 * d
    v3 = v1 - a
    v4 = a + v1
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = a / v6
    v8 = xp.arctan(v7)
    v9 = v2 * v8
    v10 = v9 / 3.141592653589793
    v11 = xp.where(v0, 0.5 * a, r)
    v12 = v11 <= a
    v13 = xp.where(v12, v11, 0.5 * a)
    v14 = xp.where(v12, 2.0 * a, v11)
    v15 = xp.where(v12, 0.0, xp.nan)
    v16 = d - v15
    v17 = xp.where(v0, v10, v16)
    return v17


def force(xp, d, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * d
    v2 = v1 * a
    return v2


def pressure(xp, r, d, a, E_star):
    v0 = r <= a
    v1 = d > 0.0
    v2 = v0 & v1
    v3 = E_star * d
    v4 = a - r
    v5 = a + r
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = 3.141592653589793 * v7
    v9 = v3 / v8
    v10 = xp.where(v2, v9, 0.0)
    return v10


def profile(xp, r, a):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = xp.where(v0, 2.0 * a, r)
    v3 = xp.where(v0, 0.0, xp.nan)
    return v3


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
