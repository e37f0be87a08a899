"""Programs of axicontact.cohesive.sextic."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, nan, pow, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import sextic as bodies

C0 = np.array(192.0)
C1 = np.array(35.0)
C2 = np.array(7.0)
C3 = np.array(2.0)
RULE_0 = rule(((0.45, 8), (inf, 16)))


def cohesive_radius(a, A, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, A, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, A, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, A, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, A, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v14 = hypot(a, q)
            value = 192.0 * E_star * A / 35.0 * pow(a, 7.0) - 2.0 * sigma_0 * (v14 * v14 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, A, E_star, dgamma, sigma_0, t0, t1, t2):
    np.multiply(C0, E_star, out)
    np.multiply(out, A, out)
    np.divide(out, C1, out)
    np.power(a, C2, t0)
    np.multiply(out, t0, t0)
    np.hypot(a, q, out)
    np.multiply(C3, sigma_0, t1)
    np.multiply(out, out, out)
    np.arctan2(q, a, t2)
    np.multiply(out, t2, t2)
    np.multiply(a, q, out)
    np.add(t2, out, out)
    np.multiply(t1, out, out)
    np.subtract(t0, out, out)


def pressure(r, a, A, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, A, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(A, E_star, dgamma, sigma_0, control):
    if A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and A > 1e-30 and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(A, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, A, E_star, dgamma, sigma_0):
    if a.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, A, E_star, dgamma, sigma_0):
    if d.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, A, E_star, dgamma, sigma_0):
    if F.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, A, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, A, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, A, E_star, dgamma, sigma_0):
    if c.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v30 = 0.0
            else:
                v7 = hypot(0.0, c)
                v8 = atan2(c, 0.0)
                v17 = 96.0 * A / 5.0
                v24 = []
                for node, weight in RULE_0(v8 / 1.0):
                    v10 = node * v8
                    v11 = 0.0 + v10
                    v22 = v17 * pow(v7 * cos(v11), 5.0) * v11 * sin(v11)
                    v24.append(weight * v22)
                v24 = fsum(v24) * v8
                v30 = 0.6366197723675814 * v7 * v24
            v33 = sigma_0 / E_star
            v37 = v30 - dgamma / sigma_0 - 1.2732395447351628 * v33 * c
            if v37 <= -(2.0 * v33 * c):
                value = v37
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, A, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, A, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, A, E_star, dgamma, sigma_0):
    if c.__class__ is A.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v30 = 0.0
            else:
                v7 = hypot(0.0, c)
                v8 = atan2(c, 0.0)
                v17 = 96.0 * A / 5.0
                v24 = []
                for node, weight in RULE_0(v8 / 1.0):
                    v10 = node * v8
                    v11 = 0.0 + v10
                    v22 = v17 * pow(v7 * cos(v11), 5.0) * v11 * sin(v11)
                    v24.append(weight * v22)
                v24 = fsum(v24) * v8
                v30 = 0.6366197723675814 * v7 * v24
            v33 = sigma_0 / E_star
            if v30 - dgamma / sigma_0 - 1.2732395447351628 * v33 * c <= -(2.0 * v33 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, A, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, A, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, A, E_star, sigma_0):
    if a.__class__ is c.__class__ is A.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (A > 1e-30) and (A < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v5 = c - a
            v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (c + a))
            v11 = hypot(a, v10)
            v12 = atan2(v10, a)
            v21 = 96.0 * A / 5.0
            v28 = []
            for node, weight in RULE_0(v12 / 1.0):
                v14 = node * v12
                v15 = 0.0 + v14
                v26 = v21 * pow(v11 * cos(v15), 5.0) * v15 * sin(v15)
                v28.append(weight * v26)
            v28 = fsum(v28) * v12
            value = sigma_0 * (0.6366197723675814 * v11 * v28 + 1.2732395447351628 * (sigma_0 / E_star) * v10 * (v12 - v10 / (v11 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, A, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'A', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'A', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'A', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 3, 0, (), False),
    },
}
