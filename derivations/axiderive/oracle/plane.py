"""The defining integrals of the plane problem, over E*, free of roots: t^2 = lo^2 + (hi^2 - lo^2) y^2 on each piece.

The load is an integral of the profile; the fields are integrals of the growth
P'(t) of the load, which is the derivative of a formula that the load itself
has been checked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import mpmath as mp
import sympy as sp

from ..notation import C, E_star, a, n, x
from ..physics.plane import derive
from ..profiles.profile import Piece, Profile
from .evaluate import evaluated
from .rules import integrate
from .shape import Number, Values, number

GUARD = 70
"""Extra digits: P'(t) contains sqrt(t^2 - b^2), and the nodes come close to b."""


@dataclass(frozen=True)
class Face:
    """A profile whose contact grows, at given values: pieces of the height f, its slope f' and the growth P'/E*."""

    values: Values
    breaks: tuple[Number, ...]
    heights: tuple[sp.Expr, ...]
    slopes: tuple[sp.Expr, ...]
    growths: tuple[sp.Expr, ...]

    def at(self, expr: sp.Expr, symbol: sp.Symbol, point: Number) -> Number:
        """The value of an expression with the point for the symbol, at the working precision."""
        return evaluated(expr, {**self.values, symbol: point})

    def pieces(self, lo: Number, hi: Number, exprs: Iterable[sp.Expr]) -> list[tuple[Number, Number, sp.Expr]]:
        """Pieces of lo < t < hi with the expression that holds there."""
        ends = [mp.mpf(0), *self.breaks, mp.inf]
        cut = [(max(lo, left), min(hi, right), expr) for left, right, expr in zip(ends, ends[1:], exprs, strict=False)]
        return [(left, right, expr) for left, right, expr in cut if left < right and expr != 0]

    def height(self, point: Number) -> Number:
        """f at a point x > 0, at a break by the piece below it."""
        found = self.pieces(point * (1 - mp.mpf(10) ** -GUARD), point, self.heights)
        return self.at(found[0][2], x, point) if found else mp.mpf(0)


def unbounded(profile: Profile) -> Profile:
    """The profile itself, or the concave face turned over, C x^n, as if it had no edges."""
    if profile.compact:
        return profile
    (piece,) = profile.pieces
    power = sp.expand_power_base(piece.expr).as_independent(x, as_Add=False)[1]
    geometry = tuple(symbol for symbol in profile.parameters if symbol != a)
    return replace(
        profile,
        contact="compact",
        parameters=geometry,
        pieces=(Piece(None, C * power if piece.expr != 0 else piece.expr),),
    )


def face(profile: Profile, values: Values) -> Face:
    """The face at the given values; the coefficient of a concave one is put in for C."""
    pure = unbounded(profile)
    if pure is not profile:
        (piece,) = profile.pieces
        values = {**values, C: evaluated(-piece.expr.subs(x, 1), {**values, x: sp.S.One})}
    loads = {sum(case.below(b, a) for b in pure.breaks): case.expr / E_star for case in derive(pure)["P"].cases}
    return Face(
        values,
        tuple(number(values[b]) for b in pure.breaks),
        tuple(piece.expr for piece in pure.pieces),
        tuple(sp.diff(piece.expr, x) for piece in pure.pieces),
        tuple(sp.diff(loads.get(i, sp.S.Zero), a) for i in range(len(pure.pieces))),
    )


def load(face: Face, half_width: Number, digits: int) -> Number:
    """int x f'(x)/sqrt(a^2 - x^2) dx in x = a sin(u)."""

    def angle(length: Number) -> Number:
        return mp.atan2(length, mp.sqrt((half_width - length) * (half_width + length)))

    total = mp.mpf(0)
    for lo, hi, slope in face.pieces(mp.mpf(0), half_width, face.slopes):

        def integrand(u: Number, slope: sp.Expr = slope) -> Number:
            point = half_width * mp.sin(u)
            return point * face.at(slope, x, point)

        total += _cut(integrand, angle(lo), angle(hi), [0j], face, digits)
    return total


def _cut(
    integrand: Callable[[Number], Number], lo: Number, hi: Number, singular: list[complex], face: Face, digits: int
) -> Number:
    """In as many parts as a high power of the distance asks for, the first away from a singular lower end."""
    parts = int(mp.ceil(number(face.values.get(n, sp.S.One)) / 4))
    ends = [lo + (hi - lo) * i / parts for i in range(parts)] + [hi]
    return mp.fsum(
        integrate(integrand, left, right, singular, digits) for left, right in zip(ends, ends[1:], strict=False)
    )


def _superposed(face: Face, lo: Number, hi: Number, kernel: Kernel, z: Number, digits: int) -> Number:
    """Integral of P'(t) kernel(t, y span) dt, where y span = sqrt(t^2 - lo^2); z is where the kernel is singular."""
    total = mp.mpf(0)
    for left, right, growth in face.pieces(lo, hi, face.growths):
        span = mp.sqrt((right - left) * (right + left))
        below = [b for b in face.breaks if b <= left]  # where the growth on this piece is singular
        corners = [mp.sqrt(mp.mpc((point - left) * (point + left))) / span for point in (mp.mpf(0), z, *below)]

        def integrand(y: Number, left: Number = left, span: Number = span, growth: sp.Expr = growth) -> Number:
            t = mp.hypot(left, y * span)
            return face.at(growth, a, t) * y * span**2 / t * kernel(t, y * span, left)

        singular = [complex(sign * corner) for corner in corners if corner != 0 for sign in (1, -1)]
        singular += [0j] if left == 0 else []
        total += _cut(integrand, mp.mpf(0), mp.mpf(1), singular, face, digits)
    return total


Kernel = Callable[[Number, Number, Number], Number]
"""Function of t, sqrt(t^2 - lo^2) and lo."""


def pressure(face: Face, half_width: Number, point: Number, digits: int) -> Number:
    """p/E* at a point of the contact: int_x^a P'(t)/sqrt(t^2 - x^2) dt/(pi E*)."""

    def kernel(t: Number, root: Number, lo: Number) -> Number:
        return 1 / root if lo == point else 1 / mp.hypot(root, mp.sqrt((lo - point) * (lo + point)))

    return _superposed(face, point, half_width, kernel, point, digits) / mp.pi


def slope(face: Face, half_width: Number, point: Number, digits: int) -> Number:
    """dw/dx at a point of the free surface: -2 int_0^a P'(t)/sqrt(x^2 - t^2) dt/(pi E*)."""

    def kernel(t: Number, root: Number, lo: Number) -> Number:
        return 1 / mp.sqrt((point - t) * (point + t))

    return -2 / mp.pi * _superposed(face, mp.mpf(0), half_width, kernel, point, digits)


def depth(face: Face, half_width: Number, distance: Number, digits: int) -> Number:
    """Depth of the middle below the surface at a distance L > a: 2 int_0^a P'(t) acosh(L/t) dt/(pi E*)."""

    def kernel(t: Number, root: Number, lo: Number) -> Number:
        return mp.acosh(distance / t)

    return 2 / mp.pi * _superposed(face, mp.mpf(0), half_width, kernel, distance, digits)
