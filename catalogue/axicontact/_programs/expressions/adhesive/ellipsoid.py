"""Formulas of axicontact.adhesive.ellipsoid over an array library `xp`."""


def depth(xp, a, h, b, E_star, dgamma):
    v0 = h / b
    v1 = v0 * a
    v2 = 2.0 * a
    v3 = b - a
    v4 = v2 / v3
    v5 = xp.log1p(v4)
    v6 = v5 / 2.0
    v7 = v1 * v6
    v8 = xp.sqrt(a)
    v9 = 6.283185307179586 * dgamma
    v10 = v9 / E_star
    v11 = xp.sqrt(v10)
    v12 = v8 * v11
    v13 = v7 - v12
    return v13


def force(xp, a, h, b, E_star, dgamma):
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
    v42 = 2.0 * E_star
    v43 = v42 * a
    v44 = xp.sqrt(a)
    v45 = 6.283185307179586 * dgamma
    v46 = v45 / E_star
    v47 = xp.sqrt(v46)
    v48 = v44 * v47
    v49 = v43 * v48
    v50 = v41 - v49
    return v50
