"""Plots of a contact on a graded half-space for a few exponents: pressure, and force over depth or the surface."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...profiles.profile import Profile
from ..given import Axes, axes
from ..labels import HIGHEST, Rows
from ..plots import WIDEST, contact_range, cut
from ..values import Numbers, sketch_values

Entries = Mapping[str, Entry]
EXPONENTS = ("-0.5", "0", "0.5")
DIGITS = 10
"""Working digits; a coordinate is printed with five."""
PLACES = (0.004, 0.02, *(i / 20 for i in range(1, 18)), 0.88, 0.91, 0.94, 0.965, 0.98, 0.99, 0.996, 0.9995)
BESIDE = tuple(sign * gap for gap in (2e-4, 1e-3, 3e-3, 7e-3, 0.015, 0.03) for sign in (-1, 1))
"""Places around a break, at which the slope of the pressure is infinite."""
BESIDE_FACE = (1.0, 3.0)
"""Radii over that of a face between which the surface is drawn."""
DEPTHS = ("1", "1.5", "2", "3", "4", "6")
"""Multiples of the depth of the sketch, of which the first is drawn at which every pressure is one."""


def frames(profile: Profile, main: Entries, graded: Entries) -> tuple[Axes, ...]:
    """Frames for the exponents with an entry: the homogeneous ones are those of the normal contact."""
    family = [_numbers(profile, main if k == "0" else graded, k) for k in EXPONENTS]
    names = f"for $k={', '.join(EXPONENTS)}$"
    if profile.contact == "compact":
        pressures = [_pressure(one) for one in family]
        return (_pressures(pressures, names), _forces(profile, family, names))
    for factor in map(sp.Rational, DEPTHS):
        depth = family[0].values[nt.d] * factor
        pressed = [one.at(d=depth) for one in family]
        try:
            pressures = [_pressure(one) for one in pressed]
        except LookupError:  # part of the face is not in contact yet
            continue
        if all(y > 0 for rows in pressures for _, y in rows):
            share = f"{float(depth / family[0].values[nt.a]):g}"
            surfaces = [_surface(one.at(d=depth)) for one in family]
            return (_pressures(pressures, rf"{names}, at $d={share}\,a$"), _surfaces(surfaces, names))
    message = f"{profile.name}: no depth of {', '.join(DEPTHS)} times that of the sketch presses the whole face"
    raise LookupError(message)


def _numbers(profile: Profile, entries: Entries, exponent: str) -> Numbers:
    return Numbers(profile, entries, sketch_values(profile) | {nt.H: sp.S.One, nt.k: sp.Rational(exponent)}, DIGITS)


def _pressures(family: list[Rows], words: str) -> Axes:
    words = f"{words}, at equal mean pressure."
    return axes(("$r/a$", r"$p/\bar p$"), (0.0, 1.0), HIGHEST, family, list(EXPONENTS), ("Graded pressure", words))


def _pressure(numbers: Numbers) -> Rows:
    """Pressure over its mean; where a sharp tip or an edge makes it infinite, up to the top of the frame."""
    radius, mean = numbers["a"], numbers.mean_pressure
    breaks = [float(numbers[b.name] / radius) for b in numbers.profile.breaks]
    places = {*PLACES, *(b + gap for b in breaks for gap in BESIDE)}
    rows = [(x, float(numbers("p", mp.mpf(x) * radius) / mean)) for x in sorted(places) if 0 < x < 1]
    return cut(rows)


def _surfaces(family: list[Rows], words: str) -> Axes:
    """The surface beside a face whose edge is fixed, where force over depth is a straight line."""
    words = f"{words}, over that of the edge."
    return axes(("$r/a$", "$w/w(a)$"), BESIDE_FACE, 1.0, family, list(EXPONENTS), ("Graded displacement", words))


def _surface(numbers: Numbers) -> Rows:
    """Displacement over that of the edge, dense where the surface is steep."""
    radius = numbers["a"]
    edge = numbers.depth - numbers.shape(radius)
    start, end = BESIDE_FACE
    places = [start + (end - start) * (i / 32) ** 2 for i in range(1, 33)]
    return [(start, 1.0), *((x, float(numbers("w", mp.mpf(x) * radius) / edge)) for x in places)]


def _forces(profile: Profile, family: list[Numbers], words: str) -> Axes:
    """Force over depth, each over those of the sketched contact radius."""
    rows = [_force(profile, one) for one in family]
    words = f"{words}, each over those at the radius of the sketch."
    return axes(("$d/d_1$", "$F/F_1$"), (0.0, WIDEST), HIGHEST, rows, list(EXPONENTS), ("Graded force", words))


def _force(profile: Profile, numbers: Numbers) -> Rows:
    """Up to where the depth still grows with the radius: that of a bump does not for ever."""
    depth, force = numbers("d"), numbers("F")
    low, high = contact_range(profile, numbers)
    radii = [low + (high - low) * (mp.mpf(i) / 32) ** 2 for i in range(33)]
    rows = [(float(one("d") / depth), float(one("F") / force)) for one in (numbers.at(a=radius) for radius in radii)]
    growing = next((i for i in range(1, len(rows)) if rows[i][0] <= rows[i - 1][0]), len(rows))
    return rows[:growing]
