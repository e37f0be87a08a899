"""Plots of what has no profile to sink in: prescribed pressures, and the punch that an eccentric load tilts."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.loads import Load
from ..profiles.profile import Profile
from .axes import Axes, axes
from .drawing import Rows
from .labels import HIGHEST
from .values import Numbers, Values

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
        numbers = Strip(profile, entries, values | {nt.e: sp.Rational(e) - sp.Rational(1, 10**12)}, DIGITS)
        end = max(4 * mp.mpf(e) - 3, -1) + NEAR  # of the contact, where the pressure rises as a root
        rising = {end + (1 - NEAR - end) * mp.sin(mp.pi * i / 240) ** 2 for i in range(120)}
        places = sorted({NEAR - 1} | rising)
        pressures.append([(float(x), y) for x in places if (y := float(numbers("p", x))) < HIGHEST * 1.06])
    tilt = []
    for share in (mp.mpf(i) / 50 for i in range(46)):
        e = sp.Rational(str(share)) + sp.Rational(1, 10**9)  # the border of lift-off belongs to neither case
        tilt.append((float(share), float(mp.pi / 2 * Strip(profile, entries, values | {nt.e: e}, DIGITS)("phi"))))
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


class Strip(Numbers):
    """The entries of a plane contact at numbers, whose fields are asked for at x instead of r."""

    def place(self, suffix: str) -> sp.Symbol:
        """The coordinate a field is asked for at: x."""
        return nt.x
