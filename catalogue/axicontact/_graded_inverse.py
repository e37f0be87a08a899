"""Contact radius of a depth or a force on the graded half space, in a variable of bounded logarithmic slope."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_growth import gaussian_rate
from ._inverse import inverse

Load = Callable[..., Array]
SLACK = 0.1
"""Least exponent assumed of a load that is no power: it only widens the bracket."""


def radius_to(
    load: Load, rate: Load, value: Array, start: Array, needs: tuple[Array, ...], largest: Array | float = np.inf
) -> Array:
    """The a with load(a, *needs) = value; `rate` is the derivative of the load."""

    def curve(a: Array) -> tuple[Array, Array]:
        own = load(a, *needs)
        return own, a * rate(a, *needs) / own

    value = value + np.zeros(1)
    return inverse(curve, value, start + np.zeros_like(value), (SLACK, np.inf), largest)


def radius_beyond(load: Load, rate: Load, value: Array, b: Array, needs: tuple[Array, ...]) -> Array:
    """The same for a flat face of radius b, in t = sqrt(a**2 - b**2)/b; both functions take a and that root."""

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = np.hypot(b, b * t), b * t
        own = load(a, root, *needs)
        return own, root * (root / a) * rate(a, root, *needs) / own

    value = value + np.zeros(1)
    t = inverse(curve, value, np.ones_like(value), (SLACK, np.inf))
    return np.hypot(b, b * t)


def radius_below(load: Load, rate: Load, value: Array, R: Array, needs: tuple[Array, ...]) -> Array:
    """The same for a sphere, in t = a/sqrt(R**2 - a**2); NaN where the load is beyond that of a = R."""

    def place(t: Array) -> tuple[Array, Array]:
        root = R / np.hypot(1.0, t)
        return root * t, root

    def curve(t: Array) -> tuple[Array, Array]:
        a, root = place(t)
        own = load(a, root, *needs)
        return own, a * (root / R) ** 2 * rate(a, root, *needs) / own

    value = value + np.zeros(1)
    steepest = 1e8 * np.ones_like(value)
    t = inverse(curve, value, np.ones_like(value), (SLACK, np.inf), steepest)
    return np.where(value <= load(*place(steepest), *needs), place(t)[0], np.nan)


def gaussian_reach(s: Array, k: Array) -> Array:
    """The radius of largest depth of a Gaussian bump, where the contact ceases to be compact."""
    low, high = np.ones_like(s + k), 8.0 * np.ones_like(s + k)
    for _ in range(60):
        middle = (low + high) / 2.0
        # with the s of the caller: the rate at the radius returned must not round to less than zero
        rises = gaussian_rate(s * middle, s, k) >= 0.0
        low, high = np.where(rises, middle, low), np.where(rises, high, middle)
    return s * low
