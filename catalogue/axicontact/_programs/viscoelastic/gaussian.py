"""Programs of axicontact.viscoelastic.gaussian."""

from __future__ import annotations

from ..._runtime.interface import ordinary
from ..._programs.bodies.viscoelastic import gaussian as bodies


def step_force_kelvin_voigt(t, d, h, s, E, eta):
    if t.__class__ is d.__class__ is h.__class__ is s.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._step_force_kelvin_voigt(t, d, h, s, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, h, s, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_maxwell(t, d, h, s, E, tau):
    if t.__class__ is d.__class__ is h.__class__ is s.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_force_maxwell(t, d, h, s, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, h, s, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_power_creep(t, d, h, s, E, alpha, t_0):
    if t.__class__ is d.__class__ is h.__class__ is s.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._step_force_power_creep(t, d, h, s, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, h, s, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_force_standard_solid(t, d, h, s, E_inf, E_1, tau):
    if t.__class__ is d.__class__ is h.__class__ is s.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (d > 1e-30) and (d < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_force_standard_solid(t, d, h, s, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, d, h, s, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_kelvin_voigt(t, F, h, s, E, eta):
    if t.__class__ is F.__class__ is h.__class__ is s.__class__ is E.__class__ is eta.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E > 1e-30) and (E < 1e+30) and (eta > 1e-30) and (eta < 1e+30):
        try:
            value = bodies._step_load_radius_kelvin_voigt(t, F, h, s, E, eta)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, h, s, E, eta):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_maxwell(t, F, h, s, E, tau):
    if t.__class__ is F.__class__ is h.__class__ is s.__class__ is E.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E > 1e-30) and (E < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_load_radius_maxwell(t, F, h, s, E, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, h, s, E, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_power_creep(t, F, h, s, E, alpha, t_0):
    if t.__class__ is F.__class__ is h.__class__ is s.__class__ is E.__class__ is alpha.__class__ is t_0.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E > 1e-30) and (E < 1e+30) and (alpha > 1e-30) and (alpha < 1.0) and (t_0 > 1e-30) and (t_0 < 1e+30):
        try:
            value = bodies._step_load_radius_power_creep(t, F, h, s, E, alpha, t_0)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, h, s, E, alpha, t_0):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def step_load_radius_standard_solid(t, F, h, s, E_inf, E_1, tau):
    if t.__class__ is F.__class__ is h.__class__ is s.__class__ is E_inf.__class__ is E_1.__class__ is tau.__class__ is float and t > 1e-30 and (t < 1e+30) and (F > 1e-30) and (F < 1e+30) and (h > 1e-30) and (h < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_inf > 1e-30) and (E_inf < 1e+30) and (E_1 > 1e-30) and (E_1 < 1e+30) and (tau > 1e-30) and (tau < 1e+30):
        try:
            value = bodies._step_load_radius_standard_solid(t, F, h, s, E_inf, E_1, tau)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(t, F, h, s, E_inf, E_1, tau):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
