"""Formulas of axicontact.tangential.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.physics.slip import gained_share
from ...._programs.expressions._runtime.physics.slip import power_gain
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.power_law import depth as normal_depth
from ...._programs.expressions.normal.power_law import force as normal_force
from ...._programs.expressions.normal.power_law import pressure as normal_pressure
from ...._programs.expressions.normal.power_law import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.power_law import slope as normal_slope


def tangential_force(xp, a, c, A, n, E_star, mu):
    return mu * normal_force(xp, a, A, n, E_star) * gained_share(xp, c, a, n + 1.0)


def traction(xp, r, a, c, A, n, E_star, mu):
    v1 = r < c
    v5 = E_star / 3.141592653589793 * normal_slope(xp, a, A, n)
    v9 = normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, A, n, E_star)
    return mu * xp.where(v1, v5 * power_gain(xp, xp.where(v1, r, 0.5 * c), c, a, n), v9)


def tangential_displacement(xp, a, c, A, n, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A, n) * gained_share(xp, c, a, n)


def stick_radius(xp, F_x, a, A, n, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, A, n, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, A, n, E_star))


def full_slip_displacement(xp, a, A, n, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A, n)
