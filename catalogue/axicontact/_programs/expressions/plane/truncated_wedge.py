"""Formulas of axicontact.plane.truncated_wedge over an array library `xp`."""

from ...._runtime.integrals import nodes_along


def depth(xp, L, a, theta, b):
    nodes, weights = nodes_along(xp, 64, L, a, theta, b)
    v1 = 128.0 * b
    v2 = a < v1
    v3 = xp.where(v2, a, 0.5 * v1)
    v4 = v3 >= b
    v5 = xp.where(v4, v3, 2.0 * b)
    v6 = v5 <= L
    v7 = xp.where(v6, v5, 0.5 * L)
    v8 = v7 < L
    v9 = xp.where(v8, v7, 0.5 * L)
    v10 = v9 > b
    v11 = xp.where(v10, v9, 2.0 * b)
    v12 = v11 - b
    v13 = xp.maximum(v12, 0.0)
    v14 = v11 + b
    v15 = v13 * v14
    v16 = xp.sqrt(v15)
    v17 = L - v11
    v18 = xp.maximum(v17, 0.0)
    v19 = L + v11
    v20 = v18 * v19
    v21 = xp.sqrt(v20)
    v22 = v16 / v21
    v23 = b / L
    v24 = v22 / v23
    v25 = xp.arcsinh(v24)
    v26 = xp.arcsinh(v22)
    v27 = 42.0 + v26
    v28 = xp.minimum(v25, v27)
    v29 = nodes * v28
    v30 = xp.tan(theta)
    v31 = -v29
    v32 = xp.exp(v31)
    v33 = v25 - v29
    v34 = (-2.0) * v33
    v35 = xp.expm1(v34)
    v36 = 0.0 - v35
    v37 = v32 * v36
    v38 = (-2.0) * v25
    v39 = xp.expm1(v38)
    v40 = 0.0 - v39
    v41 = v40 > 0.0
    v42 = xp.where(v41, v40, xp.inf)
    v43 = v37 / v42
    v44 = v16 * v43
    v45 = v22 * v22
    v46 = 1.0 + v45
    v47 = xp.sqrt(v46)
    v48 = v22 * v43
    v49 = v48 * v48
    v50 = 1.0 + v49
    v51 = xp.sqrt(v50)
    v52 = v47 / v51
    v53 = v44 * v52
    v54 = v53 ** 2.0
    v55 = b ** 2.0
    v56 = v54 + v55
    v57 = xp.sqrt(v56)
    v58 = v30 * v57
    v59 = v58 / v53
    v60 = b * b
    v61 = v53 * v53
    v62 = v60 + v61
    v63 = xp.sqrt(v62)
    v64 = v53 / v63
    v65 = v23 / v22
    v66 = v65 ** 2.0
    v67 = v43 * v43
    v68 = v66 + v67
    v69 = xp.sqrt(v68)
    v70 = v69 / v50
    v71 = v64 * v70
    v72 = v59 * v71
    v73 = v72 * v52
    v74 = v21 * v52
    v75 = v74 / v63
    v76 = xp.arcsinh(v75)
    v77 = v73 * v76
    v78 = v28 * xp.sum(weights * v77, axis=0)
    v79 = v16 * v78
    v80 = xp.where(v10, 0.5 * b, v9)
    v81 = xp.where(v10, v79, 0.0)
    v82 = 0.6366197723675814 * v81
    v83 = xp.where(v8, 2.0 * L, v7)
    v84 = v83 > b
    v85 = xp.where(v84, v83, 2.0 * b)
    v86 = xp.tan(theta)
    v87 = v85 - b
    v88 = v86 * v87
    v89 = xp.where(v84, 0.5 * b, v83)
    v90 = xp.where(v84, v88, 0.0)
    v91 = xp.where(v8, v82, v90)
    v92 = xp.where(v6, 2.0 * L, v5)
    v93 = xp.where(v6, v91, xp.nan)
    v94 = xp.where(v4, 0.5 * b, v3)
    v95 = xp.where(v4, v93, xp.nan)
    v96 = xp.where(v2, 2.0 * v1, a)
    v97 = v96 >= b
    v98 = xp.where(v97, v96, 2.0 * b)
    v99 = v98 <= L
    v100 = xp.where(v99, v98, 0.5 * L)
    v101 = xp.tan(theta)
    v102 = 2.0 * v101
    v103 = v102 / 3.141592653589793
    v104 = L - v100
    v105 = v100 + L
    v106 = v104 * v105
    v107 = xp.sqrt(v106)
    v108 = v107 / v100
    v109 = xp.arcsinh(v108)
    v110 = v100 - b
    v111 = v100 + b
    v112 = v110 * v111
    v113 = xp.sqrt(v112)
    v114 = v109 * v113
    v115 = v113 / v107
    v116 = xp.arctan(v115)
    v117 = L * v116
    v118 = v114 + v117
    v119 = L * v113
    v120 = b * v107
    v121 = v119 / v120
    v122 = xp.arctan(v121)
    v123 = b * v122
    v124 = v118 - v123
    v125 = v103 * v124
    v126 = xp.where(v99, 2.0 * L, v98)
    v127 = xp.where(v99, v125, xp.nan)
    v128 = xp.where(v97, 0.5 * b, v96)
    v129 = xp.where(v97, v127, xp.nan)
    v130 = xp.where(v2, v95, v129)
    return v130


def half_width_from_load(xp, P, theta, b, E_star):
    v0 = P ** 2.0
    v1 = E_star ** 2.0
    v2 = xp.tan(theta)
    v3 = v2 ** 2.0
    v4 = v1 * v3
    v5 = v0 / v4
    v6 = b ** 2.0
    v7 = v5 + v6
    v8 = xp.sqrt(v7)
    return v8


def load(xp, a, theta, b, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = a - b
    v3 = a + b
    v4 = v2 * v3
    v5 = xp.sqrt(v4)
    v6 = v1 * v5
    return v6


def pressure(xp, x, a, theta, b, E_star):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = x < v1
    v3 = xp.where(v2, x, 0.5 * v1)
    v4 = v3 < b
    v5 = xp.where(v4, v3, 0.5 * b)
    v6 = xp.tan(theta)
    v7 = E_star * v6
    v8 = v7 / 3.141592653589793
    v9 = v1 - b
    v10 = v1 + b
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = b - v5
    v14 = v5 + b
    v15 = v13 * v14
    v16 = xp.sqrt(v15)
    v17 = v12 / v16
    v18 = xp.arcsinh(v17)
    v19 = v8 * v18
    v20 = xp.where(v4, 2.0 * b, v3)
    v21 = xp.tan(theta)
    v22 = E_star * v21
    v23 = v22 / 3.141592653589793
    v24 = v1 - v20
    v25 = v1 + v20
    v26 = v24 * v25
    v27 = xp.sqrt(v26)
    v28 = v20 - b
    v29 = v20 + b
    v30 = v28 * v29
    v31 = xp.sqrt(v30)
    v32 = v27 / v31
    v33 = xp.arcsinh(v32)
    v34 = v23 * v33
    v35 = xp.where(v4, v19, v34)
    v36 = xp.where(v2, 2.0 * v1, x)
    v37 = xp.where(v2, v35, 0.0)
    v38 = xp.where(v0, 0.5 * b, a)
    v39 = xp.where(v0, v37, xp.nan)
    return v39


def profile(xp, x, theta, b):
    v0 = x > b
    v1 = xp.where(v0, x, 2.0 * b)
    v2 = xp.tan(theta)
    v3 = v1 - b
    v4 = v2 * v3
    v5 = xp.where(v0, 0.5 * b, x)
    v6 = xp.where(v0, v4, 0.0)
    return v6


def slope(xp, x, a, theta, b):
    v0 = a >= b
    v1 = xp.where(v0, a, 2.0 * b)
    v2 = x > v1
    v3 = xp.where(v2, x, 2.0 * v1)
    v4 = xp.tan(theta)
    v5 = (-2.0) * v4
    v6 = v5 / 3.141592653589793
    v7 = v1 - b
    v8 = v1 + b
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v3 - v1
    v12 = v1 + v3
    v13 = v11 * v12
    v14 = xp.sqrt(v13)
    v15 = xp.arctan2(v10, v14)
    v16 = v6 * v15
    v17 = xp.where(v2, 0.5 * v1, x)
    v18 = v17 > b
    v19 = xp.where(v18, v17, 2.0 * b)
    v20 = xp.tan(theta)
    v21 = xp.where(v18, 0.5 * b, v17)
    v22 = xp.where(v18, v20, 0.0)
    v23 = -v22
    v24 = xp.where(v2, v16, v23)
    v25 = xp.where(v0, 0.5 * b, a)
    v26 = xp.where(v0, v24, xp.nan)
    return v26
