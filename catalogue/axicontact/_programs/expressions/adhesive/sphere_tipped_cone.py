"""Formulas of axicontact.adhesive.sphere_tipped_cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import sine_root
from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.sphere_tipped_cone import depth_at as normal_depth_at
from ...._programs.expressions.normal.sphere_tipped_cone import displacement as normal_displacement
from ...._programs.expressions.normal.sphere_tipped_cone import force_at as normal_force_at
from ...._programs.expressions.normal.sphere_tipped_cone import pressure as normal_pressure
from ...._programs.expressions.normal.sphere_tipped_cone import slope_at as normal_slope_at
from ...._runtime.steps import radii_along
from ...._runtime.steps import stable


def depth(xp, a, R, theta, E_star, dgamma):
    v2 = normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta)
    return v2 - retraction(xp, a, E_star, dgamma)


def force(xp, a, R, theta, E_star, dgamma):
    v2 = normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, E_star)
    return v2 - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, R, theta, E_star, dgamma):
    return normal_pressure(xp, r, a, R, theta, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, R, theta, E_star, dgamma):
    return normal_displacement(xp, r, a, R, theta) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, R, theta, E_star, dgamma):

    def f4(v5):
        v8 = normal_slope_at(xp, v5, sine_root(xp, v5, R, theta), R, theta)
        v12 = v8 - retraction(xp, v5, E_star, dgamma) / (2.0 * v5)
        return (depth(xp, v5, R, theta, E_star, dgamma), v12)
    v4 = radii_along(xp, 'radii_around', d, R, theta, E_star, dgamma) * (R * xp.sin(theta))
    return stable(xp, f4, d, v4)


def radius_from_force(xp, F, R, theta, E_star, dgamma):

    def f4(v5):
        v10 = normal_slope_at(xp, v5, sine_root(xp, v5, R, theta), R, theta)
        v16 = 2.0 * E_star * v5 * (v10 - 3.0 * retraction(xp, v5, E_star, dgamma) / (2.0 * v5))
        return (force(xp, v5, R, theta, E_star, dgamma), v16)
    v4 = radii_along(xp, 'radii_around', F, R, theta, E_star, dgamma) * (R * xp.sin(theta))
    return stable(xp, f4, F, v4)
