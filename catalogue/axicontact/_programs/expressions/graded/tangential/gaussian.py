"""Formulas of axicontact.graded.tangential.gaussian over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import gaussian_depth
from ....._programs.expressions._runtime.graded.growth import gaussian_force
from ....._programs.expressions._runtime.graded.growth import gaussian_rate
from ....._programs.expressions._runtime.graded.pressure import gaussian_pressure
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.gaussian import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.gaussian import force as graded_normal_force
from ....._programs.expressions.graded.normal.gaussian import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.gaussian import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, h, s, H, k, mu):
    v27, v28 = nodes_along(xp, 1, a, c, h, s, H, k, mu)
    v2 = h * gaussian_rate(xp, a, s, k)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    v9 = difference_root(xp, c, 0.0)
    v14 = (v9 > 0.0) & (v9 >= 0.25 * difference_root(xp, a, 0.0))
    v18 = xp.maximum(c - 0.0, 0.0) * (c + 0.0)
    v19 = v18 > 0.0
    v22 = xp.where(v19, xp.sqrt(xp.where(v19, v18, 1.0)), 0.0)
    v24 = v14 & (v22 > 0.0)
    v26 = xp.where(v24, span(xp, c, a, v22), 0.0)
    v31 = v22 * xp.exp(v27 * v26)
    v34 = xp.sqrt(0.0 + v31 * v31)
    v41 = gaussian_rate(xp, v34, s, k) * (v34 * v34 ** k) * v31 * (v31 / v34)
    v46 = gaussian_force(xp, a, s, k) - gaussian_force(xp, c, s, k)
    v48 = h * xp.where(v14, xp.where(v24, v26 * xp.sum(v28 * v41, axis=0), 0.0), v46)
    return xp.where(v3, mu * (2.0 * H / (1.0 + k)) * v48, xp.nan)


def traction(xp, r, a, c, h, s, H, k, mu):
    v21, v22 = nodes_along(xp, 1, r, a, c, h, s, H, k, mu)
    v2 = h * gaussian_rate(xp, a, s, k)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    v5 = r < c
    v8 = xp.minimum(xp.where(v5, r, 0.5 * c), c)
    v9 = difference_root(xp, c, v8)
    v14 = (v9 > 0.0) & (v9 >= 0.25 * difference_root(xp, a, v8))
    v15 = xp.maximum(v8, 0.0)
    v16 = difference_root(xp, c, v15)
    v18 = v14 & (v16 > 0.0)
    v20 = xp.where(v18, span(xp, c, a, v16), 0.0)
    v28 = v16 * xp.exp(v21 * v20)
    v29 = v28 * v28
    v31 = xp.sqrt((v15 - 0.0) * (v15 + 0.0) + v29)
    v37 = xp.sqrt((v15 - v8) * (v15 + v8) + v29)
    v43 = gaussian_rate(xp, v31, s, k) * (v37 ** k / v37) * v28 * (v28 / v31)
    v48 = gaussian_pressure(xp, v8, a, s, k) - gaussian_pressure(xp, v8, c, s, k)
    v50 = h * xp.where(v14, xp.where(v18, v20 * xp.sum(v22 * v43, axis=0), 0.0), v48)
    v53 = graded_normal_pressure(xp, xp.where(v5, 2.0 * c, r), a, h, s, H, k)
    return xp.where(v3, mu * xp.where(v5, H / 3.141592653589793 * v50, v53), xp.nan)


def tangential_displacement(xp, a, c, h, s, H, H_x, k, mu):
    v25, v26 = nodes_along(xp, 1, a, c, h, s, H, H_x, k, mu)
    v2 = h * gaussian_rate(xp, a, s, k)
    v3 = v2 >= 0.0
    v4 = xp.where(v3, v2, 1.0)
    v7 = difference_root(xp, c, 0.0)
    v12 = (v7 > 0.0) & (v7 >= 0.25 * difference_root(xp, a, 0.0))
    v16 = xp.maximum(c - 0.0, 0.0) * (c + 0.0)
    v17 = v16 > 0.0
    v20 = xp.where(v17, xp.sqrt(xp.where(v17, v16, 1.0)), 0.0)
    v22 = v12 & (v20 > 0.0)
    v24 = xp.where(v22, span(xp, c, a, v20), 0.0)
    v29 = v20 * xp.exp(v25 * v24)
    v32 = xp.sqrt(0.0 + v29 * v29)
    v37 = v24 * xp.sum(v26 * (gaussian_rate(xp, v32, s, k) * v29 * (v29 / v32)), axis=0)
    v41 = gaussian_depth(xp, a, s, k) - gaussian_depth(xp, c, s, k)
    v45 = xp.where(v3, mu * (H / H_x) * (h * xp.where(v12, xp.where(v22, v37, 0.0), v41)), xp.nan)
    return v45


def stick_radius(xp, F_x, a, h, s, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, h, s, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, h, s, H, k))
    return v7


def full_slip_displacement(xp, a, h, s, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, h, s, k)
