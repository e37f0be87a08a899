"""The sketch of the punch that an eccentric load tilts, with both edges in contact, and the exact surface beside it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..entry import Entry
from ..oracle.values import REACH, Values, sketch_values
from ..profiles.profile import Profile
from .given import Strip
from .labels import Rows, coordinates

DIGITS = 16
RADIUS, WIDTH = 1.75, 4.7
"""Half the face and half of the frame, in units of the picture."""
SUNK = 0.52
"""Depth of the middle in half-widths, which sets the load."""
THICKNESS = 1.45
NODES = 200


@dataclass(frozen=True)
class TiltedSketch:
    """Coordinates in units of the picture, the undeformed surface at y = 0."""

    body: str
    contact: str
    surface: str
    surface_left: str
    end: float
    radius: float
    edge: float
    """Height of the edge on the side of the load."""
    load: float
    """Where the load acts."""
    top: float
    """Height of the body there."""
    corner: float
    """Height of the edge on the other side, where the inclination is drawn."""
    degrees: float
    arrow: float
    arrow_end: float


def tilted_sketch(profile: Profile, entries: Mapping[str, Entry]) -> TiltedSketch:
    """At the eccentricity of the profile's file; depth, inclination and surface to one scale."""
    unit = _Surface(profile, entries, sketch_values(profile) | {nt.P: mp.mpf(1)})
    found = _Surface(profile, entries, unit.values | {nt.P: SUNK / unit.face(0.0)})
    tilt, load = float(found.tilt), float(found.values[nt.e])
    places = [1 + (WIDTH / RADIUS - 1) * (i / 32) ** 2 for i in range(33)]

    def drawn(x: float, height: Callable[[float], float]) -> tuple[float, float]:
        return RADIUS * x, -RADIUS * height(x)

    right = [drawn(x, found.face if x == 1 else found.beside) for x in places]
    left = [drawn(-x, found.face if x == 1 else found.beside) for x in reversed(places)]
    face: Rows = [left[-1], right[0]]
    across, up = THICKNESS * math.sin(math.atan(tilt)), THICKNESS * math.cos(math.atan(tilt))
    roof = [(x + across, y + up) for x, y in reversed(face)]
    top = roof[1][1] - tilt * (RADIUS * load - roof[1][0])
    arrow = 3.75
    return TiltedSketch(
        coordinates([*face, *roof]),
        coordinates(face),
        coordinates(right),
        coordinates(left),
        round(right[-1][1], 4),
        RADIUS,
        round(right[0][1], 4),
        round(RADIUS * load, 4),
        round(top, 4),
        round(left[-1][1], 4),
        round(math.degrees(math.atan(tilt)), 2),
        arrow,
        round(drawn(arrow / RADIUS, found.beside)[1], 4),
    )


class _Surface:
    """Displacement of the surface for a = E* = 1; w is 0 at the distance to which depths are related, on the mean."""

    def __init__(self, profile: Profile, entries: Mapping[str, Entry], values: Values) -> None:
        self.values = values
        numbers = Strip(profile, entries, values, DIGITS)
        self.tilt = numbers("phi")
        angles = [mp.pi * (2 * i + 1) / (2 * NODES) for i in range(NODES)]
        # the rule of Gauss and Chebyshev: the pressure without its root times equal weights
        self.strips = [(float(mp.cos(t)), float(numbers("p", mp.cos(t)) * mp.sin(t) * mp.pi / NODES)) for t in angles]
        reach = float(REACH)
        self.level = (self._potential(reach) + self._potential(-reach)) / 2

    def beside(self, x: float) -> float:
        """The logarithmic displacement of every strip of the pressure, summed."""
        return self._potential(x) - self.level

    def face(self, x: float) -> float:
        """Depth of the flat face: below P/(pi sqrt(1 - s^2)) the mean of -log|x - s| is log 2 for every x."""
        load: Any = self.values[nt.P]
        return float(2 / math.pi * load * math.log(2)) - self.level + float(self.tilt) * x

    def _potential(self, x: float) -> float:
        return -2 / math.pi * sum(weight * math.log(abs(x - s)) for s, weight in self.strips)
