"""Formulas of axicontact.tangential.truncated_cone over an array library `xp`."""


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    v0 = E_star / G_star
    v1 = mu * v0
    v2 = xp.tan(theta)
    v3 = v2 * a
    v4 = a - b
    v5 = a + b
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v7 / b
    v9 = xp.arctan(v8)
    v10 = v3 * v9
    v11 = v1 * v10
    return v11


def stick_radius(xp, F_x, a, theta, b, E_star, mu):
    v0 = F_x == 0.0
    v1 = a >= 0.0
    v2 = v0 & v1
    v3 = xp.tan(theta)
    v4 = E_star * v3
    v5 = a ** 2.0
    v6 = a - b
    v7 = a + b
    v8 = v6 * v7
    v9 = xp.sqrt(v8)
    v10 = v9 / b
    v11 = xp.arctan(v10)
    v12 = v5 * v11
    v13 = b * v9
    v14 = v12 + v13
    v15 = v4 * v14
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
    v26 = b / b
    v27 = xp.arctan(v26)
    v28 = v25 * v27
    v29 = b * b
    v30 = v28 + v29
    v31 = v4 * v30
    v32 = v23 / v31
    v33 = xp.log(v32)
    v34 = v33 - (-0.2510287548037454)
    v35 = (-2.75) * v34
    v36 = v33 - (-0.49265831981054176)
    v37 = (-1.375) * v36
    v38 = xp.maximum(v35, v37)
    v39 = v35 - v37
    v40 = xp.absolute(v39)
    v41 = -v40
    v42 = xp.exp(v41)
    v43 = xp.log1p(v42)
    v44 = v38 + v43
    v45 = v44 / (-2.75)
    v46 = xp.exp(v45)
    v47 = 1.0 + v46
    v48 = 1.0 / v47
    v49 = 1.0 - v48
    v50 = 7.204481 * v49
    v51 = v50 + (-25.89697)
    v52 = v51 * v49
    v53 = v52 + 34.2219
    v54 = v53 * v49
    v55 = v54 + (-19.76727)
    v56 = v55 * v49
    v57 = v56 + 4.536442
    v58 = v57 * v49
    v59 = v58 + (-0.3986471)
    v60 = v59 * v49
    v61 = v60 + 0.100541
    v62 = v61 * v49
    v63 = v62 + 0.9995205
    v64 = v46 * v63
    v65 = xp.where(v23 > 0.0, v23, 1.0)
    v66 = xp.minimum(v64, xp.inf)
    for _ in range(6):
        v68 = xp.tan(theta)
        v69 = E_star * v68
        v70 = v66 * v66
        v71 = 1.0 + v70
        v72 = xp.sqrt(v71)
        v73 = b * v72
        v74 = v73 ** 2.0
        v75 = b * v66
        v76 = v75 / b
        v77 = xp.arctan(v76)
        v78 = v74 * v77
        v79 = b * v75
        v80 = v78 + v79
        v81 = v69 * v80
        v82 = 2.0 * E_star
        v83 = v82 * v75
        v84 = v83 * v75
        v85 = v68 * v77
        v86 = b * v68
        v87 = v86 / v75
        v88 = v85 + v87
        v89 = v84 * v88
        v90 = v89 / v81
        v91 = xp.log(v65 / v81)
        v92 = v91 / 1.0
        v93 = v91 / 2.0
        v94 = xp.minimum(xp.maximum(v91 / v90, xp.minimum(v92, v93)), xp.maximum(v92, v93))
        v95 = xp.where(v81 < xp.inf, v94, 0.0)
        v66 = xp.minimum(v66 * xp.exp(v95), xp.inf)
    v97 = xp.where(v23 > 0.0, v66, 0.0 * v23)
    v98 = v97 * v97
    v99 = 1.0 + v98
    v100 = xp.sqrt(v99)
    v101 = b * v100
    v102 = xp.where(v2, a, v101)
    return v102
