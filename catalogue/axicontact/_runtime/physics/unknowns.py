"""Lengths that stand for a contact radius in an iteration: in them a load has no infinite slope and no flat stretch."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..integrals import difference_root
from ..interface import Array, Kept

Load = Callable[..., Array]
CLOSE = 1e-4
"""The t at which the terms of a load beyond a break are read."""
SHARP, SETTLED, STEPS = 0.3, 1e-9, 12
"""First powers below SHARP are joined to the last as a graded load does; steps of the join that count as settled."""
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
        ratio = np.sqrt(-np.log1p(-x))
        return s * ratio, s / (2.0 * ratio * (1.0 - x))

    return Unknown(lambda a: -np.expm1(-((a / s) ** 2)), back)


def beyond_edge(b: Array, first: Array | float = 1.0, last: Array | float = 1.0) -> Unknown:
    """For a load that leaves b as t**first and ends as t**last, t = sqrt(a**2/b**2 - 1)."""
    plain = isinstance(first, float) and first == last == 1.0

    def of(a: Array) -> Array:
        t = difference_root(a, b) / b
        return t if plain else power_of(t, first, last)

    def back(x: Array) -> tuple[Array, Array]:
        t, slope = (x, 1.0) if plain else root_of(x, first, last)
        a = b * np.hypot(1.0, t)
        return a, a * (t * t / (1.0 + t * t)) / (x * slope)

    return Unknown(of, back, order=3.0 / first, unit=1.0)


def root_of(x: Array, first: Array | float, last: Array | float) -> tuple[Array, Array]:
    """The t at which x is t**first for small t and t**last for large, and d ln x/d ln t there.

    Joined at t**2 = first/last without a kink; but where the first is near 0 the bend would be sharp, and x is
    t**first (1 + t**2)**((last - first)/2).
    """
    if np.any(first < SHARP):
        return _root_of_product(x, first, last)
    share = first / last
    square = np.where(x < 1.0, share, np.maximum(x, 1.0) ** (2.0 / last) - 1.0 + share)
    t = np.sqrt(square) * np.where(x < 1.0, np.minimum(x, 1.0) ** (1.0 / first), 1.0)
    return t, np.where(x < 1.0, first, last * square / (square + 1.0 - share))


def power_of(t: Array, first: Array | float, last: Array | float) -> Array:
    """The x of which `root_of` gives t."""
    if np.any(first < SHARP):
        return _product(t, first, last)
    share = first / last
    low = np.minimum(t / np.sqrt(share), 1.0) ** first
    return np.where(t * t < share, low, (np.maximum(t * t - share, 0.0) + 1.0) ** (last / 2.0))


def _product(t: Array, first: Array | float, last: Array | float) -> Array:
    return t**first * (1.0 + t * t) ** ((last - first) / 2.0)


def _root_of_product(x: Array, first: Array | float, last: Array | float) -> tuple[Array, Array]:
    """Halley's steps in ln t."""
    wanted, gain = np.log(x), last - first
    near = 0.5 * np.log(np.expm1(np.minimum(np.maximum(2.0 * wanted / last, 0.0), 600.0)) + first / last)
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
    t, slope = np.exp(log), first + gain / (1.0 + np.exp(-2.0 * log))
    # the rounding of the logarithm is felt in its exponential
    missed = x / _product(t, first, last) - 1.0
    return t * np.where(np.abs(missed) < 1e-6 * slope, 1.0 + missed / slope, 1.0), slope


@Kept
def at_break(of: tuple[Load, Load], b: Array, first: Array, *needs: Array) -> tuple[Array, Array, Array]:
    """The load at a break, and that at CLOSE beyond it with its derivative by ln a."""
    load, rate = of
    a, root = b * (1.0 + CLOSE * CLOSE) ** 0.5, b * CLOSE
    return load(b, first, *needs), load(a, root, *needs), a * rate(a, root, *needs)
