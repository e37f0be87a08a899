"""Formulas of axicontact.graded.tangential.polynomial over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.polynomial import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.polynomial import force as graded_normal_force
from ....._programs.expressions.graded.normal.polynomial import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.polynomial import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import numbered


def tangential_force(xp, a, c, A, H, k, mu):
    v2 = 1.0 + k

    def f4(j, A_j):
        v5 = A_j > 0.0
        v11 = xp.where(v5, A_j, 1.0) * (power_force(xp, a, j, k) * gained_share(xp, c, a, j + v2))
        return xp.where(v5, v11, 0.0)
    return mu * (2.0 * H / v2) * sum([f4(j, A_j) for j, A_j in numbered(A)])


def traction(xp, r, a, c, A, H, k, mu):
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)

    def f3(j, A_j):
        v4 = A_j > 0.0
        v10 = power_factor(xp, j, k) * j * power_growth(xp, xp.minimum(v2, c), c, a, j, k)
        return xp.where(v4, xp.where(v4, A_j, 1.0) * v10, 0.0)
    v14 = H / 3.141592653589793 * sum([f3(j, A_j) for j, A_j in numbered(A)])
    v18 = mu * xp.where(v1, v14, graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, A, H, k))
    return v18


def tangential_displacement(xp, a, c, A, H, H_x, k, mu):

    def f2(j, A_j):
        v3 = A_j > 0.0
        v10 = xp.where(v3, A_j, 1.0) * (power_factor(xp, j, k) * a ** j * gained_share(xp, c, a, j))
        return xp.where(v3, v10, 0.0)
    return mu * (H / H_x) * sum([f2(j, A_j) for j, A_j in numbered(A)])


def stick_radius(xp, F_x, a, A, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, A, H, k), F_x, mu)
    v7 = xp.where((F_x == 0.0) & (a >= 0.0), a, graded_normal_radius_from_force(xp, v5, A, H, k))
    return v7


def full_slip_displacement(xp, a, A, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, A, k)
