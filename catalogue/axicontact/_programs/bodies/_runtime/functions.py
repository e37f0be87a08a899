"""Bodies of axicontact._runtime.functions over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

import math

from ...._runtime.plain import MATH as np


def rational(v, top, bottom):
    """P(v)/Q(v) with coefficients in ascending order, for v >= 0; the terms of either do not cancel."""
    above, below = (top[-1], bottom[-1])
    for coefficient in top[-2::-1]:
        above = above * v + coefficient
    for coefficient in bottom[-2::-1]:
        below = below * v + coefficient
    return above / below


def sine_root(x, R, theta):
    """sqrt(x**2 - (R*sin(theta))**2), and zero for x below; a sine close to 1 is rounded away from its angle."""
    sine, cosine = (R * np.sin(theta), R * np.cos(theta))
    square = cosine * cosine - (R - x) * (R + x) if cosine < sine else (x - sine) * (x + sine)
    return np.sqrt(np.maximum(square, 0.0))


def halves(x):
    """Two numbers of 26 bits that add up to x."""
    high = 134217729.0 * x
    high = high - (high - x)
    return (high, x - high)


def nth_root(x, n, more=0):
    """x**(1/(n + more)) for x >= 0; Newton's step makes good what the rounded exponent did, up to ln(x) units."""
    degree = n + more
    y = x ** (1.0 / degree)
    return y + y * ((x / (y ** n * y ** more) - 1.0) / degree) if (x > 0.0) & (x < np.inf) else y


def lower_power(x, n):
    """x**(n - 1) for x >= 0; the rounding of n - 1 would cost up to ln(x) units."""
    return x ** n / x if x > 0.0 else x ** (n - 1.0)


def from_start(v, top, bottom, start):
    """start + v P(v)/Q(v), where the start is most of it."""
    return start + v * rational(v, top, bottom)


def depth_over_height(j):
    """sqrt(pi) Gamma(j/2 + 1)/Gamma(j/2 + 1/2) for j = 1, 2, ...: j!!/(j - 1)!!, for an odd j times pi/2."""
    ratio = math.prod(range(j, 0, -2)) / math.prod(range(j - 1, 0, -2))
    return ratio * (math.pi / 2.0) if j % 2 else ratio


def gamma(x):
    return np.vectorize(math.gamma, otypes=[float])(x)


def gamma_quotient(x, y):
    """Gamma(x)/Gamma(y), where each of them may be too large."""

    def quotient(x, y):
        return math.gamma(x) / math.gamma(y) if x < 100.0 else math.exp(math.lgamma(x) - math.lgamma(y))
    return np.vectorize(quotient, otypes=[float])(x, y)
