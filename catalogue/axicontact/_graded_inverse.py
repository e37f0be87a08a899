"""Contact radius of a depth or a force on the graded half space, in a variable in which the load is nearly linear."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_growth import gaussian_rate
from ._integrals import difference_root
from ._inverse import ROUNDING, Curve, inverse, inverse_across, inverse_below

Load = Callable[..., Array]
SLACK = 0.1
"""Least exponent assumed of a load that is no power: it only widens the bracket."""
LEAST, STEEPEST = 1e-150, 1e8
"""Roots over radii between which a radius is told from the end of its domain."""


def radius_to(load: Load, rate: Load, value: Array, start: Array, needs: tuple[Array, ...]) -> Array:
    """The a with load(a, *needs) = value; `rate` is the derivative of the load."""
    value = value + np.zeros(1)
    start = start + np.zeros_like(value)
    return inverse(_curve(load, rate, needs), value, start, (SLACK, np.inf), smooth=True)


def radius_up_to(load: Load, rate: Load, value: Array, largest: Array, needs: tuple[Array, ...]) -> Array:
    """The same where the load ends at `largest` with slope zero; NaN beyond."""
    value = value + np.zeros(1)
    # the rate there must not round to less than zero
    largest = largest * (1.0 - 2.0**-49) + np.zeros_like(value)
    return inverse_below(_curve(load, rate, needs), value, largest, (1.0, 4.0))


def _curve(load: Load, rate: Load, needs: tuple[Array, ...]) -> Curve:
    def curve(a: Array) -> tuple[Array, Array]:
        own = load(a, *needs)
        return own, a * rate(a, *needs) / own

    return curve


def radius_beyond(
    load: Load, rate: Load, value: Array, b: Array, needs: tuple[Array, ...], exponents: tuple[Array, Array]
) -> Array:
    """The same for a flat face of radius b; both functions take a and its root b t = sqrt(a**2 - b**2).

    The load grows as t**e for small and for large t, with the two `exponents`; the unknown is
    t**e (1 + t**2)**((f - e)/2), which does the same: with e = 1 + k near 0 it does not run away.
    """
    first, last = exponents
    value = value + np.zeros(1)
    # its power stays a normal number: below the range of doubles everything would be done in longer numbers
    least = LEAST ** (1.0 / np.maximum(first, 1.0))

    def like(t: Array) -> tuple[Array, Array]:
        square = t * t
        share = square / (1.0 + square)
        return t**first * (1.0 + square) ** ((last - first) / 2.0), first + (last - first) * share

    def place(x: Array) -> Array:
        x = np.maximum(x, like(least)[0])
        start = np.where(x < 1.0, np.maximum(x ** (1.0 / first), least), x ** (1.0 / last))
        ends, noise = (np.minimum(first, last), np.maximum(first, last)), 4.0 * ROUNDING * x
        return inverse(like, x, start, ends, smooth=True, noise=noise)

    def curve(x: Array) -> tuple[Array, Array]:
        t = place(x)
        a, root = np.hypot(b, b * t), b * t
        own = load(a, root, *needs)
        return own, root * (root / a) * rate(a, root, *needs) / own / like(t)[1]

    unit = like(np.ones_like(value))[0]
    x = inverse(curve, value, unit * (value / curve(unit)[0]), (SLACK, np.inf), smooth=True)
    return np.hypot(b, b * place(x))


def radius_across(
    load: Load,
    rate: Load,
    value: Array,
    b: Array,
    needs: tuple[Array, ...],
    tip: Array,
    least: Array | float = 1.0,
    end: Array | None = None,
) -> Array:
    """The same for a profile with a break at b, the power `tip` of a below and at least t**least in excess beyond."""

    def curve(a: Array) -> tuple[Array, Array]:
        root = difference_root(a, b)
        own = load(a, root, *needs)
        return own, a * rate(a, root, *needs) / own

    def beyond(a: Array, root: Array) -> tuple[Array, Array]:
        return load(a, root, *needs), root * (root / a) * rate(a, root, *needs)

    return inverse_across(curve, beyond, value + np.zeros(1), b, tip, end, least)


def radius_below(
    load: Load, rate: Load, value: Array, R: Array, needs: tuple[Array, ...], exponent: Array, k: Array
) -> Array:
    """The same for a sphere, in t = a/sqrt(R**2 - a**2); NaN where the load is beyond that of a = R.

    It begins as t**`exponent`, and ends as const - t**-k, log(t) or t**-k, by the sign of k; the unknown is
    (1 - (1 + t**exponent)**(-k/exponent))/k, which does the same.
    """
    value = value + np.zeros(1)
    k = np.where(np.abs(k) < 1e-30, 1e-30, k)

    def like(t: Array) -> tuple[Array, Array]:
        power = t**exponent
        log = np.log1p(power)
        x = -np.expm1(-k / exponent * log) / k
        return x, power / (1.0 + power) * np.exp(-k / exponent * log) / x

    def place(x: Array) -> Array:
        power = np.expm1(-exponent / k * np.log1p(-k * x))
        return power ** (1.0 / exponent)

    def radius(t: Array) -> tuple[Array, Array]:
        root = R / np.hypot(1.0, t)
        return root * t, root

    def curve(x: Array) -> tuple[Array, Array]:
        t = place(x)
        a, root = radius(t)
        own = load(a, root, *needs)
        return own, a * (root / R) ** 2 * rate(a, root, *needs) / own / like(t)[1]

    steepest = STEEPEST * np.ones_like(value)
    half = 0.5 * np.ones_like(value)
    largest = like(steepest)[0]
    x = inverse(curve, value, half * (value / curve(half)[0]), (SLACK, np.inf), largest, smooth=True)
    return np.where(value <= load(*radius(steepest), *needs), radius(place(x))[0], np.nan)


def gaussian_reach(s: Array, k: Array) -> Array:
    """The radius of largest depth of a Gaussian bump, where the contact ceases to be compact."""
    low, high = np.ones_like(s + k), 8.0 * np.ones_like(s + k)
    for _ in range(60):
        middle = (low + high) / 2.0
        # with the s of the caller: the rate at the radius returned must not round to less than zero
        rises = gaussian_rate(s * middle, s, k) >= 0.0
        low, high = np.where(rises, middle, low), np.where(rises, high, middle)
    return s * low
