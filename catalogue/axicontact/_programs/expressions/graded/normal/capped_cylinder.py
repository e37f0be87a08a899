"""Formulas of axicontact.graded.normal.capped_cylinder over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.capped_cylinder import profile


def force(xp, d, a, R, H, k):
    v7 = 2.0 * R
    v8 = power_factor(xp, 2.0, k) * a ** 2.0 / v7
    v12 = a * xp.minimum(d / v8, 1.0) ** 0.5
    v15 = 2.0 * H / (1.0 + k) * power_force(xp, v12, 2.0, k) / v7
    return v15 + xp.maximum(d - v8, 0.0) * punch_stiffness(xp, v12, H, k)


def pressure(xp, r, d, a, R, H, k):
    v4 = 2.0 * R
    v5 = power_factor(xp, 2.0, k) * a ** 2.0 / v4
    v9 = a * xp.minimum(d / v5, 1.0) ** 0.5
    v10 = r <= v9
    v11 = xp.where(v10, r, 0.5 * v9)
    v13 = xp.maximum(d - v5, 0.0)
    v14 = v13 > 0.0
    v19 = v11 < v9
    v23 = power_pressure(xp, xp.minimum(xp.where(v19, v11, 0.5 * v9), v9), v9, 2.0, k)
    v26 = xp.where(v19, 2.0 * v9, v11)
    v18 = xp.where(v14, xp.where(v14, v13, 1.0) * punch_pressure(xp, v11, v9, H, k), 0.0)
    v29 = xp.where(v10, 2.0 * v9, r)
    return xp.where(v10, v18 + xp.where(v19, H / 3.141592653589793 * v23 / v4, 0.0), 0.0)


def displacement(xp, r, d, a, R, k):
    v4 = 2.0 * R
    v5 = power_factor(xp, 2.0, k) * a ** 2.0 / v4
    v9 = a * xp.minimum(d / v5, 1.0) ** 0.5
    v14 = r > v9
    v17 = xp.where(v14, 0.5 * v9, r)
    v18 = xp.where(v14, punch_share(xp, xp.where(v14, r, 2.0 * v9), v9, k), 1.0)
    return power_displacement(xp, r, v9, 2.0, k) / v4 + xp.maximum(d - v5, 0.0) * v18


def stiffness(xp, d, a, R, H, k):
    v9 = a * xp.minimum(d / (power_factor(xp, 2.0, k) * a ** 2.0 / (2.0 * R)), 1.0) ** 0.5
    return punch_stiffness(xp, v9, H, k)


def depth_from_force(xp, F, a, R, H, k):
    v6 = 2.0 * R
    v7 = 2.0 * H / (1.0 + k) * power_force(xp, a, 2.0, k) / v6
    v8 = v7 > F
    v17 = (F / xp.where(v8, v7, 2.0 * F)) ** (2.0 / (3.0 + k))
    v26 = (F - xp.where(v8, 0.5 * F, v7)) / punch_stiffness(xp, a, H, k)
    v27 = power_factor(xp, 2.0, k) * a ** 2.0 / v6 + v26
    return xp.where(v8, power_factor(xp, 2.0, k) * a ** 2.0 / v6 * v17, v27)
