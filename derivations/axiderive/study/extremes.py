"""Stiff and extreme cases: one formula at one point, where a length or an exponent runs to the end of its range."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from .. import notation as nt
from ..build.pool import Jobs, run
from ..oracle.evaluate import evaluate
from .naive import Point, judged, reference
from .report import Record, rounded, table, versions
from .subject import ADHESIVE, NAMES, OTHER, PARAMETERS, RADIUS, named, subject

NEAR = (3, 6, 9, 12, 15)
FAR = (*NEAR, 100, 300)
SCALES = (-300, -150, -30, 30, 150, 300)
BREAKS = ("rounded_punch", "truncated_cone")
KNOWN = (*NAMES, OTHER, *ADHESIVE)


@dataclass(frozen=True)
class Case:
    """One formula at one point of a limit."""

    limit: str
    problem: str
    suffix: str
    label: str
    point: Point


@dataclass(frozen=True)
class Limit:
    """What is changed in some contacts, step by step; of each contact one formula, or one at each of its places."""

    name: str
    problems: tuple[str, ...]
    steps: Sequence[Any]
    label: str
    changed: Callable[[str, Point, Any], Point]
    """From the problem, its point and the step to the point of the case."""
    suffix: str = ""

    def cases(self, names: Sequence[str] = KNOWN, *, quick: bool = False) -> Iterator[Case]:
        """The cases of these problems, in the quick mode at the first step alone."""
        for problem in (problem for problem in self.problems if problem in names):
            for step in self.steps[:1] if quick else self.steps:
                point, label = self.changed(problem, _base(problem), step), self.label.format(step)
                if not all(0 < x < math.inf for symbol, x in point.items() if symbol not in (nt.k, nt.F)):
                    continue
                for suffix, where, place in [(self.suffix, "", point)] if self.suffix else _places(point):
                    yield Case(self.name, problem, suffix, f"{label}, {where}" if where else label, place)


def _base(problem: str) -> Point:
    known = PARAMETERS | {nt.a: RADIUS}
    return {symbol: known.get(symbol, 1.0) for symbol in (*subject(problem).entries["F"].parameters, nt.a)}


def _places(base: Point) -> Iterator[tuple[str, str, Point]]:
    """Depth, force, a pressure on each side of a break and a displacement, for one contact."""
    a, b = base[nt.a], base.get(nt.b)
    yield "d", "", base
    yield "F", "", base
    inside = [("r = a/2", a / 2)] if b is None else [("r = b/2", b / 2), ("r = (a + b)/2", a / 2 + b / 2)]
    for where, r in inside:
        yield "p", where, {**base, nt.r: r}
    yield "w", "r = 3a/2", {**base, nt.r: 1.5 * a}


def _limit(
    name: str,
    problems: tuple[str, ...],
    steps: Sequence[Any],
    label: str,
    values: Callable[[Any], Point],
    suffix: str = "",
) -> Limit:
    """A limit whose steps say what symbols are."""
    return Limit(name, problems, steps, label, lambda problem, base, step: base | values(step), suffix)


def _near(distance: int) -> float:
    return float(10.0**-distance)


def _scaled(problem: str, base: Point, decade: int) -> Point:
    """All lengths at the ends of the range of doubles; A of A r**n keeps height over length, 0 beyond that range."""
    scale = 10.0**decade
    base = {s: x * scale if nt.describe(s).dimension == nt.LENGTH else x for s, x in base.items()}
    if nt.A in base:
        decades = decade * (1 - base[nt.n])
        base[nt.A] = PARAMETERS[nt.A] * 10.0**decades if abs(decades) < 300 else 0.0
    return base


def _pulled(problem: str, base: Point, distance: int) -> Point:
    """The stable contact next to pull-off under force control: a(F) at F = F_c (1 - x)."""
    known = subject(problem).entries
    force, radius = (float(evaluate(known[suffix].cases[0].expr, base, 30)) for suffix in ("Fc", "ac"))
    # the radius of the point is where its search starts: it grows with the root of the distance
    return base | {nt.F: force * (1 - _near(distance)), nt.a: radius * (1 + math.sqrt(_near(distance)))}


LIMITS = (
    _limit("b -> 0", BREAKS, FAR, "b/a = 1e-{}", lambda x: {nt.b: RADIUS * _near(x)}),
    _limit("b -> a", BREAKS, NEAR, "1 - b/a = 1e-{}", lambda x: {nt.b: RADIUS * (1 - _near(x))}),
    _limit("R -> infinity", ("sphere",), FAR, "a/R = 1e-{}", lambda x: {nt.R: RADIUS / _near(x)}),
    _limit("a -> R", ("sphere",), NEAR, "1 - a/R = 1e-{}", lambda x: {nt.R: RADIUS / (1 - _near(x))}),
    _limit("n -> 0", ("power_law",), (1e-3, 1e-2, 0.1), "n = {:g}", lambda n: {nt.n: n, nt.a: 1.0}),
    _limit("n large", ("power_law",), (40.0, 100.0, 1000.0), "n = {:g}", lambda n: {nt.n: n, nt.a: 1.0}),
    _limit("edge", NAMES, NEAR, "|1 - r/a| = 1e-{}", lambda x: {nt.r: RADIUS * (1 - _near(x))}, "p"),
    _limit("edge", NAMES, NEAR, "|1 - r/a| = 1e-{}", lambda x: {nt.r: RADIUS * (1 + _near(x))}, "w"),
    _limit("axis", NAMES, FAR, "r/a = 1e-{}", lambda x: {nt.r: RADIUS * _near(x)}, "p"),
    _limit("far away", NAMES, FAR, "a/r = 1e-{}", lambda x: {nt.r: RADIUS / _near(x)}, "w"),
    Limit("float range", NAMES, SCALES, "lengths 1e{}", _scaled),
    *(
        _limit(f"k -> {end}", (OTHER,), [end - side * _near(x) for x in NEAR], "k = {!r}", lambda k: {nt.k: k})
        for end, side in ((-1, -1), (0, -1), (1, 1))
    ),
    Limit("pull-off", ADHESIVE, NEAR, "1 - F/F_c = 1e-{}", _pulled, "aF"),
)


NOTE = (
    "errors are relative to an Arb enclosure of the closed form at the doubles given, null where the value is NaN, "
    "infinite or refused; ulps in units of the last place of the exact value. Cases whose exact value is no normal "
    "double, or whose arguments are none, are left out."
)


def measure(names: Sequence[str] = KNOWN, *, quick: bool = False, jobs: Jobs = 1) -> Record:
    """The record of the study."""
    settings = {"parameters": named(PARAMETERS) | {"a": RADIUS}, "versions": versions()}
    cases = [(case,) for limit in LIMITS for case in limit.cases(names, quick=quick)]
    rows = list(chain.from_iterable(run(_row, cases, jobs, ordered=True)))
    return {"study": "extremes", "note": NOTE, "settings": settings, "rows": rows}


def _row(case: Case) -> list[Record]:
    """One row, none where the exact value is no normal double."""
    exact = reference(case.problem, case.suffix, case.point)
    if exact is None:
        return []
    found = {way: ones[0] for way, ones in judged(case.problem, case.suffix, [case.point], [exact]).items()}
    told = {"limit": case.limit, "key": f"{case.problem}.{case.suffix}", "case": case.label}
    errors = {way: rounded(one.relative) for way, one in found.items()}
    return [told | errors | {"ulps": rounded(found["emitted"].ulps)}]


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
    return table(head, lines)


def _worst(rows: list[Record], *ways: str) -> tuple[float | int | None, ...]:
    worst = [max((row[way] for row in rows if row[way] is not None), default=None) for way in ways]
    return *worst, sum(row[ways[0]] is None for row in rows)
