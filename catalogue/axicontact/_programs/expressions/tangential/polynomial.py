"""Formulas of axicontact.tangential.polynomial over an array library `xp`."""

from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.polynomial import depth as normal_depth
from ...._programs.expressions.normal.polynomial import force as normal_force
from ...._programs.expressions.normal.polynomial import radius_from_force as normal_radius_from_force


def stick_radius(xp, F_x, a, A, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, A, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, A, E_star))


def full_slip_displacement(xp, a, A, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A)
