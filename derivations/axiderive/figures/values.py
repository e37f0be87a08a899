"""Numbers behind pictures, plots and check tables: the entries of a profile at given parameter values.

A strip gives its numbers in the terms of a round contact, so that sketch, plots and check values are the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import Entry
from ..oracle.evaluate import case_at, evaluated, height, value_of
from ..oracle.shape import coefficient
from ..profiles.profile import Profile

Values = dict[Any, Any]
DIGITS = 25
POLYNOMIAL = (sp.Rational(3, 20), sp.Rational(1, 5), sp.Rational(1, 10))
"""Coefficients with which the polynomial profile is drawn and tabulated."""


def sketch_values(profile: Profile) -> Values:
    """The parameters a profile is drawn with, exact, with E_star = 1; lengths in units of the picture."""
    values: Values = {symbol: sp.Rational(str(value)) for symbol, value in profile.sketch.values}
    values[nt.E_star] = sp.S.One
    values[nt.a] = sp.Rational(str(profile.sketch.a))
    if profile.sketch.d is not None:
        values[nt.d] = sp.Rational(str(profile.sketch.d))
    if nt.coefficients in profile.parameters:
        values[nt.N] = sp.Integer(len(POLYNOMIAL))
        values |= {coefficient(i + 1): value for i, value in enumerate(POLYNOMIAL)}
    for symbol, expr in profile.abbreviations:
        values[symbol] = expr.xreplace(values)
    return values


class Numbers:
    """Evaluates the entries of one profile."""

    def __init__(self, profile: Profile, entries: Mapping[str, Entry], values: Values, digits: int = DIGITS) -> None:
        self.profile, self.entries, self.values, self.digits = profile, entries, values, digits
        self.compact = profile.compact

    def at(self, **changed: Any) -> Numbers:
        """The same profile with other values, by the names of their symbols."""
        values = self.values | {nt.describe(name).symbol: value for name, value in changed.items()}
        return Numbers(self.profile, self.entries, values, self.digits)

    def __getitem__(self, name: str) -> Any:
        """The value of a parameter."""
        with mp.workdps(self.digits):
            return evaluated(sp.sympify(nt.describe(name).symbol), self.values)

    def __call__(self, suffix: str, r: Any = None) -> Any:
        """One quantity; a radius on a border of two cases is moved off it a little."""
        values = dict(self.values)
        with mp.workdps(self.digits):
            place = self.place(suffix)
            if r is not None:
                values[place] = mp.mpmathify(r)
            try:
                case = case_at(self.entries[suffix], values)
            except LookupError:
                values[place] = values[place] * (1 + mp.mpf(10) ** (4 - self.digits))
                case = case_at(self.entries[suffix], values)
            # for all else of a curve what mpmath compiles once is as quick as an enclosure
            if case.expr.has(*MASTERS):
                return value_of(case.expr, values, self.digits)
            return mp.re(evaluated(case.expr, values))

    def place(self, suffix: str) -> sp.Symbol:
        """The coordinate a field is asked for at: r or x, and L of the depth of a strip."""
        return next((s for s in self.entries[suffix].quantity.arguments if s in (nt.x, nt.L)), nt.r)

    @property
    def least(self) -> Any:
        """The depth, or load of a strip, from which on a concave face is in contact everywhere."""
        suffix, bound = ("xz", "Pmin") if "xz" in self.entries else ("rz", "dmin")
        entry = self.entries[suffix]
        symbol = entry.quantity.symbol
        equation = next((case.expr for case in entry.cases if case.expr.has(symbol)), None)
        with mp.workdps(self.digits):
            if equation is None:
                ring = Numbers.__call__(self, suffix)
            else:
                a, excess = self["a"], equation.lhs - equation.rhs
                near = (a / 3, 2 * a / 3)
                ring = mp.findroot(lambda x: evaluated(excess, {**self.values, symbol: x}), near, solver="anderson")
        return Numbers(self.profile, self.entries, self.values | {symbol: ring}, self.digits)(bound)

    @property
    def depth(self) -> Any:
        """The value of the entry d where the contact grows, otherwise the given value of d."""
        return self("d") if self.compact else self["d"]

    @property
    def mean_pressure(self) -> Any:
        """F/(pi a**2)."""
        return self("F") / (mp.pi * self["a"] ** 2)

    def shape(self, r: Any) -> Any:
        """f(r)."""
        with mp.workdps(self.digits):
            return height(self.profile, self.values, mp.mpmathify(r))


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

    def at(self, **changed: Any) -> Numbers:
        """The same strip with other values, by the names of their symbols."""
        values = self.values | {nt.describe(name).symbol: value for name, value in changed.items()}
        return StripNumbers(self.profile, self.entries, values, self.digits)

    def __call__(self, suffix: str, r: Any = None) -> Any:
        if suffix == "F":
            return self["P"] if not self.compact else super().__call__("P")
        if suffix == "w":
            return self.depth - super().__call__("d", r)
        return super().__call__(suffix, self.reach if suffix == "d" and r is None else r)

    @property
    def reach(self) -> Any:
        """The distance that depths are related to: the same for every half-width."""
        return mp.mpf(REACH.p) / REACH.q * mp.mpf(self.profile.sketch.a)

    @property
    def depth(self) -> Any:
        """Depth of the middle below the surface at the distance `reach`."""
        return self("d")

    @property
    def mean_pressure(self) -> Any:
        """Line load over the width, P/(2 a)."""
        return self("F") / (2 * self["a"])
