"""Formulas of axicontact.graded.tangential.rounded_curved_punch over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rounding_depth
from ....._programs.expressions._runtime.graded.breaks import rounding_force
from ....._programs.expressions._runtime.graded.breaks import rounding_rate
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.pressure import rounding_pressure
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.rounded_curved_punch import depth_at as graded_normal_depth_at
from ....._programs.expressions.graded.normal.rounded_curved_punch import force_at as graded_normal_force_at
from ....._programs.expressions.graded.normal.rounded_curved_punch import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.rounded_curved_punch import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, R1, R2, b, H, k, mu):
    v25, v26 = nodes_along(xp, 1, a, c, R1, R2, b, H, k, mu)
    v2 = 1.0 + k
    v12 = rounding_force(xp, c, difference_root(xp, c, b), b, k)
    v14 = rounding_force(xp, a, difference_root(xp, a, b), b, k)
    v15 = 0.25 * v14
    v16 = v12 >= v15
    v19 = xp.maximum(0.0, b)
    v20 = difference_root(xp, c, v19)
    v22 = (xp.where(v16, v12, 2.0 * v15) >= v15) & (v20 > 0.0)
    v24 = xp.where(v22, span(xp, c, a, v20), 0.0)
    v32 = v20 * xp.exp(v25 * v24)
    v33 = v32 * v32
    v35 = xp.sqrt((v19 - 0.0) * (v19 + 0.0) + v33)
    v44 = rounding_rate(xp, v35, xp.sqrt((v19 - b) * (v19 + b) + v33), b, k) * (v35 * v35 ** k)
    v49 = xp.where(v22, v24 * xp.sum(v26 * (v44 * v32 * (v32 / v35)), axis=0), 0.0)
    v10 = power_force(xp, a, 2.0, k) * gained_share(xp, c, a, 2.0 + v2) / (2.0 * R1)
    v54 = v10 + xp.where(v16, v49, v14 - xp.where(v16, 0.5 * v15, v12)) / R2
    return mu * (2.0 * H / v2) * v54


def traction(xp, r, a, c, R1, R2, b, H, k, mu):
    v23, v24 = nodes_along(xp, 1, r, a, c, R1, R2, b, H, k, mu)
    v1 = r < c
    v6 = xp.minimum(xp.where(v1, r, 0.5 * c), c)
    v11 = rounding_pressure(xp, v6, c, b, k)
    v12 = rounding_pressure(xp, v6, a, b, k)
    v13 = 0.25 * v12
    v14 = v11 >= v13
    v17 = xp.maximum(v6, b)
    v18 = difference_root(xp, c, v17)
    v20 = (xp.where(v14, v11, 2.0 * v13) >= v13) & (v18 > 0.0)
    v22 = xp.where(v20, span(xp, c, a, v18), 0.0)
    v30 = v18 * xp.exp(v23 * v22)
    v31 = v30 * v30
    v33 = xp.sqrt((v17 - 0.0) * (v17 + 0.0) + v31)
    v44 = xp.sqrt((v17 - v6) * (v17 + v6) + v31)
    v47 = rounding_rate(xp, v33, xp.sqrt((v17 - b) * (v17 + b) + v31), b, k) * (v44 ** k / v44)
    v52 = xp.where(v20, v22 * xp.sum(v24 * (v47 * v30 * (v30 / v33)), axis=0), 0.0)
    v10 = power_factor(xp, 2.0, k) * 2.0 * power_growth(xp, v6, c, a, 2.0, k) / (2.0 * R1)
    v57 = v10 + xp.where(v14, v52, v12 - xp.where(v14, 0.5 * v13, v11)) / R2
    v60 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, R1, R2, b, H, k)
    return mu * xp.where(v1, H / 3.141592653589793 * v57, v60)


def tangential_displacement(xp, a, c, R1, R2, b, H, H_x, k, mu):
    v24, v25 = nodes_along(xp, 1, a, c, R1, R2, b, H, H_x, k, mu)
    v11 = rounding_depth(xp, c, difference_root(xp, c, b), b, k)
    v13 = rounding_depth(xp, a, difference_root(xp, a, b), b, k)
    v14 = 0.25 * v13
    v15 = v11 >= v14
    v18 = xp.maximum(0.0, b)
    v19 = difference_root(xp, c, v18)
    v21 = (xp.where(v15, v11, 2.0 * v14) >= v14) & (v19 > 0.0)
    v23 = xp.where(v21, span(xp, c, a, v19), 0.0)
    v31 = v19 * xp.exp(v24 * v23)
    v32 = v31 * v31
    v34 = xp.sqrt((v18 - 0.0) * (v18 + 0.0) + v32)
    v43 = rounding_rate(xp, v34, xp.sqrt((v18 - b) * (v18 + b) + v32), b, k) * v31 * (v31 / v34)
    v45 = xp.where(v21, v23 * xp.sum(v25 * v43, axis=0), 0.0)
    v9 = power_factor(xp, 2.0, k) * a ** 2.0 * gained_share(xp, c, a, 2.0) / (2.0 * R1)
    v51 = mu * (H / H_x) * (v9 + xp.where(v15, v45, v13 - xp.where(v15, 0.5 * v14, v11)) / R2)
    return v51


def stick_radius(xp, F_x, a, R1, R2, b, H, k, mu):
    v5 = graded_normal_force_at(xp, a, difference_root(xp, a, b), R1, R2, b, H, k)
    v7 = graded_normal_radius_from_force(xp, stick_force(xp, v5, F_x, mu), R1, R2, b, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v7)


def full_slip_displacement(xp, a, R1, R2, b, H, H_x, k, mu):
    v5 = mu * (H / H_x) * graded_normal_depth_at(xp, a, difference_root(xp, a, b), R1, R2, b, k)
    return v5
