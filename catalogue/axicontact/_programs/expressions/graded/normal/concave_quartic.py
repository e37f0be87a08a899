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
    v12 = xp.where(v11, v10, 0.5 * d)
    v13 = d - v9
    v14 = 4.0 * h
    v15 = a ** 2.0
    v16 = k * v15
    v17 = r ** 2.0
    v18 = 4.0 * v17
    v19 = v16 + v18
    v20 = v19 - v15
    v21 = v20 ** 2.0
    v22 = v14 * v21
    v23 = v15 ** 2.0
    v24 = v23 * v4
    v25 = v5 ** 2.0
    v26 = v24 * v25
    v27 = v22 / v26
    v28 = v13 + v27
    v29 = r < a
    v30 = xp.where(v29, r, 0.5 * a)
    v31 = H / 3.141592653589793
    v32 = a - v30
    v33 = xp.maximum(v32, 0.0)
    v34 = a + v30
    v35 = v33 * v34
    v36 = xp.sqrt(v35)
    v37 = v36 ** k
    v38 = v31 * v37
    v39 = v38 / v36
    v40 = xp.where(v29, 2.0 * a, r)
    v41 = v40 > a
    v42 = xp.where(v41, v40, 2.0 * a)
    v43 = xp.where(v41, 0.5 * a, v40)
    v44 = xp.where(v41, 0.0, xp.inf)
    v45 = xp.where(v29, v39, v44)
    v46 = v28 * v45
    v47 = xp.where(v11, 2.0 * d, v10)
    v48 = xp.where(v11, v46, xp.nan)
    return v48


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
