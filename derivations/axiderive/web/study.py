"""The figures of the studies as SVG, from the millimetres in which the book draws them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from ..book.study import error, maps
from ..book.study import timing as of_profile
from ..print.words import escaped
from .figures import Figure, Scale
from .words import slug

UNIT = 8.0
"""SVG units to a millimetre."""
LEFT, RIGHT, BELOW, ABOVE = 8.5, 2.5, 8.5, 5.5
"""Millimetres around the frame of a panel, for its ticks and the names of its axes."""
MARGIN, HEADING, GAP = 5.0, 5.0, 3.0
"""Millimetres left of and below a map, above it, and between its two pictures."""
_RECTANGLE = re.compile(r"\(([\d.]+),([\d.]+)\) rectangle \+\(([\d.]+),([\d.]+)\)")


def timing(record: Mapping[str, Any], keys: Sequence[str]) -> dict[str, Any] | None:
    """Error against run time of these keys for the page of their profile; None if none was measured."""
    found = of_profile.timing(record, keys)
    if found is None:
        return None
    panels = [_panel(one, strip.figure) for strip in found.strips for one in strip.figure.panels]
    return {
        "panels": panels,
        "methods": found.methods,
        "sentences": [s for strip in found.strips for s in strip.sentences],
    }


def model(figures: Mapping[str, Any]) -> dict[str, Any]:
    """What the page of the studies shows, from `book.study`; each part may be missing."""
    shown: dict[str, Any] = {"error": None, "speed": figures["speed"], "maps": None, "extremes": None}
    if figures["error"]:
        whole = figures["error"]
        shown["error"] = {"panels": [_panel(one, whole) for one in whole.panels], "methods": whole.methods}
    if figures["maps"]:
        found = figures["maps"]
        shown["maps"] = {
            "figures": [_map(one, found.width) for one in (*found.square, *found.plain)],
            "legend": [words for _, words in found.legend],
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


def _caption(key: str, known: bool) -> tuple[str, str]:
    """The key, and a link to its formula where there is one."""
    return key, rf"\hyperref[eq:{key}]{{formula}}" if known else ""


def _panel(panel: error.Panel, whole: error.Figure) -> Figure:
    """Lines of one formula over the decades of time and error."""
    size = UNIT * (LEFT + whole.width + RIGHT), UNIT * (ABOVE + whole.height + BELOW)
    lines = ", ".join(f"{line.letter}{' (this catalogue)' * line.own}" for line in panel.lines)
    seen = f"Worst relative error of {panel.key} over the run time: lines {lines}"
    figure = Figure(*size, _caption(panel.key, panel.known), seen, anchor=f"error.{panel.key}")
    scale = Scale(UNIT * LEFT, UNIT * (ABOVE + whole.height), UNIT, UNIT)
    for place, power in whole.xticks:
        x, y = scale.at(place, 0)
        figure.line("grid", (x, y), scale.at(place, whole.height))
        figure.line("axis", (x, y), (x, y + 6))
        figure.label(f"10^{{{power}}}", (x, y + 2.8 * UNIT))
    for place, power in whole.yticks:
        x, y = scale.at(0, place)
        figure.line("axis", (x - 6, y), (x, y))
        figure.label(f"10^{{{power}}}", (x - 1.2 * UNIT, y), "right")
    figure.line("axis", scale.at(0, 0), scale.at(whole.width, 0))
    figure.line("axis", scale.at(0, 0), scale.at(0, whole.height))
    figure.label(whole.names[0], (figure.width - UNIT * RIGHT, figure.height), "above-right", plain=True)
    figure.label(whole.names[1], (0, 0), "below-left", plain=True)
    for line in panel.lines:
        look = "own" if line.own else "rival"
        figure.add("polyline", look, points=scale.points(line.points))
        for point in line.points:
            x, y = scale.at(*point)
            figure.add("circle", f"{look} dot", cx=x, cy=y, r=3.5)
        figure.label(line.letter, scale.at(*line.place), kind="accent" if line.own else "", plain=True)
    return figure


def _map(one: maps.Map, width: float) -> Figure:
    """The printed formula and the emitted function side by side."""
    size = UNIT * (MARGIN + 2 * width + GAP + 1), UNIT * (HEADING + one.height + MARGIN)
    shares = f"{one.naive.share} % of the printed formula, {one.emitted.share} % of the emitted function"
    seen = f"Error of {one.key} over its range as two maps; missing the limit: {shares}"
    figure = Figure(*size, _caption(one.key, one.known), seen, anchor=f"map.{one.key}")
    for i, (words, picture) in enumerate((("as printed", one.naive), ("emitted", one.emitted))):
        scale = Scale(UNIT * (MARGIN + i * (width + GAP)), UNIT * (HEADING + one.height), UNIT, UNIT)
        for level in picture.levels:
            figure.add("path", f"level{maps.COLOURS.index(level.colour)}", d=_squares(level.rectangles, scale))
        x, y = scale.at(0, one.height)
        figure.add("rect", "frame", x=x, y=y, width=UNIT * width, height=UNIT * one.height)
        figure.label(f"{words} {picture.share} %", (x, y - 2.2 * UNIT), "left", plain=True)
        name, first, last = (text.strip("$") for text in one.across)
        for text, place, side in ((first, 0.0, "left"), (name, width / 2, "middle"), (last, width, "right")):
            at, bottom = scale.at(place, 0)
            figure.label(text, (at, bottom + 2.6 * UNIT), side)
    if one.up:
        scale = Scale(UNIT * (MARGIN - 1), UNIT * (HEADING + one.height), UNIT, UNIT)
        name, first, last = (text.strip("$") for text in one.up)
        for text, place in ((first, 1.0), (name, one.height / 2), (last, one.height - 1.0)):
            figure.label(text, scale.at(0, place), "right")
    return figure


def _squares(rectangles: str, scale: Scale) -> str:
    """Rectangles of one level as one path."""
    parts = []
    for match in _RECTANGLE.finditer(rectangles):
        left, low, width, tall = map(float, match.groups())
        (x1, y1), (x2, y2) = scale.at(left, low), scale.at(left + width, low + tall)
        parts.append(f"M{x1:g} {y1:g}H{x2:g}V{y2:g}H{x1:g}z")
    return "".join(parts)
