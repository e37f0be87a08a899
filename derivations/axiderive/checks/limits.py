"""Limits of a profile to simpler ones: exactly where a formula is defined there, else at a tiny distance."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Entry
from ..oracle.evaluate import case_at, evaluate, evaluate_case, evaluated
from ..oracle.evidence import Evidence, judge, residual
from ..oracle.sampling import Values, fields, points
from ..oracle.shape import Number
from ..physics.normal import derive
from ..profiles import load
from ..profiles.profile import Limit, Profile
from .quadrature import LOST

INHERITED = (*FOUR, "pm")


def check_limits(profile: Profile, entries: Mapping[str, Entry], *, digits: int, seed: int) -> list[Evidence]:
    """Every limit that the profile names, for every quantity both profiles have."""
    checks = []
    for limit in profile.limits:
        target = load(limit.target)
        simpler = derive(target)
        checks += [
            check_limit(profile, entries[s], limit, target, simpler[s], digits=digits, seed=seed) for s in INHERITED
        ]
    return checks


def check_limit(
    profile: Profile, entry: Entry, limit: Limit, target: Profile, simpler: Entry, *, digits: int, seed: int
) -> Evidence:
    """A simpler profile as the limit, at a relative distance of 1e-(digits + 10) where the limit itself is excluded."""
    near = sp.Rational(1, 10 ** (digits + 10))
    vanishing = limit.value == 0
    case = next(c for c in entry.cases if not vanishing or c.chain[0] == limit.symbol)
    chain = tuple(x for x in case.chain if not (vanishing and x == limit.symbol))
    rows: list[tuple[Values, Number]] = []
    for point in points(profile, chain, 6, seed, fields(profile, entry)):
        if point.extreme:
            continue
        values = {**point.values, limit.symbol: point.values[chain[0]] * near if vanishing else sp.sympify(limit.value)}
        got = evaluate_case(case_at(entry, values), values, digits)
        with mp.workdps(2 * digits + 40):
            at_target = {**values, **_parameters(profile, limit, target, values)}
            wanted = evaluate(case_at(simpler, at_target).expr, at_target, digits)
        rows.append((values, residual(got, wanted)))
    identity = f"limit {limit.symbol} -> {limit.value}: {simpler.key}"
    return judge(entry.key, identity, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)


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
