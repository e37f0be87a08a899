"""Formulas of axicontact.normal.capped_cylinder over an array library `xp`."""


def depth_from_force(xp, F, a, R, E_star):
    v0 = 4.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    v6 = v5 > F
    v7 = F ** 2.0
    v8 = 9.0 * v7
    v9 = E_star ** 2.0
    v10 = 16.0 * v9
    v11 = v10 * R
    v12 = v8 / v11
    v13 = xp.cbrt(v12)
    v14 = 2.0 * E_star
    v15 = v14 * a
    v16 = F / v15
    v17 = v3 / v1
    v18 = v16 + v17
    v19 = xp.where(v6, v13, v18)
    return v19


def displacement(xp, r, d, a, R):
    v0 = R * d
    v1 = xp.sqrt(v0)
    v2 = xp.minimum(v1, a)
    v3 = r > v2
    v4 = a ** 2.0
    v5 = v4 / R
    v6 = xp.minimum(d, v5)
    v7 = v2 / r
    v8 = r - v2
    v9 = r + v2
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = r + v11
    v13 = v2 / v12
    v14 = v13 * v13
    v15 = (-0.7327347664453868) * v14
    v16 = v15 + (-32.15553480435792)
    v17 = v16 * v14
    v18 = v17 + (-332.23363563146734)
    v19 = v18 * v14
    v20 = v19 + (-1070.7082873491413)
    v21 = v20 * v14
    v22 = v21 + (-85.27694715374247)
    v23 = v22 * v14
    v24 = v23 + 5044.821368830373
    v25 = v24 * v14
    v26 = v25 + 8082.413158212496
    v27 = v26 * v14
    v28 = v27 + 3759.725330928701
    v29 = v28 * v14
    v30 = v29 + 0.26666666666720995
    v31 = 0.21387262524856868 * v14
    v32 = v31 + 32.12935731379798
    v33 = v32 * v14
    v34 = v33 + 746.8124983579742
    v35 = v34 * v14
    v36 = v35 + 6202.125133759036
    v37 = v36 * v14
    v38 = v37 + 23553.080984642995
    v39 = v38 * v14
    v40 = v39 + 44404.005348491315
    v41 = v40 * v14
    v42 = v41 + 40380.01430284195
    v43 = v42 * v14
    v44 = v43 + 14099.684276696918
    v45 = v44 * v14
    v46 = v45 + 1.0
    v47 = v30 / v46
    v48 = v14 * v47
    v49 = 0.6666666666666666 + v48
    v50 = v7 * v49
    v51 = v6 * v50
    v52 = a * a
    v53 = v0 - v52
    v54 = 134217729.0 * R
    v55 = v54 - R
    v56 = v54 - v55
    v57 = 134217729.0 * d
    v58 = v57 - d
    v59 = v57 - v58
    v60 = v56 * v59
    v61 = v60 - v0
    v62 = d - v59
    v63 = v56 * v62
    v64 = v61 + v63
    v65 = R - v56
    v66 = v65 * v59
    v67 = v64 + v66
    v68 = v65 * v62
    v69 = v67 + v68
    v70 = 134217729.0 * a
    v71 = v70 - a
    v72 = v70 - v71
    v73 = v72 * v72
    v74 = v73 - v52
    v75 = a - v72
    v76 = v72 * v75
    v77 = v74 + v76
    v78 = v75 * v72
    v79 = v77 + v78
    v80 = v75 * v75
    v81 = v79 + v80
    v82 = v69 - v81
    v83 = v53 + v82
    v84 = v83 / R
    v85 = v84 > 0.0
    v86 = xp.maximum(v84, 0.0)
    v87 = r - a
    v88 = r + a
    v89 = v87 * v88
    v90 = xp.sqrt(v89)
    v91 = xp.arctan2(a, v90)
    v92 = v86 * v91
    v93 = xp.where(v85, v92, 0.0)
    v94 = v51 + v93
    v95 = 0.6366197723675814 * v94
    v96 = r <= a
    v97 = xp.where(v96, r, 0.5 * a)
    v98 = v97 ** 2.0
    v99 = 2.0 * R
    v100 = v98 / v99
    v101 = xp.where(v96, 2.0 * a, r)
    v102 = xp.where(v96, v100, xp.nan)
    v103 = d - v102
    v104 = xp.where(v3, v95, v103)
    return v104


def force(xp, d, a, R, E_star):
    v0 = 4.0 * E_star
    v1 = v0 / 3.0
    v2 = R * d
    v3 = xp.sqrt(v2)
    v4 = xp.minimum(v3, a)
    v5 = v1 * v4
    v6 = a ** 2.0
    v7 = v6 / R
    v8 = xp.minimum(d, v7)
    v9 = v5 * v8
    v10 = 2.0 * E_star
    v11 = v10 * a
    v12 = a * a
    v13 = v2 - v12
    v14 = 134217729.0 * R
    v15 = v14 - R
    v16 = v14 - v15
    v17 = 134217729.0 * d
    v18 = v17 - d
    v19 = v17 - v18
    v20 = v16 * v19
    v21 = v20 - v2
    v22 = d - v19
    v23 = v16 * v22
    v24 = v21 + v23
    v25 = R - v16
    v26 = v25 * v19
    v27 = v24 + v26
    v28 = v25 * v22
    v29 = v27 + v28
    v30 = 134217729.0 * a
    v31 = v30 - a
    v32 = v30 - v31
    v33 = v32 * v32
    v34 = v33 - v12
    v35 = a - v32
    v36 = v32 * v35
    v37 = v34 + v36
    v38 = v35 * v32
    v39 = v37 + v38
    v40 = v35 * v35
    v41 = v39 + v40
    v42 = v29 - v41
    v43 = v13 + v42
    v44 = v43 / R
    v45 = xp.maximum(v44, 0.0)
    v46 = v11 * v45
    v47 = v9 + v46
    return v47


def pressure(xp, r, d, a, R, E_star):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = 2.0 * E_star
    v3 = R * d
    v4 = a * a
    v5 = v3 - v4
    v6 = 134217729.0 * R
    v7 = v6 - R
    v8 = v6 - v7
    v9 = 134217729.0 * d
    v10 = v9 - d
    v11 = v9 - v10
    v12 = v8 * v11
    v13 = v12 - v3
    v14 = d - v11
    v15 = v8 * v14
    v16 = v13 + v15
    v17 = R - v8
    v18 = v17 * v11
    v19 = v16 + v18
    v20 = v17 * v14
    v21 = v19 + v20
    v22 = 134217729.0 * a
    v23 = v22 - a
    v24 = v22 - v23
    v25 = v24 * v24
    v26 = v25 - v4
    v27 = a - v24
    v28 = v24 * v27
    v29 = v26 + v28
    v30 = v27 * v24
    v31 = v29 + v30
    v32 = v27 * v27
    v33 = v31 + v32
    v34 = v21 - v33
    v35 = v5 + v34
    v36 = v35 / R
    v37 = v36 > 0.0
    v38 = a - v1
    v39 = a + v1
    v40 = v38 * v39
    v41 = v1 * v1
    v42 = v3 - v41
    v43 = 134217729.0 * v1
    v44 = v43 - v1
    v45 = v43 - v44
    v46 = v45 * v45
    v47 = v46 - v41
    v48 = v1 - v45
    v49 = v45 * v48
    v50 = v47 + v49
    v51 = v48 * v45
    v52 = v50 + v51
    v53 = v48 * v48
    v54 = v52 + v53
    v55 = v21 - v54
    v56 = v42 + v55
    v57 = xp.where(v37, v40, v56)
    v58 = xp.maximum(v57, 0.0)
    v59 = xp.sqrt(v58)
    v60 = v2 * v59
    v61 = 3.141592653589793 * R
    v62 = v60 / v61
    v63 = E_star / 3.141592653589793
    v64 = v63 * v36
    v65 = xp.sqrt(v40)
    v66 = v64 / v65
    v67 = xp.where(v37, v66, 0.0)
    v68 = v62 + v67
    v69 = xp.where(v0, 2.0 * a, r)
    v70 = xp.where(v0, v68, 0.0)
    return v70


def profile(xp, r, a, R):
    v0 = r <= a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = v1 ** 2.0
    v3 = 2.0 * R
    v4 = v2 / v3
    v5 = xp.where(v0, 2.0 * a, r)
    v6 = xp.where(v0, v4, xp.nan)
    return v6


def stiffness(xp, d, a, R, E_star):
    v0 = 2.0 * E_star
    v1 = R * d
    v2 = xp.sqrt(v1)
    v3 = xp.minimum(v2, a)
    v4 = v0 * v3
    return v4
