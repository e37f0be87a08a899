"""Formulas of axicontact.tangential.rounded_cone over an array library `xp`."""


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a < b
    v3 = xp.where(v2, a, 0.5 * b)
    v4 = xp.tan(theta)
    v5 = v4 / b
    v6 = v3 ** 2.0
    v7 = v5 * v6
    v8 = xp.where(v2, 2.0 * b, a)
    v9 = xp.tan(theta)
    v10 = v9 * v8
    v11 = v8 - b
    v12 = v8 + b
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = v14 / b
    v16 = xp.arctan(v15)
    v17 = v14 + v8
    v18 = b / v17
    v19 = v16 + v18
    v20 = v10 * v19
    v21 = xp.where(v2, v7, v20)
    v22 = v1 * v21
    return v22
