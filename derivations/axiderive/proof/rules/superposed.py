"""Contacts that superpose another one, as their physics says why: its statements, shown in every region."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from ...abel.form import Chain, insert
from ...entry import FOUR, Case, Entry
from ...notation import a, r
from ...physics import DEPTH, DISPLACEMENT, FORCE, OWN, PRESSURE, SHAPE, Proof, Shown
from ..algebra.domain import Domain
from ..algebra.identity import at
from ..statement import Rule, closed, require_regions, require_zero
from .compact import Compact
from .complete import Complete

SUFFIXES = dict(zip((DEPTH, FORCE, PRESSURE, DISPLACEMENT), FOUR, strict=True))


class Superposed:
    """The entries of one profile above those of its normal contact, with the proofs of their physics."""

    def __init__(self, normal: Compact | Complete, entries: dict[str, Entry], proofs: Mapping[str, Proof]) -> None:
        self.normal, self.entries, self.proofs = normal, entries, proofs
        self.floor = normal.profile.breaks[0] if normal.profile.truncated else None

    def show(self, suffix: str) -> list[str]:
        """The steps that prove a quantity."""
        proof, steps = self.proofs[suffix], list[str]()
        source, entry = closed(self.normal.entries[proof.over]), self._closed(suffix)
        wanted = [case.chain for case in source.cases]
        if proof.within is not None:
            wanted = [new for old in wanted for new in insert(old, proof.within, above=self.floor, below=a)]
        if proof.beyond is not None:
            end = next((high for low, high in itertools.pairwise(self.normal.profile.chain) if low == a), None)
            wanted = [new for old in wanted for new in insert(old, proof.beyond, above=a, below=end)]
        require_regions(entry, tuple(wanted))
        for case in entry.cases:
            radii = {a, proof.within, proof.beyond}
            steps += [self._step(case, shown, radii) for shown in proof.shown if _applies(case, shown)]
        return steps

    def _closed(self, suffix: str) -> Entry:
        """The entry; of a root what its equation says of the value that is given."""
        entry = self.entries[suffix]
        source = entry.quantity.inverts
        if entry.status != "root" or not source:
            return closed(entry)
        given = self.entries[source].quantity.symbol
        cases = (Case(case.chain, case.expr.lhs - case.expr.rhs + given) for case in entry.cases)
        return replace(entry, cases=tuple(cases))

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
        called = (own for name in (*SUFFIXES, SHAPE) for own in expr.atoms(name))
        return expr.xreplace({own: self._formula(own, chain, radii) for own in called})

    def _formula(self, called: sp.Expr, chain: Chain, radii: set[sp.Symbol | None]) -> sp.Expr:
        """A quantity of the contact below of the radius that it is called with; no pressure outside of it."""
        if called.func == SHAPE:
            return self.normal.profile.height(chain, *called.args)
        *places, radius = called.args
        if called.func == PRESSURE and any(chain.index(place) > chain.index(radius) for place in places):
            return sp.S.Zero
        others = radii - {radius, *places} if places else radii - {radius} | {r}
        renamed = {radius: a, **dict.fromkeys(places, r)}
        region = tuple(renamed.get(x, x) for x in chain if x not in others)
        entry = closed(self.normal.entries[SUFFIXES[called.func]])
        (found,) = (own.expr for own in entry.cases if own.chain == region)
        return found.subs([*zip((r,), places, strict=False), (a, radius)], simultaneous=True)


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
    return {suffix: (_needed(proof), Superposed.show, suffix) for suffix, proof in proofs.items()}


def _needed(proof: Proof) -> tuple[str, ...]:
    named = (own for own in SUFFIXES if any(shown.zero.has(own) for shown in proof.shown))
    return tuple(dict.fromkeys(f"plain.{suffix}" for suffix in (proof.over, *map(SUFFIXES.__getitem__, named))))
