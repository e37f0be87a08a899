"""Formulas of axicontact.adhesive.cone over an array library `xp`."""


def depth(xp, a, theta, E_star, dgamma):
    v0 = xp.tan(theta)
    v1 = 3.141592653589793 * v0
    v2 = v1 * a
    v3 = v2 / 2.0
    v4 = xp.sqrt(a)
    v5 = 6.283185307179586 * dgamma
    v6 = v5 / E_star
    v7 = xp.sqrt(v6)
    v8 = v4 * v7
    v9 = v3 - v8
    return v9


def displacement(xp, r, a, theta, E_star, dgamma):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = xp.tan(theta)
    v3 = v2 * a
    v4 = v1 - a
    v5 = v1 + a
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v1 + v7
    v9 = a / v8
    v10 = xp.arctan(v9)
    v11 = 2.0 * v10
    v12 = v11 - v9
    v13 = v3 * v12
    v14 = xp.where(v0, 0.5 * a, r)
    v15 = xp.tan(theta)
    v16 = 3.141592653589793 * v15
    v17 = v16 * a
    v18 = v17 / 2.0
    v19 = v15 * v14
    v20 = v18 - v19
    v21 = xp.where(v0, v13, v20)
    v22 = xp.sqrt(a)
    v23 = 6.283185307179586 * dgamma
    v24 = v23 / E_star
    v25 = xp.sqrt(v24)
    v26 = v22 * v25
    v27 = xp.where(v0, r, 2.0 * a)
    v28 = v27 - a
    v29 = xp.maximum(v28, 0.0)
    v30 = v27 + a
    v31 = v29 * v30
    v32 = xp.sqrt(v31)
    v33 = xp.arctan2(a, v32)
    v34 = 0.6366197723675814 * v33
    v35 = xp.where(v0, 0.5 * a, r)
    v36 = xp.where(v0, v34, 1.0)
    v37 = v26 * v36
    v38 = v21 - v37
    return v38


def force(xp, a, theta, E_star, dgamma):
    v0 = 3.141592653589793 * E_star
    v1 = xp.tan(theta)
    v2 = v0 * v1
    v3 = a ** 2.0
    v4 = v2 * v3
    v5 = v4 / 2.0
    v6 = 2.0 * E_star
    v7 = v6 * a
    v8 = xp.sqrt(a)
    v9 = 6.283185307179586 * dgamma
    v10 = v9 / E_star
    v11 = xp.sqrt(v10)
    v12 = v8 * v11
    v13 = v7 * v12
    v14 = v5 - v13
    return v14


def pressure(xp, r, a, theta, E_star, dgamma):
    v0 = r < a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = xp.tan(theta)
    v3 = E_star * v2
    v4 = a - v1
    v5 = a + v1
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v4 + v7
    v9 = v8 / v1
    v10 = xp.log1p(v9)
    v11 = v3 * v10
    v12 = v11 / 2.0
    v13 = xp.where(v0, 2.0 * a, r)
    v14 = xp.where(v0, v12, 0.0)
    v15 = r <= a
    v16 = xp.where(v15, r, 0.5 * a)
    v17 = xp.sqrt(a)
    v18 = 6.283185307179586 * dgamma
    v19 = v18 / E_star
    v20 = xp.sqrt(v19)
    v21 = v17 * v20
    v22 = v21 > 0.0
    v23 = E_star * v21
    v24 = a - v16
    v25 = xp.maximum(v24, 0.0)
    v26 = a + v16
    v27 = v25 * v26
    v28 = xp.sqrt(v27)
    v29 = 3.141592653589793 * v28
    v30 = v23 / v29
    v31 = xp.where(v22, v30, 0.0)
    v32 = xp.where(v15, 2.0 * a, r)
    v33 = xp.where(v15, v31, 0.0)
    v34 = v14 - v33
    return v34
