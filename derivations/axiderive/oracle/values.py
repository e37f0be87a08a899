"""Numbers of the entries at given parameter values.

Numbers behind pictures, plots and check tables: the entries of a profile at given parameter values.

Numbers of a plane contact in the terms of a round one, so that sketch, plots and check values are the same.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import Entry
from ..profiles.profile import Profile
from .evaluate import at_precision, case_at
from .shape import coefficient, concrete, number, numeric_symbols

Values = dict[Any, Any]
DIGITS = 25
POLYNOMIAL = (sp.Rational(3, 20), sp.Rational(1, 5), sp.Rational(1, 10))
"""Coefficients with which the polynomial profile is drawn and tabulated."""


@dataclass(frozen=True)
class Remaining:
    """An integral that is left in a result, and the symbol that stands for its value there."""

    stand_in: sp.Symbol
    variable: sp.Symbol
    low: sp.Expr
    high: sp.Expr
    body: sp.Expr


def evaluated(expr: sp.Expr, values: Values) -> Any:
    """The value of a result at the working precision; integrals left in it by quadrature."""
    function, arguments, integrals = _prepared(concrete(sp.sympify(expr), values), numeric_symbols(values))
    known = dict(values)
    for one in integrals:
        ends = [evaluated(end, values) for end in (one.low, one.high)]
        known[one.stand_in] = mp.quad(_of_one_variable(one.body, one.variable, values), ends)
    return function(*(number(known[s]) for s in arguments))


def _of_one_variable(body: sp.Expr, variable: sp.Symbol, values: Values) -> Callable[[Any], Any]:
    """The integrand with everything but its variable fixed, looked up once and not at every node."""
    function, (_, *others), _ = _prepared(body, (variable, *numeric_symbols(values)))
    fixed = [number(values[s]) for s in others]
    return lambda x: function(x, *fixed)


@lru_cache(maxsize=4096)
def _prepared(
    expr: sp.Expr, known: tuple[sp.Symbol, ...]
) -> tuple[Callable[..., Any], tuple[sp.Symbol, ...], tuple[Remaining, ...]]:
    """A result as a function, the known symbols that it takes, and the integrals whose values it takes."""
    integrals = []
    for i, integral in enumerate(sorted(expr.atoms(sp.Integral), key=str)):
        variable, low, high = integral.limits[0]
        integrals.append(Remaining(sp.Symbol(f"integral{i}", positive=True), variable, low, high, integral.function))
        expr = expr.xreplace({integral: integrals[-1].stand_in})
    own = {master.__name__: master.numeric for master in MASTERS}
    arguments = tuple(s for s in (*known, *(one.stand_in for one in integrals)) if expr.has(s))
    function: Callable[..., Any] = sp.lambdify(arguments, expr, modules=[own, "mpmath"], cse=True)
    return function, arguments, tuple(integrals)


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


def least(curve: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """The least value between two points, by the golden section: exact to the square of the width that is left."""
    ratio = (mp.sqrt(5) - 1) / 2
    x, y = high - ratio * (high - low), low + ratio * (high - low)
    below, above = curve(x), curve(y)
    for _ in range(40):
        if below < above:
            high, y, above = y, x, below
            x = high - ratio * (high - low)
            below = curve(x)
        else:
            low, x, below = x, y, above
            y = low + ratio * (high - low)
            above = curve(y)
    return min(below, above)


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
            return at_precision(sp.sympify(nt.describe(name).symbol), self.values)

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
            return mp.re(evaluated(case.expr, values))

    def place(self, suffix: str) -> sp.Symbol:
        """The coordinate a field is asked for at."""
        return nt.r

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
            for piece in self.profile.pieces:
                if piece.upper is None or mp.mpf(r) <= at_precision(piece.upper, self.values):
                    return at_precision(piece.expr, {**self.values, nt.r: mp.mpf(r), nt.x: mp.mpf(r)})
        message = f"{self.profile.name}: no piece of the profile reaches r = {r}"
        raise LookupError(message)


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
        """The same strip with other values, by the names of their symbols."""
        values = self.values | {nt.describe(name).symbol: value for name, value in changed.items()}
        return StripNumbers(self.profile, self.entries, values, self.digits)

    def __call__(self, suffix: str, r: Any = None) -> Any:
        if suffix == "F":
            return self["P"] if not self.compact else super().__call__("P")
        if suffix == "w":
            return self.depth - super().__call__("d", r)
        return super().__call__(suffix, self.reach if suffix == "d" and r is None else r)

    def place(self, suffix: str) -> sp.Symbol:
        """L for the depth, x for everything else."""
        return nt.L if suffix == "d" else nt.x

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
