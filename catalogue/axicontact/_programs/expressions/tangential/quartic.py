"""Formulas of axicontact.tangential.quartic over an array library `xp`."""


def full_slip_displacement(xp, a, A, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = 8.0 * A
    v3 = v2 / 3.0
    v4 = a ** 2.0
    v5 = v4 ** 2.0
    v6 = v3 * v5
    v7 = v1 * v6
    return v7


def stick_radius(xp, F_x, a, A, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = 64.0 * E_star
    v4 = v3 * A
    v5 = v4 / 15.0
    v6 = a ** 5.0
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
    v18 = 15.0 * v17
    v19 = v18 / v4
    v20 = v19 > 0.0
    v21 = v19 < xp.inf
    v22 = v20 & v21
    v23 = v19 ** 0.2
    v24 = v23 ** 5.0
    v25 = v23 ** 0.0
    v26 = v24 * v25
    v27 = v19 / v26
    v28 = v27 - 1.0
    v29 = v28 / 5.0
    v30 = v23 * v29
    v31 = v23 + v30
    v32 = xp.where(v22, v31, v23)
    v33 = xp.where(v2, a, v32)
    return v33


def tangential_displacement(xp, a, c, A, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = 8.0 * A
    v3 = v2 / 3.0
    v4 = a ** 2.0
    v5 = v4 ** 2.0
    v6 = v3 * v5
    v7 = v1 * v6
    v8 = a > c
    v9 = xp.where(v8, a, 2.0 * c)
    v10 = v9 - c
    v11 = v10 / c
    v12 = xp.log1p(v11)
    v13 = xp.where(v8, 0.5 * c, a)
    v14 = xp.where(v8, v12, 0.0)
    v15 = (-4.0) * v14
    v16 = xp.expm1(v15)
    v17 = -v16
    v18 = v7 * v17
    return v18


def tangential_force(xp, a, c, A, E_star, mu):
    v0 = 64.0 * E_star
    v1 = v0 * A
    v2 = v1 / 15.0
    v3 = a ** 5.0
    v4 = v2 * v3
    v5 = mu * v4
    v6 = a > c
    v7 = xp.where(v6, a, 2.0 * c)
    v8 = v7 - c
    v9 = v8 / c
    v10 = xp.log1p(v9)
    v11 = xp.where(v6, 0.5 * c, a)
    v12 = xp.where(v6, v10, 0.0)
    v13 = (-5.0) * v12
    v14 = xp.expm1(v13)
    v15 = -v14
    v16 = v5 * v15
    return v16


def traction(xp, r, a, c, A, E_star, mu):
    v0 = r < c
    v1 = xp.where(v0, r, 0.5 * c)
    v2 = E_star / 3.141592653589793
    v3 = 32.0 * A
    v4 = v3 / 3.0
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
    v25 = 2.0 * v1
    v26 = v25 * v1
    v27 = a * a
    v28 = v27 * 0.0
    v29 = v28 + 1.0
    v30 = a - v1
    v31 = xp.maximum(v30, 0.0)
    v32 = a + v1
    v33 = v31 * v32
    v34 = xp.sqrt(v33)
    v35 = c - v1
    v36 = xp.maximum(v35, 0.0)
    v37 = c + v1
    v38 = v36 * v37
    v39 = xp.sqrt(v38)
    v40 = v34 + v39
    v41 = v29 * v40
    v42 = v41 * v34
    v43 = v26 + v42
    v44 = c * c
    v45 = v43 + v44
    v46 = v45 / 3.0
    v47 = v24 * v46
    v48 = v5 * v47
    v49 = xp.where(v0, 2.0 * c, r)
    v50 = v49 < a
    v51 = xp.where(v50, v49, 0.5 * a)
    v52 = 32.0 * E_star
    v53 = v52 * A
    v54 = v53 / 28.274333882308138
    v55 = a ** 2.0
    v56 = v51 ** 2.0
    v57 = 2.0 * v56
    v58 = v55 + v57
    v59 = v54 * v58
    v60 = a - v51
    v61 = a + v51
    v62 = v60 * v61
    v63 = xp.sqrt(v62)
    v64 = v59 * v63
    v65 = xp.where(v50, 2.0 * a, v49)
    v66 = xp.where(v50, v64, 0.0)
    v67 = xp.where(v0, v48, v66)
    v68 = mu * v67
    return v68
