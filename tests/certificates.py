"""The closed entries of every physics, derived once, and which of them are to be proved."""

from __future__ import annotations

import functools
from collections.abc import Callable

from axiderive import profiles
from axiderive.entry import Entry
from axiderive.physics import adhesive, normal, tangential, viscoelastic
from axiderive.physics.medium import GRADED
from axiderive.profiles.profile import Profile

Entries = dict[str, Entry]
DERIVE: dict[str, Callable[[Profile], Entries]] = {
    "graded": lambda profile: normal.derive(profile, GRADED),
    "adhesive": adhesive.derive,
    "graded adhesive": lambda profile: adhesive.derive(profile, GRADED),
    "tangential": tangential.derive,
    "graded tangential": lambda profile: tangential.derive(profile, GRADED),
    "viscoelastic": viscoelastic.derive,
}
BACK = ("earlier_", "end_", "radius_")
WITH_EDGE = ("graded", "viscoelastic")
CELLS = [(kind, name) for kind in DERIVE for name in (profiles.NAMES if kind in WITH_EDGE else profiles.COMPACT_NAMES)]


@functools.cache
def entries(kind: str, name: str) -> Entries:
    return DERIVE[kind](profiles.load(name))


def expected(entry: Entry, within: Entries) -> bool:
    """Closed formulas, equations that say where a load is least, a step force by the radius, a way back."""
    if entry.status == "root":
        shown = entry.suffix in ("ac", "am", "rz") or entry.suffix.startswith(("step_", *BACK))
        return shown and within[entry.suffix] is entry
    return entry.status == "closed"
