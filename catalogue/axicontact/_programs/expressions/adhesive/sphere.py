"""Formulas of axicontact.adhesive.sphere over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.sphere import depth as normal_depth
from ...._programs.expressions.normal.sphere import displacement as normal_displacement
from ...._programs.expressions.normal.sphere import force as normal_force
from ...._programs.expressions.normal.sphere import pressure as normal_pressure
from ...._programs.expressions.normal.sphere import slope as normal_slope
from ...._runtime.steps import radii_along
from ...._runtime.steps import stable


def depth(xp, a, R, E_star, dgamma):
    return normal_depth(xp, a, R) - retraction(xp, a, E_star, dgamma)


def force(xp, a, R, E_star, dgamma):
    return normal_force(xp, a, R, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, R, E_star, dgamma):
    return normal_pressure(xp, r, a, R, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, R, E_star, dgamma):
    return normal_displacement(xp, r, a, R) - lift(xp, r, a, E_star, dgamma)


def rate(xp, a, R):
    v4 = xp.maximum(R - a, 0.0) * (R + a)
    v5 = v4 > 0.0
    return normal_slope(xp, a, xp.where(v5, xp.sqrt(xp.where(v5, v4, 1.0)), 0.0), R)


def radius_from_depth(xp, d, R, E_star, dgamma):

    def f2(v3):
        v5 = retraction(xp, v3, E_star, dgamma)
        return (normal_depth(xp, v3, R) - v5, rate(xp, v3, R) - v5 / (2.0 * v3))
    return stable(xp, f2, d, radii_along(xp, 'radii_below', d, R, E_star, dgamma) * R)


def radius_from_force(xp, F, R, E_star, dgamma):

    def f2(v3):
        v14 = rate(xp, v3, R) - 3.0 * retraction(xp, v3, E_star, dgamma) / (2.0 * v3)
        v6 = normal_force(xp, v3, R, E_star) - pull(xp, v3, E_star, dgamma)
        return (v6, 2.0 * E_star * v3 * v14)
    return stable(xp, f2, F, radii_along(xp, 'radii_below', F, R, E_star, dgamma) * R)
