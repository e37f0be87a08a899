"""Formulas of axicontact.tangential.capped_paraboloid over an array library `xp`."""


def full_slip_displacement(xp, a, R1, R2, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a < b
    v3 = xp.where(v2, a, 0.5 * b)
    v4 = v3 ** 2.0
    v5 = v4 / R1
    v6 = xp.where(v2, 2.0 * b, a)
    v7 = R1 - R2
    v8 = v7 / R2
    v9 = v6 - b
    v10 = v6 + b
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = v8 * v12
    v14 = v6 + v13
    v15 = v6 * v14
    v16 = v15 / R1
    v17 = xp.where(v2, v5, v16)
    v18 = v1 * v17
    return v18
