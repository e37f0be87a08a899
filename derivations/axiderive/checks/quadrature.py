"""Every formula against the integral that defines it, at 50 digits.

The known side of an inverse is the defining integral at a chosen contact
radius; the inverse must lead back to that radius.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.definitions import Contact, contact, greatest, level, ring
from ..oracle.evaluate import at_precision, case_at, evaluate, evaluate_case, holds
from ..oracle.evidence import Evidence, judge, residual
from ..oracle.integrals import GUARD
from ..oracle.sampling import Point, fields, points
from ..oracle.shape import Number, Values, shape
from ..profiles.profile import Profile

LOST = 10
"""Digits by which the agreement may fall short of the digits of the quadrature."""

Entries = Mapping[str, Entry]


def check(
    profile: Profile, entries: Entries, suffix: str, *, digits: int = 50, points: int = 8, seed: int = 0
) -> Evidence:
    """Compare one entry with its definition at `points` points or more: every case gets at least three."""
    entry = entries[suffix]
    drawn = _points(profile, entries, suffix, points, seed)
    with mp.workdps(digits + GUARD):
        rows = [(point.values, _residual(profile, entries, suffix, point.values, digits)) for point in drawn]
    return judge(
        entry.key,
        "mpmath quadrature of the defining integral"
        + (", round trip" if entry.quantity.inverts else "")
        + (", its greatest value searched for over the radii" if entry.quantity.member else ""),
        rows,
        seed=seed,
        extremes=sum(point.extreme for point in drawn),
        digits=digits,
        required=digits - LOST,
    )


def check_profile(
    profile: Profile, entries: Entries, *, digits: int = 50, points: int = 8, seed: int = 0
) -> dict[str, Evidence]:
    """The evidence for every entry of a profile, keyed by suffix."""
    return {suffix: check(profile, entries, suffix, digits=digits, points=points, seed=seed) for suffix in entries}


def _points(profile: Profile, entries: Entries, suffix: str, count: int, seed: int) -> list[Point]:
    """Points spread over the cases; those of an inverse are drawn in the regions of the formula it inverts."""
    quantity = entries[suffix].quantity
    if quantity.threshold:
        drawn = points(profile, (nt.a,), count, seed)
        return [point for point in drawn if any(holds(case, point.values) for case in entries["rz"].cases)][:2]
    if quantity.member:
        # a search asks for a hundred integrals, whose panels are doubles: none between an edge and a face just as large
        drawn = points(profile, (*profile.breaks, nt.a), count, seed)
        known = [point for point in drawn if any(holds(case, point.values) for case in entries["rp"].cases)]
        return [point for point in known if not point.extreme][:3]
    source = entries[quantity.inverts or suffix]
    chains = [case.chain for case in source.cases]
    if suffix in ("k", "pm") and "d" in entries:
        chains = [case.chain for case in entries["d"].cases]
    each = max(3, -(-count // len(chains)))
    return [point for chain in chains for point in points(profile, chain, each, seed, fields(profile, source))]


def _residual(profile: Profile, entries: Entries, suffix: str, values: Values, digits: int) -> Number:
    quantity = entries[suffix].quantity
    if quantity.threshold:
        return _threshold_residual(profile, entries, suffix, values, digits)
    if quantity.member:
        return _peak_residual(profile, entries, suffix, values, digits)
    # next to the largest radius of a compact contact an inverse costs half as many digits as the gap has
    here = contact(profile, values, digits + (20 if quantity.inverts else 0))
    if not quantity.inverts:
        return residual(value(entries[suffix], values, digits), here.quantity(suffix))
    known = {**values, quantity.arguments[0]: here.quantity(quantity.inverts)}
    wanted = here.radius if quantity.symbol == nt.a else here.quantity(str(quantity.symbol))
    return residual(inverse(entries, suffix, known, digits), wanted)


def value(entry: Entry, values: Values, digits: int) -> Number:
    """A closed result, or one that stays an integral, at a point."""
    case = case_at(entry, values)
    return evaluate_case(case, values, digits) if case.expr.has(sp.Integral) else evaluate(case.expr, values, digits)


def inverse(entries: Entries, suffix: str, known: Values, digits: int) -> Number:
    """A closed inverse evaluated, or the root of its equation found and, where asked for, carried on to d or F."""
    entry = entries[suffix]
    if entry.status != "root":
        without = {s: v for s, v in known.items() if s != nt.a or entry.profile.complete}
        if entry.profile.complete:
            without.pop(entry.quantity.symbol, None)
        return evaluate(case_at(entry, without).expr, without, digits)
    largest = entry.profile.largest
    radius = root(case_at(entry, known), nt.a, known, digits, () if largest is None else (largest,))
    if entry.quantity.symbol == nt.a:
        return radius
    return evaluate(case_at(entries[str(entry.quantity.symbol)], known).expr, {**known, nt.a: radius}, digits)


def root(case: Case, unknown: sp.Symbol, known: Values, digits: int, beyond: tuple[sp.Expr, ...] = ()) -> Number:
    """The root of an equation by bracketing, from a start that is off by a thousandth of the way to the next border.

    The brackets only say which root; that the equation has its root at the known point is what the residual measures.
    """
    here = at_precision(unknown, known)
    borders = [at_precision(x, known) for x in (*case.chain, *beyond) if x != unknown]
    reach = min([abs(border - here) for border in borders] + [here]) / 1000

    def gap(x: Number) -> Number:
        at = {**known, unknown: x}
        return at_precision(case.expr.lhs, at) / at_precision(case.expr.rhs, at) - 1

    with mp.extradps(2 * GUARD):
        tolerance = mp.mpf(10) ** (-2 * digits)
        return mp.findroot(
            gap, (here - reach, here + reach * mp.mpf("0.7")), solver="secant", tol=tolerance, verify=False
        )


@lru_cache(maxsize=8)
def _ring(
    profile: Profile, items: tuple[tuple[sp.Symbol, sp.Expr], ...], prec: int, digits: int
) -> tuple[Number, Number]:
    values = dict(items)
    face, a = shape(profile, values), at_precision(nt.a, values)
    return ring(lambda r, digits: level(face, a, r, digits), a, digits)


def _peak_residual(profile: Profile, entries: Entries, suffix: str, values: Values, digits: int) -> Number:
    """Ring and greatest pressure against the pressure of the definition, whose greatest value is searched for."""
    place, height = _greatest(profile, tuple(values.items()), int(mp.mp.prec), digits)
    equation = case_at(entries["rp"], values).expr
    if isinstance(equation, sp.Eq):
        bracket = Case((*profile.breaks, nt.r_peak, nt.a), equation)
        found = root(bracket, nt.r_peak, {**values, nt.r_peak: place}, digits)
    else:
        found = at_precision(equation, values)
    if suffix == "rp":
        return residual(found, place) if place else abs(found)
    got = evaluate(case_at(entries["pp"], values).expr, {**values, nt.r_peak: found}, digits)
    return residual(got, at_precision(nt.E_star, values) * height)


@lru_cache(maxsize=8)
def _greatest(
    profile: Profile, items: tuple[tuple[sp.Symbol, sp.Expr], ...], prec: int, digits: int
) -> tuple[Number, Number]:
    values = dict(items)
    return greatest(shape(profile, values), at_precision(nt.a, values), digits)


def _threshold_residual(profile: Profile, entries: Entries, suffix: str, values: Values, digits: int) -> Number:
    """Ring, least depth and least force against the pressure of the definition, whose maximum is searched for."""
    radius, depth = _ring(profile, tuple(values.items()), int(mp.mp.prec), digits)
    case = case_at(entries["rz"], values)
    equation = case.expr
    if isinstance(equation, sp.Eq):
        found = root(Case((sp.S.Zero, nt.r_zero, nt.a), equation), nt.r_zero, {**values, nt.r_zero: radius}, digits)
    else:
        found = at_precision(equation, values)
    if suffix == "rz":
        return residual(found, radius) if radius else abs(found)
    got = evaluate(case_at(entries[suffix], values).expr, {**values, nt.r_zero: found}, digits)
    if suffix == "dmin":
        return residual(got, depth)
    at_depth: Contact = contact(profile, {**values, nt.d: depth}, digits)
    return residual(got, at_depth.quantity("F"))
