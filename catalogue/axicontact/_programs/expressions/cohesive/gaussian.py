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
    v8 = 0.0 + v5 * v4
    v15 = v4 * xp.sum(v6 * (normal_slope(xp, v2 * xp.cos(v8), h, s) * v8 * xp.sin(v8)), axis=0)
    v23 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (0.6366197723675814 * v2 * v15 + v23)


def zone(xp, a, h, s, E_star, dgamma, sigma_0):
    v8, v9 = nodes_along(xp, 1, a, h, s, E_star, dgamma, sigma_0)
    v2 = difference_root(xp, 1.5019752682686114 * s, a)
    v4 = 0.999999 * v2
    v5 = xp.hypot(a, v4)
    v7 = xp.arctan2(v4, a)
    v11 = 0.0 + v8 * v7
    v18 = v7 * xp.sum(v9 * (normal_slope(xp, v5 * xp.cos(v11), h, s) * v11 * xp.sin(v11)), axis=0)
    v21 = 1.2732395447351628 * (sigma_0 / E_star)
    v29 = sigma_0 * (0.6366197723675814 * v5 * v18 + v21 * v4 * (v7 - v4 / (v5 + a))) >= dgamma
    v31 = xp.where((v2 > 0.0) & v29, a, xp.nan)
    v33 = dgamma / sigma_0
    v36 = 0.7853981633974483 * v33 * (E_star / sigma_0)
    v38 = 0.5 * v36 / 0.5707963267948966

    def f44(v47):
        v48 = xp.hypot(v31, v47)
        v50 = xp.arctan2(v47, v31)
        v52 = 0.0 + v8 * v50
        v58 = normal_slope(xp, v48 * xp.cos(v52), h, s) * v52 * xp.sin(v52)
        v63 = v47 / (v48 + v31)
        v66 = 0.6366197723675814 * v48 * (v50 * xp.sum(v9 * v58, axis=0)) + v21 * v47 * (v50 - v63)
        v68 = v47 / v48
        v72 = xp.cos(0.0 + v8 * v50)
        v77 = 0.6366197723675814 * (v50 * xp.sum(v9 * (normal_slope(xp, v48 * v72, h, s) * v72), axis=0))
        return (v66, v47 / v66 * v68 * (v77 + v21 * (v50 / v68 - v68 * v63)))
    v46 = xp.minimum(v38 + xp.sqrt(v38 ** 2.0 + 2.0 * v31 * v36), 0.75 * v2)
    return xp.where(xp.isnan(v31), xp.nan, newton(xp, f44, v33, v46, v2, 0.5, 4.0))


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
