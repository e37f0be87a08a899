"""Formulas of axicontact.graded.normal.cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_mean
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.cone import profile


def depth(xp, a, theta, k):
    return power_factor(xp, 1.0, k) * a ** 1.0 * xp.tan(theta)


def force(xp, a, theta, H, k):
    return 2.0 * H / (1.0 + k) * (power_force(xp, a, 1.0, k) * xp.tan(theta))


def pressure(xp, r, a, theta, H, k):
    v1 = r < a
    v7 = power_pressure(xp, xp.minimum(xp.where(v1, r, 0.5 * a), a), a, 1.0, k) * xp.tan(theta)
    v9 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v7, 0.0)


def radius_from_force(xp, F, theta, H, k):
    return (F / force(xp, 1.0, theta, H, k)) ** (1.0 / (2.0 + k))


def displacement(xp, r, a, theta, k):
    return power_displacement(xp, r, a, 1.0, k) * xp.tan(theta)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, theta, H, k):
    v8 = 2.0 * H / (1.0 + k) / 3.141592653589793 * (power_mean(xp, a, 1.0, k) * xp.tan(theta))
    return v8


def radius_from_depth(xp, d, theta, k):
    return d / depth(xp, 1.0, theta, k)


def force_from_depth(xp, d, theta, H, k):
    v11 = d * (punch_stiffness(xp, d / depth(xp, 1.0, theta, k), H, k) * (1.0 / (1.0 + (1.0 + k))))
    return xp.where((d > 0.0) & xp.isfinite(d), v11, d)


def depth_from_force(xp, F, theta, H, k):
    v9 = punch_stiffness(xp, radius_from_force(xp, F, theta, H, k), H, k) * (1.0 / (1.0 + (1.0 + k)))
    return xp.where((F > 0.0) & xp.isfinite(F), F / v9, F)
