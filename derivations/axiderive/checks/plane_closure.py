"""The pressure put back into the equation of the half plane, which no formula was derived from.

    dw/dx = -2/(pi E*) PV int p(s)/(x - s) ds

must give -f' under the punch (the tilt under an eccentric load) and the slope
outside, and int p dx the load.  The contact is run through in s = m + c sin(u),
which removes the roots at its edges; what is singular at a break of the
profile or at the tip is integrated from there.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle import plane as integrals
from ..oracle import rules
from ..oracle.evaluate import case_at, evaluated
from ..oracle.evidence import Evidence, judge, residual
from ..oracle.rules import integrate, middle
from ..oracle.sampling import Point, points
from ..oracle.shape import Number, Values, number, numeric_symbols
from ..profiles.profile import Profile

LOST = 6
"""Digits by which the agreement may fall short of the digits of the quadrature."""


def _working(digits: int) -> int:
    """The nodes come as close to the tip as 10**(-2 digits), where 1 - x**2/a**2 must not round to 1."""
    return 4 * digits + 60


@dataclass(frozen=True)
class Pressed:
    """The pressure over the contact: middle, half-width and pieces (from, to, formula); if even, of the right half."""

    values: Values
    middle: Number
    half: Number
    pieces: tuple[tuple[Number, Number, sp.Expr], ...]
    even: bool

    def at(self, s: Number, expr: sp.Expr) -> Number:
        """The value of an expression at x = s, at the working precision."""
        return evaluated(expr, {**self.values, nt.x: s})

    def formula(self, expr: sp.Expr) -> Callable[[Number], Number]:
        """The pressure as a function of the place, by Arb where it has all functions."""
        if rules.foreign(expr):
            return lambda s: self.at(s, expr)
        symbols = [symbol for symbol in numeric_symbols(self.values) if symbol != nt.x and expr.has(symbol)]
        inside = rules.bound(expr, nt.x, {symbol: number(self.values[symbol]) for symbol in symbols})

        def pressure(s: Number) -> Number:
            with rules.at_working_precision():
                return middle(inside(rules.ball(s)))

        return pressure

    def integral(self, kernel: Callable[[Number, Number], Number], poles: list[complex], digits: int) -> Number:
        """int kernel(s, p(s)) ds over the contact."""
        angles = [self._angle(left) for left, *_ in self.pieces] + [self._angle(self.pieces[-1][1])]
        inner = [complex(angle) for angle in (angles[:-1] if self.even else angles[1:-1])]
        inner += [-angle for angle in inner if self.even]
        # sin(u) takes every value again at pi - u, where the pressure continues with the other sign
        singular = [z for angle in inner for z in (angle, cmath.pi - angle, -cmath.pi - angle)] + poles
        total = mp.mpf(0)
        for (_, _, expr), lo, hi in zip(self.pieces, angles, angles[1:], strict=False):

            def integrand(u: Number, pressure: Callable[[Number], Number] = self.formula(expr)) -> Number:  # noqa: B008
                s = self.middle + self.half * mp.sin(u)
                p = pressure(s)
                both = kernel(s, p) + (kernel(-s, p) if self.even else 0)
                return both * self.half * mp.cos(u)

            halfway = (lo + hi) / 2
            for end, sign in ((lo, 1), (hi, -1)):
                moved = [sign * (z - complex(end)) for z in singular]
                moved = [0j if abs(z) < 1e-30 else z for z in moved]
                part = partial(_from, integrand, end, sign)
                total += integrate(part, mp.mpf(0), abs(halfway - end), moved, digits)
        return total

    def _split(self, x: Number) -> Pressed:
        pieces = [
            part
            for lo, hi, expr in self.pieces
            for part in ([(lo, x, expr), (x, hi, expr)] if lo < x < hi else [(lo, hi, expr)])
        ]
        return replace(self, pieces=tuple(pieces))

    def _angle(self, s: Number) -> Number:
        z = (s - self.middle) / self.half
        return mp.asin(max(-1, min(1, z)))

    def slope(self, x: Number, digits: int) -> Number:
        """E* dw/dx."""
        z = (x - self.middle) / self.half
        if abs(z) > 1:
            pole = complex(mp.pi / 2 * mp.sign(z), mp.acosh(abs(z)))
            poles = [pole, pole.conjugate(), -pole, -pole.conjugate()]
            return -2 / mp.pi * self.integral(lambda s, p: p / (x - s), poles, digits)
        here = self.at(x, next(expr for lo, hi, expr in self.pieces if lo <= x <= hi))
        # removable at x, but the root continued past the edge leaves a pole behind
        rest = self._split(x).integral(lambda s, p: (p - here) / (x - s), [], digits)
        return -2 / mp.pi * (rest + here * mp.log((1 + z) / (1 - z)))


def _from(integrand: Callable[[Number], Number], end: Number, sign: int, v: Number) -> Number:
    return integrand(end + sign * v)


def pressed(profile: Profile, entry: Entry, values: Values) -> Pressed:
    """The pressure of an entry over its whole contact."""
    a = number(values[nt.a])
    if nt.e in profile.parameters:
        case, lost = case_at(entry, values), max(mp.mpf(0), 4 * abs(number(values[nt.e])) - 2 * a)
        side = mp.sign(number(values[nt.e]))
        half = a - lost / 2
        middle = side * (a - half)
        return Pressed(values, middle, half, ((middle - half, middle + half, case.expr),), False)
    ends = [mp.mpf(0), *(b for b in (number(values[b]) for b in profile.breaks) if b < a), a]
    cut = zip(ends, ends[1:], strict=False)
    pieces = tuple((lo, hi, case_at(entry, {**values, nt.x: (lo + hi) / 2}).expr) for lo, hi in cut)
    return Pressed(values, mp.mpf(0), a, pieces, True)


def check_profile(
    profile: Profile, entries: Mapping[str, Entry], *, digits: int = 40, points: int = 4, seed: int = 0
) -> list[Evidence]:
    """Slope inside and outside and the load, from the pressure alone."""
    comparisons: list[tuple[str, str, Callable[[Values], Number]]] = [
        ("p", "load as the integral of the pressure", lambda values: _load(profile, entries, values, digits)),
        ("p", "singular integral equation under the punch", lambda values: _inside(profile, entries, values, digits)),
    ]
    if "s" in entries:
        comparisons.append(
            ("s", "singular integral outside the contact", lambda values: _outside(profile, entries, values, digits))
        )
    if "phi" in entries:
        comparisons.append(
            ("phi", "slope under the punch from the pressure", lambda values: _inside(profile, entries, values, digits))
        )
        comparisons.append(("cw", "load and moment over this width", lambda values: _moment(entries, values, digits)))
    found = []
    for suffix, compared, compare in comparisons:
        drawn = _points(profile, entries[suffix], points, seed)
        with mp.workdps(_working(digits)):
            rows = [(point.values, compare(point.values)) for point in drawn]
        extremes = sum(point.extreme for point in drawn)
        key = entries[suffix].key
        found.append(judge(key, compared, rows, seed=seed, extremes=extremes, digits=digits, required=digits - LOST))
    return found


def _points(profile: Profile, entry: Entry, count: int, seed: int) -> list[Point]:
    """Points in every region of the entry; under the eccentric punch x lies anywhere in the contact."""
    fields = (nt.P,) if profile.complete else ()
    if nt.e in profile.parameters:
        return _eccentric(profile, count, seed)
    chains = [case.chain for case in entry.cases]
    each = max(2, -(-count // len(chains)))
    return [point for chain in chains for point in points(profile, chain, each, seed, fields)]


def _eccentric(profile: Profile, count: int, seed: int) -> list[Point]:
    """Both regimes and both signs of e, with x on both sides of the middle of the contact."""
    drawn = []
    for i, point in enumerate(points(profile, (nt.x, nt.a), 4 * count, seed, (nt.P, nt.e))):
        a, ratio = point.values[nt.a], point.values[nt.x] / point.values[nt.a]
        distance = a * (1 + ratio) / 2 if i % 2 else a * ratio / 2
        side = 1 if i % 4 < 2 else -1
        lost = max(0, 4 * distance - 2 * a)
        position = side * (a - (2 * a - lost) * sp.Rational(1 + 2 * (i % 5), 11))
        drawn.append(Point({**point.values, nt.e: side * distance, nt.x: position}, point.extreme))
    return drawn[: max(8, count)]


def _moment(entries: Mapping[str, Entry], values: Values, digits: int) -> Number:
    """Load and moment of the pressure over the width that the entry gives, at the loaded edge."""
    a, side = number(values[nt.a]), mp.sign(number(values[nt.e]))
    half = evaluated(case_at(entries["cw"], values).expr, values) / 2
    middle = side * (a - half)
    over = Pressed(values, middle, half, ((middle - half, middle + half, case_at(entries["p"], values).expr),), False)
    force, moment = over.integral(lambda s, p: p, [], digits), over.integral(lambda s, p: s * p, [], digits)
    wanted = number(values[nt.P])
    return max(residual(force, wanted), residual(moment, wanted * number(values[nt.e])))


def _load(profile: Profile, entries: Mapping[str, Entry], values: Values, digits: int) -> Number:
    total = pressed(profile, entries["p"], values).integral(lambda s, p: p, [], digits)
    wanted = number(values[nt.P]) if nt.P in values else evaluated(case_at(entries["P"], values).expr, values)
    return residual(total, wanted)


def _inside(profile: Profile, entries: Mapping[str, Entry], values: Values, digits: int) -> Number:
    x = number(values[nt.x])
    got = pressed(profile, entries["p"], values).slope(x, digits) / number(values[nt.E_star])
    if "phi" in entries:
        return residual(got, evaluated(case_at(entries["phi"], values).expr, values))
    face = integrals.face(profile, values)
    pieces = face.pieces(x * (1 - mp.mpf(10) ** -digits), x, face.slopes)
    wanted = face.at(pieces[0][2], nt.x, x) if pieces else mp.mpf(0)
    # the slope of the profile near its tip is a small difference: it is measured by the mean pressure
    total = values[nt.P] if profile.complete else case_at(entries["P"], values).expr
    scale = evaluated(total / (values[nt.a] * values[nt.E_star]), values)
    return abs(got + wanted if profile.compact else got - wanted) / max(abs(wanted), scale)


def _outside(profile: Profile, entries: Mapping[str, Entry], values: Values, digits: int) -> Number:
    got = pressed(profile, entries["p"], values).slope(number(values[nt.x]), digits) / number(values[nt.E_star])
    return residual(got, evaluated(case_at(entries["s"], values).expr, values))
