"""Formulas of axicontact.graded.adhesive.rounded_punch over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.displacement import rounding_displacement
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.rounded_punch import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.rounded_punch import force as graded_normal_force
from ....._programs.expressions.graded.normal.rounded_punch import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.rounded_punch import rate as graded_normal_rate
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, R, b, H, k, dgamma):
    return graded_normal_depth(xp, a, R, b, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, R, b, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, R, b, H, k) - v4


def pressure(xp, r, a, R, b, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, R, b, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, R, b, H, k, dgamma):
    v4 = r > a
    v7 = xp.where(v4, 0.5 * a, r)
    v8 = xp.where(v4, punch_share(xp, xp.where(v4, r, 2.0 * a), a, k), 1.0)
    return rounding_displacement(xp, r, a, b, k) / R - retraction(xp, a, H, k, dgamma) * v8


def radius_from_depth(xp, d, R, b, H, k, dgamma):

    def f2(v3):
        v5 = retraction(xp, v3, H, k, dgamma)
        v13 = graded_normal_rate(xp, v3, R, b, k) - (1.0 + -1.0 * k) * v5 / (2.0 * v3)
        return (graded_normal_depth(xp, v3, R, b, k) - v5, v13)
    return stable(xp, f2, d, radii_along(xp, 'radii_beyond', d, R, b, H, k, dgamma) * b)


def radius_from_force(xp, F, R, b, H, k, dgamma):

    def f2(v3):
        v10 = (3.0 + k) * retraction(xp, v3, H, k, dgamma) / (2.0 * v3)
        v13 = (graded_normal_rate(xp, v3, R, b, k) - v10) * punch_stiffness(xp, v3, H, k)
        return (force(xp, v3, R, b, H, k, dgamma), v13)
    return stable(xp, f2, F, radii_along(xp, 'radii_beyond', F, R, b, H, k, dgamma) * b)
