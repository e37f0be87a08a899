"""Formulas of axicontact.normal.concave_quartic over an array library `xp`."""

from ...._programs.expressions._runtime.shapes.powers import power_punches


def profile(xp, r, a, h):
    v1 = r <= a
    v10 = xp.where(v1, 2.0 * a, r)
    v11 = xp.where(v1, -h * (xp.where(v1, r, 0.5 * a) ** 2.0) ** 2.0 / (a ** 2.0) ** 2.0, xp.nan)
    return v11


def force(xp, d, a, h, E_star):
    v3 = 4.0 * h / 3.0 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v12 = xp.where(v4, 2.0 * d, v3)
    return xp.where(v4, 2.0 * E_star * a * (d + 8.0 * h / 15.0), xp.nan)


def pressure(xp, r, d, a, h, E_star):
    v1 = 4.0 * h
    v2 = v1 / 3.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v11 = 2.0 * r
    v22 = d - v2 + v1 * (v11 - a) ** 2.0 * (a + v11) ** 2.0 / (9.0 * (a ** 2.0) ** 2.0)
    v28 = E_star / 3.141592653589793 * v22 / xp.sqrt((a - r) * (a + r))
    v30 = xp.where(v4, 2.0 * d, v3)
    return xp.where(v4, xp.where((r <= a) & (d > 0.0), v28, 0.0), xp.nan)


def displacement(xp, r, d, a, h):
    v3 = 4.0 * h / 3.0 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v6 = r > a
    v7 = xp.where(v6, r, 2.0 * a)
    v13 = d * xp.arctan2(a, xp.sqrt((v7 - a) * (v7 + a)))
    v19 = 0.6366197723675814 * (v13 + 8.0 * h / 3.0 * power_punches(xp, v7, a, 4.0))
    v24 = xp.where(v4, 2.0 * d, v3)
    v25 = xp.where(v4, xp.where(v6, v19, d - profile(xp, xp.where(v6, 0.5 * a, r), a, h)), xp.nan)
    return v25


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def minimum_force(xp, a, h, E_star):
    return 56.0 * E_star * h / 15.0 * a


def depth_from_force(xp, F, a, h, E_star):
    v2 = minimum_force(xp, a, h, E_star) * 0.999999999999999
    v3 = v2 <= F
    v4 = xp.where(v3, v2, 0.5 * F)
    v11 = xp.where(v3, 2.0 * F, v2)
    return xp.where(v3, F / (2.0 * E_star * a) - 8.0 * h / 15.0, xp.nan)


def zero_radius(xp, a):
    return a / 2.0


def minimum_depth(xp, h):
    return 4.0 * h / 3.0


def energy(xp, d, a, h, E_star):
    v3 = 4.0 * h / 3.0 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v17 = d ** 2.0 * a + 16.0 * h / 15.0 * d * a + 64.0 * h ** 2.0 / 81.0 * a
    v19 = xp.where(v4, 2.0 * d, v3)
    return xp.where(v4, E_star * v17, xp.nan)


def load_within(xp, r, d, a, h, E_star):
    v1 = 4.0 * h
    v2 = v1 / 3.0
    v3 = v2 * 0.999999999999999
    v4 = v3 <= d
    v5 = xp.where(v4, v3, 0.5 * d)
    v6 = r < a
    v7 = xp.where(v6, r, 0.5 * a)
    v15 = v7 ** 2.0 / (a + xp.sqrt((a - v7) * (a + v7)))
    v18 = a ** 2.0
    v19 = v18 ** 2.0
    v31 = v15 * (v15 * (120.0 * v18 + v15 * (16.0 * v15 - 80.0 * a)) - 40.0 * (a * v18))
    v38 = xp.where(v6, 2.0 * a, r)
    v37 = 2.0 * E_star * v15 * (d - v2 + v1 * (5.0 * v19 + v31) / (45.0 * v19))
    v41 = xp.where(v4, 2.0 * d, v3)
    return xp.where(v4, xp.where(v6, v37, force(xp, d, a, h, E_star)), xp.nan)
