"""Rings of zero and of greatest pressure, with least depth, least force and greatest pressure, by their definitions.

On the graded half-space p >= 0 asks for d >= g(a) - W(r), W(r) = (a**2 - r**2)**((1 - k)/2) int_r^a g'(t)
(t**2 - r**2)**((k - 1)/2) dt, so that the ring is where W has its minimum.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case
from ..oracle.definitions import first_zero, greatest, stationary
from ..oracle.evaluate import case_at, evaluate, evaluated, holds
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import GUARD
from ..oracle.sampling import points
from ..oracle.shape import Number, Shape, Values, number, shape
from ..profiles.profile import Profile
from .comparison import Comparison, Evidence, Rows, residual, root

Search = Callable[[Shape, Number, int], tuple[Number, Number]]
DEFINED = "mpmath quadrature of the defining integral"
EXPONENTS = tuple(sp.Rational(x) for x in ("-3/10", "1/5", "1/2"))
POWERS = tuple(sp.Rational(x) for x in ("37/10", "9/5", "5/2"))
ELSEWHERE = (0.05, 0.3, 0.6, 0.9)


def check(own: Comparison, suffix: str) -> Evidence:
    """Evidence for a ring or for what is known of it."""
    if own.graded(suffix):
        return _graded(own, suffix)
    peak = bool(own.entries[suffix].quantity.member)
    # a search asks for a hundred integrals, whose panels are doubles: none between an edge and a face just as large
    drawn = points(own.profile, (*own.profile.breaks, nt.a) if peak else (nt.a,), own.points, own.seed)
    cases = own.entries["rp" if peak else "rz"].cases
    known = [point for point in drawn if any(holds(case, point.values) for case in cases)]
    chosen = [point for point in known if not point.extreme][:3] if peak else known[:2]
    with mp.workdps(own.digits + GUARD):
        rows: Rows = [(point.values, _residual(own, suffix, peak, point.values)) for point in chosen]
    compared = DEFINED + (", its greatest value searched for over the radii" if peak else "")
    return own.judge(suffix, compared, rows, extremes=sum(point.extreme for point in chosen))


def _residual(own: Comparison, suffix: str, peak: bool, values: Values) -> Number:
    """Against the pressure of the definition, whose greatest value, or first zero, is searched for."""
    place, symbol, search = ("rp", nt.r_peak, greatest) if peak else ("rz", nt.r_zero, first_zero)
    profile, digits = own.profile, own.digits
    radius, level = _searched(search, profile, tuple(values.items()), int(mp.mp.prec), digits)
    equation = case_at(own.entries[place], values).expr
    if isinstance(equation, sp.Eq):
        bracket = Case((*(profile.breaks if peak else (sp.S.Zero,)), symbol, nt.a), equation)
        found = root(bracket, symbol, {**values, symbol: radius}, digits)
    else:
        found = evaluated(equation, values)
    if suffix == place:
        return residual(found, radius) if radius else abs(found)
    got = evaluate(case_at(own.entries[suffix], values).expr, {**values, symbol: found}, digits)
    if peak:
        return residual(got, number(values[nt.E_star]) * level)
    if suffix == "dmin":
        return residual(got, level)
    here = HalfSpace(profile, {**values, nt.d: level}, digits, False)
    return residual(got, here.force(*here.contact(here.at(nt.a))))


@lru_cache(maxsize=8)
def _searched(
    search: Search, profile: Profile, items: tuple[tuple[sp.Symbol, sp.Expr], ...], prec: int, digits: int
) -> tuple[Number, Number]:
    values = dict(items)
    return search(shape(profile, values), number(values[nt.a]), digits)


def _graded(own: Comparison, suffix: str) -> Evidence:
    """At one point, with each of `EXPONENTS` for k and another n if there is one."""
    rows: Rows = []
    with mp.workdps(own.digits + GUARD):
        for exponent, power in zip(EXPONENTS, POWERS, strict=True):
            values = {**points(own.profile, (nt.a,), 1, own.seed, (nt.H,))[0].values, nt.k: exponent}
            if nt.n in own.profile.parameters:
                values[nt.n] = power
            rows.append((values, _graded_residual(own, suffix, values)))
    return own.judge(suffix, "least weighted pressure by quadrature of its definition", rows)


def _graded_residual(own: Comparison, suffix: str, values: Values) -> Number:
    here, digits = HalfSpace(own.profile, values, own.digits, True), own.digits
    a = here.at(nt.a)
    face = here.face(a)

    def weighted(r: Number) -> Number:
        return mp.pi * face.pressure(a, r) * ((a - r) * (a + r)) ** ((1 - here.k) / 2)

    found = _ring(case_at(own.entries["rz"], values), values, a, digits)
    least = weighted(found)
    if suffix == "rz":
        return _offset(weighted, found, least, a)
    depth = face.depth(a) - least
    got = evaluate(case_at(own.entries[suffix], values).expr, {**values, nt.r_zero: found}, digits)
    return residual(got, depth if suffix == "dmin" else here.modulus * face.force(a, depth))


def _ring(case: Case, values: Values, a: Number, digits: int) -> Number:
    """What the entry says, its equation solved from a bracket; whether it is the minimum is measured afterwards."""
    if not isinstance(case.expr, sp.Eq):
        return evaluate(case.expr, values, digits) if case.expr != 0 else mp.mpf(0)
    starts = [a * i / 40 for i in range(1, 40)]

    def gap(x: Number) -> Number:
        return evaluated(case.expr.lhs - case.expr.rhs, {**values, nt.r_zero: x})

    for lo, hi in zip(starts, starts[1:], strict=False):
        if gap(lo) * gap(hi) < 0:
            near = mp.findroot(gap, (lo, hi), solver="anderson", tol=mp.mpf(10) ** -12, verify=False)
            bracket = Case((sp.S.Zero, nt.r_zero, nt.a), case.expr)
            return root(bracket, nt.r_zero, {**values, nt.r_zero: near}, digits)
    message = f"the equation of the ring {case.expr} has no root below a"
    raise ArithmeticError(message)


def _offset(weighted: Callable[[Number], Number], ring: Number, least: Number, a: Number) -> Number:
    """How far the least value next to the ring lies from it, relative to the ring; 1 if there is a lower one."""
    if any(weighted(a * mp.mpf(x)) <= least for x in ELSEWHERE):
        return mp.mpf(1)
    return mp.mpf(0) if ring == 0 else residual(ring, stationary(weighted, ring, a)[0])
