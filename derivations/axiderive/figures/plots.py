"""The two plots of an entry: pressure over its mean, and what the force, the depth or the surface do.

Force over depth is drawn between the laws of the tip and of the flanks; where
it is one power of the depth it would say nothing, and is left out.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..print.formula import Printer
from ..profiles.profile import Profile
from .axes import HIGHEST, Axes, Mark, Shown, axes, short
from .drawing import Rows
from .values import Numbers, sketch_values

TOP = HIGHEST * 1.06
RATIOS = ("0.25", "0.5", "0.8")


def plots(profile: Profile, numbers: Numbers) -> tuple[Axes, ...]:
    """At the values of the profile's file, with its most telling ratio varied in the pressure."""
    plane = numbers.place("p") == nt.x
    family, name = _family(profile, numbers)
    rows = [(_pressure(member), label) for label, member in family]
    # the semicircle of a cylinder and the strip, each over its own mean
    known: list[Shown] = (
        [(_scaled(HERTZ, 8 / (3 * math.pi)), "cylinder"), (_scaled(PUNCH, 4 / math.pi), "flat strip")]
        if plane
        else [(HERTZ, "Hertz"), (PUNCH, "flat punch")]
    )
    against = f"against {' and '.join(label for _, label in known)}"
    words = f"over its mean, for {name}, {against}." if name else f"over its mean, {against}."
    axis = "$x/a$" if plane else "$r/a$"
    pressure = axes((axis, r"$p/\bar p$"), (0.0, 1.0), (0.0, HIGHEST), rows, ("Pressure", words), known)
    second: Axes | None
    if plane:
        second = _reach(numbers)
    elif profile.complete:
        second = _beside(numbers) if profile.pieces[0].expr == 0 else _pressed(profile, numbers)
    else:
        second = None if _one_power(profile) else _between(profile, numbers)
    return (pressure, second) if second else (pressure,)


def _scaled(rows: Rows, factor: float) -> Rows:
    return [(x, y * factor) for x, y in rows]


def _family(profile: Profile, numbers: Numbers) -> tuple[list[tuple[str, Numbers]], str]:
    """The same profile at several values of one dimensionless ratio."""
    values = numbers.values

    def members(name: str, ratios: Sequence[str], changed: Callable[[Any], dict[str, Any]]) -> Any:
        family = [(ratio, numbers.at(**changed(sp.Rational(ratio)))) for ratio in ratios]
        return family, f"${name}={', '.join(ratios)}$"

    if "Pmin" in numbers.entries:
        load = sp.nsimplify(numbers.least, rational=True)
        return members(r"P/P_{\mathrm{min}}", ("1", "2", "4"), lambda v: {"P": load * v})
    if profile.breaks:
        b = profile.breaks[0]
        return members(f"{nt.describe(b).latex}/a", RATIOS, lambda v: {"a": values[b] / v})
    if nt.n in profile.parameters:
        exponents = ("1.5", "2", "4") if profile.complete else ("0.5", "1", "2", "4")
        return members("n", exponents, lambda v: {"n": v, **_lift(profile, v)})
    if nt.a in profile.chain:
        bound = profile.chain[-1]
        return members(f"a/{nt.describe(bound).latex}", ("0.5", "0.9", "0.99"), lambda v: {"a": v * values[bound]})
    if nt.h in profile.parameters and profile.complete:
        least = sp.nsimplify(numbers.least, rational=True)
        return members(r"d/d_{\mathrm{min}}", ("1", "2", "4"), lambda v: {"d": least * v})
    if profile.complete and nt.R in profile.parameters:
        contact = values[nt.a] ** 2 / values[nt.R]
        return members("dR/a^2", ("1", "2", "5"), lambda v: {"d": contact * (v + sp.Rational(1, 10**9))})
    length = next((s for s in (nt.b, nt.s, nt.wavelength) if s in profile.parameters), None)
    if length is not None:
        ratios = {nt.b: ("0.3", "1", "10"), nt.s: ("0.3", "0.9", "1.5")}.get(length, ("0.5", "1", "3"))
        return members(f"a/{nt.describe(length).latex}", ratios, lambda v: {"a": v * values[length]})
    return [("", numbers)], ""


def _lift(profile: Profile, n: sp.Rational) -> dict[str, Any]:
    """Depth of a concave face of power n that keeps it in complete contact."""
    return {"d": sp.Integer(3) * max(n, 1) * sp.Rational(15, 100)} if profile.complete else {}


def _radii(breaks: list[float]) -> list[float]:
    """Fractions of the contact radius, dense at the edge and around every break."""
    ends = (0.002, 0.005, 0.01, 0.02, 0.96, 0.97, 0.98, 0.985, 0.99, 0.995, 0.998, 0.9995)
    found = {*ends, *(i / 40 for i in range(1, 39))}
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
HERTZ: Rows = [(x, 1.5 * math.sqrt(1 - x * x)) for x in RADII]
PUNCH: Rows = [(x, 0.5 / math.sqrt(1 - x * x)) for x in RADII[:-1] if 0.5 / math.sqrt(1 - x * x) < 4.2]


def _one_power(profile: Profile) -> bool:
    """Whether the profile is a single power of the radius."""
    if len(profile.pieces) > 1:
        return False
    _, rest = sp.sympify(profile.pieces[0].expr).as_independent(nt.r, as_Add=False)
    return bool(rest.as_base_exp()[0] == nt.r)


STRAIGHT = {0: "flat punch", 1: "cone", 2: "paraboloid"}
"""What a tip or a flank of this power is alone."""
FAR = mp.mpf(1000)
"""Radius over the length of a profile at which it follows its flank, and the inverse at which it follows its tip."""
DECADES = (0.05, 20.0)
"""Depths of the plot, in units of the profile, where the contact may grow as far."""


def _unit(profile: Profile) -> tuple[sp.Expr, sp.Expr]:
    """Height and length that a profile is made of: what its depth and its radius are measured in."""
    own = set(profile.parameters)
    if {nt.R, nt.h, nt.wavelength} <= own:
        return nt.wavelength**2 / nt.R, nt.wavelength
    if nt.theta in own:
        return nt.b * sp.tan(nt.theta), nt.b
    length = next((s for s in (nt.b, nt.s) if s in own), nt.a if profile.complete else nt.R)
    if nt.h in own:
        return nt.h, length
    curvature = next((s for s in (nt.R2, nt.R) if s in own), None)
    if curvature == length:
        return nt.R, nt.R
    return (length**2 / curvature, length) if curvature else (sp.S.One, sp.S.One)


def _names(height: sp.Expr, length: sp.Expr, given: bool) -> tuple[str, str]:
    """d and F_N over their units; without one, over those of the sketch."""
    if not given:
        return r"$d/d_1$", r"$F_{\mathrm N}/F_1$"
    return f"${_inline(nt.d, height)}$", f"${_inline(nt.F, nt.E_star * height * length)}$"


def _inline(what: sp.Symbol, unit: sp.Expr) -> str:
    """One quantity over its unit on one line."""
    below, above = sp.fraction(unit)
    over = Printer()(what * above)
    return f"{over}/({Printer()(below)})" if below.is_Mul else f"{over}/{Printer()(below)}"


def _between(profile: Profile, numbers: Numbers) -> Axes:
    """Force over depth of a compact contact, with the powers that its tip and its flank would follow alone."""
    height, length = _unit(profile)
    given = height != 1
    size = mp.mpf(str(length.xreplace(numbers.values).evalf(20))) if given else numbers["a"]
    depth = mp.mpf(str(height.xreplace(numbers.values).evalf(20))) if given else numbers.depth
    force = depth * size if given else numbers("F")

    def state(radius: Any) -> tuple[float, float]:
        member = numbers.at(a=radius)
        return float(member("d") / depth), float(member("F") / force)

    low = numbers[profile.breaks[0].name] if profile.truncated else mp.mpf(0)
    bound = _largest(profile, numbers)
    first = _radius_at(state, low, size, DECADES[0], bound)
    last = _radius_at(state, low, size, DECADES[1], bound)
    count = 60
    radii = [low + (first - low) * ((last - low) / (first - low)) ** (mp.mpf(i) / count) for i in range(count + 1)]
    rows = [state(radius) for radius in radii]
    ends = (DECADES[0], _rounded_up(rows[-1][0]))
    names = []
    references: list[Shown] = []
    small, large = _power(numbers, size / FAR), None if bound else _power(numbers, size * FAR)
    for power, at in ((small, (first - low) / FAR + low), (large, size * FAR)):
        if power is None:
            continue
        x0, y0 = state(at)
        exponent = 1 + 1 / power if power else 1.0
        label = _label(profile, power, at < size)
        names.append(label)
        references.append(([(x, y0 * (x / x0) ** exponent) for x in _steps(*ends)], label))
    bottom, top = 10 ** math.floor(math.log10(rows[0][1])), 10 ** math.ceil(math.log10(rows[-1][1]))
    marks: tuple[Mark, ...] = ()
    if profile.breaks and not profile.truncated:
        name = nt.describe(profile.breaks[0]).latex
        x, y = state(numbers[profile.breaks[0].name] * (1 + mp.mpf("1e-9")))
        marks = (Mark(*short(x, y), f"a={name}"),)
    inside = [([(x, y) for x, y in line if bottom <= y <= top], label) for line, label in references]
    words = _told(names) + ("; at the dot the contact reaches the break." if marks else ".")
    return axes(
        _names(height, length, given), ends, (bottom, top), [(rows, "")], ("Force and depth", words), inside, marks,
        (True, True),
    )  # fmt: skip


def _told(names: list[str]) -> str:
    """What the grey lines are."""
    if len(names) == 1:
        return f"in grey the {names[0]} that has its tip"
    return f"from the law of {_article(names[0])} to that of {_article(names[1])}, in grey"


def _article(name: str) -> str:
    return name if name.startswith(("power", "no ", "both")) else f"the {name}"


def _rounded_up(value: float) -> float:
    """The next of 1, 2 and 5 times a power of ten."""
    power = 10 ** math.floor(math.log10(value))
    return next(float(f"{step * power:.4g}") for step in (1, 2, 5, 10) if step * power >= value * (1 - 1e-6))


def _steps(low: float, high: float) -> list[float]:
    return [low * (high / low) ** (i / 40) for i in range(41)]


def _label(profile: Profile, power: int, tip: bool) -> str:
    """What the profile is alone at its tip, or far from it."""
    if nt.R1 in profile.parameters:
        return "inner radius" if tip else "outer radius" if profile.name == "capped_paraboloid" else "both radii"
    if nt.wavelength in profile.parameters:
        return "crest" if tip else "no waves"
    return STRAIGHT.get(power, f"power {power}")


def _power(numbers: Numbers, radius: Any) -> int:
    """The power of the radius that the profile follows around this one; 0 where it is flat."""
    near, beyond = numbers.shape(radius), numbers.shape(2 * radius)
    return round(float(mp.log(beyond / near, 2))) if near else 0


def _largest(profile: Profile, numbers: Numbers) -> Any:
    """The largest radius there is, or none."""
    if nt.a in profile.chain:
        return numbers[profile.chain[-1].name] * (1 - mp.mpf("1e-6"))
    return numbers.values[nt.s] * mp.mpf("1.5") if profile.largest is not None and nt.s in numbers.values else None


def _radius_at(state: Callable[[Any], tuple[float, float]], low: Any, size: Any, goal: float, bound: Any = None) -> Any:
    """The radius at which the depth is the goal, or the largest one."""
    under, above = low + size * mp.mpf("1e-9"), bound or low + size * mp.mpf("1e5")
    if state(above)[0] <= goal:
        return above
    for _ in range(60):
        middle = low + mp.sqrt((under - low) * (above - low))
        under, above = (middle, above) if state(middle)[0] < goal else (under, middle)
    return under


def _pressed(profile: Profile, numbers: Numbers) -> Axes:
    """Force over depth of a face that is not flat, from where the whole of it is in contact."""
    height, length = _unit(profile)
    depth, size = (mp.mpf(str(x.xreplace(numbers.values).evalf(20))) for x in (height, length))
    domed = nt.R in profile.parameters
    least = depth if domed else numbers.least
    depths = [least * mp.mpf(i) / 20 for i in range(1 if domed else 20, 61)]
    rows = [(float(d / depth), float(numbers.at(d=d)("F") / (depth * size))) for d in depths]
    x, y = next(row for row in rows if row[0] >= float(least / depth) * (1 - 1e-9))
    end = _rounded_up(rows[-1][0])
    top = _rounded_up(rows[-1][1])
    shown = Mark(*short(x, y), "r=a" if domed else r"d_{\mathrm{min}}")
    references: list[Shown] = []
    if domed:
        references = [
            ([(u, 4 / 3 * u**1.5) for u in (end * i / 40 for i in range(41)) if 4 / 3 * u**1.5 <= top], "no edge")
        ]
        words = "a paraboloid up to the dot, where the edge comes into contact; a straight line from there on."
    else:
        words = "the whole face is in contact from the dot on, and not below."
    return axes(
        _names(height, length, True), (0.0, end), (0.0, top), [(rows, "")], ("Force and depth", words), references,
        (shown,),
    )  # fmt: skip


def _beside(numbers: Numbers) -> Axes:
    """The surface beside a flat punch, and below a force on a point."""
    radius, depth = numbers["a"], numbers.depth
    places = [1 + 4 * (i / 40) ** 2 for i in range(1, 41)]
    rows = [(1.0, 1.0), *((x, float(numbers("w", mp.mpf(x) * radius) / depth)) for x in places)]
    point = [(x, 2 / (math.pi * x)) for x in (1.0, *places)]
    words = "the surface beside the punch; three radii from the axis it is that of a force on a point."
    return axes(("$r/a$", "$w/d$"), (1.0, 5.0), (0.0, 1.0), [(rows, "")], ("Displacement", words), [(point, "point")])


def _reach(numbers: Numbers) -> Axes:
    """The depth of a plane contact over the distance at which it is zero, against that of a flat strip."""
    radius, load = numbers["a"], numbers("F")
    ratios = [10 ** (i / 20) for i in range(41)]
    ratios[0] = 1 + 1e-9
    rows = [(x, float(mp.pi * numbers("d", mp.mpf(x) * radius) / (2 * load))) for x in ratios]
    strip = [(x, math.acosh(x)) for x in ratios]
    inside = [(x, y) for x, y in rows if 0 <= y <= 6]
    words = (
        "the depth grows with the logarithm of the distance $L$ it is measured from;"
        " far away all profiles differ by a constant."
    )
    return axes(
        ("$L/a$", r"$\pi E^{*}d/(2P)$"), (1.0, 100.0), (0.0, 6.0), [(inside, "")], ("Depth", words),
        [] if _near(inside, strip) else [(strip, "flat strip")], (), (True, False),
    )  # fmt: skip


def _near(rows: Rows, others: Rows) -> bool:
    """Whether two curves with the same places are one in print."""
    known = dict(others)
    return all(abs(y - known[x]) < 0.02 for x, y in rows)


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
    pressures = [(_graded_pressure(one), k) for one, k in family]
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


def _graded_pressure(numbers: Numbers) -> Rows:
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
