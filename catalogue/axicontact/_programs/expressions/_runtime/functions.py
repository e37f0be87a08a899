"""Formulas of axicontact._runtime.functions over an array library `xp`."""


def half_tangent(xp, r, a):
    return a / (r + xp.sqrt((r - a) * (r + a)))


def beside_cone(xp, r, a):
    v1 = half_tangent(xp, r, a)
    return 2.0 * xp.arctan(v1) - v1


def lower_power(xp, x, n):
    v1 = x > 0.0
    v2 = xp.where(v1, x, 1.0)
    return xp.where(v1, v2 ** n / v2, x ** (n - 1.0))


def sine_root(xp, x, R, theta):
    v2 = R * xp.cos(theta)
    v4 = R * xp.sin(theta)
    v5 = v2 < v4
    v6 = xp.where(v5, v2, 0.5 * v4)
    v12 = xp.where(v5, 2.0 * v4, v2)
    v17 = xp.maximum(xp.where(v5, v6 * v6 - (R - x) * (R + x), (x - v4) * (x + v4)), 0.0)
    v18 = v17 > 0.0
    return xp.where(v18, xp.sqrt(xp.where(v18, v17, 1.0)), 0.0)


def lost(xp, x, y, product):
    v1 = 134217729.0 * x
    v3 = v1 - (v1 - x)
    v4 = 134217729.0 * y
    v6 = v4 - (v4 - y)
    v9 = y - v6
    v12 = x - v3
    return v3 * v6 - product + v3 * v9 + v12 * v6 + v12 * v9


def difference_of_products(xp, w, x, y, z):
    v1 = w * x
    v2 = y * z
    return v1 - v2 + (lost(xp, w, x, v1) - lost(xp, y, z, v2))
