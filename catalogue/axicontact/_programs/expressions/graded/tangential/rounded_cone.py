"""Formulas of axicontact.graded.tangential.rounded_cone over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import rounded_depth
from ....._programs.expressions._runtime.graded.breaks import rounded_force
from ....._programs.expressions._runtime.graded.breaks import rounded_rate
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.pressure import rounded_pressure
from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.graded.rules import sinh_over
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.graded.slip import span
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.rounded_cone import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.rounded_cone import force_at as graded_normal_force_at
from ....._programs.expressions.graded.normal.rounded_cone import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.rounded_cone import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along
from ....._runtime.steps import weighted_along


def tangential_force(xp, a, c, theta, b, H, k, mu):
    v58, v59 = nodes_along(xp, 1, a, c, theta, b, H, k, mu)
    v2 = 1.0 + k
    v6 = rounded_force(xp, c, difference_root(xp, c, b), b, k)
    v8 = rounded_force(xp, a, difference_root(xp, a, b), b, k)
    v9 = 0.25 * v8
    v10 = v6 >= v9
    v11 = xp.where(v10, v6, 2.0 * v9)
    v12 = c <= b
    v13 = xp.where(v12, c, 0.5 * b)
    v15 = xp.minimum(a, xp.maximum(b, v13))
    v22 = 0.0 * a
    v23 = v22 - b
    v24 = v23 < 0.0
    v28 = xp.maximum(a - b, 0.0) * (a + b)
    v29 = v28 > 0.0
    v32 = xp.where(v29, xp.sqrt(xp.where(v29, v28, 1.0)), 0.0)
    v33 = xp.where(v24, 1.0, v23)
    v35 = xp.where(v24, v32, difference_root(xp, a, v22))
    v36 = v35 > 0.0
    v37 = xp.where(v36, v35, 1.0)
    v38 = v23 == 0.0
    v45 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v48 = v22 + b
    v50 = xp.sqrt(xp.absolute(v23) * v48)
    v51 = xp.where(v38, xp.minimum(b, v37) * v45, v50)
    v57 = xp.minimum(xp.arcsinh(v37 / v51), 3.0 * xp.minimum(1.0, xp.inf / v51))
    v60 = v58 * 1.0
    v63 = v57 * (v60 * v60 ** 2.0)
    v65 = v51 * xp.sinh(v63)
    v66 = xp.hypot(b, v65)
    v75 = rounded_rate(xp, v66, v65, b, k) * v66 ** 2.0 * v65 / v66 * (v51 * xp.cosh(v63)) ** k
    v82 = v51 * xp.sinh(v57)
    v83 = v37 > v82
    v84 = xp.where(v83, v37, 2.0 * v82)
    v88 = xp.where(v38, xp.minimum(b, v84) * v45, v50)
    v96 = v88 * xp.sinh(xp.minimum(xp.arcsinh(v84 / v88), 3.0 * xp.minimum(1.0, xp.inf / v88)))
    v97 = v84 > v96
    v98 = xp.where(v97, v84, 2.0 * v96)
    v101 = xp.where(v38, xp.minimum(b, v98) * v45, v50)
    v108 = xp.sinh(xp.minimum(xp.arcsinh(v98 / v101), 3.0 * xp.minimum(1.0, xp.inf / v101)))
    v110 = xp.where(v97, 0.5 * v96, v84)
    v115 = xp.where(v83, 0.5 * v82, v37)
    v116 = xp.where(v83, xp.log(xp.sqrt(v84) / xp.sqrt(xp.where(v97, v101 * v108, 1.0))), 0.0)
    v119 = v82 * xp.exp(v58 * v116)
    v120 = xp.hypot(b, v119)
    v126 = xp.hypot(v51, v119)
    v128 = rounded_rate(xp, v120, v119, b, k) * v120 ** 2.0 * v119 / v120 * v126 ** k
    v135 = v37 * xp.exp(-(v58 * v116))
    v136 = xp.hypot(b, v135)
    v142 = xp.hypot(v51, v135)
    v144 = rounded_rate(xp, v136, v135, b, k) * v136 ** 2.0 * v135 / v136 * v142 ** k
    v147 = v116 * xp.sum(v59 * (v144 * (v135 / v142)), axis=0)
    v80 = v57 * (1.0 * xp.sum(v59 * (v75 * 3.0 * v60 * v60), axis=0))
    v150 = xp.where(v24, 1.0, v23)
    v151 = v150 == 0.0
    v152 = v150 < 0.0
    v153 = xp.where(v152, 1.0, v150)
    v155 = xp.where(v152, v32, difference_root(xp, a, v22))
    v160 = xp.sqrt(xp.absolute(v150) * v48)
    v161 = xp.where(v151, xp.minimum(b, v155) * v45, v160)
    v165 = xp.minimum(xp.arcsinh(v155 / v161), 3.0)
    v167, v168 = weighted_along(xp, v2, a, c, theta, b, H, k, mu)
    v169 = v167 * v165
    v171 = v161 * xp.cosh(v169)
    v172 = xp.hypot(b, v171)
    v177 = rounded_rate(xp, v172, v171, b, k) * v172 ** 2.0 * v171 / v172
    v182 = raised(xp, v165, k) * xp.sum(v168 * (v177 * sinh_over(xp, v169) ** k), axis=0)
    v185 = v161 * xp.sinh(v165)
    v186 = v155 > v185
    v187 = xp.where(v186, v155, 2.0 * v185)
    v191 = xp.where(v151, xp.minimum(b, v187) * v45, v160)
    v196 = v191 * xp.sinh(xp.minimum(xp.arcsinh(v187 / v191), 3.0))
    v197 = v187 > v196
    v198 = xp.where(v197, v187, 2.0 * v196)
    v201 = xp.where(v151, xp.minimum(b, v198) * v45, v160)
    v207 = xp.where(v197, 0.5 * v196, v187)
    v209 = xp.sqrt(xp.where(v197, v201 * xp.sinh(xp.minimum(xp.arcsinh(v198 / v201), 3.0)), 1.0))
    v212 = xp.where(v186, 0.5 * v185, v155)
    v213 = xp.where(v186, xp.log(xp.sqrt(v187) / v209), 0.0)
    v216 = v185 * xp.exp(v58 * v213)
    v218 = xp.hypot(v161, v216)
    v219 = xp.hypot(b, v218)
    v225 = v216 ** k * (rounded_rate(xp, v219, v218, b, k) * v219 ** 2.0 * v218 / v219)
    v232 = v155 * xp.exp(-(v58 * v213))
    v234 = xp.hypot(v161, v232)
    v235 = xp.hypot(b, v234)
    v241 = v232 ** k * (rounded_rate(xp, v235, v234, b, k) * v235 ** 2.0 * v234 / v235)
    v244 = v213 * xp.sum(v59 * (v241 * (v232 / v234)), axis=0)
    v246 = v161 ** k * v182 + (v213 * xp.sum(v59 * (v225 * (v216 / v218)), axis=0) + v244)
    v247 = xp.where(v24, v80 + (v116 * xp.sum(v59 * (v128 * (v119 / v126)), axis=0) + v147), v246)
    v21 = power_force(xp, v15, 2.0, k) * gained_share(xp, v13, v15, 2.0 + v2) / (2.0 * b)
    v250 = xp.where(v12, 2.0 * b, c)
    v256 = xp.maximum(0.0, b)
    v257 = difference_root(xp, v250, v256)
    v255 = (rounded_force(xp, v250, difference_root(xp, v250, b), b, k) >= v9) & (v250 > b)
    v259 = v255 & (v257 > 0.0)
    v261 = xp.where(v259, span(xp, v250, a, v257), 0.0)
    v267 = v257 * xp.exp(v58 * v261)
    v268 = v267 * v267
    v270 = xp.sqrt((v256 - 0.0) * (v256 + 0.0) + v268)
    v276 = rounded_rate(xp, v270, xp.sqrt((v256 - b) * (v256 + b) + v268), b, k)
    v283 = v261 * xp.sum(v59 * (v276 * (v270 * v270 ** k) * v267 * (v267 / v270)), axis=0)
    v285 = xp.where(v12, v21 + xp.where(v36, v247, 0.0), xp.where(v259, v283, 0.0))
    v290 = xp.where(v10, v285, v8 - xp.where(v10, 0.5 * v9, v6)) * xp.tan(theta)
    return mu * (2.0 * H / v2) * v290


def traction(xp, r, a, c, theta, b, H, k, mu):
    v56, v57 = nodes_along(xp, 1, r, a, c, theta, b, H, k, mu)
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v4 = xp.minimum(v2, c)
    v5 = rounded_pressure(xp, v4, c, b, k)
    v6 = rounded_pressure(xp, v4, a, b, k)
    v7 = 0.25 * v6
    v8 = v5 >= v7
    v9 = xp.where(v8, v5, 2.0 * v7)
    v10 = c <= b
    v11 = xp.where(v10, c, 0.5 * b)
    v14 = xp.minimum(v2, v11)
    v17 = power_growth(xp, v14, v11, xp.minimum(a, xp.maximum(b, v11)), 2.0, k)
    v21 = v14 - b
    v22 = v21 < 0.0
    v26 = xp.maximum(a - b, 0.0) * (a + b)
    v27 = v26 > 0.0
    v30 = xp.where(v27, xp.sqrt(xp.where(v27, v26, 1.0)), 0.0)
    v31 = xp.where(v22, 1.0, v21)
    v33 = xp.where(v22, v30, difference_root(xp, a, v14))
    v34 = v33 > 0.0
    v35 = xp.where(v34, v33, 1.0)
    v36 = v21 == 0.0
    v43 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v46 = v14 + b
    v48 = xp.sqrt(xp.absolute(v21) * v46)
    v49 = xp.where(v36, xp.minimum(b, v35) * v43, v48)
    v55 = xp.minimum(xp.arcsinh(v35 / v49), 3.0 * xp.minimum(1.0, xp.inf / v49))
    v58 = v56 * 1.0
    v61 = v55 * (v58 * v58 ** 2.0)
    v63 = v49 * xp.sinh(v61)
    v64 = xp.hypot(b, v63)
    v73 = rounded_rate(xp, v64, v63, b, k) * v64 ** 0.0 * v63 / v64 * (v49 * xp.cosh(v61)) ** k
    v80 = v49 * xp.sinh(v55)
    v81 = v35 > v80
    v82 = xp.where(v81, v35, 2.0 * v80)
    v86 = xp.where(v36, xp.minimum(b, v82) * v43, v48)
    v94 = v86 * xp.sinh(xp.minimum(xp.arcsinh(v82 / v86), 3.0 * xp.minimum(1.0, xp.inf / v86)))
    v95 = v82 > v94
    v96 = xp.where(v95, v82, 2.0 * v94)
    v99 = xp.where(v36, xp.minimum(b, v96) * v43, v48)
    v106 = xp.sinh(xp.minimum(xp.arcsinh(v96 / v99), 3.0 * xp.minimum(1.0, xp.inf / v99)))
    v108 = xp.where(v95, 0.5 * v94, v82)
    v113 = xp.where(v81, 0.5 * v80, v35)
    v114 = xp.where(v81, xp.log(xp.sqrt(v82) / xp.sqrt(xp.where(v95, v99 * v106, 1.0))), 0.0)
    v117 = v80 * xp.exp(v56 * v114)
    v118 = xp.hypot(b, v117)
    v124 = xp.hypot(v49, v117)
    v126 = rounded_rate(xp, v118, v117, b, k) * v118 ** 0.0 * v117 / v118 * v124 ** k
    v133 = v35 * xp.exp(-(v56 * v114))
    v134 = xp.hypot(b, v133)
    v140 = xp.hypot(v49, v133)
    v142 = rounded_rate(xp, v134, v133, b, k) * v134 ** 0.0 * v133 / v134 * v140 ** k
    v145 = v114 * xp.sum(v57 * (v142 * (v133 / v140)), axis=0)
    v78 = v55 * (1.0 * xp.sum(v57 * (v73 * 3.0 * v58 * v58), axis=0))
    v148 = xp.where(v22, 1.0, v21)
    v149 = v148 == 0.0
    v150 = v148 < 0.0
    v151 = xp.where(v150, 1.0, v148)
    v153 = xp.where(v150, v30, difference_root(xp, a, v14))
    v158 = xp.sqrt(xp.absolute(v148) * v46)
    v159 = xp.where(v149, xp.minimum(b, v153) * v43, v158)
    v163 = xp.minimum(xp.arcsinh(v153 / v159), 3.0)
    v166, v167 = weighted_along(xp, 1.0 + k, r, a, c, theta, b, H, k, mu)
    v168 = v166 * v163
    v170 = v159 * xp.cosh(v168)
    v171 = xp.hypot(b, v170)
    v176 = rounded_rate(xp, v171, v170, b, k) * v171 ** 0.0 * v170 / v171
    v181 = raised(xp, v163, k) * xp.sum(v167 * (v176 * sinh_over(xp, v168) ** k), axis=0)
    v184 = v159 * xp.sinh(v163)
    v185 = v153 > v184
    v186 = xp.where(v185, v153, 2.0 * v184)
    v190 = xp.where(v149, xp.minimum(b, v186) * v43, v158)
    v195 = v190 * xp.sinh(xp.minimum(xp.arcsinh(v186 / v190), 3.0))
    v196 = v186 > v195
    v197 = xp.where(v196, v186, 2.0 * v195)
    v200 = xp.where(v149, xp.minimum(b, v197) * v43, v158)
    v206 = xp.where(v196, 0.5 * v195, v186)
    v208 = xp.sqrt(xp.where(v196, v200 * xp.sinh(xp.minimum(xp.arcsinh(v197 / v200), 3.0)), 1.0))
    v211 = xp.where(v185, 0.5 * v184, v153)
    v212 = xp.where(v185, xp.log(xp.sqrt(v186) / v208), 0.0)
    v215 = v184 * xp.exp(v56 * v212)
    v217 = xp.hypot(v159, v215)
    v218 = xp.hypot(b, v217)
    v224 = v215 ** k * (rounded_rate(xp, v218, v217, b, k) * v218 ** 0.0 * v217 / v218)
    v231 = v153 * xp.exp(-(v56 * v212))
    v233 = xp.hypot(v159, v231)
    v234 = xp.hypot(b, v233)
    v240 = v231 ** k * (rounded_rate(xp, v234, v233, b, k) * v234 ** 0.0 * v233 / v234)
    v243 = v212 * xp.sum(v57 * (v240 * (v231 / v233)), axis=0)
    v245 = v159 ** k * v181 + (v212 * xp.sum(v57 * (v224 * (v215 / v217)), axis=0) + v243)
    v246 = xp.where(v22, v78 + (v114 * xp.sum(v57 * (v126 * (v117 / v124)), axis=0) + v145), v245)
    v249 = xp.where(v10, 2.0 * b, c)
    v250 = xp.minimum(v2, v249)
    v254 = rounded_pressure(xp, v250, v249, b, k) >= 0.25 * rounded_pressure(xp, v250, a, b, k)
    v257 = xp.maximum(v250, b)
    v258 = difference_root(xp, v249, v257)
    v260 = v254 & (v249 > b) & (v258 > 0.0)
    v262 = xp.where(v260, span(xp, v249, a, v258), 0.0)
    v268 = v258 * xp.exp(v56 * v262)
    v269 = v268 * v268
    v271 = xp.sqrt((v257 - 0.0) * (v257 + 0.0) + v269)
    v282 = xp.sqrt((v257 - v250) * (v257 + v250) + v269)
    v277 = rounded_rate(xp, v271, xp.sqrt((v257 - b) * (v257 + b) + v269), b, k)
    v289 = v262 * xp.sum(v57 * (v277 * (v282 ** k / v282) * v268 * (v268 / v271)), axis=0)
    v248 = power_factor(xp, 2.0, k) * 2.0 * v17 / (2.0 * b) + xp.where(v34, v246, 0.0)
    v291 = xp.where(v10, v248, xp.where(v260, v289, 0.0))
    v296 = xp.where(v8, v291, v6 - xp.where(v8, 0.5 * v7, v5)) * xp.tan(theta)
    v299 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, theta, b, H, k)
    return mu * xp.where(v1, H / 3.141592653589793 * v296, v299)


def tangential_displacement(xp, a, c, theta, b, H, H_x, k, mu):
    v57, v58 = nodes_along(xp, 1, a, c, theta, b, H, H_x, k, mu)
    v4 = rounded_depth(xp, c, difference_root(xp, c, b), b, k)
    v6 = rounded_depth(xp, a, difference_root(xp, a, b), b, k)
    v7 = 0.25 * v6
    v8 = v4 >= v7
    v9 = xp.where(v8, v4, 2.0 * v7)
    v10 = c <= b
    v11 = xp.where(v10, c, 0.5 * b)
    v14 = xp.minimum(a, xp.maximum(b, v11))
    v21 = 0.0 * a
    v22 = v21 - b
    v23 = v22 < 0.0
    v27 = xp.maximum(a - b, 0.0) * (a + b)
    v28 = v27 > 0.0
    v31 = xp.where(v28, xp.sqrt(xp.where(v28, v27, 1.0)), 0.0)
    v32 = xp.where(v23, 1.0, v22)
    v34 = xp.where(v23, v31, difference_root(xp, a, v21))
    v35 = v34 > 0.0
    v36 = xp.where(v35, v34, 1.0)
    v37 = v22 == 0.0
    v44 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v47 = v21 + b
    v49 = xp.sqrt(xp.absolute(v22) * v47)
    v50 = xp.where(v37, xp.minimum(b, v36) * v44, v49)
    v56 = xp.minimum(xp.arcsinh(v36 / v50), 3.0 * xp.minimum(1.0, xp.inf / v50))
    v59 = v57 * 1.0
    v62 = v56 * (v59 * v59 ** 2.0)
    v64 = v50 * xp.sinh(v62)
    v65 = xp.hypot(b, v64)
    v71 = rounded_rate(xp, v65, v64, b, k) * v65 ** (1.0 - k) * v64 / v65
    v82 = v50 * xp.sinh(v56)
    v83 = v36 > v82
    v84 = xp.where(v83, v36, 2.0 * v82)
    v88 = xp.where(v37, xp.minimum(b, v84) * v44, v49)
    v96 = v88 * xp.sinh(xp.minimum(xp.arcsinh(v84 / v88), 3.0 * xp.minimum(1.0, xp.inf / v88)))
    v97 = v84 > v96
    v98 = xp.where(v97, v84, 2.0 * v96)
    v101 = xp.where(v37, xp.minimum(b, v98) * v44, v49)
    v108 = xp.sinh(xp.minimum(xp.arcsinh(v98 / v101), 3.0 * xp.minimum(1.0, xp.inf / v101)))
    v110 = xp.where(v97, 0.5 * v96, v84)
    v115 = xp.where(v83, 0.5 * v82, v36)
    v116 = xp.where(v83, xp.log(xp.sqrt(v84) / xp.sqrt(xp.where(v97, v101 * v108, 1.0))), 0.0)
    v119 = v82 * xp.exp(v57 * v116)
    v120 = xp.hypot(b, v119)
    v127 = xp.hypot(v50, v119)
    v129 = rounded_rate(xp, v120, v119, b, k) * v120 ** (1.0 - k) * v119 / v120 * v127 ** k
    v136 = v36 * xp.exp(-(v57 * v116))
    v137 = xp.hypot(b, v136)
    v144 = xp.hypot(v50, v136)
    v146 = rounded_rate(xp, v137, v136, b, k) * v137 ** (1.0 - k) * v136 / v137 * v144 ** k
    v149 = v116 * xp.sum(v58 * (v146 * (v136 / v144)), axis=0)
    v80 = v56 * (1.0 * xp.sum(v58 * (v71 * (v50 * xp.cosh(v62)) ** k * 3.0 * v59 * v59), axis=0))
    v152 = xp.where(v23, 1.0, v22)
    v153 = v152 == 0.0
    v154 = v152 < 0.0
    v155 = xp.where(v154, 1.0, v152)
    v157 = xp.where(v154, v31, difference_root(xp, a, v21))
    v162 = xp.sqrt(xp.absolute(v152) * v47)
    v163 = xp.where(v153, xp.minimum(b, v157) * v44, v162)
    v167 = xp.minimum(xp.arcsinh(v157 / v163), 3.0)
    v170, v171 = weighted_along(xp, 1.0 + k, a, c, theta, b, H, H_x, k, mu)
    v172 = v170 * v167
    v174 = v163 * xp.cosh(v172)
    v175 = xp.hypot(b, v174)
    v181 = rounded_rate(xp, v175, v174, b, k) * v175 ** (1.0 - k) * v174 / v175
    v186 = raised(xp, v167, k) * xp.sum(v171 * (v181 * sinh_over(xp, v172) ** k), axis=0)
    v189 = v163 * xp.sinh(v167)
    v190 = v157 > v189
    v191 = xp.where(v190, v157, 2.0 * v189)
    v195 = xp.where(v153, xp.minimum(b, v191) * v44, v162)
    v200 = v195 * xp.sinh(xp.minimum(xp.arcsinh(v191 / v195), 3.0))
    v201 = v191 > v200
    v202 = xp.where(v201, v191, 2.0 * v200)
    v205 = xp.where(v153, xp.minimum(b, v202) * v44, v162)
    v211 = xp.where(v201, 0.5 * v200, v191)
    v213 = xp.sqrt(xp.where(v201, v205 * xp.sinh(xp.minimum(xp.arcsinh(v202 / v205), 3.0)), 1.0))
    v216 = xp.where(v190, 0.5 * v189, v157)
    v217 = xp.where(v190, xp.log(xp.sqrt(v191) / v213), 0.0)
    v220 = v189 * xp.exp(v57 * v217)
    v222 = xp.hypot(v163, v220)
    v223 = xp.hypot(b, v222)
    v230 = v220 ** k * (rounded_rate(xp, v223, v222, b, k) * v223 ** (1.0 - k) * v222 / v223)
    v237 = v157 * xp.exp(-(v57 * v217))
    v239 = xp.hypot(v163, v237)
    v240 = xp.hypot(b, v239)
    v247 = v237 ** k * (rounded_rate(xp, v240, v239, b, k) * v240 ** (1.0 - k) * v239 / v240)
    v250 = v217 * xp.sum(v58 * (v247 * (v237 / v239)), axis=0)
    v252 = v163 ** k * v186 + (v217 * xp.sum(v58 * (v230 * (v220 / v222)), axis=0) + v250)
    v253 = xp.where(v23, v80 + (v116 * xp.sum(v58 * (v129 * (v119 / v127)), axis=0) + v149), v252)
    v20 = power_factor(xp, 2.0, k) * v14 ** 2.0 * gained_share(xp, v11, v14, 2.0) / (2.0 * b)
    v256 = xp.where(v10, 2.0 * b, c)
    v262 = xp.maximum(0.0, b)
    v263 = difference_root(xp, v256, v262)
    v261 = (rounded_depth(xp, v256, difference_root(xp, v256, b), b, k) >= v7) & (v256 > b)
    v265 = v261 & (v263 > 0.0)
    v267 = xp.where(v265, span(xp, v256, a, v263), 0.0)
    v273 = v263 * xp.exp(v57 * v267)
    v274 = v273 * v273
    v276 = xp.sqrt((v262 - 0.0) * (v262 + 0.0) + v274)
    v283 = rounded_rate(xp, v276, xp.sqrt((v262 - b) * (v262 + b) + v274), b, k) * v273
    v287 = xp.where(v265, v267 * xp.sum(v58 * (v283 * (v273 / v276)), axis=0), 0.0)
    v288 = xp.where(v10, v20 + xp.where(v35, v253, 0.0), v287)
    v294 = mu * (H / H_x) * (xp.where(v8, v288, v6 - xp.where(v8, 0.5 * v7, v4)) * xp.tan(theta))
    return v294


def stick_radius(xp, F_x, a, theta, b, H, k, mu):
    v5 = graded_normal_force_at(xp, a, difference_root(xp, a, b), theta, b, H, k)
    v7 = graded_normal_radius_from_force(xp, stick_force(xp, v5, F_x, mu), theta, b, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v7)


def full_slip_displacement(xp, a, theta, b, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, theta, b, k)
