"""Formulas of axicontact.tangential.hyperboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.hyperboloid import depth as normal_depth
from ...._programs.expressions.normal.hyperboloid import force as normal_force
from ...._programs.expressions.normal.hyperboloid import pressure as normal_pressure
from ...._programs.expressions.normal.hyperboloid import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.hyperboloid import slope as normal_slope
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, theta, b, E_star, mu):
    v19, v20 = nodes_along(xp, 1, a, c, theta, b, E_star, mu)
    v1 = normal_force(xp, c, theta, b, E_star)
    v2 = normal_force(xp, a, theta, b, E_star)
    v3 = 0.25 * v2
    v4 = v1 >= v3
    v9 = (xp.where(v4, v1, 2.0 * v3) >= v3) & (a > c)
    v12 = difference_root(xp, c, 0.0)
    v17 = xp.log1p((a - c + gap(xp, a, c, difference_root(xp, a, 0.0), v12)) / (c + v12))
    v18 = xp.where(v9, v17, 0.0)
    v21 = v19 * v18
    v26 = c * xp.cosh(v21) + v12 * xp.sinh(v21)
    v31 = xp.where(v9, v18 * xp.sum(v20 * (normal_slope(xp, v26, theta, b) * v26 ** 2.0), axis=0), 0.0)
    return mu * xp.where(v4, 2.0 * E_star * v31, v2 - xp.where(v4, 0.5 * v3, v1))


def traction(xp, r, a, c, theta, b, E_star, mu):
    v19, v20 = nodes_along(xp, 1, r, a, c, theta, b, E_star, mu)
    v2 = normal_pressure(xp, r, c, theta, b, E_star)
    v3 = normal_pressure(xp, r, a, theta, b, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v9 = v6 & (a > c)
    v12 = difference_root(xp, c, r)
    v17 = xp.log1p((a - c + gap(xp, a, c, difference_root(xp, a, r), v12)) / (c + v12))
    v18 = xp.where(v9, v17, 0.0)
    v21 = v19 * v18
    v26 = c * xp.cosh(v21) + v12 * xp.sinh(v21)
    v31 = xp.where(v9, v18 * xp.sum(v20 * (normal_slope(xp, v26, theta, b) * v26 ** 0.0), axis=0), 0.0)
    return mu * xp.where(v6, E_star / 3.141592653589793 * v31, v3 - v2)


def tangential_displacement(xp, a, c, theta, b, E_star, G_star, mu):
    v20, v21 = nodes_along(xp, 1, a, c, theta, b, E_star, G_star, mu)
    v3 = normal_depth(xp, c, theta, b)
    v4 = normal_depth(xp, a, theta, b)
    v5 = 0.25 * v4
    v6 = v3 >= v5
    v10 = (xp.where(v6, v3, 2.0 * v5) >= v5) & (a > c)
    v13 = difference_root(xp, c, 0.0)
    v18 = xp.log1p((a - c + gap(xp, a, c, difference_root(xp, a, 0.0), v13)) / (c + v13))
    v19 = xp.where(v10, v18, 0.0)
    v22 = v20 * v19
    v27 = c * xp.cosh(v22) + v13 * xp.sinh(v22)
    v31 = v19 * xp.sum(v21 * (normal_slope(xp, v27, theta, b) * v27 ** 1.0), axis=0)
    v35 = xp.where(v6, xp.where(v10, v31, 0.0), v4 - xp.where(v6, 0.5 * v5, v3))
    return mu * (E_star / G_star) * v35


def stick_radius(xp, F_x, a, theta, b, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, theta, b, E_star), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, theta, b, E_star))
    return v7


def full_slip_displacement(xp, a, theta, b, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, theta, b)
