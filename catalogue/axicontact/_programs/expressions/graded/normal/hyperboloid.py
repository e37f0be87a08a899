"""Formulas of axicontact.graded.normal.hyperboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import hyperboloid_displacement
from ....._programs.expressions._runtime.graded.growth import hyperboloid_depth
from ....._programs.expressions._runtime.graded.growth import hyperboloid_force
from ....._programs.expressions._runtime.graded.growth import hyperboloid_rate
from ....._programs.expressions._runtime.graded.pressure import hyperboloid_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.hyperboloid import profile
from ....._runtime.steps import newton


def force(xp, a, theta, b, H, k):
    return 2.0 * H / (1.0 + k) * (hyperboloid_force(xp, a, b, k) * xp.tan(theta))


def pressure(xp, r, a, theta, b, H, k):
    v1 = r < a
    v7 = hyperboloid_pressure(xp, xp.minimum(xp.where(v1, r, 0.5 * a), a), a, b, k) * xp.tan(theta)
    v9 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v7, 0.0)


def depth(xp, a, theta, b, k):
    return hyperboloid_depth(xp, a, b, k) * xp.tan(theta)


def displacement(xp, r, a, theta, b, k):
    return hyperboloid_displacement(xp, r, a, b, k) * xp.tan(theta)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, theta, b, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, theta, b, H, k) / (3.141592653589793 * v2 * v2), 0.0)


def radius_from_depth(xp, d, theta, b, k):

    def f3(v4):
        v6 = xp.tan(theta)
        v7 = hyperboloid_depth(xp, v4, b, k) * v6
        return (v7, v4 * (hyperboloid_rate(xp, v4, b, k) * v6) / v7)
    return newton(xp, f3, d + 0.0, 1.5 * b + 0.0, xp.inf, 1e-06, xp.inf)


def force_rate(xp, a, theta, b, H, k):
    return punch_stiffness(xp, a, H, k) * (hyperboloid_rate(xp, a, b, k) * xp.tan(theta))


def radius_from_force(xp, F, theta, b, H, k):

    def f3(v4):
        v5 = force(xp, v4, theta, b, H, k)
        return (v5, v4 * force_rate(xp, v4, theta, b, H, k) / v5)
    return newton(xp, f3, F + 0.0, 1.5 * b + 0.0, xp.inf, 1e-06, xp.inf)


def force_from_depth(xp, d, theta, b, H, k):
    v1 = radius_from_depth(xp, d, theta, b, k)
    v7 = punch_force(xp, d - hyperboloid_depth(xp, v1, b, k) * xp.tan(theta), v1, H, k)
    return force(xp, v1, theta, b, H, k) + v7


def depth_from_force(xp, F, theta, b, H, k):
    v1 = radius_from_force(xp, F, theta, b, H, k)
    v7 = punch_depth(xp, F - force(xp, v1, theta, b, H, k), v1, H, k)
    return hyperboloid_depth(xp, v1, b, k) * xp.tan(theta) + v7
