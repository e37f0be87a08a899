"""Stability maps: the printed formula through NumPy beside the emitted function, as heat maps of a few levels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...figures.drawing import Boxes, Drawing
from .error import captioned, referred

SIDE = 21.5
"""Millimetres of a map of two ratios, and of the width of one."""
STRIP = 3.0
LEVELS = (5.0, 1e3, 1e6, 1e9, 1e12)
"""Errors in ulps up to which a cell has the colour of its level; beyond them there is one more, and one for NaN."""
NAMES = ("5", "10^{3}", "10^{6}", "10^{9}", "10^{12}")

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
class Figure:
    """All maps of the study, those of one ratio and those of two, with the words for each level."""

    plain: tuple[Map, ...]
    """Maps of one ratio."""
    square: tuple[Map, ...]
    legend: tuple[str, ...]


def drawing(one: Map, *, printed: bool) -> Drawing:
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


def figure(record: Mapping[str, Any], keys: frozenset[str]) -> Figure:
    """The maps of the record, those of one ratio and those of two."""
    found = [_map(one, keys) for one in record["maps"]]
    words = [rf"$\le {name}$" for name in NAMES] + ["more", "NaN or infinite"]
    return Figure(
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
