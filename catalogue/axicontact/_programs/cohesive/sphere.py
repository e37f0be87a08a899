"""Programs of axicontact.cohesive.sphere."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, log1p, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import sphere as bodies

C0 = np.array(2.0)
C1 = np.array(0.5)
C2 = np.array(1.0)
C3 = np.array(1.0716932453474512e-06)
C4 = np.array(0.00019982814521087247)
C5 = np.array(0.007076196047699156)
C6 = np.array(0.08608622548411103)
C7 = np.array(0.3073858328214721)
C8 = np.array(0.3333333333333333)
C9 = np.array(2.565078604208634e-08)
C10 = np.array(2.0203143566039827e-05)
C11 = np.array(0.001617010334189783)
C12 = np.array(0.03639274880225476)
C13 = np.array(0.32215749846441627)
RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


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


def force_of(a, q, R, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v11 = log1p(2.0 * a / (R - a)) / 2.0
            v15 = a / R
            if v11 < 1.0:
                v21 = v11 * v11
                v56 = v15 * (v15 * v15) * ((((((1.0716932453474512e-06 * v21 + 0.00019982814521087247) * v21 + 0.007076196047699156) * v21 + 0.08608622548411103) * v21 + 0.3073858328214721) * v21 + 0.3333333333333333) / (((((2.565078604208634e-08 * v21 + 2.0203143566039827e-05) * v21 + 0.001617010334189783) * v21 + 0.03639274880225476) * v21 + 0.32215749846441627) * v21 + 1.0))
            else:
                v56 = v11 - v15
            v60 = hypot(a, q)
            value = E_star * (a * a * v11 + R * R * v56) - 2.0 * sigma_0 * (v60 * v60 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, R, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    np.subtract(R, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.square(a, out)
    np.multiply(out, t0, out)
    np.square(R, t1)
    np.divide(a, R, t2)
    np.less(t0, C2, m0)
    some56 = np.count_nonzero(m0)
    if some56:
        np.minimum(t0, f0, out=t3)
        np.multiply(t2, t2, t4)
        np.multiply(t2, t4, t4)
        np.multiply(t3, t3, t3)
        np.multiply(C3, t3, t5)
        np.add(t5, C4, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C5, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C6, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C7, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C8, t5)
        np.multiply(C9, t3, t6)
        np.add(t6, C10, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C11, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C12, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C13, t6)
        np.multiply(t6, t3, t3)
        np.add(t3, C2, t3)
        np.divide(t5, t3, t3)
        np.multiply(t4, t3, t3)
    if some56 != size:
        other56 = t4 if some56 else t3
        np.subtract(t0, t2, other56)
        if some56:
            np.copyto(t3, other56, where=~m0)
    np.multiply(t1, t3, t3)
    np.add(out, t3, t3)
    np.multiply(E_star, t3, t3)
    np.hypot(a, q, out)
    np.multiply(C0, sigma_0, t1)
    np.multiply(out, out, out)
    np.arctan2(q, a, t2)
    np.multiply(out, t2, t2)
    np.multiply(a, q, out)
    np.add(t2, out, out)
    np.multiply(t1, out, out)
    np.subtract(t3, out, out)


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


def pull_off_depth(a, q, R, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, R, E_star, dgamma, sigma_0):
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


def pull_off_zone(a, R, E_star, dgamma, sigma_0):
    if a.__class__ is R.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, R, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, R, E_star, dgamma, sigma_0):
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
            if c == 0.0:
                v56 = 0.0
            else:
                v7 = hypot(0.0, c)
                v9 = R - 0.0
                v13 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (R + 0.0))
                v14 = v13 - c
                v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (v13 + c))
                v20 = asinh(v18 / v7)
                v21 = v20 > 0.0
                v23 = v20 if v21 else 1.0
                v25 = asinh(atan2(c, 0.0) / v23)
                v48 = []
                for node, weight in RULE_0(v25 / 0.7):
                    v27 = node * v25
                    v29 = v23 * sinh(v27)
                    v30 = sin(v29)
                    v32 = v7 * cos(v29)
                    v34 = hypot(v18, v7 * v30)
                    v46 = (asinh(v32 / v34) + R * v32 / (v34 * v34)) * v23 * cosh(v27) * v29 * v30
                    v48.append(weight * v46)
                v48 = fsum(v48) * v25
                v56 = (0.6366197723675814 if v21 else inf) * v7 * v48
            v59 = sigma_0 / E_star
            v63 = v56 - dgamma / sigma_0 - 1.2732395447351628 * v59 * c
            if v63 <= -(2.0 * v59 * c):
                value = v63
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
            if c == 0.0:
                v56 = 0.0
            else:
                v7 = hypot(0.0, c)
                v9 = R - 0.0
                v13 = sqrt((v9 if v9 > 0.0 or v9 != v9 else 0.0) * (R + 0.0))
                v14 = v13 - c
                v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (v13 + c))
                v20 = asinh(v18 / v7)
                v21 = v20 > 0.0
                v23 = v20 if v21 else 1.0
                v25 = asinh(atan2(c, 0.0) / v23)
                v48 = []
                for node, weight in RULE_0(v25 / 0.7):
                    v27 = node * v25
                    v29 = v23 * sinh(v27)
                    v30 = sin(v29)
                    v32 = v7 * cos(v29)
                    v34 = hypot(v18, v7 * v30)
                    v46 = (asinh(v32 / v34) + R * v32 / (v34 * v34)) * v23 * cosh(v27) * v29 * v30
                    v48.append(weight * v46)
                v48 = fsum(v48) * v25
                v56 = (0.6366197723675814 if v21 else inf) * v7 * v48
            v59 = sigma_0 / E_star
            if v56 - dgamma / sigma_0 - 1.2732395447351628 * v59 * c <= -(2.0 * v59 * c):
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
            value = sigma_0 * ((0.6366197723675814 if v25 else inf) * v11 * v52 + 1.2732395447351628 * (sigma_0 / E_star) * v10 * (v12 - v10 / (v11 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'R', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'R', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'R', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 7, 1, (1.0,), False),
    },
}
