"""Formulas of axicontact.graded.tangential.truncated_cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import flank_depth
from ....._programs.expressions._runtime.graded.breaks import flank_force
from ....._programs.expressions._runtime.graded.breaks import flank_rate
from ....._programs.expressions._runtime.graded.pressure import flank_pressure
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.truncated_cone import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.truncated_cone import force as graded_normal_force
from ....._programs.expressions.graded.normal.truncated_cone import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.truncated_cone import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, theta, b, H, k, mu):
    v17, v18 = nodes_along(xp, 1, a, c, theta, b, H, k, mu)
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
    v37 = flank_rate(xp, v27, xp.sqrt((v7 - b) * (v7 + b) + v25), b, k) * (v27 * v27 ** k) * v24
    v45 = flank_force(xp, v2, difference_root(xp, v2, b), b, k)
    v41 = xp.where(v14, v16 * xp.sum(v18 * (v37 * (v24 / v27)), axis=0), 0.0)
    v47 = xp.where(v13, v41, flank_force(xp, a, difference_root(xp, a, b), b, k) - v45)
    v51 = xp.where(v1, 0.5 * b, c)
    return xp.where(v1, mu * (2.0 * H / (1.0 + k)) * (v47 * xp.tan(theta)), xp.nan)


def traction(xp, r, a, c, theta, b, H, k, mu):
    v17, v18 = nodes_along(xp, 1, r, a, c, theta, b, H, k, mu)
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
    v42 = flank_rate(xp, v27, xp.sqrt((v7 - b) * (v7 + b) + v25), b, k) * (v38 ** k / v38) * v24
    v49 = flank_pressure(xp, v6, a, b, k) - flank_pressure(xp, v6, v2, b, k)
    v50 = xp.where(v13, xp.where(v14, v16 * xp.sum(v18 * (v42 * (v24 / v27)), axis=0), 0.0), v49)
    v55 = graded_normal_pressure(xp, xp.where(v3, 2.0 * v2, r), a, theta, b, H, k)
    v58 = xp.where(v1, 0.5 * b, c)
    v57 = mu * xp.where(v3, H / 3.141592653589793 * (v50 * xp.tan(theta)), v55)
    return xp.where(v1, v57, xp.nan)


def tangential_displacement(xp, a, c, theta, b, H, H_x, k, mu):
    v15, v16 = nodes_along(xp, 1, a, c, theta, b, H, H_x, k, mu)
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
    v34 = flank_rate(xp, v25, xp.sqrt((v5 - b) * (v5 + b) + v23), b, k) * v22 * (v22 / v25)
    v40 = flank_depth(xp, v2, difference_root(xp, v2, b), b, k)
    v41 = flank_depth(xp, a, difference_root(xp, a, b), b, k) - v40
    v44 = xp.where(v11, xp.where(v12, v14 * xp.sum(v16 * v34, axis=0), 0.0), v41) * xp.tan(theta)
    v46 = xp.where(v1, 0.5 * b, c)
    return xp.where(v1, mu * (H / H_x) * v44, xp.nan)


def stick_radius(xp, F_x, a, theta, b, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, theta, b, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, theta, b, H, k))
    return v7


def full_slip_displacement(xp, a, theta, b, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, theta, b, k)
