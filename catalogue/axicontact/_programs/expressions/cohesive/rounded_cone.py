"""Formulas of axicontact.cohesive.rounded_cone over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
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
    v41 = xp.arctan2(v1, a) - v40
    v45 = v40 + v42 * v41
    v51 = normal_slope(xp, xp.minimum(xp.absolute(v2 * xp.cos(v45)), b), theta, b) * v45
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
    v77 = difference_root(xp, a, b)
    v79 = v76 > 0.0
    v80 = xp.where(v79, v76, 1.0)
    v81 = xp.where(v5, a, 0.5 * b)
    v82 = difference_root(xp, c, v81)
    v83 = difference_root(xp, b, v81)
    v87 = xp.maximum(v82 - v83, 0.0) * (v82 + v83)
    v88 = v87 > 0.0
    v92 = xp.where(v5, 2.0 * b, a)
    v95 = xp.hypot(difference_root(xp, v92, b), difference_root(xp, c, v92))
    v97 = xp.where(v79, xp.where(v5, xp.where(v88, xp.sqrt(xp.where(v88, v87, 1.0)), 0.0), v95), b)
    v99 = xp.arcsinh(b / v97)
    v101 = 1.5707963267948966 / v99
    v103 = xp.arctan2(v77, v76) / v99
    v114 = v101 * xp.sqrt(1.0 + v103 * v103) + v103 * xp.sqrt(1.0 + v101 * v101)
    v116 = xp.arcsinh(xp.arctan2(v76, v77) / v99 * (v101 + v103) / v114)
    v117 = v42 * v116
    v120 = xp.arcsinh(v101)
    v121 = 0.5 * v117
    v126 = 2.0 * v99 * xp.cosh(v120 - v121) * xp.sinh(v121)
    v129 = v97 * xp.maximum(xp.cos(v126), 1e-17)
    v132 = xp.sqrt(b * b + v129 * v129)
    v140 = v97 * xp.sin(v126)
    v138 = normal_slope_beyond(xp, v132, v129, theta, b) * v129 * v99 * xp.cosh(v120 - v117)
    v145 = v116 * xp.sum(v43 * (v138 * xp.arctan2(v140, v132) * (v140 / v132)), axis=0)
    v55 = 0.6366197723675814 * v2 * (v41 * xp.sum(v43 * (v51 * xp.sin(v45)), axis=0))
    v150 = sigma_0 * (v55 + 0.6366197723675814 * v145 + ring_of_zone(xp, v1, a, E_star, sigma_0))
    return v150


def zone(xp, a, theta, b, E_star, dgamma, sigma_0):
    v78, v79 = nodes_along(xp, 1, a, theta, b, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v8 = xp.sqrt(v4)
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * v8), xp.inf)
    v13 = xp.hypot(a, v12)
    v16 = a < b
    v17 = xp.where(v16, a, 0.5 * b)
    v23 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v17) * v8), xp.inf)
    v24 = xp.hypot(v17, v23)
    v25 = v24 > b
    v26 = xp.where(v25, v24, 2.0 * b)
    v27 = v17 < b
    v28 = xp.where(v27, v17, 0.5 * b)
    v29 = v28 < b
    v30 = xp.where(v29, v28, 0.5 * b)
    v36 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v30) * v8), xp.inf)
    v37 = difference_root(xp, b, v30)
    v41 = xp.maximum(v36 - v37, 0.0) * (v36 + v37)
    v42 = v41 > 0.0
    v52 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * xp.where(v29, 2.0 * b, v28)) * v8), xp.inf)
    v55 = xp.where(v27, 2.0 * b, v17)
    v62 = xp.arctan2(xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v55) * v8), xp.inf), v55)
    v54 = xp.arctan2(xp.where(v29, xp.where(v42, xp.sqrt(xp.where(v42, v41, 1.0)), 0.0), v52), b)
    v64 = xp.where(v25, 0.5 * b, v24)
    v68 = xp.where(v16, 2.0 * b, a)
    v67 = xp.minimum(xp.where(v25, xp.where(v27, v54, v62), 0.0), xp.arctan2(v23, v17))
    v75 = xp.arctan2(xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v68) * v8), xp.inf), v68)
    v76 = xp.where(v16, v67, v75)
    v77 = xp.arctan2(v12, a) - v76
    v81 = v76 + v78 * v77
    v87 = normal_slope(xp, xp.minimum(xp.absolute(v13 * xp.cos(v81)), b), theta, b) * v81
    v92 = xp.where(v16, a, 0.5 * b)
    v93 = v92 < b
    v94 = xp.where(v93, v92, 0.5 * b)
    v100 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v94) * v8), xp.inf)
    v101 = difference_root(xp, b, v94)
    v105 = xp.maximum(v100 - v101, 0.0) * (v100 + v101)
    v106 = v105 > 0.0
    v110 = xp.where(v93, 2.0 * b, v92)
    v117 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v110) * v8), xp.inf)
    v109 = xp.where(v106, xp.sqrt(xp.where(v106, v105, 1.0)), 0.0)
    v126 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * xp.where(v16, 2.0 * b, a)) * v8), xp.inf)
    v127 = xp.where(v16, xp.where(v93, v109, xp.hypot(difference_root(xp, v110, b), v117)), v126)
    v128 = difference_root(xp, a, b)
    v130 = v127 > 0.0
    v131 = xp.where(v130, v127, 1.0)
    v132 = xp.where(v16, a, 0.5 * b)
    v138 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v132) * v8), xp.inf)
    v139 = difference_root(xp, b, v132)
    v143 = xp.maximum(v138 - v139, 0.0) * (v138 + v139)
    v144 = v143 > 0.0
    v148 = xp.where(v16, 2.0 * b, a)
    v155 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v148) * v8), xp.inf)
    v147 = xp.where(v144, xp.sqrt(xp.where(v144, v143, 1.0)), 0.0)
    v158 = xp.where(v130, xp.where(v16, v147, xp.hypot(difference_root(xp, v148, b), v155)), b)
    v160 = xp.arcsinh(b / v158)
    v162 = 1.5707963267948966 / v160
    v164 = xp.arctan2(v128, v127) / v160
    v175 = v162 * xp.sqrt(1.0 + v164 * v164) + v164 * xp.sqrt(1.0 + v162 * v162)
    v177 = xp.arcsinh(xp.arctan2(v127, v128) / v160 * (v162 + v164) / v175)
    v178 = v78 * v177
    v181 = xp.arcsinh(v162)
    v182 = 0.5 * v178
    v187 = 2.0 * v160 * xp.cosh(v181 - v182) * xp.sinh(v182)
    v190 = v158 * xp.maximum(xp.cos(v187), 1e-17)
    v193 = xp.sqrt(b * b + v190 * v190)
    v201 = v158 * xp.sin(v187)
    v199 = normal_slope_beyond(xp, v193, v190, theta, b) * v190 * v160 * xp.cosh(v181 - v178)
    v206 = v177 * xp.sum(v79 * (v199 * xp.arctan2(v201, v193) * (v201 / v193)), axis=0)
    v91 = 0.6366197723675814 * v13 * (v77 * xp.sum(v79 * (v87 * xp.sin(v81)), axis=0))
    v208 = v91 + 0.6366197723675814 * v206
    v209 = sigma_0 / dgamma
    v211 = v208 > 0.0
    v212 = xp.where(v211, v208, 1.0)
    v213 = v212 > 0.0
    v221 = xp.cos(v76 + v78 * v77)
    v226 = normal_slope(xp, xp.minimum(xp.absolute(v13 * v221), b), theta, b) * v221
    v229 = v78 * v177
    v232 = xp.arcsinh(v162)
    v233 = 0.5 * v229
    v240 = xp.maximum(xp.cos(2.0 * v160 * xp.cosh(v232 - v233) * xp.sinh(v233)), 1e-17)
    v241 = v158 * v240
    v247 = normal_slope_beyond(xp, xp.sqrt(b * b + v241 * v241), v241, theta, b) * v241 * v160
    v253 = 0.6366197723675814 * (v177 * xp.sum(v79 * (v247 * xp.cosh(v232 - v229) / v13), axis=0))
    v218 = v12 / xp.where(v213, xp.where(v213, v212, 1.0), 1.0) * (v12 / v13)
    v256 = xp.where(v211, v218 * (0.6366197723675814 * (v77 * xp.sum(v79 * v226, axis=0)) + v253), 1.0)
    v258 = 1.0 + a / v13
    v260 = 0.5 * (v256 + v258)
    v266 = (ring_of_zone(xp, v12, a, E_star, sigma_0) * v209) ** (v260 / v258)

    def f269(v272):
        v273 = xp.hypot(a, v272)
        v275 = xp.arctan2(v272, a)
        v276 = xp.where(v16, a, 0.5 * b)
        v277 = xp.hypot(v276, v272)
        v278 = v277 > b
        v279 = xp.where(v278, v277, 2.0 * b)
        v280 = v276 < b
        v281 = xp.where(v280, v276, 0.5 * b)
        v282 = v281 < b
        v284 = difference_root(xp, b, xp.where(v282, v281, 0.5 * b))
        v288 = xp.maximum(v272 - v284, 0.0) * (v272 + v284)
        v289 = v288 > 0.0
        v293 = xp.where(v282, 2.0 * b, v281)
        v294 = xp.where(v282, xp.where(v289, xp.sqrt(xp.where(v289, v288, 1.0)), 0.0), v272)
        v299 = xp.where(v278, 0.5 * b, v277)
        v298 = xp.where(v280, xp.arctan2(v294, b), xp.arctan2(v272, xp.where(v280, 2.0 * b, v276)))
        v302 = xp.minimum(xp.where(v278, v298, 0.0), xp.arctan2(v272, v276))
        v305 = xp.where(v16, v302, xp.arctan2(v272, xp.where(v16, 2.0 * b, a)))
        v306 = v275 - v305
        v308 = v305 + v78 * v306
        v314 = normal_slope(xp, xp.minimum(xp.absolute(v273 * xp.cos(v308)), b), theta, b) * v308
        v319 = xp.where(v16, a, 0.5 * b)
        v320 = v319 < b
        v322 = difference_root(xp, b, xp.where(v320, v319, 0.5 * b))
        v326 = xp.maximum(v272 - v322, 0.0) * (v272 + v322)
        v327 = v326 > 0.0
        v333 = xp.hypot(difference_root(xp, xp.where(v320, 2.0 * b, v319), b), v272)
        v335 = xp.where(v16, 2.0 * b, a)
        v334 = xp.where(v320, xp.where(v327, xp.sqrt(xp.where(v327, v326, 1.0)), 0.0), v333)
        v336 = xp.where(v16, v334, v272)
        v338 = v336 > 0.0
        v339 = xp.where(v338, v336, 1.0)
        v341 = difference_root(xp, b, xp.where(v16, a, 0.5 * b))
        v345 = xp.maximum(v272 - v341, 0.0) * (v272 + v341)
        v346 = v345 > 0.0
        v352 = xp.hypot(difference_root(xp, xp.where(v16, 2.0 * b, a), b), v272)
        v353 = xp.where(v16, xp.where(v346, xp.sqrt(xp.where(v346, v345, 1.0)), 0.0), v352)
        v354 = xp.where(v338, v353, b)
        v356 = xp.arcsinh(b / v354)
        v358 = 1.5707963267948966 / v356
        v360 = xp.arctan2(v128, v336) / v356
        v371 = v358 * xp.sqrt(1.0 + v360 * v360) + v360 * xp.sqrt(1.0 + v358 * v358)
        v373 = xp.arcsinh(xp.arctan2(v336, v128) / v356 * (v358 + v360) / v371)
        v374 = v78 * v373
        v377 = xp.arcsinh(v358)
        v378 = 0.5 * v374
        v383 = 2.0 * v356 * xp.cosh(v377 - v378) * xp.sinh(v378)
        v386 = v354 * xp.maximum(xp.cos(v383), 1e-17)
        v389 = xp.sqrt(b * b + v386 * v386)
        v397 = v354 * xp.sin(v383)
        v395 = normal_slope_beyond(xp, v389, v386, theta, b) * v386 * v356 * xp.cosh(v377 - v374)
        v402 = v373 * xp.sum(v79 * (v395 * xp.arctan2(v397, v389) * (v397 / v389)), axis=0)
        v318 = 0.6366197723675814 * v273 * (v306 * xp.sum(v79 * (v314 * xp.sin(v308)), axis=0))
        v406 = 1.2732395447351628 * (sigma_0 / E_star)
        v409 = v272 / (v273 + a)
        v412 = v318 + 0.6366197723675814 * v402 + v406 * v272 * (v275 - v409)
        v413 = v272 / v273
        v417 = xp.cos(v305 + v78 * v306)
        v422 = normal_slope(xp, xp.minimum(xp.absolute(v273 * v417), b), theta, b) * v417
        v425 = v78 * v373
        v428 = xp.arcsinh(v358)
        v429 = 0.5 * v425
        v436 = xp.maximum(xp.cos(2.0 * v356 * xp.cosh(v428 - v429) * xp.sinh(v429)), 1e-17)
        v437 = v354 * v436
        v443 = normal_slope_beyond(xp, xp.sqrt(b * b + v437 * v437), v437, theta, b) * v437 * v356
        v449 = 0.6366197723675814 * (v373 * xp.sum(v79 * (v443 * xp.cosh(v428 - v425) / v273), axis=0))
        v450 = 0.6366197723675814 * (v306 * xp.sum(v79 * v422, axis=0)) + v449
        return (v412, v272 * v413 * (v450 + v406 * (v275 / v413 - v413 * v409)) / v412)
    v271 = xp.minimum(v12 * ((v208 * v209) ** (v260 / v256) + v266) ** (-1.0 / v260), xp.inf)
    return newton(xp, f269, v1, v271, xp.inf, 0.5, 4.0)


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
