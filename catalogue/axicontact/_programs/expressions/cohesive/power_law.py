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
    v16, v17 = nodes_along(xp, 1, a, c, A, n, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = a > 0.0
    v5 = xp.where(v4, a, 1.0)
    v7 = v5 > 0.0
    v11 = xp.where(v4, difference_root(xp, c, v5) / xp.where(v7, xp.where(v7, v5, 1.0), 1.0), xp.inf)
    v15 = xp.minimum(xp.arcsinh(v11), 40.0 / xp.minimum(n, 1.0))
    v18 = v16 * v15
    v19 = xp.cosh(v18)
    v23 = xp.sinh(v18)
    v27 = normal_slope(xp, v2 / v19, A, n) / v19 * xp.arctan(v23) * (v23 / v19)
    v37 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (xp.arctan2(v1, a) - v1 / (v2 + a))
    return sigma_0 * (0.6366197723675814 * v2 * (v15 * xp.sum(v17 * v27, axis=0)) + v37)


def zone(xp, a, A, n, E_star, dgamma, sigma_0):
    v28, v29 = nodes_along(xp, 1, a, A, n, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v3 = 1.2732395447351628 * (sigma_0 / E_star)
    v4 = v1 / v3
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = xp.hypot(a, v14)
        v17 = a > 0.0
        v18 = xp.where(v17, a, 1.0)
        v19 = v18 > 0.0
        v24 = xp.arcsinh(xp.where(v17, v14 / xp.where(v19, xp.where(v19, v18, 1.0), 1.0), xp.inf))
        v27 = xp.minimum(v24, 40.0 / xp.minimum(n, 1.0))
        v30 = v28 * v27
        v31 = xp.cosh(v30)
        v35 = xp.sinh(v30)
        v39 = normal_slope(xp, v15 / v31, A, n) / v31 * xp.arctan(v35) * (v35 / v31)
        v43 = xp.arctan2(v14, a)
        v45 = v14 / (v15 + a)
        v48 = 0.6366197723675814 * v15 * (v27 * xp.sum(v29 * v39, axis=0)) + v3 * v14 * (v43 - v45)
        v50 = v14 / v15
        v53 = xp.cosh(v28 * v27)
        v58 = v27 * xp.sum(v29 * (normal_slope(xp, v15 / v53, A, n) / v53 / v53), axis=0)
        v65 = v14 / v48 * v50 * (0.6366197723675814 * v58 + v3 * (v43 / v50 - v50 * v45))
        return (v48, v65)
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
