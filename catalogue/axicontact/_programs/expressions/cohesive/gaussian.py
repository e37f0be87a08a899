"""Formulas of axicontact.cohesive.gaussian over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.gaussian import depth as normal_depth
from ...._programs.expressions.normal.gaussian import displacement as normal_displacement
from ...._programs.expressions.normal.gaussian import force as normal_force
from ...._programs.expressions.normal.gaussian import pressure as normal_pressure
from ...._programs.expressions.normal.gaussian import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, h, s, E_star, sigma_0):
    v5, v6 = nodes_along(xp, 1, a, c, h, s, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v7 = v5 * v4
    v14 = v4 * xp.sum(v6 * (normal_slope(xp, v2 * xp.cos(v7), h, s) * v7 * xp.sin(v7)), axis=0)
    v22 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (0.6366197723675814 * v2 * v14 + v22)


def zone(xp, a, h, s, E_star, dgamma, sigma_0):
    v7, v8 = nodes_along(xp, 1, a, h, s, E_star, dgamma, sigma_0)
    v2 = difference_root(xp, 1.5019752682686114 * s, a)
    v3 = 0.999999 * v2
    v4 = xp.hypot(a, v3)
    v6 = xp.arctan2(v3, a)
    v9 = v7 * v6
    v16 = v6 * xp.sum(v8 * (normal_slope(xp, v4 * xp.cos(v9), h, s) * v9 * xp.sin(v9)), axis=0)
    v19 = 1.2732395447351628 * (sigma_0 / E_star)
    v26 = sigma_0 * (0.6366197723675814 * v4 * v16 + v19 * v3 * (v6 - v3 / (v4 + a)))
    v27 = v26 >= dgamma
    v28 = xp.where(v27, v26, 2.0 * dgamma)
    v29 = v28 >= dgamma
    v30 = xp.where(v29, v28, 2.0 * dgamma)
    v31 = xp.where(v29, 0.5 * dgamma, v28)
    v33 = xp.where(v29, dgamma, xp.nan) / sigma_0
    v34 = v33 / v19
    v36 = 0.5 * v34 / 0.5707963267948966

    def f42(v45):
        v46 = xp.hypot(a, v45)
        v48 = xp.arctan2(v45, a)
        v49 = v7 * v48
        v55 = normal_slope(xp, v46 * xp.cos(v49), h, s) * v49 * xp.sin(v49)
        v60 = v45 / (v46 + a)
        v63 = 0.6366197723675814 * v46 * (v48 * xp.sum(v8 * v55, axis=0)) + v19 * v45 * (v48 - v60)
        v65 = v45 / v46
        v68 = xp.cos(v7 * v48)
        v73 = 0.6366197723675814 * (v48 * xp.sum(v8 * (normal_slope(xp, v46 * v68, h, s) * v68), axis=0))
        return (v63, v45 / v63 * v65 * (v73 + v19 * (v48 / v65 - v65 * v60)))
    v44 = xp.minimum(v36 + xp.sqrt(v36 ** 2.0 + 2.0 * a * v34), 0.75 * v2)
    v81 = xp.where(v27, 0.5 * dgamma, v26)
    return xp.where(v27, newton(xp, f42, v33, v44, v2, 0.5, 4.0), xp.nan)


def cohesive_radius(xp, a, h, s, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, h, s, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, h, s, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, h, s) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, h, s, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)
    return v2


def force(xp, a, h, s, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, h, s, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, h, s, E_star) - v3


def pressure(xp, r, a, h, s, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, h, s, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, h, s, E_star) - v3


def displacement(xp, r, a, h, s, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, h, s, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, h, s) - v3
