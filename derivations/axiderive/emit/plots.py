"""Coordinates of the two plots every profile has, five digits each.

Left: pressure over its mean against sphere and flat punch.  Right: force over
depth, both related to one reference contact, against the same two.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..profiles.profile import Profile
from .labels import HIGHEST, Curve, Rows, coordinates, labelled
from .strips import REACH, StripNumbers
from .values import Numbers

TOP = HIGHEST * 1.06
WIDEST = 2.0
PAIR = re.compile(r"\(([-\d.e]+),([-\d.e]+)\)")
RATIOS = ("0.25", "0.5", "0.8")


@dataclass(frozen=True)
class Plots:
    pressure: tuple[Curve, ...]
    references: tuple[Curve, ...]
    pressure_caption: str
    force: Curve
    force_references: tuple[Curve, ...]
    force_caption: str
    abscissa: str = "r"
    load: str = r"F_{\mathrm N}"


def plots(profile: Profile, numbers: Numbers) -> Plots:
    """Both plots at the values of the profile's file, with its most telling ratio varied on the left."""
    family, name = _family(profile, numbers)
    rows = [_pressure(member) for _, member in family]
    curves: list[Curve] = []
    plane = numbers.place("p") == nt.x
    # the semicircle of a cylinder and the strip, each over its own mean
    shown = (
        [*rows, _scaled(SPHERE, 8 / (3 * math.pi)), _scaled(PUNCH, 4 / math.pi)] if plane else [*rows, SPHERE, PUNCH]
    )
    ball, punch = ("cylinder", "flat strip") if plane else ("sphere", "flat punch")
    for i, label in enumerate([*(label for label, _ in family), ball, punch]):
        curves.append(labelled(shown, i, label, curves))
    caption = f"for {name}, at equal mean pressure" if name else "at equal mean pressure"
    force, reference = _force(profile, numbers)
    words = ("x", "P") if plane else ("r", r"F_{\mathrm N}")
    known = _force_references(force, plane)
    return Plots(tuple(curves[:-2]), tuple(curves[-2:]), caption, force, known, reference, *words)


def _force_references(force: Curve, plane: bool) -> tuple[Curve, ...]:
    """Sphere and flat punch through (1, 1), of a plane contact cylinder and strip, labelled beside the own curve."""
    own = [(float(x) / WIDEST, float(y)) for x, y in PAIR.findall(force.coordinates)]
    depths = [i / 50 for i in range(51)]
    round_one = _cylinder() if plane else [(x, (WIDEST * x) ** 1.5) for x in depths]
    family = [own, round_one, [(x, WIDEST * x) for x in depths]]
    found: list[Curve] = []
    for i, label in ((1, "cylinder" if plane else "sphere"), (2, "flat strip" if plane else "flat punch")):
        curve = labelled(family, i, label, found)
        found.append(curve)
    return tuple(
        replace(curve, x=WIDEST * curve.x, coordinates=coordinates([(WIDEST * x, y) for x, y in rows]))
        for curve, rows in zip(found, family[1:], strict=True)
    )


def _cylinder() -> Rows:
    """Load of a cylinder over its depth, both over those of the half-width that REACH counts; depths over WIDEST."""
    reach = float(REACH)

    def depth(width: float) -> float:
        return reach**2 + width**2 * math.acosh(reach / width) - reach * math.sqrt(reach**2 - width**2)

    widths = [i / 40 for i in range(1, 81)]
    rows = [(depth(width) / depth(1.0) / WIDEST, width**2) for width in widths]
    return [(0.0, 0.0), *((x, y) for x, y in rows if x <= 1)]


def _scaled(rows: Rows, factor: float) -> Rows:
    return [(x, y * factor) for x, y in rows]


def _family(profile: Profile, numbers: Numbers) -> tuple[list[tuple[str, Numbers]], str]:
    """The same profile at several values of one dimensionless ratio."""
    if isinstance(numbers, StripNumbers) and "Pmin" in numbers.entries:
        loads = ("1", "2", "4")
        return [(v, numbers.at(P=numbers.least * int(v))) for v in loads], r"$P/P_{\mathrm{min}}=1, 2, 4$"
    if profile.breaks:
        b = profile.breaks[0]
        size = numbers.values[b]
        members = [(ratio, numbers.at(a=size / sp.Rational(ratio))) for ratio in RATIOS]
        return members, f"${nt.describe(b).latex}/a={', '.join(RATIOS)}$"
    if nt.n in profile.parameters:
        values = ("1.5", "2", "4") if profile.contact == "complete" else ("0.5", "1", "2", "4")
        return [
            (v, numbers.at(n=sp.Rational(v), **_lift(profile, sp.Rational(v)))) for v in values
        ], f"$n={', '.join(values)}$"
    if nt.a in profile.chain:
        bound = profile.chain[-1]
        values = ("0.5", "0.9", "0.99")
        members = [(v, numbers.at(a=sp.Rational(v) * numbers.values[bound])) for v in values]
        return members, f"$a/{nt.describe(bound).latex}={', '.join(values)}$"
    if nt.h in profile.parameters and profile.contact == "complete":
        least = sp.nsimplify(numbers("dmin"), rational=True)
        values = ("1", "2", "4")
        return [
            (v, numbers.at(d=least * sp.Rational(v))) for v in values
        ], r"$d/d_{\mathrm{min}}=" + f"{', '.join(values)}$"
    if profile.contact == "complete" and nt.R in profile.parameters:
        values = ("1", "2", "5")
        contact = numbers.values[nt.a] ** 2 / numbers.values[nt.R]
        members = [(v, numbers.at(d=contact * (sp.Rational(v) + sp.Rational(1, 10**9)))) for v in values]
        return members, f"$dR/a^2={', '.join(values)}$"
    length = next((s for s in (nt.b, nt.s, nt.wavelength) if s in profile.parameters), None)
    if length is not None:
        values = {nt.b: ("0.3", "1", "10"), nt.s: ("0.3", "0.9", "1.5")}.get(length, ("0.5", "1", "3"))
        members = [(v, numbers.at(a=sp.Rational(v) * numbers.values[length])) for v in values]
        return members, f"$a/{nt.describe(length).latex}={', '.join(values)}$"
    return [("", numbers)], ""


def _lift(profile: Profile, n: sp.Rational) -> dict[str, Any]:
    """Depth of a concave face of power n that keeps it in complete contact."""
    return {"d": sp.Integer(3) * max(n, 1) * sp.Rational(15, 100)} if profile.contact == "complete" else {}


def _radii(breaks: list[float]) -> list[float]:
    """Fractions of the contact radius, dense at the edge and around every break."""
    found = {
        0.002,
        0.005,
        0.01,
        0.02,
        *(i / 40 for i in range(1, 39)),
        0.96,
        0.97,
        0.98,
        0.985,
        0.99,
        0.995,
        0.998,
        0.9995,
    }
    for b in breaks:
        found |= {b * (1 + s * gap) for gap in (1e-6, 1e-5, 1e-4, 5e-4, 2e-3, 5e-3, 0.01, 0.02, 0.04) for s in (-1, 1)}
    return sorted(x for x in found if 0 < x < 1 and all(abs(x - b) > 1e-9 for b in breaks))


def _pressure(numbers: Numbers) -> Rows:
    radius, mean = numbers["a"], numbers.mean_pressure
    breaks = [float(numbers[b.name] / radius) for b in numbers.profile.breaks]
    rows = [(x, float(numbers("p", mp.mpf(x) * radius) / mean)) for x in _radii(breaks)]
    rows += [(b, TOP) for b in breaks if b < 1 and _grows([y for x, y in rows if 0 < b - x < 2e-4 * b])]
    return cut(sorted(rows))


def cut(rows: Rows) -> Rows:
    """The rows up to TOP, and where they cross it: towards a sharp edge 1/p**2 goes to zero with the distance."""
    found = [(x, y) for x, y in rows if y <= TOP]
    for (x0, y0), (x1, y1) in pairwise(rows):
        if min(y0, y1) < TOP < max(y0, y1):
            share = (y0**-2 - TOP**-2) / (y0**-2 - y1**-2)
            found.append((x0 + share * (x1 - x0), TOP))
    return sorted(found)


def _grows(towards: list[float]) -> bool:
    """Whether the last of three decades adds to a pressure as much as the one before it: it is infinite."""
    first, second, third = towards[-3:]
    return third - second > max(0.5 * (second - first), 1e-3)


# dense towards the edge
RADII = [math.sin(math.pi / 2 * i / 60) for i in range(61)]
SPHERE: Rows = [(x, 1.5 * math.sqrt(1 - x * x)) for x in RADII]
PUNCH: Rows = [(x, 0.5 / math.sqrt(1 - x * x)) for x in RADII[:-1] if 0.5 / math.sqrt(1 - x * x) < 4.2]


def _force(profile: Profile, numbers: Numbers) -> tuple[Curve, str]:
    """Force over depth, both in units of the contact that is drawn in the sketch."""
    depth, force = numbers.depth, numbers("F")
    if numbers.place("p") == nt.x and profile.contact == "complete":
        return _strip_under_load(numbers)
    if profile.contact == "complete":
        start = numbers("dmin") if "dmin" in numbers.entries and not _needs_ring(numbers) else mp.mpf("1e-4")
        depths = [start + (WIDEST * depth - start) * mp.mpf(i) / 40 for i in range(41)]
        rows = [(float(d / depth), float(numbers.at(d=d)("F") / force)) for d in depths]
        reference = "$(d_1, F_1)$: the contact of the sketch"
    else:
        low, high = contact_range(profile, numbers)
        radii = [low + (high - low) * (mp.mpf(i) / 40) ** 2 for i in range(41)]
        members = [numbers.at(a=radius) for radius in radii]
        rows = [(float(m("d") / depth), float(m("F") / force)) for m in members]
        unit = "P_1=P(a_1)" if numbers.place("p") == nt.x else r"F_1=F_{\mathrm N}(a_1)"
        reference = f"$d_1=d(a_1)$, ${unit}$" + _reference(profile, numbers)
        if numbers.place("p") == nt.x and rows[-1][0] < 0.99 * WIDEST:
            reference += "; to the half-width $L$"
    x, y = rows[int(len(rows) * 0.7)]
    return Curve(coordinates(rows), "", round(x, 3), round(y, 3)), reference


def _strip_under_load(numbers: Numbers) -> tuple[Curve, str]:
    """The depth of a strip whose edge is fixed goes with the load."""
    load, depth = numbers("F"), numbers.depth
    rows = [(float(numbers.at(P=load * s).depth / depth), float(s)) for s in (mp.mpf(i) / 10 for i in range(0, 33, 2))]
    return Curve(coordinates(sorted(rows)), "", 1.0, 1.0), "$(d_1, P_1)$: the contact of the sketch"


def _needs_ring(numbers: Numbers) -> bool:
    return any(case.expr.has(nt.r_zero) for case in numbers.entries["dmin"].cases)


def _reference(profile: Profile, numbers: Numbers) -> str:
    """What the reference contact is, unless the curve is the same for all."""
    if (
        len(profile.pieces) == 1
        and sp.sympify(profile.pieces[0].expr).as_independent(nt.r, as_Add=False)[1].as_base_exp()[0] == nt.r
    ):
        return "; a universal curve"
    length = next(
        (s for s in (*profile.breaks, *profile.chain, nt.b, nt.s, nt.wavelength) if s in numbers.values and s != nt.a),
        None,
    )
    if length is None:
        return " of the sketch"
    ratio = mp.nstr(numbers["a"] / numbers[length.name], 3)
    return f" at $a_1={ratio}\\,{nt.describe(length).latex}$"


def contact_range(profile: Profile, numbers: Numbers) -> tuple[Any, Any]:
    """Contact radii from nothing to the depth at the right end of the plot, or to the largest contact there is."""
    radius, goal = numbers["a"], mp.mpf(WIDEST) * numbers.depth
    low = numbers[profile.breaks[0].name] * (1 + mp.mpf("1e-9")) if profile.truncated else radius * mp.mpf("1e-3")
    highest = radius * 8
    if nt.a in profile.chain:
        highest = numbers[profile.chain[-1].name] * (1 - mp.mpf("1e-6"))
    elif profile.largest is not None:
        highest = numbers.values[nt.s] * mp.mpf("1.5")
    if numbers.place("p") == nt.x:
        highest = mp.mpf(REACH.p) / REACH.q * radius * (1 - mp.mpf("1e-6"))
    if numbers.at(a=highest)("d") <= goal:
        return low, highest
    below, above = radius, highest
    for _ in range(40):
        middle = (below + above) / 2
        below, above = (middle, above) if numbers.at(a=middle)("d") < goal else (below, middle)
    return low, above
