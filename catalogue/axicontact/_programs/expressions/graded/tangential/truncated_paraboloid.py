"""Formulas of axicontact.graded.tangential.truncated_paraboloid over an array library `xp`."""


def full_slip_displacement(xp, a, R, b, H, H_x, k, mu):
    v0 = H / H_x
    v1 = mu * v0
    v2 = a >= b
    v3 = xp.where(v2, a, 2.0 * b)
    v4 = v3 * v3
    v5 = v3 - b
    v6 = xp.maximum(v5, 0.0)
    v7 = v3 + b
    v8 = v6 * v7
    v9 = xp.sqrt(v8)
    v10 = v9 / v3
    v11 = v10 > 0.0
    v12 = v10 ** k
    v13 = v10 * v12
    v14 = xp.where(v11, v13, 0.0)
    v15 = v4 * v14
    v16 = 1.0 + k
    v17 = v15 / v16
    v18 = 0.0 * b
    v19 = v17 + v18
    v20 = v19 / R
    v21 = xp.where(v2, 0.5 * b, a)
    v22 = xp.where(v2, v20, xp.nan)
    v23 = v1 * v22
    return v23
