"""Sketches to scale, from the exact deflected surface: nothing in them is drawn by eye.

Each is a section through the half-space with its dimension lines, in units of 9 mm in print.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import sympy as sp

from .. import notation as nt
from ..oracle.evaluate import evaluated
from ..profiles.profile import Profile
from .drawing import Drawing, Point, Rows
from .values import Numbers

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


RADIUS = 1.75
DEEPEST = 1.3
TOP = 0.66
NAME = 0.36
"""Height at which `rigid` stands, in the left half of the body."""
LONG = 0.16
"""Least length of the arrow of the displacement, where the surface has sunk as far anywhere."""
ROOM = 0.6
"""Depth from which its name stands on its dimension line."""
BODY = 1.95
"""The indenter is drawn up to this multiple of the contact radius, or to the height of its top."""


def sketch(profile: Profile, numbers: Numbers, force: str, place: str) -> Drawing:
    """The picture of a profile at the values its file gives; the names of the load and of the coordinate."""
    radius, depth = float(numbers["a"]), float(numbers.depth)
    scale = min(RADIUS / radius, DEEPEST / max(depth, 1e-9))
    right = [(scale * r, scale * (float(numbers.shape(r)) - depth)) for r in _body_radii(profile, numbers, scale)]
    inside = [(x, y) for x, y in right if x <= scale * radius * (1 + 1e-9)]
    outside = _outside(numbers, scale)
    drawn = _Scaled(numbers, scale, depth)
    figure = section("to scale, at the parameters of the check values", "")
    indenter(figure, _closed(right), mirrored(inside)[:-1] + inside, mirrored(outside), outside)
    figure.line("middle", (0.0, TOP), (0.0, FLOOR))
    load(figure, force, 0.0, TOP + 0.04)
    _depth(figure, scale * depth)
    _dimensions(figure, profile, drawn)
    _heights(figure, profile, drawn)
    _radii(figure, profile, drawn)
    _angle(figure, profile, drawn)
    x, sunk = _arrow(numbers, scale, right[-1][0])
    displacement(figure, x, -sunk)
    _, *marked = (words.text for words in figure.words)
    body = f"contact: the rigid body, pressed by ${force}$, and the deformed surface"
    figure.seen += f"{body}; marked are {', '.join(marked)}"
    coordinates(figure, place, -2.3)
    figure.label("rigid", (-min(0.85, max(x for x, y in right if y <= NAME) / 2), NAME), look="ink")
    return figure


class _Scaled:
    """The numbers of a profile in units of the picture, the undeformed surface at y = 0."""

    def __init__(self, numbers: Numbers, scale: float, depth: float) -> None:
        self.numbers, self.scale, self.depth = numbers, scale, scale * depth

    def length(self, name: str) -> float:
        """Of a parameter."""
        return self.scale * float(self.numbers[name])

    def height(self, r: float) -> float:
        """Of the profile at a radius."""
        return self.scale * float(self.numbers.shape(r)) - self.depth


def _depth(figure: Drawing, depth: float) -> None:
    figure.line("extension", (0.0, -depth), (-4.1, -depth))
    figure.line("dimension", (-3.95, 0.0), (-3.95, -depth), heads=2)
    if depth > ROOM:
        figure.label("$d$", (-3.95, -depth / 2), look="length")
    else:
        figure.label("$d$", (-4.02, -depth / 2), "east")


def _arrow(numbers: Numbers, scale: float, beside: float) -> tuple[float, float]:
    """Where the displacement is drawn, and how large it is there: LONG, where it is so anywhere beside the body.

    The place is as far out as that allows; where the surface has risen its arrow would cross its own name.
    """
    places = [ARROW - (ARROW - beside - 0.2) * i / 12 for i in range(13)] if beside + 0.2 < ARROW else [ARROW]
    found = [(x, float(numbers("w", x / scale)) * scale) for x in places]
    return next((one for one in found if one[1] >= LONG), max(found, key=lambda one: one[1]))


def _body_radii(profile: Profile, numbers: Numbers, scale: float) -> list[float]:
    """Radii at which the outline is taken: dense, with the edge of contact and the breaks among them."""
    radius = float(numbers["a"])
    if profile.complete:
        return [radius * i / 40 for i in range(41)]
    last = BODY * radius
    bound = [x for x in profile.chain if x != nt.a]
    if bound and nt.a in profile.chain:
        last = min(last, 0.985 * float(numbers[bound[-1].name]))
    highest = (TOP - 0.25) / scale + float(numbers.depth)
    while float(numbers.shape(last)) > highest and last > 1.02 * radius:
        last *= 0.99
    marks = {radius, last} | {float(numbers[b.name]) for b in profile.breaks}
    marks |= {last * i / 60 for i in range(61)}
    return sorted(x for x in marks if x <= last)


def _closed(right: Rows) -> Rows:
    """The outline of the indenter with its vertical sides and flat top."""
    x, _ = right[-1]
    return mirrored(right)[:-1] + right + [(x, TOP), (-x, TOP)]


def _outside(numbers: Numbers, scale: float) -> Rows:
    """The free surface, dense near the edge of contact where it is steep."""
    start, end = float(numbers["a"]), WIDTH / scale
    radii = [start + (end - start) * (i / 32) ** 2 for i in range(33)]
    radii[0] = start * (1 + 1e-9)
    return [(scale * r, -scale * float(numbers("w", r))) for r in radii]


def _dimensions(figure: Drawing, profile: Profile, drawn: _Scaled) -> None:
    numbers = drawn.numbers
    radius = float(numbers["a"])
    dimension(figure, "a", (drawn.length("a"), drawn.height(radius)), -1.78)
    for b in profile.breaks:
        at = float(numbers[b.name])
        if at < radius:
            dimension(figure, nt.describe(b).latex, (drawn.length(b.name), drawn.height(at)), -1.5)
    for length in (nt.b, nt.s):
        if length in profile.parameters and length not in profile.breaks:
            at = float(numbers[length.name])
            height = drawn.height(0.985 * at if length in profile.chain else at)
            dimension(figure, nt.describe(length).latex, (drawn.length(length.name), height), -1.5)
    if nt.wavelength in profile.parameters:
        wave = drawn.length("wavelength")
        height = drawn.height(2 * float(numbers["wavelength"]))
        dimension(figure, r"\lambda", (2 * wave, height), -1.5, wave)


def _heights(figure: Drawing, profile: Profile, drawn: _Scaled) -> None:
    """The height of a bump, the depth of a face, the half of an ellipsoid; waves are too flat to be measured."""
    if nt.h not in profile.parameters or nt.wavelength in profile.parameters:
        return
    tip, height = -drawn.depth, drawn.length("h")
    # the ends of the line, and the place up to which its lower end is led
    if profile.complete:
        x, low, high, end = -0.9, tip - height, tip, -drawn.length("a")
    else:
        x, low, high, end = ARROW - 0.75, tip, tip + height, 0.0
    figure.line("extension", (end, low), (x, low))
    figure.line("extension", (0.0, high), (x, high))
    figure.line("dimension", (x, low), (x, high), heads=2)
    figure.label("$h$", (x - 0.04, (low + high) / 2), "east")


STRAIGHT = 1e-9
"""Difference of a slope from the tangent of theta that is one of rounding."""
LEADER = 0.8
"""Length of the arrow of a radius."""


def _radii(figure: Drawing, profile: Profile, drawn: _Scaled) -> None:
    """An arrow along the normal for every radius of curvature, on the part of the profile that has it."""
    numbers = drawn.numbers
    radius = float(numbers["a"])
    inner = float(numbers[profile.breaks[0].name]) if profile.breaks else radius
    places = {nt.R1: 0.55 * inner, nt.R2: (inner + radius) / 2}
    places[nt.R] = (inner + radius) / 2 if profile.truncated else 0.6 * inner
    for symbol in (nt.R, nt.R1, nt.R2):
        if symbol in profile.parameters:
            x = places[symbol]
            slope = (float(numbers.shape(1.001 * x)) - float(numbers.shape(0.999 * x))) / (0.002 * x)
            norm = (1 + slope * slope) ** 0.5
            side = -1 if symbol == nt.R1 else 1  # of two radii one is drawn on either side
            end = side * drawn.scale * x, drawn.height(x)
            tail = (side * (drawn.scale * x - LEADER * slope / norm), end[1] + LEADER / norm)
            figure.line("pointer", tail, end, heads=1)
            figure.label(f"${nt.describe(symbol).latex}$", tail, "west")


def _angle(figure: Drawing, profile: Profile, drawn: _Scaled) -> None:
    """The angle theta, drawn where a flank of that slope begins."""
    if nt.theta not in profile.parameters:
        return
    starts: list[sp.Expr] = [sp.S.Zero, *profile.breaks]
    for start, piece in zip(starts, profile.pieces, strict=True):
        slope = sp.diff(piece.expr, nt.r)
        if not slope.has(nt.r) and abs(evaluated(slope - sp.tan(nt.theta), drawn.numbers.values)) < STRAIGHT:
            at = 0.0 if start == 0 else float(drawn.numbers[start.name])
            place = drawn.scale * at, drawn.height(at)
            angle(figure, r"\theta", place, (1.55, 1.05), math.degrees(float(drawn.numbers["theta"])))
            return
