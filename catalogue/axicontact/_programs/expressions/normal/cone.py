"""Formulas of axicontact.normal.cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import beside_cone


def depth(xp, a, theta):
    return 3.141592653589793 * xp.tan(theta) * a / 2.0


def force(xp, a, theta, E_star):
    return 3.141592653589793 * E_star * xp.tan(theta) * a ** 2.0 / 2.0


def pressure(xp, r, a, theta, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v5 = a - v2
    v14 = xp.where(v1, 2.0 * a, r)
    v13 = E_star * xp.tan(theta) * xp.log1p((v5 + xp.sqrt(v5 * (a + v2))) / v2) / 2.0
    return xp.where(v1, v13, 0.0)


def displacement(xp, r, a, theta):
    v1 = r > a
    v6 = xp.tan(theta) * a * beside_cone(xp, xp.where(v1, r, 2.0 * a), a)
    return xp.where(v1, v6, depth(xp, a, theta) - xp.tan(theta) * xp.where(v1, 0.5 * a, r))


def radius_from_depth(xp, d, theta):
    return 2.0 * d / (3.141592653589793 * xp.tan(theta))


def radius_from_force(xp, F, theta, E_star):
    return xp.sqrt(2.0 * F / (3.141592653589793 * E_star * xp.tan(theta)))


def profile(xp, r, theta):
    return xp.tan(theta) * r


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, theta, E_star):
    return E_star * xp.tan(theta) / 2.0


def force_from_depth(xp, d, theta, E_star):
    return 2.0 * E_star / (3.141592653589793 * xp.tan(theta)) * d ** 2.0


def depth_from_force(xp, F, theta, E_star):
    return xp.sqrt(3.141592653589793 * xp.tan(theta) / (2.0 * E_star) * F)


def energy(xp, a, theta, E_star):
    return 9.869604401089358 * E_star * xp.tan(theta) ** 2.0 / 12.0 * (a * a ** 2.0)


def load_within(xp, r, a, theta, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v10 = a - v4
    v13 = xp.sqrt(v10 * (a + v4))
    v9 = 3.141592653589793 * E_star * xp.tan(theta) * v4 ** 2.0
    v23 = xp.where(v1, 2.0 * a, r)
    v22 = xp.where(v3, v9 * (a / (v13 + a) + xp.log1p((v10 + v13) / v4)) / 2.0, 0.0)
    return xp.where(v1, v22, force(xp, a, theta, E_star))
