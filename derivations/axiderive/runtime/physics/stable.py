"""The stable radius under a load: on its branch, in an unknown in which the excess over the least load is a power."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..interface import Array
from ..inverse import inverse
from .adhesion import XI, hess_retraction
from .branches import Branches, Load, at_the_end
from .unknowns import Unknown

EPS = np.finfo(float).eps
NOISE = 2.0 * EPS
"""Of a load, over its parts."""
SLACK, LOST = 1e-6, 0.3
"""The first so that a bracket spans all doubles, but where the load is met to a thousandth.

The second is the slope of what is all rounding.
"""


def stable_radius(
    value: Array,
    found: Branches,
    load: Load,
    slope_of: Load,
    pulled: Load,
    inner: Unknown,
    outer: Unknown | None = None,
    corner: Array | None = None,
) -> Array:
    """The largest radius of a stable contact under this load; NaN below pull-off.

    `slope_of` is the derivative of the load, `pulled` the part of it by adhesion.
    A `corner` of the load divides a branch; the unknown is that of `inner` below it and that of `outer` beyond,
    counted from the start of the branch.  The load in excess of the least of a branch, over what it is short of
    the largest where the branch ends, grows from nothing to infinity, as a power at both ends.
    No exponent is assumed: the bracket of the root spans all doubles, and each evaluation cuts it.
    """
    low, high, least, top = _branch_of(value, found, load, pulled)
    if not np.count_nonzero(np.isfinite(least)):
        return least
    beyond = np.full_like(low, corner is None and outer is not None, dtype=bool)
    if corner is not None:
        low, high, least, top, beyond = _divided(value, low, high, least, top, load, corner)
    ends = np.isfinite(top)
    if outer is None and np.any(ends):
        # where the load ends steeply the unknown does so too
        ends = ends & (slope_of(high) < np.inf)
    first, reach, largest, place = _counted(low, np.where(ends, high, np.inf), beyond, inner, outer)
    # the load is a difference, known to the rounding of its parts
    fixed = np.abs(least) + pulled(low)
    parts = fixed + np.abs(value)
    least_short = 4.0 * NOISE * parts

    def excess(t: Array) -> tuple[Array, Array]:
        a, step = place(t)
        own = load(a)
        more, short = own - least, np.where(ends, np.maximum(top - own, least_short), 1.0)
        known = EPS * (fixed + np.abs(own))
        lost = more <= known
        more = np.where(lost, known, more)
        slope = t * step * slope_of(a) * (1.0 / more + np.where(ends, 1.0 / short, 0.0))
        more = more / short
        # from a flat stretch, the step to a load far above would leave the range of doubles
        slope = np.where(np.logical_not(ends) & (more < 0.5 * wanted), np.maximum(slope, 0.7), slope)
        return more, np.where(lost, LOST, slope)

    def share(t: Array) -> Array:
        a, step = place(t)
        return t * step / a

    short = np.where(ends, np.maximum(top - value, least_short), 1.0)
    wanted = np.where(value < np.inf, np.maximum(value - least, 0.0) / short, 0.0)
    far = ends & (wanted > 1.0)
    order, least_unit = (
        getattr(inner, name) if outer is None else np.where(beyond, getattr(outer, name), getattr(inner, name))
        for name in ("order", "unit")
    )
    unit = np.where(far, reach, np.minimum(np.maximum(first, least_unit), largest))
    scale, slope = excess(unit)
    # next to the least the excess is a square, next to a corner at most a cube, far away at most a fourth power
    ratio = wanted / scale
    start = unit * ratio ** (1.0 / np.where((ratio > 1.0) & np.logical_not(far), 4.0, order))
    # without adhesion the least radius says nothing of the others
    start = np.where(ends & (slope == LOST), reach, start)
    noise = NOISE * parts * np.where(ends, (1.0 + wanted) / short, 1.0)
    t = inverse(excess, wanted, start, (SLACK, np.inf), largest, share, smooth=True, noise=noise)
    a = place(t)[0]
    return np.where((value == np.inf) & (high == np.inf), np.inf, np.where(np.isfinite(least), a, np.nan))


def _branch_of(value: Array, found: Branches, load: Load, pulled: Load) -> tuple[Array, Array, Array, Array]:
    """The last branch with this load: its ends, and the load there, known to the rounding of its parts."""
    low = high = least = largest = np.full_like(value, np.nan)
    for first, last in zip(found.first, found.last, strict=True):
        start = load(first)
        top = np.where(np.isfinite(last), at_the_end(load, last), np.inf)
        top = np.where(np.isnan(top), np.inf, top)
        fits = (value >= start - 2.0 * NOISE * (np.abs(start) + pulled(first))) & (value <= top)
        low, high = np.where(fits, first, low), np.where(fits, last, high)
        least, largest = np.where(fits, start, least), np.where(fits, top, largest)
    return low, high, least, largest


def _divided(
    value: Array, low: Array, high: Array, least: Array, top: Array, load: Load, corner: Array
) -> tuple[Array, ...]:
    """The part of the branch on the side of the corner where the load is, and whether that is beyond."""
    bend = load(corner + np.zeros_like(low))
    inside = (low < corner) & np.logical_not(high <= corner)
    above = inside & (value > bend)
    below = inside & np.logical_not(above)
    high, top = np.where(below, corner, high), np.where(below, bend, top)
    low, least = np.where(above, corner, low), np.where(above, bend, least)
    return low, high, least, top, low >= corner


def _counted(
    low: Array, high: Array, beyond: Array, inner: Unknown, outer: Unknown | None
) -> tuple[Array, Array, Array, Callable[[Array], tuple[Array, Array]]]:
    """The unknown at `low`, how far it is to `high`, the largest t, and the radius with its derivative by t.

    t is what the unknown exceeds its first value by, times reach over what it is short of the last.
    """

    def of(a: Array) -> Array:
        return inner.of(a) if outer is None else np.where(beyond, outer.of(np.where(beyond, a, low)), inner.of(a))

    first = of(low)
    last = np.where(high == np.inf, np.inf, of(np.where(high == np.inf, low, high)))
    reach = last - first

    def place(t: Array) -> tuple[Array, Array]:
        open_ = np.logical_not(np.isfinite(reach))
        share = np.where(open_, 0.0, t / reach)
        x = first + np.where(share < np.inf, t / (1.0 + share), reach)
        step = 1.0 / (1.0 + share) ** 2
        a, rate = inner.back(x)
        if outer is not None:
            own, own_rate = outer.back(np.where(beyond, x, 1.0))
            a, rate = np.where(beyond, own, a), np.where(beyond, own_rate, rate)
        return a, rate * step

    return first, reach, np.where(np.isfinite(reach) | beyond, np.inf, inner.end - first), place


def growth(slope: Array, a: Array, control: str, E_star: Array, dgamma: Array) -> Array:
    """Derivative of the load by that of the depth without adhesion, with the retraction weighed by xi."""
    own = slope - XI[control] * hess_retraction(a, E_star, dgamma) / (2.0 * a)
    return 2.0 * E_star * a * own if control == "force" else own
