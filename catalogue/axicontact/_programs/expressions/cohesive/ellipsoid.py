"""Formulas of axicontact.cohesive.ellipsoid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.ellipsoid import depth as normal_depth
from ...._programs.expressions.normal.ellipsoid import displacement as normal_displacement
from ...._programs.expressions.normal.ellipsoid import force as normal_force
from ...._programs.expressions.normal.ellipsoid import pressure as normal_pressure
from ...._programs.expressions.normal.ellipsoid import slope as normal_slope
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, h, b, E_star, sigma_0):
    v23, v24 = nodes_along(xp, 1, a, c, h, b, E_star, sigma_0)
    v1 = difference_root(xp, b, a)
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
    v34 = normal_slope(xp, v11 * xp.cos(v27), xp.hypot(v10, v11 * v30), h, b) * v20
    v40 = 0.6366197723675814 * v11 * (v22 * xp.sum(v24 * (v34 * xp.cosh(v25) * v27 * v30), axis=0))
    v49 = 1.2732395447351628 * (sigma_0 / E_star) * v2 * (xp.arctan2(v2, a) - v2 / (v11 + a))
    return sigma_0 * (xp.where(v14, v40, xp.inf) + v49)


def zone(xp, a, h, b, E_star, dgamma, sigma_0):
    v23, v24 = nodes_along(xp, 1, a, h, b, E_star, dgamma, sigma_0)
    v1 = difference_root(xp, b, a)
    v2 = 0.999999 * v1
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
    v34 = normal_slope(xp, v11 * xp.cos(v27), xp.hypot(v10, v11 * v30), h, b) * v20
    v40 = 0.6366197723675814 * v11 * (v22 * xp.sum(v24 * (v34 * xp.cosh(v25) * v27 * v30), axis=0))
    v43 = 1.2732395447351628 * (sigma_0 / E_star)
    v51 = sigma_0 * (xp.where(v14, v40, xp.inf) + v43 * v2 * (xp.arctan2(v2, a) - v2 / (v11 + a)))
    v52 = v51 >= dgamma
    v53 = xp.where(v52, v51, 2.0 * dgamma)
    v54 = v53 >= dgamma
    v55 = xp.where(v54, v53, 2.0 * dgamma)
    v56 = xp.where(v54, 0.5 * dgamma, v53)
    v58 = xp.where(v54, dgamma, xp.nan) / sigma_0
    v59 = v58 / v43
    v61 = 0.5 * v59 / 0.5707963267948966

    def f67(v70):
        v74 = xp.maximum(v1 - v70, 0.0) * (v1 + v70)
        v75 = v74 > 0.0
        v78 = xp.where(v75, xp.sqrt(xp.where(v75, v74, 1.0)), 0.0)
        v79 = xp.hypot(a, v70)
        v81 = xp.arcsinh(v78 / v79)
        v82 = v81 > 0.0
        v83 = xp.where(v82, v81, 1.0)
        v86 = v83 > 0.0
        v88 = xp.where(v86, xp.where(v86, v83, 1.0), 1.0)
        v90 = xp.arcsinh(xp.arctan2(v70, a) / v88)
        v91 = v23 * v90
        v93 = v88 * xp.sinh(v91)
        v96 = xp.sin(v93)
        v100 = normal_slope(xp, v79 * xp.cos(v93), xp.hypot(v78, v79 * v96), h, b) * v88
        v106 = 0.6366197723675814 * v79 * (v90 * xp.sum(v24 * (v100 * xp.cosh(v91) * v93 * v96), axis=0))
        v109 = xp.arctan2(v70, a)
        v111 = v70 / (v79 + a)
        v114 = xp.where(v82, v106, xp.inf) + v43 * v70 * (v109 - v111)
        v116 = v70 / v79
        v118 = xp.where(v82, v81, 1.0)
        v119 = v118 > 0.0
        v121 = xp.where(v119, xp.where(v119, v118, 1.0), 1.0)
        v123 = xp.arcsinh(v109 / v121)
        v124 = v23 * v123
        v126 = v121 * xp.sinh(v124)
        v127 = xp.cos(v126)
        v133 = normal_slope(xp, v79 * v127, xp.hypot(v78, v79 * xp.sin(v126)), h, b) * v121
        v138 = 0.6366197723675814 * (v123 * xp.sum(v24 * (v133 * xp.cosh(v124) * v127), axis=0))
        v145 = v70 / v114 * v116 * (xp.where(v82, v138, xp.inf) + v43 * (v109 / v116 - v116 * v111))
        return (v114, v145)
    v69 = xp.minimum(v61 + xp.sqrt(v61 ** 2.0 + 2.0 * a * v59), 0.75 * v1)
    v147 = xp.where(v52, 0.5 * dgamma, v51)
    return xp.where(v52, newton(xp, f67, v58, v69, v1, 0.5, 4.0), xp.nan)


def cohesive_radius(xp, a, h, b, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, h, b, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, h, b, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, h, b) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, h, b, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, h, b, E_star, dgamma, sigma_0), h, b, E_star, dgamma, sigma_0)
    return v2


def force(xp, a, h, b, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, h, b, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, h, b, E_star) - v3


def pressure(xp, r, a, h, b, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, h, b, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, h, b, E_star) - v3


def displacement(xp, r, a, h, b, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, h, b, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, h, b) - v3
