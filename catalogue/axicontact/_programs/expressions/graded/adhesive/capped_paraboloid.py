"""Formulas of axicontact.graded.adhesive.capped_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions.graded.normal.capped_paraboloid import depth_at as graded_normal_depth_at
from ....._programs.expressions.graded.normal.capped_paraboloid import displacement as graded_normal_displacement
from ....._programs.expressions.graded.normal.capped_paraboloid import force_at as graded_normal_force_at
from ....._programs.expressions.graded.normal.capped_paraboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.capped_paraboloid import rate_at as graded_normal_rate_at
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, R1, R2, b, H, k, dgamma):
    v2 = graded_normal_depth_at(xp, a, difference_root(xp, a, b), R1, R2, b, k)
    return v2 - retraction(xp, a, H, k, dgamma)


def force(xp, a, R1, R2, b, H, k, dgamma):
    v2 = graded_normal_force_at(xp, a, difference_root(xp, a, b), R1, R2, b, H, k)
    return v2 - punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)


def pressure(xp, r, a, R1, R2, b, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, R1, R2, b, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, R1, R2, b, H, k, dgamma):
    v3 = r > a
    v6 = xp.where(v3, 0.5 * a, r)
    v7 = xp.where(v3, punch_share(xp, xp.where(v3, r, 2.0 * a), a, k), 1.0)
    v9 = graded_normal_displacement(xp, r, a, R1, R2, b, k) - retraction(xp, a, H, k, dgamma) * v7
    return v9


def radius_from_depth(xp, d, R1, R2, b, H, k, dgamma):

    def f2(v3):
        v6 = graded_normal_rate_at(xp, v3, difference_root(xp, v3, b), R1, R2, b, k)
        v13 = v6 - (1.0 + -1.0 * k) * retraction(xp, v3, H, k, dgamma) / (2.0 * v3)
        return (depth(xp, v3, R1, R2, b, H, k, dgamma), v13)
    return stable(xp, f2, d, radii_along(xp, 'radii_around', d, R1, R2, b, H, k, dgamma) * b)


def radius_from_force(xp, F, R1, R2, b, H, k, dgamma):

    def f2(v3):
        v6 = graded_normal_rate_at(xp, v3, difference_root(xp, v3, b), R1, R2, b, k)
        v12 = v6 - (3.0 + k) * retraction(xp, v3, H, k, dgamma) / (2.0 * v3)
        return (force(xp, v3, R1, R2, b, H, k, dgamma), v12 * punch_stiffness(xp, v3, H, k))
    return stable(xp, f2, F, radii_along(xp, 'radii_around', F, R1, R2, b, H, k, dgamma) * b)
