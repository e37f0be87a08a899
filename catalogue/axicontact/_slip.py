"""Partial slip in the Cattaneo-Mindlin approximation: mu times the difference of two normal contacts.

Where the radii a and c are close, the difference is the integral over the growth from c to a.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._integrals import difference_root, integral

CLOSE, NODES = 0.75, 32
Slope = Callable[[Array], Array]


def force_gain(slope: Slope, c: Array, a: Array) -> Array:
    """Integral of t g'(t) from c to a, for g' without singularities near."""
    return integral(lambda x: (c + x) * slope(c + x), a - c, NODES)


def depth_gain(slope: Slope, c: Array, a: Array) -> Array:
    """Integral of g'(t) from c to a."""
    return integral(lambda x: slope(c + x), a - c, NODES)


def pressure_gain(slope: Slope, r: Array, c: Array, a: Array) -> Array:
    """Integral of g'(t)/sqrt(t**2 - r**2) from c to a, for r < c."""
    inner, outer = difference_root(c, r), difference_root(a, r)
    reach = (a - c) * (a + c) / (inner + outer)

    def integrand(x: Array) -> Array:
        t = np.sqrt(r * r + (inner + x) ** 2)
        return slope(t) / t

    # on the axis t = c exp(x), since the integrand is steep where c is small
    centre = integral(lambda x: slope(c * np.exp(x)), np.log(a / c), NODES)
    return np.where(r == 0.0, centre, integral(integrand, reach, NODES))


def difference(outer: Array, inner: Array, gain: Array, c: Array, a: Array) -> Array:
    """outer - inner, or the integral over the growth where c is close to a or both are infinite."""
    valid = ~(np.isnan(outer) | np.isnan(inner))
    return np.where(valid & ((c > CLOSE * a) | np.isinf(inner)), gain, outer - inner)


def stick_force(F: Array, F_x: Array, mu: Array) -> Array:
    """The normal force of the stick zone, F - F_x/mu; NaN beyond full slip."""
    rest = F - F_x / mu
    rest = np.where(np.abs(rest) <= 2e-16 * F, 0.0, rest)
    return np.where(rest >= 0.0, rest, np.nan)
