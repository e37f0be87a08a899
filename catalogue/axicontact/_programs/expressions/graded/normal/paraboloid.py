"""Formulas of axicontact.graded.normal.paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_mean
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.paraboloid import profile


def depth(xp, a, R, k):
    return power_factor(xp, 2.0, k) * a ** 2.0 / (2.0 * R)


def force(xp, a, R, H, k):
    return 2.0 * H / (1.0 + k) * (power_force(xp, a, 2.0, k) / (2.0 * R))


def pressure(xp, r, a, R, H, k):
    v1 = r < a
    v7 = power_pressure(xp, xp.minimum(xp.where(v1, r, 0.5 * a), a), a, 2.0, k) / (2.0 * R)
    v9 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v7, 0.0)


def radius_from_force(xp, F, R, H, k):
    return (F / force(xp, 1.0, R, H, k)) ** (1.0 / (3.0 + k))


def displacement(xp, r, a, R, k):
    return power_displacement(xp, r, a, 2.0, k) / (2.0 * R)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, R, H, k):
    return 2.0 * H / (1.0 + k) / 3.141592653589793 * (power_mean(xp, a, 2.0, k) / (2.0 * R))


def radius_from_depth(xp, d, R, k):
    return xp.sqrt(d / depth(xp, 1.0, R, k))


def force_from_depth(xp, d, R, H, k):
    v11 = punch_stiffness(xp, xp.sqrt(d / depth(xp, 1.0, R, k)), H, k) * (2.0 / (2.0 + (1.0 + k)))
    return xp.where((d > 0.0) & xp.isfinite(d), d * v11, d)


def depth_from_force(xp, F, R, H, k):
    v10 = F / (punch_stiffness(xp, radius_from_force(xp, F, R, H, k), H, k) * (2.0 / (2.0 + (1.0 + k))))
    return xp.where((F > 0.0) & xp.isfinite(F), v10, F)
