"""The quantities of normal contact straight from their definitions, by quadrature of f' and (r f')'.

Nothing of the engine is used here.  The order of the iterated Abel integrals
is exchanged, which leaves one integral over the profile for each quantity:

* (11.29)  g(a) = a int f'(s) du                                  with s = a sin(u)
* (11.20)  F = 2 E* [(d - g(a)) a + int f'(s) s**2 du]
* (11.23)  p = E*/pi [int (s f')' K(s, r) ds + sum over the kinks of b (jump of f') K(b, r)
                      + (d - g(a))/sqrt(a**2 - r**2)]
* (11.26)  w = 2/pi [(d - g(a)) asin(a/r) + int f'(s) (a asin(a/r) - z atan(z/q)) du]
           with z = a cos(u), q = sqrt(r**2 - a**2)

K(s, r) = int_max(s, r)^a dt/sqrt((t**2 - s**2)(t**2 - r**2)) is symmetric and
has a logarithm at s = r.  d - g(a) vanishes for a compact contact.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable

import mpmath as mp

from .rules import integrate
from .shape import Number, Shape, Stretch

Weight = Callable[[Stretch, Number, Number], Number]
GUARD = 30
"""Digits carried beyond those asked for: 1 - 1e-9 costs 9 to 18 of them."""


def panels_no_longer_than(longest: float, lo: Number, hi: Number) -> list[Number]:
    """Equidistant breakpoints from lo to hi."""
    count = max(1, math.ceil((hi - lo) / longest))
    return [lo + (hi - lo) * i / count for i in range(count)] + [hi]


def _over_angle(shape: Shape, a: Number, weight: Weight, extra: tuple[complex, ...], digits: int) -> Number:
    """int weight(piece, s, a cos u) du over all pieces, s = a sin(u); `extra` are singular points in u."""
    return mp.fsum(_over_piece(piece, a, weight, extra, digits) for piece in shape.stretches)


def _over_piece(piece: Stretch, a: Number, weight: Weight, extra: tuple[complex, ...], digits: int) -> Number:
    lo, hi = _angle(piece.lo, a), _angle(piece.hi, a)
    singular = (*(cmath.asin(z / float(a)) for z in piece.singular), *extra)

    def f(u: Number) -> Number:
        return weight(piece, a * mp.sin(u), a * mp.cos(u))

    ends = panels_no_longer_than(6 * piece.wavelength / float(a), lo, hi)
    return mp.fsum(integrate(f, x, y, singular, digits) for x, y in itertools.pairwise(ends))


def _angle(s: Number, a: Number) -> Number:
    return mp.atan2(s, mp.sqrt((a - s) * (a + s)))


def depth(shape: Shape, a: Number, digits: int) -> Number:
    """g(a), (11.29)."""
    return a * _over_angle(shape, a, lambda piece, s, z: piece.slope(s), (), digits)


def force(shape: Shape, a: Number, digits: int, free_depth: Number | None = None) -> Number:
    """F/E*, (11.20) with the order of integration exchanged; `free_depth` is d of a complete contact."""
    total = _over_angle(shape, a, lambda piece, s, z: piece.slope(s) * s * s, (), digits)
    if free_depth is not None:
        total += (free_depth - depth(shape, a, digits)) * a
    return 2 * total


def depth_rate(shape: Shape, a: Number, digits: int) -> Number:
    """dg/da, the integral (11.29) differentiated under its sign; each kink adds what its moving angle brings in."""
    total = _over_angle(shape, a, lambda piece, s, z: piece.bend(s), (), digits)
    return total + mp.fsum(b * jump / mp.sqrt((a - b) * (a + b)) for b, jump in shape.kinks if b < a)


def force_rate(shape: Shape, a: Number, digits: int) -> Number:
    """(dF/da)/E*, (11.20) differentiated under its sign."""
    total = _over_angle(shape, a, lambda piece, s, z: (piece.bend(s) + piece.slope(s)) * s * s / a, (), digits)
    return 2 * (total + mp.fsum(b**3 * jump / (a * mp.sqrt((a - b) * (a + b))) for b, jump in shape.kinks if b < a))


def displacement(shape: Shape, a: Number, r: Number, digits: int, free_depth: Number | None = None) -> Number:
    """w(r) for r > a, (11.26) with the order of integration exchanged."""
    q = mp.sqrt((r - a) * (r + a))
    inclination = mp.atan2(a, q)
    near = complex(0, float(mp.asinh(q / a)))
    extra = (cmath.pi / 2 + near, cmath.pi / 2 - near)

    def weight(piece: Stretch, s: Number, z: Number) -> Number:
        return piece.slope(s) * (a * inclination - z * mp.atan(z / q))

    total = _over_angle(shape, a, weight, extra, digits)
    if free_depth is not None:
        total += (free_depth - depth(shape, a, digits)) * inclination
    return 2 * total / mp.pi


def pressure(shape: Shape, a: Number, r: Number, digits: int, free_depth: Number | None = None) -> Number:
    """p(r)/E* for 0 < r < a, (11.23) with the order of integration exchanged."""
    total = mp.fsum(_pressure_piece(piece, a, r, digits) for piece in shape.stretches)
    total += mp.fsum(b * jump * kernel(b, r, a) for b, jump in shape.kinks if b < a and jump != 0)
    if free_depth is not None:
        total += (free_depth - depth(shape, a, digits)) / mp.sqrt((a - r) * (a + r))
    return total / mp.pi


def kernel(s: Number, r: Number, a: Number) -> Number:
    """K(s, r)."""
    large, small = max(s, r), min(s, r)
    return _kernel(large, (large - small) * (large + small), (a - large) * (a + large))


def _kernel(large: Number, gap: Number, rest: Number) -> Number:
    """K(s, r) from M = max(s, r), M**2 - min(s, r)**2 and a**2 - M**2, by Bulirsch's transformation (el1)."""
    m, complement = mp.mpf(1), mp.sqrt(gap) / large
    y = mp.sqrt(gap / rest)
    turns, enough = 0, mp.mpf(10) ** (-mp.mp.dps // 2)
    while True:
        product, before = m * complement, m
        m += complement
        y -= product / y
        if y == 0:
            y = mp.sqrt(product) * mp.eps
        if abs(before - complement) <= enough * before:
            break
        complement = 2 * mp.sqrt(product)
        turns = 2 * turns + (y < 0)
    return (mp.atan(m / y) + mp.pi * (turns + (y < 0))) / (m * large)


def _pressure_piece(piece: Stretch, a: Number, r: Number, digits: int) -> Number:
    """int (s f')' K(s, r) ds over one piece: in x = u - asin(r/a) next to r, in the angle u near the tip."""
    lo, hi, centre = _angle(piece.lo, a), _angle(piece.hi, a), _angle(r, a)
    parts = [
        (lo, min(hi, centre / 2), False),
        (max(lo, centre / 2), min(hi, centre), True),
        (max(lo, centre), hi, True),
    ]
    singular = [cmath.asin(z / float(a)) for z in piece.singular]
    kernel_points = (complex(centre), complex(-centre), complex(mp.pi - centre))
    rest_at_r = (a - r) * (a + r)
    across, along = mp.cos_sin(centre)

    def next_to_r(x: Number) -> Number:
        # x is the exact distance u - asin(r/a) to the logarithm
        c, i = mp.cos_sin(x)
        return integrand(c * across - i * along, i * across + c * along, i)

    def from_the_tip(u: Number) -> Number:
        c, i = mp.cos_sin(u)
        return integrand(c, i, i * across - c * along)

    def integrand(cosine: Number, sine: Number, away: Number) -> Number:
        s, z = a * sine, a * cosine
        gap = abs(a * a * away * (sine * across + cosine * along))
        large, rest = (s, z * z) if away > 0 else (r, rest_at_r)
        return piece.bend(s) * _kernel(large, gap, rest) * z

    total = mp.mpf(0)
    for start, end, near in parts:
        if end <= start:
            continue
        shift = centre if near else mp.mpf(0)
        points = [z - complex(shift) for z in (*singular, *kernel_points[1:])]
        points.append(complex(0) if near else kernel_points[0])
        ends = panels_no_longer_than(6 * piece.wavelength / float(a), start - shift, end - shift)
        f = next_to_r if near else from_the_tip
        total += mp.fsum(integrate(f, x, y, points, digits) for x, y in itertools.pairwise(ends))
    return total
