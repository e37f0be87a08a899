"""Formulas of axicontact.normal.sextic over an array library `xp`."""


def depth(xp, a, A):
    v0 = 16.0 * A
    v1 = v0 / 5.0
    v2 = a ** 6.0
    v3 = v1 * v2
    return v3


def depth_from_force(xp, F, A, E_star):
    v0 = F / E_star
    v1 = v0 > 0.0
    v2 = v0 < xp.inf
    v3 = v1 & v2
    v4 = v0 ** 0.14285714285714285
    v5 = v4 ** 7.0
    v6 = v4 ** 0.0
    v7 = v5 * v6
    v8 = v0 / v7
    v9 = v8 - 1.0
    v10 = v9 / 7.0
    v11 = v4 * v10
    v12 = v4 + v11
    v13 = xp.where(v3, v12, v4)
    v14 = v0 / v13
    v15 = xp.where(v3, v14, v0)
    v16 = 117649.0 * A
    v17 = v16 / 933120.0
    v18 = v17 > 0.0
    v19 = v17 < xp.inf
    v20 = v18 & v19
    v21 = v17 ** 0.14285714285714285
    v22 = v21 ** 7.0
    v23 = v21 ** 0.0
    v24 = v22 * v23
    v25 = v17 / v24
    v26 = v25 - 1.0
    v27 = v26 / 7.0
    v28 = v21 * v27
    v29 = v21 + v28
    v30 = xp.where(v20, v29, v21)
    v31 = v15 * v30
    return v31


def displacement(xp, r, a, A):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = 32.0 * A
    v3 = v2 / 15.707963267948966
    v4 = a ** 6.0
    v5 = v3 * v4
    v6 = a / v1
    v7 = v1 - a
    v8 = v1 + a
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v1 + v10
    v12 = a / v11
    v13 = v12 * v12
    v14 = (-1.2774361052403345) * v13
    v15 = v14 + (-23.178809850601194)
    v16 = v15 * v13
    v17 = v16 + (-181.92316258227586)
    v18 = v17 * v13
    v19 = v18 + (-611.3425551498234)
    v20 = v19 * v13
    v21 = v20 + (-362.00165963521414)
    v22 = v21 * v13
    v23 = v22 + 2098.825846649865
    v24 = v23 * v13
    v25 = v24 + 3992.6681072942106
    v26 = v25 * v13
    v27 = v26 + 2012.329045387071
    v28 = v27 * v13
    v29 = v28 + 0.44444444444468756
    v30 = 0.008653162919782199 * v13
    v31 = v30 + (-0.42336499735873506)
    v32 = v31 * v13
    v33 = v32 + 23.453299031698904
    v34 = v33 * v13
    v35 = v34 + 657.0260884407312
    v36 = v35 * v13
    v37 = v36 + 4128.7190564480725
    v38 = v37 * v13
    v39 = v38 + 10373.373159937977
    v40 = v39 * v13
    v41 = v40 + 11371.059137910102
    v42 = v41 * v13
    v43 = v42 + 4528.267624848188
    v44 = v43 * v13
    v45 = v44 + 1.0
    v46 = v29 / v45
    v47 = v13 * v46
    v48 = 0.8571428571428571 + v47
    v49 = v6 * v48
    v50 = v5 * v49
    v51 = xp.where(v0, 0.5 * a, r)
    v52 = 16.0 * A
    v53 = v52 / 5.0
    v54 = a ** 6.0
    v55 = v53 * v54
    v56 = v51 ** 6.0
    v57 = A * v56
    v58 = v55 - v57
    v59 = xp.where(v0, v50, v58)
    return v59


def force(xp, a, A, E_star):
    v0 = 192.0 * E_star
    v1 = v0 * A
    v2 = v1 / 35.0
    v3 = a ** 7.0
    v4 = v2 * v3
    return v4


def force_from_depth(xp, d, A, E_star):
    v0 = 6.0 * E_star
    v1 = v0 / 7.0
    v2 = v1 * d
    v3 = 20.0 * d
    v4 = v3 / A
    v5 = v4 > 0.0
    v6 = v4 < xp.inf
    v7 = v5 & v6
    v8 = v4 ** 0.16666666666666666
    v9 = v8 ** 6.0
    v10 = v8 ** 0.0
    v11 = v9 * v10
    v12 = v4 / v11
    v13 = v12 - 1.0
    v14 = v13 / 6.0
    v15 = v8 * v14
    v16 = v8 + v15
    v17 = xp.where(v7, v16, v8)
    v18 = v2 * v17
    return v18


def mean_pressure(xp, a, A, E_star):
    v0 = 192.0 * E_star
    v1 = v0 * A
    v2 = v1 / 109.95574287564276
    v3 = a ** 5.0
    v4 = v2 * v3
    return v4


def peak_pressure(xp, a, A, E_star):
    v0 = 151.42562584220406 * E_star
    v1 = v0 * A
    v2 = v1 / 78.53981633974483
    v3 = a ** 5.0
    v4 = v2 * v3
    v5 = v4 * 1.1260325006104943
    return v5


def peak_radius(xp, a):
    v0 = a * 1.6528916502810695
    v1 = v0 / 2.0
    return v1


def pressure(xp, r, a, A, E_star):
    v0 = r < a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = 32.0 * E_star
    v3 = v2 * A
    v4 = v3 / 78.53981633974483
    v5 = a ** 2.0
    v6 = v5 ** 2.0
    v7 = 3.0 * v6
    v8 = 4.0 * v5
    v9 = v1 ** 2.0
    v10 = v8 * v9
    v11 = v7 + v10
    v12 = v9 ** 2.0
    v13 = 8.0 * v12
    v14 = v11 + v13
    v15 = v4 * v14
    v16 = a - v1
    v17 = a + v1
    v18 = v16 * v17
    v19 = xp.sqrt(v18)
    v20 = v15 * v19
    v21 = xp.where(v0, 2.0 * a, r)
    v22 = xp.where(v0, v20, 0.0)
    return v22


def profile(xp, r, A):
    v0 = r ** 6.0
    v1 = A * v0
    return v1


def radius_from_depth(xp, d, A):
    v0 = 5.0 * d
    v1 = 16.0 * A
    v2 = v0 / v1
    v3 = v2 > 0.0
    v4 = v2 < xp.inf
    v5 = v3 & v4
    v6 = v2 ** 0.16666666666666666
    v7 = v6 ** 6.0
    v8 = v6 ** 0.0
    v9 = v7 * v8
    v10 = v2 / v9
    v11 = v10 - 1.0
    v12 = v11 / 6.0
    v13 = v6 * v12
    v14 = v6 + v13
    v15 = xp.where(v5, v14, v6)
    return v15


def radius_from_force(xp, F, A, E_star):
    v0 = 35.0 * F
    v1 = 192.0 * E_star
    v2 = v1 * A
    v3 = v0 / v2
    v4 = v3 > 0.0
    v5 = v3 < xp.inf
    v6 = v4 & v5
    v7 = v3 ** 0.14285714285714285
    v8 = v7 ** 7.0
    v9 = v7 ** 0.0
    v10 = v8 * v9
    v11 = v3 / v10
    v12 = v11 - 1.0
    v13 = v12 / 7.0
    v14 = v7 * v13
    v15 = v7 + v14
    v16 = xp.where(v6, v15, v7)
    return v16


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
