"""Formulas of axicontact.graded.normal.flat_punch over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import punch_share
from ....._programs.expressions._runtime.graded.punch import punch_pressure
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions.normal.flat_punch import profile


def force(xp, d, a, H, k):
    return punch_stiffness(xp, a, H, k) * d


def pressure(xp, r, d, a, H, k):
    v1 = d > 0.0
    return xp.where(v1, xp.where(v1, d, 1.0) * punch_pressure(xp, r, a, H, k), 0.0)


def displacement(xp, r, d, a, k):
    v1 = r > a
    v4 = xp.where(v1, 0.5 * a, r)
    return d * xp.where(v1, punch_share(xp, xp.where(v1, r, 2.0 * a), a, k), 1.0)


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def depth_from_force(xp, F, a, H, k):
    return F / punch_stiffness(xp, a, H, k)
