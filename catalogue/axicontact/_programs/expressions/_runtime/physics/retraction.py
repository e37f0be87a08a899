"""Formulas of axicontact._runtime.physics.retraction over an array library `xp`."""

from ....._runtime.steps import fading
from ....._runtime.steps import fraction
from ....._runtime.steps import rising


def lag_maxwell(xp, t, t_m, t_h, ratio, E, tau):
    v6 = ratio * xp.expm1(xp.minimum(xp.maximum(t - t_h, 0.0) / tau, 700.0))
    v11 = v6 * xp.exp(xp.minimum((t_h - t_m) / tau, 700.0))
    v12 = v11 < 1.0
    v19 = xp.where(v12, 2.0 * 1.0, v11)
    v18 = -tau * xp.log1p(-xp.minimum(xp.where(v12, v11, 0.5 * 1.0), 0.9999999999999998))
    return xp.where(v12, v18, xp.inf)


def earlier(xp, t, t_m, lag):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    return xp.where(v1, xp.maximum(t_m - lag, 0.0), xp.where(v1, 0.5 * t_m, t))


def end_maxwell(xp, ratio, t_m, t_h, E, tau):
    v12 = t_h + tau * xp.log1p(-xp.expm1(-t_m / tau) * xp.exp((t_m - t_h) / tau) / ratio)
    return v12


def lag_kelvin_voigt(xp, t, t_m, t_h, ratio, E, eta):
    v1 = t > t_h
    v7 = xp.where(v1, 0.5 * t_h, t)
    return xp.where(v1, ratio * (xp.where(v1, t, 2.0 * t_h) - t_h + eta / E), 0.0)


def end_kelvin_voigt(xp, ratio, t_m, t_h, E, eta):
    return t_h + xp.maximum(t_m / ratio - eta / E, 0.0)


def slowed(xp, x, k):
    v3 = 1.0 + k
    v6 = xp.maximum(k, 1.0)
    v7 = xp.log(v6)
    v9 = v7 + (v6 - x)
    v10 = v9 > 1.0
    v12 = xp.maximum(xp.where(v10, v9, 2.0 * 1.0), 1.0)
    v16 = xp.where(v10, 0.5 * 1.0, v9)
    v20 = v16 - xp.log1p(xp.exp(xp.minimum(v16, 1.0)))
    v22 = v7 - xp.where(v10, xp.log(v12 - xp.log(v12)), v20)
    v26 = xp.where((k > 1.0) & (2.0 * x > v3), v22, xp.maximum(x / v3, x - k))
    v30 = -xp.expm1(-v26)
    v38 = xp.maximum(v26 + (x - v26 - k * v30) / (1.0 + k * (1.0 - v30)), 0.0)
    v42 = -xp.expm1(-v38)
    v50 = xp.maximum(v38 + (x - v38 - k * v42) / (1.0 + k * (1.0 - v42)), 0.0)
    v54 = -xp.expm1(-v50)
    v62 = xp.maximum(v50 + (x - v50 - k * v54) / (1.0 + k * (1.0 - v54)), 0.0)
    v66 = -xp.expm1(-v62)
    v74 = xp.maximum(v62 + (x - v62 - k * v66) / (1.0 + k * (1.0 - v66)), 0.0)
    v78 = -xp.expm1(-v74)
    v86 = xp.maximum(v74 + (x - v74 - k * v78) / (1.0 + k * (1.0 - v78)), 0.0)
    v90 = -xp.expm1(-v86)
    v98 = xp.maximum(v86 + (x - v86 - k * v90) / (1.0 + k * (1.0 - v90)), 0.0)
    v102 = -xp.expm1(-v98)
    v110 = xp.maximum(v98 + (x - v98 - k * v102) / (1.0 + k * (1.0 - v102)), 0.0)
    v114 = -xp.expm1(-v110)
    v122 = xp.maximum(v110 + (x - v110 - k * v114) / (1.0 + k * (1.0 - v114)), 0.0)
    v126 = -xp.expm1(-v122)
    v134 = xp.maximum(v122 + (x - v122 - k * v126) / (1.0 + k * (1.0 - v126)), 0.0)
    v138 = -xp.expm1(-v134)
    v146 = xp.maximum(v134 + (x - v134 - k * v138) / (1.0 + k * (1.0 - v138)), 0.0)
    v150 = -xp.expm1(-v146)
    v158 = xp.maximum(v146 + (x - v146 - k * v150) / (1.0 + k * (1.0 - v150)), 0.0)
    v162 = -xp.expm1(-v158)
    v170 = xp.maximum(v158 + (x - v158 - k * v162) / (1.0 + k * (1.0 - v162)), 0.0)
    v174 = -xp.expm1(-v170)
    v182 = xp.maximum(v170 + (x - v170 - k * v174) / (1.0 + k * (1.0 - v174)), 0.0)
    v186 = -xp.expm1(-v182)
    v194 = xp.maximum(v182 + (x - v182 - k * v186) / (1.0 + k * (1.0 - v186)), 0.0)
    v198 = -xp.expm1(-v194)
    v206 = xp.maximum(v194 + (x - v194 - k * v198) / (1.0 + k * (1.0 - v198)), 0.0)
    v210 = -xp.expm1(-v206)
    v218 = xp.maximum(v206 + (x - v206 - k * v210) / (1.0 + k * (1.0 - v210)), 0.0)
    v222 = -xp.expm1(-v218)
    v230 = xp.maximum(v218 + (x - v218 - k * v222) / (1.0 + k * (1.0 - v222)), 0.0)
    v234 = -xp.expm1(-v230)
    v242 = xp.maximum(v230 + (x - v230 - k * v234) / (1.0 + k * (1.0 - v234)), 0.0)
    v246 = -xp.expm1(-v242)
    v254 = xp.maximum(v242 + (x - v242 - k * v246) / (1.0 + k * (1.0 - v246)), 0.0)
    v258 = -xp.expm1(-v254)
    return xp.maximum(v254 + (x - v254 - k * v258) / (1.0 + k * (1.0 - v258)), 0.0)


def lag_standard_solid(xp, t, t_m, t_h, ratio, E_inf, E_1, tau):
    v3 = xp.maximum(t - t_h, 0.0) / tau
    v4 = E_1 / E_inf
    v15 = v4 * xp.exp(-(xp.maximum(t - t_m, 0.0) / tau))
    return tau * slowed(xp, ratio * (v3 - v4 * xp.expm1(-v3)), v15)


def end_standard_solid(xp, ratio, t_m, t_h, E_inf, E_1, tau):
    v1 = t_m / tau
    v2 = E_1 / E_inf
    v10 = -v2 * xp.expm1(-v1) * xp.exp((t_m - t_h) / tau)
    return t_h + tau * slowed(xp, (v1 + v10) / ratio, v2 + v10 / ratio)


def lag_power_creep(xp, t, t_m, t_h, ratio, E, alpha, t_0):
    v3 = t > t_h
    v4 = xp.where(v3, t, 2.0 * t_h)
    v8 = xp.where(v3, 0.5 * t_h, t)
    v10 = 1.0 - alpha
    v14 = xp.log1p(ratio * xp.where(v3, (v4 - t_h) / (v4 - t_m), 0.0) ** v10) / v10
    return xp.maximum(t - t_m, 0.0) * xp.expm1(xp.minimum(v14, 700.0))


def sooner(xp, start, k, ratio, beta):
    v1 = xp.minimum(start, 1e+100)
    v3 = 1.0 + k * v1
    v8 = xp.expm1(beta * xp.log1p(v1 / v3))
    v20 = beta * v1 * (k + (1.0 + v8) / v8 / (v3 + v1)) / v3
    v24 = v1 * xp.exp(xp.minimum(-xp.log(v3 ** beta * v8 / ratio) / v20, 700.0))
    v25 = xp.minimum(v24, 1e+100)
    v27 = 1.0 + k * v25
    v32 = xp.expm1(beta * xp.log1p(v25 / v27))
    v44 = beta * v25 * (k + (1.0 + v32) / v32 / (v27 + v25)) / v27
    v48 = v25 * xp.exp(xp.minimum(-xp.log(v27 ** beta * v32 / ratio) / v44, 700.0))
    v49 = xp.minimum(v48, 1e+100)
    v51 = 1.0 + k * v49
    v56 = xp.expm1(beta * xp.log1p(v49 / v51))
    v68 = beta * v49 * (k + (1.0 + v56) / v56 / (v51 + v49)) / v51
    v72 = v49 * xp.exp(xp.minimum(-xp.log(v51 ** beta * v56 / ratio) / v68, 700.0))
    v73 = xp.minimum(v72, 1e+100)
    v75 = 1.0 + k * v73
    v80 = xp.expm1(beta * xp.log1p(v73 / v75))
    v92 = beta * v73 * (k + (1.0 + v80) / v80 / (v75 + v73)) / v75
    v96 = v73 * xp.exp(xp.minimum(-xp.log(v75 ** beta * v80 / ratio) / v92, 700.0))
    v97 = xp.minimum(v96, 1e+100)
    v99 = 1.0 + k * v97
    v104 = xp.expm1(beta * xp.log1p(v97 / v99))
    v116 = beta * v97 * (k + (1.0 + v104) / v104 / (v99 + v97)) / v99
    v120 = v97 * xp.exp(xp.minimum(-xp.log(v99 ** beta * v104 / ratio) / v116, 700.0))
    v121 = xp.minimum(v120, 1e+100)
    v123 = 1.0 + k * v121
    v128 = xp.expm1(beta * xp.log1p(v121 / v123))
    v140 = beta * v121 * (k + (1.0 + v128) / v128 / (v123 + v121)) / v123
    v144 = v121 * xp.exp(xp.minimum(-xp.log(v123 ** beta * v128 / ratio) / v140, 700.0))
    v145 = xp.minimum(v144, 1e+100)
    v147 = 1.0 + k * v145
    v152 = xp.expm1(beta * xp.log1p(v145 / v147))
    v164 = beta * v145 * (k + (1.0 + v152) / v152 / (v147 + v145)) / v147
    v168 = v145 * xp.exp(xp.minimum(-xp.log(v147 ** beta * v152 / ratio) / v164, 700.0))
    v169 = xp.minimum(v168, 1e+100)
    v171 = 1.0 + k * v169
    v176 = xp.expm1(beta * xp.log1p(v169 / v171))
    v188 = beta * v169 * (k + (1.0 + v176) / v176 / (v171 + v169)) / v171
    v192 = v169 * xp.exp(xp.minimum(-xp.log(v171 ** beta * v176 / ratio) / v188, 700.0))
    v193 = xp.minimum(v192, 1e+100)
    v195 = 1.0 + k * v193
    v200 = xp.expm1(beta * xp.log1p(v193 / v195))
    v212 = beta * v193 * (k + (1.0 + v200) / v200 / (v195 + v193)) / v195
    v216 = v193 * xp.exp(xp.minimum(-xp.log(v195 ** beta * v200 / ratio) / v212, 700.0))
    v217 = xp.minimum(v216, 1e+100)
    v219 = 1.0 + k * v217
    v224 = xp.expm1(beta * xp.log1p(v217 / v219))
    v236 = beta * v217 * (k + (1.0 + v224) / v224 / (v219 + v217)) / v219
    v240 = v217 * xp.exp(xp.minimum(-xp.log(v219 ** beta * v224 / ratio) / v236, 700.0))
    v241 = xp.minimum(v240, 1e+100)
    v243 = 1.0 + k * v241
    v248 = xp.expm1(beta * xp.log1p(v241 / v243))
    v260 = beta * v241 * (k + (1.0 + v248) / v248 / (v243 + v241)) / v243
    v264 = v241 * xp.exp(xp.minimum(-xp.log(v243 ** beta * v248 / ratio) / v260, 700.0))
    v265 = xp.minimum(v264, 1e+100)
    v267 = 1.0 + k * v265
    v272 = xp.expm1(beta * xp.log1p(v265 / v267))
    v284 = beta * v265 * (k + (1.0 + v272) / v272 / (v267 + v265)) / v267
    v288 = v265 * xp.exp(xp.minimum(-xp.log(v267 ** beta * v272 / ratio) / v284, 700.0))
    v289 = xp.minimum(v288, 1e+100)
    v291 = 1.0 + k * v289
    v296 = xp.expm1(beta * xp.log1p(v289 / v291))
    v308 = beta * v289 * (k + (1.0 + v296) / v296 / (v291 + v289)) / v291
    v312 = v289 * xp.exp(xp.minimum(-xp.log(v291 ** beta * v296 / ratio) / v308, 700.0))
    v313 = xp.minimum(v312, 1e+100)
    v315 = 1.0 + k * v313
    v320 = xp.expm1(beta * xp.log1p(v313 / v315))
    v332 = beta * v313 * (k + (1.0 + v320) / v320 / (v315 + v313)) / v315
    v336 = v313 * xp.exp(xp.minimum(-xp.log(v315 ** beta * v320 / ratio) / v332, 700.0))
    v337 = xp.minimum(v336, 1e+100)
    v339 = 1.0 + k * v337
    v344 = xp.expm1(beta * xp.log1p(v337 / v339))
    v356 = beta * v337 * (k + (1.0 + v344) / v344 / (v339 + v337)) / v339
    v360 = v337 * xp.exp(xp.minimum(-xp.log(v339 ** beta * v344 / ratio) / v356, 700.0))
    v361 = xp.minimum(v360, 1e+100)
    v363 = 1.0 + k * v361
    v368 = xp.expm1(beta * xp.log1p(v361 / v363))
    v380 = beta * v361 * (k + (1.0 + v368) / v368 / (v363 + v361)) / v363
    v384 = v361 * xp.exp(xp.minimum(-xp.log(v363 ** beta * v368 / ratio) / v380, 700.0))
    v385 = xp.minimum(v384, 1e+100)
    v387 = 1.0 + k * v385
    v392 = xp.expm1(beta * xp.log1p(v385 / v387))
    v404 = beta * v385 * (k + (1.0 + v392) / v392 / (v387 + v385)) / v387
    v408 = v385 * xp.exp(xp.minimum(-xp.log(v387 ** beta * v392 / ratio) / v404, 700.0))
    v409 = xp.minimum(v408, 1e+100)
    v411 = 1.0 + k * v409
    v416 = xp.expm1(beta * xp.log1p(v409 / v411))
    v428 = beta * v409 * (k + (1.0 + v416) / v416 / (v411 + v409)) / v411
    v432 = v409 * xp.exp(xp.minimum(-xp.log(v411 ** beta * v416 / ratio) / v428, 700.0))
    v433 = xp.minimum(v432, 1e+100)
    v435 = 1.0 + k * v433
    v440 = xp.expm1(beta * xp.log1p(v433 / v435))
    v452 = beta * v433 * (k + (1.0 + v440) / v440 / (v435 + v433)) / v435
    v456 = v433 * xp.exp(xp.minimum(-xp.log(v435 ** beta * v440 / ratio) / v452, 700.0))
    v457 = xp.minimum(v456, 1e+100)
    v459 = 1.0 + k * v457
    v464 = xp.expm1(beta * xp.log1p(v457 / v459))
    v476 = beta * v457 * (k + (1.0 + v464) / v464 / (v459 + v457)) / v459
    v480 = v457 * xp.exp(xp.minimum(-xp.log(v459 ** beta * v464 / ratio) / v476, 700.0))
    return xp.minimum(v480, 1e+100)


def end_power_creep(xp, ratio, t_m, t_h, E, alpha, t_0):
    v1 = t_h > t_m
    v4 = 1.0 - alpha
    v7 = xp.expm1(xp.minimum(xp.log1p(ratio) / v4, 700.0))
    v11 = xp.where(v1, 0.5 * t_m, t_h)
    v10 = sooner(xp, v7, (xp.where(v1, t_h, 2.0 * t_m) - t_m) / t_m, ratio, v4)
    v18 = t_m / xp.where(v1, v10, xp.expm1(xp.minimum(xp.log1p(ratio) / (1.0 - alpha), 700.0)))
    return t_h + v18


def kept_maxwell(xp, t, t_1, since, m, E, tau):
    return E * xp.exp(-since / tau) * fading(xp, t_1 / tau, m)


def kept_standard_solid(xp, t, t_1, since, m, E_inf, E_1, tau):
    return E_inf + E_1 * xp.exp(-since / tau) * fading(xp, t_1 / tau, m)


def kept_power_creep(xp, t, t_1, since, m, E, alpha, t_0):
    v4 = 1.0 - alpha
    v8 = E * (t_0 / t) ** alpha * xp.sin(3.141592653589793 * xp.minimum(alpha, v4))
    v11 = t_1 / t
    v15 = (m + 1.0) / (m + 2.0 + v4)
    v16 = v11 < v15
    v22 = fraction(xp, xp.minimum(xp.where(v16, v11, 0.5 * v15), v15), m, v4)
    v25 = m + v4
    v33 = rising(xp, v25, 1.0 + m - v25) * rising(xp, 1.0, 1.0 + v4 - 1.0) / v4
    v41 = xp.minimum(xp.minimum(since / t, 1.0), 1.0 - v15)
    v36 = v33 / xp.maximum(xp.where(v16, 2.0 * v15, v11), v15) ** m
    v46 = v36 - m / v4 * v41 ** v4 * fraction(xp, v41, v4, m)
    v47 = xp.where(v16, xp.minimum(since / t, 1.0) ** v4 * v22, v46)
    return v8 / (3.141592653589793 * alpha) * v47
