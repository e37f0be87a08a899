"""Formulas of axicontact.tangential.rounded_curved_punch over an array library `xp`."""


def full_slip_displacement(xp, a, R1, R2, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a < b
    v3 = xp.where(v2, a, 0.5 * b)
    v4 = v3 ** 2.0
    v5 = v4 / R1
    v6 = xp.where(v2, 2.0 * b, a)
    v7 = v6 / R1
    v8 = b / R2
    v9 = v6 - b
    v10 = v9 / b
    v11 = v10 < 0.42
    v12 = xp.minimum(v10, 0.42)
    v13 = xp.sqrt(v12)
    v14 = v12 * v13
    v15 = 0.0005288491342179178 * v12
    v16 = v15 + 0.038096760299703034
    v17 = v16 * v12
    v18 = v17 + 0.4065213849117787
    v19 = v18 * v12
    v20 = v19 + 1.438682033198726
    v21 = v20 * v12
    v22 = v21 + 1.9979042349620892
    v23 = v22 * v12
    v24 = v23 + 0.9428090415820634
    v25 = 0.006421883194715949 * v12
    v26 = v25 + 0.15001504718401248
    v27 = v26 * v12
    v28 = v27 + 0.9450913324352289
    v29 = v28 * v12
    v30 = v29 + 2.37401087025821
    v31 = v30 * v12
    v32 = v31 + 2.569097449054519
    v33 = v32 * v12
    v34 = v33 + 1.0
    v35 = v24 / v34
    v36 = v14 * v35
    v37 = v6 + b
    v38 = v9 * v37
    v39 = xp.sqrt(v38)
    v40 = v39 / b
    v41 = xp.arctan(v40)
    v42 = v40 - v41
    v43 = xp.where(v11, v36, v42)
    v44 = v8 * v43
    v45 = v7 + v44
    v46 = v6 * v45
    v47 = xp.where(v2, v5, v46)
    v48 = v1 * v47
    return v48
