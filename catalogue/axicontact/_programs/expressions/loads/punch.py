"""Formulas of axicontact.loads.punch over an array library `xp`."""


def displacement(xp, r, a, p_0, E_star):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = 2.0 * p_0
    v3 = v2 / E_star
    v4 = v3 * a
    v5 = v1 - a
    v6 = a + v1
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = a / v8
    v10 = xp.arctan(v9)
    v11 = v4 * v10
    v12 = xp.where(v0, 0.5 * a, r)
    v13 = 3.141592653589793 * p_0
    v14 = v13 / E_star
    v15 = v14 * a
    v16 = xp.where(v0, v11, v15)
    return v16
