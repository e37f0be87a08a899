"""Formulas of axicontact.normal.concave_paraboloid over an array library `xp`."""


def depth_from_force(xp, F, a, h, E_star):
    v0 = 16.0 * E_star
    v1 = v0 * h
    v2 = v1 / 3.0
    v3 = v2 * a
    v4 = v3 * 0.999999999999999
    v5 = v4 <= F
    v6 = 2.0 * E_star
    v7 = v6 * a
    v8 = F / v7
    v9 = 2.0 * h
    v10 = v9 / 3.0
    v11 = v8 - v10
    v12 = xp.where(v5, v11, xp.nan)
    return v12


def force(xp, d, a, h, E_star):
    v0 = 2.0 * h
    v1 = v0 * 0.999999999999999
    v2 = v1 <= d
    v3 = 2.0 * E_star
    v4 = v3 * a
    v5 = v0 / 3.0
    v6 = d + v5
    v7 = v4 * v6
    v8 = xp.where(v2, v7, xp.nan)
    return v8


def minimum_depth(xp, h):
    v0 = 2.0 * h
    return v0


def minimum_force(xp, a, h, E_star):
    v0 = 16.0 * E_star
    v1 = v0 * h
    v2 = v1 / 3.0
    v3 = v2 * a
    return v3


def pressure(xp, r, d, a, h, E_star):
    v0 = 2.0 * h
    v1 = v0 * 0.999999999999999
    v2 = v1 <= d
    v3 = r <= a
    v4 = d > 0.0
    v5 = v3 & v4
    v6 = E_star / 3.141592653589793
    v7 = d - v0
    v8 = 4.0 * h
    v9 = r ** 2.0
    v10 = v8 * v9
    v11 = a ** 2.0
    v12 = v10 / v11
    v13 = v7 + v12
    v14 = v6 * v13
    v15 = a - r
    v16 = a + r
    v17 = v15 * v16
    v18 = xp.sqrt(v17)
    v19 = v14 / v18
    v20 = xp.where(v5, v19, 0.0)
    v21 = xp.where(v2, v20, xp.nan)
    return v21


def profile(xp, r, a, h):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = -h
    v3 = v1 ** 2.0
    v4 = v2 * v3
    v5 = a ** 2.0
    v6 = v4 / v5
    v7 = xp.where(v0, 2.0 * a, r)
    v8 = xp.where(v0, v6, xp.nan)
    return v8


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1


def zero_radius(xp, ):
    return 0.0
