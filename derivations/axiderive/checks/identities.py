"""Identities that tie the entries of a profile together, or a profile to a simpler one.

None of them uses how an entry was derived.  `check_profile` returns one
piece of evidence per identity, under the key of the entry it tests.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Case, Entry
from ..oracle.balls import NotAvailableError, enclose_value
from ..oracle.evaluate import case_at, decades, evaluate, evaluate_case, evaluated, holds
from ..oracle.evidence import Evidence, judge, not_available, residual
from ..oracle.integrals import GUARD
from ..oracle.rules import integrate
from ..oracle.sampling import Values, border, fields, points
from ..oracle.shape import Number, shape
from ..profiles.profile import Profile
from .limits import check_limits
from .quadrature import LOST

Entries = Mapping[str, Entry]
Rows = list[tuple[Values, Number]]
EACH = 2
"""Points per case."""
EXTREME_PLANS = 8
"""Points with extreme ratios that a chain of up to four lengths starts with; they are passed over here."""
CONTINUOUS = (*FOUR, "pm")


def check_profile(
    profile: Profile, entries: Entries, *, digits: int = 50, points: int = 8, seed: int = 0
) -> list[Evidence]:
    """Every identity that applies to the profile; `points` bounds the points of each."""
    checks = [
        check_stiffness(profile, entries, digits=digits, seed=seed),
        check_force_of_pressure(profile, entries, digits=digits, seed=seed),
        check_edge(profile, entries, digits=digits, seed=seed),
    ]
    if "d" in entries:
        checks.append(check_profile_from_depth(profile, entries, digits=digits, seed=seed))
    for suffix in CONTINUOUS:
        if suffix in entries and len(entries[suffix].cases) > 1:
            checks.append(check_continuity(profile, entries[suffix], digits=digits, seed=seed))
    checks += check_limits(profile, entries, digits=digits, seed=seed)
    return checks


def _judge(entry: Entry, identity: str, rows: Rows, digits: int, seed: int) -> Evidence:
    if not rows:
        return not_available(entry.key, identity, "no pair of cases that a formula of its own tells apart")
    return judge(entry.key, identity, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)


def _at_cases(profile: Profile, entry: Entry, seed: int, each: int = EACH) -> list[Values]:
    """Random points in every case."""
    found: list[Values] = []
    for case in entry.cases:
        drawn = points(profile, case.chain, each + EXTREME_PLANS, seed, fields(profile, entry))
        found += [point.values for point in drawn if not point.extreme][:each]
    return found


def _from_a_break(entry: Entry) -> bool:
    return any(integral.limits[0][1] != 0 for case in entry.cases for integral in case.expr.atoms(sp.Integral))


def check_stiffness(profile: Profile, entries: Entries, *, digits: int, seed: int) -> Evidence:
    """dF/dd = 2 E* a: the formulas of F and d differentiated by a, or F by d where d is free."""
    free = profile.complete
    rows: Rows = []
    for values in _at_cases(profile, entries["F"], seed):
        force = case_at(entries["F"], values).expr
        if free:
            slope = sp.diff(force, nt.d)
        else:
            slope = sp.diff(force, nt.a) / sp.diff(case_at(entries["d"], values).expr, nt.a)
        wanted = evaluate(case_at(entries["k"], values).expr, values, digits)
        rows.append((values, residual(evaluate(slope, values, digits), wanted)))
    return _judge(entries["k"], "dF/dd = 2 E* a, by differentiating F and d", rows, digits, seed)


def check_edge(profile: Profile, entries: Entries, *, digits: int, seed: int) -> Evidence:
    """w(a) = d - f(a) from outside: the relative distance 1e-(2 digits + 10) leaves a difference of its square root."""
    gap = sp.Rational(1, 10 ** (2 * digits + 10))
    entry = entries["w"]
    rows: Rows = []
    for case in entry.cases:
        edge_of_contact = next(i for i, x in enumerate(case.chain) if x == nt.a or x.has(nt.d))
        position = case.chain.index(nt.r) - 1
        if position != edge_of_contact:
            continue
        inner = case.chain[position]
        values = border(profile, case.chain, position, gap, seed, fields(profile, entry))
        with mp.workdps(2 * digits):
            edge = evaluated(inner, values)
            depth = (
                evaluated(nt.d, values)
                if nt.d in values
                else evaluate(case_at(entries["d"], values).expr, values, digits)
            )
            wanted = depth - shape(profile, values).height(edge)
            rows.append((values, residual(evaluate_case(case, values, digits), wanted)))
    return _judge(entry, "w(a) = d - f(a)", rows, digits, seed)


def check_profile_from_depth(profile: Profile, entries: Entries, *, digits: int, seed: int) -> Evidence:
    """(11.28): f(a) = 2/pi int g(a sin(u)) du gives the profile back."""
    rows: Rows = []
    for values in _at_cases(profile, entries["d"], seed, each=1):
        with mp.workdps(2 * digits + GUARD):  # 1 - x**2/2 next to the edge keeps half of the digits of x
            a = evaluated(nt.a, values)

            def depth(t: Number, case: Case | None, at: Values = values) -> Number:
                return evaluated(case.expr, {**at, nt.a: t}) if case else mp.mpf(0)

            total = over_contact(entries["d"], values, depth, digits)
            rows.append((values, residual(2 * total / mp.pi, shape(profile, values).height(a))))
    return _judge(entries["d"], "f recovered from g by (11.28)", rows, digits, seed)


def check_force_of_pressure(profile: Profile, entries: Entries, *, digits: int, seed: int) -> Evidence:
    """F = 2 pi int p r dr, with r = a sin(u), which removes the singular edge."""
    identity, entry = "F = 2 pi int p r dr", entries["p"]
    if entry.status == "integral":
        return not_available(
            entries["F"].key, identity, "the pressure is itself an integral, too slow to integrate again"
        )
    rows: Rows = []
    for case in entries["F"].cases:
        drawn = points(profile, case.chain, EXTREME_PLANS + EACH, seed, fields(profile, entry))
        values = min((point.values for point in drawn), key=decades)
        rows.append((values, carried(case, entry, values, digits)))
    return _judge(entries["F"], identity, rows, digits, seed)


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


def check_continuity(profile: Profile, entry: Entry, *, digits: int, seed: int) -> Evidence:
    """Cases that differ by the order of two neighbours meet where these are equal."""
    gap = sp.Rational(1, 10 ** (2 * digits + 10))
    rows: Rows = []
    if _from_a_break(entry):
        reason = "an integral from a break on is too slow so near to the break"
        return not_available(entry.key, "continuity between the cases", reason)
    for left, right in itertools.combinations(entry.cases, 2):
        differing = [i for i, (x, y) in enumerate(zip(left.chain, right.chain, strict=True)) if x != y]
        if len(differing) != 2 or differing[1] != differing[0] + 1 or left.expr == right.expr:
            continue
        values = border(profile, left.chain, differing[0], gap, seed, fields(profile, entry))
        swapped = _exchanged(left.chain[differing[0]], left.chain[differing[1]], values)
        here, there = (evaluate_case(case, at, digits) for case, at in ((left, values), (right, swapped)))
        rows.append((values, residual(here, there)))
    return _judge(entry, "continuity between the cases", rows, digits, seed)


def _exchanged(lo: sp.Expr, hi: sp.Expr, values: Values) -> Values:
    """The point on the other side: the symbol of the pair moved across."""
    symbol, other, ratio = (lo, hi, 1) if lo.is_Symbol else (hi, lo, -1)
    with mp.workdps(400):
        low, high = evaluated(lo, values), evaluated(hi, values)
        moved = high * (high / low) if ratio == 1 else low * (low / high)
    return {**values, symbol: moved}
