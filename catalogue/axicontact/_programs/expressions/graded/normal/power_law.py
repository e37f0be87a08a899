"""Formulas of axicontact.graded.normal.power_law over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_mean
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.power_law import profile


def depth(xp, a, A, n, k):
    return A * (power_factor(xp, n, k) * a ** n)


def force(xp, a, A, n, H, k):
    return 2.0 * H / (1.0 + k) * (A * power_force(xp, a, n, k))


def pressure(xp, r, a, A, n, H, k):
    v1 = r < a
    v6 = A * power_pressure(xp, xp.minimum(xp.where(v1, r, 0.5 * a), a), a, n, k)
    v8 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, H / 3.141592653589793 * v6, 0.0)


def radius_from_depth(xp, d, A, n, k):
    return (d / depth(xp, 1.0, A, n, k)) ** (1.0 / n)


def radius_from_force(xp, F, A, n, H, k):
    return (F / force(xp, 1.0, A, n, H, k)) ** (1.0 / (n + (1.0 + k)))


def displacement(xp, r, a, A, n, k):
    return A * power_displacement(xp, r, a, n, k)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, A, n, H, k):
    return 2.0 * H / (1.0 + k) / 3.141592653589793 * (A * power_mean(xp, a, n, k))


def force_from_depth(xp, d, A, n, H, k):
    v10 = d * (punch_stiffness(xp, radius_from_depth(xp, d, A, n, k), H, k) * (n / (n + (1.0 + k))))
    return xp.where((d > 0.0) & xp.isfinite(d), v10, d)


def depth_from_force(xp, F, A, n, H, k):
    v10 = F / (punch_stiffness(xp, radius_from_force(xp, F, A, n, H, k), H, k) * (n / (n + (1.0 + k))))
    return xp.where((F > 0.0) & xp.isfinite(F), v10, F)
