"""Formulas of axicontact.graded.tangential.sphere over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import sphere_depth
from ....._programs.expressions._runtime.graded.growth import sphere_force
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.pressure import sphere
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.sphere import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.sphere import force as graded_normal_force
from ....._programs.expressions.graded.normal.sphere import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.sphere import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, R, H, k, mu):
    v23, v24 = nodes_along(xp, 1, a, c, R, H, k, mu)
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v7 = difference_root(xp, R, c)
    v8 = sphere_force(xp, c, v7, k)
    v9 = difference_root(xp, R, v2)
    v10 = sphere_force(xp, v2, v9, k)
    v11 = 0.25 * v10
    v12 = v8 >= v11
    v15 = difference_root(xp, c, 0.0)
    v17 = (xp.where(v12, v8, 2.0 * v11) >= v11) & (v15 > 0.0)
    v18 = difference_root(xp, R, 0.0)
    v22 = xp.where(v17, span(xp, c, v2, v15 * (v9 / v18)), 0.0)
    v28 = v15 / v7 * xp.exp(v23 * v22)
    v31 = xp.sqrt(1.0 + v28 * v28)
    v33 = v18 * (v28 / v31)
    v36 = xp.sqrt(0.0 + v33 * v33)
    v46 = sphere_rate(xp, v36, v18 / v31, k) * (v36 * v36 ** k) * (v33 / v31) * (v33 / v36 / v31)
    v48 = xp.where(v17, v22 * xp.sum(v24 * v46, axis=0), 0.0)
    v53 = xp.where(v1, 2.0 * R, a)
    v52 = mu * (2.0 * H / (1.0 + k)) * xp.where(v12, v48, v10 - xp.where(v12, 0.5 * v11, v8))
    return xp.where(v1, v52, xp.nan)


def traction(xp, r, a, c, R, H, k, mu):
    v24, v25 = nodes_along(xp, 1, r, a, c, R, H, k, mu)
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v3 = r < c
    v6 = xp.minimum(xp.where(v3, r, 0.5 * c), c)
    v7 = difference_root(xp, c, v6)
    v8 = difference_root(xp, R, c)
    v9 = sphere(xp, v6, R, v7, v8, k)
    v11 = difference_root(xp, R, v2)
    v12 = sphere(xp, v6, R, difference_root(xp, v2, v6), v11, k)
    v13 = 0.25 * v12
    v14 = v9 >= v13
    v18 = (xp.where(v14, v9, 2.0 * v13) >= v13) & (v7 > 0.0)
    v19 = difference_root(xp, R, v6)
    v23 = xp.where(v18, span(xp, c, v2, v7 * (v11 / v19)), 0.0)
    v30 = v7 / v8 * xp.exp(v24 * v23)
    v33 = xp.sqrt(1.0 + v30 * v30)
    v35 = v19 * (v30 / v33)
    v38 = xp.sqrt(v6 * v6 + v35 * v35)
    v48 = sphere_rate(xp, v38, v19 / v33, k) * (v35 ** k / v35) * (v35 / v33) * (v35 / v38 / v33)
    v50 = xp.where(v18, v23 * xp.sum(v25 * v48, axis=0), 0.0)
    v54 = H / 3.141592653589793 * xp.where(v14, v50, v12 - xp.where(v14, 0.5 * v13, v9))
    v59 = xp.where(v1, 2.0 * R, a)
    v58 = mu * xp.where(v3, v54, graded_normal_pressure(xp, xp.where(v3, 2.0 * c, r), v2, R, H, k))
    return xp.where(v1, v58, xp.nan)


def tangential_displacement(xp, a, c, R, H, H_x, k, mu):
    v21, v22 = nodes_along(xp, 1, a, c, R, H, H_x, k, mu)
    v1 = a <= R
    v2 = xp.where(v1, a, 0.5 * R)
    v5 = difference_root(xp, R, c)
    v6 = sphere_depth(xp, c, v5, k)
    v7 = difference_root(xp, R, v2)
    v8 = sphere_depth(xp, v2, v7, k)
    v9 = 0.25 * v8
    v10 = v6 >= v9
    v13 = difference_root(xp, c, 0.0)
    v15 = (xp.where(v10, v6, 2.0 * v9) >= v9) & (v13 > 0.0)
    v16 = difference_root(xp, R, 0.0)
    v20 = xp.where(v15, span(xp, c, v2, v13 * (v7 / v16)), 0.0)
    v26 = v13 / v5 * xp.exp(v21 * v20)
    v29 = xp.sqrt(1.0 + v26 * v26)
    v31 = v16 * (v26 / v29)
    v34 = xp.sqrt(0.0 + v31 * v31)
    v41 = sphere_rate(xp, v34, v16 / v29, k) * (v31 / v29) * (v31 / v34 / v29)
    v43 = xp.where(v15, v20 * xp.sum(v22 * v41, axis=0), 0.0)
    v48 = xp.where(v1, 2.0 * R, a)
    v47 = mu * (H / H_x) * xp.where(v10, v43, v8 - xp.where(v10, 0.5 * v9, v6))
    return xp.where(v1, v47, xp.nan)


def stick_radius(xp, F_x, a, R, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, R, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, R, H, k))
    return v7


def full_slip_displacement(xp, a, R, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, R, k)
