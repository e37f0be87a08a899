"""Pressure on the graded half-space: integral of g'(t) (t**2 - r**2)**((k - 1)/2) over the growth from r to a.

In u = sqrt(t**2 - r**2) the weight is u**k; each further substitution keeps the singularities of g' away
from the path, as in the rules of the homogeneous half-space.  `slope` gives g'(t).  The pressure is H/pi times
this integral.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..integrals import difference_root, integral, integral_by_panels, integral_in_strip
from ..interface import Array, either
from .breaks import past_tip, rounded_rate, rounding_rate, tipped_rate
from .growth import axis_power, gaussian_rate, hyperboloid_rate, power_factor, sphere_rate
from .rules import NODES, nodes_for, raised, sine_integral, sinh_over, weighted
from .waves import waves_rate

Slope = Callable[..., Array]
_PANEL, _LONGEST = 3.0, 8.0
"""First panels: where the weight meets a root that may be near, and the most that the nodes resolve with none near."""
SPAN = 4.0
"""Waves that one panel resolves."""
_NEAREST = 1e-9
"""A root, over b, whose square is nothing."""
_AXIS = 2.0**-60
"""A distance from the axis, over the radius of contact, whose square is nothing against one."""


def smooth_growth(slope: Slope, r: Array, a: Array, k: Array) -> Array:
    """The integral for g'(t)/t without singularities near."""
    r = _off_axis(r, a)

    def smooth(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    stop = difference_root(a, r)
    return raised(stop, k) * weighted(smooth, stop, k)


def wavy_growth(slope: Slope, r: Array, a: Array, wavelength: Array, k: Array) -> Array:
    """The integral where g' oscillates with a wavelength: one panel with the weight, then plain ones."""
    r = _off_axis(r, a)
    stop = difference_root(a, r)
    first = np.minimum(stop, SPAN * wavelength)

    def smooth(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    total = raised(first, k) * weighted(smooth, first, k)
    return total + integral_by_panels(
        lambda u: smooth(first + u) * (first + u) ** k, stop - first, SPAN * wavelength, NODES
    )


def sinh_growth(slope: Slope, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral where g' has a singularity at t**2 = -b**2."""
    r = _off_axis(r, a)

    def smooth(near: Array, far: Array) -> Array:
        t = np.hypot(r, near)
        return slope(t) / t * far

    return _from_branch(smooth, np.hypot(r, b), difference_root(a, r), k)


def tanh_growth(slope: Slope, r: Array, R: Array, reach: Array, end: Array, k: Array) -> Array:
    """The integral where g' has a singularity at t = R; `slope` takes t and sqrt(R**2 - t**2).

    Up to the a of which sqrt(a**2 - r**2) is `reach` and sqrt(R**2 - a**2) is `end`.
    """
    r = _off_axis(r, reach)
    scale = difference_root(R, r)

    def smooth(v: Array) -> Array:
        root = scale / np.cosh(v)
        t = np.hypot(r, scale * np.tanh(v))
        return slope(t, root) / t * (sinh_over(v) / np.cosh(v)) ** k / np.cosh(v) ** 2

    stop = np.arcsinh(reach / end)
    first = np.minimum(stop, _LONGEST)
    total = raised(first, k) * weighted(smooth, first, k, nodes_for(first))
    if np.any(stop > first):
        total = total + integral_in_strip(lambda v: smooth(first + v) * (first + v) ** k, stop - first)
    return np.where(end > 0.0, raised(scale, k) * total, np.inf)


def _off_axis(r: Array, a: Array) -> Array:
    """The radius, but not zero: for k < -1/2 the integrand is asked for at t = r, where g'(t)/t has but a limit."""
    return np.maximum(r, _AXIS * a)


def growth_beyond(slope: Slope, r: Array, a: Array, b: Array, k: Array, order: float = 0.0) -> Array:
    """The integral from max(r, b) on for a profile with a corner at b.

    `slope` takes t and sqrt(t**2 - b**2) and returns g'(t) (sqrt(t**2 - b**2)/t)**(1 - k), which is finite there
    and begins with the power `order` of the root.
    """
    within, scale, reach = _branches(r, a, b, order + 2.0 * k, r - b, a - b)

    def smooth(near: Array, far: Array) -> Array:
        root = np.where(within, near, far)
        t = np.hypot(b, root)
        return slope(t, root) * (far / t) ** k

    value = np.where(reach > 0.0, _from_branch(smooth, scale, reach, k), 0.0)
    at = (r == b) & (reach > 0.0)
    return np.where(at, growth_from_break(slope, np.where(at, reach, b), b, k, order), value) if np.any(at) else value


def growth_from_break(slope: Slope, reach: Array, b: Array, k: Array, order: float) -> Array:
    """The same for r = b, of positive 2 k + `order`, up to the distance `reach`: both branch points are one."""
    above = np.where(2.0 * k + order > 0.0, 2.0 * k + order, 1.0)

    def smooth(near: Array, far: Array) -> Array:
        root = np.maximum(near, _NEAREST * b)
        return slope(far, root) * far ** (1.0 - k) / root**order

    return _from_branch(smooth, b, reach, above - 1.0, above)


def growth_beyond_cap(
    slope: Slope,
    r: Array,
    a: Array,
    b: Array,
    k: Array,
    past: Callable[[Array], Array] | None = None,
    bend: Array | float = np.inf,
) -> Array:
    """The integral from max(r, b) on for a slope continuous at b; `slope` takes t and sqrt(t**2 - b**2), returns g'(t).

    There g' carries a power (t**2 - b**2)**((1 + k)/2), which a cube in the variable makes smooth.
    `past` gives what a radius is past b, where b itself is rounded, `bend` the distance at which g' changes its course.
    """
    gaps = [past(x) if past else x - b for x in (r, a)]
    within, scale, reach = _branches(r, a, b, 2.0 + 2.0 * k, *gaps)
    first, start = _panel(scale, reach, _PANEL * np.minimum(1.0, bend / scale))

    def inner(root: Array, u: Array) -> Array:
        t = np.hypot(b, root)
        return slope(t, root) * root / t * u**k

    def outer(_: Array, root: Array) -> Array:
        t = np.hypot(b, root)
        return slope(t, root) * root / t

    def cube(x: Array) -> Array:
        v = first * x**3
        return inner(scale * np.sinh(v), scale * np.cosh(v)) * 3.0 * x * x

    def below() -> Array:
        near = first * integral(cube, np.ones_like(first), NODES)
        return near + growth_far(inner, start, reach, scale)

    value = either(within, below, lambda: _from_branch(outer, scale, reach, k))
    return np.where(reach > 0.0, value, 0.0)


def _branches(r: Array, a: Array, b: Array, power: Array, near: Array, far: Array) -> tuple[Array, Array, Array]:
    """On which side of the break, the distance of the two branch points r and b, and of the edge to the outer one.

    `near` and `far` are r - b and a - b.

    Where r is b as far as b is known the distance is so small that nothing is left of the power of it by which the
    value differs, nor of its square; the next double is as near as 1e-8.
    """
    within = near < 0.0
    reach = np.where(within, np.sqrt(np.maximum(far, 0.0) * (a + b)), difference_root(a, r))
    least = np.minimum(b, reach) * np.exp(-37.0 / np.minimum(np.maximum(power, 0.107), 2.0))
    return within, np.where(near == 0.0, least, np.sqrt(np.abs(near) * (r + b))), reach


def _from_branch(
    smooth: Callable[[Array, Array], Array], scale: Array, reach: Array, k: Array, above: Array | None = None
) -> Array:
    """Integral of y**k smooth(y, far) dy/far from y = 0 to `reach`, with far = sqrt(scale**2 + y**2).

    `above` is 1 + k, as in the rule of the weight.
    """
    first, start = _panel(scale, reach, _PANEL)

    def weighed(v: Array) -> Array:
        return smooth(scale * np.sinh(v), scale * np.cosh(v)) * sinh_over(v) ** k

    near = weighted(weighed, first, k, nodes_for(first), above)
    rest = growth_far(lambda y, far: y**k * smooth(y, far), start, reach, scale)
    return scale**k * (raised(first, k) * near) + rest


def _panel(scale: Array, reach: Array, longest: Array | float) -> tuple[Array, Array]:
    """The length of the first panel in arcsinh(y/scale), and the y where the rest starts, `reach` if there is none."""
    whole = np.arcsinh(reach / scale)
    first = np.minimum(whole, longest)
    return first, np.where(first < whole, scale * np.sinh(first), reach)


def growth_far(integrand: Callable[[Array, Array], Array], start: Array, reach: Array, scale: Array) -> Array:
    """Integral of integrand(y, far) dy/far from y = start on, in ln y, where both branch points are one.

    Counted from either end up to the middle: in a length that counts decades an error is one of every power of it.
    """
    long = reach > start
    if not np.any(long):
        return np.zeros_like(start)
    half = np.where(long, np.log(np.sqrt(reach) / np.sqrt(np.where(long, start, 1.0))), 0.0)

    def along(y: Array) -> Array:
        far = np.hypot(scale, y)
        return integrand(y, far) * (y / far)

    rising = integral_in_strip(lambda x: along(start * np.exp(x)), half)
    return rising + integral_in_strip(lambda x: along(reach * np.exp(-x)), half)


_TERMS = 22
_EVEN = 16
"""Even powers up to this one are closed; of higher ones the rule takes fewer steps."""


def power_pressure(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral for f = r**n."""
    return power_factor(n, k) * n * (a**n / a * a**k) * power_growth(r, a, n, k)


def flank_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = 1 beyond b."""

    def slope(t: Array, root: Array) -> Array:
        return _tame(t, root, k) * sine_integral(np.arctan2(root, b), k) + b / t

    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def rim_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r beyond b."""

    def slope(t: Array, root: Array) -> Array:
        return t * ((1.0 - k) / (1.0 + k) * (root / t) ** 2 + 1.0)

    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def rounding_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r - b beyond b."""
    return growth_beyond(_rounding(b, k), r, a, b, k, 2.0)


def _rounding(b: Array, k: Array) -> Callable[[Array, Array], Array]:
    return lambda t, root: _tame(t, root, k) * rounding_rate(t, root, b, k)


def rounded_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f' = r/b up to b, 1 beyond."""
    tip = np.where(r < b, power_pressure(np.minimum(r, b), np.minimum(a, b), 2.0, k) / (2.0 * b), 0.0)
    value = tip + growth_beyond_cap(lambda t, root: rounded_rate(t, root, b, k), r, a, b, k)
    at = (r == b) & (a > b)
    return np.where(at, _rounded_at(np.where(at, a, 2.0 * b), b, k), value) if np.any(at) else value


def _rounded_at(a: Array, b: Array, k: Array) -> Array:
    """The same for r = b, next to which the slope is that of the parabola less that of a rounding: two powers."""
    reach = difference_root(a, b)
    turn = np.minimum(reach, b)
    near = 2.0 * raised(turn, k) / (1.0 + k) ** 2 - growth_from_break(_rounding(b, k), turn, b, k, 2.0)
    return near / b + growth_far(lambda y, t: y**k * rounded_rate(t, y, b, k), turn, reach, b)


def sphere_pressure(r: Array, a: Array, R: Array, k: Array) -> Array:
    """The integral for a sphere of unit height over radius."""
    return _sphere(r, R, difference_root(a, r), difference_root(R, a), k)


def _sphere(r: Array, R: Array, reach: Array, end: Array, k: Array) -> Array:
    return tanh_growth(lambda t, root: sphere_rate(t, root, k), r, R, reach, end, k)


def tipped_pressure(r: Array, a: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    """The integral for a sphere up to b, continued by its tangent cone."""

    def past(x: Array) -> Array:
        return past_tip(x, R, b, end)

    within, whole = past(r) < 0.0, past(a) >= 0.0
    reach = np.where(whole, np.sqrt(np.maximum(-past(r), 0.0) * (b + r)), difference_root(a, r))
    last = np.where(whole, end, difference_root(R, a))
    tip = either(within, lambda: _sphere(np.minimum(r, b), R, reach, last, k), lambda: np.zeros_like(reach))
    return tip + growth_beyond_cap(lambda t, root: tipped_rate(t, root, R, b, end, k), r, a, b, k, past, end)


def hyperboloid_pressure(r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral for f = sqrt(r**2 + b**2) - b."""
    return sinh_growth(lambda t: hyperboloid_rate(t, b, k), r, a, b, k)


def gaussian_pressure(r: Array, a: Array, s: Array, k: Array) -> Array:
    """The integral for f = 1 - exp(-r**2/s**2)."""
    return smooth_growth(lambda t: gaussian_rate(t, s, k), r, a, k)


def waves_pressure(r: Array, a: Array, q: Array, k: Array) -> Array:
    """The integral for f = 1 - cos(q r)."""
    return wavy_growth(lambda t: waves_rate(t, q, k), r, a, 2.0 * np.pi / q, k)


def _cornered(value: Array, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The pressure at a corner, which is finite for k > 0 only."""
    return np.where((r == b) & (a > b) & (k <= 0.0), np.inf, value)


def _tame(t: Array, root: Array, k: Array) -> Array:
    return (root / t) ** (1.0 - k)


def power_growth(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The integral for g'(t) = t**(n - 1), over a**(n + k - 1)."""
    if isinstance(n, int | float) and n % 2.0 == 0.0 and n <= _EVEN:
        return _even_growth(r, a, int(n), k)
    m = axis_power(n, k)
    length = np.log1p((a - r) / r)
    length = np.where(np.isfinite(length), length, np.log(a) - np.log(r))
    near = np.minimum(np.minimum(length, 1.0), 20.0 / np.maximum(np.abs(m), 1e-300))
    half, above = (k - 1.0) / 2.0, (k + 1.0) / 2.0

    def smooth(x: Array) -> Array:
        shrink = np.where(x > 0.0, -np.expm1(-2.0 * x) / np.where(x > 0.0, x, 1.0), 2.0)
        return shrink**half * np.exp(-m * (near - x))

    rest = length - near
    place = np.minimum(r / a * np.exp(near), 1.0)
    far = place**n / place * place**k
    first = np.where(rest > 0.0, far, 1.0) * near**above
    first = first * weighted(smooth, near, half, above=above)
    total = first + np.where(np.abs(m) > 20.0, _steep(rest, near, m, half), _tail(rest, near, m, half, far))
    return np.where(r > 0.0, total, np.where(m > 0.0, 1.0 / np.where(m > 0.0, m, 1.0), np.inf))


def _even_growth(r: Array, a: Array, n: int, k: Array) -> Array:
    """By parts in t**2 - r**2: every step adds what is positive."""
    half, square = (1.0 + k) / 2.0, (r / a) ** 2
    total = 0.5 / half
    for j in range(1, n // 2):
        total = (0.5 + j * square * total) / (j + half)
    # 1 + k is rounded: next to the edge its power would be wrong by 10 units
    share = (a - r) / a * ((a + r) / a)
    return np.sqrt(share) * share ** (k / 2.0) * total


def _tail(rest: Array, near: Array, m: Array, half: Array, far: Array) -> Array:
    """What lies beyond ln(t/r) = `near` = 1: the binomial series in exp(-2 x), whose terms are positive.

    `far` is exp(-m rest), where the logarithm of a ratio far from 1 would cost its number of digits.
    """
    rest = np.where(np.isfinite(rest), rest, 0.0)
    factor, total = np.ones_like(rest + half), np.zeros_like(rest + half)
    for j in range(_TERMS):
        rate = m - 2.0 * j
        span = np.where(rate == 0.0, rest, -np.expm1(-np.abs(rate) * rest) / np.where(rate == 0.0, 1.0, np.abs(rate)))
        level = np.where(rate > 0.0, np.exp(-2.0 * j * (near + rest)), np.exp(-2.0 * j * near) * far)
        total = total + factor * span * level
        factor = factor * (j - half) / (j + 1.0)
    return total


def _steep(rest: Array, near: Array, m: Array, half: Array) -> Array:
    """What lies beyond ln(t/r) = `near`, for a large power m, of which only the upper end counts."""
    rest = np.where(np.isfinite(rest), rest, np.inf)
    stop = np.minimum(rest, 42.0 / np.maximum(np.abs(m), 20.0))

    def integrand(y: Array) -> Array:
        return np.exp(-m * y) * (-np.expm1(-2.0 * (near + (rest - y)))) ** half

    return integral(integrand, stop, NODES)
