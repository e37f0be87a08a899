"""The sketch of a page, as the book draws it: a contact to scale, a prescribed pressure, a punch that tilts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .drawing import Figure, Pairs, Scale, pairs
from .words import symbol

WIDE, HIGH, LOW = 4.75, 1.66, -2.16
UNIT = 84.0
"""SVG units to one unit of the sketch."""


def sketch(model: Mapping[str, Any]) -> Figure | None:
    """The picture a page opens with, from the exact deflected surface; None for a page without one."""
    if model["picture"]:
        return _contact(model["picture"], model)
    if model["load_picture"]:
        return _pressed(model["load_picture"])
    return _tilted(model["tilted_picture"], model) if model["tilted_picture"] else None


def thumbnail(shape: Mapping[str, str]) -> Figure:
    """The outline that the front of the book draws of a profile or a pressure, over the surface at rest."""
    figure, scale = Figure(180, 54), Scale(90, 24, 20, 20)
    figure.line("thin", scale.at(-4.5, 0), scale.at(4.5, 0))
    for kind, element in (("body", "polygon"), ("pressure", "polygon"), ("contact", "polyline")):
        if kind in shape:
            figure.add(element, kind, points=scale.points(pairs(shape[kind])))
    return figure


def _frame(words: str, seen: str) -> tuple[Figure, Scale]:
    figure = Figure(
        2 * WIDE * UNIT, (HIGH - LOW) * UNIT, ("Sketch", words), f"Section through the {seen}", anchor="sketch"
    )
    return figure, Scale(WIDE * UNIT, HIGH * UNIT, UNIT, UNIT)


def _contact(picture: Any, model: Mapping[str, Any]) -> Figure:
    lengths = [one.name for one in (*picture.dimensions, *picture.heights, *picture.radii)]
    drawn = ", ".join(map(symbol, ["d", *lengths, *([r"\theta"] if picture.angle else []), "w"]))
    figure, scale = _frame(
        "to scale, at the parameters of the check values",
        f"contact: the rigid body, pressed by {symbol(model['load'])}, and the deformed surface; marked are {drawn}",
    )
    left, contact, right = pairs(picture.surface_left), pairs(picture.contact), pairs(picture.surface)
    ground = [(-4.7, LOW), (-4.7, left[0][1]), *left, *contact, *right, (4.7, LOW)]
    _body(figure, scale, ground, picture)
    figure.line("dashed thin", scale.at(0, 0.66), scale.at(0, LOW))
    _arrow(figure, scale, (0, 1.62), (0, 0.7))
    figure.label(model["load"], scale.at(0.12, 1.45), "left")
    figure.line("thin", scale.at(0, -picture.depth), scale.at(-4.1, -picture.depth))
    figure.line("thin", scale.at(-3.95, 0), scale.at(-3.95, -picture.depth))
    figure.label("d", scale.at(-4.02, -picture.depth / 2), "right")
    for dimension in picture.dimensions:
        _dimension(figure, scale, dimension.name, (dimension.at, dimension.start), dimension.level, dimension.begin)
    for height in picture.heights:
        figure.line("thin", scale.at(height.end, height.low), scale.at(height.x, height.low))
        figure.line("thin", scale.at(0, height.high), scale.at(height.x, height.high))
        figure.line("thin", scale.at(height.x, height.low), scale.at(height.x, height.high))
        figure.label(height.name, scale.at(height.x - 0.06, (height.low + height.high) / 2), "right")
    for radius in picture.radii:
        _arrow(figure, scale, (radius.tail_x, radius.tail_y), (radius.x, radius.y))
        figure.label(radius.name, scale.at(radius.tail_x + 0.05, radius.tail_y), "left")
    if picture.angle:
        figure.line(
            "thin", scale.at(picture.angle.x, picture.angle.y), scale.at(picture.angle.x + 1.55, picture.angle.y)
        )
        figure.label(r"\theta", scale.at(picture.angle.x + 1.3, picture.angle.y + 0.2))
    _displacement(figure, scale, picture)
    _coordinates(figure, scale, model["place"])
    return figure


def _pressed(picture: Any) -> Figure:
    """A prescribed pressure over the surface it makes."""
    figure, scale = _frame(
        "the pressure, and the surface it makes, to the scale of its deepest point",
        "loaded surface: arrows of the pressure p(r) on the circle of radius a, and the dent they make",
    )
    surface = pairs(picture.surface)
    figure.add("polygon", "ground", points=scale.points([(-4.7, LOW), *surface, (4.7, LOW)]))
    figure.add("polyline", "surface", points=scale.points(surface))
    figure.add("polygon", "pressure", points=scale.points(pairs(picture.pressure)))
    for x, top in picture.arrows:
        _arrow(figure, scale, (x, top), (x, picture.base), "pressing")
    figure.line("dashed thin", scale.at(-4.7, 0), scale.at(4.7, 0))
    figure.line("dashed thin", scale.at(0, 0), scale.at(0, LOW))
    _dimension(figure, scale, "a", (picture.radius, 0.0), -1.8)
    figure.label("p(r)", scale.at(picture.radius + 0.1, 0.6), "left", "accent")
    _coordinates(figure, scale, "r")
    return figure


def _tilted(picture: Any, model: Mapping[str, Any]) -> Figure:
    """A punch under an eccentric load."""
    figure, scale = _frame(
        "to scale, with both edges in contact",
        f"contact: the flat body, tilted by φ under {symbol(model['load'])} at the distance e from its middle",
    )
    _body(figure, scale, [(-4.7, LOW), *pairs(picture.surface_left), *pairs(picture.surface), (4.7, LOW)], picture)
    figure.line("dashed thin", scale.at(0, 1.4), scale.at(0, LOW))
    _arrow(figure, scale, (picture.load, 1.62), (picture.load, picture.top))
    figure.label(model["load"], scale.at(picture.load + 0.12, 1.45), "left")
    figure.line("thin", scale.at(0, 1.22), scale.at(picture.load, 1.22))
    figure.label("e", scale.at(picture.load / 2, 1.26), "above")
    _dimension(figure, scale, "a", (picture.radius, picture.edge), -1.78)
    left = -picture.radius
    figure.line("thin", scale.at(left, picture.corner), scale.at(left + 1.6, picture.corner))
    figure.label(r"\varphi", scale.at(left + 1.66, picture.corner - 0.03), "left")
    _displacement(figure, scale, picture)
    _coordinates(figure, scale, model["place"])
    return figure


def _body(figure: Figure, scale: Scale, ground: Pairs, picture: Any) -> None:
    figure.add("polygon", "ground", points=scale.points(ground))
    figure.add("polygon", "body", points=scale.points(pairs(picture.body)))
    figure.add("polyline", "surface", points=scale.points(pairs(picture.surface)))
    figure.add("polyline", "surface", points=scale.points(pairs(picture.surface_left)))
    figure.add("polyline", "contact", points=scale.points(pairs(picture.contact)))
    figure.line("dashed thin", scale.at(-4.7, 0), scale.at(4.7, 0))


def _dimension(
    figure: Figure, scale: Scale, name: str, end: tuple[float, float], level: float, begin: float = 0.0
) -> None:
    """A length from the axis, or from another place, to a point of the picture."""
    figure.line("thin", scale.at(*end), scale.at(end[0], level - 0.1))
    if begin:
        figure.line("thin", scale.at(begin, end[1]), scale.at(begin, level - 0.1))
    figure.line("thin", scale.at(begin, level), scale.at(end[0], level))
    figure.label(name, scale.at((begin + end[0]) / 2, level), kind="length")


def _displacement(figure: Figure, scale: Scale, picture: Any) -> None:
    _arrow(figure, scale, (picture.arrow, 0), (picture.arrow, picture.arrow_end))
    figure.label("w", scale.at(picture.arrow + 0.05, 0.02), "above-left")


def _coordinates(figure: Figure, scale: Scale, place: str) -> None:
    _arrow(figure, scale, (3.7, -1.35), (4.3, -1.35))
    _arrow(figure, scale, (3.7, -1.35), (3.7, -1.95))
    figure.label(place, scale.at(4.35, -1.35), "left")
    figure.label("z", scale.at(3.64, -1.85), "right")


def _arrow(figure: Figure, scale: Scale, start: tuple[float, float], end: tuple[float, float], kind: str = "") -> None:
    """A line with a head, which shrinks with a short line."""
    (x1, y1), (x2, y2) = scale.at(*start), scale.at(*end)
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    if length < 2:
        return
    u, v, size = (x2 - x1) / length, (y2 - y1) / length, min(11.0, length / 2)
    figure.line(f"arrow {kind}".strip(), (x1, y1), (x2, y2))
    corners = [(x2, y2)] + [(x2 - size * u + s * size * 0.35 * v, y2 - size * v - s * size * 0.35 * u) for s in (1, -1)]
    figure.add("polygon", f"head {kind}".strip(), points=" ".join(f"{x:.1f},{y:.1f}" for x, y in corners))
