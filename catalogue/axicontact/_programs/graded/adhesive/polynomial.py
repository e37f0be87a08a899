"""Programs of axicontact.graded.adhesive.polynomial."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.adhesive import polynomial as bodies


def depth(a, H, k, dgamma, A):
    if a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._depth(a, A, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, H, k, dgamma, A):
    if r.__class__ is a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._displacement(r, a, A, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, H, k, dgamma, A):
    if a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._force(a, A, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, H, k, dgamma, A):
    if r.__class__ is a.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._pressure(r, a, A, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(H, k, dgamma, A, control):
    if H.__class__ is k.__class__ is dgamma.__class__ is float and H > 1e-30 and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._pull_off_radius(A, H, k, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, H, k, dgamma, A):
    if d.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_depth(d, A, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, H, k, dgamma, A):
    if F.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_force(F, A, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, H, k, A):
    if F.__class__ is H.__class__ is k.__class__ is float and F > -1e+30 and (F < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, A, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
