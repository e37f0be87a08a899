"""Formulas of axicontact.graded.tangential.rounded_punch over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rounding_depth
from ....._programs.expressions._runtime.graded.breaks import rounding_force
from ....._programs.expressions._runtime.graded.breaks import rounding_rate
from ....._programs.expressions._runtime.graded.pressure import rounding_pressure
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.rounded_punch import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.rounded_punch import force as graded_normal_force
from ....._programs.expressions.graded.normal.rounded_punch import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.rounded_punch import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, R, b, H, k, mu):
    v17, v18 = nodes_along(xp, 1, a, c, R, b, H, k, mu)
    v1 = c >= b
    v2 = xp.where(v1, c, 2.0 * b)
    v7 = xp.maximum(0.0, b)
    v8 = difference_root(xp, v2, v7)
    v9 = v8 > 0.0
    v13 = v9 & (v8 >= 0.25 * difference_root(xp, a, v7))
    v14 = v13 & v9
    v16 = xp.where(v14, span(xp, v2, a, v8), 0.0)
    v24 = v8 * xp.exp(v17 * v16)
    v25 = v24 * v24
    v27 = xp.sqrt((v7 - 0.0) * (v7 + 0.0) + v25)
    v36 = rounding_rate(xp, v27, xp.sqrt((v7 - b) * (v7 + b) + v25), b, k) * (v27 * v27 ** k)
    v45 = rounding_force(xp, v2, difference_root(xp, v2, b), b, k)
    v41 = xp.where(v14, v16 * xp.sum(v18 * (v36 * v24 * (v24 / v27)), axis=0), 0.0)
    v48 = xp.where(v13, v41, rounding_force(xp, a, difference_root(xp, a, b), b, k) - v45) / R
    v50 = xp.where(v1, 0.5 * b, c)
    return xp.where(v1, mu * (2.0 * H / (1.0 + k)) * v48, xp.nan)


def traction(xp, r, a, c, R, b, H, k, mu):
    v17, v18 = nodes_along(xp, 1, r, a, c, R, b, H, k, mu)
    v1 = c >= b
    v2 = xp.where(v1, c, 2.0 * b)
    v3 = r < v2
    v6 = xp.minimum(xp.where(v3, r, 0.5 * v2), v2)
    v7 = xp.maximum(v6, b)
    v8 = difference_root(xp, v2, v7)
    v9 = v8 > 0.0
    v13 = v9 & (v8 >= 0.25 * difference_root(xp, a, v7))
    v14 = v13 & v9
    v16 = xp.where(v14, span(xp, v2, a, v8), 0.0)
    v24 = v8 * xp.exp(v17 * v16)
    v25 = v24 * v24
    v27 = xp.sqrt((v7 - 0.0) * (v7 + 0.0) + v25)
    v38 = xp.sqrt((v7 - v6) * (v7 + v6) + v25)
    v41 = rounding_rate(xp, v27, xp.sqrt((v7 - b) * (v7 + b) + v25), b, k) * (v38 ** k / v38)
    v46 = xp.where(v14, v16 * xp.sum(v18 * (v41 * v24 * (v24 / v27)), axis=0), 0.0)
    v50 = xp.where(v13, v46, rounding_pressure(xp, v6, a, b, k) - rounding_pressure(xp, v6, v2, b, k))
    v54 = graded_normal_pressure(xp, xp.where(v3, 2.0 * v2, r), a, R, b, H, k)
    v57 = xp.where(v1, 0.5 * b, c)
    return xp.where(v1, mu * xp.where(v3, H / 3.141592653589793 * (v50 / R), v54), xp.nan)


def tangential_displacement(xp, a, c, R, b, H, H_x, k, mu):
    v15, v16 = nodes_along(xp, 1, a, c, R, b, H, H_x, k, mu)
    v1 = c >= b
    v2 = xp.where(v1, c, 2.0 * b)
    v5 = xp.maximum(0.0, b)
    v6 = difference_root(xp, v2, v5)
    v7 = v6 > 0.0
    v11 = v7 & (v6 >= 0.25 * difference_root(xp, a, v5))
    v12 = v11 & v7
    v14 = xp.where(v12, span(xp, v2, a, v6), 0.0)
    v22 = v6 * xp.exp(v15 * v14)
    v23 = v22 * v22
    v25 = xp.sqrt((v5 - 0.0) * (v5 + 0.0) + v23)
    v34 = rounding_rate(xp, v25, xp.sqrt((v5 - b) * (v5 + b) + v23), b, k) * v22 * (v22 / v25)
    v40 = rounding_depth(xp, v2, difference_root(xp, v2, b), b, k)
    v41 = rounding_depth(xp, a, difference_root(xp, a, b), b, k) - v40
    v43 = xp.where(v11, xp.where(v12, v14 * xp.sum(v16 * v34, axis=0), 0.0), v41) / R
    v45 = xp.where(v1, 0.5 * b, c)
    return xp.where(v1, mu * (H / H_x) * v43, xp.nan)


def stick_radius(xp, F_x, a, R, b, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, R, b, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, R, b, H, k))
    return v7


def full_slip_displacement(xp, a, R, b, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, R, b, k)
