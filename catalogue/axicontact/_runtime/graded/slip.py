"""What a contact on the graded half-space gains while it grows from c to a.

`quantity` names the integral of g'(t) times its weight: 1 for the depth, t**(1 + k)
for the force over 2 H/(1 + k), and (t**2 - r**2)**((k - 1)/2) for the pressure over H/pi.
The path is counted in the logarithm of the distance sqrt(t**2 - m**2) to the nearest branch
point m, the larger of r and the break, where every power is smooth and all else pi/2 away.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..integrals import difference_root, integral_by_panels, integral_in_strip
from ..interface import Array, either
from ..physics.slip import CLOSE, gained_share
from .growth import power_depth, power_factor, power_force, sphere_rate
from .pressure import SPAN, growth_beyond_cap
from .rules import raised

Whole = Callable[..., Array]
Lengths = tuple[Array, ...]
NODES, DECAY, WAVES = 64, 42.0, 256.0
PANEL = 9.0
"""Length that the nodes resolve with singularities pi/2 away; see STRIPS."""


def power_gain(quantity: str, r: Array, c: Array, a: Array, n: Array, k: Array) -> Array:
    """For f = r**n."""
    if quantity == "depth":
        return power_depth(a, n, k) * gained_share(c, a, n)
    if quantity == "force":
        return power_force(a, n, k) * gained_share(c, a, n + (1.0 + k))
    return power_factor(n, k) * n * _power_growth(r, c, a, n, k)


def _power_growth(r: Array, c: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral of t**(n - 1) (t**2 - r**2)**((k - 1)/2), from the end where it is larger far from r."""
    inner, outer = difference_root(c, r), difference_root(a, r)
    falls = n + (k - 1.0) >= 0.0
    end = np.where(falls, a, c)
    start: Array = np.where(falls, outer, inner)
    side = 1.0 - 2.0 * falls
    # of a steep power only the upper end counts
    lost = (a / outer) ** 2 * -np.expm1(-2.0 * DECAY / np.maximum(n - 2.0, 1e-3))
    cut = -0.5 * np.log1p(-np.minimum(lost, 1.0 - 1e-16))
    last = np.where((n > 2.0) & (lost < 1.0), cut, np.inf)
    stop = np.minimum(_span(c, a, inner), last)

    def integrand(w: Array) -> Array:
        distance = start * np.exp(side * w)
        base = np.where(falls, r * r + distance * distance, c * c)
        change = 0.5 * np.log1p(start * start * np.abs(np.expm1(2.0 * side * w)) / base)
        return np.exp(side * ((n - 2.0) * change + (1.0 + k) * w))

    within = integral_by_panels(integrand, stop, PANEL * np.ones_like(stop), NODES)
    return end**n / end / end * raised(start, k) * within


def smooth_gain(
    quantity: str, whole: Whole, rate: Whole, lengths: Lengths, r: Array, c: Array, a: Array, k: Array
) -> Array:
    """For g' with no singularity but on the imaginary axis."""
    close = _close(r, c, a)
    fields = (r,) if quantity == "pressure" else ()
    return either(
        close,
        lambda: _grown(quantity, lambda t, _: rate(t, *lengths, k), r, c, a, 0.0, k, close),
        lambda: whole(*fields, a, *lengths, k) - whole(*fields, c, *lengths, k),
    )


def beyond_gain(
    quantity: str, whole: Whole, rate: Whole, lengths: Lengths, r: Array, c: Array, a: Array, k: Array
) -> Array:
    """For g' that begins at the break with a power of the distance to it."""
    (b,) = lengths
    close = _close(np.maximum(r, b), c, a)
    return either(
        close,
        lambda: _grown(quantity, lambda t, root: rate(t, root, *lengths, k), r, c, a, b, k, close),
        lambda: _difference(quantity, whole, lengths, b, r, c, a, k),
    )


def below_gain(
    quantity: str, whole: Whole, rate: Whole, lengths: Lengths, r: Array, c: Array, a: Array, k: Array
) -> Array:
    """For g' singular at t = R."""
    (R,) = lengths

    def values(t: Array) -> Array:
        return whole(r, t, R, k) if quantity == "pressure" else whole(t, difference_root(R, t), k)

    close = _close(r, c, a)
    return either(close, lambda: _grown_below(quantity, rate, r, c, a, R, k, close), lambda: values(a) - values(c))


def rounded_gain(
    quantity: str, whole: Whole, rate: Whole, lengths: Lengths, r: Array, c: Array, a: Array, k: Array
) -> Array:
    """For a cone with a parabolic tip up to b."""
    (b,) = lengths

    def tip(close: Array) -> Array:
        return power_gain(quantity, r, c, np.minimum(a, np.maximum(b, c)), 2.0, k) / (2.0 * b)

    return _across(quantity, tip, whole, rate, lengths, b, r, c, a, k)


def tipped_gain(
    quantity: str, whole: Whole, rate: Whole, lengths: Lengths, r: Array, c: Array, a: Array, k: Array
) -> Array:
    """For a sphere up to b and its tangent cone."""
    R, b, *_ = lengths

    def tip(close: Array) -> Array:
        return _grown_below(quantity, sphere_rate, r, c, np.minimum(a, np.maximum(b, c)), R, k, close & (c < b))

    return _across(quantity, tip, whole, rate, lengths, b, r, c, a, k)


def _across(
    quantity: str, tip: Callable[[Array], Array], whole: Whole, rate: Whole, lengths: Lengths, b: Array,
    r: Array, c: Array, a: Array, k: Array,
) -> Array:  # fmt: skip
    """What a shape gains whose rate is continuous at b, with the tip that ends there."""
    power = {"pressure": 0.0, "depth": 1.0 - k, "force": 2.0}[quantity]
    start = r if quantity == "pressure" else 0.0 * a
    close = _close(r, c, a)

    def slope(t: Array, root: Array) -> Array:
        return rate(t, root, *lengths, k)

    def from_tip() -> Array:
        return tip(close) + growth_beyond_cap(lambda t, root: slope(t, root) * t**power, start, a, b, k)

    def beyond() -> Array:
        return _grown(quantity, slope, r, c, a, b, k, close & (c > b))

    return either(
        close,
        lambda: either(c <= b, from_tip, beyond),
        lambda: _difference(quantity, whole, lengths, b, r, c, a, k),
    )


def waves_gain(
    quantity: str, whole: Whole, rate: Whole, lengths: Lengths, r: Array, c: Array, a: Array, k: Array
) -> Array:
    """For f = 1 - cos(q r): one panel in the logarithm, then plain ones."""
    (q,) = lengths
    length, inner, outer = 2.0 * np.pi / q, difference_root(c, r), difference_root(a, r)
    gap = np.where(a > c, (a - c) * (a + c) / (inner + outer), 0.0)
    close = (inner >= CLOSE * outer) & (gap < WAVES * length)
    gap = np.where(close, gap, 0.0)
    first = np.minimum(gap, length)

    def _grown(y: Array) -> Array:
        t = np.sqrt(r * r + y * y)
        return rate(t, q, k) * _weight(quantity, t, y, k) * (y / t)

    def near(w: Array) -> Array:
        y = inner * np.exp(w)
        return y * _grown(y)

    def gain() -> Array:
        rest = integral_by_panels(
            lambda y: _grown(inner + first + y), gap - first, SPAN * length * np.ones_like(gap), NODES
        )
        return rest + integral_by_panels(near, np.log1p(first / inner), PANEL * np.ones_like(gap), NODES)

    fields = (r,) if quantity == "pressure" else ()
    return either(close, gain, lambda: whole(*fields, a, q, k) - whole(*fields, c, q, k))


def _close(m: Array, c: Array, a: Array) -> Array:
    """Where most of what is there at a was there at c, counted from the branch point m."""
    inner = difference_root(c, m)
    return (inner > 0.0) & (inner >= CLOSE * difference_root(a, m))


def _difference(
    quantity: str, whole: Whole, lengths: Lengths, b: Array, r: Array, c: Array, a: Array, k: Array
) -> Array:
    if quantity == "pressure":
        return whole(r, a, *lengths, k) - whole(r, c, *lengths, k)
    return whole(a, difference_root(a, b), *lengths, k) - whole(c, difference_root(c, b), *lengths, k)


def _weight(quantity: str, t: Array, y: Array, k: Array) -> Array:
    if quantity == "depth":
        return 1.0
    return t * t**k if quantity == "force" else y**k / y


def _span(c: Array, a: Array, distance: Array) -> Array:
    """Logarithm of the growth of sqrt(t**2 - m**2), which is `distance` at t = c."""
    return np.where(a > c, 0.5 * np.log1p((a - c) / distance * ((a + c) / distance)), 0.0)


def _grown(quantity: str, rate: Whole, r: Array, c: Array, a: Array, b: Array, k: Array, close: Array) -> Array:
    """The integral from c to a for rate(t, sqrt(t**2 - b**2)), where c is beyond r and b."""
    branch = np.maximum(r, b)
    start = difference_root(c, branch)

    def integrand(w: Array) -> Array:
        distance = start * np.exp(w)
        t, root, y = (np.sqrt((branch - x) * (branch + x) + distance * distance) for x in (0.0, b, r))
        return rate(t, root) * _weight(quantity, t, y, k) * distance * (distance / t)

    holds = close & (start > 0.0)
    return np.where(holds, integral_in_strip(integrand, np.where(holds, _span(c, a, start), 0.0)), 0.0)


def _grown_below(quantity: str, rate: Whole, r: Array, c: Array, a: Array, R: Array, k: Array, close: Array) -> Array:
    """The same for rate(t, sqrt(R**2 - t**2)), in the logarithm of the ratio of both distances."""
    scale, start = difference_root(R, r), difference_root(c, r)
    ratio, last = start / difference_root(R, c), difference_root(R, a) / scale

    def integrand(w: Array) -> Array:
        tangent = ratio * np.exp(w)
        secant = np.sqrt(1.0 + tangent * tangent)
        y = scale * (tangent / secant)
        t = np.sqrt(r * r + y * y)
        return rate(t, scale / secant, k) * _weight(quantity, t, y, k) * (y / secant) * (y / t / secant)

    holds = close & (start > 0.0)
    return np.where(holds, integral_in_strip(integrand, np.where(holds, _span(c, a, start * last), 0.0)), 0.0)
