"""Formulas of axicontact.tangential.sphere_tipped_cone over an array library `xp`."""


def full_slip_displacement(xp, a, R, theta, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.sin(theta)
    v3 = R * v2
    v4 = a < v3
    v5 = 2.0 * a
    v6 = R - a
    v7 = v5 / v6
    v8 = xp.log1p(v7)
    v9 = v8 / 2.0
    v10 = a * v9
    v11 = v3 ** 2.0
    v12 = xp.cos(theta)
    v13 = R * v12
    v14 = v13 < v3
    v15 = v13 * v13
    v16 = R + a
    v17 = v6 * v16
    v18 = v15 - v17
    v19 = a - v3
    v20 = a + v3
    v21 = v19 * v20
    v22 = xp.where(v14, v18, v21)
    v23 = xp.maximum(v22, 0.0)
    v24 = xp.sqrt(v23)
    v25 = v24 + a
    v26 = v11 / v25
    v27 = v13 + R
    v28 = v11 / v27
    v29 = v26 + v28
    v30 = v24 + v13
    v31 = v29 / v30
    v32 = xp.log1p(v31)
    v33 = xp.arctan2(v24, v3)
    v34 = v3 * v33
    v35 = v34 / v13
    v36 = v32 + v35
    v37 = a * v36
    v38 = xp.where(v4, v10, v37)
    v39 = v1 * v38
    return v39
