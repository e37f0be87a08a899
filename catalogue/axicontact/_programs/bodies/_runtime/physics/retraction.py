"""Bodies of axicontact._runtime.physics.retraction over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import exp, expm1, inf, pow

from ....._programs.bodies._runtime.functions import gamma, gamma_quotient
from ....._programs.bodies._runtime.physics.relaxation import fading
from ....._runtime.plain import log1p, MATH as np

LARGEST = 700.0
ROUNDING = 2.220446049250313e-16
SOONEST = 1e+100
STEPS = 20
TERMS = 400


def earlier(t, t_m, lag):
    if t > t_m:
        v4 = t_m - lag
        return v4 if v4 > 0.0 or v4 != v4 else 0.0
    return t


def passed(t, t_m, lag):
    v3 = t - t_m
    return (v3 if v3 > 0.0 or v3 != v3 else 0.0) + lag


def lag_maxwell(t, t_m, t_h, ratio, E, tau):
    v6 = t - t_h
    v9 = (v6 if v6 > 0.0 or v6 != v6 else 0.0) / tau
    v15 = (t_h - t_m) / tau
    v18 = ratio * expm1(v9 if v9 < 700.0 or v9 != v9 else 700.0) * exp(v15 if v15 < 700.0 or v15 != v15 else 700.0)
    if v18 < 1.0:
        return -tau * log1p(-(v18 if v18 < 0.9999999999999998 or v18 != v18 else 0.9999999999999998))
    return inf


def lag_kelvin_voigt(t, t_m, t_h, ratio, E, eta):
    if t > t_h:
        return ratio * (t - t_h + eta / E)
    return 0.0


def lag_standard_solid(t, t_m, t_h, ratio, E_inf, E_1, tau):
    since, x, stiffer = (np.maximum(t - t_m, 0.0) / tau, np.maximum(t - t_h, 0.0) / tau, E_1 / E_inf)
    return tau * slowed(ratio * (x - stiffer * np.expm1(-x)), stiffer * np.exp(-since))


def lag_power_creep(t, t_m, t_h, ratio, E, alpha, t_0):
    v9 = t - t_m
    v14 = 1.0 - alpha
    v19 = log1p(ratio * pow((t - t_h) / v9 if t > t_h else 0.0, v14)) / v14
    return (v9 if v9 > 0.0 or v9 != v9 else 0.0) * expm1(v19 if v19 < 700.0 or v19 != v19 else 700.0)


def slowed(x, k):
    """The y with y + k (1 - exp(-y)) = x, for x >= 0 and k >= 0, by Newton's method.

    It is x - k + W(k exp(k - x)) with Lambert's W, whose logarithm the start is near where k is large.
    """
    large = np.maximum(k, 1.0)
    level = np.log(large) + (large - x)
    above = np.maximum(level, 1.0)
    below = level - np.log1p(np.exp(np.minimum(level, 1.0)))
    lambert = np.log(above - np.log(above)) if level > 1.0 else below
    y = np.log(large) - lambert if (k > 1.0) & (2.0 * x > 1.0 + k) else np.maximum(x / (1.0 + k), x - k)
    for _ in range(STEPS):
        gone = -np.expm1(-y)
        step = (x - y - k * gone) / (1.0 + k * (1.0 - gone))
        y = np.maximum(y + step, 0.0)
        if not np.count_nonzero(np.abs(step) > ROUNDING * y):
            break
    return y


def kept_maxwell(t, t_1, since, m, E, tau):
    return E * np.exp(-since / tau) * fading(t_1 / tau, m)


def kept_standard_solid(t, t_1, since, m, E_inf, E_1, tau):
    return E_inf + E_1 * np.exp(-since / tau) * fading(t_1 / tau, m)


def kept_power_creep(t, t_1, since, m, E, alpha, t_0):
    """m x**-m B(x; m, 1 - alpha) with x = t_1/t by the fraction that converges on its side of x.

    What is left of the whole B loses 1/(1 - alpha) units for alpha close to 1.
    """
    beta = 1.0 - alpha
    middle = (m + 1.0) / (m + 2.0 + beta)
    x, rest = (t_1 / t, np.minimum(since / t, 1.0))
    low, high, near = (np.minimum(x, middle), np.maximum(x, middle), np.minimum(rest, 1.0 - middle))
    first = rest ** beta * fraction(low, m, beta)
    whole = gamma_quotient(1.0 + m, m + beta) * gamma(1.0 + beta) / beta / high ** m
    second = whole - m / beta * near ** beta * fraction(near, beta, m)
    scale = E * (t_0 / t) ** alpha * np.sin(np.pi * np.minimum(alpha, beta)) / (np.pi * alpha)
    return scale * (first if x < middle else second)


def fraction(x, p, q):
    """p x**-p (1 - x)**-q B(x; p, q) for x up to (p + 1)/(p + q + 2), by its continued fraction (Lentz)."""
    above, below = (1.0, 1.0 / (1.0 - (p + q) * x / (p + 1.0)))
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


def coefficients(k, x, p, q):
    """Two of its coefficients."""
    even = k * (q - k) * x / ((p + (2 * k - 1)) * (p + 2 * k))
    return (even, -(p + k) * (p + q + k) * x / ((p + 2 * k) * (p + (2 * k + 1))))


def end_standard_solid(ratio, t_m, t_h, E_inf, E_1, tau):
    x, stiffer = (t_m / tau, E_1 / E_inf)
    faded = -stiffer * np.expm1(-x) * np.exp((t_m - t_h) / tau)
    return t_h + tau * slowed((x + faded) / ratio, stiffer + faded / ratio)


def end_power_creep(ratio, t_m, t_h, E, alpha, t_0):
    beta = 1.0 - alpha
    at_once = np.expm1(np.minimum(np.log1p(ratio) / beta, LARGEST))
    return t_h + t_m / (sooner(at_once, (t_h - t_m) / t_m, ratio, beta) if t_h > t_m else at_once)


def sooner(start, k, ratio, beta):
    """The y = 1/u with ratio u**beta = (u + k + 1)**beta - (u + k)**beta, by Newton's method for its logarithm.

    It starts from that without a hold, k = 0, which is smaller; eight steps are the most of 1500 random ones.
    """
    y = np.minimum(start, SOONEST)
    for _ in range(STEPS):
        whole = 1.0 + k * y
        grown = np.expm1(beta * np.log1p(y / whole))
        slope = beta * y * (k + (1.0 + grown) / grown / (whole + y)) / whole
        step = -np.log(whole ** beta * grown / ratio) / slope
        y = np.minimum(y * np.exp(np.minimum(step, LARGEST)), SOONEST)
        if not np.count_nonzero(np.abs(step) > 4.0 * ROUNDING * (y + whole)):
            break
    return y
