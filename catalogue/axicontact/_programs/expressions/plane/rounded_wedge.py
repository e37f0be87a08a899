"""Formulas of axicontact.plane.rounded_wedge over an array library `xp`."""


def half_width_from_load(xp, P, theta, b, E_star):
    v0 = xp.where(P > 0.0, P, 1.0)
    v1 = xp.minimum(b, xp.inf)
    for _ in range(6):
        v3 = v1 < b
        v4 = xp.where(v3, v1, 0.5 * b)
        v5 = 3.141592653589793 * E_star
        v6 = xp.tan(theta)
        v7 = v5 * v6
        v8 = 4.0 * b
        v9 = v7 / v8
        v10 = v4 ** 2.0
        v11 = v9 * v10
        v12 = xp.where(v3, 2.0 * b, v1)
        v13 = xp.tan(theta)
        v14 = E_star * v13
        v15 = v12 - b
        v16 = v12 + b
        v17 = v15 * v16
        v18 = xp.sqrt(v17)
        v19 = v12 ** 2.0
        v20 = b / v18
        v21 = xp.arctan(v20)
        v22 = v19 * v21
        v23 = v22 / b
        v24 = v18 + v23
        v25 = v14 * v24
        v26 = v25 / 2.0
        v27 = xp.where(v3, v11, v26)
        v28 = E_star * v1
        v29 = xp.where(v3, v1, 0.5 * b)
        v30 = xp.tan(theta)
        v31 = 3.141592653589793 * v30
        v32 = 2.0 * b
        v33 = v31 / v32
        v34 = v33 * v29
        v35 = xp.where(v3, 2.0 * b, v1)
        v36 = xp.tan(theta)
        v37 = v36 / b
        v38 = v37 * v35
        v39 = v35 - b
        v40 = v35 + b
        v41 = v39 * v40
        v42 = xp.sqrt(v41)
        v43 = b / v42
        v44 = xp.arctan(v43)
        v45 = v38 * v44
        v46 = xp.where(v3, v34, v45)
        v47 = v28 * v46
        v48 = v47 / v27
        v49 = xp.log(v0 / v27)
        v50 = v49 / 1.0
        v51 = v49 / 2.0
        v52 = xp.minimum(xp.maximum(v49 / v48, xp.minimum(v50, v51)), xp.maximum(v50, v51))
        v53 = xp.where(v27 < xp.inf, v52, 0.0)
        v1 = xp.minimum(v1 * xp.exp(v53), xp.inf)
    v55 = xp.where(P > 0.0, v1, 0.0 * P)
    return v55


def load(xp, a, theta, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 3.141592653589793 * E_star
    v3 = xp.tan(theta)
    v4 = v2 * v3
    v5 = 4.0 * b
    v6 = v4 / v5
    v7 = v1 ** 2.0
    v8 = v6 * v7
    v9 = xp.where(v0, 2.0 * b, a)
    v10 = xp.tan(theta)
    v11 = E_star * v10
    v12 = v9 - b
    v13 = v9 + b
    v14 = v12 * v13
    v15 = xp.sqrt(v14)
    v16 = v9 ** 2.0
    v17 = b / v15
    v18 = xp.arctan(v17)
    v19 = v16 * v18
    v20 = v19 / b
    v21 = v15 + v20
    v22 = v11 * v21
    v23 = v22 / 2.0
    v24 = xp.where(v0, v8, v23)
    return v24


def profile(xp, x, theta, b):
    v0 = x > b
    v1 = xp.where(v0, x, 2.0 * b)
    v2 = xp.tan(theta)
    v3 = b / 2.0
    v4 = v1 - v3
    v5 = v2 * v4
    v6 = xp.where(v0, 0.5 * b, x)
    v7 = xp.tan(theta)
    v8 = 2.0 * b
    v9 = v7 / v8
    v10 = v6 ** 2.0
    v11 = v9 * v10
    v12 = xp.where(v0, v5, v11)
    return v12
