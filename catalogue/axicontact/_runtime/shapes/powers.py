"""Integrals over the growth of a power-law contact, g(t) ~ t**n with any real n > 0.

With t**2 falling as exp(-2 s**2) from its upper end every integrand is positive
and smooth; its nearest singularity is at abs(s) = sqrt(pi).
"""

from __future__ import annotations

import numpy as np

from ..integrals import Course, at_many_radii, integral, integral_by_length, of_displacement
from ..interface import Array

NODES = 64
LENGTHS = ((16.0, NODES), (np.inf, 2 * NODES))
"""Nodes by the length of the interval, which for exponents near 1 grows with the logarithm of r/a."""
STEEP = 6.0
"""Exponents from here on bend the pressure too much for a panel of `integrals.along`."""
_DECAY = 42.0
"""exp(-42) = 6e-19: what is left of a power beyond it does not count."""


def of_pressure(a: float, n: float) -> tuple[Course | None, float, float]:
    """Up to the axis, for powers that panels resolve."""
    return (Course(0.0, a * a, True, a) if n < STEEP else None), 0.0, a


@at_many_radii(of_pressure)
def power_pressure(r: Array, a: Array, n: Array) -> Array:
    """Integral of t**(n - 1)/sqrt(t**2 - r**2) dt from r to a, over a**(n - 1)."""
    centre = np.where(n > 1.0, 1.0 / np.abs(n - 1.0), np.inf)
    largest = np.where(n > 1.0, 1.0, (r / a) ** n * (a / r))
    return np.where(r > 0.0, largest * _fallen_pressure(_log_ratio(a, r), n), centre)


def _fallen_pressure(depth: Array, n: Array) -> Array:
    """The same over the larger end of t**(n - 1), for r = a exp(-depth)."""
    steep, rate = n > 1.0, np.abs(n - 1.0)
    cut = np.maximum(depth - _DECAY / np.maximum(rate, 1e-3), 0.0)
    stop = np.sqrt(depth)

    def integrand(step: Array) -> Array:
        # counted from the end where the power is largest, so that the difference to it is exact
        fall = np.where(steep, step * (2.0 * stop - step), step * step)
        return np.exp(-rate * fall) * _weight(np.where(steep, np.maximum(stop - step, 0.0), step))

    reach = np.where(steep, stop - np.sqrt(cut), np.sqrt(depth - cut))
    # at the edge, where nothing is left of the path, the weight has but a limit
    return np.where(depth > 0.0, integral_by_length(integrand, reach, lengths=LENGTHS), 0.0)


@at_many_radii(of_displacement)
def power_displacement(r: Array, a: Array, n: Array) -> Array:
    """Integral of n t**(n - 1) arcsin(t/r) dt from 0 to a < r, over a**n."""
    start, reach = _span(r, a, n)

    def integrand(step: Array) -> Array:
        s = start + step
        fall = step * (2.0 * start + step)
        ratio = a / r * np.exp(-fall)
        return np.arctan2(ratio, np.sqrt(-np.expm1(-2.0 * s * s))) * np.exp(-n * fall) * 2.0 * s

    return np.where(a > 0.0, n * integral(integrand, reach, NODES), 0.0)


@at_many_radii(of_displacement)
def power_punches(r: Array, a: Array, n: Array) -> Array:
    """Integral of t**n/sqrt(r**2 - t**2) dt from 0 to a < r, over a**n."""
    start, reach = _span(r, a, n)

    def integrand(step: Array) -> Array:
        s = start + step
        return np.exp(-(n + 1.0) * step * (2.0 * start + step)) * _weight(s)

    return a / r * integral(integrand, reach, NODES)


def power_strips(x: Array, a: Array, n: Array) -> Array:
    """Integral of n t**(n - 1)/sqrt(x**2 - t**2) dt from 0 to a < x, over a**n; 1/x is taken out for small n."""
    start = np.sqrt(_log_ratio(x, a))
    fall = _DECAY / (n + 2.0)

    def integrand(step: Array) -> Array:
        s = start + step
        root = np.sqrt(-np.expm1(-2.0 * s * s))
        return np.exp(-(n + 2.0) * step * (2.0 * start + step)) * _weight(s) / (1.0 + root)

    reach = fall / (np.sqrt(start * start + fall) + start)
    return np.where(a > 0.0, 1.0 + n * (a / x) ** 2 * integral(integrand, reach, NODES), 1.0) / x


def _weight(s: Array) -> Array:
    """2 s/sqrt(1 - exp(-2 s**2)), for s > 0."""
    return 2.0 * s / np.sqrt(-np.expm1(-2.0 * s * s))


def _log_ratio(x: Array, y: Array) -> Array:
    """ln(x/y) for x >= y; the quotient overflows where y is subnormal."""
    excess = (x - y) / y
    return np.where(np.isfinite(excess), np.log1p(excess), np.log(x) - np.log(y))


def _span(r: Array, a: Array, n: Array) -> tuple[Array, Array]:
    start = np.sqrt(_log_ratio(r, a))
    fall = _DECAY / (n + 1.0)
    return start, fall / (np.sqrt(start * start + fall) + start)
