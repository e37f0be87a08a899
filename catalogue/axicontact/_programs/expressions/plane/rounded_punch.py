"""Formulas of axicontact.plane.rounded_punch over an array library `xp`."""


def profile(xp, x, R, b):
    v0 = x > b
    v1 = xp.where(v0, x, 2.0 * b)
    v2 = v1 - b
    v3 = v2 ** 2.0
    v4 = 2.0 * R
    v5 = v3 / v4
    v6 = xp.where(v0, 0.5 * b, x)
    v7 = xp.where(v0, v5, 0.0)
    return v7
