"""Formulas of axicontact.graded.normal.concave_paraboloid over an array library `xp`."""


def minimum_depth(xp, a, h, k):
    v0 = (-2.0) * h
    v1 = k - 1.0
    v2 = v0 * v1
    v3 = k + 1.0
    v4 = v3 ** 2.0
    v5 = v2 / v4
    v6 = 0.0 * a
    v7 = v5 + v6
    return v7


def pressure(xp, r, d, a, h, H, k):
    v0 = (-2.0) * h
    v1 = k - 1.0
    v2 = v0 * v1
    v3 = k + 1.0
    v4 = v3 ** 2.0
    v5 = v2 / v4
    v6 = 0.0 * a
    v7 = v5 + v6
    v8 = v7 * 0.999999999999999
    v9 = v8 <= d
    v10 = d - v7
    v11 = 4.0 * h
    v12 = r ** 2.0
    v13 = v11 * v12
    v14 = a ** 2.0
    v15 = v14 * v4
    v16 = v13 / v15
    v17 = v10 + v16
    v18 = r < a
    v19 = xp.where(v18, r, 0.5 * a)
    v20 = H / 3.141592653589793
    v21 = a - v19
    v22 = xp.maximum(v21, 0.0)
    v23 = a + v19
    v24 = v22 * v23
    v25 = xp.sqrt(v24)
    v26 = v25 ** k
    v27 = v20 * v26
    v28 = v27 / v25
    v29 = xp.where(v18, 2.0 * a, r)
    v30 = v29 > a
    v31 = xp.where(v30, v29, 2.0 * a)
    v32 = xp.where(v30, 0.5 * a, v29)
    v33 = xp.where(v30, 0.0, xp.inf)
    v34 = xp.where(v18, v28, v33)
    v35 = v17 * v34
    v36 = xp.where(v9, v35, xp.nan)
    return v36


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


def zero_radius(xp, a, h, k):
    v0 = 0.0 * a
    v1 = 0.0 * h
    v2 = v0 + v1
    return v2
