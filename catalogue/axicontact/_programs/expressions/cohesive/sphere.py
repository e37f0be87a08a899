"""Formulas of axicontact.cohesive.sphere over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.sphere import depth as normal_depth
from ...._programs.expressions.normal.sphere import displacement as normal_displacement
from ...._programs.expressions.normal.sphere import force as normal_force
from ...._programs.expressions.normal.sphere import pressure as normal_pressure
from ...._programs.expressions.normal.sphere import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, R, E_star, sigma_0):
    v23, v24 = nodes_along(xp, 1, a, c, R, E_star, sigma_0)
    v1 = difference_root(xp, R, a)
    v2 = difference_root(xp, c, a)
    v6 = xp.maximum(v1 - v2, 0.0) * (v1 + v2)
    v7 = v6 > 0.0
    v10 = xp.where(v7, xp.sqrt(xp.where(v7, v6, 1.0)), 0.0)
    v11 = xp.hypot(a, v2)
    v13 = xp.arcsinh(v10 / v11)
    v14 = v13 > 0.0
    v15 = xp.where(v14, v13, 1.0)
    v18 = v15 > 0.0
    v20 = xp.where(v18, xp.where(v18, v15, 1.0), 1.0)
    v22 = xp.arcsinh(xp.arctan2(v2, a) / v20)
    v25 = v23 * v22
    v27 = v20 * xp.sinh(v25)
    v30 = xp.sin(v27)
    v36 = normal_slope(xp, v11 * xp.cos(v27), xp.hypot(v10, v11 * v30), R) * v20 * xp.cosh(v25)
    v40 = 0.6366197723675814 * v11 * (v22 * xp.sum(v24 * (v36 * v27 * v30), axis=0))
    v49 = 1.2732395447351628 * (sigma_0 / E_star) * v2 * (xp.arctan2(v2, a) - v2 / (v11 + a))
    return sigma_0 * (xp.where(v14, v40, xp.inf) + v49)


def zone(xp, a, R, E_star, dgamma, sigma_0):
    v24, v25 = nodes_along(xp, 1, a, R, E_star, dgamma, sigma_0)
    v1 = difference_root(xp, R, a)
    v3 = 0.999999 * v1
    v7 = xp.maximum(v1 - v3, 0.0) * (v1 + v3)
    v8 = v7 > 0.0
    v11 = xp.where(v8, xp.sqrt(xp.where(v8, v7, 1.0)), 0.0)
    v12 = xp.hypot(a, v3)
    v14 = xp.arcsinh(v11 / v12)
    v15 = v14 > 0.0
    v16 = xp.where(v15, v14, 1.0)
    v19 = v16 > 0.0
    v21 = xp.where(v19, xp.where(v19, v16, 1.0), 1.0)
    v23 = xp.arcsinh(xp.arctan2(v3, a) / v21)
    v26 = v24 * v23
    v28 = v21 * xp.sinh(v26)
    v31 = xp.sin(v28)
    v37 = normal_slope(xp, v12 * xp.cos(v28), xp.hypot(v11, v12 * v31), R) * v21 * xp.cosh(v26)
    v41 = 0.6366197723675814 * v12 * (v23 * xp.sum(v25 * (v37 * v28 * v31), axis=0))
    v44 = 1.2732395447351628 * (sigma_0 / E_star)
    v52 = sigma_0 * (xp.where(v15, v41, xp.inf) + v44 * v3 * (xp.arctan2(v3, a) - v3 / (v12 + a)))
    v55 = xp.where((v1 > 0.0) & (v52 >= dgamma), a, xp.nan)
    v57 = dgamma / sigma_0
    v60 = 0.7853981633974483 * v57 * (E_star / sigma_0)
    v62 = 0.5 * v60 / 0.5707963267948966

    def f68(v71):
        v72 = difference_root(xp, R, v55)
        v76 = xp.maximum(v72 - v71, 0.0) * (v72 + v71)
        v77 = v76 > 0.0
        v80 = xp.where(v77, xp.sqrt(xp.where(v77, v76, 1.0)), 0.0)
        v81 = xp.hypot(v55, v71)
        v83 = xp.arcsinh(v80 / v81)
        v84 = v83 > 0.0
        v85 = xp.where(v84, v83, 1.0)
        v88 = v85 > 0.0
        v90 = xp.where(v88, xp.where(v88, v85, 1.0), 1.0)
        v92 = xp.arcsinh(xp.arctan2(v71, v55) / v90)
        v93 = v24 * v92
        v95 = v90 * xp.sinh(v93)
        v98 = xp.sin(v95)
        v102 = normal_slope(xp, v81 * xp.cos(v95), xp.hypot(v80, v81 * v98), R) * v90
        v108 = 0.6366197723675814 * v81 * (v92 * xp.sum(v25 * (v102 * xp.cosh(v93) * v95 * v98), axis=0))
        v111 = xp.arctan2(v71, v55)
        v113 = v71 / (v81 + v55)
        v116 = xp.where(v84, v108, xp.inf) + v44 * v71 * (v111 - v113)
        v118 = v71 / v81
        v120 = xp.where(v84, v83, 1.0)
        v121 = v120 > 0.0
        v123 = xp.where(v121, xp.where(v121, v120, 1.0), 1.0)
        v125 = xp.arcsinh(v111 / v123)
        v126 = v24 * v125
        v128 = v123 * xp.sinh(v126)
        v129 = xp.cos(v128)
        v135 = normal_slope(xp, v81 * v129, xp.hypot(v80, v81 * xp.sin(v128)), R) * v123
        v140 = 0.6366197723675814 * (v125 * xp.sum(v25 * (v135 * xp.cosh(v126) * v129), axis=0))
        v147 = v71 / v116 * v118 * (xp.where(v84, v140, xp.inf) + v44 * (v111 / v118 - v118 * v113))
        return (v116, v147)
    v70 = xp.minimum(v62 + xp.sqrt(v62 ** 2.0 + 2.0 * v55 * v60), 0.75 * v1)
    return xp.where(xp.isnan(v55), xp.nan, newton(xp, f68, v57, v70, v1, 0.5, 4.0))


def cohesive_radius(xp, a, R, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, R, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, R, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, R) - 2.0 * (sigma_0 / E_star) * q


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
