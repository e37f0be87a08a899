"""Formulas of axicontact.normal.concave_quartic over an array library `xp`."""

from ...._runtime.integrals import nodes_along


def depth_from_force(xp, F, a, h, E_star):
    v0 = 56.0 * E_star
    v1 = v0 * h
    v2 = v1 / 15.0
    v3 = v2 * a
    v4 = v3 * 0.999999999999999
    v5 = v4 <= F
    v6 = xp.where(v5, v4, 0.5 * F)
    v7 = 2.0 * E_star
    v8 = v7 * a
    v9 = F / v8
    v10 = 8.0 * h
    v11 = v10 / 15.0
    v12 = v9 - v11
    v13 = xp.where(v5, 2.0 * F, v4)
    v14 = xp.where(v5, v12, xp.nan)
    return v14


def displacement(xp, r, d, a, h):
    nodes, weights = nodes_along(xp, 64, r, d, a, h)
    v1 = 4.0 * h
    v2 = v1 / 3.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v6 = r > a
    v7 = xp.where(v6, r, 2.0 * a)
    v8 = v7 - a
    v9 = v7 + a
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = xp.arctan2(a, v11)
    v13 = d * v12
    v14 = 8.0 * h
    v15 = v14 / 3.0
    v16 = a / v7
    v17 = v8 / a
    v18 = xp.isfinite(v17)
    v19 = xp.log1p(v17)
    v20 = xp.log(v7)
    v21 = xp.log(a)
    v22 = v20 - v21
    v23 = xp.where(v18, v19, v22)
    v24 = xp.sqrt(v23)
    v25 = v24 * v24
    v26 = v25 + 8.4
    v27 = xp.sqrt(v26)
    v28 = v27 + v24
    v29 = 8.4 / v28
    v30 = nodes * v29
    v31 = (-5.0) * v30
    v32 = 2.0 * v24
    v33 = v32 + v30
    v34 = v31 * v33
    v35 = xp.exp(v34)
    v36 = v24 + v30
    v37 = 2.0 * v36
    v38 = (-2.0) * v36
    v39 = v38 * v36
    v40 = xp.expm1(v39)
    v41 = -v40
    v42 = xp.sqrt(v41)
    v43 = v37 / v42
    v44 = v35 * v43
    v45 = v29 * xp.sum(weights * v44, axis=0)
    v46 = v16 * v45
    v47 = v15 * v46
    v48 = v13 + v47
    v49 = 0.6366197723675814 * v48
    v50 = xp.where(v6, 0.5 * a, r)
    v51 = v50 <= a
    v52 = xp.where(v51, v50, 0.5 * a)
    v53 = -h
    v54 = v52 ** 2.0
    v55 = v54 ** 2.0
    v56 = v53 * v55
    v57 = a ** 2.0
    v58 = v57 ** 2.0
    v59 = v56 / v58
    v60 = xp.where(v51, 2.0 * a, v50)
    v61 = xp.where(v51, v59, xp.nan)
    v62 = d - v61
    v63 = xp.where(v6, v49, v62)
    v64 = xp.where(v4, 2.0 * d, v3)
    v65 = xp.where(v4, v63, xp.nan)
    return v65


def force(xp, d, a, h, E_star):
    v0 = 4.0 * h
    v1 = v0 / 3.0
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = 2.0 * E_star
    v6 = v5 * a
    v7 = 8.0 * h
    v8 = v7 / 15.0
    v9 = d + v8
    v10 = v6 * v9
    v11 = xp.where(v3, 2.0 * d, v2)
    v12 = xp.where(v3, v10, xp.nan)
    return v12


def minimum_depth(xp, h):
    v0 = 4.0 * h
    v1 = v0 / 3.0
    return v1


def minimum_force(xp, a, h, E_star):
    v0 = 56.0 * E_star
    v1 = v0 * h
    v2 = v1 / 15.0
    v3 = v2 * a
    return v3


def pressure(xp, r, d, a, h, E_star):
    v0 = 4.0 * h
    v1 = v0 / 3.0
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r <= a
    v6 = d > 0.0
    v7 = v5 & v6
    v8 = E_star / 3.141592653589793
    v9 = d - v1
    v10 = 2.0 * r
    v11 = v10 - a
    v12 = v11 ** 2.0
    v13 = v0 * v12
    v14 = a + v10
    v15 = v14 ** 2.0
    v16 = v13 * v15
    v17 = a ** 2.0
    v18 = v17 ** 2.0
    v19 = 9.0 * v18
    v20 = v16 / v19
    v21 = v9 + v20
    v22 = v8 * v21
    v23 = a - r
    v24 = a + r
    v25 = v23 * v24
    v26 = xp.sqrt(v25)
    v27 = v22 / v26
    v28 = xp.where(v7, v27, 0.0)
    v29 = xp.where(v3, 2.0 * d, v2)
    v30 = xp.where(v3, v28, xp.nan)
    return v30


def profile(xp, r, a, h):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = -h
    v3 = v1 ** 2.0
    v4 = v3 ** 2.0
    v5 = v2 * v4
    v6 = a ** 2.0
    v7 = v6 ** 2.0
    v8 = v5 / v7
    v9 = xp.where(v0, 2.0 * a, r)
    v10 = xp.where(v0, v8, xp.nan)
    return v10


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1


def zero_radius(xp, a):
    v0 = a / 2.0
    return v0
