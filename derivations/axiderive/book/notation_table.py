"""The table of the notation: the records of the symbols by subject, and the names that only print has."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any

import sympy as sp

from .. import notation as nt
from ..physics.systems import SYSTEMS
from ..print.words import domain, prose
from ..profiles.pools import POOLS
from .texts import rows, sections

Row = dict[str, str]


def _named(table: str) -> dict[str, list[str]]:
    """The names of a table in their order; LaTeX, unit and meaning of those that only print has."""
    found: dict[str, list[str]] = {}
    for names, *said in rows(table):
        found |= {names: said} if said else {name: said for name in names.split()}
    return found


SUBJECTS = {subject: _named(table) for subject, table in sections("notation").items()}
"""The names of each part of the table: of records, and with a colon those that have none, or one of several."""
IN_PRINT = {name: said for names in SUBJECTS.values() for name, said in names.items() if said}
SAID = {"x": "distance from the middle of a plane contact"}
"""Meanings in print that are shorter than those of the records, which speak of derivations too."""
INSTEAD = {
    "a_c": ":pull_off_radius", "u_0": ":sliding", "j": ":index", "z": ":section", "W": ":potential",
    **{f"S_{m}": ":pressed" for m in range(4)}, **{f"D_{m}": ":deeper" for m in range(4)},
}  # fmt: skip
"""Records whose symbol stands in the row of a name in print."""


ROOTS = ("m", "v", r"\ell")
"""Letters of roots that mean something else in other rows; s has a row of its own."""


def by_subject(used: AbstractSet[str], entries: Sequence[Mapping[str, Any]]) -> list[tuple[str, list[Row]]]:
    """The rows of the table by subject, for a book whose formulas use the symbols of these names.

    The entries are summaries: a letter that means different things in them has a row for each.
    """
    known = used | {"N", *IN_PRINT}
    meanings = _by_meaning({m["name"]: m["number"] for m in entries})
    meanings["width"] = [
        _row("width") | {"meaning": _within("width of the contact", [m for m in entries if "width" in m["symbols"]])}
    ]
    meanings[":roots"] = [
        _row(":roots") | {"name": f"print-root-{i}", "latex": letter, "meaning": _within(IN_PRINT[":roots"][2], own)}
        for i, letter in enumerate(ROOTS)
        if (own := [m for m in entries if letter in m["roots"]])
    ]
    return [
        (title, [row for name in names if name in known for row in meanings.get(name) or [_row(name)]])
        for title, names in (*SUBJECTS.items(), *of_physics())
    ]


def of_physics() -> Iterator[tuple[str, tuple[str, ...]]]:
    """Further subjects: of every physics above another one the letters of its material and results with no row yet."""
    told = {*INSTEAD, *(name for names in SUBJECTS.values() for name in names)}
    printed = {letter for latex, _, _ in IN_PRINT.values() for letter in latex.split(r",\;")}
    for system in SYSTEMS:
        physics = system.physics
        results = (own.symbol for table in physics.quantities.values() for own in table.values())
        letters = dict.fromkeys(symbol.name for symbol in (*physics.material, *results))
        new = [name for name in letters if name not in told and nt.describe(name).latex not in printed]
        told |= {*new}
        if physics.over and new:
            yield system.said.title, tuple(new)


def _within(meaning: str, entries: Sequence[Mapping[str, Any]]) -> str:
    """The words with the entries that they hold in."""
    places = dict.fromkeys(rf"\hyperref[sec:{m['name']}]{{{m['number']}}}" for m in entries if not m["host"])
    return f"{prose(meaning)} ({', '.join(places)})"


def _by_meaning(numbers: Mapping[str, str]) -> dict[str, list[Row]]:
    """Of the symbols that profiles have words of their own for: a row for every meaning, with its entries."""
    found: dict[sp.Symbol, dict[str, dict[str, str]]] = {}
    for pool in POOLS:
        for profile_id in (own for own in map(pool.id, pool.names) if own in numbers):
            for symbol, meaning in pool.load(profile_id.rpartition(".")[2]).meanings:
                places = found.setdefault(symbol, {}).setdefault(meaning, {})
                places.setdefault(numbers[profile_id], rf"\hyperref[sec:{profile_id}]{{{numbers[profile_id]}}}")
    return {symbol.name: _rows_by_meaning(symbol.name, meanings) for symbol, meanings in found.items()}


def _rows_by_meaning(name: str, meanings: Mapping[str, Mapping[str, str]]) -> list[Row]:
    plain = _row(name)
    return [
        plain | {"name": f"{name}-{i}" if i else name, "meaning": f"{prose(meaning)} ({', '.join(entries.values())})"}
        for i, (meaning, entries) in enumerate(meanings.items())
    ]


def recorded(used: AbstractSet[str]) -> list[Row]:
    """The symbols of these names, in the order of the notation."""
    left_out = {"j", "N", "stiffness"}
    return [_row(record.name) for record in nt.all_notation() if record.name in used - left_out]


def _row(name: str) -> Row:
    if name in IN_PRINT:
        latex, unit, meaning = IN_PRINT[name]
        limits = ""
    else:
        n = nt.describe(name)
        latex, unit, meaning, limits = n.latex, n.unit, SAID.get(name, n.meaning), domain(n)
    anchor = name.replace(":", "print-")
    return {"name": anchor, "latex": latex, "unit": _unit(unit), "meaning": prose(meaning), "domain": limits}


def _unit(unit: str) -> str:
    text = re.sub(r"\^\(([^()]*)\)", lambda m: f"$^{{{m[1]}}}$", unit)
    return re.sub(r"\^(\d+)", lambda m: f"$^{{{m[1]}}}$", text)
