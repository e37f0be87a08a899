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
    v21, v22 = nodes_along(xp, 1, a, c, R, b, H, k, mu)
    v1 = c >= b
    v2 = xp.where(v1, c, 2.0 * b)
    v8 = rounding_force(xp, v2, difference_root(xp, v2, b), b, k)
    v10 = rounding_force(xp, a, difference_root(xp, a, b), b, k)
    v11 = 0.25 * v10
    v12 = v8 >= v11
    v15 = xp.maximum(0.0, b)
    v16 = difference_root(xp, v2, v15)
    v18 = (xp.where(v12, v8, 2.0 * v11) >= v11) & (v16 > 0.0)
    v20 = xp.where(v18, span(xp, v2, a, v16), 0.0)
    v28 = v16 * xp.exp(v21 * v20)
    v29 = v28 * v28
    v31 = xp.sqrt((v15 - 0.0) * (v15 + 0.0) + v29)
    v40 = rounding_rate(xp, v31, xp.sqrt((v15 - b) * (v15 + b) + v29), b, k) * (v31 * v31 ** k)
    v45 = xp.where(v18, v20 * xp.sum(v22 * (v40 * v28 * (v28 / v31)), axis=0), 0.0)
    v51 = xp.where(v1, 0.5 * b, c)
    v50 = mu * (2.0 * H / (1.0 + k)) * (xp.where(v12, v45, v10 - xp.where(v12, 0.5 * v11, v8)) / R)
    return xp.where(v1, v50, xp.nan)


def traction(xp, r, a, c, R, b, H, k, mu):
    v19, v20 = nodes_along(xp, 1, r, a, c, R, b, H, k, mu)
    v1 = c >= b
    v2 = xp.where(v1, c, 2.0 * b)
    v3 = r < v2
    v6 = xp.minimum(xp.where(v3, r, 0.5 * v2), v2)
    v7 = rounding_pressure(xp, v6, v2, b, k)
    v8 = rounding_pressure(xp, v6, a, b, k)
    v9 = 0.25 * v8
    v10 = v7 >= v9
    v13 = xp.maximum(v6, b)
    v14 = difference_root(xp, v2, v13)
    v16 = (xp.where(v10, v7, 2.0 * v9) >= v9) & (v14 > 0.0)
    v18 = xp.where(v16, span(xp, v2, a, v14), 0.0)
    v26 = v14 * xp.exp(v19 * v18)
    v27 = v26 * v26
    v29 = xp.sqrt((v13 - 0.0) * (v13 + 0.0) + v27)
    v40 = xp.sqrt((v13 - v6) * (v13 + v6) + v27)
    v43 = rounding_rate(xp, v29, xp.sqrt((v13 - b) * (v13 + b) + v27), b, k) * (v40 ** k / v40)
    v48 = xp.where(v16, v18 * xp.sum(v20 * (v43 * v26 * (v26 / v29)), axis=0), 0.0)
    v53 = H / 3.141592653589793 * (xp.where(v10, v48, v8 - xp.where(v10, 0.5 * v9, v7)) / R)
    v58 = xp.where(v1, 0.5 * b, c)
    v57 = mu * xp.where(v3, v53, graded_normal_pressure(xp, xp.where(v3, 2.0 * v2, r), a, R, b, H, k))
    return xp.where(v1, v57, xp.nan)


def tangential_displacement(xp, a, c, R, b, H, H_x, k, mu):
    v19, v20 = nodes_along(xp, 1, a, c, R, b, H, H_x, k, mu)
    v1 = c >= b
    v2 = xp.where(v1, c, 2.0 * b)
    v6 = rounding_depth(xp, v2, difference_root(xp, v2, b), b, k)
    v8 = rounding_depth(xp, a, difference_root(xp, a, b), b, k)
    v9 = 0.25 * v8
    v10 = v6 >= v9
    v13 = xp.maximum(0.0, b)
    v14 = difference_root(xp, v2, v13)
    v16 = (xp.where(v10, v6, 2.0 * v9) >= v9) & (v14 > 0.0)
    v18 = xp.where(v16, span(xp, v2, a, v14), 0.0)
    v26 = v14 * xp.exp(v19 * v18)
    v27 = v26 * v26
    v29 = xp.sqrt((v13 - 0.0) * (v13 + 0.0) + v27)
    v38 = rounding_rate(xp, v29, xp.sqrt((v13 - b) * (v13 + b) + v27), b, k) * v26 * (v26 / v29)
    v40 = xp.where(v16, v18 * xp.sum(v20 * v38, axis=0), 0.0)
    v46 = xp.where(v1, 0.5 * b, c)
    v45 = mu * (H / H_x) * (xp.where(v10, v40, v8 - xp.where(v10, 0.5 * v9, v6)) / R)
    return xp.where(v1, v45, xp.nan)


def stick_radius(xp, F_x, a, R, b, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, R, b, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, R, b, H, k))
    return v7


def full_slip_displacement(xp, a, R, b, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, R, b, k)
