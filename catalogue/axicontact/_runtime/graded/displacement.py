"""Displacement of a flat punch, of powers and of the other shapes on the graded half-space.

With z = sqrt(a**2 - s**2) and q = sqrt(r**2 - a**2) the surface outside is
2/pi cos(pi k/2) q**(1 - k) times the integral of z**k (d - f(s))/(q**2 + z**2) over 0 < z < a.
Up to z = a/2 in z = c sinh(v), which keeps z = i q away from the path, then in z = a sin(y).

d - f(s) = (d - f(a)) + (f(a) - f(s)), and d - f(a) is (1 - k) a**(1 - k) times the integral of z**(k - 2) times the
fall f(a) - f(s) over 0 < z < a: one integral over the fall, in which next to k = 1 and to the edge nothing cancels.
A shape is the fall over (z/a)**2, as a function of s and z.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..integrals import at_many_radii, difference_root, integral, integral_by_panels, integral_in_strip, of_displacement
from ..interface import Array
from .breaks import past_tip
from .growth import power_excess
from .rules import NODES, raised, sine_over, weighted

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


@at_many_radii(of_displacement, SHARE, everywhere=True)
def sphere_displacement(r: Array, a: Array, R: Array, k: Array) -> Array:
    """Of a sphere of unit height over radius."""
    end = difference_root(R, a)
    return _smooth(lambda s, z: a * (a / (end + np.hypot(end, z))), r, a, k, end)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def hyperboloid_displacement(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f = sqrt(r**2 + b**2) - b, with a singularity at s = i b, close to the tip where b is small."""
    gap = _gap(r, a, k)
    shape = _weighed(gap, lambda s, z: a * (a / (np.hypot(a, b) + np.hypot(s, b))), a)
    near = from_edge(shape, a, gap.q, gap.q, np.arcsinh(a / gap.q / 2.0), k)
    ratio = b / a

    def smooth(x: Array) -> Array:
        y = ratio * np.sinh(x)
        value = shape(a * np.sin(y), a * np.cos(y)) * kernel(np.cos(y), np.sin(y), a / gap.q, k)
        return value * ratio * np.cosh(x)

    far = integral(smooth, np.arcsinh((np.pi / 2.0 - SPLIT) / ratio) + np.zeros_like(gap.q), NODES)
    root = difference_root(a, r)
    return _joined(gap, a, near + far, root * (root / (np.hypot(a, b) + np.hypot(r, b))))


@at_many_radii(of_displacement, SHARE, everywhere=True)
def gaussian_displacement(r: Array, a: Array, s: Array, k: Array) -> Array:
    """Of f = 1 - exp(-r**2/s**2)."""
    square = (a / s) ** 2

    def shape(_: Array, z: Array) -> Array:
        x = (z / s) ** 2
        return square * np.exp(-square) * np.where(x > 0.0, np.expm1(x) / np.where(x > 0.0, x, 1.0), 1.0)

    return _smooth(shape, r, a, k)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def waves_displacement(r: Array, a: Array, q: Array, k: Array) -> Array:
    """Of f = 1 - cos(q r)."""
    gap = _gap(r, a, k)

    def fall(s: Array, z: Array) -> Array:
        x = q / 2.0 * z * (z / (a + s))
        return q * a * (a / (a + s)) * np.sin(q / 2.0 * (a + s)) * np.where(x > 0.0, np.sin(x) / x, 1.0)

    shape = _weighed(gap, fall, a)
    first = np.minimum(SPLIT, 2.0 * np.pi / q / a)
    near = from_edge(shape, a, gap.q, gap.q, np.arcsinh(a * np.sin(first) / gap.q), k)

    def smooth(y: Array) -> Array:
        sine, cosine = np.sin(first + y), np.cos(first + y)
        return shape(a * cosine, a * sine) * kernel(sine, cosine, a / gap.q, k)

    far = integral_by_panels(smooth, np.pi / 2.0 - first + np.zeros_like(gap.q), first, NODES)
    return _joined(gap, a, near + far, _fall(fall, r, a))


@at_many_radii(of_displacement, SHARE, everywhere=True)
def flank_displacement(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = 1 for r > b."""
    at = _break_at(r, a, b)
    return _broken(lambda s, z: a * (a / (a + s)), lambda _: at.root * (at.root / (a + b)), r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def rim_displacement(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = r for r > b."""
    at = _break_at(r, a, b)
    return _broken(lambda s, z: a * a / 2.0 + 0.0 * z, lambda _: at.root * at.root / 2.0, r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def rounding_displacement(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = r - b for r > b."""
    at = _break_at(r, a, b)
    last = at.root * (at.root / (a + b))

    def beyond(s: Array, z: Array) -> Array:
        # s**2 - b**2, of the pair that is small against the radius
        square = np.where(s < z, (s - b) * (s + b), (at.root - z) * (at.root + z))
        return a * (a / (a + s)) * (last + square / (s + b)) / 2.0

    return _broken(beyond, lambda _: last * last / 2.0, r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def rounded_displacement(r: Array, a: Array, b: Array, k: Array) -> Array:
    """Of f' = r/b for r < b, 1 beyond."""
    at = _break_at(r, a, b)

    def within(more: Array) -> Array:
        return at.root * (at.root / (a + b)) + more / (2.0 * b)

    tip = power_displacement(r, a, 2.0, k) / (2.0 * b)
    return np.where(a <= b, tip, _broken(lambda s, z: a * (a / (a + s)), within, r, a, k, at))


@at_many_radii(of_displacement, SHARE, everywhere=True)
def tipped_displacement(r: Array, a: Array, R: Array, b: Array, end: Array, k: Array) -> Array:
    """Of the sphere R up to r = b, continued by its tangent cone."""
    slope = b / end

    def past(x: Array) -> Array:
        return past_tip(x, R, b, end)

    def within(more: Array) -> Array:
        return slope * past(a) + more / (end + np.sqrt(end * end + more))

    at = _Break(b, np.sqrt(np.maximum(past(a), 0.0) * (a + b)), -past(r) * (b + r), end)
    tip = sphere_displacement(r, np.minimum(a, b), R, k)
    return np.where(a <= b, tip, _broken(lambda s, z: slope * a * (a / (a + s)), within, r, a, k, at))


class _Gap(NamedTuple):
    """What weighs the fall, outside with the share of a flat punch and inside, where q is a, for d - f(a) alone."""

    outside: Array
    q: Array
    even: Array
    grown: Array


def _gap(r: Array, a: Array, k: Array) -> _Gap:
    outside = r > a
    q = np.where(outside, difference_root(np.maximum(r, a), a), a)
    share = (1.0 - k) * np.where(outside, punch_share(r, a, k), 1.0)
    # in this order: far away the share is small as that power is large
    even = np.where(share > 0.0, share * raised(q / a, k), 0.0)
    return _Gap(outside, q, even, np.where(outside, punch_scale(k), 0.0) + share * raised(a / q, -k))


def _weighed(gap: _Gap, shape: Shape, a: Array) -> Shape:
    return lambda s, z: shape(s, z) * (gap.grown * (z / a) ** 2 + gap.even)


def _fall(shape: Shape, r: Array, a: Array) -> Array:
    """That of the profile at r."""
    root = difference_root(a, r)
    return shape(r, root) * (root / a) ** 2


def _joined(gap: _Gap, a: Array, value: Array, fall: Array) -> Array:
    return np.where(a > 0.0, np.where(gap.outside, value, value + fall), 0.0)


def _smooth(shape: Shape, r: Array, a: Array, k: Array, c: Array | float = np.inf) -> Array:
    """Of a profile without singularities near, but for one at z = i c."""
    gap = _gap(r, a, k)
    own, close = _weighed(gap, shape, a), np.minimum(gap.q, c)
    near = from_edge(own, a, gap.q, close, np.arcsinh(a / close / 2.0), k)
    return _joined(gap, a, near + over_angle(own, a, gap.q, np.full_like(gap.q, np.pi / 2.0), k), _fall(shape, r, a))


class _Break(NamedTuple):
    """sqrt(a**2 - b**2), b**2 - r**2, and the -end**2 of b**2 - s**2 at which the fall within is singular."""

    b: Array
    root: Array
    more: Array
    end: Array | float = np.inf


def _break_at(r: Array, a: Array, b: Array) -> _Break:
    return _Break(b, difference_root(a, b), (b - r) * (b + r))


def _broken(beyond: Shape, within: Callable[[Array], Array], r: Array, a: Array, k: Array, at: _Break) -> Array:
    """Of a profile with a break, for a > b; `within` is the fall itself, as a function of b**2 - s**2."""
    gap = _gap(r, a, k)
    own = _weighed(gap, beyond, a)
    near = from_edge(own, a, gap.q, gap.q, np.arcsinh(np.minimum(at.root, a / 2.0) / gap.q), k)
    value = near + over_angle(own, a, gap.q, np.maximum(np.arctan2(at.root, at.b), SPLIT), k)
    tip = _weighed(gap, lambda more, z: within(more) / (z / a) ** 2, a)
    value = value + over_cap(tip, gap.q, at.root, at.b, k, at.end)
    fall = np.where(at.more < 0.0, _fall(beyond, r, a), within(np.maximum(at.more, 0.0)))
    return np.where(a > at.b, _joined(gap, a, value, fall), 0.0)
