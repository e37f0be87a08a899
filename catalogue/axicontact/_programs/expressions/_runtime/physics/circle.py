"""Formulas of axicontact._runtime.physics.circle over an array library `xp`."""


def elliptic(xp, kc, b):
    v1 = xp.maximum(kc, 1e-09)
    v3 = 2.0 * (b + v1)
    v4 = 1.0 + b
    v6 = 2.0 * xp.sqrt(v1)
    v9 = 2.0 * (v3 + v4 * v6)
    v10 = 1.0 + v1
    v12 = v4 + v3 / v10
    v15 = 2.0 * xp.sqrt(v6 * v10)
    v18 = 2.0 * (v9 + v12 * v15)
    v19 = v6 + v10
    v21 = v12 + v9 / v19
    v24 = 2.0 * xp.sqrt(v15 * v19)
    v27 = 2.0 * (v18 + v21 * v24)
    v28 = v15 + v19
    v30 = v21 + v18 / v28
    v33 = 2.0 * xp.sqrt(v24 * v28)
    v36 = 2.0 * (v27 + v30 * v33)
    v37 = v24 + v28
    v39 = v30 + v27 / v37
    v42 = 2.0 * xp.sqrt(v33 * v37)
    v45 = 2.0 * (v36 + v39 * v42)
    v46 = v33 + v37
    v48 = v39 + v36 / v46
    v51 = 2.0 * xp.sqrt(v42 * v46)
    v54 = 2.0 * (v45 + v48 * v51)
    v55 = v42 + v46
    v57 = v48 + v45 / v55
    v60 = 2.0 * xp.sqrt(v51 * v55)
    v64 = v51 + v55
    v67 = v60 + v64
    return (2.0 * (v54 + v57 * v60) + (v57 + v54 / v64) * v67) / (v67 * v67)


def uniform(xp, r, a):
    v1 = xp.maximum(r, a)
    v3 = v1 < xp.inf
    v4 = xp.where(v3, v1, 0.5 * xp.inf)
    v5 = xp.minimum(r, a)
    v12 = xp.where(v3, 2.0 * xp.inf, v1)
    v14 = r <= a
    v15 = xp.where(v14, r, 0.5 * a)
    v16 = xp.maximum(v15, a)
    v17 = v16 < xp.inf
    v18 = xp.where(v17, v16, 0.5 * xp.inf)
    v19 = xp.minimum(v15, a)
    v26 = xp.where(v17, 2.0 * xp.inf, v16)
    v27 = xp.where(v17, xp.sqrt((v18 - v19) / v18 * ((v18 + v19) / v18)), 1.0)
    v29 = xp.where(v14, 2.0 * a, r)
    v13 = xp.where(v3, xp.sqrt((v4 - v5) / v4 * ((v4 + v5) / v4)), 1.0)
    return a / v1 * elliptic(xp, v13, xp.where(v14, v27 * v27, 0.0))
