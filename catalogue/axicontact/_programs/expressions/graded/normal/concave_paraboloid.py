"""Formulas of axicontact.graded.normal.concave_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_sag
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.punch import punch_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.concave_paraboloid import profile


def minimum_depth(xp, a, h, k):
    return -2.0 * h * (k - 1.0) / (k + 1.0) ** 2.0 + 0.0 * a


def force(xp, d, a, h, H, k):
    v2 = minimum_depth(xp, a, h, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v14 = xp.where(v3, 2.0 * d, v2)
    v13 = punch_stiffness(xp, a, H, k) * (d + h * power_factor(xp, 2.0, k) * (1.0 + k) / (3.0 + k))
    return xp.where(v3, v13, xp.nan)


def pressure(xp, r, d, a, h, H, k):
    v1 = minimum_depth(xp, a, h, k)
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v14 = d - v1 + 4.0 * h * r ** 2.0 / (a ** 2.0 * (k + 1.0) ** 2.0)
    v17 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, v14 * punch_pressure(xp, r, a, H, k), xp.nan)


def displacement(xp, r, d, a, h, k):
    v2 = minimum_depth(xp, a, h, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r > a
    v6 = xp.where(v5, r, 2.0 * a)
    v13 = d * punch_share(xp, v6, a, k) + h * power_sag(xp, v6, a, 2.0, k) / a ** 2.0
    v18 = xp.where(v3, 2.0 * d, v2)
    v19 = xp.where(v3, xp.where(v5, v13, d - profile(xp, xp.where(v5, 0.5 * a, r), a, h)), xp.nan)
    return v19


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def minimum_force(xp, a, h, H, k):
    v9 = minimum_depth(xp, a, h, k) + h * power_factor(xp, 2.0, k) * (1.0 + k) / (3.0 + k)
    return punch_stiffness(xp, a, H, k) * v9


def depth_from_force(xp, F, a, h, H, k):
    v2 = minimum_force(xp, a, h, H, k) * 0.999999999999999
    v3 = v2 <= F
    v4 = xp.where(v3, v2, 0.5 * F)
    v14 = xp.where(v3, 2.0 * F, v2)
    v13 = F / punch_stiffness(xp, a, H, k) - h * power_factor(xp, 2.0, k) * (1.0 + k) / (3.0 + k)
    return xp.where(v3, v13, xp.nan)


def zero_radius(xp, a, h, k):
    return 0.0 * a + 0.0 * h
