"""Programs of axicontact.cohesive.power_law."""

from __future__ import annotations

from math import asinh, atan, atan2, cosh, fsum, hypot, inf, nan, pow, sinh, sqrt

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import power_law as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def cohesive_radius(a, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, A, n, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, A, n, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_force(a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(A, n, E_star, dgamma, sigma_0, control):
    if A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and A > 1e-30 and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(A, n, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, A, n, E_star, dgamma, sigma_0):
    if d.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, A, n, E_star, dgamma, sigma_0):
    if F.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, A, n, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, A, n, E_star, dgamma, sigma_0):
    if c.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v7 = hypot(0.0, c)
            v13 = 40.0 / (n if n < 1.0 or n != n else 1.0)
            v14 = inf if inf < v13 or inf != inf else v13
            v25 = n / 2.0 + 0.5
            v27 = v25 + 1.75
            v31 = (v25 + 0.5) * (v25 + 1.5)
            v44 = 1.0 / (v27 * v27)
            v86 = 1.7724538509055159 * n * A * ((v25 * (v25 + 1.0) / v31 if v25 < 1.0 else 1.0 - (v25 + 0.75) / v31) * sqrt(v27) * (1.0 + v44 * (((((((0.01524698625788054 * v44 + 0.5334320651111477) * v44 + 2.250488865813539) * v44 + 2.8612106440066865) * v44 + 1.3794681629043655) * v44 + 0.2596058532893223) * v44 + 0.015624999999999823) / ((((((3.278794792785737 * v44 + 49.328555418276075) * v44 + 167.28648538571198) * v44 + 195.37226190335065) * v44 + 90.69722535867314) * v44 + 16.763212110504565) * v44 + 1.0))))
            v96 = []
            for node, weight in RULE_0(v14 / 1.0):
                v15 = node * v14
                v16 = sinh(v15)
                v17 = cosh(v15)
                v18 = v7 / v17
                v94 = v86 * pow(v18, n) / v18 / v17 * atan(v16) * (v16 / v17)
                v96.append(weight * v94)
            v96 = fsum(v96) * v14
            v117 = sigma_0 / E_star
            v121 = 0.6366197723675814 * v7 * v96 - dgamma / sigma_0 - 1.2732395447351628 * v117 * c
            if v121 <= -(2.0 * v117 * c):
                value = v121
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, A, n, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, A, n, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, A, n, E_star, dgamma, sigma_0):
    if c.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v7 = hypot(0.0, c)
            v13 = 40.0 / (n if n < 1.0 or n != n else 1.0)
            v14 = inf if inf < v13 or inf != inf else v13
            v25 = n / 2.0 + 0.5
            v27 = v25 + 1.75
            v31 = (v25 + 0.5) * (v25 + 1.5)
            v44 = 1.0 / (v27 * v27)
            v86 = 1.7724538509055159 * n * A * ((v25 * (v25 + 1.0) / v31 if v25 < 1.0 else 1.0 - (v25 + 0.75) / v31) * sqrt(v27) * (1.0 + v44 * (((((((0.01524698625788054 * v44 + 0.5334320651111477) * v44 + 2.250488865813539) * v44 + 2.8612106440066865) * v44 + 1.3794681629043655) * v44 + 0.2596058532893223) * v44 + 0.015624999999999823) / ((((((3.278794792785737 * v44 + 49.328555418276075) * v44 + 167.28648538571198) * v44 + 195.37226190335065) * v44 + 90.69722535867314) * v44 + 16.763212110504565) * v44 + 1.0))))
            v96 = []
            for node, weight in RULE_0(v14 / 1.0):
                v15 = node * v14
                v16 = sinh(v15)
                v17 = cosh(v15)
                v18 = v7 / v17
                v94 = v86 * pow(v18, n) / v18 / v17 * atan(v16) * (v16 / v17)
                v96.append(weight * v94)
            v96 = fsum(v96) * v14
            v117 = sigma_0 / E_star
            if 0.6366197723675814 * v7 * v96 - dgamma / sigma_0 - 1.2732395447351628 * v117 * c <= -(2.0 * v117 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, A, n, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, A, n, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, A, n, E_star, sigma_0):
    if a.__class__ is c.__class__ is A.__class__ is n.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = c - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (c + a))
            v12 = hypot(a, v11)
            v14 = a > 0.0
            v20 = asinh(v11 / (a if v14 else 1.0) if v14 else inf)
            v23 = 40.0 / (n if n < 1.0 or n != n else 1.0)
            v24 = v20 if v20 < v23 or v20 != v20 else v23
            v35 = n / 2.0 + 0.5
            v37 = v35 + 1.75
            v41 = (v35 + 0.5) * (v35 + 1.5)
            v54 = 1.0 / (v37 * v37)
            v96 = 1.7724538509055159 * n * A * ((v35 * (v35 + 1.0) / v41 if v35 < 1.0 else 1.0 - (v35 + 0.75) / v41) * sqrt(v37) * (1.0 + v54 * (((((((0.01524698625788054 * v54 + 0.5334320651111477) * v54 + 2.250488865813539) * v54 + 2.8612106440066865) * v54 + 1.3794681629043655) * v54 + 0.2596058532893223) * v54 + 0.015624999999999823) / ((((((3.278794792785737 * v54 + 49.328555418276075) * v54 + 167.28648538571198) * v54 + 195.37226190335065) * v54 + 90.69722535867314) * v54 + 16.763212110504565) * v54 + 1.0))))
            v106 = []
            for node, weight in RULE_0(v24 / 1.0):
                v25 = node * v24
                v26 = sinh(v25)
                v27 = cosh(v25)
                v28 = v12 / v27
                v104 = v96 * pow(v28, n) / v28 / v27 * atan(v26) * (v26 / v27)
                v106.append(weight * v104)
            v106 = fsum(v106) * v24
            value = sigma_0 * (0.6366197723675814 * v12 * v106 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (atan2(v11, a) - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, A, n, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
