"""Formulas of axicontact.cohesive.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.power_law import depth as normal_depth
from ...._programs.expressions.normal.power_law import displacement as normal_displacement
from ...._programs.expressions.normal.power_law import force as normal_force
from ...._programs.expressions.normal.power_law import pressure as normal_pressure
from ...._programs.expressions.normal.power_law import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, A, n, E_star, sigma_0):
    v17, v18 = nodes_along(xp, 1, a, c, A, n, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = a > 0.0
    v5 = xp.where(v4, a, 1.0)
    v7 = v5 > 0.0
    v11 = xp.where(v4, difference_root(xp, c, v5) / xp.where(v7, xp.where(v7, v5, 1.0), 1.0), xp.inf)
    v16 = xp.arcsinh(xp.minimum(xp.arcsinh(v11), 40.0 / xp.minimum(n, 1.2)))
    v19 = v17 * v16
    v20 = xp.sinh(v19)
    v21 = xp.cosh(v20)
    v27 = xp.sinh(v20)
    v31 = normal_slope(xp, v2 / v21, A, n) / v21 * xp.cosh(v19) * xp.arctan(v27) * (v27 / v21)
    v41 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (xp.arctan2(v1, a) - v1 / (v2 + a))
    return sigma_0 * (0.6366197723675814 * v2 * (v16 * xp.sum(v18 * v31, axis=0)) + v41)


def zone(xp, a, A, n, E_star, dgamma, sigma_0):
    v29, v30 = nodes_along(xp, 1, a, A, n, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = xp.hypot(a, v14)
        v17 = a > 0.0
        v18 = xp.where(v17, a, 1.0)
        v19 = v18 > 0.0
        v24 = xp.arcsinh(xp.where(v17, v14 / xp.where(v19, xp.where(v19, v18, 1.0), 1.0), xp.inf))
        v28 = xp.arcsinh(xp.minimum(v24, 40.0 / xp.minimum(n, 1.2)))
        v31 = v29 * v28
        v32 = xp.sinh(v31)
        v33 = xp.cosh(v32)
        v39 = xp.sinh(v32)
        v43 = normal_slope(xp, v15 / v33, A, n) / v33 * xp.cosh(v31) * xp.arctan(v39) * (v39 / v33)
        v47 = 1.2732395447351628 * (sigma_0 / E_star)
        v49 = xp.arctan2(v14, a)
        v51 = v14 / (v15 + a)
        v54 = 0.6366197723675814 * v15 * (v28 * xp.sum(v30 * v43, axis=0)) + v47 * v14 * (v49 - v51)
        v56 = v14 / v15
        v58 = v29 * v28
        v60 = xp.cosh(xp.sinh(v58))
        v66 = normal_slope(xp, v15 / v60, A, n) / v60 * xp.cosh(v58) / v60
        v73 = 0.6366197723675814 * (v28 * xp.sum(v30 * v66, axis=0)) + v47 * (v49 / v56 - v56 * v51)
        return (v54, v14 / v54 * v56 * v73)
    v13 = xp.minimum(v6 + xp.sqrt(v6 ** 2.0 + 2.0 * a * v4), xp.inf)
    return newton(xp, f13, v1, v13, xp.inf, 0.5, 4.0)


def cohesive_radius(xp, a, A, n, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, A, n, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, A, n, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, A, n) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, A, n, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, A, n, E_star, dgamma, sigma_0), A, n, E_star, dgamma, sigma_0)
    return v2


def force(xp, a, A, n, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, A, n, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, A, n, E_star) - v3


def pressure(xp, r, a, A, n, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, A, n, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, A, n, E_star) - v3


def displacement(xp, r, a, A, n, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, A, n, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, A, n) - v3
