"""Programs of axicontact.cohesive.power_law."""

from __future__ import annotations

from math import asinh, atan, atan2, cosh, fsum, hypot, inf, nan, pow, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import power_law as bodies

C0 = np.array(0.5)
C1 = np.array(1.75)
C2 = np.array(1.5)
C3 = np.array(1.0)
C4 = np.array(0.75)
C5 = np.array(0.01524698625788054)
C6 = np.array(0.5334320651111477)
C7 = np.array(2.250488865813539)
C8 = np.array(2.8612106440066865)
C9 = np.array(1.3794681629043655)
C10 = np.array(0.2596058532893223)
C11 = np.array(0.015624999999999823)
C12 = np.array(3.278794792785737)
C13 = np.array(49.328555418276075)
C14 = np.array(167.28648538571198)
C15 = np.array(195.37226190335065)
C16 = np.array(90.69722535867314)
C17 = np.array(16.763212110504565)
C18 = np.array(3.5449077018110318)
C19 = np.array(2.0)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


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


def force_of(a, q, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v10 = n / 2.0 + 0.5
            v12 = v10 + 1.75
            v16 = (v10 + 0.5) * (v10 + 1.5)
            v30 = 1.0 / (v12 * v12)
            v82 = hypot(a, q)
            value = 3.5449077018110318 * E_star * n * A / (n + 1.0) * a * pow(a, n) * ((v10 * (v10 + 1.0) / v16 if v10 < 1.0 else 1.0 - (v10 + 0.75) / v16) * sqrt(v12) * (1.0 + v30 * (((((((0.01524698625788054 * v30 + 0.5334320651111477) * v30 + 2.250488865813539) * v30 + 2.8612106440066865) * v30 + 1.3794681629043655) * v30 + 0.2596058532893223) * v30 + 0.015624999999999823) / ((((((3.278794792785737 * v30 + 49.328555418276075) * v30 + 167.28648538571198) * v30 + 195.37226190335065) * v30 + 90.69722535867314) * v30 + 16.763212110504565) * v30 + 1.0)))) - 2.0 * sigma_0 * (v82 * v82 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, A, n, E_star, dgamma, sigma_0, t0, t1, t2, t3, m0):
    size = out.size
    np.multiply(n, C0, out)
    np.add(out, C0, out)
    np.add(out, C1, t0)
    np.add(out, C0, t1)
    np.add(out, C2, t2)
    np.multiply(t1, t2, t2)
    np.less(out, C3, m0)
    some25 = np.count_nonzero(m0)
    if some25:
        np.add(out, C3, t1)
        np.multiply(out, t1, t1)
        np.divide(t1, t2, t1)
    if some25 != size:
        other25 = t3 if some25 else t1
        np.add(out, C4, other25)
        np.divide(other25, t2, other25)
        np.subtract(C3, other25, other25)
        if some25:
            np.copyto(t1, other25, where=~m0)
    np.sqrt(t0, t2)
    np.multiply(t1, t2, t2)
    np.multiply(t0, t0, t0)
    np.divide(C3, t0, t0)
    np.multiply(C5, t0, t1)
    np.add(t1, C6, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C7, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C8, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C9, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C10, t1)
    np.multiply(t1, t0, t1)
    np.add(t1, C11, t1)
    np.multiply(C12, t0, out)
    np.add(out, C13, out)
    np.multiply(out, t0, out)
    np.add(out, C14, out)
    np.multiply(out, t0, out)
    np.add(out, C15, out)
    np.multiply(out, t0, out)
    np.add(out, C16, out)
    np.multiply(out, t0, out)
    np.add(out, C17, out)
    np.multiply(out, t0, out)
    np.add(out, C3, out)
    np.divide(t1, out, out)
    np.multiply(t0, out, out)
    np.add(C3, out, out)
    np.multiply(t2, out, out)
    np.multiply(C18, E_star, t2)
    np.multiply(t2, n, t2)
    np.multiply(t2, A, t2)
    np.add(n, C3, t0)
    np.divide(t2, t0, t0)
    np.multiply(t0, a, t0)
    np.power(a, n, t2)
    np.multiply(t0, t2, t2)
    np.multiply(t2, out, out)
    np.hypot(a, q, t2)
    np.multiply(C19, sigma_0, t0)
    np.multiply(t2, t2, t2)
    np.arctan2(q, a, t1)
    np.multiply(t2, t1, t1)
    np.multiply(a, q, t2)
    np.add(t1, t2, t2)
    np.multiply(t0, t2, t2)
    np.subtract(out, t2, out)


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


def pull_off_depth(a, q, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, A, n, E_star, dgamma, sigma_0):
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


def pull_off_zone(a, A, n, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is n.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, A, n, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, n, E_star, dgamma, sigma_0):
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
            if c == 0.0:
                v108 = 0.0
            else:
                v8 = hypot(0.0, c)
                v15 = 40.0 / (n if n < 1.2 or n != n else 1.2)
                v17 = asinh(inf if inf < v15 or inf != inf else v15)
                v29 = n / 2.0 + 0.5
                v31 = v29 + 1.75
                v35 = (v29 + 0.5) * (v29 + 1.5)
                v48 = 1.0 / (v31 * v31)
                v90 = 1.7724538509055159 * n * A * ((v29 * (v29 + 1.0) / v35 if v29 < 1.0 else 1.0 - (v29 + 0.75) / v35) * sqrt(v31) * (1.0 + v48 * (((((((0.01524698625788054 * v48 + 0.5334320651111477) * v48 + 2.250488865813539) * v48 + 2.8612106440066865) * v48 + 1.3794681629043655) * v48 + 0.2596058532893223) * v48 + 0.015624999999999823) / ((((((3.278794792785737 * v48 + 49.328555418276075) * v48 + 167.28648538571198) * v48 + 195.37226190335065) * v48 + 90.69722535867314) * v48 + 16.763212110504565) * v48 + 1.0))))
                v102 = []
                for node, weight in RULE_0(v17 / 1.0):
                    v18 = node * v17
                    v19 = sinh(v18)
                    v20 = sinh(v19)
                    v21 = cosh(v19)
                    v22 = v8 / v21
                    v100 = v90 * pow(v22, n) / v22 / v21 * cosh(v18) * atan(v20) * (v20 / v21)
                    v102.append(weight * v100)
                v102 = fsum(v102) * v17
                v108 = 0.6366197723675814 * v8 * v102
            v111 = sigma_0 / E_star
            v115 = v108 - dgamma / sigma_0 - 1.2732395447351628 * v111 * c
            if v115 <= -(2.0 * v111 * c):
                value = v115
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
            if c == 0.0:
                v108 = 0.0
            else:
                v8 = hypot(0.0, c)
                v15 = 40.0 / (n if n < 1.2 or n != n else 1.2)
                v17 = asinh(inf if inf < v15 or inf != inf else v15)
                v29 = n / 2.0 + 0.5
                v31 = v29 + 1.75
                v35 = (v29 + 0.5) * (v29 + 1.5)
                v48 = 1.0 / (v31 * v31)
                v90 = 1.7724538509055159 * n * A * ((v29 * (v29 + 1.0) / v35 if v29 < 1.0 else 1.0 - (v29 + 0.75) / v35) * sqrt(v31) * (1.0 + v48 * (((((((0.01524698625788054 * v48 + 0.5334320651111477) * v48 + 2.250488865813539) * v48 + 2.8612106440066865) * v48 + 1.3794681629043655) * v48 + 0.2596058532893223) * v48 + 0.015624999999999823) / ((((((3.278794792785737 * v48 + 49.328555418276075) * v48 + 167.28648538571198) * v48 + 195.37226190335065) * v48 + 90.69722535867314) * v48 + 16.763212110504565) * v48 + 1.0))))
                v102 = []
                for node, weight in RULE_0(v17 / 1.0):
                    v18 = node * v17
                    v19 = sinh(v18)
                    v20 = sinh(v19)
                    v21 = cosh(v19)
                    v22 = v8 / v21
                    v100 = v90 * pow(v22, n) / v22 / v21 * cosh(v18) * atan(v20) * (v20 / v21)
                    v102.append(weight * v100)
                v102 = fsum(v102) * v17
                v108 = 0.6366197723675814 * v8 * v102
            v111 = sigma_0 / E_star
            if v108 - dgamma / sigma_0 - 1.2732395447351628 * v111 * c <= -(2.0 * v111 * c):
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
            v13 = a > 0.0
            v19 = asinh(v11 / (a if v13 else 1.0) if v13 else inf)
            v23 = 40.0 / (n if n < 1.2 or n != n else 1.2)
            v25 = asinh(v19 if v19 < v23 or v19 != v19 else v23)
            v37 = n / 2.0 + 0.5
            v39 = v37 + 1.75
            v43 = (v37 + 0.5) * (v37 + 1.5)
            v56 = 1.0 / (v39 * v39)
            v98 = 1.7724538509055159 * n * A * ((v37 * (v37 + 1.0) / v43 if v37 < 1.0 else 1.0 - (v37 + 0.75) / v43) * sqrt(v39) * (1.0 + v56 * (((((((0.01524698625788054 * v56 + 0.5334320651111477) * v56 + 2.250488865813539) * v56 + 2.8612106440066865) * v56 + 1.3794681629043655) * v56 + 0.2596058532893223) * v56 + 0.015624999999999823) / ((((((3.278794792785737 * v56 + 49.328555418276075) * v56 + 167.28648538571198) * v56 + 195.37226190335065) * v56 + 90.69722535867314) * v56 + 16.763212110504565) * v56 + 1.0))))
            v110 = []
            for node, weight in RULE_0(v25 / 1.0):
                v26 = node * v25
                v27 = sinh(v26)
                v28 = sinh(v27)
                v29 = cosh(v27)
                v30 = v12 / v29
                v108 = v98 * pow(v30, n) / v30 / v29 * cosh(v26) * atan(v28) * (v28 / v29)
                v110.append(weight * v108)
            v110 = fsum(v110) * v25
            value = sigma_0 * (0.6366197723675814 * v12 * v110 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (atan2(v11, a) - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, A, n, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'A', 'n', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'A', 'n', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'A', 'n', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 4, 1, (), False),
    },
}
