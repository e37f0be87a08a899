"""Roots of increasing functions without a closed inverse, by a safeguarded Newton iteration."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array

Curve = Callable[[Array], tuple[Array, Array]]
ITERATIONS, PATIENCE, POLISHING, SETTLED, ROUNDING = 120, 12, 4, 1e-12, 2.0**-53


def inverse(
    curve: Curve,
    value: Array,
    start: Array,
    exponents: tuple[float, float],
    largest: Array | float = np.inf,
    share: Callable[[Array], Array] | None = None,
) -> Array:
    """The t with curve(t) = value, for 0 < t <= largest.

    `curve` returns its value and its logarithmic slope d ln curve/d ln t.  That slope lies between
    the two `exponents`, so the error of `start` bounds the root from both sides:
    ln t - ln start lies between ln(value/curve(start)) divided by either exponent.
    Newton's step in ln t is taken unless it leaves the bracket; where it does not settle, the bracket is halved.
    It ends early where the curve is met within a rounding, or where a step no longer changes what t stands for:
    a quantity whose logarithm moves with `share` of that of t.
    """
    low_exponent, high_exponent = exponents
    position = np.log(start)
    y, slope = curve(start)
    error = np.log(value / y)
    ends = position + error / low_exponent if low_exponent > 0.0 else error * np.inf, position + error / high_exponent
    low, high = np.minimum(*ends) - 1e-9, np.minimum(np.maximum(*ends) + 1e-9, np.log(largest))
    for iteration in range(ITERATIONS):
        low = np.where(error > 0.0, np.maximum(low, position), low)
        high = np.where(error < 0.0, np.minimum(high, position), high)
        step = error / slope
        newton = (low <= position + step) & (position + step <= high) & ((iteration < PATIENCE) | (iteration % 2 == 0))
        step = np.where(newton, step, (low + high) / 2.0 - position)
        position = position + step
        t = np.exp(position)
        y, slope = curve(t)
        error = np.log1p((value - y) / y)
        moving = np.abs(value - y) > ROUNDING * value
        if share is not None:
            moving = moving & (np.abs(step) * share(t) > 4.0 * ROUNDING)
        if not np.any(moving & ((np.abs(step) > SETTLED) | (np.abs(error) > SETTLED))):
            break
    # the last steps are linear in t: they remove the rounding of the logarithm, and what is left next to a kink
    for _ in range(POLISHING):
        change = t * ((value - y) / y) / slope
        change = np.where(np.abs(change) < 1e-6 * t, change, 0.0)
        t = t + change
        if not np.any(np.abs(change) > 1e-14 * t):
            break
        y, slope = curve(t)
    root = np.minimum(t, largest)
    return np.where(value == 0.0, 0.0, np.where(value == np.inf, np.inf, root))


def inverse_across(curve: Curve, value: Array, b: Array, exponents: tuple[float, float]) -> Array:
    """The radius with curve(radius) = value, for a curve whose slope jumps or bends sharply at b.

    Below b its unknown is t = radius/b.  Above, the excess over curve(b) grows like a power of
    t = sqrt(radius**2/b**2 - 1) with an exponent of 1 or more, even where the curve leaves b with an infinite slope.
    """
    base = curve(b * np.ones_like(value))[0]
    above = value > base

    def radius(t: Array) -> Array:
        return b * np.where(above, np.sqrt(1.0 + t * t), t)

    def share(t: Array) -> Array:
        return np.where(above, t * t / (1.0 + t * t), 1.0)

    def excess(t: Array) -> tuple[Array, Array]:
        y, slope = curve(radius(t))
        more = np.where(above, y - base, y)
        return more, slope * (y / more) * share(t)

    start, largest = np.where(above, 1.0, 0.5), np.where(above, np.inf, 1.0)
    low = min(1.0, exponents[0])
    return radius(inverse(excess, np.where(above, value - base, value), start, (low, exponents[1]), largest, share))
