"""Error against run time of p(r), F(d) and w(r): the emitted function beside every other way.

Each method runs in turn with the emitted function, repeated; only the median
of the ratios of their processor times per point is kept, because times belong
to a machine.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import Any

from .methods import DIGITS, QUICK, Method, Plan, exact, methods, skipped
from .report import Record, paired, relative, rounded, summary, table, versions
from .subject import EVERY, FURTHER, PARAMETERS, RADIUS, Subject, named, subject

NOTE = (
    "ratio: median over interleaved repeats in one run of (processor time per point of the method)/(of the emitted "
    "function, over settings.vector points, or as many as settings.longest, in s, allows), "
    "two digits; no times are kept, they differ from machine to machine and so, less, do the ratios. "
    "Graded and plane contacts of the pages of the profiles have the settings of settings.brief. "
    "Errors are relative to the defining integral at the doubles given, at `points` points. "
    "Rivals are given f', g and g' in closed form, from break to break. Grid methods are compared at their nodes next "
    "to the points."
)


KNOWN = tuple(EVERY)


def measure(names: Sequence[str] = KNOWN, *, quick: bool = False) -> Record:
    """The record of the study."""
    plan = QUICK if quick else Plan()
    rows: list[Record] = []
    missing: list[dict[str, str]] = []
    for name in names:
        for suffix in EVERY[name]:
            rows += list(_rows(subject(name), suffix, plan))
            missing += skipped(subject(name), suffix)
    parameters = named(PARAMETERS) | {"a": RADIUS}
    own = {name: FURTHER.get(subject(name).problem.name) for name in names}
    parameters |= {name: named(values) for name, values in own.items() if values}
    return {
        "study": "error",
        "note": NOTE,
        "settings": {
            **_plain(asdict(plan)),
            "brief": _plain(plan.brief),
            "reference_digits": DIGITS,
            "parameters": parameters,
            "versions": versions(),
        },
        "rows": rows,
        "skipped": missing,
    }


def _plain(settings: Mapping[str, Any]) -> Record:
    return {name: list(value) if isinstance(value, tuple) else value for name, value in settings.items()}


def _rows(subject: Subject, suffix: str, plan: Plan) -> Iterator[Record]:
    own: Method | None = None
    for method in methods(subject, suffix, plan):
        own = own or method
        ratio = paired(method.run, own.run, plan.rounds) * own.count / method.count
        told = {"key": f"{subject.name}.{suffix}", "method": method.name, "setting": method.setting}
        yield told | {"ratio": rounded(ratio)} | summary(errors(subject, suffix, method))


def errors(subject: Subject, suffix: str, method: Method) -> list[float]:
    """Relative errors at the arguments of the method."""
    values = method.run()
    pairs = zip(method.pick, method.at, strict=True)
    return [relative(values[i], exact(subject, suffix, float(x))) for i, x in pairs]


def text(record: Record) -> str:
    """One line per method and setting."""
    columns = ("key", "method", "setting", "ratio", "worst", "median", "lost")
    rows = [[row[column] for column in columns] for row in record["rows"]]
    notes = sorted({f"{row['method']}: {row['reason']}" for row in record["skipped"]})
    return "\n".join([table(columns, rows), *(f"skipped  {note}" for note in notes)])
