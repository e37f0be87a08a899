"""Roots of increasing functions without a closed inverse, by a safeguarded Newton iteration."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array

Curve = Callable[[Array], tuple[Array, Array]]
ITERATIONS, PATIENCE, POLISHING, SETTLED = 120, 12, 4, 1e-12


def inverse(
    curve: Curve, value: Array, start: Array, exponents: tuple[float, float], largest: Array | float = np.inf
) -> Array:
    """The t with curve(t) = value, for 0 < t <= largest.

    `curve` returns its value and its logarithmic slope d ln curve/d ln t.  That slope lies between
    the two `exponents`, so the error of `start` bounds the root from both sides:
    ln t - ln start lies between ln(value/curve(start)) divided by either exponent.
    Newton's step in ln t is taken unless it leaves the bracket; where it does not settle, the bracket is halved.
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
        if not np.any((np.abs(step) > SETTLED) | (np.abs(error) > SETTLED)):
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
