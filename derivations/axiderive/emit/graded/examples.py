"""One number per function for its doctest, computed from the exact entry at 30 digits."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...profiles.profile import Profile
from ...proof.half_space import HalfSpace
from .. import example
from ..layout import fit
from ..physics.text import name_of

Values = dict[sp.Symbol, sp.Expr]
MATERIAL: Values = {
    nt.H: sp.S.One,
    nt.k: sp.Rational(1, 4),
    nt.H_x: sp.Rational(4, 5),
    nt.dgamma: sp.Rational(1, 100),
    nt.mu: sp.Rational(3, 10),
}
GIVEN = {"ad": "d", "aF": "F", "Fd": "d", "dF": "F"}
"""Inverses, and the entry whose value at the drawn radius they start from."""
LOADS = {"d": nt.d, "F": nt.F}


class Example:
    """The doctests of one module; `plain` are the entries without adhesion or friction."""

    def __init__(
        self, profile: Profile, entries: Mapping[str, Entry], group: str, plain: Mapping[str, Entry] | None = None
    ) -> None:
        self.profile, self.entries, self.group = profile, entries, group
        self.plain = plain or entries

    @cached_property
    def known(self) -> Values:
        """Parameters as drawn, a unit modulus with k = 1/4, and fields in the middle of the contact."""
        known = MATERIAL | example.numbers(self.profile)
        known |= {symbol: expr.subs(known) for symbol, expr in self.profile.abbreviations}
        a = known.get(nt.a, sp.Rational(str(self.profile.sketch.a)))
        floor = known[self.profile.breaks[0]] if self.profile.truncated else sp.S.Zero
        known |= {nt.a: a, nt.r: a * sp.Rational(3, 10), nt.c: _rounded(sp.N((floor + a) / 2))}
        return known | {nt.d: sp.Rational(str(self.profile.sketch.d or "0.6"))}

    def lines(self, suffix: str) -> list[str]:
        """The doctest of the function behind one entry."""
        entry = self.entries[suffix]
        at = dict(self.known)
        if entry.quantity.symbol == nt.w:
            at[nt.r] = 2 * at[nt.a]
        if suffix in GIVEN:
            source = self.entries[GIVEN[suffix]]
            at[LOADS[GIVEN[suffix]]] = _rounded(self.closed(source, at))
        if nt.F_x in entry.quantity.arguments:
            at[nt.F_x] = _rounded(self.closed(self.entries["F"], at))
        passed = [example.literal(at[symbol]) for symbol in entry.quantity.arguments]
        return self.shown(entry.quantity.function, passed, entry.parameters, at, self.number(entry, at))

    def shown(
        self, function: str, passed: list[str], symbols: tuple[sp.Symbol, ...], at: Values, value: sp.Float
    ) -> list[str]:
        arguments = [*passed, *(self.keyword(symbol, at) for symbol in symbols)]
        first, *others = fit(f"value = {self.profile.name}.{function}({', '.join(arguments)})", 12)
        typed = [f">>> {first}", *(f"... {other}" for other in others)]
        return [*self.head(), *typed, ">>> round(value, 6)", example.result(value)]

    def head(self) -> list[str]:
        return [f">>> from axicontact.{self.group} import {self.profile.name}"]

    def keyword(self, symbol: sp.Symbol | sp.IndexedBase, at: Values) -> str:
        if symbol == nt.coefficients:
            return f"A=({', '.join(example.literal(c) for c in example.POLYNOMIAL)})"
        return f"{name_of(symbol)}={example.literal(at[symbol])}"

    def number(self, entry: Entry, at: Values) -> sp.Float:
        """The exact value; what an equation defines is its root near the drawn state."""
        if entry.status == "root" and entry.composed:
            outer, inner = entry.composed
            return self.closed(self.entries[outer], at | {nt.a: self.root(self.entries[inner], nt.a, at)})
        if entry.status == "root":
            unknown = {"c": nt.c, "rz": nt.r_zero}.get(entry.suffix, nt.a)
            return self.root(entry, unknown, at)
        if entry.suffix == "c":
            at = at | {nt.F: self.closed(self.plain["F"], at)}
        if entry.status == "integral":
            return self.defined(entry, at)
        ring = self.entries.get("rz")
        if entry.suffix in ("dmin", "Fmin") and ring is not None:
            at = at | {nt.r_zero: self.number(ring, at)}
        return self.closed(entry, at)

    def defined(self, entry: Entry, at: Values) -> sp.Float:
        """A pressure or displacement without closed form, from its definition."""
        half_space = HalfSpace(self.profile, at, 15, graded=True)
        quantity = {"adhesive": half_space.adhesive, "tangential": half_space.tangential}.get(
            self.group.removeprefix("graded."), half_space.normal
        )
        with mp.workdps(30):
            return sp.Float(str(mp.re(quantity(entry.suffix, mp.mpf(str(sp.N(at[nt.a], 30)))))), 30)

    def closed(self, entry: Entry, at: Values) -> sp.Float:
        return example.number(example._plain(example._case(entry, at).expr), at)

    def root(self, entry: Entry, unknown: sp.Symbol, at: Values) -> sp.Float:
        start = at[nt.a] * sp.Rational(2, 5) if unknown == nt.r_zero else at[unknown]
        if unknown == nt.r_zero and not isinstance(entry.cases[-1].expr, sp.Eq):
            return self.closed(entry, at)

        def residual(x: object) -> object:
            now = at | {unknown: sp.Float(str(x), 30)}
            expr = example._plain(example._case(entry, now).expr)
            return mp.mpf(str(example.number(expr.lhs - expr.rhs, now))) if isinstance(expr, sp.Eq) else mp.mpf(0)

        with mp.workdps(30):
            near = mp.mpf(str(sp.N(start, 30)))
            found = mp.findroot(residual, (near, near * mp.mpf("1.001")), tol=mp.mpf("1e-40"), verify=False)
            return sp.Float(str(found), 30)


def _rounded(number: sp.Float) -> sp.Rational:
    return sp.Rational(str(sp.Float(str(number), 4)))
