"""Formulas of axicontact.plane.concave_power over an array library `xp`."""


def profile(xp, x, a, h, n):
    v0 = x <= a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = -h
    v3 = v1 ** n
    v4 = v2 * v3
    v5 = a ** n
    v6 = v4 / v5
    v7 = xp.where(v0, 2.0 * a, x)
    v8 = xp.where(v0, v6, xp.nan)
    return v8
