"""Formulas of axicontact.tangential.hyperboloid over an array library `xp`."""


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.tan(theta)
    v3 = v2 * a
    v4 = a / b
    v5 = xp.arctan(v4)
    v6 = v3 * v5
    v7 = v1 * v6
    return v7
