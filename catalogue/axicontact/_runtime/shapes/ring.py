"""Where the pressure under a concave face h (r/a)**n vanishes first on unloading, at any exponent k of grading.

There the pressure and its slope are zero.  With R = (a/r_0)**2 - 1 and b = (1 + k)/2 this is, by parts,
b (1 - b) times the integral of s**(b - 2) (1 - s) ((1 + R s)**(n/2 - 1) - 1) over 0 < s < 1 being one: a sum
of positive terms that grows with R.  Its logarithm is nearly linear in L = ln(a/r_0) = ln(1 + R)/2.

Beyond these, the ring of greatest pressure under A r**n.  With r_max = a/cosh(U) its equation is a balance again, of
(n - 2) tanh(U) times the integral of (cosh(u)/cosh(U))**(n - 3) over 0 < u < U and one.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..integrals import integral_by_length
from ..interface import Array

STEPS = 5
"""Steps of Newton: the start is off by 2 % for k = 0; four leave 1e-12 up to k = 0.95, and n above 2.3."""
LENGTHS = ((3.0, 32), (20.0, 64), (np.inf, 128))
"""Values of (n - 1) L and the nodes that leave the last digit."""
GONE = 300.0
"""exp(-2 GONE) is nothing beside 1, and still a double."""


def ring_of_zero_pressure(n: Array, k: Array = 0.0) -> Array:
    """r_0/a; 0 for n <= 2, the centre."""
    return np.where(n > 2.0, np.exp(-_log_ratio(n, k)), 0.0)


def outside_zero_pressure(n: Array, k: Array = 0.0) -> Array:
    """1 - (r_0/a)**2, to the last digits where the ring is next to the edge."""
    return np.where(n > 2.0, -np.expm1(-2.0 * _log_ratio(n, k)), 1.0)


def lifted_at_zero_pressure(n: Array, k: Array) -> Array:
    """n (1 - (r_0/a)**2) - 1 + k, what the depth of a hollow is divided by; next to k = -1 all of that cancels.

    It is n (1 + k)/((n - 2) F) with the hypergeometric F(2 - n/2, 1; (3 + k)/2; 1 - (r_0/a)**2).
    """
    half, length, steep = (1.0 + k) / 2.0, _log_ratio(n, k), (n - 3.0) + k
    z = -np.expm1(-2.0 * length)

    def integrand(y: Array) -> Array:
        return np.exp(-steep * length * (1.0 - y)) * (-np.expm1(-2.0 * length * y) / z) ** half

    series = 1.0 - (n - 4.0) * length * _integral(integrand, (n - 1.0) * length)
    return np.where(n > 2.0, n * (1.0 + k) / ((n - 2.0) * series), (n - 1.0) + k)


def _log_ratio(n: Array, k: Array) -> Array:
    """ln(a/r_0) for n > 2, by Newton's method for the logarithm of the balance."""
    n = np.where(n > 2.0, n, 3.0)
    length = _start(n - 2.0, k)
    for _ in range(STEPS):
        z, square = -np.expm1(-2.0 * length), np.exp(-2.0 * np.minimum(length, GONE))
        # at the root above 1 + k, where next to k = -1 the difference is lost
        lifted = np.maximum((n - 1.0) + k - n * square, 1.0 + k)
        value = _balance(length, n - 2.0, k)
        # the integral obeys a linear equation in L of first order
        slope = (1.0 - k) * (1.0 + k) * np.exp((n - 2.0) * length) / (z * lifted)
        slope = slope + (value - 1.0) * (2.0 * ((n - 1.0) + k) / lifted - (1.0 + k) / z)
        length = length - np.log(value) * value / slope
    return length


def _balance(length: Array, m: Array, k: Array) -> Array:
    """The integral as a function of L for m = n - 2, over y with 1 + R s = exp(2 L y)."""
    z = -np.expm1(-2.0 * length)

    def integrand(y: Array) -> Array:
        inner, outer = -np.expm1(-2.0 * length * y), -np.expm1(-2.0 * length * (1.0 - y))
        risen = np.expm1(m * length * y)
        # by parts once more: the power of s at its lower end is then above zero for all k
        rest = risen - 0.5 * m * (risen + 1.0) * inner * (outer / z)
        return np.exp((1.0 - k) * length * (1.0 - y)) * (inner / z) ** ((k - 1.0) / 2.0) * rest / inner

    return (1.0 - k) * length * _integral(integrand, (m + 1.0) * length)


def _integral(integrand: Callable[[Array], Array], length: Array) -> Array:
    """Over 0 < y < 1, for a power of y above zero at its lower end: in the eighth root of y."""

    def rooted(x: Array) -> Array:
        power = x**2 * x
        power = power * power * x
        return 8.0 * power * integrand(power * x)

    return integral_by_length(rooted, np.ones_like(length), 1.0 / length, LENGTHS)


def _start(m: Array, k: Array) -> Array:
    """(a/r_0)**(1 - k) as 1 + c/m: right for small m, for m = 2, and at both ends of k."""
    small = 4.0 / np.pi * np.sin(np.pi / 2.0 * (1.0 - k)) / (1.0 + k)
    middle = 2.0 * np.expm1(-0.5 * (1.0 - k) * np.log((1.0 - k) / 4.0))
    bend = 0.36 + 0.4 * k
    c = small + (middle - small) * (1.0 + bend) * m / (m + 2.0 * np.maximum(bend, 0.0))
    length = np.log1p(c / m) / (1.0 - k)
    # next to k = 1 the other power of a/r_0 is the larger one
    return np.where(m < 2.0, np.maximum(length, np.log(m * (m + 2.0) / (2.0 * (1.0 - k))) / m), length)


def ring_of_greatest_pressure(n: Array) -> Array:
    """r_max/a under a power law; 0 for n <= 2, the axis."""
    return np.where(n > 2.0, 1.0 / np.hypot(1.0, _slope_of_peak(n)), 0.0)


def rise_to_greatest_pressure(n: Array) -> Array:
    """1/sqrt(1 - (r_max/a)**2): the greatest pressure over that of a ring on the axis."""
    return np.where(n > 2.0, np.hypot(1.0, 1.0 / _slope_of_peak(n)), 1.0)


PEAK_STEPS = 5
"""From a start that is off by 4 %; four leave 1e-14."""
PEAK_LENGTHS = ((1.5, 32), (8.0, 64), (np.inf, 128))
"""Lengths of the interval of u, and the nodes that leave the last digit."""


def _slope_of_peak(n: Array) -> Array:
    """sinh(U) = sqrt((a/r_max)**2 - 1) for n > 2; where the balance is one it grows as sinh(U), so this is Newton's."""
    m = np.where(n > 2.0, n, 3.0) - 2.0
    # right next to m = 0, and 1.307/sqrt(m) for large m
    slope = 2.0 / (np.pi * m) * np.sqrt(1.0 + 4.215 * m)
    for _ in range(PEAK_STEPS):
        slope = np.hypot(1.0, slope) / (m * _risen(slope, m - 1.0))
    return slope


def _risen(slope: Array, power: Array) -> Array:
    """The integral of (cosh(u)/cosh(U))**power over 0 < u < U for the slope sinh(U)."""
    end = slope * slope

    def integrand(u: Array) -> Array:
        here = np.sinh(u) ** 2
        fallen = (end - here) / (1.0 + end)
        squared = np.where(fallen < 0.5, np.log1p(-np.minimum(fallen, 0.5)), np.log((1.0 + here) / (1.0 + end)))
        return np.exp(0.5 * power * squared)

    return integral_by_length(integrand, np.arcsinh(slope), lengths=PEAK_LENGTHS)
