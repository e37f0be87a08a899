"""Pressure on the graded half-space: integral of g'(t) (t**2 - r**2)**((k - 1)/2) over the growth from r to a.

`slope` gives g'(t).  The pressure is H/pi times this integral.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from ._elementwise import Array
from ._graded_breaks import past_tip, rounded_rate, rounding_rate, tipped_rate
from ._graded_growth import axis_power, gaussian_rate, hyperboloid_rate, power_factor, sphere_rate
from ._graded_paths import (
    growth_beyond,
    growth_beyond_cap,
    growth_far,
    growth_from_break,
    sinh_growth,
    smooth_growth,
    tanh_growth,
    wavy_growth,
)
from ._graded_rules import NODES, raised, sine_integral, weighted
from ._graded_waves import waves_rate
from ._integrals import difference_root, integral

_TERMS = 22
_EVEN = 16
"""Even powers up to this one are closed; of higher ones the rule takes fewer steps."""


def power_pressure(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral for f = r**n."""
    return power_factor(n, k) * n * (a**n / a * a**k) * power_growth(r, a, n, k)


def flank_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = 1 beyond b."""

    def slope(t: Array, root: Array) -> Array:
        return _tame(t, root, k) * sine_integral(np.arctan2(root, b), k) + b / t

    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def rim_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r beyond b."""

    def slope(t: Array, root: Array) -> Array:
        return t * ((1.0 - k) / (1.0 + k) * (root / t) ** 2 + 1.0)

    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def rounding_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r - b beyond b."""
    return growth_beyond(_rounding(b, k), r, a, b, k, 2.0)


def _rounding(b: Array, k: Array) -> Callable[[Array, Array], Array]:
    return lambda t, root: _tame(t, root, k) * rounding_rate(t, root, b, k)


def rounded_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r/b up to b, 1 beyond."""
    tip = np.where(r < b, power_pressure(np.minimum(r, b), np.minimum(a, b), 2.0, k) / (2.0 * b), 0.0)
    value = tip + growth_beyond_cap(lambda t, root: rounded_rate(t, root, b, k), r, a, b, k)
    at = (r == b) & (a > b)
    return np.where(at, _rounded_at(np.where(at, a, 2.0 * b), b, k), value) if at.any() else value


def _rounded_at(a: Array, b: Array, k: Array) -> Array:
    """The same for r = b, next to which the slope is that of the parabola less that of a rounding: two powers."""
    reach = difference_root(a, b)
    turn = np.minimum(reach, b)
    near = 2.0 * raised(turn, k) / (1.0 + k) ** 2 - growth_from_break(_rounding(b, k), turn, b, k, 2.0)
    return near / b + growth_far(lambda y, t: y**k * rounded_rate(t, y, b, k), turn, reach, b)


def sphere_pressure(r: Array, a: Array, R: Array, k: Array) -> Array:
    """The integral for a sphere of unit height over radius."""
    return _sphere(r, R, difference_root(a, r), difference_root(R, a), k)


def _sphere(r: Array, R: Array, reach: Array, end: Array, k: Array) -> Array:
    return tanh_growth(lambda t, root: sphere_rate(t, root, k), r, R, reach, end, k)


def tipped_pressure(r: Array, a: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    """The integral for a sphere up to b, continued by its tangent cone."""
    past = partial(past_tip, R=R, b=b, end=end)
    within, whole = past(r) < 0.0, past(a) >= 0.0
    reach = np.where(whole, np.sqrt(np.maximum(-past(r), 0.0) * (b + r)), difference_root(a, r))
    tip = _sphere(np.minimum(r, b), R, reach, np.where(whole, end, difference_root(R, a)), k)
    beyond = growth_beyond_cap(lambda t, root: tipped_rate(t, root, R, b, end, k), r, a, b, k, past, end)
    return np.where(within, tip, 0.0) + beyond


def hyperboloid_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f = sqrt(r**2 + b**2) - b."""
    return sinh_growth(lambda t: hyperboloid_rate(t, b, k), r, a, b, k)


def gaussian_pressure(r: Array, a: Array, s: Array, k: Array) -> Array:
    """The integral for f = 1 - exp(-r**2/s**2)."""
    return smooth_growth(lambda t: gaussian_rate(t, s, k), r, a, k)


def waves_pressure(r: Array, a: Array, q: Array, k: Array) -> Array:
    """The integral for f = 1 - cos(q r)."""
    return wavy_growth(lambda t: waves_rate(t, q, k), r, a, 2.0 * np.pi / q, k)


def _cornered(value: Array, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The pressure at a corner, which is finite for k > 0 only."""
    return np.where((r == b) & (a > b) & (k <= 0.0), np.inf, value)


def _tame(t: Array, root: Array, k: Array) -> Array:
    return (root / t) ** (1.0 - k)


def power_growth(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral for g'(t) = t**(n - 1), over a**(n + k - 1)."""
    if isinstance(n, int | float) and n % 2.0 == 0.0 and n <= _EVEN:
        return _even_growth(r, a, int(n), k)
    m = axis_power(n, k)
    length = np.log1p((a - r) / r)
    length = np.where(np.isfinite(length), length, np.log(a) - np.log(r))
    near = np.minimum(np.minimum(length, 1.0), 20.0 / np.maximum(np.abs(m), 1e-300))
    half, above = (k - 1.0) / 2.0, (k + 1.0) / 2.0

    def smooth(x: Array) -> Array:
        shrink = np.where(x > 0.0, -np.expm1(-2.0 * x) / np.where(x > 0.0, x, 1.0), 2.0)
        return shrink**half * np.exp(-m * (near - x))

    rest = length - near
    place = np.minimum(r / a * np.exp(near), 1.0)
    far = place**n / place * place**k
    first = np.where(rest > 0.0, far, 1.0) * near**above
    first = first * weighted(smooth, near, half, above=above)
    total = first + np.where(np.abs(m) > 20.0, _steep(rest, near, m, half), _tail(rest, near, m, half, far))
    return np.where(r > 0.0, total, np.where(m > 0.0, 1.0 / np.where(m > 0.0, m, 1.0), np.inf))


def _even_growth(r: Array, a: Array, n: int, k: Array) -> Array:
    """By parts in t**2 - r**2: every step adds what is positive."""
    half, square = (1.0 + k) / 2.0, (r / a) ** 2
    total = 0.5 / half
    for j in range(1, n // 2):
        total = (0.5 + j * square * total) / (j + half)
    # 1 + k is rounded: next to the edge its power would be wrong by 10 units
    share = (a - r) / a * ((a + r) / a)
    return np.sqrt(share) * share ** (k / 2.0) * total


def _tail(rest: Array, near: Array, m: Array, half: Array, far: Array) -> Array:
    """What lies beyond ln(t/r) = `near` = 1: the binomial series in exp(-2 x), whose terms are positive.

    `far` is exp(-m rest), where the logarithm of a ratio far from 1 would cost its number of digits.
    """
    rest = np.where(np.isfinite(rest), rest, 0.0)
    factor, total = np.ones_like(rest + half), np.zeros_like(rest + half)
    for j in range(_TERMS):
        rate = m - 2.0 * j
        span = np.where(rate == 0.0, rest, -np.expm1(-np.abs(rate) * rest) / np.where(rate == 0.0, 1.0, np.abs(rate)))
        level = np.where(rate > 0.0, np.exp(-2.0 * j * (near + rest)), np.exp(-2.0 * j * near) * far)
        total = total + factor * span * level
        factor = factor * (j - half) / (j + 1.0)
    return total


def _steep(rest: Array, near: Array, m: Array, half: Array) -> Array:
    """What lies beyond ln(t/r) = `near`, for a large power m, of which only the upper end counts."""
    rest = np.where(np.isfinite(rest), rest, np.inf)
    stop = np.minimum(rest, 42.0 / np.maximum(np.abs(m), 20.0))

    def integrand(y: Array) -> Array:
        return np.exp(-m * y) * (-np.expm1(-2.0 * (near + (rest - y)))) ** half

    return integral(integrand, stop, NODES)
