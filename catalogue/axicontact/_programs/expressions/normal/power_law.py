"""Formulas of axicontact.normal.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.functions import lower_power
from ...._programs.expressions._runtime.shapes.powers import power_displacement
from ...._programs.expressions._runtime.shapes.powers import power_pressure
from ...._programs.expressions._runtime.special import gamma_ratio


def depth(xp, a, A, n):
    return 1.7724538509055159 * A * a ** n * gamma_ratio(xp, n / 2.0 + 0.5)


def force(xp, a, A, n, E_star):
    v8 = 3.5449077018110318 * E_star * n * A / (n + 1.0) * a * a ** n
    return v8 * gamma_ratio(xp, n / 2.0 + 0.5)


def pressure(xp, r, a, A, n, E_star):
    v1 = r < a
    v7 = E_star * n * A / 1.7724538509055159 * lower_power(xp, a, n)
    v14 = xp.where(v1, 2.0 * a, r)
    v13 = v7 * power_pressure(xp, xp.where(v1, r, 0.5 * a), a, n) * gamma_ratio(xp, n / 2.0 + 0.5)
    return xp.where(v1, v13, 0.0)


def displacement(xp, r, a, A, n):
    v1 = r > a
    v7 = power_displacement(xp, xp.where(v1, r, 2.0 * a), a, n)
    v12 = 2.0 * A / 1.7724538509055159 * a ** n * v7 * gamma_ratio(xp, n / 2.0 + 0.5)
    return xp.where(v1, v12, depth(xp, a, A, n) - A * xp.where(v1, 0.5 * a, r) ** n)


def radius_from_depth(xp, d, A, n):
    v6 = d / (1.7724538509055159 * A * gamma_ratio(xp, n / 2.0 + 0.5))
    v10 = n + 0.0
    v12 = v6 ** (1.0 / v10)
    v20 = v12 + v12 * ((v6 / (v12 ** n * v12 ** 0.0) - 1.0) / v10)
    return xp.where((v6 > 0.0) & (v6 < xp.inf), v20, v12)


def radius_from_force(xp, F, A, n, E_star):
    v1 = n + 1.0
    v10 = v1 * F / (3.5449077018110318 * E_star * n * A * gamma_ratio(xp, n / 2.0 + 0.5))
    v15 = v10 ** (1.0 / v1)
    v23 = v15 + v15 * ((v10 / (v15 ** n * v15 ** 1.0) - 1.0) / v1)
    return xp.where((v10 > 0.0) & (v10 < xp.inf), v23, v15)


def slope(xp, t, A, n):
    return 1.7724538509055159 * n * A * gamma_ratio(xp, n / 2.0 + 0.5) * t ** n / t


def profile(xp, r, A, n):
    return A * r ** n


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, A, n, E_star):
    v8 = 2.0 * E_star * n * A / (1.7724538509055159 * (n + 1.0)) * lower_power(xp, a, n)
    return v8 * gamma_ratio(xp, n / 2.0 + 0.5)


def force_from_depth(xp, d, A, n, E_star):
    v8 = gamma_ratio(xp, n / 2.0 + 0.5)
    v12 = d / (1.7724538509055159 * A * v8)
    v17 = n + 0.0
    v19 = v12 ** (1.0 / v17)
    v27 = v19 + v19 * ((v12 / (v19 ** n * v19 ** 0.0) - 1.0) / v17)
    v13 = 3.5449077018110318 * E_star * n * A / (n + 1.0) * v8 * v12
    return v13 * xp.where((v12 > 0.0) & (v12 < xp.inf), v27, v19)


def depth_from_force(xp, F, A, n, E_star):
    v4 = gamma_ratio(xp, n / 2.0 + 0.5)
    v6 = n + 1.0
    v12 = v6 * F / (3.5449077018110318 * E_star * n * A * v4)
    v15 = (v12 > 0.0) & (v12 < xp.inf)
    v17 = v12 ** (1.0 / v6)
    v27 = v12 / xp.where(v15, v17 + v17 * ((v12 / (v17 ** n * v17 ** 1.0) - 1.0) / v6), v17)
    return 1.7724538509055159 * A * v4 * xp.where(v15, v27, v12)


def energy(xp, a, A, n, E_star):
    v6 = 2.0 * n
    v11 = 6.283185307179586 * E_star * n ** 2.0 * A ** 2.0 / ((v6 + 1.0) * (n + 1.0)) * a
    return v11 * a ** v6 * gamma_ratio(xp, n / 2.0 + 0.5) ** 2.0


def load_within(xp, r, a, A, n, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v22 = 1.0 / (xp.sqrt((a - v4) * (a + v4)) + a) + power_pressure(xp, v4, a, n) / a
    v23 = 3.5449077018110318 * E_star * n * A / (n + 1.0) * a ** n * v4 ** 2.0 * v22
    v29 = xp.where(v1, 2.0 * a, r)
    v28 = xp.where(v3, v23 * gamma_ratio(xp, n / 2.0 + 0.5), 0.0)
    return xp.where(v1, v28, force(xp, a, A, n, E_star))
