"""Formulas of axicontact.normal.flat_punch over an array library `xp`."""


def profile(xp, r, a):
    v1 = r <= a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, 0.0, xp.nan)


def force(xp, d, a, E_star):
    return 2.0 * E_star * d * a


def pressure(xp, r, d, a, E_star):
    v10 = E_star * d / (3.141592653589793 * xp.sqrt((a - r) * (a + r)))
    return xp.where((r <= a) & (d > 0.0), v10, 0.0)


def displacement(xp, r, d, a):
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v12 = xp.where(v1, 0.5 * a, r)
    v13 = v12 <= a
    v14 = xp.where(v13, v12, 0.5 * a)
    v15 = xp.where(v13, 2.0 * a, v12)
    v11 = 2.0 * d * xp.arctan(a / xp.sqrt((v2 - a) * (a + v2))) / 3.141592653589793
    return xp.where(v1, v11, d - xp.where(v13, 0.0, xp.nan))


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def depth_from_force(xp, F, a, E_star):
    return F / (2.0 * E_star * a)


def energy(xp, d, a, E_star):
    return E_star * d ** 2.0 * a


def load_within(xp, r, d, a, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v13 = xp.where(v1, 2.0 * a, r)
    v12 = 2.0 * E_star * d * v2 ** 2.0 / (xp.sqrt((a - v2) * (a + v2)) + a)
    return xp.where(v1, v12, 2.0 * E_star * d * a)
