"""Pressure and traction summed over the contact: F = 2 pi int p r dr and F_x = 2 pi int tau r dr."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from .. import notation as nt
from ..abel.masters import C0
from ..entry import Entry
from ..oracle.evaluate import case_at, decades
from ..oracle.evidence import Evidence, judge, not_available
from ..oracle.sampling import Values
from ..physics import Physics, tangential
from ..profiles.profile import Profile
from .identities import carried
from .physics_quadrature import Entries, drawn_points
from .quadrature import LOST

EXPONENTS = (sp.Rational(-1, 10), sp.Rational(2, 5))
"""Exponents of grading at which pressures are summed; at k = -3/10 what is left out at the edge costs 12 digits."""


def traction(profile: Profile, entries: Entries, *, digits: int = 50, seed: int = 0) -> Evidence:
    """F_x = 2 pi int tau r dr."""
    force, entry = entries["F"], entries["tau"]
    drawn = [point.values for point in drawn_points(profile, entries, "F", tangential.PHYSICS, 1, seed)]
    return _check(force, entry, "traction", [min(drawn, key=decades)], digits, seed)


def pressure(
    profile: Profile, force: Entry, entry: Entry, physics: Physics, *, digits: int = 50, seed: int = 0
) -> Evidence:
    """F = 2 pi int p r dr on the graded half-space, in every case of the force.

    Without a free edge, and under adhesion, the pressure grows towards the edge like (a - r)**((k - 1)/2).
    """
    drawn = [point.values for point in drawn_points(profile, {"F": force}, "F", physics, 1, seed) if not point.extreme]
    each = {case_at(force, values).chain: values for values in drawn}
    exponents = EXPONENTS if len(each) == 1 else EXPONENTS[:1]
    places = [{**values, nt.k: exponent} for values in each.values() for exponent in exponents]
    return _check(force, entry, "pressure", places, digits, seed)


def _check(force: Entry, entry: Entry, name: str, places: Sequence[Values], digits: int, seed: int) -> Evidence:
    compared = f"2 pi int {entry.suffix} r dr"
    if entry.status == "integral" or any(case.expr.has(C0) for case in entry.cases):
        reason = f"the {name} is itself an integral, too slow to integrate again"
        return not_available(force.key, compared, reason)
    rows = [(values, carried(case_at(force, values), entry, values, digits)) for values in places]
    return judge(force.key, compared, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)
