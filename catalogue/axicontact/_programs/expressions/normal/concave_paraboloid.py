"""Formulas of axicontact.normal.concave_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.shapes.powers import power_punches


def profile(xp, r, a, h):
    v1 = r <= a
    v8 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, -h * xp.where(v1, r, 0.5 * a) ** 2.0 / a ** 2.0, xp.nan)


def force(xp, d, a, h, E_star):
    v1 = 2.0 * h
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v10 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, 2.0 * E_star * a * (d + v1 / 3.0), xp.nan)


def pressure(xp, r, d, a, h, E_star):
    v1 = 2.0 * h
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v16 = E_star / 3.141592653589793 * (d - v1 + 4.0 * h * r ** 2.0 / a ** 2.0)
    v23 = xp.where(v3, 2.0 * d, v2)
    v22 = xp.where((r <= a) & (d > 0.0), v16 / xp.sqrt((a - r) * (a + r)), 0.0)
    return xp.where(v3, v22, xp.nan)


def displacement(xp, r, d, a, h):
    v1 = 2.0 * h
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r > a
    v6 = xp.where(v5, r, 2.0 * a)
    v15 = d * xp.arctan2(a, xp.sqrt((v6 - a) * (v6 + a))) + v1 * power_punches(xp, v6, a, 2.0)
    v21 = xp.where(v3, 2.0 * d, v2)
    v20 = xp.where(v5, 0.6366197723675814 * v15, d - profile(xp, xp.where(v5, 0.5 * a, r), a, h))
    return xp.where(v3, v20, xp.nan)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def minimum_force(xp, a, h, E_star):
    return 16.0 * E_star * h / 3.0 * a


def depth_from_force(xp, F, a, h, E_star):
    v2 = minimum_force(xp, a, h, E_star) * 0.999999999999999
    v3 = v2 <= F
    v4 = xp.where(v3, v2, 0.5 * F)
    v11 = xp.where(v3, 2.0 * F, v2)
    return xp.where(v3, F / (2.0 * E_star * a) - 2.0 * h / 3.0, xp.nan)


def zero_radius(xp):
    return 0.0


def minimum_depth(xp, h):
    return 2.0 * h


def energy(xp, d, a, h, E_star):
    v2 = 2.0 * h * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v18 = xp.where(v3, 2.0 * d, v2)
    v17 = E_star * (d ** 2.0 * a + 4.0 * h / 3.0 * d * a + 4.0 * h ** 2.0 / 5.0 * a)
    return xp.where(v3, v17, xp.nan)


def load_within(xp, r, d, a, h, E_star):
    v1 = 2.0 * h
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r < a
    v6 = xp.where(v5, r, 0.5 * a)
    v12 = xp.sqrt((a - v6) * (a + v6))
    v14 = v6 ** 2.0 / (a + v12)
    v25 = d - v1 + 4.0 * h * v14 * (v12 + 2.0 * a) / (3.0 * a ** 2.0)
    v27 = xp.where(v5, 2.0 * a, r)
    v30 = xp.where(v3, 2.0 * d, v2)
    v31 = xp.where(v3, xp.where(v5, 2.0 * E_star * v14 * v25, force(xp, d, a, h, E_star)), xp.nan)
    return v31
