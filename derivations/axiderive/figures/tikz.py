"""Figures as pictures of TikZ, in millimetres; the preamble of the book has a style d/<look> for every look."""

from __future__ import annotations

from collections.abc import Sequence

from .drawing import Boxes, Drawing, Line, Point, Window, Words

TOLERANCE = 0.006
"""Millimetres by which a curve in print may miss its points: a sixth of the width of the thinnest line."""


def tikz(drawing: Drawing, unit: float = 1.0) -> str:
    """The picture, one shape on a line; a unit of the figure is so many millimetres."""
    (left, low), (right, high) = drawing.low, drawing.high
    rows = [
        rf"\begin{{tikzpicture}}[x={unit:g}mm,y={unit:g}mm,{drawing.kind}]",
        rf" \path[use as bounding box] {_point((left, low))} rectangle {_point((right, high))};",
        *(_boxes(boxes) for boxes in drawing.boxes),
        *(_line(line, unit) for line in drawing.lines),
        *(_traces(drawing.window, unit) if drawing.window else ()),
        *(rf" \path[{_style(dot.look)}] {_point(dot.place)} circle;" for dot in drawing.dots),
        *(_node(words) for words in drawing.words),
        r"\end{tikzpicture}",
    ]
    return "\n".join(rows)


def _boxes(boxes: Boxes) -> str:
    found = (f"{_point((x, y))} rectangle +{_point((wide, tall))}" for x, y, wide, tall in boxes.corners)
    return rf" \path[{_style(boxes.look)}] {' '.join(found)};"


def _line(line: Line, unit: float) -> str:
    heads = ("", "->,", "<->,")[line.heads]
    return rf" \path[{heads}{_style(line.look)}] {_path(line.points, unit)}{'--cycle' if line.closed else ''};"


def _traces(window: Window, unit: float) -> list[str]:
    corners = (window.left, window.low), (window.left + window.width, window.low + window.height)
    return [
        rf" \begin{{scope}}\clip {_point(corners[0])} rectangle {_point(corners[1])};",
        *(rf" \path[{_style(one.look)}] {_path([*map(window.place, one.points)], unit)};" for one in window.traces),
        r" \end{scope}",
    ]


def _node(words: Words) -> str:
    look = _style(words.look, "t/") if words.look else ""
    options = [f"anchor={words.side}", look, "rotate=90" if words.turned else ""]
    text = words.text.replace("\N{MINUS SIGN}", "$-$")
    return rf" \node[{','.join(filter(None, options))}] at {_point(words.place)} {{{text}}};"


def _style(look: str, folder: str = "d/") -> str:
    return ",".join(f"{folder}{name}" for name in look.split())


def _path(points: Sequence[Point], unit: float) -> str:
    return "--".join(map(_point, thinned(points, TOLERANCE / unit)))


def _point(point: Point) -> str:
    return "({},{})".format(*(f"{round(value, 3) + 0.0:g}" for value in point))


def thinned(points: Sequence[Point], tolerance: float) -> list[Point]:
    """The points without those that a line between their neighbours passes closer than the tolerance."""
    if len(points) < 3:
        return list(points)
    (x0, y0), (x1, y1) = points[0], points[-1]
    length = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5

    def distance(point: Point) -> float:
        dx, dy = point[0] - x0, point[1] - y0
        along = (dx * (x1 - x0) + dy * (y1 - y0)) / length if length else 0.0
        beyond = max(-along, along - length, 0.0)
        across = (dx * (y1 - y0) - dy * (x1 - x0)) / length if length else (dx * dx + dy * dy) ** 0.5
        return float((across * across + beyond * beyond) ** 0.5)

    far = max(range(1, len(points) - 1), key=lambda i: distance(points[i]))
    if distance(points[far]) <= tolerance:
        return [points[0], points[-1]]
    return thinned(points[: far + 1], tolerance)[:-1] + thinned(points[far:], tolerance)
