"""Displacement of a flat punch and of powers on the graded half-space, and the integrals of all displacements.

With z = sqrt(a**2 - s**2) and q = sqrt(r**2 - a**2) the surface outside is
2/pi cos(pi k/2) q**(1 - k) times the integral of z**k (d - f(s))/(q**2 + z**2) over 0 < z < a.
Up to z = a/2 in z = c sinh(v), which keeps z = i q away from the path, then in z = a sin(y).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._along import at_many_radii
from ._elementwise import Array
from ._graded_growth import power_excess
from ._graded_rules import NODES, raised, sine_over, weighted
from ._integrals import difference_root, integral, integral_in_strip, of_displacement

Shape = Callable[[Array, Array], Array]
"""A function of s and z, with s**2 + z**2 = a**2."""
SPLIT = np.pi / 6.0
EDGE = ((3.0, 32), (11.0, 64))
"""Lengths of a path from the edge, and the nodes of one panel for it; beyond there are two panels.

They lose 3 units; 32 nodes lose 10 on a path of 4, and 64 nodes 60 on a path of 16.
"""
STEEP = 16.0
"""The power of a shape beyond which it needs two panels everywhere."""
SHARE = 0.125
"""Of the radii from which on panels pay: a rule of this file costs as much as eight of the ordinary ones."""
_SMOOTHING = 8


def punch_scale(k: Array) -> Array:
    """2/pi cos(pi k/2), without loss near k = -1 and 1."""
    return 2.0 / np.pi * np.sin(np.pi / 2.0 * (1.0 - np.abs(k)))


@at_many_radii(of_displacement, SHARE)
def punch_share(r: Array, a: Array, k: Array) -> Array:
    """w/d outside a flat punch, for r > a."""
    q = difference_root(r, a)
    stop = np.arcsinh(a / q)
    return punch_scale(k) * from_edge(lambda s, z: np.ones_like(z), a, q, q, stop, k)


@at_many_radii(of_displacement, SHARE)
def power_sag(r: Array, a: Array, n: Array, k: Array) -> Array:
    """Of f = r**n."""
    q = difference_root(r, a)
    near = _from_edge_of_power(lambda s, z: np.exp(n / 2.0 * np.log1p(-((z / a) ** 2))), q, a, n, k)

    whole = np.floor(n)
    weight = n - whole

    def smooth(x: Array) -> Array:
        # whole powers need no weight; with n in the weight the rule cancels for large n
        return sine_over(x) ** weight * np.sin(x) ** whole * kernel(np.cos(x), np.sin(x), a / q, k)

    reach = _to_axis(q)
    far = reach**weight * reach * weighted(smooth, reach, weight)
    return punch_scale(k) * a**n * (near + far)


def power_displacement(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The displacement of f = r**n inside and outside the contact: what d is above f(a), and f(a) above f(s)."""
    ratio = np.where(r < 0.5 * a, np.log(r / a), np.where(r < a, np.log1p((r - a) / a), 0.0))
    excess = power_excess(n, k)
    over = np.where(r > a, _beside_power(r, a, n, k, excess), excess - np.expm1(n * ratio))
    return np.where(a > 0.0, a**n * over, 0.0)


@at_many_radii(of_displacement, SHARE)
def _beside_power(r: Array, a: Array, n: Array, k: Array, excess: Array) -> Array:
    q = difference_root(r, a)
    near = _from_edge_of_power(lambda s, z: excess - np.expm1(n / 2.0 * np.log1p(-((z / a) ** 2))), q, a, n, k)

    def smooth(u: Array) -> Array:
        # towards the axis the integrand ends in a power n, which this makes smooth for every n
        x = reach * u**_SMOOTHING
        over = (excess - np.expm1(n * np.log(np.sin(x)))) * _SMOOTHING * reach * u ** (_SMOOTHING - 1)
        return over * kernel(np.cos(x), np.sin(x), a / q, k)

    reach = _to_axis(q)
    return punch_scale(k) * (near + integral(smooth, np.ones_like(reach), NODES))


def _to_axis(q: Array) -> Array:
    """The angle that is left beyond the split, one number for all points: they share their nodes."""
    return np.full((1,) * np.ndim(q), np.pi / 2.0 - SPLIT)


def _from_edge_of_power(shape: Shape, q: Array, a: Array, n: Array, k: Array) -> Array:
    return from_edge(shape, a, q, q, np.arcsinh(a / q / 2.0), k, np.any(n > STEEP))


def from_edge(shape: Shape, a: Array, q: Array, c: Array, stop: Array, k: Array, steep: Array | bool = False) -> Array:
    """From z = 0 on in z = c sinh(v), where the path is long in two panels of which the first carries the weight."""
    ratio = c / q

    def smooth(v: Array, sinh: Array) -> Array:
        z = c * sinh
        return shape(difference_root(a, z), z) * np.cosh(v) / (1.0 + (ratio * sinh) ** 2)

    def first(v: Array) -> Array:
        sinh = np.sinh(v)
        return smooth(v, sinh) * np.where(v > 0.0, sinh / np.where(v > 0.0, v, 1.0), 1.0) ** k

    def second(v: Array) -> Array:
        sinh = np.sinh(half + v)
        return smooth(half + v, sinh) * sinh**k

    longest = np.inf if steep else float(np.max(np.where(np.isfinite(stop), stop, 0.0), initial=0.0))
    for length, count in EDGE:
        if longest <= length:
            return raised(ratio, k) * raised(stop, k) * weighted(first, stop, k, count)
    half = stop / 2.0
    return raised(ratio, k) * (raised(half, k) * weighted(first, half, k) + integral(second, half, NODES))


def over_angle(shape: Shape, a: Array, q: Array, stop: Array, k: Array) -> Array:
    """In z = a sin(y) from the split to `stop`, with nodes in s: sines cost ten roots."""
    low = a * np.cos(stop) + np.zeros_like(q)

    def smooth(x: Array) -> Array:
        s = low + x
        z = difference_root(a, s)
        return shape(s, z) * (s / z) * (z / q) ** k / (1.0 + (z / q) ** 2) / q

    return integral(smooth, a * np.cos(SPLIT) - low, 32)


def kernel(sine: Array, cosine: Array, ratio: Array, k: Array) -> Array:
    """q**(1 - k) z**k dz/(q**2 + z**2) over dy, for z = a sin(y) and ratio = a/q."""
    return ratio * ratio**k * (sine**k * cosine) / (1.0 + (ratio * sine) ** 2)


def over_cap(shape: Shape, q: Array, root: Array, b: Array, k: Array, end: Array | float = np.inf) -> Array:
    """The part within a break at s = b, where z = root, of a function of more = b**2 - s**2 and z.

    All its singularities are at negative `more`: z = 0, z = i q and that of the function, -end**2.  In the logarithm
    of the distance to the nearest of them they are pi/2 away from the path, which is counted from either end.
    """
    low = np.minimum(root, end)
    top, half = np.hypot(low, b), np.log1p((b / low) ** 2) / 4.0 + np.zeros_like(q)

    def along(near: Array, risen: Array) -> Array:
        more = risen * (near + low)
        z = np.sqrt(root * root + more)
        return shape(more, z) * (near / z) * (near / q) * (z / q) ** k / (1.0 + (z / q) ** 2)

    def from_low(x: Array) -> Array:
        return along(low * np.exp(x), low * np.expm1(x))

    def from_top(x: Array) -> Array:
        # near - low cancels where they are alike, its increments far below `top`: 700 units at end = 1e-8 R
        near = top * np.exp(-x)
        return along(near, np.where(near > 2.0 * low, near - low, b * (b / (top + low)) + top * np.expm1(-x)))

    return integral_in_strip(from_low, half) + integral_in_strip(from_top, half)
