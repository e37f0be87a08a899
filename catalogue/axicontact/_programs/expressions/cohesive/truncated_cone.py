"""Formulas of axicontact.cohesive.truncated_cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.truncated_cone import depth as normal_depth
from ...._programs.expressions.normal.truncated_cone import displacement as normal_displacement
from ...._programs.expressions.normal.truncated_cone import force as normal_force
from ...._programs.expressions.normal.truncated_cone import pressure as normal_pressure
from ...._programs.expressions.normal.truncated_cone import slope_beyond as normal_slope_beyond
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, theta, b, E_star, sigma_0):
    v63, v64 = nodes_along(xp, 1, a, c, theta, b, E_star, sigma_0)
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v3 = v2 < b
    v4 = xp.where(v3, v2, 0.5 * b)
    v5 = difference_root(xp, c, v4)
    v6 = difference_root(xp, b, v4)
    v10 = xp.maximum(v5 - v6, 0.0) * (v5 + v6)
    v11 = v10 > 0.0
    v15 = xp.where(v3, 2.0 * b, v2)
    v18 = xp.hypot(difference_root(xp, v15, b), difference_root(xp, c, v15))
    v19 = xp.where(v3, xp.where(v11, xp.sqrt(xp.where(v11, v10, 1.0)), 0.0), v18)
    v22 = xp.where(v1, v19, difference_root(xp, c, xp.where(v1, 2.0 * b, a)))
    v23 = difference_root(xp, a, b)
    v25 = v22 > 0.0
    v26 = xp.where(v25, v22, 1.0)
    v27 = xp.where(v1, a, 0.5 * b)
    v28 = difference_root(xp, c, v27)
    v29 = difference_root(xp, b, v27)
    v33 = xp.maximum(v28 - v29, 0.0) * (v28 + v29)
    v34 = v33 > 0.0
    v38 = xp.where(v1, 2.0 * b, a)
    v41 = xp.hypot(difference_root(xp, v38, b), difference_root(xp, c, v38))
    v43 = xp.where(v25, xp.where(v1, xp.where(v34, xp.sqrt(xp.where(v34, v33, 1.0)), 0.0), v41), b)
    v45 = xp.arcsinh(b / v43)
    v47 = 1.5707963267948966 / v45
    v49 = xp.arctan2(v23, v22) / v45
    v60 = v47 * xp.sqrt(1.0 + v49 * v49) + v49 * xp.sqrt(1.0 + v47 * v47)
    v62 = xp.arcsinh(xp.arctan2(v22, v23) / v45 * (v47 + v49) / v60)
    v65 = v63 * v62
    v68 = xp.arcsinh(v47)
    v69 = 0.5 * v65
    v74 = 2.0 * v45 * xp.cosh(v68 - v69) * xp.sinh(v69)
    v77 = v43 * xp.maximum(xp.cos(v74), 1e-17)
    v80 = xp.sqrt(b * b + v77 * v77)
    v88 = v43 * xp.sin(v74)
    v86 = normal_slope_beyond(xp, v80, v77, theta, b) * v77 * v45 * xp.cosh(v68 - v65)
    v94 = 0.6366197723675814 * (v62 * xp.sum(v64 * (v86 * xp.arctan2(v88, v80) * (v88 / v80)), axis=0))
    return sigma_0 * (v94 + ring_of_zone(xp, difference_root(xp, c, a), a, E_star, sigma_0))


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v100, v101 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v8 = xp.sqrt(v4)
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * v8), xp.inf)
    v13 = a < b
    v14 = xp.where(v13, a, 0.5 * b)
    v15 = v14 < b
    v16 = xp.where(v15, v14, 0.5 * b)
    v22 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v16) * v8), xp.inf)
    v23 = difference_root(xp, b, v16)
    v27 = xp.maximum(v22 - v23, 0.0) * (v22 + v23)
    v28 = v27 > 0.0
    v32 = xp.where(v15, 2.0 * b, v14)
    v39 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v32) * v8), xp.inf)
    v31 = xp.where(v28, xp.sqrt(xp.where(v28, v27, 1.0)), 0.0)
    v48 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * xp.where(v13, 2.0 * b, a)) * v8), xp.inf)
    v49 = xp.where(v13, xp.where(v15, v31, xp.hypot(difference_root(xp, v32, b), v39)), v48)
    v50 = difference_root(xp, a, b)
    v52 = v49 > 0.0
    v53 = xp.where(v52, v49, 1.0)
    v54 = xp.where(v13, a, 0.5 * b)
    v60 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v54) * v8), xp.inf)
    v61 = difference_root(xp, b, v54)
    v65 = xp.maximum(v60 - v61, 0.0) * (v60 + v61)
    v66 = v65 > 0.0
    v70 = xp.where(v13, 2.0 * b, a)
    v77 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v70) * v8), xp.inf)
    v69 = xp.where(v66, xp.sqrt(xp.where(v66, v65, 1.0)), 0.0)
    v80 = xp.where(v52, xp.where(v13, v69, xp.hypot(difference_root(xp, v70, b), v77)), b)
    v82 = xp.arcsinh(b / v80)
    v84 = 1.5707963267948966 / v82
    v86 = xp.arctan2(v50, v49) / v82
    v97 = v84 * xp.sqrt(1.0 + v86 * v86) + v86 * xp.sqrt(1.0 + v84 * v84)
    v99 = xp.arcsinh(xp.arctan2(v49, v50) / v82 * (v84 + v86) / v97)
    v102 = v100 * v99
    v105 = xp.arcsinh(v84)
    v106 = 0.5 * v102
    v111 = 2.0 * v82 * xp.cosh(v105 - v106) * xp.sinh(v106)
    v114 = v80 * xp.maximum(xp.cos(v111), 1e-17)
    v117 = xp.sqrt(b * b + v114 * v114)
    v125 = v80 * xp.sin(v111)
    v123 = normal_slope_beyond(xp, v117, v114, theta, b) * v114 * v82 * xp.cosh(v105 - v102)
    v130 = v99 * xp.sum(v101 * (v123 * xp.arctan2(v125, v117) * (v125 / v117)), axis=0)
    v131 = 0.6366197723675814 * v130
    v132 = sigma_0 / dgamma
    v134 = v131 > 0.0
    v135 = xp.where(v134, v131, 1.0)
    v136 = v135 > 0.0
    v140 = xp.hypot(a, v12)
    v143 = v100 * v99
    v146 = xp.arcsinh(v84)
    v147 = 0.5 * v143
    v155 = v80 * xp.maximum(xp.cos(2.0 * v82 * xp.cosh(v146 - v147) * xp.sinh(v147)), 1e-17)
    v161 = normal_slope_beyond(xp, xp.sqrt(b * b + v155 * v155), v155, theta, b) * v155 * v82
    v167 = 0.6366197723675814 * (v99 * xp.sum(v101 * (v161 * xp.cosh(v146 - v143) / v140), axis=0))
    v168 = v12 / xp.where(v136, xp.where(v136, v135, 1.0), 1.0) * (v12 / v140) * v167
    v169 = xp.where(v134, v168, 1.0)
    v172 = 1.0 + a / xp.hypot(a, v12)
    v174 = 0.5 * (v169 + v172)
    v180 = (ring_of_zone(xp, v12, a, E_star, sigma_0) * v132) ** (v174 / v172)

    def f183(v186):
        v187 = xp.where(v13, a, 0.5 * b)
        v188 = v187 < b
        v190 = difference_root(xp, b, xp.where(v188, v187, 0.5 * b))
        v194 = xp.maximum(v186 - v190, 0.0) * (v186 + v190)
        v195 = v194 > 0.0
        v201 = xp.hypot(difference_root(xp, xp.where(v188, 2.0 * b, v187), b), v186)
        v203 = xp.where(v13, 2.0 * b, a)
        v202 = xp.where(v188, xp.where(v195, xp.sqrt(xp.where(v195, v194, 1.0)), 0.0), v201)
        v204 = xp.where(v13, v202, v186)
        v206 = v204 > 0.0
        v207 = xp.where(v206, v204, 1.0)
        v209 = difference_root(xp, b, xp.where(v13, a, 0.5 * b))
        v213 = xp.maximum(v186 - v209, 0.0) * (v186 + v209)
        v214 = v213 > 0.0
        v220 = xp.hypot(difference_root(xp, xp.where(v13, 2.0 * b, a), b), v186)
        v221 = xp.where(v13, xp.where(v214, xp.sqrt(xp.where(v214, v213, 1.0)), 0.0), v220)
        v222 = xp.where(v206, v221, b)
        v224 = xp.arcsinh(b / v222)
        v226 = 1.5707963267948966 / v224
        v228 = xp.arctan2(v50, v204) / v224
        v239 = v226 * xp.sqrt(1.0 + v228 * v228) + v228 * xp.sqrt(1.0 + v226 * v226)
        v241 = xp.arcsinh(xp.arctan2(v204, v50) / v224 * (v226 + v228) / v239)
        v242 = v100 * v241
        v245 = xp.arcsinh(v226)
        v246 = 0.5 * v242
        v251 = 2.0 * v224 * xp.cosh(v245 - v246) * xp.sinh(v246)
        v254 = v222 * xp.maximum(xp.cos(v251), 1e-17)
        v257 = xp.sqrt(b * b + v254 * v254)
        v265 = v222 * xp.sin(v251)
        v263 = normal_slope_beyond(xp, v257, v254, theta, b) * v254 * v224 * xp.cosh(v245 - v242)
        v270 = v241 * xp.sum(v101 * (v263 * xp.arctan2(v265, v257) * (v265 / v257)), axis=0)
        v273 = 1.2732395447351628 * (sigma_0 / E_star)
        v275 = xp.arctan2(v186, a)
        v276 = xp.hypot(a, v186)
        v278 = v186 / (v276 + a)
        v281 = 0.6366197723675814 * v270 + v273 * v186 * (v275 - v278)
        v282 = v186 / v276
        v284 = v100 * v241
        v287 = xp.arcsinh(v226)
        v288 = 0.5 * v284
        v295 = xp.maximum(xp.cos(2.0 * v224 * xp.cosh(v287 - v288) * xp.sinh(v288)), 1e-17)
        v296 = v222 * v295
        v302 = normal_slope_beyond(xp, xp.sqrt(b * b + v296 * v296), v296, theta, b) * v296 * v224
        v308 = 0.6366197723675814 * (v241 * xp.sum(v101 * (v302 * xp.cosh(v287 - v284) / v276), axis=0))
        return (v281, v186 * v282 * (v308 + v273 * (v275 / v282 - v282 * v278)) / v281)
    v185 = xp.minimum(v12 * ((v131 * v132) ** (v174 / v169) + v180) ** (-1.0 / v174), xp.inf)
    return newton(xp, f183, v1, v185, xp.inf, 0.5, 4.0)


def cohesive_radius(xp, a, theta, b, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, theta, b, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_depth(xp, xp.where(v1, 2.0 * b, a), theta, b))
    return v5 - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, theta, b, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)
    return v2


def force_of(xp, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_force(xp, xp.where(v1, 2.0 * b, a), theta, b, E_star))
    return v5 - pull_of_zone(xp, q, a, sigma_0)


def force(xp, a, theta, b, E_star, dgamma, sigma_0):
    v2 = force_of(xp, a, zone(xp, a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)
    return v2


def pressure_of(xp, r, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_pressure(xp, r, xp.where(v1, 2.0 * b, a), theta, b, E_star))
    return v5 - tension_of_zone(xp, r, q, a, sigma_0)


def pressure(xp, r, a, theta, b, E_star, dgamma, sigma_0):
    v1 = zone(xp, a, theta, b, E_star, dgamma, sigma_0)
    return pressure_of(xp, r, a, v1, theta, b, E_star, dgamma, sigma_0)


def displacement_of(xp, r, a, q, theta, b, E_star, dgamma, sigma_0):
    v1 = a < b
    v2 = xp.where(v1, a, 0.5 * b)
    v5 = xp.where(v1, 0.0, normal_displacement(xp, r, xp.where(v1, 2.0 * b, a), theta, b))
    return v5 - lift_of_zone(xp, r, q, a, E_star, sigma_0)


def displacement(xp, r, a, theta, b, E_star, dgamma, sigma_0):
    v1 = zone(xp, a, theta, b, E_star, dgamma, sigma_0)
    return displacement_of(xp, r, a, v1, theta, b, E_star, dgamma, sigma_0)
