"""Formulas of axicontact.normal.concave_paraboloid over an array library `xp`."""

from ...._runtime.integrals import nodes_along


def depth_from_force(xp, F, a, h, E_star):
    v0 = 16.0 * E_star
    v1 = v0 * h
    v2 = v1 / 3.0
    v3 = v2 * a
    v4 = v3 * 0.999999999999999
    v5 = v4 <= F
    v6 = xp.where(v5, v4, 0.5 * F)
    v7 = 2.0 * E_star
    v8 = v7 * a
    v9 = F / v8
    v10 = 2.0 * h
    v11 = v10 / 3.0
    v12 = v9 - v11
    v13 = xp.where(v5, 2.0 * F, v4)
    v14 = xp.where(v5, v12, xp.nan)
    return v14


def displacement(xp, r, d, a, h):
    nodes, weights = nodes_along(xp, 64, r, d, a, h)
    v1 = 2.0 * h
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r > a
    v6 = xp.where(v5, r, 2.0 * a)
    v7 = v6 - a
    v8 = v6 + a
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = xp.arctan2(a, v10)
    v12 = d * v11
    v13 = a / v6
    v14 = v7 / a
    v15 = xp.isfinite(v14)
    v16 = xp.log1p(v14)
    v17 = xp.log(v6)
    v18 = xp.log(a)
    v19 = v17 - v18
    v20 = xp.where(v15, v16, v19)
    v21 = xp.sqrt(v20)
    v22 = v21 * v21
    v23 = v22 + 14.0
    v24 = xp.sqrt(v23)
    v25 = v24 + v21
    v26 = 14.0 / v25
    v27 = nodes * v26
    v28 = (-3.0) * v27
    v29 = 2.0 * v21
    v30 = v29 + v27
    v31 = v28 * v30
    v32 = xp.exp(v31)
    v33 = v21 + v27
    v34 = 2.0 * v33
    v35 = (-2.0) * v33
    v36 = v35 * v33
    v37 = xp.expm1(v36)
    v38 = -v37
    v39 = xp.sqrt(v38)
    v40 = v34 / v39
    v41 = v32 * v40
    v42 = v26 * xp.sum(weights * v41, axis=0)
    v43 = v13 * v42
    v44 = v1 * v43
    v45 = v12 + v44
    v46 = 0.6366197723675814 * v45
    v47 = xp.where(v5, 0.5 * a, r)
    v48 = v47 <= a
    v49 = xp.where(v48, v47, 0.5 * a)
    v50 = -h
    v51 = v49 ** 2.0
    v52 = v50 * v51
    v53 = a ** 2.0
    v54 = v52 / v53
    v55 = xp.where(v48, 2.0 * a, v47)
    v56 = xp.where(v48, v54, xp.nan)
    v57 = d - v56
    v58 = xp.where(v5, v46, v57)
    v59 = xp.where(v3, 2.0 * d, v2)
    v60 = xp.where(v3, v58, xp.nan)
    return v60


def force(xp, d, a, h, E_star):
    v0 = 2.0 * h
    v1 = v0 * 0.999999999999999
    v2 = v1 <= d
    v3 = xp.where(v2, v1, 0.5 * d)
    v4 = 2.0 * E_star
    v5 = v4 * a
    v6 = v0 / 3.0
    v7 = d + v6
    v8 = v5 * v7
    v9 = xp.where(v2, 2.0 * d, v1)
    v10 = xp.where(v2, v8, xp.nan)
    return v10


def minimum_depth(xp, h):
    v0 = 2.0 * h
    return v0


def minimum_force(xp, a, h, E_star):
    v0 = 16.0 * E_star
    v1 = v0 * h
    v2 = v1 / 3.0
    v3 = v2 * a
    return v3


def pressure(xp, r, d, a, h, E_star):
    v0 = 2.0 * h
    v1 = v0 * 0.999999999999999
    v2 = v1 <= d
    v3 = xp.where(v2, v1, 0.5 * d)
    v4 = r <= a
    v5 = d > 0.0
    v6 = v4 & v5
    v7 = E_star / 3.141592653589793
    v8 = d - v0
    v9 = 4.0 * h
    v10 = r ** 2.0
    v11 = v9 * v10
    v12 = a ** 2.0
    v13 = v11 / v12
    v14 = v8 + v13
    v15 = v7 * v14
    v16 = a - r
    v17 = a + r
    v18 = v16 * v17
    v19 = xp.sqrt(v18)
    v20 = v15 / v19
    v21 = xp.where(v6, v20, 0.0)
    v22 = xp.where(v2, 2.0 * d, v1)
    v23 = xp.where(v2, v21, xp.nan)
    return v23


def profile(xp, r, a, h):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = -h
    v3 = v1 ** 2.0
    v4 = v2 * v3
    v5 = a ** 2.0
    v6 = v4 / v5
    v7 = xp.where(v0, 2.0 * a, r)
    v8 = xp.where(v0, v6, xp.nan)
    return v8


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1


def zero_radius(xp, ):
    return 0.0
