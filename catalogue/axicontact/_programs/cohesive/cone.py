"""Programs of axicontact.cohesive.cone."""

from __future__ import annotations

from math import atan2, fsum, hypot, inf, nan, sin, sqrt, tan

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import cone as bodies

C0 = np.array(3.141592653589793)
C1 = np.array(2.0)
C2 = np.array(0.5)
RULE_0 = rule(((0.45, 8), (inf, 16)))


def cohesive_radius(a, theta, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, theta, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, theta, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, theta, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, theta, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v14 = hypot(a, q)
            value = 3.141592653589793 * E_star * tan(theta) * (a * a) / 2.0 - 2.0 * sigma_0 * (v14 * v14 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, theta, E_star, dgamma, sigma_0, t0, t1, t2):
    np.multiply(C0, E_star, out)
    np.tan(theta, t0)
    np.multiply(out, t0, t0)
    np.square(a, out)
    np.multiply(t0, out, out)
    np.multiply(out, C2, out)
    np.hypot(a, q, t0)
    np.multiply(C1, sigma_0, t1)
    np.multiply(t0, t0, t0)
    np.arctan2(q, a, t2)
    np.multiply(t0, t2, t2)
    np.multiply(a, q, t0)
    np.add(t2, t0, t0)
    np.multiply(t1, t0, t0)
    np.subtract(out, t0, out)


def pressure(r, a, theta, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, theta, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(theta, E_star, dgamma, sigma_0, control):
    if theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and theta > 1e-30 and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(theta, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, theta, E_star, dgamma, sigma_0):
    if a.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, theta, E_star, dgamma, sigma_0):
    if d.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, theta, E_star, dgamma, sigma_0):
    if F.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, theta, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, theta, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, theta, E_star, dgamma, sigma_0):
    if c.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v29 = 0.0
            else:
                v8 = atan2(c, 0.0)
                v18 = 3.141592653589793 * tan(theta) / 2.0
                v23 = []
                for node, weight in RULE_0(v8 / 1.0):
                    v10 = node * v8
                    v11 = 0.0 + v10
                    v21 = v18 * v11 * sin(v11)
                    v23.append(weight * v21)
                v23 = fsum(v23) * v8
                v29 = 0.6366197723675814 * hypot(0.0, c) * v23
            v32 = sigma_0 / E_star
            v36 = v29 - dgamma / sigma_0 - 1.2732395447351628 * v32 * c
            if v36 <= -(2.0 * v32 * c):
                value = v36
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, theta, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, theta, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, theta, E_star, dgamma, sigma_0):
    if c.__class__ is theta.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v29 = 0.0
            else:
                v8 = atan2(c, 0.0)
                v18 = 3.141592653589793 * tan(theta) / 2.0
                v23 = []
                for node, weight in RULE_0(v8 / 1.0):
                    v10 = node * v8
                    v11 = 0.0 + v10
                    v21 = v18 * v11 * sin(v11)
                    v23.append(weight * v21)
                v23 = fsum(v23) * v8
                v29 = 0.6366197723675814 * hypot(0.0, c) * v23
            v32 = sigma_0 / E_star
            if v29 - dgamma / sigma_0 - 1.2732395447351628 * v32 * c <= -(2.0 * v32 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, theta, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, theta, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, theta, E_star, sigma_0):
    if a.__class__ is c.__class__ is theta.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (theta > 1e-30) and (theta < 1.5707963267948966) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v5 = c - a
            v10 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (c + a))
            v11 = hypot(a, v10)
            v12 = atan2(v10, a)
            v22 = 3.141592653589793 * tan(theta) / 2.0
            v27 = []
            for node, weight in RULE_0(v12 / 1.0):
                v14 = node * v12
                v15 = 0.0 + v14
                v25 = v22 * v15 * sin(v15)
                v27.append(weight * v25)
            v27 = fsum(v27) * v12
            value = sigma_0 * (0.6366197723675814 * v11 * v27 + 1.2732395447351628 * (sigma_0 / E_star) * v10 * (v12 - v10 / (v11 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, theta, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'theta', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'theta', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'theta', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 3, 0, (), False),
    },
}
