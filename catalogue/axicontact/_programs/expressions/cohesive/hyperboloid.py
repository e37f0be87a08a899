"""Formulas of axicontact.cohesive.hyperboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.hyperboloid import depth as normal_depth
from ...._programs.expressions.normal.hyperboloid import displacement as normal_displacement
from ...._programs.expressions.normal.hyperboloid import force as normal_force
from ...._programs.expressions.normal.hyperboloid import pressure as normal_pressure
from ...._programs.expressions.normal.hyperboloid import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, theta, b, E_star, sigma_0):
    v14, v15 = nodes_along(xp, 1, a, c, theta, b, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = a > 0.0
    v5 = xp.where(v4, a, 1.0)
    v7 = v5 > 0.0
    v11 = xp.where(v4, difference_root(xp, c, v5) / xp.where(v7, xp.where(v7, v5, 1.0), 1.0), xp.inf)
    v13 = xp.minimum(xp.arcsinh(v11), 40.0)
    v16 = v14 * v13
    v17 = xp.cosh(v16)
    v21 = xp.sinh(v16)
    v25 = normal_slope(xp, v2 / v17, theta, b) / v17 * xp.arctan(v21) * (v21 / v17)
    v35 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (xp.arctan2(v1, a) - v1 / (v2 + a))
    return sigma_0 * (0.6366197723675814 * v2 * (v13 * xp.sum(v15 * v25, axis=0)) + v35)


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v26, v27 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
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
        v25 = xp.minimum(v24, 40.0)
        v28 = v26 * v25
        v29 = xp.cosh(v28)
        v33 = xp.sinh(v28)
        v37 = normal_slope(xp, v15 / v29, theta, b) / v29 * xp.arctan(v33) * (v33 / v29)
        v41 = xp.arctan2(v14, a)
        v43 = v14 / (v15 + a)
        v46 = 0.6366197723675814 * v15 * (v25 * xp.sum(v27 * v37, axis=0)) + v3 * v14 * (v41 - v43)
        v48 = v14 / v15
        v51 = xp.cosh(v26 * v25)
        v56 = v25 * xp.sum(v27 * (normal_slope(xp, v15 / v51, theta, b) / v51 / v51), axis=0)
        v63 = v14 / v46 * v48 * (0.6366197723675814 * v56 + v3 * (v41 / v48 - v48 * v43))
        return (v46, v63)
    v13 = xp.minimum(v6 + xp.sqrt(v6 ** 2.0 + 2.0 * a * v4), xp.inf)
    return newton(xp, f13, v1, v13, xp.inf, 0.5, 4.0)


def cohesive_radius(xp, a, theta, b, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, theta, b, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, theta, b, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, theta, b) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, theta, b, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)
    return v2


def force(xp, a, theta, b, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, theta, b, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, theta, b, E_star) - v3


def pressure(xp, r, a, theta, b, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, theta, b, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, theta, b, E_star) - v3


def displacement(xp, r, a, theta, b, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, theta, b, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, theta, b) - v3
