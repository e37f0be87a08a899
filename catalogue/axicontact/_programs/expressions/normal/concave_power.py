"""Formulas of axicontact.normal.concave_power over an array library `xp`."""


def profile(xp, r, a, h, n):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = -h
    v3 = v1 / a
    v4 = v3 ** n
    v5 = v2 * v4
    v6 = xp.where(v0, 2.0 * a, r)
    v7 = xp.where(v0, v5, xp.nan)
    return v7


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
