"""Contacts that superpose another one, as their physics says why: its statements, shown in every region."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...abel.form import Chain, insert
from ...entry import Case, Entry
from ...notation import a, r
from ...physics import DEPTH, FORCE, OWN, PRESSURE, Proof, Shown
from ..algebra.domain import Domain
from ..algebra.identity import at
from ..statement import Rule, closed, require_regions, require_zero
from .compact import Compact
from .complete import Complete

SUFFIXES = {DEPTH: "d", FORCE: "F", PRESSURE: "p"}


class Superposed:
    """The entries of one profile above those of its normal contact, with the proofs of their physics."""

    def __init__(self, normal: Compact | Complete, entries: dict[str, Entry], proofs: Mapping[str, Proof]) -> None:
        self.normal, self.entries, self.proofs = normal, entries, proofs
        self.floor = normal.profile.breaks[0] if normal.profile.truncated else None

    def show(self, suffix: str) -> list[str]:
        """The steps that prove a quantity."""
        proof, steps = self.proofs[suffix], list[str]()
        source, entry = closed(self.normal.entries[proof.over]), closed(self.entries[suffix])
        wanted = [case.chain for case in source.cases]
        if proof.within is not None:
            wanted = [new for old in wanted for new in insert(old, proof.within, above=self.floor, below=a)]
        require_regions(entry, tuple(wanted))
        for case in entry.cases:
            steps += [self._step(case, shown, {a, proof.within}) for shown in proof.shown if _applies(case, shown)]
        return steps

    def _step(self, case: Case, shown: Shown, radii: set[sp.Symbol | None]) -> str:
        """That the expression of a statement vanishes in a region, or on the border that it names."""
        given = {symbol: self._put(expr, case.chain, radii) for symbol, expr in shown.given.items()}
        zero = self._put(shown.zero, case.chain, radii).xreplace({OWN: case.expr.subs(given)}).doit()
        domain = self.normal.domain(case.chain)
        if shown.known:
            domain = Domain(*shown.known, *domain.chains())
        if shown.at is not None:
            domain = domain.at(*shown.at)
            zero = at(zero, *shown.at, domain)
        return require_zero(zero, domain, shown.label)

    def _put(self, expr: sp.Expr, chain: Chain, radii: set[sp.Symbol | None]) -> sp.Expr:
        """The expression with the formulas of the contact below, each in the region that a chain leaves of it."""
        called = (own for name in SUFFIXES for own in expr.atoms(name))
        return expr.xreplace({own: self._formula(own, chain, radii) for own in called})

    def _formula(self, called: sp.Expr, chain: Chain, radii: set[sp.Symbol | None]) -> sp.Expr:
        """A quantity of the contact below of the radius that it is called with; no pressure outside of it."""
        *places, radius = called.args
        if any(chain.index(place) > chain.index(radius) for place in places):
            return sp.S.Zero
        others = radii - {radius} if places else radii - {radius} | {r}
        region = tuple(a if x == radius else x for x in chain if x not in others)
        entry = closed(self.normal.entries[SUFFIXES[called.func]])
        (found,) = (own.expr for own in entry.cases if own.chain == region)
        return found.subs(a, radius)


def _applies(case: Case, shown: Shown) -> bool:
    """Whether a statement is one about a region: about its order of two lengths, or about one of its borders."""
    if shown.where is not None:
        return case.below(*shown.where)
    if shown.at is not None:
        symbol, value = shown.at
        place = case.chain.index(symbol)
        return value == (case.chain[place - 1] if place else 0)
    return True


def rules(proofs: Mapping[str, Proof]) -> dict[str, Rule]:
    """What every quantity rests on, and its steps."""
    return {suffix: ((f"plain.{proof.over}",), Superposed.show, suffix) for suffix, proof in proofs.items()}
