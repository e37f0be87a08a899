"""Every formula of a round contact against the integrals that define it, at 50 digits; prescribed pressures too.

Roots and inverses are checked by round trip: the known side is the definition at a chosen contact radius, the entry
must lead back to it.  Of the rings of zero and of greatest pressure, with least depth, least force and greatest
pressure, the definition is searched: on the graded half-space p >= 0 asks for d >= g(a) - W(r), W(r) =
(a**2 - r**2)**((1 - k)/2) int_r^a g'(t) (t**2 - r**2)**((k - 1)/2) dt, so that the ring is where W has its minimum.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.definitions import first_zero, greatest, stationary
from ..oracle.evaluate import case_at, evaluate, evaluate_case, evaluated, holds
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import GUARD, under_load
from ..oracle.sampling import points
from ..oracle.shape import Number, Shape, Values, number, shape
from ..physics import DEPTH, PRESSURE, normal
from ..physics.consequences import CONSEQUENCES
from ..profiles.loads import Load
from ..profiles.profile import Profile
from . import viscoelastic
from .comparison import LOST, Comparison, Evidence, Rows, formula_value, inverse, residual, root

NESTED = 46
"""Digits of a pressure on the graded half-space, which is an integral of integrals."""
NESTED_LOST = 6
SUMMED = 14
"""Digits of an integral over pressures by the definition, each of which is an integral."""
TWICE = 20
"""Digits of a consequence, or of a sum over depths, which are integrals of integrals too."""
DEEP = 2
"""Points of a sum over depths."""
STABLE = mp.mpf(9) / 10
"""Greatest share of the work of separation that a contact of radius a can carry: an inverse is the stable branch."""
ILL = 60
"""Digits carried beyond those asked for where a small stick zone is the root of a difference of two forces."""
LOADED = tuple(sp.Rational(x) for x in ("-9/10", "-3/5", "-1/4", "3/10", "1", "27/10"))
"""Exponents of a prescribed pressure."""


def check(own: Comparison, suffix: str) -> Evidence:
    """Compare one entry with its definition."""
    if isinstance(own.profile, Load):
        return _of_load(own, own.profile, suffix)
    if own.physics.laws:
        return viscoelastic.check(own, suffix)
    quantity, graded = own.entries[suffix].quantity, own.graded(suffix)
    if own.physics.definitions is None and (quantity.threshold or (quantity.member and not quantity.control)):
        return ring(own, suffix)
    nested, twice = graded and quantity.place == "inside" and not _sum_of_powers(own.profile), suffix in CONSEQUENCES
    integrals = own.entries[suffix].definition.atoms(sp.Integral) if own.physics.definitions else ()
    summed, deep = (any(x.has(name) for x in integrals) for name in (PRESSURE, DEPTH))
    twice = twice or deep
    working = SUMMED if summed else min(own.digits, NESTED if nested else TWICE if twice else own.digits)
    drawn = own.drawn(suffix, 1 if nested or summed or twice else own.points)
    if twice:  # an extreme ratio costs more digits than two integrals have
        drawn = [point for point in drawn if not point.extreme]
    if deep:  # seconds each; that every case is a sum of what the normal contact has is certified
        drawn = drawn[:: -(-len(drawn) // DEEP)]
    rule, more = (_superposed, 20) if own.physics.definitions else (_adhesive if own.physics.tension else _pressed, 0)
    # next to the largest radius of a compact contact an inverse costs half as many digits as the gap has
    ill = quantity.symbol == nt.c
    more = ILL if ill else 0 if summed or twice else 20 if quantity.inverts or quantity.symbol == nt.a_c else more
    rows: Rows = []
    with mp.workdps(working + GUARD + (ILL if ill else 0)):
        for point in drawn:
            here = HalfSpace(own.profile, point.values, working + more, graded)
            rows.append((point.values, rule(here, own, suffix, here.at(nt.a), working)))
    extremes, lost = sum(point.extreme for point in drawn), NESTED_LOST if nested or summed or deep else LOST
    return own.judge(suffix, _compared(own, suffix), rows, extremes=extremes, digits=working, lost=lost)


def _of_load(own: Comparison, load: Load, suffix: str) -> Evidence:
    entry = own.entries[suffix]
    drawn = [point for case in entry.cases for point in points(load, case.chain, own.points, own.seed, (nt.E_star,))]
    rows: Rows = []
    with mp.workdps(own.digits + GUARD):
        for i, point in enumerate(drawn):
            values = point.values
            if nt.sigma in values:
                values[nt.sigma] = LOADED[i % len(LOADED)]
            s = number(sp.sympify(load.exponent).xreplace(values))
            got = evaluate(case_at(entry, values).expr, values, own.digits)
            rows.append((values, residual(got, under_load(values, s, own.digits))))
    compared, extremes = "mpmath quadrature of (11.104) and (11.105)", sum(point.extreme for point in drawn)
    return own.judge(suffix, compared, rows, extremes=extremes)


def _sum_of_powers(profile: Profile) -> bool:
    """Whether the rate of the depth is known from one integral for every power of the profile."""
    return len(profile.pieces) == 1 and all(
        term.as_independent(nt.r, as_Add=False)[1].as_base_exp()[0] == nt.r
        for term in sp.Add.make_args(sp.expand_power_base(profile.pieces[0].expr))
    )


def _compared(own: Comparison, suffix: str) -> str:
    """What stands against the entry."""
    quantity = own.entries[suffix].quantity
    if quantity.control:
        place = f"the radius at which the {quantity.control} by quadrature is stationary"
        return place if quantity.symbol == nt.a_c else f"{quantity.symbol} by quadrature at {place}"
    if own.physics is normal.PHYSICS and not own.graded(suffix):
        return DEFINED + (", round trip" if quantity.inverts else "")
    if quantity.symbol == nt.c:
        return "round trip: the stick radius whose tangential force is known by quadrature"
    if quantity.inverts:
        return f"round trip: {quantity.symbol} of the contact whose {quantity.inverts} is known by quadrature"
    return own.physics.compared


def _pressed(here: HalfSpace, own: Comparison, suffix: str, a: Number, digits: int) -> Number:
    values, entry = here.values, own.entries[suffix]
    radius, free_depth = here.contact(a)
    if not entry.quantity.inverts:
        got = formula_value(entry, values, digits) if here.graded else _value(entry, values, digits)
        return residual(got, here.normal(suffix, radius, free_depth))
    known = {**values, entry.quantity.arguments[0]: here.normal(entry.quantity.inverts, radius, free_depth)}
    symbol = entry.quantity.symbol
    wanted = radius if symbol == nt.a else here.normal(str(symbol), radius, free_depth)
    return residual(inverse(own.entries, suffix, known, digits), wanted)


def _value(entry: Entry, values: Values, digits: int) -> Number:
    """A closed result, or one that stays an integral, at a point."""
    case = case_at(entry, values)
    return evaluate_case(case, values, digits) if case.expr.has(sp.Integral) else evaluate(case.expr, values, digits)


def _adhesive(here: HalfSpace, own: Comparison, suffix: str, a: Number, digits: int) -> Number:
    entry, values = own.entries[suffix], here.values
    quantity = entry.quantity
    if here.profile.complete:  # the edge peels off where the free depth is short by the retraction
        defined = here.adhesive(str(quantity.symbol) if quantity.control else suffix, a)
        return residual(formula_value(entry, values, digits), defined)
    if quantity.control:
        stationary = {**values, nt.dgamma: here.separation(quantity.control, a), nt.a_c: a}
        if quantity.symbol == nt.a_c:
            return residual(_radius(entry, nt.a_c, stationary, digits), a)
        there = HalfSpace(here.profile, {**stationary, nt.a: a}, here.digits, here.graded)
        got = evaluate(case_at(entry, stationary).expr, stationary, digits)
        return residual(got, there.adhesive(str(quantity.symbol), a))
    if quantity.inverts:
        given = quantity.inverts
        stable = here.separation(own.entries[given].quantity.function, a) * STABLE
        values = {**values, nt.dgamma: min(number(values[nt.dgamma]), stable)}
        there = HalfSpace(here.profile, values, here.digits, here.graded)
        return residual(_radius(entry, nt.a, {**values, quantity.arguments[0]: there.adhesive(given, a)}, digits), a)
    return residual(formula_value(entry, values, digits), here.adhesive(suffix, a))


def _superposed(here: HalfSpace, own: Comparison, suffix: str, a: Number, digits: int) -> Number:
    """What superposes normal contacts, as its physics defines it."""
    entry, quantity = own.entries[suffix], own.entries[suffix].quantity
    assert own.physics.definitions is not None
    stated = own.physics.definitions(here.profile, here.medium)
    if not quantity.inverts:
        # an integral for the gap at the end of a zone is one for the displacement at that place
        place = {nt.r: here.values[own.physics.solved]} if own.physics.solved else {}
        return residual(formula_value(entry, {**place, **here.values}, digits), here.defined(stated[suffix]))
    given = own.entries[quantity.inverts].quantity.symbol
    known = {**here.values, given: here.defined(stated[quantity.inverts]), nt.F: here.force(a)}
    return residual(_radius(entry, quantity.symbol, known, digits), here.at(quantity.symbol))


def _radius(entry: Entry, unknown: sp.Symbol, known: Values, digits: int) -> Number:
    case, largest = case_at(entry, known), entry.profile.largest
    if entry.status == "closed":
        return evaluate(case.expr, {s: x for s, x in known.items() if s != unknown}, digits)
    return root(case, unknown, known, digits, largest if largest is None else largest.subs(nt.a, unknown))


# rings of zero and of greatest pressure

Search = Callable[[Shape, Number, int], tuple[Number, Number]]
DEFINED = "mpmath quadrature of the defining integral"
EXPONENTS = tuple(sp.Rational(x) for x in ("-3/10", "1/5", "1/2"))
POWERS = tuple(sp.Rational(x) for x in ("37/10", "9/5", "5/2"))
ELSEWHERE = (0.05, 0.3, 0.6, 0.9)


def ring(own: Comparison, suffix: str) -> Evidence:
    """Evidence for a ring or for what is known of it."""
    if own.graded(suffix):
        return _graded(own, suffix)
    peak = bool(own.entries[suffix].quantity.member)
    # a search asks for a hundred integrals, whose panels are doubles: none between an edge and a face just as large
    chain = own.profile.chain or (*own.profile.breaks, nt.a) if peak else (nt.a,)
    drawn = points(own.profile, chain, own.points, own.seed)
    cases = own.entries["rp" if peak else "rz"].cases
    known = [point for point in drawn if any(holds(case, point.values) for case in cases)]
    chosen = known[:2]
    if peak:
        known = [point for point in known if not point.extreme]
        # three, and one of each case
        found = [next((point for point in known if holds(case, point.values)), None) for case in cases]
        chosen = [point for point in known if point in known[:3] or point in found]
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
