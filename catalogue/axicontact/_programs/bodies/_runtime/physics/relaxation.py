"""Bodies of axicontact._runtime.physics.relaxation over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.physics.relaxation import Array
from ....._runtime.plain import MATH as np


def relaxation_maxwell(t: Array, E: Array, tau: Array) -> Array:
    return E * np.exp(-t / tau)


def relaxation_standard_solid(t: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return E_inf + E_1 * np.exp(-t / tau)


def relaxation_kelvin_voigt(t: Array, E: Array, eta: Array) -> Array:
    """For t > 0; a step of the depth needs an infinite force at t = 0."""
    return np.where(t > 0.0, E, np.inf)


def relaxation_power_creep(t: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return E * (t_0 / t) ** alpha * np.sin(np.pi * alpha) / (np.pi * alpha)


def creep_maxwell(t: Array, E: Array, tau: Array) -> Array:
    return (1.0 + t / tau) / E


def creep_standard_solid(t: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    glassy = E_inf + E_1
    x = t / tau * (E_inf / glassy)
    return 1.0 / glassy - E_1 / glassy * np.expm1(-x) / E_inf


def creep_kelvin_voigt(t: Array, E: Array, eta: Array) -> Array:
    return -np.expm1(-E * t / eta) / E


def creep_power_creep(t: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return (t / t_0) ** alpha / E
