"""Programs of axicontact.cohesive.sphere."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, nan, sin, sinh, sqrt

from ..._runtime.interface import ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import sphere as bodies

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def cohesive_radius(a, R, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, R, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, R, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, R, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, R, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_force(a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R, E_star, dgamma, sigma_0, control):
    if R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and R > 1e-30 and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(R, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R, E_star, dgamma, sigma_0):
    if d.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R, E_star, dgamma, sigma_0):
    if F.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, R, E_star, dgamma, sigma_0):
    if c.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = hypot(0.0, c)
            v8 = R - 0.0
            v12 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (R + 0.0))
            v13 = v12 - c
            v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (v12 + c))
            v19 = asinh(v17 / v6)
            v20 = v19 > 0.0
            if v20:
                v22 = v19 if v20 else 1.0
                v24 = asinh(atan2(c, 0.0) / v22)
                v47 = []
                for node, weight in RULE_0(v24 / 0.7):
                    v26 = node * v24
                    v28 = v22 * sinh(v26)
                    v29 = sin(v28)
                    v31 = v6 * cos(v28)
                    v33 = hypot(v17, v6 * v29)
                    v45 = (asinh(v31 / v33) + R * v31 / (v33 * v33)) * v22 * cosh(v26) * v28 * v29
                    v47.append(weight * v45)
                v47 = fsum(v47) * v24
                v73 = 0.6366197723675814 * v6 * v47
            else:
                v73 = inf
            v78 = sigma_0 / E_star
            v82 = v73 - dgamma / sigma_0 - 1.2732395447351628 * v78 * c
            if v82 <= -(2.0 * v78 * c):
                value = v82
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, R, E_star, dgamma, sigma_0):
    if c.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = hypot(0.0, c)
            v8 = R - 0.0
            v12 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (R + 0.0))
            v13 = v12 - c
            v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (v12 + c))
            v19 = asinh(v17 / v6)
            v20 = v19 > 0.0
            if v20:
                v22 = v19 if v20 else 1.0
                v24 = asinh(atan2(c, 0.0) / v22)
                v47 = []
                for node, weight in RULE_0(v24 / 0.7):
                    v26 = node * v24
                    v28 = v22 * sinh(v26)
                    v29 = sin(v28)
                    v31 = v6 * cos(v28)
                    v33 = hypot(v17, v6 * v29)
                    v45 = (asinh(v31 / v33) + R * v31 / (v33 * v33)) * v22 * cosh(v26) * v28 * v29
                    v47.append(weight * v45)
                v47 = fsum(v47) * v24
                v73 = 0.6366197723675814 * v6 * v47
            else:
                v73 = inf
            v78 = sigma_0 / E_star
            if v73 - dgamma / sigma_0 - 1.2732395447351628 * v78 * c <= -(2.0 * v78 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, R, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, R, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, R, E_star, sigma_0):
    if a.__class__ is c.__class__ is R.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v5 = c - a
            v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (c + a))
            v11 = hypot(a, v10)
            v12 = atan2(v10, a)
            v13 = R - a
            v17 = sqrt((v13 if v13 > 0.0 or v13 != v13 else 0.0) * (R + a))
            v18 = v17 - v10
            v22 = sqrt((v18 if v18 > 0.0 or v18 != v18 else 0.0) * (v17 + v10))
            v24 = asinh(v22 / v11)
            v25 = v24 > 0.0
            if v25:
                v27 = v24 if v25 else 1.0
                v29 = asinh(v12 / v27)
                v52 = []
                for node, weight in RULE_0(v29 / 0.7):
                    v31 = node * v29
                    v33 = v27 * sinh(v31)
                    v34 = sin(v33)
                    v36 = v11 * cos(v33)
                    v38 = hypot(v22, v11 * v34)
                    v50 = (asinh(v36 / v38) + R * v36 / (v38 * v38)) * v27 * cosh(v31) * v33 * v34
                    v52.append(weight * v50)
                v52 = fsum(v52) * v29
                v78 = 0.6366197723675814 * v11 * v52
            else:
                v78 = inf
            value = sigma_0 * (v78 + 1.2732395447351628 * (sigma_0 / E_star) * v10 * (v12 - v10 / (v11 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None
