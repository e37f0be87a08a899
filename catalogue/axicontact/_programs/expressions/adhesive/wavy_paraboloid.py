"""Formulas of axicontact.adhesive.wavy_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
from ...._programs.expressions._runtime.physics.adhesion import lift
from ...._programs.expressions._runtime.physics.adhesion import pull
from ...._programs.expressions._runtime.physics.adhesion import tension
from ...._programs.expressions.normal.wavy_paraboloid import depth as normal_depth
from ...._programs.expressions.normal.wavy_paraboloid import displacement as normal_displacement
from ...._programs.expressions.normal.wavy_paraboloid import force as normal_force
from ...._programs.expressions.normal.wavy_paraboloid import pressure as normal_pressure
from ...._programs.expressions.normal.wavy_paraboloid import slope as normal_slope
from ...._runtime.steps import radii_along
from ...._runtime.steps import stable


def depth(xp, a, R, h, wavelength, E_star, dgamma):
    return normal_depth(xp, a, R, h, wavelength) - retraction(xp, a, E_star, dgamma)


def force(xp, a, R, h, wavelength, E_star, dgamma):
    return normal_force(xp, a, R, h, wavelength, E_star) - pull(xp, a, E_star, dgamma)


def pressure(xp, r, a, R, h, wavelength, E_star, dgamma):
    return normal_pressure(xp, r, a, R, h, wavelength, E_star) - tension(xp, r, a, E_star, dgamma)


def displacement(xp, r, a, R, h, wavelength, E_star, dgamma):
    return normal_displacement(xp, r, a, R, h, wavelength) - lift(xp, r, a, E_star, dgamma)


def radius_from_depth(xp, d, R, h, wavelength, E_star, dgamma):

    def f2(v3):
        v5 = retraction(xp, v3, E_star, dgamma)
        v10 = normal_slope(xp, v3, R, h, wavelength) - v5 / (2.0 * v3)
        return (normal_depth(xp, v3, R, h, wavelength) - v5, v10)
    v2 = radii_along(xp, 'radii_of_waves', d, R, h, wavelength, E_star, dgamma) * wavelength
    return stable(xp, f2, d, v2)


def radius_from_force(xp, F, R, h, wavelength, E_star, dgamma):

    def f2(v3):
        v13 = 3.0 * retraction(xp, v3, E_star, dgamma) / (2.0 * v3)
        v6 = normal_force(xp, v3, R, h, wavelength, E_star) - pull(xp, v3, E_star, dgamma)
        return (v6, 2.0 * E_star * v3 * (normal_slope(xp, v3, R, h, wavelength) - v13))
    v2 = radii_along(xp, 'radii_of_waves', F, R, h, wavelength, E_star, dgamma) * wavelength
    return stable(xp, f2, F, v2)
