"""Formulas of axicontact.normal.hyperboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.special import arctan_gap
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def depth(xp, a, theta, b):
    return xp.tan(theta) * a * xp.arctan(a / b)


def force(xp, a, theta, b, E_star):
    v10 = a ** 2.0 * xp.arctan2(a, b) + b ** 2.0 * arctan_gap(xp, a / b)
    return E_star * xp.tan(theta) * v10


def slope(xp, t, theta, b):
    v1 = xp.tan(theta)
    return v1 * xp.arctan(t / b) + b * v1 * t / (t ** 2.0 + b ** 2.0)


def pressure(xp, r, a, theta, b, E_star):
    v11, v12 = nodes_along(xp, 1, r, a, theta, b, E_star)
    v1 = r < a
    v2 = xp.where(v1, r, 0.5 * a)
    v4 = difference_root(xp, a, v2)
    v5 = v2 * v2
    v8 = xp.sqrt(v5 + b * b)
    v10 = xp.arcsinh(v4 / v8)
    v13 = v11 * v10
    v23 = 0.0 - xp.expm1(-2.0 * v10)
    v24 = v23 > 0.0
    v20 = xp.exp(-v13) * (0.0 - xp.expm1(-2.0 * (v10 - v13)))
    v28 = v4 * (v20 / xp.where(v24, xp.where(v24, v23, 1.0), xp.inf))
    v29 = v28 * v28
    v31 = xp.sqrt(v5 + v29)
    v38 = v10 * xp.sum(v12 * (slope(xp, v31, theta, b) / v31 * xp.sqrt(v8 * v8 + v29)), axis=0)
    v40 = xp.where(v1, 2.0 * a, r)
    return xp.where(v1, E_star / 3.141592653589793 * v38, 0.0)


def profile(xp, r, theta, b):
    v2 = r ** 2.0
    return xp.tan(theta) * v2 / (xp.sqrt(v2 + b ** 2.0) + b)


def displacement(xp, r, a, theta, b):
    v12, v13 = nodes_along(xp, 1, r, a, theta, b)
    v1 = r > a
    v2 = xp.where(v1, r, 2.0 * a)
    v4 = a / difference_root(xp, v2, a)
    v9 = b / xp.sqrt(v2 * v2 + b * b)
    v11 = xp.arcsinh(v4 / v9)
    v14 = v12 * v11
    v24 = 0.0 - xp.expm1(-2.0 * v11)
    v25 = v24 > 0.0
    v21 = xp.exp(-v14) * (0.0 - xp.expm1(-2.0 * (v11 - v14)))
    v29 = v4 * (v21 / xp.where(v25, xp.where(v25, v24, 1.0), xp.inf))
    v31 = v29 * v29
    v33 = xp.sqrt(1.0 + v31)
    v37 = slope(xp, v2 * v29 / v33, theta, b) * xp.arctan(v29)
    v46 = v2 * (v11 * xp.sum(v13 * (v37 * (xp.sqrt(v9 * v9 + v31) / (v33 * v33 * v33))), axis=0))
    v51 = depth(xp, a, theta, b) - profile(xp, xp.where(v1, 0.5 * a, r), theta, b)
    return xp.where(v1, 0.6366197723675814 * v46, v51)


def stiffness(xp, a, E_star):
    return 2.0 * E_star * a


def mean_pressure(xp, a, theta, b, E_star):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    return xp.where(v1, force(xp, v2, theta, b, E_star) / (3.141592653589793 * v2 ** 2.0), 0.0)


def radius_from_depth(xp, d, theta, b):

    def f1(v2):
        v3 = depth(xp, v2, theta, b)
        return (v3, v2 * slope(xp, v2, theta, b) / v3)
    return newton(xp, f1, d, b / 1000.0, xp.inf, 1.0, 2.0)


def radius_from_force(xp, F, theta, b, E_star):

    def f1(v2):
        v3 = force(xp, v2, theta, b, E_star)
        return (v3, 2.0 * E_star * v2 ** 2.0 * slope(xp, v2, theta, b) / v3)
    return newton(xp, f1, F, b / 1000.0, xp.inf, 2.0, 3.0)


def force_from_depth(xp, d, theta, b, E_star):
    v1 = radius_from_depth(xp, d, theta, b)
    v10 = 2.0 * E_star * v1 * (d - depth(xp, v1, theta, b))
    return force(xp, v1, theta, b, E_star) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def depth_from_force(xp, F, theta, b, E_star):
    v1 = radius_from_force(xp, F, theta, b, E_star)
    v10 = (F - force(xp, v1, theta, b, E_star)) / (2.0 * E_star * v1)
    return depth(xp, v1, theta, b) + xp.where((v1 > 0.0) & (v1 < xp.inf), v10, 0.0)


def energy(xp, a, theta, b, E_star):
    v3, v4 = nodes_along(xp, 1, a, theta, b, E_star)
    v2 = xp.arcsinh(a / b)
    v5 = v3 * v2
    v16 = 0.0 - xp.expm1(-2.0 * v2)
    v17 = v16 > 0.0
    v13 = xp.exp(-v5) * (0.0 - xp.expm1(-2.0 * (v2 - v5)))
    v21 = a * (v13 / xp.where(v17, xp.where(v17, v16, 1.0), xp.inf))
    v23 = depth(xp, a, theta, b) - depth(xp, v21, theta, b)
    return E_star * (v2 * xp.sum(v4 * (v23 * v23 * xp.sqrt(b * b + v21 * v21)), axis=0))


def load_within(xp, r, a, theta, b, E_star):
    v10, v11 = nodes_along(xp, 1, r, a, theta, b, E_star)
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
    v36 = v6 * (v9 * xp.sum(v11 * (slope(xp, v30, theta, b) * (v27 / (v30 + v27))), axis=0))
    return force(xp, v1, theta, b, E_star) + 2.0 * E_star * xp.where(v4, v36, 0.0)
