"""Programs of axicontact.viscoelastic.concave_power."""

from __future__ import annotations

from math import exp, expm1, fsum, inf, log, log1p, nan, pow, sin, sqrt

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule

RULE_0 = rule(((3.0, 32), (20.0, 64), (inf, 128)))


def step_force_kelvin_voigt(t, d, a, h, n, E, eta):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            v14 = n / 2.0 + 0.5
            v16 = v14 + 1.75
            v20 = (v14 + 0.5) * (v14 + 1.5)
            v34 = 1.0 / (v16 * v16)
            v75 = (v14 * (v14 + 1.0) / v20 if v14 < 1.0 else 1.0 - (v14 + 0.75) / v20) * sqrt(v16) * (1.0 + v34 * (((((((0.01524698625788054 * v34 + 0.5334320651111477) * v34 + 2.250488865813539) * v34 + 2.8612106440066865) * v34 + 1.3794681629043655) * v34 + 0.2596058532893223) * v34 + 0.015624999999999823) / ((((((3.278794792785737 * v34 + 49.328555418276075) * v34 + 167.28648538571198) * v34 + 195.37226190335065) * v34 + 90.69722535867314) * v34 + 16.763212110504565) * v34 + 1.0)))
            v76 = n > 2.0
            if v76:
                v78 = n if v76 else 3.0
                v79 = v78 - 2.0
                v88 = log1p((1.2732395447351628 + 0.9883942191601786 * v79 / (v79 + 0.72)) / v79)
                if v79 < 2.0:
                    v94 = log(v79 * (v79 + 2.0) / 2.0) / v79
                    v96 = v88 if v88 > v94 or v88 != v88 else v94
                else:
                    v96 = v88
                v98 = -2.0 * v96
                v100 = -expm1(v98)
                v106 = v78 - 1.0 + 0.0
                v108 = v106 - v78 * exp(-2.0 * (v96 if v96 < 300.0 or v96 != v96 else 300.0))
                v109 = v108 if v108 > 1.0 or v108 != v108 else 1.0
                v110 = v79 + 1.0
                v112 = 1.0 / (v110 * v96)
                v128 = v79 * v96
                v131 = 0.5 * v79
                v147 = []
                for node, weight in RULE_0(1.0 / v112):
                    v113 = node * 1.0
                    v115 = v113 * v113 * v113
                    v117 = v115 * v115 * v113
                    v120 = v117 * v113
                    v123 = -expm1(v98 * v120)
                    v124 = 1.0 - v120
                    v130 = expm1(v128 * v120)
                    v146 = 8.0 * v117 * (exp(v96 * v124) * pow(v123 / v100, -0.5) * (v130 - v131 * (v130 + 1.0) * v123 * (-expm1(v98 * v124) / v100)) / v123)
                    v147.append(weight * v146)
                v147 = fsum(v147) * 1.0
                v148 = v96 * v147
                v153 = 2.0 * v106
                v162 = v96 - log(v148) * v148 / (exp(v128) / (v100 * v109) + (v148 - 1.0) * (v153 / v109 - 1.0 / v100))
                v163 = -2.0 * v162
                v165 = -expm1(v163)
                v170 = v106 - v78 * exp(-2.0 * (v162 if v162 < 300.0 or v162 != v162 else 300.0))
                v171 = v170 if v170 > 1.0 or v170 != v170 else 1.0
                v173 = 1.0 / (v110 * v162)
                v188 = v79 * v162
                v205 = []
                for node, weight in RULE_0(1.0 / v173):
                    v174 = node * 1.0
                    v176 = v174 * v174 * v174
                    v178 = v176 * v176 * v174
                    v180 = v178 * v174
                    v183 = -expm1(v163 * v180)
                    v184 = 1.0 - v180
                    v190 = expm1(v188 * v180)
                    v204 = 8.0 * v178 * (exp(v162 * v184) * pow(v183 / v165, -0.5) * (v190 - v131 * (v190 + 1.0) * v183 * (-expm1(v163 * v184) / v165)) / v183)
                    v205.append(weight * v204)
                v205 = fsum(v205) * 1.0
                v206 = v162 * v205
                v219 = v162 - log(v206) * v206 / (exp(v188) / (v165 * v171) + (v206 - 1.0) * (v153 / v171 - 1.0 / v165))
                v220 = -2.0 * v219
                v222 = -expm1(v220)
                v227 = v106 - v78 * exp(-2.0 * (v219 if v219 < 300.0 or v219 != v219 else 300.0))
                v228 = v227 if v227 > 1.0 or v227 != v227 else 1.0
                v230 = 1.0 / (v110 * v219)
                v245 = v79 * v219
                v262 = []
                for node, weight in RULE_0(1.0 / v230):
                    v231 = node * 1.0
                    v233 = v231 * v231 * v231
                    v235 = v233 * v233 * v231
                    v237 = v235 * v231
                    v240 = -expm1(v220 * v237)
                    v241 = 1.0 - v237
                    v247 = expm1(v245 * v237)
                    v261 = 8.0 * v235 * (exp(v219 * v241) * pow(v240 / v222, -0.5) * (v247 - v131 * (v247 + 1.0) * v240 * (-expm1(v220 * v241) / v222)) / v240)
                    v262.append(weight * v261)
                v262 = fsum(v262) * 1.0
                v263 = v219 * v262
                v276 = v219 - log(v263) * v263 / (exp(v245) / (v222 * v228) + (v263 - 1.0) * (v153 / v228 - 1.0 / v222))
                v277 = -2.0 * v276
                v279 = -expm1(v277)
                v284 = v106 - v78 * exp(-2.0 * (v276 if v276 < 300.0 or v276 != v276 else 300.0))
                v285 = v284 if v284 > 1.0 or v284 != v284 else 1.0
                v287 = 1.0 / (v110 * v276)
                v302 = v79 * v276
                v319 = []
                for node, weight in RULE_0(1.0 / v287):
                    v288 = node * 1.0
                    v290 = v288 * v288 * v288
                    v292 = v290 * v290 * v288
                    v294 = v292 * v288
                    v297 = -expm1(v277 * v294)
                    v298 = 1.0 - v294
                    v304 = expm1(v302 * v294)
                    v318 = 8.0 * v292 * (exp(v276 * v298) * pow(v297 / v279, -0.5) * (v304 - v131 * (v304 + 1.0) * v297 * (-expm1(v277 * v298) / v279)) / v297)
                    v319.append(weight * v318)
                v319 = fsum(v319) * 1.0
                v320 = v276 * v319
                v333 = v276 - log(v320) * v320 / (exp(v302) / (v279 * v285) + (v320 - 1.0) * (v153 / v285 - 1.0 / v279))
                v334 = -2.0 * v333
                v336 = -expm1(v334)
                v341 = v106 - v78 * exp(-2.0 * (v333 if v333 < 300.0 or v333 != v333 else 300.0))
                v342 = v341 if v341 > 1.0 or v341 != v341 else 1.0
                v344 = 1.0 / (v110 * v333)
                v359 = v79 * v333
                v376 = []
                for node, weight in RULE_0(1.0 / v344):
                    v345 = node * 1.0
                    v347 = v345 * v345 * v345
                    v349 = v347 * v347 * v345
                    v351 = v349 * v345
                    v354 = -expm1(v334 * v351)
                    v355 = 1.0 - v351
                    v361 = expm1(v359 * v351)
                    v375 = 8.0 * v349 * (exp(v333 * v355) * pow(v354 / v336, -0.5) * (v361 - v131 * (v361 + 1.0) * v354 * (-expm1(v334 * v355) / v336)) / v354)
                    v376.append(weight * v375)
                v376 = fsum(v376) * 1.0
                v377 = v333 * v376
                v394 = -expm1(-2.0 * (v333 - log(v377) * v377 / (exp(v359) / (v336 * v342) + (v377 - 1.0) * (v153 / v342 - 1.0 / v336))))
            else:
                v394 = 1.0
            v398 = 1.7724538509055159 * h
            value = (E if t > 0.0 else inf) * (2.0 * a * (d + v398 / (n + 1.0) * v75) if v398 * v75 / (n * v394 - 1.0) * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, a, h, n, E, eta):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_maxwell(t, d, a, h, n, E, tau):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v14 = n / 2.0 + 0.5
            v16 = v14 + 1.75
            v20 = (v14 + 0.5) * (v14 + 1.5)
            v34 = 1.0 / (v16 * v16)
            v75 = (v14 * (v14 + 1.0) / v20 if v14 < 1.0 else 1.0 - (v14 + 0.75) / v20) * sqrt(v16) * (1.0 + v34 * (((((((0.01524698625788054 * v34 + 0.5334320651111477) * v34 + 2.250488865813539) * v34 + 2.8612106440066865) * v34 + 1.3794681629043655) * v34 + 0.2596058532893223) * v34 + 0.015624999999999823) / ((((((3.278794792785737 * v34 + 49.328555418276075) * v34 + 167.28648538571198) * v34 + 195.37226190335065) * v34 + 90.69722535867314) * v34 + 16.763212110504565) * v34 + 1.0)))
            v76 = n > 2.0
            if v76:
                v78 = n if v76 else 3.0
                v79 = v78 - 2.0
                v88 = log1p((1.2732395447351628 + 0.9883942191601786 * v79 / (v79 + 0.72)) / v79)
                if v79 < 2.0:
                    v94 = log(v79 * (v79 + 2.0) / 2.0) / v79
                    v96 = v88 if v88 > v94 or v88 != v88 else v94
                else:
                    v96 = v88
                v98 = -2.0 * v96
                v100 = -expm1(v98)
                v107 = v78 - 1.0 + 0.0
                v109 = v107 - v78 * exp(-2.0 * (v96 if v96 < 300.0 or v96 != v96 else 300.0))
                v110 = v109 if v109 > 1.0 or v109 != v109 else 1.0
                v111 = v79 + 1.0
                v113 = 1.0 / (v111 * v96)
                v129 = v79 * v96
                v132 = 0.5 * v79
                v148 = []
                for node, weight in RULE_0(1.0 / v113):
                    v114 = node * 1.0
                    v116 = v114 * v114 * v114
                    v118 = v116 * v116 * v114
                    v121 = v118 * v114
                    v124 = -expm1(v98 * v121)
                    v125 = 1.0 - v121
                    v131 = expm1(v129 * v121)
                    v147 = 8.0 * v118 * (exp(v96 * v125) * pow(v124 / v100, -0.5) * (v131 - v132 * (v131 + 1.0) * v124 * (-expm1(v98 * v125) / v100)) / v124)
                    v148.append(weight * v147)
                v148 = fsum(v148) * 1.0
                v149 = v96 * v148
                v154 = 2.0 * v107
                v163 = v96 - log(v149) * v149 / (exp(v129) / (v100 * v110) + (v149 - 1.0) * (v154 / v110 - 1.0 / v100))
                v164 = -2.0 * v163
                v166 = -expm1(v164)
                v171 = v107 - v78 * exp(-2.0 * (v163 if v163 < 300.0 or v163 != v163 else 300.0))
                v172 = v171 if v171 > 1.0 or v171 != v171 else 1.0
                v174 = 1.0 / (v111 * v163)
                v189 = v79 * v163
                v206 = []
                for node, weight in RULE_0(1.0 / v174):
                    v175 = node * 1.0
                    v177 = v175 * v175 * v175
                    v179 = v177 * v177 * v175
                    v181 = v179 * v175
                    v184 = -expm1(v164 * v181)
                    v185 = 1.0 - v181
                    v191 = expm1(v189 * v181)
                    v205 = 8.0 * v179 * (exp(v163 * v185) * pow(v184 / v166, -0.5) * (v191 - v132 * (v191 + 1.0) * v184 * (-expm1(v164 * v185) / v166)) / v184)
                    v206.append(weight * v205)
                v206 = fsum(v206) * 1.0
                v207 = v163 * v206
                v220 = v163 - log(v207) * v207 / (exp(v189) / (v166 * v172) + (v207 - 1.0) * (v154 / v172 - 1.0 / v166))
                v221 = -2.0 * v220
                v223 = -expm1(v221)
                v228 = v107 - v78 * exp(-2.0 * (v220 if v220 < 300.0 or v220 != v220 else 300.0))
                v229 = v228 if v228 > 1.0 or v228 != v228 else 1.0
                v231 = 1.0 / (v111 * v220)
                v246 = v79 * v220
                v263 = []
                for node, weight in RULE_0(1.0 / v231):
                    v232 = node * 1.0
                    v234 = v232 * v232 * v232
                    v236 = v234 * v234 * v232
                    v238 = v236 * v232
                    v241 = -expm1(v221 * v238)
                    v242 = 1.0 - v238
                    v248 = expm1(v246 * v238)
                    v262 = 8.0 * v236 * (exp(v220 * v242) * pow(v241 / v223, -0.5) * (v248 - v132 * (v248 + 1.0) * v241 * (-expm1(v221 * v242) / v223)) / v241)
                    v263.append(weight * v262)
                v263 = fsum(v263) * 1.0
                v264 = v220 * v263
                v277 = v220 - log(v264) * v264 / (exp(v246) / (v223 * v229) + (v264 - 1.0) * (v154 / v229 - 1.0 / v223))
                v278 = -2.0 * v277
                v280 = -expm1(v278)
                v285 = v107 - v78 * exp(-2.0 * (v277 if v277 < 300.0 or v277 != v277 else 300.0))
                v286 = v285 if v285 > 1.0 or v285 != v285 else 1.0
                v288 = 1.0 / (v111 * v277)
                v303 = v79 * v277
                v320 = []
                for node, weight in RULE_0(1.0 / v288):
                    v289 = node * 1.0
                    v291 = v289 * v289 * v289
                    v293 = v291 * v291 * v289
                    v295 = v293 * v289
                    v298 = -expm1(v278 * v295)
                    v299 = 1.0 - v295
                    v305 = expm1(v303 * v295)
                    v319 = 8.0 * v293 * (exp(v277 * v299) * pow(v298 / v280, -0.5) * (v305 - v132 * (v305 + 1.0) * v298 * (-expm1(v278 * v299) / v280)) / v298)
                    v320.append(weight * v319)
                v320 = fsum(v320) * 1.0
                v321 = v277 * v320
                v334 = v277 - log(v321) * v321 / (exp(v303) / (v280 * v286) + (v321 - 1.0) * (v154 / v286 - 1.0 / v280))
                v335 = -2.0 * v334
                v337 = -expm1(v335)
                v342 = v107 - v78 * exp(-2.0 * (v334 if v334 < 300.0 or v334 != v334 else 300.0))
                v343 = v342 if v342 > 1.0 or v342 != v342 else 1.0
                v345 = 1.0 / (v111 * v334)
                v360 = v79 * v334
                v377 = []
                for node, weight in RULE_0(1.0 / v345):
                    v346 = node * 1.0
                    v348 = v346 * v346 * v346
                    v350 = v348 * v348 * v346
                    v352 = v350 * v346
                    v355 = -expm1(v335 * v352)
                    v356 = 1.0 - v352
                    v362 = expm1(v360 * v352)
                    v376 = 8.0 * v350 * (exp(v334 * v356) * pow(v355 / v337, -0.5) * (v362 - v132 * (v362 + 1.0) * v355 * (-expm1(v335 * v356) / v337)) / v355)
                    v377.append(weight * v376)
                v377 = fsum(v377) * 1.0
                v378 = v334 * v377
                v395 = -expm1(-2.0 * (v334 - log(v378) * v378 / (exp(v360) / (v337 * v343) + (v378 - 1.0) * (v154 / v343 - 1.0 / v337))))
            else:
                v395 = 1.0
            v399 = 1.7724538509055159 * h
            value = E * exp(-t / tau) * (2.0 * a * (d + v399 / (n + 1.0) * v75) if v399 * v75 / (n * v395 - 1.0) * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, a, h, n, E, tau):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_power_creep(t, d, a, h, n, E, alpha, t_0):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            v12 = 3.141592653589793 * alpha
            v19 = n / 2.0 + 0.5
            v21 = v19 + 1.75
            v25 = (v19 + 0.5) * (v19 + 1.5)
            v39 = 1.0 / (v21 * v21)
            v80 = (v19 * (v19 + 1.0) / v25 if v19 < 1.0 else 1.0 - (v19 + 0.75) / v25) * sqrt(v21) * (1.0 + v39 * (((((((0.01524698625788054 * v39 + 0.5334320651111477) * v39 + 2.250488865813539) * v39 + 2.8612106440066865) * v39 + 1.3794681629043655) * v39 + 0.2596058532893223) * v39 + 0.015624999999999823) / ((((((3.278794792785737 * v39 + 49.328555418276075) * v39 + 167.28648538571198) * v39 + 195.37226190335065) * v39 + 90.69722535867314) * v39 + 16.763212110504565) * v39 + 1.0)))
            v81 = n > 2.0
            if v81:
                v83 = n if v81 else 3.0
                v84 = v83 - 2.0
                v93 = log1p((1.2732395447351628 + 0.9883942191601786 * v84 / (v84 + 0.72)) / v84)
                if v84 < 2.0:
                    v99 = log(v84 * (v84 + 2.0) / 2.0) / v84
                    v101 = v93 if v93 > v99 or v93 != v93 else v99
                else:
                    v101 = v93
                v103 = -2.0 * v101
                v105 = -expm1(v103)
                v112 = v83 - 1.0 + 0.0
                v114 = v112 - v83 * exp(-2.0 * (v101 if v101 < 300.0 or v101 != v101 else 300.0))
                v115 = v114 if v114 > 1.0 or v114 != v114 else 1.0
                v116 = v84 + 1.0
                v118 = 1.0 / (v116 * v101)
                v134 = v84 * v101
                v137 = 0.5 * v84
                v153 = []
                for node, weight in RULE_0(1.0 / v118):
                    v119 = node * 1.0
                    v121 = v119 * v119 * v119
                    v123 = v121 * v121 * v119
                    v126 = v123 * v119
                    v129 = -expm1(v103 * v126)
                    v130 = 1.0 - v126
                    v136 = expm1(v134 * v126)
                    v152 = 8.0 * v123 * (exp(v101 * v130) * pow(v129 / v105, -0.5) * (v136 - v137 * (v136 + 1.0) * v129 * (-expm1(v103 * v130) / v105)) / v129)
                    v153.append(weight * v152)
                v153 = fsum(v153) * 1.0
                v154 = v101 * v153
                v159 = 2.0 * v112
                v168 = v101 - log(v154) * v154 / (exp(v134) / (v105 * v115) + (v154 - 1.0) * (v159 / v115 - 1.0 / v105))
                v169 = -2.0 * v168
                v171 = -expm1(v169)
                v176 = v112 - v83 * exp(-2.0 * (v168 if v168 < 300.0 or v168 != v168 else 300.0))
                v177 = v176 if v176 > 1.0 or v176 != v176 else 1.0
                v179 = 1.0 / (v116 * v168)
                v194 = v84 * v168
                v211 = []
                for node, weight in RULE_0(1.0 / v179):
                    v180 = node * 1.0
                    v182 = v180 * v180 * v180
                    v184 = v182 * v182 * v180
                    v186 = v184 * v180
                    v189 = -expm1(v169 * v186)
                    v190 = 1.0 - v186
                    v196 = expm1(v194 * v186)
                    v210 = 8.0 * v184 * (exp(v168 * v190) * pow(v189 / v171, -0.5) * (v196 - v137 * (v196 + 1.0) * v189 * (-expm1(v169 * v190) / v171)) / v189)
                    v211.append(weight * v210)
                v211 = fsum(v211) * 1.0
                v212 = v168 * v211
                v225 = v168 - log(v212) * v212 / (exp(v194) / (v171 * v177) + (v212 - 1.0) * (v159 / v177 - 1.0 / v171))
                v226 = -2.0 * v225
                v228 = -expm1(v226)
                v233 = v112 - v83 * exp(-2.0 * (v225 if v225 < 300.0 or v225 != v225 else 300.0))
                v234 = v233 if v233 > 1.0 or v233 != v233 else 1.0
                v236 = 1.0 / (v116 * v225)
                v251 = v84 * v225
                v268 = []
                for node, weight in RULE_0(1.0 / v236):
                    v237 = node * 1.0
                    v239 = v237 * v237 * v237
                    v241 = v239 * v239 * v237
                    v243 = v241 * v237
                    v246 = -expm1(v226 * v243)
                    v247 = 1.0 - v243
                    v253 = expm1(v251 * v243)
                    v267 = 8.0 * v241 * (exp(v225 * v247) * pow(v246 / v228, -0.5) * (v253 - v137 * (v253 + 1.0) * v246 * (-expm1(v226 * v247) / v228)) / v246)
                    v268.append(weight * v267)
                v268 = fsum(v268) * 1.0
                v269 = v225 * v268
                v282 = v225 - log(v269) * v269 / (exp(v251) / (v228 * v234) + (v269 - 1.0) * (v159 / v234 - 1.0 / v228))
                v283 = -2.0 * v282
                v285 = -expm1(v283)
                v290 = v112 - v83 * exp(-2.0 * (v282 if v282 < 300.0 or v282 != v282 else 300.0))
                v291 = v290 if v290 > 1.0 or v290 != v290 else 1.0
                v293 = 1.0 / (v116 * v282)
                v308 = v84 * v282
                v325 = []
                for node, weight in RULE_0(1.0 / v293):
                    v294 = node * 1.0
                    v296 = v294 * v294 * v294
                    v298 = v296 * v296 * v294
                    v300 = v298 * v294
                    v303 = -expm1(v283 * v300)
                    v304 = 1.0 - v300
                    v310 = expm1(v308 * v300)
                    v324 = 8.0 * v298 * (exp(v282 * v304) * pow(v303 / v285, -0.5) * (v310 - v137 * (v310 + 1.0) * v303 * (-expm1(v283 * v304) / v285)) / v303)
                    v325.append(weight * v324)
                v325 = fsum(v325) * 1.0
                v326 = v282 * v325
                v339 = v282 - log(v326) * v326 / (exp(v308) / (v285 * v291) + (v326 - 1.0) * (v159 / v291 - 1.0 / v285))
                v340 = -2.0 * v339
                v342 = -expm1(v340)
                v347 = v112 - v83 * exp(-2.0 * (v339 if v339 < 300.0 or v339 != v339 else 300.0))
                v348 = v347 if v347 > 1.0 or v347 != v347 else 1.0
                v350 = 1.0 / (v116 * v339)
                v365 = v84 * v339
                v382 = []
                for node, weight in RULE_0(1.0 / v350):
                    v351 = node * 1.0
                    v353 = v351 * v351 * v351
                    v355 = v353 * v353 * v351
                    v357 = v355 * v351
                    v360 = -expm1(v340 * v357)
                    v361 = 1.0 - v357
                    v367 = expm1(v365 * v357)
                    v381 = 8.0 * v355 * (exp(v339 * v361) * pow(v360 / v342, -0.5) * (v367 - v137 * (v367 + 1.0) * v360 * (-expm1(v340 * v361) / v342)) / v360)
                    v382.append(weight * v381)
                v382 = fsum(v382) * 1.0
                v383 = v339 * v382
                v400 = -expm1(-2.0 * (v339 - log(v383) * v383 / (exp(v365) / (v342 * v348) + (v383 - 1.0) * (v159 / v348 - 1.0 / v342))))
            else:
                v400 = 1.0
            v404 = 1.7724538509055159 * h
            value = E * pow(t_0 / t, alpha) * sin(v12) / v12 * (2.0 * a * (d + v404 / (n + 1.0) * v80) if v404 * v80 / (n * v400 - 1.0) * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, a, h, n, E, alpha, t_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_standard_solid(t, d, a, h, n, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            v16 = n / 2.0 + 0.5
            v18 = v16 + 1.75
            v22 = (v16 + 0.5) * (v16 + 1.5)
            v36 = 1.0 / (v18 * v18)
            v77 = (v16 * (v16 + 1.0) / v22 if v16 < 1.0 else 1.0 - (v16 + 0.75) / v22) * sqrt(v18) * (1.0 + v36 * (((((((0.01524698625788054 * v36 + 0.5334320651111477) * v36 + 2.250488865813539) * v36 + 2.8612106440066865) * v36 + 1.3794681629043655) * v36 + 0.2596058532893223) * v36 + 0.015624999999999823) / ((((((3.278794792785737 * v36 + 49.328555418276075) * v36 + 167.28648538571198) * v36 + 195.37226190335065) * v36 + 90.69722535867314) * v36 + 16.763212110504565) * v36 + 1.0)))
            v78 = n > 2.0
            if v78:
                v80 = n if v78 else 3.0
                v81 = v80 - 2.0
                v90 = log1p((1.2732395447351628 + 0.9883942191601786 * v81 / (v81 + 0.72)) / v81)
                if v81 < 2.0:
                    v96 = log(v81 * (v81 + 2.0) / 2.0) / v81
                    v98 = v90 if v90 > v96 or v90 != v90 else v96
                else:
                    v98 = v90
                v100 = -2.0 * v98
                v102 = -expm1(v100)
                v109 = v80 - 1.0 + 0.0
                v111 = v109 - v80 * exp(-2.0 * (v98 if v98 < 300.0 or v98 != v98 else 300.0))
                v112 = v111 if v111 > 1.0 or v111 != v111 else 1.0
                v113 = v81 + 1.0
                v115 = 1.0 / (v113 * v98)
                v131 = v81 * v98
                v134 = 0.5 * v81
                v150 = []
                for node, weight in RULE_0(1.0 / v115):
                    v116 = node * 1.0
                    v118 = v116 * v116 * v116
                    v120 = v118 * v118 * v116
                    v123 = v120 * v116
                    v126 = -expm1(v100 * v123)
                    v127 = 1.0 - v123
                    v133 = expm1(v131 * v123)
                    v149 = 8.0 * v120 * (exp(v98 * v127) * pow(v126 / v102, -0.5) * (v133 - v134 * (v133 + 1.0) * v126 * (-expm1(v100 * v127) / v102)) / v126)
                    v150.append(weight * v149)
                v150 = fsum(v150) * 1.0
                v151 = v98 * v150
                v156 = 2.0 * v109
                v165 = v98 - log(v151) * v151 / (exp(v131) / (v102 * v112) + (v151 - 1.0) * (v156 / v112 - 1.0 / v102))
                v166 = -2.0 * v165
                v168 = -expm1(v166)
                v173 = v109 - v80 * exp(-2.0 * (v165 if v165 < 300.0 or v165 != v165 else 300.0))
                v174 = v173 if v173 > 1.0 or v173 != v173 else 1.0
                v176 = 1.0 / (v113 * v165)
                v191 = v81 * v165
                v208 = []
                for node, weight in RULE_0(1.0 / v176):
                    v177 = node * 1.0
                    v179 = v177 * v177 * v177
                    v181 = v179 * v179 * v177
                    v183 = v181 * v177
                    v186 = -expm1(v166 * v183)
                    v187 = 1.0 - v183
                    v193 = expm1(v191 * v183)
                    v207 = 8.0 * v181 * (exp(v165 * v187) * pow(v186 / v168, -0.5) * (v193 - v134 * (v193 + 1.0) * v186 * (-expm1(v166 * v187) / v168)) / v186)
                    v208.append(weight * v207)
                v208 = fsum(v208) * 1.0
                v209 = v165 * v208
                v222 = v165 - log(v209) * v209 / (exp(v191) / (v168 * v174) + (v209 - 1.0) * (v156 / v174 - 1.0 / v168))
                v223 = -2.0 * v222
                v225 = -expm1(v223)
                v230 = v109 - v80 * exp(-2.0 * (v222 if v222 < 300.0 or v222 != v222 else 300.0))
                v231 = v230 if v230 > 1.0 or v230 != v230 else 1.0
                v233 = 1.0 / (v113 * v222)
                v248 = v81 * v222
                v265 = []
                for node, weight in RULE_0(1.0 / v233):
                    v234 = node * 1.0
                    v236 = v234 * v234 * v234
                    v238 = v236 * v236 * v234
                    v240 = v238 * v234
                    v243 = -expm1(v223 * v240)
                    v244 = 1.0 - v240
                    v250 = expm1(v248 * v240)
                    v264 = 8.0 * v238 * (exp(v222 * v244) * pow(v243 / v225, -0.5) * (v250 - v134 * (v250 + 1.0) * v243 * (-expm1(v223 * v244) / v225)) / v243)
                    v265.append(weight * v264)
                v265 = fsum(v265) * 1.0
                v266 = v222 * v265
                v279 = v222 - log(v266) * v266 / (exp(v248) / (v225 * v231) + (v266 - 1.0) * (v156 / v231 - 1.0 / v225))
                v280 = -2.0 * v279
                v282 = -expm1(v280)
                v287 = v109 - v80 * exp(-2.0 * (v279 if v279 < 300.0 or v279 != v279 else 300.0))
                v288 = v287 if v287 > 1.0 or v287 != v287 else 1.0
                v290 = 1.0 / (v113 * v279)
                v305 = v81 * v279
                v322 = []
                for node, weight in RULE_0(1.0 / v290):
                    v291 = node * 1.0
                    v293 = v291 * v291 * v291
                    v295 = v293 * v293 * v291
                    v297 = v295 * v291
                    v300 = -expm1(v280 * v297)
                    v301 = 1.0 - v297
                    v307 = expm1(v305 * v297)
                    v321 = 8.0 * v295 * (exp(v279 * v301) * pow(v300 / v282, -0.5) * (v307 - v134 * (v307 + 1.0) * v300 * (-expm1(v280 * v301) / v282)) / v300)
                    v322.append(weight * v321)
                v322 = fsum(v322) * 1.0
                v323 = v279 * v322
                v336 = v279 - log(v323) * v323 / (exp(v305) / (v282 * v288) + (v323 - 1.0) * (v156 / v288 - 1.0 / v282))
                v337 = -2.0 * v336
                v339 = -expm1(v337)
                v344 = v109 - v80 * exp(-2.0 * (v336 if v336 < 300.0 or v336 != v336 else 300.0))
                v345 = v344 if v344 > 1.0 or v344 != v344 else 1.0
                v347 = 1.0 / (v113 * v336)
                v362 = v81 * v336
                v379 = []
                for node, weight in RULE_0(1.0 / v347):
                    v348 = node * 1.0
                    v350 = v348 * v348 * v348
                    v352 = v350 * v350 * v348
                    v354 = v352 * v348
                    v357 = -expm1(v337 * v354)
                    v358 = 1.0 - v354
                    v364 = expm1(v362 * v354)
                    v378 = 8.0 * v352 * (exp(v336 * v358) * pow(v357 / v339, -0.5) * (v364 - v134 * (v364 + 1.0) * v357 * (-expm1(v337 * v358) / v339)) / v357)
                    v379.append(weight * v378)
                v379 = fsum(v379) * 1.0
                v380 = v336 * v379
                v397 = -expm1(-2.0 * (v336 - log(v380) * v380 / (exp(v362) / (v339 * v345) + (v380 - 1.0) * (v156 / v345 - 1.0 / v339))))
            else:
                v397 = 1.0
            v401 = 1.7724538509055159 * h
            value = (E_inf + E_1 * exp(-t / tau)) * (2.0 * a * (d + v401 / (n + 1.0) * v77) if v401 * v77 / (n * v397 - 1.0) * 0.999999999999999 <= d else nan)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, a, h, n, E_inf, E_1, tau):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
