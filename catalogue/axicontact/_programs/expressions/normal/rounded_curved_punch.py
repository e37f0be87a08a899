"""Formulas of axicontact.normal.rounded_curved_punch over an array library `xp`."""


def depth(xp, a, R1, R2, b):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = v1 ** 2.0
    v3 = v2 / R1
    v4 = xp.where(v0, 2.0 * b, a)
    v5 = v4 / R1
    v6 = b / R2
    v7 = v4 - b
    v8 = v7 / b
    v9 = v8 < 0.42
    v10 = xp.minimum(v8, 0.42)
    v11 = xp.sqrt(v10)
    v12 = v10 * v11
    v13 = 0.0005288491342179178 * v10
    v14 = v13 + 0.038096760299703034
    v15 = v14 * v10
    v16 = v15 + 0.4065213849117787
    v17 = v16 * v10
    v18 = v17 + 1.438682033198726
    v19 = v18 * v10
    v20 = v19 + 1.9979042349620892
    v21 = v20 * v10
    v22 = v21 + 0.9428090415820634
    v23 = 0.006421883194715949 * v10
    v24 = v23 + 0.15001504718401248
    v25 = v24 * v10
    v26 = v25 + 0.9450913324352289
    v27 = v26 * v10
    v28 = v27 + 2.37401087025821
    v29 = v28 * v10
    v30 = v29 + 2.569097449054519
    v31 = v30 * v10
    v32 = v31 + 1.0
    v33 = v22 / v32
    v34 = v12 * v33
    v35 = v4 + b
    v36 = v7 * v35
    v37 = xp.sqrt(v36)
    v38 = v37 / b
    v39 = xp.arctan(v38)
    v40 = v38 - v39
    v41 = xp.where(v9, v34, v40)
    v42 = v6 * v41
    v43 = v5 + v42
    v44 = v4 * v43
    v45 = xp.where(v0, v3, v44)
    return v45


def force(xp, a, R1, R2, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = 3.0 * R1
    v4 = v2 / v3
    v5 = v1 ** 2.0
    v6 = v1 * v5
    v7 = v4 * v6
    v8 = xp.where(v0, 2.0 * b, a)
    v9 = v8 ** 2.0
    v10 = v8 * v9
    v11 = 4.0 * v10
    v12 = 3.0 * R1
    v13 = v11 / v12
    v14 = b / R2
    v15 = v14 * v9
    v16 = v8 - b
    v17 = v16 / b
    v18 = v17 < 0.42
    v19 = xp.minimum(v17, 0.42)
    v20 = xp.sqrt(v19)
    v21 = v19 * v20
    v22 = 0.0005288491342179178 * v19
    v23 = v22 + 0.038096760299703034
    v24 = v23 * v19
    v25 = v24 + 0.4065213849117787
    v26 = v25 * v19
    v27 = v26 + 1.438682033198726
    v28 = v27 * v19
    v29 = v28 + 1.9979042349620892
    v30 = v29 * v19
    v31 = v30 + 0.9428090415820634
    v32 = 0.006421883194715949 * v19
    v33 = v32 + 0.15001504718401248
    v34 = v33 * v19
    v35 = v34 + 0.9450913324352289
    v36 = v35 * v19
    v37 = v36 + 2.37401087025821
    v38 = v37 * v19
    v39 = v38 + 2.569097449054519
    v40 = v39 * v19
    v41 = v40 + 1.0
    v42 = v31 / v41
    v43 = v21 * v42
    v44 = v8 + b
    v45 = v16 * v44
    v46 = xp.sqrt(v45)
    v47 = v46 / b
    v48 = xp.arctan(v47)
    v49 = v47 - v48
    v50 = xp.where(v18, v43, v49)
    v51 = v15 * v50
    v52 = v13 + v51
    v53 = v45 * v46
    v54 = 3.0 * R2
    v55 = v53 / v54
    v56 = v52 + v55
    v57 = E_star * v56
    v58 = xp.where(v0, v7, v57)
    return v58


def mean_pressure(xp, a, R1, R2, b, E_star):
    v0 = a < b
    v1 = xp.where(v0, a, 0.5 * b)
    v2 = 4.0 * E_star
    v3 = 9.42477796076938 * R1
    v4 = v2 / v3
    v5 = v4 * v1
    v6 = xp.where(v0, 2.0 * b, a)
    v7 = E_star / 3.141592653589793
    v8 = 4.0 * v6
    v9 = 3.0 * R1
    v10 = v8 / v9
    v11 = b / R2
    v12 = v6 - b
    v13 = v12 / b
    v14 = v13 < 0.42
    v15 = xp.minimum(v13, 0.42)
    v16 = xp.sqrt(v15)
    v17 = v15 * v16
    v18 = 0.0005288491342179178 * v15
    v19 = v18 + 0.038096760299703034
    v20 = v19 * v15
    v21 = v20 + 0.4065213849117787
    v22 = v21 * v15
    v23 = v22 + 1.438682033198726
    v24 = v23 * v15
    v25 = v24 + 1.9979042349620892
    v26 = v25 * v15
    v27 = v26 + 0.9428090415820634
    v28 = 0.006421883194715949 * v15
    v29 = v28 + 0.15001504718401248
    v30 = v29 * v15
    v31 = v30 + 0.9450913324352289
    v32 = v31 * v15
    v33 = v32 + 2.37401087025821
    v34 = v33 * v15
    v35 = v34 + 2.569097449054519
    v36 = v35 * v15
    v37 = v36 + 1.0
    v38 = v27 / v37
    v39 = v17 * v38
    v40 = v6 + b
    v41 = v12 * v40
    v42 = xp.sqrt(v41)
    v43 = v42 / b
    v44 = xp.arctan(v43)
    v45 = v43 - v44
    v46 = xp.where(v14, v39, v45)
    v47 = v11 * v46
    v48 = v10 + v47
    v49 = v41 * v42
    v50 = v6 ** 2.0
    v51 = 3.0 * v50
    v52 = v51 * R2
    v53 = v49 / v52
    v54 = v48 + v53
    v55 = v7 * v54
    v56 = xp.where(v0, v5, v55)
    return v56


def profile(xp, r, R1, R2, b):
    v0 = r < b
    v1 = xp.where(v0, r, 0.5 * b)
    v2 = v1 ** 2.0
    v3 = 2.0 * R1
    v4 = v2 / v3
    v5 = xp.where(v0, 2.0 * b, r)
    v6 = v5 ** 2.0
    v7 = 2.0 * R1
    v8 = v6 / v7
    v9 = v5 - b
    v10 = v9 ** 2.0
    v11 = 2.0 * R2
    v12 = v10 / v11
    v13 = v8 + v12
    v14 = xp.where(v0, v4, v13)
    return v14


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
