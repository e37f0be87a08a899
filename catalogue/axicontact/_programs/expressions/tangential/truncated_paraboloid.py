"""Formulas of axicontact.tangential.truncated_paraboloid over an array library `xp`."""


def full_slip_displacement(xp, a, R, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = a - b
    v3 = a + b
    v4 = v2 * v3
    v5 = xp.sqrt(v4)
    v6 = a * v5
    v7 = v6 / R
    v8 = v1 * v7
    return v8


def stick_radius(xp, F_x, a, R, b, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = 2.0 * E_star
    v4 = 3.0 * R
    v5 = v3 / v4
    v6 = a ** 2.0
    v7 = 2.0 * v6
    v8 = b ** 2.0
    v9 = v7 + v8
    v10 = v5 * v9
    v11 = a - b
    v12 = a + b
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = v10 * v14
    v16 = F_x / mu
    v17 = v15 - v16
    v18 = xp.absolute(v17)
    v19 = 2e-16 * v15
    v20 = v18 <= v19
    v21 = xp.where(v20, 0.0, v17)
    v22 = v21 >= 0.0
    v23 = xp.where(v22, v21, xp.nan)
    v24 = b * 1.4142135623730951
    v25 = v24 ** 2.0
    v26 = 2.0 * v25
    v27 = v26 + v8
    v28 = v5 * v27
    v29 = v28 * b
    v30 = v23 / v29
    v31 = xp.log(v30)
    v32 = v31 - (-0.5108256237659907)
    v33 = (-1.75) * v32
    v34 = v31 - (-0.916290731874155)
    v35 = (-0.5833333333333334) * v34
    v36 = xp.maximum(v33, v35)
    v37 = v33 - v35
    v38 = xp.absolute(v37)
    v39 = -v38
    v40 = xp.exp(v39)
    v41 = xp.log1p(v40)
    v42 = v36 + v41
    v43 = v42 / (-1.75)
    v44 = xp.exp(v43)
    v45 = 1.0 + v44
    v46 = 1.0 / v45
    v47 = 1.0 - v46
    v48 = 19.09787 * v47
    v49 = v48 + (-63.48232)
    v50 = v49 * v47
    v51 = v50 + 76.63965
    v52 = v51 * v47
    v53 = v52 + (-39.30687)
    v54 = v53 * v47
    v55 = v54 + 7.512052
    v56 = v55 * v47
    v57 = v56 + (-0.7678073)
    v58 = v57 * v47
    v59 = v58 + 0.3089073
    v60 = v59 * v47
    v61 = v60 + 0.9990587
    v62 = v44 * v61
    v63 = xp.where(v23 > 0.0, v23, 1.0)
    v64 = xp.minimum(v62, xp.inf)
    for _ in range(6):
        v66 = 2.0 * E_star
        v67 = 3.0 * R
        v68 = v66 / v67
        v69 = v64 * v64
        v70 = 1.0 + v69
        v71 = xp.sqrt(v70)
        v72 = b * v71
        v73 = v72 ** 2.0
        v74 = 2.0 * v73
        v75 = b ** 2.0
        v76 = v74 + v75
        v77 = v68 * v76
        v78 = b * v64
        v79 = v77 * v78
        v80 = v66 * v78
        v81 = v80 * v78
        v82 = 2.0 * v78
        v83 = v82 / R
        v84 = R * v78
        v85 = v75 / v84
        v86 = v83 + v85
        v87 = v81 * v86
        v88 = v87 / v79
        v89 = xp.log(v63 / v79)
        v90 = v89 / 1.0
        v91 = v89 / 3.0
        v92 = xp.minimum(xp.maximum(v89 / v88, xp.minimum(v90, v91)), xp.maximum(v90, v91))
        v93 = xp.where(v79 < xp.inf, v92, 0.0)
        v64 = xp.minimum(v64 * xp.exp(v93), xp.inf)
    v95 = xp.where(v23 > 0.0, v64, 0.0 * v23)
    v96 = v95 * v95
    v97 = 1.0 + v96
    v98 = xp.sqrt(v97)
    v99 = b * v98
    v100 = xp.where(v2, a, v99)
    return v100
