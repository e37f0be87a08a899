"""Formulas of axicontact.cohesive.rounded_cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.rounded_cone import depth as normal_depth
from ...._programs.expressions.normal.rounded_cone import displacement as normal_displacement
from ...._programs.expressions.normal.rounded_cone import force as normal_force
from ...._programs.expressions.normal.rounded_cone import pressure as normal_pressure
from ...._programs.expressions.normal.rounded_cone import slope as normal_slope
from ...._programs.expressions.normal.rounded_cone import slope_beyond as normal_slope_beyond
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, theta, b, E_star, sigma_0):
    v42, v43 = nodes_along(xp, 1, a, c, theta, b, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v5 = a < b
    v6 = xp.where(v5, a, 0.5 * b)
    v7 = difference_root(xp, c, v6)
    v8 = xp.hypot(v6, v7)
    v9 = v8 > b
    v10 = xp.where(v9, v8, 2.0 * b)
    v11 = v6 < b
    v12 = xp.where(v11, v6, 0.5 * b)
    v13 = v12 < b
    v14 = xp.where(v13, v12, 0.5 * b)
    v15 = difference_root(xp, c, v14)
    v16 = difference_root(xp, b, v14)
    v20 = xp.maximum(v15 - v16, 0.0) * (v15 + v16)
    v21 = v20 > 0.0
    v24 = xp.where(v21, xp.sqrt(xp.where(v21, v20, 1.0)), 0.0)
    v29 = xp.where(v11, 2.0 * b, v6)
    v28 = xp.arctan2(xp.where(v13, v24, difference_root(xp, c, xp.where(v13, 2.0 * b, v12))), b)
    v33 = xp.where(v9, 0.5 * b, v8)
    v34 = xp.where(v9, xp.where(v11, v28, xp.arctan2(difference_root(xp, c, v29), v29)), 0.0)
    v37 = xp.where(v5, 2.0 * b, a)
    v39 = xp.arctan2(difference_root(xp, c, v37), v37)
    v40 = xp.where(v5, xp.minimum(v34, xp.arctan2(v7, v6)), v39)
    v41 = v4 - v40
    v45 = v40 + v42 * v41
    v52 = normal_slope(xp, xp.minimum(v2 * xp.cos(v45), b), theta, b) * v45 * xp.sin(v45)
    v55 = xp.where(v5, a, 0.5 * b)
    v56 = v55 < b
    v57 = xp.where(v56, v55, 0.5 * b)
    v58 = difference_root(xp, c, v57)
    v59 = difference_root(xp, b, v57)
    v63 = xp.maximum(v58 - v59, 0.0) * (v58 + v59)
    v64 = v63 > 0.0
    v68 = xp.where(v56, 2.0 * b, v55)
    v71 = xp.hypot(difference_root(xp, v68, b), difference_root(xp, c, v68))
    v72 = xp.where(v56, xp.where(v64, xp.sqrt(xp.where(v64, v63, 1.0)), 0.0), v71)
    v75 = xp.where(v5, v72, difference_root(xp, c, xp.where(v5, 2.0 * b, a)))
    v76 = v75 > 0.0
    v77 = xp.where(v76, v75, 1.0)
    v78 = v77 > 0.0
    v80 = xp.where(v78, xp.where(v78, v77, 1.0), b)
    v81 = difference_root(xp, a, b)
    v83 = xp.where(v78, v77, 1.0)
    v84 = xp.where(v5, a, 0.5 * b)
    v85 = difference_root(xp, c, v84)
    v86 = difference_root(xp, b, v84)
    v90 = xp.maximum(v85 - v86, 0.0) * (v85 + v86)
    v91 = v90 > 0.0
    v95 = xp.where(v5, 2.0 * b, a)
    v98 = xp.hypot(difference_root(xp, v95, b), difference_root(xp, c, v95))
    v100 = xp.where(v78, xp.where(v5, xp.where(v91, xp.sqrt(xp.where(v91, v90, 1.0)), 0.0), v98), b)
    v102 = xp.arcsinh(b / v100)
    v104 = 1.5707963267948966 / v102
    v106 = xp.arctan2(v81, v80) / v102
    v117 = v104 * xp.sqrt(1.0 + v106 * v106) + v106 * xp.sqrt(1.0 + v104 * v104)
    v119 = xp.arcsinh(xp.arctan2(v80, v81) / v102 * (v104 + v106) / v117)
    v120 = v42 * v119
    v123 = xp.arcsinh(v104)
    v124 = 0.5 * v120
    v129 = 2.0 * v102 * xp.cosh(v123 - v124) * xp.sinh(v124)
    v131 = v100 * xp.cos(v129)
    v134 = xp.sqrt(b * b + v131 * v131)
    v142 = v100 * xp.sin(v129)
    v140 = normal_slope_beyond(xp, v134, v131, theta, b) * v131 * v102 * xp.cosh(v123 - v120)
    v147 = v119 * xp.sum(v43 * (v140 * xp.arctan2(v142, v134) * (v142 / v134)), axis=0)
    v54 = 0.6366197723675814 * v2 * (v41 * xp.sum(v43 * v52, axis=0))
    v157 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (v54 + xp.where(v76, 0.6366197723675814 * v147, 0.0) + v157)


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v50, v51 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = xp.hypot(a, v14)
        v17 = xp.arctan2(v14, a)
        v18 = a < b
        v19 = xp.where(v18, a, 0.5 * b)
        v20 = xp.hypot(v19, v14)
        v21 = v20 > b
        v22 = xp.where(v21, v20, 2.0 * b)
        v23 = v19 < b
        v24 = xp.where(v23, v19, 0.5 * b)
        v25 = v24 < b
        v27 = difference_root(xp, b, xp.where(v25, v24, 0.5 * b))
        v31 = xp.maximum(v14 - v27, 0.0) * (v14 + v27)
        v32 = v31 > 0.0
        v36 = xp.where(v25, 2.0 * b, v24)
        v38 = xp.arctan2(xp.where(v25, xp.where(v32, xp.sqrt(xp.where(v32, v31, 1.0)), 0.0), v14), b)
        v42 = xp.where(v21, 0.5 * b, v20)
        v43 = xp.where(v21, xp.where(v23, v38, xp.arctan2(v14, xp.where(v23, 2.0 * b, v19))), 0.0)
        v47 = xp.arctan2(v14, xp.where(v18, 2.0 * b, a))
        v48 = xp.where(v18, xp.minimum(v43, xp.arctan2(v14, v19)), v47)
        v49 = v17 - v48
        v53 = v48 + v50 * v49
        v60 = normal_slope(xp, xp.minimum(v15 * xp.cos(v53), b), theta, b) * v53 * xp.sin(v53)
        v63 = xp.where(v18, a, 0.5 * b)
        v64 = v63 < b
        v66 = difference_root(xp, b, xp.where(v64, v63, 0.5 * b))
        v70 = xp.maximum(v14 - v66, 0.0) * (v14 + v66)
        v71 = v70 > 0.0
        v77 = xp.hypot(difference_root(xp, xp.where(v64, 2.0 * b, v63), b), v14)
        v79 = xp.where(v18, 2.0 * b, a)
        v78 = xp.where(v64, xp.where(v71, xp.sqrt(xp.where(v71, v70, 1.0)), 0.0), v77)
        v80 = xp.where(v18, v78, v14)
        v81 = v80 > 0.0
        v82 = xp.where(v81, v80, 1.0)
        v83 = v82 > 0.0
        v85 = xp.where(v83, xp.where(v83, v82, 1.0), b)
        v86 = difference_root(xp, a, b)
        v88 = xp.where(v83, v82, 1.0)
        v90 = difference_root(xp, b, xp.where(v18, a, 0.5 * b))
        v94 = xp.maximum(v14 - v90, 0.0) * (v14 + v90)
        v95 = v94 > 0.0
        v101 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * b, a), b), v14)
        v102 = xp.where(v18, xp.where(v95, xp.sqrt(xp.where(v95, v94, 1.0)), 0.0), v101)
        v103 = xp.where(v83, v102, b)
        v105 = xp.arcsinh(b / v103)
        v107 = 1.5707963267948966 / v105
        v109 = xp.arctan2(v86, v85) / v105
        v120 = v107 * xp.sqrt(1.0 + v109 * v109) + v109 * xp.sqrt(1.0 + v107 * v107)
        v122 = xp.arcsinh(xp.arctan2(v85, v86) / v105 * (v107 + v109) / v120)
        v123 = v50 * v122
        v126 = xp.arcsinh(v107)
        v127 = 0.5 * v123
        v132 = 2.0 * v105 * xp.cosh(v126 - v127) * xp.sinh(v127)
        v134 = v103 * xp.cos(v132)
        v137 = xp.sqrt(b * b + v134 * v134)
        v145 = v103 * xp.sin(v132)
        v143 = normal_slope_beyond(xp, v137, v134, theta, b) * v134 * v105 * xp.cosh(v126 - v123)
        v150 = v122 * xp.sum(v51 * (v143 * xp.arctan2(v145, v137) * (v145 / v137)), axis=0)
        v62 = 0.6366197723675814 * v15 * (v49 * xp.sum(v51 * v60, axis=0))
        v155 = 1.2732395447351628 * (sigma_0 / E_star)
        v158 = v14 / (v15 + a)
        v161 = v62 + xp.where(v81, 0.6366197723675814 * v150, 0.0) + v155 * v14 * (v17 - v158)
        v163 = v14 / v15
        v167 = xp.cos(v48 + v50 * v49)
        v172 = v49 * xp.sum(v51 * (normal_slope(xp, xp.minimum(v15 * v167, b), theta, b) * v167), axis=0)
        v174 = xp.where(v81, v80, 1.0)
        v175 = v174 > 0.0
        v177 = xp.where(v175, xp.where(v175, v174, 1.0), b)
        v178 = difference_root(xp, a, b)
        v180 = xp.where(v175, v174, 1.0)
        v182 = difference_root(xp, b, xp.where(v18, a, 0.5 * b))
        v186 = xp.maximum(v14 - v182, 0.0) * (v14 + v182)
        v187 = v186 > 0.0
        v193 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * b, a), b), v14)
        v194 = xp.where(v18, xp.where(v187, xp.sqrt(xp.where(v187, v186, 1.0)), 0.0), v193)
        v195 = xp.where(v175, v194, b)
        v197 = xp.arcsinh(b / v195)
        v199 = 1.5707963267948966 / v197
        v201 = xp.arctan2(v178, v177) / v197
        v212 = v199 * xp.sqrt(1.0 + v201 * v201) + v201 * xp.sqrt(1.0 + v199 * v199)
        v214 = xp.arcsinh(xp.arctan2(v177, v178) / v197 * (v199 + v201) / v212)
        v215 = v50 * v214
        v218 = xp.arcsinh(v199)
        v219 = 0.5 * v215
        v226 = v195 * xp.cos(2.0 * v197 * xp.cosh(v218 - v219) * xp.sinh(v219))
        v232 = normal_slope_beyond(xp, xp.sqrt(b * b + v226 * v226), v226, theta, b) * v226 * v197
        v238 = 0.6366197723675814 * (v214 * xp.sum(v51 * (v232 * xp.cosh(v218 - v215) / v15), axis=0))
        v240 = 0.6366197723675814 * v172 + xp.where(v81, v238, 0.0)
        return (v161, v14 / v161 * v163 * (v240 + v155 * (v17 / v163 - v163 * v158)))
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
