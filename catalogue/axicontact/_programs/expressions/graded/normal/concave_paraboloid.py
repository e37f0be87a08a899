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
    v10 = xp.where(v9, v8, 0.5 * d)
    v11 = d - v7
    v12 = 4.0 * h
    v13 = r ** 2.0
    v14 = v12 * v13
    v15 = a ** 2.0
    v16 = v15 * v4
    v17 = v14 / v16
    v18 = v11 + v17
    v19 = r < a
    v20 = xp.where(v19, r, 0.5 * a)
    v21 = H / 3.141592653589793
    v22 = a - v20
    v23 = xp.maximum(v22, 0.0)
    v24 = a + v20
    v25 = v23 * v24
    v26 = xp.sqrt(v25)
    v27 = v26 ** k
    v28 = v21 * v27
    v29 = v28 / v26
    v30 = xp.where(v19, 2.0 * a, r)
    v31 = v30 > a
    v32 = xp.where(v31, v30, 2.0 * a)
    v33 = xp.where(v31, 0.5 * a, v30)
    v34 = xp.where(v31, 0.0, xp.inf)
    v35 = xp.where(v19, v29, v34)
    v36 = v18 * v35
    v37 = xp.where(v9, 2.0 * d, v8)
    v38 = xp.where(v9, v36, xp.nan)
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


def zero_radius(xp, a, h, k):
    v0 = 0.0 * a
    v1 = 0.0 * h
    v2 = v0 + v1
    return v2
