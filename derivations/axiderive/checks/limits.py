"""Limits of a profile to simpler ones, and of the graded half-space to the homogeneous one.

Exactly where a formula is defined there, else at a tiny distance; integrals by their values.
"""

from __future__ import annotations

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Entry
from ..oracle.evaluate import case_at, decades, evaluate, evaluate_case, evaluated
from ..oracle.integrals import GUARD
from ..oracle.sampling import fields
from ..oracle.shape import Number, Values
from ..physics.normal import derive
from ..profiles import load
from ..profiles.profile import Limit, Profile
from ..proof.algebra.domain import NotProvedError
from ..proof.rules.compact import Compact
from ..proof.rules.complete import Complete
from ..proof.rules.graded import homogeneous_limit
from .comparison import Comparison, Entries, Evidence, Rows, formula_value, not_available, residual

INHERITED = (*FOUR, "pm")
FEW = 2
"""Cases in which an integral is compared."""
CANDIDATES = 12


def simpler(own: Comparison) -> list[Evidence]:
    """Every limit that the profile names, for every quantity both profiles have."""
    checks = []
    for limit in own.profile.limits:
        target = load(limit.target)
        entries = derive(target)
        checks += [to_limit(own, suffix, limit, target, entries[suffix]) for suffix in INHERITED]
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
