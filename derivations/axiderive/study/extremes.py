"""Stiff and extreme cases.

Stiff and extreme cases: one formula at one point, where a length or an exponent runs to the end of its range.

Stiff and extreme cases: emitted beside naive at the ends of the ranges.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

import sympy as sp

from .. import notation as nt
from ..oracle.evaluate import evaluate
from .naive import Point, judged, reference
from .problems import NAMES, PARAMETERS
from .report import Record, rounded, table, versions
from .subject import entries

NEAR = (3, 6, 9, 12, 15)
FAR = (*NEAR, 100, 300)
SCALES = (-300, -150, -30, 30, 150, 300)
EXPONENTS = (1e-3, 1e-2, 0.1, 40.0, 100.0, 1000.0)
WHOLE = (-1, 0, 1)
QUICK = 1
"""Steps of each limit in the quick mode."""
RADIUS = 2.0
BREAKS = ("rounded_punch", "truncated_cone")
T = TypeVar("T")


@dataclass(frozen=True)
class Case:
    """One formula at one point of a limit."""

    limit: str
    problem: str
    suffix: str
    label: str
    point: Point


Place = tuple[str, str, Point]
"""Suffix, where on the surface, and the point."""


def _some(steps: Sequence[T], quick: bool) -> Sequence[T]:
    return steps[:QUICK] if quick else steps


def _near(distance: int) -> float:
    return float(10.0**-distance)


def _places(base: Point) -> Iterator[Place]:
    """Depth, force, a pressure on each side of a break and a displacement, for one contact."""
    a, b = base[nt.a], base.get(nt.b)
    yield "d", "", base
    yield "F", "", base
    inside = [("r = a/2", a / 2)] if b is None else [("r = b/2", b / 2), ("r = (a + b)/2", a / 2 + b / 2)]
    for where, r in inside:
        yield "p", where, {**base, nt.r: r}
    yield "w", "r = 3a/2", {**base, nt.r: 1.5 * a}


def _base(problem: str, **changed: float) -> Point:
    parameters = entries(problem)["d"].profile.parameters
    point = {symbol: PARAMETERS[symbol] for symbol in (*parameters, nt.E_star)} | {nt.a: RADIUS}
    return point | {sp.Symbol(name, positive=True): value for name, value in changed.items()}


def _breaks(steps: Sequence[int], place: Callable[[int], float], limit: str, label: str) -> Iterator[Case]:
    for problem in BREAKS:
        for step in steps:
            for suffix, where, point in _places(_base(problem, b=place(step))):
                yield Case(limit, problem, suffix, _joined(f"{label} = 1e-{step}", where), point)


def _joined(*parts: str) -> str:
    return ", ".join(part for part in parts if part)


def small_breaks(quick: bool) -> Iterator[Case]:
    """Cases with a break that vanishes beside the contact radius; fewer in the quick mode."""
    yield from _breaks(_some(FAR, quick), lambda step: RADIUS * _near(step), "b -> 0", "b/a")


def close_breaks(quick: bool) -> Iterator[Case]:
    """Cases with a break just below the contact radius."""
    yield from _breaks(_some(NEAR, quick), lambda step: RADIUS * (1 - _near(step)), "b -> a", "1 - b/a")


def large_spheres(quick: bool) -> Iterator[Case]:
    """Cases of a sphere much larger than its contact."""
    for step in _some(FAR, quick):
        for suffix, where, point in _places(_base("sphere", R=RADIUS / _near(step))):
            yield Case("R -> infinity", "sphere", suffix, _joined(f"a/R = 1e-{step}", where), point)


def hemispheres(quick: bool) -> Iterator[Case]:
    """Cases of a sphere whose contact radius is almost its own radius."""
    for step in _some(NEAR, quick):
        for suffix, where, point in _places(_base("sphere", R=RADIUS / (1 - _near(step)))):
            yield Case("a -> R", "sphere", suffix, _joined(f"1 - a/R = 1e-{step}", where), point)


def exponents(quick: bool) -> Iterator[Case]:
    """Cases of a power law with very small and very large exponents."""
    for n in _some(EXPONENTS, quick):
        limit = "n -> 0" if n < 1 else "n large"
        for suffix, where, point in _places(_base("power_law", n=n, a=1.0)):
            yield Case(limit, "power_law", suffix, _joined(f"n = {n:g}", where), point)


def edges(quick: bool) -> Iterator[Case]:
    """Towards the edge of the contact from both sides."""
    for problem in NAMES:
        for step in _some(NEAR, quick):
            for suffix, r in (("p", RADIUS * (1 - _near(step))), ("w", RADIUS * (1 + _near(step)))):
                yield Case("edge", problem, suffix, f"|1 - r/a| = 1e-{step}", _base(problem, r=r))


def axes(quick: bool) -> Iterator[Case]:
    """Towards the axis, and far away."""
    for problem in NAMES:
        for step in _some(FAR, quick):
            yield Case("axis", problem, "p", f"r/a = 1e-{step}", _base(problem, r=RADIUS * _near(step)))
            yield Case("far away", problem, "w", f"a/r = 1e-{step}", _base(problem, r=RADIUS / _near(step)))


def scales(quick: bool) -> Iterator[Case]:
    """All lengths at the ends of the range of doubles."""
    for problem in NAMES:
        for decade in _some(SCALES, quick):
            scale = 10.0**decade
            base = _base(problem)
            lengths = [s for s in base if nt.describe(s).dimension == nt.LENGTH]
            base |= {symbol: base[symbol] * scale for symbol in lengths}
            if nt.A in base:
                base[nt.A] = _amplitude(base[nt.n], decade)
            if all(0 < x < math.inf for x in base.values()):
                for suffix, where, point in _places(base):
                    yield Case("float range", problem, suffix, _joined(f"lengths 1e{decade}", where), point)


def _amplitude(n: float, decade: int) -> float:
    """A of A r**n that keeps height over length; 0 where it leaves the range."""
    decades = decade * (1 - n)
    return PARAMETERS[nt.A] * 10.0**decades if abs(decades) < 300 else 0.0


def grading(quick: bool) -> Iterator[Case]:
    """The exponent of the graded half-space next to -1, 0 and 1."""
    problem = "power_law.fgm"
    known = entries(problem)
    material = [s for s in known["F"].parameters if s not in known["d"].parameters]
    for whole in WHOLE:
        for step in _some(NEAR, quick):
            k = whole + _near(step) if whole < 1 else whole - _near(step)
            base = {symbol: PARAMETERS[symbol] for symbol in (nt.A, nt.n)} | dict.fromkeys(material, 1.0)
            for suffix, where, point in _places(base | {nt.k: k, nt.a: RADIUS}):
                yield Case(f"k -> {whole}", problem, suffix, _joined(f"k = {k!r}", where), point)


def pull_off(quick: bool) -> Iterator[Case]:
    """The stable contact next to pull-off under force control: a(F) at F = F_c (1 - x)."""
    for problem in ("paraboloid.adh", "cone.adh"):
        base = {symbol: PARAMETERS.get(symbol, 1.0) for symbol in entries(problem)["Fc"].parameters}
        force, radius = (float(evaluate(entries(problem)[suffix].cases[0].expr, base, 30)) for suffix in ("Fc", "ac"))
        for step in _some(NEAR, quick):
            # the radius of the point is where its search starts: it grows with the root of the distance
            point = base | {nt.F: force * (1 - _near(step)), nt.a: radius * (1 + math.sqrt(_near(step)))}
            yield Case("pull-off", problem, "aF", f"1 - F/F_c = 1e-{step}", point)


LIMITS = (
    small_breaks, close_breaks, large_spheres, hemispheres, exponents, edges, axes, scales, grading, pull_off,
)  # fmt: skip


NOTE = (
    "errors are relative to an Arb enclosure of the closed form at the doubles given, null where the value is NaN, "
    "infinite or refused; ulps in units of the last place of the exact value. Cases whose exact value is no normal "
    "double, or whose arguments are none, are left out."
)


def measure(*, quick: bool = False) -> Record:
    """The record of the study."""
    rows: list[Record] = []
    skipped: list[Record] = []
    for limit in LIMITS:
        try:
            rows += [row for case in limit(quick) for row in _row(case)]
        except ImportError as error:
            skipped.append({"limit": limit.__name__, "reason": f"the catalogue has no such module yet ({error})"})
    parameters = {str(symbol): value for symbol, value in PARAMETERS.items()} | {"a": RADIUS}
    return {
        "study": "extremes",
        "note": NOTE,
        "settings": {"parameters": parameters, "versions": versions()},
        "rows": rows,
        "skipped": skipped,
    }


def _row(case: Case) -> list[Record]:
    exact = reference(case.problem, case.suffix, case.point)
    if exact is None:
        return []
    found = {way: ones[0] for way, ones in judged(case.problem, case.suffix, [case.point], [exact]).items()}
    errors = {way: rounded(one.relative) for way, one in found.items()}
    return [
        {
            "limit": case.limit,
            "key": f"{case.problem}.{case.suffix}",
            "case": case.label,
            **errors,
            "ulps": rounded(found["emitted"].ulps),
        }
    ]


def text(record: Record) -> str:
    """One line per limit and formula: the worst case of each way, and how many values are lost."""
    groups: dict[tuple[str, str], list[Record]] = {}
    for row in record["rows"]:
        groups.setdefault((row["limit"], row["key"]), []).append(row)
    head = ("limit", "key", "cases", "emitted", "ulps", "lost", "naive", "lost", "worst emitted case")
    lines = []
    for (limit, key), rows in groups.items():
        worst = max(rows, key=lambda row: math.inf if row["ulps"] is None else row["ulps"])
        lines.append((limit, key, len(rows), *_worst(rows, "emitted", "ulps"), *_worst(rows, "naive"), worst["case"]))
    notes = [f"skipped  {row['limit']}: {row['reason']}" for row in record["skipped"]]
    return "\n".join([table(head, lines), *notes])


def _worst(rows: list[Record], *ways: str) -> tuple[float | int | None, ...]:
    worst = [max((row[way] for row in rows if row[way] is not None), default=None) for way in ways]
    return *worst, sum(row[ways[0]] is None for row in rows)
