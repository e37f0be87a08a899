"""Formulas of axicontact.graded.adhesive.sphere_tipped_cone over an array library `xp`."""

from ....._programs.expressions._runtime.functions import sine_root
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.sphere_tipped_cone import depth_at as graded_normal_depth_at
from ....._programs.expressions.graded.normal.sphere_tipped_cone import displacement as graded_normal_displacement
from ....._programs.expressions.graded.normal.sphere_tipped_cone import force_at as graded_normal_force_at
from ....._programs.expressions.graded.normal.sphere_tipped_cone import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.sphere_tipped_cone import rate_at as graded_normal_rate_at
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, R, theta, H, k, dgamma):
    v2 = graded_normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta, k)
    return v2 - retraction(xp, a, H, k, dgamma)


def force(xp, a, R, theta, H, k, dgamma):
    v2 = graded_normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, H, k)
    return v2 - punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)


def pressure(xp, r, a, R, theta, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, R, theta, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, R, theta, H, k, dgamma):
    v3 = r > a
    v6 = xp.where(v3, 0.5 * a, r)
    v7 = xp.where(v3, punch_share(xp, xp.where(v3, r, 2.0 * a), a, k), 1.0)
    v9 = graded_normal_displacement(xp, r, a, R, theta, k) - retraction(xp, a, H, k, dgamma) * v7
    return v9


def radius_from_depth(xp, d, R, theta, H, k, dgamma):

    def f4(v5):
        v8 = graded_normal_rate_at(xp, v5, sine_root(xp, v5, R, theta), R, theta, k)
        v15 = v8 - (1.0 + -1.0 * k) * retraction(xp, v5, H, k, dgamma) / (2.0 * v5)
        return (depth(xp, v5, R, theta, H, k, dgamma), v15)
    v4 = radii_along(xp, 'radii_around', d, R, theta, H, k, dgamma) * (R * xp.sin(theta))
    return stable(xp, f4, d, v4)


def radius_from_force(xp, F, R, theta, H, k, dgamma):

    def f4(v5):
        v8 = graded_normal_rate_at(xp, v5, sine_root(xp, v5, R, theta), R, theta, k)
        v14 = v8 - (3.0 + k) * retraction(xp, v5, H, k, dgamma) / (2.0 * v5)
        return (force(xp, v5, R, theta, H, k, dgamma), v14 * punch_stiffness(xp, v5, H, k))
    v4 = radii_along(xp, 'radii_around', F, R, theta, H, k, dgamma) * (R * xp.sin(theta))
    return stable(xp, f4, F, v4)
