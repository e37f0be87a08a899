"""Formulas of axicontact.graded.tangential.ellipsoid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import sphere_depth
from ....._programs.expressions._runtime.graded.growth import sphere_force
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.pressure import sphere
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.ellipsoid import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.ellipsoid import force as graded_normal_force
from ....._programs.expressions.graded.normal.ellipsoid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.ellipsoid import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, h, b, H, k, mu):
    v20, v21 = nodes_along(xp, 1, a, c, h, b, H, k, mu)
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v7 = difference_root(xp, c, 0.0)
    v8 = v7 > 0.0
    v12 = v8 & (v7 >= 0.25 * difference_root(xp, v2, 0.0))
    v13 = v12 & v8
    v14 = difference_root(xp, b, v2)
    v15 = difference_root(xp, b, 0.0)
    v19 = xp.where(v13, span(xp, c, v2, v7 * (v14 / v15)), 0.0)
    v26 = v7 / difference_root(xp, b, c) * xp.exp(v20 * v19)
    v29 = xp.sqrt(1.0 + v26 * v26)
    v31 = v15 * (v26 / v29)
    v34 = xp.sqrt(0.0 + v31 * v31)
    v44 = sphere_rate(xp, v34, v15 / v29, k) * (v34 * v34 ** k) * (v31 / v29) * (v31 / v34 / v29)
    v50 = sphere_force(xp, v2, v14, k) - sphere_force(xp, c, difference_root(xp, b, c), k)
    v53 = h * xp.where(v12, xp.where(v13, v19 * xp.sum(v21 * v44, axis=0), 0.0), v50) / b
    v55 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, mu * (2.0 * H / (1.0 + k)) * v53, xp.nan)


def traction(xp, r, a, c, h, b, H, k, mu):
    v20, v21 = nodes_along(xp, 1, r, a, c, h, b, H, k, mu)
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = r < c
    v6 = xp.minimum(xp.where(v3, r, 0.5 * c), c)
    v7 = difference_root(xp, c, v6)
    v8 = v7 > 0.0
    v9 = difference_root(xp, v2, v6)
    v12 = v8 & (v7 >= 0.25 * v9)
    v13 = v12 & v8
    v14 = difference_root(xp, b, v2)
    v15 = difference_root(xp, b, v6)
    v19 = xp.where(v13, span(xp, c, v2, v7 * (v14 / v15)), 0.0)
    v27 = v7 / difference_root(xp, b, c) * xp.exp(v20 * v19)
    v30 = xp.sqrt(1.0 + v27 * v27)
    v32 = v15 * (v27 / v30)
    v35 = xp.sqrt(v6 * v6 + v32 * v32)
    v45 = sphere_rate(xp, v35, v15 / v30, k) * (v32 ** k / v32) * (v32 / v30) * (v32 / v35 / v30)
    v51 = sphere(xp, v6, b, v9, v14, k) - sphere(xp, v6, b, v7, difference_root(xp, b, c), k)
    v54 = h * xp.where(v12, xp.where(v13, v19 * xp.sum(v21 * v45, axis=0), 0.0), v51) / b
    v57 = graded_normal_pressure(xp, xp.where(v3, 2.0 * c, r), v2, h, b, H, k)
    v60 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, mu * xp.where(v3, H / 3.141592653589793 * v54, v57), xp.nan)


def tangential_displacement(xp, a, c, h, b, H, H_x, k, mu):
    v18, v19 = nodes_along(xp, 1, a, c, h, b, H, H_x, k, mu)
    v1 = a <= b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = difference_root(xp, c, 0.0)
    v6 = v5 > 0.0
    v10 = v6 & (v5 >= 0.25 * difference_root(xp, v2, 0.0))
    v11 = v10 & v6
    v12 = difference_root(xp, b, v2)
    v13 = difference_root(xp, b, 0.0)
    v17 = xp.where(v11, span(xp, c, v2, v5 * (v12 / v13)), 0.0)
    v24 = v5 / difference_root(xp, b, c) * xp.exp(v18 * v17)
    v27 = xp.sqrt(1.0 + v24 * v24)
    v29 = v13 * (v24 / v27)
    v32 = xp.sqrt(0.0 + v29 * v29)
    v39 = sphere_rate(xp, v32, v13 / v27, k) * (v29 / v27) * (v29 / v32 / v27)
    v45 = sphere_depth(xp, v2, v12, k) - sphere_depth(xp, c, difference_root(xp, b, c), k)
    v48 = h * xp.where(v10, xp.where(v11, v17 * xp.sum(v19 * v39, axis=0), 0.0), v45) / b
    v50 = xp.where(v1, 2.0 * b, a)
    return xp.where(v1, mu * (H / H_x) * v48, xp.nan)


def stick_radius(xp, F_x, a, h, b, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, h, b, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, h, b, H, k))
    return v7


def full_slip_displacement(xp, a, h, b, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, h, b, k)
