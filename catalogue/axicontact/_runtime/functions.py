"""Functions that NumPy lacks, or that lose digits when written out; gamma functions by the standard library."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from .interface import Array


def rational(v: Array, top: Sequence[float], bottom: Sequence[float]) -> Array:
    """P(v)/Q(v) with coefficients in ascending order, for v >= 0; the terms of either do not cancel."""
    above, below = top[-1], bottom[-1]
    for coefficient in top[-2::-1]:
        above = above * v + coefficient
    for coefficient in bottom[-2::-1]:
        below = below * v + coefficient
    return above / below


def sine_root(x: Array, R: Array, theta: Array) -> Array:
    """sqrt(x**2 - (R*sin(theta))**2), and zero for x below; a sine close to 1 is rounded away from its angle."""
    sine, cosine = R * np.sin(theta), R * np.cos(theta)
    square = np.where(cosine < sine, cosine * cosine - (R - x) * (R + x), (x - sine) * (x + sine))
    return np.sqrt(np.maximum(square, 0.0))


def difference_of_products(w: Array, x: Array, y: Array, z: Array) -> Array:
    """w*x - y*z with the rounding of both products made good (Dekker 1971)."""
    left, right = w * x, y * z
    return (left - right) + (_lost(w, x, left) - _lost(y, z, right))


def _lost(x: Array, y: Array, product: Array) -> Array:
    """x*y - product, exactly."""
    (x_high, x_low), (y_high, y_low) = halves(x), halves(y)
    return ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low


def halves(x: Array) -> tuple[Array, Array]:
    """Two numbers of 26 bits that add up to x."""
    high = 134217729.0 * x
    high = high - (high - x)
    return high, x - high


def nth_root(x: Array, n: Array, more: int = 0) -> Array:
    """x**(1/(n + more)) for x >= 0; Newton's step makes good what the rounded exponent did, up to ln(x) units."""
    degree = n + more
    y = x ** (1.0 / degree)
    return np.where((x > 0.0) & (x < np.inf), y + y * ((x / (y**n * y**more) - 1.0) / degree), y)


def without_root(x: Array, n: Array, more: int = 0) -> Array:
    """x**(1 - 1/(n + more)) for x >= 0, as x over its root."""
    return np.where((x > 0.0) & (x < np.inf), x / nth_root(x, n, more), x)


def lower_power(x: Array, n: Array) -> Array:
    """x**(n - 1) for x >= 0; the rounding of n - 1 would cost up to ln(x) units."""
    return np.where(x > 0.0, x**n / x, x ** (n - 1.0))


def from_start(v: Array, top: Sequence[float], bottom: Sequence[float], start: float) -> Array:
    """start + v P(v)/Q(v), where the start is most of it."""
    return start + v * rational(v, top, bottom)


def beside(r: Array, a: Array, kernel: tuple[Sequence[float], Sequence[float], float]) -> Array:
    """pi/2 w(r)/g(a) beside a contact whose depth g is a power of its radius a < r; see `kernels`."""
    tangent = _half_tangent(r, a)
    return a / r * from_start(tangent * tangent, *kernel)


def beside_cone(r: Array, a: Array) -> Array:
    """The same where the depth is proportional to the radius: psi - tan(psi/2), sin(psi) = a/r."""
    tangent = _half_tangent(r, a)
    return 2.0 * np.arctan(tangent) - tangent


def _half_tangent(r: Array, a: Array) -> Array:
    """The tangent of half the angle whose sine is a/r."""
    return a / (r + np.sqrt((r - a) * (r + a)))


def depth_over_height(j: int) -> float:
    """sqrt(pi) Gamma(j/2 + 1)/Gamma(j/2 + 1/2) for j = 1, 2, ...: j!!/(j - 1)!!, for an odd j times pi/2."""
    ratio = math.prod(range(j, 0, -2)) / math.prod(range(j - 1, 0, -2))
    return ratio * (math.pi / 2.0) if j % 2 else ratio


def gamma(x: Array) -> Array:
    return np.vectorize(math.gamma, otypes=[float])(x)


def gamma_quotient(x: Array, y: Array) -> Array:
    """Gamma(x)/Gamma(y), where each of them may be too large."""

    def quotient(x: float, y: float) -> float:
        return math.gamma(x) / math.gamma(y) if x < 100.0 else math.exp(math.lgamma(x) - math.lgamma(y))

    return np.vectorize(quotient, otypes=[float])(x, y)


def at_break(b: Array) -> Array:
    """The root of radius**2 - b**2 at the break b."""
    return np.zeros_like(b)
