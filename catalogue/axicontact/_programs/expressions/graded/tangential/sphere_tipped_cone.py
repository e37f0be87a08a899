"""Formulas of axicontact.graded.tangential.sphere_tipped_cone over an array library `xp`."""

from ....._programs.expressions._runtime.functions import sine_root
from ....._programs.expressions._runtime.graded.breaks import tipped_depth
from ....._programs.expressions._runtime.graded.breaks import tipped_force
from ....._programs.expressions._runtime.graded.breaks import tipped_rate
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.pressure import tipped_pressure
from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.graded.rules import sinh_over
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.sphere_tipped_cone import depth_at as graded_normal_depth_at
from ....._programs.expressions.graded.normal.sphere_tipped_cone import force_at as graded_normal_force_at
from ....._programs.expressions.graded.normal.sphere_tipped_cone import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.sphere_tipped_cone import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along
from ....._runtime.steps import weighted_along


def tangential_force(xp, a, c, R, theta, H, k, mu):
    v30, v31 = nodes_along(xp, 1, a, c, R, theta, H, k, mu)
    v2 = 1.0 + k
    v5 = difference_root(xp, c, 0.0)
    v8 = 0.25 * difference_root(xp, a, 0.0)
    v12 = R * xp.sin(theta)
    v13 = c <= v12
    v14 = xp.where(v13, c, 0.5 * v12)
    v15 = difference_root(xp, v14, 0.0)
    v16 = v15 > 0.0
    v21 = v16 & (v15 >= v8) & (v14 < v12) & v16
    v23 = xp.minimum(a, xp.maximum(v12, v14))
    v25 = difference_root(xp, R, 0.0)
    v29 = xp.where(v21, span(xp, v14, v23, v15 * (difference_root(xp, R, v23) / v25)), 0.0)
    v36 = v15 / difference_root(xp, R, v14) * xp.exp(v30 * v29)
    v39 = xp.sqrt(1.0 + v36 * v36)
    v41 = v25 * (v36 / v39)
    v44 = xp.sqrt(0.0 + v41 * v41)
    v54 = sphere_rate(xp, v44, v25 / v39, k) * (v44 * v44 ** k) * (v41 / v39) * (v41 / v44 / v39)
    v57 = 0.0 * a
    v58 = v57 - v12
    v59 = v58 < 0.0
    v63 = xp.maximum(a - v12, 0.0) * (a + v12)
    v64 = v63 > 0.0
    v67 = xp.where(v64, xp.sqrt(xp.where(v64, v63, 1.0)), 0.0)
    v68 = xp.where(v59, 1.0, v58)
    v70 = xp.where(v59, v67, difference_root(xp, a, v57))
    v71 = v70 > 0.0
    v72 = xp.where(v71, v70, 1.0)
    v73 = v58 == 0.0
    v80 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v83 = v57 + v12
    v85 = xp.sqrt(xp.absolute(v58) * v83)
    v86 = xp.where(v73, xp.minimum(v12, v72) * v80, v85)
    v88 = xp.arcsinh(v72 / v86)
    v92 = xp.minimum(v88, 3.0 * xp.minimum(1.0, xp.inf / v86))
    v93 = v30 * 1.0
    v96 = v92 * (v93 * v93 ** 2.0)
    v98 = v86 * xp.sinh(v96)
    v99 = xp.hypot(v12, v98)
    v106 = tipped_rate(xp, v99, v98, R, v12, R * xp.cos(theta), k) * v99 ** 2.0 * v98 / v99
    v116 = v92 < v88
    v120 = xp.where(v116, 2.0 * v88, v92)
    v121 = xp.where(v116, v86 * xp.sinh(xp.where(v116, v92, 0.5 * v88)), v72)
    v122 = v72 > v121
    v123 = xp.where(v122, v72, 2.0 * v121)
    v127 = xp.where(v73, xp.minimum(v12, v123) * v80, v85)
    v129 = xp.arcsinh(v123 / v127)
    v133 = xp.minimum(v129, 3.0 * xp.minimum(1.0, xp.inf / v127))
    v134 = v133 < v129
    v138 = xp.where(v134, 2.0 * v129, v133)
    v139 = xp.where(v134, v127 * xp.sinh(xp.where(v134, v133, 0.5 * v129)), v123)
    v140 = v123 > v139
    v141 = xp.where(v140, v123, 2.0 * v139)
    v144 = xp.where(v73, xp.minimum(v12, v141) * v80, v85)
    v146 = xp.arcsinh(v141 / v144)
    v150 = xp.minimum(v146, 3.0 * xp.minimum(1.0, xp.inf / v144))
    v151 = v150 < v146
    v155 = xp.where(v151, 2.0 * v146, v150)
    v157 = xp.where(v140, 0.5 * v139, v123)
    v156 = xp.where(v151, v144 * xp.sinh(xp.where(v151, v150, 0.5 * v146)), v141)
    v162 = xp.where(v122, 0.5 * v121, v72)
    v163 = xp.where(v122, xp.log(xp.sqrt(v123) / xp.sqrt(xp.where(v140, v156, 1.0))), 0.0)
    v166 = v121 * xp.exp(v30 * v163)
    v167 = xp.hypot(v12, v166)
    v175 = xp.hypot(v86, v166)
    v174 = tipped_rate(xp, v167, v166, R, v12, R * xp.cos(theta), k) * v167 ** 2.0 * v166 / v167
    v184 = v72 * xp.exp(-(v30 * v163))
    v185 = xp.hypot(v12, v184)
    v193 = xp.hypot(v86, v184)
    v192 = tipped_rate(xp, v185, v184, R, v12, R * xp.cos(theta), k) * v185 ** 2.0 * v184 / v185
    v198 = v163 * xp.sum(v31 * (v192 * v193 ** k * (v184 / v193)), axis=0)
    v115 = v92 * (1.0 * xp.sum(v31 * (v106 * (v86 * xp.cosh(v96)) ** k * 3.0 * v93 * v93), axis=0))
    v201 = xp.where(v59, 1.0, v58)
    v202 = v201 == 0.0
    v203 = v201 < 0.0
    v204 = xp.where(v203, 1.0, v201)
    v206 = xp.where(v203, v67, difference_root(xp, a, v57))
    v211 = xp.sqrt(xp.absolute(v201) * v83)
    v212 = xp.where(v202, xp.minimum(v12, v206) * v80, v211)
    v215 = xp.arcsinh(v206 / v212)
    v216 = xp.minimum(v215, 3.0)
    v218, v219 = weighted_along(xp, v2, a, c, R, theta, H, k, mu)
    v220 = v218 * v216
    v222 = v212 * xp.cosh(v220)
    v223 = xp.hypot(v12, v222)
    v230 = tipped_rate(xp, v223, v222, R, v12, R * xp.cos(theta), k) * v223 ** 2.0 * v222 / v223
    v235 = raised(xp, v216, k) * xp.sum(v219 * (v230 * sinh_over(xp, v220) ** k), axis=0)
    v237 = v216 < v215
    v241 = xp.where(v237, 2.0 * v215, v216)
    v242 = xp.where(v237, v212 * xp.sinh(xp.where(v237, v216, 0.5 * v215)), v206)
    v243 = v206 > v242
    v244 = xp.where(v243, v206, 2.0 * v242)
    v248 = xp.where(v202, xp.minimum(v12, v244) * v80, v211)
    v250 = xp.arcsinh(v244 / v248)
    v251 = xp.minimum(v250, 3.0)
    v252 = v251 < v250
    v256 = xp.where(v252, 2.0 * v250, v251)
    v257 = xp.where(v252, v248 * xp.sinh(xp.where(v252, v251, 0.5 * v250)), v244)
    v258 = v244 > v257
    v259 = xp.where(v258, v244, 2.0 * v257)
    v262 = xp.where(v202, xp.minimum(v12, v259) * v80, v211)
    v264 = xp.arcsinh(v259 / v262)
    v265 = xp.minimum(v264, 3.0)
    v266 = v265 < v264
    v270 = xp.where(v266, 2.0 * v264, v265)
    v272 = xp.where(v258, 0.5 * v257, v244)
    v271 = xp.where(v266, v262 * xp.sinh(xp.where(v266, v265, 0.5 * v264)), v259)
    v277 = xp.where(v243, 0.5 * v242, v206)
    v278 = xp.where(v243, xp.log(xp.sqrt(v244) / xp.sqrt(xp.where(v258, v271, 1.0))), 0.0)
    v281 = v242 * xp.exp(v30 * v278)
    v283 = xp.hypot(v212, v281)
    v284 = xp.hypot(v12, v283)
    v291 = tipped_rate(xp, v284, v283, R, v12, R * xp.cos(theta), k) * v284 ** 2.0 * v283 / v284
    v299 = v206 * xp.exp(-(v30 * v278))
    v301 = xp.hypot(v212, v299)
    v302 = xp.hypot(v12, v301)
    v309 = tipped_rate(xp, v302, v301, R, v12, R * xp.cos(theta), k) * v302 ** 2.0 * v301 / v302
    v313 = v278 * xp.sum(v31 * (v299 ** k * v309 * (v299 / v301)), axis=0)
    v314 = v278 * xp.sum(v31 * (v281 ** k * v291 * (v281 / v283)), axis=0) + v313
    v200 = v115 + (v163 * xp.sum(v31 * (v174 * v175 ** k * (v166 / v175)), axis=0) + v198)
    v317 = xp.where(v71, xp.where(v59, v200, v212 ** k * v235 + v314), 0.0)
    v319 = xp.where(v13, 2.0 * v12, c)
    v320 = difference_root(xp, v319, 0.0)
    v326 = xp.maximum(0.0, v12)
    v327 = difference_root(xp, v319, v326)
    v329 = (v320 > 0.0) & (v320 >= v8) & (v319 > v12) & (v327 > 0.0)
    v331 = xp.where(v329, span(xp, v319, a, v327), 0.0)
    v337 = v327 * xp.exp(v30 * v331)
    v338 = v337 * v337
    v340 = xp.sqrt((v326 - 0.0) * (v326 + 0.0) + v338)
    v345 = xp.sqrt((v326 - v12) * (v326 + v12) + v338)
    v352 = tipped_rate(xp, v340, v345, R, v12, R * xp.cos(theta), k) * (v340 * v340 ** k) * v337
    v356 = xp.where(v329, v331 * xp.sum(v31 * (v352 * (v337 / v340)), axis=0), 0.0)
    v360 = R * xp.cos(theta)
    v363 = tipped_force(xp, c, difference_root(xp, c, v12), R, v12, v360, k)
    v364 = tipped_force(xp, a, difference_root(xp, a, v12), R, v12, v360, k) - v363
    v357 = xp.where(v13, xp.where(v21, v29 * xp.sum(v31 * v54, axis=0), 0.0) + v317, v356)
    return mu * (2.0 * H / v2) * xp.where((v5 > 0.0) & (v5 >= v8), v357, v364)


def traction(xp, r, a, c, R, theta, H, k, mu):
    v33, v34 = nodes_along(xp, 1, r, a, c, R, theta, H, k, mu)
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v4 = xp.minimum(v2, c)
    v5 = difference_root(xp, c, v4)
    v12 = R * xp.sin(theta)
    v13 = c <= v12
    v14 = xp.where(v13, c, 0.5 * v12)
    v15 = xp.minimum(v2, v14)
    v16 = difference_root(xp, v14, v15)
    v17 = v16 > 0.0
    v18 = difference_root(xp, a, v15)
    v24 = v17 & (v16 >= 0.25 * v18) & (v14 < v12) & v17
    v26 = xp.minimum(a, xp.maximum(v12, v14))
    v28 = difference_root(xp, R, v15)
    v32 = xp.where(v24, span(xp, v14, v26, v16 * (difference_root(xp, R, v26) / v28)), 0.0)
    v40 = v16 / difference_root(xp, R, v14) * xp.exp(v33 * v32)
    v43 = xp.sqrt(1.0 + v40 * v40)
    v45 = v28 * (v40 / v43)
    v48 = xp.sqrt(v15 * v15 + v45 * v45)
    v58 = sphere_rate(xp, v48, v28 / v43, k) * (v45 ** k / v45) * (v45 / v43) * (v45 / v48 / v43)
    v61 = v15 - v12
    v62 = v61 < 0.0
    v66 = xp.maximum(a - v12, 0.0) * (a + v12)
    v67 = v66 > 0.0
    v70 = xp.where(v67, xp.sqrt(xp.where(v67, v66, 1.0)), 0.0)
    v71 = xp.where(v62, 1.0, v61)
    v72 = xp.where(v62, v70, v18)
    v73 = v72 > 0.0
    v74 = xp.where(v73, v72, 1.0)
    v75 = v61 == 0.0
    v82 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v85 = v15 + v12
    v87 = xp.sqrt(xp.absolute(v61) * v85)
    v88 = xp.where(v75, xp.minimum(v12, v74) * v82, v87)
    v90 = xp.arcsinh(v74 / v88)
    v94 = xp.minimum(v90, 3.0 * xp.minimum(1.0, xp.inf / v88))
    v95 = v33 * 1.0
    v98 = v94 * (v95 * v95 ** 2.0)
    v100 = v88 * xp.sinh(v98)
    v101 = xp.hypot(v12, v100)
    v108 = tipped_rate(xp, v101, v100, R, v12, R * xp.cos(theta), k) * v101 ** 0.0 * v100 / v101
    v118 = v94 < v90
    v122 = xp.where(v118, 2.0 * v90, v94)
    v123 = xp.where(v118, v88 * xp.sinh(xp.where(v118, v94, 0.5 * v90)), v74)
    v124 = v74 > v123
    v125 = xp.where(v124, v74, 2.0 * v123)
    v129 = xp.where(v75, xp.minimum(v12, v125) * v82, v87)
    v131 = xp.arcsinh(v125 / v129)
    v135 = xp.minimum(v131, 3.0 * xp.minimum(1.0, xp.inf / v129))
    v136 = v135 < v131
    v140 = xp.where(v136, 2.0 * v131, v135)
    v141 = xp.where(v136, v129 * xp.sinh(xp.where(v136, v135, 0.5 * v131)), v125)
    v142 = v125 > v141
    v143 = xp.where(v142, v125, 2.0 * v141)
    v146 = xp.where(v75, xp.minimum(v12, v143) * v82, v87)
    v148 = xp.arcsinh(v143 / v146)
    v152 = xp.minimum(v148, 3.0 * xp.minimum(1.0, xp.inf / v146))
    v153 = v152 < v148
    v157 = xp.where(v153, 2.0 * v148, v152)
    v159 = xp.where(v142, 0.5 * v141, v125)
    v158 = xp.where(v153, v146 * xp.sinh(xp.where(v153, v152, 0.5 * v148)), v143)
    v164 = xp.where(v124, 0.5 * v123, v74)
    v165 = xp.where(v124, xp.log(xp.sqrt(v125) / xp.sqrt(xp.where(v142, v158, 1.0))), 0.0)
    v168 = v123 * xp.exp(v33 * v165)
    v169 = xp.hypot(v12, v168)
    v177 = xp.hypot(v88, v168)
    v176 = tipped_rate(xp, v169, v168, R, v12, R * xp.cos(theta), k) * v169 ** 0.0 * v168 / v169
    v186 = v74 * xp.exp(-(v33 * v165))
    v187 = xp.hypot(v12, v186)
    v195 = xp.hypot(v88, v186)
    v194 = tipped_rate(xp, v187, v186, R, v12, R * xp.cos(theta), k) * v187 ** 0.0 * v186 / v187
    v200 = v165 * xp.sum(v34 * (v194 * v195 ** k * (v186 / v195)), axis=0)
    v117 = v94 * (1.0 * xp.sum(v34 * (v108 * (v88 * xp.cosh(v98)) ** k * 3.0 * v95 * v95), axis=0))
    v203 = xp.where(v62, 1.0, v61)
    v204 = v203 == 0.0
    v205 = v203 < 0.0
    v206 = xp.where(v205, 1.0, v203)
    v207 = xp.where(v205, v70, v18)
    v212 = xp.sqrt(xp.absolute(v203) * v85)
    v213 = xp.where(v204, xp.minimum(v12, v207) * v82, v212)
    v216 = xp.arcsinh(v207 / v213)
    v217 = xp.minimum(v216, 3.0)
    v220, v221 = weighted_along(xp, 1.0 + k, r, a, c, R, theta, H, k, mu)
    v222 = v220 * v217
    v224 = v213 * xp.cosh(v222)
    v225 = xp.hypot(v12, v224)
    v232 = tipped_rate(xp, v225, v224, R, v12, R * xp.cos(theta), k) * v225 ** 0.0 * v224 / v225
    v237 = raised(xp, v217, k) * xp.sum(v221 * (v232 * sinh_over(xp, v222) ** k), axis=0)
    v239 = v217 < v216
    v243 = xp.where(v239, 2.0 * v216, v217)
    v244 = xp.where(v239, v213 * xp.sinh(xp.where(v239, v217, 0.5 * v216)), v207)
    v245 = v207 > v244
    v246 = xp.where(v245, v207, 2.0 * v244)
    v250 = xp.where(v204, xp.minimum(v12, v246) * v82, v212)
    v252 = xp.arcsinh(v246 / v250)
    v253 = xp.minimum(v252, 3.0)
    v254 = v253 < v252
    v258 = xp.where(v254, 2.0 * v252, v253)
    v259 = xp.where(v254, v250 * xp.sinh(xp.where(v254, v253, 0.5 * v252)), v246)
    v260 = v246 > v259
    v261 = xp.where(v260, v246, 2.0 * v259)
    v264 = xp.where(v204, xp.minimum(v12, v261) * v82, v212)
    v266 = xp.arcsinh(v261 / v264)
    v267 = xp.minimum(v266, 3.0)
    v268 = v267 < v266
    v272 = xp.where(v268, 2.0 * v266, v267)
    v274 = xp.where(v260, 0.5 * v259, v246)
    v273 = xp.where(v268, v264 * xp.sinh(xp.where(v268, v267, 0.5 * v266)), v261)
    v279 = xp.where(v245, 0.5 * v244, v207)
    v280 = xp.where(v245, xp.log(xp.sqrt(v246) / xp.sqrt(xp.where(v260, v273, 1.0))), 0.0)
    v283 = v244 * xp.exp(v33 * v280)
    v285 = xp.hypot(v213, v283)
    v286 = xp.hypot(v12, v285)
    v293 = tipped_rate(xp, v286, v285, R, v12, R * xp.cos(theta), k) * v286 ** 0.0 * v285 / v286
    v301 = v207 * xp.exp(-(v33 * v280))
    v303 = xp.hypot(v213, v301)
    v304 = xp.hypot(v12, v303)
    v311 = tipped_rate(xp, v304, v303, R, v12, R * xp.cos(theta), k) * v304 ** 0.0 * v303 / v304
    v315 = v280 * xp.sum(v34 * (v301 ** k * v311 * (v301 / v303)), axis=0)
    v316 = v280 * xp.sum(v34 * (v283 ** k * v293 * (v283 / v285)), axis=0) + v315
    v202 = v117 + (v165 * xp.sum(v34 * (v176 * v177 ** k * (v168 / v177)), axis=0) + v200)
    v319 = xp.where(v73, xp.where(v62, v202, v213 ** k * v237 + v316), 0.0)
    v321 = xp.where(v13, 2.0 * v12, c)
    v322 = xp.minimum(v2, v321)
    v323 = difference_root(xp, v321, v322)
    v331 = xp.maximum(v322, v12)
    v332 = difference_root(xp, v321, v331)
    v334 = (v323 > 0.0) & (v323 >= 0.25 * difference_root(xp, a, v322)) & (v321 > v12) & (v332 > 0.0)
    v336 = xp.where(v334, span(xp, v321, a, v332), 0.0)
    v342 = v332 * xp.exp(v33 * v336)
    v343 = v342 * v342
    v345 = xp.sqrt((v331 - 0.0) * (v331 + 0.0) + v343)
    v350 = xp.sqrt((v331 - v12) * (v331 + v12) + v343)
    v358 = xp.sqrt((v331 - v322) * (v331 + v322) + v343)
    v362 = tipped_rate(xp, v345, v350, R, v12, R * xp.cos(theta), k) * (v358 ** k / v358) * v342
    v366 = xp.where(v334, v336 * xp.sum(v34 * (v362 * (v342 / v345)), axis=0), 0.0)
    v369 = R * xp.cos(theta)
    v367 = xp.where(v13, xp.where(v24, v32 * xp.sum(v34 * v58, axis=0), 0.0) + v319, v366)
    v372 = tipped_pressure(xp, v4, a, R, v12, v369, k) - tipped_pressure(xp, v4, c, R, v12, v369, k)
    v373 = xp.where((v5 > 0.0) & (v5 >= 0.25 * difference_root(xp, a, v4)), v367, v372)
    v376 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, R, theta, H, k)
    return mu * xp.where(v1, H / 3.141592653589793 * v373, v376)


def tangential_displacement(xp, a, c, R, theta, H, H_x, k, mu):
    v28, v29 = nodes_along(xp, 1, a, c, R, theta, H, H_x, k, mu)
    v3 = difference_root(xp, c, 0.0)
    v6 = 0.25 * difference_root(xp, a, 0.0)
    v10 = R * xp.sin(theta)
    v11 = c <= v10
    v12 = xp.where(v11, c, 0.5 * v10)
    v13 = difference_root(xp, v12, 0.0)
    v14 = v13 > 0.0
    v19 = v14 & (v13 >= v6) & (v12 < v10) & v14
    v21 = xp.minimum(a, xp.maximum(v10, v12))
    v23 = difference_root(xp, R, 0.0)
    v27 = xp.where(v19, span(xp, v12, v21, v13 * (difference_root(xp, R, v21) / v23)), 0.0)
    v34 = v13 / difference_root(xp, R, v12) * xp.exp(v28 * v27)
    v37 = xp.sqrt(1.0 + v34 * v34)
    v39 = v23 * (v34 / v37)
    v42 = xp.sqrt(0.0 + v39 * v39)
    v49 = sphere_rate(xp, v42, v23 / v37, k) * (v39 / v37) * (v39 / v42 / v37)
    v52 = 0.0 * a
    v53 = v52 - v10
    v54 = v53 < 0.0
    v58 = xp.maximum(a - v10, 0.0) * (a + v10)
    v59 = v58 > 0.0
    v62 = xp.where(v59, xp.sqrt(xp.where(v59, v58, 1.0)), 0.0)
    v63 = xp.where(v54, 1.0, v53)
    v65 = xp.where(v54, v62, difference_root(xp, a, v52))
    v66 = v65 > 0.0
    v67 = xp.where(v66, v65, 1.0)
    v68 = v53 == 0.0
    v75 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v78 = v52 + v10
    v80 = xp.sqrt(xp.absolute(v53) * v78)
    v81 = xp.where(v68, xp.minimum(v10, v67) * v75, v80)
    v83 = xp.arcsinh(v67 / v81)
    v87 = xp.minimum(v83, 3.0 * xp.minimum(1.0, xp.inf / v81))
    v88 = v28 * 1.0
    v91 = v87 * (v88 * v88 ** 2.0)
    v93 = v81 * xp.sinh(v91)
    v94 = xp.hypot(v10, v93)
    v102 = tipped_rate(xp, v94, v93, R, v10, R * xp.cos(theta), k) * v94 ** (1.0 - k) * v93 / v94
    v112 = v87 < v83
    v116 = xp.where(v112, 2.0 * v83, v87)
    v117 = xp.where(v112, v81 * xp.sinh(xp.where(v112, v87, 0.5 * v83)), v67)
    v118 = v67 > v117
    v119 = xp.where(v118, v67, 2.0 * v117)
    v123 = xp.where(v68, xp.minimum(v10, v119) * v75, v80)
    v125 = xp.arcsinh(v119 / v123)
    v129 = xp.minimum(v125, 3.0 * xp.minimum(1.0, xp.inf / v123))
    v130 = v129 < v125
    v134 = xp.where(v130, 2.0 * v125, v129)
    v135 = xp.where(v130, v123 * xp.sinh(xp.where(v130, v129, 0.5 * v125)), v119)
    v136 = v119 > v135
    v137 = xp.where(v136, v119, 2.0 * v135)
    v140 = xp.where(v68, xp.minimum(v10, v137) * v75, v80)
    v142 = xp.arcsinh(v137 / v140)
    v146 = xp.minimum(v142, 3.0 * xp.minimum(1.0, xp.inf / v140))
    v147 = v146 < v142
    v151 = xp.where(v147, 2.0 * v142, v146)
    v153 = xp.where(v136, 0.5 * v135, v119)
    v152 = xp.where(v147, v140 * xp.sinh(xp.where(v147, v146, 0.5 * v142)), v137)
    v158 = xp.where(v118, 0.5 * v117, v67)
    v159 = xp.where(v118, xp.log(xp.sqrt(v119) / xp.sqrt(xp.where(v136, v152, 1.0))), 0.0)
    v162 = v117 * xp.exp(v28 * v159)
    v163 = xp.hypot(v10, v162)
    v170 = tipped_rate(xp, v163, v162, R, v10, R * xp.cos(theta), k) * v163 ** (1.0 - k) * v162
    v172 = xp.hypot(v81, v162)
    v181 = v67 * xp.exp(-(v28 * v159))
    v182 = xp.hypot(v10, v181)
    v189 = tipped_rate(xp, v182, v181, R, v10, R * xp.cos(theta), k) * v182 ** (1.0 - k) * v181
    v191 = xp.hypot(v81, v181)
    v196 = v159 * xp.sum(v29 * (v189 / v182 * v191 ** k * (v181 / v191)), axis=0)
    v111 = v87 * (1.0 * xp.sum(v29 * (v102 * (v81 * xp.cosh(v91)) ** k * 3.0 * v88 * v88), axis=0))
    v199 = xp.where(v54, 1.0, v53)
    v200 = v199 == 0.0
    v201 = v199 < 0.0
    v202 = xp.where(v201, 1.0, v199)
    v204 = xp.where(v201, v62, difference_root(xp, a, v52))
    v209 = xp.sqrt(xp.absolute(v199) * v78)
    v210 = xp.where(v200, xp.minimum(v10, v204) * v75, v209)
    v213 = xp.arcsinh(v204 / v210)
    v214 = xp.minimum(v213, 3.0)
    v217, v218 = weighted_along(xp, 1.0 + k, a, c, R, theta, H, H_x, k, mu)
    v219 = v217 * v214
    v221 = v210 * xp.cosh(v219)
    v222 = xp.hypot(v10, v221)
    v229 = tipped_rate(xp, v222, v221, R, v10, R * xp.cos(theta), k) * v222 ** (1.0 - k) * v221
    v235 = raised(xp, v214, k) * xp.sum(v218 * (v229 / v222 * sinh_over(xp, v219) ** k), axis=0)
    v237 = v214 < v213
    v241 = xp.where(v237, 2.0 * v213, v214)
    v242 = xp.where(v237, v210 * xp.sinh(xp.where(v237, v214, 0.5 * v213)), v204)
    v243 = v204 > v242
    v244 = xp.where(v243, v204, 2.0 * v242)
    v248 = xp.where(v200, xp.minimum(v10, v244) * v75, v209)
    v250 = xp.arcsinh(v244 / v248)
    v251 = xp.minimum(v250, 3.0)
    v252 = v251 < v250
    v256 = xp.where(v252, 2.0 * v250, v251)
    v257 = xp.where(v252, v248 * xp.sinh(xp.where(v252, v251, 0.5 * v250)), v244)
    v258 = v244 > v257
    v259 = xp.where(v258, v244, 2.0 * v257)
    v262 = xp.where(v200, xp.minimum(v10, v259) * v75, v209)
    v264 = xp.arcsinh(v259 / v262)
    v265 = xp.minimum(v264, 3.0)
    v266 = v265 < v264
    v270 = xp.where(v266, 2.0 * v264, v265)
    v272 = xp.where(v258, 0.5 * v257, v244)
    v271 = xp.where(v266, v262 * xp.sinh(xp.where(v266, v265, 0.5 * v264)), v259)
    v277 = xp.where(v243, 0.5 * v242, v204)
    v278 = xp.where(v243, xp.log(xp.sqrt(v244) / xp.sqrt(xp.where(v258, v271, 1.0))), 0.0)
    v281 = v242 * xp.exp(v28 * v278)
    v283 = xp.hypot(v210, v281)
    v284 = xp.hypot(v10, v283)
    v291 = tipped_rate(xp, v284, v283, R, v10, R * xp.cos(theta), k) * v284 ** (1.0 - k) * v283
    v300 = v204 * xp.exp(-(v28 * v278))
    v302 = xp.hypot(v210, v300)
    v303 = xp.hypot(v10, v302)
    v310 = tipped_rate(xp, v303, v302, R, v10, R * xp.cos(theta), k) * v303 ** (1.0 - k) * v302
    v315 = v278 * xp.sum(v29 * (v300 ** k * (v310 / v303) * (v300 / v302)), axis=0)
    v316 = v278 * xp.sum(v29 * (v281 ** k * (v291 / v284) * (v281 / v283)), axis=0) + v315
    v198 = v111 + (v159 * xp.sum(v29 * (v170 / v163 * v172 ** k * (v162 / v172)), axis=0) + v196)
    v319 = xp.where(v66, xp.where(v54, v198, v210 ** k * v235 + v316), 0.0)
    v321 = xp.where(v11, 2.0 * v10, c)
    v322 = difference_root(xp, v321, 0.0)
    v328 = xp.maximum(0.0, v10)
    v329 = difference_root(xp, v321, v328)
    v331 = (v322 > 0.0) & (v322 >= v6) & (v321 > v10) & (v329 > 0.0)
    v333 = xp.where(v331, span(xp, v321, a, v329), 0.0)
    v339 = v329 * xp.exp(v28 * v333)
    v340 = v339 * v339
    v342 = xp.sqrt((v328 - 0.0) * (v328 + 0.0) + v340)
    v347 = xp.sqrt((v328 - v10) * (v328 + v10) + v340)
    v353 = tipped_rate(xp, v342, v347, R, v10, R * xp.cos(theta), k) * v339 * (v339 / v342)
    v320 = xp.where(v19, v27 * xp.sum(v29 * v49, axis=0), 0.0) + v319
    v359 = R * xp.cos(theta)
    v362 = tipped_depth(xp, c, difference_root(xp, c, v10), R, v10, v359, k)
    v363 = tipped_depth(xp, a, difference_root(xp, a, v10), R, v10, v359, k) - v362
    v356 = xp.where(v11, v320, xp.where(v331, v333 * xp.sum(v29 * v353, axis=0), 0.0))
    return mu * (H / H_x) * xp.where((v3 > 0.0) & (v3 >= v6), v356, v363)


def stick_radius(xp, F_x, a, R, theta, H, k, mu):
    v5 = graded_normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, H, k)
    v7 = graded_normal_radius_from_force(xp, stick_force(xp, v5, F_x, mu), R, theta, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v7)


def full_slip_displacement(xp, a, R, theta, H, H_x, k, mu):
    v5 = mu * (H / H_x) * graded_normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta, k)
    return v5
