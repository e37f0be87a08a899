"""Formulas of axicontact.normal.capped_cylinder over an array library `xp`."""


def depth_from_force(xp, F, a, R, E_star):
    v0 = 4.0 * E_star
    v1 = 3.0 * R
    v2 = v0 / v1
    v3 = a ** 2.0
    v4 = a * v3
    v5 = v2 * v4
    v6 = v5 > F
    v7 = xp.where(v6, v5, 2.0 * F)
    v8 = F ** 2.0
    v9 = 9.0 * v8
    v10 = E_star ** 2.0
    v11 = 16.0 * v10
    v12 = v11 * R
    v13 = v9 / v12
    v14 = xp.cbrt(v13)
    v15 = xp.where(v6, 0.5 * F, v5)
    v16 = 2.0 * E_star
    v17 = v16 * a
    v18 = F / v17
    v19 = v3 / v1
    v20 = v18 + v19
    v21 = xp.where(v6, v14, v20)
    return v21


def displacement(xp, r, d, a, R):
    v0 = R * d
    v1 = xp.sqrt(v0)
    v2 = xp.minimum(v1, a)
    v3 = r > v2
    v4 = xp.where(v3, r, 2.0 * v2)
    v5 = a ** 2.0
    v6 = v5 / R
    v7 = xp.minimum(d, v6)
    v8 = v2 / v4
    v9 = v4 - v2
    v10 = v4 + v2
    v11 = v9 * v10
    v12 = xp.sqrt(v11)
    v13 = v4 + v12
    v14 = v2 / v13
    v15 = v14 * v14
    v16 = (-0.7327347664453868) * v15
    v17 = v16 + (-32.15553480435792)
    v18 = v17 * v15
    v19 = v18 + (-332.23363563146734)
    v20 = v19 * v15
    v21 = v20 + (-1070.7082873491413)
    v22 = v21 * v15
    v23 = v22 + (-85.27694715374247)
    v24 = v23 * v15
    v25 = v24 + 5044.821368830373
    v26 = v25 * v15
    v27 = v26 + 8082.413158212496
    v28 = v27 * v15
    v29 = v28 + 3759.725330928701
    v30 = v29 * v15
    v31 = v30 + 0.26666666666720995
    v32 = 0.21387262524856868 * v15
    v33 = v32 + 32.12935731379798
    v34 = v33 * v15
    v35 = v34 + 746.8124983579742
    v36 = v35 * v15
    v37 = v36 + 6202.125133759036
    v38 = v37 * v15
    v39 = v38 + 23553.080984642995
    v40 = v39 * v15
    v41 = v40 + 44404.005348491315
    v42 = v41 * v15
    v43 = v42 + 40380.01430284195
    v44 = v43 * v15
    v45 = v44 + 14099.684276696918
    v46 = v45 * v15
    v47 = v46 + 1.0
    v48 = v31 / v47
    v49 = v15 * v48
    v50 = 0.6666666666666666 + v49
    v51 = v8 * v50
    v52 = v7 * v51
    v53 = a * a
    v54 = v0 - v53
    v55 = 134217729.0 * R
    v56 = v55 - R
    v57 = v55 - v56
    v58 = 134217729.0 * d
    v59 = v58 - d
    v60 = v58 - v59
    v61 = v57 * v60
    v62 = v61 - v0
    v63 = d - v60
    v64 = v57 * v63
    v65 = v62 + v64
    v66 = R - v57
    v67 = v66 * v60
    v68 = v65 + v67
    v69 = v66 * v63
    v70 = v68 + v69
    v71 = 134217729.0 * a
    v72 = v71 - a
    v73 = v71 - v72
    v74 = v73 * v73
    v75 = v74 - v53
    v76 = a - v73
    v77 = v73 * v76
    v78 = v75 + v77
    v79 = v76 * v73
    v80 = v78 + v79
    v81 = v76 * v76
    v82 = v80 + v81
    v83 = v70 - v82
    v84 = v54 + v83
    v85 = v84 / R
    v86 = v85 > 0.0
    v87 = xp.maximum(v85, 0.0)
    v88 = v4 - a
    v89 = v4 + a
    v90 = v88 * v89
    v91 = xp.sqrt(v90)
    v92 = xp.arctan2(a, v91)
    v93 = v87 * v92
    v94 = xp.where(v86, v93, 0.0)
    v95 = v52 + v94
    v96 = 0.6366197723675814 * v95
    v97 = xp.where(v3, 0.5 * v2, r)
    v98 = v97 <= a
    v99 = xp.where(v98, v97, 0.5 * a)
    v100 = v99 ** 2.0
    v101 = 2.0 * R
    v102 = v100 / v101
    v103 = xp.where(v98, 2.0 * a, v97)
    v104 = xp.where(v98, v102, xp.nan)
    v105 = d - v104
    v106 = xp.where(v3, v96, v105)
    return v106


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
