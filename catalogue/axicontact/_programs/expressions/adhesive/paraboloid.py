"""Formulas of axicontact.adhesive.paraboloid over an array library `xp`."""


def depth(xp, a, R, E_star, dgamma):
    v0 = a ** 2.0
    v1 = v0 / R
    v2 = xp.sqrt(a)
    v3 = 6.283185307179586 * dgamma
    v4 = v3 / E_star
    v5 = xp.sqrt(v4)
    v6 = v2 * v5
    v7 = v1 - v6
    return v7


def displacement(xp, r, a, R, E_star, dgamma):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = a ** 2.0
    v3 = 2.0 * v2
    v4 = 3.141592653589793 * R
    v5 = v3 / v4
    v6 = a / v1
    v7 = v1 - a
    v8 = v1 + a
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v1 + v10
    v12 = a / v11
    v13 = v12 * v12
    v14 = (-0.7327347664453868) * v13
    v15 = v14 + (-32.15553480435792)
    v16 = v15 * v13
    v17 = v16 + (-332.23363563146734)
    v18 = v17 * v13
    v19 = v18 + (-1070.7082873491413)
    v20 = v19 * v13
    v21 = v20 + (-85.27694715374247)
    v22 = v21 * v13
    v23 = v22 + 5044.821368830373
    v24 = v23 * v13
    v25 = v24 + 8082.413158212496
    v26 = v25 * v13
    v27 = v26 + 3759.725330928701
    v28 = v27 * v13
    v29 = v28 + 0.26666666666720995
    v30 = 0.21387262524856868 * v13
    v31 = v30 + 32.12935731379798
    v32 = v31 * v13
    v33 = v32 + 746.8124983579742
    v34 = v33 * v13
    v35 = v34 + 6202.125133759036
    v36 = v35 * v13
    v37 = v36 + 23553.080984642995
    v38 = v37 * v13
    v39 = v38 + 44404.005348491315
    v40 = v39 * v13
    v41 = v40 + 40380.01430284195
    v42 = v41 * v13
    v43 = v42 + 14099.684276696918
    v44 = v43 * v13
    v45 = v44 + 1.0
    v46 = v29 / v45
    v47 = v13 * v46
    v48 = 0.6666666666666666 + v47
    v49 = v6 * v48
    v50 = v5 * v49
    v51 = xp.where(v0, 0.5 * a, r)
    v52 = a ** 2.0
    v53 = v52 / R
    v54 = v51 ** 2.0
    v55 = 2.0 * R
    v56 = v54 / v55
    v57 = v53 - v56
    v58 = xp.where(v0, v50, v57)
    v59 = xp.sqrt(a)
    v60 = 6.283185307179586 * dgamma
    v61 = v60 / E_star
    v62 = xp.sqrt(v61)
    v63 = v59 * v62
    v64 = xp.where(v0, r, 2.0 * a)
    v65 = v64 - a
    v66 = xp.maximum(v65, 0.0)
    v67 = v64 + a
    v68 = v66 * v67
    v69 = xp.sqrt(v68)
    v70 = xp.arctan2(a, v69)
    v71 = 0.6366197723675814 * v70
    v72 = xp.where(v0, 0.5 * a, r)
    v73 = xp.where(v0, v71, 1.0)
    v74 = v63 * v73
    v75 = v58 - v74
    return v75


def force(xp, a, R, E_star, dgamma):
    v0 = 4.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    v6 = 2.0 * E_star
    v7 = v6 * a
    v8 = xp.sqrt(a)
    v9 = 6.283185307179586 * dgamma
    v10 = v9 / E_star
    v11 = xp.sqrt(v10)
    v12 = v8 * v11
    v13 = v7 * v12
    v14 = v5 - v13
    return v14


def pressure(xp, r, a, R, E_star, dgamma):
    v0 = r < a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = 2.0 * E_star
    v3 = 3.141592653589793 * R
    v4 = v2 / v3
    v5 = a - v1
    v6 = a + v1
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = v4 * v8
    v10 = xp.where(v0, 2.0 * a, r)
    v11 = xp.where(v0, v9, 0.0)
    v12 = r <= a
    v13 = xp.where(v12, r, 0.5 * a)
    v14 = xp.sqrt(a)
    v15 = 6.283185307179586 * dgamma
    v16 = v15 / E_star
    v17 = xp.sqrt(v16)
    v18 = v14 * v17
    v19 = v18 > 0.0
    v20 = E_star * v18
    v21 = a - v13
    v22 = xp.maximum(v21, 0.0)
    v23 = a + v13
    v24 = v22 * v23
    v25 = xp.sqrt(v24)
    v26 = 3.141592653589793 * v25
    v27 = v20 / v26
    v28 = xp.where(v19, v27, 0.0)
    v29 = xp.where(v12, 2.0 * a, r)
    v30 = xp.where(v12, v28, 0.0)
    v31 = v11 - v30
    return v31
