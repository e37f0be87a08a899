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
    v34, v35 = nodes_along(xp, 1, a, c, R, theta, H, k, mu)
    v2 = 1.0 + k
    v6 = R * xp.sin(theta)
    v9 = R * xp.cos(theta)
    v10 = tipped_force(xp, c, difference_root(xp, c, v6), R, v6, v9, k)
    v12 = tipped_force(xp, a, difference_root(xp, a, v6), R, v6, v9, k)
    v13 = 0.25 * v12
    v14 = v10 >= v13
    v15 = xp.where(v14, v10, 2.0 * v13)
    v16 = c <= v6
    v17 = xp.where(v16, c, 0.5 * v6)
    v23 = difference_root(xp, v17, 0.0)
    v22 = (tipped_force(xp, v17, difference_root(xp, v17, v6), R, v6, v9, k) >= v13) & (v17 < v6)
    v25 = v22 & (v23 > 0.0)
    v27 = xp.minimum(a, xp.maximum(v6, v17))
    v29 = difference_root(xp, R, 0.0)
    v33 = xp.where(v25, span(xp, v17, v27, v23 * (difference_root(xp, R, v27) / v29)), 0.0)
    v40 = v23 / difference_root(xp, R, v17) * xp.exp(v34 * v33)
    v43 = xp.sqrt(1.0 + v40 * v40)
    v45 = v29 * (v40 / v43)
    v48 = xp.sqrt(0.0 + v45 * v45)
    v58 = sphere_rate(xp, v48, v29 / v43, k) * (v48 * v48 ** k) * (v45 / v43) * (v45 / v48 / v43)
    v61 = 0.0 * a
    v62 = v61 - v6
    v63 = v62 < 0.0
    v67 = xp.maximum(a - v6, 0.0) * (a + v6)
    v68 = v67 > 0.0
    v71 = xp.where(v68, xp.sqrt(xp.where(v68, v67, 1.0)), 0.0)
    v72 = xp.where(v63, 1.0, v62)
    v74 = xp.where(v63, v71, difference_root(xp, a, v61))
    v75 = v74 > 0.0
    v76 = xp.where(v75, v74, 1.0)
    v77 = v62 == 0.0
    v84 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v87 = v61 + v6
    v89 = xp.sqrt(xp.absolute(v62) * v87)
    v90 = xp.where(v77, xp.minimum(v6, v76) * v84, v89)
    v96 = xp.minimum(xp.arcsinh(v76 / v90), 3.0 * xp.minimum(1.0, xp.inf / v90))
    v97 = v34 * 1.0
    v100 = v96 * (v97 * v97 ** 2.0)
    v102 = v90 * xp.sinh(v100)
    v103 = xp.hypot(v6, v102)
    v108 = tipped_rate(xp, v103, v102, R, v6, v9, k) * v103 ** 2.0 * v102 / v103
    v116 = 1.0 * xp.sum(v35 * (v108 * (v90 * xp.cosh(v100)) ** k * 3.0 * v97 * v97), axis=0)
    v119 = v90 * xp.sinh(v96)
    v120 = v76 > v119
    v121 = xp.where(v120, v76, 2.0 * v119)
    v125 = xp.where(v77, xp.minimum(v6, v121) * v84, v89)
    v132 = xp.sinh(xp.minimum(xp.arcsinh(v121 / v125), 3.0 * xp.minimum(1.0, xp.inf / v125)))
    v133 = v125 * v132
    v134 = v121 > v133
    v135 = xp.where(v134, v121, 2.0 * v133)
    v138 = xp.where(v77, xp.minimum(v6, v135) * v84, v89)
    v145 = xp.sinh(xp.minimum(xp.arcsinh(v135 / v138), 3.0 * xp.minimum(1.0, xp.inf / v138)))
    v147 = xp.where(v134, 0.5 * v133, v121)
    v152 = xp.where(v120, 0.5 * v119, v76)
    v153 = xp.where(v120, xp.log(xp.sqrt(v121) / xp.sqrt(xp.where(v134, v138 * v145, 1.0))), 0.0)
    v156 = v119 * xp.exp(v34 * v153)
    v157 = xp.hypot(v6, v156)
    v163 = xp.hypot(v90, v156)
    v165 = tipped_rate(xp, v157, v156, R, v6, v9, k) * v157 ** 2.0 * v156 / v157 * v163 ** k
    v172 = v76 * xp.exp(-(v34 * v153))
    v173 = xp.hypot(v6, v172)
    v179 = xp.hypot(v90, v172)
    v181 = tipped_rate(xp, v173, v172, R, v6, v9, k) * v173 ** 2.0 * v172 / v173 * v179 ** k
    v184 = v153 * xp.sum(v35 * (v181 * (v172 / v179)), axis=0)
    v187 = xp.where(v63, 1.0, v62)
    v188 = v187 == 0.0
    v189 = v187 < 0.0
    v190 = xp.where(v189, 1.0, v187)
    v192 = xp.where(v189, v71, difference_root(xp, a, v61))
    v197 = xp.sqrt(xp.absolute(v187) * v87)
    v198 = xp.where(v188, xp.minimum(v6, v192) * v84, v197)
    v202 = xp.minimum(xp.arcsinh(v192 / v198), 3.0)
    v204, v205 = weighted_along(xp, v2, a, c, R, theta, H, k, mu)
    v206 = v204 * v202
    v208 = v198 * xp.cosh(v206)
    v209 = xp.hypot(v6, v208)
    v214 = tipped_rate(xp, v209, v208, R, v6, v9, k) * v209 ** 2.0 * v208 / v209
    v219 = raised(xp, v202, k) * xp.sum(v205 * (v214 * sinh_over(xp, v206) ** k), axis=0)
    v222 = v198 * xp.sinh(v202)
    v223 = v192 > v222
    v224 = xp.where(v223, v192, 2.0 * v222)
    v228 = xp.where(v188, xp.minimum(v6, v224) * v84, v197)
    v233 = v228 * xp.sinh(xp.minimum(xp.arcsinh(v224 / v228), 3.0))
    v234 = v224 > v233
    v235 = xp.where(v234, v224, 2.0 * v233)
    v238 = xp.where(v188, xp.minimum(v6, v235) * v84, v197)
    v244 = xp.where(v234, 0.5 * v233, v224)
    v246 = xp.sqrt(xp.where(v234, v238 * xp.sinh(xp.minimum(xp.arcsinh(v235 / v238), 3.0)), 1.0))
    v249 = xp.where(v223, 0.5 * v222, v192)
    v250 = xp.where(v223, xp.log(xp.sqrt(v224) / v246), 0.0)
    v253 = v222 * xp.exp(v34 * v250)
    v255 = xp.hypot(v198, v253)
    v256 = xp.hypot(v6, v255)
    v262 = v253 ** k * (tipped_rate(xp, v256, v255, R, v6, v9, k) * v256 ** 2.0 * v255 / v256)
    v269 = v192 * xp.exp(-(v34 * v250))
    v271 = xp.hypot(v198, v269)
    v272 = xp.hypot(v6, v271)
    v278 = v269 ** k * (tipped_rate(xp, v272, v271, R, v6, v9, k) * v272 ** 2.0 * v271 / v272)
    v281 = v250 * xp.sum(v35 * (v278 * (v269 / v271)), axis=0)
    v186 = v96 * v116 + (v153 * xp.sum(v35 * (v165 * (v156 / v163)), axis=0) + v184)
    v283 = v198 ** k * v219 + (v250 * xp.sum(v35 * (v262 * (v253 / v255)), axis=0) + v281)
    v60 = xp.where(v25, v33 * xp.sum(v35 * v58, axis=0), 0.0)
    v287 = xp.where(v16, 2.0 * v6, c)
    v293 = xp.maximum(0.0, v6)
    v294 = difference_root(xp, v287, v293)
    v292 = (tipped_force(xp, v287, difference_root(xp, v287, v6), R, v6, v9, k) >= v13) & (v287 > v6)
    v296 = v292 & (v294 > 0.0)
    v298 = xp.where(v296, span(xp, v287, a, v294), 0.0)
    v304 = v294 * xp.exp(v34 * v298)
    v305 = v304 * v304
    v307 = xp.sqrt((v293 - 0.0) * (v293 + 0.0) + v305)
    v313 = tipped_rate(xp, v307, xp.sqrt((v293 - v6) * (v293 + v6) + v305), R, v6, v9, k)
    v320 = v298 * xp.sum(v35 * (v313 * (v307 * v307 ** k) * v304 * (v304 / v307)), axis=0)
    v286 = v60 + xp.where(v75, xp.where(v63, v186, v283), 0.0)
    v322 = xp.where(v16, v286, xp.where(v296, v320, 0.0))
    return mu * (2.0 * H / v2) * xp.where(v14, v322, v12 - xp.where(v14, 0.5 * v13, v10))


def traction(xp, r, a, c, R, theta, H, k, mu):
    v34, v35 = nodes_along(xp, 1, r, a, c, R, theta, H, k, mu)
    v1 = r < c
    v2 = xp.where(v1, r, 0.5 * c)
    v4 = xp.minimum(v2, c)
    v6 = R * xp.sin(theta)
    v8 = R * xp.cos(theta)
    v9 = tipped_pressure(xp, v4, c, R, v6, v8, k)
    v10 = tipped_pressure(xp, v4, a, R, v6, v8, k)
    v11 = 0.25 * v10
    v12 = v9 >= v11
    v13 = xp.where(v12, v9, 2.0 * v11)
    v14 = c <= v6
    v15 = xp.where(v14, c, 0.5 * v6)
    v16 = xp.minimum(v2, v15)
    v19 = 0.25 * tipped_pressure(xp, v16, a, R, v6, v8, k)
    v23 = difference_root(xp, v15, v16)
    v25 = (tipped_pressure(xp, v16, v15, R, v6, v8, k) >= v19) & (v15 < v6) & (v23 > 0.0)
    v27 = xp.minimum(a, xp.maximum(v6, v15))
    v29 = difference_root(xp, R, v16)
    v33 = xp.where(v25, span(xp, v15, v27, v23 * (difference_root(xp, R, v27) / v29)), 0.0)
    v41 = v23 / difference_root(xp, R, v15) * xp.exp(v34 * v33)
    v44 = xp.sqrt(1.0 + v41 * v41)
    v46 = v29 * (v41 / v44)
    v49 = xp.sqrt(v16 * v16 + v46 * v46)
    v59 = sphere_rate(xp, v49, v29 / v44, k) * (v46 ** k / v46) * (v46 / v44) * (v46 / v49 / v44)
    v62 = v16 - v6
    v63 = v62 < 0.0
    v67 = xp.maximum(a - v6, 0.0) * (a + v6)
    v68 = v67 > 0.0
    v71 = xp.where(v68, xp.sqrt(xp.where(v68, v67, 1.0)), 0.0)
    v72 = xp.where(v63, 1.0, v62)
    v74 = xp.where(v63, v71, difference_root(xp, a, v16))
    v75 = v74 > 0.0
    v76 = xp.where(v75, v74, 1.0)
    v77 = v62 == 0.0
    v84 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v87 = v16 + v6
    v89 = xp.sqrt(xp.absolute(v62) * v87)
    v90 = xp.where(v77, xp.minimum(v6, v76) * v84, v89)
    v96 = xp.minimum(xp.arcsinh(v76 / v90), 3.0 * xp.minimum(1.0, xp.inf / v90))
    v97 = v34 * 1.0
    v100 = v96 * (v97 * v97 ** 2.0)
    v102 = v90 * xp.sinh(v100)
    v103 = xp.hypot(v6, v102)
    v108 = tipped_rate(xp, v103, v102, R, v6, v8, k) * v103 ** 0.0 * v102 / v103
    v116 = 1.0 * xp.sum(v35 * (v108 * (v90 * xp.cosh(v100)) ** k * 3.0 * v97 * v97), axis=0)
    v119 = v90 * xp.sinh(v96)
    v120 = v76 > v119
    v121 = xp.where(v120, v76, 2.0 * v119)
    v125 = xp.where(v77, xp.minimum(v6, v121) * v84, v89)
    v132 = xp.sinh(xp.minimum(xp.arcsinh(v121 / v125), 3.0 * xp.minimum(1.0, xp.inf / v125)))
    v133 = v125 * v132
    v134 = v121 > v133
    v135 = xp.where(v134, v121, 2.0 * v133)
    v138 = xp.where(v77, xp.minimum(v6, v135) * v84, v89)
    v145 = xp.sinh(xp.minimum(xp.arcsinh(v135 / v138), 3.0 * xp.minimum(1.0, xp.inf / v138)))
    v147 = xp.where(v134, 0.5 * v133, v121)
    v152 = xp.where(v120, 0.5 * v119, v76)
    v153 = xp.where(v120, xp.log(xp.sqrt(v121) / xp.sqrt(xp.where(v134, v138 * v145, 1.0))), 0.0)
    v156 = v119 * xp.exp(v34 * v153)
    v157 = xp.hypot(v6, v156)
    v163 = xp.hypot(v90, v156)
    v165 = tipped_rate(xp, v157, v156, R, v6, v8, k) * v157 ** 0.0 * v156 / v157 * v163 ** k
    v172 = v76 * xp.exp(-(v34 * v153))
    v173 = xp.hypot(v6, v172)
    v179 = xp.hypot(v90, v172)
    v181 = tipped_rate(xp, v173, v172, R, v6, v8, k) * v173 ** 0.0 * v172 / v173 * v179 ** k
    v184 = v153 * xp.sum(v35 * (v181 * (v172 / v179)), axis=0)
    v187 = xp.where(v63, 1.0, v62)
    v188 = v187 == 0.0
    v189 = v187 < 0.0
    v190 = xp.where(v189, 1.0, v187)
    v192 = xp.where(v189, v71, difference_root(xp, a, v16))
    v197 = xp.sqrt(xp.absolute(v187) * v87)
    v198 = xp.where(v188, xp.minimum(v6, v192) * v84, v197)
    v202 = xp.minimum(xp.arcsinh(v192 / v198), 3.0)
    v205, v206 = weighted_along(xp, 1.0 + k, r, a, c, R, theta, H, k, mu)
    v207 = v205 * v202
    v209 = v198 * xp.cosh(v207)
    v210 = xp.hypot(v6, v209)
    v215 = tipped_rate(xp, v210, v209, R, v6, v8, k) * v210 ** 0.0 * v209 / v210
    v220 = raised(xp, v202, k) * xp.sum(v206 * (v215 * sinh_over(xp, v207) ** k), axis=0)
    v223 = v198 * xp.sinh(v202)
    v224 = v192 > v223
    v225 = xp.where(v224, v192, 2.0 * v223)
    v229 = xp.where(v188, xp.minimum(v6, v225) * v84, v197)
    v234 = v229 * xp.sinh(xp.minimum(xp.arcsinh(v225 / v229), 3.0))
    v235 = v225 > v234
    v236 = xp.where(v235, v225, 2.0 * v234)
    v239 = xp.where(v188, xp.minimum(v6, v236) * v84, v197)
    v245 = xp.where(v235, 0.5 * v234, v225)
    v247 = xp.sqrt(xp.where(v235, v239 * xp.sinh(xp.minimum(xp.arcsinh(v236 / v239), 3.0)), 1.0))
    v250 = xp.where(v224, 0.5 * v223, v192)
    v251 = xp.where(v224, xp.log(xp.sqrt(v225) / v247), 0.0)
    v254 = v223 * xp.exp(v34 * v251)
    v256 = xp.hypot(v198, v254)
    v257 = xp.hypot(v6, v256)
    v263 = v254 ** k * (tipped_rate(xp, v257, v256, R, v6, v8, k) * v257 ** 0.0 * v256 / v257)
    v270 = v192 * xp.exp(-(v34 * v251))
    v272 = xp.hypot(v198, v270)
    v273 = xp.hypot(v6, v272)
    v279 = v270 ** k * (tipped_rate(xp, v273, v272, R, v6, v8, k) * v273 ** 0.0 * v272 / v273)
    v282 = v251 * xp.sum(v35 * (v279 * (v270 / v272)), axis=0)
    v186 = v96 * v116 + (v153 * xp.sum(v35 * (v165 * (v156 / v163)), axis=0) + v184)
    v284 = v198 ** k * v220 + (v251 * xp.sum(v35 * (v263 * (v254 / v256)), axis=0) + v282)
    v61 = xp.where(v25, v33 * xp.sum(v35 * v59, axis=0), 0.0)
    v288 = xp.where(v14, 2.0 * v6, c)
    v289 = xp.minimum(v2, v288)
    v292 = 0.25 * tipped_pressure(xp, v289, a, R, v6, v8, k)
    v296 = xp.maximum(v289, v6)
    v297 = difference_root(xp, v288, v296)
    v299 = (tipped_pressure(xp, v289, v288, R, v6, v8, k) >= v292) & (v288 > v6) & (v297 > 0.0)
    v301 = xp.where(v299, span(xp, v288, a, v297), 0.0)
    v307 = v297 * xp.exp(v34 * v301)
    v308 = v307 * v307
    v310 = xp.sqrt((v296 - 0.0) * (v296 + 0.0) + v308)
    v321 = xp.sqrt((v296 - v289) * (v296 + v289) + v308)
    v316 = tipped_rate(xp, v310, xp.sqrt((v296 - v6) * (v296 + v6) + v308), R, v6, v8, k)
    v328 = v301 * xp.sum(v35 * (v316 * (v321 ** k / v321) * v307 * (v307 / v310)), axis=0)
    v287 = v61 + xp.where(v75, xp.where(v63, v186, v284), 0.0)
    v330 = xp.where(v14, v287, xp.where(v299, v328, 0.0))
    v334 = H / 3.141592653589793 * xp.where(v12, v330, v10 - xp.where(v12, 0.5 * v11, v9))
    v337 = xp.where(v1, v334, graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, R, theta, H, k))
    return mu * v337


def tangential_displacement(xp, a, c, R, theta, H, H_x, k, mu):
    v32, v33 = nodes_along(xp, 1, a, c, R, theta, H, H_x, k, mu)
    v4 = R * xp.sin(theta)
    v7 = R * xp.cos(theta)
    v8 = tipped_depth(xp, c, difference_root(xp, c, v4), R, v4, v7, k)
    v10 = tipped_depth(xp, a, difference_root(xp, a, v4), R, v4, v7, k)
    v11 = 0.25 * v10
    v12 = v8 >= v11
    v13 = xp.where(v12, v8, 2.0 * v11)
    v14 = c <= v4
    v15 = xp.where(v14, c, 0.5 * v4)
    v21 = difference_root(xp, v15, 0.0)
    v20 = (tipped_depth(xp, v15, difference_root(xp, v15, v4), R, v4, v7, k) >= v11) & (v15 < v4)
    v23 = v20 & (v21 > 0.0)
    v25 = xp.minimum(a, xp.maximum(v4, v15))
    v27 = difference_root(xp, R, 0.0)
    v31 = xp.where(v23, span(xp, v15, v25, v21 * (difference_root(xp, R, v25) / v27)), 0.0)
    v38 = v21 / difference_root(xp, R, v15) * xp.exp(v32 * v31)
    v41 = xp.sqrt(1.0 + v38 * v38)
    v43 = v27 * (v38 / v41)
    v46 = xp.sqrt(0.0 + v43 * v43)
    v53 = sphere_rate(xp, v46, v27 / v41, k) * (v43 / v41) * (v43 / v46 / v41)
    v56 = 0.0 * a
    v57 = v56 - v4
    v58 = v57 < 0.0
    v62 = xp.maximum(a - v4, 0.0) * (a + v4)
    v63 = v62 > 0.0
    v66 = xp.where(v63, xp.sqrt(xp.where(v63, v62, 1.0)), 0.0)
    v67 = xp.where(v58, 1.0, v57)
    v69 = xp.where(v58, v66, difference_root(xp, a, v56))
    v70 = v69 > 0.0
    v71 = xp.where(v70, v69, 1.0)
    v72 = v57 == 0.0
    v79 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v82 = v56 + v4
    v84 = xp.sqrt(xp.absolute(v57) * v82)
    v85 = xp.where(v72, xp.minimum(v4, v71) * v79, v84)
    v91 = xp.minimum(xp.arcsinh(v71 / v85), 3.0 * xp.minimum(1.0, xp.inf / v85))
    v92 = v32 * 1.0
    v95 = v91 * (v92 * v92 ** 2.0)
    v97 = v85 * xp.sinh(v95)
    v98 = xp.hypot(v4, v97)
    v104 = tipped_rate(xp, v98, v97, R, v4, v7, k) * v98 ** (1.0 - k) * v97 / v98
    v115 = v85 * xp.sinh(v91)
    v116 = v71 > v115
    v117 = xp.where(v116, v71, 2.0 * v115)
    v121 = xp.where(v72, xp.minimum(v4, v117) * v79, v84)
    v128 = xp.sinh(xp.minimum(xp.arcsinh(v117 / v121), 3.0 * xp.minimum(1.0, xp.inf / v121)))
    v129 = v121 * v128
    v130 = v117 > v129
    v131 = xp.where(v130, v117, 2.0 * v129)
    v134 = xp.where(v72, xp.minimum(v4, v131) * v79, v84)
    v141 = xp.sinh(xp.minimum(xp.arcsinh(v131 / v134), 3.0 * xp.minimum(1.0, xp.inf / v134)))
    v143 = xp.where(v130, 0.5 * v129, v117)
    v148 = xp.where(v116, 0.5 * v115, v71)
    v149 = xp.where(v116, xp.log(xp.sqrt(v117) / xp.sqrt(xp.where(v130, v134 * v141, 1.0))), 0.0)
    v152 = v115 * xp.exp(v32 * v149)
    v153 = xp.hypot(v4, v152)
    v160 = xp.hypot(v85, v152)
    v159 = tipped_rate(xp, v153, v152, R, v4, v7, k) * v153 ** (1.0 - k) * v152 / v153
    v169 = v71 * xp.exp(-(v32 * v149))
    v170 = xp.hypot(v4, v169)
    v177 = xp.hypot(v85, v169)
    v176 = tipped_rate(xp, v170, v169, R, v4, v7, k) * v170 ** (1.0 - k) * v169 / v170
    v182 = v149 * xp.sum(v33 * (v176 * v177 ** k * (v169 / v177)), axis=0)
    v113 = v91 * (1.0 * xp.sum(v33 * (v104 * (v85 * xp.cosh(v95)) ** k * 3.0 * v92 * v92), axis=0))
    v185 = xp.where(v58, 1.0, v57)
    v186 = v185 == 0.0
    v187 = v185 < 0.0
    v188 = xp.where(v187, 1.0, v185)
    v190 = xp.where(v187, v66, difference_root(xp, a, v56))
    v195 = xp.sqrt(xp.absolute(v185) * v82)
    v196 = xp.where(v186, xp.minimum(v4, v190) * v79, v195)
    v200 = xp.minimum(xp.arcsinh(v190 / v196), 3.0)
    v203, v204 = weighted_along(xp, 1.0 + k, a, c, R, theta, H, H_x, k, mu)
    v205 = v203 * v200
    v207 = v196 * xp.cosh(v205)
    v208 = xp.hypot(v4, v207)
    v214 = tipped_rate(xp, v208, v207, R, v4, v7, k) * v208 ** (1.0 - k) * v207 / v208
    v219 = raised(xp, v200, k) * xp.sum(v204 * (v214 * sinh_over(xp, v205) ** k), axis=0)
    v222 = v196 * xp.sinh(v200)
    v223 = v190 > v222
    v224 = xp.where(v223, v190, 2.0 * v222)
    v228 = xp.where(v186, xp.minimum(v4, v224) * v79, v195)
    v233 = v228 * xp.sinh(xp.minimum(xp.arcsinh(v224 / v228), 3.0))
    v234 = v224 > v233
    v235 = xp.where(v234, v224, 2.0 * v233)
    v238 = xp.where(v186, xp.minimum(v4, v235) * v79, v195)
    v244 = xp.where(v234, 0.5 * v233, v224)
    v246 = xp.sqrt(xp.where(v234, v238 * xp.sinh(xp.minimum(xp.arcsinh(v235 / v238), 3.0)), 1.0))
    v249 = xp.where(v223, 0.5 * v222, v190)
    v250 = xp.where(v223, xp.log(xp.sqrt(v224) / v246), 0.0)
    v253 = v222 * xp.exp(v32 * v250)
    v255 = xp.hypot(v196, v253)
    v256 = xp.hypot(v4, v255)
    v262 = tipped_rate(xp, v256, v255, R, v4, v7, k) * v256 ** (1.0 - k) * v255 / v256
    v270 = v190 * xp.exp(-(v32 * v250))
    v272 = xp.hypot(v196, v270)
    v273 = xp.hypot(v4, v272)
    v279 = tipped_rate(xp, v273, v272, R, v4, v7, k) * v273 ** (1.0 - k) * v272 / v273
    v283 = v250 * xp.sum(v33 * (v270 ** k * v279 * (v270 / v272)), axis=0)
    v284 = v250 * xp.sum(v33 * (v253 ** k * v262 * (v253 / v255)), axis=0) + v283
    v184 = v113 + (v149 * xp.sum(v33 * (v159 * v160 ** k * (v152 / v160)), axis=0) + v182)
    v287 = xp.where(v70, xp.where(v58, v184, v196 ** k * v219 + v284), 0.0)
    v289 = xp.where(v14, 2.0 * v4, c)
    v295 = xp.maximum(0.0, v4)
    v296 = difference_root(xp, v289, v295)
    v294 = (tipped_depth(xp, v289, difference_root(xp, v289, v4), R, v4, v7, k) >= v11) & (v289 > v4)
    v298 = v294 & (v296 > 0.0)
    v300 = xp.where(v298, span(xp, v289, a, v296), 0.0)
    v306 = v296 * xp.exp(v32 * v300)
    v307 = v306 * v306
    v309 = xp.sqrt((v295 - 0.0) * (v295 + 0.0) + v307)
    v316 = tipped_rate(xp, v309, xp.sqrt((v295 - v4) * (v295 + v4) + v307), R, v4, v7, k) * v306
    v320 = xp.where(v298, v300 * xp.sum(v33 * (v316 * (v306 / v309)), axis=0), 0.0)
    v321 = xp.where(v14, xp.where(v23, v31 * xp.sum(v33 * v53, axis=0), 0.0) + v287, v320)
    return mu * (H / H_x) * xp.where(v12, v321, v10 - xp.where(v12, 0.5 * v11, v8))


def stick_radius(xp, F_x, a, R, theta, H, k, mu):
    v5 = graded_normal_force_at(xp, a, sine_root(xp, a, R, theta), R, theta, H, k)
    v7 = graded_normal_radius_from_force(xp, stick_force(xp, v5, F_x, mu), R, theta, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v7)


def full_slip_displacement(xp, a, R, theta, H, H_x, k, mu):
    v5 = mu * (H / H_x) * graded_normal_depth_at(xp, a, sine_root(xp, a, R, theta), R, theta, k)
    return v5
