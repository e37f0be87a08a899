"""Formulas of axicontact.graded.tangential.hyperboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import hyperboloid_depth
from ....._programs.expressions._runtime.graded.growth import hyperboloid_force
from ....._programs.expressions._runtime.graded.growth import hyperboloid_rate
from ....._programs.expressions._runtime.graded.pressure import hyperboloid_pressure
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.hyperboloid import force as graded_normal_force
from ....._programs.expressions.graded.normal.hyperboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.hyperboloid import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, theta, b, H, k, mu):
    v23, v24 = nodes_along(xp, 1, a, c, theta, b, H, k, mu)
    v5 = difference_root(xp, c, 0.0)
    v10 = (v5 > 0.0) & (v5 >= 0.25 * difference_root(xp, a, 0.0))
    v14 = xp.maximum(c - 0.0, 0.0) * (c + 0.0)
    v15 = v14 > 0.0
    v18 = xp.where(v15, xp.sqrt(xp.where(v15, v14, 1.0)), 0.0)
    v20 = v10 & (v18 > 0.0)
    v22 = xp.where(v20, span(xp, c, a, v18), 0.0)
    v27 = v18 * xp.exp(v23 * v22)
    v30 = xp.sqrt(0.0 + v27 * v27)
    v37 = hyperboloid_rate(xp, v30, b, k) * (v30 * v30 ** k) * v27 * (v27 / v30)
    v42 = hyperboloid_force(xp, a, b, k) - hyperboloid_force(xp, c, b, k)
    v45 = xp.where(v10, xp.where(v20, v22 * xp.sum(v24 * v37, axis=0), 0.0), v42) * xp.tan(theta)
    return mu * (2.0 * H / (1.0 + k)) * v45


def traction(xp, r, a, c, theta, b, H, k, mu):
    v17, v18 = nodes_along(xp, 1, r, a, c, theta, b, H, k, mu)
    v1 = r < c
    v4 = xp.minimum(xp.where(v1, r, 0.5 * c), c)
    v5 = difference_root(xp, c, v4)
    v10 = (v5 > 0.0) & (v5 >= 0.25 * difference_root(xp, a, v4))
    v11 = xp.maximum(v4, 0.0)
    v12 = difference_root(xp, c, v11)
    v14 = v10 & (v12 > 0.0)
    v16 = xp.where(v14, span(xp, c, a, v12), 0.0)
    v24 = v12 * xp.exp(v17 * v16)
    v25 = v24 * v24
    v27 = xp.sqrt((v11 - 0.0) * (v11 + 0.0) + v25)
    v33 = xp.sqrt((v11 - v4) * (v11 + v4) + v25)
    v39 = hyperboloid_rate(xp, v27, b, k) * (v33 ** k / v33) * v24 * (v24 / v27)
    v44 = hyperboloid_pressure(xp, v4, a, b, k) - hyperboloid_pressure(xp, v4, c, b, k)
    v47 = xp.where(v10, xp.where(v14, v16 * xp.sum(v18 * v39, axis=0), 0.0), v44) * xp.tan(theta)
    v50 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, theta, b, H, k)
    return mu * xp.where(v1, H / 3.141592653589793 * v47, v50)


def tangential_displacement(xp, a, c, theta, b, H, H_x, k, mu):
    v21, v22 = nodes_along(xp, 1, a, c, theta, b, H, H_x, k, mu)
    v3 = difference_root(xp, c, 0.0)
    v8 = (v3 > 0.0) & (v3 >= 0.25 * difference_root(xp, a, 0.0))
    v12 = xp.maximum(c - 0.0, 0.0) * (c + 0.0)
    v13 = v12 > 0.0
    v16 = xp.where(v13, xp.sqrt(xp.where(v13, v12, 1.0)), 0.0)
    v18 = v8 & (v16 > 0.0)
    v20 = xp.where(v18, span(xp, c, a, v16), 0.0)
    v25 = v16 * xp.exp(v21 * v20)
    v28 = xp.sqrt(0.0 + v25 * v25)
    v33 = v20 * xp.sum(v22 * (hyperboloid_rate(xp, v28, b, k) * v25 * (v25 / v28)), axis=0)
    v37 = hyperboloid_depth(xp, a, b, k) - hyperboloid_depth(xp, c, b, k)
    return mu * (H / H_x) * (xp.where(v8, xp.where(v18, v33, 0.0), v37) * xp.tan(theta))


def stick_radius(xp, F_x, a, theta, b, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, theta, b, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, theta, b, H, k))
    return v7


def full_slip_displacement(xp, a, theta, b, H, H_x, k, mu):
    return mu * (H / H_x) * (hyperboloid_depth(xp, a, b, k) * xp.tan(theta))
