"""Sketches and plots of what has no profile to sink in: prescribed pressures, and the punch that a load tilts."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.loads import Load
from ..profiles.profile import Profile
from . import sketch
from .axes import HIGHEST, Axes, axes
from .drawing import Drawing, Rows
from .sketch import ARROW, FLOOR, WIDTH
from .values import REACH, Numbers, Values, sketch_values

DIGITS = 16
EXPONENTS = ("-0.5", "0", "0.5", "2")
NEAR = mp.mpf(10) ** -9
"""Distance from the edge of a contact at which its pressure is finite."""
ECCENTRICITIES = ("0", "0.25", "0.5", "0.75")


def axes_of(profile: Profile, entries: Mapping[str, Entry]) -> tuple[Axes, ...]:
    """The two frames of a prescribed pressure or of the eccentric punch; none for others."""
    if isinstance(profile, Load):
        return _load_axes(profile, entries)
    if nt.e in profile.parameters:
        return _tilted_axes(profile, entries)
    return ()


def _load_axes(load: Load, entries: Mapping[str, Entry]) -> tuple[Axes, ...]:
    """p over p_0, and w over p_0 a/E*; for the power at several exponents."""
    free = load.exponent == nt.sigma
    exponents = [sp.Rational(s) for s in EXPONENTS] if free else [sp.sympify(load.exponent)]
    labels = list(EXPONENTS) if free else [""]
    radii = [mp.mpf(i) / 50 for i in range(50)] + [mp.mpf("0.99"), mp.mpf("0.998")]
    pressures = [[(float(x), float((1 - x * x) ** mp.mpf(str(s)))) for x in radii] for s in map(sp.Float, exponents)]
    beside = [1 + sign * mp.mpf(gap) for gap in ("1e-5", "1e-3", "0.005", "0.015", "0.03", "0.05") for sign in (-1, 1)]
    places = sorted([*(mp.mpf(2 * i + 1) / 41 for i in range(61)), *beside])
    displacements = []
    for s in exponents:
        values: Values = {nt.a: sp.S.One, nt.p_0: sp.S.One, nt.E_star: sp.S.One, nt.sigma: s}
        numbers = Numbers(load, entries, values, DIGITS)
        displacements.append([(float(x), float(numbers("w", x))) for x in places])
    words = f"for the exponents $s={', '.join(EXPONENTS)}$" if free else "inside the circle of radius $a$"
    return (
        axes(
            ("$r/a$", "$p/p_0$"), (0.0, 1.0), (0.0, 2.0), list(zip(pressures, labels, strict=True)),
            ("Pressure", f"{words}."),
        ),
        axes(
            ("$r/a$", "$w E^{*}/(p_0 a)$"), (0.0, 3.0), (0.0, 3.2), list(zip(displacements, labels, strict=True)),
            ("Displacement", "of the surface, inside and outside the circle."),
        ),
    )  # fmt: skip


def _tilted_axes(profile: Profile, entries: Mapping[str, Entry]) -> tuple[Axes, ...]:
    """Pressure over the mean P/(2 a) for several eccentricities; inclination over the eccentricity."""
    values: Values = {nt.a: sp.S.One, nt.P: sp.Integer(2), nt.E_star: sp.S.One}
    pressures: list[Rows] = []
    for e in ECCENTRICITIES:
        numbers = Numbers(profile, entries, values | {nt.e: sp.Rational(e) - sp.Rational(1, 10**12)}, DIGITS)
        end = max(4 * mp.mpf(e) - 3, -1) + NEAR  # of the contact, where the pressure rises as a root
        rising = {end + (1 - NEAR - end) * mp.sin(mp.pi * i / 240) ** 2 for i in range(120)}
        places = sorted({NEAR - 1} | rising)
        pressures.append([(float(x), y) for x in places if (y := float(numbers("p", x))) < HIGHEST * 1.06])
    tilt = []
    for share in (mp.mpf(i) / 50 for i in range(46)):
        e = sp.Rational(str(share)) + sp.Rational(1, 10**9)  # the border of lift-off belongs to neither case
        tilt.append((float(share), float(mp.pi / 2 * Numbers(profile, entries, values | {nt.e: e}, DIGITS)("phi"))))
    return (
        axes(
            ("$x/a$", r"$p/\bar p$"), (-1.0, 1.0), (0.0, HIGHEST), list(zip(pressures, ECCENTRICITIES, strict=True)),
            ("Pressure", f"for $e/a={', '.join(ECCENTRICITIES)}$; beyond one half the left edge is lifted off."),
        ),
        axes(
            ("$e/a$", r"$\pi E^{*}a\,\varphi/P$"), (0.0, 1.0), (0.0, 16.0), [(tilt, "")],
            ("Inclination", r"under $P$ at $x=e$; linear until an edge lifts off."),
        ),
    )  # fmt: skip


RADIUS = 1.7
"""The loaded circle, in units of the picture."""
DEPTH, BASE, HEIGHT, CUT = 1.3, 0.14, 0.75, 1.6
"""The deepest point of the surface, where the pressure begins, p_0, and where it is cut, in the same units."""
LOW = 0.35
"""p_0 below a pressure that is infinite at the edge."""
EXPONENT = sp.Integer(2)
STEPS = 80


def load_sketch(load: Load, entries: Mapping[str, Entry]) -> Drawing:
    """The power of the distance to the edge with the exponent 2; depths to the scale of the deepest one."""
    exponent = load.exponent.subs(nt.sigma, EXPONENT)
    values: Values = {nt.a: sp.S.One, nt.p_0: sp.S.One, nt.E_star: sp.S.One, nt.sigma: exponent}
    numbers = Numbers(load, entries, values, DIGITS)
    places = [(2 * i + 1) / (2 * STEPS) * WIDTH for i in range(STEPS)]
    sunk = [float(numbers("w", sp.Rational(x / RADIUS).limit_denominator(10**6))) for x in places]
    half = [(x, -DEPTH * w / max(sunk)) for x, w in zip(places, sunk, strict=True)]
    surface = [(-x, y) for x, y in reversed(half)] + half

    def height(x: float) -> float:
        scale = LOW if exponent < 0 else HEIGHT
        gap = max(1 - (x / RADIUS) ** 2, 1e-9)
        return float(min(BASE + scale * gap ** float(exponent), CUT))

    inside = [RADIUS * math.sin(math.pi / 2 * (i / 40 - 1)) for i in range(81)]
    figure = sketch.section(
        "the pressure, and the surface it makes, to the scale of its deepest point",
        "loaded surface: arrows of the pressure $p(r)$ on the circle of radius $a$, and the dent they make",
    )
    sketch.ground(figure, surface)
    figure.line("surface", *surface)
    figure.area("pressure", [(-RADIUS, BASE), *((x, height(x)) for x in inside), (RADIUS, BASE)])
    for x in (-1.36, -1.02, -0.68, -0.34, 0.0, 0.34, 0.68, 1.02, 1.36):
        figure.line("pressing", (x, height(x)), (x, BASE), heads=1)
    sketch.rest(figure)
    figure.line("middle", (0.0, 0.0), (0.0, FLOOR))
    sketch.dimension(figure, "a", (RADIUS, 0.0), -1.8)
    figure.label("$p(r)$", (RADIUS, 0.6), "west", "accent")
    sketch.coordinates(figure, "r", -2.9)
    return figure


HALF = 1.75
"""Half the face of the tilted punch, in units of the picture."""
SUNK = 0.52
"""Depth of the middle in half-widths, which sets the load."""
THICKNESS = 1.45
NODES = 200


def tilted_sketch(profile: Profile, entries: Mapping[str, Entry], force: str) -> Drawing:
    """At the eccentricity of the profile's file; the name of the load; depth, inclination and surface to one scale."""
    unit = _Surface(profile, entries, sketch_values(profile) | {nt.P: mp.mpf(1)})
    found = _Surface(profile, entries, unit.values | {nt.P: SUNK / unit.face(0.0)})
    tilt, at = float(found.tilt), HALF * float(found.values[nt.e])
    places = [1 + (WIDTH / HALF - 1) * (i / 32) ** 2 for i in range(33)]

    def drawn(x: float, height: Callable[[float], float]) -> tuple[float, float]:
        return HALF * x, -HALF * height(x)

    right = [drawn(x, found.face if x == 1 else found.beside) for x in places]
    left = [drawn(-x, found.face if x == 1 else found.beside) for x in reversed(places)]
    face: Rows = [left[-1], right[0]]
    across, up = THICKNESS * math.sin(math.atan(tilt)), THICKNESS * math.cos(math.atan(tilt))
    roof = [(x + across, y + up) for x, y in reversed(face)]
    figure = sketch.section(
        "to scale, with both edges in contact",
        f"contact: the flat body, tilted by $\\varphi$ under ${force}$ at the distance $e$ from its middle",
    )
    sketch.indenter(figure, [*face, *roof], face, left, right)
    figure.line("middle", (0.0, 1.4), (0.0, FLOOR))
    sketch.load(figure, force, at, roof[1][1] - tilt * (at - roof[1][0]) + 0.03)
    figure.line("dimension", (0.0, 1.1), (at, 1.1), heads=2)
    figure.label("$e$", (at / 2, 1.12), "south")
    sketch.dimension(figure, "a", right[0], -1.78)
    sketch.angle(figure, r"\varphi", face[0], (1.6, 1.3), -math.degrees(math.atan(tilt)))
    sketch.displacement(figure, ARROW, drawn(ARROW / HALF, found.beside)[1])
    sketch.coordinates(figure, "x", -2.9)
    figure.label("rigid", (-0.85, 0.3), look="ink")
    return figure


class _Surface:
    """Displacement of the surface for a = E* = 1; w is 0 at the distance to which depths are related, on the mean."""

    def __init__(self, profile: Profile, entries: Mapping[str, Entry], values: Values) -> None:
        self.values = values
        numbers = Numbers(profile, entries, values, DIGITS)
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
