"""Formulas of axicontact.adhesive.sextic over an array library `xp`."""


def depth(xp, a, A, E_star, dgamma):
    v0 = 16.0 * A
    v1 = v0 / 5.0
    v2 = a ** 6.0
    v3 = v1 * v2
    v4 = xp.sqrt(a)
    v5 = 6.283185307179586 * dgamma
    v6 = v5 / E_star
    v7 = xp.sqrt(v6)
    v8 = v4 * v7
    v9 = v3 - v8
    return v9


def displacement(xp, r, a, A, E_star, dgamma):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = 32.0 * A
    v3 = v2 / 15.707963267948966
    v4 = a ** 6.0
    v5 = v3 * v4
    v6 = a / v1
    v7 = v1 - a
    v8 = v1 + a
    v9 = v7 * v8
    v10 = xp.sqrt(v9)
    v11 = v1 + v10
    v12 = a / v11
    v13 = v12 * v12
    v14 = (-1.2774361052403345) * v13
    v15 = v14 + (-23.178809850601194)
    v16 = v15 * v13
    v17 = v16 + (-181.92316258227586)
    v18 = v17 * v13
    v19 = v18 + (-611.3425551498234)
    v20 = v19 * v13
    v21 = v20 + (-362.00165963521414)
    v22 = v21 * v13
    v23 = v22 + 2098.825846649865
    v24 = v23 * v13
    v25 = v24 + 3992.6681072942106
    v26 = v25 * v13
    v27 = v26 + 2012.329045387071
    v28 = v27 * v13
    v29 = v28 + 0.44444444444468756
    v30 = 0.008653162919782199 * v13
    v31 = v30 + (-0.42336499735873506)
    v32 = v31 * v13
    v33 = v32 + 23.453299031698904
    v34 = v33 * v13
    v35 = v34 + 657.0260884407312
    v36 = v35 * v13
    v37 = v36 + 4128.7190564480725
    v38 = v37 * v13
    v39 = v38 + 10373.373159937977
    v40 = v39 * v13
    v41 = v40 + 11371.059137910102
    v42 = v41 * v13
    v43 = v42 + 4528.267624848188
    v44 = v43 * v13
    v45 = v44 + 1.0
    v46 = v29 / v45
    v47 = v13 * v46
    v48 = 0.8571428571428571 + v47
    v49 = v6 * v48
    v50 = v5 * v49
    v51 = xp.where(v0, 0.5 * a, r)
    v52 = 16.0 * A
    v53 = v52 / 5.0
    v54 = a ** 6.0
    v55 = v53 * v54
    v56 = v51 ** 6.0
    v57 = A * v56
    v58 = v55 - v57
    v59 = xp.where(v0, v50, v58)
    v60 = xp.sqrt(a)
    v61 = 6.283185307179586 * dgamma
    v62 = v61 / E_star
    v63 = xp.sqrt(v62)
    v64 = v60 * v63
    v65 = xp.where(v0, r, 2.0 * a)
    v66 = v65 - a
    v67 = xp.maximum(v66, 0.0)
    v68 = v65 + a
    v69 = v67 * v68
    v70 = xp.sqrt(v69)
    v71 = xp.arctan2(a, v70)
    v72 = 0.6366197723675814 * v71
    v73 = xp.where(v0, 0.5 * a, r)
    v74 = xp.where(v0, v72, 1.0)
    v75 = v64 * v74
    v76 = v59 - v75
    return v76


def force(xp, a, A, E_star, dgamma):
    v0 = 192.0 * E_star
    v1 = v0 * A
    v2 = v1 / 35.0
    v3 = a ** 7.0
    v4 = v2 * v3
    v5 = 2.0 * E_star
    v6 = v5 * a
    v7 = xp.sqrt(a)
    v8 = 6.283185307179586 * dgamma
    v9 = v8 / E_star
    v10 = xp.sqrt(v9)
    v11 = v7 * v10
    v12 = v6 * v11
    v13 = v4 - v12
    return v13


def pressure(xp, r, a, A, E_star, dgamma):
    v0 = r < a
    v1 = xp.where(v0, r, 0.5 * a)
    v2 = 32.0 * E_star
    v3 = v2 * A
    v4 = v3 / 78.53981633974483
    v5 = a ** 2.0
    v6 = v5 ** 2.0
    v7 = 3.0 * v6
    v8 = 4.0 * v5
    v9 = v1 ** 2.0
    v10 = v8 * v9
    v11 = v7 + v10
    v12 = v9 ** 2.0
    v13 = 8.0 * v12
    v14 = v11 + v13
    v15 = v4 * v14
    v16 = a - v1
    v17 = a + v1
    v18 = v16 * v17
    v19 = xp.sqrt(v18)
    v20 = v15 * v19
    v21 = xp.where(v0, 2.0 * a, r)
    v22 = xp.where(v0, v20, 0.0)
    v23 = r <= a
    v24 = xp.where(v23, r, 0.5 * a)
    v25 = xp.sqrt(a)
    v26 = 6.283185307179586 * dgamma
    v27 = v26 / E_star
    v28 = xp.sqrt(v27)
    v29 = v25 * v28
    v30 = v29 > 0.0
    v31 = E_star * v29
    v32 = a - v24
    v33 = xp.maximum(v32, 0.0)
    v34 = a + v24
    v35 = v33 * v34
    v36 = xp.sqrt(v35)
    v37 = 3.141592653589793 * v36
    v38 = v31 / v37
    v39 = xp.where(v30, v38, 0.0)
    v40 = xp.where(v23, 2.0 * a, r)
    v41 = xp.where(v23, v39, 0.0)
    v42 = v22 - v41
    return v42
