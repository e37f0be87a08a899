"""Formulas of axicontact.graded.normal.concave_quartic over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_sag
from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.punch import punch_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.concave_quartic import profile


def minimum_depth(xp, a, h, k):
    return -4.0 * h * (k - 1.0) / ((k + 1.0) ** 2.0 * (k + 3.0)) + 0.0 * a


def force(xp, d, a, h, H, k):
    v2 = minimum_depth(xp, a, h, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v14 = xp.where(v3, 2.0 * d, v2)
    v13 = punch_stiffness(xp, a, H, k) * (d + h * power_factor(xp, 4.0, k) * (1.0 + k) / (5.0 + k))
    return xp.where(v3, v13, xp.nan)


def pressure(xp, r, d, a, h, H, k):
    v1 = minimum_depth(xp, a, h, k)
    v2 = v1 * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v7 = a ** 2.0
    v14 = 4.0 * h * (k * v7 + 4.0 * r ** 2.0 - v7) ** 2.0
    v23 = d - v1 + v14 / (v7 ** 2.0 * (k + 1.0) ** 2.0 * (k + 3.0) ** 2.0)
    v26 = xp.where(v3, 2.0 * d, v2)
    return xp.where(v3, v23 * punch_pressure(xp, r, a, H, k), xp.nan)


def displacement(xp, r, d, a, h, k):
    v2 = minimum_depth(xp, a, h, k) * 0.999999999999999
    v3 = v2 <= d
    v4 = xp.where(v3, v2, 0.5 * d)
    v5 = r > a
    v6 = xp.where(v5, r, 2.0 * a)
    v14 = d * punch_share(xp, v6, a, k) + h * power_sag(xp, v6, a, 4.0, k) / (a ** 2.0) ** 2.0
    v19 = xp.where(v3, 2.0 * d, v2)
    v20 = xp.where(v3, xp.where(v5, v14, d - profile(xp, xp.where(v5, 0.5 * a, r), a, h)), xp.nan)
    return v20


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def minimum_force(xp, a, h, H, k):
    v9 = minimum_depth(xp, a, h, k) + h * power_factor(xp, 4.0, k) * (1.0 + k) / (5.0 + k)
    return punch_stiffness(xp, a, H, k) * v9


def depth_from_force(xp, F, a, h, H, k):
    v2 = minimum_force(xp, a, h, H, k) * 0.999999999999999
    v3 = v2 <= F
    v4 = xp.where(v3, v2, 0.5 * F)
    v14 = xp.where(v3, 2.0 * F, v2)
    v13 = F / punch_stiffness(xp, a, H, k) - h * power_factor(xp, 4.0, k) * (1.0 + k) / (5.0 + k)
    return xp.where(v3, v13, xp.nan)


def zero_radius(xp, a, h, k):
    return a * xp.sqrt(1.0 - k) / 2.0 + 0.0 * h
