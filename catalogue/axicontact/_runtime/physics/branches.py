"""Stable branches of an adhesive contact whose load is no power of the radius, and pull-off as the lowest of them.

The load grows with the contact radius where the steepness sqrt(a) g'(a) exceeds a level; the sign is read on a grid,
and each change is refined.  A jump of g' at a corner of the profile is a change of sign like any other.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..functions import halves
from ..interface import Array

Load = Callable[[Array], Array]
STEPS, CLOSEST, FAR = 20, 2.0**-51, 1e50
"""Steps before a bracket is halved, the shortest first step over the radius, and radii beyond the range of loads."""


class Branches(NamedTuple):
    """Ends of the stable branches along a first axis, in ascending order; NaN where there are fewer."""

    first: Array
    last: Array


class Samples(NamedTuple):
    """The steepness on a grid from the least radius on that separates the minima of the load."""

    radii: Array
    steepness: Array
    end: Array | float
    """The largest radius."""
    found: dict[float, Branches]
    """The branches of levels that are plain numbers, once they were searched for."""


def branches(steepness: Load, sampled: Samples, level: Array) -> Branches:
    """The branches on which the steepness is above the level."""
    shape = np.zeros(np.broadcast_shapes(np.shape(level), sampled.radii.shape[1:]))
    grid, known = sampled.radii + shape, sampled.steepness + shape
    rises = known >= level
    # a load that grows from the least radius on has its minimum there
    starts = np.concatenate([rises[:1], rises[1:] & ~rises[:-1]])
    ends = np.concatenate([np.zeros_like(rises[:1]), ~rises[1:] & rises[:-1]])
    above = np.log(known / level)
    first, last = (
        _changes(lambda a: np.log(steepness(a) / level), mask, grid, sign * above, sign)
        for mask, sign in ((starts, 1.0), (ends, -1.0))
    )
    # where g' is infinite the load may be too
    first = np.minimum(first, np.nextafter(grid[-1], 0.0))
    missing = np.full((max(0, len(first) - len(last)), *last.shape[1:]), np.nan)
    last = np.concatenate([last, missing])[: len(first)]
    return Branches(first, np.where(np.isfinite(first) & np.logical_not(last <= FAR), sampled.end, last))


def _changes(above: Load, mask: Array, grid: Array, known: Array, sign: float) -> Array:
    """The first radius beyond each change of sign, between neighbours of the grid.

    By the rule of false position, with half the weight for an end that stays again (Illinois), in logarithms: over
    decades the steepness is nearly a power.  A step is at least as long as to cross what is all rounding, soon.
    """
    count = int(mask.sum(axis=0).max(initial=0))
    order = np.argsort(~mask, axis=0, kind="stable")[:count]
    below = np.maximum(order - 1, 0)
    low, high, before, after = (np.take_along_axis(x, place, axis=0) for x in (grid, known) for place in (below, order))
    valid, stays = np.take_along_axis(mask, order, axis=0), np.zeros(low.shape)
    for step in range(STEPS + 64):
        if not np.count_nonzero(valid & (np.nextafter(low, high) < high)):
            break
        middle = halfway(low, high)
        if step < STEPS:
            share = before / (before - after)
            tried = low * np.exp(np.where((share >= 0.0) & (share <= 1.0), share, 0.5) * np.log(high / low))
            tried = np.clip(tried, low * (1.0 + CLOSEST * 2.0**step), high * (1.0 - CLOSEST * 2.0**step))
            middle = np.where((low < tried) & (tried < high), tried, middle)
        value = sign * above(middle)
        beyond = value >= 0.0
        before = np.where(beyond, np.where(stays > 0.0, 0.5 * before, before), value)
        after = np.where(beyond, value, np.where(stays < 0.0, 0.5 * after, after))
        low, high, stays = np.where(beyond, low, middle), np.where(beyond, middle, high), np.where(beyond, 1.0, -1.0)
    return np.where(valid, high, np.nan)


def at_the_end(load: Load, a: Array) -> Array:
    """The load at the largest radius, where it may be infinite."""
    return load(a)


def halfway(low: Array, high: Array) -> Array:
    """The number in the middle of all floating-point numbers between two positive ones."""
    bits = [np.ascontiguousarray(x, dtype=np.float64).view(np.int64) for x in np.broadcast_arrays(low, high)]
    return (bits[0] + (bits[1] - bits[0]) // 2).view(np.float64)


def exponent_of(x: Array) -> Array:
    """The whole m with 2**m <= x < 2**(m + 1)."""
    return np.frexp(x)[1] - 1


def stress_at(unit: Array, H: Array, k: Array) -> tuple[Array, Array]:
    """The exponent of the power of two near H L**k for L = 2**unit, and H in units of that stress and of L."""
    mantissa, exponent = np.frexp(H)
    # half of the digits of k make an exact product with a whole number
    high, low = halves(k)
    whole = np.floor(unit * high + 0.5)
    return exponent + exponent_of(np.exp2(whole)), mantissa * np.exp2((unit * high - whole) + unit * low)


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
