"""Identities that tie the entries of a contact together, and its limits.

Limits of a profile to simpler ones, and of the graded half-space to the homogeneous one: exactly where a formula is
defined there, else at a tiny distance; integrals by their values.

No identity uses how an entry was derived.  Each returns one piece of evidence, under the key of the entry it tests.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import C0
from ..entry import FOUR, Case, Entry
from ..oracle.balls import NotAvailableError, enclose_value
from ..oracle.evaluate import case_at, decades, evaluate, evaluate_case, evaluated, holds
from ..oracle.integrals import GUARD
from ..oracle.rules import integrate
from ..oracle.sampling import border, fields, points
from ..oracle.shape import Number, Values, shape
from ..physics.normal import derive
from ..profiles import load
from ..profiles.profile import Limit, Profile
from ..proof.algebra.domain import NotProvedError
from ..proof.rules.compact import Compact
from ..proof.rules.complete import Complete
from ..proof.rules.graded import homogeneous_limit
from .comparison import Comparison, Entries, Evidence, Rows, formula_value, not_available, residual

EACH = 2
"""Points per case."""
EXTREME_PLANS = 8
"""Points with extreme ratios that a chain of up to four lengths starts with; they are passed over here."""
COMMON = (*FOUR, "pm")
"""Quantities whose cases are compared with each other, and with those of a simpler profile."""
FEW = 2
"""Cases in which an integral is compared."""
CANDIDATES = 12
EXPONENTS = (sp.Rational(-1, 10), sp.Rational(2, 5))
"""Exponents of grading at which pressures are summed; at k = -3/10 what is left out at the edge costs 12 digits."""


def check_profile(own: Comparison) -> list[Evidence]:
    """Every identity that applies to normal contact on the homogeneous half-space."""
    checks = [stiffness(own), force_of_pressure(own), edge(own)]
    if "d" in own.entries:
        checks.append(profile_from_depth(own))
    several = [s for s in COMMON if s in own.entries and len(own.entries[s].cases) > 1]
    return checks + [continuity(own, suffix) for suffix in several] + simpler(own)


def _at_cases(own: Comparison, suffix: str, each: int = EACH) -> list[Values]:
    """Random points in every case."""
    entry = own.entries[suffix]
    drawn = (own.tame(case.chain, each + EXTREME_PLANS, fields(own.profile, entry))[:each] for case in entry.cases)
    return [*itertools.chain.from_iterable(drawn)]


def stiffness(own: Comparison) -> Evidence:
    """dF/dd: the formulas of F and d differentiated by a, or F by d where d is free."""
    graded, digits = own.graded("F"), own.digits
    places = [p.values for p in own.drawn("F", 1) if not p.extreme] if graded else _at_cases(own, "F")
    rows: Rows = []
    for values in places:
        slope = sp.diff(case_at(own.entries["F"], values).expr, nt.d if own.profile.complete else nt.a)
        if own.profile.compact:
            slope /= sp.diff(case_at(own.entries["d"], values).expr, nt.a)
        with mp.workdps(digits + GUARD):
            wanted = evaluate(case_at(own.entries["k"], values).expr, values, digits)
            got = _value(slope, values, digits) if graded else evaluate(slope, values, digits)
            rows.append((values, residual(got, wanted)))
    return own.judge("k", f"dF/dd{'' if graded else ' = 2 E* a'}, by differentiating F and d", rows)


def edge(own: Comparison) -> Evidence:
    """w(a) = d - f(a) from outside: the relative distance 1e-(2 digits + 10) leaves a difference of its square root."""
    digits, entry = own.digits, own.entries["w"]
    gap = sp.Rational(1, 10 ** (2 * digits + 10))
    rows: Rows = []
    for case in entry.cases:
        position = case.chain.index(nt.r) - 1
        if position != next(i for i, x in enumerate(case.chain) if x == nt.a or x.has(nt.d)):
            continue
        values = border(own.profile, case.chain, position, gap, own.seed, fields(own.profile, entry))
        with mp.workdps(2 * digits):
            if nt.d in values:
                depth = evaluated(nt.d, values)
            else:
                depth = evaluate(case_at(own.entries["d"], values).expr, values, digits)
            wanted = depth - shape(own.profile, values).height(evaluated(case.chain[position], values))
            rows.append((values, residual(evaluate_case(case, values, digits), wanted)))
    return own.judge("w", "w(a) = d - f(a)", rows)


def profile_from_depth(own: Comparison) -> Evidence:
    """(11.28): f(a) = 2/pi int g(a sin(u)) du gives the profile back."""
    rows: Rows = []
    for values in _at_cases(own, "d", each=1):
        with mp.workdps(2 * own.digits + GUARD):  # 1 - x**2/2 next to the edge keeps half of the digits of x
            a = evaluated(nt.a, values)

            def depth(t: Number, case: Case | None, at: Values = values) -> Number:
                return evaluated(case.expr, {**at, nt.a: t}) if case else mp.mpf(0)

            total = over_contact(own.entries["d"], values, depth, own.digits)
            rows.append((values, residual(2 * total / mp.pi, shape(own.profile, values).height(a))))
    return own.judge("d", "f recovered from g by (11.28)", rows)


def force_of_pressure(own: Comparison) -> Evidence:
    """F = 2 pi int p r dr, with r = a sin(u), which removes the singular edge."""
    identity, force, entry = "F = 2 pi int p r dr", own.entries["F"], own.entries["p"]
    if entry.status == "integral":
        return not_available(force.key, identity, "the pressure is itself an integral, too slow to integrate again")
    rows: Rows = []
    for case in force.cases:
        drawn = points(own.profile, case.chain, EXTREME_PLANS + EACH, own.seed, fields(own.profile, entry))
        values = min((point.values for point in drawn), key=decades)
        rows.append((values, carried(case, entry, values, own.digits)))
    return own.judge("F", identity, rows)


def traction_carried(own: Comparison) -> Evidence:
    """F_x = 2 pi int tau r dr."""
    drawn = (point.values for point in own.drawn("F", 1))
    return _summed(own, "tau", "traction", [min(drawn, key=decades)])


def pressure_carried(own: Comparison) -> Evidence:
    """F = 2 pi int p r dr on the graded half-space, in every case of the force.

    Without a free edge, and under adhesion, the pressure grows towards the edge like (a - r)**((k - 1)/2).
    """
    drawn = (point.values for point in own.drawn("F", 1) if not point.extreme)
    each = {case_at(own.entries["F"], values).chain: values for values in drawn}
    exponents = EXPONENTS if len(each) == 1 else EXPONENTS[:1]
    return _summed(own, "p", "pressure", [{**v, nt.k: exponent} for v in each.values() for exponent in exponents])


def _summed(own: Comparison, suffix: str, name: str, places: Sequence[Values]) -> Evidence:
    compared, force, entry = f"2 pi int {suffix} r dr", own.entries["F"], own.entries[suffix]
    if entry.status == "integral" or any(case.expr.has(C0) for case in entry.cases):
        reason = f"the {name} is itself an integral, too slow to integrate again"
        return not_available(force.key, compared, reason)
    return own.judge(
        "F", compared, [(values, carried(case_at(force, values), entry, values, own.digits)) for values in places]
    )


def carried(whole: Case, entry: Entry, values: Values, digits: int) -> Number:
    """Residual of 2 pi int p r dr, or tau for p, against the force in a region."""
    with mp.workdps(2 * digits + GUARD):
        edge = evaluated(next((x for x in whole.chain if x == nt.a or x.has(nt.d)), nt.a), values)

        def summand(r: Number, region: Case | None) -> Number:
            if region is None:
                return mp.mpf(0)
            return _value(region.expr, {**values, nt.r: r}, digits + 5) * r * mp.sqrt((edge - r) * (edge + r))

        total = over_contact(entry, values, summand, digits, edge, nt.r)
        return residual(2 * mp.pi * total, evaluate(whole.expr, values, digits))


def _value(expr: sp.Expr, values: Values, digits: int) -> Number:
    try:
        return enclose_value(expr, values, digits)
    except NotAvailableError:
        return evaluate(expr, values, digits)


def over_contact(
    entry: Entry,
    values: Values,
    integrand: Callable[[Number, Case | None], Number],
    digits: int,
    edge: Number | None = None,
    variable: sp.Symbol = nt.a,
) -> Number:
    """int_0^(pi/2) integrand(edge sin(u), case there) du, split where the case changes; such ends may be singular."""
    end = edge if edge is not None else evaluated(nt.a, values)
    face = shape(entry.profile, values)
    lengths = {evaluated(x, values) for case in entry.cases for x in case.chain if not x.has(variable)}
    ends = [mp.mpf(0), *(mp.asin(s / end) for s in sorted(lengths) if s < end), mp.pi / 2]
    extra = [mp.mpmathify(z) for piece in face.stretches for z in piece.singular if not _among(z, lengths)]
    angles = [mp.asin(z / end) for z in (*lengths, *extra)]
    singular = [*angles, *(-z for z in angles), *(mp.pi - z for z in angles), *ends, -mp.pi / 2]
    longest = min(6 * piece.wavelength for piece in face.stretches) / float(end)
    negligible, total = mp.mpf(10) ** (-digits - 15), mp.mpf(0)
    for lo, hi in itertools.pairwise(ends):
        middle = (lo + hi) / 2
        at = {**values, variable: end * mp.sin(middle)}
        case = next((c for c in entry.cases if holds(c, at)), None)
        for origin, start, stop in ((lo, mp.mpf(0), middle - lo), (hi, middle - hi, mp.mpf(0))):

            def f(x: Number, origin: Number = origin, region: Case | None = case) -> Number:
                # at worst a logarithm: what lies this near to an end is below the digits wanted
                return integrand(end * mp.sin(origin + x), region) if abs(x) > negligible else mp.mpf(0)

            nearby = (0j, *(complex(z - origin) for z in singular if abs(z - origin) > mp.eps ** mp.mpf("0.6")))
            total += integrate(f, start, stop, nearby, digits, longest=longest)
    return total


def _among(z: complex, lengths: set[Number]) -> bool:
    """Whether a singular point of the profile, known as a float, is a length of the chains or its mirror image."""
    return any(abs(z - sign * complex(s)) < 1e-12 * abs(z) for s in lengths for sign in (1, -1))


def continuity(own: Comparison, suffix: str) -> Evidence:
    """Cases that differ by the order of two neighbours meet where these are equal."""
    entry, digits, compared = own.entries[suffix], own.digits, "continuity between the cases"
    gap = sp.Rational(1, 10 ** (2 * digits + 10))
    if any(integral.limits[0][1] != 0 for case in entry.cases for integral in case.expr.atoms(sp.Integral)):
        return not_available(entry.key, compared, "an integral from a break on is too slow so near to the break")
    rows: Rows = []
    for left, right in itertools.combinations(entry.cases, 2):
        differing = [i for i, (x, y) in enumerate(zip(left.chain, right.chain, strict=True)) if x != y]
        if len(differing) != 2 or differing[1] != differing[0] + 1 or left.expr == right.expr:
            continue
        values = border(own.profile, left.chain, differing[0], gap, own.seed, fields(own.profile, entry))
        swapped = _exchanged(left.chain[differing[0]], left.chain[differing[1]], values)
        here, there = (evaluate_case(case, at, digits) for case, at in ((left, values), (right, swapped)))
        rows.append((values, residual(here, there)))
    if not rows:
        return not_available(entry.key, compared, "no pair of cases that a formula of its own tells apart")
    return own.judge(suffix, compared, rows)


def _exchanged(lo: sp.Expr, hi: sp.Expr, values: Values) -> Values:
    """The point on the other side: the symbol of the pair moved across."""
    symbol, other, ratio = (lo, hi, 1) if lo.is_Symbol else (hi, lo, -1)
    with mp.workdps(400):
        low, high = evaluated(lo, values), evaluated(hi, values)
        moved = high * (high / low) if ratio == 1 else low * (low / high)
    return {**values, symbol: moved}


def simpler(own: Comparison) -> list[Evidence]:
    """Every limit that the profile names, for every quantity both profiles have."""
    checks = []
    for limit in own.profile.limits:
        target = load(limit.target)
        entries = derive(target)
        checks += [to_limit(own, suffix, limit, target, entries[suffix]) for suffix in COMMON]
    return checks


def to_limit(own: Comparison, suffix: str, limit: Limit, target: Profile, simple: Entry) -> Evidence:
    """A simpler profile as the limit, at a relative distance of 1e-(digits + 10) where the limit itself is excluded."""
    entry, digits, vanishing = own.entries[suffix], own.digits, limit.value == 0
    near = sp.Rational(1, 10 ** (digits + 10))
    case = next(c for c in entry.cases if not vanishing or c.chain[0] == limit.symbol)
    chain = tuple(x for x in case.chain if not (vanishing and x == limit.symbol))
    rows: Rows = []
    for drawn in own.tame(chain, 6, fields(own.profile, entry)):
        values = {**drawn, limit.symbol: drawn[chain[0]] * near if vanishing else sp.sympify(limit.value)}
        got = evaluate_case(case_at(entry, values), values, digits)
        with mp.workdps(2 * digits + 40):
            at_target = {**values, **_parameters(own.profile, limit, target, values)}
            wanted = evaluate(case_at(simple, at_target).expr, at_target, digits)
        rows.append((values, residual(got, wanted)))
    return own.judge(suffix, f"limit {limit.symbol} -> {limit.value}: {simple.key}", rows)


def _parameters(profile: Profile, limit: Limit, target: Profile, values: Values) -> Values:
    """The target's own parameters, from the coefficient that both shapes must share."""
    own = [s for s in target.parameters if s not in profile.parameters]
    if not own:
        return {}
    reached = profile.pieces[-1].expr.subs(limit.symbol, limit.value)
    size = sp.Dummy("size", positive=True)
    (coefficient,) = (sp.cancel(reached / reached.subs(nt.r, 1)),)
    ratio = target.pieces[-1].expr / coefficient
    solved = min(sp.solve(ratio - size, own[0]), key=sp.count_ops)
    return {own[0]: evaluated(solved, {size: evaluated(reached.subs(nt.r, 1), values)})}


def homogeneous(own: Comparison, plain: Entries, below: Compact | Complete) -> list[Evidence]:
    """Every entry that both half-spaces have, at k = 0; `below` states the normal contact on the homogeneous one.

    A formula at k = 0 and an equation at k = 0 are compared symbol by symbol, an integral by its value there.
    """
    found = []
    for suffix, entry in own.entries.items():
        if suffix not in plain:
            continue
        statuses = {entry.status, plain[suffix].status}
        if "integral" in statuses:
            found.append(_at_zero(own, plain[suffix], suffix))
        elif len(statuses) == 1:
            found.append(_exact(own, plain, suffix, below))
        else:
            reason = "an equation here and its solution there; what they invert is compared"
            found.append(not_available(entry.key, f"k = 0: {plain[suffix].key}", reason))
    return found


def _exact(own: Comparison, plain: Entries, suffix: str, below: Compact | Complete) -> Evidence:
    key, compared = own.entries[suffix].key, f"k = 0: {plain[suffix].key}, symbolically"
    try:
        steps = homogeneous_limit(suffix, dict(own.entries), dict(plain), below)
    except NotProvedError as error:
        return Evidence(key, compared, "failed", reason=str(error))
    return Evidence(key, compared, "passed", count=len(steps))


def _at_zero(own: Comparison, plain: Entry, suffix: str) -> Evidence:
    """At one point of each of the first cases that are integrals."""
    entry = own.entries[suffix]
    drawn = (point.values for point in own.drawn(suffix, CANDIDATES))
    # next to a border an integral takes a minute
    places = {case_at(entry, values): values for values in sorted(drawn, key=decades, reverse=True)}
    integrals = [values for case, values in places.items() if case.expr.has(sp.Integral)]
    rows: Rows = []
    for at in (integrals or list(places.values()))[:FEW]:
        values = {**at, nt.E_star: at[nt.H], nt.k: sp.S.Zero}
        if nt.H_x in values:
            values[nt.G_star] = values[nt.H_x]
        with mp.workdps(own.digits + GUARD):
            pair: list[Number] = [formula_value(x, values, own.digits) for x in (entry, plain)]
            rows.append((values, residual(*pair)))
    return own.judge(suffix, f"k = 0: {plain.key}", rows)
