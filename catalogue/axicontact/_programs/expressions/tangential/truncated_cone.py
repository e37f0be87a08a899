"""Formulas of axicontact.tangential.truncated_cone over an array library `xp`."""


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.tan(theta)
    v3 = v2 * a
    v4 = a - b
    v5 = a + b
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v7 / b
    v9 = xp.arctan(v8)
    v10 = v3 * v9
    v11 = v1 * v10
    return v11
