"""Formulas of axicontact.normal.truncated_paraboloid over an array library `xp`."""

from ...._runtime.integrals import nodes_along


def depth(xp, a, R, b):
    v0 = a - b
    v1 = a + b
    v2 = v0 * v1
    v3 = xp.sqrt(v2)
    v4 = a * v3
    v5 = v4 / R
    return v5


def depth_from_force(xp, F, R, b, E_star):
    v0 = 2.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = b * 1.4142135623730951
    v4 = v3 ** 2.0
    v5 = 2.0 * v4
    v6 = b ** 2.0
    v7 = v5 + v6
    v8 = v2 * v7
    v9 = v8 * b
    v10 = F / v9
    v11 = xp.log(v10)
    v12 = v11 - (-0.5108256237659907)
    v13 = (-1.75) * v12
    v14 = v11 - (-0.916290731874155)
    v15 = (-0.5833333333333334) * v14
    v16 = xp.maximum(v13, v15)
    v17 = v13 - v15
    v18 = xp.absolute(v17)
    v19 = -v18
    v20 = xp.exp(v19)
    v21 = xp.log1p(v20)
    v22 = v16 + v21
    v23 = v22 / (-1.75)
    v24 = xp.exp(v23)
    v25 = 1.0 + v24
    v26 = 1.0 / v25
    v27 = 1.0 - v26
    v28 = 19.09787 * v27
    v29 = v28 + (-63.48232)
    v30 = v29 * v27
    v31 = v30 + 76.63965
    v32 = v31 * v27
    v33 = v32 + (-39.30687)
    v34 = v33 * v27
    v35 = v34 + 7.512052
    v36 = v35 * v27
    v37 = v36 + (-0.7678073)
    v38 = v37 * v27
    v39 = v38 + 0.3089073
    v40 = v39 * v27
    v41 = v40 + 0.9990587
    v42 = v24 * v41
    v43 = xp.where(F > 0.0, F, 1.0)
    v44 = xp.minimum(v42, xp.inf)
    for _ in range(6):
        v46 = v44 * v44
        v47 = 1.0 + v46
        v48 = xp.sqrt(v47)
        v49 = b * v48
        v50 = v49 ** 2.0
        v51 = 2.0 * v50
        v52 = v51 + v6
        v53 = v2 * v52
        v54 = b * v44
        v55 = v53 * v54
        v56 = v0 * v54
        v57 = v56 * v54
        v58 = 2.0 * v54
        v59 = v58 / R
        v60 = R * v54
        v61 = v6 / v60
        v62 = v59 + v61
        v63 = v57 * v62
        v64 = v63 / v55
        v65 = xp.log(v43 / v55)
        v66 = v65 / 1.0
        v67 = v65 / 3.0
        v68 = xp.minimum(xp.maximum(v65 / v64, xp.minimum(v66, v67)), xp.maximum(v66, v67))
        v69 = xp.where(v55 < xp.inf, v68, 0.0)
        v44 = xp.minimum(v44 * xp.exp(v69), xp.inf)
    v71 = xp.where(F > 0.0, v44, 0.0 * F)
    v72 = v71 * v71
    v73 = 1.0 + v72
    v74 = xp.sqrt(v73)
    v75 = b * v74
    v76 = b * v71
    v77 = v75 * v76
    v78 = v77 / R
    v79 = v75 > 0.0
    v80 = v75 < xp.inf
    v81 = v79 & v80
    v82 = v75 ** 2.0
    v83 = 2.0 * v82
    v84 = v83 + v6
    v85 = v2 * v84
    v86 = v85 * v76
    v87 = F - v86
    v88 = v0 * v75
    v89 = v87 / v88
    v90 = xp.where(v81, v89, 0.0)
    v91 = v78 + v90
    return v91


def displacement(xp, r, a, R, b):
    nodes, weights = nodes_along(xp, 64, r, a, R, b)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r > v2
    v4 = xp.where(v3, r, 2.0 * v2)
    v5 = v2 > b
    v6 = xp.where(v5, v2, 2.0 * b)
    v7 = v4 - b
    v8 = xp.maximum(v7, 0.0)
    v9 = v4 + b
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v6 - b
    v13 = xp.maximum(v12, 0.0)
    v14 = v6 + b
    v15 = v13 * v14
    v16 = xp.sqrt(v15)
    v17 = v4 - v6
    v18 = xp.maximum(v17, 0.0)
    v19 = v4 + v6
    v20 = v18 * v19
    v21 = xp.sqrt(v20)
    v22 = v16 / v21
    v23 = b / v4
    v24 = v22 / v23
    v25 = xp.arcsinh(v24)
    v26 = nodes * v25
    v27 = -v26
    v28 = xp.exp(v27)
    v29 = v25 - v26
    v30 = (-2.0) * v29
    v31 = xp.expm1(v30)
    v32 = 0.0 - v31
    v33 = v28 * v32
    v34 = (-2.0) * v25
    v35 = xp.expm1(v34)
    v36 = 0.0 - v35
    v37 = v36 > 0.0
    v38 = xp.where(v37, v36, xp.inf)
    v39 = v33 / v38
    v40 = v22 * v39
    v41 = v11 * v40
    v42 = v40 * v40
    v43 = 1.0 + v42
    v44 = xp.sqrt(v43)
    v45 = v41 / v44
    v46 = 2.0 * v45
    v47 = v46 / R
    v48 = b ** 2.0
    v49 = R * v45
    v50 = v48 / v49
    v51 = v47 + v50
    v52 = v51 * v45
    v53 = b * b
    v54 = v45 * v45
    v55 = v53 + v54
    v56 = xp.sqrt(v55)
    v57 = v52 / v56
    v58 = v11 / v44
    v59 = xp.arctan2(v56, v58)
    v60 = v57 * v59
    v61 = v23 * v23
    v62 = v61 + v42
    v63 = xp.sqrt(v62)
    v64 = v44 * v44
    v65 = v64 * v44
    v66 = v63 / v65
    v67 = v60 * v66
    v68 = v25 * xp.sum(weights * v67, axis=0)
    v69 = v11 * v68
    v70 = xp.where(v5, 0.5 * b, v2)
    v71 = xp.where(v5, v69, 0.0)
    v72 = 0.6366197723675814 * v71
    v73 = xp.where(v3, 0.5 * v2, r)
    v74 = v2 - b
    v75 = v2 + b
    v76 = v74 * v75
    v77 = xp.sqrt(v76)
    v78 = v2 * v77
    v79 = v78 / R
    v80 = v73 < b
    v81 = xp.where(v80, v73, 0.5 * b)
    v82 = xp.where(v80, 2.0 * b, v73)
    v83 = v82 - b
    v84 = v82 + b
    v85 = v83 * v84
    v86 = 2.0 * R
    v87 = v85 / v86
    v88 = xp.where(v80, 0.0, v87)
    v89 = v79 - v88
    v90 = xp.where(v3, v72, v89)
    v91 = xp.where(v1, 0.5 * b, a)
    v92 = xp.where(v1, v90, xp.nan)
    return v92


def force(xp, a, R, b, E_star):
    v0 = 2.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = 2.0 * v3
    v5 = b ** 2.0
    v6 = v4 + v5
    v7 = v2 * v6
    v8 = a - b
    v9 = a + b
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v7 * v11
    return v12


def force_from_depth(xp, d, R, b, E_star):
    v0 = 2.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = b * 1.4142135623730951
    v4 = v3 * b
    v5 = v4 / R
    v6 = d / v5
    v7 = xp.log(v6)
    v8 = v7 - (-0.346583180371942)
    v9 = (-3.0) * v8
    v10 = (-1.5) * v8
    v11 = xp.maximum(v9, v10)
    v12 = v9 - v10
    v13 = xp.absolute(v12)
    v14 = -v13
    v15 = xp.exp(v14)
    v16 = xp.log1p(v15)
    v17 = v11 + v16
    v18 = v17 / (-3.0)
    v19 = xp.exp(v18)
    v20 = 1.0 + v19
    v21 = 1.0 / v20
    v22 = 1.0 - v21
    v23 = 8.200478 * v22
    v24 = v23 + (-25.52146)
    v25 = v24 * v22
    v26 = v25 + 28.05264
    v27 = v26 * v22
    v28 = v27 + (-12.15272)
    v29 = v28 * v22
    v30 = v29 + 1.353675
    v31 = v30 * v22
    v32 = v31 + 0.009062067
    v33 = v32 * v22
    v34 = v33 + 0.05914493
    v35 = v34 * v22
    v36 = v35 + 0.9996917
    v37 = v19 * v36
    v38 = xp.where(d > 0.0, d, 1.0)
    v39 = xp.minimum(v37, xp.inf)
    for _ in range(6):
        v41 = v39 * v39
        v42 = 1.0 + v41
        v43 = xp.sqrt(v42)
        v44 = b * v43
        v45 = b * v39
        v46 = v44 * v45
        v47 = v46 / R
        v48 = v45 * v45
        v49 = v48 / v44
        v50 = 2.0 * v45
        v51 = v50 / R
        v52 = b ** 2.0
        v53 = R * v45
        v54 = v52 / v53
        v55 = v51 + v54
        v56 = v49 * v55
        v57 = v56 / v47
        v58 = xp.log(v38 / v47)
        v59 = v58 / 1.0
        v60 = v58 / 2.0
        v61 = xp.minimum(xp.maximum(v58 / v57, xp.minimum(v59, v60)), xp.maximum(v59, v60))
        v62 = xp.where(v47 < xp.inf, v61, 0.0)
        v39 = xp.minimum(v39 * xp.exp(v62), xp.inf)
    v64 = xp.where(d > 0.0, v39, 0.0 * d)
    v65 = v64 * v64
    v66 = 1.0 + v65
    v67 = xp.sqrt(v66)
    v68 = b * v67
    v69 = v68 ** 2.0
    v70 = 2.0 * v69
    v71 = b ** 2.0
    v72 = v70 + v71
    v73 = v2 * v72
    v74 = b * v64
    v75 = v73 * v74
    v76 = v68 > 0.0
    v77 = v68 < xp.inf
    v78 = v76 & v77
    v79 = v0 * v68
    v80 = v68 * v74
    v81 = v80 / R
    v82 = d - v81
    v83 = v79 * v82
    v84 = xp.where(v78, v83, 0.0)
    v85 = v75 + v84
    return v85


def mean_pressure(xp, a, R, b, E_star):
    v0 = 4.0 * E_star
    v1 = 9.42477796076938 * R
    v2 = v0 / v1
    v3 = a - b
    v4 = a + b
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = v2 * v6
    v8 = 2.0 * E_star
    v9 = b ** 2.0
    v10 = v8 * v9
    v11 = v10 * v6
    v12 = a ** 2.0
    v13 = 9.42477796076938 * v12
    v14 = v13 * R
    v15 = v11 / v14
    v16 = v7 + v15
    return v16


def pressure(xp, r, a, R, b, E_star):
    nodes, weights = nodes_along(xp, 64, r, a, R, b, E_star)
    v1 = a >= b
    v2 = xp.where(v1, a, 2.0 * b)
    v3 = r < v2
    v4 = xp.where(v3, r, 0.5 * v2)
    v5 = v4 == b
    v6 = v2 > b
    v7 = v5 & v6
    v8 = E_star / 3.141592653589793
    v9 = xp.nextafter(b, xp.inf)
    v10 = xp.where(v5, v9, v4)
    v11 = xp.maximum(v10, b)
    v12 = v2 > v11
    v13 = xp.where(v12, v2, 2.0 * v11)
    v14 = v10 < b
    v15 = xp.where(v14, v10, 0.5 * b)
    v16 = v13 - b
    v17 = xp.maximum(v16, 0.0)
    v18 = v13 + b
    v19 = v17 * v18
    v20 = xp.sqrt(v19)
    v21 = xp.where(v14, 2.0 * b, v10)
    v22 = v13 - v21
    v23 = xp.maximum(v22, 0.0)
    v24 = v13 + v21
    v25 = v23 * v24
    v26 = xp.sqrt(v25)
    v27 = xp.where(v14, v20, v26)
    v28 = v10 - b
    v29 = xp.absolute(v28)
    v30 = v10 + b
    v31 = v29 * v30
    v32 = xp.sqrt(v31)
    v33 = v27 / v32
    v34 = xp.arcsinh(v33)
    v35 = nodes * v34
    v36 = v13 - b
    v37 = xp.maximum(v36, 0.0)
    v38 = v13 + b
    v39 = v37 * v38
    v40 = xp.sqrt(v39)
    v41 = -v35
    v42 = xp.exp(v41)
    v43 = xp.where(v14, v10, 0.5 * b)
    v44 = xp.where(v14, 2.0 * b, v10)
    v45 = xp.where(v14, 0.0, 1.0)
    v46 = 2.0 * v45
    v47 = 1.0 - v46
    v48 = v34 - v35
    v49 = (-2.0) * v48
    v50 = xp.expm1(v49)
    v51 = v47 * v50
    v52 = v46 - v51
    v53 = v42 * v52
    v54 = (-2.0) * v34
    v55 = xp.expm1(v54)
    v56 = v47 * v55
    v57 = v46 - v56
    v58 = v57 > 0.0
    v59 = xp.where(v58, v57, xp.inf)
    v60 = v53 / v59
    v61 = v40 * v60
    v62 = 2.0 * v61
    v63 = v62 / R
    v64 = b ** 2.0
    v65 = R * v61
    v66 = v64 / v65
    v67 = v63 + v66
    v68 = v67 * v61
    v69 = b * b
    v70 = v61 * v61
    v71 = v69 + v70
    v72 = xp.sqrt(v71)
    v73 = v68 / v72
    v74 = v34 * xp.sum(weights * v73, axis=0)
    v75 = xp.where(v12, 0.5 * v11, v2)
    v76 = xp.where(v12, v74, 0.0)
    v77 = v8 * v76
    v78 = xp.where(v7, xp.inf, v77)
    v79 = xp.where(v3, 2.0 * v2, r)
    v80 = xp.where(v3, v78, 0.0)
    v81 = xp.where(v1, 0.5 * b, a)
    v82 = xp.where(v1, v80, xp.nan)
    return v82


def profile(xp, r, R, b):
    v0 = r < b
    v1 = xp.where(v0, r, 0.5 * b)
    v2 = xp.where(v0, 2.0 * b, r)
    v3 = v2 - b
    v4 = v2 + b
    v5 = v3 * v4
    v6 = 2.0 * R
    v7 = v5 / v6
    v8 = xp.where(v0, 0.0, v7)
    return v8


def radius_from_depth(xp, d, R, b):
    v0 = b ** 2.0
    v1 = v0 ** 2.0
    v2 = R ** 2.0
    v3 = 4.0 * v2
    v4 = d ** 2.0
    v5 = v3 * v4
    v6 = v1 + v5
    v7 = xp.sqrt(v6)
    v8 = v7 / R
    v9 = v0 / R
    v10 = v8 + v9
    v11 = xp.sqrt(v10)
    v12 = 2.0 * R
    v13 = xp.sqrt(v12)
    v14 = v11 * v13
    v15 = v14 / 2.0
    return v15


def radius_from_force(xp, F, R, b, E_star):
    v0 = 2.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = b * 1.4142135623730951
    v4 = v3 ** 2.0
    v5 = 2.0 * v4
    v6 = b ** 2.0
    v7 = v5 + v6
    v8 = v2 * v7
    v9 = v8 * b
    v10 = F / v9
    v11 = xp.log(v10)
    v12 = v11 - (-0.5108256237659907)
    v13 = (-1.75) * v12
    v14 = v11 - (-0.916290731874155)
    v15 = (-0.5833333333333334) * v14
    v16 = xp.maximum(v13, v15)
    v17 = v13 - v15
    v18 = xp.absolute(v17)
    v19 = -v18
    v20 = xp.exp(v19)
    v21 = xp.log1p(v20)
    v22 = v16 + v21
    v23 = v22 / (-1.75)
    v24 = xp.exp(v23)
    v25 = 1.0 + v24
    v26 = 1.0 / v25
    v27 = 1.0 - v26
    v28 = 19.09787 * v27
    v29 = v28 + (-63.48232)
    v30 = v29 * v27
    v31 = v30 + 76.63965
    v32 = v31 * v27
    v33 = v32 + (-39.30687)
    v34 = v33 * v27
    v35 = v34 + 7.512052
    v36 = v35 * v27
    v37 = v36 + (-0.7678073)
    v38 = v37 * v27
    v39 = v38 + 0.3089073
    v40 = v39 * v27
    v41 = v40 + 0.9990587
    v42 = v24 * v41
    v43 = xp.where(F > 0.0, F, 1.0)
    v44 = xp.minimum(v42, xp.inf)
    for _ in range(6):
        v46 = v44 * v44
        v47 = 1.0 + v46
        v48 = xp.sqrt(v47)
        v49 = b * v48
        v50 = v49 ** 2.0
        v51 = 2.0 * v50
        v52 = v51 + v6
        v53 = v2 * v52
        v54 = b * v44
        v55 = v53 * v54
        v56 = v0 * v54
        v57 = v56 * v54
        v58 = 2.0 * v54
        v59 = v58 / R
        v60 = R * v54
        v61 = v6 / v60
        v62 = v59 + v61
        v63 = v57 * v62
        v64 = v63 / v55
        v65 = xp.log(v43 / v55)
        v66 = v65 / 1.0
        v67 = v65 / 3.0
        v68 = xp.minimum(xp.maximum(v65 / v64, xp.minimum(v66, v67)), xp.maximum(v66, v67))
        v69 = xp.where(v55 < xp.inf, v68, 0.0)
        v44 = xp.minimum(v44 * xp.exp(v69), xp.inf)
    v71 = xp.where(F > 0.0, v44, 0.0 * F)
    v72 = v71 * v71
    v73 = 1.0 + v72
    v74 = xp.sqrt(v73)
    v75 = b * v74
    return v75


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
