"""Formulas of axicontact.adhesive.gaussian over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.gaussian import depth as normal_depth
from ...._programs.expressions.normal.gaussian import displacement as normal_displacement
from ...._programs.expressions.normal.gaussian import force as normal_force
from ...._programs.expressions.normal.gaussian import pressure as normal_pressure
from ...._programs.expressions.normal.gaussian import slope as normal_slope
from ...._runtime.steps import radii_along
from ...._runtime.steps import stable


def depth(xp, a, h, s, E_star, dgamma):
    return normal_depth(xp, a, h, s) - retraction(xp, a, E_star, dgamma)


def force(xp, a, h, s, E_star, dgamma):
    return normal_force(xp, a, h, s, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, h, s, E_star, dgamma):
    return normal_pressure(xp, r, a, h, s, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, h, s, E_star, dgamma):
    return normal_displacement(xp, r, a, h, s) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, h, s, E_star, dgamma):

    def f3(v4):
        v6 = retraction(xp, v4, E_star, dgamma)
        return (normal_depth(xp, v4, h, s) - v6, normal_slope(xp, v4, h, s) - v6 / (2.0 * v4))
    v3 = radii_along(xp, 'radii_to', d, h, s, E_star, dgamma) * (1.5019752682686114 * s)
    return stable(xp, f3, d, v3)


def radius_from_force(xp, F, h, s, E_star, dgamma):

    def f3(v4):
        v15 = normal_slope(xp, v4, h, s) - 3.0 * retraction(xp, v4, E_star, dgamma) / (2.0 * v4)
        v7 = normal_force(xp, v4, h, s, E_star) - pull(xp, v4, E_star, dgamma)
        return (v7, 2.0 * E_star * v4 * v15)
    v3 = radii_along(xp, 'radii_to', F, h, s, E_star, dgamma) * (1.5019752682686114 * s)
    return stable(xp, f3, F, v3)
