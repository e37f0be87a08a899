"""Formulas of axicontact.tangential.cone over an array library `xp`."""

from ...._programs.expressions._runtime.physics.slip import arc_gain
from ...._programs.expressions._runtime.physics.slip import gained_share
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.cone import depth as normal_depth
from ...._programs.expressions.normal.cone import force as normal_force
from ...._programs.expressions.normal.cone import pressure as normal_pressure
from ...._programs.expressions.normal.cone import radius_from_force as normal_radius_from_force


def tangential_force(xp, a, c, theta, E_star, mu):
    return mu * normal_force(xp, a, theta, E_star) * gained_share(xp, c, a, 2.0)


def traction(xp, r, a, c, theta, E_star, mu):
    v1 = r < c
    v7 = E_star / 3.141592653589793 * (3.141592653589793 * xp.tan(theta) / 2.0)
    v11 = normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, theta, E_star)
    return mu * xp.where(v1, v7 * arc_gain(xp, xp.where(v1, r, 0.5 * c), c, a), v11)


def tangential_displacement(xp, a, c, theta, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, theta) * gained_share(xp, c, a, 1.0)


def stick_radius(xp, F_x, a, theta, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, theta, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, theta, E_star))


def full_slip_displacement(xp, a, theta, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, theta)
