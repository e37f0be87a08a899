"""Formulas of axicontact.normal.ellipsoid over an array library `xp`."""


def depth(xp, a, h, b):
    v0 = h / b
    v1 = v0 * a
    v2 = 2.0 * a
    v3 = b - a
    v4 = v2 / v3
    v5 = xp.log1p(v4)
    v6 = v5 / 2.0
    v7 = v1 * v6
    return v7


def force(xp, a, h, b, E_star):
    v0 = E_star * h
    v1 = a ** 2.0
    v2 = 2.0 * a
    v3 = b - a
    v4 = v2 / v3
    v5 = xp.log1p(v4)
    v6 = v5 / 2.0
    v7 = v1 * v6
    v8 = v7 / b
    v9 = v6 < 1.0
    v10 = a / b
    v11 = v10 * v10
    v12 = v10 * v11
    v13 = xp.minimum(v6, 1.0)
    v14 = v13 * v13
    v15 = 1.0716932453474512e-06 * v14
    v16 = v15 + 0.00019982814521087247
    v17 = v16 * v14
    v18 = v17 + 0.007076196047699156
    v19 = v18 * v14
    v20 = v19 + 0.08608622548411103
    v21 = v20 * v14
    v22 = v21 + 0.3073858328214721
    v23 = v22 * v14
    v24 = v23 + 0.3333333333333333
    v25 = 2.565078604208634e-08 * v14
    v26 = v25 + 2.0203143566039827e-05
    v27 = v26 * v14
    v28 = v27 + 0.001617010334189783
    v29 = v28 * v14
    v30 = v29 + 0.03639274880225476
    v31 = v30 * v14
    v32 = v31 + 0.32215749846441627
    v33 = v32 * v14
    v34 = v33 + 1.0
    v35 = v24 / v34
    v36 = v12 * v35
    v37 = v6 - v10
    v38 = xp.where(v9, v36, v37)
    v39 = b * v38
    v40 = v8 + v39
    v41 = v0 * v40
    return v41


def mean_pressure(xp, a, h, b, E_star):
    v0 = a > 0.0
    v1 = E_star * h
    v2 = a ** 2.0
    v3 = 2.0 * a
    v4 = b - a
    v5 = v3 / v4
    v6 = xp.log1p(v5)
    v7 = v6 / 2.0
    v8 = v2 * v7
    v9 = v8 / b
    v10 = v7 < 1.0
    v11 = a / b
    v12 = v11 * v11
    v13 = v11 * v12
    v14 = xp.minimum(v7, 1.0)
    v15 = v14 * v14
    v16 = 1.0716932453474512e-06 * v15
    v17 = v16 + 0.00019982814521087247
    v18 = v17 * v15
    v19 = v18 + 0.007076196047699156
    v20 = v19 * v15
    v21 = v20 + 0.08608622548411103
    v22 = v21 * v15
    v23 = v22 + 0.3073858328214721
    v24 = v23 * v15
    v25 = v24 + 0.3333333333333333
    v26 = 2.565078604208634e-08 * v15
    v27 = v26 + 2.0203143566039827e-05
    v28 = v27 * v15
    v29 = v28 + 0.001617010334189783
    v30 = v29 * v15
    v31 = v30 + 0.03639274880225476
    v32 = v31 * v15
    v33 = v32 + 0.32215749846441627
    v34 = v33 * v15
    v35 = v34 + 1.0
    v36 = v25 / v35
    v37 = v13 * v36
    v38 = v7 - v11
    v39 = xp.where(v10, v37, v38)
    v40 = b * v39
    v41 = v9 + v40
    v42 = v1 * v41
    v43 = 3.141592653589793 * v2
    v44 = v42 / v43
    v45 = xp.where(v0, v44, 0.0)
    return v45


def profile(xp, r, h, b):
    v0 = r ** 2.0
    v1 = h * v0
    v2 = b ** 2.0
    v3 = r / b
    v4 = 1.0 - v3
    v5 = v3 + 1.0
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v7 + 1.0
    v9 = v2 * v8
    v10 = v1 / v9
    return v10


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
