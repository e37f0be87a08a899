"""One number per function for its doctest, computed from the exact entry or, without closed form, its definition."""

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
from ..physics import examples
from ..physics.examples import Values

MATERIAL: Values = {nt.H: sp.S.One, nt.k: sp.Rational(1, 4), nt.H_x: sp.Rational(4, 5)}
GIVEN = {"ad": "d", "aF": "F", "Fd": "d", "dF": "F", "c": "F"}
"""Inverses, and the entry whose value in the drawn state they start from."""
DIGITS = 15


class Example(examples.Example):
    """The doctests of one module, on a half-space with k = 1/4; `elastic` are the entries of its normal contact."""

    def __init__(
        self, profile: Profile, entries: Mapping[str, Entry], group: str, elastic: Mapping[str, Entry]
    ) -> None:
        super().__init__(profile, entries, f"graded.{group}", elastic)
        self.physics = group

    @cached_property
    def known(self) -> Values:
        """Parameters and the middle of the contact, as for the homogeneous half-space."""
        drawn = examples.Example(self.profile, self.entries, self.group).known
        return drawn | MATERIAL | {nt.d: self.loads[nt.d]}

    def lines(self, suffix: str) -> list[str]:
        """The doctest of the function behind one entry."""
        entry, at = self.entries[suffix], dict(self.known)
        if entry.quantity.symbol == nt.w:
            at[nt.r] = 2 * at[nt.a]
        if suffix in GIVEN:
            field = entry.quantity.arguments[0]
            at[field] = _rounded(self.number(self.entries[GIVEN[suffix]], at))
        passed = [example.literal(at[symbol]) for symbol in entry.quantity.arguments]
        passed += [self.keyword(symbol, at) for symbol in entry.parameters]
        first, *others = fit(f"value = {self.profile.name}.{entry.quantity.function}({', '.join(passed)})", 12)
        typed = [f">>> {first}", *(f"... {other}" for other in others)]
        return [*self.head(), *typed, ">>> round(value, 6)", example.result(self.number(entry, at))]

    def number(self, entry: Entry, at: Values) -> sp.Float:
        """The exact value; what an equation defines is its root near the drawn state."""
        if entry.status == "integral":
            return self.defined(entry, at)
        if entry.status == "root" and entry.composed:
            outer, inner = entry.composed
            return self.number(self.entries[outer], at | {nt.a: self.number(self.entries[inner], at)})
        if entry.suffix == "rz" and isinstance(example._case(entry, at | {nt.r_zero: at[nt.r]}).expr, sp.Eq):
            return example._root(self.profile, entry, at)
        ring = self.entries.get("rz")
        if entry.suffix in ("dmin", "Fmin") and ring is not None:
            at = at | {nt.r_zero: self.number(ring, at)}
        return super().number(entry, at)

    def defined(self, entry: Entry, at: Values) -> sp.Float:
        """A pressure or displacement without closed form, by quadrature."""
        half_space = HalfSpace(self.profile, at, DIGITS, graded=True)
        rules = {"normal": half_space.normal, "adhesive": half_space.adhesive, "tangential": half_space.tangential}
        with mp.workdps(2 * DIGITS):
            a = mp.mpf(str(sp.N(at[nt.a], 2 * DIGITS)))
            return sp.Float(str(mp.re(rules[self.physics](entry.suffix, a))), 2 * DIGITS)


def _rounded(number: sp.Float) -> sp.Rational:
    return sp.Rational(str(sp.Float(str(number), 4)))
