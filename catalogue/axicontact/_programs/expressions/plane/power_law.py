"""Formulas of axicontact.plane.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.functions import lower_power
from ...._programs.expressions._runtime.shapes.powers import power_pressure
from ...._programs.expressions._runtime.shapes.powers import power_strips
from ...._programs.expressions._runtime.special import gamma_ratio


def profile(xp, x, A, n):
    return A * x ** n


def load(xp, a, A, n, E_star):
    v5 = 1.7724538509055159 * E_star * n * A * a ** n
    return v5 / (2.0 * gamma_ratio(xp, n / 2.0 + 0.5))


def pressure(xp, x, a, A, n, E_star):
    v1 = x < a
    v7 = E_star * n ** 2.0 * A * lower_power(xp, a, n)
    v9 = v7 * power_pressure(xp, xp.where(v1, x, 0.5 * a), a, n)
    v15 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, v9 / (3.5449077018110318 * gamma_ratio(xp, (n + 1.0) / 2.0)), 0.0)


def slope(xp, x, a, A, n):
    v1 = x > a
    v8 = -n * A * a ** n * power_strips(xp, xp.where(v1, x, 2.0 * a), a, n)
    v13 = v8 / (1.7724538509055159 * gamma_ratio(xp, (n + 1.0) / 2.0))
    return xp.where(v1, v13, -(n * A * lower_power(xp, xp.where(v1, 0.5 * a, x), n)))


def depth(xp, L, a, A, n):
    v1 = a <= L
    v2 = xp.where(v1, a, 0.5 * L)
    v3 = v2 > 0.0
    v4 = xp.where(v3, v2, 1.0)
    v9 = L - v4
    v17 = L * power_strips(xp, L, v4, n) + n * xp.log1p((v9 + xp.sqrt(v9 * (v4 + L))) / v4)
    v23 = A * v4 ** n * v17 / (1.7724538509055159 * gamma_ratio(xp, (n + 1.0) / 2.0))
    v25 = xp.where(v1, 2.0 * L, a)
    return xp.where(v1, xp.where(v3, v23, 0.0), xp.nan)


def half_width_from_load(xp, P, A, n, E_star):
    v9 = 2.0 * P * gamma_ratio(xp, n / 2.0 + 0.5) / (1.7724538509055159 * E_star * n * A)
    v13 = n + 0.0
    v15 = v9 ** (1.0 / v13)
    v23 = v15 + v15 * ((v9 / (v15 ** n * v15 ** 0.0) - 1.0) / v13)
    return xp.where((v9 > 0.0) & (v9 < xp.inf), v23, v15)
