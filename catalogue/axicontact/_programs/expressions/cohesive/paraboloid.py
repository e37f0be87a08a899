"""Formulas of axicontact.cohesive.paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
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
    v24 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (0.6366197723675814 * v2 * v16 + v24)


def zone(xp, a, R, E_star, dgamma, sigma_0):
    v18, v19 = nodes_along(xp, 1, a, R, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = xp.hypot(a, v14)
        v17 = xp.arctan2(v14, a)
        v21 = 0.0 + v18 * v17
        v29 = v17 * xp.sum(v19 * (2.0 * (v15 * xp.cos(v21)) / R * v21 * xp.sin(v21)), axis=0)
        v32 = 1.2732395447351628 * (sigma_0 / E_star)
        v35 = v14 / (v15 + a)
        v38 = 0.6366197723675814 * v15 * v29 + v32 * v14 * (v17 - v35)
        v40 = v14 / v15
        v44 = xp.cos(0.0 + v18 * v17)
        v50 = 0.6366197723675814 * (v17 * xp.sum(v19 * (2.0 * (v15 * v44) / R * v44), axis=0))
        return (v38, v14 / v38 * v40 * (v50 + v32 * (v17 / v40 - v40 * v35)))
    v13 = xp.minimum(v6 + xp.sqrt(v6 ** 2.0 + 2.0 * a * v4), xp.inf)
    return newton(xp, f13, v1, v13, xp.inf, 0.5, 4.0)


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
