"""Roots of increasing functions without a closed inverse, by a safeguarded iteration of high order."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array

Curve = Callable[[Array], tuple[Array, Array]]
ITERATIONS, PATIENCE, POLISHING, SETTLED, ROUNDING = 120, 12, 4, 1e-9, 2.0**-53


def inverse(
    curve: Curve,
    value: Array,
    start: Array,
    exponents: tuple[float, float],
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
    It ends early where the curve is met within a rounding, or where a step no longer changes what t stands for:
    a quantity whose logarithm moves with `share` of that of t.  What the last steps change of the root of a
    `smooth` curve, without kinks, needs no second look.  What the curve misses by less than `noise` is not missed.
    """
    low_exponent, high_exponent = exponents
    position = np.log(start)
    y, slope = curve(start)
    error = np.log(value / y)
    ends = position + error / low_exponent if low_exponent > 0.0 else error * np.inf, position + error / high_exponent
    low, high = np.minimum(*ends) - 1e-9, np.minimum(np.maximum(*ends) + 1e-9, np.log(largest))
    step = error / slope
    for iteration in range(ITERATIONS):
        low = np.where(error > 0.0, np.maximum(low, position), low)
        high = np.where(error < 0.0, np.minimum(high, position), high)
        within = (low <= position + step) & (position + step <= high) & ((iteration < PATIENCE) | (iteration % 2 == 0))
        step = np.where(within, step, (low + high) / 2.0 - position)
        position = position + step
        t = np.exp(position)
        before, slope_before = error, slope
        y, slope = curve(t)
        error = np.log1p((value - y) / y)
        moving = np.abs(value - y) > np.maximum(ROUNDING * value, noise)
        if share is not None:
            moving = moving & (np.abs(step) * share(t) > 4.0 * ROUNDING)
        if not np.any(moving & (np.abs(error) > SETTLED * np.minimum(slope, 1.0))):
            break
        step = _step(step, before, slope_before, error, slope)
    # the last steps are linear in t: they remove the rounding of the logarithm, and what is left next to a kink
    enough = SETTLED if smooth else 1e-14
    for _ in range(POLISHING):
        change = t * ((value - y) / y) / slope
        change = np.where((np.abs(change) < 1e-6 * t) & (np.abs(value - y) > noise), change, 0.0)
        t = t + change
        if not np.any(np.abs(change) > enough * t):
            break
        y, slope = curve(t)
    root = np.minimum(t, largest)
    return np.where(value == 0.0, 0.0, np.where(value == np.inf, np.inf, root))


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


def inverse_below(curve: Curve, value: Array, largest: Array, exponents: tuple[float, float]) -> Array:
    """The t with curve(t) = value, for 0 < t <= largest where the curve ends with slope zero; not a number beyond.

    What the value is short of the largest, over the value, is nearly a power of the shortfall s of t over t at both
    ends; `exponents` are bounds of that power.
    """
    top = curve(largest)[0]

    def shortfall(s: Array) -> tuple[Array, Array]:
        t = largest / (1.0 + s)
        y, slope = curve(t)
        short = (top - y) / y
        return short, s / (1.0 + s) * slope * (1.0 + short) / short

    # the largest value and the argument are both rounded
    short = np.maximum((top - value) / value, 0.0)
    noise = 4.0 * ROUNDING * (1.0 + short)
    s = inverse(shortfall, short, np.sqrt(short), exponents, smooth=True, noise=noise)
    t = largest / (1.0 + s)
    return np.where(value <= top * (1.0 + 2.0**-50), t, np.nan)


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

    low, tip = min(1.0, exponents[0]), exponents[0]
    # a parabolic tip is met at once
    start = np.where(above, 1.0, (np.minimum(value, base) / base) ** (1.0 / tip))
    largest = np.where(above, np.inf, 1.0)
    return radius(inverse(excess, np.where(above, value - base, value), start, (low, exponents[1]), largest, share))
