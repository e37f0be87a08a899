"""Programs of axicontact.graded.adhesive.capped_paraboloid."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.adhesive import capped_paraboloid as bodies


def depth(a, R1, R2, b, H, k, dgamma):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._depth(a, R1, R2, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, R1, R2, b, H, k, dgamma):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._displacement(r, a, R1, R2, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, R1, R2, b, H, k, dgamma):
    if a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._force(a, R1, R2, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, R1, R2, b, H, k, dgamma):
    if r.__class__ is a.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R1 > 1e-30) and (R1 < 1e+30) and (R2 > 1e-30) and (R2 < 1e+30) and (b > 1e-30) and (b < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pressure(r, a, R1, R2, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(R1, R2, b, H, k, dgamma, control):
    if R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and R1 > -1e+30 and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (H > -1e+30) and (H < 1e+30) and (k > -1e+30) and (k < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(R1, R2, b, H, k, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, R1, R2, b, H, k, dgamma):
    if d.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (H > -1e+30) and (H < 1e+30) and (k > -1e+30) and (k < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, R1, R2, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, R1, R2, b, H, k, dgamma):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (H > -1e+30) and (H < 1e+30) and (k > -1e+30) and (k < 1e+30) and (dgamma > -1e+30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, R1, R2, b, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R1, R2, b, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, R1, R2, b, H, k):
    if F.__class__ is R1.__class__ is R2.__class__ is b.__class__ is H.__class__ is k.__class__ is float and F > -1e+30 and (F < 1e+30) and (R1 > -1e+30) and (R1 < 1e+30) and (R2 > -1e+30) and (R2 < 1e+30) and (b > -1e+30) and (b < 1e+30) and (H > -1e+30) and (H < 1e+30) and (k > -1e+30) and (k < 1e+30):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, R1, R2, b, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, R1, R2, b, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
