"""Formulas of axicontact.normal.sphere over an array library `xp`."""


def depth(xp, a, R):
    v0 = 2.0 * a
    v1 = R - a
    v2 = v0 / v1
    v3 = xp.log1p(v2)
    v4 = v3 / 2.0
    v5 = a * v4
    return v5


def force(xp, a, R, E_star):
    v0 = a ** 2.0
    v1 = 2.0 * a
    v2 = R - a
    v3 = v1 / v2
    v4 = xp.log1p(v3)
    v5 = v4 / 2.0
    v6 = v0 * v5
    v7 = R ** 2.0
    v8 = v5 < 1.0
    v9 = a / R
    v10 = v9 * v9
    v11 = v9 * v10
    v12 = xp.minimum(v5, 1.0)
    v13 = v12 * v12
    v14 = 1.0716932453474512e-06 * v13
    v15 = v14 + 0.00019982814521087247
    v16 = v15 * v13
    v17 = v16 + 0.007076196047699156
    v18 = v17 * v13
    v19 = v18 + 0.08608622548411103
    v20 = v19 * v13
    v21 = v20 + 0.3073858328214721
    v22 = v21 * v13
    v23 = v22 + 0.3333333333333333
    v24 = 2.565078604208634e-08 * v13
    v25 = v24 + 2.0203143566039827e-05
    v26 = v25 * v13
    v27 = v26 + 0.001617010334189783
    v28 = v27 * v13
    v29 = v28 + 0.03639274880225476
    v30 = v29 * v13
    v31 = v30 + 0.32215749846441627
    v32 = v31 * v13
    v33 = v32 + 1.0
    v34 = v23 / v33
    v35 = v11 * v34
    v36 = v5 - v9
    v37 = xp.where(v8, v35, v36)
    v38 = v7 * v37
    v39 = v6 + v38
    v40 = E_star * v39
    return v40


def mean_pressure(xp, a, R, E_star):
    v0 = a > 0.0
    v1 = a ** 2.0
    v2 = 2.0 * a
    v3 = R - a
    v4 = v2 / v3
    v5 = xp.log1p(v4)
    v6 = v5 / 2.0
    v7 = v1 * v6
    v8 = R ** 2.0
    v9 = v6 < 1.0
    v10 = a / R
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
    v39 = v8 * v38
    v40 = v7 + v39
    v41 = E_star * v40
    v42 = 3.141592653589793 * v1
    v43 = v41 / v42
    v44 = xp.where(v0, v43, 0.0)
    return v44


def profile(xp, r, R):
    v0 = r ** 2.0
    v1 = R - r
    v2 = r + R
    v3 = v1 * v2
    v4 = xp.sqrt(v3)
    v5 = v4 + R
    v6 = v0 / v5
    return v6


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
