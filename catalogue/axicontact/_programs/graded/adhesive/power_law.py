"""Programs of axicontact.graded.adhesive.power_law."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.adhesive import power_law as bodies


def depth(a, A, n, H, k, dgamma):
    if a.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._depth(a, A, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, A, n, H, k, dgamma):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._displacement(r, a, A, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, A, n, H, k, dgamma):
    if a.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._force(a, A, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, A, n, H, k, dgamma):
    if r.__class__ is a.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pressure(r, a, A, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_depth(a, A, n, H, k, dgamma, control):
    if a.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_depth(a, A, n, H, k, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, A, n, H, k, dgamma, control):
    if a.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_force(a, A, n, H, k, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(A, n, H, k, dgamma, control):
    if A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and A > 1e-30 and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_radius(A, n, H, k, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, A, n, H, k, dgamma):
    if d.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_depth(d, A, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, A, n, H, k, dgamma):
    if F.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._radius_from_force(F, A, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, A, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, A, n, H, k):
    if F.__class__ is A.__class__ is n.__class__ is H.__class__ is k.__class__ is float and F > -1e+30 and (F < 1e+30) and (A > 1e-30) and (A < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, A, n, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, A, n, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
