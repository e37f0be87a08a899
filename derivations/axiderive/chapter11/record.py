"""The checks of the chapter as plain data, for the evidence and the handbook."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from .errata import errata
from .first_principles import steps
from .runner import Row


def record(rows: Iterable[Row], digits: int = 30, seed: int = 11) -> dict[str, Any]:
    """What `runner.run` found, the errata those rows show, and the exact steps from the point load to the punch.

    Returns
    -------
    dict
        JSON-able: the digits demanded, the seed, `rows` (an equation each), `errata` (place, printed, right,
        reason, evidence) and `steps` (equations, claim, holds).
    """
    rows = tuple(rows)
    return {
        "digits": digits,
        "seed": seed,
        "rows": [_row(row) for row in rows],
        "errata": [asdict(erratum) for erratum in errata(digits, seed, rows)],
        "steps": [{"equations": step.equations, "claim": step.claim, "holds": step.holds()} for step in steps()],
    }


def failures(found: Mapping[str, Any]) -> list[str]:
    """What of a record does not hold, one sentence each."""
    wrong = [f"({row['name']}) {row['title']}" for row in found["rows"] if row["verdict"] == "fails"]
    return wrong + [f"{step['equations']}: {step['claim']}" for step in found["steps"] if not step["holds"]]


def _row(row: Row) -> dict[str, Any]:
    """The residual is that of the form that holds; that of a misprint stands beside it."""
    misprint = row.verdict == "misprint"
    return {
        "name": row.name,
        "title": row.title,
        "verdict": row.verdict,
        "digits": row.digits(),
        "residual": f"{(row.corrected or row.printed).residual():.1e}",
        "as_printed": f"{row.printed.values:.1e}" if misprint else "",
        "right_form": row.right_form if misprint else "",
    }
