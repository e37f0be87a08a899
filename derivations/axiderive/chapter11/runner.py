"""Runs the checks: numbers of equations in, rows with verdicts out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from multiprocessing import get_context
from typing import Any, Literal

import mpmath as mp

from .draw import Draw
from .equation import Equation, Formula

SECTIONS = (
    "flat_punch", "normal", "adhesive", "graded_punch", "graded", "graded_adhesive",
    "tangential", "special_functions", "foppl_schubert",
)  # fmt: skip
GUARD = 20
"""Digits carried beyond those demanded."""

Verdict = Literal["OK", "misprint", "fails"]


@dataclass(frozen=True)
class Outcome:
    """Largest relative residuals of one formula over all draws: of its values, and of its scaling with the units."""

    values: float
    units: float
    count: int

    def digits(self) -> float:
        return _digits(max(self.values, self.units))


@dataclass(frozen=True)
class Row:
    """What the table says about one equation."""

    number: int
    title: str
    verdict: Verdict
    printed: Outcome
    corrected: Outcome | None
    right_form: str

    @property
    def name(self) -> str:
        return f"11.{self.number}"

    def digits(self) -> float:
        """Digits to which the printed form holds, or the corrected one where the printed form is wrong."""
        return (self.corrected or self.printed).digits()


def _digits(residual: float) -> float:
    return float("inf") if residual == 0 else float(-mp.log10(residual))


@lru_cache(maxsize=1)
def equations() -> dict[int, Equation]:
    """All equations by number."""
    found = [e for section in SECTIONS for e in import_module(f".{section}", __package__).EQUATIONS]
    return {e.number: e for e in sorted(found, key=lambda e: e.number)}


def evaluate(equation: Equation, formula: Formula, digits: int, seed: int, draws: int) -> Outcome:
    """The check of an equation on one formula; the first draw is repeated in other units."""
    with mp.workdps(digits + GUARD):
        values: Any = mp.mpf(0)
        units: Any = mp.mpf(0)
        count = 0
        for index in range(draws):
            key = f"{seed}:{equation.number}:{index}"
            residuals = list(equation.check(Draw(key), formula))
            count += len(residuals)
            values = max([values, *(x.relative() for x in residuals)])
            if index == 0:
                other = _other_units(key)
                scaled = list(equation.check(other, formula))
                units = max(x.in_units(y, other) for x, y in zip(residuals, scaled, strict=True))
        return Outcome(float(values), float(units), count)


def _other_units(key: str) -> Draw:
    factors = Draw(f"units of {key}")
    return Draw(key, (factors.number(2, 20), factors.number(2, 20)))


def check(equation: Equation, digits: int = 30, seed: int = 11, draws: int = 4) -> Row:
    """One row; the verdict depends on the residuals alone."""
    printed = evaluate(equation, equation.formula, digits, seed, draws)
    corrected = evaluate(equation, equation.corrected, digits, seed, draws) if equation.corrected else None
    verdict: Verdict = "OK"
    if printed.digits() < digits:
        verdict = "misprint" if corrected and corrected.digits() >= digits else "fails"
    elif corrected:
        verdict = "fails"  # a correction of a formula that needs none
    return Row(equation.number, equation.title, verdict, printed, corrected, equation.right_form)


def _task(job: tuple[int, int, int, int]) -> Row:
    number, digits, seed, draws = job
    return check(equations()[number], digits, seed, draws)


def run(
    numbers: Iterable[int] | None = None, digits: int = 30, seed: int = 11, draws: int = 4, jobs: int = 1
) -> tuple[Row, ...]:
    """Check the equations (11.n) of these numbers, all if None.

    Parameters
    ----------
    numbers
        n of (11.n).
    digits
        Relative agreement demanded; 20 more are carried.
    seed, draws
        Random parameters: the seed, and how many sets of them for every equation.
    jobs
        Processes; the rows do not depend on it.

    Raises
    ------
    ValueError
        If the chapter has no equation of that number.
    """
    wanted = sorted(equations() if numbers is None else set(numbers))
    unknown = [n for n in wanted if n not in equations()]
    if unknown:
        message = f"the chapter has no equation (11.{unknown[0]}); its equations are (11.1)-(11.{max(equations())})"
        raise ValueError(message)
    tasks = [(n, digits, seed, draws) for n in wanted]
    if jobs <= 1:
        return tuple(map(_task, tasks))
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        return tuple(pool.map(_task, tasks))


def table(rows: Sequence[Row]) -> str:
    """One line per equation: number, verdict, digits, residuals of the printed and the corrected form, what was checked."""
    head = ("equation", "verdict", "digits", "printed", "units", "corrected", "what was checked")
    lines = [head, *(_line(row) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(head) - 1)]
    text = ["  ".join([*(cell.ljust(width) for cell, width in zip(line, widths, strict=False)), line[-1]]) for line in lines]
    return "\n".join(line.rstrip() for line in text) + "\n"


def _line(row: Row) -> tuple[str, ...]:
    digits = row.digits()
    return (
        f"({row.name})",
        row.verdict,
        "exact" if digits == float("inf") else str(int(digits)),
        f"{row.printed.values:.1e}",
        f"{row.printed.units:.1e}",
        f"{max(row.corrected.values, row.corrected.units):.1e}" if row.corrected else "",
        row.title + (f"; right: {row.right_form}" if row.verdict == "misprint" else ""),
    )
