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
from ....._programs.expressions._runtime.graded.rules import sine_mean
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
    v92, v93 = nodes_along(xp, 1, r, a, b, k)
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
    v26 = xp.arcsinh(v24 / b)
    v27 = xp.minimum(v26, 3.0)
    v29, v30 = weighted_along(xp, v21, r, a, b, k)
    v31 = v29 * v27
    v33 = b * xp.cosh(v31)
    v34 = 1.0 - k
    v40 = xp.maximum(b * xp.sinh(v31), 1e-09 * b)
    v49 = v33 * (v34 / (1.0 + k) * (v40 / v33) ** 2.0 + 1.0) * v33 ** v34 / v40 ** 0.0
    v54 = raised(xp, v27, v22) * xp.sum(v30 * (v49 * sinh_over(xp, v31) ** v22), axis=0)
    v56 = v27 < v26
    v60 = xp.where(v56, 2.0 * v26, v27)
    v61 = xp.where(v56, b * xp.sinh(xp.where(v56, v27, 0.5 * v26)), v24)
    v62 = v24 > v61
    v63 = xp.where(v62, v24, 2.0 * v61)
    v66 = xp.arcsinh(v63 / b)
    v67 = xp.minimum(v66, 3.0)
    v68 = v67 < v66
    v72 = xp.where(v68, 2.0 * v66, v67)
    v73 = xp.where(v68, b * xp.sinh(xp.where(v68, v67, 0.5 * v66)), v63)
    v74 = v63 > v73
    v75 = xp.where(v74, v63, 2.0 * v73)
    v77 = xp.arcsinh(v75 / b)
    v78 = xp.minimum(v77, 3.0)
    v79 = v78 < v77
    v83 = xp.where(v79, 2.0 * v77, v78)
    v85 = xp.where(v74, 0.5 * v73, v63)
    v86 = xp.where(v74, xp.where(v79, b * xp.sinh(xp.where(v79, v78, 0.5 * v77)), v75), 1.0)
    v90 = xp.where(v62, 0.5 * v61, v24)
    v91 = xp.where(v62, xp.log(xp.sqrt(v63) / xp.sqrt(v86)), 0.0)
    v96 = v61 * xp.exp(v92 * v91)
    v98 = xp.hypot(b, v96)
    v99 = 1.0 - k
    v103 = xp.maximum(v96, 1e-09 * b)
    v112 = v98 * (v99 / (1.0 + k) * (v103 / v98) ** 2.0 + 1.0) * v98 ** v99 / v103 ** 0.0
    v120 = v24 * xp.exp(-(v92 * v91))
    v122 = xp.hypot(b, v120)
    v123 = 1.0 - k
    v127 = xp.maximum(v120, 1e-09 * b)
    v136 = v122 * (v123 / (1.0 + k) * (v127 / v122) ** 2.0 + 1.0) * v122 ** v123 / v127 ** 0.0
    v140 = v91 * xp.sum(v93 * (v120 ** v22 * v136 * (v120 / v122)), axis=0)
    v143 = xp.where(v15, v14, 1.0)
    v144 = v2 == 0.0
    v150 = xp.exp(-37.0 / xp.minimum(xp.maximum(0.0 + v17, 0.107), 2.0))
    v153 = r + b
    v155 = xp.sqrt(xp.absolute(v2) * v153)
    v156 = xp.where(v144, xp.minimum(b, v143) * v150, v155)
    v159 = xp.arcsinh(v143 / v156)
    v160 = xp.minimum(v159, 3.0)
    v162 = 1.0 + k
    v163, v164 = weighted_along(xp, v162, r, a, b, k)
    v165 = v163 * v160
    v168 = xp.where(v3, 1.0, v2)
    v170 = v168 < 0.0
    v171 = xp.where(v170, 1.0, v168)
    v175 = xp.minimum(b, xp.where(v170, v11, difference_root(xp, a, r))) * v150
    v181 = xp.where(v168 == 0.0, v175, xp.sqrt(xp.absolute(v168) * v153)) * xp.cosh(v165)
    v182 = xp.where(v3, v156 * xp.sinh(v165), v181)
    v183 = xp.hypot(b, v182)
    v190 = v183 * ((1.0 - k) / v162 * (v182 / v183) ** 2.0 + 1.0)
    v198 = v190 * (v156 * xp.cosh(v165) / v183) ** k * sinh_over(xp, v165) ** k
    v202 = v160 < v159
    v206 = xp.where(v202, 2.0 * v159, v160)
    v207 = xp.where(v202, v156 * xp.sinh(xp.where(v202, v160, 0.5 * v159)), v143)
    v208 = v143 > v207
    v209 = xp.where(v208, v143, 2.0 * v207)
    v213 = xp.where(v144, xp.minimum(b, v209) * v150, v155)
    v215 = xp.arcsinh(v209 / v213)
    v216 = xp.minimum(v215, 3.0)
    v217 = v216 < v215
    v221 = xp.where(v217, 2.0 * v215, v216)
    v222 = xp.where(v217, v213 * xp.sinh(xp.where(v217, v216, 0.5 * v215)), v209)
    v223 = v209 > v222
    v224 = xp.where(v223, v209, 2.0 * v222)
    v227 = xp.where(v144, xp.minimum(b, v224) * v150, v155)
    v229 = xp.arcsinh(v224 / v227)
    v230 = xp.minimum(v229, 3.0)
    v231 = v230 < v229
    v235 = xp.where(v231, 2.0 * v229, v230)
    v237 = xp.where(v223, 0.5 * v222, v209)
    v236 = xp.where(v231, v227 * xp.sinh(xp.where(v231, v230, 0.5 * v229)), v224)
    v242 = xp.where(v208, 0.5 * v207, v143)
    v243 = xp.where(v208, xp.log(xp.sqrt(v209) / xp.sqrt(xp.where(v223, v236, 1.0))), 0.0)
    v245 = xp.exp(v92 * v243)
    v246 = v207 * v245
    v248 = xp.where(v3, 1.0, v2)
    v250 = v248 < 0.0
    v251 = xp.where(v250, 1.0, v248)
    v253 = xp.where(v250, v11, difference_root(xp, a, r))
    v259 = xp.where(v248 == 0.0, xp.minimum(b, v253) * v150, xp.sqrt(xp.absolute(v248) * v153))
    v261 = xp.arcsinh(v253 / v259)
    v262 = xp.minimum(v261, 3.0)
    v263 = v262 < v261
    v267 = xp.where(v263, 2.0 * v261, v262)
    v269 = xp.where(v263, v259 * xp.sinh(xp.where(v263, v262, 0.5 * v261)), v253) * v245
    v271 = xp.where(v3, v246, xp.hypot(v259, v269))
    v272 = xp.hypot(b, v271)
    v280 = xp.hypot(v156, v246)
    v283 = v272 * ((1.0 - k) / v162 * (v271 / v272) ** 2.0 + 1.0) * (v280 / v272) ** k
    v290 = xp.exp(-(v92 * v243))
    v291 = v143 * v290
    v293 = xp.where(v3, 1.0, v2)
    v295 = v293 < 0.0
    v296 = xp.where(v295, 1.0, v293)
    v298 = xp.where(v295, v11, difference_root(xp, a, r))
    v304 = xp.where(v293 == 0.0, xp.minimum(b, v298) * v150, xp.sqrt(xp.absolute(v293) * v153))
    v307 = xp.where(v3, v291, xp.hypot(v304, v298 * v290))
    v308 = xp.hypot(b, v307)
    v316 = xp.hypot(v156, v291)
    v319 = v308 * ((1.0 - k) / v162 * (v307 / v308) ** 2.0 + 1.0) * (v316 / v308) ** k
    v323 = v243 * xp.sum(v93 * (v291 ** k * v319 * (v291 / v316)), axis=0)
    v324 = v243 * xp.sum(v93 * (v246 ** k * v283 * (v246 / v280)), axis=0) + v323
    v325 = v156 ** k * (raised(xp, v160, k) * xp.sum(v164 * v198, axis=0)) + v324
    v142 = b ** v22 * v54 + (v91 * xp.sum(v93 * (v96 ** v22 * v112 * (v96 / v98)), axis=0) + v140)
    return cornered(xp, xp.where(v16, v142, xp.where(v15, v325, 0.0)), r, a, b, k)


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
    v64, v65 = nodes_along(xp, 1, r, a, b, k)
    v2 = xp.maximum(r, 8.673617379884035e-19 * a)
    v3 = xp.hypot(v2, b)
    v5 = difference_root(xp, a, v2)
    v7 = xp.arcsinh(v5 / v3)
    v8 = xp.minimum(v7, 3.0)
    v11, v12 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v13 = v11 * v8
    v16 = xp.hypot(v2, v3 * xp.sinh(v13))
    v24 = hyperboloid_rate(xp, v16, b, k) / v16 * (v3 * xp.cosh(v13)) * sinh_over(xp, v13) ** k
    v28 = v8 < v7
    v32 = xp.where(v28, 2.0 * v7, v8)
    v33 = xp.where(v28, v3 * xp.sinh(xp.where(v28, v8, 0.5 * v7)), v5)
    v34 = v5 > v33
    v35 = xp.where(v34, v5, 2.0 * v33)
    v38 = xp.arcsinh(v35 / v3)
    v39 = xp.minimum(v38, 3.0)
    v40 = v39 < v38
    v44 = xp.where(v40, 2.0 * v38, v39)
    v45 = xp.where(v40, v3 * xp.sinh(xp.where(v40, v39, 0.5 * v38)), v35)
    v46 = v35 > v45
    v47 = xp.where(v46, v35, 2.0 * v45)
    v49 = xp.arcsinh(v47 / v3)
    v50 = xp.minimum(v49, 3.0)
    v51 = v50 < v49
    v55 = xp.where(v51, 2.0 * v49, v50)
    v57 = xp.where(v46, 0.5 * v45, v35)
    v58 = xp.where(v46, xp.where(v51, v3 * xp.sinh(xp.where(v51, v50, 0.5 * v49)), v47), 1.0)
    v62 = xp.where(v34, 0.5 * v33, v5)
    v63 = xp.where(v34, xp.log(xp.sqrt(v35) / xp.sqrt(v58)), 0.0)
    v68 = v33 * xp.exp(v64 * v63)
    v70 = xp.hypot(v2, v68)
    v73 = xp.hypot(v3, v68)
    v77 = v68 ** k * (hyperboloid_rate(xp, v70, b, k) / v70 * v73) * (v68 / v73)
    v82 = v5 * xp.exp(-(v64 * v63))
    v84 = xp.hypot(v2, v82)
    v87 = xp.hypot(v3, v82)
    v91 = v82 ** k * (hyperboloid_rate(xp, v84, b, k) / v84 * v87) * (v82 / v87)
    v93 = v63 * xp.sum(v65 * v77, axis=0) + v63 * xp.sum(v65 * v91, axis=0)
    return v3 ** k * (raised(xp, v8, k) * xp.sum(v12 * v24, axis=0)) + v93


def rounded_at(xp, a, b, k):
    v79, v80 = nodes_along(xp, 1, a, b, k)
    v1 = difference_root(xp, a, b)
    v2 = xp.minimum(v1, b)
    v9 = 2.0 * k + 2.0
    v10 = v9 > 0.0
    v12 = xp.where(v10, xp.where(v10, v9, 1.0), 1.0)
    v13 = v12 - 1.0
    v16 = xp.arcsinh(v2 / b)
    v17 = xp.minimum(v16, 3.0)
    v19, v20 = weighted_along(xp, v12, a, b, k)
    v21 = v19 * v17
    v25 = xp.maximum(b * xp.sinh(v21), 1e-09 * b)
    v27 = b * xp.cosh(v21)
    v29 = 1.0 - k
    v36 = (v25 / v27) ** v29 * rounding_rate(xp, v27, v25, b, k) * v27 ** v29 / v25 ** 2.0
    v41 = raised(xp, v17, v13) * xp.sum(v20 * (v36 * sinh_over(xp, v21) ** v13), axis=0)
    v43 = v17 < v16
    v47 = xp.where(v43, 2.0 * v16, v17)
    v48 = xp.where(v43, b * xp.sinh(xp.where(v43, v17, 0.5 * v16)), v2)
    v49 = v2 > v48
    v50 = xp.where(v49, v2, 2.0 * v48)
    v53 = xp.arcsinh(v50 / b)
    v54 = xp.minimum(v53, 3.0)
    v55 = v54 < v53
    v59 = xp.where(v55, 2.0 * v53, v54)
    v60 = xp.where(v55, b * xp.sinh(xp.where(v55, v54, 0.5 * v53)), v50)
    v61 = v50 > v60
    v62 = xp.where(v61, v50, 2.0 * v60)
    v64 = xp.arcsinh(v62 / b)
    v65 = xp.minimum(v64, 3.0)
    v66 = v65 < v64
    v70 = xp.where(v66, 2.0 * v64, v65)
    v72 = xp.where(v61, 0.5 * v60, v50)
    v73 = xp.where(v61, xp.where(v66, b * xp.sinh(xp.where(v66, v65, 0.5 * v64)), v62), 1.0)
    v77 = xp.where(v49, 0.5 * v48, v2)
    v78 = xp.where(v49, xp.log(xp.sqrt(v50) / xp.sqrt(v73)), 0.0)
    v83 = v48 * xp.exp(v79 * v78)
    v86 = xp.maximum(v83, 1e-09 * b)
    v87 = xp.hypot(b, v83)
    v89 = 1.0 - k
    v96 = (v86 / v87) ** v89 * rounding_rate(xp, v87, v86, b, k) * v87 ** v89 / v86 ** 2.0
    v104 = v2 * xp.exp(-(v79 * v78))
    v107 = xp.maximum(v104, 1e-09 * b)
    v108 = xp.hypot(b, v104)
    v110 = 1.0 - k
    v115 = (v107 / v108) ** v110 * rounding_rate(xp, v108, v107, b, k) * v108 ** v110
    v121 = v78 * xp.sum(v80 * (v104 ** v13 * (v115 / v107 ** 2.0) * (v104 / v108)), axis=0)
    v123 = b ** v13 * v41 + (v78 * xp.sum(v80 * (v83 ** v13 * v96 * (v83 / v87)), axis=0) + v121)
    v126 = v1 > v2
    v127 = xp.where(v126, v1, 2.0 * v2)
    v129 = xp.minimum(v127, b)
    v130 = v127 > v129
    v133 = xp.where(v130, 0.5 * v129, v127)
    v135 = xp.sqrt(xp.where(v130, xp.minimum(xp.where(v130, v127, 2.0 * v129), b), 1.0))
    v138 = xp.where(v126, 0.5 * v2, v1)
    v139 = xp.where(v126, xp.log(xp.sqrt(v127) / v135), 0.0)
    v142 = v2 * xp.exp(v79 * v139)
    v144 = xp.hypot(b, v142)
    v148 = v142 ** k * rounded_rate(xp, v144, v142, b, k) * (v142 / v144)
    v153 = v1 * xp.exp(-(v79 * v139))
    v155 = xp.hypot(b, v153)
    v159 = v153 ** k * rounded_rate(xp, v155, v153, b, k) * (v153 / v155)
    v161 = v139 * xp.sum(v80 * v148, axis=0) + v139 * xp.sum(v80 * v159, axis=0)
    return (2.0 * raised(xp, v2, k) / (1.0 + k) ** 2.0 - v123) / b + v161


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
    v45 = xp.arcsinh(v29 / v43)
    v49 = xp.minimum(v45, 3.0 * xp.minimum(1.0, xp.inf / v43))
    v52 = v50 * 1.0
    v55 = v49 * (v52 * v52 ** 2.0)
    v57 = v43 * xp.sinh(v55)
    v58 = xp.hypot(b, v57)
    v67 = rounded_rate(xp, v58, v57, b, k) * v57 / v58 * (v43 * xp.cosh(v55)) ** k * 3.0 * v52
    v71 = v49 < v45
    v75 = xp.where(v71, 2.0 * v45, v49)
    v76 = xp.where(v71, v43 * xp.sinh(xp.where(v71, v49, 0.5 * v45)), v29)
    v77 = v29 > v76
    v78 = xp.where(v77, v29, 2.0 * v76)
    v82 = xp.where(v30, xp.minimum(b, v78) * v37, v42)
    v84 = xp.arcsinh(v78 / v82)
    v88 = xp.minimum(v84, 3.0 * xp.minimum(1.0, xp.inf / v82))
    v89 = v88 < v84
    v93 = xp.where(v89, 2.0 * v84, v88)
    v94 = xp.where(v89, v82 * xp.sinh(xp.where(v89, v88, 0.5 * v84)), v78)
    v95 = v78 > v94
    v96 = xp.where(v95, v78, 2.0 * v94)
    v99 = xp.where(v30, xp.minimum(b, v96) * v37, v42)
    v101 = xp.arcsinh(v96 / v99)
    v105 = xp.minimum(v101, 3.0 * xp.minimum(1.0, xp.inf / v99))
    v106 = v105 < v101
    v110 = xp.where(v106, 2.0 * v101, v105)
    v112 = xp.where(v95, 0.5 * v94, v78)
    v113 = xp.where(v95, xp.where(v106, v99 * xp.sinh(xp.where(v106, v105, 0.5 * v101)), v96), 1.0)
    v117 = xp.where(v77, 0.5 * v76, v29)
    v118 = xp.where(v77, xp.log(xp.sqrt(v78) / xp.sqrt(v113)), 0.0)
    v121 = v76 * xp.exp(v50 * v118)
    v122 = xp.hypot(b, v121)
    v126 = xp.hypot(v43, v121)
    v130 = rounded_rate(xp, v122, v121, b, k) * v121 / v122 * v126 ** k * (v121 / v126)
    v135 = v29 * xp.exp(-(v50 * v118))
    v136 = xp.hypot(b, v135)
    v140 = xp.hypot(v43, v135)
    v144 = rounded_rate(xp, v136, v135, b, k) * v135 / v136 * v140 ** k * (v135 / v140)
    v146 = v118 * xp.sum(v51 * v130, axis=0) + v118 * xp.sum(v51 * v144, axis=0)
    v148 = xp.where(v16, 1.0, v15)
    v149 = v148 == 0.0
    v150 = v148 < 0.0
    v151 = xp.where(v150, 1.0, v148)
    v153 = xp.where(v150, v24, difference_root(xp, a, r))
    v158 = xp.sqrt(xp.absolute(v148) * v40)
    v159 = xp.where(v149, xp.minimum(b, v153) * v37, v158)
    v162 = xp.arcsinh(v153 / v159)
    v163 = xp.minimum(v162, 3.0)
    v166, v167 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v168 = v166 * v163
    v170 = v159 * xp.cosh(v168)
    v171 = xp.hypot(b, v170)
    v177 = rounded_rate(xp, v171, v170, b, k) * v170 / v171 * sinh_over(xp, v168) ** k
    v181 = v163 < v162
    v185 = xp.where(v181, 2.0 * v162, v163)
    v186 = xp.where(v181, v159 * xp.sinh(xp.where(v181, v163, 0.5 * v162)), v153)
    v187 = v153 > v186
    v188 = xp.where(v187, v153, 2.0 * v186)
    v192 = xp.where(v149, xp.minimum(b, v188) * v37, v158)
    v194 = xp.arcsinh(v188 / v192)
    v195 = xp.minimum(v194, 3.0)
    v196 = v195 < v194
    v200 = xp.where(v196, 2.0 * v194, v195)
    v201 = xp.where(v196, v192 * xp.sinh(xp.where(v196, v195, 0.5 * v194)), v188)
    v202 = v188 > v201
    v203 = xp.where(v202, v188, 2.0 * v201)
    v206 = xp.where(v149, xp.minimum(b, v203) * v37, v158)
    v208 = xp.arcsinh(v203 / v206)
    v209 = xp.minimum(v208, 3.0)
    v210 = v209 < v208
    v214 = xp.where(v210, 2.0 * v208, v209)
    v216 = xp.where(v202, 0.5 * v201, v188)
    v215 = xp.where(v210, v206 * xp.sinh(xp.where(v210, v209, 0.5 * v208)), v203)
    v221 = xp.where(v187, 0.5 * v186, v153)
    v222 = xp.where(v187, xp.log(xp.sqrt(v188) / xp.sqrt(xp.where(v202, v215, 1.0))), 0.0)
    v225 = v186 * xp.exp(v50 * v222)
    v227 = xp.hypot(v159, v225)
    v228 = xp.hypot(b, v227)
    v234 = v225 ** k * (rounded_rate(xp, v228, v227, b, k) * v227 / v228) * (v225 / v227)
    v239 = v153 * xp.exp(-(v50 * v222))
    v241 = xp.hypot(v159, v239)
    v242 = xp.hypot(b, v241)
    v248 = v239 ** k * (rounded_rate(xp, v242, v241, b, k) * v241 / v242) * (v239 / v241)
    v250 = v222 * xp.sum(v51 * v234, axis=0) + v222 * xp.sum(v51 * v248, axis=0)
    v251 = v159 ** k * (raised(xp, v163, k) * xp.sum(v167 * v177, axis=0)) + v250
    v252 = xp.where(v16, v49 * (1.0 * xp.sum(v51 * (v67 * v52), axis=0)) + v146, v251)
    v254 = xp.where(v7, v12, 0.0) + xp.where(v28, v252, 0.0)
    return xp.where(v3, rounded_at(xp, xp.where(v3, a, v4), b, k), v254)


def rounding_pressure(xp, r, a, b, k):
    v89, v90 = nodes_along(xp, 1, r, a, b, k)
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
    v26 = xp.arcsinh(v24 / b)
    v27 = xp.minimum(v26, 3.0)
    v29, v30 = weighted_along(xp, v21, r, a, b, k)
    v31 = v29 * v27
    v35 = xp.maximum(b * xp.sinh(v31), 1e-09 * b)
    v37 = b * xp.cosh(v31)
    v39 = 1.0 - k
    v46 = (v35 / v37) ** v39 * rounding_rate(xp, v37, v35, b, k) * v37 ** v39 / v35 ** 2.0
    v51 = raised(xp, v27, v22) * xp.sum(v30 * (v46 * sinh_over(xp, v31) ** v22), axis=0)
    v53 = v27 < v26
    v57 = xp.where(v53, 2.0 * v26, v27)
    v58 = xp.where(v53, b * xp.sinh(xp.where(v53, v27, 0.5 * v26)), v24)
    v59 = v24 > v58
    v60 = xp.where(v59, v24, 2.0 * v58)
    v63 = xp.arcsinh(v60 / b)
    v64 = xp.minimum(v63, 3.0)
    v65 = v64 < v63
    v69 = xp.where(v65, 2.0 * v63, v64)
    v70 = xp.where(v65, b * xp.sinh(xp.where(v65, v64, 0.5 * v63)), v60)
    v71 = v60 > v70
    v72 = xp.where(v71, v60, 2.0 * v70)
    v74 = xp.arcsinh(v72 / b)
    v75 = xp.minimum(v74, 3.0)
    v76 = v75 < v74
    v80 = xp.where(v76, 2.0 * v74, v75)
    v82 = xp.where(v71, 0.5 * v70, v60)
    v83 = xp.where(v71, xp.where(v76, b * xp.sinh(xp.where(v76, v75, 0.5 * v74)), v72), 1.0)
    v87 = xp.where(v59, 0.5 * v58, v24)
    v88 = xp.where(v59, xp.log(xp.sqrt(v60) / xp.sqrt(v83)), 0.0)
    v93 = v58 * xp.exp(v89 * v88)
    v96 = xp.maximum(v93, 1e-09 * b)
    v97 = xp.hypot(b, v93)
    v99 = 1.0 - k
    v106 = (v96 / v97) ** v99 * rounding_rate(xp, v97, v96, b, k) * v97 ** v99 / v96 ** 2.0
    v114 = v24 * xp.exp(-(v89 * v88))
    v117 = xp.maximum(v114, 1e-09 * b)
    v118 = xp.hypot(b, v114)
    v120 = 1.0 - k
    v125 = (v117 / v118) ** v120 * rounding_rate(xp, v118, v117, b, k) * v118 ** v120
    v131 = v88 * xp.sum(v90 * (v114 ** v22 * (v125 / v117 ** 2.0) * (v114 / v118)), axis=0)
    v134 = xp.where(v15, v14, 1.0)
    v135 = v2 == 0.0
    v141 = xp.exp(-37.0 / xp.minimum(xp.maximum(2.0 + v17, 0.107), 2.0))
    v144 = r + b
    v146 = xp.sqrt(xp.absolute(v2) * v144)
    v147 = xp.where(v135, xp.minimum(b, v134) * v141, v146)
    v150 = xp.arcsinh(v134 / v147)
    v151 = xp.minimum(v150, 3.0)
    v154, v155 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v156 = v154 * v151
    v159 = xp.where(v3, 1.0, v2)
    v161 = v159 < 0.0
    v162 = xp.where(v161, 1.0, v159)
    v166 = xp.minimum(b, xp.where(v161, v11, difference_root(xp, a, r))) * v141
    v172 = xp.where(v159 == 0.0, v166, xp.sqrt(xp.absolute(v159) * v144)) * xp.cosh(v156)
    v173 = xp.where(v3, v147 * xp.sinh(v156), v172)
    v174 = xp.hypot(b, v173)
    v179 = (v173 / v174) ** (1.0 - k) * rounding_rate(xp, v174, v173, b, k)
    v187 = v179 * (v147 * xp.cosh(v156) / v174) ** k * sinh_over(xp, v156) ** k
    v191 = v151 < v150
    v195 = xp.where(v191, 2.0 * v150, v151)
    v196 = xp.where(v191, v147 * xp.sinh(xp.where(v191, v151, 0.5 * v150)), v134)
    v197 = v134 > v196
    v198 = xp.where(v197, v134, 2.0 * v196)
    v202 = xp.where(v135, xp.minimum(b, v198) * v141, v146)
    v204 = xp.arcsinh(v198 / v202)
    v205 = xp.minimum(v204, 3.0)
    v206 = v205 < v204
    v210 = xp.where(v206, 2.0 * v204, v205)
    v211 = xp.where(v206, v202 * xp.sinh(xp.where(v206, v205, 0.5 * v204)), v198)
    v212 = v198 > v211
    v213 = xp.where(v212, v198, 2.0 * v211)
    v216 = xp.where(v135, xp.minimum(b, v213) * v141, v146)
    v218 = xp.arcsinh(v213 / v216)
    v219 = xp.minimum(v218, 3.0)
    v220 = v219 < v218
    v224 = xp.where(v220, 2.0 * v218, v219)
    v226 = xp.where(v212, 0.5 * v211, v198)
    v225 = xp.where(v220, v216 * xp.sinh(xp.where(v220, v219, 0.5 * v218)), v213)
    v231 = xp.where(v197, 0.5 * v196, v134)
    v232 = xp.where(v197, xp.log(xp.sqrt(v198) / xp.sqrt(xp.where(v212, v225, 1.0))), 0.0)
    v234 = xp.exp(v89 * v232)
    v235 = v196 * v234
    v237 = xp.where(v3, 1.0, v2)
    v239 = v237 < 0.0
    v240 = xp.where(v239, 1.0, v237)
    v242 = xp.where(v239, v11, difference_root(xp, a, r))
    v248 = xp.where(v237 == 0.0, xp.minimum(b, v242) * v141, xp.sqrt(xp.absolute(v237) * v144))
    v250 = xp.arcsinh(v242 / v248)
    v251 = xp.minimum(v250, 3.0)
    v252 = v251 < v250
    v256 = xp.where(v252, 2.0 * v250, v251)
    v258 = xp.where(v252, v248 * xp.sinh(xp.where(v252, v251, 0.5 * v250)), v242) * v234
    v260 = xp.where(v3, v235, xp.hypot(v248, v258))
    v261 = xp.hypot(b, v260)
    v267 = xp.hypot(v147, v235)
    v270 = (v260 / v261) ** (1.0 - k) * rounding_rate(xp, v261, v260, b, k) * (v267 / v261) ** k
    v277 = xp.exp(-(v89 * v232))
    v278 = v134 * v277
    v280 = xp.where(v3, 1.0, v2)
    v282 = v280 < 0.0
    v283 = xp.where(v282, 1.0, v280)
    v285 = xp.where(v282, v11, difference_root(xp, a, r))
    v291 = xp.where(v280 == 0.0, xp.minimum(b, v285) * v141, xp.sqrt(xp.absolute(v280) * v144))
    v294 = xp.where(v3, v278, xp.hypot(v291, v285 * v277))
    v295 = xp.hypot(b, v294)
    v301 = xp.hypot(v147, v278)
    v304 = (v294 / v295) ** (1.0 - k) * rounding_rate(xp, v295, v294, b, k) * (v301 / v295) ** k
    v308 = v232 * xp.sum(v90 * (v278 ** k * v304 * (v278 / v301)), axis=0)
    v309 = v232 * xp.sum(v90 * (v235 ** k * v270 * (v235 / v267)), axis=0) + v308
    v310 = v147 ** k * (raised(xp, v151, k) * xp.sum(v155 * v187, axis=0)) + v309
    v133 = b ** v22 * v51 + (v88 * xp.sum(v90 * (v93 ** v22 * v106 * (v93 / v97)), axis=0) + v131)
    return xp.where(v16, v133, xp.where(v15, v310, 0.0))


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
    v49 = xp.arcsinh(v33 / v47)
    v53 = xp.minimum(v49, 3.0 * xp.minimum(1.0, end / v47))
    v56 = v54 * 1.0
    v59 = v53 * (v56 * v56 ** 2.0)
    v61 = v47 * xp.sinh(v59)
    v62 = xp.hypot(b, v61)
    v70 = tipped_rate(xp, v62, v61, R, b, end, k) * v61 / v62 * (v47 * xp.cosh(v59)) ** k * 3.0
    v75 = v53 < v49
    v79 = xp.where(v75, 2.0 * v49, v53)
    v80 = xp.where(v75, v47 * xp.sinh(xp.where(v75, v53, 0.5 * v49)), v33)
    v81 = v33 > v80
    v82 = xp.where(v81, v33, 2.0 * v80)
    v86 = xp.where(v34, xp.minimum(b, v82) * v41, v46)
    v88 = xp.arcsinh(v82 / v86)
    v92 = xp.minimum(v88, 3.0 * xp.minimum(1.0, end / v86))
    v93 = v92 < v88
    v97 = xp.where(v93, 2.0 * v88, v92)
    v98 = xp.where(v93, v86 * xp.sinh(xp.where(v93, v92, 0.5 * v88)), v82)
    v99 = v82 > v98
    v100 = xp.where(v99, v82, 2.0 * v98)
    v103 = xp.where(v34, xp.minimum(b, v100) * v41, v46)
    v105 = xp.arcsinh(v100 / v103)
    v109 = xp.minimum(v105, 3.0 * xp.minimum(1.0, end / v103))
    v110 = v109 < v105
    v114 = xp.where(v110, 2.0 * v105, v109)
    v116 = xp.where(v99, 0.5 * v98, v82)
    v117 = xp.where(v99, xp.where(v110, v103 * xp.sinh(xp.where(v110, v109, 0.5 * v105)), v100), 1.0)
    v121 = xp.where(v81, 0.5 * v80, v33)
    v122 = xp.where(v81, xp.log(xp.sqrt(v82) / xp.sqrt(v117)), 0.0)
    v125 = v80 * xp.exp(v54 * v122)
    v126 = xp.hypot(b, v125)
    v130 = xp.hypot(v47, v125)
    v134 = tipped_rate(xp, v126, v125, R, b, end, k) * v125 / v126 * v130 ** k * (v125 / v130)
    v139 = v33 * xp.exp(-(v54 * v122))
    v140 = xp.hypot(b, v139)
    v144 = xp.hypot(v47, v139)
    v148 = tipped_rate(xp, v140, v139, R, b, end, k) * v139 / v140 * v144 ** k * (v139 / v144)
    v150 = v122 * xp.sum(v55 * v134, axis=0) + v122 * xp.sum(v55 * v148, axis=0)
    v152 = xp.where(v2, 1.0, v1)
    v153 = v152 == 0.0
    v154 = v152 < 0.0
    v155 = xp.where(v154, 1.0, v152)
    v156 = xp.where(v154, v29, v15)
    v161 = xp.sqrt(xp.absolute(v152) * v44)
    v162 = xp.where(v153, xp.minimum(b, v156) * v41, v161)
    v165 = xp.arcsinh(v156 / v162)
    v166 = xp.minimum(v165, 3.0)
    v169, v170 = weighted_along(xp, 1.0 + k, r, a, R, b, end, k)
    v171 = v169 * v166
    v173 = v162 * xp.cosh(v171)
    v174 = xp.hypot(b, v173)
    v180 = tipped_rate(xp, v174, v173, R, b, end, k) * v173 / v174 * sinh_over(xp, v171) ** k
    v184 = v166 < v165
    v188 = xp.where(v184, 2.0 * v165, v166)
    v189 = xp.where(v184, v162 * xp.sinh(xp.where(v184, v166, 0.5 * v165)), v156)
    v190 = v156 > v189
    v191 = xp.where(v190, v156, 2.0 * v189)
    v195 = xp.where(v153, xp.minimum(b, v191) * v41, v161)
    v197 = xp.arcsinh(v191 / v195)
    v198 = xp.minimum(v197, 3.0)
    v199 = v198 < v197
    v203 = xp.where(v199, 2.0 * v197, v198)
    v204 = xp.where(v199, v195 * xp.sinh(xp.where(v199, v198, 0.5 * v197)), v191)
    v205 = v191 > v204
    v206 = xp.where(v205, v191, 2.0 * v204)
    v209 = xp.where(v153, xp.minimum(b, v206) * v41, v161)
    v211 = xp.arcsinh(v206 / v209)
    v212 = xp.minimum(v211, 3.0)
    v213 = v212 < v211
    v217 = xp.where(v213, 2.0 * v211, v212)
    v219 = xp.where(v205, 0.5 * v204, v191)
    v218 = xp.where(v213, v209 * xp.sinh(xp.where(v213, v212, 0.5 * v211)), v206)
    v224 = xp.where(v190, 0.5 * v189, v156)
    v225 = xp.where(v190, xp.log(xp.sqrt(v191) / xp.sqrt(xp.where(v205, v218, 1.0))), 0.0)
    v228 = v189 * xp.exp(v54 * v225)
    v230 = xp.hypot(v162, v228)
    v231 = xp.hypot(b, v230)
    v237 = v228 ** k * (tipped_rate(xp, v231, v230, R, b, end, k) * v230 / v231) * (v228 / v230)
    v242 = v156 * xp.exp(-(v54 * v225))
    v244 = xp.hypot(v162, v242)
    v245 = xp.hypot(b, v244)
    v251 = v242 ** k * (tipped_rate(xp, v245, v244, R, b, end, k) * v244 / v245) * (v242 / v244)
    v253 = v225 * xp.sum(v55 * v237, axis=0) + v225 * xp.sum(v55 * v251, axis=0)
    v254 = v162 ** k * (raised(xp, v166, k) * xp.sum(v170 * v180, axis=0)) + v253
    v255 = xp.where(v2, v53 * (1.0 * xp.sum(v55 * (v70 * v56 * v56), axis=0)) + v150, v254)
    return xp.where(v2, v20, 0.0) + xp.where(v32, v255, 0.0)


def flank_pressure(xp, r, a, b, k):
    v94, v95 = nodes_along(xp, 1, r, a, b, k)
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
    v26 = xp.arcsinh(v24 / b)
    v27 = xp.minimum(v26, 3.0)
    v29, v30 = weighted_along(xp, v21, r, a, b, k)
    v31 = v29 * v27
    v35 = xp.maximum(b * xp.sinh(v31), 1e-09 * b)
    v37 = b * xp.cosh(v31)
    v39 = 1.0 - k
    v41 = xp.arctan2(v35, b)
    v47 = (v35 / v37) ** v39 * (raised(xp, v41, k) * sine_mean(xp, v41, k)) + b / v37
    v55 = xp.sum(v30 * (v47 * v37 ** v39 / v35 ** 0.0 * sinh_over(xp, v31) ** v22), axis=0)
    v58 = v27 < v26
    v62 = xp.where(v58, 2.0 * v26, v27)
    v63 = xp.where(v58, b * xp.sinh(xp.where(v58, v27, 0.5 * v26)), v24)
    v64 = v24 > v63
    v65 = xp.where(v64, v24, 2.0 * v63)
    v68 = xp.arcsinh(v65 / b)
    v69 = xp.minimum(v68, 3.0)
    v70 = v69 < v68
    v74 = xp.where(v70, 2.0 * v68, v69)
    v75 = xp.where(v70, b * xp.sinh(xp.where(v70, v69, 0.5 * v68)), v65)
    v76 = v65 > v75
    v77 = xp.where(v76, v65, 2.0 * v75)
    v79 = xp.arcsinh(v77 / b)
    v80 = xp.minimum(v79, 3.0)
    v81 = v80 < v79
    v85 = xp.where(v81, 2.0 * v79, v80)
    v87 = xp.where(v76, 0.5 * v75, v65)
    v88 = xp.where(v76, xp.where(v81, b * xp.sinh(xp.where(v81, v80, 0.5 * v79)), v77), 1.0)
    v92 = xp.where(v64, 0.5 * v63, v24)
    v93 = xp.where(v64, xp.log(xp.sqrt(v65) / xp.sqrt(v88)), 0.0)
    v98 = v63 * xp.exp(v94 * v93)
    v101 = xp.maximum(v98, 1e-09 * b)
    v102 = xp.hypot(b, v98)
    v104 = 1.0 - k
    v106 = xp.arctan2(v101, b)
    v112 = (v101 / v102) ** v104 * (raised(xp, v106, k) * sine_mean(xp, v106, k)) + b / v102
    v119 = v98 ** v22 * (v112 * v102 ** v104 / v101 ** 0.0) * (v98 / v102)
    v124 = v24 * xp.exp(-(v94 * v93))
    v127 = xp.maximum(v124, 1e-09 * b)
    v128 = xp.hypot(b, v124)
    v130 = 1.0 - k
    v132 = xp.arctan2(v127, b)
    v138 = (v127 / v128) ** v130 * (raised(xp, v132, k) * sine_mean(xp, v132, k)) + b / v128
    v145 = v124 ** v22 * (v138 * v128 ** v130 / v127 ** 0.0) * (v124 / v128)
    v147 = v93 * xp.sum(v95 * v119, axis=0) + v93 * xp.sum(v95 * v145, axis=0)
    v149 = xp.where(v15, v14, 1.0)
    v150 = v2 == 0.0
    v156 = xp.exp(-37.0 / xp.minimum(xp.maximum(0.0 + v17, 0.107), 2.0))
    v159 = r + b
    v161 = xp.sqrt(xp.absolute(v2) * v159)
    v162 = xp.where(v150, xp.minimum(b, v149) * v156, v161)
    v165 = xp.arcsinh(v149 / v162)
    v166 = xp.minimum(v165, 3.0)
    v169, v170 = weighted_along(xp, 1.0 + k, r, a, b, k)
    v171 = v169 * v166
    v174 = xp.where(v3, 1.0, v2)
    v176 = v174 < 0.0
    v177 = xp.where(v176, 1.0, v174)
    v181 = xp.minimum(b, xp.where(v176, v11, difference_root(xp, a, r))) * v156
    v187 = xp.where(v174 == 0.0, v181, xp.sqrt(xp.absolute(v174) * v159)) * xp.cosh(v171)
    v188 = xp.where(v3, v162 * xp.sinh(v171), v187)
    v189 = xp.hypot(b, v188)
    v193 = xp.arctan2(v188, b)
    v199 = (v188 / v189) ** (1.0 - k) * (raised(xp, v193, k) * sine_mean(xp, v193, k)) + b / v189
    v207 = v199 * (v162 * xp.cosh(v171) / v189) ** k * sinh_over(xp, v171) ** k
    v211 = v166 < v165
    v215 = xp.where(v211, 2.0 * v165, v166)
    v216 = xp.where(v211, v162 * xp.sinh(xp.where(v211, v166, 0.5 * v165)), v149)
    v217 = v149 > v216
    v218 = xp.where(v217, v149, 2.0 * v216)
    v222 = xp.where(v150, xp.minimum(b, v218) * v156, v161)
    v224 = xp.arcsinh(v218 / v222)
    v225 = xp.minimum(v224, 3.0)
    v226 = v225 < v224
    v230 = xp.where(v226, 2.0 * v224, v225)
    v231 = xp.where(v226, v222 * xp.sinh(xp.where(v226, v225, 0.5 * v224)), v218)
    v232 = v218 > v231
    v233 = xp.where(v232, v218, 2.0 * v231)
    v236 = xp.where(v150, xp.minimum(b, v233) * v156, v161)
    v238 = xp.arcsinh(v233 / v236)
    v239 = xp.minimum(v238, 3.0)
    v240 = v239 < v238
    v244 = xp.where(v240, 2.0 * v238, v239)
    v246 = xp.where(v232, 0.5 * v231, v218)
    v245 = xp.where(v240, v236 * xp.sinh(xp.where(v240, v239, 0.5 * v238)), v233)
    v251 = xp.where(v217, 0.5 * v216, v149)
    v252 = xp.where(v217, xp.log(xp.sqrt(v218) / xp.sqrt(xp.where(v232, v245, 1.0))), 0.0)
    v254 = xp.exp(v94 * v252)
    v255 = v216 * v254
    v257 = xp.where(v3, 1.0, v2)
    v259 = v257 < 0.0
    v260 = xp.where(v259, 1.0, v257)
    v262 = xp.where(v259, v11, difference_root(xp, a, r))
    v268 = xp.where(v257 == 0.0, xp.minimum(b, v262) * v156, xp.sqrt(xp.absolute(v257) * v159))
    v270 = xp.arcsinh(v262 / v268)
    v271 = xp.minimum(v270, 3.0)
    v272 = v271 < v270
    v276 = xp.where(v272, 2.0 * v270, v271)
    v278 = xp.where(v272, v268 * xp.sinh(xp.where(v272, v271, 0.5 * v270)), v262) * v254
    v280 = xp.where(v3, v255, xp.hypot(v268, v278))
    v281 = xp.hypot(b, v280)
    v285 = xp.arctan2(v280, b)
    v292 = xp.hypot(v162, v255)
    v291 = (v280 / v281) ** (1.0 - k) * (raised(xp, v285, k) * sine_mean(xp, v285, k)) + b / v281
    v302 = xp.exp(-(v94 * v252))
    v303 = v149 * v302
    v305 = xp.where(v3, 1.0, v2)
    v307 = v305 < 0.0
    v308 = xp.where(v307, 1.0, v305)
    v310 = xp.where(v307, v11, difference_root(xp, a, r))
    v316 = xp.where(v305 == 0.0, xp.minimum(b, v310) * v156, xp.sqrt(xp.absolute(v305) * v159))
    v319 = xp.where(v3, v303, xp.hypot(v316, v310 * v302))
    v320 = xp.hypot(b, v319)
    v324 = xp.arctan2(v319, b)
    v331 = xp.hypot(v162, v303)
    v330 = (v319 / v320) ** (1.0 - k) * (raised(xp, v324, k) * sine_mean(xp, v324, k)) + b / v320
    v299 = v252 * xp.sum(v95 * (v255 ** k * (v291 * (v292 / v281) ** k) * (v255 / v292)), axis=0)
    v338 = v252 * xp.sum(v95 * (v303 ** k * (v330 * (v331 / v320) ** k) * (v303 / v331)), axis=0)
    v340 = v162 ** k * (raised(xp, v166, k) * xp.sum(v170 * v207, axis=0)) + (v299 + v338)
    v342 = xp.where(v16, b ** v22 * (raised(xp, v27, v22) * v55) + v147, xp.where(v15, v340, 0.0))
    return cornered(xp, v342, r, a, b, k)


def waves_pressure(xp, r, a, q, k):
    v21, v22 = nodes_along(xp, 4, r, a, q, k)
    v2 = xp.maximum(r, 8.673617379884035e-19 * a)
    v3 = difference_root(xp, a, v2)
    v6 = xp.minimum(v3, 4.0 * (6.283185307179586 / q))
    v9, v10 = weighted_along(xp, 1.0 + k, r, a, q, k)
    v11 = v9 * v6
    v15 = xp.sqrt(v2 * v2 + v11 * v11)
    v20 = v3 - v6
    v25 = v6 + v21 * v20
    v28 = xp.sqrt(v2 * v2 + v25 * v25)
    v19 = raised(xp, v6, k) * xp.sum(v10 * (waves_rate(xp, v15, q, k) / v15), axis=0)
    return v19 + v20 * xp.sum(v22 * (waves_rate(xp, v28, q, k) / v28 * v25 ** k), axis=0)
