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
    v54 = xp.where(v52, 0.5 * dgamma, v51)
    v56 = xp.where(v52, dgamma, xp.nan) / sigma_0
    v57 = v56 / v43
    v59 = 0.5 * v57 / 0.5707963267948966

    def f65(v68):
        v72 = xp.maximum(v1 - v68, 0.0) * (v1 + v68)
        v73 = v72 > 0.0
        v76 = xp.where(v73, xp.sqrt(xp.where(v73, v72, 1.0)), 0.0)
        v77 = xp.hypot(a, v68)
        v79 = xp.arcsinh(v76 / v77)
        v80 = v79 > 0.0
        v81 = xp.where(v80, v79, 1.0)
        v84 = v81 > 0.0
        v86 = xp.where(v84, xp.where(v84, v81, 1.0), 1.0)
        v88 = xp.arcsinh(xp.arctan2(v68, a) / v86)
        v89 = v23 * v88
        v91 = v86 * xp.sinh(v89)
        v94 = xp.sin(v91)
        v98 = normal_slope(xp, v77 * xp.cos(v91), xp.hypot(v76, v77 * v94), h, b) * v86
        v104 = 0.6366197723675814 * v77 * (v88 * xp.sum(v24 * (v98 * xp.cosh(v89) * v91 * v94), axis=0))
        v107 = xp.arctan2(v68, a)
        v109 = v68 / (v77 + a)
        v112 = xp.where(v80, v104, xp.inf) + v43 * v68 * (v107 - v109)
        v114 = v68 / v77
        v116 = xp.where(v80, v79, 1.0)
        v117 = v116 > 0.0
        v119 = xp.where(v117, xp.where(v117, v116, 1.0), 1.0)
        v121 = xp.arcsinh(v107 / v119)
        v122 = v23 * v121
        v124 = v119 * xp.sinh(v122)
        v125 = xp.cos(v124)
        v131 = normal_slope(xp, v77 * v125, xp.hypot(v76, v77 * xp.sin(v124)), h, b) * v119
        v136 = 0.6366197723675814 * (v121 * xp.sum(v24 * (v131 * xp.cosh(v122) * v125), axis=0))
        v143 = v68 / v112 * v114 * (xp.where(v80, v136, xp.inf) + v43 * (v107 / v114 - v114 * v109))
        return (v112, v143)
    v67 = xp.minimum(v59 + xp.sqrt(v59 ** 2.0 + 2.0 * a * v57), 0.75 * v1)
    return newton(xp, f65, v56, v67, v1, 0.5, 4.0)


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
