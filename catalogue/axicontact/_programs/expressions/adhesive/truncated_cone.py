"""Formulas of axicontact.adhesive.truncated_cone over an array library `xp`."""


def depth(xp, a, theta, b, E_star, dgamma):
    v0 = xp.tan(theta)
    v1 = v0 * a
    v2 = a - b
    v3 = a + b
    v4 = v2 * v3
    v5 = xp.sqrt(v4)
    v6 = v5 / b
    v7 = xp.arctan(v6)
    v8 = v1 * v7
    v9 = xp.sqrt(a)
    v10 = 6.283185307179586 * dgamma
    v11 = v10 / E_star
    v12 = xp.sqrt(v11)
    v13 = v9 * v12
    v14 = v8 - v13
    return v14


def force(xp, a, theta, b, E_star, dgamma):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = a ** 2.0
    v3 = a - b
    v4 = a + b
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = v6 / b
    v8 = xp.arctan(v7)
    v9 = v2 * v8
    v10 = b * v6
    v11 = v9 + v10
    v12 = v1 * v11
    v13 = 2.0 * E_star
    v14 = v13 * a
    v15 = xp.sqrt(a)
    v16 = 6.283185307179586 * dgamma
    v17 = v16 / E_star
    v18 = xp.sqrt(v17)
    v19 = v15 * v18
    v20 = v14 * v19
    v21 = v12 - v20
    return v21
