"""Formulas of axicontact.tangential.ellipsoid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.ellipsoid import depth as normal_depth
from ...._programs.expressions.normal.ellipsoid import force as normal_force
from ...._programs.expressions.normal.ellipsoid import pressure as normal_pressure
from ...._programs.expressions.normal.ellipsoid import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.ellipsoid import slope as normal_slope
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, h, b, E_star, mu):
    v26, v27 = nodes_along(xp, 1, a, c, h, b, E_star, mu)
    v1 = normal_force(xp, c, h, b, E_star)
    v2 = normal_force(xp, a, h, b, E_star)
    v3 = 0.25 * v2
    v4 = v1 >= v3
    v9 = (xp.where(v4, v1, 2.0 * v3) >= v3) & (a > c)
    v10 = difference_root(xp, b, 0.0)
    v12 = difference_root(xp, a, 0.0)
    v13 = difference_root(xp, c, 0.0)
    v16 = difference_root(xp, b, a)
    v23 = xp.log1p(2.0 * v10 * gap(xp, a, c, v12, v13) / v16 * ((v10 + v12) / (v10 + v13)) / v16)
    v25 = xp.where(v9, 0.5 * v23, 0.0)
    v28 = v26 * v25
    v29 = xp.cosh(v28)
    v31 = xp.sinh(v28)
    v37 = v10 * v29 + v13 * v31
    v38 = v10 * (v13 * v29 + v10 * v31) / v37
    v41 = xp.sqrt(0.0 + v38 * v38)
    v44 = v10 * difference_root(xp, b, c) / v37
    v51 = normal_slope(xp, v41, v44, h, b) * (v44 / v10) * (v44 / v41) * v41 ** 2.0
    v54 = 2.0 * E_star * xp.where(v9, v25 * xp.sum(v27 * v51, axis=0), 0.0)
    return mu * xp.where(v4, v54, v2 - xp.where(v4, 0.5 * v3, v1))


def traction(xp, r, a, c, h, b, E_star, mu):
    v26, v27 = nodes_along(xp, 1, r, a, c, h, b, E_star, mu)
    v2 = normal_pressure(xp, r, c, h, b, E_star)
    v3 = normal_pressure(xp, r, a, h, b, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v9 = v6 & (a > c)
    v10 = difference_root(xp, b, r)
    v12 = difference_root(xp, a, r)
    v13 = difference_root(xp, c, r)
    v16 = difference_root(xp, b, a)
    v23 = xp.log1p(2.0 * v10 * gap(xp, a, c, v12, v13) / v16 * ((v10 + v12) / (v10 + v13)) / v16)
    v25 = xp.where(v9, 0.5 * v23, 0.0)
    v28 = v26 * v25
    v30 = xp.cosh(v28)
    v32 = xp.sinh(v28)
    v38 = v10 * v30 + v13 * v32
    v39 = v10 * (v13 * v30 + v10 * v32) / v38
    v42 = xp.sqrt(r * r + v39 * v39)
    v45 = v10 * difference_root(xp, b, c) / v38
    v52 = normal_slope(xp, v42, v45, h, b) * (v45 / v10) * (v45 / v42) * v42 ** 0.0
    v55 = E_star / 3.141592653589793 * xp.where(v9, v25 * xp.sum(v27 * v52, axis=0), 0.0)
    return mu * xp.where(v6, v55, v3 - v2)


def tangential_displacement(xp, a, c, h, b, E_star, G_star, mu):
    v27, v28 = nodes_along(xp, 1, a, c, h, b, E_star, G_star, mu)
    v3 = normal_depth(xp, c, h, b)
    v4 = normal_depth(xp, a, h, b)
    v5 = 0.25 * v4
    v6 = v3 >= v5
    v10 = (xp.where(v6, v3, 2.0 * v5) >= v5) & (a > c)
    v11 = difference_root(xp, b, 0.0)
    v13 = difference_root(xp, a, 0.0)
    v14 = difference_root(xp, c, 0.0)
    v17 = difference_root(xp, b, a)
    v24 = xp.log1p(2.0 * v11 * gap(xp, a, c, v13, v14) / v17 * ((v11 + v13) / (v11 + v14)) / v17)
    v26 = xp.where(v10, 0.5 * v24, 0.0)
    v29 = v27 * v26
    v30 = xp.cosh(v29)
    v32 = xp.sinh(v29)
    v38 = v11 * v30 + v14 * v32
    v39 = v11 * (v14 * v30 + v11 * v32) / v38
    v42 = xp.sqrt(0.0 + v39 * v39)
    v45 = v11 * difference_root(xp, b, c) / v38
    v52 = normal_slope(xp, v42, v45, h, b) * (v45 / v11) * (v45 / v42) * v42 ** 1.0
    v54 = xp.where(v10, v26 * xp.sum(v28 * v52, axis=0), 0.0)
    return mu * (E_star / G_star) * xp.where(v6, v54, v4 - xp.where(v6, 0.5 * v5, v3))


def stick_radius(xp, F_x, a, h, b, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, h, b, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, h, b, E_star))


def full_slip_displacement(xp, a, h, b, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, h, b)
