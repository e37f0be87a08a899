"""Formulas of axicontact.adhesive.hyperboloid over an array library `xp`."""


def depth(xp, a, theta, b, E_star, dgamma):
    v0 = xp.tan(theta)
    v1 = v0 * a
    v2 = a / b
    v3 = xp.arctan(v2)
    v4 = v1 * v3
    v5 = xp.sqrt(a)
    v6 = 6.283185307179586 * dgamma
    v7 = v6 / E_star
    v8 = xp.sqrt(v7)
    v9 = v5 * v8
    v10 = v4 - v9
    return v10


def force(xp, a, theta, b, E_star, dgamma):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = a ** 2.0
    v3 = xp.arctan2(a, b)
    v4 = v2 * v3
    v5 = b ** 2.0
    v6 = a / b
    v7 = v6 < 1.0
    v8 = xp.minimum(v6, 1.0)
    v9 = v8 * v8
    v10 = v8 * v9
    v11 = 2.229767813968649e-06 * v9
    v12 = v11 + 0.0021043873129700233
    v13 = v12 * v9
    v14 = v13 + 0.04325113828415611
    v15 = v14 * v9
    v16 = v15 + 0.2725778671008127
    v17 = v16 * v9
    v18 = v17 + 0.7123414383945195
    v19 = v18 * v9
    v20 = v19 + 0.8116412201960678
    v21 = v20 * v9
    v22 = v21 + 0.3333333333333333
    v23 = 0.002445452808893491 * v9
    v24 = v23 + 0.06453295925870227
    v25 = v24 * v9
    v26 = v25 + 0.5368820963772863
    v27 = v26 * v9
    v28 = v27 + 1.9680296155712274
    v29 = v28 * v9
    v30 = v29 + 3.5294070829658954
    v31 = v30 * v9
    v32 = v31 + 3.034923660588189
    v33 = v32 * v9
    v34 = v33 + 1.0
    v35 = v22 / v34
    v36 = v10 * v35
    v37 = xp.arctan(v6)
    v38 = v6 - v37
    v39 = xp.where(v7, v36, v38)
    v40 = v5 * v39
    v41 = v4 + v40
    v42 = v1 * v41
    v43 = 2.0 * E_star
    v44 = v43 * a
    v45 = xp.sqrt(a)
    v46 = 6.283185307179586 * dgamma
    v47 = v46 / E_star
    v48 = xp.sqrt(v47)
    v49 = v45 * v48
    v50 = v44 * v49
    v51 = v42 - v50
    return v51
