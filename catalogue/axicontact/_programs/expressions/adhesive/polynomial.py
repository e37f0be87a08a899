"""Formulas of axicontact.adhesive.polynomial over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.polynomial import depth as normal_depth
from ...._programs.expressions.normal.polynomial import displacement as normal_displacement
from ...._programs.expressions.normal.polynomial import force as normal_force
from ...._programs.expressions.normal.polynomial import pressure as normal_pressure
from ...._programs.expressions.normal.polynomial import slope as normal_slope
from ...._runtime.steps import radii_along
from ...._runtime.steps import stable


def depth(xp, a, A, E_star, dgamma):
    return normal_depth(xp, a, A) - retraction(xp, a, E_star, dgamma)


def force(xp, a, A, E_star, dgamma):
    return normal_force(xp, a, A, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, A, E_star, dgamma):
    return normal_pressure(xp, r, a, A, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, A, E_star, dgamma):
    return normal_displacement(xp, r, a, A) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, A, E_star, dgamma):

    def f1(v2):
        v4 = retraction(xp, v2, E_star, dgamma)
        return (normal_depth(xp, v2, A) - v4, normal_slope(xp, v2, A) - v4 / (2.0 * v2))
    return stable(xp, f1, d, radii_along(xp, 'decades', d, E_star, dgamma))


def radius_from_force(xp, F, A, E_star, dgamma):

    def f1(v2):
        v13 = normal_slope(xp, v2, A) - 3.0 * retraction(xp, v2, E_star, dgamma) / (2.0 * v2)
        v5 = normal_force(xp, v2, A, E_star) - pull(xp, v2, E_star, dgamma)
        return (v5, 2.0 * E_star * v2 * v13)
    return stable(xp, f1, F, radii_along(xp, 'decades', F, E_star, dgamma))
