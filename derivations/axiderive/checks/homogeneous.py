"""The graded half-space at k = 0: the formulas of the homogeneous one, or their values."""

from __future__ import annotations

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..oracle.evaluate import case_at, decades
from ..oracle.evidence import Evidence, judge, not_available, residual
from ..oracle.integrals import GUARD
from ..oracle.shape import Number, Values
from ..physics import Physics
from ..profiles.profile import Profile
from ..proof.algebra.domain import NotProvedError
from ..proof.rules.compact import Compact
from ..proof.rules.complete import Complete
from ..proof.rules.graded import homogeneous_limit
from .physics_quadrature import Entries, drawn_points, formula_value
from .quadrature import LOST

FEW = 2
"""Cases in which an integral is compared."""
CANDIDATES = 12


def check_profile(
    profile: Profile,
    entries: Entries,
    plain: Entries,
    below: Compact | Complete,
    physics: Physics,
    *,
    digits: int = 50,
    seed: int = 0,
) -> list[Evidence]:
    """Every entry that both half-spaces have; `below` states the normal contact on the homogeneous one.

    A formula at k = 0 and an equation at k = 0 are compared symbol by symbol, an integral by its value there.
    """
    found = []
    for suffix, entry in entries.items():
        if suffix not in plain:
            continue
        statuses = {entry.status, plain[suffix].status}
        if "integral" in statuses:
            found.append(_at_zero(profile, entries, plain, suffix, physics, digits, seed))
        elif len(statuses) == 1:
            found.append(_exact(entries, plain, suffix, below))
        else:
            reason = "an equation here and its solution there; what they invert is compared"
            found.append(not_available(entry.key, f"k = 0: {plain[suffix].key}", reason))
    return found


def _exact(entries: Entries, plain: Entries, suffix: str, below: Compact | Complete) -> Evidence:
    entry, compared = entries[suffix], f"k = 0: {plain[suffix].key}, symbolically"
    try:
        steps = homogeneous_limit(suffix, dict(entries), dict(plain), below)
    except NotProvedError as error:
        return Evidence(entry.key, compared, "failed", reason=str(error))
    return Evidence(entry.key, compared, "passed", count=len(steps))


def _at_zero(
    profile: Profile, entries: Entries, plain: Entries, suffix: str, physics: Physics, digits: int, seed: int
) -> Evidence:
    """At one point of each of the first cases that are integrals."""
    entry, own = entries[suffix], plain[suffix]
    drawn = (point.values for point in drawn_points(profile, entries, suffix, physics, CANDIDATES, seed))
    # next to a border an integral takes a minute
    places = {case_at(entry, values): values for values in sorted(drawn, key=decades, reverse=True)}
    integrals = [values for case, values in places.items() if case.expr.has(sp.Integral)]
    rows: list[tuple[Values, Number]] = []
    for at in (integrals or list(places.values()))[:FEW]:
        values = {**at, nt.E_star: at[nt.H], nt.k: sp.S.Zero}
        if nt.H_x in values:
            values[nt.G_star] = values[nt.H_x]
        with mp.workdps(digits + GUARD):
            got, want = (formula_value(x, values, digits) for x in (entry, own))
            rows.append((values, residual(got, want)))
    return judge(entry.key, f"k = 0: {own.key}", rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)
