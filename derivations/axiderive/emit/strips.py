"""Numbers of a plane contact in the terms of a round one, so that sketch, plots and check values are the same."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile
from ..proof.evaluate import at_precision
from .values import DIGITS, Numbers, Values

REACH = sp.Rational(27, 10)
"""Distance of the reference point in half-widths of the sketch: its end."""


class StripNumbers(Numbers):
    """A strip of half-width a: the depth is that of the middle below the surface at L = 2.7 a."""

    def __init__(self, profile: Profile, entries: Mapping[str, Entry], values: Values, digits: int = DIGITS) -> None:
        super().__init__(profile, entries, values, digits)
        self.values = dict(values)
        if not self.compact and nt.P not in self.values:
            self.values[nt.P] = self._load()

    def _load(self) -> Any:
        """A load under which the whole face presses: the depth of the sketch says how far beyond the least load.

        Of three digits, so that it is printed as it is.
        """
        share = sp.Rational(str(self.profile.sketch.d or 1)) + 1
        load = share * (self.least if "Pmin" in self.entries else sp.Rational(1, 2))
        return sp.Rational(f"{float(load):.3g}")

    @property
    def least(self) -> sp.Rational:
        """The least load of complete contact."""
        ring = self("xz") if self.entries["xz"].status == "closed" else self._ring()
        values = self.values | {nt.x_zero: ring}
        found = Numbers(self.profile, self.entries, values, self.digits)("Pmin")
        return sp.nsimplify(found, rational=True)

    def _ring(self) -> Any:
        case = next(c for c in self.entries["xz"].cases if c.expr.has(nt.x_zero))
        equation = case.expr.lhs - case.expr.rhs
        with mp.workdps(self.digits):
            a = self["a"]
            return mp.findroot(
                lambda x: at_precision(equation, {**self.values, nt.x_zero: x}), (a / 3, 2 * a / 3), solver="anderson"
            )

    def at(self, **changed: Any) -> Numbers:
        values = self.values | {nt.describe(name).symbol: value for name, value in changed.items()}
        return StripNumbers(self.profile, self.entries, values, self.digits)

    def __call__(self, suffix: str, r: Any = None) -> Any:
        if suffix == "F":
            return self["P"] if not self.compact else super().__call__("P")
        if suffix == "w":
            return self.depth - super().__call__("d", r)
        return super().__call__(suffix, self.reach if suffix == "d" and r is None else r)

    def place(self, suffix: str) -> sp.Symbol:
        return nt.L if suffix == "d" else nt.x

    @property
    def reach(self) -> Any:
        """The distance that depths are related to: the same for every half-width."""
        return mp.mpf(REACH.p) / REACH.q * mp.mpf(self.profile.sketch.a)

    @property
    def depth(self) -> Any:
        return self("d")

    @property
    def mean_pressure(self) -> Any:
        return self("F") / (2 * self["a"])
