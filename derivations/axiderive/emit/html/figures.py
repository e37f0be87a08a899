"""The plots of a page, from the coordinates that the book prints."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from .drawing import Figure, Scale, pairs

FRAME = (400.0, 268.0)
INNER = (46.0, 28.0, 346.0, 200.0)
"""Left, top, width and height of the axes in the frame."""


def _axes(
    caption: tuple[str, str], x: tuple[float, float], y: tuple[float, float], names: tuple[str, str]
) -> tuple[Figure, Scale]:
    figure = Figure(*FRAME, caption, INNER)
    left, top, width, height = INNER
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


def _curve(figure: Figure, scale: Scale, kind: str, coordinates: str) -> None:
    figure.curve(kind, scale.points(pairs(coordinates)))


def _reference(figure: Figure, scale: Scale, curve: Any) -> None:
    _curve(figure, scale, "reference", curve.coordinates)
    figure.label(curve.label, scale.at(curve.x, curve.y), SIDES[curve.anchor], "note", plain=True)


def _family(figure: Figure, scale: Scale, curves: Sequence[Any]) -> None:
    """The curves of one quantity, lighter to darker."""
    for i, curve in enumerate(curves):
        tone = f"curve tone{i if len(curves) > 1 else 3}"
        _curve(figure, scale, tone, curve.coordinates)
        if curve.label:
            figure.label(curve.label, scale.at(curve.x, curve.y), SIDES[curve.anchor], tone.replace("curve", "accent"))


SIDES = {"south": "above", "north": "below", "center": "middle", "east": "right", "west": "left"}
"""Where a label lies whose side, or center, of that name touches the curve."""


def pressure(plots: Any) -> Figure:
    """Pressure over its mean against sphere and flat punch."""
    figure, scale = _axes(("Pressure", plots.pressure_caption), (0, 1), (0, 3.2), (f"{plots.abscissa}/a", r"p/\bar p"))
    _ticks(figure, scale, (0, 0.25, 0.5, 0.75), (0, 1, 2, 3), (0, 0))
    for curve in plots.references:
        _reference(figure, scale, curve)
    _family(figure, scale, plots.pressure)
    return figure


def force(plots: Any) -> Figure:
    """Force over depth, both over those of a reference contact."""
    plane = plots.abscissa == "x"
    unit = "P_1" if plane else "F_1"
    figure, scale = _axes(("Force and depth", plots.force_caption), (0, 2), (0, 3.2), ("d/d_1", f"{plots.load}/{unit}"))
    _ticks(figure, scale, (0, 0.5, 1, 1.5), (0, 1, 2, 3), (0, 0))
    for curve in plots.force_references:
        _reference(figure, scale, curve)
    _curve(figure, scale, "load", plots.force.coordinates)
    return figure


def adhesion(curves: Any) -> Figure:
    """Force over depth with adhesion: stable, stable under depth control only, unstable."""
    found = curves.adhesion
    words = (
        rf"$\Delta\gamma$ such that $F_{{\mathrm c}}=-{found.pull}\,F_1$; grey: $\Delta\gamma=0$. "
        "Dashed: stable under depth control only; dotted: unstable"
    )
    figure, scale = _axes(("Adhesion", words), (-0.9, 2), (-1, 3.2), ("d/d_1", "F/F_1"))
    _ticks(figure, scale, (0, 1), (-1, 0, 1, 2, 3), (-0.9, -1))
    figure.line("reference", scale.at(-0.9, 0), scale.at(2, 0))
    _curve(figure, scale, "reference", found.without)
    _curve(figure, scale, "load", found.stable)
    _curve(figure, scale, "load dashed", found.grips)
    _curve(figure, scale, "load dotted", found.unstable)
    points = ((r"F_{\mathrm c}", found.force, "below-left"), (r"d_{\mathrm m}", found.depth, "right"))
    for name, place, side in points:
        x, y = scale.at(*place)
        figure.add("circle", "dot", cx=x, cy=y, r=2.6)
        figure.label(name, (x, y), side, "accent")
    return figure


def slip(curves: Any) -> Figure:
    """Tangential force over displacement from full stick to full slip."""
    figure, scale = _axes(
        ("Partial slip", r"from full stick to full slip at $u_{\mathrm s}$"), (0, 1.25), (0, 1.25),
        (r"u/u_{\mathrm s}", r"F_x/(\mu F_{\mathrm N})"),
    )  # fmt: skip
    _ticks(figure, scale, (0, 0.5, 1), (0, 0.5, 1), (0, 0))
    _reference(figure, scale, curves.sphere)
    _curve(figure, scale, "curve tone3", curves.slip)
    _curve(figure, scale, "curve tone3", "(1,1) (1.25,1)")
    return figure


def given(axes: Any) -> Figure:
    """A frame of a prescribed pressure or of the eccentric punch."""
    names = (axes.names[0].strip("$"), axes.names[1].strip("$"))
    figure, scale = _axes((axes.title, axes.words), axes.x, axes.y, names)
    _ticks(figure, scale, axes.ticks[0][:-1], axes.ticks[1], (axes.x[0], axes.y[0]))
    _family(figure, scale, axes.curves)
    return figure


def figures(model: Mapping[str, Any]) -> dict[str, list[Figure]]:
    """The plots of a page by the system they stand with, in the order of the book."""
    found: list[Figure] = []
    if model.get("plots"):
        found += [pressure(model["plots"]), force(model["plots"])]
    if model.get("curves"):
        found += [adhesion(model["curves"]), slip(model["curves"])]
    found += [given(axes) for axes in model["axes"]]
    graded = [given(axes) for axes in model["graded"]]
    for figure in (*found, *graded):
        figure.anchor = "plot." + figure.caption[0].lower().replace(" ", "-")
    return {model["first"]: found, "graded.normal": graded}
