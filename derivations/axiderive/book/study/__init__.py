"""The records of `axicontact study` as figures and tables of the book: whatever cases the records hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from . import error, maps, tables

Records = Mapping[str, Mapping[str, Any]]
"""What was measured, by name of the study: error, speed, maps, extremes; a study may be missing."""
DRAWN: Mapping[str, Callable[[Mapping[str, Any], frozenset[str]], Any]] = {
    "error": error.figure,
    "speed": tables.speed,
    "maps": maps.figure,
    "extremes": lambda record, _: tables.extremes(record),
}


def figures(records: Records, keys: frozenset[str]) -> dict[str, Any]:
    """What the template of the studies draws; `keys` are those that the book prints and a panel may refer to."""
    return {name: drawn(records[name], keys) if name in records else None for name, drawn in DRAWN.items()}
