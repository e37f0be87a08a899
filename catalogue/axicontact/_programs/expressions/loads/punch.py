"""Formulas of axicontact.loads.punch over an array library `xp`."""


def displacement(xp, r, a, p_0, E_star):
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v13 = xp.where(v1, 0.5 * a, r)
    v12 = 2.0 * p_0 / E_star * a * xp.arctan(a / xp.sqrt((v2 - a) * (a + v2)))
    return xp.where(v1, v12, 3.141592653589793 * p_0 / E_star * a)
