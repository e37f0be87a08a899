"""Programs of axicontact.graded.normal.capped_cylinder."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.normal import capped_cylinder as bodies


def depth_from_force(F, a, R, H, k):
    if F.__class__ is a.__class__ is R.__class__ is H.__class__ is k.__class__ is float and F > 1e-30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._depth_from_force(F, a, R, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F, a, R, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, d, a, R, k):
    if r.__class__ is d.__class__ is a.__class__ is R.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._displacement(r, d, a, R, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, R, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(d, a, R, H, k):
    if d.__class__ is a.__class__ is R.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._force(d, a, R, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, a, R, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, d, a, R, H, k):
    if r.__class__ is d.__class__ is a.__class__ is R.__class__ is H.__class__ is k.__class__ is float and r > 1e-30 and (r < 1e+30) and (d > 1e-30) and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._pressure(r, d, a, R, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, d, a, R, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stiffness(d, a, R, H, k):
    if d.__class__ is a.__class__ is R.__class__ is H.__class__ is k.__class__ is float and d > 1e-30 and (d < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._stiffness(d, a, R, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(d, a, R, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
