"""Formulas of axicontact.adhesive.sphere_tipped_cone over an array library `xp`."""


def depth(xp, a, R, theta, E_star, dgamma):
    v0 = xp.sin(theta)
    v1 = R * v0
    v2 = a < v1
    v3 = 2.0 * a
    v4 = R - a
    v5 = v3 / v4
    v6 = xp.log1p(v5)
    v7 = v6 / 2.0
    v8 = a * v7
    v9 = v1 ** 2.0
    v10 = xp.cos(theta)
    v11 = R * v10
    v12 = v11 < v1
    v13 = v11 * v11
    v14 = R + a
    v15 = v4 * v14
    v16 = v13 - v15
    v17 = a - v1
    v18 = a + v1
    v19 = v17 * v18
    v20 = xp.where(v12, v16, v19)
    v21 = xp.maximum(v20, 0.0)
    v22 = xp.sqrt(v21)
    v23 = v22 + a
    v24 = v9 / v23
    v25 = v11 + R
    v26 = v9 / v25
    v27 = v24 + v26
    v28 = v22 + v11
    v29 = v27 / v28
    v30 = xp.log1p(v29)
    v31 = xp.arctan2(v22, v1)
    v32 = v1 * v31
    v33 = v32 / v11
    v34 = v30 + v33
    v35 = a * v34
    v36 = xp.where(v2, v8, v35)
    v37 = xp.sqrt(a)
    v38 = 6.283185307179586 * dgamma
    v39 = v38 / E_star
    v40 = xp.sqrt(v39)
    v41 = v37 * v40
    v42 = v36 - v41
    return v42
