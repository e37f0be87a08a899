"""Formulas of axicontact.graded.normal.polynomial over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_mean
from ....._programs.expressions._runtime.graded.growth import power_rate
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.polynomial import profile
from ....._runtime.steps import newton
from ....._runtime.steps import numbered


def depth(xp, a, A, k):

    def f0(j, A_j):
        v1 = A_j > 0.0
        return xp.where(v1, xp.where(v1, A_j, 1.0) * (power_factor(xp, j, k) * a ** j), 0.0)
    return sum([f0(j, A_j) for j, A_j in numbered(A)])


def force(xp, a, A, H, k):

    def f3(j, A_j):
        v4 = A_j > 0.0
        return xp.where(v4, xp.where(v4, A_j, 1.0) * power_force(xp, a, j, k), 0.0)
    return 2.0 * H / (1.0 + k) * sum([f3(j, A_j) for j, A_j in numbered(A)])


def pressure(xp, r, a, A, H, k):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)

    def f3(j, A_j):
        v4 = A_j > 0.0
        v9 = xp.where(v4, xp.where(v4, A_j, 1.0) * power_pressure(xp, xp.minimum(v2, a), a, j, k), 0.0)
        return v9
    v12 = xp.where(v1, 2.0 * a, r)
    v13 = xp.where(v1, H / 3.141592653589793 * sum([f3(j, A_j) for j, A_j in numbered(A)]), 0.0)
    return v13


def displacement(xp, r, a, A, k):

    def f0(j, A_j):
        v1 = A_j > 0.0
        return xp.where(v1, xp.where(v1, A_j, 1.0) * power_displacement(xp, r, a, j, k), 0.0)
    return sum([f0(j, A_j) for j, A_j in numbered(A)])


def rate(xp, a, A, k):

    def f0(j, A_j):
        v1 = A_j > 0.0
        return xp.where(v1, xp.where(v1, A_j, 1.0) * power_rate(xp, a, j, k), 0.0)
    return sum([f0(j, A_j) for j, A_j in numbered(A)])


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, A, H, k):

    def f4(j, A_j):
        v5 = A_j > 0.0
        return xp.where(v5, xp.where(v5, A_j, 1.0) * power_mean(xp, a, j, k), 0.0)
    v11 = 2.0 * H / (1.0 + k) / 3.141592653589793 * sum([f4(j, A_j) for j, A_j in numbered(A)])
    return v11


def radius_from_depth(xp, d, A, k):

    def f1(v2):
        v3 = depth(xp, v2, A, k)
        return (v3, v2 * rate(xp, v2, A, k) / v3)
    return newton(xp, f1, d + 0.0, 1.0, xp.inf, 1e-06, xp.inf)


def radius_from_force(xp, F, A, H, k):

    def f1(v2):
        v3 = force(xp, v2, A, H, k)
        return (v3, v2 * (punch_stiffness(xp, v2, H, k) * rate(xp, v2, A, k)) / v3)
    return newton(xp, f1, F + 0.0, 1.0, xp.inf, 1e-06, xp.inf)


def force_from_depth(xp, d, A, H, k):
    v1 = radius_from_depth(xp, d, A, k)
    return force(xp, v1, A, H, k) + punch_force(xp, d - depth(xp, v1, A, k), v1, H, k)


def depth_from_force(xp, F, A, H, k):
    v1 = radius_from_force(xp, F, A, H, k)
    return depth(xp, v1, A, k) + punch_depth(xp, F - force(xp, v1, A, H, k), v1, H, k)
