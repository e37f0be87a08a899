"""Formulas of axicontact.cohesive.power_law over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.power_law import depth as normal_depth
from ...._programs.expressions.normal.power_law import displacement as normal_displacement
from ...._programs.expressions.normal.power_law import force as normal_force
from ...._programs.expressions.normal.power_law import pressure as normal_pressure
from ...._programs.expressions.normal.power_law import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, A, n, E_star, sigma_0):
    v17, v18 = nodes_along(xp, 1, a, c, A, n, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = a > 0.0
    v5 = xp.where(v4, a, 1.0)
    v7 = v5 > 0.0
    v11 = xp.where(v4, difference_root(xp, c, v5) / xp.where(v7, xp.where(v7, v5, 1.0), 1.0), xp.inf)
    v16 = xp.arcsinh(xp.minimum(xp.arcsinh(v11), 40.0 / xp.minimum(n, 1.2)))
    v19 = v17 * v16
    v20 = xp.sinh(v19)
    v21 = xp.cosh(v20)
    v27 = xp.sinh(v20)
    v31 = normal_slope(xp, v2 / v21, A, n) / v21 * xp.cosh(v19) * xp.arctan(v27) * (v27 / v21)
    v33 = 0.6366197723675814 * v2 * (v16 * xp.sum(v18 * v31, axis=0))
    return sigma_0 * (v33 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, A, n, E_star, dgamma, sigma_0):
    v33, v34 = nodes_along(xp, 1, a, A, n, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v8 = xp.sqrt(v4)
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * v8), xp.inf)
    v13 = xp.hypot(a, v12)
    v15 = a > 0.0
    v16 = xp.where(v15, a, 1.0)
    v23 = v16 > 0.0
    v22 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v16) * v8), xp.inf)
    v30 = 40.0 / xp.minimum(n, 1.2)
    v28 = xp.arcsinh(xp.where(v15, v22 / xp.where(v23, xp.where(v23, v16, 1.0), 1.0), xp.inf))
    v32 = xp.arcsinh(xp.minimum(v28, v30))
    v35 = v33 * v32
    v36 = xp.sinh(v35)
    v37 = xp.cosh(v36)
    v43 = xp.sinh(v36)
    v47 = normal_slope(xp, v13 / v37, A, n) / v37 * xp.cosh(v35) * xp.arctan(v43) * (v43 / v37)
    v49 = 0.6366197723675814 * v13 * (v32 * xp.sum(v34 * v47, axis=0))
    v50 = sigma_0 / dgamma
    v52 = v49 > 0.0
    v53 = xp.where(v52, v49, 1.0)
    v54 = v53 > 0.0
    v60 = v33 * v32
    v62 = xp.cosh(xp.sinh(v60))
    v68 = normal_slope(xp, v13 / v62, A, n) / v62 * xp.cosh(v60) / v62
    v59 = v12 / xp.where(v54, xp.where(v54, v53, 1.0), 1.0) * (v12 / v13)
    v72 = xp.where(v52, v59 * (0.6366197723675814 * (v32 * xp.sum(v34 * v68, axis=0))), 1.0)
    v74 = 1.0 + a / v13
    v76 = 0.5 * (v72 + v74)
    v83 = (v49 * v50) ** (v76 / v72) + (ring_of_zone(xp, v12, a, E_star, sigma_0) * v50) ** (v76 / v74)

    def f85(v88):
        v89 = xp.hypot(a, v88)
        v91 = xp.where(v15, a, 1.0)
        v92 = v91 > 0.0
        v97 = xp.arcsinh(xp.where(v15, v88 / xp.where(v92, xp.where(v92, v91, 1.0), 1.0), xp.inf))
        v99 = xp.arcsinh(xp.minimum(v97, v30))
        v100 = v33 * v99
        v101 = xp.sinh(v100)
        v102 = xp.cosh(v101)
        v108 = xp.sinh(v101)
        v110 = normal_slope(xp, v89 / v102, A, n) / v102 * xp.cosh(v100) * xp.arctan(v108)
        v116 = 1.2732395447351628 * (sigma_0 / E_star)
        v118 = xp.arctan2(v88, a)
        v120 = v88 / (v89 + a)
        v114 = 0.6366197723675814 * v89 * (v99 * xp.sum(v34 * (v110 * (v108 / v102)), axis=0))
        v123 = v114 + v116 * v88 * (v118 - v120)
        v124 = v88 / v89
        v126 = v33 * v99
        v128 = xp.cosh(xp.sinh(v126))
        v134 = normal_slope(xp, v89 / v128, A, n) / v128 * xp.cosh(v126) / v128
        v136 = 0.6366197723675814 * (v99 * xp.sum(v34 * v134, axis=0))
        return (v123, v88 * v124 * (v136 + v116 * (v118 / v124 - v124 * v120)) / v123)
    v144 = newton(xp, f85, v1, xp.minimum(v12 * v83 ** (-1.0 / v76), xp.inf), xp.inf, 0.5, 4.0)
    return v144


def cohesive_radius(xp, a, A, n, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, A, n, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, A, n, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, A, n) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, A, n, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, A, n, E_star, dgamma, sigma_0), A, n, E_star, dgamma, sigma_0)
    return v2


def force(xp, a, A, n, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, A, n, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, A, n, E_star) - v3


def pressure(xp, r, a, A, n, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, A, n, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, A, n, E_star) - v3


def displacement(xp, r, a, A, n, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, A, n, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, A, n) - v3
