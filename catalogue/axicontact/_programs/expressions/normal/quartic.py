"""Formulas of axicontact.normal.quartic over an array library `xp`."""

from ...._programs.expressions._runtime.functions import half_tangent


def depth(xp, a, A):
    return 8.0 * A / 3.0 * (a ** 2.0) ** 2.0


def force(xp, a, A, E_star):
    return 64.0 * E_star * A / 15.0 * a ** 5.0


def pressure(xp, r, a, A, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v10 = 32.0 * E_star * A / 28.274333882308138 * (a ** 2.0 + 2.0 * v2 ** 2.0)
    v16 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, v10 * xp.sqrt((a - v2) * (a + v2)), 0.0)


def displacement(xp, r, a, A):
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v9 = half_tangent(xp, v2, a)
    v10 = v9 * v9
    v15 = ((-4.320959889429597 * v10 + -106.53004831006083) * v10 + -683.6776777243583) * v10
    v21 = (((v15 + -1307.862063615897) * v10 + 1123.6903304493044) * v10 + 6598.931700123421) * v10
    v31 = ((-0.06548708381580395 * v10 + 10.743349921788495) * v10 + 655.5477291446655) * v10
    v37 = (((v31 + 5580.132341984832) * v10 + 18919.75045798054) * v10 + 30703.596314182465) * v10
    v26 = ((v21 + 7450.127483097781) * v10 + 2696.481329529376) * v10 + 0.3809523809520408
    v45 = 0.8 + v10 * (v26 / (((v37 + 23803.775464413437) * v10 + 7078.863490014608) * v10 + 1.0))
    v47 = 16.0 * A / 9.42477796076938 * (a ** 2.0) ** 2.0 * (a / v2 * v45)
    v54 = xp.where(v1, v47, depth(xp, a, A) - A * (xp.where(v1, 0.5 * a, r) ** 2.0) ** 2.0)
    return v54


def radius_from_depth(xp, d, A):
    return xp.sqrt(xp.sqrt(3.0 * d / (8.0 * A)))


def radius_from_force(xp, F, A, E_star):
    v4 = 15.0 * F / (64.0 * E_star * A)
    v8 = v4 ** 0.2
    v16 = v8 + v8 * ((v4 / (v8 ** 5.0 * v8 ** 0.0) - 1.0) / 5.0)
    return xp.where((v4 > 0.0) & (v4 < xp.inf), v16, v8)


def slope(xp, t, A):
    return 32.0 * A / 3.0 * (t * t ** 2.0)


def profile(xp, r, A):
    return A * (r ** 2.0) ** 2.0


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, A, E_star):
    return 64.0 * E_star * A / 47.12388980384689 * (a * a ** 2.0)


def force_from_depth(xp, d, A, E_star):
    return 4.0 * E_star / 5.0 * d * xp.sqrt(xp.sqrt(6.0 * d / A))


def depth_from_force(xp, F, A, E_star):
    v1 = F / E_star
    v4 = (v1 > 0.0) & (v1 < xp.inf)
    v5 = v1 ** 0.2
    v15 = v1 / xp.where(v4, v5 + v5 * ((v1 / (v5 ** 5.0 * v5 ** 0.0) - 1.0) / 5.0), v5)
    v18 = 625.0 * A / 1536.0
    v22 = v18 ** 0.2
    v30 = v22 + v22 * ((v18 / (v22 ** 5.0 * v22 ** 0.0) - 1.0) / 5.0)
    return xp.where(v4, v15, v1) * xp.where((v18 > 0.0) & (v18 < xp.inf), v30, v22)


def energy(xp, a, A, E_star):
    return 2048.0 * E_star * A ** 2.0 / 405.0 * a ** 9.0


def load_within(xp, r, a, A, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v8 = v4 ** 2.0
    v10 = a ** 2.0
    v16 = xp.sqrt((a - v4) * (a + v4))
    v23 = 3.0 * v10 ** 2.0 / (v16 + a) + v10 * v16 + 2.0 * v8 * v16
    v26 = xp.where(v1, 2.0 * a, r)
    v25 = xp.where(v3, 64.0 * E_star * A / 45.0 * v8 * v23, 0.0)
    return xp.where(v1, v25, force(xp, a, A, E_star))
