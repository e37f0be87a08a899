"""Formulas of axicontact.tangential.sextic over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gained_share
from ...._programs.expressions._runtime.physics.slip import root_gain
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.sextic import depth as normal_depth
from ...._programs.expressions.normal.sextic import force as normal_force
from ...._programs.expressions.normal.sextic import pressure as normal_pressure
from ...._programs.expressions.normal.sextic import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.sextic import slope as normal_slope


def tangential_force(xp, a, c, A, E_star, mu):
    return mu * normal_force(xp, a, A, E_star) * gained_share(xp, c, a, 7.0)


def traction(xp, r, a, c, A, E_star, mu):
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v11 = a * a
    v13 = v11 * 0.0 + 1.0
    v14 = difference_root(xp, a, v2)
    v16 = v14 + difference_root(xp, c, v2)
    v20 = c * c
    v23 = 4.0 * v2 * v2 * ((2.0 * v2 * v2 + v13 * v16 * v14 + v20) / 3.0)
    v32 = root_gain(xp, v2, c, a) * ((v23 + (v11 * v13 + v20) * v16 * v14 + v20 * v20) / 5.0)
    v33 = E_star / 3.141592653589793 * normal_slope(xp, 1.0, A) * v32
    return mu * xp.where(v1, v33, normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, A, E_star))


def tangential_displacement(xp, a, c, A, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A) * gained_share(xp, c, a, 6.0)


def stick_radius(xp, F_x, a, A, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, A, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, A, E_star))


def full_slip_displacement(xp, a, A, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A)
