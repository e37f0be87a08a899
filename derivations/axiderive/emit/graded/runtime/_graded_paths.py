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
_PANEL = 3.0
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


def tanh_growth(slope: Slope, r: Array, a: Array, R: Array, k: Array) -> Array:
    """The integral where g' has a singularity at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    r = _off_axis(r, a)
    scale = difference_root(R, r)

    def smooth(v: Array) -> Array:
        root = scale / np.cosh(v)
        t = np.hypot(r, scale * np.tanh(v))
        return slope(t, root) / t * (sinh_over(v) / np.cosh(v)) ** k / np.cosh(v) ** 2

    stop = np.arcsinh(difference_root(a, r) / difference_root(R, a))
    value = raised(scale, k) * raised(stop, k) * weighted(smooth, stop, k)
    return np.where(a < R, value, np.inf)


def _off_axis(r: Array, a: Array) -> Array:
    """The radius, but not zero: for k < -1/2 the integrand is asked for at t = r, where g'(t)/t has but a limit."""
    return np.maximum(r, _AXIS * a)


def growth_beyond(slope: Slope, r: Array, a: Array, b: Array, k: Array, order: float = 0.0) -> Array:
    """The integral from max(r, b) on for a profile with a corner at b.

    `slope` takes t and sqrt(t**2 - b**2) and returns g'(t) (sqrt(t**2 - b**2)/t)**(1 - k), which is finite there
    and begins with the power `order` of the root.
    """
    within, scale, reach = _branches(r, a, b, order + 2.0 * k)

    def smooth(near: Array, far: Array) -> Array:
        root = np.where(within, near, far)
        t = np.hypot(b, root)
        return slope(t, root) * (far / t) ** k

    return np.where(reach > 0.0, _from_branch(smooth, scale, reach, k), 0.0)


def growth_beyond_cap(slope: Slope, r: Array, a: Array, b: Array, k: Array) -> Array:
    """The integral from max(r, b) on for a slope continuous at b; `slope` takes t and sqrt(t**2 - b**2), returns g'(t).

    There g' carries a power (t**2 - b**2)**((1 + k)/2), which a cube in the variable makes smooth.
    """
    within, scale, reach = _branches(r, a, b, 2.0 + 2.0 * k)
    first = np.minimum(np.arcsinh(reach / scale), _PANEL)

    def inner(root: Array, u: Array) -> Array:
        t = np.hypot(b, root)
        return slope(t, root) * root / t * u**k

    def outer(_: Array, root: Array) -> Array:
        t = np.hypot(b, root)
        return slope(t, root) * root / t

    def cube(x: Array) -> Array:
        v = first * x**3
        return inner(scale * np.sinh(v), scale * np.cosh(v)) * 3.0 * x * x

    below = first * integral(cube, np.ones_like(first), NODES) + _far(inner, scale * np.sinh(first), reach, scale)
    value = np.where(within, below, _from_branch(outer, scale, reach, k))
    return np.where(reach > 0.0, value, 0.0)


def _branches(r: Array, a: Array, b: Array, power: Array) -> tuple[Array, Array, Array]:
    """On which side of the break, the distance of the two branch points r and b, and of the edge to the outer one.

    Where r is b itself the distance is so small that nothing is left of the power of it by which the value differs;
    the next double is as near as 1e-8, of which that power may be a sixth.
    """
    within = r < b
    reach = np.where(within, difference_root(a, b), difference_root(a, r))
    least = b * np.exp(-37.0 / np.maximum(power, 0.107))
    return within, np.where(r == b, least, np.sqrt(np.abs(r - b) * (r + b))), reach


def _from_branch(smooth: Callable[[Array, Array], Array], scale: Array, reach: Array, k: Array) -> Array:
    """Integral of y**k smooth(y, far) dy/far from y = 0 to `reach`, with far = sqrt(scale**2 + y**2)."""
    first = np.minimum(np.arcsinh(reach / scale), _PANEL)
    near = weighted(lambda v: smooth(scale * np.sinh(v), scale * np.cosh(v)) * sinh_over(v) ** k, first, k)
    rest = _far(lambda y, far: y**k * smooth(y, far), scale * np.sinh(first), reach, scale)
    return scale**k * (raised(first, k) * near) + rest


def _far(integrand: Callable[[Array, Array], Array], start: Array, reach: Array, scale: Array) -> Array:
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
