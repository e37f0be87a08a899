"""Formulas of axicontact._runtime.graded.pressure over an array library `xp`."""

from ....._programs.expressions._runtime.graded.breaks import past_tip
from ....._programs.expressions._runtime.graded.breaks import rounded_rate
from ....._programs.expressions._runtime.graded.breaks import rounding_rate
from ....._programs.expressions._runtime.graded.breaks import tipped_rate
from ....._programs.expressions._runtime.graded.growth import axis_power
from ....._programs.expressions._runtime.graded.growth import gaussian_rate
from ....._programs.expressions._runtime.graded.growth import hyperboloid_rate
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import sphere_rate
from ....._programs.expressions._runtime.graded.rules import raised
from ....._programs.expressions._runtime.graded.rules import sine_integral
from ....._programs.expressions._runtime.graded.rules import sinh_over
from ....._programs.expressions._runtime.graded.waves import waves_rate
from ....._programs.expressions._runtime.integrals import difference_root
from ....._runtime.steps import nodes_along
from ....._runtime.steps import weighted_along


def steep(xp, rest, near, m, half):
    v7, v8 = nodes_along(xp, 1, rest, near, m, half)
    v2 = xp.where(xp.isfinite(rest), rest, xp.inf)
    v6 = xp.minimum(v2, 42.0 / xp.maximum(xp.absolute(m), 20.0))
    v9 = v7 * v6
    v19 = xp.exp(-m * v9) * (-xp.expm1(-2.0 * (near + (v2 - v9)))) ** half
    return v6 * xp.sum(v8 * v19, axis=0)


def tail(xp, rest, near, m, half, far):
    v1 = m - 0.0
    v2 = v1 == 0.0
    v4 = xp.where(xp.isfinite(rest), rest, 0.0)
    v5 = xp.absolute(v1)
    v13 = v1 > 0.0
    v14 = xp.where(v13, v1, 1.0)
    v21 = xp.where(v13, xp.exp(-0.0 * (near + v4)), xp.exp(-0.0 * near) * far)
    v24 = 0.0 - half
    v25 = m - 2.0
    v26 = v25 == 0.0
    v27 = xp.absolute(v25)
    v36 = v25 > 0.0
    v37 = xp.where(v36, v25, 1.0)
    v35 = v24 * xp.where(v26, v4, -xp.expm1(-v27 * v4) / xp.where(v26, 1.0, v27))
    v45 = v35 * xp.where(v36, xp.exp(-2.0 * (near + v4)), xp.exp(-2.0 * near) * far)
    v49 = v24 * (1.0 - half) / 2.0
    v50 = m - 4.0
    v51 = v50 == 0.0
    v52 = xp.absolute(v50)
    v61 = v50 > 0.0
    v62 = xp.where(v61, v50, 1.0)
    v60 = v49 * xp.where(v51, v4, -xp.expm1(-v52 * v4) / xp.where(v51, 1.0, v52))
    v46 = 0.0 + xp.where(v2, v4, -xp.expm1(-v5 * v4) / xp.where(v2, 1.0, v5)) * v21 + v45
    v74 = v49 * (2.0 - half) / 3.0
    v75 = m - 6.0
    v76 = v75 == 0.0
    v77 = xp.absolute(v75)
    v86 = v75 > 0.0
    v87 = xp.where(v86, v75, 1.0)
    v85 = v74 * xp.where(v76, v4, -xp.expm1(-v77 * v4) / xp.where(v76, 1.0, v77))
    v71 = v46 + v60 * xp.where(v61, xp.exp(-4.0 * (near + v4)), xp.exp(-4.0 * near) * far)
    v99 = v74 * (3.0 - half) / 4.0
    v100 = m - 8.0
    v101 = v100 == 0.0
    v102 = xp.absolute(v100)
    v111 = v100 > 0.0
    v112 = xp.where(v111, v100, 1.0)
    v110 = v99 * xp.where(v101, v4, -xp.expm1(-v102 * v4) / xp.where(v101, 1.0, v102))
    v120 = v110 * xp.where(v111, xp.exp(-8.0 * (near + v4)), xp.exp(-8.0 * near) * far)
    v96 = v71 + v85 * xp.where(v86, xp.exp(-6.0 * (near + v4)), xp.exp(-6.0 * near) * far)
    v124 = v99 * (4.0 - half) / 5.0
    v125 = m - 10.0
    v126 = v125 == 0.0
    v127 = xp.absolute(v125)
    v136 = v125 > 0.0
    v137 = xp.where(v136, v125, 1.0)
    v135 = v124 * xp.where(v126, v4, -xp.expm1(-v127 * v4) / xp.where(v126, 1.0, v127))
    v145 = v135 * xp.where(v136, xp.exp(-10.0 * (near + v4)), xp.exp(-10.0 * near) * far)
    v149 = v124 * (5.0 - half) / 6.0
    v150 = m - 12.0
    v151 = v150 == 0.0
    v152 = xp.absolute(v150)
    v161 = v150 > 0.0
    v162 = xp.where(v161, v150, 1.0)
    v160 = v149 * xp.where(v151, v4, -xp.expm1(-v152 * v4) / xp.where(v151, 1.0, v152))
    v170 = v160 * xp.where(v161, xp.exp(-12.0 * (near + v4)), xp.exp(-12.0 * near) * far)
    v174 = v149 * (6.0 - half) / 7.0
    v175 = m - 14.0
    v176 = v175 == 0.0
    v177 = xp.absolute(v175)
    v186 = v175 > 0.0
    v187 = xp.where(v186, v175, 1.0)
    v185 = v174 * xp.where(v176, v4, -xp.expm1(-v177 * v4) / xp.where(v176, 1.0, v177))
    v195 = v185 * xp.where(v186, xp.exp(-14.0 * (near + v4)), xp.exp(-14.0 * near) * far)
    v199 = v174 * (7.0 - half) / 8.0
    v200 = m - 16.0
    v201 = v200 == 0.0
    v202 = xp.absolute(v200)
    v211 = v200 > 0.0
    v212 = xp.where(v211, v200, 1.0)
    v210 = v199 * xp.where(v201, v4, -xp.expm1(-v202 * v4) / xp.where(v201, 1.0, v202))
    v220 = v210 * xp.where(v211, xp.exp(-16.0 * (near + v4)), xp.exp(-16.0 * near) * far)
    v224 = v199 * (8.0 - half) / 9.0
    v225 = m - 18.0
    v226 = v225 == 0.0
    v227 = xp.absolute(v225)
    v236 = v225 > 0.0
    v237 = xp.where(v236, v225, 1.0)
    v235 = v224 * xp.where(v226, v4, -xp.expm1(-v227 * v4) / xp.where(v226, 1.0, v227))
    v245 = v235 * xp.where(v236, xp.exp(-18.0 * (near + v4)), xp.exp(-18.0 * near) * far)
    v249 = v224 * (9.0 - half) / 10.0
    v250 = m - 20.0
    v251 = v250 == 0.0
    v252 = xp.absolute(v250)
    v261 = v250 > 0.0
    v262 = xp.where(v261, v250, 1.0)
    v260 = v249 * xp.where(v251, v4, -xp.expm1(-v252 * v4) / xp.where(v251, 1.0, v252))
    v270 = v260 * xp.where(v261, xp.exp(-20.0 * (near + v4)), xp.exp(-20.0 * near) * far)
    v274 = v249 * (10.0 - half) / 11.0
    v275 = m - 22.0
    v276 = v275 == 0.0
    v277 = xp.absolute(v275)
    v286 = v275 > 0.0
    v287 = xp.where(v286, v275, 1.0)
    v285 = v274 * xp.where(v276, v4, -xp.expm1(-v277 * v4) / xp.where(v276, 1.0, v277))
    v295 = v285 * xp.where(v286, xp.exp(-22.0 * (near + v4)), xp.exp(-22.0 * near) * far)
    v299 = v274 * (11.0 - half) / 12.0
    v300 = m - 24.0
    v301 = v300 == 0.0
    v302 = xp.absolute(v300)
    v311 = v300 > 0.0
    v312 = xp.where(v311, v300, 1.0)
    v310 = v299 * xp.where(v301, v4, -xp.expm1(-v302 * v4) / xp.where(v301, 1.0, v302))
    v320 = v310 * xp.where(v311, xp.exp(-24.0 * (near + v4)), xp.exp(-24.0 * near) * far)
    v324 = v299 * (12.0 - half) / 13.0
    v325 = m - 26.0
    v326 = v325 == 0.0
    v327 = xp.absolute(v325)
    v336 = v325 > 0.0
    v337 = xp.where(v336, v325, 1.0)
    v335 = v324 * xp.where(v326, v4, -xp.expm1(-v327 * v4) / xp.where(v326, 1.0, v327))
    v345 = v335 * xp.where(v336, xp.exp(-26.0 * (near + v4)), xp.exp(-26.0 * near) * far)
    v349 = v324 * (13.0 - half) / 14.0
    v350 = m - 28.0
    v351 = v350 == 0.0
    v352 = xp.absolute(v350)
    v361 = v350 > 0.0
    v362 = xp.where(v361, v350, 1.0)
    v360 = v349 * xp.where(v351, v4, -xp.expm1(-v352 * v4) / xp.where(v351, 1.0, v352))
    v346 = v96 + v120 + v145 + v170 + v195 + v220 + v245 + v270 + v295 + v320 + v345
    v370 = v360 * xp.where(v361, xp.exp(-28.0 * (near + v4)), xp.exp(-28.0 * near) * far)
    v374 = v349 * (14.0 - half) / 15.0
    v375 = m - 30.0
    v376 = v375 == 0.0
    v377 = xp.absolute(v375)
    v386 = v375 > 0.0
    v387 = xp.where(v386, v375, 1.0)
    v385 = v374 * xp.where(v376, v4, -xp.expm1(-v377 * v4) / xp.where(v376, 1.0, v377))
    v395 = v385 * xp.where(v386, xp.exp(-30.0 * (near + v4)), xp.exp(-30.0 * near) * far)
    v399 = v374 * (15.0 - half) / 16.0
    v400 = m - 32.0
    v401 = v400 == 0.0
    v402 = xp.absolute(v400)
    v411 = v400 > 0.0
    v412 = xp.where(v411, v400, 1.0)
    v410 = v399 * xp.where(v401, v4, -xp.expm1(-v402 * v4) / xp.where(v401, 1.0, v402))
    v420 = v410 * xp.where(v411, xp.exp(-32.0 * (near + v4)), xp.exp(-32.0 * near) * far)
    v424 = v399 * (16.0 - half) / 17.0
    v425 = m - 34.0
    v426 = v425 == 0.0
    v427 = xp.absolute(v425)
    v436 = v425 > 0.0
    v437 = xp.where(v436, v425, 1.0)
    v435 = v424 * xp.where(v426, v4, -xp.expm1(-v427 * v4) / xp.where(v426, 1.0, v427))
    v445 = v435 * xp.where(v436, xp.exp(-34.0 * (near + v4)), xp.exp(-34.0 * near) * far)
    v449 = v424 * (17.0 - half) / 18.0
    v450 = m - 36.0
    v451 = v450 == 0.0
    v452 = xp.absolute(v450)
    v461 = v450 > 0.0
    v462 = xp.where(v461, v450, 1.0)
    v460 = v449 * xp.where(v451, v4, -xp.expm1(-v452 * v4) / xp.where(v451, 1.0, v452))
    v470 = v460 * xp.where(v461, xp.exp(-36.0 * (near + v4)), xp.exp(-36.0 * near) * far)
    v474 = v449 * (18.0 - half) / 19.0
    v475 = m - 38.0
    v476 = v475 == 0.0
    v477 = xp.absolute(v475)
    v486 = v475 > 0.0
    v487 = xp.where(v486, v475, 1.0)
    v485 = v474 * xp.where(v476, v4, -xp.expm1(-v477 * v4) / xp.where(v476, 1.0, v477))
    v495 = v485 * xp.where(v486, xp.exp(-38.0 * (near + v4)), xp.exp(-38.0 * near) * far)
    v499 = v474 * (19.0 - half) / 20.0
    v500 = m - 40.0
    v501 = v500 == 0.0
    v502 = xp.absolute(v500)
    v511 = v500 > 0.0
    v512 = xp.where(v511, v500, 1.0)
    v510 = v499 * xp.where(v501, v4, -xp.expm1(-v502 * v4) / xp.where(v501, 1.0, v502))
    v520 = v510 * xp.where(v511, xp.exp(-40.0 * (near + v4)), xp.exp(-40.0 * near) * far)
    v525 = m - 42.0
    v526 = v525 == 0.0
    v527 = xp.absolute(v525)
    v534 = xp.where(v526, v4, -xp.expm1(-v527 * v4) / xp.where(v526, 1.0, v527))
    v536 = v525 > 0.0
    v537 = xp.where(v536, v525, 1.0)
    v544 = xp.where(v536, xp.exp(-42.0 * (near + v4)), xp.exp(-42.0 * near) * far)
    v521 = v346 + v370 + v395 + v420 + v445 + v470 + v495 + v520
    return v521 + v499 * (20.0 - half) / 21.0 * v534 * v544


def power_growth(xp, r, a, n, k):
    v1 = r > 0.0
    v2 = xp.where(v1, r, 1.0)
    v5 = xp.log1p((a - v2) / v2)
    v10 = xp.where(xp.isfinite(v5), v5, xp.log(a) - xp.log(v2))
    v11 = xp.minimum(v10, 1.0)
    v12 = axis_power(xp, n, k)
    v13 = xp.absolute(v12)
    v16 = xp.minimum(v11, 20.0 / xp.maximum(v13, 1e-300))
    v17 = v10 - v16
    v18 = v17 > 0.0
    v19 = xp.where(v18, v17, 1.0)
    v23 = xp.minimum(v2 / a * xp.exp(v16), 1.0)
    v30 = (k + 1.0) / 2.0
    v33, v34 = weighted_along(xp, v30, r, a, n, k)
    v35 = v33 * v16
    v36 = v35 > 0.0
    v37 = xp.where(v36, v35, 1.0)
    v41 = v37 > 0.0
    v44 = -xp.expm1(-2.0 * v37) / xp.where(v41, xp.where(v41, v37, 1.0), 1.0)
    v53 = xp.where(v36, v44, 2.0) ** ((k - 1.0) / 2.0) * xp.exp(-v12 * (v16 - v35))
    v32 = xp.where(v18, v23 ** n / v23 * v23 ** k, 1.0) * v16 ** v30
    v56 = v13 > 20.0
    v60 = xp.minimum(v11, 20.0 / xp.maximum(xp.where(v56, v13, 2.0 * 20.0), 1e-300))
    v68 = xp.minimum(v11, 20.0 / xp.maximum(xp.where(v56, 0.5 * 20.0, v13), 1e-300))
    v75 = xp.minimum(v2 / a * xp.exp(v68), 1.0)
    v80 = tail(xp, v10 - v68, v68, v12, (k - 1.0) / 2.0, v75 ** n / v75 * v75 ** k)
    v81 = xp.where(v56, steep(xp, v10 - v60, v60, v12, (k - 1.0) / 2.0), v80)
    v83 = axis_power(xp, n, k)
    v84 = v83 > 0.0
    v85 = xp.where(v84, v83, 1.0)
    v86 = v85 > 0.0
    v90 = xp.where(v84, 1.0 / xp.where(v86, xp.where(v86, v85, 1.0), 1.0), xp.inf)
    return xp.where(v1, v32 * xp.sum(v34 * v53, axis=0) + v81, v90)


def power_pressure(xp, r, a, n, k):
    v9 = power_factor(xp, n, k) * n * (a ** n / a * a ** k) * power_growth(xp, r, a, n, k)
    return v9


def cornered(xp, value, r, a, b, k):
    return xp.where((r == b) & (a > b) & (k <= 0.0), xp.inf, value)


def rim_pressure(xp, r, a, b, k):
    v80, v81 = nodes_along(xp, 1, r, a, b, k)
    v2 = r - b
    v3 = v2 < 0.0
    v7 = xp.maximum(a - b, 0.0) * (a + b)
    v8 = v7 > 0.0
    v11 = xp.where(v8, xp.sqrt(xp.where(v8, v7, 1.0)), 0.0)
    v12 = xp.where(v3, 1.0, v2)
    v14 = xp.where(v3, v11, difference_root(xp, a, r))
    v15 = v14 > 0.0
    v16 = (r == b) & v15
    v17 = 2.0 * k
    v18 = v17 + 0.0
    v19 = v18 > 0.0
    v21 = xp.where(v19, xp.where(v19, v18, 1.0), 1.0)
    v22 = v21 - 1.0
    v24 = xp.where(v16, v14, b)
    v27 = xp.minimum(xp.arcsinh(v24 / b), 3.0)
    v29, v30 = weighted_along(xp, v21, r, a, b, k)
    v31 = v29 * v27
    v33 = b * xp.cosh(v31)
    v34 = 1.0 - k
    v40 = xp.maximum(b * xp.sinh(v31), 1e-09 * b)
    v49 = v33 * (v34 / (1.0 + k) * (v40 / v33) ** 2.0 + 1.0) * v33 ** v34 / v40 ** 0.0
    v54 = raised(xp, v27, v22) * xp.sum(v30 * (v49 * sinh_over(xp, v31) ** v22), axis=0)
    v57 = b * xp.sinh(v27)
    v58 = v24 > v57
    v59 = xp.where(v58, v24, 2.0 * v57)
    v65 = b * xp.sinh(xp.minimum(xp.arcsinh(v59 / b), 3.0))
    v66 = v59 > v65
    v73 = xp.where(v66, 0.5 * v65, v59)
    v72 = b * xp.sinh(xp.minimum(xp.arcsinh(xp.where(v66, v59, 2.0 * v65) / b), 3.0))
    v78 = xp.where(v58, 0.5 * v57, v24)
    v79 = xp.where(v58, xp.log(xp.sqrt(v59) / xp.sqrt(xp.where(v66, v72, 1.0))), 0.0)
    v84 = v57 * xp.exp(v80 * v79)
    v86 = xp.hypot(b, v84)
    v87 = 1.0 - k
    v91 = xp.maximum(v84, 1e-09 * b)
    v100 = v86 * (v87 / (1.0 + k) * (v91 / v86) ** 2.0 + 1.0) * v86 ** v87 / v91 ** 0.0
    v108 = v24 * xp.exp(-(v80 * v79))
    v110 = xp.hypot(b, v108)
    v111 = 1.0 - k
    v115 = xp.maximum(v108, 1e-09 * b)
    v124 = v110 * (v111 / (1.0 + k) * (v115 / v110) ** 2.0 + 1.0) * v110 ** v111 / v115 ** 0.0
    v128 = v79 * xp.sum(v81 * (v108 ** v22 * v124 * (v108 / v110)), axis=0)
    v131 = xp.where(v15, v14, 1.0)
    v132 = v2 == 0.0
    v138 = xp.exp(-37.0 / xp.minimum(xp.maximum(0.0 + v17, 0.107), 2.0))
    v141 = r + b
    v143 = xp.sqrt(xp.absolute(v2) * v141)
    v144 = xp.where(v132, xp.minimum(b, v131) * v138, v143)
    v148 = xp.minimum(xp.arcsinh(v131 / v144), 3.0)
    v150 = 1.0 + k
    v151, v152 = weighted_along(xp, v150, r, a, b, k)
    v153 = v151 * v148
    v156 = xp.where(v3, 1.0, v2)
    v158 = v156 < 0.0
    v159 = xp.where(v158, 1.0, v156)
    v163 = xp.minimum(b, xp.where(v158, v11, difference_root(xp, a, r))) * v138
    v169 = xp.where(v156 == 0.0, v163, xp.sqrt(xp.absolute(v156) * v141)) * xp.cosh(v153)
    v170 = xp.where(v3, v144 * xp.sinh(v153), v169)
    v171 = xp.hypot(b, v170)
    v178 = v171 * ((1.0 - k) / v150 * (v170 / v171) ** 2.0 + 1.0)
    v186 = v178 * (v144 * xp.cosh(v153) / v171) ** k * sinh_over(xp, v153) ** k
    v191 = v144 * xp.sinh(v148)
    v192 = v131 > v191
    v193 = xp.where(v192, v131, 2.0 * v191)
    v197 = xp.where(v132, xp.minimum(b, v193) * v138, v143)
    v202 = v197 * xp.sinh(xp.minimum(xp.arcsinh(v193 / v197), 3.0))
    v203 = v193 > v202
    v204 = xp.where(v203, v193, 2.0 * v202)
    v207 = xp.where(v132, xp.minimum(b, v204) * v138, v143)
    v213 = xp.where(v203, 0.5 * v202, v193)
    v215 = xp.sqrt(xp.where(v203, v207 * xp.sinh(xp.minimum(xp.arcsinh(v204 / v207), 3.0)), 1.0))
    v218 = xp.where(v192, 0.5 * v191, v131)
    v219 = xp.where(v192, xp.log(xp.sqrt(v193) / v215), 0.0)
    v221 = xp.exp(v80 * v219)
    v222 = v191 * v221
    v224 = xp.where(v3, 1.0, v2)
    v226 = v224 < 0.0
    v227 = xp.where(v226, 1.0, v224)
    v229 = xp.where(v226, v11, difference_root(xp, a, r))
    v235 = xp.where(v224 == 0.0, xp.minimum(b, v229) * v138, xp.sqrt(xp.absolute(v224) * v141))
    v242 = xp.hypot(v235, v235 * xp.sinh(xp.minimum(xp.arcsinh(v229 / v235), 3.0)) * v221)
    v243 = xp.where(v3, v222, v242)
    v244 = xp.hypot(b, v243)
    v252 = xp.hypot(v144, v222)
    v255 = v244 * ((1.0 - k) / v150 * (v243 / v244) ** 2.0 + 1.0) * (v252 / v244) ** k
    v262 = xp.exp(-(v80 * v219))
    v263 = v131 * v262
    v265 = xp.where(v3, 1.0, v2)
    v267 = v265 < 0.0
    v268 = xp.where(v267, 1.0, v265)
    v270 = xp.where(v267, v11, difference_root(xp, a, r))
    v276 = xp.where(v265 == 0.0, xp.minimum(b, v270) * v138, xp.sqrt(xp.absolute(v265) * v141))
    v279 = xp.where(v3, v263, xp.hypot(v276, v270 * v262))
    v280 = xp.hypot(b, v279)
    v288 = xp.hypot(v144, v263)
    v291 = v280 * ((1.0 - k) / v150 * (v279 / v280) ** 2.0 + 1.0) * (v288 / v280) ** k
    v295 = v219 * xp.sum(v81 * (v263 ** k * v291 * (v263 / v288)), axis=0)
    v296 = v219 * xp.sum(v81 * (v222 ** k * v255 * (v222 / v252)), axis=0) + v295
    v297 = v144 ** k * (raised(xp, v148, k) * xp.sum(v152 * v186, axis=0)) + v296
    v130 = b ** v22 * v54 + (v79 * xp.sum(v81 * (v84 ** v22 * v100 * (v84 / v86)), axis=0) + v128)
    return cornered(xp, xp.where(v16, v130, xp.where(v15, v297, 0.0)), r, a, b, k)


def sphere(xp, r, R, reach, end, k):
    v31, v32 = nodes_along(xp, 1, r, R, reach, end, k)
    v1 = end > 0.0
    v4 = xp.maximum(r, 8.673617379884035e-19 * reach)
    v5 = difference_root(xp, R, v4)
    v8 = xp.arcsinh(reach / xp.where(v1, end, 1.0))
    v9 = xp.minimum(v8, 8.0)
    v12, v13 = weighted_along(xp, 1.0 + k, r, R, reach, end, k)
    v14 = v12 * v9
    v17 = xp.hypot(v4, v5 * xp.tanh(v14))
    v18 = xp.cosh(v14)
    v25 = sphere_rate(xp, v17, v5 / v18, k) / v17 * (sinh_over(xp, v14) / v18) ** k
    v30 = v8 - v9
    v34 = v9 + v31 * v30
    v37 = xp.hypot(v4, v5 * xp.tanh(v34))
    v38 = xp.cosh(v34)
    v45 = sphere_rate(xp, v37, v5 / v38, k) / v37 * (sinh_over(xp, v34) / v38) ** k
    v29 = raised(xp, v9, k) * xp.sum(v13 * (v25 / v18 ** 2.0), axis=0)
    v52 = raised(xp, v5, k) * (v29 + v30 * xp.sum(v32 * (v45 / v38 ** 2.0 * v34 ** k), axis=0))
    return xp.where(v1, v52, xp.inf)


def gaussian_pressure(xp, r, a, s, k):
    v2 = xp.maximum(r, 8.673617379884035e-19 * a)
    v3 = difference_root(xp, a, v2)
    v6, v7 = weighted_along(xp, 1.0 + k, r, a, s, k)
    v8 = v6 * v3
    v12 = xp.sqrt(v2 * v2 + v8 * v8)
    return raised(xp, v3, k) * xp.sum(v7 * (gaussian_rate(xp, v12, s, k) / v12), axis=0)


def hyperboloid_pressure(xp, r, a, b, k):
    v52, v53 = nodes_along(xp, 1, r, a, b, k)
    v2 = xp.maximum(r, 8.673617379884035e-19 * a)
    v3 = xp.hypot(v2, b)
    v5 = difference_root(xp, a, v2)
    v8 = xp.minimum(xp.arcsinh(v5 / v3), 3.0)
    v11, v12 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v13 = v11 * v8
    v16 = xp.hypot(v2, v3 * xp.sinh(v13))
    v24 = hyperboloid_rate(xp, v16, b, k) / v16 * (v3 * xp.cosh(v13)) * sinh_over(xp, v13) ** k
    v29 = v3 * xp.sinh(v8)
    v30 = v5 > v29
    v31 = xp.where(v30, v5, 2.0 * v29)
    v37 = v3 * xp.sinh(xp.minimum(xp.arcsinh(v31 / v3), 3.0))
    v38 = v31 > v37
    v45 = xp.where(v38, 0.5 * v37, v31)
    v44 = v3 * xp.sinh(xp.minimum(xp.arcsinh(xp.where(v38, v31, 2.0 * v37) / v3), 3.0))
    v50 = xp.where(v30, 0.5 * v29, v5)
    v51 = xp.where(v30, xp.log(xp.sqrt(v31) / xp.sqrt(xp.where(v38, v44, 1.0))), 0.0)
    v56 = v29 * xp.exp(v52 * v51)
    v58 = xp.hypot(v2, v56)
    v61 = xp.hypot(v3, v56)
    v65 = v56 ** k * (hyperboloid_rate(xp, v58, b, k) / v58 * v61) * (v56 / v61)
    v70 = v5 * xp.exp(-(v52 * v51))
    v72 = xp.hypot(v2, v70)
    v75 = xp.hypot(v3, v70)
    v79 = v70 ** k * (hyperboloid_rate(xp, v72, b, k) / v72 * v75) * (v70 / v75)
    v81 = v51 * xp.sum(v53 * v65, axis=0) + v51 * xp.sum(v53 * v79, axis=0)
    return v3 ** k * (raised(xp, v8, k) * xp.sum(v12 * v24, axis=0)) + v81


def rounded_at(xp, a, b, k):
    v67, v68 = nodes_along(xp, 1, a, b, k)
    v1 = difference_root(xp, a, b)
    v2 = xp.minimum(v1, b)
    v9 = 2.0 * k + 2.0
    v10 = v9 > 0.0
    v12 = xp.where(v10, xp.where(v10, v9, 1.0), 1.0)
    v13 = v12 - 1.0
    v17 = xp.minimum(xp.arcsinh(v2 / b), 3.0)
    v19, v20 = weighted_along(xp, v12, a, b, k)
    v21 = v19 * v17
    v25 = xp.maximum(b * xp.sinh(v21), 1e-09 * b)
    v27 = b * xp.cosh(v21)
    v29 = 1.0 - k
    v36 = (v25 / v27) ** v29 * rounding_rate(xp, v27, v25, b, k) * v27 ** v29 / v25 ** 2.0
    v41 = raised(xp, v17, v13) * xp.sum(v20 * (v36 * sinh_over(xp, v21) ** v13), axis=0)
    v44 = b * xp.sinh(v17)
    v45 = v2 > v44
    v46 = xp.where(v45, v2, 2.0 * v44)
    v52 = b * xp.sinh(xp.minimum(xp.arcsinh(v46 / b), 3.0))
    v53 = v46 > v52
    v60 = xp.where(v53, 0.5 * v52, v46)
    v59 = b * xp.sinh(xp.minimum(xp.arcsinh(xp.where(v53, v46, 2.0 * v52) / b), 3.0))
    v65 = xp.where(v45, 0.5 * v44, v2)
    v66 = xp.where(v45, xp.log(xp.sqrt(v46) / xp.sqrt(xp.where(v53, v59, 1.0))), 0.0)
    v71 = v44 * xp.exp(v67 * v66)
    v74 = xp.maximum(v71, 1e-09 * b)
    v75 = xp.hypot(b, v71)
    v77 = 1.0 - k
    v84 = (v74 / v75) ** v77 * rounding_rate(xp, v75, v74, b, k) * v75 ** v77 / v74 ** 2.0
    v92 = v2 * xp.exp(-(v67 * v66))
    v95 = xp.maximum(v92, 1e-09 * b)
    v96 = xp.hypot(b, v92)
    v98 = 1.0 - k
    v105 = (v95 / v96) ** v98 * rounding_rate(xp, v96, v95, b, k) * v96 ** v98 / v95 ** 2.0
    v109 = v66 * xp.sum(v68 * (v92 ** v13 * v105 * (v92 / v96)), axis=0)
    v111 = b ** v13 * v41 + (v66 * xp.sum(v68 * (v71 ** v13 * v84 * (v71 / v75)), axis=0) + v109)
    v114 = v1 > v2
    v115 = xp.where(v114, v1, 2.0 * v2)
    v117 = xp.minimum(v115, b)
    v118 = v115 > v117
    v121 = xp.where(v118, 0.5 * v117, v115)
    v123 = xp.sqrt(xp.where(v118, xp.minimum(xp.where(v118, v115, 2.0 * v117), b), 1.0))
    v126 = xp.where(v114, 0.5 * v2, v1)
    v127 = xp.where(v114, xp.log(xp.sqrt(v115) / v123), 0.0)
    v130 = v2 * xp.exp(v67 * v127)
    v132 = xp.hypot(b, v130)
    v136 = v130 ** k * rounded_rate(xp, v132, v130, b, k) * (v130 / v132)
    v141 = v1 * xp.exp(-(v67 * v127))
    v143 = xp.hypot(b, v141)
    v147 = v141 ** k * rounded_rate(xp, v143, v141, b, k) * (v141 / v143)
    v149 = v127 * xp.sum(v68 * v136, axis=0) + v127 * xp.sum(v68 * v147, axis=0)
    return (2.0 * raised(xp, v2, k) / (1.0 + k) ** 2.0 - v111) / b + v149


def rounded_pressure(xp, r, a, b, k):
    v50, v51 = nodes_along(xp, 1, r, a, b, k)
    v3 = (r == b) & (a > b)
    v4 = 2.0 * b
    v7 = r < b
    v13 = xp.where(v7, 2.0 * b, r)
    v12 = power_pressure(xp, xp.minimum(xp.where(v7, r, 0.5 * b), b), xp.minimum(a, b), 2.0, k) / v4
    v15 = r - b
    v16 = v15 < 0.0
    v20 = xp.maximum(a - b, 0.0) * (a + b)
    v21 = v20 > 0.0
    v24 = xp.where(v21, xp.sqrt(xp.where(v21, v20, 1.0)), 0.0)
    v25 = xp.where(v16, 1.0, v15)
    v27 = xp.where(v16, v24, difference_root(xp, a, r))
    v28 = v27 > 0.0
    v29 = xp.where(v28, v27, 1.0)
    v30 = v15 == 0.0
    v37 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v40 = r + b
    v42 = xp.sqrt(xp.absolute(v15) * v40)
    v43 = xp.where(v30, xp.minimum(b, v29) * v37, v42)
    v49 = xp.minimum(xp.arcsinh(v29 / v43), 3.0 * xp.minimum(1.0, xp.inf / v43))
    v52 = v50 * 1.0
    v55 = v49 * (v52 * v52 ** 2.0)
    v57 = v43 * xp.sinh(v55)
    v58 = xp.hypot(b, v57)
    v67 = rounded_rate(xp, v58, v57, b, k) * v57 / v58 * (v43 * xp.cosh(v55)) ** k * 3.0 * v52
    v72 = v43 * xp.sinh(v49)
    v73 = v29 > v72
    v74 = xp.where(v73, v29, 2.0 * v72)
    v78 = xp.where(v30, xp.minimum(b, v74) * v37, v42)
    v86 = v78 * xp.sinh(xp.minimum(xp.arcsinh(v74 / v78), 3.0 * xp.minimum(1.0, xp.inf / v78)))
    v87 = v74 > v86
    v88 = xp.where(v87, v74, 2.0 * v86)
    v91 = xp.where(v30, xp.minimum(b, v88) * v37, v42)
    v100 = xp.where(v87, 0.5 * v86, v74)
    v99 = v91 * xp.sinh(xp.minimum(xp.arcsinh(v88 / v91), 3.0 * xp.minimum(1.0, xp.inf / v91)))
    v105 = xp.where(v73, 0.5 * v72, v29)
    v106 = xp.where(v73, xp.log(xp.sqrt(v74) / xp.sqrt(xp.where(v87, v99, 1.0))), 0.0)
    v109 = v72 * xp.exp(v50 * v106)
    v110 = xp.hypot(b, v109)
    v114 = xp.hypot(v43, v109)
    v118 = rounded_rate(xp, v110, v109, b, k) * v109 / v110 * v114 ** k * (v109 / v114)
    v123 = v29 * xp.exp(-(v50 * v106))
    v124 = xp.hypot(b, v123)
    v128 = xp.hypot(v43, v123)
    v132 = rounded_rate(xp, v124, v123, b, k) * v123 / v124 * v128 ** k * (v123 / v128)
    v134 = v106 * xp.sum(v51 * v118, axis=0) + v106 * xp.sum(v51 * v132, axis=0)
    v136 = xp.where(v16, 1.0, v15)
    v137 = v136 == 0.0
    v138 = v136 < 0.0
    v139 = xp.where(v138, 1.0, v136)
    v141 = xp.where(v138, v24, difference_root(xp, a, r))
    v146 = xp.sqrt(xp.absolute(v136) * v40)
    v147 = xp.where(v137, xp.minimum(b, v141) * v37, v146)
    v151 = xp.minimum(xp.arcsinh(v141 / v147), 3.0)
    v154, v155 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v156 = v154 * v151
    v158 = v147 * xp.cosh(v156)
    v159 = xp.hypot(b, v158)
    v165 = rounded_rate(xp, v159, v158, b, k) * v158 / v159 * sinh_over(xp, v156) ** k
    v170 = v147 * xp.sinh(v151)
    v171 = v141 > v170
    v172 = xp.where(v171, v141, 2.0 * v170)
    v176 = xp.where(v137, xp.minimum(b, v172) * v37, v146)
    v181 = v176 * xp.sinh(xp.minimum(xp.arcsinh(v172 / v176), 3.0))
    v182 = v172 > v181
    v183 = xp.where(v182, v172, 2.0 * v181)
    v186 = xp.where(v137, xp.minimum(b, v183) * v37, v146)
    v192 = xp.where(v182, 0.5 * v181, v172)
    v194 = xp.sqrt(xp.where(v182, v186 * xp.sinh(xp.minimum(xp.arcsinh(v183 / v186), 3.0)), 1.0))
    v197 = xp.where(v171, 0.5 * v170, v141)
    v198 = xp.where(v171, xp.log(xp.sqrt(v172) / v194), 0.0)
    v201 = v170 * xp.exp(v50 * v198)
    v203 = xp.hypot(v147, v201)
    v204 = xp.hypot(b, v203)
    v210 = v201 ** k * (rounded_rate(xp, v204, v203, b, k) * v203 / v204) * (v201 / v203)
    v215 = v141 * xp.exp(-(v50 * v198))
    v217 = xp.hypot(v147, v215)
    v218 = xp.hypot(b, v217)
    v224 = v215 ** k * (rounded_rate(xp, v218, v217, b, k) * v217 / v218) * (v215 / v217)
    v226 = v198 * xp.sum(v51 * v210, axis=0) + v198 * xp.sum(v51 * v224, axis=0)
    v227 = v147 ** k * (raised(xp, v151, k) * xp.sum(v155 * v165, axis=0)) + v226
    v228 = xp.where(v16, v49 * (1.0 * xp.sum(v51 * (v67 * v52), axis=0)) + v134, v227)
    v230 = xp.where(v7, v12, 0.0) + xp.where(v28, v228, 0.0)
    return xp.where(v3, rounded_at(xp, xp.where(v3, a, v4), b, k), v230)


def rounding_pressure(xp, r, a, b, k):
    v77, v78 = nodes_along(xp, 1, r, a, b, k)
    v2 = r - b
    v3 = v2 < 0.0
    v7 = xp.maximum(a - b, 0.0) * (a + b)
    v8 = v7 > 0.0
    v11 = xp.where(v8, xp.sqrt(xp.where(v8, v7, 1.0)), 0.0)
    v12 = xp.where(v3, 1.0, v2)
    v14 = xp.where(v3, v11, difference_root(xp, a, r))
    v15 = v14 > 0.0
    v16 = (r == b) & v15
    v17 = 2.0 * k
    v18 = v17 + 2.0
    v19 = v18 > 0.0
    v21 = xp.where(v19, xp.where(v19, v18, 1.0), 1.0)
    v22 = v21 - 1.0
    v24 = xp.where(v16, v14, b)
    v27 = xp.minimum(xp.arcsinh(v24 / b), 3.0)
    v29, v30 = weighted_along(xp, v21, r, a, b, k)
    v31 = v29 * v27
    v35 = xp.maximum(b * xp.sinh(v31), 1e-09 * b)
    v37 = b * xp.cosh(v31)
    v39 = 1.0 - k
    v46 = (v35 / v37) ** v39 * rounding_rate(xp, v37, v35, b, k) * v37 ** v39 / v35 ** 2.0
    v51 = raised(xp, v27, v22) * xp.sum(v30 * (v46 * sinh_over(xp, v31) ** v22), axis=0)
    v54 = b * xp.sinh(v27)
    v55 = v24 > v54
    v56 = xp.where(v55, v24, 2.0 * v54)
    v62 = b * xp.sinh(xp.minimum(xp.arcsinh(v56 / b), 3.0))
    v63 = v56 > v62
    v70 = xp.where(v63, 0.5 * v62, v56)
    v69 = b * xp.sinh(xp.minimum(xp.arcsinh(xp.where(v63, v56, 2.0 * v62) / b), 3.0))
    v75 = xp.where(v55, 0.5 * v54, v24)
    v76 = xp.where(v55, xp.log(xp.sqrt(v56) / xp.sqrt(xp.where(v63, v69, 1.0))), 0.0)
    v81 = v54 * xp.exp(v77 * v76)
    v84 = xp.maximum(v81, 1e-09 * b)
    v85 = xp.hypot(b, v81)
    v87 = 1.0 - k
    v94 = (v84 / v85) ** v87 * rounding_rate(xp, v85, v84, b, k) * v85 ** v87 / v84 ** 2.0
    v102 = v24 * xp.exp(-(v77 * v76))
    v105 = xp.maximum(v102, 1e-09 * b)
    v106 = xp.hypot(b, v102)
    v108 = 1.0 - k
    v113 = (v105 / v106) ** v108 * rounding_rate(xp, v106, v105, b, k) * v106 ** v108
    v119 = v76 * xp.sum(v78 * (v102 ** v22 * (v113 / v105 ** 2.0) * (v102 / v106)), axis=0)
    v122 = xp.where(v15, v14, 1.0)
    v123 = v2 == 0.0
    v129 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + v17, 0.107), 2.0))
    v132 = r + b
    v134 = xp.sqrt(xp.absolute(v2) * v132)
    v135 = xp.where(v123, xp.minimum(b, v122) * v129, v134)
    v139 = xp.minimum(xp.arcsinh(v122 / v135), 3.0)
    v142, v143 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v144 = v142 * v139
    v147 = xp.where(v3, 1.0, v2)
    v149 = v147 < 0.0
    v150 = xp.where(v149, 1.0, v147)
    v154 = xp.minimum(b, xp.where(v149, v11, difference_root(xp, a, r))) * v129
    v160 = xp.where(v147 == 0.0, v154, xp.sqrt(xp.absolute(v147) * v132)) * xp.cosh(v144)
    v161 = xp.where(v3, v135 * xp.sinh(v144), v160)
    v162 = xp.hypot(b, v161)
    v167 = (v161 / v162) ** (1.0 - k) * rounding_rate(xp, v162, v161, b, k)
    v175 = v167 * (v135 * xp.cosh(v144) / v162) ** k * sinh_over(xp, v144) ** k
    v180 = v135 * xp.sinh(v139)
    v181 = v122 > v180
    v182 = xp.where(v181, v122, 2.0 * v180)
    v186 = xp.where(v123, xp.minimum(b, v182) * v129, v134)
    v191 = v186 * xp.sinh(xp.minimum(xp.arcsinh(v182 / v186), 3.0))
    v192 = v182 > v191
    v193 = xp.where(v192, v182, 2.0 * v191)
    v196 = xp.where(v123, xp.minimum(b, v193) * v129, v134)
    v202 = xp.where(v192, 0.5 * v191, v182)
    v204 = xp.sqrt(xp.where(v192, v196 * xp.sinh(xp.minimum(xp.arcsinh(v193 / v196), 3.0)), 1.0))
    v207 = xp.where(v181, 0.5 * v180, v122)
    v208 = xp.where(v181, xp.log(xp.sqrt(v182) / v204), 0.0)
    v210 = xp.exp(v77 * v208)
    v211 = v180 * v210
    v213 = xp.where(v3, 1.0, v2)
    v215 = v213 < 0.0
    v216 = xp.where(v215, 1.0, v213)
    v218 = xp.where(v215, v11, difference_root(xp, a, r))
    v224 = xp.where(v213 == 0.0, xp.minimum(b, v218) * v129, xp.sqrt(xp.absolute(v213) * v132))
    v231 = xp.hypot(v224, v224 * xp.sinh(xp.minimum(xp.arcsinh(v218 / v224), 3.0)) * v210)
    v232 = xp.where(v3, v211, v231)
    v233 = xp.hypot(b, v232)
    v239 = xp.hypot(v135, v211)
    v242 = (v232 / v233) ** (1.0 - k) * rounding_rate(xp, v233, v232, b, k) * (v239 / v233) ** k
    v249 = xp.exp(-(v77 * v208))
    v250 = v122 * v249
    v252 = xp.where(v3, 1.0, v2)
    v254 = v252 < 0.0
    v255 = xp.where(v254, 1.0, v252)
    v257 = xp.where(v254, v11, difference_root(xp, a, r))
    v263 = xp.where(v252 == 0.0, xp.minimum(b, v257) * v129, xp.sqrt(xp.absolute(v252) * v132))
    v266 = xp.where(v3, v250, xp.hypot(v263, v257 * v249))
    v267 = xp.hypot(b, v266)
    v273 = xp.hypot(v135, v250)
    v276 = (v266 / v267) ** (1.0 - k) * rounding_rate(xp, v267, v266, b, k) * (v273 / v267) ** k
    v280 = v208 * xp.sum(v78 * (v250 ** k * v276 * (v250 / v273)), axis=0)
    v281 = v208 * xp.sum(v78 * (v211 ** k * v242 * (v211 / v239)), axis=0) + v280
    v282 = v135 ** k * (raised(xp, v139, k) * xp.sum(v143 * v175, axis=0)) + v281
    v121 = b ** v22 * v51 + (v76 * xp.sum(v78 * (v81 ** v22 * v94 * (v81 / v85)), axis=0) + v119)
    return xp.where(v16, v121, xp.where(v15, v282, 0.0))


def tipped_pressure(xp, r, a, R, b, end, k):
    v54, v55 = nodes_along(xp, 1, r, a, R, b, end, k)
    v1 = past_tip(xp, r, R, b, end)
    v2 = v1 < 0.0
    v4 = past_tip(xp, a, R, b, end)
    v5 = v4 >= 0.0
    v6 = xp.where(v5, v4, 1.0)
    v10 = xp.maximum(-v1, 0.0) * (b + r)
    v11 = v10 > 0.0
    v15 = difference_root(xp, a, r)
    v17 = xp.where(v5, v4, 1.0)
    v16 = xp.where(v5, xp.where(v11, xp.sqrt(xp.where(v11, v10, 1.0)), 0.0), v15)
    v21 = xp.where(v2, 1.0, v1)
    v20 = sphere(xp, xp.minimum(r, b), R, v16, xp.where(v5, end, difference_root(xp, R, a)), k)
    v25 = xp.maximum(v4, 0.0) * (a + b)
    v26 = v25 > 0.0
    v29 = xp.where(v26, xp.sqrt(xp.where(v26, v25, 1.0)), 0.0)
    v30 = xp.where(v2, 1.0, v1)
    v31 = xp.where(v2, v29, v15)
    v32 = v31 > 0.0
    v33 = xp.where(v32, v31, 1.0)
    v34 = v1 == 0.0
    v41 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + 2.0 * k, 0.107), 2.0))
    v44 = r + b
    v46 = xp.sqrt(xp.absolute(v1) * v44)
    v47 = xp.where(v34, xp.minimum(b, v33) * v41, v46)
    v53 = xp.minimum(xp.arcsinh(v33 / v47), 3.0 * xp.minimum(1.0, end / v47))
    v56 = v54 * 1.0
    v59 = v53 * (v56 * v56 ** 2.0)
    v61 = v47 * xp.sinh(v59)
    v62 = xp.hypot(b, v61)
    v70 = tipped_rate(xp, v62, v61, R, b, end, k) * v61 / v62 * (v47 * xp.cosh(v59)) ** k * 3.0
    v76 = v47 * xp.sinh(v53)
    v77 = v33 > v76
    v78 = xp.where(v77, v33, 2.0 * v76)
    v82 = xp.where(v34, xp.minimum(b, v78) * v41, v46)
    v90 = v82 * xp.sinh(xp.minimum(xp.arcsinh(v78 / v82), 3.0 * xp.minimum(1.0, end / v82)))
    v91 = v78 > v90
    v92 = xp.where(v91, v78, 2.0 * v90)
    v95 = xp.where(v34, xp.minimum(b, v92) * v41, v46)
    v104 = xp.where(v91, 0.5 * v90, v78)
    v103 = v95 * xp.sinh(xp.minimum(xp.arcsinh(v92 / v95), 3.0 * xp.minimum(1.0, end / v95)))
    v109 = xp.where(v77, 0.5 * v76, v33)
    v110 = xp.where(v77, xp.log(xp.sqrt(v78) / xp.sqrt(xp.where(v91, v103, 1.0))), 0.0)
    v113 = v76 * xp.exp(v54 * v110)
    v114 = xp.hypot(b, v113)
    v118 = xp.hypot(v47, v113)
    v122 = tipped_rate(xp, v114, v113, R, b, end, k) * v113 / v114 * v118 ** k * (v113 / v118)
    v127 = v33 * xp.exp(-(v54 * v110))
    v128 = xp.hypot(b, v127)
    v132 = xp.hypot(v47, v127)
    v136 = tipped_rate(xp, v128, v127, R, b, end, k) * v127 / v128 * v132 ** k * (v127 / v132)
    v138 = v110 * xp.sum(v55 * v122, axis=0) + v110 * xp.sum(v55 * v136, axis=0)
    v140 = xp.where(v2, 1.0, v1)
    v141 = v140 == 0.0
    v142 = v140 < 0.0
    v143 = xp.where(v142, 1.0, v140)
    v144 = xp.where(v142, v29, v15)
    v149 = xp.sqrt(xp.absolute(v140) * v44)
    v150 = xp.where(v141, xp.minimum(b, v144) * v41, v149)
    v154 = xp.minimum(xp.arcsinh(v144 / v150), 3.0)
    v157, v158 = weighted_along(xp, 1.0 + k, r, a, R, b, end, k)
    v159 = v157 * v154
    v161 = v150 * xp.cosh(v159)
    v162 = xp.hypot(b, v161)
    v168 = tipped_rate(xp, v162, v161, R, b, end, k) * v161 / v162 * sinh_over(xp, v159) ** k
    v173 = v150 * xp.sinh(v154)
    v174 = v144 > v173
    v175 = xp.where(v174, v144, 2.0 * v173)
    v179 = xp.where(v141, xp.minimum(b, v175) * v41, v149)
    v184 = v179 * xp.sinh(xp.minimum(xp.arcsinh(v175 / v179), 3.0))
    v185 = v175 > v184
    v186 = xp.where(v185, v175, 2.0 * v184)
    v189 = xp.where(v141, xp.minimum(b, v186) * v41, v149)
    v195 = xp.where(v185, 0.5 * v184, v175)
    v197 = xp.sqrt(xp.where(v185, v189 * xp.sinh(xp.minimum(xp.arcsinh(v186 / v189), 3.0)), 1.0))
    v200 = xp.where(v174, 0.5 * v173, v144)
    v201 = xp.where(v174, xp.log(xp.sqrt(v175) / v197), 0.0)
    v204 = v173 * xp.exp(v54 * v201)
    v206 = xp.hypot(v150, v204)
    v207 = xp.hypot(b, v206)
    v213 = v204 ** k * (tipped_rate(xp, v207, v206, R, b, end, k) * v206 / v207) * (v204 / v206)
    v218 = v144 * xp.exp(-(v54 * v201))
    v220 = xp.hypot(v150, v218)
    v221 = xp.hypot(b, v220)
    v227 = v218 ** k * (tipped_rate(xp, v221, v220, R, b, end, k) * v220 / v221) * (v218 / v220)
    v229 = v201 * xp.sum(v55 * v213, axis=0) + v201 * xp.sum(v55 * v227, axis=0)
    v230 = v150 ** k * (raised(xp, v154, k) * xp.sum(v158 * v168, axis=0)) + v229
    v231 = xp.where(v2, v53 * (1.0 * xp.sum(v55 * (v70 * v56 * v56), axis=0)) + v138, v230)
    return xp.where(v2, v20, 0.0) + xp.where(v32, v231, 0.0)


def flank_pressure(xp, r, a, b, k):
    v80, v81 = nodes_along(xp, 1, r, a, b, k)
    v2 = r - b
    v3 = v2 < 0.0
    v7 = xp.maximum(a - b, 0.0) * (a + b)
    v8 = v7 > 0.0
    v11 = xp.where(v8, xp.sqrt(xp.where(v8, v7, 1.0)), 0.0)
    v12 = xp.where(v3, 1.0, v2)
    v14 = xp.where(v3, v11, difference_root(xp, a, r))
    v15 = v14 > 0.0
    v16 = (r == b) & v15
    v17 = 2.0 * k
    v18 = v17 + 0.0
    v19 = v18 > 0.0
    v21 = xp.where(v19, xp.where(v19, v18, 1.0), 1.0)
    v22 = v21 - 1.0
    v24 = xp.where(v16, v14, b)
    v27 = xp.minimum(xp.arcsinh(v24 / b), 3.0)
    v29, v30 = weighted_along(xp, v21, r, a, b, k)
    v31 = v29 * v27
    v35 = xp.maximum(b * xp.sinh(v31), 1e-09 * b)
    v37 = b * xp.cosh(v31)
    v39 = 1.0 - k
    v47 = ((v35 / v37) ** v39 * sine_integral(xp, xp.arctan2(v35, b), k) + b / v37) * v37 ** v39
    v53 = xp.sum(v30 * (v47 / v35 ** 0.0 * sinh_over(xp, v31) ** v22), axis=0)
    v57 = b * xp.sinh(v27)
    v58 = v24 > v57
    v59 = xp.where(v58, v24, 2.0 * v57)
    v65 = b * xp.sinh(xp.minimum(xp.arcsinh(v59 / b), 3.0))
    v66 = v59 > v65
    v73 = xp.where(v66, 0.5 * v65, v59)
    v72 = b * xp.sinh(xp.minimum(xp.arcsinh(xp.where(v66, v59, 2.0 * v65) / b), 3.0))
    v78 = xp.where(v58, 0.5 * v57, v24)
    v79 = xp.where(v58, xp.log(xp.sqrt(v59) / xp.sqrt(xp.where(v66, v72, 1.0))), 0.0)
    v84 = v57 * xp.exp(v80 * v79)
    v87 = xp.maximum(v84, 1e-09 * b)
    v88 = xp.hypot(b, v84)
    v90 = 1.0 - k
    v98 = ((v87 / v88) ** v90 * sine_integral(xp, xp.arctan2(v87, b), k) + b / v88) * v88 ** v90
    v108 = v24 * xp.exp(-(v80 * v79))
    v111 = xp.maximum(v108, 1e-09 * b)
    v112 = xp.hypot(b, v108)
    v114 = 1.0 - k
    v120 = (v111 / v112) ** v114 * sine_integral(xp, xp.arctan2(v111, b), k) + b / v112
    v127 = v108 ** v22 * (v120 * v112 ** v114 / v111 ** 0.0) * (v108 / v112)
    v104 = v79 * xp.sum(v81 * (v84 ** v22 * (v98 / v87 ** 0.0) * (v84 / v88)), axis=0)
    v131 = xp.where(v15, v14, 1.0)
    v132 = v2 == 0.0
    v138 = xp.exp(-37.0 / xp.minimum(xp.maximum(0.0 + v17, 0.107), 2.0))
    v141 = r + b
    v143 = xp.sqrt(xp.absolute(v2) * v141)
    v144 = xp.where(v132, xp.minimum(b, v131) * v138, v143)
    v148 = xp.minimum(xp.arcsinh(v131 / v144), 3.0)
    v151, v152 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v153 = v151 * v148
    v156 = xp.where(v3, 1.0, v2)
    v158 = v156 < 0.0
    v159 = xp.where(v158, 1.0, v156)
    v163 = xp.minimum(b, xp.where(v158, v11, difference_root(xp, a, r))) * v138
    v169 = xp.where(v156 == 0.0, v163, xp.sqrt(xp.absolute(v156) * v141)) * xp.cosh(v153)
    v170 = xp.where(v3, v144 * xp.sinh(v153), v169)
    v171 = xp.hypot(b, v170)
    v179 = (v170 / v171) ** (1.0 - k) * sine_integral(xp, xp.arctan2(v170, b), k) + b / v171
    v187 = v179 * (v144 * xp.cosh(v153) / v171) ** k * sinh_over(xp, v153) ** k
    v192 = v144 * xp.sinh(v148)
    v193 = v131 > v192
    v194 = xp.where(v193, v131, 2.0 * v192)
    v198 = xp.where(v132, xp.minimum(b, v194) * v138, v143)
    v203 = v198 * xp.sinh(xp.minimum(xp.arcsinh(v194 / v198), 3.0))
    v204 = v194 > v203
    v205 = xp.where(v204, v194, 2.0 * v203)
    v208 = xp.where(v132, xp.minimum(b, v205) * v138, v143)
    v214 = xp.where(v204, 0.5 * v203, v194)
    v216 = xp.sqrt(xp.where(v204, v208 * xp.sinh(xp.minimum(xp.arcsinh(v205 / v208), 3.0)), 1.0))
    v219 = xp.where(v193, 0.5 * v192, v131)
    v220 = xp.where(v193, xp.log(xp.sqrt(v194) / v216), 0.0)
    v222 = xp.exp(v80 * v220)
    v223 = v192 * v222
    v225 = xp.where(v3, 1.0, v2)
    v227 = v225 < 0.0
    v228 = xp.where(v227, 1.0, v225)
    v230 = xp.where(v227, v11, difference_root(xp, a, r))
    v236 = xp.where(v225 == 0.0, xp.minimum(b, v230) * v138, xp.sqrt(xp.absolute(v225) * v141))
    v243 = xp.hypot(v236, v236 * xp.sinh(xp.minimum(xp.arcsinh(v230 / v236), 3.0)) * v222)
    v244 = xp.where(v3, v223, v243)
    v245 = xp.hypot(b, v244)
    v254 = xp.hypot(v144, v223)
    v253 = (v244 / v245) ** (1.0 - k) * sine_integral(xp, xp.arctan2(v244, b), k) + b / v245
    v264 = xp.exp(-(v80 * v220))
    v265 = v131 * v264
    v267 = xp.where(v3, 1.0, v2)
    v269 = v267 < 0.0
    v270 = xp.where(v269, 1.0, v267)
    v272 = xp.where(v269, v11, difference_root(xp, a, r))
    v278 = xp.where(v267 == 0.0, xp.minimum(b, v272) * v138, xp.sqrt(xp.absolute(v267) * v141))
    v281 = xp.where(v3, v265, xp.hypot(v278, v272 * v264))
    v282 = xp.hypot(b, v281)
    v291 = xp.hypot(v144, v265)
    v290 = (v281 / v282) ** (1.0 - k) * sine_integral(xp, xp.arctan2(v281, b), k) + b / v282
    v261 = v220 * xp.sum(v81 * (v223 ** k * (v253 * (v254 / v245) ** k) * (v223 / v254)), axis=0)
    v298 = v220 * xp.sum(v81 * (v265 ** k * (v290 * (v291 / v282) ** k) * (v265 / v291)), axis=0)
    v300 = v144 ** k * (raised(xp, v148, k) * xp.sum(v152 * v187, axis=0)) + (v261 + v298)
    v130 = b ** v22 * (raised(xp, v27, v22) * v53) + (v104 + v79 * xp.sum(v81 * v127, axis=0))
    return cornered(xp, xp.where(v16, v130, xp.where(v15, v300, 0.0)), r, a, b, k)


def waves_pressure(xp, r, a, q, k):
    v20, v21 = nodes_along(xp, 4, r, a, q, k)
    v2 = xp.maximum(r, 8.673617379884035e-19 * a)
    v3 = difference_root(xp, a, v2)
    v5 = xp.minimum(v3, 6.283185307179586 / q)
    v8, v9 = weighted_along(xp, 1.0 + k, r, a, q, k)
    v10 = v8 * v5
    v14 = xp.sqrt(v2 * v2 + v10 * v10)
    v19 = v3 - v5
    v24 = v5 + v20 * v19
    v27 = xp.sqrt(v2 * v2 + v24 * v24)
    v18 = raised(xp, v5, k) * xp.sum(v9 * (waves_rate(xp, v14, q, k) / v14), axis=0)
    return v18 + v19 * xp.sum(v21 * (waves_rate(xp, v27, q, k) / v27 * v24 ** k), axis=0)
