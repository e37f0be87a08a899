"""Bodies of axicontact._runtime.functions over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import cos, sin
import math

from ...._runtime.plain import sqrt, MATH as np


def sine_root(x, R, theta):
    v4 = R * sin(theta)
    v6 = R * cos(theta)
    v16 = v6 * v6 - (R - x) * (R + x) if v6 < v4 else (x - v4) * (x + v4)
    return sqrt(v16 if v16 > 0.0 or v16 != v16 else 0.0)


def halves(x):
    v2 = 134217729.0 * x
    v4 = v2 - (v2 - x)
    return (v4, x - v4)


def nth_root(x, n, more=0):
    """x**(1/(n + more)) for x >= 0; Newton's step makes good what the rounded exponent did, up to ln(x) units."""
    degree = n + more
    y = x ** (1.0 / degree)
    return y + y * ((x / (y ** n * y ** more) - 1.0) / degree) if (x > 0.0) & (x < np.inf) else y


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
