"""Formulas of axicontact.graded.normal.sextic over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_mean
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.sextic import profile


def depth(xp, a, A, k):
    return A * (power_factor(xp, 6.0, k) * a ** 6.0)


def force(xp, a, A, H, k):
    return 2.0 * H / (1.0 + k) * (A * power_force(xp, a, 6.0, k))


def pressure(xp, r, a, A, H, k):
    v1 = r < a
    v6 = A * power_pressure(xp, xp.minimum(xp.where(v1, r, 0.5 * a), a), a, 6.0, k)
    v8 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v6, 0.0)


def radius_from_force(xp, F, A, H, k):
    return (F / force(xp, 1.0, A, H, k)) ** (1.0 / (7.0 + k))


def displacement(xp, r, a, A, k):
    return A * power_displacement(xp, r, a, 6.0, k)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, A, H, k):
    return 2.0 * H / (1.0 + k) / 3.141592653589793 * (A * power_mean(xp, a, 6.0, k))


def radius_from_depth(xp, d, A, k):
    return (d / depth(xp, 1.0, A, k)) ** 0.16666666666666666


def force_from_depth(xp, d, A, H, k):
    v7 = punch_stiffness(xp, (d / depth(xp, 1.0, A, k)) ** 0.16666666666666666, H, k)
    return xp.where((d > 0.0) & xp.isfinite(d), d * (v7 * (6.0 / (6.0 + (1.0 + k)))), d)


def depth_from_force(xp, F, A, H, k):
    v10 = F / (punch_stiffness(xp, radius_from_force(xp, F, A, H, k), H, k) * (6.0 / (6.0 + (1.0 + k))))
    return xp.where((F > 0.0) & xp.isfinite(F), v10, F)
