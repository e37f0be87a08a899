"""Formulas of axicontact.normal.polynomial over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.shapes.powers import power_displacement
from ...._programs.expressions._runtime.shapes.powers import power_pressure
from ...._runtime.functions import depth_over_height
from ...._runtime.steps import least
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along
from ...._runtime.steps import numbered


def depth(xp, a, A):

    def f0(j, A_j):
        v1 = A_j > 0.0
        return xp.where(v1, depth_over_height(j) * a ** j * xp.where(v1, A_j, 1.0), 0.0)
    return sum([f0(j, A_j) for j, A_j in numbered(A)])


def force(xp, a, A, E_star):

    def f1(j, A_j):
        v2 = A_j > 0.0
        v6 = j + 1.0
        v11 = xp.where(v2, j * depth_over_height(j) / v6 * a ** v6 * xp.where(v2, A_j, 1.0), 0.0)
        return v11
    return 2.0 * E_star * sum([f1(j, A_j) for j, A_j in numbered(A)])


def pressure(xp, r, a, A, E_star):
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)

    def f3(j, A_j):
        v4 = A_j > 0.0
        v12 = j * depth_over_height(j) * a ** (j - 1.0) * power_pressure(xp, v2, a, j)
        return xp.where(v4, v12 * xp.where(v4, A_j, 1.0), 0.0)
    v17 = xp.where(v1, 2.0 * a, r)
    v18 = xp.where(v1, E_star / 3.141592653589793 * sum([f3(j, A_j) for j, A_j in numbered(A)]), 0.0)
    return v18


def profile(xp, r, A):

    def f0(j, A_j):
        v1 = A_j > 0.0
        return xp.where(v1, r ** j * xp.where(v1, A_j, 1.0), 0.0)
    return sum([f0(j, A_j) for j, A_j in numbered(A)])


def displacement(xp, r, a, A):
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)

    def f2(j, A_j):
        v3 = A_j > 0.0
        v9 = depth_over_height(j) * a ** j * power_displacement(xp, v2, a, j)
        return xp.where(v3, v9 * xp.where(v3, A_j, 1.0), 0.0)
    v14 = 2.0 * sum([f2(j, A_j) for j, A_j in numbered(A)]) / 3.141592653589793
    return xp.where(v1, v14, depth(xp, a, A) - profile(xp, xp.where(v1, 0.5 * a, r), A))


def slope(xp, a, A):

    def f0(j, A_j):
        v1 = A_j > 0.0
        v9 = xp.where(v1, j * depth_over_height(j) * a ** (j - 1.0) * xp.where(v1, A_j, 1.0), 0.0)
        return v9
    return sum([f0(j, A_j) for j, A_j in numbered(A)])


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, A, E_star):

    def f2(j, A_j):
        v3 = A_j > 0.0
        v12 = j * depth_over_height(j) / (j + 1.0) * a ** (j - 1.0) * xp.where(v3, A_j, 1.0)
        return xp.where(v3, v12, 0.0)
    return 2.0 * E_star / 3.141592653589793 * sum([f2(j, A_j) for j, A_j in numbered(A)])


def radius_from_depth(xp, d, A):

    def f0(j, A_j):
        v1 = A_j > 0.0
        v8 = xp.where(v1, xp.log(d / depth_over_height(j) / xp.where(v1, A_j, 1.0)) / j, xp.inf)
        return v8

    def f13(v12):
        v13 = depth(xp, v12, A)
        return (v13, v12 * slope(xp, v12, A) / v13)
    v10 = xp.exp(least(xp, [f0(j, A_j) for j, A_j in numbered(A)]))
    return newton(xp, f13, d, v10, xp.inf, 1.0, len(numbered(A)))


def radius_from_force(xp, F, A, E_star):

    def f0(j, A_j):
        v1 = A_j > 0.0
        v3 = j + 1.0
        v11 = xp.log(v3 / (2.0 * E_star * j * depth_over_height(j)) * F / xp.where(v1, A_j, 1.0))
        return xp.where(v1, v11 / v3, xp.inf)

    def f19(v18):
        v19 = force(xp, v18, A, E_star)
        return (v19, 2.0 * E_star * v18 ** 2.0 * slope(xp, v18, A) / v19)
    v15 = xp.exp(least(xp, [f0(j, A_j) for j, A_j in numbered(A)]))
    return newton(xp, f19, F, v15, xp.inf, 2.0, len(numbered(A)) + 1.0)


def force_from_depth(xp, d, A, E_star):
    v1 = radius_from_depth(xp, d, A)
    v11 = xp.where((v1 > 0.0) & (v1 < xp.inf), 2.0 * E_star * v1 * (d - depth(xp, v1, A)), 0.0)
    return force(xp, v1, A, E_star) + v11


def depth_from_force(xp, F, A, E_star):
    v1 = radius_from_force(xp, F, A, E_star)
    v10 = (F - force(xp, v1, A, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, A) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def energy(xp, a, A, E_star):
    v3, v4 = nodes_along(xp, 1, a, E_star)
    v2 = xp.arcsinh(a / a)
    v5 = v3 * v2
    v16 = 0.0 - xp.expm1(-2.0 * v2)
    v17 = v16 > 0.0
    v13 = xp.exp(-v5) * (0.0 - xp.expm1(-2.0 * (v2 - v5)))
    v21 = a * (v13 / xp.where(v17, xp.where(v17, v16, 1.0), xp.inf))
    v23 = depth(xp, a, A) - depth(xp, v21, A)
    return E_star * (v2 * xp.sum(v4 * (v23 * v23 * xp.sqrt(a * a + v21 * v21)), axis=0))


def load_within(xp, r, a, A, E_star):
    v10, v11 = nodes_along(xp, 1, r, a, E_star)
    v1 = xp.minimum(r, a)
    v4 = v1 > 0.0
    v5 = xp.where(v4, v1, 1.0)
    v6 = v5 * v5
    v7 = difference_root(xp, a, v5)
    v9 = xp.arcsinh(v7 / v5)
    v12 = v10 * v9
    v22 = 0.0 - xp.expm1(-2.0 * v9)
    v23 = v22 > 0.0
    v19 = xp.exp(-v12) * (0.0 - xp.expm1(-2.0 * (v9 - v12)))
    v27 = v7 * (v19 / xp.where(v23, xp.where(v23, v22, 1.0), xp.inf))
    v30 = xp.sqrt(v6 + v27 * v27)
    v37 = xp.where(v4, v6 * (v9 * xp.sum(v11 * (slope(xp, v30, A) * (v27 / (v30 + v27))), axis=0)), 0.0)
    return force(xp, v1, A, E_star) + 2.0 * E_star * v37
