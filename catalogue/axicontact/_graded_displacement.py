"""Displacement of a flat punch and of powers on the graded half-space, and the integrals of all displacements.

With z = sqrt(a**2 - s**2) and q = sqrt(r**2 - a**2) the surface outside is
2/pi cos(pi k/2) q**(1 - k) times the integral of z**k (d - f(s))/(q**2 + z**2) over 0 < z < a.
Up to z = a/2 in z = c sinh(v), which keeps z = i q away from the path, then in z = a sin(y).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ._elementwise import Array
from ._graded_growth import power_excess
from ._graded_rules import NODES, raised, sine_over, sinh_over, weighted
from ._integrals import difference_root, integral, integral_in_strip

Shape = Callable[[Array, Array], Array]
"""A function of s and z, with s**2 + z**2 = a**2."""
SPLIT = np.pi / 6.0
_SMOOTHING = 8


def punch_scale(k: Array) -> Array:
    """2/pi cos(pi k/2), without loss near k = -1 and 1."""
    return 2.0 / np.pi * np.sin(np.pi / 2.0 * (1.0 - np.abs(k)))


def punch_share(r: Array, a: Array, k: Array) -> Array:
    """w/d outside a flat punch, for r > a."""
    q = difference_root(r, a)
    stop = np.arcsinh(a / q)
    return punch_scale(k) * from_edge(lambda s, z: np.ones_like(s), a, q, q, stop, k)


def power_sag(r: Array, a: Array, n: Array, k: Array) -> Array:
    """Of f = r**n."""
    q = difference_root(r, a)
    near = from_edge(lambda s, z: (s / a) ** n, a, q, q, np.arcsinh(a / q / 2.0), k)

    whole = np.floor(n)
    weight = n - whole

    def smooth(x: Array) -> Array:
        # whole powers need no weight; with n in the weight the rule cancels for large n
        return sine_over(x) ** weight * np.sin(x) ** whole * kernel(np.cos(x), np.sin(x), a / q, k)

    reach = np.pi / 2.0 - SPLIT
    far = reach**weight * reach * weighted(smooth, np.full_like(q, reach), weight)
    return punch_scale(k) * a**n * (near + far)


def power_displacement(r: Array, a: Array, n: Array, k: Array) -> Array:
    """The displacement of f = r**n inside and outside the contact: what d is above f(a), and f(a) above f(s)."""
    ratio = np.where(r < 0.5 * a, np.log(r / a), np.where(r < a, np.log1p((r - a) / a), 0.0))
    excess, inside = power_excess(n, k), -np.expm1(n * ratio)
    q = difference_root(r, a)
    near = from_edge(lambda s, z: -np.expm1(n / 2.0 * np.log1p(-((z / a) ** 2))), a, q, q, np.arcsinh(a / q / 2.0), k)

    def smooth(u: Array) -> Array:
        # towards the axis the integrand ends in a power n, which this makes smooth for every n
        x = reach * u**_SMOOTHING
        fall = -np.expm1(n * np.log(np.sin(x))) * kernel(np.cos(x), np.sin(x), a / q, k)
        return fall * _SMOOTHING * reach * u ** (_SMOOTHING - 1)

    reach = np.pi / 2.0 - SPLIT
    outside = excess * punch_share(r, a, k) + punch_scale(k) * (near + integral(smooth, np.ones_like(q), NODES))
    return np.where(a > 0.0, a**n * np.where(r > a, outside, excess + inside), 0.0)


def from_edge(shape: Shape, a: Array, q: Array, c: Array, stop: Array, k: Array) -> Array:
    """From z = 0 on in z = c sinh(v), in two panels of which the first carries the weight."""
    ratio = c / q

    def smooth(v: Array) -> Array:
        z = c * np.sinh(v)
        return shape(difference_root(a, z), z) * np.cosh(v) / (1.0 + (ratio * np.sinh(v)) ** 2)

    half = stop / 2.0
    first = raised(half, k) * weighted(lambda v: smooth(v) * sinh_over(v) ** k, half, k)
    second = integral(lambda v: smooth(half + v) * np.sinh(half + v) ** k, half, NODES)
    return raised(ratio, k) * (first + second)


def over_angle(shape: Shape, a: Array, q: Array, stop: Array, k: Array) -> Array:
    def smooth(y: Array) -> Array:
        sine, cosine = np.sin(SPLIT + y), np.cos(SPLIT + y)
        return shape(a * cosine, a * sine) * kernel(sine, cosine, a / q, k)

    return integral(smooth, stop - SPLIT, NODES)


def kernel(sine: Array, cosine: Array, ratio: Array, k: Array) -> Array:
    """q**(1 - k) z**k dz/(q**2 + z**2) over dy, for z = a sin(y) and ratio = a/q."""
    return ratio * (ratio * sine) ** k * cosine / (1.0 + (ratio * sine) ** 2)


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
