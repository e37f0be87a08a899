"""Material laws of viscoelasticity: relaxation and creep, and the factor of a ramp of the depth.

A ramp d = v t into a force F ~ d**m gives F_el(v t) times int_0^1 m x**(m - 1) E(t (1 - x)) dx.
"""

from __future__ import annotations

import numpy as np

from ..functions import gamma, gamma_quotient
from ..integrals import integral
from ..interface import Array

SWITCH, TERMS, ROUNDING = 40.0, 170, 2.0**-54


def fading(x: Array, m: Array) -> Array:
    """1F1(1; m + 1; -x) = int_0^1 m (1 - y)**(m - 1) exp(-x y) dy for x >= 0 and m >= 1: positive terms only."""
    low = np.minimum(x, SWITCH)
    term, total = np.exp(-low), np.exp(-low)
    for k in range(1, TERMS):
        term = term * low / k
        more = term * (m / (m + k))
        total = total + more
        if not np.count_nonzero(more > ROUNDING * total):
            break
    if not np.count_nonzero(x > SWITCH):
        return total
    high = np.maximum(x, SWITCH)
    tail = integral(lambda y: m * np.exp((m - 1.0) * np.log1p(-y) - high * y), 0.999999 * SWITCH / high, 64)
    return np.where(x <= SWITCH, total, np.where(x < np.inf, tail, 0.0))


def ramp_maxwell(t: Array, m: Array, E: Array, tau: Array) -> Array:
    return E * fading(t / tau, m)


def ramp_standard_solid(t: Array, m: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return E_inf + E_1 * fading(t / tau, m)


def ramp_kelvin_voigt(t: Array, m: Array, E: Array, eta: Array) -> Array:
    """Infinite at t = 0, where the force is the limit."""
    return E + eta * m / t


def ramp_power_creep(t: Array, m: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    return E * (t_0 / t) ** alpha * gamma_quotient(1.0 + m, 1.0 + m - alpha) / gamma(1.0 + alpha)


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
