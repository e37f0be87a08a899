"""Formulas of axicontact.cohesive.rounded_curved_punch over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.rounded_curved_punch import depth as normal_depth
from ...._programs.expressions.normal.rounded_curved_punch import displacement as normal_displacement
from ...._programs.expressions.normal.rounded_curved_punch import force as normal_force
from ...._programs.expressions.normal.rounded_curved_punch import pressure as normal_pressure
from ...._programs.expressions.normal.rounded_curved_punch import slope_beyond as normal_slope_beyond
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, R1, R2, b, E_star, sigma_0):
    v42, v43 = nodes_along(xp, 1, a, c, R1, R2, b, E_star, sigma_0)
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
    v53 = 2.0 * xp.minimum(v2 * xp.cos(v45), b) / R1 * v45 * xp.sin(v45)
    v56 = xp.where(v5, a, 0.5 * b)
    v57 = v56 < b
    v58 = xp.where(v57, v56, 0.5 * b)
    v59 = difference_root(xp, c, v58)
    v60 = difference_root(xp, b, v58)
    v64 = xp.maximum(v59 - v60, 0.0) * (v59 + v60)
    v65 = v64 > 0.0
    v69 = xp.where(v57, 2.0 * b, v56)
    v72 = xp.hypot(difference_root(xp, v69, b), difference_root(xp, c, v69))
    v73 = xp.where(v57, xp.where(v65, xp.sqrt(xp.where(v65, v64, 1.0)), 0.0), v72)
    v76 = xp.where(v5, v73, difference_root(xp, c, xp.where(v5, 2.0 * b, a)))
    v77 = v76 > 0.0
    v78 = xp.where(v77, v76, 1.0)
    v79 = v78 > 0.0
    v81 = xp.where(v79, xp.where(v79, v78, 1.0), b)
    v82 = difference_root(xp, a, b)
    v84 = xp.where(v79, v78, 1.0)
    v85 = xp.where(v5, a, 0.5 * b)
    v86 = difference_root(xp, c, v85)
    v87 = difference_root(xp, b, v85)
    v91 = xp.maximum(v86 - v87, 0.0) * (v86 + v87)
    v92 = v91 > 0.0
    v96 = xp.where(v5, 2.0 * b, a)
    v99 = xp.hypot(difference_root(xp, v96, b), difference_root(xp, c, v96))
    v101 = xp.where(v79, xp.where(v5, xp.where(v92, xp.sqrt(xp.where(v92, v91, 1.0)), 0.0), v99), b)
    v103 = xp.arcsinh(b / v101)
    v105 = 1.5707963267948966 / v103
    v107 = xp.arctan2(v82, v81) / v103
    v118 = v105 * xp.sqrt(1.0 + v107 * v107) + v107 * xp.sqrt(1.0 + v105 * v105)
    v120 = xp.arcsinh(xp.arctan2(v81, v82) / v103 * (v105 + v107) / v118)
    v121 = v42 * v120
    v124 = xp.arcsinh(v105)
    v125 = 0.5 * v121
    v130 = 2.0 * v103 * xp.cosh(v124 - v125) * xp.sinh(v125)
    v132 = v101 * xp.cos(v130)
    v135 = xp.sqrt(b * b + v132 * v132)
    v143 = v101 * xp.sin(v130)
    v141 = normal_slope_beyond(xp, v135, v132, R1, R2, b) * v132 * v103 * xp.cosh(v124 - v121)
    v148 = v120 * xp.sum(v43 * (v141 * xp.arctan2(v143, v135) * (v143 / v135)), axis=0)
    v55 = 0.6366197723675814 * v2 * (v41 * xp.sum(v43 * v53, axis=0))
    v158 = 1.2732395447351628 * (sigma_0 / E_star) * v1 * (v4 - v1 / (v2 + a))
    return sigma_0 * (v55 + xp.where(v77, 0.6366197723675814 * v148, 0.0) + v158)


def zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0):
    v50, v51 = nodes_along(xp, 1, a, R1, R2, b, E_star, dgamma, sigma_0)
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
        v61 = 2.0 * xp.minimum(v15 * xp.cos(v53), b) / R1 * v53 * xp.sin(v53)
        v64 = xp.where(v18, a, 0.5 * b)
        v65 = v64 < b
        v67 = difference_root(xp, b, xp.where(v65, v64, 0.5 * b))
        v71 = xp.maximum(v14 - v67, 0.0) * (v14 + v67)
        v72 = v71 > 0.0
        v78 = xp.hypot(difference_root(xp, xp.where(v65, 2.0 * b, v64), b), v14)
        v80 = xp.where(v18, 2.0 * b, a)
        v79 = xp.where(v65, xp.where(v72, xp.sqrt(xp.where(v72, v71, 1.0)), 0.0), v78)
        v81 = xp.where(v18, v79, v14)
        v82 = v81 > 0.0
        v83 = xp.where(v82, v81, 1.0)
        v84 = v83 > 0.0
        v86 = xp.where(v84, xp.where(v84, v83, 1.0), b)
        v87 = difference_root(xp, a, b)
        v89 = xp.where(v84, v83, 1.0)
        v91 = difference_root(xp, b, xp.where(v18, a, 0.5 * b))
        v95 = xp.maximum(v14 - v91, 0.0) * (v14 + v91)
        v96 = v95 > 0.0
        v102 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * b, a), b), v14)
        v103 = xp.where(v18, xp.where(v96, xp.sqrt(xp.where(v96, v95, 1.0)), 0.0), v102)
        v104 = xp.where(v84, v103, b)
        v106 = xp.arcsinh(b / v104)
        v108 = 1.5707963267948966 / v106
        v110 = xp.arctan2(v87, v86) / v106
        v121 = v108 * xp.sqrt(1.0 + v110 * v110) + v110 * xp.sqrt(1.0 + v108 * v108)
        v123 = xp.arcsinh(xp.arctan2(v86, v87) / v106 * (v108 + v110) / v121)
        v124 = v50 * v123
        v127 = xp.arcsinh(v108)
        v128 = 0.5 * v124
        v133 = 2.0 * v106 * xp.cosh(v127 - v128) * xp.sinh(v128)
        v135 = v104 * xp.cos(v133)
        v138 = xp.sqrt(b * b + v135 * v135)
        v146 = v104 * xp.sin(v133)
        v144 = normal_slope_beyond(xp, v138, v135, R1, R2, b) * v135 * v106 * xp.cosh(v127 - v124)
        v151 = v123 * xp.sum(v51 * (v144 * xp.arctan2(v146, v138) * (v146 / v138)), axis=0)
        v63 = 0.6366197723675814 * v15 * (v49 * xp.sum(v51 * v61, axis=0))
        v156 = 1.2732395447351628 * (sigma_0 / E_star)
        v159 = v14 / (v15 + a)
        v162 = v63 + xp.where(v82, 0.6366197723675814 * v151, 0.0) + v156 * v14 * (v17 - v159)
        v164 = v14 / v15
        v168 = xp.cos(v48 + v50 * v49)
        v174 = v49 * xp.sum(v51 * (2.0 * xp.minimum(v15 * v168, b) / R1 * v168), axis=0)
        v176 = xp.where(v82, v81, 1.0)
        v177 = v176 > 0.0
        v179 = xp.where(v177, xp.where(v177, v176, 1.0), b)
        v180 = difference_root(xp, a, b)
        v182 = xp.where(v177, v176, 1.0)
        v184 = difference_root(xp, b, xp.where(v18, a, 0.5 * b))
        v188 = xp.maximum(v14 - v184, 0.0) * (v14 + v184)
        v189 = v188 > 0.0
        v195 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * b, a), b), v14)
        v196 = xp.where(v18, xp.where(v189, xp.sqrt(xp.where(v189, v188, 1.0)), 0.0), v195)
        v197 = xp.where(v177, v196, b)
        v199 = xp.arcsinh(b / v197)
        v201 = 1.5707963267948966 / v199
        v203 = xp.arctan2(v180, v179) / v199
        v214 = v201 * xp.sqrt(1.0 + v203 * v203) + v203 * xp.sqrt(1.0 + v201 * v201)
        v216 = xp.arcsinh(xp.arctan2(v179, v180) / v199 * (v201 + v203) / v214)
        v217 = v50 * v216
        v220 = xp.arcsinh(v201)
        v221 = 0.5 * v217
        v228 = v197 * xp.cos(2.0 * v199 * xp.cosh(v220 - v221) * xp.sinh(v221))
        v234 = normal_slope_beyond(xp, xp.sqrt(b * b + v228 * v228), v228, R1, R2, b) * v228 * v199
        v240 = 0.6366197723675814 * (v216 * xp.sum(v51 * (v234 * xp.cosh(v220 - v217) / v15), axis=0))
        v242 = 0.6366197723675814 * v174 + xp.where(v82, v240, 0.0)
        return (v162, v14 / v162 * v164 * (v242 + v156 * (v17 / v164 - v164 * v159)))
    v13 = xp.minimum(v6 + xp.sqrt(v6 ** 2.0 + 2.0 * a * v4), xp.inf)
    return newton(xp, f13, v1, v13, xp.inf, 0.5, 4.0)


def cohesive_radius(xp, a, R1, R2, b, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, R1, R2, b, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, R1, R2, b) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, R1, R2, b, E_star, dgamma, sigma_0):
    v1 = zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0)
    return depth_of(xp, a, v1, R1, R2, b, E_star, dgamma, sigma_0)


def force(xp, a, R1, R2, b, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, R1, R2, b, E_star) - v3


def pressure(xp, r, a, R1, R2, b, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, R1, R2, b, E_star) - v3


def displacement(xp, r, a, R1, R2, b, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, R1, R2, b) - v3
