"""The sketch of a prescribed pressure: its profile over the loaded circle, and the exact surface below it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.values import Numbers, Values
from ..profiles.loads import Load
from .labels import Rows, coordinates

DIGITS = 16
RADIUS, WIDTH = 1.7, 4.7
"""The loaded circle and half of the frame, in units of the picture."""
DEPTH, BASE, HEIGHT, HIGHEST = 1.3, 0.14, 0.75, 1.6
"""The deepest point of the surface, where the pressure begins, p_0, and where it is cut, in the same units."""
LOW = 0.35
"""p_0 below a pressure that is infinite at the edge."""
EXPONENT = sp.Integer(2)
STEPS = 80


@dataclass(frozen=True)
class LoadSketch:
    """Curves of the picture and what is written into it."""

    surface: str
    pressure: str
    arrows: tuple[tuple[float, float], ...]
    """Places of the arrows and their upper ends."""
    radius: float
    base: float
    label: tuple[float, float]


def load_sketch(load: Load, entries: Mapping[str, Entry]) -> LoadSketch:
    """The power of the distance to the edge with the exponent 2; depths to the scale of the deepest one."""
    exponent = load.exponent.subs(nt.sigma, EXPONENT)
    values: Values = {nt.a: sp.S.One, nt.p_0: sp.S.One, nt.E_star: sp.S.One, nt.sigma: exponent}
    numbers = Numbers(load, entries, values, DIGITS)
    places = [(2 * i + 1) / (2 * STEPS) * WIDTH for i in range(STEPS)]
    sunk = [float(numbers("w", sp.Rational(x / RADIUS).limit_denominator(10**6))) for x in places]
    half: Rows = [(x, -DEPTH * w / max(sunk)) for x, w in zip(places, sunk, strict=True)]
    surface = [(-x, y) for x, y in reversed(half)] + half

    def height(x: float) -> float:
        scale = LOW if exponent < 0 else HEIGHT
        gap = max(1 - (x / RADIUS) ** 2, 1e-9)
        return float(min(BASE + scale * gap ** float(exponent), HIGHEST))

    inside = [RADIUS * math.sin(math.pi / 2 * (i / 40 - 1)) for i in range(81)]
    outline = [(x, height(x)) for x in inside]
    closed = [(-RADIUS, BASE), *outline, (RADIUS, BASE)]
    arrows = tuple((x, round(height(x), 3)) for x in (-1.36, -1.02, -0.68, -0.34, 0.0, 0.34, 0.68, 1.02, 1.36))
    return LoadSketch(coordinates(surface), coordinates(closed), arrows, RADIUS, BASE, (0.0, height(0.0)))
