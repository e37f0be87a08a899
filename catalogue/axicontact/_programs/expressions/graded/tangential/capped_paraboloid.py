"""Formulas of axicontact.graded.tangential.capped_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rim_depth
from ....._programs.expressions._runtime.graded.breaks import rim_force
from ....._programs.expressions._runtime.graded.breaks import rim_rate
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.pressure import rim_pressure
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.capped_paraboloid import depth_at as graded_normal_depth_at
from ....._programs.expressions.graded.normal.capped_paraboloid import force_at as graded_normal_force_at
from ....._programs.expressions.graded.normal.capped_paraboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.capped_paraboloid import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, R1, R2, b, H, k, mu):
    v21, v22 = nodes_along(xp, 1, a, c, R1, R2, b, H, k, mu)
    v2 = 1.0 + k
    v11 = xp.maximum(0.0, b)
    v12 = difference_root(xp, c, v11)
    v13 = v12 > 0.0
    v17 = v13 & (v12 >= 0.25 * difference_root(xp, a, v11))
    v18 = v17 & v13
    v20 = xp.where(v18, span(xp, c, a, v12), 0.0)
    v28 = v12 * xp.exp(v21 * v20)
    v29 = v28 * v28
    v31 = xp.sqrt((v11 - 0.0) * (v11 + 0.0) + v29)
    v41 = rim_rate(xp, v31, xp.sqrt((v11 - b) * (v11 + b) + v29), b, k) * (v31 * v31 ** k) * v28
    v49 = rim_force(xp, c, difference_root(xp, c, b), b, k)
    v45 = xp.where(v18, v20 * xp.sum(v22 * (v41 * (v28 / v31)), axis=0), 0.0)
    v53 = xp.where(v17, v45, rim_force(xp, a, difference_root(xp, a, b), b, k) - v49) * (R1 - R2)
    v10 = power_force(xp, a, 2.0, k) * gained_share(xp, c, a, 2.0 + v2) / (2.0 * R1)
    return mu * (2.0 * H / v2) * (v10 + v53 / (R1 * R2))


def traction(xp, r, a, c, R1, R2, b, H, k, mu):
    v21, v22 = nodes_along(xp, 1, r, a, c, R1, R2, b, H, k, mu)
    v1 = r < c
    v6 = xp.minimum(xp.where(v1, r, 0.5 * c), c)
    v11 = xp.maximum(v6, b)
    v12 = difference_root(xp, c, v11)
    v13 = v12 > 0.0
    v17 = v13 & (v12 >= 0.25 * difference_root(xp, a, v11))
    v18 = v17 & v13
    v20 = xp.where(v18, span(xp, c, a, v12), 0.0)
    v28 = v12 * xp.exp(v21 * v20)
    v29 = v28 * v28
    v31 = xp.sqrt((v11 - 0.0) * (v11 + 0.0) + v29)
    v42 = xp.sqrt((v11 - v6) * (v11 + v6) + v29)
    v46 = rim_rate(xp, v31, xp.sqrt((v11 - b) * (v11 + b) + v29), b, k) * (v42 ** k / v42) * v28
    v50 = xp.where(v18, v20 * xp.sum(v22 * (v46 * (v28 / v31)), axis=0), 0.0)
    v54 = xp.where(v17, v50, rim_pressure(xp, v6, a, b, k) - rim_pressure(xp, v6, c, b, k))
    v10 = power_factor(xp, 2.0, k) * 2.0 * power_growth(xp, v6, c, a, 2.0, k) / (2.0 * R1)
    v62 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, R1, R2, b, H, k)
    v64 = mu * xp.where(v1, H / 3.141592653589793 * (v10 + v54 * (R1 - R2) / (R1 * R2)), v62)
    return v64


def tangential_displacement(xp, a, c, R1, R2, b, H, H_x, k, mu):
    v20, v21 = nodes_along(xp, 1, a, c, R1, R2, b, H, H_x, k, mu)
    v10 = xp.maximum(0.0, b)
    v11 = difference_root(xp, c, v10)
    v12 = v11 > 0.0
    v16 = v12 & (v11 >= 0.25 * difference_root(xp, a, v10))
    v17 = v16 & v12
    v19 = xp.where(v17, span(xp, c, a, v11), 0.0)
    v27 = v11 * xp.exp(v20 * v19)
    v28 = v27 * v27
    v30 = xp.sqrt((v10 - 0.0) * (v10 + 0.0) + v28)
    v39 = rim_rate(xp, v30, xp.sqrt((v10 - b) * (v10 + b) + v28), b, k) * v27 * (v27 / v30)
    v45 = rim_depth(xp, c, difference_root(xp, c, b), b, k)
    v46 = rim_depth(xp, a, difference_root(xp, a, b), b, k) - v45
    v49 = xp.where(v16, xp.where(v17, v19 * xp.sum(v21 * v39, axis=0), 0.0), v46) * (R1 - R2)
    v9 = power_factor(xp, 2.0, k) * a ** 2.0 * gained_share(xp, c, a, 2.0) / (2.0 * R1)
    return mu * (H / H_x) * (v9 + v49 / (R1 * R2))


def stick_radius(xp, F_x, a, R1, R2, b, H, k, mu):
    v5 = graded_normal_force_at(xp, a, difference_root(xp, a, b), R1, R2, b, H, k)
    v7 = graded_normal_radius_from_force(xp, stick_force(xp, v5, F_x, mu), R1, R2, b, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v7)


def full_slip_displacement(xp, a, R1, R2, b, H, H_x, k, mu):
    v5 = mu * (H / H_x) * graded_normal_depth_at(xp, a, difference_root(xp, a, b), R1, R2, b, k)
    return v5
