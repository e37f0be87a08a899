"""Formulas of axicontact.tangential.ellipsoid over an array library `xp`."""


def full_slip_displacement(xp, a, h, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = h / b
    v3 = v2 * a
    v4 = 2.0 * a
    v5 = b - a
    v6 = v4 / v5
    v7 = xp.log1p(v6)
    v8 = v7 / 2.0
    v9 = v3 * v8
    v10 = v1 * v9
    return v10
