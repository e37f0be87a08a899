"""Stable branches of an adhesive contact whose load is no power of the radius.

The load grows with the contact radius where sqrt(a) g'(a) exceeds a level; its
sign is read on a grid, and each change is refined.  A jump of g' at a corner of
the profile is a change of sign like any other.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ._adhesion import XI, hess_retraction
from ._elementwise import Array
from ._inverse import inverse

Load = Callable[[Array], Array]
EPS = np.finfo(float).eps


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
    values = load(found.first)
    best = np.argmin(np.where(np.isnan(values), np.inf, values), axis=0)
    return np.take_along_axis(found.first, best[None], axis=0)[0]


def stable_radius(
    value: Array,
    found: Branches,
    load: Load,
    rate: Load,
    xi: float,
    E_star: Array,
    dgamma: Array,
    corner: Array | None = None,
) -> Array:
    """The largest radius of a stable contact under this load; NaN below pull-off.

    The load in excess of the least of a branch is nearly a power of t at both ends, with
    t = (a - first)/first times last/(last - a) where the branch has an end.  A `corner` of the load divides a branch.
    """
    value = np.atleast_1d(value)
    low, high, least = (np.full(np.broadcast_shapes(value.shape, found.first.shape[1:]), np.nan) for _ in range(3))
    slack = 4.0 * EPS
    for first, last in zip(found.first, found.last, strict=True):
        start = load(first)
        top = np.where(np.isfinite(last), load(last), np.inf)
        fits = (value >= start - slack * np.abs(start)) & (value <= np.where(np.isnan(top), np.inf, top))
        low, high, least = (np.where(fits, new, old) for new, old in ((first, low), (last, high), (start, least)))
    if corner is not None:
        inside, bend = (low < corner) & ~(high <= corner), load(corner + np.zeros_like(low))
        beyond = inside & (value > bend)
        high = np.where(inside & ~beyond, corner, high)
        low, least = np.where(beyond, corner, low), np.where(beyond, bend, least)
    ends = np.isfinite(high)
    share_of_last = np.where(ends, low / high, 0.0)
    # the load is a difference, known to the rounding of its parts
    parts = np.abs(value) + np.abs(least) + _scale(low, xi, E_star) * hess_retraction(low, E_star, dgamma)

    def place(t: Array) -> Array:
        return low * ((1.0 + t) / (1.0 + share_of_last * t))

    def share(t: Array) -> Array:
        return (place(t) - low) / place(t)

    def excess(t: Array) -> tuple[Array, Array]:
        a = place(t)
        own = load(a) - least
        lost = own <= EPS * parts
        more = np.where(lost, EPS * parts, own)
        step = low * t * (1.0 - share_of_last) / (1.0 + share_of_last * t) ** 2
        slope = step * growth(rate, a, xi, E_star, dgamma) / more
        # from a flat stretch, the step to a load far above would leave the range of doubles
        slope = np.where(~ends & (more < 0.5 * wanted), np.maximum(slope, 0.7), slope)
        return more, np.where(lost, 0.3, slope)

    wanted = np.where(value < np.inf, np.maximum(value - least, 0.0), 0.0)
    one = np.ones_like(low)
    # next to a least that is no corner the excess is a square
    scale = excess(one)[0]
    start = np.minimum(one, np.sqrt(wanted / scale))
    # without adhesion the least radius says nothing of the others
    start = np.where(ends & (scale <= EPS * parts), 1.0 / share_of_last, start)
    t = inverse(excess, wanted, start, (0.0, np.inf), share=share, smooth=True, noise=4.0 * EPS * parts)
    return np.where((value == np.inf) & (high == np.inf), np.inf, place(t))


def growth(rate: Load, a: Array, xi: float, E_star: Array, dgamma: Array) -> Array:
    """Derivative of the load: that of the depth, or 2 E_star a times it with the retraction weighed by xi."""
    slope = rate(a) - xi * hess_retraction(a, E_star, dgamma) / (2.0 * a)
    return slope * _scale(a, xi, E_star)


def _scale(a: Array, xi: float, E_star: Array) -> Array:
    """The load of a contact moved by a unit length: a depth, or the force of the flat punch."""
    return np.where(xi == 1.0, 1.0, 2.0 * E_star * a)


def decades() -> Array:
    """Radii of any size, for a g' that grows with the radius."""
    return 10.0 ** np.arange(-150.0, 151.0, 10.0)[:, None]


def radii_below(high: Array) -> Array:
    """Radii up to an end at which g' is infinite."""
    return np.multiply.outer(
        np.concatenate([10.0 ** np.arange(-150.0, 0.0, 10.0), 1.0 - 0.5 ** np.arange(1.0, 53.0, 3.0)]),
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
