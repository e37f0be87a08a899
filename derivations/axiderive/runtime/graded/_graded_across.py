"""Contact radius of a depth or a force on the graded half-space, of a profile with a break, on either side of it."""

from __future__ import annotations

import numpy as np

from ._across import Rooted, inverse_across
from ._elementwise import Array
from ._graded_inverse import SLACK, Load
from ._integrals import difference_root
from ._inverse import LOST, ROUNDING, inverse
from ._unknowns import Unknown, power_of, radius_itself, root_of, up_to

CLOSE, NEAREST = 1e-4, 1e-12
"""The t at which the terms of a load beyond a break are read, and one at which a is b."""


def radius_across(
    load: Load,
    rate: Load,
    value: Array,
    b: Array,
    needs: tuple[Array, ...],
    tip: Array,
    least: Array | None = None,
    end: Array | None = None,
) -> Array:
    """The a with load(a, root, *needs) = value, with root = sqrt(a**2 - b**2) for a break at b and 0 below it.

    Below the load is the power `tip` of a, in excess from t**least on beyond.
    """
    value = value + np.zeros(1)
    if end is None and least is None:
        return inverse_across(_with_rate(load, rate, needs), value, b + np.zeros_like(value), tip)
    # where a steep tip ends, a unit of the radius is thousands of the load, and what is beyond begins at its own
    first = np.zeros_like(value) if end is None else NEAREST * b + np.zeros_like(value)
    base = load(b + np.zeros_like(value), first, *needs)
    above = value > base
    below = radius_itself() if end is None else up_to(end, needs[-1])
    radius = b + np.zeros_like(value)
    if not np.all(above):
        radius = _below(load, rate, np.where(above, base, value), base, b, needs, below, tip)
    if not np.any(above):
        return radius
    return np.where(
        above,
        _beyond(load, rate, np.where(above, value - base, 0.0), base, b, needs, 1.0 if least is None else least, tip),
        radius,
    )


def _with_rate(load: Load, rate: Load, needs: tuple[Array, ...]) -> Rooted:
    """Value and derivative by ln a."""
    return lambda a, root: (load(a, root, *needs), a * rate(a, root, *needs))


def _below(
    load: Load,
    rate: Load,
    value: Array,
    base: Array,
    b: Array,
    needs: tuple[Array, ...],
    unknown: Unknown,
    tip: Array,
) -> Array:
    """The radius up to b."""
    largest = unknown.of(b + np.zeros_like(value))

    def share(x: Array) -> Array:
        a, step = unknown.back(x)
        return x * step / a

    def curve(x: Array) -> tuple[Array, Array]:
        a, step = unknown.back(x)
        own = load(a, difference_root(a, b), *needs)
        return own, x * step * rate(a, difference_root(a, b), *needs) / own

    start = largest * (value / base) ** (1.0 / tip)
    x = inverse(curve, value, start, (SLACK, np.inf), largest, share=share, smooth=True)
    return np.minimum(unknown.back(x)[0], b)


def _beyond(
    load: Load,
    rate: Load,
    excess: Array,
    base: Array,
    b: Array,
    needs: tuple[Array, ...],
    least: Array | float,
    tip: Array,
) -> Array:
    """The radius beyond b, where the load exceeds that of b by nearly c t**least + C t**2.

    Both terms are read from the load close to b, and with them the t at which one gives way to the other.
    """
    curve_at = _with_rate(load, rate, needs)

    def more_and_rate(t: Array) -> tuple[Array, Array]:
        y, slope = curve_at(b * np.sqrt(1.0 + t * t), b * t)
        slope = slope * (t * t / (1.0 + t * t))
        more = np.maximum(y - base, ROUNDING * base)
        # above its rounding the excess may grow by less than its first power, where the load saturates
        return more, np.where(more > LOST * ROUNDING * base, slope, np.maximum(slope, np.minimum(least, 1.0) * more))

    near = CLOSE * np.ones_like(excess)
    more, slope = more_and_rate(near)
    second = np.clip((slope / more - least) / np.maximum(2.0 - least, ROUNDING), ROUNDING, 1.0 - ROUNDING)
    # where the powers are all but equal it does not matter where they meet
    meet = near * ((1.0 - second) / second) ** (1.0 / np.maximum(2.0 - least, 0.2))
    meet = np.minimum(np.maximum(meet, NEAREST), 1.0 / NEAREST)
    unit = more * (1.0 - second) * (meet / near) ** least

    def place(x: Array) -> tuple[Array, Array]:
        t, power = root_of(x, least, 2.0)
        return meet * t, power

    def curve(x: Array) -> tuple[Array, Array]:
        t, power = place(x)
        own, slope = more_and_rate(t)
        return own, slope / own / power

    def share(x: Array) -> Array:
        t, power = place(x)
        return t * t / (1.0 + t * t) / power

    # both the value and that at the break are rounded, some of them sums
    noise = 8.0 * ROUNDING * (base + excess)
    first = place(np.where(excess > 0.0, excess / unit, 1.0))[0]
    # far away the break is forgotten
    start = power_of(np.where(first > 1.0, first ** (2.0 / tip), first) / meet, least, 2.0)
    wanted = np.where(excess > 0.0, excess, unit)
    x = inverse(curve, wanted, start, (SLACK, np.inf), share=share, smooth=True, noise=noise)
    t = place(x)[0]
    return np.where(excess > 0.0, b * np.sqrt(1.0 + t * t), b)
