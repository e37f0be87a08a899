"""Formulas of axicontact.adhesive.cone over an array library `xp`."""

from ...._runtime.integrals import nodes_along


def depth(xp, a, theta, E_star, dgamma):
    v0 = xp.tan(theta)
    v1 = 3.141592653589793 * v0
    v2 = v1 * a
    v3 = v2 / 2.0
    v4 = xp.sqrt(a)
    v5 = 6.283185307179586 * dgamma
    v6 = v5 / E_star
    v7 = xp.sqrt(v6)
    v8 = v4 * v7
    v9 = v3 - v8
    return v9


def displacement(xp, r, a, theta, E_star, dgamma):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = xp.tan(theta)
    v3 = v2 * a
    v4 = v1 - a
    v5 = v1 + a
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v1 + v7
    v9 = a / v8
    v10 = xp.arctan(v9)
    v11 = 2.0 * v10
    v12 = v11 - v9
    v13 = v3 * v12
    v14 = xp.where(v0, 0.5 * a, r)
    v15 = xp.tan(theta)
    v16 = 3.141592653589793 * v15
    v17 = v16 * a
    v18 = v17 / 2.0
    v19 = v15 * v14
    v20 = v18 - v19
    v21 = xp.where(v0, v13, v20)
    v22 = xp.sqrt(a)
    v23 = 6.283185307179586 * dgamma
    v24 = v23 / E_star
    v25 = xp.sqrt(v24)
    v26 = v22 * v25
    v27 = xp.where(v0, r, 2.0 * a)
    v28 = v27 - a
    v29 = xp.maximum(v28, 0.0)
    v30 = v27 + a
    v31 = v29 * v30
    v32 = xp.sqrt(v31)
    v33 = xp.arctan2(a, v32)
    v34 = 0.6366197723675814 * v33
    v35 = xp.where(v0, 0.5 * a, r)
    v36 = xp.where(v0, v34, 1.0)
    v37 = v26 * v36
    v38 = v21 - v37
    return v38


def force(xp, a, theta, E_star, dgamma):
    v0 = 3.141592653589793 * E_star
    v1 = xp.tan(theta)
    v2 = v0 * v1
    v3 = a ** 2.0
    v4 = v2 * v3
    v5 = v4 / 2.0
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


def pressure(xp, r, a, theta, E_star, dgamma):
    v0 = r < a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = xp.tan(theta)
    v3 = E_star * v2
    v4 = a - v1
    v5 = a + v1
    v6 = v4 * v5
    v7 = xp.sqrt(v6)
    v8 = v4 + v7
    v9 = v8 / v1
    v10 = xp.log1p(v9)
    v11 = v3 * v10
    v12 = v11 / 2.0
    v13 = xp.where(v0, 2.0 * a, r)
    v14 = xp.where(v0, v12, 0.0)
    v15 = r <= a
    v16 = xp.where(v15, r, 0.5 * a)
    v17 = xp.sqrt(a)
    v18 = 6.283185307179586 * dgamma
    v19 = v18 / E_star
    v20 = xp.sqrt(v19)
    v21 = v17 * v20
    v22 = v21 > 0.0
    v23 = E_star * v21
    v24 = a - v16
    v25 = xp.maximum(v24, 0.0)
    v26 = a + v16
    v27 = v25 * v26
    v28 = xp.sqrt(v27)
    v29 = 3.141592653589793 * v28
    v30 = v23 / v29
    v31 = xp.where(v22, v30, 0.0)
    v32 = xp.where(v15, 2.0 * a, r)
    v33 = xp.where(v15, v31, 0.0)
    v34 = v14 - v33
    return v34


def radius_from_depth(xp, d, theta, E_star, dgamma):
    nodes, weights = nodes_along(xp, 64, d, theta, E_star, dgamma)
    v1 = xp.tan(theta)
    v2 = 3.141592653589793 * v1
    v3 = dgamma > 0.0
    v4 = 2.0 * dgamma
    v5 = 3.141592653589793 * E_star
    v6 = v1 ** 2.0
    v7 = v5 * v6
    v8 = v4 / v7
    v9 = xp.where(v3, v8, 0.0)
    v10 = v2 * v9
    v11 = v10 / 2.0
    v12 = v11 * (-1.0)
    v13 = v12 < 0.0
    v14 = xp.where(v13, v12, (-1.0))
    v15 = d / v14
    v16 = 1.0 - v15
    v17 = xp.where(v13, v16, xp.inf)
    v18 = xp.absolute(v17)
    v19 = v18 < 1e-15
    v20 = xp.where(v19, v18, 0.5 * 1e-15)
    v21 = xp.where(v19, 2.0 * 1e-15, v18)
    v22 = xp.where(v19, 0.0, v17)
    v23 = v22 < 0.0
    v24 = xp.isfinite(v22)
    v25 = v22 == 0.0
    v26 = v22 > 0.0
    v27 = xp.where(v26, v22, 1.0)
    v28 = v27 * 2.0
    v29 = v28 < 1.0
    v30 = xp.where(v29, v28, 0.5 * 1.0)
    v31 = 2.0 * v27
    v32 = v31 / 2.0
    v33 = xp.sqrt(v32)
    v34 = xp.where(v29, 2.0 * 1.0, v28)
    v35 = v27 + 0.0
    v36 = xp.log1p(v35)
    v37 = v36 / 2.0
    v38 = xp.expm1(v37)
    v39 = 2.0 * v38
    v40 = v27 + v39
    v41 = xp.log1p(v40)
    v42 = v41 / 2.0
    v43 = xp.expm1(v42)
    v44 = 2.0 * v43
    v45 = v27 + v44
    v46 = xp.log1p(v45)
    v47 = v46 / 2.0
    v48 = xp.expm1(v47)
    v49 = xp.where(v29, v33, v48)
    v50 = xp.where(v27 > 0.0, v27, 1.0)
    v51 = xp.minimum(v49, xp.inf)
    for _ in range(6):
        v53 = xp.minimum(v51, 4.0)
        v54 = v53 * 2.0
        v55 = v54 < 4.0
        v56 = xp.where(v55, v54, 0.5 * 4.0)
        v57 = xp.minimum(v51, 2.0)
        v58 = 2.0 * v57
        v59 = v58 * v57
        v60 = nodes * 1.0
        v61 = 1.0 - v60
        v62 = v57 * v60
        v63 = xp.log1p(v62)
        v64 = 0.0 * v63
        v65 = xp.exp(v64)
        v66 = v61 * v65
        v67 = 1.0 * xp.sum(weights * v66, axis=0)
        v68 = v59 * v67
        v69 = xp.where(v55, 2.0 * 4.0, v54)
        v70 = 1.0 + v51
        v71 = v51 > 1.0
        v72 = xp.log1p(v51)
        v73 = v72 > 1.0
        v74 = v71 & v73
        v75 = v70 ** 1.0
        v76 = v75 - 1.0
        v77 = xp.expm1(v72)
        v78 = xp.where(v74, v76, v77)
        v79 = 2.0 * v78
        v80 = v70 * v79
        v81 = v80 / 2.0
        v82 = v81 - v51
        v83 = xp.where(v55, v68, v82)
        v84 = v51 > 1.0
        v85 = xp.log1p(v51)
        v86 = v85 > 1.0
        v87 = v84 & v86
        v88 = 1.0 + v51
        v89 = v88 ** 1.0
        v90 = v89 - 1.0
        v91 = xp.expm1(v85)
        v92 = xp.where(v87, v90, v91)
        v93 = 2.0 * v92
        v94 = v51 * v93
        v95 = v94 / v83
        v96 = xp.log(v50 / v83)
        v97 = v96 / 2.0
        v98 = v96 / 2.0
        v99 = xp.minimum(xp.maximum(v96 / v95, xp.minimum(v97, v98)), xp.maximum(v97, v98))
        v100 = xp.where(v83 < xp.inf, v99, 0.0)
        v51 = xp.minimum(v51 * xp.exp(v100), xp.inf)
    v102 = xp.where(v27 > 0.0, v51, 0.0 * v27)
    v103 = xp.where(v25, 0.0, v102)
    v104 = 1.0 + v103
    v105 = v104 ** 2.0
    v106 = v9 * v105
    v107 = d >= 0.0
    v108 = xp.maximum(d, 0.0)
    v109 = 2.0 * v108
    v110 = v109 / v2
    v111 = xp.where(v107, v110, xp.nan)
    v112 = xp.where(v24, v106, v111)
    v113 = xp.where(v23, xp.nan, v112)
    return v113


def radius_from_force(xp, F, theta, E_star, dgamma):
    nodes, weights = nodes_along(xp, 64, F, theta, E_star, dgamma)
    v1 = 3.141592653589793 * E_star
    v2 = xp.tan(theta)
    v3 = v1 * v2
    v4 = dgamma > 0.0
    v5 = 18.0 * dgamma
    v6 = v2 ** 2.0
    v7 = v1 * v6
    v8 = v5 / v7
    v9 = xp.where(v4, v8, 0.0)
    v10 = v9 ** 2.0
    v11 = v3 * v10
    v12 = v11 / 2.0
    v13 = v12 * (-0.33333333333333326)
    v14 = v13 < 0.0
    v15 = xp.where(v14, v13, (-1.0))
    v16 = F / v15
    v17 = 1.0 - v16
    v18 = xp.where(v14, v17, xp.inf)
    v19 = xp.absolute(v18)
    v20 = v19 < 1e-15
    v21 = xp.where(v20, v19, 0.5 * 1e-15)
    v22 = xp.where(v20, 2.0 * 1e-15, v19)
    v23 = xp.where(v20, 0.0, v18)
    v24 = v23 < 0.0
    v25 = xp.isfinite(v23)
    v26 = v23 == 0.0
    v27 = v23 > 0.0
    v28 = xp.where(v27, v23, 1.0)
    v29 = v28 * 1.3333333333333333
    v30 = v29 < 1.0
    v31 = xp.where(v30, v29, 0.5 * 1.0)
    v32 = 2.0 * v28
    v33 = v32 / 1.3333333333333333
    v34 = xp.sqrt(v33)
    v35 = xp.where(v30, 2.0 * 1.0, v29)
    v36 = 0.33333333333333326 * v28
    v37 = v36 + 0.0
    v38 = xp.log1p(v37)
    v39 = v38 / 1.3333333333333333
    v40 = xp.expm1(v39)
    v41 = 1.3333333333333333 * v40
    v42 = v36 + v41
    v43 = xp.log1p(v42)
    v44 = v43 / 1.3333333333333333
    v45 = xp.expm1(v44)
    v46 = 1.3333333333333333 * v45
    v47 = v36 + v46
    v48 = xp.log1p(v47)
    v49 = v48 / 1.3333333333333333
    v50 = xp.expm1(v49)
    v51 = xp.where(v30, v34, v50)
    v52 = xp.where(v28 > 0.0, v28, 1.0)
    v53 = xp.minimum(v51, xp.inf)
    for _ in range(6):
        v55 = xp.minimum(v53, 4.0)
        v56 = v55 * 2.0
        v57 = v56 < 4.0
        v58 = xp.where(v57, v56, 0.5 * 4.0)
        v59 = xp.minimum(v53, 2.0)
        v60 = 1.3333333333333333 * v59
        v61 = v60 * v59
        v62 = nodes * 1.0
        v63 = 1.0 - v62
        v64 = v59 * v62
        v65 = xp.log1p(v64)
        v66 = (-0.6666666666666667) * v65
        v67 = xp.exp(v66)
        v68 = v63 * v67
        v69 = 1.0 * xp.sum(weights * v68, axis=0)
        v70 = v61 * v69
        v71 = xp.where(v57, 2.0 * 4.0, v56)
        v72 = 1.0 + v53
        v73 = v53 > 1.0
        v74 = xp.log1p(v53)
        v75 = 0.33333333333333326 * v74
        v76 = v75 > 1.0
        v77 = v73 & v76
        v78 = v72 ** 0.33333333333333326
        v79 = v78 - 1.0
        v80 = xp.expm1(v75)
        v81 = xp.where(v77, v79, v80)
        v82 = 1.3333333333333333 * v81
        v83 = v82 / 0.33333333333333326
        v84 = v72 * v83
        v85 = v84 / 1.3333333333333333
        v86 = v85 - v53
        v87 = xp.where(v57, v70, v86)
        v88 = v53 > 1.0
        v89 = xp.log1p(v53)
        v90 = 0.33333333333333326 * v89
        v91 = v90 > 1.0
        v92 = v88 & v91
        v93 = 1.0 + v53
        v94 = v93 ** 0.33333333333333326
        v95 = v94 - 1.0
        v96 = xp.expm1(v90)
        v97 = xp.where(v92, v95, v96)
        v98 = 1.3333333333333333 * v97
        v99 = v98 / 0.33333333333333326
        v100 = v53 * v99
        v101 = v100 / v87
        v102 = xp.log(v52 / v87)
        v103 = v102 / 1.3333333333333333
        v104 = v102 / 2.0
        v105 = xp.minimum(xp.maximum(v102 / v101, xp.minimum(v103, v104)), xp.maximum(v103, v104))
        v106 = xp.where(v87 < xp.inf, v105, 0.0)
        v53 = xp.minimum(v53 * xp.exp(v106), xp.inf)
    v108 = xp.where(v28 > 0.0, v53, 0.0 * v28)
    v109 = xp.where(v26, 0.0, v108)
    v110 = 1.0 + v109
    v111 = v110 ** 0.6666666666666666
    v112 = v9 * v111
    v113 = F >= 0.0
    v114 = xp.maximum(F, 0.0)
    v115 = 2.0 * v114
    v116 = v115 / v3
    v117 = xp.sqrt(v116)
    v118 = xp.where(v113, v117, xp.nan)
    v119 = xp.where(v25, v112, v118)
    v120 = xp.where(v24, xp.nan, v119)
    return v120
