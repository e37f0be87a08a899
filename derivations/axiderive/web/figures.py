"""Figures of the web edition.

Figures as SVG shapes in the units of the page, with formulas laid over them.

The plots of a page, from the coordinates that the book prints.

The sketch of a page, as the book draws it: a contact to scale, a prescribed pressure, a punch that tilts.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from .words import symbol

Pairs = list[tuple[float, float]]
Shape = tuple[str, str, dict[str, str]]
_PAIR = re.compile(r"\(([^,()]+),([^,()]+)\)")


def pairs(text: str) -> Pairs:
    """The numbers of `(x,y) (x,y) ...`."""
    return [(float(x), float(y)) for x, y in _PAIR.findall(text)]


@dataclass(frozen=True)
class Scale:
    """From the units of a figure to those of the SVG, whose y points down."""

    x0: float
    y0: float
    x: float
    y: float

    def at(self, x: float, y: float) -> tuple[float, float]:
        """The place of a point in units of the SVG, to one decimal."""
        return round(self.x0 + self.x * x, 1), round(self.y0 - self.y * y, 1)

    def points(self, rows: Iterable[tuple[float, float]]) -> str:
        """The points in units of the SVG as the text of a `points` attribute."""
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


@dataclass(frozen=True)
class Window:
    """The frame of a plot, beyond which its curves are cut off, and its axes, in whose units they are drawn."""

    left: float
    top: float
    width: float
    height: float
    x: tuple[float, float]
    y: tuple[float, float]
    names: tuple[str, str]
    logarithmic: tuple[bool, bool]
    """Such an axis has the decimal logarithm as its unit."""

    @property
    def view(self) -> str:
        """The frame in the units of its axes, with y down."""
        (left, right), (low, high) = self.x, self.y
        return f"{left:g} {-high:g} {right - left:g} {high - low:g}"


@dataclass
class Figure:
    """Shapes as (element, class, attributes), curves in a window, and the labels over them."""

    width: float
    height: float
    caption: tuple[str, str] = ("", "")
    seen: str = ""
    """What the figure shows, for a reader who does not see it."""
    window: Window | None = None
    shapes: list[Shape] = field(default_factory=list)
    curves: list[tuple[str, str, str]] = field(default_factory=list)
    """Class, name and points."""
    labels: list[Label] = field(default_factory=list)
    anchor: str = ""
    """Id of the figure on its page; its caption has the same with .caption behind it."""

    def add(self, element: str, kind: str, **attributes: Any) -> None:
        """Adds a shape; an attribute whose name is a word of Python has an underscore behind it."""
        self.shapes.append((element, kind, {name.rstrip("_"): f"{value}" for name, value in attributes.items()}))

    def curve(self, kind: str, name: str, points: Iterable[tuple[float, float]]) -> None:
        """Adds a curve to the window, in the units of its axes."""
        self.curves.append((kind, name, " ".join(f"{x:.5g},{y:.5g}" for x, y in points)))

    def line(self, kind: str, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Adds a straight line from one place to another, in units of the SVG."""
        (x1, y1), (x2, y2) = start, end
        self.add("line", kind, x1=x1, y1=y1, x2=x2, y2=y2)

    def label(
        self, text: str, place: tuple[float, float], side: str = "middle", kind: str = "", plain: bool = False
    ) -> None:
        """Adds a label at a place in units of the SVG, which is kept in percent of the figure."""
        x, y = place
        left, top = round(100 * x / self.width, 2), round(100 * y / self.height, 2)
        self.labels.append(Label(text, left, top, side, kind, plain))


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
