"""Programs of axicontact.cohesive.ellipsoid."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, log1p, nan, sin, sinh, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._runtime.plain import rule
from ..._programs.bodies.cohesive import ellipsoid as bodies

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


def cohesive_radius(a, h, b, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._cohesive_radius(a, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def depth(a, h, b, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._depth(a, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, h, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._displacement(r, a, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, h, b, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._force(a, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force_of(a, q, h, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (q > 1e-30) and (q < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v12 = log1p(2.0 * a / (b - a)) / 2.0
            v17 = a / b
            if v12 < 1.0:
                v23 = v12 * v12
                v58 = v17 * (v17 * v17) * ((((((1.0716932453474512e-06 * v23 + 0.00019982814521087247) * v23 + 0.007076196047699156) * v23 + 0.08608622548411103) * v23 + 0.3073858328214721) * v23 + 0.3333333333333333) / (((((2.565078604208634e-08 * v23 + 2.0203143566039827e-05) * v23 + 0.001617010334189783) * v23 + 0.03639274880225476) * v23 + 0.32215749846441627) * v23 + 1.0))
            else:
                v58 = v12 - v17
            v62 = hypot(a, q)
            value = E_star * h * (a * a * v12 / b + b * v58) - 2.0 * sigma_0 * (v62 * v62 * atan2(q, a) + a * q)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_force_of_all_signed():
    return ()


def block_force_of_all_signed(out, a, q, h, b, E_star, dgamma, sigma_0, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.multiply(C0, a, out)
    np.subtract(b, a, t0)
    np.divide(out, t0, t0)
    np.log1p(t0, t0)
    np.multiply(t0, C1, t0)
    np.multiply(E_star, h, out)
    np.square(a, t1)
    np.multiply(t1, t0, t1)
    np.divide(t1, b, t1)
    np.divide(a, b, t2)
    np.less(t0, C2, m0)
    some58 = np.count_nonzero(m0)
    if some58:
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
    if some58 != size:
        other58 = t4 if some58 else t3
        np.subtract(t0, t2, other58)
        if some58:
            np.copyto(t3, other58, where=~m0)
    np.multiply(b, t3, t3)
    np.add(t1, t3, t3)
    np.multiply(out, t3, t3)
    np.hypot(a, q, out)
    np.multiply(C0, sigma_0, t1)
    np.multiply(out, out, out)
    np.arctan2(q, a, t2)
    np.multiply(out, t2, t2)
    np.multiply(a, q, out)
    np.add(t2, out, out)
    np.multiply(t1, out, out)
    np.subtract(t3, out, out)


def pressure(r, a, h, b, E_star, dgamma, sigma_0):
    if r.__class__ is a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pressure(r, a, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, q, h, b, E_star, dgamma, sigma_0):
    if a.__class__ is q.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (q > -1e+30) and (q < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_depth(a, q, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, q, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(h, b, E_star, dgamma, sigma_0, control):
    if h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and h > 1e-30 and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_radius(h, b, E_star, dgamma, sigma_0, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_zone(a, h, b, E_star, dgamma, sigma_0):
    if a.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and a > -1e+30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._pull_off_zone(a, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, h, b, E_star, dgamma, sigma_0):
    if d.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and d > -1e+30 and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_depth(d, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, h, b, E_star, dgamma, sigma_0):
    if F.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and F > -1e+30 and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            value = bodies._radius_from_force(F, h, b, E_star, dgamma, sigma_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, h, b, E_star, dgamma, sigma_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_depth(c, h, b, E_star, dgamma, sigma_0):
    if c.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v59 = 0.0
            else:
                v8 = hypot(0.0, c)
                v10 = b - 0.0
                v14 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (b + 0.0))
                v15 = v14 - c
                v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (v14 + c))
                v21 = asinh(v19 / v8)
                v22 = v21 > 0.0
                v24 = v21 if v22 else 1.0
                v26 = asinh(atan2(c, 0.0) / v24)
                v38 = h / b
                v51 = []
                for node, weight in RULE_0(v26 / 0.7):
                    v28 = node * v26
                    v30 = v24 * sinh(v28)
                    v31 = sin(v30)
                    v33 = v8 * cos(v30)
                    v35 = hypot(v19, v8 * v31)
                    v49 = (v38 * asinh(v33 / v35) + h * v33 / (v35 * v35)) * v24 * cosh(v28) * v30 * v31
                    v51.append(weight * v49)
                v51 = fsum(v51) * v26
                v59 = (0.6366197723675814 if v22 else inf) * v8 * v51
            v62 = sigma_0 / E_star
            v66 = v59 - dgamma / sigma_0 - 1.2732395447351628 * v62 * c
            if v66 <= -(2.0 * v62 * c):
                value = v66
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, h, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, h, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def without_contact_force(c, h, b, E_star, dgamma, sigma_0):
    if c.__class__ is h.__class__ is b.__class__ is E_star.__class__ is dgamma.__class__ is sigma_0.__class__ is float and c > 1e-30 and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            if c == 0.0:
                v59 = 0.0
            else:
                v8 = hypot(0.0, c)
                v10 = b - 0.0
                v14 = sqrt((v10 if v10 > 0.0 or v10 != v10 else 0.0) * (b + 0.0))
                v15 = v14 - c
                v19 = sqrt((v15 if v15 > 0.0 or v15 != v15 else 0.0) * (v14 + c))
                v21 = asinh(v19 / v8)
                v22 = v21 > 0.0
                v24 = v21 if v22 else 1.0
                v26 = asinh(atan2(c, 0.0) / v24)
                v38 = h / b
                v51 = []
                for node, weight in RULE_0(v26 / 0.7):
                    v28 = node * v26
                    v30 = v24 * sinh(v28)
                    v31 = sin(v30)
                    v33 = v8 * cos(v30)
                    v35 = hypot(v19, v8 * v31)
                    v49 = (v38 * asinh(v33 / v35) + h * v33 / (v35 * v35)) * v24 * cosh(v28) * v30 * v31
                    v51.append(weight * v49)
                v51 = fsum(v51) * v26
                v59 = (0.6366197723675814 if v22 else inf) * v8 * v51
            v62 = sigma_0 / E_star
            if v59 - dgamma / sigma_0 - 1.2732395447351628 * v62 * c <= -(2.0 * v62 * c):
                value = -3.141592653589793 * sigma_0 * c * c
                if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                    return value
                if value != value and ordinary(c, h, b, E_star, dgamma, sigma_0):
                    return value
                return None
            value = nan
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(c, h, b, E_star, dgamma, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_separation(a, c, h, b, E_star, sigma_0):
    if a.__class__ is c.__class__ is h.__class__ is b.__class__ is E_star.__class__ is sigma_0.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (h > 1e-30) and (h < 1e+30) and (b > 1e-30) and (b < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (sigma_0 > 1e-30) and (sigma_0 < 1e+30):
        try:
            v6 = c - a
            v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (c + a))
            v12 = hypot(a, v11)
            v13 = atan2(v11, a)
            v14 = b - a
            v18 = sqrt((v14 if v14 > 0.0 or v14 != v14 else 0.0) * (b + a))
            v19 = v18 - v11
            v23 = sqrt((v19 if v19 > 0.0 or v19 != v19 else 0.0) * (v18 + v11))
            v25 = asinh(v23 / v12)
            v26 = v25 > 0.0
            v28 = v25 if v26 else 1.0
            v30 = asinh(v13 / v28)
            v42 = h / b
            v55 = []
            for node, weight in RULE_0(v30 / 0.7):
                v32 = node * v30
                v34 = v28 * sinh(v32)
                v35 = sin(v34)
                v37 = v12 * cos(v34)
                v39 = hypot(v23, v12 * v35)
                v53 = (v42 * asinh(v37 / v39) + h * v37 / (v39 * v39)) * v28 * cosh(v32) * v34 * v35
                v55.append(weight * v53)
            v55 = fsum(v55) * v30
            value = sigma_0 * ((0.6366197723675814 if v26 else inf) * v12 * v55 + 1.2732395447351628 * (sigma_0 / E_star) * v11 * (v13 - v11 / (v12 + a)))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, h, b, E_star, sigma_0):
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_force_of', 0, 'a', 'q', 'h', 'b', 'E_star', 'dgamma', 'sigma_0'): {
        ('a', 'q', 'h', 'b', 'E_star', 'dgamma', 'sigma_0'): (('a', 'q', 'h', 'b', 'E_star', 'dgamma', 'sigma_0'), prepare_force_of_all_signed, block_force_of_all_signed, 7, 1, (1.0,), False),
    },
}
