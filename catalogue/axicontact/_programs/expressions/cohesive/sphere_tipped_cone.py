"""Formulas of axicontact.cohesive.sphere_tipped_cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import sine_root
from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.sphere_tipped_cone import depth_at as normal_depth_at
from ...._programs.expressions.normal.sphere_tipped_cone import displacement as normal_displacement
from ...._programs.expressions.normal.sphere_tipped_cone import force_at as normal_force_at
from ...._programs.expressions.normal.sphere_tipped_cone import pressure as normal_pressure
from ...._programs.expressions.normal.sphere_tipped_cone import slope as normal_slope
from ...._programs.expressions.normal.sphere_tipped_cone import slope_beyond as normal_slope_beyond
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, R, theta, E_star, sigma_0):
    v44, v45 = nodes_along(xp, 1, a, c, R, theta, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v6 = R * xp.sin(theta)
    v7 = a < v6
    v8 = xp.where(v7, a, 0.5 * v6)
    v9 = difference_root(xp, c, v8)
    v10 = xp.hypot(v8, v9)
    v11 = v10 > v6
    v12 = xp.where(v11, v10, 2.0 * v6)
    v13 = v8 < v6
    v14 = xp.where(v13, v8, 0.5 * v6)
    v15 = v14 < v6
    v16 = xp.where(v15, v14, 0.5 * v6)
    v17 = difference_root(xp, c, v16)
    v18 = difference_root(xp, v6, v16)
    v22 = xp.maximum(v17 - v18, 0.0) * (v17 + v18)
    v23 = v22 > 0.0
    v26 = xp.where(v23, xp.sqrt(xp.where(v23, v22, 1.0)), 0.0)
    v31 = xp.where(v13, 2.0 * v6, v8)
    v30 = xp.arctan2(xp.where(v15, v26, difference_root(xp, c, xp.where(v15, 2.0 * v6, v14))), v6)
    v35 = xp.where(v11, 0.5 * v6, v10)
    v36 = xp.where(v11, xp.where(v13, v30, xp.arctan2(difference_root(xp, c, v31), v31)), 0.0)
    v39 = xp.where(v7, 2.0 * v6, a)
    v41 = xp.arctan2(difference_root(xp, c, v39), v39)
    v42 = xp.where(v7, xp.minimum(v36, xp.arctan2(v9, v8)), v41)
    v43 = v4 - v42
    v47 = v42 + v44 * v43
    v49 = v2 * xp.cos(v47)
    v57 = normal_slope(xp, v49, xp.sqrt((R - v49) * (R + v49)), R) * v47 * xp.sin(v47)
    v60 = xp.where(v7, a, 0.5 * v6)
    v61 = v60 < v6
    v62 = xp.where(v61, v60, 0.5 * v6)
    v63 = difference_root(xp, c, v62)
    v64 = difference_root(xp, v6, v62)
    v68 = xp.maximum(v63 - v64, 0.0) * (v63 + v64)
    v69 = v68 > 0.0
    v73 = xp.where(v61, 2.0 * v6, v60)
    v76 = xp.hypot(difference_root(xp, v73, v6), difference_root(xp, c, v73))
    v77 = xp.where(v61, xp.where(v69, xp.sqrt(xp.where(v69, v68, 1.0)), 0.0), v76)
    v80 = xp.where(v7, v77, difference_root(xp, c, xp.where(v7, 2.0 * v6, a)))
    v81 = v80 > 0.0
    v82 = xp.where(v81, v80, 1.0)
    v83 = v82 > 0.0
    v85 = xp.where(v83, xp.where(v83, v82, 1.0), v6)
    v86 = difference_root(xp, a, v6)
    v88 = xp.where(v83, v82, 1.0)
    v89 = xp.where(v7, a, 0.5 * v6)
    v90 = difference_root(xp, c, v89)
    v91 = difference_root(xp, v6, v89)
    v95 = xp.maximum(v90 - v91, 0.0) * (v90 + v91)
    v96 = v95 > 0.0
    v100 = xp.where(v7, 2.0 * v6, a)
    v103 = xp.hypot(difference_root(xp, v100, v6), difference_root(xp, c, v100))
    v104 = xp.where(v7, xp.where(v96, xp.sqrt(xp.where(v96, v95, 1.0)), 0.0), v103)
    v105 = xp.where(v83, v104, v6)
    v107 = xp.arcsinh(v6 / v105)
    v109 = 1.5707963267948966 / v107
    v111 = xp.arctan2(v86, v85) / v107
    v122 = v109 * xp.sqrt(1.0 + v111 * v111) + v111 * xp.sqrt(1.0 + v109 * v109)
    v124 = xp.arcsinh(xp.arctan2(v85, v86) / v107 * (v109 + v111) / v122)
    v125 = v44 * v124
    v128 = xp.arcsinh(v109)
    v129 = 0.5 * v125
    v134 = 2.0 * v107 * xp.cosh(v128 - v129) * xp.sinh(v129)
    v136 = v105 * xp.cos(v134)
    v139 = xp.sqrt(v6 * v6 + v136 * v136)
    v147 = v105 * xp.sin(v134)
    v145 = normal_slope_beyond(xp, v139, v136, R, theta) * v136 * v107 * xp.cosh(v128 - v125)
    v152 = v124 * xp.sum(v45 * (v145 * xp.arctan2(v147, v139) * (v147 / v139)), axis=0)
    v59 = 0.6366197723675814 * v2 * (v43 * xp.sum(v45 * v57, axis=0))
    v162 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (v59 + xp.where(v81, 0.6366197723675814 * v152, 0.0) + v162)


def zone(xp, a, R, theta, E_star, dgamma, sigma_0):
    v52, v53 = nodes_along(xp, 1, a, R, theta, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v6 = 0.5 * v4 / 0.5707963267948966

    def f13(v14):
        v15 = xp.hypot(a, v14)
        v17 = xp.arctan2(v14, a)
        v19 = R * xp.sin(theta)
        v20 = a < v19
        v21 = xp.where(v20, a, 0.5 * v19)
        v22 = xp.hypot(v21, v14)
        v23 = v22 > v19
        v24 = xp.where(v23, v22, 2.0 * v19)
        v25 = v21 < v19
        v26 = xp.where(v25, v21, 0.5 * v19)
        v27 = v26 < v19
        v29 = difference_root(xp, v19, xp.where(v27, v26, 0.5 * v19))
        v33 = xp.maximum(v14 - v29, 0.0) * (v14 + v29)
        v34 = v33 > 0.0
        v38 = xp.where(v27, 2.0 * v19, v26)
        v40 = xp.arctan2(xp.where(v27, xp.where(v34, xp.sqrt(xp.where(v34, v33, 1.0)), 0.0), v14), v19)
        v44 = xp.where(v23, 0.5 * v19, v22)
        v45 = xp.where(v23, xp.where(v25, v40, xp.arctan2(v14, xp.where(v25, 2.0 * v19, v21))), 0.0)
        v49 = xp.arctan2(v14, xp.where(v20, 2.0 * v19, a))
        v50 = xp.where(v20, xp.minimum(v45, xp.arctan2(v14, v21)), v49)
        v51 = v17 - v50
        v55 = v50 + v52 * v51
        v57 = v15 * xp.cos(v55)
        v65 = normal_slope(xp, v57, xp.sqrt((R - v57) * (R + v57)), R) * v55 * xp.sin(v55)
        v68 = xp.where(v20, a, 0.5 * v19)
        v69 = v68 < v19
        v71 = difference_root(xp, v19, xp.where(v69, v68, 0.5 * v19))
        v75 = xp.maximum(v14 - v71, 0.0) * (v14 + v71)
        v76 = v75 > 0.0
        v82 = xp.hypot(difference_root(xp, xp.where(v69, 2.0 * v19, v68), v19), v14)
        v84 = xp.where(v20, 2.0 * v19, a)
        v83 = xp.where(v69, xp.where(v76, xp.sqrt(xp.where(v76, v75, 1.0)), 0.0), v82)
        v85 = xp.where(v20, v83, v14)
        v86 = v85 > 0.0
        v87 = xp.where(v86, v85, 1.0)
        v88 = v87 > 0.0
        v90 = xp.where(v88, xp.where(v88, v87, 1.0), v19)
        v91 = difference_root(xp, a, v19)
        v93 = xp.where(v88, v87, 1.0)
        v95 = difference_root(xp, v19, xp.where(v20, a, 0.5 * v19))
        v99 = xp.maximum(v14 - v95, 0.0) * (v14 + v95)
        v100 = v99 > 0.0
        v106 = xp.hypot(difference_root(xp, xp.where(v20, 2.0 * v19, a), v19), v14)
        v107 = xp.where(v20, xp.where(v100, xp.sqrt(xp.where(v100, v99, 1.0)), 0.0), v106)
        v108 = xp.where(v88, v107, v19)
        v110 = xp.arcsinh(v19 / v108)
        v112 = 1.5707963267948966 / v110
        v114 = xp.arctan2(v91, v90) / v110
        v125 = v112 * xp.sqrt(1.0 + v114 * v114) + v114 * xp.sqrt(1.0 + v112 * v112)
        v127 = xp.arcsinh(xp.arctan2(v90, v91) / v110 * (v112 + v114) / v125)
        v128 = v52 * v127
        v131 = xp.arcsinh(v112)
        v132 = 0.5 * v128
        v137 = 2.0 * v110 * xp.cosh(v131 - v132) * xp.sinh(v132)
        v139 = v108 * xp.cos(v137)
        v142 = xp.sqrt(v19 * v19 + v139 * v139)
        v150 = v108 * xp.sin(v137)
        v148 = normal_slope_beyond(xp, v142, v139, R, theta) * v139 * v110 * xp.cosh(v131 - v128)
        v155 = v127 * xp.sum(v53 * (v148 * xp.arctan2(v150, v142) * (v150 / v142)), axis=0)
        v67 = 0.6366197723675814 * v15 * (v51 * xp.sum(v53 * v65, axis=0))
        v160 = 1.2732395447351628 * (sigma_0 / E_star)
        v163 = v14 / (v15 + a)
        v166 = v67 + xp.where(v86, 0.6366197723675814 * v155, 0.0) + v160 * v14 * (v17 - v163)
        v168 = v14 / v15
        v172 = xp.cos(v50 + v52 * v51)
        v173 = v15 * v172
        v179 = normal_slope(xp, v173, xp.sqrt((R - v173) * (R + v173)), R) * v172
        v182 = xp.where(v86, v85, 1.0)
        v183 = v182 > 0.0
        v185 = xp.where(v183, xp.where(v183, v182, 1.0), v19)
        v186 = difference_root(xp, a, v19)
        v188 = xp.where(v183, v182, 1.0)
        v190 = difference_root(xp, v19, xp.where(v20, a, 0.5 * v19))
        v194 = xp.maximum(v14 - v190, 0.0) * (v14 + v190)
        v195 = v194 > 0.0
        v201 = xp.hypot(difference_root(xp, xp.where(v20, 2.0 * v19, a), v19), v14)
        v202 = xp.where(v20, xp.where(v195, xp.sqrt(xp.where(v195, v194, 1.0)), 0.0), v201)
        v203 = xp.where(v183, v202, v19)
        v205 = xp.arcsinh(v19 / v203)
        v207 = 1.5707963267948966 / v205
        v209 = xp.arctan2(v186, v185) / v205
        v220 = v207 * xp.sqrt(1.0 + v209 * v209) + v209 * xp.sqrt(1.0 + v207 * v207)
        v222 = xp.arcsinh(xp.arctan2(v185, v186) / v205 * (v207 + v209) / v220)
        v223 = v52 * v222
        v226 = xp.arcsinh(v207)
        v227 = 0.5 * v223
        v234 = v203 * xp.cos(2.0 * v205 * xp.cosh(v226 - v227) * xp.sinh(v227))
        v239 = normal_slope_beyond(xp, xp.sqrt(v19 * v19 + v234 * v234), v234, R, theta) * v234
        v245 = v222 * xp.sum(v53 * (v239 * v205 * xp.cosh(v226 - v223) / v15), axis=0)
        v181 = 0.6366197723675814 * (v51 * xp.sum(v53 * v179, axis=0))
        v248 = v181 + xp.where(v86, 0.6366197723675814 * v245, 0.0)
        return (v166, v14 / v166 * v168 * (v248 + v160 * (v17 / v168 - v168 * v163)))
    v13 = xp.minimum(v6 + xp.sqrt(v6 ** 2.0 + 2.0 * a * v4), xp.inf)
    return newton(xp, f13, v1, v13, xp.inf, 0.5, 4.0)


def cohesive_radius(xp, a, R, theta, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, R, theta, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, R, theta, E_star, dgamma, sigma_0):
    v6 = normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta) - 2.0 * (sigma_0 / E_star) * q
    return v6


def depth(xp, a, R, theta, E_star, dgamma, sigma_0):
    v2 = depth_of(xp, a, zone(xp, a, R, theta, E_star, dgamma, sigma_0), R, theta, E_star, dgamma, sigma_0)
    return v2


def force_of(xp, a, q, R, theta, E_star, dgamma, sigma_0):
    v2 = normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, E_star)
    return v2 - pull_of_zone(xp, q, a, sigma_0)


def force(xp, a, R, theta, E_star, dgamma, sigma_0):
    v2 = force_of(xp, a, zone(xp, a, R, theta, E_star, dgamma, sigma_0), R, theta, E_star, dgamma, sigma_0)
    return v2


def pressure(xp, r, a, R, theta, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, R, theta, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, R, theta, E_star) - v3


def displacement(xp, r, a, R, theta, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, R, theta, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, R, theta) - v3
