"""Programs of axicontact.tangential.sphere_tipped_cone."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, exp, expm1, fsum, inf, log1p, pow, sin, sinh, sqrt, tanh

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.tangential import sphere_tipped_cone as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def full_slip_displacement(a, R, theta, E_star, G_star, mu):
    if a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v9 = R * sin(theta)
            v14 = R - a
            if a < v9:
                v46 = a * (log1p(2.0 * a / v14) / 2.0)
            else:
                v11 = R * cos(theta)
                v21 = v11 * v11 - v14 * (R + a) if v11 < v9 else (a - v9) * (a + v9)
                v24 = sqrt(v21 if v21 > 0.0 or v21 != v21 else 0.0)
                v27 = v9 * v9
                v46 = a * (log1p((v27 / (v24 + a) + v27 / (v11 + R)) / (v24 + v11)) + v9 * atan2(v24, v9) / v11)
            value = mu * (E_star / G_star) * v46
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, theta, E_star, G_star, mu):
    v6 = E_star / G_star
    v7 = mu * v6
    v8 = np.sin(theta)
    v9 = R * v8
    v10 = np.cos(theta)
    v11 = R * v10
    v12 = np.less(v11, v9)
    v13 = v11 * v11
    v27 = np.square(v9)
    v30 = v11 + R
    v31 = v27 / v30
    return (R, v7, v9, v11, v12, v13, v27, v31)


def block_full_slip_displacement_a(out, a, R, v7, v9, v11, v12, v13, v27, v31, t0, t1, t2, t3, m0, f0):
    size = out.size
    np.subtract(R, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.less(a, v9, m0)
    some47 = np.count_nonzero(m0)
    if some47:
        np.multiply(C0, a, t0)
        np.divide(t0, out, t0)
        np.log1p(t0, t0)
        np.multiply(t0, C1, t0)
        np.multiply(a, t0, t0)
    if some47 != size:
        other47 = t1 if some47 else t0
        if v12:
            np.add(R, a, other47)
            np.multiply(out, other47, other47)
            np.subtract(v13, other47, other47)
        else:
            np.subtract(a, v9, other47)
            np.add(a, v9, t2)
            np.multiply(other47, t2, other47)
        np.maximum(other47, f0, out=other47)
        np.sqrt(other47, other47)
        np.arctan2(other47, v9, t2)
        np.add(other47, a, t3)
        np.divide(v27, t3, t3)
        np.add(t3, v31, t3)
        np.add(other47, v11, other47)
        np.divide(t3, other47, other47)
        np.log1p(other47, other47)
        np.multiply(v9, t2, t2)
        np.divide(t2, v11, t2)
        np.add(other47, t2, t2)
        np.multiply(a, t2, other47)
        if some47:
            np.copyto(t0, other47, where=~m0)
    np.multiply(v7, t0, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, theta, E_star, G_star, mu, t0, t1, t2, t3, t4, t5, t6, t7, t8, m0, m1, f0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.sin(theta, t0)
    np.multiply(R, t0, t0)
    np.subtract(R, a, t1)
    np.less(a, t0, m0)
    some47 = np.count_nonzero(m0)
    if some47:
        np.multiply(C0, a, t2)
        np.divide(t2, t1, t2)
        np.log1p(t2, t2)
        np.multiply(t2, C1, t2)
        np.multiply(a, t2, t2)
    if some47 != size:
        other47 = t3 if some47 else t2
        np.cos(theta, other47)
        np.multiply(R, other47, other47)
        np.less(other47, t0, m1)
        some21 = np.count_nonzero(m1)
        if some21:
            np.multiply(other47, other47, t4)
            np.add(R, a, t5)
            np.multiply(t1, t5, t5)
            np.subtract(t4, t5, t4)
        if some21 != size:
            other21 = t5 if some21 else t4
            np.subtract(a, t0, other21)
            np.add(a, t0, t6)
            np.multiply(other21, t6, other21)
            if some21:
                np.copyto(t4, other21, where=~m1)
        np.maximum(t4, f0, out=t4)
        np.sqrt(t4, t4)
        np.arctan2(t4, t0, t5)
        np.square(t0, t6)
        np.add(t4, a, t7)
        np.divide(t6, t7, t7)
        np.add(other47, R, t8)
        np.divide(t6, t8, t8)
        np.add(t7, t8, t8)
        np.add(t4, other47, t4)
        np.divide(t8, t4, t4)
        np.log1p(t4, t4)
        np.multiply(t0, t5, t5)
        np.divide(t5, other47, other47)
        np.add(t4, other47, other47)
        np.multiply(a, other47, other47)
        if some47:
            np.copyto(t2, other47, where=~m0)
    np.multiply(out, t2, out)


def stick_radius(F_x, a, R, theta, E_star, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, R, theta, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, theta, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, theta, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v8 = R * sin(theta)
            v10 = R * cos(theta)
            v11 = v10 < v8
            v12 = v10 * v10
            v13 = R - a
            v17 = a - v8
            v18 = a + v8
            v26 = v8 * v8
            v30 = v26 / (v10 + R)
            if a < v8:
                v45 = a * (log1p(2.0 * a / v13) / 2.0)
            else:
                v20 = v12 - v13 * (R + a) if v11 else v17 * v18
                v23 = sqrt(v20 if v20 > 0.0 or v20 != v20 else 0.0)
                v45 = a * (log1p((v26 / (v23 + a) + v30) / (v23 + v10)) + v8 * atan2(v23, v8) / v10)
            v46 = R - c
            v47 = R + c
            if c < v8:
                v73 = c * (log1p(2.0 * c / v46) / 2.0)
            else:
                v53 = v12 - v46 * v47 if v11 else (c - v8) * (c + v8)
                v55 = sqrt(v53 if v53 > 0.0 or v53 != v53 else 0.0)
                v73 = c * (log1p((v26 / (v55 + c) + v30) / (v55 + v10)) + v8 * atan2(v55, v8) / v10)
            v76 = v73 >= 0.25 * v45
            if v76:
                v77 = a if a < v8 or a != a else v8
                v102 = v77 > c
                v116 = v76 and v102
                if v116:
                    v78 = R - 0.0
                    v82 = sqrt((v78 if v78 > 0.0 or v78 != v78 else 0.0) * (R + 0.0))
                    v83 = c - 0.0
                    v87 = sqrt((v83 if v83 > 0.0 or v83 != v83 else 0.0) * (c + 0.0))
                    if v116:
                        v91 = v77 - 0.0
                        v95 = sqrt((v91 if v91 > 0.0 or v91 != v91 else 0.0) * (v77 + 0.0))
                        v96 = R - v77
                        v100 = sqrt((v96 if v96 > 0.0 or v96 != v96 else 0.0) * (R + v77))
                        v120 = 0.5 * log1p(2.0 * v82 * ((v77 - c) * (v77 + c) / (v95 + v87) if v102 else 0.0) / v100 * ((v82 + v95) / (v82 + v87)) / v100)
                    else:
                        v120 = 0.0
                    v133 = v82 * sqrt((v46 if v46 > 0.0 or v46 != v46 else 0.0) * v47)
                    v150 = []
                    for node, weight in RULE_0(v120 / 1.0):
                        v122 = node * v120
                        v123 = cosh(v122)
                        v124 = sinh(v122)
                        v127 = v82 * v123 + v87 * v124
                        v132 = v82 * (v87 * v123 + v82 * v124) / v127
                        v134 = v133 / v127
                        v137 = sqrt(0.0 + v132 * v132)
                        v149 = (asinh(v137 / v134) + R * v137 / (v134 * v134)) * (v134 / v82) * (v134 / v137) * pow(v137, 1.0)
                        v150.append(weight * v149)
                    v150 = fsum(v150) * v120
                    v151 = v150
                else:
                    v151 = 0.0
                v156 = v8 if v8 > c or v8 != v8 else c
                v170 = a > v156
                v186 = v76 and v170
                if v186:
                    v155 = 1.0 - 2.0 * theta / 3.141592653589793
                    v157 = v156 - v8
                    v161 = sqrt((v157 if v157 > 0.0 or v157 != v157 else 0.0) * (v156 + v8))
                    v162 = v156 - 0.0
                    v166 = sqrt((v162 if v162 > 0.0 or v162 != v162 else 0.0) * (v156 + 0.0))
                    if v186:
                        v173 = (a - v156) * (a + v156)
                        if v170:
                            v177 = a - 0.0
                            v184 = v173 / (sqrt((v177 if v177 > 0.0 or v177 != v177 else 0.0) * (a + 0.0)) + v166)
                        else:
                            v184 = 0.0
                        v190 = log1p(((v173 / (sqrt((v17 if v17 > 0.0 or v17 != v17 else 0.0) * v18) + v161) if v170 else 0.0) + v184) / (v161 + v166))
                    else:
                        v190 = 0.0
                    v197 = v8 * v8
                    v211 = v26 * R
                    v212 = v10 * v10
                    v223 = []
                    for node, weight in RULE_0(v190 / v155):
                        v191 = node * v190
                        v196 = v161 * cosh(v191) + v166 * sinh(v191)
                        v200 = sqrt(v197 + v196 * v196)
                        v222 = (log1p((v26 / (v196 + v200) + v30) / (v196 + v10)) + v8 * atan2(v196, v8) / v10 + v211 / (v200 * v212 + R * v196 * v10)) * (v196 / v200) * pow(v200, 1.0)
                        v223.append(weight * v222)
                    v223 = fsum(v223) * v190
                    v224 = v223
                else:
                    v224 = 0.0
                v229 = v151 + v224
            else:
                v229 = v45 - v73
            value = mu * (E_star / G_star) * v229
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, theta, E_star, G_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R, theta, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v7 = R * sin(theta)
            v9 = R * cos(theta)
            v10 = v9 < v7
            v11 = v9 * v9
            v16 = a - v7
            v17 = a + v7
            v19 = v11 - (R - a) * (R + a) if v10 else v16 * v17
            v22 = sqrt(v19 if v19 > 0.0 or v19 != v19 else 0.0)
            v23 = a if a < v7 or a != a else v7
            v25 = R - v23
            v31 = asinh(v23 / (sqrt(v25 * (v23 + R)) if a < v7 else v9))
            v35 = R * R
            v36 = tanh(v31)
            if v31 < 1.0:
                v42 = v31 * v31
                v77 = v36 * (v36 * v36) * ((((((1.0716932453474512e-06 * v42 + 0.00019982814521087247) * v42 + 0.007076196047699156) * v42 + 0.08608622548411103) * v42 + 0.3073858328214721) * v42 + 0.3333333333333333) / (((((2.565078604208634e-08 * v42 + 2.0203143566039827e-05) * v42 + 0.001617010334189783) * v42 + 0.03639274880225476) * v42 + 0.32215749846441627) * v42 + 1.0))
            else:
                v77 = v31 - v36
            v81 = 2.0 * E_star
            v85 = 1.0 - 2.0 * theta / 3.141592653589793
            v87 = asinh(v22 / v7)
            v91 = 0.0 - expm1(-2.0 * v87)
            v94 = v91 if v91 > 0.0 else inf
            v105 = v7 * v7
            v110 = v7 * v7
            v114 = v110 / (v9 + R)
            v122 = v110 * R
            v123 = v9 * v9
            v132 = []
            for node, weight in RULE_0(v87 / v85):
                v95 = node * v87
                v104 = v22 * (exp(-v95) * (0.0 - expm1(-2.0 * (v87 - v95))) / v94)
                v108 = sqrt(v105 + v104 * v104)
                v131 = (log1p((v110 / (v104 + v108) + v114) / (v104 + v9)) + v7 * atan2(v104, v7) / v9 + v122 / (v108 * v123 + R * v104 * v9)) * v104 * v108
                v132.append(weight * v131)
            v132 = fsum(v132) * v87
            v135 = E_star * (v23 * v23 * v31 + v35 * v77) + v81 * v132
            v136 = R - c
            v137 = R + c
            v143 = v11 - v136 * v137 if v10 else (c - v7) * (c + v7)
            v145 = sqrt(v143 if v143 > 0.0 or v143 != v143 else 0.0)
            v146 = c if c < v7 or c != c else v7
            v154 = asinh(v146 / (sqrt((R - v146) * (v146 + R)) if c < v7 else v9))
            v157 = tanh(v154)
            if v154 < 1.0:
                v162 = v154 * v154
                v186 = v157 * (v157 * v157) * ((((((1.0716932453474512e-06 * v162 + 0.00019982814521087247) * v162 + 0.007076196047699156) * v162 + 0.08608622548411103) * v162 + 0.3073858328214721) * v162 + 0.3333333333333333) / (((((2.565078604208634e-08 * v162 + 2.0203143566039827e-05) * v162 + 0.001617010334189783) * v162 + 0.03639274880225476) * v162 + 0.32215749846441627) * v162 + 1.0))
            else:
                v186 = v154 - v157
            v191 = asinh(v145 / v7)
            v194 = 0.0 - expm1(-2.0 * v191)
            v196 = v194 if v194 > 0.0 else inf
            v228 = []
            for node, weight in RULE_0(v191 / v85):
                v197 = node * v191
                v206 = v145 * (exp(-v197) * (0.0 - expm1(-2.0 * (v191 - v197))) / v196)
                v209 = sqrt(v105 + v206 * v206)
                v227 = (log1p((v110 / (v206 + v209) + v114) / (v206 + v9)) + v7 * atan2(v206, v7) / v9 + v122 / (v209 * v123 + R * v206 * v9)) * v206 * v209
                v228.append(weight * v227)
            v228 = fsum(v228) * v191
            v230 = E_star * (v146 * v146 * v154 + v35 * v186) + v81 * v228
            v233 = v230 >= 0.25 * v135
            if v233:
                v257 = v23 > c
                v271 = v233 and v257
                if v271:
                    v234 = R - 0.0
                    v238 = sqrt((v234 if v234 > 0.0 or v234 != v234 else 0.0) * (R + 0.0))
                    v239 = c - 0.0
                    v243 = sqrt((v239 if v239 > 0.0 or v239 != v239 else 0.0) * (c + 0.0))
                    if v271:
                        v247 = v23 - 0.0
                        v251 = sqrt((v247 if v247 > 0.0 or v247 != v247 else 0.0) * (v23 + 0.0))
                        v255 = sqrt((v25 if v25 > 0.0 or v25 != v25 else 0.0) * (R + v23))
                        v275 = 0.5 * log1p(2.0 * v238 * ((v23 - c) * (v23 + c) / (v251 + v243) if v257 else 0.0) / v255 * ((v238 + v251) / (v238 + v243)) / v255)
                    else:
                        v275 = 0.0
                    v287 = v238 * sqrt((v136 if v136 > 0.0 or v136 != v136 else 0.0) * v137)
                    v304 = []
                    for node, weight in RULE_0(v275 / 1.0):
                        v276 = node * v275
                        v277 = cosh(v276)
                        v278 = sinh(v276)
                        v281 = v238 * v277 + v243 * v278
                        v286 = v238 * (v243 * v277 + v238 * v278) / v281
                        v288 = v287 / v281
                        v291 = sqrt(0.0 + v286 * v286)
                        v303 = (asinh(v291 / v288) + R * v291 / (v288 * v288)) * (v288 / v238) * (v288 / v291) * (v291 * v291)
                        v304.append(weight * v303)
                    v304 = fsum(v304) * v275
                    v305 = v304
                else:
                    v305 = 0.0
                v306 = v7 if v7 > c or v7 != v7 else c
                v320 = a > v306
                v336 = v233 and v320
                if v336:
                    v307 = v306 - v7
                    v311 = sqrt((v307 if v307 > 0.0 or v307 != v307 else 0.0) * (v306 + v7))
                    v312 = v306 - 0.0
                    v316 = sqrt((v312 if v312 > 0.0 or v312 != v312 else 0.0) * (v306 + 0.0))
                    if v336:
                        v323 = (a - v306) * (a + v306)
                        if v320:
                            v327 = a - 0.0
                            v334 = v323 / (sqrt((v327 if v327 > 0.0 or v327 != v327 else 0.0) * (a + 0.0)) + v316)
                        else:
                            v334 = 0.0
                        v340 = log1p(((v323 / (sqrt((v16 if v16 > 0.0 or v16 != v16 else 0.0) * v17) + v311) if v320 else 0.0) + v334) / (v311 + v316))
                    else:
                        v340 = 0.0
                    v370 = []
                    for node, weight in RULE_0(v340 / v85):
                        v341 = node * v340
                        v346 = v311 * cosh(v341) + v316 * sinh(v341)
                        v349 = sqrt(v105 + v346 * v346)
                        v369 = (log1p((v110 / (v346 + v349) + v114) / (v346 + v9)) + v7 * atan2(v346, v7) / v9 + v122 / (v349 * v123 + R * v346 * v9)) * (v346 / v349) * (v349 * v349)
                        v370.append(weight * v369)
                    v370 = fsum(v370) * v340
                    v371 = v370
                else:
                    v371 = 0.0
                v375 = v81 * (v305 + v371)
            else:
                v375 = v135 - v230
            value = mu * v375
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, theta, E_star, mu):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R, theta, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is theta.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._traction(r, a, c, R, theta, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R, theta, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'theta', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 4, 1, (0.0,), False),
        ('a', 'R', 'theta', 'E_star', 'G_star', 'mu'): (('a', 'R', 'theta', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 9, 2, (0.0,), False),
    },
}
