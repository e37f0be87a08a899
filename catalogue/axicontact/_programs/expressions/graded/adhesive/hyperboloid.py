"""Formulas of axicontact.graded.adhesive.hyperboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import hyperboloid_displacement
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import hyperboloid_depth
from ....._programs.expressions._runtime.graded.growth import hyperboloid_rate
from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.punch import tension
from ....._programs.expressions.graded.normal.hyperboloid import force as graded_normal_force
from ....._programs.expressions.graded.normal.hyperboloid import pressure as graded_normal_pressure
from ....._runtime.steps import radii_along
from ....._runtime.steps import stable


def depth(xp, a, theta, b, H, k, dgamma):
    return hyperboloid_depth(xp, a, b, k) * xp.tan(theta) - retraction(xp, a, H, k, dgamma)


def force(xp, a, theta, b, H, k, dgamma):
    v4 = punch_stiffness(xp, a, H, k) * retraction(xp, a, H, k, dgamma)
    return graded_normal_force(xp, a, theta, b, H, k) - v4


def pressure(xp, r, a, theta, b, H, k, dgamma):
    return graded_normal_pressure(xp, r, a, theta, b, H, k) - tension(xp, r, a, H, k, dgamma)


def displacement(xp, r, a, theta, b, H, k, dgamma):
    v5 = r > a
    v8 = xp.where(v5, 0.5 * a, r)
    v9 = xp.where(v5, punch_share(xp, xp.where(v5, r, 2.0 * a), a, k), 1.0)
    v3 = hyperboloid_displacement(xp, r, a, b, k) * xp.tan(theta)
    return v3 - retraction(xp, a, H, k, dgamma) * v9


def radius_from_depth(xp, d, theta, b, H, k, dgamma):

    def f1(v2):
        v12 = (1.0 + -1.0 * k) * retraction(xp, v2, H, k, dgamma) / (2.0 * v2)
        v13 = hyperboloid_rate(xp, v2, b, k) * xp.tan(theta) - v12
        return (depth(xp, v2, theta, b, H, k, dgamma), v13)
    return stable(xp, f1, d, radii_along(xp, 'decades', d, theta, b, H, k, dgamma))


def radius_from_force(xp, F, theta, b, H, k, dgamma):

    def f1(v2):
        v11 = (3.0 + k) * retraction(xp, v2, H, k, dgamma) / (2.0 * v2)
        v14 = (hyperboloid_rate(xp, v2, b, k) * xp.tan(theta) - v11) * punch_stiffness(xp, v2, H, k)
        return (force(xp, v2, theta, b, H, k, dgamma), v14)
    return stable(xp, f1, F, radii_along(xp, 'decades', F, theta, b, H, k, dgamma))
