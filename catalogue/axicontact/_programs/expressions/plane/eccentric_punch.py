"""Formulas of axicontact.plane.eccentric_punch over an array library `xp`."""


def pressure(xp, x, P, a, e):
    v4 = xp.absolute(e)
    v5 = a / 2.0
    v6 = v4 < v5
    v7 = xp.where(v6, v4, 0.5 * v5)
    v11 = a - x
    v20 = 3.141592653589793 * a ** 2.0 * xp.sqrt(v11 * (a + x))
    v22 = xp.where(v6, 2.0 * v5, v4)
    v25 = 2.0 * (2.0 * v22 - a)
    v26 = v25 - a
    v28 = -a / 2.0
    v29 = v26 < v28
    v30 = xp.where(v29, v26, 0.5 * v28)
    v38 = xp.copysign(1.0, e) * x - xp.where(v29, 2.0 * v28, v26)
    v40 = xp.maximum(xp.where(v29, a + xp.copysign(1.0, e) * x - v25, v38), 0.0)
    v44 = v40 / (a - xp.copysign(1.0, e) * x)
    v45 = v44 > 0.0
    v52 = P * xp.where(v45, xp.sqrt(xp.where(v45, v44, 1.0)), 0.0) / (6.283185307179586 * (a - v22))
    v53 = xp.where(v6, P * (x * (2.0 * e + a) + a * v11) / v20, v52)
    return xp.where((x <= a) & (P > 0.0), v53, 0.0)


def tilt(xp, P, a, e, E_star):
    v1 = xp.absolute(e)
    v2 = a / 2.0
    v3 = v1 < v2
    v4 = xp.where(v3, v1, 0.5 * v2)
    v17 = xp.copysign(1.0, e) / (3.141592653589793 * E_star * (a - xp.where(v3, 2.0 * v2, v1))) * P
    return xp.where(v3, 4.0 * e * P / (3.141592653589793 * E_star * a ** 2.0), v17)


def contact_width(xp, a, e):
    v1 = xp.absolute(e)
    v2 = a / 2.0
    v3 = v1 < v2
    v4 = xp.where(v3, v1, 0.5 * v2)
    return xp.where(v3, 2.0 * a, 4.0 * (a - xp.where(v3, 2.0 * v2, v1)))
