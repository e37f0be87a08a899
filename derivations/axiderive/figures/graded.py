"""Plots of a contact on a graded half-space for a few exponents: pressure, and the surface beside the contact."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.values import Numbers, sketch_values
from ..profiles.profile import Profile
from .axes import Axes, axes
from .labels import HIGHEST, Rows
from .plots import cut

Entries = Mapping[str, Entry]
SHOWN = ("cone", "paraboloid")
"""Profiles that are drawn: what the grading does to the others it does to these."""
EXPONENTS = ("-0.5", "0", "0.5")
DIGITS = 10
"""Working digits; a coordinate is printed with five."""
PLACES = (0.004, 0.02, *(i / 20 for i in range(1, 18)), 0.88, 0.91, 0.94, 0.965, 0.98, 0.99, 0.996, 0.9995)
BESIDE = (1.0, 3.0)
"""Radii over that of the contact between which the surface is drawn."""


def frames(profile: Profile, main: Entries, graded: Entries) -> tuple[Axes, ...]:
    """Frames for the exponents with an entry: the homogeneous ones are those of the normal contact."""
    family = [(_numbers(profile, main if k == "0" else graded, k), k) for k in EXPONENTS]
    names = rf"for $k={', '.join(EXPONENTS)}$"
    pressures = [(_pressure(one), k) for one, k in family]
    surfaces = [(_surface(one), k) for one, k in family]
    return (
        axes(
            ("$r/a$", r"$p/\bar p$"), (0.0, 1.0), (0.0, HIGHEST), pressures,
            ("Graded pressure", f"{names}: the stiffer the depth, the more the middle carries."),
        ),
        axes(
            ("$r/a$", "$w/w(a)$"), BESIDE, (0.0, 1.0), surfaces,
            ("Graded displacement", f"{names}: the stiffer the depth, the sooner the surface is level."),
        ),
    )  # fmt: skip


def _numbers(profile: Profile, entries: Entries, exponent: str) -> Numbers:
    return Numbers(profile, entries, sketch_values(profile) | {nt.H: sp.S.One, nt.k: sp.Rational(exponent)}, DIGITS)


def _pressure(numbers: Numbers) -> Rows:
    """Pressure over its mean; where a sharp tip makes it infinite, up to the top of the frame."""
    radius, mean = numbers["a"], numbers.mean_pressure
    return cut([(x, float(numbers("p", mp.mpf(x) * radius) / mean)) for x in PLACES])


def _surface(numbers: Numbers) -> Rows:
    """Displacement over that of the edge, dense where the surface is steep."""
    radius = numbers["a"]
    edge = numbers.depth - numbers.shape(radius)
    start, end = BESIDE
    places = [start + (end - start) * (i / 32) ** 2 for i in range(1, 33)]
    return [(start, 1.0), *((x, float(numbers("w", mp.mpf(x) * radius) / edge)) for x in places)]
