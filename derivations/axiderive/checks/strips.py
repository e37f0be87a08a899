"""Plane formulas against the integrals that define them, and the pressure put back into the equation of the half plane.

The half-width is checked by a round trip from the integral.  From the equation no formula was derived:

    dw/dx = -2/(pi E*) PV int p(s)/(x - s) ds

must give -f' under the punch (the tilt under an eccentric load) and the slope
outside, and int p dx the load.  The contact is run through in s = m + c sin(u),
which removes the roots at its edges; what is singular at a break of the
profile or at the tip is integrated from there.
"""

from __future__ import annotations

import cmath
import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case
from ..oracle import rules
from ..oracle.evaluate import case_at, evaluate, evaluated, holds
from ..oracle.plane import GUARD, defined, strip
from ..oracle.sampling import Point, points
from ..oracle.shape import Number, Values, number, numeric_symbols
from .comparison import Comparison, Evidence, Rows, inverse, not_available, residual, root

TILTED = "the pressure of the eccentric punch is no integral; its closure is checked"
CLOSURE_DIGITS, CLOSURE_POINTS = 40, 4
CLOSURE_LOST = 6
"""Digits by which the agreement may fall short of the digits of the quadrature."""


def check_profile(own: Comparison) -> list[Evidence]:
    """The evidence for every entry of a plane profile."""
    closing = replace(own, digits=CLOSURE_DIGITS, points=CLOSURE_POINTS)
    return [*(check(own, suffix) for suffix in own.entries), *closure(closing)]


def check(own: Comparison, suffix: str) -> Evidence:
    """Compare one entry with its definition at `points` points or more: every case gets at least three."""
    quantity = own.entries[suffix].quantity
    compared = "mpmath quadrature of the defining integral" + (", round trip" if quantity.inverts else "")
    if nt.e in own.profile.parameters:
        return not_available(own.entries[suffix].key, compared, TILTED)
    if quantity.threshold:
        cases = own.entries["xz"].cases
        drawn = [
            p for p in points(own.profile, (nt.a,), own.points, own.seed) if any(holds(c, p.values) for c in cases)
        ]
    else:  # those of an inverse are drawn in the regions of the load
        drawn = _points(own, quantity.inverts or suffix, 3)
    difference = _threshold if quantity.threshold else _residual
    with mp.workdps(own.digits + GUARD):
        rows: Rows = [(point.values, difference(own, suffix, point.values)) for point in drawn]
    return own.judge(suffix, compared, rows, extremes=sum(point.extreme for point in drawn))


def _points(own: Comparison, suffix: str, least: int) -> list[Point]:
    """Points in every region of the entry."""
    chains = [case.chain for case in own.entries[suffix].cases]
    each, fields = max(least, -(-own.points // len(chains))), (nt.P,) if own.profile.complete else ()
    return [point for chain in chains for point in points(own.profile, chain, each, own.seed, fields)]


def _residual(own: Comparison, suffix: str, values: Values) -> Number:
    profile, entry, digits = own.profile, own.entries[suffix], own.digits
    if not entry.quantity.inverts:
        return residual(evaluate(case_at(entry, values).expr, values, digits), defined(profile, suffix, values, digits))
    known = {**values, nt.P: defined(profile, "P", values, digits)}
    if entry.status == "root":
        found = root(case_at(entry, known), nt.a, known, digits)
    else:
        found = inverse(own.entries, suffix, known, digits)
    return residual(found, number(values[nt.a]))


def _threshold(own: Comparison, suffix: str, values: Values) -> Number:
    """The least load is the level at x_0; the level falls on both sides of x_0 and, inside, is stationary there."""
    face = strip(own.profile, values, own.digits)
    a, x_0 = face.a, zero_distance(case_at(own.entries["xz"], values), values)
    top = face.level(x_0)
    if suffix == "Pmin":
        least = evaluated(own.entries["Pmin"].cases[0].expr, {**values, nt.x_zero: x_0})
        return residual(least / number(values[nt.E_star]), top)
    step = a * mp.mpf(10) ** -3 * (1 - x_0 / a)
    if face.level(x_0 + step) >= top or (x_0 > 0 and face.level(x_0 - step) >= top):
        return mp.mpf(1)
    if x_0 == 0:
        return mp.mpf(0)
    # x sqrt(a^2 - x^2) d/dx of sqrt(a^2 - x^2) p for a face of one power
    growth = a * face.at(face.growths[0], nt.a, a) / mp.pi
    order = x_0 * face.at(face.slopes[0], nt.x, x_0) / face.at(face.heights[0], nt.x, x_0)
    curvature = ((order - 1) * a**2 - order * x_0**2) * face.pressure(x_0)
    return residual(curvature, growth * mp.sqrt((a - x_0) * (a + x_0)))


def zero_distance(case: Case, values: Values) -> Number:
    """x_0 in closed form, or the root of its equation, below the place where the right side is infinite."""
    if not isinstance(case.expr, sp.Eq):
        return evaluated(case.expr, values)
    top, bottom = sp.fraction(case.expr.rhs)
    expr = (case.expr.lhs * bottom - top) * (nt.x_zero / nt.a) ** (nt.n - 1)

    def gap(x: Number) -> Number:
        return evaluated(expr, {**values, nt.x_zero: x})

    a, n = number(values[nt.a]), number(values[nt.n])
    lo, hi = a * mp.mpf(10) ** -3, a * mp.sqrt((n - 1) / n)
    for _ in range(20):
        middle = (lo + hi) / 2
        lo, hi = (middle, hi) if gap(lo) * gap(middle) > 0 else (lo, middle)
    return mp.findroot(gap, (lo, hi), solver="secant", tol=mp.mpf(10) ** (-2 * mp.mp.dps), verify=False)


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
                return rules.middle(inside(rules.ball(s)))

        return pressure

    def integral(self, kernel: Callable[[Number, Number], Number], poles: list[complex], digits: int) -> Number:
        """int kernel(s, p(s)) ds over the contact."""
        angles = [self._angle(left) for left, *_ in self.pieces] + [self._angle(self.pieces[-1][1])]
        inner = [complex(angle) for angle in (angles[:-1] if self.even else angles[1:-1])]
        inner += [-angle for angle in inner if self.even]
        # sin(u) takes every value again at pi - u, where the pressure continues with the other sign
        singular = [z for angle in inner for z in (angle, cmath.pi - angle, -cmath.pi - angle)] + poles
        total = mp.mpf(0)
        for (_, _, expr), (lo, hi) in zip(self.pieces, itertools.pairwise(angles), strict=True):
            pressure, halfway = self.formula(expr), (lo + hi) / 2
            for end, sign in ((lo, 1), (hi, -1)):

                def integrand(
                    v: Number,
                    end: Number = end,
                    sign: int = sign,
                    pressure: Callable[[Number], Number] = pressure,
                ) -> Number:
                    u = end + sign * v
                    s = self.middle + self.half * mp.sin(u)
                    p = pressure(s)
                    both = kernel(s, p) + (kernel(-s, p) if self.even else 0)
                    return both * self.half * mp.cos(u)

                moved = [sign * (z - complex(end)) for z in singular]
                moved = [0j if abs(z) < 1e-30 else z for z in moved]
                total += rules.integrate(integrand, mp.mpf(0), abs(halfway - end), moved, digits)
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


def pressed(own: Comparison, values: Values) -> Pressed:
    """The pressure over its whole contact."""
    a, entry = number(values[nt.a]), own.entries["p"]
    if nt.e in own.profile.parameters:
        e = number(values[nt.e])
        return _tilted(own, values, a - max(mp.mpf(0), 4 * abs(e) - 2 * a) / 2)
    ends = [mp.mpf(0), *(b for b in (number(values[b]) for b in own.profile.breaks) if b < a), a]
    cut = itertools.pairwise(ends)
    pieces = tuple((lo, hi, case_at(entry, {**values, nt.x: (lo + hi) / 2}).expr) for lo, hi in cut)
    return Pressed(values, mp.mpf(0), a, pieces, True)


def _tilted(own: Comparison, values: Values, half: Number) -> Pressed:
    """The pressure under the eccentric punch over a half-width at the loaded edge."""
    middle = mp.sign(number(values[nt.e])) * (number(values[nt.a]) - half)
    piece = (middle - half, middle + half, case_at(own.entries["p"], values).expr)
    return Pressed(values, middle, half, (piece,), False)


def closure(own: Comparison) -> list[Evidence]:
    """Slope inside and outside and the load, from the pressure alone."""
    comparisons: list[tuple[str, str, Callable[[Comparison, Values], Number]]] = [
        ("p", "load as the integral of the pressure", _load),
        ("p", "singular integral equation under the punch", _inside),
        ("s", "singular integral outside the contact", _outside),
        ("phi", "slope under the punch from the pressure", _inside),
        ("cw", "load and moment over this width", _moment),
    ]
    found = []
    for suffix, compared, compare in comparisons:
        if suffix not in own.entries:
            continue
        drawn = _eccentric(own) if nt.e in own.profile.parameters else _points(own, suffix, 2)
        # the nodes come as close to the tip as 10**(-2 digits), where 1 - x**2/a**2 must not round to 1
        with mp.workdps(4 * own.digits + 60):
            rows: Rows = [(point.values, compare(own, point.values)) for point in drawn]
        extremes = sum(point.extreme for point in drawn)
        found.append(own.judge(suffix, compared, rows, extremes=extremes, lost=CLOSURE_LOST))
    return found


def _eccentric(own: Comparison) -> list[Point]:
    """Both regimes and both signs of e, with x on both sides of the middle of the contact."""
    drawn = []
    for i, point in enumerate(points(own.profile, (nt.x, nt.a), 4 * own.points, own.seed, (nt.P, nt.e))):
        a, ratio = point.values[nt.a], point.values[nt.x] / point.values[nt.a]
        distance = a * (1 + ratio) / 2 if i % 2 else a * ratio / 2
        side = 1 if i % 4 < 2 else -1
        lost = max(0, 4 * distance - 2 * a)
        position = side * (a - (2 * a - lost) * sp.Rational(1 + 2 * (i % 5), 11))
        drawn.append(Point({**point.values, nt.e: side * distance, nt.x: position}, point.extreme))
    return drawn[: max(8, own.points)]


def _moment(own: Comparison, values: Values) -> Number:
    """Load and moment of the pressure over the width that the entry gives, at the loaded edge."""
    over = _tilted(own, values, evaluated(case_at(own.entries["cw"], values).expr, values) / 2)
    force, moment = (over.integral(kernel, [], own.digits) for kernel in (lambda s, p: p, lambda s, p: s * p))
    wanted = number(values[nt.P])
    return max(residual(force, wanted), residual(moment, wanted * number(values[nt.e])))


def _load(own: Comparison, values: Values) -> Number:
    total = pressed(own, values).integral(lambda s, p: p, [], own.digits)
    wanted = number(values[nt.P]) if nt.P in values else evaluated(case_at(own.entries["P"], values).expr, values)
    return residual(total, wanted)


def _inside(own: Comparison, values: Values) -> Number:
    x, profile = number(values[nt.x]), own.profile
    got = pressed(own, values).slope(x, own.digits) / number(values[nt.E_star])
    if "phi" in own.entries:
        return residual(got, evaluated(case_at(own.entries["phi"], values).expr, values))
    face = strip(profile, values, own.digits)
    pieces = face.pieces(x * (1 - mp.mpf(10) ** -own.digits), x, face.slopes)
    wanted = face.at(pieces[0][2], nt.x, x) if pieces else mp.mpf(0)
    # the slope of the profile near its tip is a small difference: it is measured by the mean pressure
    total = values[nt.P] if profile.complete else case_at(own.entries["P"], values).expr
    scale = evaluated(total / (values[nt.a] * values[nt.E_star]), values)
    return abs(got + wanted if profile.compact else got - wanted) / max(abs(wanted), scale)


def _outside(own: Comparison, values: Values) -> Number:
    got = pressed(own, values).slope(number(values[nt.x]), own.digits) / number(values[nt.E_star])
    return residual(got, evaluated(case_at(own.entries["s"], values).expr, values))
