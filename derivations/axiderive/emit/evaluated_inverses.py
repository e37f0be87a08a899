"""Inverses in print as the generated code computes them: the unknown that is solved for, and what rounding it costs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ..contact.medium import HOMOGENEOUS
from ..entry import Entry
from ..notation import a
from ..profiles.profile import Profile
from .compact import Compact
from .evaluated import Rows
from .evaluated_slip import packed
from .inverses import Inverses
from .naming import LEFT
from .places import PLACES, UNKNOWN
from .printer import Printer
from .private import PrivateFunctions
from .rows import Region
from .unknowns import Unknown, smooth, unknowns
from .unknowns_graded import graded_unknowns

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
    rows: Rows = [_solved(own, key) for own in solved(entries)]
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


def graded_rows(key: str, entries: Mapping[str, Entry]) -> Rows:
    """The rows of the inverses on the graded half-space."""
    return [_solved(own, key) for own in graded_unknowns(entries)] if "ad" in entries else []


def solved(entries: Mapping[str, Entry]) -> Iterator[Unknown]:
    """What a normal contact is solved for where no root says more than the radius."""
    inverses = Inverses(Compact(entries, PrivateFunctions(entries["d"].profile)))
    if any(inverses.unknowns()):
        return
    found = tuple(unknowns(entries))
    yield from found or [smooth(inverses.first_radius())]


def _solved(own: Unknown, key: str) -> dict[str, Any]:
    lines = packed([f"{equation.left}={equation.right}" for equation in own.equations])
    keys = " ".join(f"{key}.{suffix}" for suffix in own.suffixes)
    tex, small = Region("", tuple(lines)).tex, own.small and f"${own.small}$"
    return _row("solved", keys, f"Solved for ${own.letter}$", small, tex, own.half, own.remark)


def _row(
    kind: str, keys: str, label: str, small: str, tex: str, half: bool = False, remark: str = ""
) -> dict[str, Any]:
    return {
        "half": half, "comment": f"{kind} {keys}", "label": label, "small": small, "tex": tex, "remark": remark,
    }  # fmt: skip
