"""Material laws of viscoelasticity: relaxation and creep, and what a ramp of the depth makes of them.

A ramp d = v t into a force F ~ d**m gives F_el(v t) times int_0^1 m x**(m - 1) E(t (1 - x)) dx, into any other one
2 v int_0^a I(t - g(x)/v) dx with I(t) = int_0^t E ds: what springs bear that are pressed in from their first touch on.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..functions import gamma, gamma_quotient
from ..integrals import TERMS as VALUES
from ..integrals import in_parts, integral, summed
from ..interface import Array

SWITCH, TERMS, ROUNDING = 40.0, 170, 2.0**-54
STEP, BELOW, ABOVE = 0.33, 57, 112
"""Of the rule over springs, in ln(x/(a - x)): the step, and how many of them lead towards either end."""
_places = STEP * np.arange(-BELOW, ABOVE + 1)
SHARES = 1.0 / (1.0 + np.exp(-_places))
WEIGHTS = STEP * SHARES / (1.0 + np.exp(_places))
UNDER = float(np.sum(STEP * np.exp(-STEP * np.arange(BELOW + 1.0, 3.0 * BELOW))))
WEIGHTS[-1] *= 1.0 / -np.expm1(-STEP)
"""Nodes and weights on (0, 1), the weight that is left below the first node, and all above the last one in its own."""


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


def springs(left: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """The integral of what springs bear from `low` to `high`, next to which it may have any time of its own.

    Equal steps of the logarithm of the distance from either end are as fine as any kernel: with those of STEP powers
    and exponentials of any time are summed to 1e-15.  What is below the first node is as at `low`, what is above the
    last one as there.
    """
    first = left(low)
    nodes, weights = (column.reshape(-1, *(1,) * np.ndim(first)) for column in (SHARES, WEIGHTS))
    parts = in_parts(len(SHARES), VALUES // max(1, np.size(first)))
    total = summed(weights[part] * left(low + (high - low) * nodes[part]) for part in parts)
    return (high - low) * (total + UNDER * first)


def left_maxwell(pressed: Array, since: Array, E: Array, tau: Array) -> Array:
    """I(since + pressed) - I(since): what is left, per speed, of a spring that was pressed in until a time ago."""
    return E * tau * np.exp(-since / tau) * -np.expm1(-pressed / tau)


def left_standard_solid(pressed: Array, since: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return E_inf * pressed + left_maxwell(pressed, since, E_1, tau)


def left_power_creep(pressed: Array, since: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    beta = 1.0 - alpha
    # a power of the whole time and one of the time since lose what they have in common
    ago = np.where(since > 0.0, since, 1.0)
    grown = np.where(since > 0.0, ago**beta * np.expm1(beta * np.log1p(pressed / ago)), pressed**beta)
    return E * t_0**alpha * np.sin(np.pi * np.minimum(alpha, beta)) / (np.pi * alpha * beta) * grown
