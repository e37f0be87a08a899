"""Formulas of axicontact.graded.adhesive.gaussian over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import gaussian_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import gaussian_rate
from ....._programs.expressions._runtime.graded.inverse import gaussian_reach
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.gaussian import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.gaussian import force as graded_normal_force
from ....._programs.expressions.graded.normal.gaussian import pressure as graded_normal_pressure
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, h, s, H, k, dgamma):
    return graded_normal_depth(xp, a, h, s, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, h, s, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, h, s, H, k) - v4


def pressure(xp, r, a, h, s, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, h, s, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, h, s, H, k, dgamma):
    v4 = r > a
    v7 = xp.where(v4, 0.5 * a, r)
    v8 = xp.where(v4, punch_share(xp, xp.where(v4, r, 2.0 * a), a, k), 1.0)
    return h * gaussian_displacement(xp, r, a, s, k) - retraction(xp, a, H, k, dgamma) * v8


def radius_from_depth(xp, d, h, s, H, k, dgamma):

    def f3(v4):
        v6 = retraction(xp, v4, H, k, dgamma)
        v15 = h * gaussian_rate(xp, v4, s, k) - (1.0 + -1.0 * k) * v6 / (2.0 * v4)
        return (graded_normal_depth(xp, v4, h, s, k) - v6, v15)
    v3 = radii_along(xp, 'radii_to', d, h, s, H, k, dgamma) * gaussian_reach(xp, s, k)
    return stable(xp, f3, d, v3)


def radius_from_force(xp, F, h, s, H, k, dgamma):

    def f3(v4):
        v12 = (3.0 + k) * retraction(xp, v4, H, k, dgamma) / (2.0 * v4)
        v15 = (h * gaussian_rate(xp, v4, s, k) - v12) * punch_stiffness(xp, v4, H, k)
        return (force(xp, v4, h, s, H, k, dgamma), v15)
    v3 = radii_along(xp, 'radii_to', F, h, s, H, k, dgamma) * gaussian_reach(xp, s, k)
    return stable(xp, f3, F, v3)
