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
    v57, v58 = nodes_along(xp, 1, a, c, theta, b, H, k, mu)
    v2 = 1.0 + k
    v5 = difference_root(xp, c, 0.0)
    v8 = 0.25 * difference_root(xp, a, 0.0)
    v11 = c <= b
    v12 = xp.where(v11, c, 0.5 * b)
    v14 = xp.minimum(a, xp.maximum(b, v12))
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
    v52 = xp.arcsinh(v36 / v50)
    v56 = xp.minimum(v52, 3.0 * xp.minimum(1.0, xp.inf / v50))
    v59 = v57 * 1.0
    v62 = v56 * (v59 * v59 ** 2.0)
    v64 = v50 * xp.sinh(v62)
    v65 = xp.hypot(b, v64)
    v74 = rounded_rate(xp, v65, v64, b, k) * v65 ** 2.0 * v64 / v65 * (v50 * xp.cosh(v62)) ** k
    v80 = v56 < v52
    v84 = xp.where(v80, 2.0 * v52, v56)
    v85 = xp.where(v80, v50 * xp.sinh(xp.where(v80, v56, 0.5 * v52)), v36)
    v86 = v36 > v85
    v87 = xp.where(v86, v36, 2.0 * v85)
    v91 = xp.where(v37, xp.minimum(b, v87) * v44, v49)
    v93 = xp.arcsinh(v87 / v91)
    v97 = xp.minimum(v93, 3.0 * xp.minimum(1.0, xp.inf / v91))
    v98 = v97 < v93
    v102 = xp.where(v98, 2.0 * v93, v97)
    v103 = xp.where(v98, v91 * xp.sinh(xp.where(v98, v97, 0.5 * v93)), v87)
    v104 = v87 > v103
    v105 = xp.where(v104, v87, 2.0 * v103)
    v108 = xp.where(v37, xp.minimum(b, v105) * v44, v49)
    v110 = xp.arcsinh(v105 / v108)
    v114 = xp.minimum(v110, 3.0 * xp.minimum(1.0, xp.inf / v108))
    v115 = v114 < v110
    v119 = xp.where(v115, 2.0 * v110, v114)
    v121 = xp.where(v104, 0.5 * v103, v87)
    v120 = xp.where(v115, v108 * xp.sinh(xp.where(v115, v114, 0.5 * v110)), v105)
    v126 = xp.where(v86, 0.5 * v85, v36)
    v127 = xp.where(v86, xp.log(xp.sqrt(v87) / xp.sqrt(xp.where(v104, v120, 1.0))), 0.0)
    v130 = v85 * xp.exp(v57 * v127)
    v131 = xp.hypot(b, v130)
    v137 = xp.hypot(v50, v130)
    v139 = rounded_rate(xp, v131, v130, b, k) * v131 ** 2.0 * v130 / v131 * v137 ** k
    v146 = v36 * xp.exp(-(v57 * v127))
    v147 = xp.hypot(b, v146)
    v153 = xp.hypot(v50, v146)
    v155 = rounded_rate(xp, v147, v146, b, k) * v147 ** 2.0 * v146 / v147 * v153 ** k
    v158 = v127 * xp.sum(v58 * (v155 * (v146 / v153)), axis=0)
    v79 = v56 * (1.0 * xp.sum(v58 * (v74 * 3.0 * v59 * v59), axis=0))
    v161 = xp.where(v23, 1.0, v22)
    v162 = v161 == 0.0
    v163 = v161 < 0.0
    v164 = xp.where(v163, 1.0, v161)
    v166 = xp.where(v163, v31, difference_root(xp, a, v21))
    v171 = xp.sqrt(xp.absolute(v161) * v47)
    v172 = xp.where(v162, xp.minimum(b, v166) * v44, v171)
    v175 = xp.arcsinh(v166 / v172)
    v176 = xp.minimum(v175, 3.0)
    v178, v179 = weighted_along(xp, v2, a, c, theta, b, H, k, mu)
    v180 = v178 * v176
    v182 = v172 * xp.cosh(v180)
    v183 = xp.hypot(b, v182)
    v188 = rounded_rate(xp, v183, v182, b, k) * v183 ** 2.0 * v182 / v183
    v193 = raised(xp, v176, k) * xp.sum(v179 * (v188 * sinh_over(xp, v180) ** k), axis=0)
    v195 = v176 < v175
    v199 = xp.where(v195, 2.0 * v175, v176)
    v200 = xp.where(v195, v172 * xp.sinh(xp.where(v195, v176, 0.5 * v175)), v166)
    v201 = v166 > v200
    v202 = xp.where(v201, v166, 2.0 * v200)
    v206 = xp.where(v162, xp.minimum(b, v202) * v44, v171)
    v208 = xp.arcsinh(v202 / v206)
    v209 = xp.minimum(v208, 3.0)
    v210 = v209 < v208
    v214 = xp.where(v210, 2.0 * v208, v209)
    v215 = xp.where(v210, v206 * xp.sinh(xp.where(v210, v209, 0.5 * v208)), v202)
    v216 = v202 > v215
    v217 = xp.where(v216, v202, 2.0 * v215)
    v220 = xp.where(v162, xp.minimum(b, v217) * v44, v171)
    v222 = xp.arcsinh(v217 / v220)
    v223 = xp.minimum(v222, 3.0)
    v224 = v223 < v222
    v228 = xp.where(v224, 2.0 * v222, v223)
    v230 = xp.where(v216, 0.5 * v215, v202)
    v229 = xp.where(v224, v220 * xp.sinh(xp.where(v224, v223, 0.5 * v222)), v217)
    v235 = xp.where(v201, 0.5 * v200, v166)
    v236 = xp.where(v201, xp.log(xp.sqrt(v202) / xp.sqrt(xp.where(v216, v229, 1.0))), 0.0)
    v239 = v200 * xp.exp(v57 * v236)
    v241 = xp.hypot(v172, v239)
    v242 = xp.hypot(b, v241)
    v248 = v239 ** k * (rounded_rate(xp, v242, v241, b, k) * v242 ** 2.0 * v241 / v242)
    v255 = v166 * xp.exp(-(v57 * v236))
    v257 = xp.hypot(v172, v255)
    v258 = xp.hypot(b, v257)
    v264 = v255 ** k * (rounded_rate(xp, v258, v257, b, k) * v258 ** 2.0 * v257 / v258)
    v267 = v236 * xp.sum(v58 * (v264 * (v255 / v257)), axis=0)
    v269 = v172 ** k * v193 + (v236 * xp.sum(v58 * (v248 * (v239 / v241)), axis=0) + v267)
    v270 = xp.where(v23, v79 + (v127 * xp.sum(v58 * (v139 * (v130 / v137)), axis=0) + v158), v269)
    v20 = power_force(xp, v14, 2.0, k) * gained_share(xp, v12, v14, 2.0 + v2) / (2.0 * b)
    v273 = xp.where(v11, 2.0 * b, c)
    v274 = difference_root(xp, v273, 0.0)
    v280 = xp.maximum(0.0, b)
    v281 = difference_root(xp, v273, v280)
    v283 = (v274 > 0.0) & (v274 >= v8) & (v273 > b) & (v281 > 0.0)
    v285 = xp.where(v283, span(xp, v273, a, v281), 0.0)
    v291 = v281 * xp.exp(v57 * v285)
    v292 = v291 * v291
    v294 = xp.sqrt((v280 - 0.0) * (v280 + 0.0) + v292)
    v300 = rounded_rate(xp, v294, xp.sqrt((v280 - b) * (v280 + b) + v292), b, k)
    v307 = v285 * xp.sum(v58 * (v300 * (v294 * v294 ** k) * v291 * (v291 / v294)), axis=0)
    v313 = rounded_force(xp, c, difference_root(xp, c, b), b, k)
    v314 = rounded_force(xp, a, difference_root(xp, a, b), b, k) - v313
    v309 = xp.where(v11, v20 + xp.where(v35, v270, 0.0), xp.where(v283, v307, 0.0))
    v318 = mu * (2.0 * H / v2) * (xp.where((v5 > 0.0) & (v5 >= v8), v309, v314) * xp.tan(theta))
    return v318


def traction(xp, r, a, c, theta, b, H, k, mu):
    v57, v58 = nodes_along(xp, 1, r, a, c, theta, b, H, k, mu)
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v4 = xp.minimum(v2, c)
    v5 = difference_root(xp, c, v4)
    v11 = c <= b
    v12 = xp.where(v11, c, 0.5 * b)
    v15 = xp.minimum(v2, v12)
    v18 = power_growth(xp, v15, v12, xp.minimum(a, xp.maximum(b, v12)), 2.0, k)
    v22 = v15 - b
    v23 = v22 < 0.0
    v27 = xp.maximum(a - b, 0.0) * (a + b)
    v28 = v27 > 0.0
    v31 = xp.where(v28, xp.sqrt(xp.where(v28, v27, 1.0)), 0.0)
    v32 = xp.where(v23, 1.0, v22)
    v34 = xp.where(v23, v31, difference_root(xp, a, v15))
    v35 = v34 > 0.0
    v36 = xp.where(v35, v34, 1.0)
    v37 = v22 == 0.0
    v44 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v47 = v15 + b
    v49 = xp.sqrt(xp.absolute(v22) * v47)
    v50 = xp.where(v37, xp.minimum(b, v36) * v44, v49)
    v52 = xp.arcsinh(v36 / v50)
    v56 = xp.minimum(v52, 3.0 * xp.minimum(1.0, xp.inf / v50))
    v59 = v57 * 1.0
    v62 = v56 * (v59 * v59 ** 2.0)
    v64 = v50 * xp.sinh(v62)
    v65 = xp.hypot(b, v64)
    v74 = rounded_rate(xp, v65, v64, b, k) * v65 ** 0.0 * v64 / v65 * (v50 * xp.cosh(v62)) ** k
    v80 = v56 < v52
    v84 = xp.where(v80, 2.0 * v52, v56)
    v85 = xp.where(v80, v50 * xp.sinh(xp.where(v80, v56, 0.5 * v52)), v36)
    v86 = v36 > v85
    v87 = xp.where(v86, v36, 2.0 * v85)
    v91 = xp.where(v37, xp.minimum(b, v87) * v44, v49)
    v93 = xp.arcsinh(v87 / v91)
    v97 = xp.minimum(v93, 3.0 * xp.minimum(1.0, xp.inf / v91))
    v98 = v97 < v93
    v102 = xp.where(v98, 2.0 * v93, v97)
    v103 = xp.where(v98, v91 * xp.sinh(xp.where(v98, v97, 0.5 * v93)), v87)
    v104 = v87 > v103
    v105 = xp.where(v104, v87, 2.0 * v103)
    v108 = xp.where(v37, xp.minimum(b, v105) * v44, v49)
    v110 = xp.arcsinh(v105 / v108)
    v114 = xp.minimum(v110, 3.0 * xp.minimum(1.0, xp.inf / v108))
    v115 = v114 < v110
    v119 = xp.where(v115, 2.0 * v110, v114)
    v121 = xp.where(v104, 0.5 * v103, v87)
    v120 = xp.where(v115, v108 * xp.sinh(xp.where(v115, v114, 0.5 * v110)), v105)
    v126 = xp.where(v86, 0.5 * v85, v36)
    v127 = xp.where(v86, xp.log(xp.sqrt(v87) / xp.sqrt(xp.where(v104, v120, 1.0))), 0.0)
    v130 = v85 * xp.exp(v57 * v127)
    v131 = xp.hypot(b, v130)
    v137 = xp.hypot(v50, v130)
    v139 = rounded_rate(xp, v131, v130, b, k) * v131 ** 0.0 * v130 / v131 * v137 ** k
    v146 = v36 * xp.exp(-(v57 * v127))
    v147 = xp.hypot(b, v146)
    v153 = xp.hypot(v50, v146)
    v155 = rounded_rate(xp, v147, v146, b, k) * v147 ** 0.0 * v146 / v147 * v153 ** k
    v158 = v127 * xp.sum(v58 * (v155 * (v146 / v153)), axis=0)
    v79 = v56 * (1.0 * xp.sum(v58 * (v74 * 3.0 * v59 * v59), axis=0))
    v161 = xp.where(v23, 1.0, v22)
    v162 = v161 == 0.0
    v163 = v161 < 0.0
    v164 = xp.where(v163, 1.0, v161)
    v166 = xp.where(v163, v31, difference_root(xp, a, v15))
    v171 = xp.sqrt(xp.absolute(v161) * v47)
    v172 = xp.where(v162, xp.minimum(b, v166) * v44, v171)
    v175 = xp.arcsinh(v166 / v172)
    v176 = xp.minimum(v175, 3.0)
    v179, v180 = weighted_along(xp, 1.0 + k, r, a, c, theta, b, H, k, mu)
    v181 = v179 * v176
    v183 = v172 * xp.cosh(v181)
    v184 = xp.hypot(b, v183)
    v189 = rounded_rate(xp, v184, v183, b, k) * v184 ** 0.0 * v183 / v184
    v194 = raised(xp, v176, k) * xp.sum(v180 * (v189 * sinh_over(xp, v181) ** k), axis=0)
    v196 = v176 < v175
    v200 = xp.where(v196, 2.0 * v175, v176)
    v201 = xp.where(v196, v172 * xp.sinh(xp.where(v196, v176, 0.5 * v175)), v166)
    v202 = v166 > v201
    v203 = xp.where(v202, v166, 2.0 * v201)
    v207 = xp.where(v162, xp.minimum(b, v203) * v44, v171)
    v209 = xp.arcsinh(v203 / v207)
    v210 = xp.minimum(v209, 3.0)
    v211 = v210 < v209
    v215 = xp.where(v211, 2.0 * v209, v210)
    v216 = xp.where(v211, v207 * xp.sinh(xp.where(v211, v210, 0.5 * v209)), v203)
    v217 = v203 > v216
    v218 = xp.where(v217, v203, 2.0 * v216)
    v221 = xp.where(v162, xp.minimum(b, v218) * v44, v171)
    v223 = xp.arcsinh(v218 / v221)
    v224 = xp.minimum(v223, 3.0)
    v225 = v224 < v223
    v229 = xp.where(v225, 2.0 * v223, v224)
    v231 = xp.where(v217, 0.5 * v216, v203)
    v230 = xp.where(v225, v221 * xp.sinh(xp.where(v225, v224, 0.5 * v223)), v218)
    v236 = xp.where(v202, 0.5 * v201, v166)
    v237 = xp.where(v202, xp.log(xp.sqrt(v203) / xp.sqrt(xp.where(v217, v230, 1.0))), 0.0)
    v240 = v201 * xp.exp(v57 * v237)
    v242 = xp.hypot(v172, v240)
    v243 = xp.hypot(b, v242)
    v249 = v240 ** k * (rounded_rate(xp, v243, v242, b, k) * v243 ** 0.0 * v242 / v243)
    v256 = v166 * xp.exp(-(v57 * v237))
    v258 = xp.hypot(v172, v256)
    v259 = xp.hypot(b, v258)
    v265 = v256 ** k * (rounded_rate(xp, v259, v258, b, k) * v259 ** 0.0 * v258 / v259)
    v268 = v237 * xp.sum(v58 * (v265 * (v256 / v258)), axis=0)
    v270 = v172 ** k * v194 + (v237 * xp.sum(v58 * (v249 * (v240 / v242)), axis=0) + v268)
    v271 = xp.where(v23, v79 + (v127 * xp.sum(v58 * (v139 * (v130 / v137)), axis=0) + v158), v270)
    v274 = xp.where(v11, 2.0 * b, c)
    v275 = xp.minimum(v2, v274)
    v276 = difference_root(xp, v274, v275)
    v284 = xp.maximum(v275, b)
    v285 = difference_root(xp, v274, v284)
    v287 = (v276 > 0.0) & (v276 >= 0.25 * difference_root(xp, a, v275)) & (v274 > b) & (v285 > 0.0)
    v289 = xp.where(v287, span(xp, v274, a, v285), 0.0)
    v295 = v285 * xp.exp(v57 * v289)
    v296 = v295 * v295
    v298 = xp.sqrt((v284 - 0.0) * (v284 + 0.0) + v296)
    v309 = xp.sqrt((v284 - v275) * (v284 + v275) + v296)
    v304 = rounded_rate(xp, v298, xp.sqrt((v284 - b) * (v284 + b) + v296), b, k)
    v316 = v289 * xp.sum(v58 * (v304 * (v309 ** k / v309) * v295 * (v295 / v298)), axis=0)
    v273 = power_factor(xp, 2.0, k) * 2.0 * v18 / (2.0 * b) + xp.where(v35, v271, 0.0)
    v10 = (v5 > 0.0) & (v5 >= 0.25 * difference_root(xp, a, v4))
    v321 = rounded_pressure(xp, v4, a, b, k) - rounded_pressure(xp, v4, c, b, k)
    v324 = xp.where(v10, xp.where(v11, v273, xp.where(v287, v316, 0.0)), v321) * xp.tan(theta)
    v327 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, theta, b, H, k)
    return mu * xp.where(v1, H / 3.141592653589793 * v324, v327)


def tangential_displacement(xp, a, c, theta, b, H, H_x, k, mu):
    v56, v57 = nodes_along(xp, 1, a, c, theta, b, H, H_x, k, mu)
    v3 = difference_root(xp, c, 0.0)
    v6 = 0.25 * difference_root(xp, a, 0.0)
    v9 = c <= b
    v10 = xp.where(v9, c, 0.5 * b)
    v13 = xp.minimum(a, xp.maximum(b, v10))
    v20 = 0.0 * a
    v21 = v20 - b
    v22 = v21 < 0.0
    v26 = xp.maximum(a - b, 0.0) * (a + b)
    v27 = v26 > 0.0
    v30 = xp.where(v27, xp.sqrt(xp.where(v27, v26, 1.0)), 0.0)
    v31 = xp.where(v22, 1.0, v21)
    v33 = xp.where(v22, v30, difference_root(xp, a, v20))
    v34 = v33 > 0.0
    v35 = xp.where(v34, v33, 1.0)
    v36 = v21 == 0.0
    v43 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v46 = v20 + b
    v48 = xp.sqrt(xp.absolute(v21) * v46)
    v49 = xp.where(v36, xp.minimum(b, v35) * v43, v48)
    v51 = xp.arcsinh(v35 / v49)
    v55 = xp.minimum(v51, 3.0 * xp.minimum(1.0, xp.inf / v49))
    v58 = v56 * 1.0
    v61 = v55 * (v58 * v58 ** 2.0)
    v63 = v49 * xp.sinh(v61)
    v64 = xp.hypot(b, v63)
    v70 = rounded_rate(xp, v64, v63, b, k) * v64 ** (1.0 - k) * v63 / v64
    v80 = v55 < v51
    v84 = xp.where(v80, 2.0 * v51, v55)
    v85 = xp.where(v80, v49 * xp.sinh(xp.where(v80, v55, 0.5 * v51)), v35)
    v86 = v35 > v85
    v87 = xp.where(v86, v35, 2.0 * v85)
    v91 = xp.where(v36, xp.minimum(b, v87) * v43, v48)
    v93 = xp.arcsinh(v87 / v91)
    v97 = xp.minimum(v93, 3.0 * xp.minimum(1.0, xp.inf / v91))
    v98 = v97 < v93
    v102 = xp.where(v98, 2.0 * v93, v97)
    v103 = xp.where(v98, v91 * xp.sinh(xp.where(v98, v97, 0.5 * v93)), v87)
    v104 = v87 > v103
    v105 = xp.where(v104, v87, 2.0 * v103)
    v108 = xp.where(v36, xp.minimum(b, v105) * v43, v48)
    v110 = xp.arcsinh(v105 / v108)
    v114 = xp.minimum(v110, 3.0 * xp.minimum(1.0, xp.inf / v108))
    v115 = v114 < v110
    v119 = xp.where(v115, 2.0 * v110, v114)
    v121 = xp.where(v104, 0.5 * v103, v87)
    v120 = xp.where(v115, v108 * xp.sinh(xp.where(v115, v114, 0.5 * v110)), v105)
    v126 = xp.where(v86, 0.5 * v85, v35)
    v127 = xp.where(v86, xp.log(xp.sqrt(v87) / xp.sqrt(xp.where(v104, v120, 1.0))), 0.0)
    v130 = v85 * xp.exp(v56 * v127)
    v131 = xp.hypot(b, v130)
    v138 = xp.hypot(v49, v130)
    v140 = rounded_rate(xp, v131, v130, b, k) * v131 ** (1.0 - k) * v130 / v131 * v138 ** k
    v147 = v35 * xp.exp(-(v56 * v127))
    v148 = xp.hypot(b, v147)
    v155 = xp.hypot(v49, v147)
    v157 = rounded_rate(xp, v148, v147, b, k) * v148 ** (1.0 - k) * v147 / v148 * v155 ** k
    v160 = v127 * xp.sum(v57 * (v157 * (v147 / v155)), axis=0)
    v79 = v55 * (1.0 * xp.sum(v57 * (v70 * (v49 * xp.cosh(v61)) ** k * 3.0 * v58 * v58), axis=0))
    v163 = xp.where(v22, 1.0, v21)
    v164 = v163 == 0.0
    v165 = v163 < 0.0
    v166 = xp.where(v165, 1.0, v163)
    v168 = xp.where(v165, v30, difference_root(xp, a, v20))
    v173 = xp.sqrt(xp.absolute(v163) * v46)
    v174 = xp.where(v164, xp.minimum(b, v168) * v43, v173)
    v177 = xp.arcsinh(v168 / v174)
    v178 = xp.minimum(v177, 3.0)
    v181, v182 = weighted_along(xp, 1.0 + k, a, c, theta, b, H, H_x, k, mu)
    v183 = v181 * v178
    v185 = v174 * xp.cosh(v183)
    v186 = xp.hypot(b, v185)
    v192 = rounded_rate(xp, v186, v185, b, k) * v186 ** (1.0 - k) * v185 / v186
    v197 = raised(xp, v178, k) * xp.sum(v182 * (v192 * sinh_over(xp, v183) ** k), axis=0)
    v199 = v178 < v177
    v203 = xp.where(v199, 2.0 * v177, v178)
    v204 = xp.where(v199, v174 * xp.sinh(xp.where(v199, v178, 0.5 * v177)), v168)
    v205 = v168 > v204
    v206 = xp.where(v205, v168, 2.0 * v204)
    v210 = xp.where(v164, xp.minimum(b, v206) * v43, v173)
    v212 = xp.arcsinh(v206 / v210)
    v213 = xp.minimum(v212, 3.0)
    v214 = v213 < v212
    v218 = xp.where(v214, 2.0 * v212, v213)
    v219 = xp.where(v214, v210 * xp.sinh(xp.where(v214, v213, 0.5 * v212)), v206)
    v220 = v206 > v219
    v221 = xp.where(v220, v206, 2.0 * v219)
    v224 = xp.where(v164, xp.minimum(b, v221) * v43, v173)
    v226 = xp.arcsinh(v221 / v224)
    v227 = xp.minimum(v226, 3.0)
    v228 = v227 < v226
    v232 = xp.where(v228, 2.0 * v226, v227)
    v234 = xp.where(v220, 0.5 * v219, v206)
    v233 = xp.where(v228, v224 * xp.sinh(xp.where(v228, v227, 0.5 * v226)), v221)
    v239 = xp.where(v205, 0.5 * v204, v168)
    v240 = xp.where(v205, xp.log(xp.sqrt(v206) / xp.sqrt(xp.where(v220, v233, 1.0))), 0.0)
    v243 = v204 * xp.exp(v56 * v240)
    v245 = xp.hypot(v174, v243)
    v246 = xp.hypot(b, v245)
    v253 = v243 ** k * (rounded_rate(xp, v246, v245, b, k) * v246 ** (1.0 - k) * v245 / v246)
    v260 = v168 * xp.exp(-(v56 * v240))
    v262 = xp.hypot(v174, v260)
    v263 = xp.hypot(b, v262)
    v270 = v260 ** k * (rounded_rate(xp, v263, v262, b, k) * v263 ** (1.0 - k) * v262 / v263)
    v273 = v240 * xp.sum(v57 * (v270 * (v260 / v262)), axis=0)
    v275 = v174 ** k * v197 + (v240 * xp.sum(v57 * (v253 * (v243 / v245)), axis=0) + v273)
    v276 = xp.where(v22, v79 + (v127 * xp.sum(v57 * (v140 * (v130 / v138)), axis=0) + v160), v275)
    v19 = power_factor(xp, 2.0, k) * v13 ** 2.0 * gained_share(xp, v10, v13, 2.0) / (2.0 * b)
    v279 = xp.where(v9, 2.0 * b, c)
    v280 = difference_root(xp, v279, 0.0)
    v286 = xp.maximum(0.0, b)
    v287 = difference_root(xp, v279, v286)
    v289 = (v280 > 0.0) & (v280 >= v6) & (v279 > b) & (v287 > 0.0)
    v291 = xp.where(v289, span(xp, v279, a, v287), 0.0)
    v297 = v287 * xp.exp(v56 * v291)
    v298 = v297 * v297
    v300 = xp.sqrt((v286 - 0.0) * (v286 + 0.0) + v298)
    v307 = rounded_rate(xp, v300, xp.sqrt((v286 - b) * (v286 + b) + v298), b, k) * v297
    v311 = xp.where(v289, v291 * xp.sum(v57 * (v307 * (v297 / v300)), axis=0), 0.0)
    v316 = rounded_depth(xp, c, difference_root(xp, c, b), b, k)
    v312 = xp.where(v9, v19 + xp.where(v34, v276, 0.0), v311)
    v317 = rounded_depth(xp, a, difference_root(xp, a, b), b, k) - v316
    return mu * (H / H_x) * (xp.where((v3 > 0.0) & (v3 >= v6), v312, v317) * xp.tan(theta))


def stick_radius(xp, F_x, a, theta, b, H, k, mu):
    v5 = graded_normal_force_at(xp, a, difference_root(xp, a, b), theta, b, H, k)
    v7 = graded_normal_radius_from_force(xp, stick_force(xp, v5, F_x, mu), theta, b, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v7)


def full_slip_displacement(xp, a, theta, b, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, theta, b, k)
