"""Formulas of axicontact.tangential.truncated_paraboloid over an array library `xp`."""


def full_slip_displacement(xp, a, R, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a - b
    v3 = a + b
    v4 = v2 * v3
    v5 = xp.sqrt(v4)
    v6 = a * v5
    v7 = v6 / R
    v8 = v1 * v7
    return v8
