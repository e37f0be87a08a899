"""Adhesive contact by the rule of Hess: the contact without adhesion less a flat punch moved by the retraction.

At pull-off the force (xi = 3) or the depth (xi = 1) is stationary in the contact
radius, and the retraction is 2 a g'(a)/xi with the depth g(a) without adhesion.

Where the load is no power of the radius it has stable branches: it grows with the
contact radius where sqrt(a) g'(a) exceeds a level; the sign is read on a grid, and each
change is refined.  A jump of g' at a corner of the profile is a change of sign like any other.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..integrals import difference_root, integral
from ..interface import Array, Result
from ..inverse import inverse

XI = {"force": 3.0, "depth": 1.0}
"""The retraction at pull-off is 2 a g'(a)/xi, by what is held."""
ROUNDING = 1e-15
"""A load this close below pull-off, relative to it, counts as pull-off."""


class PullOff(NamedTuple):
    """The state at which the contact breaks."""

    radius: Result
    force: Result
    depth: Result


def require_control(control: str) -> str:
    if control not in XI:
        message = f"control = {control!r} must be 'force' or 'depth': what is held while the contact is unloaded"
        raise ValueError(message)
    return control


def hess_retraction(a: Array, E_star: Array, dgamma: Array) -> Array:
    """sqrt(2 pi a dgamma/E_star); a root per factor, since the product may underflow."""
    return np.sqrt(a) * np.sqrt(2.0 * np.pi * dgamma / E_star)


def pull(a: Array, E_star: Array, dgamma: Array) -> Array:
    """Force of the flat punch moved by the retraction."""
    return 2.0 * E_star * a * hess_retraction(a, E_star, dgamma)


def tension(r: Array, a: Array, E_star: Array, dgamma: Array) -> Array:
    """Its pressure: infinite at the edge, zero outside."""
    moved = hess_retraction(a, E_star, dgamma)
    inside = np.where(moved > 0.0, E_star * moved / (np.pi * difference_root(a, r)), 0.0)
    return np.where(r <= a, inside, 0.0)


def lift(r: Array, a: Array, E_star: Array, dgamma: Array) -> Array:
    """Its surface displacement."""
    share = np.where(r > a, 2.0 / np.pi * np.arctan2(a, difference_root(r, a)), 1.0)
    return hess_retraction(a, E_star, dgamma) * share


def power_law_radius(value: Array, a_c: Array, least: Array, p: Array, q: float, plain: Array) -> Array:
    """Stable radius where the load is A a**p - B a**q, with its minimum `least` at a_c.

    In v = (a/a_c)**q all of them are one curve, 1 + value/abs(least) = (v**m - m v)/(m - 1) + 1 with m = p/q.
    `plain` is the radius without adhesion, which remains where the pull is nothing to the load.
    """
    m = p / q + np.zeros_like(value)
    e = np.where(least < 0.0, 1.0 - value / np.where(least < 0.0, least, -1.0), np.inf)
    e = np.where(np.abs(e) < ROUNDING, 0.0, e)
    s = _growth(np.where(e > 0.0, e, 1.0), m)
    a = a_c * (1.0 + np.where(e == 0.0, 0.0, s)) ** (1.0 / q)
    return np.where(e < 0.0, np.nan, np.where(np.isfinite(e), a, np.where(value >= 0.0, plain, np.nan)))


def _growth(e: Array, m: Array) -> Array:
    """The s > 0 at which ((1 + s)**m - 1 - m s)/(m - 1) = e, for m > 1."""

    def curve(s: Array) -> tuple[Array, Array]:
        log = np.log1p(s)
        # the rounding of a logarithm of 60 would be felt in its exponential
        more = np.where((s > 1.0) & ((m - 1.0) * log > 1.0), (1.0 + s) ** (m - 1.0) - 1.0, np.expm1((m - 1.0) * log))
        rate = m * more / (m - 1.0)
        value = np.where(np.minimum(s, 4.0) * np.maximum(m, 2.0) < 4.0, near(s), (1.0 + s) * rate / m - s)
        return value, s * rate / value

    def near(s: Array) -> Array:
        # an integral of positive terms, up to where the difference is a third of its own; at s = 1/2 it is an eighth
        s = np.minimum(s, 2.0)
        return m * s * s * integral(lambda y: (1.0 - y) * np.exp((m - 2.0) * np.log1p(s * y)), np.ones_like(s), 16)

    # (1 + s)**m = 1 + (m - 1) e + m s, twice with the last s on the right
    far = 0.0
    for _ in range(3):
        far = np.expm1(np.log1p((m - 1.0) * e + m * far) / m)
    start = np.where(e * m < 1.0, np.sqrt(2.0 * e / m), far)
    return inverse(curve, e, start, (np.minimum(m, 2.0), np.maximum(m, 2.0)))


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
