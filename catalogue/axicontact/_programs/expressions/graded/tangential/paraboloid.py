"""Formulas of axicontact.graded.tangential.paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.paraboloid import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.paraboloid import force as graded_normal_force
from ....._programs.expressions.graded.normal.paraboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.paraboloid import radius_from_force as graded_normal_radius_from_force


def tangential_force(xp, a, c, R, H, k, mu):
    v2 = 1.0 + k
    v10 = power_force(xp, a, 2.0, k) * gained_share(xp, c, a, 2.0 + v2) / (2.0 * R)
    return mu * (2.0 * H / v2) * v10


def traction(xp, r, a, c, R, H, k, mu):
    v1 = r < c
    v7 = power_growth(xp, xp.minimum(xp.where(v1, r, 0.5 * c), c), c, a, 2.0, k)
    v11 = H / 3.141592653589793 * (power_factor(xp, 2.0, k) * 2.0 * v7 / (2.0 * R))
    v15 = mu * xp.where(v1, v11, graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, R, H, k))
    return v15


def tangential_displacement(xp, a, c, R, H, H_x, k, mu):
    v9 = power_factor(xp, 2.0, k) * a ** 2.0 * gained_share(xp, c, a, 2.0) / (2.0 * R)
    return mu * (H / H_x) * v9


def stick_radius(xp, F_x, a, R, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, R, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, R, H, k))
    return v7


def full_slip_displacement(xp, a, R, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, R, k)
