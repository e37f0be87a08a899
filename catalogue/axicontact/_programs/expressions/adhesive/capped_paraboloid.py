"""Formulas of axicontact.adhesive.capped_paraboloid over an array library `xp`."""


def depth(xp, a, R1, R2, b, E_star, dgamma):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = v1 ** 2.0
    v3 = v2 / R1
    v4 = xp.where(v0, 2.0 * b, a)
    v5 = R1 - R2
    v6 = v5 / R2
    v7 = v4 - b
    v8 = v4 + b
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v6 * v10
    v12 = v4 + v11
    v13 = v4 * v12
    v14 = v13 / R1
    v15 = xp.where(v0, v3, v14)
    v16 = xp.sqrt(a)
    v17 = 6.283185307179586 * dgamma
    v18 = v17 / E_star
    v19 = xp.sqrt(v18)
    v20 = v16 * v19
    v21 = v15 - v20
    return v21


def force(xp, a, R1, R2, b, E_star, dgamma):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = 3.0 * R1
    v4 = v2 / v3
    v5 = v1 ** 2.0
    v6 = v1 * v5
    v7 = v4 * v6
    v8 = xp.where(v0, 2.0 * b, a)
    v9 = 2.0 * E_star
    v10 = 3.0 * R1
    v11 = v9 / v10
    v12 = v8 ** 2.0
    v13 = v8 * v12
    v14 = 2.0 * v13
    v15 = R1 - R2
    v16 = v15 / R2
    v17 = 2.0 * v12
    v18 = b ** 2.0
    v19 = v17 + v18
    v20 = v16 * v19
    v21 = v8 - b
    v22 = v8 + b
    v23 = v21 * v22
    v24 = xp.sqrt(v23)
    v25 = v20 * v24
    v26 = v14 + v25
    v27 = v11 * v26
    v28 = xp.where(v0, v7, v27)
    v29 = 2.0 * E_star
    v30 = v29 * a
    v31 = xp.sqrt(a)
    v32 = 6.283185307179586 * dgamma
    v33 = v32 / E_star
    v34 = xp.sqrt(v33)
    v35 = v31 * v34
    v36 = v30 * v35
    v37 = v28 - v36
    return v37
