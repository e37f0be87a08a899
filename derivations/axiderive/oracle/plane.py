"""The defining integrals of the plane problem, over E*, free of roots: t^2 = lo^2 + (hi^2 - lo^2) y^2 on each piece.

The load is an integral of the profile; the fields are integrals of the growth
P'(t) of the load, which is the derivative of a formula that the load itself
has been checked for.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..physics.plane import derive
from ..profiles.profile import Piece, Profile
from .evaluate import evaluated
from .rules import integrate
from .shape import Number, Values, number

GUARD = 70
"""Extra digits: P'(t) contains sqrt(t^2 - b^2), and the nodes come close to b."""
Kernel = Callable[[Number, Number, Number], Number]
"""Function of t, sqrt(t^2 - lo^2) and lo."""


@dataclass(frozen=True)
class Strip:
    """A face in contact up to the half-width a, at given values: pieces of the height f, slope f' and growth P'/E*."""

    values: Values
    digits: int
    a: Number
    breaks: tuple[Number, ...]
    heights: tuple[sp.Expr, ...]
    slopes: tuple[sp.Expr, ...]
    growths: tuple[sp.Expr, ...]

    def at(self, expr: sp.Expr, symbol: sp.Symbol, point: Number) -> Number:
        """The value of an expression with the point for the symbol, at the working precision."""
        return evaluated(expr, {**self.values, symbol: point})

    def pieces(self, lo: Number, hi: Number, exprs: Iterable[sp.Expr]) -> list[tuple[Number, Number, sp.Expr]]:
        """Pieces of lo < t < hi with the expression that holds there."""
        ends = itertools.pairwise([mp.mpf(0), *self.breaks, mp.inf])
        cut = [(max(lo, left), min(hi, right), expr) for (left, right), expr in zip(ends, exprs, strict=False)]
        return [(left, right, expr) for left, right, expr in cut if left < right and expr != 0]

    def load(self) -> Number:
        """P/E* = int x f'(x)/sqrt(a^2 - x^2) dx, in x = a sin(u), of the face that grows."""

        def angle(length: Number) -> Number:
            return mp.atan2(length, mp.sqrt((self.a - length) * (self.a + length)))

        total = mp.mpf(0)
        for lo, hi, slope in self.pieces(mp.mpf(0), self.a, self.slopes):

            def integrand(u: Number, slope: sp.Expr = slope) -> Number:
                point = self.a * mp.sin(u)
                return point * self.at(slope, nt.x, point)

            total += self._integral(integrand, angle(lo), angle(hi), [0j])
        return total

    def pressure(self, x: Number) -> Number:
        """p/E* at a point of the contact: int_x^a P'(t)/sqrt(t^2 - x^2) dt/(pi E*)."""

        def kernel(t: Number, root: Number, lo: Number) -> Number:
            return 1 / root if lo == x else 1 / mp.hypot(root, mp.sqrt((lo - x) * (lo + x)))

        return self._superposed(x, kernel, x) / mp.pi

    def level(self, x: Number) -> Number:
        """The load over E* under which the pressure at x is zero."""
        return mp.pi * mp.sqrt((self.a - x) * (self.a + x)) * self.pressure(x) - self.load()

    def slope(self, x: Number) -> Number:
        """dw/dx at a point of the free surface: -2 int_0^a P'(t)/sqrt(x^2 - t^2) dt/(pi E*)."""
        return -2 / mp.pi * self._superposed(mp.mpf(0), lambda t, root, lo: 1 / mp.sqrt((x - t) * (x + t)), x)

    def depth(self, distance: Number) -> Number:
        """Depth of the middle below the surface at a distance L > a: 2 int_0^a P'(t) acosh(L/t) dt/(pi E*)."""
        return 2 / mp.pi * self._superposed(mp.mpf(0), lambda t, root, lo: mp.acosh(distance / t), distance)

    def _superposed(self, start: Number, kernel: Kernel, z: Number) -> Number:
        """int P'(t) kernel(t, y span) dt up to a, y span = sqrt(t^2 - lo^2); z is where the kernel is singular."""
        total = mp.mpf(0)
        for left, right, growth in self.pieces(start, self.a, self.growths):
            span = mp.sqrt((right - left) * (right + left))
            below = [b for b in self.breaks if b <= left]  # where the growth on this piece is singular
            corners = [mp.sqrt(mp.mpc((point - left) * (point + left))) / span for point in (mp.mpf(0), z, *below)]

            def integrand(y: Number, left: Number = left, span: Number = span, growth: sp.Expr = growth) -> Number:
                t = mp.hypot(left, y * span)
                return self.at(growth, nt.a, t) * y * span**2 / t * kernel(t, y * span, left)

            singular = [complex(sign * corner) for corner in corners if corner != 0 for sign in (1, -1)]
            total += self._integral(integrand, mp.mpf(0), mp.mpf(1), singular + ([0j] if left == 0 else []))
        return total

    def _integral(
        self, integrand: Callable[[Number], Number], lo: Number, hi: Number, singular: list[complex]
    ) -> Number:
        """In as many parts as a high power of the distance asks for, the first away from a singular lower end."""
        parts = int(mp.ceil(number(self.values.get(nt.n, sp.S.One)) / 4))
        ends = itertools.pairwise([*(lo + (hi - lo) * i / parts for i in range(parts)), hi])
        return mp.fsum(integrate(integrand, left, right, singular, self.digits) for left, right in ends)


def strip(profile: Profile, values: Values, digits: int) -> Strip:
    """The face at the given values; a concave one is turned over, C x^n, as if it had no edges."""
    a, pure = number(values[nt.a]), profile
    if profile.complete:
        (piece,) = profile.pieces
        power = sp.expand_power_base(piece.expr).as_independent(nt.x, as_Add=False)[1]
        geometry = tuple(symbol for symbol in profile.parameters if symbol != nt.a)
        turned = Piece(None, nt.C * power if piece.expr != 0 else piece.expr)
        pure = replace(profile, contact="compact", parameters=geometry, pieces=(turned,))
        values = {**values, nt.C: evaluated(-piece.expr.subs(nt.x, 1), {**values, nt.x: sp.S.One})}
    loads = {sum(case.below(b, nt.a) for b in pure.breaks): case.expr / nt.E_star for case in derive(pure)["P"].cases}
    return Strip(
        values,
        digits,
        a,
        tuple(number(values[b]) for b in pure.breaks),
        tuple(piece.expr for piece in pure.pieces),
        tuple(sp.diff(piece.expr, nt.x) for piece in pure.pieces),
        tuple(sp.diff(loads.get(i, sp.S.Zero), nt.a) for i in range(len(pure.pieces))),
    )


FLAT: dict[str, tuple[sp.Symbol, Callable[[Number, Number], Number]]] = {
    "p": (nt.x, lambda a, x: 1 / mp.sqrt((a - x) * (a + x)) / mp.pi),
    "s": (nt.x, lambda a, x: -2 / mp.pi / mp.sqrt((x - a) * (x + a))),
    "d": (nt.L, lambda a, L: 2 / mp.pi * mp.acosh(L / a)),
}
"""Where a field is asked for, and that of a flat strip under a unit load over E*."""


def defined(profile: Profile, suffix: str, values: Values, digits: int) -> Number:
    """P, p, s = dw/dx or d as its integral; in complete contact a flat strip takes P - P_f(a)."""
    own, modulus = strip(profile, values, digits), number(values[nt.E_star])
    if suffix == "P":
        return modulus * own.load()
    symbol, flat = FLAT[suffix]
    place, scale = number(values[symbol]), modulus if suffix == "p" else mp.mpf(1)
    field = {"p": own.pressure, "s": own.slope, "d": own.depth}[suffix](place)
    if profile.compact:
        return scale * field
    edge = number(values[nt.P]) / modulus + own.load()
    return scale * (edge * flat(own.a, place) - field)
