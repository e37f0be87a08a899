"""What every check is made with, and what it leaves behind.

The entries of a profile, the points at which they are compared, and their values; evidence as plain data for JSON.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.balls import NotAvailableError
from ..oracle.evaluate import case_at, evaluate, evaluate_case, evaluate_integral, evaluated
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import GUARD
from ..oracle.sampling import Point, points
from ..oracle.shape import Number, Values, number, numeric_symbols, shape
from ..physics import Physics, normal
from ..profiles.profile import Profile

Entries = Mapping[str, Entry]
Rows = list[tuple[Values, Number]]
"""Points, and the residual at each."""
LOST = 10
"""Digits by which the agreement may fall short of the digits of the quadrature."""
EXPONENTS = tuple(sp.Rational(x) for x in ("-7/10", "-3/10", "1/5", "3/5", "1/2"))
"""Exponents of grading; every sixth point gets a random one."""
MANY = 6
"""Cases above which one point for each is enough."""


Outcome = Literal["passed", "failed", "not available"]


@dataclass(frozen=True)
class Evidence:
    """The result of comparing one entry with something independent of it, at `count` points drawn from `seed`."""

    key: str
    compared: str
    outcome: Outcome
    seed: int = 0
    count: int = 0
    extremes: int = 0
    """How many of the points have a ratio of lengths of 1e-9 or 1 - 1e-9."""
    worst: str = ""
    """Largest relative residual."""
    digits: int = 0
    """Digits on which both sides agree at every point."""
    required: int = 0
    worst_point: dict[str, str] = field(default_factory=dict)
    reason: str = ""

    @property
    def passed(self) -> bool:
        """Whether the outcome is "passed"; false also where nothing could be compared."""
        return self.outcome == "passed"


def point_text(values: Values) -> dict[str, str]:
    """The values of a point as text by the names of their symbols, numbers of mpmath to 20 digits."""
    return {str(s): _text(values[s]) for s in numeric_symbols(values)}


def _text(value: Any) -> str:
    return mp.nstr(value, 20) if isinstance(value, mp.mpf) else str(value)


def residual(got: Number, want: Number) -> Number:
    """Relative difference; absolute where the wanted value is zero."""
    return abs(got - want) / abs(want) if want else abs(got)


def agreed(worst: Number, working: int) -> int:
    """Whole digits of agreement, never more than were carried."""
    return working if worst == 0 else max(0, min(working, int(mp.floor(-mp.log10(worst)))))


def not_available(key: str, compared: str, reason: str) -> Evidence:
    """Evidence that nothing could be compared, with the reason."""
    return Evidence(key, compared, "not available", reason=reason)


@dataclass(frozen=True)
class Comparison:
    """The entries of one profile under one physics; they are compared to `digits` digits at points from a seed."""

    profile: Profile
    entries: Entries
    physics: Physics = normal.PHYSICS
    digits: int = 50
    points: int = 8
    seed: int = 0

    def judge(
        self, suffix: str, compared: str, rows: Rows, *, extremes: int = 0, digits: int = 0, lost: int = LOST
    ) -> Evidence:
        """Evidence for an entry from the residuals, with these digits or those of the comparison."""
        working = digits or self.digits
        point, worst = max(rows, key=lambda row: row[1])
        reached = agreed(worst, working)
        return Evidence(
            key=self.entries[suffix].key,
            compared=compared,
            outcome="passed" if reached >= working - lost else "failed",
            seed=self.seed,
            count=len(rows),
            extremes=extremes,
            worst=mp.nstr(worst, 2),
            digits=reached,
            required=working - lost,
            worst_point=point_text(point),
        )

    def graded(self, suffix: str) -> bool:
        """Whether an entry knows of an exponent of grading."""
        return nt.k in self.entries[suffix].parameters

    def tame(self, chain: tuple[sp.Expr, ...], among: int, fields: tuple[sp.Symbol, ...]) -> list[Values]:
        """Those of the first points of a region where no ratio of lengths is extreme."""
        drawn = points(self.profile, chain, among, self.seed, fields)
        return [point.values for point in drawn if not point.extreme]

    def drawn(self, suffix: str, count: int) -> list[Point]:
        """Points spread over the cases, those of an inverse over the cases of what it inverts."""
        entry, graded = self.entries[suffix], self.graded(suffix)
        quantity, plain = entry.quantity, self.physics is normal.PHYSICS and not graded
        pulled = self.physics.tension and (quantity.inverts or quantity.control)
        by_depth = (pulled or suffix in ("k", "pm", "Dl")) and "d" in self.entries
        source = self.entries["d" if by_depth else quantity.inverts or suffix]
        material = () if plain else self.physics.drawn
        fields = (*source.quantity.arguments, *material, *self.profile.free_depth)
        # an unevaluated integral next to a border takes long; the closed formulas get the extreme points
        tame = graded and (quantity.place == "inside" or any(case.expr.has(sp.Integral) for case in entry.cases))
        chains = [case.chain for case in source.cases]
        least = 3 if plain else 1 if tame or len(chains) > MANY else 2
        each = max(least, -(-count // len(chains)))
        if tame and suffix == "tau":  # seconds each; that every case is a difference of pressures is shown symbolically
            chains = chains[:: -(-len(chains) // MANY)]
        growing, out = self.profile.compact and quantity.control, list[Point]()
        for chain in chains:
            candidates = (self._point(chain, i, len(out), fields, graded, tame) for i in itertools.count())
            kept = (point for point in candidates if not growing or self._grows(point.values, graded))
            for _ in range(each):
                out.append(next(kept))
        return out

    def _grows(self, values: Values, graded: bool) -> bool:
        """Whether the depth grows with the contact: the largest radius that a profile names is that for k = 0."""
        with mp.workdps(20):
            return bool(HalfSpace(self.profile, values, 10, graded).rates(number(values[nt.a]))[0] > 0)

    def _point(
        self, chain: tuple[sp.Expr, ...], i: int, index: int, fields: tuple[sp.Symbol, ...], graded: bool, tame: bool
    ) -> Point:
        """The i-th point of a case; on the graded half-space the exponent comes first: chains may contain it."""
        exponents = {nt.k: self._exponent(index)} if graded else {}
        chain = tuple(length.subs(exponents) for length in chain)
        drawn = points(self.profile, chain, i + 1 + (12 if tame else 0), self.seed, fields)
        point = [p for p in drawn if not (tame and p.extreme)][i]
        values = {**point.values, **exponents}
        if nt.dgamma in fields and nt.n in values and 2 * values[nt.n] + values.get(nt.k, 0) == 1:
            values[nt.n] = sp.Rational(37, 10)  # g and Dl are the same power of a: nothing is stationary
        return Point(values, point.extreme)

    def _exponent(self, index: int) -> sp.Rational:
        shift = random.Random(f"{self.seed} {self.profile.name}").randrange(len(EXPONENTS))
        drawn = sp.Rational(random.Random(f"{self.seed} {self.profile.name} {index}").randint(-89, 89), 100)
        return (*EXPONENTS, drawn)[(index + shift) % (len(EXPONENTS) + 1)]


def formula_value(entry: Entry, values: Values, digits: int) -> Number:
    """A formula of the catalogue at a point; an enclosure where Arb has all its functions, which is faster."""
    case = case_at(entry, values)
    if case.expr.has(sp.Integral):
        stretches = shape(entry.profile, values).stretches
        radii = {z for piece in stretches for z in piece.singular} | {complex(piece.hi) for piece in stretches[:-1]}
        ordered = tuple(sorted(radii | {0j}, key=lambda z: (abs(z), z.imag)))
        return evaluate_integral(case.expr, values, digits, ordered)
    try:
        return evaluate_case(case, values, digits)
    except NotAvailableError:
        return evaluate(case.expr, values, digits)


def inverse(entries: Entries, suffix: str, known: Values, digits: int) -> Number:
    """A closed inverse evaluated, or the root of its equation found and, where asked for, carried on to d or F."""
    entry = entries[suffix]
    if entry.status != "root":
        without = {s: v for s, v in known.items() if s != nt.a or entry.profile.complete}
        if entry.profile.complete:
            without.pop(entry.quantity.symbol, None)
        return evaluate(case_at(entry, without).expr, without, digits)
    radius = root(case_at(entry, known), nt.a, known, digits, entry.profile.largest)
    if entry.quantity.symbol == nt.a:
        return radius
    return evaluate(case_at(entries[str(entry.quantity.symbol)], known).expr, {**known, nt.a: radius}, digits)


def root(case: Case, unknown: sp.Symbol, known: Values, digits: int, beyond: sp.Expr | None = None) -> Number:
    """The root of an equation by bracketing, from a start that is off by a thousandth of the way to the next border.

    The brackets only say which root; that the equation has its root at the known point is what the residual measures.
    `beyond` is one more border.
    """
    here = evaluated(unknown, known)
    borders = [evaluated(x, known) for x in (*case.chain, beyond) if x is not None and x != unknown]
    reach = min([abs(border - here) for border in borders] + [here]) / 1000

    def gap(x: Number) -> Number:
        at = {**known, unknown: x}
        return evaluated(case.expr.lhs, at) / evaluated(case.expr.rhs, at) - 1

    with mp.extradps(2 * GUARD):
        ends, tolerance = (here - reach, here + reach * mp.mpf("0.7")), mp.mpf(10) ** (-2 * digits)
        return mp.findroot(gap, ends, solver="secant", tol=tolerance, verify=False)
