"""Error against run time: one panel for every formula that was measured, all with the same axes, in millimetres."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...figures.drawing import Drawing
from ...print.words import escaped

WIDTH, HEIGHT = 43.0, 30.0
"""Millimetres of the frame; twelve fit below the words of the first page."""
NAMES = "run time over that of the function", "worst relative error"
"""What the axes measure."""
LOWEST = -16


METHODS = {
    "emitted": "the function of this catalogue",
    "lambdify": "the printed formula through NumPy",
    "generated rule": "a generated rule of $N$ nodes",
    "Gauss-Jacobi": "Gauss--Jacobi rule for the defining integral",
    "quad": "adaptive quadrature in double precision",
    "mpmath": "adaptive quadrature in many digits",
    "quad, substituted": "adaptive quadrature, singularities substituted away",
    "mpmath, substituted": "the same in many digits",
    "trapezoid MDR": "dimensionality reduction by the trapezoidal rule",
    "FFT MDR": "dimensionality reduction on a grid by FFT",
    "quad and root": "adaptive quadrature and root finding",
    "quad, weighted": "adaptive quadrature, singular weight",
    "table": "interpolation in a table",
    "BEM": "boundary elements",
}
"""What the methods are, below the panels."""
OWN = ("emitted", "generated rule")
"""Methods of the catalogue, drawn in colour."""
FLOOR = 2.0**-53
"""Errors below the rounding of a double count as that."""

Point = tuple[float, float]
Plots = dict[str, dict[str, list[Point]]]


@dataclass(frozen=True)
class Line:
    """What one method reaches: its points in millimetres, its letter and where that sits."""

    letter: str
    own: bool
    points: tuple[Point, ...]
    place: Point


@dataclass(frozen=True)
class Panel:
    """One formula; `known` says whether the book prints its key."""

    key: str
    known: bool
    lines: tuple[Line, ...]


@dataclass(frozen=True)
class Figure:
    """All panels, their axes, and what the letters mean."""

    panels: tuple[Panel, ...]
    methods: tuple[tuple[str, str], ...]
    xticks: tuple[tuple[float, int], ...]
    yticks: tuple[tuple[float, int], ...]


def picture(panel: Panel, whole: Figure, first: bool | None = None) -> Drawing:
    """A panel in millimetres: in print the first of a line has the name of its vertical axis; None for the web edition.

    There the names of the axes stand in the corners, and the key is the caption.
    """
    wide, high = WIDTH, HEIGHT
    if first is None:
        figure = Drawing("study", (-8.5, -8.5), (wide + 2.5, high + 5.5), captioned(panel.key, panel.known))
        figure.label(NAMES[0], (wide, -8.5), "south east")
        figure.label(NAMES[1], (-8.5, high + 5.5), "north west")
    else:
        figure = Drawing("study", (-12.0 if first else -8.5, -8.0), (wide, high + 5.0))
        figure.label(NAMES[0], (wide / 2, -4.7), "north", "note")
        figure.label(referred(panel.key, panel.known), (0.0, high + 2.2), "base west")
        if first:
            figure.label(NAMES[1], (-9.6, high / 2), "base", "note", turned=True)
    lines = ", ".join(f"{line.letter}{' (this catalogue)' * line.own}" for line in panel.lines)
    figure.seen = f"Worst relative error of {panel.key} over the run time: lines {lines}"
    figure.anchor = f"error.{panel.key}"
    for place, power in whole.xticks:
        figure.line("grid", (place, 0.0), (place, high))
        figure.line("tick", (place, 0.0), (place, -0.8))
        figure.label(f"$10^{{{power}}}$", (place, -0.8), "north", "tick")
    for place, power in whole.yticks:
        figure.line("tick", (0.0, place), (-0.8, place))
        figure.label(f"$10^{{{power}}}$", (-0.8, place), "east", "tick")
    figure.line("axis", (wide, 0.0), (0.0, 0.0), (0.0, high))
    for line in panel.lines:
        look, colour = ("own", "accent") if line.own else ("rival", "ink")
        figure.line(look, *line.points)
        for point in line.points:
            figure.dot(f"dot {colour}", point)
        figure.label(line.letter, line.place, look=colour)
    return figure


def captioned(key: str, known: bool) -> tuple[str, str]:
    """The key, and a link to its formula where there is one."""
    return key, rf"\hyperref[eq:{key}]{{formula}}" if known else ""


def referred(key: str, known: bool) -> str:
    """The key, which leads to its formula where the book prints it."""
    return rf"\eqr{{{key}}}" if known else rf"\code{{\detokenize{{{key}}}}}"


def plots(record: Mapping[str, Any]) -> Plots:
    """Times and worst errors by key and method, in the order of the record; an error that is none is left out."""
    found: Plots = {}
    for row in record["rows"]:
        if row["worst"] is not None:
            point = row["ratio"], max(row["worst"], FLOOR)
            found.setdefault(row["key"], {}).setdefault(row["method"], []).append(point)
    return found


def figure(record: Mapping[str, Any], keys: frozenset[str]) -> Figure:
    """The panels in the order of the record, with the words of the methods in that of their letters."""
    found = plots(record)
    methods = dict.fromkeys(method for plot in found.values() for method in plot)
    letters = {method: chr(ord("a") + i) for i, method in enumerate(methods)}
    ratios = [x for plot in found.values() for points in plot.values() for x, _ in points]
    first, last = math.floor(math.log10(min(ratios))), math.ceil(math.log10(max(ratios)))
    scale = Scale(first, last)
    panels = tuple(Panel(key, key in keys, tuple(_lines(plot, letters, scale))) for key, plot in found.items())
    step = max(1, math.ceil((last - first) / 5))
    return Figure(
        panels,
        tuple((letter, METHODS.get(method, escaped(method))) for method, letter in letters.items()),
        tuple((round(scale.x(10.0**power), 2), power) for power in range(-(-first // step) * step, last + 1, step)),
        tuple((round(scale.y(10.0**power), 2), power) for power in range(LOWEST, 1, 4)),
    )


@dataclass(frozen=True)
class Scale:
    """Decades of the ratio of times to millimetres; errors from 1e-16 to 1."""

    first: int
    last: int

    def x(self, ratio: float) -> float:
        """Place in millimetres of a ratio of times on the logarithmic horizontal axis."""
        return WIDTH * (math.log10(ratio) - self.first) / (self.last - self.first)

    def y(self, error: float) -> float:
        """Place in millimetres of an error on the logarithmic vertical axis; errors off the axis stand at its ends."""
        power = min(max(math.log10(error), LOWEST), 0.0)
        return HEIGHT * (power - LOWEST) / -LOWEST


def _lines(plot: Mapping[str, Sequence[Point]], letters: Mapping[str, str], scale: Scale) -> Iterator[Line]:
    points = {m: tuple((scale.x(ratio), scale.y(error)) for ratio, error in rows) for m, rows in plot.items()}
    taken = [point for own in points.values() for point in own]
    for method, own in points.items():
        place = _free(own, taken, scale)
        taken.append(place)
        yield Line(letters[method], method in OWN, own, place)


AROUND = tuple((2.1 * math.cos(math.pi * i / 4), 2.1 * math.sin(math.pi * i / 4)) for i in (2, 0, 6, 4, 1, 3, 5, 7))


def _free(own: Sequence[Point], taken: Sequence[Point], scale: Scale) -> Point:
    """Beside one of the points, where points and letters are farthest away."""

    def room(place: Point) -> float:
        inside = 1.0 <= place[0] <= WIDTH - 1.0 and 1.0 <= place[1] <= HEIGHT
        return min(math.dist(place, other) for other in taken) if inside else -1.0

    places = [(x + dx, y + dy) for x, y in own for dx, dy in AROUND]
    best = max(places, key=lambda place: round(min(room(place), 2.1), 3))
    return round(best[0], 2), round(best[1], 2)
