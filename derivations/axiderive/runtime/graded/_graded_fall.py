"""Displacement of the other shapes, from what a profile falls below its height at the edge of the contact.

d - f(s) = (d - f(a)) + (f(a) - f(s)), and d - f(a) is (1 - k) a**(1 - k) times the integral of z**(k - 2) times the
fall f(a) - f(s) over 0 < z < a: one integral over the fall, in which next to k = 1 and to the edge nothing cancels.
A shape is the fall over (z/a)**2, as a function of s and z.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from ._along import at_many_radii
from ._elementwise import Array
from ._graded_breaks import past_tip
from ._graded_displacement import (
    SHARE,
    SPLIT,
    Shape,
    from_edge,
    kernel,
    over_angle,
    over_cap,
    power_displacement,
    punch_scale,
    punch_share,
)
from ._graded_rules import NODES, raised
from ._integrals import difference_root, integral, integral_by_panels, of_displacement


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
    slope, past = b / end, partial(past_tip, R=R, b=b, end=end)

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
