"""The records of `axicontact study` as figures and tables of the book: whatever cases the records hold.

One panel of error against run time for every formula that was measured, in millimetres, all with the same axes; maps of
the printed formula through NumPy beside the emitted function, in a few levels of error; what a call costs, the worst of
stiff and extreme cases; and what two pages in print choose of all that.
"""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..figures.drawing import Boxes, Drawing
from ..print.words import escaped
from .evidence import power_of_ten

WIDTH, HEIGHT = 43.0, 30.0
"""Millimetres of the frame; twelve fit below the words of the first page."""
AXES = "run time over that of the function", "worst relative error"
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
class Panels:
    """All panels, their axes, and what the letters mean."""

    panels: tuple[Panel, ...]
    methods: tuple[tuple[str, str], ...]
    xticks: tuple[tuple[float, int], ...]
    yticks: tuple[tuple[float, int], ...]


def panel_drawing(panel: Panel, whole: Panels, first: bool | None = None) -> Drawing:
    """A panel in millimetres: in print the first of a line has the name of its vertical axis; None for the web edition.

    There the names of the axes stand in the corners, and the key is the caption.
    """
    wide, high = WIDTH, HEIGHT
    if first is None:
        figure = Drawing("study", (-8.5, -8.5), (wide + 2.5, high + 5.5), captioned(panel.key, panel.known))
        figure.label(AXES[0], (wide, -8.5), "south east")
        figure.label(AXES[1], (-8.5, high + 5.5), "north west")
    else:
        figure = Drawing("study", (-12.0 if first else -8.5, -8.0), (wide, high + 5.0))
        figure.label(AXES[0], (wide / 2, -4.7), "north", "note")
        figure.label(referred(panel.key, panel.known), (0.0, high + 2.2), "base west")
        if first:
            figure.label(AXES[1], (-9.6, high / 2), "base", "note", turned=True)
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


def error_panels(record: Mapping[str, Any], keys: frozenset[str]) -> Panels:
    """The panels in the order of the record, with the words of the methods in that of their letters."""
    found = plots(record)
    methods = dict.fromkeys(method for plot in found.values() for method in plot)
    letters = {method: chr(ord("a") + i) for i, method in enumerate(methods)}
    ratios = [x for plot in found.values() for points in plot.values() for x, _ in points]
    first, last = math.floor(math.log10(min(ratios))), math.ceil(math.log10(max(ratios)))
    scale = Scale(first, last)
    panels = tuple(Panel(key, key in keys, tuple(_lines(plot, letters, scale))) for key, plot in found.items())
    step = max(1, math.ceil((last - first) / 5))
    return Panels(
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


SIDE = 21.5
"""Millimetres of a map of two ratios, and of the width of one."""
STRIP = 3.0
LEVELS = (5.0, 1e3, 1e6, 1e9, 1e12)
"""Errors in ulps up to which a cell has the colour of its level; beyond them there is one more, and one for NaN."""
LEVEL_NAMES = ("5", "10^{3}", "10^{6}", "10^{9}", "10^{12}")

Cells = Sequence[Sequence[float | None]]


@dataclass(frozen=True)
class Picture:
    """One way to evaluate the formula: its cells by level, and the share of the samples that miss 1e-12."""

    levels: tuple[Boxes, ...]
    share: str


@dataclass(frozen=True)
class Map:
    """Naive and emitted side by side; the axes with the ends of their ratios."""

    key: str
    known: bool
    across: tuple[str, str, str]
    up: tuple[str, str, str] | None
    naive: Picture
    emitted: Picture
    height: float


@dataclass(frozen=True)
class Maps:
    """All maps of the study, those of one ratio and those of two, with the words for each level."""

    plain: tuple[Map, ...]
    """Maps of one ratio."""
    square: tuple[Map, ...]
    legend: tuple[str, ...]


def map_drawing(one: Map, *, printed: bool) -> Drawing:
    """Both pictures of a map in millimetres, in print with the key over them, which is the caption on the web."""
    gap, name_of_own = (2.0, "function") if printed else (3.0, "emitted")
    high = one.height + (8.0 if printed else 5.0)
    figure = Drawing("study", (-5.0, -5.0), (2 * SIDE + gap + 1, high), captioned(one.key, one.known))
    if printed:
        figure.label(referred(one.key, one.known), (0.0, one.height + 4.6), "base west")
    shares = f"{one.naive.share} % of the printed formula, {one.emitted.share} % of the emitted function"
    figure.seen = f"Error of {one.key} over its range as two maps; missing the limit: {shares}"
    figure.anchor = f"map.{one.key}"
    for i, (name, picture) in enumerate(zip(("as printed", name_of_own), (one.naive, one.emitted), strict=True)):
        left = i * (SIDE + gap)
        for level in picture.levels:
            figure.boxes.append(
                Boxes(level.look, tuple((x + left, y, wide, tall) for x, y, wide, tall in level.corners))
            )
        corners = ((left, 0.0), (left + SIDE, 0.0), (left + SIDE, one.height), (left, one.height))
        figure.area("frame", corners)
        figure.label(rf"{name} \textcolor{{note}}{{{picture.share}\,\%}}", (left, one.height + 1.4), "base west")
        ends = ((0.0, "north west"), (SIDE / 2, "north"), (SIDE, "north east"))
        for text, (x, side) in zip((one.across[1], one.across[0], one.across[2]), ends, strict=True):
            figure.label(text, (left + x, -0.9), side)
    if one.up:
        ends = ((0.0, "south east"), (one.height / 2, "east"), (one.height, "north east"))
        for text, (y, side) in zip((one.up[1], one.up[0], one.up[2]), ends, strict=True):
            figure.label(text, (-0.8, y), side)
    return figure


def error_maps(record: Mapping[str, Any], keys: frozenset[str]) -> Maps:
    """The maps of the record, those of one ratio and those of two."""
    found = [_map(one, keys) for one in record["maps"]]
    words = [rf"$\le {name}$" for name in LEVEL_NAMES] + ["more", "NaN or infinite"]
    return Maps(
        tuple(one for one in found if one.up is None),
        tuple(one for one in found if one.up is not None),
        tuple(words),
    )


def _map(one: Mapping[str, Any], keys: frozenset[str]) -> Map:
    flat = len(one["axes"]) == 1
    height = STRIP if flat else SIDE
    axes = [_axis(name, edges) for name, edges in zip(one["axes"], one["edges"], strict=True)]
    return Map(
        one["key"],
        one["key"] in keys,
        axes[-1],
        None if flat else axes[0],
        _picture(one["naive"], height),
        _picture(one["emitted"], height),
        height,
    )


def _axis(name: str, edges: Sequence[float]) -> tuple[str, str, str]:
    """Name of the ratio in print and its ends: a ratio reaches to 0 and to 1 as far as doubles go."""
    if edges[-1] > 1:
        return f"${name}$", f"${edges[0]:g}$", f"${edges[-1]:g}$"
    return f"${name}$", "$0$", "$1$"


def _picture(found: Mapping[str, Any], height: float) -> Picture:
    cells: Cells = found["worst"]
    by_level: dict[int, list[tuple[float, float, float, float]]] = {}
    for i, row in enumerate(cells):
        for level, start, stop in _runs(row):
            width, tall = SIDE / len(row), height / len(cells)
            by_level.setdefault(level, []).append((start * width, i * tall, (stop - start) * width, tall))
    share = found["share"]
    levels = tuple(Boxes(f"level{level}", tuple(by_level[level])) for level in sorted(by_level))
    return Picture(levels, "0" if not share else f"{100 * share:.2g}")


def _runs(row: Sequence[float | None]) -> list[tuple[int, int, int]]:
    """Neighbours of one level as one: level, first cell, cell after the last; cells without a sample are left out."""
    runs: list[tuple[int, int, int]] = []
    for j, value in enumerate(row):
        if value is None:
            continue
        level = _level(value)
        if runs and runs[-1][0] == level and runs[-1][2] == j:
            runs[-1] = (level, runs[-1][1], j + 1)
        else:
            runs.append((level, j, j + 1))
    return runs


def _level(ulps: float) -> int:
    if ulps < 0:
        return len(LEVELS) + 1
    return next((i for i, bound in enumerate(LEVELS) if ulps <= bound), len(LEVELS))


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
    return str(max(0, min(MOST, math.floor(-math.log10(max(ulps, 1.0) * FLOOR)))))


Records = Mapping[str, Mapping[str, Any]]
"""What was measured, by name of the study: error, speed, maps, extremes; a study may be missing."""
DRAWN: Mapping[str, Callable[[Mapping[str, Any], frozenset[str]], Any]] = {
    "error": error_panels,
    "speed": speed,
    "maps": error_maps,
    "extremes": lambda record, _: extremes(record),
}


def figures(records: Records, keys: frozenset[str]) -> dict[str, Any]:
    """What the template of the studies draws; `keys` are those that the book prints and a panel may refer to."""
    return {name: drawn(records[name], keys) if name in records else None for name, drawn in DRAWN.items()}
