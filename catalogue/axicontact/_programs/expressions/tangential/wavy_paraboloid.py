"""Formulas of axicontact.tangential.wavy_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gap
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.wavy_paraboloid import depth as normal_depth
from ...._programs.expressions.normal.wavy_paraboloid import force as normal_force
from ...._programs.expressions.normal.wavy_paraboloid import pressure as normal_pressure
from ...._programs.expressions.normal.wavy_paraboloid import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.wavy_paraboloid import slope as normal_slope
from ...._runtime.steps import nodes_along


def tangential_force(xp, a, c, R, h, wavelength, E_star, mu):
    v17, v18 = nodes_along(xp, 4, a, c, R, h, wavelength, E_star, mu)
    v1 = normal_force(xp, c, R, h, wavelength, E_star)
    v2 = normal_force(xp, a, R, h, wavelength, E_star)
    v3 = 0.25 * v2
    v4 = v1 >= v3
    v11 = difference_root(xp, c, 0.0)
    v12 = gap(xp, a, c, difference_root(xp, a, 0.0), v11)
    v15 = (xp.where(v4, v1, 2.0 * v3) >= v3) & (a > c) & (v12 < 256.0 * wavelength)
    v16 = xp.where(v15, v12, 0.0)
    v23 = xp.sqrt(0.0 + (v11 + v17 * v16) ** 2.0)
    v27 = v16 * xp.sum(v18 * (normal_slope(xp, v23, R, h, wavelength) * v23 ** 1.0), axis=0)
    return mu * xp.where(v4, 2.0 * E_star * v27, v2 - xp.where(v4, 0.5 * v3, v1))


def traction(xp, r, a, c, R, h, wavelength, E_star, mu):
    v17, v18 = nodes_along(xp, 4, r, a, c, R, h, wavelength, E_star, mu)
    v2 = normal_pressure(xp, r, c, R, h, wavelength, E_star)
    v3 = normal_pressure(xp, r, a, R, h, wavelength, E_star)
    v6 = (r < c) & (v2 >= 0.25 * v3)
    v11 = difference_root(xp, c, r)
    v12 = gap(xp, a, c, difference_root(xp, a, r), v11)
    v16 = xp.where(v6 & (a > c) & (v12 < 256.0 * wavelength), v12, 0.0)
    v24 = xp.sqrt(r * r + (v11 + v17 * v16) ** 2.0)
    v28 = v16 * xp.sum(v18 * (normal_slope(xp, v24, R, h, wavelength) * v24 ** (-1.0)), axis=0)
    return mu * xp.where(v6, E_star / 3.141592653589793 * v28, v3 - v2)


def tangential_displacement(xp, a, c, R, h, wavelength, E_star, G_star, mu):
    v18, v19 = nodes_along(xp, 4, a, c, R, h, wavelength, E_star, G_star, mu)
    v3 = normal_depth(xp, c, R, h, wavelength)
    v4 = normal_depth(xp, a, R, h, wavelength)
    v5 = 0.25 * v4
    v6 = v3 >= v5
    v12 = difference_root(xp, c, 0.0)
    v13 = gap(xp, a, c, difference_root(xp, a, 0.0), v12)
    v16 = (xp.where(v6, v3, 2.0 * v5) >= v5) & (a > c) & (v13 < 256.0 * wavelength)
    v17 = xp.where(v16, v13, 0.0)
    v24 = xp.sqrt(0.0 + (v12 + v18 * v17) ** 2.0)
    v28 = v17 * xp.sum(v19 * (normal_slope(xp, v24, R, h, wavelength) * v24 ** 0.0), axis=0)
    return mu * (E_star / G_star) * xp.where(v6, v28, v4 - xp.where(v6, 0.5 * v5, v3))


def stick_radius(xp, F_x, a, R, h, wavelength, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, R, h, wavelength, E_star), F_x, mu)
    v6 = normal_radius_from_force(xp, v5, R, h, wavelength, E_star)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v6)


def full_slip_displacement(xp, a, R, h, wavelength, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, R, h, wavelength)
