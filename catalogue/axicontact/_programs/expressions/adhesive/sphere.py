"""Formulas of axicontact.adhesive.sphere over an array library `xp`."""


def depth(xp, a, R, E_star, dgamma):
    v0 = 2.0 * a
    v1 = R - a
    v2 = v0 / v1
    v3 = xp.log1p(v2)
    v4 = v3 / 2.0
    v5 = a * v4
    v6 = xp.sqrt(a)
    v7 = 6.283185307179586 * dgamma
    v8 = v7 / E_star
    v9 = xp.sqrt(v8)
    v10 = v6 * v9
    v11 = v5 - v10
    return v11


def force(xp, a, R, E_star, dgamma):
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
    v41 = 2.0 * E_star
    v42 = v41 * a
    v43 = xp.sqrt(a)
    v44 = 6.283185307179586 * dgamma
    v45 = v44 / E_star
    v46 = xp.sqrt(v45)
    v47 = v43 * v46
    v48 = v42 * v47
    v49 = v40 - v48
    return v49
