"""Lengths that stand for a contact radius in an iteration: in them a load has no infinite slope and no flat stretch."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ._elementwise import Array
from ._integrals import difference_root

SETTLED, STEPS = 1e-9, 12
"""Where the steps towards ln t end: what they still miss is made good by the iteration that asks for t."""
CLOSEST = 18.3
"""artanh(a/R) of the last radius that is told from R."""


class Unknown(NamedTuple):
    """x of the radius a; a and da/dx of x; the largest x that makes sense."""

    of: Callable[[Array], Array]
    back: Callable[[Array], tuple[Array, Array]]
    end: Array | float = np.inf
    order: Array | float = 2.0
    """The highest power of x with which an excess begins."""
    unit: float = 0.0
    """The x up to which a load may be flat as far as it is known, for a branch that starts below."""


def radius_itself() -> Unknown:
    return Unknown(lambda a: a, lambda x: (x, np.ones_like(x)))


def up_to(R: Array, k: Array | float = 0.0) -> Unknown:
    """For a profile that is vertical at R: (1 - exp(-k v))/k with v = artanh(a/R), like the depth near R."""
    k = np.where(np.abs(k) < 1e-30, 1e-30, k)

    def like(v: Array) -> Array:
        return -np.expm1(-k * v) / k

    def of(a: Array) -> Array:
        return like(np.minimum(np.arctanh(np.minimum(a / R, 1.0)), CLOSEST))

    def back(x: Array) -> tuple[Array, Array]:
        v = -np.log1p(-k * x) / k
        return R * np.tanh(v), R * np.exp(k * v) / np.cosh(v) ** 2

    return Unknown(of, back, like(CLOSEST), order=3.0, unit=0.5)


def on_the_bump(s: Array) -> Unknown:
    """For f = h (1 - exp(-r**2/s**2)): the share of the height of the bump."""

    def back(x: Array) -> tuple[Array, Array]:
        a = s * np.sqrt(-np.log1p(-x))
        return a, s * s / (2.0 * a * (1.0 - x))

    return Unknown(lambda a: -np.expm1(-((a / s) ** 2)), back)


def beyond_edge(b: Array, first: Array | float = 1.0, last: Array | float = 1.0) -> Unknown:
    """For a load that leaves b as t**first and ends as t**last, t = sqrt(a**2/b**2 - 1)."""
    plain = isinstance(first, float) and first == last == 1.0

    def of(a: Array) -> Array:
        t = difference_root(a, b) / b
        return t if plain else t**first * (1.0 + t * t) ** ((last - first) / 2.0)

    def back(x: Array) -> tuple[Array, Array]:
        t, slope = (x, 1.0) if plain else powers_joined(x, first, last)
        a = b * np.hypot(1.0, t)
        return a, a * (t * t / (1.0 + t * t)) / (x * slope)

    return Unknown(of, back, order=3.0 / first, unit=1.0)


def powers_joined(x: Array, first: Array | float, last: Array | float) -> tuple[Array, Array]:
    """The t with t**first (1 + t**2)**((last - first)/2) = x, and d ln x/d ln t there."""
    t, slope = _joined(np.log(x), first, last)
    return _mended(t, x, t**first * (1.0 + t * t) ** ((last - first) / 2.0), slope), slope


def powers_summed(x: Array, small: Array, e: Array, large: Array) -> tuple[Array, Array]:
    """The t with small t**e + large t**2 = x, and d ln x/d ln t there.

    The share of the second term over that of the first is the square of what `_joined` finds.
    """
    ratio, slope = _joined(np.log(x / small) - e / 2.0 * np.log(x / large), e, 2.0)
    t = np.where(ratio > 1e8, 1.0, ratio / np.hypot(1.0, ratio)) * np.sqrt(x / large)
    return _mended(t, x, small * t**e + large * t * t, slope), slope


def _joined(wanted: Array, first: Array | float, last: Array | float) -> tuple[Array, Array]:
    """The first of them by the logarithm of x: Halley's steps in ln t."""
    wanted, first, last = np.broadcast_arrays(wanted, first, last)
    gain = last - first
    near = 0.5 * np.log(np.expm1(np.clip(2.0 * wanted / last, 0.0, 600.0)) + first / last)
    log = np.where(wanted < 0.0, wanted / first + 0.5 * np.log(first / last), near)
    log = np.where(wanted > 300.0 * last, wanted / last, log)
    for _ in range(STEPS):
        share = 1.0 / (1.0 + np.exp(-2.0 * log))
        slope = first + gain * share
        joined = first * log + gain * (np.maximum(log, 0.0) + 0.5 * np.log1p(np.exp(-2.0 * np.abs(log))))
        newton = (wanted - joined) / slope
        step = newton / np.maximum(1.0 + gain * share * (1.0 - share) / slope * newton, 0.3)
        log = log + np.where(np.isfinite(step), step, 0.0)
        if not np.any(np.abs(step) > SETTLED):
            break
    return np.exp(log), first + gain / (1.0 + np.exp(-2.0 * log))


def _mended(t: Array, x: Array, found: Array, slope: Array) -> Array:
    """t without the rounding of its logarithm."""
    missed = x / found - 1.0
    return t * np.where(np.abs(missed) < 1e-6 * slope, 1.0 + missed / slope, 1.0)
