"""Contact with a cohesive zone a < r < c of constant attraction sigma_0, by q = sqrt(c**2 - a**2).

The gap of the normal contact at c is 2/pi times the integral of g'(t) arccos(t/c) from a to c: positive terms, however
close c and a are.  Its rate with c weighs g'(t) by t/(c sqrt(c**2 - t**2)).  In the angles of `opening` nothing is
singular at t = c; singularities of g' elsewhere are kept pi/2 away from the path.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..integrals import STRIPS, difference_root, integral_by_length, integral_in_strip
from ..interface import Array, Result
from ..inverse import inverse

Opening = Callable[[Array, Array], tuple[Array, Array]]
"""Of q and a the gap of the normal contact at c, and its rate with c."""
Slope = Callable[..., Array]
Lengths = tuple[tuple[float, int], ...]
POLYNOMIAL, ENTIRE = ((0.45, 8), (np.inf, 16)), ((0.5, 16), (np.inf, 32))
"""Nodes by the length of a path, for a slope that is a polynomial up to the fifth power or has no singularities."""
LENGTHS = (*STRIPS, (18.03, 128))
"""Next to no contact a path is long: with these, four panels go as far as there are states."""
NARROW = 0.7
"""Of pi/2: how close images of the end of a profile come to the path."""
INSIDE, WITHIN = 0.75, 1.0 - 1e-6
"""Of the largest q: where the gap is looked at for a first guess, and a zone closer to the end is not looked for."""
DECAY, FALLING = 40.0, 1.2
"""exp(-40) of a gap is less than its rounding; powers above 1.2 leave even less of it, and need half of the nodes."""
EXPONENTS = (0.5, 4.0)
"""Of the gap in q, as a guess: from the ring alone to the narrow zone of a steep profile."""
CLOSE = 3e-8
"""Miss of the gap, by itself, that one more step in q makes small beside rounding."""
LEAST = 1e-17
"""What a root beyond a break is no less than, over that of c: it would be less than 0 by rounding where c is far."""
CLOSEST = 1e-9
"""Root of 1 - (r/c)**2 next to r = c: no double is closer but c itself."""
EMPTY = 0.5 * np.pi - 1.0
"""Gap at the end of a ring without contact, by its load."""


class Separated(NamedTuple):
    """Depth and force where the surfaces attract each other without contact."""

    depth: Result
    force: Result


def outer_radius(q: Array, a: Array) -> Array:
    """The radius c."""
    return np.hypot(a, q)


def half_angle(q: Array, a: Array) -> Array:
    """The angle whose cosine is a/c."""
    return np.arctan2(q, a)


def both(
    integrand: Callable[[Array], tuple[Array, Array]],
    stop: Array,
    width: Array | float = 1.0,
    lengths: Lengths = LENGTHS,
) -> tuple[Array, Array]:
    """The integrals of both members of a pair from 0 to `stop`."""
    if hasattr(stop, "integrals"):
        return stop.integrals(integrand, width, lengths)
    gap = integral_by_length(lambda x: integrand(x)[0], stop, width, lengths)
    return gap, integral_by_length(lambda x: integrand(x)[1], stop, width, lengths)


def opening(slope: Slope, q: Array, a: Array, lengths: Lengths) -> tuple[Array, Array]:
    """For g' without singularities."""
    return _along(slope, np.hypot(a, q), 0.0, np.arctan2(q, a), 1.0, lengths)


def _along(
    slope: Slope, c: Array, start: Array | float, length: Array, width: Array | float, lengths: Lengths
) -> tuple[Array, Array]:
    def gained(v: Array) -> tuple[Array, Array]:
        u = start + v
        cosine = np.cos(u)
        growth = slope(c * cosine)
        return growth * u * np.sin(u), growth * cosine

    gap, rate = both(gained, length, width, lengths)
    return 2.0 / np.pi * c * gap, 2.0 / np.pi * rate


def opening_power(slope: Slope, q: Array, a: Array, n: Array | float) -> tuple[Array, Array]:
    """For a g' that is a power n - 1 of t."""
    c = np.hypot(a, q)
    far = np.where(a > 0.0, q / np.where(a > 0.0, a, 1.0), np.inf)
    end = np.arcsinh(np.minimum(np.arcsinh(far), DECAY / np.minimum(n, FALLING)))

    def gained(v: Array) -> tuple[Array, Array]:
        # t = c/cosh(sinh(v)), with singularities above acosh(pi/2) and beyond, at the distance pi/2
        steep = np.sinh(v)
        side, secant = np.sinh(steep), np.cosh(steep)
        growth = slope(c / secant) / secant * np.cosh(v)
        return growth * np.arctan(side) * (side / secant), growth / secant

    gap, rate = both(gained, end)
    return 2.0 / np.pi * c * gap, 2.0 / np.pi * rate


def opening_beside(slope: Slope, q: Array, a: Array, b: Array) -> tuple[Array, Array]:
    """For g' with singularities at b on the imaginary axis, which is next to the end of the path where c is far."""
    c, angle = np.hypot(a, q), np.arctan2(q, a)
    scale = np.arcsinh(b / c)
    last, end = _crowded(angle, np.arctan2(a, q), scale)

    def gained(v: Array) -> tuple[Array, Array]:
        u = 2.0 * scale * np.cosh(last - 0.5 * v) * np.sinh(0.5 * v)
        cosine = np.cos(u)
        growth = slope(c * cosine) * scale * np.cosh(last - v)
        return growth * u * np.sin(u), growth * cosine

    gap, rate = both(gained, end, NARROW)
    return 2.0 / np.pi * c * gap, 2.0 / np.pi * rate


def _crowded(angle: Array, rest: Array, scale: Array) -> tuple[Array, Array]:
    """Of pi/2 - u = scale sinh(last - v): the last v, at pi/2, and the v of an angle u that leaves a rest to it."""
    x, y = 0.5 * np.pi / scale, rest / scale
    # the difference of arcsinh(x) and arcsinh(y)
    return np.arcsinh(x), np.arcsinh(angle / scale * (x + y) / (x * np.sqrt(1.0 + y * y) + y * np.sqrt(1.0 + x * x)))


def opening_below(slope: Slope, q: Array, a: Array, R: Array) -> tuple[Array, Array]:
    """For g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    c, angle = np.hypot(a, q), np.arctan2(q, a)
    reach = difference_root(R, a)
    left = np.sqrt(np.maximum(reach - q, 0.0) * (reach + q))
    scale = np.arcsinh(left / c)
    inside = scale > 0.0
    scale = np.where(inside, scale, 1.0)
    end = np.arcsinh(angle / scale)

    def gained(v: Array) -> tuple[Array, Array]:
        u = scale * np.sinh(v)
        sine, cosine = np.sin(u), np.cos(u)
        growth = slope(c * cosine, np.hypot(left, c * sine)) * scale * np.cosh(v)
        return growth * u * sine, growth * cosine

    gap, rate = both(gained, end, NARROW)
    factor = np.where(inside, 2.0 / np.pi, np.inf)
    return factor * c * gap, factor * rate


def opening_tip(slope: Slope, q: Array, a: Array, b: Array, R: Array | None = None) -> tuple[Array, Array]:
    """What is below a break at b of g' that is a polynomial, or singular at t = R."""
    c, end = np.hypot(a, q), np.arctan2(q, a)
    # c**2 - b**2 without a difference of squares
    outer = np.where(a < b, np.sqrt(np.maximum(q - difference_root(b, a), 0.0) * (q + difference_root(b, a))), q)
    start = np.where(a < b, np.arctan2(outer, b), end)
    start = np.minimum(np.where(c > b, start, 0.0), end)
    start = np.where(a < b, start, end)
    length = end - start

    def below(t: Array) -> Array:
        # elsewhere the slope may be no number: where nothing is below the break, or c is so far that t is its rounding
        return slope(np.minimum(np.abs(t), b))

    if R is None:
        return _along(below, c, start, length, 1.0, POLYNOMIAL)
    # the singularity is (R - b)/sqrt(max(c, R)**2 - b**2) away at least; 64 nodes have to do for the nearest ones.
    # A width of nothing, where c is out of range, is none
    far = np.maximum(c, R)
    width = 2.0 / np.pi * (R - b) / np.sqrt((far - b) * (far + b))
    return _along(below, c, start, length, np.maximum(width, length / 9.0 + 1e-300), STRIPS)


def opening_beyond(slope: Slope, q: Array, a: Array, b: Array) -> tuple[Array, Array]:
    """What is beyond it; `slope` takes t and sqrt(t**2 - b**2), in which it is regular but for the imaginary axis."""
    c, inner, short = np.hypot(a, q), difference_root(a, b), difference_root(b, a)
    # roots of start**2 - b**2 and c**2 - b**2, and of the difference of these
    outer = np.where(a < b, np.sqrt(np.maximum(q - short, 0.0) * (q + short)), np.hypot(inner, q))
    # next to each other the two roots are equal, and their difference is not
    whole = np.where(a < b, outer, q)
    # where nothing is beyond the break the path has no length
    outer = np.where(whole > 0.0, outer, b)
    scale = np.arcsinh(b / outer)
    # root = outer cos(angle), angle = pi/2 - scale sinh(last - v)
    angle = np.arctan2(whole, inner)
    last, end = _crowded(angle, np.arctan2(inner, whole), scale)

    def gained(v: Array) -> tuple[Array, Array]:
        turned = 2.0 * scale * np.cosh(last - 0.5 * v) * np.sinh(0.5 * v)
        root, side = outer * np.maximum(np.cos(turned), LEAST), outer * np.sin(turned)
        t = np.sqrt(b * b + root * root)
        growth = slope(t, root) * root * scale * np.cosh(last - v)
        return growth * np.arctan2(side, t) * (side / t), growth / c

    gap, rate = both(gained, end)
    return 2.0 / np.pi * gap, 2.0 / np.pi * rate


def work_of_zone(opened: Opening, q: Array, a: Array, E_star: Array, sigma_0: Array) -> Array:
    """sigma_0 times the gap at c."""
    return sigma_0 * (opened(q, a)[0] + ring_of_zone(q, a, E_star, sigma_0))


def zone_within(opened: Opening, a: Array, E_star: Array, dgamma: Array, sigma_0: Array, largest: Array) -> Array:
    """The radius of a contact; not a number where its zone would reach beyond the largest q of a profile that ends."""
    # a contact beyond the end leaves no q, or none but 0
    reached = (largest > 0.0) & (work_of_zone(opened, WITHIN * largest, a, E_star, sigma_0) >= dgamma)
    return np.where(reached, a, np.nan)


def zone_like(
    opened: Opening, a: Array, E_star: Array, dgamma: Array, sigma_0: Array, largest: Array | float = np.inf
) -> Array:
    """About the q at which the gap at c is dgamma/sigma_0."""
    # the gap of the ring alone is nearly q**2/(2 a + q/EMPTY) of its load
    part = 0.25 * np.pi * (dgamma / sigma_0) * (E_star / sigma_0)
    wide = 0.5 / EMPTY * part
    # roots apart: for lengths beyond 1e154 the product leaves the range
    start = wide + np.hypot(wide, np.sqrt(2.0 * a) * np.sqrt(part))
    start = np.minimum(start, INSIDE * largest)
    # both parts of the gap there, as powers of q
    c, (gap, rate) = np.hypot(a, start), opened(start, a)
    known = gap > 0.0
    grown = np.where(known, start / np.where(known, gap, 1.0) * (start / c) * rate, 1.0)
    ring = 1.0 + a / c
    blend = 0.5 * (grown + ring)
    own = ring_of_zone(start, a, E_star, sigma_0) * (sigma_0 / dgamma)
    whole = (gap * (sigma_0 / dgamma)) ** (blend / grown) + own ** (blend / ring)
    return np.minimum(start * whole ** (-1.0 / blend), WITHIN * largest)


def root_of_zone(
    opened: Opening, a: Array, E_star: Array, dgamma: Array, sigma_0: Array, largest: Array | float = np.inf
) -> Array:
    """That q."""
    start = zone_like(opened, a, E_star, dgamma, sigma_0, largest)
    share, value = 4.0 / np.pi * (sigma_0 / E_star), dgamma / sigma_0

    def curve(q: Array) -> tuple[Array, Array]:
        whole, rise = with_ring(*opened(q, a), q, a, share)
        return whole, rise / whole

    return inverse(curve, value, start, EXPONENTS, largest, smooth=True, noise=CLOSE * value)


def with_ring(gap: Array, rate: Array, q: Array, a: Array, share: Array) -> tuple[Array, Array]:
    """The gap at c with a share of what the ring adds under a unit load, and its rate with ln q."""
    c, angle = np.hypot(a, q), np.arctan2(q, a)
    sine, rest = q / c, q / (c + a)
    return gap + share * q * (angle - rest), q * sine * (rate + share * (angle / sine - sine * rest))


def ring_of_zone(q: Array, a: Array, E_star: Array, sigma_0: Array) -> Array:
    """What the ring adds to the gap at c."""
    return 4.0 / np.pi * (sigma_0 / E_star) * q * (np.arctan2(q, a) - q / (np.hypot(a, q) + a))


def sunk(q: Array, E_star: Array, sigma_0: Array) -> Array:
    """What the ring takes of the depth."""
    return 2.0 * (sigma_0 / E_star) * q


def pull_of_zone(q: Array, a: Array, sigma_0: Array) -> Array:
    """Its pull."""
    c = np.hypot(a, q)
    return 2.0 * sigma_0 * (c * c * np.arctan2(q, a) + a * q)


def tension_of_zone(r: Array, q: Array, a: Array, sigma_0: Array) -> Array:
    """What it takes of the pressure: sigma_0 on itself, nothing beyond."""
    inside = 2.0 / np.pi * np.arctan2(q, difference_root(a, r))
    return sigma_0 * np.where(r < a, inside, np.where(r < np.hypot(a, q), 1.0, 0.0))


def lift_of_zone(r: Array, q: Array, a: Array, E_star: Array, sigma_0: Array) -> Array:
    """What it takes of the displacement: as far as the load reaches, sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a on."""
    c, place = np.hypot(a, q), np.maximum(r, a)
    wide = difference_root(place, a)
    within = place < c
    # x = r sin(turned) from the axis of the angle at the nearer of both radii
    near, far = np.minimum(place, c), np.maximum(place, c)
    reach = np.where(within, wide, q)
    kc = difference_root(far, near) / far
    held = np.where(place > a, np.arctan2(a, wide), 0.5 * np.pi)
    end = np.arctan2(reach, a)
    ring = _ring(near, far, kc, end, within)
    return 4.0 / np.pi * (sigma_0 / E_star) * (q * held + ring)


def _ring(near: Array, far: Array, kc: Array, end: Array, within: Array) -> Array:
    """Integral of sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a to the nearer of c and r.

    With x = near cos(u) the longer root is far sqrt(kc**2 + (near/far)**2 sin(u)**2): next to the edge of the ring that
    is a small number beside the sine, and in u = kc sinh(v) regular.
    """
    ratio = near / far
    scale = np.maximum(kc, CLOSEST)
    last = np.arcsinh(end / scale)

    def rate(v: Array) -> Array:
        u = scale * np.sinh(v)
        sine = np.sin(u)
        root = np.hypot(kc, ratio * sine)
        return np.where(within, far * root, near * (sine / root) * (sine * ratio)) * scale * np.cosh(v)

    return integral_in_strip(rate, last, NARROW)


def alone(opened: Opening, c: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    """The depth of surfaces that attract each other up to the radius c without contact."""
    gap = np.where(c == 0.0, 0.0, opened(c, np.zeros_like(c))[0])
    return gap - dgamma / sigma_0 - 4.0 / np.pi * (sigma_0 / E_star) * c
