"""Formulas of axicontact.graded.normal.concave_power over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_sag
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.punch import punch_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.shapes.ring import lifted_at_zero_pressure
from ....._programs.expressions._runtime.shapes.ring import ring_of_zero_pressure
from ....._programs.expressions.normal.concave_power import profile


def minimum_depth(xp, a, h, n, k):
    v8 = h * power_factor(xp, n, k) * (1.0 - k) / lifted_at_zero_pressure(xp, n, k) + 0.0 * a
    return v8


def force(xp, d, a, h, n, H, k):
    v2 = minimum_depth(xp, a, h, n, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v13 = d + h * power_factor(xp, n, k) * (1.0 + k) / (n + 1.0 + k)
    v15 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, punch_stiffness(xp, a, H, k) * v13, xp.nan)


def pressure(xp, r, d, a, h, n, H, k):
    v2 = minimum_depth(xp, a, h, n, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r < a
    v6 = xp.where(v5, r, 0.5 * a)
    v18 = H / 3.141592653589793 * h * power_pressure(xp, xp.minimum(v6, a), a, n, k) / a ** n
    v19 = (d + h * power_factor(xp, n, k)) * punch_pressure(xp, v6, a, H, k) - v18
    v25 = (d + h * power_factor(xp, n, k)) * punch_pressure(xp, xp.where(v5, 2.0 * a, r), a, H, k)
    v27 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, xp.where(v5, v19, v25), xp.nan)


def displacement(xp, r, d, a, h, n, k):
    v2 = minimum_depth(xp, a, h, n, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r > a
    v6 = xp.where(v5, r, 2.0 * a)
    v13 = d * punch_share(xp, v6, a, k) + h * power_sag(xp, v6, a, n, k) / a ** n
    v18 = xp.where(v3, 2.0 * d, v2)
    v19 = xp.where(v3, xp.where(v5, v13, d - profile(xp, xp.where(v5, 0.5 * a, r), a, h, n)), xp.nan)
    return v19


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def minimum_force(xp, a, h, n, H, k):
    v10 = minimum_depth(xp, a, h, n, k) + h * power_factor(xp, n, k) * (1.0 + k) / (n + 1.0 + k)
    return punch_stiffness(xp, a, H, k) * v10


def depth_from_force(xp, F, a, h, n, H, k):
    v2 = minimum_force(xp, a, h, n, H, k) * 0.999999999999999
    v3 = v2 <= F
    v4 = xp.where(v3, v2, 0.5 * F)
    v13 = h * power_factor(xp, n, k) * (1.0 + k) / (n + 1.0 + k)
    v15 = xp.where(v3, 2.0 * F, v2)
    return xp.where(v3, F / punch_stiffness(xp, a, H, k) - v13, xp.nan)


def zero_radius(xp, a, h, n, k):
    return a * ring_of_zero_pressure(xp, n, k) + 0.0 * h
