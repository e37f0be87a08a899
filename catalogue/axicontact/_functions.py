"""Functions that NumPy lacks, or that lose digits when written out."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from ._elementwise import Array
from ._kernels import (
    ARCTAN_GAP,
    DAWSON,
    GAMMA_RATIO,
    HANKEL_P_0,
    HANKEL_P_1,
    HANKEL_Q_0,
    HANKEL_Q_1,
    ROOT_GAP,
    STRUVE_0,
    STRUVE_1,
    STRUVE_TAIL_0,
    STRUVE_TAIL_1,
    TANH_GAP,
)

_NEAR = 0.42
"""Where the kernel of `root_gap` ends; the root is 1.008 there."""


def rational(v: Array, top: Sequence[float], bottom: Sequence[float]) -> Array:
    """P(v)/Q(v) with coefficients in ascending order, for v >= 0; the terms of either do not cancel."""
    above, below = top[-1], bottom[-1]
    for coefficient in top[-2::-1]:
        above = above * v + coefficient
    for coefficient in bottom[-2::-1]:
        below = below * v + coefficient
    return above / below


def arctan_gap(x: Array) -> Array:
    """x - arctan(x) for x >= 0."""
    t = np.minimum(x, 1.0)
    return np.where(x < 1.0, t * (t * t) * rational(t * t, *ARCTAN_GAP), x - np.arctan(x))


def root_gap(x: Array, y: Array) -> Array:
    """arctan_gap(sqrt(x**2 - y**2)/y) for x >= y, through their difference: next to x = y it is a cube of the root."""
    q = (x - y) / y
    near, root = np.minimum(q, _NEAR), np.sqrt((x - y) * (x + y)) / y
    return np.where(q < _NEAR, near * np.sqrt(near) * rational(near, *ROOT_GAP), root - np.arctan(root))


def tanh_gap(y: Array, x: Array) -> Array:
    """y - x for x = tanh(y) >= 0; as the cube of x, which may be rounded less often than the angle."""
    t = np.minimum(y, 1.0)
    return np.where(y < 1.0, x * (x * x) * rational(t * t, *TANH_GAP), y - x)


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
    (x_high, x_low), (y_high, y_low) = _halves(x), _halves(y)
    return ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low


def _halves(x: Array) -> tuple[Array, Array]:
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
    """pi/2 w(r)/g(a) beside a contact whose depth g is a power of its radius a < r; see `_kernels`."""
    tangent = _half_tangent(r, a)
    return a / r * from_start(tangent * tangent, *kernel)


def beside_cone(r: Array, a: Array) -> Array:
    """The same where the depth is proportional to the radius: psi - tan(psi/2), sin(psi) = a/r."""
    tangent = _half_tangent(r, a)
    return 2.0 * np.arctan(tangent) - tangent


def _half_tangent(r: Array, a: Array) -> Array:
    """The tangent of half the angle whose sine is a/r."""
    return a / (r + np.sqrt((r - a) * (r + a)))


def gamma_ratio(x: Array) -> Array:
    """Gamma(x + 1/2)/Gamma(x) for x > 0, from that at x + 2."""
    w, below = x + 1.75, (x + 0.5) * (x + 1.5)
    down = np.where(x < 1.0, x * (x + 1.0) / below, 1.0 - (x + 0.75) / below)
    return down * np.sqrt(w) * from_start(1.0 / (w * w), *GAMMA_RATIO)


def depth_over_height(j: int) -> float:
    """sqrt(pi) Gamma(j/2 + 1)/Gamma(j/2 + 1/2) for j = 1, 2, ...: j!!/(j - 1)!!, for an odd j times pi/2."""
    ratio = math.prod(range(j, 0, -2)) / math.prod(range(j - 1, 0, -2))
    return ratio * (math.pi / 2.0) if j % 2 else ratio


def dawson(x: Array) -> Array:
    """Dawson's integral exp(-x**2) int_0^x exp(u**2) du for 0 <= x <= 25/16; a Gaussian bump asks up to 1.502."""
    return x / rational(x * x, *DAWSON)


def struve_h0(x: Array) -> Array:
    """Struve function H_0(x) for x >= 0."""

    def far(x: Array) -> Array:
        v = (_SWITCH / x) * (_SWITCH / x)
        p, q = rational(v, *HANKEL_P_0), -rational(v, *HANKEL_Q_0) / x
        return _wave(x, p + q, q - p) + 2.0 / np.pi / x * rational(v, *STRUVE_TAIL_0)

    return _joined(x, lambda x: x * _series(x, STRUVE_0), far)


def struve_h1(x: Array) -> Array:
    """Struve function H_1(x) for x >= 0."""

    def far(x: Array) -> Array:
        v = (_SWITCH / x) * (_SWITCH / x)
        p, q = rational(v, *HANKEL_P_1), rational(v, *HANKEL_Q_1) / x
        return _wave(x, q - p, -p - q) + 2.0 / np.pi * rational(v, *STRUVE_TAIL_1)

    return _joined(x, lambda x: x * x * _series(x, STRUVE_1), far)


# the kernels below end there, those beyond begin; H_0 has its first zero at 4.33
_SWITCH = 4.0


def _joined(x: Array, near: Callable[[Array], Array], far: Callable[[Array], Array]) -> Array:
    return np.where(x >= _SWITCH, far(np.maximum(x, _SWITCH)), near(np.minimum(x, _SWITCH)))


def _series(x: Array, kernel: tuple[Sequence[float], Sequence[float]]) -> Array:
    """In powers of 16 - x**2, which are all positive."""
    return rational((_SWITCH - x) * (_SWITCH + x), *kernel)


def _wave(x: Array, sine: Array, cosine: Array) -> Array:
    """Y_nu(x) from the sums and differences of Hankel's P and Q."""
    return (sine * np.sin(x) + cosine * np.cos(x)) / np.sqrt(np.pi * x)
