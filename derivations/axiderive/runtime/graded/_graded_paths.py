"""Integrals of g'(t) (t**2 - r**2)**((k - 1)/2) over the growth from r to a, for rates g' of every kind.

In u = sqrt(t**2 - r**2) the weight is u**k; each further substitution keeps the singularities of g' away
from the path, as in the rules of the homogeneous half-space.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_rules import NODES, raised, sinh_over, weighted
from ._integrals import difference_root, integral, integral_by_panels, integral_in_strip

Slope = Callable[..., Array]
_PANEL, _LONGEST = 3.0, 8.0
"""First panels: where the weight meets a root that may be near, and the most that the nodes resolve with none near."""
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
    first = np.minimum(stop, wavelength)

    def smooth(u: Array) -> Array:
        t = np.sqrt(r * r + u * u)
        return slope(t) / t

    total = raised(first, k) * weighted(smooth, first, k)
    return total + integral_by_panels(lambda u: smooth(first + u) * (first + u) ** k, stop - first, wavelength, NODES)


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
    total = raised(first, k) * weighted(smooth, first, k)
    if (stop > first).any():
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
    return np.where(at, growth_from_break(slope, np.where(at, reach, b), b, k, order), value) if at.any() else value


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
    first = np.minimum(np.arcsinh(reach / scale), _PANEL * np.minimum(1.0, bend / scale))

    def inner(root: Array, u: Array) -> Array:
        t = np.hypot(b, root)
        return slope(t, root) * root / t * u**k

    def outer(_: Array, root: Array) -> Array:
        t = np.hypot(b, root)
        return slope(t, root) * root / t

    def cube(x: Array) -> Array:
        v = first * x**3
        return inner(scale * np.sinh(v), scale * np.cosh(v)) * 3.0 * x * x

    below = first * integral(cube, np.ones_like(first), NODES) + growth_far(inner, scale * np.sinh(first), reach, scale)
    value = np.where(within, below, _from_branch(outer, scale, reach, k))
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
    first = np.minimum(np.arcsinh(reach / scale), _PANEL)
    near = weighted(lambda v: smooth(scale * np.sinh(v), scale * np.cosh(v)) * sinh_over(v) ** k, first, k, above=above)
    rest = growth_far(lambda y, far: y**k * smooth(y, far), scale * np.sinh(first), reach, scale)
    return scale**k * (raised(first, k) * near) + rest


def growth_far(integrand: Callable[[Array, Array], Array], start: Array, reach: Array, scale: Array) -> Array:
    """Integral of integrand(y, far) dy/far from y = start on, in ln y, where both branch points are one.

    Counted from either end up to the middle: in a length that counts decades an error is one of every power of it.
    """
    long = reach > start
    half = np.where(long, np.log(np.sqrt(reach) / np.sqrt(np.where(long, start, 1.0))), 0.0)

    def along(y: Array) -> Array:
        far = np.hypot(scale, y)
        return integrand(y, far) * (y / far)

    rising = integral_in_strip(lambda x: along(start * np.exp(x)), half)
    return rising + integral_in_strip(lambda x: along(reach * np.exp(-x)), half)
