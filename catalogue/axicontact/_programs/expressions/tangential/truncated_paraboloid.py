"""Formulas of axicontact.tangential.truncated_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.truncated_paraboloid import depth as normal_depth
from ...._programs.expressions.normal.truncated_paraboloid import force as normal_force
from ...._programs.expressions.normal.truncated_paraboloid import pressure as normal_pressure
from ...._programs.expressions.normal.truncated_paraboloid import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.truncated_paraboloid import slope_beyond as normal_slope_beyond
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, R, b, E_star, mu):
    v22, v23 = nodes_along(xp, 1, a, c, R, b, E_star, mu)
    v1 = normal_force(xp, c, R, b, E_star)
    v2 = normal_force(xp, a, R, b, E_star)
    v3 = 0.25 * v2
    v4 = v1 >= v3
    v8 = xp.maximum(b, c)
    v10 = (xp.where(v4, v1, 2.0 * v3) >= v3) & (a > v8)
    v12 = difference_root(xp, v8, b)
    v15 = difference_root(xp, v8, 0.0)
    v16 = gap(xp, a, v8, difference_root(xp, a, 0.0), v15)
    v20 = xp.log1p((gap(xp, a, v8, difference_root(xp, a, b), v12) + v16) / (v12 + v15))
    v21 = xp.where(v10, v20, 0.0)
    v24 = v22 * v21
    v30 = v12 * xp.cosh(v24) + v15 * xp.sinh(v24)
    v33 = xp.sqrt(b * b + v30 * v30)
    v38 = normal_slope_beyond(xp, v33, v30, R, b) * (v30 / v33) * v33 ** 2.0
    v41 = 2.0 * E_star * xp.where(v10, v21 * xp.sum(v23 * v38, axis=0), 0.0)
    return mu * xp.where(v4, v41, v2 - xp.where(v4, 0.5 * v3, v1))


def traction(xp, r, a, c, R, b, E_star, mu):
    v22, v23 = nodes_along(xp, 1, r, a, c, R, b, E_star, mu)
    v2 = normal_pressure(xp, r, c, R, b, E_star)
    v3 = normal_pressure(xp, r, a, R, b, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v8 = xp.maximum(b, c)
    v10 = v6 & (a > v8)
    v12 = difference_root(xp, v8, b)
    v15 = difference_root(xp, v8, r)
    v16 = gap(xp, a, v8, difference_root(xp, a, r), v15)
    v20 = xp.log1p((gap(xp, a, v8, difference_root(xp, a, b), v12) + v16) / (v12 + v15))
    v21 = xp.where(v10, v20, 0.0)
    v24 = v22 * v21
    v30 = v12 * xp.cosh(v24) + v15 * xp.sinh(v24)
    v33 = xp.sqrt(b * b + v30 * v30)
    v38 = normal_slope_beyond(xp, v33, v30, R, b) * (v30 / v33) * v33 ** 0.0
    v41 = E_star / 3.141592653589793 * xp.where(v10, v21 * xp.sum(v23 * v38, axis=0), 0.0)
    return mu * xp.where(v6, v41, v3 - v2)


def tangential_displacement(xp, a, c, R, b, E_star, G_star, mu):
    v23, v24 = nodes_along(xp, 1, a, c, R, b, E_star, G_star, mu)
    v3 = normal_depth(xp, c, R, b)
    v4 = normal_depth(xp, a, R, b)
    v5 = 0.25 * v4
    v6 = v3 >= v5
    v9 = xp.maximum(b, c)
    v11 = (xp.where(v6, v3, 2.0 * v5) >= v5) & (a > v9)
    v13 = difference_root(xp, v9, b)
    v16 = difference_root(xp, v9, 0.0)
    v17 = gap(xp, a, v9, difference_root(xp, a, 0.0), v16)
    v21 = xp.log1p((gap(xp, a, v9, difference_root(xp, a, b), v13) + v17) / (v13 + v16))
    v22 = xp.where(v11, v21, 0.0)
    v25 = v23 * v22
    v31 = v13 * xp.cosh(v25) + v16 * xp.sinh(v25)
    v34 = xp.sqrt(b * b + v31 * v31)
    v39 = normal_slope_beyond(xp, v34, v31, R, b) * (v31 / v34) * v34 ** 1.0
    v41 = xp.where(v11, v22 * xp.sum(v24 * v39, axis=0), 0.0)
    return mu * (E_star / G_star) * xp.where(v6, v41, v4 - xp.where(v6, 0.5 * v5, v3))


def stick_radius(xp, F_x, a, R, b, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, R, b, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, R, b, E_star))


def full_slip_displacement(xp, a, R, b, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, R, b)
