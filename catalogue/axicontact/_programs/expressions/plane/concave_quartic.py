"""Formulas of axicontact.plane.concave_quartic over an array library `xp`."""


def depth(xp, L, P, a, h, E_star):
    v0 = 9.42477796076938 * E_star
    v1 = v0 * h
    v2 = v1 / 8.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= P
    v5 = xp.where(v4, v3, 0.5 * P)
    v6 = a <= L
    v7 = xp.where(v6, a, 0.5 * L)
    v8 = 2.0 * P
    v9 = L - v7
    v10 = v7 + L
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = v9 + v12
    v14 = v13 / v7
    v15 = xp.log1p(v14)
    v16 = v8 * v15
    v17 = 3.141592653589793 * E_star
    v18 = v16 / v17
    v19 = h * L
    v20 = v7 ** 2.0
    v21 = L ** 2.0
    v22 = 3.0 * v21
    v23 = v20 + v22
    v24 = v19 * v23
    v25 = v20 * v12
    v26 = L * v21
    v27 = 2.0 * v26
    v28 = v25 + v27
    v29 = 2.0 * v21
    v30 = v29 * v12
    v31 = v28 + v30
    v32 = 2.0 * v31
    v33 = v24 / v32
    v34 = v18 - v33
    v35 = xp.where(v6, 2.0 * L, a)
    v36 = xp.where(v6, v34, xp.nan)
    v37 = xp.where(v4, 2.0 * P, v3)
    v38 = xp.where(v4, v36, xp.nan)
    return v38


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
    v5 = xp.where(v4, v3, 0.5 * P)
    v6 = x <= a
    v7 = P > 0.0
    v8 = v6 & v7
    v9 = P - v2
    v10 = 3.141592653589793 * E_star
    v11 = v10 * h
    v12 = 2.0 * x
    v13 = v12 - a
    v14 = v13 ** 2.0
    v15 = v11 * v14
    v16 = a + v12
    v17 = v16 ** 2.0
    v18 = v15 * v17
    v19 = a ** 2.0
    v20 = v19 ** 2.0
    v21 = 8.0 * v20
    v22 = v18 / v21
    v23 = v9 + v22
    v24 = a - x
    v25 = a + x
    v26 = v24 * v25
    v27 = xp.sqrt(v26)
    v28 = 3.141592653589793 * v27
    v29 = v23 / v28
    v30 = xp.where(v8, v29, 0.0)
    v31 = xp.where(v4, 2.0 * P, v3)
    v32 = xp.where(v4, v30, xp.nan)
    return v32


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
    v5 = xp.where(v4, v3, 0.5 * P)
    v6 = x >= a
    v7 = xp.where(v6, x, 2.0 * a)
    v8 = P > 0.0
    v9 = (-2.0) * P
    v10 = 3.141592653589793 * E_star
    v11 = v7 - a
    v12 = a + v7
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = v10 * v14
    v16 = v9 / v15
    v17 = a ** 2.0
    v18 = h * v17
    v19 = v7 ** 2.0
    v20 = 8.0 * v19
    v21 = v17 + v20
    v22 = v18 * v21
    v23 = v14 ** 2.0
    v24 = v23 ** 2.0
    v25 = 8.0 * v24
    v26 = v7 * v19
    v27 = 8.0 * v26
    v28 = v27 * v14
    v29 = v25 + v28
    v30 = v17 ** 2.0
    v31 = 3.0 * v30
    v32 = v29 + v31
    v33 = 12.0 * v17
    v34 = v33 * v23
    v35 = v32 + v34
    v36 = 2.0 * v35
    v37 = v36 * v14
    v38 = v22 / v37
    v39 = v16 - v38
    v40 = xp.where(v8, v39, 0.0)
    v41 = xp.where(v6, 0.5 * a, x)
    v42 = (-4.0) * h
    v43 = v41 ** 2.0
    v44 = v41 * v43
    v45 = v42 * v44
    v46 = a ** 2.0
    v47 = v46 ** 2.0
    v48 = v45 / v47
    v49 = -v48
    v50 = xp.where(v6, v40, v49)
    v51 = xp.where(v4, 2.0 * P, v3)
    v52 = xp.where(v4, v50, xp.nan)
    return v52


def zero_distance(xp, a):
    v0 = a / 2.0
    return v0
