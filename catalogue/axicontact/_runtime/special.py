"""Functions from fitted kernels, and the greatest pressure; few profiles need them: they are apart from `functions`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from .functions import from_start, rational
from .interface import Array, Result
from .kernels import (
    ARCTAN_GAP,
    DAWSON,
    GAMMA_RATIO,
    HANKEL_P_0,
    HANKEL_P_1,
    HANKEL_Q_0,
    HANKEL_Q_1,
    PEAK_LARGE,
    PEAK_SMALL,
    ROOT_GAP,
    STRUVE_0,
    STRUVE_1,
    STRUVE_TAIL_0,
    STRUVE_TAIL_1,
    TANH_GAP,
)

_NEAR = 0.42
"""Where the kernel of `root_gap` ends; the root is 1.008 there."""


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


def gamma_ratio(x: Array) -> Array:
    """Gamma(x + 1/2)/Gamma(x) for x > 0, from that at x + 2."""
    w, below = x + 1.75, (x + 0.5) * (x + 1.5)
    down = np.where(x < 1.0, x * (x + 1.0) / below, 1.0 - (x + 0.75) / below)
    return down * np.sqrt(w) * from_start(1.0 / (w * w), *GAMMA_RATIO)


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


class PeakPressure(NamedTuple):
    """The greatest pressure and its radius."""

    pressure: Result
    radius: Result


def peak_share(a: Array, b: Array) -> Array:
    """(r - b)/(a - b) of that radius under a flat face of radius b with a parabolic rounding; b/a alone decides.

    It is sqrt(pi b/a)/2 for small b/a and nowhere above 0.311, so that r is surely between b and a.
    """
    x = np.sqrt(b / a)
    small, large = np.minimum(x, 0.5), np.minimum(np.maximum(x, 0.5), 1.0)
    return x / (1.0 + x) * np.where(x < 0.5, rational(0.5 - small, *PEAK_SMALL), rational(1.0 - large, *PEAK_LARGE))
