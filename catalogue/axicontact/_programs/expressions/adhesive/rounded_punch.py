"""Formulas of axicontact.adhesive.rounded_punch over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.rounded_punch import depth as normal_depth
from ...._programs.expressions.normal.rounded_punch import displacement as normal_displacement
from ...._programs.expressions.normal.rounded_punch import force as normal_force
from ...._programs.expressions.normal.rounded_punch import pressure as normal_pressure
from ...._programs.expressions.normal.rounded_punch import slope_beyond as normal_slope_beyond
from ...._runtime.steps import radii_along
from ...._runtime.steps import stable


def depth(xp, a, R, b, E_star, dgamma):
    return normal_depth(xp, a, R, b) - retraction(xp, a, E_star, dgamma)


def force(xp, a, R, b, E_star, dgamma):
    return normal_force(xp, a, R, b, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, R, b, E_star, dgamma):
    return normal_pressure(xp, r, a, R, b, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, R, b, E_star, dgamma):
    return normal_displacement(xp, r, a, R, b) - lift(xp, r, a, E_star, dgamma)


def rate(xp, a, R, b):
    v4 = xp.maximum(a - b, 0.0) * (a + b)
    v5 = v4 > 0.0
    return normal_slope_beyond(xp, a, xp.where(v5, xp.sqrt(xp.where(v5, v4, 1.0)), 0.0), R, b)


def radius_from_depth(xp, d, R, b, E_star, dgamma):

    def f2(v3):
        v5 = retraction(xp, v3, E_star, dgamma)
        return (normal_depth(xp, v3, R, b) - v5, rate(xp, v3, R, b) - v5 / (2.0 * v3))
    return stable(xp, f2, d, radii_along(xp, 'radii_beyond', d, R, b, E_star, dgamma) * b)


def radius_from_force(xp, F, R, b, E_star, dgamma):

    def f2(v3):
        v14 = rate(xp, v3, R, b) - 3.0 * retraction(xp, v3, E_star, dgamma) / (2.0 * v3)
        v6 = normal_force(xp, v3, R, b, E_star) - pull(xp, v3, E_star, dgamma)
        return (v6, 2.0 * E_star * v3 * v14)
    return stable(xp, f2, F, radii_along(xp, 'radii_beyond', F, R, b, E_star, dgamma) * b)
