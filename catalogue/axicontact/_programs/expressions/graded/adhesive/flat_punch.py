"""Formulas of axicontact.graded.adhesive.flat_punch over an array library `xp`."""


def pull_off_depth(xp, a, H, k, dgamma):
    v0 = a > 0.0
    v1 = 6.283185307179586 * dgamma
    v2 = v1 / H
    v3 = xp.sqrt(v2)
    v4 = xp.sqrt(a)
    v5 = v3 * v4
    v6 = -k
    v7 = a ** v6
    v8 = xp.sqrt(v7)
    v9 = v5 * v8
    v10 = xp.where(v0, v9, 0.0)
    v11 = -v10
    return v11


def pull_off_force(xp, a, H, k, dgamma):
    v0 = 2.0 * H
    v1 = 1.0 + k
    v2 = v0 / v1
    v3 = a > 0.0
    v4 = a ** k
    v5 = a * v4
    v6 = xp.where(v3, v5, 0.0)
    v7 = v2 * v6
    v8 = -v7
    v9 = 6.283185307179586 * dgamma
    v10 = v9 / H
    v11 = xp.sqrt(v10)
    v12 = xp.sqrt(a)
    v13 = v11 * v12
    v14 = -k
    v15 = a ** v14
    v16 = xp.sqrt(v15)
    v17 = v13 * v16
    v18 = xp.where(v3, v17, 0.0)
    v19 = v8 * v18
    return v19
