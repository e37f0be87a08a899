"""Formulas of axicontact.normal.quartic over an array library `xp`."""


def depth(xp, a, A):
    v0 = 8.0 * A
    v1 = v0 / 3.0
    v2 = a ** 2.0
    v3 = v2 ** 2.0
    v4 = v1 * v3
    return v4


def depth_from_force(xp, F, A, E_star):
    v0 = F / E_star
    v1 = v0 > 0.0
    v2 = v0 < xp.inf
    v3 = v1 & v2
    v4 = v0 ** 0.2
    v5 = v4 ** 5.0
    v6 = v4 ** 0.0
    v7 = v5 * v6
    v8 = v0 / v7
    v9 = v8 - 1.0
    v10 = v9 / 5.0
    v11 = v4 * v10
    v12 = v4 + v11
    v13 = xp.where(v3, v12, v4)
    v14 = v0 / v13
    v15 = xp.where(v3, v14, v0)
    v16 = 625.0 * A
    v17 = v16 / 1536.0
    v18 = v17 > 0.0
    v19 = v17 < xp.inf
    v20 = v18 & v19
    v21 = v17 ** 0.2
    v22 = v21 ** 5.0
    v23 = v21 ** 0.0
    v24 = v22 * v23
    v25 = v17 / v24
    v26 = v25 - 1.0
    v27 = v26 / 5.0
    v28 = v21 * v27
    v29 = v21 + v28
    v30 = xp.where(v20, v29, v21)
    v31 = v15 * v30
    return v31


def displacement(xp, r, a, A):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = 16.0 * A
    v3 = v2 / 9.42477796076938
    v4 = a ** 2.0
    v5 = v4 ** 2.0
    v6 = v3 * v5
    v7 = a / v1
    v8 = v1 - a
    v9 = v1 + a
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v1 + v11
    v13 = a / v12
    v14 = v13 * v13
    v15 = (-4.320959889429597) * v14
    v16 = v15 + (-106.53004831006083)
    v17 = v16 * v14
    v18 = v17 + (-683.6776777243583)
    v19 = v18 * v14
    v20 = v19 + (-1307.862063615897)
    v21 = v20 * v14
    v22 = v21 + 1123.6903304493044
    v23 = v22 * v14
    v24 = v23 + 6598.931700123421
    v25 = v24 * v14
    v26 = v25 + 7450.127483097781
    v27 = v26 * v14
    v28 = v27 + 2696.481329529376
    v29 = v28 * v14
    v30 = v29 + 0.3809523809520408
    v31 = (-0.06548708381580395) * v14
    v32 = v31 + 10.743349921788495
    v33 = v32 * v14
    v34 = v33 + 655.5477291446655
    v35 = v34 * v14
    v36 = v35 + 5580.132341984832
    v37 = v36 * v14
    v38 = v37 + 18919.75045798054
    v39 = v38 * v14
    v40 = v39 + 30703.596314182465
    v41 = v40 * v14
    v42 = v41 + 23803.775464413437
    v43 = v42 * v14
    v44 = v43 + 7078.863490014608
    v45 = v44 * v14
    v46 = v45 + 1.0
    v47 = v30 / v46
    v48 = v14 * v47
    v49 = 0.8 + v48
    v50 = v7 * v49
    v51 = v6 * v50
    v52 = xp.where(v0, 0.5 * a, r)
    v53 = 8.0 * A
    v54 = v53 / 3.0
    v55 = a ** 2.0
    v56 = v55 ** 2.0
    v57 = v54 * v56
    v58 = v52 ** 2.0
    v59 = v58 ** 2.0
    v60 = A * v59
    v61 = v57 - v60
    v62 = xp.where(v0, v51, v61)
    return v62


def force(xp, a, A, E_star):
    v0 = 64.0 * E_star
    v1 = v0 * A
    v2 = v1 / 15.0
    v3 = a ** 5.0
    v4 = v2 * v3
    return v4


def force_from_depth(xp, d, A, E_star):
    v0 = 4.0 * E_star
    v1 = v0 / 5.0
    v2 = v1 * d
    v3 = 6.0 * d
    v4 = v3 / A
    v5 = xp.sqrt(v4)
    v6 = xp.sqrt(v5)
    v7 = v2 * v6
    return v7


def mean_pressure(xp, a, A, E_star):
    v0 = 64.0 * E_star
    v1 = v0 * A
    v2 = v1 / 47.12388980384689
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    return v5


def peak_pressure(xp, a, A, E_star):
    v0 = 32.0 * E_star
    v1 = v0 * A
    v2 = v1 / 28.274333882308138
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    v6 = v5 * 1.4142135623730951
    return v6


def peak_radius(xp, a):
    v0 = a * 1.4142135623730951
    v1 = v0 / 2.0
    return v1


def pressure(xp, r, a, A, E_star):
    v0 = r < a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = 32.0 * E_star
    v3 = v2 * A
    v4 = v3 / 28.274333882308138
    v5 = a ** 2.0
    v6 = v1 ** 2.0
    v7 = 2.0 * v6
    v8 = v5 + v7
    v9 = v4 * v8
    v10 = a - v1
    v11 = a + v1
    v12 = v10 * v11
    v13 = xp.sqrt(v12)
    v14 = v9 * v13
    v15 = xp.where(v0, 2.0 * a, r)
    v16 = xp.where(v0, v14, 0.0)
    return v16


def profile(xp, r, A):
    v0 = r ** 2.0
    v1 = v0 ** 2.0
    v2 = A * v1
    return v2


def radius_from_depth(xp, d, A):
    v0 = 3.0 * d
    v1 = 8.0 * A
    v2 = v0 / v1
    v3 = xp.sqrt(v2)
    v4 = xp.sqrt(v3)
    return v4


def radius_from_force(xp, F, A, E_star):
    v0 = 15.0 * F
    v1 = 64.0 * E_star
    v2 = v1 * A
    v3 = v0 / v2
    v4 = v3 > 0.0
    v5 = v3 < xp.inf
    v6 = v4 & v5
    v7 = v3 ** 0.2
    v8 = v7 ** 5.0
    v9 = v7 ** 0.0
    v10 = v8 * v9
    v11 = v3 / v10
    v12 = v11 - 1.0
    v13 = v12 / 5.0
    v14 = v7 * v13
    v15 = v7 + v14
    v16 = xp.where(v6, v15, v7)
    return v16


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
