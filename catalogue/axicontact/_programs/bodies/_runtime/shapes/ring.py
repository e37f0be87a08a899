"""Bodies of axicontact._runtime.shapes.ring over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import exp, expm1, fsum, inf, pow, sin

from ....._runtime.plain import log, log1p, rule

RULE_0 = rule(((3.0, 32), (20.0, 64), (inf, 128)))


def lifted_at_zero_pressure(n, k):
    v6 = n > 2.0
    v365 = n - 1.0
    if v6:
        v3 = 1.0 + k
        v5 = v3 / 2.0
        v8 = n if v6 else 3.0
        v9 = v8 - 2.0
        v10 = 1.0 - k
        v16 = 1.2732395447351628 * sin(1.5707963267948966 * v10) / v3
        v28 = 0.36 + 0.4 * k
        v41 = log1p((v16 + (2.0 * expm1(-0.5 * v10 * log(v10 / 4.0)) - v16) * (1.0 + v28) * v9 / (v9 + 2.0 * (v28 if v28 > 0.0 or v28 != v28 else 0.0))) / v9) / v10
        if v9 < 2.0:
            v48 = log(v9 * (v9 + 2.0) / (2.0 * v10)) / v9
            v50 = v41 if v41 > v48 or v41 != v41 else v48
        else:
            v50 = v41
        v52 = -2.0 * v50
        v54 = -expm1(v52)
        v60 = v8 - 1.0 + k
        v62 = v60 - v8 * exp(-2.0 * (v50 if v50 < 300.0 or v50 != v50 else 300.0))
        v63 = v62 if v62 > v3 or v62 != v62 else v3
        v64 = v10 * v50
        v65 = v9 + 1.0
        v67 = 1.0 / (v65 * v50)
        v83 = v9 * v50
        v87 = 0.5 * v9
        v98 = (k - 1.0) / 2.0
        v104 = []
        for node, weight in RULE_0(1.0 / v67):
            v68 = node * 1.0
            v70 = v68 * v68 * v68
            v72 = v70 * v70 * v68
            v75 = v72 * v68
            v78 = -expm1(v52 * v75)
            v79 = 1.0 - v75
            v85 = expm1(v83 * v75)
            v103 = 8.0 * v72 * (exp(v64 * v79) * pow(v78 / v54, v98) * (v85 - v87 * (v85 + 1.0) * v78 * (-expm1(v52 * v79) / v54)) / v78)
            v104.append(weight * v103)
        v104 = fsum(v104) * 1.0
        v105 = v64 * v104
        v106 = v10 * v3
        v112 = 2.0 * v60
        v121 = v50 - log(v105) * v105 / (v106 * exp(v83) / (v54 * v63) + (v105 - 1.0) * (v112 / v63 - v3 / v54))
        v122 = -2.0 * v121
        v124 = -expm1(v122)
        v129 = v60 - v8 * exp(-2.0 * (v121 if v121 < 300.0 or v121 != v121 else 300.0))
        v130 = v129 if v129 > v3 or v129 != v129 else v3
        v131 = v10 * v121
        v133 = 1.0 / (v65 * v121)
        v148 = v9 * v121
        v165 = []
        for node, weight in RULE_0(1.0 / v133):
            v134 = node * 1.0
            v136 = v134 * v134 * v134
            v138 = v136 * v136 * v134
            v140 = v138 * v134
            v143 = -expm1(v122 * v140)
            v144 = 1.0 - v140
            v150 = expm1(v148 * v140)
            v164 = 8.0 * v138 * (exp(v131 * v144) * pow(v143 / v124, v98) * (v150 - v87 * (v150 + 1.0) * v143 * (-expm1(v122 * v144) / v124)) / v143)
            v165.append(weight * v164)
        v165 = fsum(v165) * 1.0
        v166 = v131 * v165
        v180 = v121 - log(v166) * v166 / (v106 * exp(v148) / (v124 * v130) + (v166 - 1.0) * (v112 / v130 - v3 / v124))
        v181 = -2.0 * v180
        v183 = -expm1(v181)
        v188 = v60 - v8 * exp(-2.0 * (v180 if v180 < 300.0 or v180 != v180 else 300.0))
        v189 = v188 if v188 > v3 or v188 != v188 else v3
        v190 = v10 * v180
        v192 = 1.0 / (v65 * v180)
        v207 = v9 * v180
        v224 = []
        for node, weight in RULE_0(1.0 / v192):
            v193 = node * 1.0
            v195 = v193 * v193 * v193
            v197 = v195 * v195 * v193
            v199 = v197 * v193
            v202 = -expm1(v181 * v199)
            v203 = 1.0 - v199
            v209 = expm1(v207 * v199)
            v223 = 8.0 * v197 * (exp(v190 * v203) * pow(v202 / v183, v98) * (v209 - v87 * (v209 + 1.0) * v202 * (-expm1(v181 * v203) / v183)) / v202)
            v224.append(weight * v223)
        v224 = fsum(v224) * 1.0
        v225 = v190 * v224
        v239 = v180 - log(v225) * v225 / (v106 * exp(v207) / (v183 * v189) + (v225 - 1.0) * (v112 / v189 - v3 / v183))
        v240 = -2.0 * v239
        v242 = -expm1(v240)
        v247 = v60 - v8 * exp(-2.0 * (v239 if v239 < 300.0 or v239 != v239 else 300.0))
        v248 = v247 if v247 > v3 or v247 != v247 else v3
        v249 = v10 * v239
        v251 = 1.0 / (v65 * v239)
        v266 = v9 * v239
        v283 = []
        for node, weight in RULE_0(1.0 / v251):
            v252 = node * 1.0
            v254 = v252 * v252 * v252
            v256 = v254 * v254 * v252
            v258 = v256 * v252
            v261 = -expm1(v240 * v258)
            v262 = 1.0 - v258
            v268 = expm1(v266 * v258)
            v282 = 8.0 * v256 * (exp(v249 * v262) * pow(v261 / v242, v98) * (v268 - v87 * (v268 + 1.0) * v261 * (-expm1(v240 * v262) / v242)) / v261)
            v283.append(weight * v282)
        v283 = fsum(v283) * 1.0
        v284 = v249 * v283
        v298 = v239 - log(v284) * v284 / (v106 * exp(v266) / (v242 * v248) + (v284 - 1.0) * (v112 / v248 - v3 / v242))
        v299 = -2.0 * v298
        v301 = -expm1(v299)
        v306 = v60 - v8 * exp(-2.0 * (v298 if v298 < 300.0 or v298 != v298 else 300.0))
        v307 = v306 if v306 > v3 or v306 != v306 else v3
        v308 = v10 * v298
        v310 = 1.0 / (v65 * v298)
        v325 = v9 * v298
        v342 = []
        for node, weight in RULE_0(1.0 / v310):
            v311 = node * 1.0
            v313 = v311 * v311 * v311
            v315 = v313 * v313 * v311
            v317 = v315 * v311
            v320 = -expm1(v299 * v317)
            v321 = 1.0 - v317
            v327 = expm1(v325 * v317)
            v341 = 8.0 * v315 * (exp(v308 * v321) * pow(v320 / v301, v98) * (v327 - v87 * (v327 + 1.0) * v320 * (-expm1(v299 * v321) / v301)) / v320)
            v342.append(weight * v341)
        v342 = fsum(v342) * 1.0
        v343 = v308 * v342
        v357 = v298 - log(v343) * v343 / (v106 * exp(v325) / (v301 * v307) + (v343 - 1.0) * (v112 / v307 - v3 / v301))
        v360 = -2.0 * v357
        v362 = -expm1(v360)
        v367 = 1.0 / (v365 * v357)
        v376 = -(n - 3.0 + k) * v357
        v387 = []
        for node, weight in RULE_0(1.0 / v367):
            v368 = node * 1.0
            v370 = v368 * v368 * v368
            v372 = v370 * v370 * v368
            v374 = v372 * v368
            v386 = 8.0 * v372 * (exp(v376 * (1.0 - v374)) * pow(-expm1(v360 * v374) / v362, v5))
            v387.append(weight * v386)
        v387 = fsum(v387) * 1.0
        return n * v3 / ((n - 2.0) * (1.0 - (n - 4.0) * v357 * v387))
    return v365 + k
