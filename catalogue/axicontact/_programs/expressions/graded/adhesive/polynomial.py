"""Formulas of axicontact.graded.adhesive.polynomial over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.polynomial import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.polynomial import displacement as graded_normal_displacement
from ....._programs.expressions.graded.normal.polynomial import force as graded_normal_force
from ....._programs.expressions.graded.normal.polynomial import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.polynomial import rate as graded_normal_rate
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, A, H, k, dgamma):
    return graded_normal_depth(xp, a, A, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, A, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, A, H, k) - v4


def pressure(xp, r, a, A, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, A, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, A, H, k, dgamma):
    v3 = r > a
    v6 = xp.where(v3, 0.5 * a, r)
    v7 = xp.where(v3, punch_share(xp, xp.where(v3, r, 2.0 * a), a, k), 1.0)
    return graded_normal_displacement(xp, r, a, A, k) - retraction(xp, a, H, k, dgamma) * v7


def radius_from_depth(xp, d, A, H, k, dgamma):

    def f1(v2):
        v4 = retraction(xp, v2, H, k, dgamma)
        v12 = graded_normal_rate(xp, v2, A, k) - (1.0 + -1.0 * k) * v4 / (2.0 * v2)
        return (graded_normal_depth(xp, v2, A, k) - v4, v12)
    return stable(xp, f1, d, radii_along(xp, 'decades', d, H, k, dgamma))


def radius_from_force(xp, F, A, H, k, dgamma):

    def f1(v2):
        v10 = graded_normal_rate(xp, v2, A, k) - (3.0 + k) * retraction(xp, v2, H, k, dgamma) / (2.0 * v2)
        return (force(xp, v2, A, H, k, dgamma), v10 * punch_stiffness(xp, v2, H, k))
    return stable(xp, f1, F, radii_along(xp, 'decades', F, H, k, dgamma))
