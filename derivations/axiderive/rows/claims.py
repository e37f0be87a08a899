"""What every row of a problem says, exactly: the value of its quantity in a case, or that its sides are equal there.

It is taken from the entries, never from the text of the row: also the loads and radii that belong together. Rows are
compared with it at points inside of every case, at values a reader could use.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeAlias

import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.evaluate import decades, evaluate, holds
from ..oracle.sampling import points
from ..physics.adhesive import CONTROLS
from ..physics.systems import of
from .row import Row

Entries = Mapping[str, Entry]
Exact: TypeAlias = sp.Basic | Entry
"""An expression, an equation, or an entry in whichever of its cases holds at a point."""
Given = tuple[tuple[sp.Symbol, Exact], ...]
"""Symbols that follow from those before them."""


@dataclass(frozen=True)
class Claim:
    """A statement about every point of a case, once the symbols that are given there have their values."""

    given: Given = ()
    value: Exact | None = None
    """Of the quantity on the left, or of each side of an equation; None of an equation that holds there."""


def claim(one: Row, entry: Entry, case: Case, entries: Entries, base: Entries) -> Claim:
    """What a row says of an entry that it is about, in a case of that entry or, of an inverse, of the forward formula.

    `base` are the entries of the normal contact on the same medium.
    """
    own, slip = entry.quantity, _slip(entry, base)
    if one.kind == "formula":
        return Claim((*slip, (nt.F, base["F"])) if own.symbol == nt.p_mean else slip, case.expr)
    if one.kind == "definition":
        also = ((entries[one.uses].quantity.symbol, entries[one.uses]),) if one.uses else ()
        return Claim(((own.symbol, case.expr), *also))
    if one.kind == "root":
        return Claim(((own.arguments[0], case.expr),))
    if one.kind == "composition" and entry.composed:
        known = entry if entry.status == "closed" else entries[entry.composed[0]]
        return Claim(((own.arguments[0], case.expr),), known)
    if of(entry).physics.laws:
        return _law(entry, case, base)
    if own.inverts or own.symbol == nt.a_c:
        return Claim((*slip, *_balance(entry, case)))
    rings = [one for one in entries.values() if own.member and one.quantity.symbol == nt.r_peak]
    ring = ((nt.r_peak, one) for one in rings if one.status == "closed")
    return Claim((*ring, *_pulled(entry, case, entries)), case.expr)


def _slip(entry: Entry, base: Entries) -> Given:
    """A tangential force between full stick and full slip under the force that the outer radius belongs to."""
    if nt.F_x not in entry.quantity.arguments:
        return ()
    return ((nt.F, base["F"]), (nt.F_x, nt.F * nt.mu * sp.Rational(3, 7)))


def _balance(entry: Entry, case: Case) -> Given:
    """The unknown takes its closed value, or what balances the equation the value that goes with the unknown."""
    if not isinstance(case.expr, sp.Equality):
        return ((entry.quantity.symbol, case.expr),)
    left, right = case.expr.args
    # the load is the argument, or what gives one of the lengths at hand
    if entry.quantity.arguments:
        return ((right, left),)
    return ((nt.dgamma, nt.dgamma * (left / right) ** 2),)


def _pulled(entry: Entry, case: Case, entries: Entries) -> Given:
    """Radius and work of separation that belong together at pull-off; nothing else has a control."""
    if not entry.quantity.control:
        return ()
    radius = entries[CONTROLS[entry.quantity.control][0]]
    same = (other for other in radius.cases if radius.status == "closed" or other.chain == case.chain)
    return _balance(radius, next(same))


def _law(entry: Entry, case: Case, base: Entries) -> Claim:
    """Of a viscoelastic contact at any modulus: the row has E* beside the functions of the law, the entry has not."""
    equation = isinstance(case.expr, sp.Equality)
    given: Given = ((nt.E_star, sp.Integer(3)),)
    if equation and entry.quantity.symbol == nt.a:
        left, right = case.expr.args
        return Claim((*given, (nt.F, nt.F * left / right)))
    known = {s for x in (*case.chain, case.expr) for s in x.free_symbols}
    if nt.d in entry.quantity.arguments and nt.a not in known and "ad" in base:
        given = (*given, (nt.a, base["ad"]))
    return Claim(given, case.expr.args[1] if equation else case.expr)


Values = dict[Any, Any]
SEPARATE = {nt.k, nt.e, nt.E_star, nt.n}
"""Symbols that are not drawn as lengths or stresses are."""
EXPONENT_OF_GRADING = (sp.Rational(3, 5), sp.Rational(-2, 5))
POISSON = {nt.nu: sp.Rational(2, 7), nt.nu_1: sp.Rational(3, 11), nt.nu_2: sp.Rational(5, 13)}
STABLE_EXPONENT = sp.Rational(17, 10)
DRAWS, MOST = 6, 600
"""Points of which the first one of a case is chosen, that whose lengths are the most alike; and how many are tried."""


def points_of(entry: Entry, kind: str, entries: Entries, count: int, seed: int) -> list[tuple[Case, Values]]:
    """Points of every case; an inverse without a formula is met where its forward formula leads."""
    source = entry
    if kind in ("root", "composition"):
        source = entries[entry.quantity.inverts]
    return [(case, values) for case in source.cases for values in _drawn(entries, entry, source, case, count, seed)]


def _drawn(entries: Entries, entry: Entry, source: Entry, case: Case, count: int, seed: int) -> list[Values]:
    """The first point has lengths of one size: where one of two terms vanishes, a misprint of it is not seen."""
    chain, fields = _lengths(case), _fields(entry, source, case)
    near = sorted(itertools.islice(_inside(entry, case, fields, seed), DRAWS), key=decades)
    others = (_completed(entry, case, point.values) for point in points(entry.profile, chain, count, seed, fields)[1:])
    growing = filter(partial(_pulls, entries, entry, case), (_completed(entry, case, values) for values in near))
    if (first := next(growing, None)) is None:
        message = f"{entry.key}: no point of the case {case.chain} is among {MOST} that were drawn; draw others"
        raise ValueError(message)
    return [first, *(values for values in others if chain or holds(case, values))]


def _inside(entry: Entry, case: Case, fields: tuple[sp.Symbol, ...], seed: int) -> Iterator[Values]:
    """Points of a case: where its lengths could not be drawn from, those of all points that are in it."""
    chain, moved = _lengths(case), any(x.has(nt.k) for x in case.chain)
    for i in range(seed, seed + MOST):
        values = points(entry.profile, chain, 1, i, fields)[0].values
        if chain or moved or holds(case, _completed(entry, case, values)):
            yield values


def _pulls(entries: Entries, entry: Entry, case: Case, values: Values) -> bool:
    """Whether the depth grows with the radius, which a pull-off needs; that of a bump falls far out."""
    radius = CONTROLS[entry.quantity.control][0] if entry.quantity.control else ""
    if radius not in entries:
        return True
    slope = [own.expr for own in entries[radius].cases if own.chain == case.chain]
    equations = [expr for expr in slope if isinstance(expr, sp.Equality)]
    return all(evaluate(expr.lhs, values, 5) > 0 for expr in equations)


def _lengths(case: Case) -> tuple[sp.Expr, ...]:
    """The chain to draw from; numbers around an exponent and the side of a load are seen to afterwards."""
    return () if any(x.is_number or x.has(sp.Abs, nt.k) for x in case.chain) else case.chain


def _grading(case: Case) -> sp.Rational:
    """The exponent of the half-space; below zero the integrals across a break converge too slowly to be read back."""
    return EXPONENT_OF_GRADING[len(case.chain) % 2 if not case.expr.has(sp.Integral) else 0]


def _fields(entry: Entry, source: Entry, case: Case) -> tuple[sp.Symbol, ...]:
    lengths = {s for x in case.chain for s in x.free_symbols}
    own = {*source.quantity.arguments, *source.parameters, *entry.parameters, *case.expr.free_symbols, *lengths}
    own -= {nt.F, nt.d} if source is not entry else set()
    fixed = {*entry.profile.parameters, *SEPARATE, nt.coefficients, nt.j, nt.N}
    integrated = {integral.limits[0][0] for integral in case.expr.atoms(sp.Integral)}
    return tuple(s for s in sorted(own - fixed - integrated, key=str) if isinstance(s, sp.Symbol))


def _completed(entry: Entry, case: Case, values: Values) -> Values:
    """What a chain of lengths cannot say: exponents, signs, the side of a load, a place inside the contact."""
    fixed = dict(values)
    if nt.k in entry.parameters:
        fixed[nt.k] = _grading(case)
    fixed |= {ratio: value for ratio, value in POISSON.items() if ratio in fixed}
    fixed |= {symbol: expr.xreplace(fixed) for symbol, expr in entry.profile.abbreviations if expr.has(nt.k)}
    fixed = {symbol: value for symbol, value in fixed.items() if not sp.sympify(value).free_symbols}
    if nt.C_13 in fixed:
        fixed[nt.C_13] = -min(fixed[nt.C_11], fixed[nt.C_33]) * sp.Rational(3, 7)
    if nt.radius_2 in fixed:
        fixed[nt.radius_2] = -fixed[nt.radius_1] * sp.Rational(13, 5)
    if nt.alpha in fixed:
        fixed[nt.alpha] = sp.Rational(2, 5)
    if nt.n in fixed:
        fixed[nt.n] = STABLE_EXPONENT
    for i, x in enumerate(case.chain):
        if x.is_Symbol and i and not (low := case.chain[i - 1].xreplace(fixed)).free_symbols and x == nt.n:
            room = case.chain[i + 1] - low if i + 1 < len(case.chain) else sp.Integer(3)
            fixed[x] = low + room * sp.Rational(3, 7)
    for ring in (nt.r_zero, nt.x_zero):
        if ring in fixed:
            fixed[ring] = fixed[nt.a] * sp.Rational(7, 11)
    if nt.r_peak in fixed:
        low = sum(fixed[b] for b in entry.profile.breaks)
        fixed[nt.r_peak] = low + (fixed[nt.a] - low) * sp.Rational(4, 11)
    if nt.F_x in fixed and nt.F in fixed:
        fixed[nt.F_x] = fixed[nt.F] * fixed[nt.mu] * sp.Rational(3, 7)
    if any(x.has(nt.k) and not x.is_Symbol for x in case.chain) and nt.n not in fixed:
        return _moved_into(case, fixed)
    if nt.e in entry.profile.parameters:
        fixed[nt.e] = -fixed[nt.a] * sp.Rational(*((2, 7) if case.chain[0] != nt.a / 2 else (5, 7)))
        fixed[nt.x] = -fixed[nt.a] * sp.Rational(8, 9)
    return fixed


def _moved_into(case: Case, values: Values) -> Values:
    """A depth or force, and a radius, that lie in the region; its border has no inverse in closed form."""
    load = next(s for s in (nt.F, nt.d) if s in values)
    for power, share in itertools.product(
        range(-6, 7), (sp.Rational(1, 9), sp.Rational(8, 9), sp.Integer(2), sp.Integer(9))
    ):
        moved = {**values, load: values[load] * sp.Integer(4) ** power}
        if nt.r in values:
            moved[nt.r] = values[nt.a] * share
        if holds(case, moved):
            return moved
    message = f"no point found in {case.chain}"
    raise LookupError(message)
