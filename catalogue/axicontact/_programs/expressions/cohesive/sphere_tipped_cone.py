"""Formulas of axicontact.cohesive.sphere_tipped_cone over an array library `xp`."""

from ...._programs.expressions._runtime.functions import sine_root
from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
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
    v43 = xp.arctan2(v1, a) - v42
    v47 = v42 + v44 * v43
    v51 = xp.minimum(xp.absolute(v2 * xp.cos(v47)), v6)
    v59 = normal_slope(xp, v51, xp.sqrt((R - v51) * (R + v51)), R) * v47 * xp.sin(v47)
    v62 = xp.where(v7, a, 0.5 * v6)
    v63 = v62 < v6
    v64 = xp.where(v63, v62, 0.5 * v6)
    v65 = difference_root(xp, c, v64)
    v66 = difference_root(xp, v6, v64)
    v70 = xp.maximum(v65 - v66, 0.0) * (v65 + v66)
    v71 = v70 > 0.0
    v75 = xp.where(v63, 2.0 * v6, v62)
    v78 = xp.hypot(difference_root(xp, v75, v6), difference_root(xp, c, v75))
    v79 = xp.where(v63, xp.where(v71, xp.sqrt(xp.where(v71, v70, 1.0)), 0.0), v78)
    v82 = xp.where(v7, v79, difference_root(xp, c, xp.where(v7, 2.0 * v6, a)))
    v83 = difference_root(xp, a, v6)
    v85 = v82 > 0.0
    v86 = xp.where(v85, v82, 1.0)
    v87 = xp.where(v7, a, 0.5 * v6)
    v88 = difference_root(xp, c, v87)
    v89 = difference_root(xp, v6, v87)
    v93 = xp.maximum(v88 - v89, 0.0) * (v88 + v89)
    v94 = v93 > 0.0
    v98 = xp.where(v7, 2.0 * v6, a)
    v101 = xp.hypot(difference_root(xp, v98, v6), difference_root(xp, c, v98))
    v102 = xp.where(v7, xp.where(v94, xp.sqrt(xp.where(v94, v93, 1.0)), 0.0), v101)
    v103 = xp.where(v85, v102, v6)
    v105 = xp.arcsinh(v6 / v103)
    v107 = 1.5707963267948966 / v105
    v109 = xp.arctan2(v83, v82) / v105
    v120 = v107 * xp.sqrt(1.0 + v109 * v109) + v109 * xp.sqrt(1.0 + v107 * v107)
    v122 = xp.arcsinh(xp.arctan2(v82, v83) / v105 * (v107 + v109) / v120)
    v123 = v44 * v122
    v126 = xp.arcsinh(v107)
    v127 = 0.5 * v123
    v132 = 2.0 * v105 * xp.cosh(v126 - v127) * xp.sinh(v127)
    v135 = v103 * xp.maximum(xp.cos(v132), 1e-17)
    v138 = xp.sqrt(v6 * v6 + v135 * v135)
    v146 = v103 * xp.sin(v132)
    v144 = normal_slope_beyond(xp, v138, v135, R, theta) * v135 * v105 * xp.cosh(v126 - v123)
    v151 = v122 * xp.sum(v45 * (v144 * xp.arctan2(v146, v138) * (v146 / v138)), axis=0)
    v153 = 0.6366197723675814 * v2 * (v43 * xp.sum(v45 * v59, axis=0)) + 0.6366197723675814 * v151
    return sigma_0 * (v153 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, R, theta, E_star, dgamma, sigma_0):
    v80, v81 = nodes_along(xp, 1, a, R, theta, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v8 = xp.sqrt(v4)
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * v8), xp.inf)
    v13 = xp.hypot(a, v12)
    v17 = R * xp.sin(theta)
    v18 = a < v17
    v19 = xp.where(v18, a, 0.5 * v17)
    v25 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v19) * v8), xp.inf)
    v26 = xp.hypot(v19, v25)
    v27 = v26 > v17
    v28 = xp.where(v27, v26, 2.0 * v17)
    v29 = v19 < v17
    v30 = xp.where(v29, v19, 0.5 * v17)
    v31 = v30 < v17
    v32 = xp.where(v31, v30, 0.5 * v17)
    v38 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v32) * v8), xp.inf)
    v39 = difference_root(xp, v17, v32)
    v43 = xp.maximum(v38 - v39, 0.0) * (v38 + v39)
    v44 = v43 > 0.0
    v53 = v5 + xp.hypot(v5, xp.sqrt(2.0 * xp.where(v31, 2.0 * v17, v30)) * v8)
    v47 = xp.where(v44, xp.sqrt(xp.where(v44, v43, 1.0)), 0.0)
    v57 = xp.where(v29, 2.0 * v17, v19)
    v64 = xp.arctan2(xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v57) * v8), xp.inf), v57)
    v66 = xp.where(v27, 0.5 * v17, v26)
    v65 = xp.where(v29, xp.arctan2(xp.where(v31, v47, xp.minimum(v53, xp.inf)), v17), v64)
    v70 = xp.where(v18, 2.0 * v17, a)
    v77 = xp.arctan2(xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v70) * v8), xp.inf), v70)
    v78 = xp.where(v18, xp.minimum(xp.where(v27, v65, 0.0), xp.arctan2(v25, v19)), v77)
    v79 = xp.arctan2(v12, a) - v78
    v83 = v78 + v80 * v79
    v87 = xp.minimum(xp.absolute(v13 * xp.cos(v83)), v17)
    v95 = normal_slope(xp, v87, xp.sqrt((R - v87) * (R + v87)), R) * v83 * xp.sin(v83)
    v98 = xp.where(v18, a, 0.5 * v17)
    v99 = v98 < v17
    v100 = xp.where(v99, v98, 0.5 * v17)
    v106 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v100) * v8), xp.inf)
    v107 = difference_root(xp, v17, v100)
    v111 = xp.maximum(v106 - v107, 0.0) * (v106 + v107)
    v112 = v111 > 0.0
    v116 = xp.where(v99, 2.0 * v17, v98)
    v123 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v116) * v8), xp.inf)
    v115 = xp.where(v112, xp.sqrt(xp.where(v112, v111, 1.0)), 0.0)
    v132 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * xp.where(v18, 2.0 * v17, a)) * v8), xp.inf)
    v133 = xp.where(v18, xp.where(v99, v115, xp.hypot(difference_root(xp, v116, v17), v123)), v132)
    v134 = difference_root(xp, a, v17)
    v136 = v133 > 0.0
    v137 = xp.where(v136, v133, 1.0)
    v138 = xp.where(v18, a, 0.5 * v17)
    v144 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v138) * v8), xp.inf)
    v145 = difference_root(xp, v17, v138)
    v149 = xp.maximum(v144 - v145, 0.0) * (v144 + v145)
    v150 = v149 > 0.0
    v154 = xp.where(v18, 2.0 * v17, a)
    v161 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v154) * v8), xp.inf)
    v153 = xp.where(v150, xp.sqrt(xp.where(v150, v149, 1.0)), 0.0)
    v164 = xp.where(v136, xp.where(v18, v153, xp.hypot(difference_root(xp, v154, v17), v161)), v17)
    v166 = xp.arcsinh(v17 / v164)
    v168 = 1.5707963267948966 / v166
    v170 = xp.arctan2(v134, v133) / v166
    v181 = v168 * xp.sqrt(1.0 + v170 * v170) + v170 * xp.sqrt(1.0 + v168 * v168)
    v183 = xp.arcsinh(xp.arctan2(v133, v134) / v166 * (v168 + v170) / v181)
    v184 = v80 * v183
    v187 = xp.arcsinh(v168)
    v188 = 0.5 * v184
    v193 = 2.0 * v166 * xp.cosh(v187 - v188) * xp.sinh(v188)
    v196 = v164 * xp.maximum(xp.cos(v193), 1e-17)
    v199 = xp.sqrt(v17 * v17 + v196 * v196)
    v207 = v164 * xp.sin(v193)
    v205 = normal_slope_beyond(xp, v199, v196, R, theta) * v196 * v166 * xp.cosh(v187 - v184)
    v212 = v183 * xp.sum(v81 * (v205 * xp.arctan2(v207, v199) * (v207 / v199)), axis=0)
    v214 = 0.6366197723675814 * v13 * (v79 * xp.sum(v81 * v95, axis=0)) + 0.6366197723675814 * v212
    v215 = sigma_0 / dgamma
    v217 = v214 > 0.0
    v218 = xp.where(v217, v214, 1.0)
    v219 = v218 > 0.0
    v227 = xp.cos(v78 + v80 * v79)
    v230 = xp.minimum(xp.absolute(v13 * v227), v17)
    v236 = normal_slope(xp, v230, xp.sqrt((R - v230) * (R + v230)), R) * v227
    v239 = v80 * v183
    v242 = xp.arcsinh(v168)
    v243 = 0.5 * v239
    v250 = xp.maximum(xp.cos(2.0 * v166 * xp.cosh(v242 - v243) * xp.sinh(v243)), 1e-17)
    v251 = v164 * v250
    v256 = normal_slope_beyond(xp, xp.sqrt(v17 * v17 + v251 * v251), v251, R, theta) * v251
    v262 = v183 * xp.sum(v81 * (v256 * v166 * xp.cosh(v242 - v239) / v13), axis=0)
    v264 = 0.6366197723675814 * (v79 * xp.sum(v81 * v236, axis=0)) + 0.6366197723675814 * v262
    v265 = v12 / xp.where(v219, xp.where(v219, v218, 1.0), 1.0) * (v12 / v13) * v264
    v266 = xp.where(v217, v265, 1.0)
    v268 = 1.0 + a / v13
    v270 = 0.5 * (v266 + v268)
    v276 = (ring_of_zone(xp, v12, a, E_star, sigma_0) * v215) ** (v270 / v268)

    def f279(v282):
        v283 = xp.hypot(a, v282)
        v285 = xp.arctan2(v282, a)
        v286 = xp.where(v18, a, 0.5 * v17)
        v287 = xp.hypot(v286, v282)
        v288 = v287 > v17
        v289 = xp.where(v288, v287, 2.0 * v17)
        v290 = v286 < v17
        v291 = xp.where(v290, v286, 0.5 * v17)
        v292 = v291 < v17
        v294 = difference_root(xp, v17, xp.where(v292, v291, 0.5 * v17))
        v298 = xp.maximum(v282 - v294, 0.0) * (v282 + v294)
        v299 = v298 > 0.0
        v303 = xp.where(v292, 2.0 * v17, v291)
        v304 = xp.where(v292, xp.where(v299, xp.sqrt(xp.where(v299, v298, 1.0)), 0.0), v282)
        v309 = xp.where(v288, 0.5 * v17, v287)
        v308 = xp.where(v290, xp.arctan2(v304, v17), xp.arctan2(v282, xp.where(v290, 2.0 * v17, v286)))
        v312 = xp.minimum(xp.where(v288, v308, 0.0), xp.arctan2(v282, v286))
        v315 = xp.where(v18, v312, xp.arctan2(v282, xp.where(v18, 2.0 * v17, a)))
        v316 = v285 - v315
        v318 = v315 + v80 * v316
        v322 = xp.minimum(xp.absolute(v283 * xp.cos(v318)), v17)
        v330 = normal_slope(xp, v322, xp.sqrt((R - v322) * (R + v322)), R) * v318 * xp.sin(v318)
        v333 = xp.where(v18, a, 0.5 * v17)
        v334 = v333 < v17
        v336 = difference_root(xp, v17, xp.where(v334, v333, 0.5 * v17))
        v340 = xp.maximum(v282 - v336, 0.0) * (v282 + v336)
        v341 = v340 > 0.0
        v347 = xp.hypot(difference_root(xp, xp.where(v334, 2.0 * v17, v333), v17), v282)
        v349 = xp.where(v18, 2.0 * v17, a)
        v348 = xp.where(v334, xp.where(v341, xp.sqrt(xp.where(v341, v340, 1.0)), 0.0), v347)
        v350 = xp.where(v18, v348, v282)
        v352 = v350 > 0.0
        v353 = xp.where(v352, v350, 1.0)
        v355 = difference_root(xp, v17, xp.where(v18, a, 0.5 * v17))
        v359 = xp.maximum(v282 - v355, 0.0) * (v282 + v355)
        v360 = v359 > 0.0
        v366 = xp.hypot(difference_root(xp, xp.where(v18, 2.0 * v17, a), v17), v282)
        v367 = xp.where(v18, xp.where(v360, xp.sqrt(xp.where(v360, v359, 1.0)), 0.0), v366)
        v368 = xp.where(v352, v367, v17)
        v370 = xp.arcsinh(v17 / v368)
        v372 = 1.5707963267948966 / v370
        v374 = xp.arctan2(v134, v350) / v370
        v385 = v372 * xp.sqrt(1.0 + v374 * v374) + v374 * xp.sqrt(1.0 + v372 * v372)
        v387 = xp.arcsinh(xp.arctan2(v350, v134) / v370 * (v372 + v374) / v385)
        v388 = v80 * v387
        v391 = xp.arcsinh(v372)
        v392 = 0.5 * v388
        v397 = 2.0 * v370 * xp.cosh(v391 - v392) * xp.sinh(v392)
        v400 = v368 * xp.maximum(xp.cos(v397), 1e-17)
        v403 = xp.sqrt(v17 * v17 + v400 * v400)
        v411 = v368 * xp.sin(v397)
        v409 = normal_slope_beyond(xp, v403, v400, R, theta) * v400 * v370 * xp.cosh(v391 - v388)
        v416 = v387 * xp.sum(v81 * (v409 * xp.arctan2(v411, v403) * (v411 / v403)), axis=0)
        v420 = 1.2732395447351628 * (sigma_0 / E_star)
        v423 = v282 / (v283 + a)
        v418 = 0.6366197723675814 * v283 * (v316 * xp.sum(v81 * v330, axis=0)) + 0.6366197723675814 * v416
        v426 = v418 + v420 * v282 * (v285 - v423)
        v427 = v282 / v283
        v431 = xp.cos(v315 + v80 * v316)
        v434 = xp.minimum(xp.absolute(v283 * v431), v17)
        v440 = normal_slope(xp, v434, xp.sqrt((R - v434) * (R + v434)), R) * v431
        v443 = v80 * v387
        v446 = xp.arcsinh(v372)
        v447 = 0.5 * v443
        v454 = xp.maximum(xp.cos(2.0 * v370 * xp.cosh(v446 - v447) * xp.sinh(v447)), 1e-17)
        v455 = v368 * v454
        v460 = normal_slope_beyond(xp, xp.sqrt(v17 * v17 + v455 * v455), v455, R, theta) * v455
        v466 = v387 * xp.sum(v81 * (v460 * v370 * xp.cosh(v446 - v443) / v283), axis=0)
        v468 = 0.6366197723675814 * (v316 * xp.sum(v81 * v440, axis=0)) + 0.6366197723675814 * v466
        return (v426, v282 * v427 * (v468 + v420 * (v285 / v427 - v427 * v423)) / v426)
    v281 = xp.minimum(v12 * ((v214 * v215) ** (v270 / v266) + v276) ** (-1.0 / v270), xp.inf)
    return newton(xp, f279, v1, v281, xp.inf, 0.5, 4.0)


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
