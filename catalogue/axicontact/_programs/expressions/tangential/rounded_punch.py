"""Formulas of axicontact.tangential.rounded_punch over an array library `xp`."""


def full_slip_displacement(xp, a, R, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = b / R
    v3 = v2 * a
    v4 = a - b
    v5 = v4 / b
    v6 = v5 < 0.42
    v7 = xp.minimum(v5, 0.42)
    v8 = xp.sqrt(v7)
    v9 = v7 * v8
    v10 = 0.0005288491342179178 * v7
    v11 = v10 + 0.038096760299703034
    v12 = v11 * v7
    v13 = v12 + 0.4065213849117787
    v14 = v13 * v7
    v15 = v14 + 1.438682033198726
    v16 = v15 * v7
    v17 = v16 + 1.9979042349620892
    v18 = v17 * v7
    v19 = v18 + 0.9428090415820634
    v20 = 0.006421883194715949 * v7
    v21 = v20 + 0.15001504718401248
    v22 = v21 * v7
    v23 = v22 + 0.9450913324352289
    v24 = v23 * v7
    v25 = v24 + 2.37401087025821
    v26 = v25 * v7
    v27 = v26 + 2.569097449054519
    v28 = v27 * v7
    v29 = v28 + 1.0
    v30 = v19 / v29
    v31 = v9 * v30
    v32 = a + b
    v33 = v4 * v32
    v34 = xp.sqrt(v33)
    v35 = v34 / b
    v36 = xp.arctan(v35)
    v37 = v35 - v36
    v38 = xp.where(v6, v31, v37)
    v39 = v3 * v38
    v40 = v1 * v39
    return v40
