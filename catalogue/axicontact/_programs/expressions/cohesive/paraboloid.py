"""Formulas of axicontact.cohesive.paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.paraboloid import displacement as normal_displacement
from ...._programs.expressions.normal.paraboloid import force as normal_force
from ...._programs.expressions.normal.paraboloid import pressure as normal_pressure
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, R, E_star, sigma_0):
    v5, v6 = nodes_along(xp, 1, a, c, R, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v8 = 0.0 + v5 * v4
    v16 = v4 * xp.sum(v6 * (2.0 * (v2 * xp.cos(v8)) / R * v8 * xp.sin(v8)), axis=0)
    return sigma_0 * (0.6366197723675814 * v2 * v16 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, R, E_star, dgamma, sigma_0):
    v16, v17 = nodes_along(xp, 1, a, R, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * xp.sqrt(v4)), xp.inf)
    v13 = xp.hypot(a, v12)
    v15 = xp.arctan2(v12, a)
    v19 = 0.0 + v16 * v15
    v27 = v15 * xp.sum(v17 * (2.0 * (v13 * xp.cos(v19)) / R * v19 * xp.sin(v19)), axis=0)
    v28 = 0.6366197723675814 * v13 * v27
    v29 = sigma_0 / dgamma
    v31 = v28 > 0.0
    v32 = xp.where(v31, v28, 1.0)
    v33 = v32 > 0.0
    v41 = xp.cos(0.0 + v16 * v15)
    v47 = 0.6366197723675814 * (v15 * xp.sum(v17 * (2.0 * (v13 * v41) / R * v41), axis=0))
    v49 = xp.where(v31, v12 / xp.where(v33, xp.where(v33, v32, 1.0), 1.0) * (v12 / v13) * v47, 1.0)
    v51 = 1.0 + a / v13
    v53 = 0.5 * (v49 + v51)
    v60 = (v28 * v29) ** (v53 / v49) + (ring_of_zone(xp, v12, a, E_star, sigma_0) * v29) ** (v53 / v51)

    def f62(v65):
        v66 = xp.hypot(a, v65)
        v68 = xp.arctan2(v65, a)
        v70 = 0.0 + v16 * v68
        v78 = v68 * xp.sum(v17 * (2.0 * (v66 * xp.cos(v70)) / R * v70 * xp.sin(v70)), axis=0)
        v81 = 1.2732395447351628 * (sigma_0 / E_star)
        v84 = v65 / (v66 + a)
        v87 = 0.6366197723675814 * v66 * v78 + v81 * v65 * (v68 - v84)
        v88 = v65 / v66
        v92 = xp.cos(0.0 + v16 * v68)
        v98 = 0.6366197723675814 * (v68 * xp.sum(v17 * (2.0 * (v66 * v92) / R * v92), axis=0))
        return (v87, v65 * v88 * (v98 + v81 * (v68 / v88 - v88 * v84)) / v87)
    v106 = newton(xp, f62, v1, xp.minimum(v12 * v60 ** (-1.0 / v53), xp.inf), xp.inf, 0.5, 4.0)
    return v106


def cohesive_radius(xp, a, R, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, R, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, R, E_star, dgamma, sigma_0):
    return a ** 2.0 / R - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, R, E_star, dgamma, sigma_0):
    return depth_of(xp, a, zone(xp, a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def force(xp, a, R, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, R, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, R, E_star) - v3


def pressure(xp, r, a, R, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, R, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, R, E_star) - v3


def displacement(xp, r, a, R, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, R, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, R) - v3
