"""Formulas of axicontact.graded.tangential.power_law over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.power_law import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.power_law import force as graded_normal_force
from ....._programs.expressions.graded.normal.power_law import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.power_law import radius_from_force as graded_normal_radius_from_force


def tangential_force(xp, a, c, A, n, H, k, mu):
    v2 = 1.0 + k
    v10 = mu * (2.0 * H / v2) * (A * (power_force(xp, a, n, k) * gained_share(xp, c, a, n + v2)))
    return v10


def traction(xp, r, a, c, A, n, H, k, mu):
    v1 = r < c
    v7 = power_growth(xp, xp.minimum(xp.where(v1, r, 0.5 * c), c), c, a, n, k)
    v12 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, A, n, H, k)
    v14 = mu * xp.where(v1, H / 3.141592653589793 * (A * (power_factor(xp, n, k) * n * v7)), v12)
    return v14


def tangential_displacement(xp, a, c, A, n, H, H_x, k, mu):
    v9 = mu * (H / H_x) * (A * (power_factor(xp, n, k) * a ** n * gained_share(xp, c, a, n)))
    return v9


def stick_radius(xp, F_x, a, A, n, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, A, n, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, A, n, H, k))
    return v7


def full_slip_displacement(xp, a, A, n, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, A, n, k)
