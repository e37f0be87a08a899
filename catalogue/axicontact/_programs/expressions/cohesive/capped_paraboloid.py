"""Formulas of axicontact.cohesive.capped_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.capped_paraboloid import depth as normal_depth
from ...._programs.expressions.normal.capped_paraboloid import displacement as normal_displacement
from ...._programs.expressions.normal.capped_paraboloid import force as normal_force
from ...._programs.expressions.normal.capped_paraboloid import pressure as normal_pressure
from ...._programs.expressions.normal.capped_paraboloid import slope_beyond as normal_slope_beyond
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along


def work_of_separation(xp, a, c, R1, R2, b, E_star, sigma_0):
    v42, v43 = nodes_along(xp, 1, a, c, R1, R2, b, E_star, sigma_0)
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
    v54 = 2.0 * xp.minimum(xp.absolute(v2 * xp.cos(v45)), b) / R1 * v45 * xp.sin(v45)
    v57 = xp.where(v5, a, 0.5 * b)
    v58 = v57 < b
    v59 = xp.where(v58, v57, 0.5 * b)
    v60 = difference_root(xp, c, v59)
    v61 = difference_root(xp, b, v59)
    v65 = xp.maximum(v60 - v61, 0.0) * (v60 + v61)
    v66 = v65 > 0.0
    v70 = xp.where(v58, 2.0 * b, v57)
    v73 = xp.hypot(difference_root(xp, v70, b), difference_root(xp, c, v70))
    v74 = xp.where(v58, xp.where(v66, xp.sqrt(xp.where(v66, v65, 1.0)), 0.0), v73)
    v77 = xp.where(v5, v74, difference_root(xp, c, xp.where(v5, 2.0 * b, a)))
    v78 = difference_root(xp, a, b)
    v80 = v77 > 0.0
    v81 = xp.where(v80, v77, 1.0)
    v82 = xp.where(v5, a, 0.5 * b)
    v83 = difference_root(xp, c, v82)
    v84 = difference_root(xp, b, v82)
    v88 = xp.maximum(v83 - v84, 0.0) * (v83 + v84)
    v89 = v88 > 0.0
    v93 = xp.where(v5, 2.0 * b, a)
    v96 = xp.hypot(difference_root(xp, v93, b), difference_root(xp, c, v93))
    v98 = xp.where(v80, xp.where(v5, xp.where(v89, xp.sqrt(xp.where(v89, v88, 1.0)), 0.0), v96), b)
    v100 = xp.arcsinh(b / v98)
    v102 = 1.5707963267948966 / v100
    v104 = xp.arctan2(v78, v77) / v100
    v115 = v102 * xp.sqrt(1.0 + v104 * v104) + v104 * xp.sqrt(1.0 + v102 * v102)
    v117 = xp.arcsinh(xp.arctan2(v77, v78) / v100 * (v102 + v104) / v115)
    v118 = v42 * v117
    v121 = xp.arcsinh(v102)
    v122 = 0.5 * v118
    v127 = 2.0 * v100 * xp.cosh(v121 - v122) * xp.sinh(v122)
    v130 = v98 * xp.maximum(xp.cos(v127), 1e-17)
    v133 = xp.sqrt(b * b + v130 * v130)
    v141 = v98 * xp.sin(v127)
    v139 = normal_slope_beyond(xp, v133, v130, R1, R2, b) * v130 * v100 * xp.cosh(v121 - v118)
    v146 = v117 * xp.sum(v43 * (v139 * xp.arctan2(v141, v133) * (v141 / v133)), axis=0)
    v148 = 0.6366197723675814 * v2 * (v41 * xp.sum(v43 * v54, axis=0)) + 0.6366197723675814 * v146
    return sigma_0 * (v148 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, R1, R2, b, E_star, dgamma, sigma_0):
    v78, v79 = nodes_along(xp, 1, a, R1, R2, b, E_star, dgamma, sigma_0)
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
    v90 = 2.0 * xp.minimum(xp.absolute(v13 * xp.cos(v81)), b) / R1 * v81 * xp.sin(v81)
    v93 = xp.where(v16, a, 0.5 * b)
    v94 = v93 < b
    v95 = xp.where(v94, v93, 0.5 * b)
    v101 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v95) * v8), xp.inf)
    v102 = difference_root(xp, b, v95)
    v106 = xp.maximum(v101 - v102, 0.0) * (v101 + v102)
    v107 = v106 > 0.0
    v111 = xp.where(v94, 2.0 * b, v93)
    v118 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v111) * v8), xp.inf)
    v110 = xp.where(v107, xp.sqrt(xp.where(v107, v106, 1.0)), 0.0)
    v127 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * xp.where(v16, 2.0 * b, a)) * v8), xp.inf)
    v128 = xp.where(v16, xp.where(v94, v110, xp.hypot(difference_root(xp, v111, b), v118)), v127)
    v129 = difference_root(xp, a, b)
    v131 = v128 > 0.0
    v132 = xp.where(v131, v128, 1.0)
    v133 = xp.where(v16, a, 0.5 * b)
    v139 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v133) * v8), xp.inf)
    v140 = difference_root(xp, b, v133)
    v144 = xp.maximum(v139 - v140, 0.0) * (v139 + v140)
    v145 = v144 > 0.0
    v149 = xp.where(v16, 2.0 * b, a)
    v156 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * v149) * v8), xp.inf)
    v148 = xp.where(v145, xp.sqrt(xp.where(v145, v144, 1.0)), 0.0)
    v159 = xp.where(v131, xp.where(v16, v148, xp.hypot(difference_root(xp, v149, b), v156)), b)
    v161 = xp.arcsinh(b / v159)
    v163 = 1.5707963267948966 / v161
    v165 = xp.arctan2(v129, v128) / v161
    v176 = v163 * xp.sqrt(1.0 + v165 * v165) + v165 * xp.sqrt(1.0 + v163 * v163)
    v178 = xp.arcsinh(xp.arctan2(v128, v129) / v161 * (v163 + v165) / v176)
    v179 = v78 * v178
    v182 = xp.arcsinh(v163)
    v183 = 0.5 * v179
    v188 = 2.0 * v161 * xp.cosh(v182 - v183) * xp.sinh(v183)
    v191 = v159 * xp.maximum(xp.cos(v188), 1e-17)
    v194 = xp.sqrt(b * b + v191 * v191)
    v202 = v159 * xp.sin(v188)
    v200 = normal_slope_beyond(xp, v194, v191, R1, R2, b) * v191 * v161 * xp.cosh(v182 - v179)
    v207 = v178 * xp.sum(v79 * (v200 * xp.arctan2(v202, v194) * (v202 / v194)), axis=0)
    v209 = 0.6366197723675814 * v13 * (v77 * xp.sum(v79 * v90, axis=0)) + 0.6366197723675814 * v207
    v210 = sigma_0 / dgamma
    v212 = v209 > 0.0
    v213 = xp.where(v212, v209, 1.0)
    v214 = v213 > 0.0
    v222 = xp.cos(v76 + v78 * v77)
    v229 = v77 * xp.sum(v79 * (2.0 * xp.minimum(xp.absolute(v13 * v222), b) / R1 * v222), axis=0)
    v231 = v78 * v178
    v234 = xp.arcsinh(v163)
    v235 = 0.5 * v231
    v242 = xp.maximum(xp.cos(2.0 * v161 * xp.cosh(v234 - v235) * xp.sinh(v235)), 1e-17)
    v243 = v159 * v242
    v249 = normal_slope_beyond(xp, xp.sqrt(b * b + v243 * v243), v243, R1, R2, b) * v243 * v161
    v255 = 0.6366197723675814 * (v178 * xp.sum(v79 * (v249 * xp.cosh(v234 - v231) / v13), axis=0))
    v219 = v12 / xp.where(v214, xp.where(v214, v213, 1.0), 1.0) * (v12 / v13)
    v258 = xp.where(v212, v219 * (0.6366197723675814 * v229 + v255), 1.0)
    v260 = 1.0 + a / v13
    v262 = 0.5 * (v258 + v260)
    v268 = (ring_of_zone(xp, v12, a, E_star, sigma_0) * v210) ** (v262 / v260)

    def f271(v274):
        v275 = xp.hypot(a, v274)
        v277 = xp.arctan2(v274, a)
        v278 = xp.where(v16, a, 0.5 * b)
        v279 = xp.hypot(v278, v274)
        v280 = v279 > b
        v281 = xp.where(v280, v279, 2.0 * b)
        v282 = v278 < b
        v283 = xp.where(v282, v278, 0.5 * b)
        v284 = v283 < b
        v286 = difference_root(xp, b, xp.where(v284, v283, 0.5 * b))
        v290 = xp.maximum(v274 - v286, 0.0) * (v274 + v286)
        v291 = v290 > 0.0
        v295 = xp.where(v284, 2.0 * b, v283)
        v296 = xp.where(v284, xp.where(v291, xp.sqrt(xp.where(v291, v290, 1.0)), 0.0), v274)
        v301 = xp.where(v280, 0.5 * b, v279)
        v300 = xp.where(v282, xp.arctan2(v296, b), xp.arctan2(v274, xp.where(v282, 2.0 * b, v278)))
        v304 = xp.minimum(xp.where(v280, v300, 0.0), xp.arctan2(v274, v278))
        v307 = xp.where(v16, v304, xp.arctan2(v274, xp.where(v16, 2.0 * b, a)))
        v308 = v277 - v307
        v310 = v307 + v78 * v308
        v319 = 2.0 * xp.minimum(xp.absolute(v275 * xp.cos(v310)), b) / R1 * v310 * xp.sin(v310)
        v322 = xp.where(v16, a, 0.5 * b)
        v323 = v322 < b
        v325 = difference_root(xp, b, xp.where(v323, v322, 0.5 * b))
        v329 = xp.maximum(v274 - v325, 0.0) * (v274 + v325)
        v330 = v329 > 0.0
        v336 = xp.hypot(difference_root(xp, xp.where(v323, 2.0 * b, v322), b), v274)
        v338 = xp.where(v16, 2.0 * b, a)
        v337 = xp.where(v323, xp.where(v330, xp.sqrt(xp.where(v330, v329, 1.0)), 0.0), v336)
        v339 = xp.where(v16, v337, v274)
        v341 = v339 > 0.0
        v342 = xp.where(v341, v339, 1.0)
        v344 = difference_root(xp, b, xp.where(v16, a, 0.5 * b))
        v348 = xp.maximum(v274 - v344, 0.0) * (v274 + v344)
        v349 = v348 > 0.0
        v355 = xp.hypot(difference_root(xp, xp.where(v16, 2.0 * b, a), b), v274)
        v356 = xp.where(v16, xp.where(v349, xp.sqrt(xp.where(v349, v348, 1.0)), 0.0), v355)
        v357 = xp.where(v341, v356, b)
        v359 = xp.arcsinh(b / v357)
        v361 = 1.5707963267948966 / v359
        v363 = xp.arctan2(v129, v339) / v359
        v374 = v361 * xp.sqrt(1.0 + v363 * v363) + v363 * xp.sqrt(1.0 + v361 * v361)
        v376 = xp.arcsinh(xp.arctan2(v339, v129) / v359 * (v361 + v363) / v374)
        v377 = v78 * v376
        v380 = xp.arcsinh(v361)
        v381 = 0.5 * v377
        v386 = 2.0 * v359 * xp.cosh(v380 - v381) * xp.sinh(v381)
        v389 = v357 * xp.maximum(xp.cos(v386), 1e-17)
        v392 = xp.sqrt(b * b + v389 * v389)
        v400 = v357 * xp.sin(v386)
        v398 = normal_slope_beyond(xp, v392, v389, R1, R2, b) * v389 * v359 * xp.cosh(v380 - v377)
        v405 = v376 * xp.sum(v79 * (v398 * xp.arctan2(v400, v392) * (v400 / v392)), axis=0)
        v409 = 1.2732395447351628 * (sigma_0 / E_star)
        v412 = v274 / (v275 + a)
        v407 = 0.6366197723675814 * v275 * (v308 * xp.sum(v79 * v319, axis=0)) + 0.6366197723675814 * v405
        v415 = v407 + v409 * v274 * (v277 - v412)
        v416 = v274 / v275
        v420 = xp.cos(v307 + v78 * v308)
        v427 = v308 * xp.sum(v79 * (2.0 * xp.minimum(xp.absolute(v275 * v420), b) / R1 * v420), axis=0)
        v429 = v78 * v376
        v432 = xp.arcsinh(v361)
        v433 = 0.5 * v429
        v440 = xp.maximum(xp.cos(2.0 * v359 * xp.cosh(v432 - v433) * xp.sinh(v433)), 1e-17)
        v441 = v357 * v440
        v447 = normal_slope_beyond(xp, xp.sqrt(b * b + v441 * v441), v441, R1, R2, b) * v441 * v359
        v453 = 0.6366197723675814 * (v376 * xp.sum(v79 * (v447 * xp.cosh(v432 - v429) / v275), axis=0))
        v460 = v274 * v416 * (0.6366197723675814 * v427 + v453 + v409 * (v277 / v416 - v416 * v412))
        return (v415, v460 / v415)
    v273 = xp.minimum(v12 * ((v209 * v210) ** (v262 / v258) + v268) ** (-1.0 / v262), xp.inf)
    return newton(xp, f271, v1, v273, xp.inf, 0.5, 4.0)


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
