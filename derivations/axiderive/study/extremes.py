"""Stiff and extreme cases: emitted beside naive at the ends of the ranges."""

from __future__ import annotations

import math

from .accuracy import judged, reference
from .limits import LIMITS, RADIUS, Case
from .problems import PARAMETERS
from .report import Record, rounded, table, versions

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
