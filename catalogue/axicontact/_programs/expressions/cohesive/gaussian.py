"""Formulas of axicontact.cohesive.gaussian over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
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
    return sigma_0 * (0.6366197723675814 * v2 * v15 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, h, s, E_star, dgamma, sigma_0):
    v8, v9 = nodes_along(xp, 1, a, h, s, E_star, dgamma, sigma_0)
    v2 = difference_root(xp, 1.5019752682686114 * s, a)
    v4 = 0.999999 * v2
    v5 = xp.hypot(a, v4)
    v7 = xp.arctan2(v4, a)
    v11 = 0.0 + v8 * v7
    v18 = v7 * xp.sum(v9 * (normal_slope(xp, v5 * xp.cos(v11), h, s) * v11 * xp.sin(v11)), axis=0)
    v22 = sigma_0 * (0.6366197723675814 * v5 * v18 + ring_of_zone(xp, v4, a, E_star, sigma_0))
    v25 = xp.where((v2 > 0.0) & (v22 >= dgamma), a, xp.nan)
    v27 = dgamma / sigma_0
    v30 = 0.7853981633974483 * v27 * (E_star / sigma_0)
    v31 = 0.8759691969420544 * v30
    v39 = xp.minimum(v31 + xp.hypot(v31, xp.sqrt(2.0 * v25) * xp.sqrt(v30)), 0.75 * v2)
    v40 = xp.hypot(v25, v39)
    v42 = xp.arctan2(v39, v25)
    v44 = 0.0 + v8 * v42
    v50 = normal_slope(xp, v40 * xp.cos(v44), h, s) * v44 * xp.sin(v44)
    v52 = 0.6366197723675814 * v40 * (v42 * xp.sum(v9 * v50, axis=0))
    v53 = sigma_0 / dgamma
    v55 = v52 > 0.0
    v56 = xp.where(v55, v52, 1.0)
    v57 = v56 > 0.0
    v65 = xp.cos(0.0 + v8 * v42)
    v70 = 0.6366197723675814 * (v42 * xp.sum(v9 * (normal_slope(xp, v40 * v65, h, s) * v65), axis=0))
    v72 = xp.where(v55, v39 / xp.where(v57, xp.where(v57, v56, 1.0), 1.0) * (v39 / v40) * v70, 1.0)
    v74 = 1.0 + v25 / v40
    v76 = 0.5 * (v72 + v74)
    v82 = (ring_of_zone(xp, v39, v25, E_star, sigma_0) * v53) ** (v76 / v74)

    def f85(v88):
        v89 = xp.hypot(v25, v88)
        v91 = xp.arctan2(v88, v25)
        v93 = 0.0 + v8 * v91
        v99 = normal_slope(xp, v89 * xp.cos(v93), h, s) * v93 * xp.sin(v93)
        v103 = 1.2732395447351628 * (sigma_0 / E_star)
        v106 = v88 / (v89 + v25)
        v109 = 0.6366197723675814 * v89 * (v91 * xp.sum(v9 * v99, axis=0)) + v103 * v88 * (v91 - v106)
        v110 = v88 / v89
        v114 = xp.cos(0.0 + v8 * v91)
        v119 = 0.6366197723675814 * (v91 * xp.sum(v9 * (normal_slope(xp, v89 * v114, h, s) * v114), axis=0))
        return (v109, v88 * v110 * (v119 + v103 * (v91 / v110 - v110 * v106)) / v109)
    v87 = xp.minimum(v39 * ((v52 * v53) ** (v76 / v72) + v82) ** (-1.0 / v76), v4)
    return xp.where(xp.isnan(v25), xp.nan, newton(xp, f85, v27, v87, v2, 0.5, 4.0))


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
