"""Formulas of axicontact.adhesive.truncated_paraboloid over an array library `xp`."""


def depth(xp, a, R, b, E_star, dgamma):
    v0 = a - b
    v1 = a + b
    v2 = v0 * v1
    v3 = xp.sqrt(v2)
    v4 = a * v3
    v5 = v4 / R
    v6 = xp.sqrt(a)
    v7 = 6.283185307179586 * dgamma
    v8 = v7 / E_star
    v9 = xp.sqrt(v8)
    v10 = v6 * v9
    v11 = v5 - v10
    return v11


def force(xp, a, R, b, E_star, dgamma):
    v0 = 2.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = 2.0 * v3
    v5 = b ** 2.0
    v6 = v4 + v5
    v7 = v2 * v6
    v8 = a - b
    v9 = a + b
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v7 * v11
    v13 = v0 * a
    v14 = xp.sqrt(a)
    v15 = 6.283185307179586 * dgamma
    v16 = v15 / E_star
    v17 = xp.sqrt(v16)
    v18 = v14 * v17
    v19 = v13 * v18
    v20 = v12 - v19
    return v20
