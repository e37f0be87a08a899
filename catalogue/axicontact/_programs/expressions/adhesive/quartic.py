"""Formulas of axicontact.adhesive.quartic over an array library `xp`."""


def depth(xp, a, A, E_star, dgamma):
    v0 = 8.0 * A
    v1 = v0 / 3.0
    v2 = a ** 2.0
    v3 = v2 ** 2.0
    v4 = v1 * v3
    v5 = xp.sqrt(a)
    v6 = 6.283185307179586 * dgamma
    v7 = v6 / E_star
    v8 = xp.sqrt(v7)
    v9 = v5 * v8
    v10 = v4 - v9
    return v10


def displacement(xp, r, a, A, E_star, dgamma):
    v0 = r > a
    v1 = xp.where(v0, r, 2.0 * a)
    v2 = 16.0 * A
    v3 = v2 / 9.42477796076938
    v4 = a ** 2.0
    v5 = v4 ** 2.0
    v6 = v3 * v5
    v7 = a / v1
    v8 = v1 - a
    v9 = v1 + a
    v10 = v8 * v9
    v11 = xp.sqrt(v10)
    v12 = v1 + v11
    v13 = a / v12
    v14 = v13 * v13
    v15 = (-4.320959889429597) * v14
    v16 = v15 + (-106.53004831006083)
    v17 = v16 * v14
    v18 = v17 + (-683.6776777243583)
    v19 = v18 * v14
    v20 = v19 + (-1307.862063615897)
    v21 = v20 * v14
    v22 = v21 + 1123.6903304493044
    v23 = v22 * v14
    v24 = v23 + 6598.931700123421
    v25 = v24 * v14
    v26 = v25 + 7450.127483097781
    v27 = v26 * v14
    v28 = v27 + 2696.481329529376
    v29 = v28 * v14
    v30 = v29 + 0.3809523809520408
    v31 = (-0.06548708381580395) * v14
    v32 = v31 + 10.743349921788495
    v33 = v32 * v14
    v34 = v33 + 655.5477291446655
    v35 = v34 * v14
    v36 = v35 + 5580.132341984832
    v37 = v36 * v14
    v38 = v37 + 18919.75045798054
    v39 = v38 * v14
    v40 = v39 + 30703.596314182465
    v41 = v40 * v14
    v42 = v41 + 23803.775464413437
    v43 = v42 * v14
    v44 = v43 + 7078.863490014608
    v45 = v44 * v14
    v46 = v45 + 1.0
    v47 = v30 / v46
    v48 = v14 * v47
    v49 = 0.8 + v48
    v50 = v7 * v49
    v51 = v6 * v50
    v52 = xp.where(v0, 0.5 * a, r)
    v53 = 8.0 * A
    v54 = v53 / 3.0
    v55 = a ** 2.0
    v56 = v55 ** 2.0
    v57 = v54 * v56
    v58 = v52 ** 2.0
    v59 = v58 ** 2.0
    v60 = A * v59
    v61 = v57 - v60
    v62 = xp.where(v0, v51, v61)
    v63 = xp.sqrt(a)
    v64 = 6.283185307179586 * dgamma
    v65 = v64 / E_star
    v66 = xp.sqrt(v65)
    v67 = v63 * v66
    v68 = xp.where(v0, r, 2.0 * a)
    v69 = v68 - a
    v70 = xp.maximum(v69, 0.0)
    v71 = v68 + a
    v72 = v70 * v71
    v73 = xp.sqrt(v72)
    v74 = xp.arctan2(a, v73)
    v75 = 0.6366197723675814 * v74
    v76 = xp.where(v0, 0.5 * a, r)
    v77 = xp.where(v0, v75, 1.0)
    v78 = v67 * v77
    v79 = v62 - v78
    return v79


def force(xp, a, A, E_star, dgamma):
    v0 = 64.0 * E_star
    v1 = v0 * A
    v2 = v1 / 15.0
    v3 = a ** 5.0
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
    v4 = v3 / 28.274333882308138
    v5 = a ** 2.0
    v6 = v1 ** 2.0
    v7 = 2.0 * v6
    v8 = v5 + v7
    v9 = v4 * v8
    v10 = a - v1
    v11 = a + v1
    v12 = v10 * v11
    v13 = xp.sqrt(v12)
    v14 = v9 * v13
    v15 = xp.where(v0, 2.0 * a, r)
    v16 = xp.where(v0, v14, 0.0)
    v17 = r <= a
    v18 = xp.where(v17, r, 0.5 * a)
    v19 = xp.sqrt(a)
    v20 = 6.283185307179586 * dgamma
    v21 = v20 / E_star
    v22 = xp.sqrt(v21)
    v23 = v19 * v22
    v24 = v23 > 0.0
    v25 = E_star * v23
    v26 = a - v18
    v27 = xp.maximum(v26, 0.0)
    v28 = a + v18
    v29 = v27 * v28
    v30 = xp.sqrt(v29)
    v31 = 3.141592653589793 * v30
    v32 = v25 / v31
    v33 = xp.where(v24, v32, 0.0)
    v34 = xp.where(v17, 2.0 * a, r)
    v35 = xp.where(v17, v33, 0.0)
    v36 = v16 - v35
    return v36
