"""Formulas of axicontact.graded.normal.flat_punch over an array library `xp`."""


def depth_from_force(xp, F, a, H, k):
    v0 = 2.0 * H
    v1 = 1.0 + k
    v2 = v0 / v1
    v3 = a > 0.0
    v4 = a ** k
    v5 = a * v4
    v6 = xp.where(v3, v5, 0.0)
    v7 = v2 * v6
    v8 = F / v7
    return v8


def force(xp, d, a, H, k):
    v0 = 2.0 * H
    v1 = 1.0 + k
    v2 = v0 / v1
    v3 = a > 0.0
    v4 = a ** k
    v5 = a * v4
    v6 = xp.where(v3, v5, 0.0)
    v7 = v2 * v6
    v8 = v7 * d
    return v8


def pressure(xp, r, d, a, H, k):
    v0 = d > 0.0
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = H / 3.141592653589793
    v4 = a - v2
    v5 = xp.maximum(v4, 0.0)
    v6 = a + v2
    v7 = v5 * v6
    v8 = xp.sqrt(v7)
    v9 = v8 ** k
    v10 = v3 * v9
    v11 = v10 / v8
    v12 = xp.where(v1, 2.0 * a, r)
    v13 = v12 > a
    v14 = xp.where(v13, v12, 2.0 * a)
    v15 = xp.where(v13, 0.5 * a, v12)
    v16 = xp.where(v13, 0.0, xp.inf)
    v17 = xp.where(v1, v11, v16)
    v18 = d * v17
    v19 = xp.where(v0, v18, 0.0)
    return v19


def stiffness(xp, a, H, k):
    v0 = 2.0 * H
    v1 = 1.0 + k
    v2 = v0 / v1
    v3 = a > 0.0
    v4 = a ** k
    v5 = a * v4
    v6 = xp.where(v3, v5, 0.0)
    v7 = v2 * v6
    return v7
