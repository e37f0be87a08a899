"""Programs of axicontact.graded.adhesive.concave_power."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.adhesive import concave_power as bodies


def pull_off_depth(a, h, n, H, k, dgamma):
    if a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_depth(a, h, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_force(a, h, n, H, k, dgamma):
    if a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (dgamma > 1e-30) and (dgamma < 1e+30):
        try:
            value = bodies._pull_off_force(a, h, n, H, k, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, h, n, H, k, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, a, h, n, H, k):
    if F.__class__ is a.__class__ is h.__class__ is n.__class__ is H.__class__ is k.__class__ is float and F > -1e+30 and (F < 1e+30) and (a > 1e-30) and (a < 1e+30) and (h > 1e-30) and (h < 1e+30) and (n > 1e-30) and (n < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, a, h, n, H, k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, a, h, n, H, k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
