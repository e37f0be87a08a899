"""Formulas of axicontact.normal.concave_power over an array library `xp`."""

from ...._programs.expressions._runtime.shapes.powers import power_pressure
from ...._programs.expressions._runtime.shapes.powers import power_punches
from ...._programs.expressions._runtime.shapes.ring import outside_zero_pressure
from ...._programs.expressions._runtime.shapes.ring import ring_of_zero_pressure
from ...._programs.expressions._runtime.special import gamma_ratio


def profile(xp, r, a, h, n):
    v1 = r <= a
    v7 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, -h * (xp.where(v1, r, 0.5 * a) / a) ** n, xp.nan)


def minimum_depth(xp, h, n):
    v5 = 1.7724538509055159 * h * gamma_ratio(xp, n / 2.0 + 0.5)
    return v5 / (n * outside_zero_pressure(xp, n, 0.0) - 1.0)


def force(xp, d, a, h, n, E_star):
    v2 = minimum_depth(xp, h, n) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v14 = d + 1.7724538509055159 * h / (n + 1.0) * gamma_ratio(xp, n / 2.0 + 0.5)
    v16 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, 2.0 * E_star * a * v14, xp.nan)


def pressure(xp, r, d, a, h, n, E_star):
    v2 = minimum_depth(xp, h, n) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v11 = xp.sqrt((a - r) * (a + r))
    v16 = gamma_ratio(xp, n / 2.0 + 0.5)
    v26 = n * h * power_pressure(xp, r, a, n) * v16 / (1.7724538509055159 * a)
    v28 = E_star * (d / (3.141592653589793 * v11) + h * v16 / (1.7724538509055159 * v11) - v26)
    v30 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, xp.where((r <= a) & (d > 0.0), v28, 0.0), xp.nan)


def displacement(xp, r, d, a, h, n):
    v2 = minimum_depth(xp, h, n) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r > a
    v6 = xp.where(v5, r, 2.0 * a)
    v18 = 2.0 * h / 1.7724538509055159 * power_punches(xp, v6, a, n)
    v14 = 2.0 * d * xp.arctan2(a, xp.sqrt((v6 - a) * (a + v6))) / 3.141592653589793
    v26 = d - profile(xp, xp.where(v5, 0.5 * a, r), a, h, n)
    v28 = xp.where(v3, 2.0 * d, v2)
    v29 = xp.where(v3, xp.where(v5, v14 + v18 * gamma_ratio(xp, n / 2.0 + 0.5), v26), xp.nan)
    return v29


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def minimum_force(xp, a, h, n, E_star):
    v4 = outside_zero_pressure(xp, n, 0.0)
    v7 = 3.5449077018110318 * E_star * n * h * (v4 + 1.0) * a
    return v7 * gamma_ratio(xp, n / 2.0 + 0.5) / ((n + 1.0) * (n * v4 - 1.0))


def depth_from_force(xp, F, a, h, n, E_star):
    v2 = minimum_force(xp, a, h, n, E_star) * 0.999999999999999
    v3 = v2 <= F
    v4 = xp.where(v3, v2, 0.5 * F)
    v14 = 1.7724538509055159 * h / (n + 1.0) * gamma_ratio(xp, n / 2.0 + 0.5)
    v16 = xp.where(v3, 2.0 * F, v2)
    return xp.where(v3, F / (2.0 * E_star * a) - v14, xp.nan)


def zero_radius(xp, a, n):
    return a * ring_of_zero_pressure(xp, n, 0.0)


def energy(xp, d, a, h, n, E_star):
    v2 = minimum_depth(xp, h, n) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v13 = gamma_ratio(xp, n / 2.0 + 0.5)
    v22 = 3.141592653589793 * h ** 2.0 / (2.0 * n + 1.0) * v13 ** 2.0
    v25 = xp.where(v3, 2.0 * d, v2)
    v24 = E_star * a * (d ** 2.0 + 3.5449077018110318 * h / (n + 1.0) * d * v13 + v22)
    return xp.where(v3, v24, xp.nan)


def load_within(xp, r, d, a, h, n, E_star):
    v2 = minimum_depth(xp, h, n) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r < a
    v6 = xp.where(v5, r, 0.5 * a)
    v11 = v6 ** 2.0
    v17 = xp.sqrt((a - v6) * (a + v6)) + a
    v26 = gamma_ratio(xp, n / 2.0 + 0.5)
    v35 = 1.7724538509055159 * n * h * power_pressure(xp, v6, a, n) * v11 * v26 / a
    v36 = 1.7724538509055159 * h * v11 * v26 / v17 - v35
    v39 = xp.where(v5, 2.0 * a, r)
    v38 = 2.0 * E_star / (n + 1.0) * (n * d * v11 / v17 + d * v11 / v17 + v36)
    v42 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, xp.where(v5, v38, force(xp, d, a, h, n, E_star)), xp.nan)
