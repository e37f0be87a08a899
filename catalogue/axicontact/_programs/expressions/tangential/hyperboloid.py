"""Formulas of axicontact.tangential.hyperboloid over an array library `xp`."""


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.tan(theta)
    v3 = v2 * a
    v4 = a / b
    v5 = xp.arctan(v4)
    v6 = v3 * v5
    v7 = v1 * v6
    return v7


def stick_radius(xp, F_x, a, theta, b, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = xp.tan(theta)
    v4 = E_star * v3
    v5 = a ** 2.0
    v6 = xp.arctan2(a, b)
    v7 = v5 * v6
    v8 = b ** 2.0
    v9 = a / b
    v10 = v9 < 1.0
    v11 = xp.minimum(v9, 1.0)
    v12 = v11 * v11
    v13 = v11 * v12
    v14 = 2.229767813968649e-06 * v12
    v15 = v14 + 0.0021043873129700233
    v16 = v15 * v12
    v17 = v16 + 0.04325113828415611
    v18 = v17 * v12
    v19 = v18 + 0.2725778671008127
    v20 = v19 * v12
    v21 = v20 + 0.7123414383945195
    v22 = v21 * v12
    v23 = v22 + 0.8116412201960678
    v24 = v23 * v12
    v25 = v24 + 0.3333333333333333
    v26 = 0.002445452808893491 * v12
    v27 = v26 + 0.06453295925870227
    v28 = v27 * v12
    v29 = v28 + 0.5368820963772863
    v30 = v29 * v12
    v31 = v30 + 1.9680296155712274
    v32 = v31 * v12
    v33 = v32 + 3.5294070829658954
    v34 = v33 * v12
    v35 = v34 + 3.034923660588189
    v36 = v35 * v12
    v37 = v36 + 1.0
    v38 = v25 / v37
    v39 = v13 * v38
    v40 = xp.arctan(v9)
    v41 = v9 - v40
    v42 = xp.where(v10, v39, v41)
    v43 = v8 * v42
    v44 = v7 + v43
    v45 = v4 * v44
    v46 = F_x / mu
    v47 = v45 - v46
    v48 = xp.absolute(v47)
    v49 = 2e-16 * v45
    v50 = v48 <= v49
    v51 = xp.where(v50, 0.0, v47)
    v52 = v51 >= 0.0
    v53 = xp.where(v52, v51, xp.nan)
    v54 = b / 1000.0
    v55 = xp.where(v53 > 0.0, v53, 1.0)
    v56 = xp.minimum(v54, xp.inf)
    for _ in range(6):
        v58 = xp.tan(theta)
        v59 = E_star * v58
        v60 = v56 ** 2.0
        v61 = xp.arctan2(v56, b)
        v62 = v60 * v61
        v63 = b ** 2.0
        v64 = v56 / b
        v65 = v64 < 1.0
        v66 = xp.minimum(v64, 1.0)
        v67 = v66 * v66
        v68 = v66 * v67
        v69 = 2.229767813968649e-06 * v67
        v70 = v69 + 0.0021043873129700233
        v71 = v70 * v67
        v72 = v71 + 0.04325113828415611
        v73 = v72 * v67
        v74 = v73 + 0.2725778671008127
        v75 = v74 * v67
        v76 = v75 + 0.7123414383945195
        v77 = v76 * v67
        v78 = v77 + 0.8116412201960678
        v79 = v78 * v67
        v80 = v79 + 0.3333333333333333
        v81 = 0.002445452808893491 * v67
        v82 = v81 + 0.06453295925870227
        v83 = v82 * v67
        v84 = v83 + 0.5368820963772863
        v85 = v84 * v67
        v86 = v85 + 1.9680296155712274
        v87 = v86 * v67
        v88 = v87 + 3.5294070829658954
        v89 = v88 * v67
        v90 = v89 + 3.034923660588189
        v91 = v90 * v67
        v92 = v91 + 1.0
        v93 = v80 / v92
        v94 = v68 * v93
        v95 = xp.arctan(v64)
        v96 = v64 - v95
        v97 = xp.where(v65, v94, v96)
        v98 = v63 * v97
        v99 = v62 + v98
        v100 = v59 * v99
        v101 = 2.0 * E_star
        v102 = v101 * v60
        v103 = v58 * v95
        v104 = b * v58
        v105 = v104 * v56
        v106 = v60 + v63
        v107 = v105 / v106
        v108 = v103 + v107
        v109 = v102 * v108
        v110 = v109 / v100
        v111 = xp.log(v55 / v100)
        v112 = v111 / 2.0
        v113 = v111 / 3.0
        v114 = xp.minimum(xp.maximum(v111 / v110, xp.minimum(v112, v113)), xp.maximum(v112, v113))
        v115 = xp.where(v100 < xp.inf, v114, 0.0)
        v56 = xp.minimum(v56 * xp.exp(v115), xp.inf)
    v117 = xp.where(v53 > 0.0, v56, 0.0 * v53)
    v118 = xp.where(v2, a, v117)
    return v118
