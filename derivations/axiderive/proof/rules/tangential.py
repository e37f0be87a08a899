"""Partial slip: mu times the difference of two normal contacts of radii a and c, (11.78)-(11.80)."""

from __future__ import annotations

import sympy as sp

from ...abel.form import Chain, insert
from ...entry import Case, Entry
from ...notation import F_x, G_star, H_x, a, c, mu, r
from ..algebra.identity import at
from ..statement import Rule, closed, paired, require_regions, require_zero
from .compact import Compact


class Tangential:
    """The tangential entries of one profile, above those of its normal contact."""

    def __init__(self, normal: Compact, entries: dict[str, Entry]) -> None:
        self.normal, self.entries = normal, entries
        profile = normal.profile
        self.floor = profile.breaks[0] if profile.truncated else None
        tangential = G_star if normal.medium.k == 0 else H_x
        self.ratio = mu * normal.medium.modulus / tangential

    def force(self) -> list[str]:
        """F_x = mu (F(a) - F(c)), for every place of c below a."""
        return self._difference("F", "F", mu)

    def displacement(self) -> list[str]:
        """u = mu E*/G* (g(a) - g(c)), on the graded half-space with H/H_x, for every place of c below a."""
        return self._difference("u", "d", self.ratio)

    def _difference(self, suffix: str, source: str, unit: sp.Expr) -> list[str]:
        """unit * (value at a - value at c), for every place of c below a."""
        entry, steps = self.entries[suffix], []
        self._require_places(entry, self.normal.entry(source))
        for case in entry.cases:
            outer, inner = self._pair(case.chain, self.normal.entry(source))
            wanted = unit * (outer.expr - inner.expr.subs(a, c))
            statement = f"{suffix} = {unit} ({source}(a) - {source}(c))"
            steps.append(require_zero(case.expr - wanted, self.normal.domain(case.chain), statement))
        return steps

    def _require_places(self, entry: Entry, source: Entry) -> None:
        wanted = (chain for case in source.cases for chain in insert(case.chain, c, above=self.floor, below=a))
        require_regions(entry, tuple(wanted))

    @staticmethod
    def _pair(chain: Chain, source: Entry) -> tuple[Case, Case]:
        """The normal contact with a at its place, and the one with a where c is."""
        outer = tuple(length for length in chain if length != c)
        inner = tuple(a if length == c else length for length in chain if length != a)
        cases = {case.chain: case for case in source.cases}
        return cases[outer], cases[inner]

    def traction(self) -> list[str]:
        """mu p(r; a), less mu p(r; c) where the contact sticks."""
        entry, source, steps = self.entries["tau"], self.normal.entry("p"), []
        self._require_places(entry, source)
        for case in entry.cases:
            domain = self.normal.domain(case.chain)
            if case.below(c, r):
                (own,) = (p for p in source.cases if p.chain == tuple(x for x in case.chain if x != c))
                gap = case.expr - mu * own.expr
                steps.append(require_zero(gap, domain, "tau = mu p(r; a) for c < r < a"))
                continue
            outer, inner = self._pair(case.chain, source)
            gap = case.expr - mu * (outer.expr - inner.expr.subs(a, c))
            steps.append(require_zero(gap, domain, "tau = mu (p(r; a) - p(r; c)) for r < c"))
            if case.chain.index(c) == case.chain.index(r) + 1:
                lost = at(case.expr - mu * outer.expr, c, r)
                steps.append(require_zero(lost, domain.at(c, r), "tau is continuous at r = c"))
        return steps

    def full_slip(self) -> list[str]:
        """The displacement with c at its smallest, where g(c) = 0."""
        entry, source, steps = self.entries["us"], self.normal.entry("d"), []
        for case, own in paired(entry, source):
            domain = self.normal.domain(own.chain)
            gap = case.expr - self.ratio * own.expr
            steps.append(require_zero(gap, domain, f"u at full slip = {self.ratio} g(a)"))
        lowest = source.cases[0]
        face = self.normal.domain(lowest.chain).at(a, self.floor or sp.S.Zero)
        value = at(lowest.expr, a, self.floor or sp.S.Zero, face)
        return [*steps, require_zero(value, face, "g -> 0 where the contact begins")]

    def stick_radius(self) -> list[str]:
        """c(F_x) from F_x = mu (F(a) - F(c))."""
        entry = closed(self.entries["c"])
        chain = (c, a) if self.floor is None else (self.floor, c, a)
        require_regions(entry, (chain,))
        (case,), (force,) = entry.cases, self.normal.entry("F").cases
        domain = self.normal.domain(chain)
        outer, inner = force.expr, force.expr.subs(a, c)
        back = case.expr.subs(F_x, mu * (outer - inner))
        return [require_zero(back - c, domain, "c(F(a), F_x = mu (F(a) - F(c))) = c")]


RULES: dict[str, Rule] = {
    "F": (("plain.F",), Tangential.force),
    "tau": (("plain.p",), Tangential.traction),
    "u": (("plain.d",), Tangential.displacement),
    "c": (("plain.F",), Tangential.stick_radius),
    "us": (("plain.d",), Tangential.full_slip),
}
