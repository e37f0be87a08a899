"""The records of `axicontact study` as figures and tables of the book: whatever cases the records hold."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from . import error, maps, tables

Records = Mapping[str, Mapping[str, Any]]
"""What was measured, by name of the study: error, speed, maps, extremes; a study may be missing."""


def figures(records: Records, keys: frozenset[str]) -> dict[str, Any]:
    """What the template of the studies draws; `keys` are those that the book prints and a panel may refer to."""
    found: dict[str, Any] = {"error": None, "speed": None, "maps": None, "extremes": None}
    if "error" in records:
        found["error"] = error.figure(records["error"], keys)
    if "speed" in records:
        found["speed"] = tables.speed(records["speed"], keys)
    if "maps" in records:
        found["maps"] = maps.figure(records["maps"], keys)
    if "extremes" in records:
        found["extremes"] = tables.extremes(records["extremes"])
    return found
