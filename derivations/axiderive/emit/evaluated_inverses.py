"""Inverses in print as the generated code computes them: the unknown that is solved for, and what rounding it costs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..contact.medium import HOMOGENEOUS
from ..entry import Entry
from ..notation import a
from ..profiles.profile import Profile
from .compact import Compact
from .evaluated import Rows
from .inverses import Inverses
from .naming import LEFT
from .places import PLACES, UNKNOWN
from .printer import Printer
from .private import PrivateFunctions

RADII = {"ad": "g(a)=d", "aF": r"F_{\mathrm N}(a)=F_{\mathrm N}"}


def inverse_rows(profile: Profile, entries: Mapping[str, Entry]) -> Rows:
    """The rows of the inverses that are found by iteration; one that is closed is computed as it is printed."""
    if profile.contact != "compact":
        return []
    inverses = Inverses(Compact(entries, PrivateFunctions(profile)))
    iterated = [suffix for suffix in RADII if inverses.closed(entries[suffix]) is None]
    if not iterated:
        return []
    key = entries["d"].key.rpartition(".")[0]
    keys = " ".join(f"{key}.{suffix}" for suffix in iterated)
    printer = Printer(names={UNKNOWN: "t"})
    rows: Rows = []
    start = "start at one" if profile.breaks and not profile.truncated else "start between the powers of both ends"
    for kind, length, where in inverses.unknowns():
        radius, root = (printer(expr) for expr in PLACES[kind].expressions(length))
        whole = printer(PLACES[kind].root(a, length))
        equations = [RADII[suffix] for suffix in iterated if entries[suffix].status == "closed"]
        tex = r",\qquad ".join([f"a={radius}", f"{whole}={root}", *equations])
        own = start if kind == "beyond" or not profile.breaks else ""
        rows.append(_row("solved", keys, "Solved for $t$", where and f"${where}$", tex, remark=own))
    missed = {"F": r"\bigl[d-g(a)\bigr]", "d": rf"{LEFT['F']}-{LEFT['F']}(a)"}
    stiffness = printer(HOMOGENEOUS.stiffness())
    force = rf"{LEFT['F']}={LEFT['F']}(a)+{stiffness} \, {missed['F']}"
    depth = rf"d=g(a)+\frac{{{missed['d']}}}{{{stiffness}}}"
    return [*rows, _row("corrected", f"{key}.Fd", "Evaluated as", "", force, True),
            _row("corrected", f"{key}.dF", "Evaluated as", "", depth, True)]  # fmt: skip


def _row(
    kind: str, keys: str, label: str, small: str, tex: str, half: bool = False, remark: str = ""
) -> dict[str, Any]:
    return {
        "half": half, "comment": f"{kind} {keys}", "label": label, "small": small, "tex": tex, "remark": remark,
    }  # fmt: skip
