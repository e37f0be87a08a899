"""Formulas of axicontact.plane.eccentric_punch over an array library `xp`."""


def contact_width(xp, a, e):
    v0 = xp.absolute(e)
    v1 = a / 2.0
    v2 = v0 < v1
    v3 = 2.0 * a
    v4 = a - v0
    v5 = 4.0 * v4
    v6 = xp.where(v2, v3, v5)
    return v6


def pressure(xp, x, P, a, e):
    v0 = x <= a
    v1 = P > 0.0
    v2 = v0 & v1
    v3 = xp.absolute(e)
    v4 = a / 2.0
    v5 = v3 < v4
    v6 = 2.0 * e
    v7 = v6 + a
    v8 = x * v7
    v9 = a - x
    v10 = a * v9
    v11 = v8 + v10
    v12 = P * v11
    v13 = a ** 2.0
    v14 = 3.141592653589793 * v13
    v15 = a + x
    v16 = v9 * v15
    v17 = xp.sqrt(v16)
    v18 = v14 * v17
    v19 = v12 / v18
    v20 = 2.0 * v3
    v21 = v20 - a
    v22 = 2.0 * v21
    v23 = v22 - a
    v24 = -a
    v25 = v24 / 2.0
    v26 = v23 < v25
    v27 = xp.copysign(1.0, e)
    v28 = v27 * x
    v29 = a + v28
    v30 = v29 - v22
    v31 = v28 - v23
    v32 = xp.where(v26, v30, v31)
    v33 = xp.maximum(v32, 0.0)
    v34 = a - v28
    v35 = v33 / v34
    v36 = xp.sqrt(v35)
    v37 = P * v36
    v38 = a - v3
    v39 = 6.283185307179586 * v38
    v40 = v37 / v39
    v41 = xp.where(v5, v19, v40)
    v42 = xp.where(v2, v41, 0.0)
    return v42


def tilt(xp, P, a, e, E_star):
    v0 = xp.absolute(e)
    v1 = a / 2.0
    v2 = v0 < v1
    v3 = 4.0 * e
    v4 = v3 * P
    v5 = 3.141592653589793 * E_star
    v6 = a ** 2.0
    v7 = v5 * v6
    v8 = v4 / v7
    v9 = xp.copysign(1.0, e)
    v10 = a - v0
    v11 = v5 * v10
    v12 = v9 / v11
    v13 = v12 * P
    v14 = xp.where(v2, v8, v13)
    return v14
