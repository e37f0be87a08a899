"""Points at which printed rows are compared with their entries: inside every case, at values a reader could use."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from functools import partial
from typing import Any

import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.evaluate import decades, evaluate, holds
from ..oracle.sampling import points
from ..physics.adhesive import CONTROLS

Values = dict[Any, Any]
SEPARATE = {nt.k, nt.e, nt.E_star, nt.n}
"""Symbols that are not drawn as lengths or stresses are."""
EXPONENT_OF_GRADING = (sp.Rational(3, 5), sp.Rational(-2, 5))
POISSON = {nt.nu: sp.Rational(2, 7), nt.nu_1: sp.Rational(3, 11), nt.nu_2: sp.Rational(5, 13)}
STABLE_EXPONENT = sp.Rational(17, 10)
DRAWS = 6
"""Points of which the first one of a case is chosen: the one whose lengths are the most alike."""


def points_of(
    entry: Entry, kind: str, entries: Mapping[str, Entry], count: int, seed: int
) -> list[tuple[Case, Values]]:
    """Points of every case; an inverse without a formula is met where its forward formula leads."""
    source = entry
    if kind in ("root", "composition"):
        source = entries[entry.quantity.inverts]
    return [(case, values) for case in source.cases for values in _drawn(entries, entry, source, case, count, seed)]


def _drawn(
    entries: Mapping[str, Entry], entry: Entry, source: Entry, case: Case, count: int, seed: int
) -> list[Values]:
    """The first point has lengths of one size: where one of two terms vanishes, a misprint of it is not seen."""
    chain, fields = _lengths(case), _fields(entry, source, case)
    alike = sorted((points(entry.profile, chain, 1, seed + i, fields)[0].values for i in range(DRAWS)), key=decades)
    others = [point.values for point in points(entry.profile, chain, count, seed, fields)[1:]]
    first = next(filter(partial(_pulls, entries, entry, case), (_completed(entry, case, values) for values in alike)))
    return [first, *(_completed(entry, case, values) for values in others)]


def _pulls(entries: Mapping[str, Entry], entry: Entry, case: Case, values: Values) -> bool:
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
    """What a chain of lengths cannot say: exponents, the side of an eccentric load, a place inside the contact."""
    fixed = dict(values)
    if nt.k in entry.parameters:
        fixed[nt.k] = _grading(case)
    fixed |= {ratio: value for ratio, value in POISSON.items() if ratio in fixed}
    fixed |= {symbol: expr.xreplace(fixed) for symbol, expr in entry.profile.abbreviations if expr.has(nt.k)}
    fixed = {symbol: value for symbol, value in fixed.items() if not sp.sympify(value).free_symbols}
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
