"""Formulas of axicontact.graded.adhesive.truncated_cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import flank_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.truncated_cone import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.truncated_cone import force as graded_normal_force
from ....._programs.expressions.graded.normal.truncated_cone import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.truncated_cone import rate as graded_normal_rate
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, theta, b, H, k, dgamma):
    return graded_normal_depth(xp, a, theta, b, k) - retraction(xp, a, H, k, dgamma)


def force(xp, a, theta, b, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, theta, b, H, k) - v4


def pressure(xp, r, a, theta, b, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, theta, b, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, theta, b, H, k, dgamma):
    v5 = r > a
    v8 = xp.where(v5, 0.5 * a, r)
    v9 = xp.where(v5, punch_share(xp, xp.where(v5, r, 2.0 * a), a, k), 1.0)
    v11 = flank_displacement(xp, r, a, b, k) * xp.tan(theta) - retraction(xp, a, H, k, dgamma) * v9
    return v11


def radius_from_depth(xp, d, theta, b, H, k, dgamma):

    def f2(v3):
        v5 = retraction(xp, v3, H, k, dgamma)
        v13 = graded_normal_rate(xp, v3, theta, b, k) - (1.0 + -1.0 * k) * v5 / (2.0 * v3)
        return (graded_normal_depth(xp, v3, theta, b, k) - v5, v13)
    return stable(xp, f2, d, radii_along(xp, 'radii_beyond', d, theta, b, H, k, dgamma) * b)


def radius_from_force(xp, F, theta, b, H, k, dgamma):

    def f2(v3):
        v10 = (3.0 + k) * retraction(xp, v3, H, k, dgamma) / (2.0 * v3)
        v13 = (graded_normal_rate(xp, v3, theta, b, k) - v10) * punch_stiffness(xp, v3, H, k)
        return (force(xp, v3, theta, b, H, k, dgamma), v13)
    return stable(xp, f2, F, radii_along(xp, 'radii_beyond', F, theta, b, H, k, dgamma) * b)
