"""A figure as lines, curves, dots and words in units of its own, y upwards: one for the book and the web edition.

`tikz` and `svg` draw it.  A look is a name that both have a style for: in the preamble of the book and the style
sheet of the web edition.  Words are running text with formulas between dollar signs.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

Point = tuple[float, float]
Rows = list[Point]


@dataclass(frozen=True)
class Line:
    """A line through points, or the area within it."""

    look: str
    points: tuple[Point, ...]
    closed: bool = False
    heads: int = 0
    """One arrow head at its end, or two."""


@dataclass(frozen=True)
class Dot:
    """A point that is marked."""

    look: str
    place: Point


@dataclass(frozen=True)
class Boxes:
    """Rectangles of one look: left, low, width and height of each."""

    look: str
    corners: tuple[tuple[float, float, float, float], ...]


@dataclass(frozen=True)
class Words:
    """Text and the side of it, by the compass, that lies at a place; turned it reads upwards."""

    text: str
    place: Point
    side: str = "center"
    look: str = ""
    turned: bool = False


@dataclass(frozen=True)
class Trace:
    """A curve in the units of the axes of its window; the name is for a reader who takes its points."""

    look: str
    name: str
    points: tuple[Point, ...]


@dataclass(frozen=True)
class Window:
    """The frame of a plot: its place in the figure, the ends of its axes, and the curves, cut off at its border."""

    left: float
    low: float
    width: float
    height: float
    x: Point
    y: Point
    names: tuple[str, str]
    logarithmic: tuple[bool, bool]
    """Such an axis has the decimal logarithm as its unit."""
    traces: tuple[Trace, ...] = ()

    def place(self, point: Point) -> Point:
        """The point of the figure at a point in the units of the axes."""
        (left, right), (low, high) = self.x, self.y
        x = self.left + self.width * (point[0] - left) / (right - left)
        return x, self.low + self.height * (point[1] - low) / (high - low)


@dataclass
class Drawing:
    """All of a figure between two corners; boxes and lines lie below the curves, dots and words above them."""

    kind: str
    """What it is, which decides how large its words are: sketch, plot, outline, study."""
    low: Point
    high: Point
    caption: tuple[str, str] = ("", "")
    """Title and words."""
    seen: str = ""
    """What the figure shows, for a reader who does not see it."""
    anchor: str = ""
    """Its address on a page."""
    window: Window | None = None
    lines: list[Line] = field(default_factory=list)
    boxes: list[Boxes] = field(default_factory=list)
    dots: list[Dot] = field(default_factory=list)
    words: list[Words] = field(default_factory=list)

    def line(self, look: str, *points: Point, heads: int = 0) -> None:
        """Adds a line through points."""
        self.lines.append(Line(look, points, heads=heads))

    def area(self, look: str, points: Iterable[Point]) -> None:
        """Adds the area within points."""
        self.lines.append(Line(look, tuple(points), closed=True))

    def dot(self, look: str, place: Point) -> None:
        """Adds a dot."""
        self.dots.append(Dot(look, place))

    def label(self, text: str, place: Point, side: str = "center", look: str = "", *, turned: bool = False) -> None:
        """Adds words."""
        self.words.append(Words(text, place, side, look, turned))

    def of(self, look: str) -> tuple[Point, ...]:
        """The points of the first line of a look; LookupError if there is none."""
        found = next((line.points for line in self.lines if line.look == look), None)
        if found is None:
            message = f"the figure has no line {look}, but {sorted({line.look for line in self.lines})}"
            raise LookupError(message)
        return found


OUTLINE = ("body", "contact", "pressure")
"""Lines of a sketch that are left of it where it is drawn small."""


def outline(sketch: Drawing) -> Drawing:
    """The shape of a sketch over the surface at rest, to be drawn small."""
    found = Drawing("outline", (-4.5, -1.5), (4.5, 1.2))
    found.line("rest", (-4.5, 0.0), (4.5, 0.0))
    found.lines += [line for line in sketch.lines if line.look in OUTLINE]
    return found
