"""Formulas of axicontact.graded.adhesive.wavy_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.wavy_paraboloid import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.wavy_paraboloid import displacement as graded_normal_displacement
from ....._programs.expressions.graded.normal.wavy_paraboloid import force as graded_normal_force
from ....._programs.expressions.graded.normal.wavy_paraboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.wavy_paraboloid import rate as graded_normal_rate
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, R, h, wavelength, H, k, dgamma):
    return graded_normal_depth(xp, a, R, h, wavelength, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, R, h, wavelength, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, R, h, wavelength, H, k) - v4


def pressure(xp, r, a, R, h, wavelength, H, k, dgamma):
    v3 = graded_normal_pressure(xp, r, a, R, h, wavelength, H, k) - tension(xp, r, a, H, k, dgamma)
    return v3


def displacement(xp, r, a, R, h, wavelength, H, k, dgamma):
    v3 = r > a
    v6 = xp.where(v3, 0.5 * a, r)
    v7 = xp.where(v3, punch_share(xp, xp.where(v3, r, 2.0 * a), a, k), 1.0)
    v1 = graded_normal_displacement(xp, r, a, R, h, wavelength, k)
    return v1 - retraction(xp, a, H, k, dgamma) * v7


def radius_from_depth(xp, d, R, h, wavelength, H, k, dgamma):

    def f2(v3):
        v5 = retraction(xp, v3, H, k, dgamma)
        v13 = graded_normal_rate(xp, v3, R, h, wavelength, k) - (1.0 + -1.0 * k) * v5 / (2.0 * v3)
        return (graded_normal_depth(xp, v3, R, h, wavelength, k) - v5, v13)
    v2 = radii_along(xp, 'radii_of_waves', d, R, h, wavelength, H, k, dgamma) * wavelength
    return stable(xp, f2, d, v2)


def radius_from_force(xp, F, R, h, wavelength, H, k, dgamma):

    def f2(v3):
        v10 = (3.0 + k) * retraction(xp, v3, H, k, dgamma) / (2.0 * v3)
        v13 = (graded_normal_rate(xp, v3, R, h, wavelength, k) - v10) * punch_stiffness(xp, v3, H, k)
        return (force(xp, v3, R, h, wavelength, H, k, dgamma), v13)
    v2 = radii_along(xp, 'radii_of_waves', F, R, h, wavelength, H, k, dgamma) * wavelength
    return stable(xp, f2, F, v2)
