"""Formulas of axicontact.normal.paraboloid over an array library `xp`."""


def depth(xp, a, R):
    v0 = a ** 2.0
    v1 = v0 / R
    return v1


def depth_from_force(xp, F, R, E_star):
    v0 = F ** 2.0
    v1 = 9.0 * v0
    v2 = E_star ** 2.0
    v3 = 16.0 * v2
    v4 = v3 * R
    v5 = v1 / v4
    v6 = xp.cbrt(v5)
    return v6


def displacement(xp, r, a, R):
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
    return v58


def force(xp, a, R, E_star):
    v0 = 4.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    return v5


def force_from_depth(xp, d, R, E_star):
    v0 = 4.0 * E_star
    v1 = v0 / 3.0
    v2 = v1 * d
    v3 = R * d
    v4 = xp.sqrt(v3)
    v5 = v2 * v4
    return v5


def mean_pressure(xp, a, R, E_star):
    v0 = 4.0 * E_star
    v1 = 9.42477796076938 * R
    v2 = v0 / v1
    v3 = v2 * a
    return v3


def pressure(xp, r, a, R, E_star):
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
    return v11


def profile(xp, r, R):
    v0 = r ** 2.0
    v1 = 2.0 * R
    v2 = v0 / v1
    return v2


def radius_from_depth(xp, d, R):
    v0 = R * d
    v1 = xp.sqrt(v0)
    return v1


def radius_from_force(xp, F, R, E_star):
    v0 = 3.0 * R
    v1 = 4.0 * E_star
    v2 = v0 / v1
    v3 = v2 * F
    v4 = xp.cbrt(v3)
    return v4


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
