"""What a call costs as a table: times of the emitted functions over those of the formulas alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def table(record: Mapping[str, Any], keys: frozenset[str]) -> dict[str, Any]:
    """Sizes of the arrays, a row for each formula, the imports; `keys` are those that the book prints."""
    settings = record["settings"]
    return {
        "sizes": [_power(size) for size in settings["sizes"]],
        "largest": _power(settings["largest"]),
        "rows": [row | {"known": row["key"] in keys, "arrays": list(map(_ratio, row["arrays"]))} | _ends(row)
                 for row in record["rows"]],
        "fresh": f"{record['fresh']:.2g}",
        "imports": [f"{100 * row['ratio']:.2g}" for row in record["imports"]],
        "modules": [row["module"] for row in record["imports"]],
    }  # fmt: skip


def _ends(row: Mapping[str, Any]) -> dict[str, str]:
    return {"scalar": _ratio(row["scalar"]), "steps": _ratio(row.get("steps")), "copy": _ratio(row["copy"])}


def _ratio(x: float | None) -> str:
    if x is None:
        return "--"
    return f"${x:.2g}$" if x < 99.5 else f"${x:.0f}$"


def _power(count: int) -> str:
    exponent = len(str(count)) - 1
    return f"$10^{{{exponent}}}$" if count == 10**exponent else f"${count}$"
