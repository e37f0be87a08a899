"""What a contact gains while it grows from c to a: integrals of g'(t) t**order/sqrt(t**2 - r**2).

The depth is the one of order 1 with r = 0, the force 2 E* times that of order 2, and
the pressure at r < c is E*/pi times that of order 0.  The path is counted from c in
the variable of `_integrals` that keeps all singularities pi/2 away, whose length is a
logarithm free of differences; `close` tells where the integral is wanted.
"""

from __future__ import annotations

import numpy as np

from ._elementwise import Array
from ._integrals import WAVES, Slope, Strip, difference_root, in_groups, integral_in_strip

LONGEST = 256.0
"""Waves between c and a beyond which they are left to the difference."""


@in_groups
def growth(slope: Slope, order: int, r: Array, c: Array, a: Array, close: Array) -> Strip:
    """For g' without singularities near the real axis, or with those on the imaginary axis only."""
    root = difference_root(c, r)
    stop = np.log1p(((a - c) + _gap(a, c, difference_root(a, r), root)) / (c + root))

    def integrand(v: Array) -> Array:
        t = c * np.cosh(v) + root * np.sinh(v)
        return slope(t) * t**order

    return integrand, np.where(close & (a > c), stop, 0.0), 1.0, close & (a > c), 0.0


@in_groups
def growth_beyond(slope: Slope, order: int, r: Array, c: Array, a: Array, b: Array, close: Array) -> Strip:
    """From max(b, c) on; `slope` takes t and sqrt(t**2 - b**2)."""
    start = np.maximum(b, c)
    beyond, root = difference_root(start, b), difference_root(start, r)
    gaps = _gap(a, start, difference_root(a, b), beyond) + _gap(a, start, difference_root(a, r), root)
    holds = close & (a > start)

    def integrand(v: Array) -> Array:
        # beyond**2 and root**2 differ by a constant: they are a cosh and a sinh of v, in either order
        side = beyond * np.cosh(v) + root * np.sinh(v)
        t = np.sqrt(b * b + side * side)
        return slope(t, side) * (side / t) * t**order

    return integrand, np.where(holds, np.log1p(gaps / (beyond + root)), 0.0), 1.0, holds, 0.0


@in_groups
def growth_below(slope: Slope, order: int, r: Array, c: Array, a: Array, R: Array, close: Array) -> Strip:
    """For g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale, root, below = difference_root(R, r), difference_root(c, r), difference_root(R, c)
    outer, last = difference_root(a, r), difference_root(R, a)
    ratio = 2.0 * scale * _gap(a, c, outer, root) / last * ((scale + outer) / (scale + root)) / last
    holds = close & (a > c)

    def integrand(v: Array) -> Array:
        even, odd = np.cosh(v), np.sinh(v)
        secant = scale * even + root * odd
        u, side = scale * (root * even + scale * odd) / secant, scale * below / secant
        t = np.sqrt(r * r + u * u)
        return slope(t, side) * (side / scale) * (side / t) * t**order

    return integrand, np.where(holds, 0.5 * np.log1p(ratio), 0.0), 1.0, holds, 0.0


def growth_waves(
    slope: Slope, parameters: tuple[Array, ...], order: int, r: Array, c: Array, a: Array, wavelength: Array,
    close: Array,
) -> Array:  # fmt: skip
    """For g' that oscillates with a wavelength."""
    root = difference_root(c, r)
    gap = _gap(a, c, difference_root(a, r), root)
    holds = close & (a > c) & (gap < LONGEST * wavelength)

    def integrand(u: Array) -> Array:
        t = np.sqrt(r * r + (root + u) ** 2)
        return slope(t, *parameters) * t ** (order - 1)

    return integral_in_strip(integrand, np.where(holds, gap, 0.0), wavelength, WAVES)


def _gap(a: Array, c: Array, outer: Array, inner: Array) -> Array:
    """outer - inner, their squares being a**2 and c**2 less the same number."""
    return np.where(a > c, (a - c) * (a + c) / (outer + inner), 0.0)
