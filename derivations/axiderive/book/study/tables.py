"""Tables of the studies: what a call costs, and the worst of stiff and extreme cases, emitted beside naive."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from ...print.words import escaped
from ..evidence import power_of_ten


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
