"""Figures as SVG shapes in the units of the page, with formulas laid over them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

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
        self.shapes.append((element, kind, {name.rstrip("_"): f"{value}" for name, value in attributes.items()}))

    def curve(self, kind: str, name: str, points: Iterable[tuple[float, float]]) -> None:
        self.curves.append((kind, name, " ".join(f"{x:.5g},{y:.5g}" for x, y in points)))

    def line(self, kind: str, start: tuple[float, float], end: tuple[float, float]) -> None:
        (x1, y1), (x2, y2) = start, end
        self.add("line", kind, x1=x1, y1=y1, x2=x2, y2=y2)

    def label(
        self, text: str, place: tuple[float, float], side: str = "middle", kind: str = "", plain: bool = False
    ) -> None:
        x, y = place
        left, top = round(100 * x / self.width, 2), round(100 * y / self.height, 2)
        self.labels.append(Label(text, left, top, side, kind, plain))
