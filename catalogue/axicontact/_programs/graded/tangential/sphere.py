"""Programs of axicontact.graded.tangential.sphere."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.tangential import sphere as bodies


def full_slip_displacement(a, R, H, H_x, k, mu):
    if a.__class__ is R.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._full_slip_displacement(a, R, H, H_x, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, R, H, H_x, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stick_radius(F_x, a, R, H, k, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, R, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, H, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
