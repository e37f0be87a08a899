"""One number per function for its doctest, computed from the exact entry and not by the emitted code."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import Case, Entry
from ...letters import name_of
from ...profiles.profile import Profile
from .. import example
from ..layout import fit
from .text import PACKAGE

Values = dict[sp.Symbol, sp.Expr]
MATERIAL: Values = {
    symbol: sp.Rational(value)
    for symbol, value in (
        (nt.E_star, "1"), (nt.dgamma, "1/100"), (nt.mu, "3/10"), (nt.G_star, "4/5"), (nt.E, "1"), (nt.E_inf, "2/5"),
        (nt.E_1, "3/5"), (nt.relaxation, "2"), (nt.eta, "3/2"), (nt.alpha, "1/4"), (nt.t_0, "1"), (nt.v, "1/5"),
        (nt.p_0, "1"), (nt.sigma, "3/10"), (nt.time, "1"),
    )
}  # fmt: skip
STICK = sp.Rational(3, 5)
"""c/a, or its place between a flat face and a."""
PLACES = 97
"""Radii at which the least force is looked for: a prime, so that no break of a drawn profile is met."""


class Example:
    """The doctests of one module."""

    def __init__(
        self, profile: Profile, entries: Mapping[str, Entry], group: str, elastic: Mapping[str, Entry] | None = None
    ) -> None:
        self.profile, self.entries, self.group = profile, entries, group
        self.elastic = elastic or {}
        """The normal contact, from which a stick radius takes F(a) and a step of depth takes a(d)."""

    @cached_property
    def known(self) -> Values:
        """Parameters as drawn, unit moduli, and fields in the middle of the contact."""
        known = MATERIAL | example.numbers(self.profile)
        known |= {symbol: expr.subs(known) for symbol, expr in self.profile.abbreviations}
        radius = known.get(nt.a, sp.Rational(str(self.profile.sketch.a)))
        floor = known[self.profile.breaks[0]] if self.profile.truncated else sp.S.Zero
        rounded_stick = _rounded(sp.N(floor + STICK * (radius - floor)))
        return {nt.a: radius, nt.c: rounded_stick, nt.r: radius * sp.Rational(3, 10)} | known

    def lines(self, suffix: str) -> list[str]:
        """The doctest of the function behind one entry."""
        entry = self.entries[suffix]
        at = dict(self.known)
        if entry.quantity.symbol == nt.w:
            at[nt.r] = 2 * at[nt.a]
        given = entry.quantity.inverts
        if given:
            at[entry.quantity.arguments[0]] = _rounded(self.number(self.entries[given], at))
        loads = [own for own in entry.quantity.arguments if own in (nt.d, nt.F) and not given]
        at |= self.loads if loads else {}
        fields = [symbol for symbol in entry.quantity.arguments if symbol not in loads]
        passed = [example.literal(at[symbol]) for symbol in fields]
        passed += [self.keyword(symbol, at) for symbol in (*loads, *entry.parameters)]
        call = f"{self.profile.name}.{entry.quantity.function}({', '.join(passed)})"
        return [*self.head(), *_typed(f"value = {call}"), ">>> round(value, 6)", example.result(self.number(entry, at))]

    @property
    def loads(self) -> Values:
        """A depth, which keeps a concave face in complete contact, and a force."""
        drawn = self.profile.sketch.d if self.profile.complete else None
        return {nt.d: sp.Rational(str(drawn)) if drawn else sp.Rational(1, 5), nt.F: sp.Rational(1, 5)}

    def head(self) -> list[str]:
        """The first line of a doctest: the import of the module."""
        return [f">>> from {PACKAGE}.{self.group} import {self.profile.name}"]

    def keyword(self, symbol: sp.Symbol | sp.IndexedBase, at: Values) -> str:
        """A keyword argument with its value as Python code, a polynomial as the tuple A."""
        if symbol == nt.coefficients:
            return f"A=({', '.join(example.literal(c) for c in example.POLYNOMIAL)})"
        return f"{name_of(symbol)}={example.literal(at[symbol])}"

    def number(self, entry: Entry, at: Values) -> sp.Float:
        """The exact value; of an inverse the root near the drawn radius."""
        symbol = entry.quantity.symbol
        if entry.status == "root" and symbol in (nt.a, nt.c):
            return self.root(entry, symbol, at)
        if entry.status == "root":
            at = at | {nt.a: self.root(self.elastic["ad"], nt.a, at)}
        return _closed(entry, at)

    def root(self, entry: Entry, unknown: sp.Symbol, at: Values) -> sp.Float:
        """The unknown that solves the equation of an entry, to 30 digits; searched from its drawn value."""
        equations = _Numeric(entry, unknown, at, lambda expr: expr.lhs - expr.rhs)
        with mp.workdps(30):
            start = mp.mpf(str(sp.N(self.known[unknown], 30)))
            found = mp.findroot(equations, (start, start * mp.mpf("1.001")), tol=mp.mpf("1e-40"), verify=False)
            return sp.Float(str(found), 30)

    def pull_off(self, keywords: Sequence[str]) -> list[str]:
        """The force at pull-off: the least value of F(a)."""
        symbols = {name_of(symbol): symbol for symbol in self.entries["F"].parameters}
        passed = ", ".join(self.keyword(symbols[name], self.known) for name in keywords)
        call = f"state = {self.profile.name}.pull_off({passed})"
        lines = [*self.head(), *_typed(call), ">>> round(state.force, 6)"]
        return [*lines, example.result(self.least_force())]

    def least_force(self) -> sp.Float:
        """The least of F(a) up to the drawn radius, to 30 digits: on a grid, then next to its lowest point."""
        force = _Numeric(self.entries["F"], nt.a, self.known, lambda expr: expr)
        with mp.workdps(30):
            low = mp.mpf(str(sp.N(self.known[self.profile.breaks[0]], 30))) if self.profile.truncated else mp.mpf(0)
            reach = mp.mpf(str(sp.N(self.known[nt.a], 30))) - low
            # a break itself belongs to no case
            grid = [low + reach * mp.mpf("1e-20"), *(low + reach * i / PLACES for i in range(1, PLACES + 1))]
            values = [force(x) for x in grid]
            best = min(range(len(grid)), key=lambda i: values[i])
            below, above = grid[max(best - 1, 0)], grid[min(best + 1, len(grid) - 1)]
            return sp.Float(str(min(values[best], _least(force, below, above))), 30)


def _typed(line: str) -> list[str]:
    """A statement of a doctest, on several lines where it is too long for one."""
    first, *others = fit(line, 12)
    return [f">>> {first}", *(f"... {other}" for other in others)]


def _closed(entry: Entry, at: Values) -> sp.Float:
    expr = example._plain(example._case(entry, at).expr)
    return example.number(expr.rhs if isinstance(expr, sp.Eq) else expr, at)


class _Numeric:
    """The cases of an entry as functions of one unknown."""

    def __init__(self, entry: Entry, unknown: sp.Symbol, at: Values, form: Callable[[sp.Expr], sp.Expr]) -> None:
        self.entry, self.unknown, self.at, self.form = entry, unknown, at, form
        self.compiled: dict[Case, Callable[[Any], Any]] = {}

    def __call__(self, x: Any) -> Any:
        known = {**self.at, self.unknown: sp.Float(str(x), 30)}
        case = example._case(self.entry, known)
        if case not in self.compiled:
            expr = example._plain(self.form(case.expr))
            self.compiled[case] = example.function(expr, self.at, self.unknown)
        return mp.re(self.compiled[case](x))


def _least(function: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """The least value between two points, by the golden section: exact to the square of the width that is left."""
    ratio = (mp.sqrt(5) - 1) / 2
    x, y = high - ratio * (high - low), low + ratio * (high - low)
    fx, fy = function(x), function(y)
    for _ in range(40):
        if fx < fy:
            high, y, fy = y, x, fx
            x = high - ratio * (high - low)
            fx = function(x)
        else:
            low, x, fx = x, y, fy
            y = low + ratio * (high - low)
            fy = function(y)
    return min(fx, fy)


def _rounded(number: sp.Float) -> sp.Rational:
    return sp.Rational(str(sp.Float(str(number), 4)))
