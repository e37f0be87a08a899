"""The quantities of normal contact straight from their definitions, by quadrature of f, f' and (r f')'.

Nothing of the engine is used here.  The order of the iterated Abel integrals is exchanged, which leaves one integral
over the profile for each quantity.  With s = t cos(y) the weight (t**2 - s**2)**((k - 1)/2) is a power of sin(y), whose
singular point y = 0 is the edge of the contact:

* (11.61)  g(a) = a int f'(s) sin(y)**k dy
* (11.51)  F = 2 H/(1 + k) [a**k int f'(s) s**2 sin(y)**k dy + a**(1 + k) (d - g(a))]
* (11.56)  w = 2 cos(k pi/2)/pi [d T - q**(1 - k) a**(1 + k) int f(s) s sin(y)**k/(r**2 - s**2) dy/a]
           with T = int tan(x)**k dx from 0 to asin(a/r) and q = sqrt(r**2 - a**2), by parts
* (11.53)  p = H/pi [int_r^a g'(t) (t**2 - r**2)**((k - 1)/2) dt + (d - g(a)) (a**2 - r**2)**((k - 1)/2)], nested:
           the kernel that exchange would leave is an Appell function

On the homogeneous half-space, k = 0 and H = E*, nothing is singular at the edge, s = a sin(u) serves as well, and

* (11.26)  w = 2/pi [(d - g(a)) asin(a/r) + int f'(s) (a asin(a/r) - z atan(z/q)) du] with z = a cos(u)
* (11.23)  p = E*/pi [int (s f')' K(s, r) ds + sum over the kinks of b (jump of f') K(b, r)
                      + (d - g(a))/sqrt(a**2 - r**2)]

K(s, r) = int_max(s, r)^a dt/sqrt((t**2 - s**2)(t**2 - r**2)) is symmetric and has a logarithm at s = r.
d = g(a) for a compact contact.
"""

from __future__ import annotations

import cmath
import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import mpmath as mp

from .. import notation as nt
from . import rules
from .rules import Panel, integrate
from .shape import Number, Shape, Stretch, Values, number

Integrand = Callable[[Stretch, Any], Any]
GUARD = 30
"""Digits carried beyond those asked for: 1 - 1e-9 costs 9 to 18 of them."""
NEAR = 0.25
"""A break this close to the edge, in units of the distance of the other singular points, is integrated across."""


@dataclass(frozen=True)
class Face(ABC):
    """The profile on a half-space with c_N(x) = H |x|**k, H = E* for k = 0; moduli are left to the caller."""

    shape: Shape
    k: Number
    digits: int

    def depth(self, a: Number) -> Number:
        """g(a)."""
        return a * self._over(a, lambda piece, s: piece.slope(s))

    def force(self, a: Number, depth: Number | None = None) -> Number:
        """F/H; `depth` is d of a complete contact."""
        total = a**self.k * self._over(a, lambda piece, s: piece.slope(s) * s * s)
        if depth is not None:
            total += a ** (1 + self.k) * (depth - self.depth(a))
        return 2 * total / (1 + self.k)

    def depth_rate(self, a: Number) -> Number:
        """dg/da, the integral differentiated under its sign; each kink adds what its moving angle brings in."""
        return self._rate(a, [(a - b) * (a + b) for b, _ in self.shape.kinks])

    def force_rate(self, a: Number) -> Number:
        """(dF/da)/H of the compact contact: the weight a**k s**2 f'(s) differentiated at constant angle."""
        k = self.k
        total = a ** (k - 1) * self._over(
            a, lambda piece, s: (k * piece.slope(s) + piece.bend(s) + piece.slope(s)) * s * s
        )
        kinks = ((b, jump, (a - b) * (a + b)) for b, jump in self.shape.kinks if b < a)
        total += mp.fsum(b**3 * jump * gap ** ((k - 1) / 2) / a for b, jump, gap in kinks)
        return 2 * total / (1 + k)

    def _rate(self, t: Number, gaps: list[Number]) -> Number:
        """g'(t) with t**2 - b**2 given for every break b."""
        return self._bend(t, gaps) + t**-self.k * mp.fsum(
            b * jump * gap ** ((self.k - 1) / 2)
            for (b, jump), gap in zip(self.shape.kinks, gaps, strict=True)
            if gap > 0 and jump != 0
        )

    @abstractmethod
    def displacement(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """w(r) for r > a."""

    @abstractmethod
    def pressure(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """p(r)/H for 0 < r < a."""

    @abstractmethod
    def _bend(self, t: Number, gaps: list[Number]) -> Number:
        """The integral of (s f')' in g'(t)."""

    @abstractmethod
    def _over(self, a: Number, integrand: Integrand) -> Number:
        """int integrand(s) sin(y)**k dy over the pieces below a."""


class Homogeneous(Face):
    """The profile on the half-space of one modulus E*."""

    def displacement(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """w(r) for r > a."""
        q = mp.sqrt((r - a) * (r + a))
        inclination = mp.atan2(a, q)
        near = complex(0, float(mp.asinh(q / a)))

        def weighted(piece: Stretch, s: Number, z: Number) -> Number:
            return piece.slope(s) * (a * inclination - z * mp.atan(z / q))

        total = self._over_angle(a, weighted, (cmath.pi / 2 + near, cmath.pi / 2 - near))
        if depth is not None:
            total += (depth - self.depth(a)) * inclination
        return 2 * total / mp.pi

    def pressure(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """p(r)/E* for 0 < r < a."""
        total = mp.fsum(self._pressure_piece(piece, a, r) for piece in self.shape.stretches)
        total += mp.fsum(b * jump * kernel(b, r, a) for b, jump in self.shape.kinks if b < a and jump != 0)
        if depth is not None:
            total += (depth - self.depth(a)) / mp.sqrt((a - r) * (a + r))
        return total / mp.pi

    def _bend(self, t: Number, gaps: list[Number]) -> Number:
        return self._over(t, lambda piece, s: piece.bend(s))

    def _over(self, a: Number, integrand: Integrand) -> Number:
        return self._over_angle(a, lambda piece, s, z: integrand(piece, s), ())

    def _over_angle(
        self, a: Number, weighted: Callable[[Stretch, Number, Number], Number], extra: tuple[complex, ...]
    ) -> Number:
        """int weighted(piece, s, z) du over all pieces with s = a sin(u), z = a cos(u), singular in u at `extra`."""

        def over(piece: Stretch) -> Number:
            singular = (*(cmath.asin(z / float(a)) for z in piece.singular), *extra)
            ends, longest = (_angle(piece.lo, a), _angle(piece.hi, a)), 6 * piece.wavelength / float(a)
            return integrate(
                lambda u: weighted(piece, a * mp.sin(u), a * mp.cos(u)), *ends, singular, self.digits, longest=longest
            )

        return mp.fsum(map(over, self.shape.stretches))

    def _pressure_piece(self, piece: Stretch, a: Number, r: Number) -> Number:
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
            longest = 6 * piece.wavelength / float(a)
            f = next_to_r if near else from_the_tip
            total += integrate(f, start - shift, end - shift, points, self.digits, longest=longest)
        return total


def _angle(s: Number, a: Number) -> Number:
    return mp.atan2(s, mp.sqrt((a - s) * (a + s)))


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


@dataclass(frozen=True)
class Arithmetic:
    """What an integrand is computed with."""

    number: Callable[[Number], Any]
    cos_sin: Callable[[Any], tuple[Any, Any]]
    panel: Panel


FLOATS = Arithmetic(lambda x: x, mp.cos_sin, rules.sum_over)
BALLS = Arithmetic(rules.ball, lambda x: x.sin_cos()[::-1], rules.sum_over_balls)


class Graded(Face):
    """The profile on a half-space whose modulus is a power of the depth."""

    def displacement(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """w(r) for r > a."""
        k, q2 = self.k, (r - a) * (r + a)
        away = complex(0, float(mp.asinh(mp.sqrt(q2) / a)))
        angle, least = mp.atan2(a, mp.sqrt(q2)), min(float(k), -0.5)
        punch = integrate(lambda x: mp.tan(x) ** k, mp.mpf(0), angle, (0, cmath.pi / 2), self.digits, least)
        known = self.depth(a) if depth is None else depth
        sunk = self._over(a, lambda piece, s: piece.height(s) * s / (r * r - s * s), (away, -away))
        return 2 * mp.cos(mp.pi * k / 2) / mp.pi * (known * punch - q2 ** ((1 - k) / 2) * a**k * sunk)

    def pressure(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """p(r)/H for 0 < r < a."""
        k, breaks = self.k, [piece.hi for piece in self.shape.stretches[:-1]]
        total, longest = mp.mpf(0), min(piece.wavelength for piece in self.shape.stretches)
        for start, end in itertools.pairwise([r, *(b for b in breaks if r < b < a), a]):
            # below a break nothing is felt of it
            felt = [piece for piece in self.shape.stretches if piece.lo < end]
            points = [z for piece in felt for z in (*piece.singular, complex(piece.lo))] + [complex(r), complex(-r)]
            moved = [z - complex(start) for z in points]
            # inside, the end of a sphere that a break cuts off is singular on another sheet only: its distance counts
            moved = [-z if z.imag == 0 and 0 < z.real < end - start else z for z in moved]
            singular = (0j, *(z for z in moved if abs(z) > 1e-14 * float(end)))
            part, least = partial(self._pressure_rate, start=start, r=r), min(float(k - 1) / 2, -0.5)
            total += integrate(part, mp.mpf(0), end - start, singular, self.digits, least, longest=longest)
        if depth is not None:
            total += (depth - self.depth(a)) * ((a - r) * (a + r)) ** ((k - 1) / 2)
        return total / mp.pi

    def _pressure_rate(self, x: Number, start: Number, r: Number) -> Number:
        """g'(t) (t**2 - r**2)**((k - 1)/2) at t = start + x, with exact distances from start and what lies below it."""

        def gap(b: Number) -> Number:
            return (x + (start - b)) * (x + start + b)

        return self._rate(start + x, [gap(b) for b, _ in self.shape.kinks]) * gap(r) ** ((self.k - 1) / 2)

    def _bend(self, t: Number, gaps: list[Number]) -> Number:
        """The integral of (s f')' in it; that over c n**2 s**(n - 1) is a power of t times the one for t = 1."""
        if self.shape.powers:
            moments = ((c, n, _moment(n, self.k, self.digits, int(mp.mp.prec))) for c, n in self.shape.powers)
            return mp.fsum(c * n * n * t ** (n - 1) * moment for c, n, moment in moments)
        with rules.at_working_precision():
            return self._over(t, lambda piece, s: piece.bend_ball(s), (), gaps, BALLS)

    def _over(
        self,
        a: Number,
        integrand: Integrand,
        extra: tuple[complex, ...] = (),
        gaps: list[Number] | None = None,
        own: Arithmetic = FLOATS,
    ) -> Number:
        """int integrand(s) sin(y)**k dy over the pieces below a, s = a cos(y); `extra` are singular points in y."""
        breaks = [b for b, _ in self.shape.kinks]
        squares = [(a - b) * (a + b) for b in breaks] if gaps is None else gaps
        angles = [mp.atan2(mp.sqrt(gap), b) if gap > 0 else mp.mpf(0) for b, gap in zip(breaks, squares, strict=True)]
        total = mp.mpf(0)
        ends = itertools.pairwise([mp.pi / 2, *angles, mp.mpf(0)])
        for piece, (far, near) in zip(self.shape.stretches, ends, strict=False):
            if far > near and not _vanishes(piece, integrand, own):
                total += self._over_piece(a, piece, integrand, near, far, extra, own)
        return total

    def _over_piece(
        self,
        t: Number,
        piece: Stretch,
        integrand: Integrand,
        near: Number,
        far: Number,
        extra: tuple[complex, ...],
        own: Arithmetic,
    ) -> Number:
        radius, k = own.number(t), own.number(self.k)
        images = [sign * mp.acos(mp.mpmathify(z) / t) for z in piece.singular for sign in (1, -1)]
        longest = 3 * piece.wavelength / float(t)  # twice as much leaves 37 of 50 digits of a gaussian
        least = min(float(self.k), -0.5)

        def f(y: Number) -> Number:
            cosine, sine = own.cos_sin(y)
            return integrand(piece, radius * cosine) * sine**k

        def between(lo: Number, hi: Number) -> Number:
            # from lo on, because a singular point may be nearer to it than floats tell
            origin = own.number(lo)
            points = tuple(complex(z - lo) for z in (mp.mpf(0), mp.pi, *images, *extra))
            return integrate(
                lambda x: f(origin + x), mp.mpf(0), hi - lo, points, self.digits, least, own.panel, longest
            )

        if piece.lo == 0 and 0 in piece.singular:  # from the tip on, with exact distances to it

            def from_tip(x: Number) -> Number:
                cosine, sine = own.cos_sin(x)
                return integrand(piece, radius * sine) * cosine**k

            end = (mp.pi / 2 - near) / 2
            points = tuple(sign * cmath.asin(z / float(t)) for z in piece.singular for sign in (1, -1))
            points += (cmath.pi / 2, *(cmath.pi / 2 - z for z in extra))
            tip = integrate(from_tip, mp.mpf(0), end, points, self.digits, panel=own.panel, longest=longest)
            return tip + between(near, mp.pi / 2 - end)
        clear = min([abs(z) for z in (*images, *extra)], default=1.0)
        if 0 < near < min(NEAR * clear, far / 2):
            return between(mp.mpf(0), far) - between(mp.mpf(0), near)
        return between(near, far)


@lru_cache(maxsize=64)
def _moment(n: Number, k: Number, digits: int, prec: int) -> Number:
    """int cos(y)**(n - 1) sin(y)**k dy over a right angle, from both of its ends."""
    total = mp.mpf(0)
    for along, across in ((n - 1, k), (k, n - 1)):

        def f(x: Number, along: Number = along, across: Number = across) -> Number:
            cosine, sine = mp.cos_sin(x)
            return cosine**along * sine**across

        least, longest = min(float(across), -0.5), 2 / float(max(n, 1))
        total += integrate(f, mp.mpf(0), mp.pi / 4, (0, cmath.pi / 2), digits, least, longest=longest)
    return total


def _vanishes(piece: Stretch, integrand: Integrand, own: Arithmetic) -> bool:
    """A flat tip adds nothing."""
    middle = piece.hi / 3 + piece.lo * 2 / 3
    return bool(piece.slope(middle) == 0 and piece.bend(middle) == 0 and integrand(piece, own.number(middle)) == 0)


def under_load(values: Values, s: Number, digits: int) -> Number:
    """w(r) inside and outside the circle of a prescribed pressure p_0 (1 - r**2/a**2)**s, (11.104) and (11.105).

    With q**2 = r**2 - x**2 (11.104) is w1D(x) = 2 p_0/E* (a**2 - x**2)**(s + 1/2)/a**(2 s) int_0^1 (1 - y**2)**s dy.
    """
    a, r, p_0, modulus = (number(values[symbol]) for symbol in (nt.a, nt.r, nt.p_0, nt.E_star))
    least = min(float(s), -0.5)
    scale = integrate(lambda y: (y * (2 - y)) ** s, mp.mpf(0), mp.mpf(1), (0j, 2 + 0j), digits, least)
    factor, rest = 4 * scale * p_0 / (mp.pi * modulus) * a ** (-2 * s), abs((a - r) * (a + r))
    if r < a:  # x = r sin(v): what is left has its singular points at sin(v) = a/r
        height = 1j * complex(mp.acosh(a / r))
        points = tuple(sign * cmath.pi / 2 + z for sign in (1, -1) for z in (height, -height))

        def inside(v: Number) -> Number:
            return (rest + (r * mp.cos(v)) ** 2) ** (s + mp.mpf(1) / 2)

        return factor * integrate(inside, mp.mpf(0), mp.pi / 2, points, digits)
    # x = a cos(y): the edge of the circle at y = 0
    height = 1j * complex(mp.asinh(mp.sqrt(rest) / a))

    def outside(y: Number) -> Number:
        sine = mp.sin(y)
        return (a * sine) ** (2 * s + 1) * a * sine / mp.sqrt(rest + (a * sine) ** 2)

    return factor * integrate(outside, mp.mpf(0), mp.pi / 2, (0j, complex(mp.pi), height, -height), digits)
