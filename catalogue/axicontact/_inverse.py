"""Roots of increasing functions without a closed inverse, by a safeguarded iteration of high order."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array

Curve = Callable[[Array], tuple[Array, Array]]
Exponents = tuple[Array | float, Array | float]
Beyond = Callable[[Array, Array], tuple[Array, Array]]
ITERATIONS, PATIENCE, POLISHING, SETTLED, ROUNDING = 120, 8, 4, 1e-9, 2.0**-53
"""No curve of the catalogue needs more than six evaluations; the others are for those of other profiles."""


def inverse(
    curve: Curve,
    value: Array,
    start: Array,
    exponents: Exponents,
    largest: Array | float = np.inf,
    share: Callable[[Array], Array] | None = None,
    smooth: bool = False,
    noise: Array | float = 0.0,
) -> Array:
    """The t with curve(t) = value, for 0 < t <= largest.

    `curve` returns its value and its logarithmic slope d ln curve/d ln t.  That slope lies between
    the two `exponents`, so the error of `start` bounds the root from both sides:
    ln t - ln start lies between ln(value/curve(start)) divided by either exponent.
    A step in ln t is taken unless it leaves the bracket; where it does not settle, the bracket is halved.
    A point that is settled stays: where the curve is met within a rounding or within `noise`, or where a step no
    longer changes what t stands for, a quantity whose logarithm moves with `share` of that of t.  What is left then
    is removed by a step that is linear in t, without a second look where the curve is `smooth`, without kinks.
    """
    t = np.minimum(start, largest)
    position = np.log(t)
    y, slope = curve(t)
    error = _missed(value, y)
    low: Array
    high: Array
    low, high = _bracket(position, error, exponents, largest)
    step = error / slope
    solvable = (value > 0.0) & (value < np.inf) & (y == y)
    for iteration in range(ITERATIONS):
        # written so that a curve which has left the range of doubles is not met
        left = solvable & ~(np.abs(error) <= SETTLED * np.minimum(slope, 1.0))
        left = left & ~(np.abs(value - y) <= np.maximum(ROUNDING * value, noise))
        if share is not None:
            left = left & ~(np.abs(error) * share(t) <= 4.0 * ROUNDING * slope)
        # not np.any, which `_trace` takes for a question about a rare branch
        if not np.count_nonzero(left):
            break
        low = np.where(error > 0.0, np.maximum(low, position), low)
        high = np.where(error < 0.0, np.minimum(high, position), high)
        within = (low <= position + step) & (position + step <= high) & ((iteration < PATIENCE) | (iteration % 2 == 0))
        step = np.where(within, step, (low + high) / 2.0 - position)
        position = np.where(left, position + step, position)
        t = np.where(left, np.exp(position), t)
        before, slope_before = error, slope
        y, slope = curve(t)
        y = np.where(y == y, y, np.inf)
        error = _missed(value, y)
        step = _step(step, before, slope_before, error, slope)
    for _ in range(1 if smooth else POLISHING):
        change = t * ((value - y) / y) / slope
        change = np.where(np.abs(change) < 1e-6 * t, change, 0.0)
        t = t + change
        if smooth or not np.any(np.abs(change) > 1e-14 * t):
            break
        y, slope = curve(t)
    root = np.where(value >= 0.0, np.minimum(t, largest), np.nan)
    return np.where(value == 0.0, 0.0, np.where(value == np.inf, np.inf, root))


def _missed(value: Array, y: Array) -> Array:
    """ln value - ln y, to the last digit where they are close."""
    missed = (value - y) / y
    near = np.abs(missed) < 0.5
    return np.where(near, np.log1p(np.where(near, missed, 0.0)), np.log(value / y))


def _bracket(position: Array, error: Array, exponents: Exponents, largest: Array | float) -> tuple[Array, Array]:
    """Bounds of ln t by the least and the largest slope."""
    low, high = exponents
    ends = position + error / np.maximum(low, 1e-300), position + error / high
    return np.minimum(*ends) - 1e-9, np.minimum(np.maximum(*ends) + 1e-9, np.log(largest))


def _step(step: Array, before: Array, slope_before: Array, error: Array, slope: Array) -> Array:
    """The next step in ln t: of the cubic through the last two points and their slopes, with ln curve as variable.

    Newton's where the two disagree: next to a kink, or before the end is near.
    """
    # a root that is met moves no more
    newton, way = error / slope, np.where(before == error, np.inf, before - error)
    mean = step / way
    bend, bend_before = (1.0 / slope - mean) / way, (mean - 1.0 / slope_before) / way
    more = error * error * (bend + (bend - bend_before) / way * before)
    return newton + np.where(np.abs(more) < 0.5 * np.abs(newton), more, 0.0)


def between(x: Array, small: tuple[float, float], large: tuple[float, float], blend: float) -> Array:
    """The t of a curve known at its ends: ln t where x is the logarithm of the curve over its value at t = 1.

    There t is (exp(x)/c)**(1/e), with c and e for `small` t and for `large`; `blend` is the power of either that
    is summed.
    """
    first, last = (blend / e * (x - np.log(c)) for c, e in (small, large))
    return np.exp((np.maximum(first, last) + np.log1p(np.exp(-np.abs(first - last)))) / blend)


def inverse_below(curve: Curve, value: Array, largest: Array, exponents: Exponents) -> Array:
    """The t with curve(t) = value, for 0 < t <= largest where the curve ends with slope zero; not a number beyond.

    What the value is short of the largest, over the value, is nearly a power of the shortfall s of t over t at both
    ends; `exponents` are bounds of that power.
    """
    top = curve(largest)[0]

    def shortfall(s: Array) -> tuple[Array, Array]:
        t = largest / (1.0 + s)
        y, slope = curve(t)
        # next to the end the difference is all rounding, of either sign
        short = np.maximum((top - y) / y, ROUNDING)
        return short, np.maximum(s / (1.0 + s) * slope * (1.0 + short) / short, exponents[0])

    # the largest value and the argument are both rounded
    short = np.maximum((top - value) / value, 0.0)
    noise = 4.0 * ROUNDING * (1.0 + short)
    s = inverse(shortfall, short, np.sqrt(short), exponents, smooth=True, noise=noise)
    t = largest / (1.0 + s)
    return np.where(value <= top * (1.0 + 2.0**-48), t, np.nan)


def inverse_across(
    curve: Curve,
    beyond: Beyond,
    value: Array,
    b: Array,
    tip: Array | float,
    end: Array | None = None,
    least: Array | float = 1.0,
) -> Array:
    """The radius with curve(radius) = value, for a curve whose slope jumps or bends sharply at b.

    It begins as the power `tip` of the radius.  Below b its unknown is the radius, or artanh(radius/end) where the
    curve below would be infinitely steep at `end`.
    Above, the excess over curve(b) grows like a power of t = sqrt(radius**2/b**2 - 1), `least` or a higher one,
    even where the curve leaves b with an infinite slope.
    There `beyond` gives the value and its derivative by ln t, from the radius and b t.
    """
    base = curve(b * np.ones_like(value))[0]
    above = value > base
    radius = b * np.ones_like(value)
    if not np.all(above):
        radius = _below(curve, np.where(above, base, value), base, b, tip, end)
    if not np.any(above):
        return radius
    high = np.where(above, value, 2.0 * base)

    def excess(t: Array) -> tuple[Array, Array]:
        y, rate = beyond(b * np.sqrt(1.0 + t * t), b * t)
        more = np.maximum(y - base, ROUNDING * base)
        # next to b the difference is all rounding
        return more, np.maximum(rate / more, least)

    # both the value and that at the break are rounded, some of them sums
    noise = 8.0 * ROUNDING * high
    t = inverse(excess, high - base, np.ones_like(value), (least, np.inf), smooth=True, noise=noise)
    return np.where(above, b * np.sqrt(1.0 + t * t), radius)


def _below(curve: Curve, value: Array, base: Array, b: Array, tip: Array | float, end: Array | None) -> Array:
    """The radius up to b."""
    if end is None:
        # a parabolic tip is met at once
        return inverse(curve, value, b * (value / base) ** (1.0 / tip), (tip, np.inf), b, smooth=True)
    reach = np.arctanh(np.minimum(b / end, 1.0 - ROUNDING))
    like = value / base * np.where(reach > 1.0, reach, reach**tip)

    def share(t: Array) -> Array:
        return t / (np.sinh(t) * np.cosh(t))

    def bent(t: Array) -> tuple[Array, Array]:
        y, slope = curve(end * np.tanh(t))
        return y, slope * share(t)

    start = np.where(like > 1.0, like, like ** (1.0 / tip))
    return np.minimum(b, end * np.tanh(inverse(bent, value, start, (1.0, tip), np.inf, share, smooth=True)))
