"""Bodies of axicontact.normal.gaussian over plain numbers: the same text with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.inverse import between, inverse_below
from ...._programs.bodies._runtime.special import dawson
from ....normal.gaussian import Array
from ...._runtime.plain import MATH as np


def _slope(t: Array, h: Array, s: Array) -> Array:
    """Rate g'(t) of the indentation depth g(t)."""
    z = t / s
    return 2 * h / s * (dawson(z) + (1 - 2 * dawson(z) * z) * z)


def _depth(a: Array, h: Array, s: Array) -> Array:
    z = a / s
    return np.where(a <= 1.5019752682686114 * s, 2 * h * dawson(z) * z, np.nan)


def _radius_from_depth(d: Array, h: Array, s: Array) -> Array:
    def curve(a: Array) -> tuple[Array, Array]:
        value = _depth(a, h, s)
        return value, a * _slope(a, h, s) / value

    def like(short: Array) -> Array:
        rest = (1.003776, 0.2435676, 0.7000671, -0.6766533, 4.031949, -6.599278, 3.971419, -0.793611)
        return between(np.log(short / 0.6348098), (1.575, 2.0), (0.4486, 2.0), -6.0, rest)

    largest = 1.5019752682686114 * s * np.ones_like(d)
    return inverse_below(curve, d, largest, (1.0, 2.0), like)
