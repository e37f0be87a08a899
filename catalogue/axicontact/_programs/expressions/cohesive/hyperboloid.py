"""Formulas of axicontact.cohesive.hyperboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
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
    v6 = xp.arcsinh(b / v2)
    v8 = 1.5707963267948966 / v6
    v10 = xp.arctan2(a, v1) / v6
    v21 = v8 * xp.sqrt(1.0 + v10 * v10) + v10 * xp.sqrt(1.0 + v8 * v8)
    v23 = xp.arcsinh(xp.arctan2(v1, a) / v6 * (v8 + v10) / v21)
    v26 = v24 * v23
    v28 = xp.arcsinh(v8)
    v29 = 0.5 * v26
    v34 = 2.0 * v6 * xp.cosh(v28 - v29) * xp.sinh(v29)
    v42 = normal_slope(xp, v2 * xp.cos(v34), theta, b) * v6 * xp.cosh(v28 - v26) * v34
    v46 = 0.6366197723675814 * v2 * (v23 * xp.sum(v25 * (v42 * xp.sin(v34)), axis=0))
    return sigma_0 * (v46 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v35, v36 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * xp.sqrt(v4)), xp.inf)
    v13 = xp.hypot(a, v12)
    v17 = xp.arcsinh(b / v13)
    v19 = 1.5707963267948966 / v17
    v21 = xp.arctan2(a, v12) / v17
    v32 = v19 * xp.sqrt(1.0 + v21 * v21) + v21 * xp.sqrt(1.0 + v19 * v19)
    v34 = xp.arcsinh(xp.arctan2(v12, a) / v17 * (v19 + v21) / v32)
    v37 = v35 * v34
    v39 = xp.arcsinh(v19)
    v40 = 0.5 * v37
    v45 = 2.0 * v17 * xp.cosh(v39 - v40) * xp.sinh(v40)
    v53 = normal_slope(xp, v13 * xp.cos(v45), theta, b) * v17 * xp.cosh(v39 - v37) * v45
    v57 = 0.6366197723675814 * v13 * (v34 * xp.sum(v36 * (v53 * xp.sin(v45)), axis=0))
    v58 = sigma_0 / dgamma
    v60 = v57 > 0.0
    v61 = xp.where(v60, v57, 1.0)
    v62 = v61 > 0.0
    v68 = v35 * v34
    v70 = xp.arcsinh(v19)
    v71 = 0.5 * v68
    v77 = xp.cos(2.0 * v17 * xp.cosh(v70 - v71) * xp.sinh(v71))
    v84 = normal_slope(xp, v13 * v77, theta, b) * v17 * xp.cosh(v70 - v68) * v77
    v67 = v12 / xp.where(v62, xp.where(v62, v61, 1.0), 1.0) * (v12 / v13)
    v88 = xp.where(v60, v67 * (0.6366197723675814 * (v34 * xp.sum(v36 * v84, axis=0))), 1.0)
    v90 = 1.0 + a / v13
    v92 = 0.5 * (v88 + v90)
    v99 = (v57 * v58) ** (v92 / v88) + (ring_of_zone(xp, v12, a, E_star, sigma_0) * v58) ** (v92 / v90)

    def f101(v104):
        v105 = xp.hypot(a, v104)
        v107 = xp.arctan2(v104, a)
        v109 = xp.arcsinh(b / v105)
        v111 = 1.5707963267948966 / v109
        v113 = xp.arctan2(a, v104) / v109
        v124 = v111 * xp.sqrt(1.0 + v113 * v113) + v113 * xp.sqrt(1.0 + v111 * v111)
        v126 = xp.arcsinh(v107 / v109 * (v111 + v113) / v124)
        v127 = v35 * v126
        v129 = xp.arcsinh(v111)
        v130 = 0.5 * v127
        v135 = 2.0 * v109 * xp.cosh(v129 - v130) * xp.sinh(v130)
        v143 = normal_slope(xp, v105 * xp.cos(v135), theta, b) * v109 * xp.cosh(v129 - v127) * v135
        v149 = 1.2732395447351628 * (sigma_0 / E_star)
        v152 = v104 / (v105 + a)
        v147 = 0.6366197723675814 * v105 * (v126 * xp.sum(v36 * (v143 * xp.sin(v135)), axis=0))
        v155 = v147 + v149 * v104 * (v107 - v152)
        v156 = v104 / v105
        v158 = v35 * v126
        v160 = xp.arcsinh(v111)
        v161 = 0.5 * v158
        v167 = xp.cos(2.0 * v109 * xp.cosh(v160 - v161) * xp.sinh(v161))
        v174 = normal_slope(xp, v105 * v167, theta, b) * v109 * xp.cosh(v160 - v158) * v167
        v176 = 0.6366197723675814 * (v126 * xp.sum(v36 * v174, axis=0))
        return (v155, v104 * v156 * (v176 + v149 * (v107 / v156 - v156 * v152)) / v155)
    v184 = newton(xp, f101, v1, xp.minimum(v12 * v99 ** (-1.0 / v92), xp.inf), xp.inf, 0.5, 4.0)
    return v184


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
