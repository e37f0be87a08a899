"""Contact beyond the normal one on the homogeneous half-space, and prescribed pressure, against their definitions.

Roots and inverses are checked by round trip: the known side is the definition
at a chosen contact radius, the entry must lead back to it.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry, Quantity
from ..oracle.balls import NotAvailableError
from ..oracle.evaluate import case_at, evaluate, evaluate_case, evaluate_integral
from ..oracle.evidence import Evidence, judge, residual
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import GUARD, under_load
from ..oracle.sampling import Point, points
from ..oracle.shape import Number, Values, number, shape
from ..physics import Physics, adhesive, normal, tangential
from ..profiles.loads import Load
from ..profiles.profile import Profile
from . import graded_threshold, viscoelastic_quadrature
from .quadrature import LOST, inverse, root

Entries = Mapping[str, Entry]

EXPONENTS = tuple(sp.Rational(x) for x in ("-7/10", "-3/10", "1/5", "3/5", "1/2"))
"""Exponents of grading; every sixth point gets a random one."""
MANY = 6
"""Cases above which one point for each is enough."""
FIELDS = {
    normal.PHYSICS: (nt.H,),
    adhesive.PHYSICS: (nt.dgamma, nt.H),
    tangential.PHYSICS: (nt.mu, nt.G_star, nt.H, nt.H_x),
}
"""What is drawn of the material."""


def drawn_points(
    profile: Profile, entries: Entries, suffix: str, physics: Physics, count: int, seed: int
) -> list[Point]:
    """Points spread over the cases, those of an inverse over the cases of what it inverts."""
    source = entries[suffix]
    quantity, graded = source.quantity, nt.k in source.parameters
    if physics.tension and (quantity.inverts or quantity.control) and "d" in entries:
        source = entries["d"]
    elif quantity.inverts:
        source = entries[quantity.inverts]
    elif suffix in ("k", "pm", "Dl") and "d" in entries:
        source = entries["d"]
    fields = (*source.quantity.arguments, *FIELDS[physics], *profile.free_depth)
    # an unevaluated integral next to a border takes long; the closed formulas get the extreme points
    tame = graded and (quantity.place == "inside" or any(case.expr.has(sp.Integral) for case in entries[suffix].cases))
    many = len(source.cases) > MANY
    each = max(1 if tame or many else 2, -(-count // len(source.cases)))
    out: list[Point] = []
    chains = [case.chain for case in source.cases]
    if tame and suffix == "tau":  # seconds each; that every case is a difference of two pressures is shown symbolically
        chains = chains[:: -(-len(chains) // MANY)]
    for chain in chains:
        candidates = (_point(profile, chain, i, len(out), seed, fields, graded, tame) for i in itertools.count())
        growing = profile.compact and quantity.control
        kept = (p for p in candidates if not growing or _grows(profile, p.values, graded))
        for _ in range(each):
            out.append(next(kept))
    return out


def _grows(profile: Profile, values: Values, graded: bool) -> bool:
    """Whether the depth grows with the contact: the largest radius that a profile names is that for k = 0."""
    with mp.workdps(20):
        return bool(HalfSpace(profile, values, 10, graded).rates(number(values[nt.a]))[0] > 0)


def _point(
    profile: Profile, chain: tuple[sp.Expr, ...], i: int, index: int, seed: int, fields: tuple[sp.Symbol, ...],
    graded: bool, tame: bool,
) -> Point:  # fmt: skip
    """The i-th point of a case; on the graded half-space the exponent comes first, because chains may contain it."""
    exponents = {nt.k: _exponent(index, profile.name, seed)} if graded else {}
    chain = tuple(length.subs(exponents) for length in chain)
    drawn = [p for p in points(profile, chain, i + 1 + (12 if tame else 0), seed, fields) if not (tame and p.extreme)]
    values = {**drawn[i].values, **exponents}
    if nt.dgamma in fields and nt.n in values and 2 * values[nt.n] + values.get(nt.k, 0) == 1:
        values[nt.n] = sp.Rational(37, 10)  # g and Dl are the same power of a: nothing is stationary
    return Point(values, drawn[i].extreme)


def _exponent(index: int, name: str, seed: int) -> sp.Rational:
    shift = random.Random(f"{seed} {name}").randrange(len(EXPONENTS))
    random_one = sp.Rational(random.Random(f"{seed} {name} {index}").randint(-89, 89), 100)
    return (*EXPONENTS, random_one)[(index + shift) % (len(EXPONENTS) + 1)]


NESTED = 46
"""Digits of a pressure on the graded half-space, which is an integral of integrals."""
NESTED_LOST = 6
STABLE = mp.mpf(9) / 10
"""Greatest share of the work of separation that a contact of radius a can carry: an inverse is the stable branch."""
ILL = 60
"""Digits carried beyond those asked for where a small stick zone is the root of a difference of two forces."""


def check_profile(
    profile: Profile, entries: Entries, physics: Physics, *, digits: int = 50, points: int = 4, seed: int = 0
) -> dict[str, Evidence]:
    """The evidence for every entry of a profile, keyed by suffix."""
    return {
        suffix: check(profile, entries, suffix, physics, digits=digits, points=points, seed=seed) for suffix in entries
    }


def check(
    profile: Profile,
    entries: Entries,
    suffix: str,
    physics: Physics,
    *,
    digits: int = 50,
    points: int = 4,
    seed: int = 0,
) -> Evidence:
    """Compare one entry with its definition."""
    if isinstance(profile, Load):
        return _of_load(profile, entries, suffix, digits, points, seed)
    if physics.laws:
        return viscoelastic_quadrature.check(profile, entries, suffix, points=points, seed=seed)
    entry = entries[suffix]
    graded = nt.k in entry.parameters
    if graded and entry.quantity.threshold:
        return graded_threshold.check(profile, entries, suffix, seed=seed)
    nested = graded and entry.quantity.place == "inside" and not _sum_of_powers(profile)
    working = min(digits, NESTED) if nested else digits
    drawn = drawn_points(profile, entries, suffix, physics, 1 if nested else points, seed)
    with mp.workdps(working + GUARD + (ILL if suffix == "c" else 0)):
        rows: list[tuple[Values, Number]] = [
            (point.values, _residual(profile, entries, suffix, physics, point.values, working, graded))
            for point in drawn
        ]
    return judge(
        entry.key,
        _compared(entry.quantity, physics),
        rows,
        seed=seed,
        extremes=sum(point.extreme for point in drawn),
        digits=working,
        required=working - (NESTED_LOST if nested else LOST),
    )


LOADED = tuple(sp.Rational(x) for x in ("-9/10", "-3/5", "-1/4", "3/10", "1", "27/10"))


def _of_load(load: Load, entries: Entries, suffix: str, digits: int, count: int, seed: int) -> Evidence:
    entry = entries[suffix]
    drawn = [point for case in entry.cases for point in points(load, case.chain, count, seed, (nt.E_star,))]
    rows: list[tuple[Values, Number]] = []
    with mp.workdps(digits + GUARD):
        for i, point in enumerate(drawn):
            values = point.values
            if nt.sigma in values:
                values[nt.sigma] = LOADED[i % len(LOADED)]
            s = number(sp.sympify(load.exponent).xreplace(values))
            got = evaluate(case_at(entry, values).expr, values, digits)
            rows.append((values, residual(got, under_load(values, s, digits))))
    return judge(
        entry.key,
        "mpmath quadrature of (11.104) and (11.105)",
        rows,
        seed=seed,
        extremes=sum(point.extreme for point in drawn),
        digits=digits,
        required=digits - LOST,
    )


def _sum_of_powers(profile: Profile) -> bool:
    """Whether the rate of the depth is known from one integral for every power of the profile."""
    return len(profile.pieces) == 1 and all(
        term.as_independent(nt.r, as_Add=False)[1].as_base_exp()[0] == nt.r
        for term in sp.Add.make_args(sp.expand_power_base(profile.pieces[0].expr))
    )


def _compared(quantity: Quantity, physics: Physics) -> str:
    """What stands against the entry."""
    if quantity.control:
        place = f"the radius at which the {quantity.control} by quadrature is stationary"
        return place if quantity.symbol == nt.a_c else f"{quantity.symbol} by quadrature at {place}"
    if quantity.symbol == nt.c:
        return "round trip: the stick radius whose tangential force is known by quadrature"
    if quantity.inverts:
        return f"round trip: {quantity.symbol} of the contact whose {quantity.inverts} is known by quadrature"
    return COMPARED[physics][0]


def _residual(
    profile: Profile, entries: Entries, suffix: str, physics: Physics, values: Values, digits: int, graded: bool
) -> Number:
    quantity = entries[suffix].quantity
    _, rule, more = COMPARED[physics]
    extra = ILL if suffix == "c" else 20 if quantity.inverts or quantity.symbol == nt.a_c else more
    here = HalfSpace(profile, values, digits + extra, graded)
    return rule(here, entries, suffix, number(values[nt.a]), digits)


def _pressed(here: HalfSpace, entries: Entries, suffix: str, a: Number, digits: int) -> Number:
    values, quantity = here.values, entries[suffix].quantity
    radius, free_depth = here.contact(a)
    if not quantity.inverts:
        return residual(formula_value(entries[suffix], values, digits), here.normal(suffix, radius, free_depth))
    known = {**values, quantity.arguments[0]: here.normal(quantity.inverts, radius, free_depth)}
    wanted = radius if quantity.symbol == nt.a else here.normal(str(quantity.symbol), radius, free_depth)
    return residual(inverse(entries, suffix, known, digits), wanted)


def formula_value(entry: Entry, values: Values, digits: int) -> Number:
    """A formula of the catalogue at a point; an enclosure where Arb has all its functions, which is faster."""
    case = case_at(entry, values)
    if case.expr.has(sp.Integral):
        stretches = shape(entry.profile, values).stretches
        radii = {z for piece in stretches for z in piece.singular} | {complex(piece.hi) for piece in stretches[:-1]}
        ordered = tuple(sorted(radii | {0j}, key=lambda z: (abs(z), z.imag)))
        return evaluate_integral(case.expr, values, digits, ordered)
    try:
        return evaluate_case(case, values, digits)
    except NotAvailableError:
        return evaluate(case.expr, values, digits)


def _adhesive(here: HalfSpace, entries: Entries, suffix: str, a: Number, digits: int) -> Number:
    entry, values = entries[suffix], here.values
    if here.profile.complete:  # the edge peels off where the free depth is short by the retraction
        defined = here.adhesive(str(entry.quantity.symbol) if entry.quantity.control else suffix, a)
        return residual(formula_value(entry, values, digits), defined)
    quantity = entry.quantity
    if quantity.control:
        stationary = {**values, nt.dgamma: here.separation(quantity.control, a), nt.a_c: a}
        if quantity.symbol == nt.a_c:
            found = _radius(entry, nt.a_c, stationary, digits)
            return residual(found, a)
        there = HalfSpace(here.profile, {**stationary, nt.a: a}, here.digits, here.graded)
        return residual(
            evaluate(case_at(entry, stationary).expr, stationary, digits), there.adhesive(str(quantity.symbol), a)
        )
    if quantity.inverts:
        given = quantity.inverts
        stable = here.separation(entries[given].quantity.function, a) * STABLE
        values = {**values, nt.dgamma: min(number(values[nt.dgamma]), stable)}
        there = HalfSpace(here.profile, values, here.digits, here.graded)
        return residual(_radius(entry, nt.a, {**values, quantity.arguments[0]: there.adhesive(given, a)}, digits), a)
    return residual(formula_value(entry, values, digits), here.adhesive(suffix, a))


def _slipping(here: HalfSpace, entries: Entries, suffix: str, a: Number, digits: int) -> Number:
    entry = entries[suffix]
    if suffix != "c":
        return residual(formula_value(entry, here.values, digits), here.tangential(suffix, a))
    known = {**here.values, nt.F_x: here.tangential("F", a), nt.F: here.force(a)}
    return residual(_radius(entry, nt.c, known, digits), here.at(nt.c))


def _radius(entry: Entry, unknown: sp.Symbol, known: Values, digits: int) -> Number:
    case = case_at(entry, known)
    if entry.status == "closed":
        return evaluate(case.expr, {s: x for s, x in known.items() if s != unknown}, digits)
    largest = entry.profile.largest
    beyond = () if largest is None else (largest.subs(nt.a, unknown),)
    return root(Case(case.chain, case.expr), unknown, known, digits, beyond)


COMPARED: dict[Physics, tuple[str, Callable[[HalfSpace, Entries, str, Number, int], Number], int]] = {
    normal.PHYSICS: ("mpmath quadrature of the definition", _pressed, 0),
    adhesive.PHYSICS: ("mpmath quadrature of the contact that is short of its depth by Dl, (11.63)", _adhesive, 0),
    tangential.PHYSICS: (
        "mu times the difference of two normal contacts by mpmath quadrature, (11.78) to (11.80)", _slipping, 20,
    ),
}  # fmt: skip
"""What stands against an entry, the relative difference from it, and the digits that this takes more."""
