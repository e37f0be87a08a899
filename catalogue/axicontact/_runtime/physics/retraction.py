"""The way back of a contact with a viscoelastic half-space, after a ramp of the depth up to t_m that is held up to t_h.

At t > t_h the contact is as large as at t_1 = t_m - lag, and the force is F_el(v t_1) times the factor
int_0^1 m x**(m - 1) E(t - t_1 x) dx, with t_1 = t_m while the depth is held.  The speed of the way back over that of
the ramp is `ratio`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..functions import gamma, gamma_quotient
from ..interface import Array, numbers, require_order
from .relaxation import fading

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

LARGEST = 700.0
"""Of exponents: what is beyond has ended before."""
STEPS, TERMS, ROUNDING = 20, 400, 2.0**-52
SOONEST = 1e100
"""Of t_m over what is left of the contact after the hold: what is beyond is nothing beside t_h."""


def require_hold(t_m: ArrayLike, t_h: ArrayLike | None) -> ArrayLike:
    """The end of the hold, t_m where none is given.

    Raises
    ------
    ValueError
        If it ends before it begins.
    """
    if t_h is None:
        return t_m
    if not (type(t_m) is type(t_h) is float and t_h >= t_m):
        early = numbers("t_h", t_h) < numbers("t_m", t_m)
        reason = "the depth is held from t_m to t_h, use t_h = t_m or leave it out for a way back that begins at once"
        require_order(~early, "t_h >= t_m", reason, t_m=t_m, t_h=t_h)
    return t_h


def earlier(t: Array, t_m: Array, lag: Array) -> Array:
    """t_1; the present on the way in, t_m while the depth is held, zero after the contact has ended."""
    return np.where(t > t_m, np.maximum(t_m - lag, 0.0), t)


def passed(t: Array, t_m: Array, lag: Array) -> Array:
    """t - t_1 from t_m on, where a difference would cancel."""
    return np.maximum(t - t_m, 0.0) + lag


def lag_maxwell(t: Array, t_m: Array, t_h: Array, ratio: Array, E: Array, tau: Array) -> Array:
    grown = ratio * np.expm1(np.minimum(np.maximum(t - t_h, 0.0) / tau, LARGEST))
    grown = grown * np.exp(np.minimum((t_h - t_m) / tau, LARGEST))
    return np.where(grown < 1.0, -tau * np.log1p(-np.minimum(grown, 1.0 - ROUNDING)), np.inf)


def lag_kelvin_voigt(t: Array, t_m: Array, t_h: Array, ratio: Array, E: Array, eta: Array) -> Array:
    """The dashpot is pulled as soon as the indenter goes back, so that the radius jumps."""
    return np.where(t > t_h, ratio * (t - t_h + eta / E), 0.0)


def lag_standard_solid(t: Array, t_m: Array, t_h: Array, ratio: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    since, x, stiffer = np.maximum(t - t_m, 0.0) / tau, np.maximum(t - t_h, 0.0) / tau, E_1 / E_inf
    return tau * slowed(ratio * (x - stiffer * np.expm1(-x)), stiffer * np.exp(-since))


def lag_power_creep(t: Array, t_m: Array, t_h: Array, ratio: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    share, beta = np.where(t > t_h, (t - t_h) / (t - t_m), 0.0), 1.0 - alpha
    return np.maximum(t - t_m, 0.0) * np.expm1(np.minimum(np.log1p(ratio * share**beta) / beta, LARGEST))


def slowed(x: Array, k: Array) -> Array:
    """The y with y + k (1 - exp(-y)) = x, for x >= 0 and k >= 0, by Newton's method.

    It is x - k + W(k exp(k - x)) with Lambert's W, whose logarithm the start is near where k is large.
    """
    large = np.maximum(k, 1.0)
    level = np.log(large) + (large - x)
    above = np.maximum(level, 1.0)
    # log(W) for W + log(W) = level
    below = level - np.log1p(np.exp(np.minimum(level, 1.0)))
    lambert = np.where(level > 1.0, np.log(above - np.log(above)), below)
    y = np.where((k > 1.0) & (2.0 * x > 1.0 + k), np.log(large) - lambert, np.maximum(x / (1.0 + k), x - k))
    for _ in range(STEPS):
        gone = -np.expm1(-y)
        step = (x - y - k * gone) / (1.0 + k * (1.0 - gone))
        y = np.maximum(y + step, 0.0)
        if not np.count_nonzero(np.abs(step) > ROUNDING * y):
            break
    return y


def kept_maxwell(t: Array, t_1: Array, since: Array, m: Array, E: Array, tau: Array) -> Array:
    return E * np.exp(-since / tau) * fading(t_1 / tau, m)


def kept_kelvin_voigt(t: Array, t_1: Array, since: Array, m: Array, E: Array, eta: Array) -> Array:
    return E + 0.0 * t_1


def kept_standard_solid(t: Array, t_1: Array, since: Array, m: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    return E_inf + E_1 * np.exp(-since / tau) * fading(t_1 / tau, m)


def kept_power_creep(t: Array, t_1: Array, since: Array, m: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    """m x**-m B(x; m, 1 - alpha) with x = t_1/t by the fraction that converges on its side of x.

    What is left of the whole B loses 1/(1 - alpha) units for alpha close to 1.
    """
    beta = 1.0 - alpha
    middle = (m + 1.0) / (m + 2.0 + beta)
    x, rest = t_1 / t, np.minimum(since / t, 1.0)
    low, high, near = np.minimum(x, middle), np.maximum(x, middle), np.minimum(rest, 1.0 - middle)
    first = rest**beta * fraction(low, m, beta)
    whole = gamma_quotient(1.0 + m, m + beta) * gamma(1.0 + beta) / beta / high**m
    second = whole - m / beta * near**beta * fraction(near, beta, m)
    scale = E * (t_0 / t) ** alpha * np.sin(np.pi * np.minimum(alpha, beta)) / (np.pi * alpha)
    return scale * np.where(x < middle, first, second)


def fraction(x: Array, p: Array, q: Array) -> Array:
    """p x**-p (1 - x)**-q B(x; p, q) for x up to (p + 1)/(p + q + 2), by its continued fraction (Lentz)."""
    above, below = 1.0, 1.0 / (1.0 - (p + q) * x / (p + 1.0))
    total = below
    for k in range(1, TERMS):
        change = 1.0
        for own in coefficients(k, x, p, q):
            below = 1.0 / (1.0 + own * below)
            above = 1.0 + own / above
            change = above * below
            total = total * change
        if not np.count_nonzero(np.abs(change - 1.0) > ROUNDING):
            break
    return total


def coefficients(k: int, x: Array, p: Array, q: Array) -> tuple[Array, Array]:
    """Two of its coefficients."""
    even = k * (q - k) * x / ((p + (2 * k - 1)) * (p + 2 * k))
    return even, -(p + k) * (p + q + k) * x / ((p + 2 * k) * (p + (2 * k + 1)))


def end_maxwell(ratio: Array, t_m: Array, t_h: Array, E: Array, tau: Array) -> Array:
    return t_h + tau * np.log1p(-np.expm1(-t_m / tau) * np.exp((t_m - t_h) / tau) / ratio)


def end_kelvin_voigt(ratio: Array, t_m: Array, t_h: Array, E: Array, eta: Array) -> Array:
    """At the end of the hold where the dashpot is pulled too fast."""
    return t_h + np.maximum(t_m / ratio - eta / E, 0.0)


def end_standard_solid(ratio: Array, t_m: Array, t_h: Array, E_inf: Array, E_1: Array, tau: Array) -> Array:
    x, stiffer = t_m / tau, E_1 / E_inf
    faded = -stiffer * np.expm1(-x) * np.exp((t_m - t_h) / tau)
    return t_h + tau * slowed((x + faded) / ratio, stiffer + faded / ratio)


def end_power_creep(ratio: Array, t_m: Array, t_h: Array, E: Array, alpha: Array, t_0: Array) -> Array:
    beta = 1.0 - alpha
    at_once = np.expm1(np.minimum(np.log1p(ratio) / beta, LARGEST))
    return t_h + t_m / np.where(t_h > t_m, sooner(at_once, (t_h - t_m) / t_m, ratio, beta), at_once)


def sooner(start: Array, k: Array, ratio: Array, beta: Array) -> Array:
    """The y = 1/u with ratio u**beta = (u + k + 1)**beta - (u + k)**beta, by Newton's method for its logarithm.

    It starts from that without a hold, k = 0, which is smaller; eight steps are the most of 1500 random ones.
    """
    y = np.minimum(start, SOONEST)
    for _ in range(STEPS):
        whole = 1.0 + k * y
        grown = np.expm1(beta * np.log1p(y / whole))
        slope = beta * y * (k + (1.0 + grown) / grown / (whole + y)) / whole
        step = -np.log(whole**beta * grown / ratio) / slope
        y = np.minimum(y * np.exp(np.minimum(step, LARGEST)), SOONEST)
        # of the time that is left, beside all before
        if not np.count_nonzero(np.abs(step) > 4.0 * ROUNDING * (y + whole)):
            break
    return y
