"""Sketches to scale, from the exact deflected surface: nothing in them is drawn by eye."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from .. import notation as nt
from ..oracle.values import Numbers
from ..profiles.profile import Profile

Points = list[tuple[float, float]]

HALF_WIDTH = 4.7
"""Half the width of the picture in its units of 9 mm."""
RADIUS = 1.75
DEEPEST = 1.3
TOP = 0.66
NAME = 0.36
ARROW, LONG = 3.75, 0.16
"""Where the arrow of the displacement stands, if that is long enough there."""
BODY = 1.95
"""The indenter is drawn up to this multiple of the contact radius, or to the height of its top."""


@dataclass(frozen=True)
class Dimension:
    """A horizontal dimension line from `begin`, the axis unless it is another place, to `at`."""

    name: str
    at: float
    start: float
    level: float
    begin: float = 0.0


@dataclass(frozen=True)
class Height:
    """A vertical dimension line at x, and the place up to which its ends are led."""

    name: str
    x: float
    low: float
    high: float
    end: float


@dataclass(frozen=True)
class Radius:
    """A radius of curvature: an arrow along the normal, from its tail inside the body to the outline."""

    name: str
    x: float
    y: float
    tail_x: float
    tail_y: float


@dataclass(frozen=True)
class Angle:
    """Inclination of a straight flank, at the point where it starts."""

    x: float
    y: float
    degrees: float


@dataclass(frozen=True)
class Picture:
    """All coordinates in units of the picture, the undeformed surface at y = 0."""

    body: str
    contact: str
    surface: str
    surface_left: str
    a: float
    depth: float
    edge: float
    end: float
    arrow: float
    arrow_end: float
    dimensions: tuple[Dimension, ...]
    heights: tuple[Height, ...]
    radii: tuple[Radius, ...]
    angle: Angle | None
    name: float
    """Where `rigid` stands: in the left half of the body at the height NAME."""


def sketch(profile: Profile, numbers: Numbers) -> Picture:
    """The picture of a profile at the values its file gives."""
    radius, depth = float(numbers["a"]), float(numbers.depth)
    scale = min(RADIUS / radius, DEEPEST / max(depth, 1e-9))
    right = [(scale * r, scale * (float(numbers.shape(r)) - depth)) for r in _body_radii(profile, numbers, scale)]
    inside = [(x, y) for x, y in right if x <= scale * radius * (1 + 1e-9)]
    outside = _outside(numbers, scale)
    first = 0.0 if profile.contact == "complete" else outside[0][1]
    arrow, moved = _arrow(numbers, scale, right[-1][0])
    return Picture(
        body=_path([(x, y) for x, y in _closed(right, profile)]),
        contact=_path([(-x, y) for x, y in reversed(inside)][:-1] + inside),
        surface=_path(outside),
        surface_left=_path([(-x, y) for x, y in reversed(outside)]),
        a=_short(scale * radius),
        depth=_short(scale * depth),
        edge=_short(-inside[-1][1] if first else -outside[0][1]),
        end=_short(outside[-1][1]),
        arrow=_short(arrow),
        arrow_end=_short(-moved),
        dimensions=_dimensions(profile, numbers, scale, depth),
        heights=_heights(profile, numbers, scale, depth),
        radii=_radii(profile, numbers, scale, depth),
        angle=_angle(profile, numbers, scale, depth),
        name=_short(-min(0.85, max(x for x, y in right if y <= NAME) / 2)),
    )


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
    if profile.contact == "complete":
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


def _closed(right: Points, profile: Profile) -> Points:
    """The outline of the indenter with its vertical sides and flat top."""
    x, _ = right[-1]
    top = [(x, TOP), (-x, TOP)]
    return [(-x, y) for x, y in reversed(right)][:-1] + right + top


def _outside(numbers: Numbers, scale: float) -> Points:
    """The free surface, dense near the edge of contact where it is steep."""
    start, end = float(numbers["a"]), HALF_WIDTH / scale
    radii = [start + (end - start) * (i / 32) ** 2 for i in range(33)]
    radii[0] = start * (1 + 1e-9)
    return [(scale * r, -scale * float(numbers("w", r))) for r in radii]


def _dimensions(profile: Profile, numbers: Numbers, scale: float, depth: float) -> tuple[Dimension, ...]:
    radius = float(numbers["a"])
    edge = scale * (float(numbers.shape(radius)) - depth)
    found = [Dimension("a", _short(scale * radius), _short(edge), -1.78)]
    for b in profile.breaks:
        at = float(numbers[b.name])
        if at < radius:
            height = scale * (float(numbers.shape(at)) - depth)
            found.append(Dimension(nt.describe(b).latex, _short(scale * at), _short(height), -1.5))
    for length in (nt.b, nt.s):
        if length in profile.parameters and length not in profile.breaks:
            at = float(numbers[length.name])
            inside = min(at, 0.985 * at if length in profile.chain else at)
            height = scale * (float(numbers.shape(inside)) - depth)
            found.append(Dimension(nt.describe(length).latex, _short(scale * at), _short(height), -1.5))
    if nt.wavelength in profile.parameters:
        wave = float(numbers["wavelength"])
        height = scale * (float(numbers.shape(2 * wave)) - depth)
        found.append(Dimension(r"\lambda", _short(scale * 2 * wave), _short(height), -1.5, _short(scale * wave)))
    return tuple(found)


def _heights(profile: Profile, numbers: Numbers, scale: float, depth: float) -> tuple[Height, ...]:
    """The height of a bump, the depth of a face, the half of an ellipsoid; waves are too flat to be measured."""
    if nt.h not in profile.parameters or nt.wavelength in profile.parameters:
        return ()
    tip, height = -scale * depth, scale * float(numbers["h"])
    if profile.contact == "complete":
        return (Height("h", -0.9, _short(tip - height), _short(tip), -_short(scale * float(numbers["a"]))),)
    at = ARROW - 0.75
    return (Height("h", at, _short(tip), _short(tip + height), 0.0),)


LEADER = 0.8
"""Length of the arrow of a radius."""


def _radii(profile: Profile, numbers: Numbers, scale: float, depth: float) -> tuple[Radius, ...]:
    """An arrow for every radius of curvature, on the part of the profile that has it."""
    radius = float(numbers["a"])
    inner = float(numbers[profile.breaks[0].name]) if profile.breaks else radius
    places = {nt.R1: 0.55 * inner, nt.R2: (inner + radius) / 2}
    places[nt.R] = (inner + radius) / 2 if profile.truncated else 0.6 * inner
    found = []
    for symbol in (nt.R, nt.R1, nt.R2):
        if symbol in profile.parameters:
            x = places[symbol]
            y = scale * (float(numbers.shape(x)) - depth)
            slope = (float(numbers.shape(1.001 * x)) - float(numbers.shape(0.999 * x))) / (0.002 * x)
            norm = (1 + slope * slope) ** 0.5
            side = -1 if symbol == nt.R1 else 1  # of two radii one is drawn on either side
            tail = (side * (scale * x - LEADER * slope / norm), y + LEADER / norm)
            ends = (_short(value) for value in (side * scale * x, y, *tail))
            found.append(Radius(nt.describe(symbol).latex, *ends))
    return tuple(found)


def _angle(profile: Profile, numbers: Numbers, scale: float, depth: float) -> Angle | None:
    """The angle theta, drawn where a flank of that slope begins."""
    starts: list[sp.Expr] = [sp.S.Zero, *profile.breaks]
    for start, piece in zip(starts, profile.pieces, strict=True):
        slope = sp.diff(piece.expr, nt.r)
        if slope == sp.tan(nt.theta):
            at = 0.0 if start == 0 else float(numbers[start.name])
            y = scale * (float(numbers.shape(at)) - depth)
            return Angle(_short(scale * at), _short(y), round(float(numbers["theta"]) * 57.29577951308232, 2))
    return None


def _short(x: Any) -> float:
    return float(f"{float(x):.4f}")


def _path(points: Points) -> str:
    return " ".join(f"({x:.4f},{y:.4f})" for x, y in points).replace("-0.0000", "0.0000")
