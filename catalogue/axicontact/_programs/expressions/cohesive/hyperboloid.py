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
    v24, v25 = nodes_along(xp, 1, a, c, theta, b, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v6 = xp.arcsinh(b / v2)
    v8 = 1.5707963267948966 / v6
    v10 = xp.arctan2(a, v1) / v6
    v21 = v8 * xp.sqrt(1.0 + v10 * v10) + v10 * xp.sqrt(1.0 + v8 * v8)
    v23 = xp.arcsinh(v4 / v6 * (v8 + v10) / v21)
    v26 = v24 * v23
    v28 = xp.arcsinh(v8)
    v29 = 0.5 * v26
    v34 = 2.0 * v6 * xp.cosh(v28 - v29) * xp.sinh(v29)
    v42 = normal_slope(xp, v2 * xp.cos(v34), theta, b) * v6 * xp.cosh(v28 - v26) * v34
    v46 = 0.6366197723675814 * v2 * (v23 * xp.sum(v25 * (v42 * xp.sin(v34)), axis=0))
    v55 = sigma_0 * (v46 + 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a)))
    return v55


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v37, v38 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = xp.hypot(a, v14)
        v17 = xp.arctan2(v14, a)
        v19 = xp.arcsinh(b / v15)
        v21 = 1.5707963267948966 / v19
        v23 = xp.arctan2(a, v14) / v19
        v34 = v21 * xp.sqrt(1.0 + v23 * v23) + v23 * xp.sqrt(1.0 + v21 * v21)
        v36 = xp.arcsinh(v17 / v19 * (v21 + v23) / v34)
        v39 = v37 * v36
        v41 = xp.arcsinh(v21)
        v42 = 0.5 * v39
        v47 = 2.0 * v19 * xp.cosh(v41 - v42) * xp.sinh(v42)
        v55 = normal_slope(xp, v15 * xp.cos(v47), theta, b) * v19 * xp.cosh(v41 - v39) * v47
        v61 = 1.2732395447351628 * (sigma_0 / E_star)
        v64 = v14 / (v15 + a)
        v59 = 0.6366197723675814 * v15 * (v36 * xp.sum(v38 * (v55 * xp.sin(v47)), axis=0))
        v67 = v59 + v61 * v14 * (v17 - v64)
        v69 = v14 / v15
        v71 = v37 * v36
        v73 = xp.arcsinh(v21)
        v74 = 0.5 * v71
        v80 = xp.cos(2.0 * v19 * xp.cosh(v73 - v74) * xp.sinh(v74))
        v87 = normal_slope(xp, v15 * v80, theta, b) * v19 * xp.cosh(v73 - v71) * v80
        v94 = 0.6366197723675814 * (v36 * xp.sum(v38 * v87, axis=0)) + v61 * (v17 / v69 - v69 * v64)
        return (v67, v14 / v67 * v69 * v94)
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
