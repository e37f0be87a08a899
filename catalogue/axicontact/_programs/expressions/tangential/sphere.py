"""Formulas of axicontact.tangential.sphere over an array library `xp`."""


def full_slip_displacement(xp, a, R, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = 2.0 * a
    v3 = R - a
    v4 = v2 / v3
    v5 = xp.log1p(v4)
    v6 = v5 / 2.0
    v7 = a * v6
    v8 = v1 * v7
    return v8
