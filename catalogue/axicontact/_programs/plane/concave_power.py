"""Programs of axicontact.plane.concave_power."""

from __future__ import annotations

from math import exp, expm1, fsum, inf, isfinite, log, log1p, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

C0 = np.array(np.nan)
RULE_0 = rule(((3.0, 32), (20.0, 64), (inf, 128)))
RULE_1 = rule(((inf, 64),))
RULE_2 = rule(((16.0, 64), (inf, 128)))


def depth(L, P, a, h, n, E_star):
    if L.__class__ is P.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and L > 1e-30 and (L < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v135 = n / 2.0 + 0.5
            v136 = v135 + 1.75
            v139 = (v135 + 0.5) * (v135 + 1.5)
            v151 = 1.0 / (v136 * v136)
            v180 = n > 2.0
            if v180:
                v182 = n if v180 else 3.0
                v183 = v182 - 2.0
                v192 = log1p((1.2732395447351628 + 0.9883942191601786 * v183 / (v183 + 0.72)) / v183)
                if v183 < 2.0:
                    v198 = log(v183 * (v183 + 2.0) / 2.0) / v183
                    v200 = v192 if v192 > v198 or v192 != v192 else v198
                else:
                    v200 = v192
                v201 = -2.0 * v200
                v203 = -expm1(v201)
                v209 = v182 - 1.0 + 0.0
                v211 = v209 - v182 * exp(-2.0 * (v200 if v200 < 300.0 or v200 != v200 else 300.0))
                v212 = v211 if v211 > 1.0 or v211 != v211 else 1.0
                v213 = v183 + 1.0
                v215 = 1.0 / (v213 * v200)
                v231 = v183 * v200
                v234 = 0.5 * v183
                v250 = []
                for node, weight in RULE_0(1.0 / v215):
                    v216 = node * 1.0
                    v218 = v216 * v216 * v216
                    v220 = v218 * v218 * v216
                    v223 = v220 * v216
                    v226 = -expm1(v201 * v223)
                    v227 = 1.0 - v223
                    v233 = expm1(v231 * v223)
                    v249 = 8.0 * v220 * (exp(v200 * v227) * pow(v226 / v203, -0.5) * (v233 - v234 * (v233 + 1.0) * v226 * (-expm1(v201 * v227) / v203)) / v226)
                    v250.append(weight * v249)
                v250 = fsum(v250) * 1.0
                v251 = v200 * v250
                v256 = 2.0 * v209
                v265 = v200 - log(v251) * v251 / (exp(v231) / (v203 * v212) + (v251 - 1.0) * (v256 / v212 - 1.0 / v203))
                v266 = -2.0 * v265
                v268 = -expm1(v266)
                v273 = v209 - v182 * exp(-2.0 * (v265 if v265 < 300.0 or v265 != v265 else 300.0))
                v274 = v273 if v273 > 1.0 or v273 != v273 else 1.0
                v276 = 1.0 / (v213 * v265)
                v291 = v183 * v265
                v308 = []
                for node, weight in RULE_0(1.0 / v276):
                    v277 = node * 1.0
                    v279 = v277 * v277 * v277
                    v281 = v279 * v279 * v277
                    v283 = v281 * v277
                    v286 = -expm1(v266 * v283)
                    v287 = 1.0 - v283
                    v293 = expm1(v291 * v283)
                    v307 = 8.0 * v281 * (exp(v265 * v287) * pow(v286 / v268, -0.5) * (v293 - v234 * (v293 + 1.0) * v286 * (-expm1(v266 * v287) / v268)) / v286)
                    v308.append(weight * v307)
                v308 = fsum(v308) * 1.0
                v309 = v265 * v308
                v322 = v265 - log(v309) * v309 / (exp(v291) / (v268 * v274) + (v309 - 1.0) * (v256 / v274 - 1.0 / v268))
                v323 = -2.0 * v322
                v325 = -expm1(v323)
                v330 = v209 - v182 * exp(-2.0 * (v322 if v322 < 300.0 or v322 != v322 else 300.0))
                v331 = v330 if v330 > 1.0 or v330 != v330 else 1.0
                v333 = 1.0 / (v213 * v322)
                v348 = v183 * v322
                v365 = []
                for node, weight in RULE_0(1.0 / v333):
                    v334 = node * 1.0
                    v336 = v334 * v334 * v334
                    v338 = v336 * v336 * v334
                    v340 = v338 * v334
                    v343 = -expm1(v323 * v340)
                    v344 = 1.0 - v340
                    v350 = expm1(v348 * v340)
                    v364 = 8.0 * v338 * (exp(v322 * v344) * pow(v343 / v325, -0.5) * (v350 - v234 * (v350 + 1.0) * v343 * (-expm1(v323 * v344) / v325)) / v343)
                    v365.append(weight * v364)
                v365 = fsum(v365) * 1.0
                v366 = v322 * v365
                v379 = v322 - log(v366) * v366 / (exp(v348) / (v325 * v331) + (v366 - 1.0) * (v256 / v331 - 1.0 / v325))
                v380 = -2.0 * v379
                v382 = -expm1(v380)
                v387 = v209 - v182 * exp(-2.0 * (v379 if v379 < 300.0 or v379 != v379 else 300.0))
                v388 = v387 if v387 > 1.0 or v387 != v387 else 1.0
                v390 = 1.0 / (v213 * v379)
                v405 = v183 * v379
                v422 = []
                for node, weight in RULE_0(1.0 / v390):
                    v391 = node * 1.0
                    v393 = v391 * v391 * v391
                    v395 = v393 * v393 * v391
                    v397 = v395 * v391
                    v400 = -expm1(v380 * v397)
                    v401 = 1.0 - v397
                    v407 = expm1(v405 * v397)
                    v421 = 8.0 * v395 * (exp(v379 * v401) * pow(v400 / v382, -0.5) * (v407 - v234 * (v407 + 1.0) * v400 * (-expm1(v380 * v401) / v382)) / v400)
                    v422.append(weight * v421)
                v422 = fsum(v422) * 1.0
                v423 = v379 * v422
                v436 = v379 - log(v423) * v423 / (exp(v405) / (v382 * v388) + (v423 - 1.0) * (v256 / v388 - 1.0 / v382))
                v437 = -2.0 * v436
                v439 = -expm1(v437)
                v444 = v209 - v182 * exp(-2.0 * (v436 if v436 < 300.0 or v436 != v436 else 300.0))
                v445 = v444 if v444 > 1.0 or v444 != v444 else 1.0
                v447 = 1.0 / (v213 * v436)
                v462 = v183 * v436
                v479 = []
                for node, weight in RULE_0(1.0 / v447):
                    v448 = node * 1.0
                    v450 = v448 * v448 * v448
                    v452 = v450 * v450 * v448
                    v454 = v452 * v448
                    v457 = -expm1(v437 * v454)
                    v458 = 1.0 - v454
                    v464 = expm1(v462 * v454)
                    v478 = 8.0 * v452 * (exp(v436 * v458) * pow(v457 / v439, -0.5) * (v464 - v234 * (v464 + 1.0) * v457 * (-expm1(v437 * v458) / v439)) / v457)
                    v479.append(weight * v478)
                v479 = fsum(v479) * 1.0
                v480 = v436 * v479
                v497 = -expm1(-2.0 * (v436 - log(v480) * v480 / (exp(v462) / (v439 * v445) + (v480 - 1.0) * (v256 / v445 - 1.0 / v439))))
            else:
                v497 = 1.0
            if 1.7724538509055159 * E_star * n * h / (2.0 * (n * v497 - 1.0) * ((v135 * (v135 + 1.0) / v139 if v135 < 1.0 else 1.0 - (v135 + 0.75) / v139) * sqrt(v136) * (1.0 + v151 * (((((((0.01524698625788054 * v151 + 0.5334320651111477) * v151 + 2.250488865813539) * v151 + 2.8612106440066865) * v151 + 1.3794681629043655) * v151 + 0.2596058532893223) * v151 + 0.015624999999999823) / ((((((3.278794792785737 * v151 + 49.328555418276075) * v151 + 167.28648538571198) * v151 + 195.37226190335065) * v151 + 90.69722535867314) * v151 + 16.763212110504565) * v151 + 1.0))))) * 0.999999999999999 <= P:
                if a <= L:
                    v6 = L - a
                    v21 = (n + 1.0) / 2.0
                    v23 = v21 + 1.75
                    v28 = (v21 + 0.5) * (v21 + 1.5)
                    v41 = 1.0 / (v23 * v23)
                    if a > 0.0:
                        v84 = v6 / a
                        v91 = sqrt(log1p(v84) if isfinite(v84) else log(L) - log(a))
                        v92 = n + 2.0
                        v94 = 42.0 / v92
                        v99 = v94 / (sqrt(v91 * v91 + v94) + v91)
                        v102 = a / L
                        v113 = -v92
                        v115 = 2.0 * v91
                        v124 = []
                        for node, weight in RULE_1(v99 / 1.0):
                            v105 = node * v99
                            v106 = v91 + v105
                            v112 = sqrt(-expm1(-2.0 * v106 * v106))
                            v123 = exp(v113 * v105 * (v115 + v105)) * (2.0 * v106 / v112) / (1.0 + v112)
                            v124.append(weight * v123)
                        v124 = fsum(v124) * v99
                        v127 = 1.0 + n * (v102 * v102) * v124
                    else:
                        v127 = 1.0
                    value = 2.0 * P * log1p((v6 + sqrt(v6 * (a + L))) / a) / (3.141592653589793 * E_star) - h * L * (v127 / L) / (1.7724538509055159 * ((v21 * (v21 + 1.0) / v28 if v21 < 1.0 else 1.0 - (v21 + 0.75) / v28) * sqrt(v23) * (1.0 + v41 * (((((((0.01524698625788054 * v41 + 0.5334320651111477) * v41 + 2.250488865813539) * v41 + 2.8612106440066865) * v41 + 1.3794681629043655) * v41 + 0.2596058532893223) * v41 + 0.015624999999999823) / ((((((3.278794792785737 * v41 + 49.328555418276075) * v41 + 167.28648538571198) * v41 + 195.37226190335065) * v41 + 90.69722535867314) * v41 + 16.763212110504565) * v41 + 1.0)))))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if value != value and ordinary(L, P, a, h, n, E_star):
                        return value
                    return None
                value = nan
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(L, P, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(L, P, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def minimum_load(h, n, E_star, a=1.0):
    if h.__class__ is n.__class__ is E_star.__class__ is a.__class__ is float and h > 1e-30 and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (a > 1e-30) and (a < 1e+30):
        try:
            v6 = n / 2.0 + 0.5
            v8 = v6 + 1.75
            v12 = (v6 + 0.5) * (v6 + 1.5)
            v26 = 1.0 / (v8 * v8)
            v68 = n > 2.0
            if v68:
                v70 = n if v68 else 3.0
                v71 = v70 - 2.0
                v80 = log1p((1.2732395447351628 + 0.9883942191601786 * v71 / (v71 + 0.72)) / v71)
                if v71 < 2.0:
                    v86 = log(v71 * (v71 + 2.0) / 2.0) / v71
                    v88 = v80 if v80 > v86 or v80 != v80 else v86
                else:
                    v88 = v80
                v90 = -2.0 * v88
                v92 = -expm1(v90)
                v99 = v70 - 1.0 + 0.0
                v101 = v99 - v70 * exp(-2.0 * (v88 if v88 < 300.0 or v88 != v88 else 300.0))
                v102 = v101 if v101 > 1.0 or v101 != v101 else 1.0
                v103 = v71 + 1.0
                v105 = 1.0 / (v103 * v88)
                v121 = v71 * v88
                v124 = 0.5 * v71
                v140 = []
                for node, weight in RULE_0(1.0 / v105):
                    v106 = node * 1.0
                    v108 = v106 * v106 * v106
                    v110 = v108 * v108 * v106
                    v113 = v110 * v106
                    v116 = -expm1(v90 * v113)
                    v117 = 1.0 - v113
                    v123 = expm1(v121 * v113)
                    v139 = 8.0 * v110 * (exp(v88 * v117) * pow(v116 / v92, -0.5) * (v123 - v124 * (v123 + 1.0) * v116 * (-expm1(v90 * v117) / v92)) / v116)
                    v140.append(weight * v139)
                v140 = fsum(v140) * 1.0
                v141 = v88 * v140
                v146 = 2.0 * v99
                v155 = v88 - log(v141) * v141 / (exp(v121) / (v92 * v102) + (v141 - 1.0) * (v146 / v102 - 1.0 / v92))
                v156 = -2.0 * v155
                v158 = -expm1(v156)
                v163 = v99 - v70 * exp(-2.0 * (v155 if v155 < 300.0 or v155 != v155 else 300.0))
                v164 = v163 if v163 > 1.0 or v163 != v163 else 1.0
                v166 = 1.0 / (v103 * v155)
                v181 = v71 * v155
                v198 = []
                for node, weight in RULE_0(1.0 / v166):
                    v167 = node * 1.0
                    v169 = v167 * v167 * v167
                    v171 = v169 * v169 * v167
                    v173 = v171 * v167
                    v176 = -expm1(v156 * v173)
                    v177 = 1.0 - v173
                    v183 = expm1(v181 * v173)
                    v197 = 8.0 * v171 * (exp(v155 * v177) * pow(v176 / v158, -0.5) * (v183 - v124 * (v183 + 1.0) * v176 * (-expm1(v156 * v177) / v158)) / v176)
                    v198.append(weight * v197)
                v198 = fsum(v198) * 1.0
                v199 = v155 * v198
                v212 = v155 - log(v199) * v199 / (exp(v181) / (v158 * v164) + (v199 - 1.0) * (v146 / v164 - 1.0 / v158))
                v213 = -2.0 * v212
                v215 = -expm1(v213)
                v220 = v99 - v70 * exp(-2.0 * (v212 if v212 < 300.0 or v212 != v212 else 300.0))
                v221 = v220 if v220 > 1.0 or v220 != v220 else 1.0
                v223 = 1.0 / (v103 * v212)
                v238 = v71 * v212
                v255 = []
                for node, weight in RULE_0(1.0 / v223):
                    v224 = node * 1.0
                    v226 = v224 * v224 * v224
                    v228 = v226 * v226 * v224
                    v230 = v228 * v224
                    v233 = -expm1(v213 * v230)
                    v234 = 1.0 - v230
                    v240 = expm1(v238 * v230)
                    v254 = 8.0 * v228 * (exp(v212 * v234) * pow(v233 / v215, -0.5) * (v240 - v124 * (v240 + 1.0) * v233 * (-expm1(v213 * v234) / v215)) / v233)
                    v255.append(weight * v254)
                v255 = fsum(v255) * 1.0
                v256 = v212 * v255
                v269 = v212 - log(v256) * v256 / (exp(v238) / (v215 * v221) + (v256 - 1.0) * (v146 / v221 - 1.0 / v215))
                v270 = -2.0 * v269
                v272 = -expm1(v270)
                v277 = v99 - v70 * exp(-2.0 * (v269 if v269 < 300.0 or v269 != v269 else 300.0))
                v278 = v277 if v277 > 1.0 or v277 != v277 else 1.0
                v280 = 1.0 / (v103 * v269)
                v295 = v71 * v269
                v312 = []
                for node, weight in RULE_0(1.0 / v280):
                    v281 = node * 1.0
                    v283 = v281 * v281 * v281
                    v285 = v283 * v283 * v281
                    v287 = v285 * v281
                    v290 = -expm1(v270 * v287)
                    v291 = 1.0 - v287
                    v297 = expm1(v295 * v287)
                    v311 = 8.0 * v285 * (exp(v269 * v291) * pow(v290 / v272, -0.5) * (v297 - v124 * (v297 + 1.0) * v290 * (-expm1(v270 * v291) / v272)) / v290)
                    v312.append(weight * v311)
                v312 = fsum(v312) * 1.0
                v313 = v269 * v312
                v326 = v269 - log(v313) * v313 / (exp(v295) / (v272 * v278) + (v313 - 1.0) * (v146 / v278 - 1.0 / v272))
                v327 = -2.0 * v326
                v329 = -expm1(v327)
                v334 = v99 - v70 * exp(-2.0 * (v326 if v326 < 300.0 or v326 != v326 else 300.0))
                v335 = v334 if v334 > 1.0 or v334 != v334 else 1.0
                v337 = 1.0 / (v103 * v326)
                v352 = v71 * v326
                v369 = []
                for node, weight in RULE_0(1.0 / v337):
                    v338 = node * 1.0
                    v340 = v338 * v338 * v338
                    v342 = v340 * v340 * v338
                    v344 = v342 * v338
                    v347 = -expm1(v327 * v344)
                    v348 = 1.0 - v344
                    v354 = expm1(v352 * v344)
                    v368 = 8.0 * v342 * (exp(v326 * v348) * pow(v347 / v329, -0.5) * (v354 - v124 * (v354 + 1.0) * v347 * (-expm1(v327 * v348) / v329)) / v347)
                    v369.append(weight * v368)
                v369 = fsum(v369) * 1.0
                v370 = v326 * v369
                v387 = -expm1(-2.0 * (v326 - log(v370) * v370 / (exp(v352) / (v329 * v335) + (v370 - 1.0) * (v146 / v335 - 1.0 / v329))))
            else:
                v387 = 1.0
            value = 1.7724538509055159 * E_star * n * h / (2.0 * (n * v387 - 1.0) * ((v6 * (v6 + 1.0) / v12 if v6 < 1.0 else 1.0 - (v6 + 0.75) / v12) * sqrt(v8) * (1.0 + v26 * (((((((0.01524698625788054 * v26 + 0.5334320651111477) * v26 + 2.250488865813539) * v26 + 2.8612106440066865) * v26 + 1.3794681629043655) * v26 + 0.2596058532893223) * v26 + 0.015624999999999823) / ((((((3.278794792785737 * v26 + 49.328555418276075) * v26 + 167.28648538571198) * v26 + 195.37226190335065) * v26 + 90.69722535867314) * v26 + 16.763212110504565) * v26 + 1.0)))))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(h, n, E_star, a):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(x, P, a, h, n, E_star):
    if x.__class__ is P.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v148 = n / 2.0 + 0.5
            v149 = v148 + 1.75
            v152 = (v148 + 0.5) * (v148 + 1.5)
            v164 = 1.0 / (v149 * v149)
            v193 = n > 2.0
            if v193:
                v195 = n if v193 else 3.0
                v196 = v195 - 2.0
                v205 = log1p((1.2732395447351628 + 0.9883942191601786 * v196 / (v196 + 0.72)) / v196)
                if v196 < 2.0:
                    v211 = log(v196 * (v196 + 2.0) / 2.0) / v196
                    v213 = v205 if v205 > v211 or v205 != v205 else v211
                else:
                    v213 = v205
                v214 = -2.0 * v213
                v216 = -expm1(v214)
                v222 = v195 - 1.0 + 0.0
                v224 = v222 - v195 * exp(-2.0 * (v213 if v213 < 300.0 or v213 != v213 else 300.0))
                v225 = v224 if v224 > 1.0 or v224 != v224 else 1.0
                v226 = v196 + 1.0
                v228 = 1.0 / (v226 * v213)
                v244 = v196 * v213
                v247 = 0.5 * v196
                v263 = []
                for node, weight in RULE_0(1.0 / v228):
                    v229 = node * 1.0
                    v231 = v229 * v229 * v229
                    v233 = v231 * v231 * v229
                    v236 = v233 * v229
                    v239 = -expm1(v214 * v236)
                    v240 = 1.0 - v236
                    v246 = expm1(v244 * v236)
                    v262 = 8.0 * v233 * (exp(v213 * v240) * pow(v239 / v216, -0.5) * (v246 - v247 * (v246 + 1.0) * v239 * (-expm1(v214 * v240) / v216)) / v239)
                    v263.append(weight * v262)
                v263 = fsum(v263) * 1.0
                v264 = v213 * v263
                v269 = 2.0 * v222
                v278 = v213 - log(v264) * v264 / (exp(v244) / (v216 * v225) + (v264 - 1.0) * (v269 / v225 - 1.0 / v216))
                v279 = -2.0 * v278
                v281 = -expm1(v279)
                v286 = v222 - v195 * exp(-2.0 * (v278 if v278 < 300.0 or v278 != v278 else 300.0))
                v287 = v286 if v286 > 1.0 or v286 != v286 else 1.0
                v289 = 1.0 / (v226 * v278)
                v304 = v196 * v278
                v321 = []
                for node, weight in RULE_0(1.0 / v289):
                    v290 = node * 1.0
                    v292 = v290 * v290 * v290
                    v294 = v292 * v292 * v290
                    v296 = v294 * v290
                    v299 = -expm1(v279 * v296)
                    v300 = 1.0 - v296
                    v306 = expm1(v304 * v296)
                    v320 = 8.0 * v294 * (exp(v278 * v300) * pow(v299 / v281, -0.5) * (v306 - v247 * (v306 + 1.0) * v299 * (-expm1(v279 * v300) / v281)) / v299)
                    v321.append(weight * v320)
                v321 = fsum(v321) * 1.0
                v322 = v278 * v321
                v335 = v278 - log(v322) * v322 / (exp(v304) / (v281 * v287) + (v322 - 1.0) * (v269 / v287 - 1.0 / v281))
                v336 = -2.0 * v335
                v338 = -expm1(v336)
                v343 = v222 - v195 * exp(-2.0 * (v335 if v335 < 300.0 or v335 != v335 else 300.0))
                v344 = v343 if v343 > 1.0 or v343 != v343 else 1.0
                v346 = 1.0 / (v226 * v335)
                v361 = v196 * v335
                v378 = []
                for node, weight in RULE_0(1.0 / v346):
                    v347 = node * 1.0
                    v349 = v347 * v347 * v347
                    v351 = v349 * v349 * v347
                    v353 = v351 * v347
                    v356 = -expm1(v336 * v353)
                    v357 = 1.0 - v353
                    v363 = expm1(v361 * v353)
                    v377 = 8.0 * v351 * (exp(v335 * v357) * pow(v356 / v338, -0.5) * (v363 - v247 * (v363 + 1.0) * v356 * (-expm1(v336 * v357) / v338)) / v356)
                    v378.append(weight * v377)
                v378 = fsum(v378) * 1.0
                v379 = v335 * v378
                v392 = v335 - log(v379) * v379 / (exp(v361) / (v338 * v344) + (v379 - 1.0) * (v269 / v344 - 1.0 / v338))
                v393 = -2.0 * v392
                v395 = -expm1(v393)
                v400 = v222 - v195 * exp(-2.0 * (v392 if v392 < 300.0 or v392 != v392 else 300.0))
                v401 = v400 if v400 > 1.0 or v400 != v400 else 1.0
                v403 = 1.0 / (v226 * v392)
                v418 = v196 * v392
                v435 = []
                for node, weight in RULE_0(1.0 / v403):
                    v404 = node * 1.0
                    v406 = v404 * v404 * v404
                    v408 = v406 * v406 * v404
                    v410 = v408 * v404
                    v413 = -expm1(v393 * v410)
                    v414 = 1.0 - v410
                    v420 = expm1(v418 * v410)
                    v434 = 8.0 * v408 * (exp(v392 * v414) * pow(v413 / v395, -0.5) * (v420 - v247 * (v420 + 1.0) * v413 * (-expm1(v393 * v414) / v395)) / v413)
                    v435.append(weight * v434)
                v435 = fsum(v435) * 1.0
                v436 = v392 * v435
                v449 = v392 - log(v436) * v436 / (exp(v418) / (v395 * v401) + (v436 - 1.0) * (v269 / v401 - 1.0 / v395))
                v450 = -2.0 * v449
                v452 = -expm1(v450)
                v457 = v222 - v195 * exp(-2.0 * (v449 if v449 < 300.0 or v449 != v449 else 300.0))
                v458 = v457 if v457 > 1.0 or v457 != v457 else 1.0
                v460 = 1.0 / (v226 * v449)
                v475 = v196 * v449
                v492 = []
                for node, weight in RULE_0(1.0 / v460):
                    v461 = node * 1.0
                    v463 = v461 * v461 * v461
                    v465 = v463 * v463 * v461
                    v467 = v465 * v461
                    v470 = -expm1(v450 * v467)
                    v471 = 1.0 - v467
                    v477 = expm1(v475 * v467)
                    v491 = 8.0 * v465 * (exp(v449 * v471) * pow(v470 / v452, -0.5) * (v477 - v247 * (v477 + 1.0) * v470 * (-expm1(v450 * v471) / v452)) / v470)
                    v492.append(weight * v491)
                v492 = fsum(v492) * 1.0
                v493 = v449 * v492
                v510 = -expm1(-2.0 * (v449 - log(v493) * v493 / (exp(v475) / (v452 * v458) + (v493 - 1.0) * (v269 / v458 - 1.0 / v452))))
            else:
                v510 = 1.0
            if 1.7724538509055159 * E_star * n * h / (2.0 * (n * v510 - 1.0) * ((v148 * (v148 + 1.0) / v152 if v148 < 1.0 else 1.0 - (v148 + 0.75) / v152) * sqrt(v149) * (1.0 + v164 * (((((((0.01524698625788054 * v164 + 0.5334320651111477) * v164 + 2.250488865813539) * v164 + 2.8612106440066865) * v164 + 1.3794681629043655) * v164 + 0.2596058532893223) * v164 + 0.015624999999999823) / ((((((3.278794792785737 * v164 + 49.328555418276075) * v164 + 167.28648538571198) * v164 + 195.37226190335065) * v164 + 90.69722535867314) * v164 + 16.763212110504565) * v164 + 1.0))))) * 0.999999999999999 <= P:
                if x <= a and P > 0.0:
                    v6 = a - x
                    v9 = sqrt(v6 * (a + x))
                    v16 = (n + 1.0) / 2.0
                    v18 = v16 + 1.75
                    v23 = (v16 + 0.5) * (v16 + 1.5)
                    v36 = 1.0 / (v18 * v18)
                    v81 = n > 1.0
                    v83 = abs(n - 1.0)
                    if x > 0.0:
                        v94 = v6 / x
                        v100 = log1p(v94) if isfinite(v94) else log(a) - log(x)
                        if v100 > 0.0:
                            v105 = v100 - 42.0 / (v83 if v83 > 0.001 or v83 != v83 else 0.001)
                            v106 = v105 if v105 > 0.0 or v105 != v105 else 0.0
                            v107 = sqrt(v100)
                            v112 = v107 - sqrt(v106) if v81 else sqrt(v100 - v106)
                            v115 = 2.0 * v107
                            v120 = -v83
                            v135 = []
                            for node, weight in RULE_2(v112 / 1.0):
                                v114 = node * v112
                                if v81:
                                    v123 = v107 - v114
                                    v125 = v123 if v123 > 0.0 or v123 != v123 else 0.0
                                else:
                                    v125 = v114
                                v134 = exp(v120 * (v114 * (v115 - v114) if v81 else v114 * v114)) * (2.0 * v125 / sqrt(-expm1(-2.0 * v125 * v125)))
                                v135.append(weight * v134)
                            v135 = fsum(v135) * v112
                            v136 = v135
                        else:
                            v136 = 0.0
                        v138 = (1.0 if v81 else pow(x / a, n) * (a / x)) * v136
                    else:
                        v138 = 1.0 / v83 if v81 else inf
                    value = P / (3.141592653589793 * v9) + E_star * n * h * (1.0 / v9 - n * v138 / a) / (3.5449077018110318 * ((v16 * (v16 + 1.0) / v23 if v16 < 1.0 else 1.0 - (v16 + 0.75) / v23) * sqrt(v18) * (1.0 + v36 * (((((((0.01524698625788054 * v36 + 0.5334320651111477) * v36 + 2.250488865813539) * v36 + 2.8612106440066865) * v36 + 1.3794681629043655) * v36 + 0.2596058532893223) * v36 + 0.015624999999999823) / ((((((3.278794792785737 * v36 + 49.328555418276075) * v36 + 167.28648538571198) * v36 + 195.37226190335065) * v36 + 90.69722535867314) * v36 + 16.763212110504565) * v36 + 1.0)))))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                        return value
                    return None
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(x, a, h, n):
    if x.__class__ is a.__class__ is h.__class__ is n.__class__ is float and x > 1e-30 and (x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            if x <= a:
                value = -h * pow(x, n) / pow(a, n)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_x(a, h, n):
    v5 = np.negative(h)
    v8 = np.power(a, n)
    return (a, n, v5, v8)


def block_profile_x(out, x, a, n, v5, v8, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.power(x, n, out)
        np.multiply(v5, out, out)
        np.divide(out, v8, out)
    if some11 != size:
        np.copyto(out, C0, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, x, a, h, n, t0, m0):
    size = out.size
    np.less_equal(x, a, m0)
    largest_x = largest(x)
    if largest_x == np.inf:
        raise FloatingPointError
    some11 = np.count_nonzero(m0)
    if some11:
        np.negative(h, out)
        np.power(x, n, t0)
        np.multiply(out, t0, t0)
        np.power(a, n, out)
        np.divide(t0, out, out)
    if some11 != size:
        np.copyto(out, C0, where=~m0)


def slope(x, P, a, h, n, E_star):
    if x.__class__ is P.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and x > 1e-30 and (x < 1e+30) and (P > 1e-30) and (P < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v136 = n / 2.0 + 0.5
            v137 = v136 + 1.75
            v140 = (v136 + 0.5) * (v136 + 1.5)
            v152 = 1.0 / (v137 * v137)
            v181 = n > 2.0
            if v181:
                v183 = n if v181 else 3.0
                v184 = v183 - 2.0
                v193 = log1p((1.2732395447351628 + 0.9883942191601786 * v184 / (v184 + 0.72)) / v184)
                if v184 < 2.0:
                    v199 = log(v184 * (v184 + 2.0) / 2.0) / v184
                    v201 = v193 if v193 > v199 or v193 != v193 else v199
                else:
                    v201 = v193
                v202 = -2.0 * v201
                v204 = -expm1(v202)
                v210 = v183 - 1.0 + 0.0
                v212 = v210 - v183 * exp(-2.0 * (v201 if v201 < 300.0 or v201 != v201 else 300.0))
                v213 = v212 if v212 > 1.0 or v212 != v212 else 1.0
                v214 = v184 + 1.0
                v216 = 1.0 / (v214 * v201)
                v232 = v184 * v201
                v235 = 0.5 * v184
                v251 = []
                for node, weight in RULE_0(1.0 / v216):
                    v217 = node * 1.0
                    v219 = v217 * v217 * v217
                    v221 = v219 * v219 * v217
                    v224 = v221 * v217
                    v227 = -expm1(v202 * v224)
                    v228 = 1.0 - v224
                    v234 = expm1(v232 * v224)
                    v250 = 8.0 * v221 * (exp(v201 * v228) * pow(v227 / v204, -0.5) * (v234 - v235 * (v234 + 1.0) * v227 * (-expm1(v202 * v228) / v204)) / v227)
                    v251.append(weight * v250)
                v251 = fsum(v251) * 1.0
                v252 = v201 * v251
                v257 = 2.0 * v210
                v266 = v201 - log(v252) * v252 / (exp(v232) / (v204 * v213) + (v252 - 1.0) * (v257 / v213 - 1.0 / v204))
                v267 = -2.0 * v266
                v269 = -expm1(v267)
                v274 = v210 - v183 * exp(-2.0 * (v266 if v266 < 300.0 or v266 != v266 else 300.0))
                v275 = v274 if v274 > 1.0 or v274 != v274 else 1.0
                v277 = 1.0 / (v214 * v266)
                v292 = v184 * v266
                v309 = []
                for node, weight in RULE_0(1.0 / v277):
                    v278 = node * 1.0
                    v280 = v278 * v278 * v278
                    v282 = v280 * v280 * v278
                    v284 = v282 * v278
                    v287 = -expm1(v267 * v284)
                    v288 = 1.0 - v284
                    v294 = expm1(v292 * v284)
                    v308 = 8.0 * v282 * (exp(v266 * v288) * pow(v287 / v269, -0.5) * (v294 - v235 * (v294 + 1.0) * v287 * (-expm1(v267 * v288) / v269)) / v287)
                    v309.append(weight * v308)
                v309 = fsum(v309) * 1.0
                v310 = v266 * v309
                v323 = v266 - log(v310) * v310 / (exp(v292) / (v269 * v275) + (v310 - 1.0) * (v257 / v275 - 1.0 / v269))
                v324 = -2.0 * v323
                v326 = -expm1(v324)
                v331 = v210 - v183 * exp(-2.0 * (v323 if v323 < 300.0 or v323 != v323 else 300.0))
                v332 = v331 if v331 > 1.0 or v331 != v331 else 1.0
                v334 = 1.0 / (v214 * v323)
                v349 = v184 * v323
                v366 = []
                for node, weight in RULE_0(1.0 / v334):
                    v335 = node * 1.0
                    v337 = v335 * v335 * v335
                    v339 = v337 * v337 * v335
                    v341 = v339 * v335
                    v344 = -expm1(v324 * v341)
                    v345 = 1.0 - v341
                    v351 = expm1(v349 * v341)
                    v365 = 8.0 * v339 * (exp(v323 * v345) * pow(v344 / v326, -0.5) * (v351 - v235 * (v351 + 1.0) * v344 * (-expm1(v324 * v345) / v326)) / v344)
                    v366.append(weight * v365)
                v366 = fsum(v366) * 1.0
                v367 = v323 * v366
                v380 = v323 - log(v367) * v367 / (exp(v349) / (v326 * v332) + (v367 - 1.0) * (v257 / v332 - 1.0 / v326))
                v381 = -2.0 * v380
                v383 = -expm1(v381)
                v388 = v210 - v183 * exp(-2.0 * (v380 if v380 < 300.0 or v380 != v380 else 300.0))
                v389 = v388 if v388 > 1.0 or v388 != v388 else 1.0
                v391 = 1.0 / (v214 * v380)
                v406 = v184 * v380
                v423 = []
                for node, weight in RULE_0(1.0 / v391):
                    v392 = node * 1.0
                    v394 = v392 * v392 * v392
                    v396 = v394 * v394 * v392
                    v398 = v396 * v392
                    v401 = -expm1(v381 * v398)
                    v402 = 1.0 - v398
                    v408 = expm1(v406 * v398)
                    v422 = 8.0 * v396 * (exp(v380 * v402) * pow(v401 / v383, -0.5) * (v408 - v235 * (v408 + 1.0) * v401 * (-expm1(v381 * v402) / v383)) / v401)
                    v423.append(weight * v422)
                v423 = fsum(v423) * 1.0
                v424 = v380 * v423
                v437 = v380 - log(v424) * v424 / (exp(v406) / (v383 * v389) + (v424 - 1.0) * (v257 / v389 - 1.0 / v383))
                v438 = -2.0 * v437
                v440 = -expm1(v438)
                v445 = v210 - v183 * exp(-2.0 * (v437 if v437 < 300.0 or v437 != v437 else 300.0))
                v446 = v445 if v445 > 1.0 or v445 != v445 else 1.0
                v448 = 1.0 / (v214 * v437)
                v463 = v184 * v437
                v480 = []
                for node, weight in RULE_0(1.0 / v448):
                    v449 = node * 1.0
                    v451 = v449 * v449 * v449
                    v453 = v451 * v451 * v449
                    v455 = v453 * v449
                    v458 = -expm1(v438 * v455)
                    v459 = 1.0 - v455
                    v465 = expm1(v463 * v455)
                    v479 = 8.0 * v453 * (exp(v437 * v459) * pow(v458 / v440, -0.5) * (v465 - v235 * (v465 + 1.0) * v458 * (-expm1(v438 * v459) / v440)) / v458)
                    v480.append(weight * v479)
                v480 = fsum(v480) * 1.0
                v481 = v437 * v480
                v498 = -expm1(-2.0 * (v437 - log(v481) * v481 / (exp(v463) / (v440 * v446) + (v481 - 1.0) * (v257 / v446 - 1.0 / v440))))
            else:
                v498 = 1.0
            if 1.7724538509055159 * E_star * n * h / (2.0 * (n * v498 - 1.0) * ((v136 * (v136 + 1.0) / v140 if v136 < 1.0 else 1.0 - (v136 + 0.75) / v140) * sqrt(v137) * (1.0 + v152 * (((((((0.01524698625788054 * v152 + 0.5334320651111477) * v152 + 2.250488865813539) * v152 + 2.8612106440066865) * v152 + 1.3794681629043655) * v152 + 0.2596058532893223) * v152 + 0.015624999999999823) / ((((((3.278794792785737 * v152 + 49.328555418276075) * v152 + 167.28648538571198) * v152 + 195.37226190335065) * v152 + 90.69722535867314) * v152 + 16.763212110504565) * v152 + 1.0))))) * 0.999999999999999 <= P:
                if x >= a:
                    if P > 0.0:
                        v6 = x - a
                        v9 = sqrt(v6 * (a + x))
                        v19 = (n + 1.0) / 2.0
                        v21 = v19 + 1.75
                        v26 = (v19 + 0.5) * (v19 + 1.5)
                        v39 = 1.0 / (v21 * v21)
                        if a > 0.0:
                            v82 = v6 / a
                            v89 = sqrt(log1p(v82) if isfinite(v82) else log(x) - log(a))
                            v90 = n + 2.0
                            v92 = 42.0 / v90
                            v97 = v92 / (sqrt(v89 * v89 + v92) + v89)
                            v100 = a / x
                            v110 = -v90
                            v112 = 2.0 * v89
                            v121 = []
                            for node, weight in RULE_1(v97 / 1.0):
                                v103 = node * v97
                                v104 = v89 + v103
                                v109 = sqrt(-expm1(-2.0 * v104 * v104))
                                v120 = exp(v110 * v103 * (v112 + v103)) * (2.0 * v104 / v109) / (1.0 + v109)
                                v121.append(weight * v120)
                            v121 = fsum(v121) * v97
                            v124 = 1.0 + n * (v100 * v100) * v121
                        else:
                            v124 = 1.0
                        value = -2.0 * P / (3.141592653589793 * E_star * v9) + n * h * (v124 / x - 1.0 / v9) / (1.7724538509055159 * ((v19 * (v19 + 1.0) / v26 if v19 < 1.0 else 1.0 - (v19 + 0.75) / v26) * sqrt(v21) * (1.0 + v39 * (((((((0.01524698625788054 * v39 + 0.5334320651111477) * v39 + 2.250488865813539) * v39 + 2.8612106440066865) * v39 + 1.3794681629043655) * v39 + 0.2596058532893223) * v39 + 0.015624999999999823) / ((((((3.278794792785737 * v39 + 49.328555418276075) * v39 + 167.28648538571198) * v39 + 195.37226190335065) * v39 + 90.69722535867314) * v39 + 16.763212110504565) * v39 + 1.0)))))
                        if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                            return value
                        if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                            return value
                        return None
                    value = 0.0
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                        return value
                    return None
                value = -(-n * h * (pow(x, n) / x if x > 0.0 else pow(x, n - 1.0)) / pow(a, n))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and x > a)) and ordinary(x, P, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def zero_distance(a, n, h=1.0):
    if a.__class__ is n.__class__ is h.__class__ is float and a > 1e-30 and (a < 1e+30) and (n > 1e-30) and (n < 1e+30) and (h > 1e-30) and (h < 1e+30):
        try:
            v3 = n > 2.0
            if v3:
                v5 = n if v3 else 3.0
                v6 = v5 - 2.0
                v15 = log1p((1.2732395447351628 + 0.9883942191601786 * v6 / (v6 + 0.72)) / v6)
                if v6 < 2.0:
                    v22 = log(v6 * (v6 + 2.0) / 2.0) / v6
                    v24 = v15 if v15 > v22 or v15 != v15 else v22
                else:
                    v24 = v15
                v26 = -2.0 * v24
                v28 = -expm1(v26)
                v35 = v5 - 1.0 + 0.0
                v37 = v35 - v5 * exp(-2.0 * (v24 if v24 < 300.0 or v24 != v24 else 300.0))
                v38 = v37 if v37 > 1.0 or v37 != v37 else 1.0
                v39 = v6 + 1.0
                v41 = 1.0 / (v39 * v24)
                v57 = v6 * v24
                v61 = 0.5 * v6
                v77 = []
                for node, weight in RULE_0(1.0 / v41):
                    v42 = node * 1.0
                    v44 = v42 * v42 * v42
                    v46 = v44 * v44 * v42
                    v49 = v46 * v42
                    v52 = -expm1(v26 * v49)
                    v53 = 1.0 - v49
                    v59 = expm1(v57 * v49)
                    v76 = 8.0 * v46 * (exp(v24 * v53) * pow(v52 / v28, -0.5) * (v59 - v61 * (v59 + 1.0) * v52 * (-expm1(v26 * v53) / v28)) / v52)
                    v77.append(weight * v76)
                v77 = fsum(v77) * 1.0
                v78 = v24 * v77
                v83 = 2.0 * v35
                v92 = v24 - log(v78) * v78 / (exp(v57) / (v28 * v38) + (v78 - 1.0) * (v83 / v38 - 1.0 / v28))
                v93 = -2.0 * v92
                v95 = -expm1(v93)
                v100 = v35 - v5 * exp(-2.0 * (v92 if v92 < 300.0 or v92 != v92 else 300.0))
                v101 = v100 if v100 > 1.0 or v100 != v100 else 1.0
                v103 = 1.0 / (v39 * v92)
                v118 = v6 * v92
                v135 = []
                for node, weight in RULE_0(1.0 / v103):
                    v104 = node * 1.0
                    v106 = v104 * v104 * v104
                    v108 = v106 * v106 * v104
                    v110 = v108 * v104
                    v113 = -expm1(v93 * v110)
                    v114 = 1.0 - v110
                    v120 = expm1(v118 * v110)
                    v134 = 8.0 * v108 * (exp(v92 * v114) * pow(v113 / v95, -0.5) * (v120 - v61 * (v120 + 1.0) * v113 * (-expm1(v93 * v114) / v95)) / v113)
                    v135.append(weight * v134)
                v135 = fsum(v135) * 1.0
                v136 = v92 * v135
                v149 = v92 - log(v136) * v136 / (exp(v118) / (v95 * v101) + (v136 - 1.0) * (v83 / v101 - 1.0 / v95))
                v150 = -2.0 * v149
                v152 = -expm1(v150)
                v157 = v35 - v5 * exp(-2.0 * (v149 if v149 < 300.0 or v149 != v149 else 300.0))
                v158 = v157 if v157 > 1.0 or v157 != v157 else 1.0
                v160 = 1.0 / (v39 * v149)
                v175 = v6 * v149
                v192 = []
                for node, weight in RULE_0(1.0 / v160):
                    v161 = node * 1.0
                    v163 = v161 * v161 * v161
                    v165 = v163 * v163 * v161
                    v167 = v165 * v161
                    v170 = -expm1(v150 * v167)
                    v171 = 1.0 - v167
                    v177 = expm1(v175 * v167)
                    v191 = 8.0 * v165 * (exp(v149 * v171) * pow(v170 / v152, -0.5) * (v177 - v61 * (v177 + 1.0) * v170 * (-expm1(v150 * v171) / v152)) / v170)
                    v192.append(weight * v191)
                v192 = fsum(v192) * 1.0
                v193 = v149 * v192
                v206 = v149 - log(v193) * v193 / (exp(v175) / (v152 * v158) + (v193 - 1.0) * (v83 / v158 - 1.0 / v152))
                v207 = -2.0 * v206
                v209 = -expm1(v207)
                v214 = v35 - v5 * exp(-2.0 * (v206 if v206 < 300.0 or v206 != v206 else 300.0))
                v215 = v214 if v214 > 1.0 or v214 != v214 else 1.0
                v217 = 1.0 / (v39 * v206)
                v232 = v6 * v206
                v249 = []
                for node, weight in RULE_0(1.0 / v217):
                    v218 = node * 1.0
                    v220 = v218 * v218 * v218
                    v222 = v220 * v220 * v218
                    v224 = v222 * v218
                    v227 = -expm1(v207 * v224)
                    v228 = 1.0 - v224
                    v234 = expm1(v232 * v224)
                    v248 = 8.0 * v222 * (exp(v206 * v228) * pow(v227 / v209, -0.5) * (v234 - v61 * (v234 + 1.0) * v227 * (-expm1(v207 * v228) / v209)) / v227)
                    v249.append(weight * v248)
                v249 = fsum(v249) * 1.0
                v250 = v206 * v249
                v263 = v206 - log(v250) * v250 / (exp(v232) / (v209 * v215) + (v250 - 1.0) * (v83 / v215 - 1.0 / v209))
                v264 = -2.0 * v263
                v266 = -expm1(v264)
                v271 = v35 - v5 * exp(-2.0 * (v263 if v263 < 300.0 or v263 != v263 else 300.0))
                v272 = v271 if v271 > 1.0 or v271 != v271 else 1.0
                v274 = 1.0 / (v39 * v263)
                v289 = v6 * v263
                v306 = []
                for node, weight in RULE_0(1.0 / v274):
                    v275 = node * 1.0
                    v277 = v275 * v275 * v275
                    v279 = v277 * v277 * v275
                    v281 = v279 * v275
                    v284 = -expm1(v264 * v281)
                    v285 = 1.0 - v281
                    v291 = expm1(v289 * v281)
                    v305 = 8.0 * v279 * (exp(v263 * v285) * pow(v284 / v266, -0.5) * (v291 - v61 * (v291 + 1.0) * v284 * (-expm1(v264 * v285) / v266)) / v284)
                    v306.append(weight * v305)
                v306 = fsum(v306) * 1.0
                v307 = v263 * v306
                v323 = exp(-(v263 - log(v307) * v307 / (exp(v289) / (v266 * v272) + (v307 - 1.0) * (v83 / v272 - 1.0 / v266))))
            else:
                v323 = 0.0
            value = a * v323
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, n, h):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_profile', 1, 'x', 'a', 'h', 'n'): {
        ('x',): (('x',), prepare_profile_x, block_profile_x, 0, 1, (), False),
        ('x', 'a', 'h', 'n'): (('x', 'a', 'h', 'n'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
}
