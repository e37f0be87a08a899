"""Error against run time of p(r), F(d) and w(r): the emitted function beside every other way.

Each method runs in turn with the emitted function, repeated; only the median
of the ratios of their processor times per point is kept, because times belong
to a machine.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict

from .methods import QUICK, Method, Plan, methods, skipped
from .points import DIGITS, exact
from .report import Record, relative, rounded, summary, table, versions
from .subject import NAMES, OTHERS, PARAMETERS, QUANTITIES, RADIUS, Subject, subject

SHORTEST = 4e-3
"""Seconds that one timing takes at least: shorter calls are repeated."""
LONGEST = 1.0
"""Seconds beyond which a method is timed three times and no more."""
FLOOR = 2.0**-53
NOTE = (
    "ratio: median over interleaved repeats in one run of (processor time per point of the method)/(of the emitted "
    "function, over settings.vector points), "
    "two digits; no times are kept, they differ from machine to machine and so, less, do the ratios. "
    "Errors are relative to the defining integral at the doubles given, at `points` points. "
    "Rivals are given f', g and g' in closed form. Grid methods are compared at their nodes next to the points. "
    "plots: [ratio, worst error] per method, errors below 2**-53 lifted to it."
)


def measure(names: Sequence[str] = (*NAMES, *OTHERS), *, quick: bool = False, plan: Plan | None = None) -> Record:
    """The record of the study."""
    plan = plan or (QUICK if quick else Plan())
    rows, missing = [], []
    for name in names:
        for suffix in OTHERS.get(name, QUANTITIES):
            rows += list(_rows(subject(name), suffix, plan))
            missing += skipped(subject(name), suffix)
    parameters = {str(symbol): value for symbol, value in PARAMETERS.items()} | {"a": RADIUS}
    return {
        "study": "error",
        "note": NOTE,
        "settings": {**_plain(plan), "reference_digits": DIGITS, "parameters": parameters, "versions": versions()},
        "rows": rows,
        "skipped": missing,
        "plots": _plots(rows),
    }


def _plain(plan: Plan) -> Record:
    return {name: list(value) if isinstance(value, tuple) else value for name, value in asdict(plan).items()}


def _rows(subject: Subject, suffix: str, plan: Plan) -> Iterator[Record]:
    own: Method | None = None
    for method in methods(subject, suffix, plan):
        own = own or method
        found = errors(subject, suffix, method)
        yield {
            "key": f"{subject.name}.{suffix}",
            "method": method.name,
            "setting": method.setting,
            "ratio": rounded(_ratio(method, own, plan.rounds)),
            **summary(found),
        }


def errors(subject: Subject, suffix: str, method: Method) -> list[float]:
    """Relative errors at the arguments of the method."""
    values = method.run()
    pairs = zip(method.pick, method.at, strict=True)
    return [relative(values[i], exact(subject, suffix, float(x))) for i, x in pairs]


def _ratio(method: Method, own: Method, rounds: int) -> float:
    """Median of the ratios of two timings that follow each other."""
    first = _seconds(method, 1)
    counts = [max(1, int(SHORTEST / seconds)) for seconds in (_seconds(own, 1), first)] if rounds > 1 else [1, 1]
    ratios = []
    for _ in range(min(rounds, 3) if first > LONGEST else rounds):
        mine = _seconds(own, counts[0]) / own.count
        ratios.append(_seconds(method, counts[1]) / method.count / mine)
    return statistics.median(ratios)


def _seconds(method: Method, repeats: int) -> float:
    start = time.process_time()
    for _ in range(repeats):
        method.run()
    return (time.process_time() - start) / repeats


def _plots(rows: list[Record]) -> dict[str, dict[str, list[list[float]]]]:
    plots: dict[str, dict[str, list[list[float]]]] = {}
    for row in rows:
        if row["worst"] is not None:
            curve = plots.setdefault(row["key"], {}).setdefault(row["method"], [])
            curve.append([row["ratio"], max(row["worst"], FLOOR)])
    return plots


def text(record: Record) -> str:
    """One line per method and setting."""
    head = ("key", "method", "setting", "time/emitted", "worst", "median", "lost")
    rows = [
        (row["key"], row["method"], row["setting"], row["ratio"], row["worst"], row["median"], row["lost"])
        for row in record["rows"]
    ]
    notes = sorted({f"{row['method']}: {row['reason']}" for row in record["skipped"]})
    return "\n".join([table(head, rows), *(f"skipped  {note}" for note in notes)])
