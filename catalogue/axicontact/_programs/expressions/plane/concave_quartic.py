"""Formulas of axicontact.plane.concave_quartic over an array library `xp`."""


def depth(xp, L, P, a, h, E_star):
    v0 = 9.42477796076938 * E_star
    v1 = v0 * h
    v2 = v1 / 8.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = a <= L
    v6 = xp.where(v5, a, 0.5 * L)
    v7 = 2.0 * P
    v8 = L - v6
    v9 = v6 + L
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v8 + v11
    v13 = v12 / v6
    v14 = xp.log1p(v13)
    v15 = v7 * v14
    v16 = 3.141592653589793 * E_star
    v17 = v15 / v16
    v18 = h * L
    v19 = v6 ** 2.0
    v20 = L ** 2.0
    v21 = 3.0 * v20
    v22 = v19 + v21
    v23 = v18 * v22
    v24 = v19 * v11
    v25 = L * v20
    v26 = 2.0 * v25
    v27 = v24 + v26
    v28 = 2.0 * v20
    v29 = v28 * v11
    v30 = v27 + v29
    v31 = 2.0 * v30
    v32 = v23 / v31
    v33 = v17 - v32
    v34 = xp.where(v5, 2.0 * L, a)
    v35 = xp.where(v5, v33, xp.nan)
    v36 = xp.where(v4, v35, xp.nan)
    return v36


def minimum_load(xp, h, E_star):
    v0 = 9.42477796076938 * E_star
    v1 = v0 * h
    v2 = v1 / 8.0
    return v2


def pressure(xp, x, P, a, h, E_star):
    v0 = 9.42477796076938 * E_star
    v1 = v0 * h
    v2 = v1 / 8.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = x <= a
    v6 = P > 0.0
    v7 = v5 & v6
    v8 = P - v2
    v9 = 3.141592653589793 * E_star
    v10 = v9 * h
    v11 = 2.0 * x
    v12 = v11 - a
    v13 = v12 ** 2.0
    v14 = v10 * v13
    v15 = a + v11
    v16 = v15 ** 2.0
    v17 = v14 * v16
    v18 = a ** 2.0
    v19 = v18 ** 2.0
    v20 = 8.0 * v19
    v21 = v17 / v20
    v22 = v8 + v21
    v23 = a - x
    v24 = a + x
    v25 = v23 * v24
    v26 = xp.sqrt(v25)
    v27 = 3.141592653589793 * v26
    v28 = v22 / v27
    v29 = xp.where(v7, v28, 0.0)
    v30 = xp.where(v4, v29, xp.nan)
    return v30


def profile(xp, x, a, h):
    v0 = x <= a
    v1 = xp.where(v0, x, 0.5 * a)
    v2 = -h
    v3 = v1 ** 2.0
    v4 = v3 ** 2.0
    v5 = v2 * v4
    v6 = a ** 2.0
    v7 = v6 ** 2.0
    v8 = v5 / v7
    v9 = xp.where(v0, 2.0 * a, x)
    v10 = xp.where(v0, v8, xp.nan)
    return v10


def slope(xp, x, P, a, h, E_star):
    v0 = 9.42477796076938 * E_star
    v1 = v0 * h
    v2 = v1 / 8.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = x >= a
    v6 = xp.where(v5, x, 2.0 * a)
    v7 = P > 0.0
    v8 = (-2.0) * P
    v9 = 3.141592653589793 * E_star
    v10 = v6 - a
    v11 = a + v6
    v12 = v10 * v11
    v13 = xp.sqrt(v12)
    v14 = v9 * v13
    v15 = v8 / v14
    v16 = a ** 2.0
    v17 = h * v16
    v18 = v6 ** 2.0
    v19 = 8.0 * v18
    v20 = v16 + v19
    v21 = v17 * v20
    v22 = v13 ** 2.0
    v23 = v22 ** 2.0
    v24 = 8.0 * v23
    v25 = v6 * v18
    v26 = 8.0 * v25
    v27 = v26 * v13
    v28 = v24 + v27
    v29 = v16 ** 2.0
    v30 = 3.0 * v29
    v31 = v28 + v30
    v32 = 12.0 * v16
    v33 = v32 * v22
    v34 = v31 + v33
    v35 = 2.0 * v34
    v36 = v35 * v13
    v37 = v21 / v36
    v38 = v15 - v37
    v39 = xp.where(v7, v38, 0.0)
    v40 = xp.where(v5, 0.5 * a, x)
    v41 = (-4.0) * h
    v42 = v40 ** 2.0
    v43 = v40 * v42
    v44 = v41 * v43
    v45 = a ** 2.0
    v46 = v45 ** 2.0
    v47 = v44 / v46
    v48 = -v47
    v49 = xp.where(v5, v39, v48)
    v50 = xp.where(v4, v49, xp.nan)
    return v50


def zero_distance(xp, a):
    v0 = a / 2.0
    return v0
