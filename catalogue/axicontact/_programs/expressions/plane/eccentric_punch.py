"""Formulas of axicontact.plane.eccentric_punch over an array library `xp`."""


def contact_width(xp, a, e):
    v0 = xp.absolute(e)
    v1 = a / 2.0
    v2 = v0 < v1
    v3 = xp.where(v2, v0, 0.5 * v1)
    v4 = 2.0 * a
    v5 = xp.where(v2, 2.0 * v1, v0)
    v6 = a - v5
    v7 = 4.0 * v6
    v8 = xp.where(v2, v4, v7)
    return v8


def pressure(xp, x, P, a, e):
    v0 = x <= a
    v1 = P > 0.0
    v2 = v0 & v1
    v3 = xp.absolute(e)
    v4 = a / 2.0
    v5 = v3 < v4
    v6 = xp.where(v5, v3, 0.5 * v4)
    v7 = 2.0 * e
    v8 = v7 + a
    v9 = x * v8
    v10 = a - x
    v11 = a * v10
    v12 = v9 + v11
    v13 = P * v12
    v14 = a ** 2.0
    v15 = 3.141592653589793 * v14
    v16 = a + x
    v17 = v10 * v16
    v18 = xp.sqrt(v17)
    v19 = v15 * v18
    v20 = v13 / v19
    v21 = xp.where(v5, 2.0 * v4, v3)
    v22 = 2.0 * v21
    v23 = v22 - a
    v24 = 2.0 * v23
    v25 = v24 - a
    v26 = -a
    v27 = v26 / 2.0
    v28 = v25 < v27
    v29 = xp.where(v28, v25, 0.5 * v27)
    v30 = xp.copysign(1.0, e)
    v31 = v30 * x
    v32 = a + v31
    v33 = v32 - v24
    v34 = xp.where(v28, 2.0 * v27, v25)
    v35 = xp.copysign(1.0, e)
    v36 = v35 * x
    v37 = v36 - v34
    v38 = xp.where(v28, v33, v37)
    v39 = xp.maximum(v38, 0.0)
    v40 = xp.copysign(1.0, e)
    v41 = v40 * x
    v42 = a - v41
    v43 = v39 / v42
    v44 = xp.sqrt(v43)
    v45 = P * v44
    v46 = a - v21
    v47 = 6.283185307179586 * v46
    v48 = v45 / v47
    v49 = xp.where(v5, v20, v48)
    v50 = xp.where(v2, v49, 0.0)
    return v50


def tilt(xp, P, a, e, E_star):
    v0 = xp.absolute(e)
    v1 = a / 2.0
    v2 = v0 < v1
    v3 = xp.where(v2, v0, 0.5 * v1)
    v4 = 4.0 * e
    v5 = v4 * P
    v6 = 3.141592653589793 * E_star
    v7 = a ** 2.0
    v8 = v6 * v7
    v9 = v5 / v8
    v10 = xp.where(v2, 2.0 * v1, v0)
    v11 = xp.copysign(1.0, e)
    v12 = 3.141592653589793 * E_star
    v13 = a - v10
    v14 = v12 * v13
    v15 = v11 / v14
    v16 = v15 * P
    v17 = xp.where(v2, v9, v16)
    return v17
