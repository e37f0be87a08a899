"""Figures as shapes of SVG, with their words as HTML over them, for the templates of the web edition."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .drawing import Boxes, Dot, Drawing, Line, Point, Window, Words

Shape = tuple[str, str, dict[str, str]]
"""Element, class and attributes."""
HEAD = 11.0
"""Length of an arrow head in units of SVG; that of a short line is half of the line."""
DOT = 3.0
SIDES = {
    "center": "middle", "south": "above", "north": "below", "east": "right", "west": "left",
    "north west": "below-left", "north east": "below-right", "south west": "above-left", "south east": "above-right",
    "base west": "above-left",
}  # fmt: skip
"""Class of words whose side of that name lies at their place."""


@dataclass(frozen=True)
class Label:
    """Words at a place in percent of the figure, and their classes."""

    text: str
    left: float
    top: float
    kind: str


@dataclass(frozen=True)
class Picture:
    """A figure for the templates; `curves` are class, name and points in the units of the axes."""

    drawing: Drawing
    width: float
    height: float
    below: list[Shape]
    above: list[Shape]
    curves: list[tuple[str, str, str]]
    frame: dict[str, str]
    """Place and view of the window."""
    labels: list[Label]


def svg(drawing: Drawing, unit: float = 1.0) -> Picture:
    """The figure with so many units of SVG to one of its own, y downwards from its upper left corner."""
    scale = Scale(drawing.low[0], drawing.high[1], unit)
    width, height = unit * (drawing.high[0] - drawing.low[0]), unit * (drawing.high[1] - drawing.low[1])
    below = [_boxes(boxes, scale) for boxes in drawing.boxes]
    below += [shape for line in drawing.lines for shape in _shapes(line, scale)]
    window = drawing.window
    return Picture(
        drawing,
        round(width, 1),
        round(height, 1),
        below,
        [_dot(one, scale) for one in drawing.dots],
        [(one.look, one.name, _pairs(one.points, 5)) for one in window.traces] if window else [],
        _frame(window, scale) if window else {},
        [_label(one, scale, width, height) for one in drawing.words],
    )


@dataclass(frozen=True)
class Scale:
    """From the units of a figure to those of the SVG, whose y points down."""

    left: float
    high: float
    unit: float

    def at(self, point: Point) -> Point:
        """The place of a point in units of the SVG, to one decimal."""
        return round(self.unit * (point[0] - self.left), 1), round(self.unit * (self.high - point[1]), 1)


def _boxes(boxes: Boxes, scale: Scale) -> Shape:
    """All as one path."""
    parts = []
    for left, low, wide, tall in boxes.corners:
        (x1, y1), (x2, y2) = scale.at((left, low)), scale.at((left + wide, low + tall))
        parts.append(f"M{x1:g} {y1:g}H{x2:g}V{y2:g}H{x1:g}z")
    return "path", boxes.look, {"d": "".join(parts)}


def _shapes(line: Line, scale: Scale) -> list[Shape]:
    points = [scale.at(point) for point in line.points]
    element = "polygon" if line.closed else "polyline"
    found: list[Shape] = [(element, line.look, {"points": _pairs(points, 6)})]
    for way in [points, points[::-1]][: line.heads]:
        found.append(("polygon", f"head {line.look}", {"points": _head(way[-2], way[-1])}))
    return found


def _head(before: Point, tip: Point) -> str:
    (x1, y1), (x2, y2) = before, tip
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5 or 1.0
    u, v, size = (x2 - x1) / length, (y2 - y1) / length, min(HEAD, length / 2)
    corners = [(x2 - size * u + s * size * 0.35 * v, y2 - size * v - s * size * 0.35 * u) for s in (1, -1)]
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in (tip, *corners))


def _dot(dot: Dot, scale: Scale) -> Shape:
    x, y = scale.at(dot.place)
    return "circle", dot.look, {"cx": f"{x:g}", "cy": f"{y:g}", "r": f"{DOT:g}"}


def _label(words: Words, scale: Scale, width: float, height: float) -> Label:
    x, y = scale.at(words.place)
    kind = f"{SIDES[words.side]} {words.look}".strip()
    return Label(words.text, round(100 * x / width, 2), round(100 * y / height, 2), kind)


def _frame(window: Window, scale: Scale) -> dict[str, str]:
    x, y = scale.at((window.left, window.low + window.height))
    (left, right), (low, high) = window.x, window.y
    place = {"x": x, "y": y, "width": scale.unit * window.width, "height": scale.unit * window.height}
    view = f"{left:g} {-high:g} {right - left:g} {high - low:g}"
    return {name: f"{value:g}" for name, value in place.items()} | {"viewBox": view}


def _pairs(points: Sequence[Point], digits: int) -> str:
    return " ".join(f"{x:.{digits}g},{y:.{digits}g}" for x, y in points)
