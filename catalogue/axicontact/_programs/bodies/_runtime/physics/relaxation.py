"""Bodies of axicontact._runtime.physics.relaxation over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import exp, expm1, inf, pow, sin

from ....._programs.bodies._runtime.functions import gamma, gamma_quotient
from ....._runtime.plain import integral
from ....._runtime.plain import log1p, MATH as np

ROUNDING = 5.551115123125783e-17
SWITCH = 40.0
TERMS = 170


def fading(x, m):
    """1F1(1; m + 1; -x) = int_0^1 m (1 - y)**(m - 1) exp(-x y) dy for x >= 0 and m >= 1: positive terms only."""
    low = np.minimum(x, SWITCH)
    term, total = (np.exp(-low), np.exp(-low))
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
    return total if x <= SWITCH else tail if x < np.inf else 0.0


def ramp_maxwell(t, m, E, tau):
    return E * fading(t / tau, m)


def ramp_standard_solid(t, m, E_inf, E_1, tau):
    return E_inf + E_1 * fading(t / tau, m)


def ramp_power_creep(t, m, E, alpha, t_0):
    return E * (t_0 / t) ** alpha * gamma_quotient(1.0 + m, 1.0 + m - alpha) / gamma(1.0 + alpha)


def relaxation_maxwell(t, E, tau):
    return E * exp(-t / tau)


def relaxation_standard_solid(t, E_inf, E_1, tau):
    return E_inf + E_1 * exp(-t / tau)


def relaxation_kelvin_voigt(t, E, eta):
    if t > 0.0:
        return E
    return inf


def relaxation_power_creep(t, E, alpha, t_0):
    v8 = 3.141592653589793 * alpha
    return E * pow(t_0 / t, alpha) * sin(v8) / v8


def creep_maxwell(t, E, tau):
    return (1.0 + t / tau) / E


def creep_standard_solid(t, E_inf, E_1, tau):
    v4 = E_inf + E_1
    return 1.0 / v4 - E_1 / v4 * expm1(-(t / tau * (E_inf / v4))) / E_inf


def creep_kelvin_voigt(t, E, eta):
    return -expm1(-E * t / eta) / E


def creep_power_creep(t, E, alpha, t_0):
    return pow(t / t_0, alpha) / E


def left_maxwell(pressed, since, E, tau):
    return E * tau * exp(-since / tau) * -expm1(-pressed / tau)


def left_standard_solid(pressed, since, E_inf, E_1, tau):
    return E_inf * pressed + E_1 * tau * exp(-since / tau) * -expm1(-pressed / tau)


def left_power_creep(pressed, since, E, alpha, t_0):
    v6 = 1.0 - alpha
    v8 = since > 0.0
    if v8:
        v9 = since if v8 else 1.0
        v17 = pow(v9, v6) * expm1(v6 * log1p(pressed / v9))
    else:
        v17 = pow(pressed, v6)
    return E * pow(t_0, alpha) * sin(3.141592653589793 * (alpha if alpha < v6 or alpha != alpha else v6)) / (3.141592653589793 * alpha * v6) * v17
