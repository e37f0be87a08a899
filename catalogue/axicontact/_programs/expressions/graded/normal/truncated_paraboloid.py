"""Formulas of axicontact.graded.normal.truncated_paraboloid over an array library `xp`."""


def depth(xp, a, R, b, k):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = v1 * v1
    v3 = v1 - b
    v4 = xp.maximum(v3, 0.0)
    v5 = v1 + b
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v7 / v1
    v9 = v8 > 0.0
    v10 = v8 ** k
    v11 = v8 * v10
    v12 = xp.where(v9, v11, 0.0)
    v13 = v2 * v12
    v14 = 1.0 + k
    v15 = v13 / v14
    v16 = 0.0 * b
    v17 = v15 + v16
    v18 = v17 / R
    v19 = xp.where(v0, 0.5 * b, a)
    v20 = xp.where(v0, v18, xp.nan)
    return v20


def force(xp, a, R, b, H, k):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = 2.0 * H
    v3 = 1.0 + k
    v4 = v2 / v3
    v5 = v1 * v1
    v6 = v1 > 0.0
    v7 = v1 ** k
    v8 = v1 * v7
    v9 = xp.where(v6, v8, 0.0)
    v10 = v5 * v9
    v11 = v1 - b
    v12 = xp.maximum(v11, 0.0)
    v13 = v1 + b
    v14 = v12 * v13
    v15 = xp.sqrt(v14)
    v16 = xp.maximum(v1, b)
    v17 = v15 / v16
    v18 = v17 > 0.0
    v19 = v17 ** k
    v20 = v17 * v19
    v21 = xp.where(v18, v20, 0.0)
    v22 = v10 * v21
    v23 = 3.0 + k
    v24 = v17 ** 2.0
    v25 = v3 * v24
    v26 = v23 - v25
    v27 = v22 * v26
    v28 = v3 * v23
    v29 = v27 / v28
    v30 = 0.0 * b
    v31 = v29 + v30
    v32 = v31 / R
    v33 = v4 * v32
    v34 = xp.where(v0, 0.5 * b, a)
    v35 = xp.where(v0, v33, xp.nan)
    return v35


def mean_pressure(xp, a, R, b, H, k):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = 2.0 * H
    v3 = 1.0 + k
    v4 = v2 / v3
    v5 = v1 * v1
    v6 = v1 > 0.0
    v7 = v1 ** k
    v8 = v1 * v7
    v9 = xp.where(v6, v8, 0.0)
    v10 = v5 * v9
    v11 = v1 - b
    v12 = xp.maximum(v11, 0.0)
    v13 = v1 + b
    v14 = v12 * v13
    v15 = xp.sqrt(v14)
    v16 = xp.maximum(v1, b)
    v17 = v15 / v16
    v18 = v17 > 0.0
    v19 = v17 ** k
    v20 = v17 * v19
    v21 = xp.where(v18, v20, 0.0)
    v22 = v10 * v21
    v23 = 3.0 + k
    v24 = v17 ** 2.0
    v25 = v3 * v24
    v26 = v23 - v25
    v27 = v22 * v26
    v28 = v3 * v23
    v29 = v27 / v28
    v30 = 0.0 * b
    v31 = v29 + v30
    v32 = v31 / R
    v33 = v4 * v32
    v34 = xp.where(v0, 0.5 * b, a)
    v35 = xp.where(v0, v33, xp.nan)
    v36 = 3.141592653589793 * a
    v37 = v36 * a
    v38 = v35 / v37
    return v38


def stiffness(xp, a, H, k):
    v0 = 2.0 * H
    v1 = 1.0 + k
    v2 = v0 / v1
    v3 = a > 0.0
    v4 = a ** k
    v5 = a * v4
    v6 = xp.where(v3, v5, 0.0)
    v7 = v2 * v6
    return v7
