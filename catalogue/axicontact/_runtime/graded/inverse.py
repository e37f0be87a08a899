"""Contact radius of a depth or a force on the graded half-space, in a variable in which the load is nearly linear.

Of a profile with a break it is sought on either side of that.
"""

from __future__ import annotations

import numpy as np

from ..integrals import difference_root
from ..interface import Array, Kept
from ..inverse import LOST, ROUNDING, Curve, inverse
from ..physics.unknowns import CLOSE, Load, Unknown, at_break, beyond_edge, power_of, radius_itself, root_of, up_to
from ..shapes.across import Rooted, inverse_across
from .growth import gaussian_rate

SLACK = 1e-6
"""So that the bracket of a root spans all doubles but where the load is met to a thousandth: no exponent is assumed."""
STEEPEST = 1e8
"""Radius over its root up to which a radius is told from the end of its domain."""
SHORT = (2.0**-49, 2.0**-35, 2.0**-20, 2.0**-10, 2.0**-5)
"""How far short of the largest radius its load is taken, over it."""


def radius_to(load: Load, rate: Load, value: Array, start: Array, needs: tuple[Array, ...]) -> Array:
    """The a with load(a, *needs) = value; `rate` is the derivative of the load."""
    value = value + np.zeros(1)
    start = start + np.zeros_like(value)
    return inverse(_curve(load, rate, needs), value, start, (SLACK, np.inf), smooth=True)


def radius_up_to(
    load: Load, rate: Load, value: Array, largest: Array, needs: tuple[Array, ...], unknown: Unknown
) -> Array:
    """The same where the load ends at `largest` with slope zero; NaN beyond.

    Solved for the load over what it is short of its largest, which is the first or the second power of
    t = x/(1 - x/x(largest)) at either end, even where the grading makes the end an asymptote.
    """
    value = value + np.zeros(1)
    end, top = largest, np.full_like(value, np.nan)
    for part in SHORT:
        # where the rate rounds to less than zero there is no load
        end = np.where(np.isnan(top), largest * (1.0 - part), end)
        top = load(end, *needs)
        if not np.any(np.isnan(top)):
            break
    held = value <= top * (1.0 + 2.0**-48)
    if not np.count_nonzero(held):
        return np.where(held, value, np.nan)
    reach = unknown.of(end)
    least_short = 6.0 * ROUNDING * top

    def place(t: Array) -> tuple[Array, Array]:
        a, step = unknown.back(t / (1.0 + t / reach))
        return a, step / (1.0 + t / reach) ** 2

    def curve(t: Array) -> tuple[Array, Array]:
        a, step = place(t)
        own = load(a, *needs)
        short = np.maximum(top - own, least_short)
        return own / short, t * step * rate(a, *needs) * (1.0 / own + 1.0 / short)

    wanted = value / np.maximum(top - value, least_short)
    noise = 2.0 * ROUNDING * wanted * (1.0 + wanted)
    t = inverse(curve, wanted, reach * np.sqrt(wanted), (SLACK, np.inf), smooth=True, noise=noise)
    return np.where(held, place(t)[0], np.nan)


def _curve(load: Load, rate: Load, needs: tuple[Array, ...]) -> Curve:
    def curve(a: Array) -> tuple[Array, Array]:
        own = load(a, *needs)
        return own, a * rate(a, *needs) / own

    return curve


def contact_beyond(
    load: Load, rate: Load, value: Array, b: Array, needs: tuple[Array, ...], exponents: tuple[Array, Array]
) -> tuple[Array, Array]:
    """The same for a flat face of radius b, with the root b t = sqrt(a**2 - b**2); load and rate take both.

    The load grows as a power of t for small and for large t, with the two `exponents`; so does the unknown, which
    does not run away where the first is 1 + k near 0.
    """
    first, last = exponents
    value = value + np.zeros(1)
    unknown = beyond_edge(b, first, last)

    def curve(x: Array) -> tuple[Array, Array]:
        t, slope = root_of(x, first, last)
        a, root = np.hypot(b, b * t), b * t
        own = load(a, root, *needs)
        return own, root * (root / a) * rate(a, root, *needs) / own / slope

    unit = unknown.of(b * np.sqrt(2.0)) * np.ones_like(value)
    x = inverse(curve, value, unit * (value / curve(unit)[0]), (SLACK, np.inf), smooth=True)
    return unknown.back(x)[0], b * root_of(x, first, last)[0]


def contact_below(
    load: Load, rate: Load, value: Array, R: Array, needs: tuple[Array, ...], exponent: Array, k: Array
) -> tuple[Array, Array]:
    """The same for a sphere, in t = a/sqrt(R**2 - a**2), with that root; NaN where the load is beyond that of a = R.

    It begins as t**`exponent`, and ends as const - t**-k, log(t) or t**-k, by the sign of k; the unknown is
    (1 - (1 + t**exponent)**(-k/exponent))/k, which does the same.
    From STEEPEST on the radius is R to the last digit, and the contact that of STEEPEST: the load in excess of it
    is what a flat face of that radius carries.
    """
    value = value + np.zeros(1)
    k = np.where(np.abs(k) < 1e-30, 1e-30, k)

    def like(t: Array) -> tuple[Array, Array]:
        power = t**exponent
        log = np.log1p(power)
        x = -np.expm1(-k / exponent * log) / k
        return x, power / (1.0 + power) * np.exp(-k / exponent * log) / x

    def place(x: Array) -> Array:
        power = np.expm1(-exponent / k * np.log1p(-k * x))
        return power ** (1.0 / exponent)

    def contact(t: Array) -> tuple[Array, Array]:
        root = R / np.hypot(1.0, t)
        return root * t, root

    def curve(x: Array) -> tuple[Array, Array]:
        t = place(x)
        a, root = contact(t)
        own = load(a, root, *needs)
        return own, a * (root / R) ** 2 * rate(a, root, *needs) / own / like(t)[1]

    steepest = STEEPEST * np.ones_like(value)
    half = 0.5 * np.ones_like(value)
    largest = like(steepest)[0]
    last = load(*contact(steepest), *needs)
    wanted = np.minimum(value, last)
    x = inverse(curve, wanted, half * (wanted / curve(half)[0]), (SLACK, np.inf), largest, smooth=True)
    a, root = contact(place(x))
    if np.any(value > last):
        a = np.where(value <= load(R, np.zeros_like(R), *needs) * (1.0 + 2.0**-48), a, np.nan)
    return a, root


@Kept
def gaussian_reach(s: Array, k: Array) -> Array:
    """The radius of largest depth of a Gaussian bump, where the contact ceases to be compact."""
    low, high = np.ones_like(s + k), 8.0 * np.ones_like(s + k)
    for _ in range(60):
        middle = (low + high) / 2.0
        # with the s of the caller: the rate at the radius returned must not round to less than zero
        rises = gaussian_rate(s * middle, s, k) >= 0.0
        low, high = np.where(rises, middle, low), np.where(rises, high, middle)
    return s * low


NEAREST = 1e-12
"""The t at which a is b."""


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
    base, *close = at_break((load, rate), b, 0.0 * b if end is None else NEAREST * b, *needs)
    base = base + np.zeros_like(value)
    above = value > base
    below = radius_itself() if end is None else up_to(end, needs[-1])
    radius = b + np.zeros_like(value)
    if not np.all(above):
        radius = _below(load, rate, np.where(above, base, value), base, b, needs, below, tip)
    if not np.any(above):
        return radius
    return np.where(
        above,
        _beyond(
            load, rate, np.where(above, value - base, 0.0), base, b, needs, 1.0 if least is None else least, tip, *close
        ),
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
    at_close: Array,
    slope_at_close: Array,
) -> Array:
    """The radius beyond b, where the load exceeds that of b by nearly c t**least + C t**2.

    Both terms are read from the load close to b, and with them the t at which one gives way to the other.
    """
    curve_at = _with_rate(load, rate, needs)

    def more_and_rate(t: Array, y: Array, slope: Array) -> tuple[Array, Array]:
        slope = slope * (t * t / (1.0 + t * t))
        more = np.maximum(y - base, ROUNDING * base)
        # above its rounding the excess may grow by less than its first power, where the load saturates
        return more, np.where(more > LOST * ROUNDING * base, slope, np.maximum(slope, np.minimum(least, 1.0) * more))

    near = CLOSE * np.ones_like(excess)
    more, slope = more_and_rate(near, at_close, slope_at_close)
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
        own, slope = more_and_rate(t, *curve_at(b * np.sqrt(1.0 + t * t), b * t))
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
