"""Formulas of axicontact.graded.normal.concave_quartic over an array library `xp`."""


def minimum_depth(xp, a, h, k):
    v0 = (-4.0) * h
    v1 = k - 1.0
    v2 = v0 * v1
    v3 = k + 1.0
    v4 = v3 ** 2.0
    v5 = k + 3.0
    v6 = v4 * v5
    v7 = v2 / v6
    v8 = 0.0 * a
    v9 = v7 + v8
    return v9


def pressure(xp, r, d, a, h, H, k):
    v0 = (-4.0) * h
    v1 = k - 1.0
    v2 = v0 * v1
    v3 = k + 1.0
    v4 = v3 ** 2.0
    v5 = k + 3.0
    v6 = v4 * v5
    v7 = v2 / v6
    v8 = 0.0 * a
    v9 = v7 + v8
    v10 = v9 * 0.999999999999999
    v11 = v10 <= d
    v12 = d - v9
    v13 = 4.0 * h
    v14 = a ** 2.0
    v15 = k * v14
    v16 = r ** 2.0
    v17 = 4.0 * v16
    v18 = v15 + v17
    v19 = v18 - v14
    v20 = v19 ** 2.0
    v21 = v13 * v20
    v22 = v14 ** 2.0
    v23 = v22 * v4
    v24 = v5 ** 2.0
    v25 = v23 * v24
    v26 = v21 / v25
    v27 = v12 + v26
    v28 = r < a
    v29 = xp.where(v28, r, 0.5 * a)
    v30 = H / 3.141592653589793
    v31 = a - v29
    v32 = xp.maximum(v31, 0.0)
    v33 = a + v29
    v34 = v32 * v33
    v35 = xp.sqrt(v34)
    v36 = v35 ** k
    v37 = v30 * v36
    v38 = v37 / v35
    v39 = xp.where(v28, 2.0 * a, r)
    v40 = v39 > a
    v41 = xp.where(v40, v39, 2.0 * a)
    v42 = xp.where(v40, 0.5 * a, v39)
    v43 = xp.where(v40, 0.0, xp.inf)
    v44 = xp.where(v28, v38, v43)
    v45 = v27 * v44
    v46 = xp.where(v11, v45, xp.nan)
    return v46


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
    v0 = 1.0 - k
    v1 = xp.sqrt(v0)
    v2 = a * v1
    v3 = v2 / 2.0
    v4 = 0.0 * h
    v5 = v3 + v4
    return v5
