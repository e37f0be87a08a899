"""The sketch of a page: the contact to scale, as the book draws it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .drawing import Figure, Scale, pairs

WIDE, HIGH, LOW = 4.75, 1.66, -2.16
UNIT = 84.0
"""SVG units to one unit of the sketch."""


def sketch(picture: Any, model: Mapping[str, Any]) -> Figure:
    """The contact to scale, from the exact deflected surface."""
    figure = Figure(2 * WIDE * UNIT, (HIGH - LOW) * UNIT, ("Sketch", "to scale, at the parameters of the check values"))
    scale = Scale(WIDE * UNIT, HIGH * UNIT, UNIT, UNIT)
    left, contact, right = pairs(picture.surface_left), pairs(picture.contact), pairs(picture.surface)
    ground = [(-4.7, LOW), (-4.7, left[0][1]), *left, *contact, *right, (4.7, LOW)]
    figure.add("polygon", "ground", points=scale.points(ground))
    figure.add("polygon", "body", points=scale.points(pairs(picture.body)))
    figure.add("polyline", "surface", points=scale.points(right))
    figure.add("polyline", "surface", points=scale.points(left))
    figure.add("polyline", "contact", points=scale.points(contact))
    figure.line("dashed thin", scale.at(-4.7, 0), scale.at(4.7, 0))
    figure.line("dashed thin", scale.at(0, 0.66), scale.at(0, LOW))
    _arrow(figure, scale, (0, 1.62), (0, 0.7))
    figure.label(model["load"], scale.at(0.12, 1.45), "left")
    figure.line("thin", scale.at(0, -picture.depth), scale.at(-4.1, -picture.depth))
    figure.line("thin", scale.at(-3.95, 0), scale.at(-3.95, -picture.depth))
    figure.label("d", scale.at(-4.02, -picture.depth / 2), "right")
    for dimension in picture.dimensions:
        figure.line("thin", scale.at(dimension.at, dimension.start), scale.at(dimension.at, dimension.level - 0.1))
        figure.line("thin", scale.at(0, dimension.level), scale.at(dimension.at, dimension.level))
        figure.label(dimension.name, scale.at(dimension.at / 2, dimension.level + 0.04), "above")
    if picture.angle:
        figure.line(
            "thin", scale.at(picture.angle.x, picture.angle.y), scale.at(picture.angle.x + 1.55, picture.angle.y)
        )
        figure.label(r"\theta", scale.at(picture.angle.x + 1.3, picture.angle.y + 0.2))
    _arrow(figure, scale, (picture.arrow, 0), (picture.arrow, picture.arrow_end))
    figure.label("w", scale.at(picture.arrow + 0.05, 0.02), "above-left")
    _arrow(figure, scale, (3.7, -1.35), (4.3, -1.35))
    _arrow(figure, scale, (3.7, -1.35), (3.7, -1.95))
    figure.label(model["place"], scale.at(4.35, -1.35), "left")
    figure.label("z", scale.at(3.64, -1.85), "right")
    return figure


def _arrow(figure: Figure, scale: Scale, start: tuple[float, float], end: tuple[float, float]) -> None:
    """A line with a head, which shrinks with a short line."""
    (x1, y1), (x2, y2) = scale.at(*start), scale.at(*end)
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    if length < 2:
        return
    u, v, size = (x2 - x1) / length, (y2 - y1) / length, min(11.0, length / 2)
    figure.line("arrow", (x1, y1), (x2, y2))
    corners = [(x2, y2)] + [(x2 - size * u + s * size * 0.35 * v, y2 - size * v - s * size * 0.35 * u) for s in (1, -1)]
    figure.add("polygon", "head", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in corners))
