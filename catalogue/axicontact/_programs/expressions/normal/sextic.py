"""Formulas of axicontact.normal.sextic over an array library `xp`."""

from ...._programs.expressions._runtime.functions import half_tangent


def depth(xp, a, A):
    return 16.0 * A / 5.0 * a ** 6.0


def force(xp, a, A, E_star):
    return 192.0 * E_star * A / 35.0 * a ** 7.0


def pressure(xp, r, a, A, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v6 = a ** 2.0
    v10 = v2 ** 2.0
    v15 = 3.0 * v6 ** 2.0 + 4.0 * v6 * v10 + 8.0 * v10 ** 2.0
    v22 = xp.where(v1, 2.0 * a, r)
    v21 = 32.0 * E_star * A / 78.53981633974483 * v15 * xp.sqrt((a - v2) * (a + v2))
    return xp.where(v1, v21, 0.0)


def displacement(xp, r, a, A):
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v8 = half_tangent(xp, v2, a)
    v9 = v8 * v8
    v14 = ((-1.2774361052403345 * v9 + -23.178809850601194) * v9 + -181.92316258227586) * v9
    v20 = (((v14 + -611.3425551498234) * v9 + -362.00165963521414) * v9 + 2098.825846649865) * v9
    v30 = ((0.008653162919782199 * v9 + -0.42336499735873506) * v9 + 23.453299031698904) * v9
    v36 = (((v30 + 657.0260884407312) * v9 + 4128.7190564480725) * v9 + 10373.373159937977) * v9
    v25 = ((v20 + 3992.6681072942106) * v9 + 2012.329045387071) * v9 + 0.44444444444468756
    v43 = v9 * (v25 / (((v36 + 11371.059137910102) * v9 + 4528.267624848188) * v9 + 1.0))
    v46 = 32.0 * A / 15.707963267948966 * a ** 6.0 * (a / v2 * (0.8571428571428571 + v43))
    return xp.where(v1, v46, depth(xp, a, A) - A * xp.where(v1, 0.5 * a, r) ** 6.0)


def radius_from_depth(xp, d, A):
    v3 = 5.0 * d / (16.0 * A)
    v7 = v3 ** 0.16666666666666666
    v15 = v7 + v7 * ((v3 / (v7 ** 6.0 * v7 ** 0.0) - 1.0) / 6.0)
    return xp.where((v3 > 0.0) & (v3 < xp.inf), v15, v7)


def radius_from_force(xp, F, A, E_star):
    v4 = 35.0 * F / (192.0 * E_star * A)
    v8 = v4 ** 0.14285714285714285
    v16 = v8 + v8 * ((v4 / (v8 ** 7.0 * v8 ** 0.0) - 1.0) / 7.0)
    return xp.where((v4 > 0.0) & (v4 < xp.inf), v16, v8)


def slope(xp, t, A):
    return 96.0 * A / 5.0 * t ** 5.0


def profile(xp, r, A):
    return A * r ** 6.0


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, A, E_star):
    return 192.0 * E_star * A / 109.95574287564276 * a ** 5.0


def force_from_depth(xp, d, A, E_star):
    v5 = 20.0 * d / A
    v9 = v5 ** 0.16666666666666666
    v17 = v9 + v9 * ((v5 / (v9 ** 6.0 * v9 ** 0.0) - 1.0) / 6.0)
    return 6.0 * E_star / 7.0 * d * xp.where((v5 > 0.0) & (v5 < xp.inf), v17, v9)


def depth_from_force(xp, F, A, E_star):
    v1 = F / E_star
    v4 = (v1 > 0.0) & (v1 < xp.inf)
    v5 = v1 ** 0.14285714285714285
    v15 = v1 / xp.where(v4, v5 + v5 * ((v1 / (v5 ** 7.0 * v5 ** 0.0) - 1.0) / 7.0), v5)
    v18 = 117649.0 * A / 933120.0
    v22 = v18 ** 0.14285714285714285
    v30 = v22 + v22 * ((v18 / (v22 ** 7.0 * v22 ** 0.0) - 1.0) / 7.0)
    return xp.where(v4, v15, v1) * xp.where((v18 > 0.0) & (v18 < xp.inf), v30, v22)


def energy(xp, a, A, E_star):
    return 18432.0 * E_star * A ** 2.0 / 2275.0 * a ** 13.0


def load_within(xp, r, a, A, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v8 = v4 ** 2.0
    v15 = xp.sqrt((a - v4) * (a + v4))
    v18 = a ** 2.0
    v26 = 15.0 * a ** 6.0 / (v15 + a) + 3.0 * v18 ** 2.0 * v15 + 4.0 * v18 * v8 * v15
    v33 = xp.where(v1, 2.0 * a, r)
    v32 = xp.where(v3, 64.0 * E_star * A / 175.0 * v8 * (v26 + 8.0 * v8 ** 2.0 * v15), 0.0)
    return xp.where(v1, v32, force(xp, a, A, E_star))
