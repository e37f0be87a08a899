"""The quantities of normal contact on the power-law graded half-space, by quadrature of f, f' and (r f')'.

Nothing of the engine is used here.  With s = t cos(y) the weight (t**2 - s**2)**((k - 1)/2) becomes a power
of sin(y), whose singular point y = 0 is the edge of the contact:

* (11.61)  g(a) = a int f'(s) sin(y)**k dy
* (11.51)  F = 2 H/(1 + k) [a**k int f'(s) s**2 sin(y)**k dy + a**(1 + k) (d - g(a))], order of integration exchanged
* (11.56)  w = 2 cos(k pi/2)/pi [d T - q**(1 - k) a**(1 + k) int f(s) s sin(y)**k/(r**2 - s**2) dy/a]
           with T = int tan(x)**k dx from 0 to asin(a/r) and q = sqrt(r**2 - a**2), order exchanged and by parts
* (11.53)  p = H/pi [int_r^a g'(t) (t**2 - r**2)**((k - 1)/2) dt + (d - g(a)) (a**2 - r**2)**((k - 1)/2)], nested:
           the kernel that exchange would leave is an Appell function

d = g(a) for a compact contact.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import mpmath as mp

from . import ball_rules
from .integrals import panels_no_longer_than
from .rules import Panel, integrate, sum_over
from .shape import Number, Shape, Stretch

NEAR = 0.25
"""A break this close to the edge, in units of the distance of the other singular points, is integrated across."""


@dataclass(frozen=True)
class Arithmetic:
    """What the integrand is computed with."""

    number: Callable[[Number], Any]
    cos_sin: Callable[[Any], tuple[Any, Any]]
    panel: Panel


def _cos_sin(x: Any) -> tuple[Any, Any]:
    sine, cosine = x.sin_cos()
    return cosine, sine


FLOATS = Arithmetic(lambda x: x, mp.cos_sin, sum_over)
BALLS = Arithmetic(ball_rules.ball, _cos_sin, ball_rules.sum_over_balls)


@dataclass(frozen=True)
class Graded:
    """The profile on a half-space with c_N(x) = H |x|**k; moduli are left to the caller."""

    shape: Shape
    k: Number
    digits: int

    def depth(self, a: Number) -> Number:
        """g(a), (11.61)."""
        return a * self._over(a, lambda piece, s: piece.slope(s))

    def depth_rate(self, a: Number) -> Number:
        """dg/da, (11.61) differentiated under its sign."""
        return self._rate(a, [(a - b) * (a + b) for b, _ in self.shape.kinks])

    def force(self, a: Number, depth: Number | None = None) -> Number:
        """F/H."""
        total = a**self.k * self._over(a, lambda piece, s: piece.slope(s) * s * s)
        if depth is not None:
            total += a ** (1 + self.k) * (depth - self.depth(a))
        return 2 * total / (1 + self.k)

    def force_rate(self, a: Number) -> Number:
        """(dF/da)/H of the compact contact: the weight a**k s**2 f'(s) differentiated at constant y."""
        k = self.k
        total = a ** (k - 1) * self._over(
            a, lambda piece, s: (k * piece.slope(s) + piece.bend(s) + piece.slope(s)) * s * s
        )
        total += mp.fsum(
            b**3 * jump * ((a - b) * (a + b)) ** ((k - 1) / 2) / a for b, jump in self.shape.kinks if b < a
        )
        return 2 * total / (1 + k)

    def displacement(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """w(r) for r > a."""
        k, q2 = self.k, (r - a) * (r + a)
        away = complex(0, float(mp.asinh(mp.sqrt(q2) / a)))
        angle = mp.atan2(a, mp.sqrt(q2))
        punch = integrate(
            lambda x: mp.tan(x) ** k, mp.mpf(0), angle, (0, cmath.pi / 2), self.digits, least=min(float(k), -0.5)
        )
        known = self.depth(a) if depth is None else depth
        sunk = self._over(a, lambda piece, s: piece.height(s) * s / (r * r - s * s), (away, -away))
        return 2 * mp.cos(mp.pi * k / 2) / mp.pi * (known * punch - q2 ** ((1 - k) / 2) * a**k * sunk)

    def pressure(self, a: Number, r: Number, depth: Number | None = None) -> Number:
        """p(r)/H for 0 < r < a."""
        k, breaks = self.k, [piece.hi for piece in self.shape.stretches[:-1]]
        ends = [r, *(b for b in breaks if r < b < a), a]
        total = mp.mpf(0)
        for start, end in zip(ends, ends[1:], strict=False):
            # below a break nothing is felt of it
            felt = [piece for piece in self.shape.stretches if piece.lo < end]
            points = [z for piece in felt for z in (*piece.singular, complex(piece.lo))] + [complex(r), complex(-r)]
            moved = [z - complex(start) for z in points]
            # inside, the end of a sphere that a break cuts off is singular on another sheet only: its distance counts
            moved = [-z if z.imag == 0 and 0 < z.real < end - start else z for z in moved]
            singular = (0j, *(z for z in moved if abs(z) > 1e-14 * float(end)))
            longest = min(piece.wavelength for piece in self.shape.stretches)
            cuts = panels_no_longer_than(longest, mp.mpf(0), end - start)
            part = partial(self._pressure_rate, start=start, r=r)
            for lo, hi in zip(cuts, cuts[1:], strict=False):
                total += integrate(part, lo, hi, singular, self.digits, min(float(k - 1) / 2, -0.5))
        if depth is not None:
            total += (depth - self.depth(a)) * ((a - r) * (a + r)) ** ((k - 1) / 2)
        return total / mp.pi

    def _pressure_rate(self, x: Number, start: Number, r: Number) -> Number:
        """g'(t) (t**2 - r**2)**((k - 1)/2) at t = start + x, with exact distances from start and what lies below it."""

        def gap(b: Number) -> Number:
            return (x + (start - b)) * (x + start + b)

        return self._rate(start + x, [gap(b) for b, _ in self.shape.kinks]) * gap(r) ** ((self.k - 1) / 2)

    def _rate(self, t: Number, gaps: list[Number]) -> Number:
        """g'(t) with t**2 - b**2 given for every break b."""
        if self.shape.powers:  # the integral over c n**2 s**(n - 1) is a power of t times the one for t = 1
            prec = int(mp.mp.prec)
            return mp.fsum(
                c * n * n * t ** (n - 1) * _moment(n, self.k, self.digits, prec) for c, n in self.shape.powers
            )
        with ball_rules.at_working_precision():
            total = self._over(t, lambda piece, s: piece.bend_ball(s), (), gaps, BALLS)
        return total + t**-self.k * mp.fsum(
            b * jump * gap ** ((self.k - 1) / 2)
            for (b, jump), gap in zip(self.shape.kinks, gaps, strict=True)
            if gap > 0 and jump != 0
        )

    def _over(
        self,
        t: Number,
        integrand: Callable[[Stretch, Number], Number],
        extra: tuple[complex, ...] = (),
        gaps: list[Number] | None = None,
        own: Arithmetic | None = None,
    ) -> Number:
        """int integrand(s) sin(y)**k dy over the pieces below t, s = t cos(y); `extra` are singular points in y."""
        breaks = [b for b, _ in self.shape.kinks]
        squares = [(t - b) * (t + b) for b in breaks] if gaps is None else gaps
        angles = [mp.atan2(mp.sqrt(gap), b) if gap > 0 else mp.mpf(0) for b, gap in zip(breaks, squares, strict=True)]
        ends = [mp.pi / 2, *angles, mp.mpf(0)]
        own, total = own or FLOATS, mp.mpf(0)
        for piece, far, near in zip(self.shape.stretches, ends, ends[1:], strict=False):
            if far > near and not _vanishes(piece, integrand, own):
                total += self._over_piece(t, piece, integrand, near, far, extra, own)
        return total

    def _over_piece(
        self,
        t: Number,
        piece: Stretch,
        integrand: Callable[[Stretch, Number], Number],
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
            cuts, origin = panels_no_longer_than(longest, mp.mpf(0), hi - lo), own.number(lo)
            points = tuple(complex(z - lo) for z in (mp.mpf(0), mp.pi, *images, *extra))
            return mp.fsum(
                integrate(lambda x: f(origin + x), start, end, points, self.digits, least, own.panel)
                for start, end in zip(cuts, cuts[1:], strict=False)
            )

        if piece.lo == 0 and 0 in piece.singular:  # from the tip on, with exact distances to it

            def from_tip(x: Number) -> Number:
                cosine, sine = own.cos_sin(x)
                return integrand(piece, radius * sine) * cosine**k

            end = (mp.pi / 2 - near) / 2
            points = tuple(sign * cmath.asin(z / float(t)) for z in piece.singular for sign in (1, -1))
            points += (cmath.pi / 2, *(cmath.pi / 2 - z for z in extra))
            cuts = panels_no_longer_than(longest, mp.mpf(0), end)
            tip = mp.fsum(
                integrate(from_tip, x, y, points, self.digits, panel=own.panel)
                for x, y in zip(cuts, cuts[1:], strict=False)
            )
            return tip + between(near, mp.pi / 2 - end)
        clear = min([abs(z) for z in (*images, *extra)], default=1.0)
        if 0 < near < min(NEAR * clear, far / 2):
            return between(mp.mpf(0), far) - between(mp.mpf(0), near)
        return between(near, far)


@lru_cache(maxsize=64)
def _moment(n: Number, k: Number, digits: int, prec: int) -> Number:
    """int cos(y)**(n - 1) sin(y)**k dy over a right angle, from both of its ends."""
    longest, half = 2 / float(max(n, 1)), mp.pi / 4
    cuts = panels_no_longer_than(longest, mp.mpf(0), half)
    total = mp.mpf(0)
    for along, across in ((n - 1, k), (k, n - 1)):

        def f(x: Number, along: Number = along, across: Number = across) -> Number:
            cosine, sine = mp.cos_sin(x)
            return cosine**along * sine**across

        least = min(float(across), -0.5)
        total += mp.fsum(
            integrate(f, x, y, (0, cmath.pi / 2), digits, least) for x, y in zip(cuts, cuts[1:], strict=False)
        )
    return total


def _vanishes(piece: Stretch, integrand: Callable[[Stretch, Number], Number], own: Arithmetic) -> bool:
    """A flat tip adds nothing."""
    middle = piece.hi / 3 + piece.lo * 2 / 3
    return bool(piece.slope(middle) == 0 and piece.bend(middle) == 0 and integrand(piece, own.number(middle)) == 0)
