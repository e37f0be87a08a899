"""Formulas of axicontact.tangential.sextic over an array library `xp`."""


def full_slip_displacement(xp, a, A, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = 16.0 * A
    v3 = v2 / 5.0
    v4 = a ** 6.0
    v5 = v3 * v4
    v6 = v1 * v5
    return v6


def stick_radius(xp, F_x, a, A, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = 192.0 * E_star
    v4 = v3 * A
    v5 = v4 / 35.0
    v6 = a ** 7.0
    v7 = v5 * v6
    v8 = F_x / mu
    v9 = v7 - v8
    v10 = xp.absolute(v9)
    v11 = 2e-16 * v7
    v12 = v10 <= v11
    v13 = xp.where(v12, v10, 0.5 * v11)
    v14 = xp.where(v12, 2.0 * v11, v10)
    v15 = xp.where(v12, 0.0, v9)
    v16 = v15 >= 0.0
    v17 = xp.where(v16, v15, xp.nan)
    v18 = 35.0 * v17
    v19 = v18 / v4
    v20 = v19 > 0.0
    v21 = v19 < xp.inf
    v22 = v20 & v21
    v23 = v19 ** 0.14285714285714285
    v24 = v23 ** 7.0
    v25 = v23 ** 0.0
    v26 = v24 * v25
    v27 = v19 / v26
    v28 = v27 - 1.0
    v29 = v28 / 7.0
    v30 = v23 * v29
    v31 = v23 + v30
    v32 = xp.where(v22, v31, v23)
    v33 = xp.where(v2, a, v32)
    return v33


def tangential_displacement(xp, a, c, A, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = 16.0 * A
    v3 = v2 / 5.0
    v4 = a ** 6.0
    v5 = v3 * v4
    v6 = v1 * v5
    v7 = a > c
    v8 = xp.where(v7, a, 2.0 * c)
    v9 = v8 - c
    v10 = v9 / c
    v11 = xp.log1p(v10)
    v12 = xp.where(v7, 0.5 * c, a)
    v13 = xp.where(v7, v11, 0.0)
    v14 = (-6.0) * v13
    v15 = xp.expm1(v14)
    v16 = -v15
    v17 = v6 * v16
    return v17


def tangential_force(xp, a, c, A, E_star, mu):
    v0 = 192.0 * E_star
    v1 = v0 * A
    v2 = v1 / 35.0
    v3 = a ** 7.0
    v4 = v2 * v3
    v5 = mu * v4
    v6 = a > c
    v7 = xp.where(v6, a, 2.0 * c)
    v8 = v7 - c
    v9 = v8 / c
    v10 = xp.log1p(v9)
    v11 = xp.where(v6, 0.5 * c, a)
    v12 = xp.where(v6, v10, 0.0)
    v13 = (-7.0) * v12
    v14 = xp.expm1(v13)
    v15 = -v14
    v16 = v5 * v15
    return v16


def traction(xp, r, a, c, A, E_star, mu):
    v0 = r < c
    v1 = xp.where(v0, r, 0.5 * c)
    v2 = E_star / 3.141592653589793
    v3 = 96.0 * A
    v4 = v3 / 5.0
    v5 = v2 * v4
    v6 = a > c
    v7 = xp.where(v6, a, 2.0 * c)
    v8 = v7 - c
    v9 = v7 + c
    v10 = v8 * v9
    v11 = v7 - v1
    v12 = xp.maximum(v11, 0.0)
    v13 = v7 + v1
    v14 = v12 * v13
    v15 = xp.sqrt(v14)
    v16 = c - v1
    v17 = xp.maximum(v16, 0.0)
    v18 = c + v1
    v19 = v17 * v18
    v20 = xp.sqrt(v19)
    v21 = v15 + v20
    v22 = v10 / v21
    v23 = xp.where(v6, 0.5 * c, a)
    v24 = xp.where(v6, v22, 0.0)
    v25 = 4.0 * v1
    v26 = v25 * v1
    v27 = 2.0 * v1
    v28 = v27 * v1
    v29 = a * a
    v30 = v29 * 0.0
    v31 = v30 + 1.0
    v32 = a - v1
    v33 = xp.maximum(v32, 0.0)
    v34 = a + v1
    v35 = v33 * v34
    v36 = xp.sqrt(v35)
    v37 = c - v1
    v38 = xp.maximum(v37, 0.0)
    v39 = c + v1
    v40 = v38 * v39
    v41 = xp.sqrt(v40)
    v42 = v36 + v41
    v43 = v31 * v42
    v44 = v43 * v36
    v45 = v28 + v44
    v46 = c * c
    v47 = v45 + v46
    v48 = v47 / 3.0
    v49 = v26 * v48
    v50 = v29 * v31
    v51 = v50 + v46
    v52 = v51 * v42
    v53 = v52 * v36
    v54 = v49 + v53
    v55 = v46 * v46
    v56 = v54 + v55
    v57 = v56 / 5.0
    v58 = v24 * v57
    v59 = v5 * v58
    v60 = xp.where(v0, 2.0 * c, r)
    v61 = v60 < a
    v62 = xp.where(v61, v60, 0.5 * a)
    v63 = 32.0 * E_star
    v64 = v63 * A
    v65 = v64 / 78.53981633974483
    v66 = a ** 2.0
    v67 = v66 ** 2.0
    v68 = 3.0 * v67
    v69 = 4.0 * v66
    v70 = v62 ** 2.0
    v71 = v69 * v70
    v72 = v68 + v71
    v73 = v70 ** 2.0
    v74 = 8.0 * v73
    v75 = v72 + v74
    v76 = v65 * v75
    v77 = a - v62
    v78 = a + v62
    v79 = v77 * v78
    v80 = xp.sqrt(v79)
    v81 = v76 * v80
    v82 = xp.where(v61, 2.0 * a, v60)
    v83 = xp.where(v61, v81, 0.0)
    v84 = xp.where(v0, v59, v83)
    v85 = mu * v84
    return v85
