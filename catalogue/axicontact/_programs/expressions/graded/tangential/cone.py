"""Formulas of axicontact.graded.tangential.cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.cone import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.cone import force as graded_normal_force
from ....._programs.expressions.graded.normal.cone import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.cone import radius_from_force as graded_normal_radius_from_force


def tangential_force(xp, a, c, theta, H, k, mu):
    v2 = 1.0 + k
    v10 = power_force(xp, a, 1.0, k) * gained_share(xp, c, a, 1.0 + v2) * xp.tan(theta)
    return mu * (2.0 * H / v2) * v10


def traction(xp, r, a, c, theta, H, k, mu):
    v1 = r < c
    v6 = power_growth(xp, xp.minimum(xp.where(v1, r, 0.5 * c), c), c, a, 1.0, k)
    v10 = H / 3.141592653589793 * (power_factor(xp, 1.0, k) * v6 * xp.tan(theta))
    v14 = mu * xp.where(v1, v10, graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, theta, H, k))
    return v14


def tangential_displacement(xp, a, c, theta, H, H_x, k, mu):
    v9 = power_factor(xp, 1.0, k) * a ** 1.0 * gained_share(xp, c, a, 1.0) * xp.tan(theta)
    return mu * (H / H_x) * v9


def stick_radius(xp, F_x, a, theta, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, theta, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, theta, H, k))
    return v7


def full_slip_displacement(xp, a, theta, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, theta, k)
