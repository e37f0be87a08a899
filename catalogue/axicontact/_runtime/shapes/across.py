"""Roots of increasing curves whose slope jumps or bends sharply at a length, on either side of it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..functions import at_break, nth_root
from ..interface import Array
from ..inverse import ROUNDING, above_noise, inverse, joining, leaving_power

Rooted = Callable[[Array, Array], tuple[Array, Array]]
NOISE = 5.0 * ROUNDING
"""Both the value and that at the break are rounded, some of them sums."""


def inverse_beyond(
    curve: Rooted,
    value: Array,
    b: Array,
    tip: Array | float,
    powers: tuple[float, float] | None = None,
    leaving: tuple[float, float] | None = None,
) -> Array:
    """The radius at which a curve has this value that is its power `tip` up to b, where it bends or its slope jumps.

    `curve` gives its value and the derivative by ln radius from b on, from the radius and sqrt(radius**2 - b**2).
    The unknown is t = that root over b, even where the curve leaves b with an infinite slope.  The excess over the
    curve at b begins and ends with the `powers` of t; or `leaving` are those of what comes to the power itself.
    """
    base = curve(b, at_break(b))[0]
    above = value > base
    radius = b * nth_root(np.where(above, base, value) / base, tip)
    if not np.count_nonzero(above):
        return radius
    high = np.where(above, value, 2.0 * base)
    return np.where(above, _beyond(curve, high, base, b, tip, powers, leaving), radius)


def inverse_across(
    curve: Rooted,
    value: Array,
    b: Array,
    tip: Array | float,
    end: Array | None = None,
    powers: tuple[float, float] | None = None,
) -> Array:
    """The same for a curve that only begins as that power: one iteration for both sides of b.

    Below it the root is zero, and the unknown the radius; or artanh(radius/end), for a curve that would be infinitely
    steep at `end`.
    """
    base = curve(b, np.zeros_like(b))[0]
    above = value > base
    if np.all(above):
        return _beyond(curve, value, base, b, tip, powers)
    radius_at, share, reach = _tip(b, end)

    def both(t: Array) -> tuple[Array, Array]:
        inner = np.minimum(t, reach)
        y, rate = curve(np.where(above, b * np.sqrt(1.0 + t * t), radius_at(inner)), np.where(above, b * t, 0.0))
        more, slope = _excess(t, y, rate, base, powers[0] if powers else 2.0)
        return np.where(above, more, y), np.where(above, slope, rate / y * share(inner))

    # the curve beyond b may begin a few roundings later
    last, rate = curve(radius_at(reach), np.zeros_like(b))
    wanted = np.where(above, value - base, np.minimum(value, last))
    like = np.where(above, last, wanted) / last
    start = reach * (like ** (1.0 / tip) if end is None else joining(like, rate / last * share(reach), tip, 1.0))
    if np.count_nonzero(above):
        start = np.where(above, _start(curve, np.where(above, wanted, base), base, b, tip, powers), start)
    least, most = (tip, np.inf) if end is None else (1.0, tip)
    t = inverse(
        both,
        wanted,
        start,
        (np.where(above, 1.0, least), np.where(above, np.inf, most)),
        np.where(above, np.inf, reach),
        lambda t: np.where(above, 1.0, share(np.minimum(t, reach))),
        smooth=True,
        noise=np.where(above, NOISE, ROUNDING) * value,
    )
    return np.where(above, b * np.sqrt(1.0 + t * t), np.minimum(b, radius_at(np.minimum(t, reach))))


def _beyond(
    curve: Rooted,
    value: Array,
    base: Array,
    b: Array,
    tip: Array | float,
    powers: tuple[float, float] | None,
    leaving: tuple[float, float] | None = None,
) -> Array:
    small = None if leaving else (powers or (2.0,))[0]

    def excess(t: Array) -> tuple[Array, Array]:
        return _excess(t, *curve(b * np.sqrt(1.0 + t * t), b * t), base, small)

    start = _start(curve, value - base, base, b, tip, powers, leaving)
    t = inverse(excess, value - base, start, (1.0, np.inf), smooth=True, noise=NOISE * value)
    return b * np.sqrt(1.0 + t * t)


def _start(
    curve: Rooted,
    more: Array,
    base: Array,
    b: Array,
    tip: Array | float,
    powers: tuple[float, float] | None,
    leaving: tuple[float, float] | None = None,
) -> Array:
    """About the t at which the excess is this."""
    if powers is None and leaving is None:
        return np.ones_like(more)
    one, slope = _excess(1.0, *curve(b * np.sqrt(2.0), b), base, powers and powers[0])
    if powers is not None:
        return joining(more / one, slope, *powers)
    return leaving_power(more / one, base / one * (2.0 ** (tip / 2.0) - 1.0), tip, *(leaving or ()))


def _excess(t: Array, y: Array, rate: Array, base: Array, small: float | None) -> tuple[Array, Array]:
    """The excess of a curve over its value at b and its logarithmic slope in t, both as `inverse_beyond` says."""
    return above_noise(y - base, rate * (t * t / (1.0 + t * t)), base, small, 1.0)


def _tip(b: Array, end: Array | None) -> tuple[Callable[[Array], Array], Callable[[Array], Array], Array]:
    """The radius of the unknown up to b; the derivative of its logarithm by that of the unknown; the unknown at b."""
    if end is None:
        return lambda t: t, np.ones_like, b
    reach = np.arctanh(np.minimum(b / end, 1.0 - ROUNDING))
    return lambda t: end * np.tanh(t), lambda t: t / (np.sinh(t) * np.cosh(t)), reach
