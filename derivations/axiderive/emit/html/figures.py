"""The plots of a page, from the coordinates that the book prints."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from .drawing import Figure, Scale, Window, pairs
from .words import symbol

FRAME = (400.0, 268.0)
INNER = (46.0, 28.0, 346.0, 200.0)
"""Left, top, width and height of the axes in the frame."""


def _axes(
    caption: tuple[str, str],
    x: tuple[float, float],
    y: tuple[float, float],
    names: tuple[str, str],
    logarithmic: tuple[bool, bool] = (False, False),
) -> tuple[Figure, Scale]:
    left, top, width, height = INNER
    across, up = map(symbol, names)
    window = Window(*INNER, x, y, (across, up), logarithmic)
    figure = Figure(*FRAME, caption, f"Plot of {up} over {across}", window)
    unit_x, unit_y = width / (x[1] - x[0]), height / (y[1] - y[0])
    scale = Scale(left - x[0] * unit_x, top + height + y[0] * unit_y, unit_x, unit_y)
    figure.line("axis", scale.at(x[0], y[0]), scale.at(x[1], y[0]))
    figure.line("axis", scale.at(x[0], y[0]), scale.at(x[0], y[1]))
    figure.label(names[0], (left + width, FRAME[1]), "above-right")
    figure.label(names[1], (8, 2), "below-left")
    return figure, scale


def _ticks(
    figure: Figure, scale: Scale, along_x: Iterable[float], along_y: Iterable[float], corner: tuple[float, float]
) -> None:
    for value in along_x:
        x, y = scale.at(value, corner[1])
        figure.line("axis", (x, y), (x, y + 4))
        figure.label(f"{value:g}".replace("-", "−"), (x, y + 13), plain=True)
    for value in along_y:
        x, y = scale.at(corner[0], value)
        figure.line("axis", (x - 4, y), (x, y))
        figure.label(f"{value:g}".replace("-", "−"), (x - 13, y), plain=True)


SIDES = {
    "south": "above", "north": "below", "center": "middle", "east": "right", "west": "left",
    "north west": "below-left",
}  # fmt: skip
"""Where a label lies whose side, or center, of that name touches the curve."""


def adhesion(curves: Any) -> Figure:
    """Force over depth with adhesion: stable, stable under depth control only, unstable."""
    found = curves.adhesion
    figure, scale = _axes(("Adhesion", found.words), (-0.9, 2), (-1, 3.2), ("d/d_1", r"F_{\mathrm N}/F_1"))
    _ticks(figure, scale, (0, 1), (-1, 0, 1, 2, 3), (-0.9, -1))
    figure.line("reference", scale.at(-0.9, 0), scale.at(2, 0))
    figure.curve("reference", "without adhesion", pairs(found.without))
    figure.curve("load", "stable", pairs(found.stable))
    figure.curve("load dashed", "stable under given depth only", pairs(found.grips))
    figure.curve("load dotted", "unstable", pairs(found.unstable))
    points = ((r"F_{\mathrm c}", found.force, "below-left"), (r"d_{\mathrm m}", found.depth, "right"))
    for name, place, side in points:
        x, y = scale.at(*place)
        figure.add("circle", "dot", cx=x, cy=y, r=2.6)
        figure.label(name, (x, y), side, "accent")
    return figure


def slip(curves: Any) -> Figure:
    """Tangential force over displacement from full stick to full slip."""
    figure, scale = _axes(
        ("Partial slip", r"the contact sticks in its middle until it slides as a whole at $u_{\mathrm s}$."),
        (0, 1.25), (0, 1.25), (r"u/u_{\mathrm s}", r"F_x/(\mu F_{\mathrm N})"),
    )  # fmt: skip
    _ticks(figure, scale, (0, 0.5, 1), (0, 0.5, 1), (0, 0))
    sphere = curves.sphere
    figure.curve("reference", sphere.label, pairs(sphere.coordinates))
    figure.label(sphere.label, scale.at(sphere.x, sphere.y), SIDES[sphere.anchor], "note", plain=True)
    figure.curve("curve tone3", "partial slip", pairs(curves.slip))
    figure.curve("curve tone3", "full slip", [(1, 1), (1.25, 1)])
    return figure


def drawn(axes: Any) -> Figure:
    """A frame of the book."""
    across, up = (math.log10 if logarithmic else float for logarithmic in axes.logarithmic)
    x, y = (across(axes.x[0]), across(axes.x[1])), (up(axes.y[0]), up(axes.y[1]))
    names = axes.names[0].strip("$"), axes.names[1].strip("$")
    figure, scale = _axes((axes.title, axes.words), x, y, names, axes.logarithmic)

    def at(u: float, v: float) -> tuple[float, float]:
        return scale.at(across(u), up(v))

    def points(text: str) -> list[tuple[float, float]]:
        return [(across(u), up(v)) for u, v in pairs(text)]

    for value in axes.ticks[0][:-1]:
        left, top = at(value, axes.y[0])
        figure.line("axis", (left, top), (left, top + 4))
        _number(figure, value, (left, top + 13))
    for value in axes.ticks[1]:
        left, top = at(axes.x[0], value)
        figure.line("axis", (left - 4, top), (left, top))
        _number(figure, value, (left - 13, top))
    for curve in axes.references:
        figure.curve("reference", curve.label, points(curve.coordinates))
        figure.label(curve.label, at(curve.x, curve.y), SIDES[curve.anchor], "note", plain=True)
    for i, curve in enumerate(axes.curves):
        tone = f"curve tone{i if len(axes.curves) > 1 else 3}"
        figure.curve(tone, symbol(curve.label) or symbol(names[1]), points(curve.coordinates))
        if curve.label:
            figure.label(curve.label, at(curve.x, curve.y), SIDES[curve.anchor], tone.replace("curve", "accent"))
    for mark in axes.marks:
        left, top = at(mark.x, mark.y)
        figure.add("circle", "dot", cx=left, cy=top, r=2.6)
        figure.label(mark.label, (left + 4, top), SIDES[mark.anchor])
    return figure


def _number(figure: Figure, value: float, place: tuple[float, float]) -> None:
    """A number at a tick; a power of ten as one."""
    text = f"{value:g}".replace("-", "−")
    power = round(math.log10(value)) if value > 0 else 0
    if abs(power) > 1 and value == float(f"1e{power}"):
        figure.label(f"10^{{{power}}}", place)
    else:
        figure.label(text, place, plain=True)


def figures(model: Mapping[str, Any]) -> dict[str, list[Figure]]:
    """The plots of a page by the system they stand with, in the order of the book."""
    found: list[Figure] = []
    found += [drawn(axes) for axes in model["plots"]]
    if model.get("curves"):
        found += [adhesion(model["curves"]), slip(model["curves"])]
    found += [drawn(axes) for axes in model["axes"]]
    graded = [drawn(axes) for axes in model["graded"]]
    for figure in (*found, *graded):
        figure.anchor = "plot." + figure.caption[0].lower().replace(" ", "-")
        named = ", ".join(dict.fromkeys(name for _, name, _ in figure.curves))
        figure.seen += f"; curves: {named}" if len(figure.curves) > 1 else ""
    return {model["first"]: found, "graded.normal": graded}
