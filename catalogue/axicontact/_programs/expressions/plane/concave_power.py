"""Formulas of axicontact.plane.concave_power over an array library `xp`."""

from ...._programs.expressions._runtime.functions import lower_power
from ...._programs.expressions._runtime.shapes.powers import power_pressure
from ...._programs.expressions._runtime.shapes.powers import power_strips
from ...._programs.expressions._runtime.shapes.ring import outside_zero_pressure
from ...._programs.expressions._runtime.shapes.ring import ring_of_zero_pressure
from ...._programs.expressions._runtime.special import gamma_ratio


def profile(xp, x, a, h, n):
    v1 = x <= a
    v8 = xp.where(v1, 2.0 * a, x)
    return xp.where(v1, -h * xp.where(v1, x, 0.5 * a) ** n / a ** n, xp.nan)


def minimum_load(xp, h, n, E_star):
    v11 = 2.0 * (n * outside_zero_pressure(xp, n, 0.0) - 1.0) * gamma_ratio(xp, n / 2.0 + 0.5)
    return 1.7724538509055159 * E_star * n * h / v11


def pressure(xp, x, P, a, h, n, E_star):
    v2 = minimum_load(xp, h, n, E_star) * 0.999999999999999
    v3 = v2 <= P
    v4 = xp.where(v3, v2, 0.5 * P)
    v11 = xp.sqrt((a - x) * (a + x))
    v21 = E_star * n * h * (1.0 / v11 - n * power_pressure(xp, x, a, n) / a)
    v26 = v21 / (3.5449077018110318 * gamma_ratio(xp, (n + 1.0) / 2.0))
    v29 = xp.where(v3, 2.0 * P, v2)
    v28 = xp.where((x <= a) & (P > 0.0), P / (3.141592653589793 * v11) + v26, 0.0)
    return xp.where(v3, v28, xp.nan)


def profile_slope(xp, x, a, h, n):
    return -n * h * lower_power(xp, x, n) / a ** n


def slope(xp, x, P, a, h, n, E_star):
    v2 = minimum_load(xp, h, n, E_star) * 0.999999999999999
    v3 = v2 <= P
    v4 = xp.where(v3, v2, 0.5 * P)
    v5 = x >= a
    v6 = xp.where(v5, x, 2.0 * a)
    v7 = P > 0.0
    v14 = xp.sqrt((v6 - a) * (a + v6))
    v25 = 1.7724538509055159 * gamma_ratio(xp, (n + 1.0) / 2.0)
    v16 = -2.0 * xp.where(v7, P, 1.0) / (3.141592653589793 * E_star * v14)
    v28 = xp.where(v7, v16 + n * h * (power_strips(xp, v6, a, n) - 1.0 / v14) / v25, 0.0)
    v33 = xp.where(v3, 2.0 * P, v2)
    v32 = xp.where(v5, v28, -profile_slope(xp, xp.where(v5, 0.5 * a, x), a, h, n))
    return xp.where(v3, v32, xp.nan)


def depth(xp, L, P, a, h, n, E_star):
    v2 = minimum_load(xp, h, n, E_star) * 0.999999999999999
    v3 = v2 <= P
    v4 = xp.where(v3, v2, 0.5 * P)
    v5 = a <= L
    v6 = xp.where(v5, a, 0.5 * L)
    v8 = L - v6
    v24 = 1.7724538509055159 * gamma_ratio(xp, (n + 1.0) / 2.0)
    v17 = 2.0 * P * xp.log1p((v8 + xp.sqrt(v8 * (v6 + L))) / v6) / (3.141592653589793 * E_star)
    v27 = xp.where(v5, 2.0 * L, a)
    v29 = xp.where(v3, 2.0 * P, v2)
    v28 = xp.where(v5, v17 - h * L * power_strips(xp, L, v6, n) / v24, xp.nan)
    return xp.where(v3, v28, xp.nan)


def zero_distance(xp, a, n):
    return a * ring_of_zero_pressure(xp, n, 0.0)
