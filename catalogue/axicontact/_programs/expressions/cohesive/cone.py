"""Formulas of axicontact.cohesive.cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.cone import depth as normal_depth
from ...._programs.expressions.normal.cone import displacement as normal_displacement
from ...._programs.expressions.normal.cone import force as normal_force
from ...._programs.expressions.normal.cone import pressure as normal_pressure
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, theta, E_star, sigma_0):
    v5, v6 = nodes_along(xp, 1, a, c, theta, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v4 = xp.arctan2(v1, a)
    v11 = 0.0 + v5 * v4
    v15 = v4 * xp.sum(v6 * (3.141592653589793 * xp.tan(theta) / 2.0 * v11 * xp.sin(v11)), axis=0)
    v18 = 0.6366197723675814 * xp.hypot(a, v1) * v15 + ring_of_zone(xp, v1, a, E_star, sigma_0)
    return sigma_0 * v18


def zone(xp, a, theta, E_star, dgamma, sigma_0):
    v16, v17 = nodes_along(xp, 1, a, theta, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * xp.sqrt(v4)), xp.inf)
    v13 = xp.hypot(a, v12)
    v15 = xp.arctan2(v12, a)
    v22 = 0.0 + v16 * v15
    v26 = v15 * xp.sum(v17 * (3.141592653589793 * xp.tan(theta) / 2.0 * v22 * xp.sin(v22)), axis=0)
    v27 = 0.6366197723675814 * v13 * v26
    v28 = sigma_0 / dgamma
    v30 = v27 > 0.0
    v31 = xp.where(v30, v27, 1.0)
    v32 = v31 > 0.0
    v44 = 3.141592653589793 * xp.tan(theta) / 2.0 * xp.cos(0.0 + v16 * v15)
    v37 = v12 / xp.where(v32, xp.where(v32, v31, 1.0), 1.0) * (v12 / v13)
    v48 = xp.where(v30, v37 * (0.6366197723675814 * (v15 * xp.sum(v17 * v44, axis=0))), 1.0)
    v50 = 1.0 + a / v13
    v52 = 0.5 * (v48 + v50)
    v59 = (v27 * v28) ** (v52 / v48) + (ring_of_zone(xp, v12, a, E_star, sigma_0) * v28) ** (v52 / v50)

    def f61(v64):
        v65 = xp.hypot(a, v64)
        v67 = xp.arctan2(v64, a)
        v72 = 0.0 + v16 * v67
        v76 = v67 * xp.sum(v17 * (3.141592653589793 * xp.tan(theta) / 2.0 * v72 * xp.sin(v72)), axis=0)
        v79 = 1.2732395447351628 * (sigma_0 / E_star)
        v82 = v64 / (v65 + a)
        v85 = 0.6366197723675814 * v65 * v76 + v79 * v64 * (v67 - v82)
        v86 = v64 / v65
        v94 = 3.141592653589793 * xp.tan(theta) / 2.0 * xp.cos(0.0 + v16 * v67)
        v101 = 0.6366197723675814 * (v67 * xp.sum(v17 * v94, axis=0)) + v79 * (v67 / v86 - v86 * v82)
        return (v85, v64 * v86 * v101 / v85)
    v104 = newton(xp, f61, v1, xp.minimum(v12 * v59 ** (-1.0 / v52), xp.inf), xp.inf, 0.5, 4.0)
    return v104


def cohesive_radius(xp, a, theta, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, theta, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, theta, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, theta) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, theta, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, theta, E_star, dgamma, sigma_0), theta, E_star, dgamma, sigma_0)
    return v2


def force(xp, a, theta, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, theta, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, theta, E_star) - v3


def pressure(xp, r, a, theta, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, theta, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, theta, E_star) - v3


def displacement(xp, r, a, theta, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, theta, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, theta) - v3
