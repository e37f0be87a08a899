"""Programs of axicontact.graded.tangential.polynomial."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies.graded.tangential import polynomial as bodies


def full_slip_displacement(a, H, H_x, k, mu, A):
    if a.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._full_slip_displacement(a, A, H, H_x, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, H, H_x, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def stick_radius(F_x, a, H, k, mu, A):
    if F_x.__class__ is a.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._stick_radius(F_x, a, A, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F_x, a, H, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, H, H_x, k, mu, A):
    if a.__class__ is c.__class__ is H.__class__ is H_x.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (H > 1e-30) and (H < 1e+30) and (H_x > 1e-30) and (H_x < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._tangential_displacement(a, c, A, H, H_x, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, c, H, H_x, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, H, k, mu, A):
    if a.__class__ is c.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._tangential_force(a, c, A, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, c, H, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, H, k, mu, A):
    if r.__class__ is a.__class__ is c.__class__ is H.__class__ is k.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (H > 1e-30) and (H < 1e+30) and (k > 1e-30) and (k < 1.0) and (mu > 1e-30) and (mu < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._traction(r, a, c, A, H, k, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, c, H, k, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
