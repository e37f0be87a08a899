"""What every sketch has: a section through the half-space with its dimension lines, in units of 9 mm in print."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .drawing import Drawing, Point, Rows

WIDTH = 4.7
"""Half of the width that is drawn."""
LOW, HIGH = -2.16, 1.66
FLOOR = -2.15
ARROW = 3.75
"""Where the arrow of the displacement stands."""


def section(words: str, seen: str) -> Drawing:
    """An empty sketch: what it is true to, and what a section through what shows."""
    corners = (-WIDTH - 0.05, LOW), (WIDTH + 0.05, HIGH)
    return Drawing("sketch", *corners, ("Sketch", words), f"Section through the {seen}", "sketch")


def ground(figure: Drawing, surface: Rows) -> None:
    """The elastic body below its surface, given from left to right."""
    figure.area("ground", [(-WIDTH, FLOOR), *surface, (WIDTH, FLOOR)])


def rest(figure: Drawing) -> None:
    """The surface before the contact."""
    figure.line("rest", (-WIDTH, 0.0), (WIDTH, 0.0))


def indenter(figure: Drawing, outline: Rows, contact: Rows, left: Rows, right: Rows) -> None:
    """A rigid body, its contact, and the free surface on either side, each from left to right."""
    ground(figure, [*left, *contact, *right])
    figure.area("body", outline)
    figure.line("surface", *right)
    figure.line("surface", *left)
    figure.line("contact", *contact)
    rest(figure)


def load(figure: Drawing, name: str, x: float, top: float) -> None:
    """The arrow of the load onto the top of the body."""
    figure.line("arrow", (x, HIGH - 0.04), (x, top), heads=1)
    figure.label(f"${name}$", (x + 0.08, 1.5), "west")


def dimension(figure: Drawing, name: str, end: Point, level: float, begin: float = 0.0) -> None:
    """A length from the axis, or from another place, to a point of the picture."""
    for x in (end[0], begin) if begin else (end[0],):
        figure.line("extension", (x, end[1]), (x, level - 0.1))
    figure.line("dimension", (begin, level), (end[0], level), heads=2)
    figure.label(f"${name}$", ((begin + end[0]) / 2, level), look="length")


def angle(figure: Drawing, name: str, at: Point, ends: tuple[float, float], degrees: float) -> None:
    """An inclination at a point against a level line of the first length, drawn in the second."""
    (x, y), (reach, radius) = at, ends
    figure.line("extension", at, (x + reach, y))
    turns = [math.radians(degrees) * i / 12 for i in range(13)]
    figure.line("direction", *((x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns), heads=1)
    beside, middle = radius + 0.25, turns[6]
    figure.label(f"${name}$", (x + beside * math.cos(middle), y + beside * math.sin(middle)))


def displacement(figure: Drawing, x: float, end: float) -> None:
    """The arrow from the surface at rest to where it has come."""
    figure.line("pointer", (x, 0.0), (x, end), heads=1)
    figure.label("$w$", (x, 0.0), "south west")


def coordinates(figure: Drawing, place: str, modulus: float) -> None:
    """The directions of the coordinates, and where the name of the elastic body stands."""
    figure.line("direction", (3.7, -1.35), (4.35, -1.35), heads=1)
    figure.line("direction", (3.7, -1.35), (3.7, -1.95), heads=1)
    figure.label(f"${place}$", (4.35, -1.35), "west")
    figure.label("$z$", (3.66, -1.86), "east")
    figure.label("elastic, $E^{*}$", (modulus, -1.85), look="note")


def mirrored(points: Sequence[Point]) -> Rows:
    """The same points on the other side of the axis, from left to right."""
    return [(-x, y) for x, y in reversed(points)]
