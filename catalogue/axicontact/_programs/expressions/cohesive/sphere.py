"""Formulas of axicontact.cohesive.sphere over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
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
    v20 = xp.where(v14, xp.where(v14, v13, 1.0), 1.0)
    v22 = xp.arcsinh(xp.arctan2(v2, a) / v20)
    v25 = v23 * v22
    v27 = v20 * xp.sinh(v25)
    v30 = xp.sin(v27)
    v36 = normal_slope(xp, v11 * xp.cos(v27), xp.hypot(v10, v11 * v30), R) * v20 * xp.cosh(v25)
    v17 = xp.where(v14, 0.6366197723675814, xp.inf) * v11
    v40 = v17 * (v22 * xp.sum(v24 * (v36 * v27 * v30), axis=0))
    return sigma_0 * (v40 + ring_of_zone(xp, v2, a, E_star, sigma_0))


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
    v21 = xp.where(v15, xp.where(v15, v14, 1.0), 1.0)
    v23 = xp.arcsinh(xp.arctan2(v3, a) / v21)
    v26 = v24 * v23
    v28 = v21 * xp.sinh(v26)
    v31 = xp.sin(v28)
    v37 = normal_slope(xp, v12 * xp.cos(v28), xp.hypot(v11, v12 * v31), R) * v21 * xp.cosh(v26)
    v18 = xp.where(v15, 0.6366197723675814, xp.inf) * v12
    v41 = v18 * (v23 * xp.sum(v25 * (v37 * v28 * v31), axis=0))
    v46 = (v1 > 0.0) & (sigma_0 * (v41 + ring_of_zone(xp, v3, a, E_star, sigma_0)) >= dgamma)
    v47 = xp.where(v46, a, xp.nan)
    v49 = dgamma / sigma_0
    v52 = 0.7853981633974483 * v49 * (E_star / sigma_0)
    v53 = 0.8759691969420544 * v52
    v61 = xp.minimum(v53 + xp.hypot(v53, xp.sqrt(2.0 * v47) * xp.sqrt(v52)), 0.75 * v1)
    v62 = difference_root(xp, R, v47)
    v66 = xp.maximum(v62 - v61, 0.0) * (v62 + v61)
    v67 = v66 > 0.0
    v70 = xp.where(v67, xp.sqrt(xp.where(v67, v66, 1.0)), 0.0)
    v71 = xp.hypot(v47, v61)
    v73 = xp.arcsinh(v70 / v71)
    v74 = v73 > 0.0
    v75 = xp.where(v74, v73, 1.0)
    v76 = xp.where(v74, 0.6366197723675814, xp.inf)
    v80 = xp.where(v74, xp.where(v74, v73, 1.0), 1.0)
    v82 = xp.arcsinh(xp.arctan2(v61, v47) / v80)
    v83 = v24 * v82
    v85 = v80 * xp.sinh(v83)
    v88 = xp.sin(v85)
    v94 = normal_slope(xp, v71 * xp.cos(v85), xp.hypot(v70, v71 * v88), R) * v80 * xp.cosh(v83)
    v98 = v76 * v71 * (v82 * xp.sum(v25 * (v94 * v85 * v88), axis=0))
    v99 = sigma_0 / dgamma
    v101 = v98 > 0.0
    v102 = xp.where(v101, v98, 1.0)
    v103 = v102 > 0.0
    v109 = v24 * v82
    v111 = v80 * xp.sinh(v109)
    v112 = xp.cos(v111)
    v118 = normal_slope(xp, v71 * v112, xp.hypot(v70, v71 * xp.sin(v111)), R) * v80
    v108 = v61 / xp.where(v103, xp.where(v103, v102, 1.0), 1.0) * (v61 / v71)
    v124 = v108 * (v76 * (v82 * xp.sum(v25 * (v118 * xp.cosh(v109) * v112), axis=0)))
    v125 = xp.where(v101, v124, 1.0)
    v127 = 1.0 + v47 / v71
    v129 = 0.5 * (v125 + v127)
    v135 = (ring_of_zone(xp, v61, v47, E_star, sigma_0) * v99) ** (v129 / v127)

    def f138(v141):
        v145 = xp.maximum(v62 - v141, 0.0) * (v62 + v141)
        v146 = v145 > 0.0
        v149 = xp.where(v146, xp.sqrt(xp.where(v146, v145, 1.0)), 0.0)
        v150 = xp.hypot(v47, v141)
        v152 = xp.arcsinh(v149 / v150)
        v153 = v152 > 0.0
        v154 = xp.where(v153, v152, 1.0)
        v155 = xp.where(v153, 0.6366197723675814, xp.inf)
        v157 = xp.arctan2(v141, v47)
        v159 = xp.where(v153, xp.where(v153, v152, 1.0), 1.0)
        v161 = xp.arcsinh(v157 / v159)
        v162 = v24 * v161
        v164 = v159 * xp.sinh(v162)
        v167 = xp.sin(v164)
        v171 = normal_slope(xp, v150 * xp.cos(v164), xp.hypot(v149, v150 * v167), R) * v159
        v179 = 1.2732395447351628 * (sigma_0 / E_star)
        v182 = v141 / (v150 + v47)
        v177 = v155 * v150 * (v161 * xp.sum(v25 * (v171 * xp.cosh(v162) * v164 * v167), axis=0))
        v185 = v177 + v179 * v141 * (v157 - v182)
        v186 = v141 / v150
        v188 = v24 * v161
        v190 = v159 * xp.sinh(v188)
        v191 = xp.cos(v190)
        v197 = normal_slope(xp, v150 * v191, xp.hypot(v149, v150 * xp.sin(v190)), R) * v159
        v202 = v155 * (v161 * xp.sum(v25 * (v197 * xp.cosh(v188) * v191), axis=0))
        return (v185, v141 * v186 * (v202 + v179 * (v157 / v186 - v186 * v182)) / v185)
    v140 = xp.minimum(v61 * ((v98 * v99) ** (v129 / v125) + v135) ** (-1.0 / v129), v3)
    return xp.where(xp.isnan(v47), xp.nan, newton(xp, f138, v49, v140, v1, 0.5, 4.0))


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
