"""The rules in front of the book that hold for every profile."""

from __future__ import annotations

from typing import Any

from ..contact import adhesive, tangential
from ..contact.systems import BY_NAME
from ..entry import COMPACT
from . import blocks, rules
from .naming import label_of
from .width import width

RULED = (
    ("graded.normal", ("p", "w", "pm")),
    ("graded.adhesive", ("Dl", "d", "F", "p", "w", "ad", "aF", "ac", "Fc", "dc", "am", "Fm", "dm")),
    ("graded.tangential", ("F", "u", "us", "tau", "c")),
)


def rule_rows() -> list[tuple[str, list[list[dict[str, Any]]]]]:
    """The rules that hold for every profile, on the graded half-space, by the title of their system."""
    return [
        (blocks.TITLES[system][0], _paired([_rule_row(system, suffix) for suffix in suffixes]))
        for system, suffixes in RULED
    ]


HALF = 100.0
"""Points for a rule on half a line."""


def _paired(rows: list[dict[str, Any]]) -> list[list[dict[str, Any]]]:
    """Neighbours that are short go on one line."""
    lines: list[list[dict[str, Any]]] = []
    for row in rows:
        behind = 10 + 0.6 * width(row["remark"]) if row["remark"] else 0
        row["narrow"] = width(row["tex"]) + behind <= HALF
        if row["narrow"] and lines and len(lines[-1]) == 1 and lines[-1][0]["narrow"]:
            lines[-1].append(row)
        else:
            lines.append([row])
    return lines


def _rule_row(system: str, suffix: str) -> dict[str, Any]:
    found = rules.rule(system, suffix)
    assert found is not None
    tables = {"normal": COMPACT, "adhesive": adhesive.QUANTITIES, "tangential": tangential.QUANTITIES}
    label, small = label_of(suffix, tables[system.rpartition(".")[2]][suffix].label)
    group = BY_NAME[system].group
    small = f"${found.where}$" if found.where else small
    return {"suffix": f"{group}.{suffix}", "label": label, "small": small, "tex": found.tex, "remark": found.remark}
