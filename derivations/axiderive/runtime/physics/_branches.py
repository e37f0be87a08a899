"""Stable branches of an adhesive contact whose load is no power of the radius.

The load grows with the contact radius where sqrt(a) g'(a) exceeds a level; its
sign is read on a grid, and each change is refined.  A jump of g' at a corner of
the profile is a change of sign like any other.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ._adhesion import XI
from ._elementwise import Array

Load = Callable[[Array], Array]


class Branches(NamedTuple):
    """Ends of the stable branches along a first axis, in ascending order; NaN where there are fewer."""

    first: Array
    last: Array


def branches(rate: Load, radii: Array, high: Array | float, control: str, E_star: Array, dgamma: Array) -> Branches:
    """The branches on which the force or the depth grows with a; `radii` is a grid from the least radius on."""
    level = XI[control] * np.sqrt(np.pi * dgamma / (2.0 * E_star))

    def balance(a: Array) -> Array:
        return np.sqrt(a) * rate(a) - level

    grid = radii + np.zeros(np.broadcast_shapes(np.shape(level), radii.shape[1:]))
    rises = balance(grid) >= 0.0
    # a load that grows from the least radius on has its minimum there
    starts = np.concatenate([rises[:1], rises[1:] & ~rises[:-1]])
    ends = np.concatenate([np.zeros_like(rises[:1]), ~rises[1:] & rises[:-1]])
    below = np.concatenate([grid[:1], grid[:-1]])
    first, last = (_changes(balance, mask, below, grid, sign) for mask, sign in ((starts, 1.0), (ends, -1.0)))
    # where g' is infinite the load may be too
    first = np.minimum(first, np.nextafter(grid[-1], 0.0))
    missing = np.full((max(0, len(first) - len(last)), *last.shape[1:]), np.nan)
    last = np.concatenate([last, missing])[: len(first)]
    return Branches(first, np.where(np.isfinite(first) & np.isnan(last), high, last))


def _changes(balance: Load, mask: Array, low: Array, high: Array, sign: float) -> Array:
    count = int(mask.sum(axis=0).max(initial=0))
    order = np.argsort(~mask, axis=0, kind="stable")[:count]
    low, high, valid = (np.take_along_axis(x, order, axis=0) for x in (low, high, mask))
    for _ in range(64):
        middle = halfway(low, high)
        above = sign * balance(middle) >= 0.0
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return np.where(valid, high, np.nan)


def halfway(low: Array, high: Array) -> Array:
    """The number in the middle of all floating-point numbers between two positive ones."""
    bits = [np.ascontiguousarray(x, dtype=np.float64).view(np.int64) for x in np.broadcast_arrays(low, high)]
    return (bits[0] + (bits[1] - bits[0]) // 2).view(np.float64)


def exponent_of(x: Array) -> Array:
    """The whole m with 2**m <= x < 2**(m + 1)."""
    return np.frexp(x)[1] - 1


def lowest(found: Branches, load: Load) -> Array:
    """Radius at which the load is lowest: pull-off; NaN without a stable contact."""
    if not len(found.first):
        return np.full(found.first.shape[1:], np.nan)
    # branch by branch: the parameters of a load have the shape of one radius
    values = np.stack([load(first) for first in found.first])
    best = np.argmin(np.where(np.isnan(values), np.inf, values), axis=0)
    return np.take_along_axis(found.first, best[None], axis=0)[0]


def decades() -> Array:
    """Radii of any size, for a g' that grows with the radius."""
    return 10.0 ** np.arange(-150.0, 151.0, 10.0)[:, None]


def radii_below(high: Array) -> Array:
    """Radii up to an end at which g' is infinite."""
    return np.multiply.outer(
        np.concatenate([10.0 ** np.arange(-150.0, 0.0, 10.0), 1.0 - 0.5 ** np.arange(1.0, 53.0, 3.0), [1.0]]),
        np.atleast_1d(high),
    )


def radii_to(high: Array) -> Array:
    """Radii up to an end at which g' vanishes."""
    return np.multiply.outer(
        np.concatenate([10.0 ** np.arange(-150.0, -2.0, 10.0), np.arange(1.0, 129.0) / 128.0]), np.atleast_1d(high)
    )


def radii_beyond(b: Array) -> Array:
    """Radii from a break of the profile on: close to it, and then any."""
    t = np.concatenate([[0.0], 10.0 ** np.arange(-7.0, 3.0, 0.05), 10.0 ** np.arange(3.0, 151.0, 10.0)])
    return np.multiply.outer(np.sqrt(1.0 + t * t), np.atleast_1d(b))


def radii_around(b: Array) -> Array:
    """Radii on both sides of a break of the profile."""
    inner = np.concatenate([10.0 ** np.arange(-150.0, 0.0, 10.0), np.arange(1.0, 16.0) / 16.0])
    return np.concatenate([np.multiply.outer(inner, np.atleast_1d(b)), radii_beyond(b)])


def radii_of_waves(wavelength: Array, reach: Array) -> Array:
    """Sixteen radii in each wave, for at least four waves and at most 4096, and decades around them."""
    waves = int(np.clip(np.max(np.where(np.isfinite(reach / wavelength), reach / wavelength, 4.0)), 4.0, 4096.0))
    inner = np.concatenate([10.0 ** np.arange(-150.0, -2.0, 10.0), np.arange(1.0, 16.0 * waves + 1.0) / 16.0])
    outer = (waves + 1.0) * 10.0 ** np.arange(0.0, 100.0, 10.0)
    return np.multiply.outer(np.concatenate([inner, outer]), np.atleast_1d(wavelength))
