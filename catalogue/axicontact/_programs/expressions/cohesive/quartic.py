"""Formulas of axicontact.cohesive.quartic over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.quartic import depth as normal_depth
from ...._programs.expressions.normal.quartic import displacement as normal_displacement
from ...._programs.expressions.normal.quartic import force as normal_force
from ...._programs.expressions.normal.quartic import pressure as normal_pressure
from ...._programs.expressions.normal.quartic import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, A, E_star, sigma_0):
    v5, v6 = nodes_along(xp, 1, a, c, A, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v8 = 0.0 + v5 * v4
    v15 = v4 * xp.sum(v6 * (normal_slope(xp, v2 * xp.cos(v8), A) * v8 * xp.sin(v8)), axis=0)
    return sigma_0 * (0.6366197723675814 * v2 * v15 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, A, E_star, dgamma, sigma_0):
    v16, v17 = nodes_along(xp, 1, a, A, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * xp.sqrt(v4)), xp.inf)
    v13 = xp.hypot(a, v12)
    v15 = xp.arctan2(v12, a)
    v19 = 0.0 + v16 * v15
    v26 = v15 * xp.sum(v17 * (normal_slope(xp, v13 * xp.cos(v19), A) * v19 * xp.sin(v19)), axis=0)
    v27 = 0.6366197723675814 * v13 * v26
    v28 = sigma_0 / dgamma
    v30 = v27 > 0.0
    v31 = xp.where(v30, v27, 1.0)
    v32 = v31 > 0.0
    v40 = xp.cos(0.0 + v16 * v15)
    v45 = 0.6366197723675814 * (v15 * xp.sum(v17 * (normal_slope(xp, v13 * v40, A) * v40), axis=0))
    v47 = xp.where(v30, v12 / xp.where(v32, xp.where(v32, v31, 1.0), 1.0) * (v12 / v13) * v45, 1.0)
    v49 = 1.0 + a / v13
    v51 = 0.5 * (v47 + v49)
    v58 = (v27 * v28) ** (v51 / v47) + (ring_of_zone(xp, v12, a, E_star, sigma_0) * v28) ** (v51 / v49)

    def f60(v63):
        v64 = xp.hypot(a, v63)
        v66 = xp.arctan2(v63, a)
        v68 = 0.0 + v16 * v66
        v75 = v66 * xp.sum(v17 * (normal_slope(xp, v64 * xp.cos(v68), A) * v68 * xp.sin(v68)), axis=0)
        v78 = 1.2732395447351628 * (sigma_0 / E_star)
        v81 = v63 / (v64 + a)
        v84 = 0.6366197723675814 * v64 * v75 + v78 * v63 * (v66 - v81)
        v85 = v63 / v64
        v89 = xp.cos(0.0 + v16 * v66)
        v94 = 0.6366197723675814 * (v66 * xp.sum(v17 * (normal_slope(xp, v64 * v89, A) * v89), axis=0))
        return (v84, v63 * v85 * (v94 + v78 * (v66 / v85 - v85 * v81)) / v84)
    v102 = newton(xp, f60, v1, xp.minimum(v12 * v58 ** (-1.0 / v51), xp.inf), xp.inf, 0.5, 4.0)
    return v102


def cohesive_radius(xp, a, A, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, A, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, A, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, A) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, A, E_star, dgamma, sigma_0):
    return depth_of(xp, a, zone(xp, a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def force(xp, a, A, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, A, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, A, E_star) - v3


def pressure(xp, r, a, A, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, A, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, A, E_star) - v3


def displacement(xp, r, a, A, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, A, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, A) - v3
