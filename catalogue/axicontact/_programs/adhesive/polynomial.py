"""Programs of axicontact.adhesive.polynomial."""

from __future__ import annotations

from ..._runtime.interface import ordinary
from ..._programs.bodies.adhesive import polynomial as bodies


def depth(a, E_star, dgamma, A):
    if a.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._depth(a, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def displacement(r, a, E_star, dgamma, A):
    if r.__class__ is a.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._displacement(r, a, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def force(a, E_star, dgamma, A):
    if a.__class__ is E_star.__class__ is dgamma.__class__ is float and a > 1e-30 and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._force(a, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(a, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pressure(r, a, E_star, dgamma, A):
    if r.__class__ is a.__class__ is E_star.__class__ is dgamma.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._pressure(r, a, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a) or value == 0.0) and ordinary(r, a, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def pull_off_radius(E_star, dgamma, A, control):
    if E_star.__class__ is dgamma.__class__ is float and E_star > 1e-30 and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._pull_off_radius(A, E_star, dgamma, control)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_depth(d, E_star, dgamma, A):
    if d.__class__ is E_star.__class__ is dgamma.__class__ is float and d > -1e+30 and (d < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_depth(d, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(d, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def radius_from_force(F, E_star, dgamma, A):
    if F.__class__ is E_star.__class__ is dgamma.__class__ is float and F > -1e+30 and (F < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (dgamma > 1e-30) and (dgamma < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._radius_from_force(F, A, E_star, dgamma)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, E_star, dgamma):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def work_of_adhesion_from_pull_off(F, E_star, A):
    if F.__class__ is E_star.__class__ is float and F > -1e+30 and (F < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._work_of_adhesion_from_pull_off(F, A, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(F, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
