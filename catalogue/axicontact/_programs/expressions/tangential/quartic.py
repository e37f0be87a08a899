"""Formulas of axicontact.tangential.quartic over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.slip import gained_share
from ...._programs.expressions._runtime.physics.slip import root_gain
from ...._programs.expressions._runtime.physics.slip import stick_force
from ...._programs.expressions.normal.quartic import depth as normal_depth
from ...._programs.expressions.normal.quartic import force as normal_force
from ...._programs.expressions.normal.quartic import pressure as normal_pressure
from ...._programs.expressions.normal.quartic import radius_from_force as normal_radius_from_force
from ...._programs.expressions.normal.quartic import slope as normal_slope


def tangential_force(xp, a, c, A, E_star, mu):
    return mu * normal_force(xp, a, A, E_star) * gained_share(xp, c, a, 5.0)


def traction(xp, r, a, c, A, E_star, mu):
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v12 = difference_root(xp, a, v2)
    v17 = 2.0 * v2 * v2 + (a * a * 0.0 + 1.0) * (v12 + difference_root(xp, c, v2)) * v12
    v5 = E_star / 3.141592653589793 * normal_slope(xp, 1.0, A)
    v24 = normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, A, E_star)
    return mu * xp.where(v1, v5 * (root_gain(xp, v2, c, a) * ((v17 + c * c) / 3.0)), v24)


def tangential_displacement(xp, a, c, A, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A) * gained_share(xp, c, a, 4.0)


def stick_radius(xp, F_x, a, A, E_star, mu):
    v5 = stick_force(xp, normal_force(xp, a, A, E_star), F_x, mu)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, normal_radius_from_force(xp, v5, A, E_star))


def full_slip_displacement(xp, a, A, E_star, G_star, mu):
    return mu * (E_star / G_star) * normal_depth(xp, a, A)
