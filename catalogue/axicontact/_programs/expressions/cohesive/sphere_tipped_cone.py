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
    v50 = xp.minimum(v2 * xp.cos(v47), v6)
    v58 = normal_slope(xp, v50, xp.sqrt((R - v50) * (R + v50)), R) * v47 * xp.sin(v47)
    v61 = xp.where(v7, a, 0.5 * v6)
    v62 = v61 < v6
    v63 = xp.where(v62, v61, 0.5 * v6)
    v64 = difference_root(xp, c, v63)
    v65 = difference_root(xp, v6, v63)
    v69 = xp.maximum(v64 - v65, 0.0) * (v64 + v65)
    v70 = v69 > 0.0
    v74 = xp.where(v62, 2.0 * v6, v61)
    v77 = xp.hypot(difference_root(xp, v74, v6), difference_root(xp, c, v74))
    v78 = xp.where(v62, xp.where(v70, xp.sqrt(xp.where(v70, v69, 1.0)), 0.0), v77)
    v81 = xp.where(v7, v78, difference_root(xp, c, xp.where(v7, 2.0 * v6, a)))
    v82 = v81 > 0.0
    v83 = xp.where(v82, v81, 1.0)
    v84 = v83 > 0.0
    v86 = xp.where(v84, xp.where(v84, v83, 1.0), v6)
    v87 = difference_root(xp, a, v6)
    v89 = xp.where(v84, v83, 1.0)
    v90 = xp.where(v7, a, 0.5 * v6)
    v91 = difference_root(xp, c, v90)
    v92 = difference_root(xp, v6, v90)
    v96 = xp.maximum(v91 - v92, 0.0) * (v91 + v92)
    v97 = v96 > 0.0
    v101 = xp.where(v7, 2.0 * v6, a)
    v104 = xp.hypot(difference_root(xp, v101, v6), difference_root(xp, c, v101))
    v105 = xp.where(v7, xp.where(v97, xp.sqrt(xp.where(v97, v96, 1.0)), 0.0), v104)
    v106 = xp.where(v84, v105, v6)
    v108 = xp.arcsinh(v6 / v106)
    v110 = 1.5707963267948966 / v108
    v112 = xp.arctan2(v87, v86) / v108
    v123 = v110 * xp.sqrt(1.0 + v112 * v112) + v112 * xp.sqrt(1.0 + v110 * v110)
    v125 = xp.arcsinh(xp.arctan2(v86, v87) / v108 * (v110 + v112) / v123)
    v126 = v44 * v125
    v129 = xp.arcsinh(v110)
    v130 = 0.5 * v126
    v135 = 2.0 * v108 * xp.cosh(v129 - v130) * xp.sinh(v130)
    v137 = v106 * xp.cos(v135)
    v140 = xp.sqrt(v6 * v6 + v137 * v137)
    v148 = v106 * xp.sin(v135)
    v146 = normal_slope_beyond(xp, v140, v137, R, theta) * v137 * v108 * xp.cosh(v129 - v126)
    v153 = v125 * xp.sum(v45 * (v146 * xp.arctan2(v148, v140) * (v148 / v140)), axis=0)
    v60 = 0.6366197723675814 * v2 * (v43 * xp.sum(v45 * v58, axis=0))
    v163 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (v60 + xp.where(v82, 0.6366197723675814 * v153, 0.0) + v163)


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
        v58 = xp.minimum(v15 * xp.cos(v55), v19)
        v66 = normal_slope(xp, v58, xp.sqrt((R - v58) * (R + v58)), R) * v55 * xp.sin(v55)
        v69 = xp.where(v20, a, 0.5 * v19)
        v70 = v69 < v19
        v72 = difference_root(xp, v19, xp.where(v70, v69, 0.5 * v19))
        v76 = xp.maximum(v14 - v72, 0.0) * (v14 + v72)
        v77 = v76 > 0.0
        v83 = xp.hypot(difference_root(xp, xp.where(v70, 2.0 * v19, v69), v19), v14)
        v85 = xp.where(v20, 2.0 * v19, a)
        v84 = xp.where(v70, xp.where(v77, xp.sqrt(xp.where(v77, v76, 1.0)), 0.0), v83)
        v86 = xp.where(v20, v84, v14)
        v87 = v86 > 0.0
        v88 = xp.where(v87, v86, 1.0)
        v89 = v88 > 0.0
        v91 = xp.where(v89, xp.where(v89, v88, 1.0), v19)
        v92 = difference_root(xp, a, v19)
        v94 = xp.where(v89, v88, 1.0)
        v96 = difference_root(xp, v19, xp.where(v20, a, 0.5 * v19))
        v100 = xp.maximum(v14 - v96, 0.0) * (v14 + v96)
        v101 = v100 > 0.0
        v107 = xp.hypot(difference_root(xp, xp.where(v20, 2.0 * v19, a), v19), v14)
        v108 = xp.where(v20, xp.where(v101, xp.sqrt(xp.where(v101, v100, 1.0)), 0.0), v107)
        v109 = xp.where(v89, v108, v19)
        v111 = xp.arcsinh(v19 / v109)
        v113 = 1.5707963267948966 / v111
        v115 = xp.arctan2(v92, v91) / v111
        v126 = v113 * xp.sqrt(1.0 + v115 * v115) + v115 * xp.sqrt(1.0 + v113 * v113)
        v128 = xp.arcsinh(xp.arctan2(v91, v92) / v111 * (v113 + v115) / v126)
        v129 = v52 * v128
        v132 = xp.arcsinh(v113)
        v133 = 0.5 * v129
        v138 = 2.0 * v111 * xp.cosh(v132 - v133) * xp.sinh(v133)
        v140 = v109 * xp.cos(v138)
        v143 = xp.sqrt(v19 * v19 + v140 * v140)
        v151 = v109 * xp.sin(v138)
        v149 = normal_slope_beyond(xp, v143, v140, R, theta) * v140 * v111 * xp.cosh(v132 - v129)
        v156 = v128 * xp.sum(v53 * (v149 * xp.arctan2(v151, v143) * (v151 / v143)), axis=0)
        v68 = 0.6366197723675814 * v15 * (v51 * xp.sum(v53 * v66, axis=0))
        v161 = 1.2732395447351628 * (sigma_0 / E_star)
        v164 = v14 / (v15 + a)
        v167 = v68 + xp.where(v87, 0.6366197723675814 * v156, 0.0) + v161 * v14 * (v17 - v164)
        v169 = v14 / v15
        v173 = xp.cos(v50 + v52 * v51)
        v175 = xp.minimum(v15 * v173, v19)
        v181 = normal_slope(xp, v175, xp.sqrt((R - v175) * (R + v175)), R) * v173
        v184 = xp.where(v87, v86, 1.0)
        v185 = v184 > 0.0
        v187 = xp.where(v185, xp.where(v185, v184, 1.0), v19)
        v188 = difference_root(xp, a, v19)
        v190 = xp.where(v185, v184, 1.0)
        v192 = difference_root(xp, v19, xp.where(v20, a, 0.5 * v19))
        v196 = xp.maximum(v14 - v192, 0.0) * (v14 + v192)
        v197 = v196 > 0.0
        v203 = xp.hypot(difference_root(xp, xp.where(v20, 2.0 * v19, a), v19), v14)
        v204 = xp.where(v20, xp.where(v197, xp.sqrt(xp.where(v197, v196, 1.0)), 0.0), v203)
        v205 = xp.where(v185, v204, v19)
        v207 = xp.arcsinh(v19 / v205)
        v209 = 1.5707963267948966 / v207
        v211 = xp.arctan2(v188, v187) / v207
        v222 = v209 * xp.sqrt(1.0 + v211 * v211) + v211 * xp.sqrt(1.0 + v209 * v209)
        v224 = xp.arcsinh(xp.arctan2(v187, v188) / v207 * (v209 + v211) / v222)
        v225 = v52 * v224
        v228 = xp.arcsinh(v209)
        v229 = 0.5 * v225
        v236 = v205 * xp.cos(2.0 * v207 * xp.cosh(v228 - v229) * xp.sinh(v229))
        v241 = normal_slope_beyond(xp, xp.sqrt(v19 * v19 + v236 * v236), v236, R, theta) * v236
        v247 = v224 * xp.sum(v53 * (v241 * v207 * xp.cosh(v228 - v225) / v15), axis=0)
        v183 = 0.6366197723675814 * (v51 * xp.sum(v53 * v181, axis=0))
        v250 = v183 + xp.where(v87, 0.6366197723675814 * v247, 0.0)
        return (v167, v14 / v167 * v169 * (v250 + v161 * (v17 / v169 - v169 * v164)))
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
