"""Formulas of axicontact.normal.cone over an array library `xp`."""


def depth(xp, a, theta):
    v0 = xp.tan(theta)
    v1 = 3.141592653589793 * v0
    v2 = v1 * a
    v3 = v2 / 2.0
    return v3


def depth_from_force(xp, F, theta, E_star):
    v0 = xp.tan(theta)
    v1 = 3.141592653589793 * v0
    v2 = 2.0 * E_star
    v3 = v1 / v2
    v4 = v3 * F
    v5 = xp.sqrt(v4)
    return v5


def displacement(xp, r, a, theta):
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
    return v21


def force(xp, a, theta, E_star):
    v0 = 3.141592653589793 * E_star
    v1 = xp.tan(theta)
    v2 = v0 * v1
    v3 = a ** 2.0
    v4 = v2 * v3
    v5 = v4 / 2.0
    return v5


def force_from_depth(xp, d, theta, E_star):
    v0 = 2.0 * E_star
    v1 = xp.tan(theta)
    v2 = 3.141592653589793 * v1
    v3 = v0 / v2
    v4 = d ** 2.0
    v5 = v3 * v4
    return v5


def mean_pressure(xp, a, theta, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = v1 / 2.0
    return v2


def pressure(xp, r, a, theta, E_star):
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
    return v14


def profile(xp, r, theta):
    v0 = xp.tan(theta)
    v1 = v0 * r
    return v1


def radius_from_depth(xp, d, theta):
    v0 = 2.0 * d
    v1 = xp.tan(theta)
    v2 = 3.141592653589793 * v1
    v3 = v0 / v2
    return v3


def radius_from_force(xp, F, theta, E_star):
    v0 = 2.0 * F
    v1 = 3.141592653589793 * E_star
    v2 = xp.tan(theta)
    v3 = v1 * v2
    v4 = v0 / v3
    v5 = xp.sqrt(v4)
    return v5


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
