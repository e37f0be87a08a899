"""Programs of axicontact.normal.concave_power."""

from __future__ import annotations

from math import atan2, exp, expm1, fsum, inf, isfinite, log, log1p, nan, pow, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule

C0 = np.array(np.nan)
C1 = np.array(2.0)
RULE_0 = rule(((3.0, 32), (20.0, 64), (inf, 128)))
RULE_1 = rule(((inf, 64),))
RULE_2 = rule(((16.0, 64), (inf, 128)))


def depth_from_force(F, a, h, n, E_star):
    if F.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            v69 = (v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))
            v70 = n > 2.0
            if v70:
                v72 = n if v70 else 3.0
                v73 = v72 - 2.0
                v82 = log1p((1.2732395447351628 + 0.9883942191601786 * v73 / (v73 + 0.72)) / v73)
                if v73 < 2.0:
                    v88 = log(v73 * (v73 + 2.0) / 2.0) / v73
                    v90 = v82 if v82 > v88 or v82 != v82 else v88
                else:
                    v90 = v82
                v92 = -2.0 * v90
                v94 = -expm1(v92)
                v101 = v72 - 1.0 + 0.0
                v103 = v101 - v72 * exp(-2.0 * (v90 if v90 < 300.0 or v90 != v90 else 300.0))
                v104 = v103 if v103 > 1.0 or v103 != v103 else 1.0
                v105 = v73 + 1.0
                v107 = 1.0 / (v105 * v90)
                v123 = v73 * v90
                v126 = 0.5 * v73
                v142 = []
                for node, weight in RULE_0(1.0 / v107):
                    v108 = node * 1.0
                    v110 = v108 * v108 * v108
                    v112 = v110 * v110 * v108
                    v115 = v112 * v108
                    v118 = -expm1(v92 * v115)
                    v119 = 1.0 - v115
                    v125 = expm1(v123 * v115)
                    v141 = 8.0 * v112 * (exp(v90 * v119) * pow(v118 / v94, -0.5) * (v125 - v126 * (v125 + 1.0) * v118 * (-expm1(v92 * v119) / v94)) / v118)
                    v142.append(weight * v141)
                v142 = fsum(v142) * 1.0
                v143 = v90 * v142
                v148 = 2.0 * v101
                v157 = v90 - log(v143) * v143 / (exp(v123) / (v94 * v104) + (v143 - 1.0) * (v148 / v104 - 1.0 / v94))
                v158 = -2.0 * v157
                v160 = -expm1(v158)
                v165 = v101 - v72 * exp(-2.0 * (v157 if v157 < 300.0 or v157 != v157 else 300.0))
                v166 = v165 if v165 > 1.0 or v165 != v165 else 1.0
                v168 = 1.0 / (v105 * v157)
                v183 = v73 * v157
                v200 = []
                for node, weight in RULE_0(1.0 / v168):
                    v169 = node * 1.0
                    v171 = v169 * v169 * v169
                    v173 = v171 * v171 * v169
                    v175 = v173 * v169
                    v178 = -expm1(v158 * v175)
                    v179 = 1.0 - v175
                    v185 = expm1(v183 * v175)
                    v199 = 8.0 * v173 * (exp(v157 * v179) * pow(v178 / v160, -0.5) * (v185 - v126 * (v185 + 1.0) * v178 * (-expm1(v158 * v179) / v160)) / v178)
                    v200.append(weight * v199)
                v200 = fsum(v200) * 1.0
                v201 = v157 * v200
                v214 = v157 - log(v201) * v201 / (exp(v183) / (v160 * v166) + (v201 - 1.0) * (v148 / v166 - 1.0 / v160))
                v215 = -2.0 * v214
                v217 = -expm1(v215)
                v222 = v101 - v72 * exp(-2.0 * (v214 if v214 < 300.0 or v214 != v214 else 300.0))
                v223 = v222 if v222 > 1.0 or v222 != v222 else 1.0
                v225 = 1.0 / (v105 * v214)
                v240 = v73 * v214
                v257 = []
                for node, weight in RULE_0(1.0 / v225):
                    v226 = node * 1.0
                    v228 = v226 * v226 * v226
                    v230 = v228 * v228 * v226
                    v232 = v230 * v226
                    v235 = -expm1(v215 * v232)
                    v236 = 1.0 - v232
                    v242 = expm1(v240 * v232)
                    v256 = 8.0 * v230 * (exp(v214 * v236) * pow(v235 / v217, -0.5) * (v242 - v126 * (v242 + 1.0) * v235 * (-expm1(v215 * v236) / v217)) / v235)
                    v257.append(weight * v256)
                v257 = fsum(v257) * 1.0
                v258 = v214 * v257
                v271 = v214 - log(v258) * v258 / (exp(v240) / (v217 * v223) + (v258 - 1.0) * (v148 / v223 - 1.0 / v217))
                v272 = -2.0 * v271
                v274 = -expm1(v272)
                v279 = v101 - v72 * exp(-2.0 * (v271 if v271 < 300.0 or v271 != v271 else 300.0))
                v280 = v279 if v279 > 1.0 or v279 != v279 else 1.0
                v282 = 1.0 / (v105 * v271)
                v297 = v73 * v271
                v314 = []
                for node, weight in RULE_0(1.0 / v282):
                    v283 = node * 1.0
                    v285 = v283 * v283 * v283
                    v287 = v285 * v285 * v283
                    v289 = v287 * v283
                    v292 = -expm1(v272 * v289)
                    v293 = 1.0 - v289
                    v299 = expm1(v297 * v289)
                    v313 = 8.0 * v287 * (exp(v271 * v293) * pow(v292 / v274, -0.5) * (v299 - v126 * (v299 + 1.0) * v292 * (-expm1(v272 * v293) / v274)) / v292)
                    v314.append(weight * v313)
                v314 = fsum(v314) * 1.0
                v315 = v271 * v314
                v328 = v271 - log(v315) * v315 / (exp(v297) / (v274 * v280) + (v315 - 1.0) * (v148 / v280 - 1.0 / v274))
                v329 = -2.0 * v328
                v331 = -expm1(v329)
                v336 = v101 - v72 * exp(-2.0 * (v328 if v328 < 300.0 or v328 != v328 else 300.0))
                v337 = v336 if v336 > 1.0 or v336 != v336 else 1.0
                v339 = 1.0 / (v105 * v328)
                v354 = v73 * v328
                v371 = []
                for node, weight in RULE_0(1.0 / v339):
                    v340 = node * 1.0
                    v342 = v340 * v340 * v340
                    v344 = v342 * v342 * v340
                    v346 = v344 * v340
                    v349 = -expm1(v329 * v346)
                    v350 = 1.0 - v346
                    v356 = expm1(v354 * v346)
                    v370 = 8.0 * v344 * (exp(v328 * v350) * pow(v349 / v331, -0.5) * (v356 - v126 * (v356 + 1.0) * v349 * (-expm1(v329 * v350) / v331)) / v349)
                    v371.append(weight * v370)
                v371 = fsum(v371) * 1.0
                v372 = v328 * v371
                v389 = -expm1(-2.0 * (v328 - log(v372) * v372 / (exp(v354) / (v331 * v337) + (v372 - 1.0) * (v148 / v337 - 1.0 / v331))))
            else:
                v389 = 1.0
            v390 = n + 1.0
            if 3.5449077018110318 * E_star * n * h * (v389 + 1.0) * a * v69 / (v390 * (n * v389 - 1.0)) * 0.999999999999999 <= F:
                value = F / (2.0 * E_star * a) - 1.7724538509055159 * h / v390 * v69
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(F, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, d, a, h, n):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            v69 = (v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))
            v129 = n > 2.0
            if v129:
                v131 = n if v129 else 3.0
                v132 = v131 - 2.0
                v141 = log1p((1.2732395447351628 + 0.9883942191601786 * v132 / (v132 + 0.72)) / v132)
                if v132 < 2.0:
                    v147 = log(v132 * (v132 + 2.0) / 2.0) / v132
                    v149 = v141 if v141 > v147 or v141 != v141 else v147
                else:
                    v149 = v141
                v150 = -2.0 * v149
                v152 = -expm1(v150)
                v159 = v131 - 1.0 + 0.0
                v161 = v159 - v131 * exp(-2.0 * (v149 if v149 < 300.0 or v149 != v149 else 300.0))
                v162 = v161 if v161 > 1.0 or v161 != v161 else 1.0
                v163 = v132 + 1.0
                v165 = 1.0 / (v163 * v149)
                v181 = v132 * v149
                v184 = 0.5 * v132
                v200 = []
                for node, weight in RULE_0(1.0 / v165):
                    v166 = node * 1.0
                    v168 = v166 * v166 * v166
                    v170 = v168 * v168 * v166
                    v173 = v170 * v166
                    v176 = -expm1(v150 * v173)
                    v177 = 1.0 - v173
                    v183 = expm1(v181 * v173)
                    v199 = 8.0 * v170 * (exp(v149 * v177) * pow(v176 / v152, -0.5) * (v183 - v184 * (v183 + 1.0) * v176 * (-expm1(v150 * v177) / v152)) / v176)
                    v200.append(weight * v199)
                v200 = fsum(v200) * 1.0
                v201 = v149 * v200
                v206 = 2.0 * v159
                v215 = v149 - log(v201) * v201 / (exp(v181) / (v152 * v162) + (v201 - 1.0) * (v206 / v162 - 1.0 / v152))
                v216 = -2.0 * v215
                v218 = -expm1(v216)
                v223 = v159 - v131 * exp(-2.0 * (v215 if v215 < 300.0 or v215 != v215 else 300.0))
                v224 = v223 if v223 > 1.0 or v223 != v223 else 1.0
                v226 = 1.0 / (v163 * v215)
                v241 = v132 * v215
                v258 = []
                for node, weight in RULE_0(1.0 / v226):
                    v227 = node * 1.0
                    v229 = v227 * v227 * v227
                    v231 = v229 * v229 * v227
                    v233 = v231 * v227
                    v236 = -expm1(v216 * v233)
                    v237 = 1.0 - v233
                    v243 = expm1(v241 * v233)
                    v257 = 8.0 * v231 * (exp(v215 * v237) * pow(v236 / v218, -0.5) * (v243 - v184 * (v243 + 1.0) * v236 * (-expm1(v216 * v237) / v218)) / v236)
                    v258.append(weight * v257)
                v258 = fsum(v258) * 1.0
                v259 = v215 * v258
                v272 = v215 - log(v259) * v259 / (exp(v241) / (v218 * v224) + (v259 - 1.0) * (v206 / v224 - 1.0 / v218))
                v273 = -2.0 * v272
                v275 = -expm1(v273)
                v280 = v159 - v131 * exp(-2.0 * (v272 if v272 < 300.0 or v272 != v272 else 300.0))
                v281 = v280 if v280 > 1.0 or v280 != v280 else 1.0
                v283 = 1.0 / (v163 * v272)
                v298 = v132 * v272
                v315 = []
                for node, weight in RULE_0(1.0 / v283):
                    v284 = node * 1.0
                    v286 = v284 * v284 * v284
                    v288 = v286 * v286 * v284
                    v290 = v288 * v284
                    v293 = -expm1(v273 * v290)
                    v294 = 1.0 - v290
                    v300 = expm1(v298 * v290)
                    v314 = 8.0 * v288 * (exp(v272 * v294) * pow(v293 / v275, -0.5) * (v300 - v184 * (v300 + 1.0) * v293 * (-expm1(v273 * v294) / v275)) / v293)
                    v315.append(weight * v314)
                v315 = fsum(v315) * 1.0
                v316 = v272 * v315
                v329 = v272 - log(v316) * v316 / (exp(v298) / (v275 * v281) + (v316 - 1.0) * (v206 / v281 - 1.0 / v275))
                v330 = -2.0 * v329
                v332 = -expm1(v330)
                v337 = v159 - v131 * exp(-2.0 * (v329 if v329 < 300.0 or v329 != v329 else 300.0))
                v338 = v337 if v337 > 1.0 or v337 != v337 else 1.0
                v340 = 1.0 / (v163 * v329)
                v355 = v132 * v329
                v372 = []
                for node, weight in RULE_0(1.0 / v340):
                    v341 = node * 1.0
                    v343 = v341 * v341 * v341
                    v345 = v343 * v343 * v341
                    v347 = v345 * v341
                    v350 = -expm1(v330 * v347)
                    v351 = 1.0 - v347
                    v357 = expm1(v355 * v347)
                    v371 = 8.0 * v345 * (exp(v329 * v351) * pow(v350 / v332, -0.5) * (v357 - v184 * (v357 + 1.0) * v350 * (-expm1(v330 * v351) / v332)) / v350)
                    v372.append(weight * v371)
                v372 = fsum(v372) * 1.0
                v373 = v329 * v372
                v386 = v329 - log(v373) * v373 / (exp(v355) / (v332 * v338) + (v373 - 1.0) * (v206 / v338 - 1.0 / v332))
                v387 = -2.0 * v386
                v389 = -expm1(v387)
                v394 = v159 - v131 * exp(-2.0 * (v386 if v386 < 300.0 or v386 != v386 else 300.0))
                v395 = v394 if v394 > 1.0 or v394 != v394 else 1.0
                v397 = 1.0 / (v163 * v386)
                v412 = v132 * v386
                v429 = []
                for node, weight in RULE_0(1.0 / v397):
                    v398 = node * 1.0
                    v400 = v398 * v398 * v398
                    v402 = v400 * v400 * v398
                    v404 = v402 * v398
                    v407 = -expm1(v387 * v404)
                    v408 = 1.0 - v404
                    v414 = expm1(v412 * v404)
                    v428 = 8.0 * v402 * (exp(v386 * v408) * pow(v407 / v389, -0.5) * (v414 - v184 * (v414 + 1.0) * v407 * (-expm1(v387 * v408) / v389)) / v407)
                    v429.append(weight * v428)
                v429 = fsum(v429) * 1.0
                v430 = v386 * v429
                v447 = -expm1(-2.0 * (v386 - log(v430) * v430 / (exp(v412) / (v389 * v395) + (v430 - 1.0) * (v206 / v395 - 1.0 / v389))))
            else:
                v447 = 1.0
            if 1.7724538509055159 * h * v69 / (n * v447 - 1.0) * 0.999999999999999 <= d:
                if r > a:
                    v70 = r - a
                    v82 = v70 / a
                    v89 = sqrt(log1p(v82) if isfinite(v82) else log(r) - log(a))
                    v90 = n + 1.0
                    v92 = 42.0 / v90
                    v97 = v92 / (sqrt(v89 * v89 + v92) + v89)
                    v101 = -v90
                    v103 = 2.0 * v89
                    v116 = []
                    for node, weight in RULE_1(v97 / 1.0):
                        v99 = node * v97
                        v100 = v89 + v99
                        v115 = exp(v101 * v99 * (v103 + v99)) * (2.0 * v100 / sqrt(-expm1(-2.0 * v100 * v100)))
                        v116.append(weight * v115)
                    v116 = fsum(v116) * v97
                    value = 2.0 * d * atan2(a, sqrt(v70 * (a + r))) / 3.141592653589793 + 2.0 * h / 1.7724538509055159 * (a / r * v116) * v69
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n):
                        return value
                    return None
                value = d - (-h * pow(r / a, n) if r <= a else nan)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def energy(d, a, h, n, E_star):
    if d.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            v69 = (v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))
            v87 = n > 2.0
            if v87:
                v89 = n if v87 else 3.0
                v90 = v89 - 2.0
                v99 = log1p((1.2732395447351628 + 0.9883942191601786 * v90 / (v90 + 0.72)) / v90)
                if v90 < 2.0:
                    v105 = log(v90 * (v90 + 2.0) / 2.0) / v90
                    v107 = v99 if v99 > v105 or v99 != v99 else v105
                else:
                    v107 = v99
                v109 = -2.0 * v107
                v111 = -expm1(v109)
                v118 = v89 - 1.0 + 0.0
                v120 = v118 - v89 * exp(-2.0 * (v107 if v107 < 300.0 or v107 != v107 else 300.0))
                v121 = v120 if v120 > 1.0 or v120 != v120 else 1.0
                v122 = v90 + 1.0
                v124 = 1.0 / (v122 * v107)
                v140 = v90 * v107
                v143 = 0.5 * v90
                v159 = []
                for node, weight in RULE_0(1.0 / v124):
                    v125 = node * 1.0
                    v127 = v125 * v125 * v125
                    v129 = v127 * v127 * v125
                    v132 = v129 * v125
                    v135 = -expm1(v109 * v132)
                    v136 = 1.0 - v132
                    v142 = expm1(v140 * v132)
                    v158 = 8.0 * v129 * (exp(v107 * v136) * pow(v135 / v111, -0.5) * (v142 - v143 * (v142 + 1.0) * v135 * (-expm1(v109 * v136) / v111)) / v135)
                    v159.append(weight * v158)
                v159 = fsum(v159) * 1.0
                v160 = v107 * v159
                v165 = 2.0 * v118
                v174 = v107 - log(v160) * v160 / (exp(v140) / (v111 * v121) + (v160 - 1.0) * (v165 / v121 - 1.0 / v111))
                v175 = -2.0 * v174
                v177 = -expm1(v175)
                v182 = v118 - v89 * exp(-2.0 * (v174 if v174 < 300.0 or v174 != v174 else 300.0))
                v183 = v182 if v182 > 1.0 or v182 != v182 else 1.0
                v185 = 1.0 / (v122 * v174)
                v200 = v90 * v174
                v217 = []
                for node, weight in RULE_0(1.0 / v185):
                    v186 = node * 1.0
                    v188 = v186 * v186 * v186
                    v190 = v188 * v188 * v186
                    v192 = v190 * v186
                    v195 = -expm1(v175 * v192)
                    v196 = 1.0 - v192
                    v202 = expm1(v200 * v192)
                    v216 = 8.0 * v190 * (exp(v174 * v196) * pow(v195 / v177, -0.5) * (v202 - v143 * (v202 + 1.0) * v195 * (-expm1(v175 * v196) / v177)) / v195)
                    v217.append(weight * v216)
                v217 = fsum(v217) * 1.0
                v218 = v174 * v217
                v231 = v174 - log(v218) * v218 / (exp(v200) / (v177 * v183) + (v218 - 1.0) * (v165 / v183 - 1.0 / v177))
                v232 = -2.0 * v231
                v234 = -expm1(v232)
                v239 = v118 - v89 * exp(-2.0 * (v231 if v231 < 300.0 or v231 != v231 else 300.0))
                v240 = v239 if v239 > 1.0 or v239 != v239 else 1.0
                v242 = 1.0 / (v122 * v231)
                v257 = v90 * v231
                v274 = []
                for node, weight in RULE_0(1.0 / v242):
                    v243 = node * 1.0
                    v245 = v243 * v243 * v243
                    v247 = v245 * v245 * v243
                    v249 = v247 * v243
                    v252 = -expm1(v232 * v249)
                    v253 = 1.0 - v249
                    v259 = expm1(v257 * v249)
                    v273 = 8.0 * v247 * (exp(v231 * v253) * pow(v252 / v234, -0.5) * (v259 - v143 * (v259 + 1.0) * v252 * (-expm1(v232 * v253) / v234)) / v252)
                    v274.append(weight * v273)
                v274 = fsum(v274) * 1.0
                v275 = v231 * v274
                v288 = v231 - log(v275) * v275 / (exp(v257) / (v234 * v240) + (v275 - 1.0) * (v165 / v240 - 1.0 / v234))
                v289 = -2.0 * v288
                v291 = -expm1(v289)
                v296 = v118 - v89 * exp(-2.0 * (v288 if v288 < 300.0 or v288 != v288 else 300.0))
                v297 = v296 if v296 > 1.0 or v296 != v296 else 1.0
                v299 = 1.0 / (v122 * v288)
                v314 = v90 * v288
                v331 = []
                for node, weight in RULE_0(1.0 / v299):
                    v300 = node * 1.0
                    v302 = v300 * v300 * v300
                    v304 = v302 * v302 * v300
                    v306 = v304 * v300
                    v309 = -expm1(v289 * v306)
                    v310 = 1.0 - v306
                    v316 = expm1(v314 * v306)
                    v330 = 8.0 * v304 * (exp(v288 * v310) * pow(v309 / v291, -0.5) * (v316 - v143 * (v316 + 1.0) * v309 * (-expm1(v289 * v310) / v291)) / v309)
                    v331.append(weight * v330)
                v331 = fsum(v331) * 1.0
                v332 = v288 * v331
                v345 = v288 - log(v332) * v332 / (exp(v314) / (v291 * v297) + (v332 - 1.0) * (v165 / v297 - 1.0 / v291))
                v346 = -2.0 * v345
                v348 = -expm1(v346)
                v353 = v118 - v89 * exp(-2.0 * (v345 if v345 < 300.0 or v345 != v345 else 300.0))
                v354 = v353 if v353 > 1.0 or v353 != v353 else 1.0
                v356 = 1.0 / (v122 * v345)
                v371 = v90 * v345
                v388 = []
                for node, weight in RULE_0(1.0 / v356):
                    v357 = node * 1.0
                    v359 = v357 * v357 * v357
                    v361 = v359 * v359 * v357
                    v363 = v361 * v357
                    v366 = -expm1(v346 * v363)
                    v367 = 1.0 - v363
                    v373 = expm1(v371 * v363)
                    v387 = 8.0 * v361 * (exp(v345 * v367) * pow(v366 / v348, -0.5) * (v373 - v143 * (v373 + 1.0) * v366 * (-expm1(v346 * v367) / v348)) / v366)
                    v388.append(weight * v387)
                v388 = fsum(v388) * 1.0
                v389 = v345 * v388
                v406 = -expm1(-2.0 * (v345 - log(v389) * v389 / (exp(v371) / (v348 * v354) + (v389 - 1.0) * (v165 / v354 - 1.0 / v348))))
            else:
                v406 = 1.0
            if 1.7724538509055159 * h * v69 / (n * v406 - 1.0) * 0.999999999999999 <= d:
                value = E_star * a * (d * d + 3.5449077018110318 * h / (n + 1.0) * d * v69 + 3.141592653589793 * (h * h) / (2.0 * n + 1.0) * (v69 * v69))
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(d, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def force(d, a, h, n, E_star):
    if d.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v8 = n / 2.0 + 0.5
            v10 = v8 + 1.75
            v14 = (v8 + 0.5) * (v8 + 1.5)
            v28 = 1.0 / (v10 * v10)
            v69 = (v8 * (v8 + 1.0) / v14 if v8 < 1.0 else 1.0 - (v8 + 0.75) / v14) * sqrt(v10) * (1.0 + v28 * (((((((0.01524698625788054 * v28 + 0.5334320651111477) * v28 + 2.250488865813539) * v28 + 2.8612106440066865) * v28 + 1.3794681629043655) * v28 + 0.2596058532893223) * v28 + 0.015624999999999823) / ((((((3.278794792785737 * v28 + 49.328555418276075) * v28 + 167.28648538571198) * v28 + 195.37226190335065) * v28 + 90.69722535867314) * v28 + 16.763212110504565) * v28 + 1.0)))
            v70 = n > 2.0
            if v70:
                v72 = n if v70 else 3.0
                v73 = v72 - 2.0
                v82 = log1p((1.2732395447351628 + 0.9883942191601786 * v73 / (v73 + 0.72)) / v73)
                if v73 < 2.0:
                    v88 = log(v73 * (v73 + 2.0) / 2.0) / v73
                    v90 = v82 if v82 > v88 or v82 != v82 else v88
                else:
                    v90 = v82
                v92 = -2.0 * v90
                v94 = -expm1(v92)
                v101 = v72 - 1.0 + 0.0
                v103 = v101 - v72 * exp(-2.0 * (v90 if v90 < 300.0 or v90 != v90 else 300.0))
                v104 = v103 if v103 > 1.0 or v103 != v103 else 1.0
                v105 = v73 + 1.0
                v107 = 1.0 / (v105 * v90)
                v123 = v73 * v90
                v126 = 0.5 * v73
                v142 = []
                for node, weight in RULE_0(1.0 / v107):
                    v108 = node * 1.0
                    v110 = v108 * v108 * v108
                    v112 = v110 * v110 * v108
                    v115 = v112 * v108
                    v118 = -expm1(v92 * v115)
                    v119 = 1.0 - v115
                    v125 = expm1(v123 * v115)
                    v141 = 8.0 * v112 * (exp(v90 * v119) * pow(v118 / v94, -0.5) * (v125 - v126 * (v125 + 1.0) * v118 * (-expm1(v92 * v119) / v94)) / v118)
                    v142.append(weight * v141)
                v142 = fsum(v142) * 1.0
                v143 = v90 * v142
                v148 = 2.0 * v101
                v157 = v90 - log(v143) * v143 / (exp(v123) / (v94 * v104) + (v143 - 1.0) * (v148 / v104 - 1.0 / v94))
                v158 = -2.0 * v157
                v160 = -expm1(v158)
                v165 = v101 - v72 * exp(-2.0 * (v157 if v157 < 300.0 or v157 != v157 else 300.0))
                v166 = v165 if v165 > 1.0 or v165 != v165 else 1.0
                v168 = 1.0 / (v105 * v157)
                v183 = v73 * v157
                v200 = []
                for node, weight in RULE_0(1.0 / v168):
                    v169 = node * 1.0
                    v171 = v169 * v169 * v169
                    v173 = v171 * v171 * v169
                    v175 = v173 * v169
                    v178 = -expm1(v158 * v175)
                    v179 = 1.0 - v175
                    v185 = expm1(v183 * v175)
                    v199 = 8.0 * v173 * (exp(v157 * v179) * pow(v178 / v160, -0.5) * (v185 - v126 * (v185 + 1.0) * v178 * (-expm1(v158 * v179) / v160)) / v178)
                    v200.append(weight * v199)
                v200 = fsum(v200) * 1.0
                v201 = v157 * v200
                v214 = v157 - log(v201) * v201 / (exp(v183) / (v160 * v166) + (v201 - 1.0) * (v148 / v166 - 1.0 / v160))
                v215 = -2.0 * v214
                v217 = -expm1(v215)
                v222 = v101 - v72 * exp(-2.0 * (v214 if v214 < 300.0 or v214 != v214 else 300.0))
                v223 = v222 if v222 > 1.0 or v222 != v222 else 1.0
                v225 = 1.0 / (v105 * v214)
                v240 = v73 * v214
                v257 = []
                for node, weight in RULE_0(1.0 / v225):
                    v226 = node * 1.0
                    v228 = v226 * v226 * v226
                    v230 = v228 * v228 * v226
                    v232 = v230 * v226
                    v235 = -expm1(v215 * v232)
                    v236 = 1.0 - v232
                    v242 = expm1(v240 * v232)
                    v256 = 8.0 * v230 * (exp(v214 * v236) * pow(v235 / v217, -0.5) * (v242 - v126 * (v242 + 1.0) * v235 * (-expm1(v215 * v236) / v217)) / v235)
                    v257.append(weight * v256)
                v257 = fsum(v257) * 1.0
                v258 = v214 * v257
                v271 = v214 - log(v258) * v258 / (exp(v240) / (v217 * v223) + (v258 - 1.0) * (v148 / v223 - 1.0 / v217))
                v272 = -2.0 * v271
                v274 = -expm1(v272)
                v279 = v101 - v72 * exp(-2.0 * (v271 if v271 < 300.0 or v271 != v271 else 300.0))
                v280 = v279 if v279 > 1.0 or v279 != v279 else 1.0
                v282 = 1.0 / (v105 * v271)
                v297 = v73 * v271
                v314 = []
                for node, weight in RULE_0(1.0 / v282):
                    v283 = node * 1.0
                    v285 = v283 * v283 * v283
                    v287 = v285 * v285 * v283
                    v289 = v287 * v283
                    v292 = -expm1(v272 * v289)
                    v293 = 1.0 - v289
                    v299 = expm1(v297 * v289)
                    v313 = 8.0 * v287 * (exp(v271 * v293) * pow(v292 / v274, -0.5) * (v299 - v126 * (v299 + 1.0) * v292 * (-expm1(v272 * v293) / v274)) / v292)
                    v314.append(weight * v313)
                v314 = fsum(v314) * 1.0
                v315 = v271 * v314
                v328 = v271 - log(v315) * v315 / (exp(v297) / (v274 * v280) + (v315 - 1.0) * (v148 / v280 - 1.0 / v274))
                v329 = -2.0 * v328
                v331 = -expm1(v329)
                v336 = v101 - v72 * exp(-2.0 * (v328 if v328 < 300.0 or v328 != v328 else 300.0))
                v337 = v336 if v336 > 1.0 or v336 != v336 else 1.0
                v339 = 1.0 / (v105 * v328)
                v354 = v73 * v328
                v371 = []
                for node, weight in RULE_0(1.0 / v339):
                    v340 = node * 1.0
                    v342 = v340 * v340 * v340
                    v344 = v342 * v342 * v340
                    v346 = v344 * v340
                    v349 = -expm1(v329 * v346)
                    v350 = 1.0 - v346
                    v356 = expm1(v354 * v346)
                    v370 = 8.0 * v344 * (exp(v328 * v350) * pow(v349 / v331, -0.5) * (v356 - v126 * (v356 + 1.0) * v349 * (-expm1(v329 * v350) / v331)) / v349)
                    v371.append(weight * v370)
                v371 = fsum(v371) * 1.0
                v372 = v328 * v371
                v389 = -expm1(-2.0 * (v328 - log(v372) * v372 / (exp(v354) / (v331 * v337) + (v372 - 1.0) * (v148 / v337 - 1.0 / v331))))
            else:
                v389 = 1.0
            v393 = 1.7724538509055159 * h
            if v393 * v69 / (n * v389 - 1.0) * 0.999999999999999 <= d:
                value = 2.0 * E_star * a * (d + v393 / (n + 1.0) * v69)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(d, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def load_within(r, d, a, h, n, E_star):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v9 = n / 2.0 + 0.5
            v11 = v9 + 1.75
            v15 = (v9 + 0.5) * (v9 + 1.5)
            v29 = 1.0 / (v11 * v11)
            v70 = (v9 * (v9 + 1.0) / v15 if v9 < 1.0 else 1.0 - (v9 + 0.75) / v15) * sqrt(v11) * (1.0 + v29 * (((((((0.01524698625788054 * v29 + 0.5334320651111477) * v29 + 2.250488865813539) * v29 + 2.8612106440066865) * v29 + 1.3794681629043655) * v29 + 0.2596058532893223) * v29 + 0.015624999999999823) / ((((((3.278794792785737 * v29 + 49.328555418276075) * v29 + 167.28648538571198) * v29 + 195.37226190335065) * v29 + 90.69722535867314) * v29 + 16.763212110504565) * v29 + 1.0)))
            v142 = 1.7724538509055159 * h
            v158 = n > 2.0
            v160 = n if v158 else 3.0
            v161 = v160 - 2.0
            v170 = log1p((1.2732395447351628 + 0.9883942191601786 * v161 / (v161 + 0.72)) / v161)
            if v161 < 2.0:
                v176 = log(v161 * (v161 + 2.0) / 2.0) / v161
                v178 = v170 if v170 > v176 or v170 != v170 else v176
            else:
                v178 = v170
            v179 = -2.0 * v178
            v181 = -expm1(v179)
            v187 = v160 - 1.0 + 0.0
            v189 = v187 - v160 * exp(-2.0 * (v178 if v178 < 300.0 or v178 != v178 else 300.0))
            v190 = v189 if v189 > 1.0 or v189 != v189 else 1.0
            v191 = v161 + 1.0
            v193 = 1.0 / (v191 * v178)
            v209 = v161 * v178
            v212 = 0.5 * v161
            v232 = exp(v209) / (v181 * v190)
            v234 = 2.0 * v187
            v237 = v234 / v190 - 1.0 / v181
            if v158:
                v228 = []
                for node, weight in RULE_0(1.0 / v193):
                    v194 = node * 1.0
                    v196 = v194 * v194 * v194
                    v198 = v196 * v196 * v194
                    v201 = v198 * v194
                    v204 = -expm1(v179 * v201)
                    v205 = 1.0 - v201
                    v211 = expm1(v209 * v201)
                    v227 = 8.0 * v198 * (exp(v178 * v205) * pow(v204 / v181, -0.5) * (v211 - v212 * (v211 + 1.0) * v204 * (-expm1(v179 * v205) / v181)) / v204)
                    v228.append(weight * v227)
                v228 = fsum(v228) * 1.0
                v229 = v178 * v228
                v243 = v178 - log(v229) * v229 / (v232 + (v229 - 1.0) * v237)
                v244 = -2.0 * v243
                v246 = -expm1(v244)
                v251 = v187 - v160 * exp(-2.0 * (v243 if v243 < 300.0 or v243 != v243 else 300.0))
                v252 = v251 if v251 > 1.0 or v251 != v251 else 1.0
                v254 = 1.0 / (v191 * v243)
                v269 = v161 * v243
                v286 = []
                for node, weight in RULE_0(1.0 / v254):
                    v255 = node * 1.0
                    v257 = v255 * v255 * v255
                    v259 = v257 * v257 * v255
                    v261 = v259 * v255
                    v264 = -expm1(v244 * v261)
                    v265 = 1.0 - v261
                    v271 = expm1(v269 * v261)
                    v285 = 8.0 * v259 * (exp(v243 * v265) * pow(v264 / v246, -0.5) * (v271 - v212 * (v271 + 1.0) * v264 * (-expm1(v244 * v265) / v246)) / v264)
                    v286.append(weight * v285)
                v286 = fsum(v286) * 1.0
                v287 = v243 * v286
                v300 = v243 - log(v287) * v287 / (exp(v269) / (v246 * v252) + (v287 - 1.0) * (v234 / v252 - 1.0 / v246))
                v301 = -2.0 * v300
                v303 = -expm1(v301)
                v308 = v187 - v160 * exp(-2.0 * (v300 if v300 < 300.0 or v300 != v300 else 300.0))
                v309 = v308 if v308 > 1.0 or v308 != v308 else 1.0
                v311 = 1.0 / (v191 * v300)
                v326 = v161 * v300
                v343 = []
                for node, weight in RULE_0(1.0 / v311):
                    v312 = node * 1.0
                    v314 = v312 * v312 * v312
                    v316 = v314 * v314 * v312
                    v318 = v316 * v312
                    v321 = -expm1(v301 * v318)
                    v322 = 1.0 - v318
                    v328 = expm1(v326 * v318)
                    v342 = 8.0 * v316 * (exp(v300 * v322) * pow(v321 / v303, -0.5) * (v328 - v212 * (v328 + 1.0) * v321 * (-expm1(v301 * v322) / v303)) / v321)
                    v343.append(weight * v342)
                v343 = fsum(v343) * 1.0
                v344 = v300 * v343
                v357 = v300 - log(v344) * v344 / (exp(v326) / (v303 * v309) + (v344 - 1.0) * (v234 / v309 - 1.0 / v303))
                v358 = -2.0 * v357
                v360 = -expm1(v358)
                v365 = v187 - v160 * exp(-2.0 * (v357 if v357 < 300.0 or v357 != v357 else 300.0))
                v366 = v365 if v365 > 1.0 or v365 != v365 else 1.0
                v368 = 1.0 / (v191 * v357)
                v383 = v161 * v357
                v400 = []
                for node, weight in RULE_0(1.0 / v368):
                    v369 = node * 1.0
                    v371 = v369 * v369 * v369
                    v373 = v371 * v371 * v369
                    v375 = v373 * v369
                    v378 = -expm1(v358 * v375)
                    v379 = 1.0 - v375
                    v385 = expm1(v383 * v375)
                    v399 = 8.0 * v373 * (exp(v357 * v379) * pow(v378 / v360, -0.5) * (v385 - v212 * (v385 + 1.0) * v378 * (-expm1(v358 * v379) / v360)) / v378)
                    v400.append(weight * v399)
                v400 = fsum(v400) * 1.0
                v401 = v357 * v400
                v414 = v357 - log(v401) * v401 / (exp(v383) / (v360 * v366) + (v401 - 1.0) * (v234 / v366 - 1.0 / v360))
                v415 = -2.0 * v414
                v417 = -expm1(v415)
                v422 = v187 - v160 * exp(-2.0 * (v414 if v414 < 300.0 or v414 != v414 else 300.0))
                v423 = v422 if v422 > 1.0 or v422 != v422 else 1.0
                v425 = 1.0 / (v191 * v414)
                v440 = v161 * v414
                v457 = []
                for node, weight in RULE_0(1.0 / v425):
                    v426 = node * 1.0
                    v428 = v426 * v426 * v426
                    v430 = v428 * v428 * v426
                    v432 = v430 * v426
                    v435 = -expm1(v415 * v432)
                    v436 = 1.0 - v432
                    v442 = expm1(v440 * v432)
                    v456 = 8.0 * v430 * (exp(v414 * v436) * pow(v435 / v417, -0.5) * (v442 - v212 * (v442 + 1.0) * v435 * (-expm1(v415 * v436) / v417)) / v435)
                    v457.append(weight * v456)
                v457 = fsum(v457) * 1.0
                v458 = v414 * v457
                v475 = -expm1(-2.0 * (v414 - log(v458) * v458 / (exp(v440) / (v417 * v423) + (v458 - 1.0) * (v234 / v423 - 1.0 / v417))))
            else:
                v475 = 1.0
            v478 = v142 * v70
            if v478 / (n * v475 - 1.0) * 0.999999999999999 <= d:
                v153 = 2.0 * E_star
                v154 = n + 1.0
                if r < a:
                    v71 = a - r
                    v75 = n > 1.0
                    v77 = abs(n - 1.0)
                    if r > 0.0:
                        v88 = v71 / r
                        v94 = log1p(v88) if isfinite(v88) else log(a) - log(r)
                        if v94 > 0.0:
                            v99 = v94 - 42.0 / (v77 if v77 > 0.001 or v77 != v77 else 0.001)
                            v100 = v99 if v99 > 0.0 or v99 != v99 else 0.0
                            v101 = sqrt(v94)
                            v106 = v101 - sqrt(v100) if v75 else sqrt(v94 - v100)
                            v109 = 2.0 * v101
                            v114 = -v77
                            v129 = []
                            for node, weight in RULE_2(v106 / 1.0):
                                v108 = node * v106
                                if v75:
                                    v117 = v101 - v108
                                    v119 = v117 if v117 > 0.0 or v117 != v117 else 0.0
                                else:
                                    v119 = v108
                                v128 = exp(v114 * (v108 * (v109 - v108) if v75 else v108 * v108)) * (2.0 * v119 / sqrt(-expm1(-2.0 * v119 * v119)))
                                v129.append(weight * v128)
                            v129 = fsum(v129) * v106
                            v130 = v129
                        else:
                            v130 = 0.0
                        v132 = (1.0 if v75 else pow(r / a, n) * (a / r)) * v130
                    else:
                        v132 = 1.0 / v77 if v75 else inf
                    v134 = r * r
                    v136 = sqrt(v71 * (a + r)) + a
                    value = v153 / v154 * (n * d * v134 / v136 + d * v134 / v136 + (v142 * v134 * v70 / v136 - 1.7724538509055159 * n * h * v132 * v134 * v70 / a))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                        return value
                    return None
                if v158:
                    v514 = []
                    for node, weight in RULE_0(1.0 / v193):
                        v484 = node * 1.0
                        v486 = v484 * v484 * v484
                        v488 = v486 * v486 * v484
                        v490 = v488 * v484
                        v493 = -expm1(v179 * v490)
                        v494 = 1.0 - v490
                        v499 = expm1(v209 * v490)
                        v513 = 8.0 * v488 * (exp(v178 * v494) * pow(v493 / v181, -0.5) * (v499 - v212 * (v499 + 1.0) * v493 * (-expm1(v179 * v494) / v181)) / v493)
                        v514.append(weight * v513)
                    v514 = fsum(v514) * 1.0
                    v515 = v178 * v514
                    v522 = v178 - log(v515) * v515 / (v232 + (v515 - 1.0) * v237)
                    v523 = -2.0 * v522
                    v525 = -expm1(v523)
                    v530 = v187 - v160 * exp(-2.0 * (v522 if v522 < 300.0 or v522 != v522 else 300.0))
                    v531 = v530 if v530 > 1.0 or v530 != v530 else 1.0
                    v533 = 1.0 / (v191 * v522)
                    v548 = v161 * v522
                    v565 = []
                    for node, weight in RULE_0(1.0 / v533):
                        v534 = node * 1.0
                        v536 = v534 * v534 * v534
                        v538 = v536 * v536 * v534
                        v540 = v538 * v534
                        v543 = -expm1(v523 * v540)
                        v544 = 1.0 - v540
                        v550 = expm1(v548 * v540)
                        v564 = 8.0 * v538 * (exp(v522 * v544) * pow(v543 / v525, -0.5) * (v550 - v212 * (v550 + 1.0) * v543 * (-expm1(v523 * v544) / v525)) / v543)
                        v565.append(weight * v564)
                    v565 = fsum(v565) * 1.0
                    v566 = v522 * v565
                    v579 = v522 - log(v566) * v566 / (exp(v548) / (v525 * v531) + (v566 - 1.0) * (v234 / v531 - 1.0 / v525))
                    v580 = -2.0 * v579
                    v582 = -expm1(v580)
                    v587 = v187 - v160 * exp(-2.0 * (v579 if v579 < 300.0 or v579 != v579 else 300.0))
                    v588 = v587 if v587 > 1.0 or v587 != v587 else 1.0
                    v590 = 1.0 / (v191 * v579)
                    v605 = v161 * v579
                    v622 = []
                    for node, weight in RULE_0(1.0 / v590):
                        v591 = node * 1.0
                        v593 = v591 * v591 * v591
                        v595 = v593 * v593 * v591
                        v597 = v595 * v591
                        v600 = -expm1(v580 * v597)
                        v601 = 1.0 - v597
                        v607 = expm1(v605 * v597)
                        v621 = 8.0 * v595 * (exp(v579 * v601) * pow(v600 / v582, -0.5) * (v607 - v212 * (v607 + 1.0) * v600 * (-expm1(v580 * v601) / v582)) / v600)
                        v622.append(weight * v621)
                    v622 = fsum(v622) * 1.0
                    v623 = v579 * v622
                    v636 = v579 - log(v623) * v623 / (exp(v605) / (v582 * v588) + (v623 - 1.0) * (v234 / v588 - 1.0 / v582))
                    v637 = -2.0 * v636
                    v639 = -expm1(v637)
                    v644 = v187 - v160 * exp(-2.0 * (v636 if v636 < 300.0 or v636 != v636 else 300.0))
                    v645 = v644 if v644 > 1.0 or v644 != v644 else 1.0
                    v647 = 1.0 / (v191 * v636)
                    v662 = v161 * v636
                    v679 = []
                    for node, weight in RULE_0(1.0 / v647):
                        v648 = node * 1.0
                        v650 = v648 * v648 * v648
                        v652 = v650 * v650 * v648
                        v654 = v652 * v648
                        v657 = -expm1(v637 * v654)
                        v658 = 1.0 - v654
                        v664 = expm1(v662 * v654)
                        v678 = 8.0 * v652 * (exp(v636 * v658) * pow(v657 / v639, -0.5) * (v664 - v212 * (v664 + 1.0) * v657 * (-expm1(v637 * v658) / v639)) / v657)
                        v679.append(weight * v678)
                    v679 = fsum(v679) * 1.0
                    v680 = v636 * v679
                    v693 = v636 - log(v680) * v680 / (exp(v662) / (v639 * v645) + (v680 - 1.0) * (v234 / v645 - 1.0 / v639))
                    v694 = -2.0 * v693
                    v696 = -expm1(v694)
                    v701 = v187 - v160 * exp(-2.0 * (v693 if v693 < 300.0 or v693 != v693 else 300.0))
                    v702 = v701 if v701 > 1.0 or v701 != v701 else 1.0
                    v704 = 1.0 / (v191 * v693)
                    v719 = v161 * v693
                    v736 = []
                    for node, weight in RULE_0(1.0 / v704):
                        v705 = node * 1.0
                        v707 = v705 * v705 * v705
                        v709 = v707 * v707 * v705
                        v711 = v709 * v705
                        v714 = -expm1(v694 * v711)
                        v715 = 1.0 - v711
                        v721 = expm1(v719 * v711)
                        v735 = 8.0 * v709 * (exp(v693 * v715) * pow(v714 / v696, -0.5) * (v721 - v212 * (v721 + 1.0) * v714 * (-expm1(v694 * v715) / v696)) / v714)
                        v736.append(weight * v735)
                    v736 = fsum(v736) * 1.0
                    v737 = v693 * v736
                    v754 = -expm1(-2.0 * (v693 - log(v737) * v737 / (exp(v719) / (v696 * v702) + (v737 - 1.0) * (v234 / v702 - 1.0 / v696))))
                else:
                    v754 = 1.0
                if v478 / (n * v754 - 1.0) * 0.999999999999999 <= d:
                    value = v153 * a * (d + v142 / v154 * v70)
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                        return value
                    return None
                value = nan
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def minimum_depth(h, n, a=1.0):
    if h.__class__ is n.__class__ is a.__class__ is float and h > 1e-30 and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (a > 1e-30) and (a < 1e+30):
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
                v324 = -expm1(-2.0 * (v263 - log(v307) * v307 / (exp(v289) / (v266 * v272) + (v307 - 1.0) * (v83 / v272 - 1.0 / v266))))
            else:
                v324 = 1.0
            v326 = n / 2.0 + 0.5
            v328 = v326 + 1.75
            v332 = (v326 + 0.5) * (v326 + 1.5)
            v345 = 1.0 / (v328 * v328)
            value = 1.7724538509055159 * h * ((v326 * (v326 + 1.0) / v332 if v326 < 1.0 else 1.0 - (v326 + 0.75) / v332) * sqrt(v328) * (1.0 + v345 * (((((((0.01524698625788054 * v345 + 0.5334320651111477) * v345 + 2.250488865813539) * v345 + 2.8612106440066865) * v345 + 1.3794681629043655) * v345 + 0.2596058532893223) * v345 + 0.015624999999999823) / ((((((3.278794792785737 * v345 + 49.328555418276075) * v345 + 167.28648538571198) * v345 + 195.37226190335065) * v345 + 90.69722535867314) * v345 + 16.763212110504565) * v345 + 1.0)))) / (n * v324 - 1.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(h, n, a):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def minimum_force(a, h, n, E_star):
    if a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v5 = n > 2.0
            if v5:
                v7 = n if v5 else 3.0
                v8 = v7 - 2.0
                v17 = log1p((1.2732395447351628 + 0.9883942191601786 * v8 / (v8 + 0.72)) / v8)
                if v8 < 2.0:
                    v24 = log(v8 * (v8 + 2.0) / 2.0) / v8
                    v26 = v17 if v17 > v24 or v17 != v17 else v24
                else:
                    v26 = v17
                v28 = -2.0 * v26
                v30 = -expm1(v28)
                v37 = v7 - 1.0 + 0.0
                v39 = v37 - v7 * exp(-2.0 * (v26 if v26 < 300.0 or v26 != v26 else 300.0))
                v40 = v39 if v39 > 1.0 or v39 != v39 else 1.0
                v41 = v8 + 1.0
                v43 = 1.0 / (v41 * v26)
                v59 = v8 * v26
                v63 = 0.5 * v8
                v79 = []
                for node, weight in RULE_0(1.0 / v43):
                    v44 = node * 1.0
                    v46 = v44 * v44 * v44
                    v48 = v46 * v46 * v44
                    v51 = v48 * v44
                    v54 = -expm1(v28 * v51)
                    v55 = 1.0 - v51
                    v61 = expm1(v59 * v51)
                    v78 = 8.0 * v48 * (exp(v26 * v55) * pow(v54 / v30, -0.5) * (v61 - v63 * (v61 + 1.0) * v54 * (-expm1(v28 * v55) / v30)) / v54)
                    v79.append(weight * v78)
                v79 = fsum(v79) * 1.0
                v80 = v26 * v79
                v85 = 2.0 * v37
                v94 = v26 - log(v80) * v80 / (exp(v59) / (v30 * v40) + (v80 - 1.0) * (v85 / v40 - 1.0 / v30))
                v95 = -2.0 * v94
                v97 = -expm1(v95)
                v102 = v37 - v7 * exp(-2.0 * (v94 if v94 < 300.0 or v94 != v94 else 300.0))
                v103 = v102 if v102 > 1.0 or v102 != v102 else 1.0
                v105 = 1.0 / (v41 * v94)
                v120 = v8 * v94
                v137 = []
                for node, weight in RULE_0(1.0 / v105):
                    v106 = node * 1.0
                    v108 = v106 * v106 * v106
                    v110 = v108 * v108 * v106
                    v112 = v110 * v106
                    v115 = -expm1(v95 * v112)
                    v116 = 1.0 - v112
                    v122 = expm1(v120 * v112)
                    v136 = 8.0 * v110 * (exp(v94 * v116) * pow(v115 / v97, -0.5) * (v122 - v63 * (v122 + 1.0) * v115 * (-expm1(v95 * v116) / v97)) / v115)
                    v137.append(weight * v136)
                v137 = fsum(v137) * 1.0
                v138 = v94 * v137
                v151 = v94 - log(v138) * v138 / (exp(v120) / (v97 * v103) + (v138 - 1.0) * (v85 / v103 - 1.0 / v97))
                v152 = -2.0 * v151
                v154 = -expm1(v152)
                v159 = v37 - v7 * exp(-2.0 * (v151 if v151 < 300.0 or v151 != v151 else 300.0))
                v160 = v159 if v159 > 1.0 or v159 != v159 else 1.0
                v162 = 1.0 / (v41 * v151)
                v177 = v8 * v151
                v194 = []
                for node, weight in RULE_0(1.0 / v162):
                    v163 = node * 1.0
                    v165 = v163 * v163 * v163
                    v167 = v165 * v165 * v163
                    v169 = v167 * v163
                    v172 = -expm1(v152 * v169)
                    v173 = 1.0 - v169
                    v179 = expm1(v177 * v169)
                    v193 = 8.0 * v167 * (exp(v151 * v173) * pow(v172 / v154, -0.5) * (v179 - v63 * (v179 + 1.0) * v172 * (-expm1(v152 * v173) / v154)) / v172)
                    v194.append(weight * v193)
                v194 = fsum(v194) * 1.0
                v195 = v151 * v194
                v208 = v151 - log(v195) * v195 / (exp(v177) / (v154 * v160) + (v195 - 1.0) * (v85 / v160 - 1.0 / v154))
                v209 = -2.0 * v208
                v211 = -expm1(v209)
                v216 = v37 - v7 * exp(-2.0 * (v208 if v208 < 300.0 or v208 != v208 else 300.0))
                v217 = v216 if v216 > 1.0 or v216 != v216 else 1.0
                v219 = 1.0 / (v41 * v208)
                v234 = v8 * v208
                v251 = []
                for node, weight in RULE_0(1.0 / v219):
                    v220 = node * 1.0
                    v222 = v220 * v220 * v220
                    v224 = v222 * v222 * v220
                    v226 = v224 * v220
                    v229 = -expm1(v209 * v226)
                    v230 = 1.0 - v226
                    v236 = expm1(v234 * v226)
                    v250 = 8.0 * v224 * (exp(v208 * v230) * pow(v229 / v211, -0.5) * (v236 - v63 * (v236 + 1.0) * v229 * (-expm1(v209 * v230) / v211)) / v229)
                    v251.append(weight * v250)
                v251 = fsum(v251) * 1.0
                v252 = v208 * v251
                v265 = v208 - log(v252) * v252 / (exp(v234) / (v211 * v217) + (v252 - 1.0) * (v85 / v217 - 1.0 / v211))
                v266 = -2.0 * v265
                v268 = -expm1(v266)
                v273 = v37 - v7 * exp(-2.0 * (v265 if v265 < 300.0 or v265 != v265 else 300.0))
                v274 = v273 if v273 > 1.0 or v273 != v273 else 1.0
                v276 = 1.0 / (v41 * v265)
                v291 = v8 * v265
                v308 = []
                for node, weight in RULE_0(1.0 / v276):
                    v277 = node * 1.0
                    v279 = v277 * v277 * v277
                    v281 = v279 * v279 * v277
                    v283 = v281 * v277
                    v286 = -expm1(v266 * v283)
                    v287 = 1.0 - v283
                    v293 = expm1(v291 * v283)
                    v307 = 8.0 * v281 * (exp(v265 * v287) * pow(v286 / v268, -0.5) * (v293 - v63 * (v293 + 1.0) * v286 * (-expm1(v266 * v287) / v268)) / v286)
                    v308.append(weight * v307)
                v308 = fsum(v308) * 1.0
                v309 = v265 * v308
                v326 = -expm1(-2.0 * (v265 - log(v309) * v309 / (exp(v291) / (v268 * v274) + (v309 - 1.0) * (v85 / v274 - 1.0 / v268))))
            else:
                v326 = 1.0
            v328 = n / 2.0 + 0.5
            v330 = v328 + 1.75
            v334 = (v328 + 0.5) * (v328 + 1.5)
            v347 = 1.0 / (v330 * v330)
            value = 3.5449077018110318 * E_star * n * h * (v326 + 1.0) * a * ((v328 * (v328 + 1.0) / v334 if v328 < 1.0 else 1.0 - (v328 + 0.75) / v334) * sqrt(v330) * (1.0 + v347 * (((((((0.01524698625788054 * v347 + 0.5334320651111477) * v347 + 2.250488865813539) * v347 + 2.8612106440066865) * v347 + 1.3794681629043655) * v347 + 0.2596058532893223) * v347 + 0.015624999999999823) / ((((((3.278794792785737 * v347 + 49.328555418276075) * v347 + 167.28648538571198) * v347 + 195.37226190335065) * v347 + 90.69722535867314) * v347 + 16.763212110504565) * v347 + 1.0)))) / ((n + 1.0) * (n * v326 - 1.0))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, d, a, h, n, E_star):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            v9 = n / 2.0 + 0.5
            v11 = v9 + 1.75
            v15 = (v9 + 0.5) * (v9 + 1.5)
            v29 = 1.0 / (v11 * v11)
            v70 = (v9 * (v9 + 1.0) / v15 if v9 < 1.0 else 1.0 - (v9 + 0.75) / v15) * sqrt(v11) * (1.0 + v29 * (((((((0.01524698625788054 * v29 + 0.5334320651111477) * v29 + 2.250488865813539) * v29 + 2.8612106440066865) * v29 + 1.3794681629043655) * v29 + 0.2596058532893223) * v29 + 0.015624999999999823) / ((((((3.278794792785737 * v29 + 49.328555418276075) * v29 + 167.28648538571198) * v29 + 195.37226190335065) * v29 + 90.69722535867314) * v29 + 16.763212110504565) * v29 + 1.0)))
            v146 = n > 2.0
            if v146:
                v148 = n if v146 else 3.0
                v149 = v148 - 2.0
                v158 = log1p((1.2732395447351628 + 0.9883942191601786 * v149 / (v149 + 0.72)) / v149)
                if v149 < 2.0:
                    v164 = log(v149 * (v149 + 2.0) / 2.0) / v149
                    v166 = v158 if v158 > v164 or v158 != v158 else v164
                else:
                    v166 = v158
                v167 = -2.0 * v166
                v169 = -expm1(v167)
                v175 = v148 - 1.0 + 0.0
                v177 = v175 - v148 * exp(-2.0 * (v166 if v166 < 300.0 or v166 != v166 else 300.0))
                v178 = v177 if v177 > 1.0 or v177 != v177 else 1.0
                v179 = v149 + 1.0
                v181 = 1.0 / (v179 * v166)
                v197 = v149 * v166
                v200 = 0.5 * v149
                v216 = []
                for node, weight in RULE_0(1.0 / v181):
                    v182 = node * 1.0
                    v184 = v182 * v182 * v182
                    v186 = v184 * v184 * v182
                    v189 = v186 * v182
                    v192 = -expm1(v167 * v189)
                    v193 = 1.0 - v189
                    v199 = expm1(v197 * v189)
                    v215 = 8.0 * v186 * (exp(v166 * v193) * pow(v192 / v169, -0.5) * (v199 - v200 * (v199 + 1.0) * v192 * (-expm1(v167 * v193) / v169)) / v192)
                    v216.append(weight * v215)
                v216 = fsum(v216) * 1.0
                v217 = v166 * v216
                v222 = 2.0 * v175
                v231 = v166 - log(v217) * v217 / (exp(v197) / (v169 * v178) + (v217 - 1.0) * (v222 / v178 - 1.0 / v169))
                v232 = -2.0 * v231
                v234 = -expm1(v232)
                v239 = v175 - v148 * exp(-2.0 * (v231 if v231 < 300.0 or v231 != v231 else 300.0))
                v240 = v239 if v239 > 1.0 or v239 != v239 else 1.0
                v242 = 1.0 / (v179 * v231)
                v257 = v149 * v231
                v274 = []
                for node, weight in RULE_0(1.0 / v242):
                    v243 = node * 1.0
                    v245 = v243 * v243 * v243
                    v247 = v245 * v245 * v243
                    v249 = v247 * v243
                    v252 = -expm1(v232 * v249)
                    v253 = 1.0 - v249
                    v259 = expm1(v257 * v249)
                    v273 = 8.0 * v247 * (exp(v231 * v253) * pow(v252 / v234, -0.5) * (v259 - v200 * (v259 + 1.0) * v252 * (-expm1(v232 * v253) / v234)) / v252)
                    v274.append(weight * v273)
                v274 = fsum(v274) * 1.0
                v275 = v231 * v274
                v288 = v231 - log(v275) * v275 / (exp(v257) / (v234 * v240) + (v275 - 1.0) * (v222 / v240 - 1.0 / v234))
                v289 = -2.0 * v288
                v291 = -expm1(v289)
                v296 = v175 - v148 * exp(-2.0 * (v288 if v288 < 300.0 or v288 != v288 else 300.0))
                v297 = v296 if v296 > 1.0 or v296 != v296 else 1.0
                v299 = 1.0 / (v179 * v288)
                v314 = v149 * v288
                v331 = []
                for node, weight in RULE_0(1.0 / v299):
                    v300 = node * 1.0
                    v302 = v300 * v300 * v300
                    v304 = v302 * v302 * v300
                    v306 = v304 * v300
                    v309 = -expm1(v289 * v306)
                    v310 = 1.0 - v306
                    v316 = expm1(v314 * v306)
                    v330 = 8.0 * v304 * (exp(v288 * v310) * pow(v309 / v291, -0.5) * (v316 - v200 * (v316 + 1.0) * v309 * (-expm1(v289 * v310) / v291)) / v309)
                    v331.append(weight * v330)
                v331 = fsum(v331) * 1.0
                v332 = v288 * v331
                v345 = v288 - log(v332) * v332 / (exp(v314) / (v291 * v297) + (v332 - 1.0) * (v222 / v297 - 1.0 / v291))
                v346 = -2.0 * v345
                v348 = -expm1(v346)
                v353 = v175 - v148 * exp(-2.0 * (v345 if v345 < 300.0 or v345 != v345 else 300.0))
                v354 = v353 if v353 > 1.0 or v353 != v353 else 1.0
                v356 = 1.0 / (v179 * v345)
                v371 = v149 * v345
                v388 = []
                for node, weight in RULE_0(1.0 / v356):
                    v357 = node * 1.0
                    v359 = v357 * v357 * v357
                    v361 = v359 * v359 * v357
                    v363 = v361 * v357
                    v366 = -expm1(v346 * v363)
                    v367 = 1.0 - v363
                    v373 = expm1(v371 * v363)
                    v387 = 8.0 * v361 * (exp(v345 * v367) * pow(v366 / v348, -0.5) * (v373 - v200 * (v373 + 1.0) * v366 * (-expm1(v346 * v367) / v348)) / v366)
                    v388.append(weight * v387)
                v388 = fsum(v388) * 1.0
                v389 = v345 * v388
                v402 = v345 - log(v389) * v389 / (exp(v371) / (v348 * v354) + (v389 - 1.0) * (v222 / v354 - 1.0 / v348))
                v403 = -2.0 * v402
                v405 = -expm1(v403)
                v410 = v175 - v148 * exp(-2.0 * (v402 if v402 < 300.0 or v402 != v402 else 300.0))
                v411 = v410 if v410 > 1.0 or v410 != v410 else 1.0
                v413 = 1.0 / (v179 * v402)
                v428 = v149 * v402
                v445 = []
                for node, weight in RULE_0(1.0 / v413):
                    v414 = node * 1.0
                    v416 = v414 * v414 * v414
                    v418 = v416 * v416 * v414
                    v420 = v418 * v414
                    v423 = -expm1(v403 * v420)
                    v424 = 1.0 - v420
                    v430 = expm1(v428 * v420)
                    v444 = 8.0 * v418 * (exp(v402 * v424) * pow(v423 / v405, -0.5) * (v430 - v200 * (v430 + 1.0) * v423 * (-expm1(v403 * v424) / v405)) / v423)
                    v445.append(weight * v444)
                v445 = fsum(v445) * 1.0
                v446 = v402 * v445
                v463 = -expm1(-2.0 * (v402 - log(v446) * v446 / (exp(v428) / (v405 * v411) + (v446 - 1.0) * (v222 / v411 - 1.0 / v405))))
            else:
                v463 = 1.0
            if 1.7724538509055159 * h * v70 / (n * v463 - 1.0) * 0.999999999999999 <= d:
                if r <= a and d > 0.0:
                    v71 = a - r
                    v74 = sqrt(v71 * (a + r))
                    v84 = n > 1.0
                    v86 = abs(n - 1.0)
                    if r > 0.0:
                        v97 = v71 / r
                        v103 = log1p(v97) if isfinite(v97) else log(a) - log(r)
                        if v103 > 0.0:
                            v108 = v103 - 42.0 / (v86 if v86 > 0.001 or v86 != v86 else 0.001)
                            v109 = v108 if v108 > 0.0 or v108 != v108 else 0.0
                            v110 = sqrt(v103)
                            v115 = v110 - sqrt(v109) if v84 else sqrt(v103 - v109)
                            v118 = 2.0 * v110
                            v123 = -v86
                            v138 = []
                            for node, weight in RULE_2(v115 / 1.0):
                                v117 = node * v115
                                if v84:
                                    v126 = v110 - v117
                                    v128 = v126 if v126 > 0.0 or v126 != v126 else 0.0
                                else:
                                    v128 = v117
                                v137 = exp(v123 * (v117 * (v118 - v117) if v84 else v117 * v117)) * (2.0 * v128 / sqrt(-expm1(-2.0 * v128 * v128)))
                                v138.append(weight * v137)
                            v138 = fsum(v138) * v115
                            v139 = v138
                        else:
                            v139 = 0.0
                        v141 = (1.0 if v84 else pow(r / a, n) * (a / r)) * v139
                    else:
                        v141 = 1.0 / v86 if v84 else inf
                    value = E_star * (d / (3.141592653589793 * v74) + h * v70 / (1.7724538509055159 * v74) - n * h * v141 * v70 / (1.7724538509055159 * a))
                    if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                        return value
                    if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                        return value
                    return None
                value = 0.0
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, E_star):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def profile(r, a, h, n):
    if r.__class__ is a.__class__ is h.__class__ is n.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            if r <= a:
                value = -h * pow(r / a, n)
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                return None
            return nan
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_profile_r(a, h, n):
    v5 = np.negative(h)
    return (a, n, v5)


def block_profile_r(out, r, a, n, v5, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.divide(r, a, out)
        np.power(out, n, out)
        np.multiply(v5, out, out)
    if some10 != size:
        np.copyto(out, C0, where=~m0)


def prepare_profile_all():
    return ()


def block_profile_all(out, r, a, h, n, t0, m0):
    size = out.size
    np.less_equal(r, a, m0)
    largest_r = largest(r)
    if largest_r == np.inf:
        raise FloatingPointError
    some10 = np.count_nonzero(m0)
    if some10:
        np.negative(h, out)
        np.divide(r, a, t0)
        np.power(t0, n, t0)
        np.multiply(out, t0, out)
    if some10 != size:
        np.copyto(out, C0, where=~m0)


def stiffness(a, E_star, h=1.0, n=1.0):
    if a.__class__ is E_star.__class__ is h.__class__ is n.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            return 2.0 * E_star * a
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_all_signed():
    return ()


def block_stiffness_all_signed(out, a, E_star):
    np.multiply(C1, E_star, out)
    np.multiply(out, a, out)


def zero_radius(a, n, h=1.0):
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
    ('_profile', 1, 'r', 'a', 'h', 'n'): {
        ('r',): (('r',), prepare_profile_r, block_profile_r, 0, 1, (), False),
        ('r', 'a', 'h', 'n'): (('r', 'a', 'h', 'n'), prepare_profile_all, block_profile_all, 1, 1, (), False),
    },
    ('_stiffness', 0, 'a', 'E_star'): {
        ('a', 'E_star'): (('a', 'E_star'), prepare_stiffness_all_signed, block_stiffness_all_signed, 0, 0, (), False),
    },
}
