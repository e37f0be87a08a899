"""Programs of axicontact.graded.normal.concave_power."""

from __future__ import annotations

from math import exp, expm1, fsum, inf, log, log1p, pow, sin

import numpy as np

from ...._runtime.interface import largest, ordinary
from ...._runtime.plain import rule
from ...._programs.bodies.graded.normal import concave_power as bodies

C0 = np.array(2.0)
C1 = np.array(1.0)
C2 = np.array(0.0)
RULE_0 = rule(((3.0, 32), (20.0, 64), (inf, 128)))


def depth_from_force(F, a, h, n, H, k):
    if F.__class__ is a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._depth_from_force(F, a, h, n, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, a, h, n, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, d, a, h, n, k):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._displacement(r, d, a, h, n, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(d, a, h, n, H, k):
    if d.__class__ is a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._force(d, a, h, n, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, a, h, n, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def minimum_depth(a, h, n, k):
    if a.__class__ is h.__class__ is n.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._minimum_depth(a, h, n, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, n, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def minimum_force(a, h, n, H, k):
    if a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._minimum_force(a, h, n, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, n, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, d, a, h, n, H, k):
    if r.__class__ is d.__class__ is a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._pressure(r, d, a, h, n, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, h, n, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(a, H, k, h=1.0, n=1.0):
    if a.__class__ is H.__class__ is k.__class__ is h.__class__ is n.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30):
        try:
            value = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_stiffness_all_signed():
    return ()


def block_stiffness_all_signed(out, a, H, k, t0, m0):
    size = out.size
    np.multiply(C0, H, out)
    np.add(C1, k, t0)
    np.divide(out, t0, t0)
    np.greater(a, C2, m0)
    some12 = np.count_nonzero(m0)
    if some12:
        np.power(a, k, out)
        np.multiply(a, out, out)
    if some12 != size:
        np.copyto(out, C2, where=~m0)
    np.multiply(t0, out, out)


def zero_radius(a, h, n, k):
    if a.__class__ is h.__class__ is n.__class__ is k.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            v5 = n > 2.0
            if v5:
                v7 = n if v5 else 3.0
                v8 = v7 - 2.0
                v10 = 1.0 - k
                v16 = 1.0 + k
                v17 = 1.2732395447351628 * sin(1.5707963267948966 * v10) / v16
                v29 = 0.36 + 0.4 * k
                v42 = log1p((v17 + (2.0 * expm1(-0.5 * v10 * log(v10 / 4.0)) - v17) * (1.0 + v29) * v8 / (v8 + 2.0 * (v29 if v29 > 0.0 or v29 != v29 else 0.0))) / v8) / v10
                if v8 < 2.0:
                    v49 = log(v8 * (v8 + 2.0) / (2.0 * v10)) / v8
                    v51 = v42 if v42 > v49 or v42 != v42 else v49
                else:
                    v51 = v42
                v53 = -2.0 * v51
                v55 = -expm1(v53)
                v61 = v7 - 1.0 + k
                v63 = v61 - v7 * exp(-2.0 * (v51 if v51 < 300.0 or v51 != v51 else 300.0))
                v64 = v63 if v63 > v16 or v63 != v63 else v16
                v65 = v10 * v51
                v66 = v8 + 1.0
                v68 = 1.0 / (v66 * v51)
                v84 = v8 * v51
                v88 = 0.5 * v8
                v99 = (k - 1.0) / 2.0
                v105 = []
                for node, weight in RULE_0(1.0 / v68):
                    v69 = node * 1.0
                    v71 = v69 * v69 * v69
                    v73 = v71 * v71 * v69
                    v76 = v73 * v69
                    v79 = -expm1(v53 * v76)
                    v80 = 1.0 - v76
                    v86 = expm1(v84 * v76)
                    v104 = 8.0 * v73 * (exp(v65 * v80) * pow(v79 / v55, v99) * (v86 - v88 * (v86 + 1.0) * v79 * (-expm1(v53 * v80) / v55)) / v79)
                    v105.append(weight * v104)
                v105 = fsum(v105) * 1.0
                v106 = v65 * v105
                v107 = v10 * v16
                v113 = 2.0 * v61
                v122 = v51 - log(v106) * v106 / (v107 * exp(v84) / (v55 * v64) + (v106 - 1.0) * (v113 / v64 - v16 / v55))
                v123 = -2.0 * v122
                v125 = -expm1(v123)
                v130 = v61 - v7 * exp(-2.0 * (v122 if v122 < 300.0 or v122 != v122 else 300.0))
                v131 = v130 if v130 > v16 or v130 != v130 else v16
                v132 = v10 * v122
                v134 = 1.0 / (v66 * v122)
                v149 = v8 * v122
                v166 = []
                for node, weight in RULE_0(1.0 / v134):
                    v135 = node * 1.0
                    v137 = v135 * v135 * v135
                    v139 = v137 * v137 * v135
                    v141 = v139 * v135
                    v144 = -expm1(v123 * v141)
                    v145 = 1.0 - v141
                    v151 = expm1(v149 * v141)
                    v165 = 8.0 * v139 * (exp(v132 * v145) * pow(v144 / v125, v99) * (v151 - v88 * (v151 + 1.0) * v144 * (-expm1(v123 * v145) / v125)) / v144)
                    v166.append(weight * v165)
                v166 = fsum(v166) * 1.0
                v167 = v132 * v166
                v181 = v122 - log(v167) * v167 / (v107 * exp(v149) / (v125 * v131) + (v167 - 1.0) * (v113 / v131 - v16 / v125))
                v182 = -2.0 * v181
                v184 = -expm1(v182)
                v189 = v61 - v7 * exp(-2.0 * (v181 if v181 < 300.0 or v181 != v181 else 300.0))
                v190 = v189 if v189 > v16 or v189 != v189 else v16
                v191 = v10 * v181
                v193 = 1.0 / (v66 * v181)
                v208 = v8 * v181
                v225 = []
                for node, weight in RULE_0(1.0 / v193):
                    v194 = node * 1.0
                    v196 = v194 * v194 * v194
                    v198 = v196 * v196 * v194
                    v200 = v198 * v194
                    v203 = -expm1(v182 * v200)
                    v204 = 1.0 - v200
                    v210 = expm1(v208 * v200)
                    v224 = 8.0 * v198 * (exp(v191 * v204) * pow(v203 / v184, v99) * (v210 - v88 * (v210 + 1.0) * v203 * (-expm1(v182 * v204) / v184)) / v203)
                    v225.append(weight * v224)
                v225 = fsum(v225) * 1.0
                v226 = v191 * v225
                v240 = v181 - log(v226) * v226 / (v107 * exp(v208) / (v184 * v190) + (v226 - 1.0) * (v113 / v190 - v16 / v184))
                v241 = -2.0 * v240
                v243 = -expm1(v241)
                v248 = v61 - v7 * exp(-2.0 * (v240 if v240 < 300.0 or v240 != v240 else 300.0))
                v249 = v248 if v248 > v16 or v248 != v248 else v16
                v250 = v10 * v240
                v252 = 1.0 / (v66 * v240)
                v267 = v8 * v240
                v284 = []
                for node, weight in RULE_0(1.0 / v252):
                    v253 = node * 1.0
                    v255 = v253 * v253 * v253
                    v257 = v255 * v255 * v253
                    v259 = v257 * v253
                    v262 = -expm1(v241 * v259)
                    v263 = 1.0 - v259
                    v269 = expm1(v267 * v259)
                    v283 = 8.0 * v257 * (exp(v250 * v263) * pow(v262 / v243, v99) * (v269 - v88 * (v269 + 1.0) * v262 * (-expm1(v241 * v263) / v243)) / v262)
                    v284.append(weight * v283)
                v284 = fsum(v284) * 1.0
                v285 = v250 * v284
                v299 = v240 - log(v285) * v285 / (v107 * exp(v267) / (v243 * v249) + (v285 - 1.0) * (v113 / v249 - v16 / v243))
                v300 = -2.0 * v299
                v302 = -expm1(v300)
                v307 = v61 - v7 * exp(-2.0 * (v299 if v299 < 300.0 or v299 != v299 else 300.0))
                v308 = v307 if v307 > v16 or v307 != v307 else v16
                v309 = v10 * v299
                v311 = 1.0 / (v66 * v299)
                v326 = v8 * v299
                v343 = []
                for node, weight in RULE_0(1.0 / v311):
                    v312 = node * 1.0
                    v314 = v312 * v312 * v312
                    v316 = v314 * v314 * v312
                    v318 = v316 * v312
                    v321 = -expm1(v300 * v318)
                    v322 = 1.0 - v318
                    v328 = expm1(v326 * v318)
                    v342 = 8.0 * v316 * (exp(v309 * v322) * pow(v321 / v302, v99) * (v328 - v88 * (v328 + 1.0) * v321 * (-expm1(v300 * v322) / v302)) / v321)
                    v343.append(weight * v342)
                v343 = fsum(v343) * 1.0
                v344 = v309 * v343
                v361 = exp(-(v299 - log(v344) * v344 / (v107 * exp(v326) / (v302 * v308) + (v344 - 1.0) * (v113 / v308 - v16 / v302))))
            else:
                v361 = 0.0
            value = a * v361 + 0.0 * h
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, n, k):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_stiffness', 0, 'a', 'H', 'k'): {
        ('a', 'H', 'k'): (('a', 'H', 'k'), prepare_stiffness_all_signed, block_stiffness_all_signed, 1, 1, (), False),
    },
}
