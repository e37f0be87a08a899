"""Programs of axicontact.viscoelastic.polynomial."""

from __future__ import annotations

from ..._runtime.interface import ordinary
from ..._programs.bodies.viscoelastic import polynomial as bodies


def step_force_kelvin_voigt(t, d, E, eta, A):
    if t.__class__ is d.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_force_kelvin_voigt(t, d, A, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, d, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_maxwell(t, d, E, tau, A):
    if t.__class__ is d.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_force_maxwell(t, d, A, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, d, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_power_creep(t, d, E, alpha, t_0, A):
    if t.__class__ is d.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_force_power_creep(t, d, A, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, d, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_standard_solid(t, d, E_inf, E_1, tau, A):
    if t.__class__ is d.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_force_standard_solid(t, d, A, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, d, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_kelvin_voigt(t, F, E, eta, A):
    if t.__class__ is F.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_load_radius_kelvin_voigt(t, F, A, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, F, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_maxwell(t, F, E, tau, A):
    if t.__class__ is F.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_load_radius_maxwell(t, F, A, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, F, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_power_creep(t, F, E, alpha, t_0, A):
    if t.__class__ is F.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_load_radius_power_creep(t, F, A, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, F, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_standard_solid(t, F, E_inf, E_1, tau, A):
    if t.__class__ is F.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30) and all([x.__class__ is float and (x == 0.0 or 1e-30 < x < 1e+30) for x in A]):
        try:
            value = bodies._step_load_radius_standard_solid(t, F, A, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or value == 0.0) and ordinary(t, F, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
