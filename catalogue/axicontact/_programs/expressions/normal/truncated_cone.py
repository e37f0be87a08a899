"""Formulas of axicontact.normal.truncated_cone over an array library `xp`."""


def depth(xp, a, theta, b):
    v0 = xp.tan(theta)
    v1 = v0 * a
    v2 = a - b
    v3 = a + b
    v4 = v2 * v3
    v5 = xp.sqrt(v4)
    v6 = v5 / b
    v7 = xp.arctan(v6)
    v8 = v1 * v7
    return v8


def force(xp, a, theta, b, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = a ** 2.0
    v3 = a - b
    v4 = a + b
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = v6 / b
    v8 = xp.arctan(v7)
    v9 = v2 * v8
    v10 = b * v6
    v11 = v9 + v10
    v12 = v1 * v11
    return v12


def mean_pressure(xp, a, theta, b, E_star):
    v0 = xp.tan(theta)
    v1 = E_star * v0
    v2 = v1 / 3.141592653589793
    v3 = a - b
    v4 = a + b
    v5 = v3 * v4
    v6 = xp.sqrt(v5)
    v7 = v6 / b
    v8 = xp.arctan(v7)
    v9 = b * v6
    v10 = a ** 2.0
    v11 = v9 / v10
    v12 = v8 + v11
    v13 = v2 * v12
    return v13


def profile(xp, r, theta, b):
    v0 = r < b
    v1 = xp.where(v0, r, 0.5 * b)
    v2 = xp.where(v0, 2.0 * b, r)
    v3 = xp.tan(theta)
    v4 = v2 - b
    v5 = v3 * v4
    v6 = xp.where(v0, 0.0, v5)
    return v6


def stiffness(xp, a, E_star):
    v0 = 2.0 * E_star
    v1 = v0 * a
    return v1
