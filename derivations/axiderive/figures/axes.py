"""A frame of a figure as data: axes, curves, what they are compared with, and where the labels stand."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from .labels import HIGHEST, TALL, Curve, Rows, coordinates, labelled

LOW_TALL = TALL * 40 / 27
"""Height of a label in a frame of 27 mm instead of 40 mm."""
Span = tuple[float, float]
Shown = tuple[Rows, str]
"""A curve and its label."""


@dataclass(frozen=True)
class Mark:
    """A point on a curve that has a name, and the side of the name that lies at the point."""

    x: float
    y: float
    label: str
    anchor: str = "north west"


@dataclass(frozen=True)
class Axes:
    """One frame: names, ends and ticks of its axes, the curves and what stands below it."""

    names: tuple[str, str]
    x: Span
    y: Span
    ticks: tuple[tuple[float, ...], tuple[float, ...]]
    curves: tuple[Curve, ...]
    title: str
    words: str
    references: tuple[Curve, ...] = ()
    """What the curves are compared with; their labels are words."""
    marks: tuple[Mark, ...] = ()
    logarithmic: tuple[bool, bool] = (False, False)


def axes(
    names: tuple[str, str],
    x: Span,
    y: Span,
    family: Sequence[Shown],
    words: tuple[str, str],
    references: Sequence[Shown] = (),
    marks: tuple[Mark, ...] = (),
    logarithmic: tuple[bool, bool] = (False, False),
) -> Axes:
    """A frame with its labels where the curves leave most room."""
    across, up = _scale(x, logarithmic[0]), _scale(y, logarithmic[1])
    drawn = [*family, *references]
    scaled = [[(across(u), HIGHEST * up(v)) for u, v in rows] for rows, _ in drawn]
    placed = [_beside(mark, across(mark.x), HIGHEST * up(mark.y)) for mark in marks]
    for i, (rows, label) in enumerate(drawn):
        at = labelled(scaled, i, label, placed, LOW_TALL) if label else Curve("", "", 0.0, 0.0)
        placed.append(replace(at, coordinates=coordinates(rows)))
    back = (_inverse(x, logarithmic[0]), _inverse(y, logarithmic[1]))
    placed = placed[len(marks) :]
    shown = [replace(c, x=back[0](c.x), y=back[1](c.y / HIGHEST)) if c.label else c for c in placed]
    ticks = (_ticks(x, logarithmic[0], 4), _ticks(y, logarithmic[1], 3.5))
    return Axes(
        names, x, y, ticks, tuple(shown[: len(family)]), *words, tuple(shown[len(family) :]), marks, logarithmic
    )


def _beside(mark: Mark, x: float, y: float) -> Curve:
    """The name of a mark, as one of the labels that others give way to."""
    name = "mark" if "_" in mark.label else mark.label
    return Curve("", name, x + 0.01 * len(name), y - LOW_TALL / 2, "center")


def _scale(ends: Span, logarithmic: bool) -> Callable[[float], float]:
    """From a value to the share of the axis below it."""
    low, high = map(math.log10, ends) if logarithmic else ends
    return lambda value: ((math.log10(value) if logarithmic else value) - low) / (high - low)


def _inverse(ends: Span, logarithmic: bool) -> Callable[[float], float]:
    low, high = map(math.log10, ends) if logarithmic else ends

    def value(share: float) -> float:
        at = low + share * (high - low)
        return float(f"{10**at if logarithmic else at:.4g}")

    return value


def _ticks(ends: Span, logarithmic: bool, most: float) -> tuple[float, ...]:
    """Round numbers from one end to the other: at most so many steps."""
    if logarithmic:
        low, high = math.ceil(math.log10(ends[0]) - 1e-9), math.floor(math.log10(ends[1]) + 1e-9)
        step = math.ceil((high - low) / most) or 1
        return tuple(float(f"1e{power}") for power in range(low, high + 1, step))
    wide = next(s for s in (0.25, 0.5, 1.0, 2.0, 4.0, 5.0, 10.0) if (ends[1] - ends[0]) / s <= most + 1e-9)
    first = math.ceil(ends[0] / wide - 1e-9)
    return tuple(wide * i for i in range(first, math.floor(ends[1] / wide + 1e-9) + 1))
