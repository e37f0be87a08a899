"""A plot as data: axes, curves, what they are compared with, and where the labels stand; and as a drawing."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from .drawing import Drawing, Point, Rows, Trace, Window
from .labels import HIGHEST, TALL, Curve, labelled, rounded

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
    look: str = "ink"


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
        at = labelled(scaled, i, label, placed, LOW_TALL) if label else Curve([], "", 0.0, 0.0)
        placed.append(replace(at, rows=rounded(rows)))
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
    return Curve([], name, x + 0.01 * len(name), y - LOW_TALL / 2, "center")


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


@dataclass(frozen=True)
class Layout:
    """Where the parts of a plot stand around its frame, in units of the drawing."""

    width: float
    height: float
    left: float
    right: float
    below: float
    above: float
    tick: float
    """Length of a tick, beyond which its number stands."""
    across: tuple[Point, str]
    """Place of the name of the horizontal axis from the lower right corner, and the side of it that lies there."""
    up: tuple[Point, str] | None
    """That of the vertical axis from the upper left corner; without one it reads upwards beside its numbers."""


def printed(axes: Axes, height: float) -> Layout:
    """In millimetres: all frames of the book end at the same distance from the right."""
    width = 64.0 if axes.logarithmic[1] else 67.0
    return Layout(width, height, 79.9 - width, 0.1, 11.2, 1.0, 0.78, ((-width / 2, -4.9), "north"), None)


SCREEN = Layout(346.0, 200.0, 46.0, 8.0, 40.0, 28.0, 4.0, ((0.0, -40.0), "south east"), ((-38.0, 26.0), "north west"))
"""Of the web edition, in units of SVG."""
TONES = 4
"""Shades from the first curve of a family to its last."""
LETTER = {".": 0.75, "-": 2.1}
"""Widths of the letters of a number in print, in millimetres; a digit has 1.4."""


def drawn(axes: Axes, layout: Layout) -> Drawing:
    """The plot with its frame in the lower left corner at (0, 0)."""
    low, high = (-layout.left, -layout.below), (layout.width + layout.right, layout.height + layout.above)
    figure = Drawing("plot", low, high, (axes.title, axes.words), f"Plot of {axes.names[1]} over {axes.names[0]}")
    figure.anchor = f"plot.{axes.title.lower().replace(' ', '-')}"
    unit = tuple(math.log10 if logarithmic else float for logarithmic in axes.logarithmic)
    ends = [(own(low), own(high)) for own, (low, high) in zip(unit, (axes.x, axes.y), strict=True)]
    window = Window(0.0, 0.0, layout.width, layout.height, ends[0], ends[1], axes.names, axes.logarithmic)

    def at(x: float, y: float) -> Point:
        return window.place((unit[0](x), unit[1](y)))

    figure.line("axis", (layout.width, 0.0), (0.0, 0.0), (0.0, layout.height))
    _numbered(figure, axes, layout, at)
    curves = [("reference", curve) for curve in axes.references]
    curves += [(curve.look or _shade(i, len(axes.curves)), curve) for i, curve in enumerate(axes.curves)]
    traces = []
    for look, curve in curves:
        text = curve.label if look == "reference" else f"${curve.label}$"
        if curve.label:
            tone = "note" if look == "reference" else look.replace("curve", "accent")
            figure.label(text, at(curve.x, curve.y), curve.anchor, f"on {tone}")
        points = tuple((unit[0](x), unit[1](y)) for x, y in curve.rows)
        traces.append(Trace(look, curve.name or (text if curve.label else axes.names[1]), points))
    for mark in axes.marks:
        figure.dot(f"dot {mark.look}", at(mark.x, mark.y))
        figure.label(f"${mark.label}$", at(mark.x, mark.y), mark.anchor, f"beside {mark.look}")
    figure.window = replace(window, traces=tuple(traces))
    named = ", ".join(dict.fromkeys(trace.name for trace in traces))
    figure.seen += f"; curves: {named}" if len(traces) > 1 else ""
    return figure


def _numbered(figure: Drawing, axes: Axes, layout: Layout, at: Callable[[float, float], Point]) -> None:
    """The ticks with their numbers, and the names of the axes."""
    (dx, dy), side = layout.across
    widest = 0.0
    for value in axes.ticks[0]:
        x, _ = at(value, axes.y[0])
        figure.line("tick", (x, 0.0), (x, -layout.tick))
        if x < layout.width or layout.up is None:  # the name of the axis stands in the corner
            figure.label(_number(value), (x, -layout.tick), "north", "tick")
    for value in axes.ticks[1]:
        _, y = at(axes.x[0], value)
        figure.line("tick", (0.0, y), (-layout.tick, y))
        figure.label(_number(value), (-layout.tick, y), "east", "tick")
        widest = max(widest, 3.6 if "^" in _number(value) else sum(LETTER.get(c, 1.4) for c in f"{value:g}"))
    figure.label(axes.names[0], (layout.width + dx, dy), side, "name")
    if layout.up is None:
        figure.label(axes.names[1], (-layout.tick - widest - 1.0, layout.height / 2), "south", "name", turned=True)
    else:
        (dx, dy), side = layout.up
        figure.label(axes.names[1], (dx, layout.height + dy), side, "name")


def _number(value: float) -> str:
    """A number at a tick; a power of ten as one."""
    power = round(math.log10(value)) if value > 0 else 0
    if abs(power) > 1 and value == float(f"1e{power}"):
        return f"$10^{{{power}}}$"
    return f"{value:g}".replace("-", "\N{MINUS SIGN}")


def _shade(index: int, count: int) -> str:
    """From light to dark over the curves of a family."""
    return f"curve tone{round(index * (TONES - 1) / (count - 1))}" if count > 1 else "curve"
