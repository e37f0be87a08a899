"""Formulas of axicontact._runtime.physics.relaxation over an array library `xp`."""

from ....._runtime.steps import fading
from ....._runtime.steps import rising


def relaxation_maxwell(xp, t, E, tau):
    return E * xp.exp(-t / tau)


def relaxation_standard_solid(xp, t, E_inf, E_1, tau):
    return E_inf + E_1 * xp.exp(-t / tau)


def relaxation_power_creep(xp, t, E, alpha, t_0):
    v4 = 3.141592653589793 * alpha
    return E * (t_0 / t) ** alpha * xp.sin(v4) / v4


def creep_kelvin_voigt(xp, t, E, eta):
    return -xp.expm1(-E * t / eta) / E


def creep_standard_solid(xp, t, E_inf, E_1, tau):
    v1 = E_inf + E_1
    return 1.0 / v1 - E_1 / v1 * xp.expm1(-(t / tau * (E_inf / v1))) / E_inf


def ramp_standard_solid(xp, t, m, E_inf, E_1, tau):
    return E_inf + E_1 * fading(xp, t / tau, m)


def ramp_power_creep(xp, t, m, E, alpha, t_0):
    v4 = 1.0 + m
    v5 = v4 - alpha
    v8 = E * (t_0 / t) ** alpha * rising(xp, v5, v4 - v5)
    return v8 / rising(xp, 1.0, 1.0 + alpha - 1.0)
