"""Runs the checks: numbers of equations in, rows with verdicts out."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from multiprocessing import get_context
from typing import Any, Literal

import mpmath as mp

from .equation import NUMBER, REGISTRY, Draw, Equation, Formula

SECTIONS = (
    "flat_punch", "normal", "adhesive", "graded_punch", "tangential", "special_functions", "foppl_schubert",
)  # fmt: skip
GUARD = 20
"""Digits carried beyond those demanded."""

Verdict = Literal["OK", "misprint", "fails"]


@dataclass(frozen=True)
class Outcome:
    """Largest relative residuals of one formula over all draws: of its values, and of its scaling with the units.

    `units` is None where only pure numbers are compared.
    """

    values: float
    units: float | None
    count: int
    carried: int

    def residual(self) -> float:
        """The larger of the residuals of the values and of the units, a pure number."""
        return max(self.values, self.units or 0.0)

    def digits(self) -> int:
        """Digits that agree, at most those carried."""
        residual = self.residual()
        return self.carried if residual == 0 else min(self.carried, int(-mp.log10(residual)))


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
        """The number as the chapter prints it, without brackets: "11.20"."""
        return f"11.{self.number}"

    def digits(self) -> int:
        """Digits to which the printed form holds, or the corrected one where the printed form is wrong."""
        return (self.corrected or self.printed).digits()


@lru_cache(maxsize=1)
def equations() -> dict[int, Equation]:
    """All equations by number."""
    for section in SECTIONS:
        import_module(f".{section}", __package__)
    return dict(sorted(REGISTRY.items()))


def evaluate(equation: Equation, formula: Formula, digits: int, seed: int, draws: int) -> Outcome:
    """The check of an equation on one formula; the first draw is repeated in other units."""
    with mp.workdps(digits + GUARD):
        values: list[Any] = []
        units: list[Any] = []
        for index in range(draws):
            key = f"{seed}:{equation.number}:{index}"
            residuals = list(equation.check(Draw(key, first=index == 0), formula))
            values += [x.relative() for x in residuals]
            if index == 0 and any(x.dimension != NUMBER for x in residuals):
                other = _other_units(key)
                scaled = equation.check(other, formula)
                units = [x.in_units(y, other) for x, y in zip(residuals, scaled, strict=True)]
        return Outcome(float(max(values)), float(max(units)) if units else None, len(values), digits + GUARD)


def _other_units(key: str) -> Draw:
    factors = Draw(f"units of {key}")
    return Draw(key, (factors.number(2, 20), factors.number(2, 20)))


def check(equation: Equation, digits: int = 30, seed: int = 11, draws: int = 3) -> Row:
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
    numbers: Iterable[int] | None = None, digits: int = 30, seed: int = 11, draws: int = 3, jobs: int = 1
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
    return tuple(stream(numbers, digits, seed, draws, jobs))


def stream(
    numbers: Iterable[int] | None = None, digits: int = 30, seed: int = 11, draws: int = 3, jobs: int = 1
) -> Iterator[Row]:
    """The rows of `run` one by one, in order."""
    wanted = sorted(equations() if numbers is None else set(numbers))
    unknown = [n for n in wanted if n not in equations()]
    if unknown:
        message = f"the chapter has no equation (11.{unknown[0]}); its equations are (11.1)-(11.{max(equations())})"
        raise ValueError(message)
    tasks = [(n, digits, seed, draws) for n in wanted]
    if jobs <= 1:
        yield from map(_task, tasks)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(_task, tasks)


HEAD = ("equation", "verdict", "digits", "printed", "units", "corrected", "what was checked")
WIDTHS = (8, 8, 6, 7, 7, 9, 0)


def table(rows: Iterable[Row]) -> str:
    """One line per equation: number, verdict, digits, residuals, what was checked, and the right form of a misprint."""
    return "\n".join([_text(HEAD), *map(line, rows)]) + "\n"


def _text(cells: Sequence[str]) -> str:
    return "  ".join(cell.ljust(width) for cell, width in zip(cells, WIDTHS, strict=True)).rstrip()


def line(row: Row) -> str:
    """The row as the table prints it."""
    units = row.printed.units
    cells = (
        f"({row.name})",
        row.verdict,
        str(row.digits()),
        f"{row.printed.values:.1e}",
        "" if units is None else f"{units:.1e}",
        f"{row.corrected.residual():.1e}" if row.corrected else "",
        row.title + (f"; right: {row.right_form}" if row.verdict == "misprint" else ""),
    )
    return _text(cells)


def report(digits: int = 30, seed: int = 11, jobs: int = 1) -> bool:
    """Print the table line by line; whether every equation holds as printed or as corrected."""
    started = time.perf_counter()
    rows: list[Row] = []
    print(_text(HEAD))
    for row in stream(digits=digits, seed=seed, jobs=jobs):
        print(line(row), flush=True)
        rows.append(row)
    verdicts = [row.verdict for row in rows]
    seconds = time.perf_counter() - started
    counts = f"{len(rows)} equations, {verdicts.count('misprint')} to be corrected, {verdicts.count('fails')} failures"
    print(f"{counts}, least agreement {min(row.digits() for row in rows)} digits, {seconds:.1f} s, seed {seed}")
    return "fails" not in verdicts
