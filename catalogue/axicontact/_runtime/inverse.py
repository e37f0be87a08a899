"""Roots of increasing functions without a closed inverse, by a safeguarded iteration of high order.

They begin where curves are joined from what is known of their ends.  Whether a point is left is asked by
np.count_nonzero: the graph of a formula takes np.any for a question about a rare branch.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .interface import Array

Curve = Callable[[Array], tuple[Array, Array]]
Exponents = tuple[Array | float, Array | float]
ITERATIONS, PATIENCE, POLISHING, SETTLED, ROUNDING, LOST = 120, 8, 3, 1e-9, 2.0**-53, 16.0
"""Normal contacts need at most five evaluations and two at single points, mostly three; the rest is for others."""


def inverse(
    curve: Curve,
    value: Array,
    start: Array,
    exponents: Exponents,
    largest: Array | float = np.inf,
    share: Callable[[Array], Array] | None = None,
    smooth: bool = False,
    noise: Array | None = None,
) -> Array:
    """The t > 0 with curve(t) = value.  It is at most `largest`.

    `curve` returns its value and its logarithmic slope d ln curve/d ln t.  Where that slope lies between the two
    `exponents`, which count as no more than a guess, the root lies in ln t between ln(value/curve) over either.
    The guarantee are signs, whatever the exponents: an increasing curve that is met below the value at one point and
    above it at another has its root between the two, and no step leaves such an interval.  Steps that do not settle
    within `PATIENCE` alternate with halves of it; if it is still open, with steps that double until it is not.
    A point that is settled stays: where the curve is met within its rounding.  With `noise`, where it is met within
    that.  With `share`, where a step no longer changes what t stands for, a quantity whose logarithm moves with that
    share of that of t.  What is left then is removed by a step that is linear in t.  Where the curve may have kinks
    and is not `smooth`, it is looked at again after that step.
    """
    if hasattr(start, "root"):
        return start.root(curve, value, largest, exponents)
    t = np.minimum(start, largest)
    position = np.log(t)
    y, slope = curve(t)
    error = _missed(value, y)
    low, high = np.full_like(position, -np.inf), np.full_like(position, np.log(largest))
    step = error / slope
    close = ROUNDING * value if noise is None else noise
    known = y == y
    solvable = (value > 0.0) & (value < np.inf) & known
    for iteration in range(ITERATIONS):
        # written so that a curve which has left the range of doubles is not met
        left = solvable & np.logical_not(np.abs(error) <= SETTLED * np.minimum(slope, 1.0))
        left = left & np.logical_not(np.abs(value - y) <= close)
        if share is not None:
            # of where the step leads too: far below the root t may stand for nothing
            moved = np.maximum(share(t), share(np.minimum(t * np.exp(np.minimum(step, 700.0)), largest)))
            left = left & np.logical_not(np.abs(error) * moved <= 4.0 * ROUNDING * slope)
        if not np.count_nonzero(left):
            break
        low = np.where(error > 0.0, np.maximum(low, position), low)
        high = np.where(error < 0.0, np.minimum(high, position), high)
        step = _safe(position, step, error, exponents, low, high, iteration - PATIENCE)
        position = np.where(left, position + step, position)
        t = np.where(left, np.exp(position), t)
        before, slope_before = error, slope
        y, slope = curve(t)
        y = np.where(y == y, y, np.inf)
        error = _missed(value, y)
        step = _step(step, before, slope_before, error, slope)
    change = _last_step(t, value, y, slope)
    t = t + change
    if not smooth:
        for _ in range(POLISHING):
            if not np.any(np.abs(change) > 1e-14 * t):
                break
            change = _last_step(t, value, *curve(t))
            t = t + change
    # a curve that is no number where the search begins has no root that is known
    root = np.where((value >= 0.0) & known, np.minimum(t, largest), np.nan)
    return np.where(value == 0.0, 0.0, np.where(value == np.inf, np.inf, root))


def _last_step(t: Array, value: Array, y: Array, slope: Array) -> Array:
    change = t * ((value - y) / y) / slope
    return np.where(np.abs(change) < 1e-3 * t, change, 0.0)


def _missed(value: Array, y: Array) -> Array:
    """ln value - ln y, to the last digit where they are close."""
    missed = (value - y) / y
    near = np.abs(missed) < 0.5
    return np.where(near, np.log1p(np.where(near, missed, 0.0)), np.log(value / y))


def _safe(
    position: Array, step: Array, error: Array, exponents: Exponents, low: Array, high: Array, late: int
) -> Array:
    """The step, no further and no nearer than the slopes allow; halfway where it leaves the signs met, or is `late`."""
    least, most = exponents
    # the logarithm of no ratio of doubles is larger
    error = np.minimum(np.maximum(error, -1500.0), 1500.0)
    ends = position + error / most, position + error * 2.0 ** max(late, 0) / np.maximum(least, 1e-300)
    first, last = np.minimum(*ends) - 1e-9, np.maximum(*ends) + 1e-9
    aimed = np.minimum(np.maximum(position + step, first), last)
    from_, to = np.maximum(first, low), np.minimum(last, high)
    met = np.isfinite(high - low)
    signs = (from_ > to) | (met & (late >= 0))
    middle = np.where(signs, low, from_) / 2.0 + np.where(signs, high, to) / 2.0
    if late >= 0:
        aimed = np.where(met, position + step, aimed)
    within = (low <= aimed) & (aimed <= high) & (late < 0 or late % 2 == 0)
    return np.where(within, aimed, middle) - position


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


def inverse_below(
    curve: Curve,
    value: Array,
    largest: Array,
    exponents: Exponents,
    like: Callable[[Array], Array] = np.sqrt,
) -> Array:
    """The t with curve(t) = value, for 0 < t <= largest where the curve ends with slope zero; not a number beyond.

    What the value is short of the largest, over the value, is nearly a power of the shortfall s of t over t at both
    ends; `exponents` are bounds of that power, `like` is about s of it.
    """
    top = curve(largest)[0]

    def shortfall(s: Array) -> tuple[Array, Array]:
        t = largest / (1.0 + s)
        y, slope = curve(t)
        short = (top - y) / y
        return above_noise(short, s / (1.0 + s) * slope * (1.0 + short), 1.0 + short, 2.0, exponents[0])

    # the largest value and the argument are both rounded
    short = np.maximum((top - value) / value, 0.0)
    noise = 4.0 * ROUNDING * (1.0 + short)
    s = inverse(shortfall, short, like(short), exponents, smooth=True, noise=noise)
    t = largest / (1.0 + s)
    return np.where(value <= top * (1.0 + 2.0**-48), t, np.nan)


def above_noise(
    difference: Array, rate: Array, size: Array, power: float | None, least: Array | float
) -> tuple[Array, Array]:
    """A difference of numbers of one `size` and its logarithmic slope; near zero it is all rounding, its rate is not.

    There it is that rate over its first `power`, if that is known.
    """
    tiny = ROUNDING * size
    if power is None:
        known = np.maximum(difference, tiny)
    else:
        known = np.where(difference > LOST * tiny, difference, np.maximum(rate / power, ROUNDING * tiny))
    return known, np.maximum(rate / known, least)


def between(
    x: Array, small: tuple[float, float], large: tuple[float, float], blend: float, rest: tuple[float, ...]
) -> Array:
    """About the t of a curve known at its ends: ln t where x is the logarithm of the curve over its value at t = 1.

    There t is (exp(x)/c)**(1/e), with c and e for `small` t and for `large`; `blend` is the power of either that
    is summed to q.  In between t is q times a polynomial of q/(1 + q), whose coefficients are the `rest`.
    """
    q = _joined(x, small, large, blend)
    v, factor = 1.0 - 1.0 / (1.0 + q), rest[-1]
    for coefficient in rest[-2::-1]:
        factor = factor * v + coefficient
    return q * factor


def _joined(x: Array, small: tuple[Array, float], large: tuple[Array, float], blend: float) -> Array:
    first, last = (blend / e * (x - np.log(c)) for c, e in (small, large))
    return np.exp((np.maximum(first, last) + np.log1p(np.exp(-np.abs(first - last)))) / blend)


def joining(like: Array, slope: Array, small: float, large: float) -> Array:
    """About the t of a curve over its value at t = 1, less steep for large t than for small, from its slopes."""
    x = np.log(like)
    if small == large:
        return np.exp(x / np.where(x < 0.0, slope, large))
    share = np.minimum(np.maximum((slope - small) / (large - small), 1e-12), 1.0 - 1e-12)
    return _joined(x, (1.0 / (1.0 - share), small), (1.0 / share, large), 0.5 * (small + large))


def leaving_power(like: Array, share: Array, tip: Array | float, small: float, large: float) -> Array:
    """The same where a power of the radius, `share` at t = 1, is left by a sum with powers of t."""
    x, rest = np.log(like), np.maximum(1.0 - share, 1e-300)
    below = _joined(np.minimum(x, 0.0), (share, 2.0), (rest, small), -0.5 * (2.0 + small))
    return np.where(x < 0.0, below, _joined(np.maximum(x, 0.0), (share, tip), (rest, large), -0.5 * (tip + large)))
