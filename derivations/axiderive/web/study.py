"""The figures of the studies as SVG, from the millimetres in which the book draws them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..book.study import error, maps
from ..figures.svg import Picture, svg
from ..print.words import escaped
from .words import slug

UNIT = 8.0
"""SVG units to a millimetre."""


def _panel(panel: error.Panel, whole: error.Figure) -> Picture:
    return svg(error.picture(panel, whole), UNIT)


def model(figures: Mapping[str, Any]) -> dict[str, Any]:
    """What the page of the studies shows, from `book.study`; each part may be missing."""
    shown: dict[str, Any] = {"error": None, "speed": figures["speed"], "maps": None, "extremes": None}
    if figures["error"]:
        whole = figures["error"]
        shown["error"] = {"panels": [_panel(one, whole) for one in whole.panels], "methods": whole.methods}
    if figures["maps"]:
        found = figures["maps"]
        shown["maps"] = {
            "figures": [svg(maps.drawing(one, printed=False), UNIT) for one in (*found.square, *found.plain)],
            "legend": found.legend,
        }
    if figures["extremes"]:
        shown["extremes"] = [row | {"problem": _linked(row), "anchor": _address(row)} for row in figures["extremes"]]
    return shown


def _address(row: Mapping[str, Any]) -> str:
    """extreme.b-to-0.cone: of the limit and the problem, which no other row has both."""
    # the sign tells k to -1 and k to 1 apart
    limit = slug(row["limit"].replace(r"\to", "to").replace("-", "minus ").translate(PLAIN))
    return f"extreme.{limit}.{row['problem']}"


PLAIN = str.maketrans({"$": None, "\\": None, "{": None, "}": None})
"""What LaTeX puts around the letters of a limit."""


def _linked(row: Mapping[str, Any]) -> str:
    """The problem, linked to the first of its formulas in the row."""
    problem, first = row["problem"], row["keys"].partition(",")[0]
    return rf"\hyperref[eq:{problem}.{first}]{{{escaped(problem)}}}"
