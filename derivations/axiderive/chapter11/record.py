"""The outcome of all checks of the chapter as plain data, for the evidence and the handbook."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from .errata import errata
from .first_principles import steps
from .runner import Row, run

DIGITS = 30
SEED = 11


def record(jobs: int = 1) -> dict[str, Any]:
    """The table of equations, the errata they show, and the exact steps from the point load to the flat punch."""
    rows = run(digits=DIGITS, seed=SEED, jobs=jobs)
    return {
        "digits": DIGITS,
        "seed": SEED,
        "equations": [_equation(row) for row in rows],
        "errata": [asdict(erratum) for erratum in errata(DIGITS, SEED, rows)],
        "steps": [{"equations": step.equations, "claim": step.claim, "holds": step.holds()} for step in steps()],
    }


def failures(found: dict[str, Any]) -> list[str]:
    """What of a record does not hold, one sentence each."""
    wrong = [f"({row['name']}) {row['title']}" for row in found["equations"] if row["verdict"] == "fails"]
    return wrong + [f"{step['equations']}: {step['claim']}" for step in found["steps"] if not step["holds"]]


def _equation(row: Row) -> dict[str, Any]:
    return {
        "name": row.name,
        "title": row.title,
        "verdict": row.verdict,
        "digits": row.digits(),
        "printed": f"{row.printed.values:.1e}",
        "units": "" if row.printed.units is None else f"{row.printed.units:.1e}",
        "corrected": f"{row.corrected.residual():.1e}" if row.corrected else "",
        "right_form": row.right_form if row.verdict == "misprint" else "",
        "count": row.printed.count,
    }
