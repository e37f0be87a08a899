"""Exact algebra of dimensions over a result: every sum homogeneous, every argument of a function a number.

Exponents may be symbols, A a**n has the dimension of a length because A has
length**(1 - n).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy.core.function import AppliedUndef

from .. import notation as nt
from ..abel.masters import C0, CapMoment, Eta, Xi
from ..entry import Entry
from ..notation import Dimension
from ..profiles.profile import Profile
from .comparison import Evidence

OF_LENGTHS = (C0,)
"""Masters that take lengths; they are numbers all the same, because they are homogeneous of degree 0."""


class UnitsError(ValueError):
    """A term whose dimension does not fit."""


def same(left: Dimension, right: Dimension) -> bool:
    """Whether the exponents of length and of force are equal, also where they are symbols."""
    return bool(sp.cancel(left.length - right.length) == 0 and sp.cancel(left.force - right.force) == 0)


def text(dimension: Dimension) -> str:
    """The dimension for a message: "length**(-2) force" for a stress, "a number" without a dimension."""
    parts = [
        name if power == 1 else f"{name}**({power})"
        for name, power in (("length", dimension.length), ("force", dimension.force))
        if power != 0
    ]
    return " ".join(parts) or "a number"


@dataclass(frozen=True)
class Units:
    """The algebra, with the dimensions that a profile fixes for its own symbols."""

    known: Mapping[sp.Symbol, Dimension] = field(default_factory=dict)

    @classmethod
    def of(cls, profile: Profile) -> Units:
        """The coefficient of a profile of fixed power has the dimension that makes f a length."""
        if nt.A not in profile.parameters or nt.n in profile.parameters:
            return cls()
        shape = cls({nt.A: nt.NUMBER}).dimension(profile.pieces[0].expr)
        return cls({nt.A: nt.LENGTH * shape**-1})

    def dimension(self, expr: sp.Expr) -> Dimension:
        """The dimension of an expression.

        Raises
        ------
        UnitsError
            Naming the term, what it has and what it should have.
        """
        if expr.is_number:
            return nt.NUMBER
        if expr.is_Symbol:
            return self.known.get(expr, nt.describe(expr).dimension)
        if isinstance(expr, sp.Indexed):
            return nt.LENGTH ** (1 - expr.indices[0])
        if expr.is_Add or isinstance(expr, sp.Equality):
            return self._common(expr)
        if expr.is_Mul:
            product = nt.NUMBER
            for factor in expr.args:
                product = product * self.dimension(factor)
            return product
        if expr.is_Pow:
            self._number(expr.exp, expr)
            return self.dimension(expr.base) ** expr.exp
        if isinstance(expr, sp.Sum):
            return self._sum(expr)
        if isinstance(expr, sp.Integral):
            return self._integral(expr)
        if isinstance(expr, sp.Abs | sp.Max):
            return self._common(sp.Tuple(*(term for term in expr.args if term != 0)))
        if isinstance(expr, sp.sign):
            return nt.NUMBER
        if isinstance(expr, OF_LENGTHS):
            self._common(expr)
            return nt.NUMBER
        if isinstance(expr, CapMoment):
            exponent, *lengths = expr.args
            self._common(sp.Tuple(*lengths))
            return nt.LENGTH**exponent
        if isinstance(expr, Xi | Eta):
            return self._common(expr)
        if isinstance(expr, sp.Derivative):
            return self.dimension(expr.expr) * self.dimension(expr.variables[0]) ** -1
        if isinstance(expr, AppliedUndef):
            return nt.describe(expr.func.__name__).dimension
        if isinstance(expr, sp.Function):
            for argument in expr.args:
                self._number(argument, expr)
            return nt.NUMBER
        message = f"no rule for the dimension of {type(expr).__name__} in {expr}; add one to units.dimension"
        raise UnitsError(message)

    def comparable(self, chain: tuple[sp.Expr, ...]) -> None:
        """Lengths stand beside lengths in a chain, forces beside forces."""
        if len(chain) > 1:
            self._common(sp.Tuple(*chain))

    def _common(self, expr: sp.Expr) -> Dimension:
        """The one dimension of all arguments."""
        first, *others = expr.args
        wanted = self.dimension(first)
        for term in others:
            found = self.dimension(term)
            if term != 0 and not same(found, wanted):
                message = f"{term} has {text(found)}, but {first} beside it has {text(wanted)}, in {expr}"
                raise UnitsError(message)
        return wanted

    def _number(self, argument: sp.Expr, where: sp.Expr) -> None:
        found = self.dimension(argument)
        if not same(found, nt.NUMBER):
            message = f"{argument} has {text(found)} where {where} asks for a number; divide it by a length"
            raise UnitsError(message)

    def _sum(self, expr: sp.Sum) -> Dimension:
        index, *limits = expr.limits[0]
        for limit in limits:
            self._number(limit, expr)
        found = self.dimension(expr.function)
        reduced = Dimension(sp.cancel(found.length), sp.cancel(found.force))
        if reduced.length.has(index) or reduced.force.has(index):
            message = f"{expr.function} has {text(reduced)}, different for every {index}; its sum has no dimension"
            raise UnitsError(message)
        return reduced

    def _integral(self, expr: sp.Integral) -> Dimension:
        variable, lower, upper = expr.limits[0]
        wanted = self.dimension(upper)
        # u is a power of a length on the graded half-space, and its limit says which; elsewhere it is what it is
        if not same(wanted, self.dimension(variable)) and not wanted.length.has(nt.k):
            message = (
                f"the limit {upper} has {text(wanted)}, but {variable} has {text(self.dimension(variable))}, in {expr}"
            )
            raise UnitsError(message)
        found = self.dimension(lower)
        if lower != 0 and not same(found, wanted):
            message = f"the limit {lower} has {text(found)}, the limit {upper} has {text(wanted)}, in {expr}"
            raise UnitsError(message)
        inside = Units({**self.known, variable: wanted})
        return inside.dimension(expr.function) * wanted


def check(profile: Profile, entries: Mapping[str, Entry], suffix: str) -> Evidence:
    """Every case of an entry has the dimension of its quantity, and its region compares like with like."""
    entry = entries[suffix]
    compared = "dimension of every term, by exact algebra"
    units = Units.of(profile)
    try:
        for case in entry.cases:
            _fits(units, case.expr, entry)
            units.comparable(case.chain)
    except UnitsError as error:
        return Evidence(entry.key, compared, "failed", reason=str(error))
    return Evidence(entry.key, compared, "passed", count=len(entry.cases))


def _fits(units: Units, expr: sp.Expr, entry: Entry) -> None:
    if isinstance(expr, sp.Equality):
        units.dimension(expr)
        return
    found, wanted = units.dimension(expr), nt.describe(entry.quantity.symbol).dimension
    if expr != 0 and not same(found, wanted):
        message = f"{entry.key} has {text(found)}; {entry.quantity.label.lower()} asks for {text(wanted)}"
        raise UnitsError(message)


def check_profile(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Evidence]:
    """Evidence for every entry, by suffix."""
    return {suffix: check(profile, entries, suffix) for suffix in entries}
