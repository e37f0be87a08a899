"""Tables of the studies: what a call costs, the worst of stiff and extreme cases, and what two pages in print choose.

These show a few panels of error against run time, and where digits are lost.
"""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from ...print.words import escaped
from ..evidence import power_of_ten
from . import error


def speed(record: Mapping[str, Any], keys: frozenset[str]) -> dict[str, Any]:
    """Sizes of the arrays, a row for each formula, the imports; `keys` are those that the book prints."""
    settings = record["settings"]
    return {
        "sizes": [_power(size) for size in settings["sizes"]],
        "largest": _power(settings["largest"]),
        "rows": [row | {"known": row["key"] in keys, "arrays": list(map(_ratio, row["arrays"]))}
                 | {name: _ratio(row.get(name)) for name in ("scalar", "steps", "copy")} for row in record["rows"]],
        "fresh": f"{record['fresh']:.2g}",
        "imports": [f"{100 * row['ratio']:.2g}" for row in record["imports"]],
        "modules": [row["module"] for row in record["imports"]],
    }  # fmt: skip


def _ratio(x: float | None) -> str:
    if x is None:
        return "--"
    return f"${x:.2g}$" if x < 99.5 else f"${x:.0f}$"


def _power(count: int) -> str:
    exponent = len(str(count)) - 1
    return f"$10^{{{exponent}}}$" if count == 10**exponent else f"${count}$"


def extremes(record: Mapping[str, Any]) -> list[dict[str, Any]]:
    """One row for each limit and problem, each limit where the record first has it."""
    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    limits = list(dict.fromkeys(row["limit"] for row in record["rows"]))
    for row in sorted(record["rows"], key=lambda row: limits.index(row["limit"])):
        groups.setdefault((row["limit"], row["key"].rpartition(".")[0]), []).append(row)
    return [
        {
            "limit": _limit(limit),
            "problem": problem,
            "keys": ", ".join(dict.fromkeys(row["key"].rpartition(".")[2] for row in rows)),
            "cases": len(rows),
            "ulps": _worst([row["ulps"] for row in rows]),
            "emitted": _worst([row["emitted"] for row in rows]),
            "naive": _worst([row["naive"] for row in rows]),
            "refused": sum(row["emitted"] is None for row in rows),
            "lost": sum(row["naive"] is None for row in rows),
        }
        for (limit, problem), rows in groups.items()
    ]


def _limit(text: str) -> str:
    """b -> 0 as mathematics, also where it is said as n large; words as words."""
    left, arrow, right = re.sub(r"^(\w) large$", r"\1 -> infinity", text).partition(" -> ")
    return rf"${left}\to {right.replace('infinity', chr(92) + 'infty')}$" if arrow else escaped(text)


def _worst(values: Sequence[float | None]) -> str:
    finite = [value for value in values if value is not None]
    if not finite:
        return "--"
    worst = max(finite)
    return f"${power_of_ten(f'{worst:.2g}')}$" if worst else "$0$"


PANELS = (
    "cone.p", "cone.w", "paraboloid.adh.ad", "rounded_punch.p", "rounded_punch.Fd", "rounded_punch.w",
    "sphere.p", "sphere.Fd", "sphere.w", "power_law.fgm.p", "power_law.fgm.Fd", "power_law.fgm.w",
)  # fmt: skip
"""A closed form, adhesion, a rule with a break, cancellation, and the graded half-space."""
MAPS = ("rounded_punch.p", "sphere.p", "truncated_cone.p", "rounded_punch.w", "sphere.w", "truncated_cone.w")
CELLS = ((0, "10^{-12}"), (6, "10^{-6}"), (9, "10^{-3}"), (12, r"\tfrac12"), (14, "1-10^{-3}"), (17, "1-10^{-6}"),
         (23, "1-10^{-12}"))  # fmt: skip
"""Which cells of a map of one ratio are told, and about which ratio they are."""
MOST = 16
"""Digits of a double."""


def spread(figures: Mapping[str, Any], records: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Panels with the methods that they show, maps, and the digits that printed formulas of one ratio keep."""
    found: dict[str, Any] = {"error": None, "maps": None, "digits": []}
    if whole := figures["error"]:
        panels = _chosen(whole.panels, PANELS)
        letters = {line.letter for panel in panels for line in panel.lines}
        methods = tuple(one for one in whole.methods if one[0] in letters)
        found["error"] = dataclasses.replace(whole, panels=panels, methods=methods)
    if whole := figures["maps"]:
        found["maps"] = dataclasses.replace(whole, square=_chosen(whole.square, MAPS))
        known = {one.key: one.known for one in whole.plain}
        found["digits"] = [_digits(one, known[one["key"]]) for one in records["maps"]["maps"] if _is_of_a_ratio(one)]
    return found


def _chosen(all_of_them: Sequence[Any], keys: Sequence[str]) -> tuple[Any, ...]:
    return tuple(one for key in keys for one in all_of_them if one.key == key)


def _is_of_a_ratio(one: Mapping[str, Any]) -> bool:
    """Whether a map has one axis, from 0 to 1."""
    return len(one["axes"]) == 1 and one["edges"][0][-1] <= 1


def _digits(one: Mapping[str, Any], known: bool) -> dict[str, Any]:
    """Digits of the printed formula over the ratio it depends on."""
    (cells,) = one["naive"]["worst"]
    return {"key": one["key"], "known": known, "ratio": one["axes"][0], "digits": [_kept(cells[i]) for i, _ in CELLS]}


def _kept(ulps: float | None) -> str:
    """Correct digits behind an error in units of the last place."""
    if ulps is None or ulps < 0:
        return "--"
    return str(max(0, min(MOST, math.floor(-math.log10(max(ulps, 1.0) * error.FLOOR)))))
