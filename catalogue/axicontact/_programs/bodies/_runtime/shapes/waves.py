"""Bodies of axicontact._runtime.shapes.waves over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.special import struve_h0, struve_h1
from ....._runtime.plain import MATH as np

FAR = 0.015625
LOOKS = 12
ROUNDING = 1.1102230246251565e-16
TERMS = 15
TURNS = 60


def inverse_over_waves(value, waves, power):
    """The z at which the integral of x**(power - 1) g'(x) from 0 to z is `value`, g(x) = x**2 + waves x H_0(x).

    Where the waves are as steep as they may be the slope of the curve touches zero, and no power of z is close to it.
    But H_0 and H_1 at one point say all derivatives: the curve is followed to the root on its Taylor series, over
    half of z or two radians at most, and looked at again from there if what the series leaves out counts.
    The curve increases, so that the root is between the points that were met below and above it; no step leaves them.
    """
    plain = np.sqrt(value) if power == 1 else np.cbrt(1.5 * value)
    raised = 1.0 + 2.0 / np.pi * waves / (1.0 + plain * plain)
    z = plain / (np.sqrt(raised) if power == 1 else np.cbrt(raised))
    left = (value > 0.0) & (value < np.inf)
    low, high = (np.zeros_like(z), np.full_like(z, np.inf))
    for _ in range(LOOKS):
        width = np.minimum(0.5 * z, 2.0)
        y, series = _series(z, waves, width, power)
        s = _reached(series, value - y, value)
        low, high = (z if y < value else low, z if y > value else high)
        step = z + width * s
        within = (low <= step) & (step <= high)
        z = (step if within else 0.5 * (low + np.minimum(high, z + width))) if left else z
        rest = np.abs(series[-1] * s ** len(series))
        settled = within & (np.abs(s) < 1.0) & (rest <= 0.5 * ROUNDING * value)
        left = left & np.logical_not(settled & (np.abs(value - y) <= FAR * value))
        if not np.count_nonzero(left):
            break
    return (z if value < np.inf else np.inf) if value >= 0.0 else np.nan


def _series(z, waves, width, power):
    """The curve at z, and the coefficients of its change at z + width s from that of s on.

    With H_0' = 2/pi - H_1 and (x H_1)' = x H_0; g' = 2 x + waves (H_0 + 2/pi x - x H_1).
    """
    part = width / z
    zero, one = ([struve_h0(z)], [struve_h1(z)])
    square, change = (z * z * zero[0] - z * one[0], z * z)
    y = change + waves * z * zero[0] if power == 1 else 2.0 / 3.0 * z * change + waves * square
    for n in range(TERMS - 1):
        grown = zero[n] if n == 0 else zero[n] + part * zero[n - 1]
        zero += [width * ((2.0 / np.pi if n == 0 else 0.0) - one[n]) / (n + 1)]
        one += [width * grown / (n + 1) - part * one[n]]
    slopes = [2.0 * z + waves * (zero[0] + z * (2.0 / np.pi - one[0]))]
    slopes += [2.0 * width + waves * (zero[1] + width * (2.0 / np.pi - one[0]) - z * one[1])]
    slopes += [waves * (zero[n] - z * one[n] - width * one[n - 1]) for n in range(2, TERMS)]
    if power == 2:
        slopes = [z * slopes[0]] + [z * slopes[n] + width * slopes[n - 1] for n in range(1, TERMS)]
    return (y, [width * slopes[n] / (n + 1) for n in range(TERMS)])


def _reached(series, change, value):
    """The s in [-1, 1] at which the series has grown by `change`, or the end before it.

    By Laguerre's steps for a cubic: where the slope touches zero the root is nearly a triple one.
    """
    most = least = 0.0 * change
    for coefficient in series[::-1]:
        most, least = (coefficient + most, -coefficient - least)
    s = (1.0 if change >= most else 0.0) - (1.0 if change <= least else 0.0)
    within = s == 0.0
    low, high = (-np.ones_like(change), np.ones_like(change))
    for turn in range(TURNS):
        missed, slope, bend = (series[-1], 0.0 * s, 0.0 * s)
        for coefficient in series[-2::-1]:
            bend = bend * s + slope
            slope = slope * s + missed
            missed = missed * s + coefficient
        bend = bend * s + slope
        slope = slope * s + missed
        missed = change - missed * s
        left = within & (np.abs(missed) > ROUNDING * (0.25 * value + 8.0 * np.abs(change)))
        if not np.count_nonzero(left):
            break
        low, high = (s if missed > 0.0 else low, high if missed > 0.0 else s)
        root = np.sqrt(np.maximum(4.0 * slope * slope + 12.0 * missed * bend, 0.0))
        step = s + 3.0 * missed / (slope + root)
        step = step if (low < step) & (step < high) & (turn % 4 != 3) else 0.5 * (low + high)
        s = step if left else s
    return s
