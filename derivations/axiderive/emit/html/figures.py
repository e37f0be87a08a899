"""Sketch and plots as SVG, from the coordinates that the book prints; formulas are laid over them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

Pairs = list[tuple[float, float]]
_PAIR = re.compile(r"\(([^,()]+),([^,()]+)\)")


def pairs(text: str) -> Pairs:
    """The numbers of `(x,y) (x,y) ...`."""
    return [(float(x), float(y)) for x, y in _PAIR.findall(text)]


@dataclass(frozen=True)
class Scale:
    """From the units of a figure to the SVG's; `tall` is the height of what is drawn in."""

    x0: float
    y0: float
    x: float
    y: float

    def at(self, x: float, y: float) -> tuple[float, float]:
        return round(self.x0 + self.x * x, 1), round(self.y0 - self.y * y, 1)

    def points(self, rows: Iterable[tuple[float, float]]) -> str:
        return " ".join("{:g},{:g}".format(*self.at(x, y)) for x, y in rows)


@dataclass(frozen=True)
class Label:
    """LaTeX or plain words at a place given in percent of the figure; `side` is the side of the words it hangs on."""

    text: str
    left: float
    top: float
    side: str = "middle"
    kind: str = ""
    plain: bool = False


@dataclass
class Figure:
    """Shapes as (element, class, attributes) and the labels over them."""

    width: float
    height: float
    caption: tuple[str, str]
    shapes: list[tuple[str, str, dict[str, str]]] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)

    def add(self, element: str, kind: str, **attributes: Any) -> None:
        self.shapes.append((element, kind, {name.rstrip("_"): f"{value}" for name, value in attributes.items()}))

    def line(self, kind: str, start: tuple[float, float], end: tuple[float, float]) -> None:
        (x1, y1), (x2, y2) = start, end
        self.add("line", kind, x1=x1, y1=y1, x2=x2, y2=y2)

    def label(self, text: str, place: tuple[float, float], side: str = "middle", kind: str = "", plain: bool = False) -> None:  # noqa: E501
        x, y = place
        left, top = round(100 * x / self.width, 2), round(100 * y / self.height, 2)
        self.labels.append(Label(text, left, top, side, kind, plain))


FRAME = (400.0, 268.0)
INNER = (46.0, 28.0, 346.0, 200.0)
"""Left, top, width and height of the axes in the frame."""


def _axes(caption: tuple[str, str], x: tuple[float, float], y: tuple[float, float], names: tuple[str, str]) -> tuple[Figure, Scale]:  # noqa: E501
    figure = Figure(*FRAME, caption)
    left, top, width, height = INNER
    unit_x, unit_y = width / (x[1] - x[0]), height / (y[1] - y[0])
    scale = Scale(left - x[0] * unit_x, top + height + y[0] * unit_y, unit_x, unit_y)
    figure.line("axis", scale.at(x[0], y[0]), scale.at(x[1], y[0]))
    figure.line("axis", scale.at(x[0], y[0]), scale.at(x[0], y[1]))
    figure.label(names[0], (left + width, FRAME[1]), "above-right")
    figure.label(names[1], (8, 2), "below-left")
    return figure, scale


def _ticks(figure: Figure, scale: Scale, along_x: Iterable[float], along_y: Iterable[float], corner: tuple[float, float]) -> None:  # noqa: E501
    for value in along_x:
        x, y = scale.at(value, corner[1])
        figure.line("axis", (x, y), (x, y + 4))
        figure.label(f"{value:g}".replace("-", "−"), (x, y + 13), plain=True)
    for value in along_y:
        x, y = scale.at(corner[0], value)
        figure.line("axis", (x - 4, y), (x, y))
        figure.label(f"{value:g}".replace("-", "−"), (x - 13, y), plain=True)


def _curve(figure: Figure, scale: Scale, kind: str, coordinates: str) -> None:
    figure.add("polyline", kind, points=scale.points(pairs(coordinates)))


def _side(above: bool) -> str:
    return "above" if above else "below"


def pressure(plots: Any) -> Figure:
    """Pressure over its mean against sphere and flat punch."""
    figure, scale = _axes(
        ("Pressure", plots.pressure_caption), (0, 1), (0, 3.2), (f"{plots.abscissa}/a", r"p/\bar p")
    )
    _ticks(figure, scale, (0, 0.25, 0.5, 0.75), (0, 1, 2, 3), (0, 0))
    for curve in plots.references:
        _curve(figure, scale, "reference", curve.coordinates)
        figure.label(curve.label, scale.at(curve.x, curve.y), _side(curve.above), "note", plain=True)
    for i, curve in enumerate(plots.pressure):
        tone = f"curve tone{i if len(plots.pressure) > 1 else 3}"
        _curve(figure, scale, tone, curve.coordinates)
        if curve.label:
            figure.label(curve.label, scale.at(curve.x, curve.y), _side(curve.above), tone.replace("curve", "accent"))
    return figure


def force(plots: Any) -> Figure:
    """Force over depth, both over those of a reference contact."""
    plane = plots.abscissa == "x"
    unit = "P_1" if plane else "F_1"
    figure, scale = _axes(
        ("Force and depth", plots.force_caption), (0, 2), (0, 3.2), ("d/d_1", f"{plots.load}/{unit}")
    )
    _ticks(figure, scale, (0, 0.5, 1, 1.5), (0, 1, 2, 3), (0, 0))
    if not plane:
        figure.add("polyline", "reference", points=scale.points([(0, 0), (2, 2)]))
        figure.add("polyline", "reference", points=scale.points((i / 25, (i / 25) ** 1.5) for i in range(51)))
        figure.label("flat punch", scale.at(1.55, 1.52), "below-left", "note", plain=True)
        figure.label("sphere", scale.at(1.6, 2.02), "above-right", "note", plain=True)
    _curve(figure, scale, "load", plots.force.coordinates)
    return figure


def adhesion(curves: Any) -> Figure:
    """Force over depth with adhesion: stable, stable at fixed depth only, unstable."""
    words = r"$\Delta\ell=0.6\,d_1$ at $a_1$; grey: $\Delta\gamma=0$. Dashed: stable at fixed depth only; dotted: unstable"
    figure, scale = _axes(("Adhesion", words), (-0.7, 2), (-1, 3.2), ("d/d_1", "F/F_1"))
    _ticks(figure, scale, (0, 1), (-1, 0, 1, 2, 3), (-0.7, -1))
    figure.line("reference", scale.at(-0.7, 0), scale.at(2, 0))
    found = curves.adhesion
    for kind, text in (
        ("reference", found.without), ("load", found.stable), ("load dashed", found.grips), ("load dotted", found.unstable),
    ):  # fmt: skip
        _curve(figure, scale, kind, text)
    for name, place, side in ((r"F_{\mathrm c}", found.force, "below-left"), (r"d_{\mathrm m}", found.depth, "above-right")):
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
    figure.add("polyline", "reference", points=scale.points((i / 60, 1 - (1 - i / 60) ** 1.5) for i in range(61)))
    figure.label("sphere", scale.at(0.62, 0.72), "below-left", "note", plain=True)
    _curve(figure, scale, "curve tone3", curves.slip)
    _curve(figure, scale, "curve tone3", "(1,1) (1.25,1)")
    return figure


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
        figure.line("thin", scale.at(picture.angle.x, picture.angle.y), scale.at(picture.angle.x + 1.55, picture.angle.y))
        figure.label(r"\theta", scale.at(picture.angle.x + 1.3, picture.angle.y + 0.2))
    _arrow(figure, scale, (picture.arrow, 0), (picture.arrow, -picture.arrow_depth))
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


def figures(model: Mapping[str, Any]) -> list[Figure]:
    """The plots of a page, in the order of the book."""
    found: list[Figure] = []
    if model.get("plots"):
        found += [pressure(model["plots"]), force(model["plots"])]
    if model.get("curves"):
        found += [adhesion(model["curves"]), slip(model["curves"])]
    return found
