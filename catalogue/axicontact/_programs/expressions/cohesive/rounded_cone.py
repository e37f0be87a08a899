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
    v51 = normal_slope(xp, v2 * xp.cos(v45), theta, b) * v45 * xp.sin(v45)
    v54 = xp.where(v5, a, 0.5 * b)
    v55 = v54 < b
    v56 = xp.where(v55, v54, 0.5 * b)
    v57 = difference_root(xp, c, v56)
    v58 = difference_root(xp, b, v56)
    v62 = xp.maximum(v57 - v58, 0.0) * (v57 + v58)
    v63 = v62 > 0.0
    v67 = xp.where(v55, 2.0 * b, v54)
    v70 = xp.hypot(difference_root(xp, v67, b), difference_root(xp, c, v67))
    v71 = xp.where(v55, xp.where(v63, xp.sqrt(xp.where(v63, v62, 1.0)), 0.0), v70)
    v74 = xp.where(v5, v71, difference_root(xp, c, xp.where(v5, 2.0 * b, a)))
    v75 = v74 > 0.0
    v76 = xp.where(v75, v74, 1.0)
    v77 = v76 > 0.0
    v79 = xp.where(v77, xp.where(v77, v76, 1.0), b)
    v80 = difference_root(xp, a, b)
    v82 = xp.where(v77, v76, 1.0)
    v83 = xp.where(v5, a, 0.5 * b)
    v84 = difference_root(xp, c, v83)
    v85 = difference_root(xp, b, v83)
    v89 = xp.maximum(v84 - v85, 0.0) * (v84 + v85)
    v90 = v89 > 0.0
    v94 = xp.where(v5, 2.0 * b, a)
    v97 = xp.hypot(difference_root(xp, v94, b), difference_root(xp, c, v94))
    v99 = xp.where(v77, xp.where(v5, xp.where(v90, xp.sqrt(xp.where(v90, v89, 1.0)), 0.0), v97), b)
    v101 = xp.arcsinh(b / v99)
    v103 = 1.5707963267948966 / v101
    v105 = xp.arctan2(v80, v79) / v101
    v116 = v103 * xp.sqrt(1.0 + v105 * v105) + v105 * xp.sqrt(1.0 + v103 * v103)
    v118 = xp.arcsinh(xp.arctan2(v79, v80) / v101 * (v103 + v105) / v116)
    v119 = v42 * v118
    v122 = xp.arcsinh(v103)
    v123 = 0.5 * v119
    v128 = 2.0 * v101 * xp.cosh(v122 - v123) * xp.sinh(v123)
    v130 = v99 * xp.cos(v128)
    v133 = xp.sqrt(b * b + v130 * v130)
    v141 = v99 * xp.sin(v128)
    v139 = normal_slope_beyond(xp, v133, v130, theta, b) * v130 * v101 * xp.cosh(v122 - v119)
    v146 = v118 * xp.sum(v43 * (v139 * xp.arctan2(v141, v133) * (v141 / v133)), axis=0)
    v53 = 0.6366197723675814 * v2 * (v41 * xp.sum(v43 * v51, axis=0))
    v156 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (v53 + xp.where(v75, 0.6366197723675814 * v146, 0.0) + v156)


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
        v59 = normal_slope(xp, v15 * xp.cos(v53), theta, b) * v53 * xp.sin(v53)
        v62 = xp.where(v18, a, 0.5 * b)
        v63 = v62 < b
        v65 = difference_root(xp, b, xp.where(v63, v62, 0.5 * b))
        v69 = xp.maximum(v14 - v65, 0.0) * (v14 + v65)
        v70 = v69 > 0.0
        v76 = xp.hypot(difference_root(xp, xp.where(v63, 2.0 * b, v62), b), v14)
        v78 = xp.where(v18, 2.0 * b, a)
        v77 = xp.where(v63, xp.where(v70, xp.sqrt(xp.where(v70, v69, 1.0)), 0.0), v76)
        v79 = xp.where(v18, v77, v14)
        v80 = v79 > 0.0
        v81 = xp.where(v80, v79, 1.0)
        v82 = v81 > 0.0
        v84 = xp.where(v82, xp.where(v82, v81, 1.0), b)
        v85 = difference_root(xp, a, b)
        v87 = xp.where(v82, v81, 1.0)
        v89 = difference_root(xp, b, xp.where(v18, a, 0.5 * b))
        v93 = xp.maximum(v14 - v89, 0.0) * (v14 + v89)
        v94 = v93 > 0.0
        v100 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * b, a), b), v14)
        v101 = xp.where(v18, xp.where(v94, xp.sqrt(xp.where(v94, v93, 1.0)), 0.0), v100)
        v102 = xp.where(v82, v101, b)
        v104 = xp.arcsinh(b / v102)
        v106 = 1.5707963267948966 / v104
        v108 = xp.arctan2(v85, v84) / v104
        v119 = v106 * xp.sqrt(1.0 + v108 * v108) + v108 * xp.sqrt(1.0 + v106 * v106)
        v121 = xp.arcsinh(xp.arctan2(v84, v85) / v104 * (v106 + v108) / v119)
        v122 = v50 * v121
        v125 = xp.arcsinh(v106)
        v126 = 0.5 * v122
        v131 = 2.0 * v104 * xp.cosh(v125 - v126) * xp.sinh(v126)
        v133 = v102 * xp.cos(v131)
        v136 = xp.sqrt(b * b + v133 * v133)
        v144 = v102 * xp.sin(v131)
        v142 = normal_slope_beyond(xp, v136, v133, theta, b) * v133 * v104 * xp.cosh(v125 - v122)
        v149 = v121 * xp.sum(v51 * (v142 * xp.arctan2(v144, v136) * (v144 / v136)), axis=0)
        v61 = 0.6366197723675814 * v15 * (v49 * xp.sum(v51 * v59, axis=0))
        v154 = 1.2732395447351628 * (sigma_0 / E_star)
        v157 = v14 / (v15 + a)
        v160 = v61 + xp.where(v80, 0.6366197723675814 * v149, 0.0) + v154 * v14 * (v17 - v157)
        v162 = v14 / v15
        v166 = xp.cos(v48 + v50 * v49)
        v170 = v49 * xp.sum(v51 * (normal_slope(xp, v15 * v166, theta, b) * v166), axis=0)
        v172 = xp.where(v80, v79, 1.0)
        v173 = v172 > 0.0
        v175 = xp.where(v173, xp.where(v173, v172, 1.0), b)
        v176 = difference_root(xp, a, b)
        v178 = xp.where(v173, v172, 1.0)
        v180 = difference_root(xp, b, xp.where(v18, a, 0.5 * b))
        v184 = xp.maximum(v14 - v180, 0.0) * (v14 + v180)
        v185 = v184 > 0.0
        v191 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * b, a), b), v14)
        v192 = xp.where(v18, xp.where(v185, xp.sqrt(xp.where(v185, v184, 1.0)), 0.0), v191)
        v193 = xp.where(v173, v192, b)
        v195 = xp.arcsinh(b / v193)
        v197 = 1.5707963267948966 / v195
        v199 = xp.arctan2(v176, v175) / v195
        v210 = v197 * xp.sqrt(1.0 + v199 * v199) + v199 * xp.sqrt(1.0 + v197 * v197)
        v212 = xp.arcsinh(xp.arctan2(v175, v176) / v195 * (v197 + v199) / v210)
        v213 = v50 * v212
        v216 = xp.arcsinh(v197)
        v217 = 0.5 * v213
        v224 = v193 * xp.cos(2.0 * v195 * xp.cosh(v216 - v217) * xp.sinh(v217))
        v230 = normal_slope_beyond(xp, xp.sqrt(b * b + v224 * v224), v224, theta, b) * v224 * v195
        v236 = 0.6366197723675814 * (v212 * xp.sum(v51 * (v230 * xp.cosh(v216 - v213) / v15), axis=0))
        v238 = 0.6366197723675814 * v170 + xp.where(v80, v236, 0.0)
        return (v160, v14 / v160 * v162 * (v238 + v154 * (v17 / v162 - v162 * v157)))
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
