"""What a build says while it runs, a line for each problem that it works on, and at its end."""

from __future__ import annotations

import sys
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Any

from ..physics import systems
from ..store.index import table

if TYPE_CHECKING:
    from .catalogue import Catalogue, Failure
    from .work import Outcome

HEAD = ["profile", "formulas", "closed", "integral", "root", "certified", "worst residual", "time"]


class Progress:
    """Counts finished problems; `--quiet` says nothing but failures."""

    def __init__(self, total: int, *, quiet: bool) -> None:
        self.total, self.quiet, self.done = total, quiet, 0

    def finished(self, outcome: Outcome) -> None:
        """Counts one problem, and says a line of it unless it was cached."""
        self.done += 1
        if not outcome.cached:
            count = f"{self.done:>{len(str(self.total))}}/{self.total}"
            state = f"{len(outcome.entries):3} formulas" if not outcome.error else "failed"
            self.say(f"{count}  {outcome.key:28} {state}  {outcome.seconds:6.1f} s")

    def say(self, text: str) -> None:
        """Writes a line to standard error, unless the build is quiet."""
        if not self.quiet:
            print(text, file=sys.stderr, flush=True)


def summary(catalogue: Catalogue) -> str:
    """The table of profiles, all physics together, with a line of totals."""
    rows: dict[str, list[Any]] = {}
    for outcome in catalogue.outcomes:
        if not outcome.error:
            name = systems.problem(outcome.key).profile_id
            rows[name] = _sum(name, [rows[name], _row(outcome)]) if name in rows else _row(outcome)
    if not rows:
        return ""
    cells = [HEAD, *([*map(str, row[:-1]), f"{row[-1]:.1f} s"] for row in [*rows.values(), _sum("all", rows.values())])]
    widths = [0, *(max(map(len, column)) for column in list(zip(*cells, strict=True))[1:])]
    return table([[cell.rjust(width) for cell, width in zip(row, widths, strict=True)] for row in cells])


def taken_over(catalogue: Catalogue) -> str:
    """How much numerical evidence was not made anew."""
    checks, errors = catalogue.kept
    made = sum(not outcome.cached for outcome in catalogue.outcomes)
    derived = f"{made} of {len(catalogue.outcomes)} problems were derived and proved now"
    if made < len(catalogue.outcomes):
        derived += ", the others by an earlier build from the same inputs"
    if not checks and not errors:
        return derived
    return (
        f"{derived}; checks of {checks} and measured errors of {errors} are those of the catalogue, "
        "from the same inputs (--fresh repeats everything)"
    )


def _row(outcome: Outcome) -> list[Any]:
    statuses = [record["status"] for record in outcome.entries.values()]
    evidence = outcome.evidence.get("entries", {})
    certified = sum(1 for found in evidence.values() if found.get("certified"))
    worst = max((found["residual"] for found in evidence.values() if found.get("residual")), key=float, default="")
    counts = [statuses.count(status) for status in ("closed", "integral", "root")]
    name = systems.problem(outcome.key).profile_id
    return [name, len(statuses), *counts, certified, worst, outcome.seconds]


def _sum(name: str, rows: Collection[list[Any]]) -> list[Any]:
    totals = [sum(row[i] for row in rows) for i in range(1, 6)]
    worst = max((row[6] for row in rows if row[6]), key=float, default="")
    return [name, *totals, worst, sum(row[7] for row in rows)]


def failure_lines(failures: Sequence[Failure], *, seed: int, verbose: bool) -> list[str]:
    """Short: what failed, and how to see it again."""
    lines = []
    for failure in failures:
        again = f"axicontact check {failure.key} --seed {seed}"
        if failure.trace:
            name = systems.problem(failure.key).profile_id
            again = f"axicontact build --fresh --jobs 1 --only {name}"
        lines.append(f"{failure.key}: {failure.message}\n    again: {again} -v")
        if verbose and failure.trace:
            lines.append(failure.trace.rstrip())
    if lines:
        lines.append(f"left out of the catalogue: {', '.join(dict.fromkeys(map(_problem, failures)))}")
    return lines


def worse_lines(catalogue: Catalogue) -> list[str]:
    """The functions whose measured errors have jumped, and what to do about them."""
    lines = [f"{key}: {sentence}" for key, sentence in catalogue.worse]
    if lines:
        key = catalogue.worse[0][0]
        lines.append(f"find the cause, or say in the commit why it stays; axicontact check {key} -v measures again")
    return lines


def _problem(failure: Failure) -> str:
    """Key of the problem that a failure keeps out: its own, or that of the formula that failed."""
    known = {problem.key for problem in systems.problems()}
    return failure.key if failure.key in known else failure.key.rpartition(".")[0]
