"""What the chapter's equations are made of, and the run through all of them.

Random parameters of a check, seeded, in a chosen system of units; the formula as printed, the check, the comparison of
two sides; numbers of equations in, rows with verdicts out.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from itertools import starmap
from typing import Any, Literal, NamedTuple, TypeAlias

import mpmath as mp

DIGITS = 20
"""Random digits of every parameter."""


@dataclass(frozen=True)
class PowerSum:
    """sum c r**n: a profile f, or a depth g, with real exponents."""

    terms: tuple[tuple[Any, Any], ...]

    def __call__(self, r: Any) -> Any:
        return mp.fsum(c * r**n for c, n in self.terms)

    def slope(self, r: Any) -> Any:
        """The derivative at r, sum c n r**(n - 1)."""
        return mp.fsum(c * n * r ** (n - 1) for c, n in self.terms)

    def times(self, factor: Any) -> PowerSum:
        """The sum with every coefficient multiplied by factor(n)."""
        return PowerSum(tuple((c * factor(n), n) for c, n in self.terms))


class Draw:
    """One set of random parameters; the same key gives the same physical values in any units.

    `units` are the factors by which the number of a length and of a force
    grows when the units change: every quantity is drawn with its dimension.
    `first` asks for the comparisons that are not worth repeating.
    """

    def __init__(self, key: str, units: tuple[Any, Any] = (1, 1), first: bool = True) -> None:
        self._random = random.Random(key)
        self.units = units
        self.first = first

    def factor(self, length: Any = 0, force: Any = 0) -> Any:
        """What a quantity of this dimension is multiplied by in the units of the draw."""
        return mp.mpf(self.units[0]) ** length * mp.mpf(self.units[1]) ** force

    def number(self, lo: float, hi: float) -> Any:
        """A random number between lo and hi, without dimension."""
        share = mp.mpf(self._random.randrange(1, 10**DIGITS)) / 10**DIGITS
        return mp.mpf(lo) + (mp.mpf(hi) - mp.mpf(lo)) * share

    def integer(self, lo: int, hi: int) -> int:
        """A random integer from lo to hi, both included."""
        return self._random.randint(lo, hi)

    def sign(self) -> int:
        """1 or -1 at random."""
        return self._random.choice((-1, 1))

    def complex(self, lo: float, hi: float, height: float = 1) -> Any:
        """A random complex number, its real part between lo and hi, its imaginary part between -height and height."""
        return mp.mpc(self.number(lo, hi), self.number(-height, height))

    def quantity(self, length: Any, force: Any, lo: float = 0.5, hi: float = 2) -> Any:
        """A random quantity with these exponents of length and force: between lo and hi where the units are 1."""
        return self.number(lo, hi) * self.factor(length, force)

    def length(self, lo: float = 0.5, hi: float = 2) -> Any:
        """A random length, between lo and hi where the units are 1."""
        return self.quantity(1, 0, lo, hi)

    def force(self, lo: float = 0.5, hi: float = 2) -> Any:
        """A random force, between lo and hi where the units are 1."""
        return self.quantity(0, 1, lo, hi)

    def stress(self, lo: float = 0.5, hi: float = 2) -> Any:
        """A random stress, pressure or modulus: a force over the square of a length."""
        return self.quantity(-2, 1, lo, hi)

    def power_sum(self, terms: int = 2) -> PowerSum:
        """A random sum of real powers that grows with r."""
        exponents = [self.number(1.2, 3.5) for _ in range(terms)]
        return PowerSum(tuple((self.quantity(1 - n, 0), n) for n in exponents))

    def even_sum(self, terms: int = 3) -> PowerSum:
        """A random even polynomial: its pressure is a polynomial in r**2 times the root at the edge."""
        return PowerSum(tuple((self.quantity(1 - n, 0), n) for n in range(2, 2 * terms + 1, 2)))


class Dimension(NamedTuple):
    """Exponents of length and force, which may be any real number: a coefficient of r**n has length 1 - n."""

    length: Any = 0
    force: Any = 0


NUMBER = Dimension()
LENGTH = Dimension(1)
AREA = Dimension(2)
FORCE = Dimension(0, 1)
STRESS = Dimension(-2, 1)
STIFFNESS = Dimension(-1, 1)
ENERGY = Dimension(1, 1)

Formula = Callable[..., Any]
"""The right side of an equation; several sides of one equation come as a tuple."""


@dataclass(frozen=True)
class Residual:
    """Two values that should agree, and the dimension both should have.

    `scale` replaces the larger of the two where an equation has zero on one side.
    """

    left: Any
    right: Any
    dimension: Dimension = NUMBER
    scale: Any = None

    def relative(self) -> Any:
        """abs(left - right) in units of the larger side; NaN counts as no agreement at all."""
        size = max(abs(self.left), abs(self.right)) if self.scale is None else abs(self.scale)
        if size == 0:
            return mp.mpf(0)
        value = abs(self.left - self.right) / size
        return value if mp.isfinite(value) else mp.inf

    def in_units(self, other: Residual, draw: Draw) -> Any:
        """How far the right side misses the scaling of its dimension; `other` is the same in the units of `draw`."""
        factor = draw.factor(*self.dimension)
        missed = Residual(self.right * factor, other.right, scale=other.scale).relative()
        if self.scale is None:
            return missed
        return max(missed, Residual(self.scale * factor, other.scale).relative())


Check = Callable[[Draw, Formula], Iterator[Residual]]


@dataclass(frozen=True)
class Equation:
    """One numbered equation of the chapter.

    `check` computes the left side on a route of its own and compares it with
    the formula it is handed: the printed one, the corrected one, or an altered one.
    """

    number: int
    formula: Formula
    title: str
    check: Check
    corrected: Formula | None = None
    printed_form: str = ""
    right_form: str = ""
    reason: str = ""


REGISTRY: dict[int, Equation] = {}
"""The equations of the sections imported so far, by number."""


def equation(number: int, formula: Formula, title: str, **misprint: Any) -> Callable[[Check], Check]:
    """Register a check of the formula printed as (11.number); `misprint` holds the further fields of `Equation`."""

    def register(check: Check) -> Check:
        if number in REGISTRY:
            message = f"equation (11.{number}) has a check already; give the new one the number it is printed with"
            raise ValueError(message)
        REGISTRY[number] = Equation(number, formula, title, check, **misprint)
        return check

    return register


def chain(left: Any, rights: tuple[Any, ...], dimension: Dimension = NUMBER) -> Iterator[Residual]:
    """One left side against every member of a chain of equalities."""
    for right in rights:
        yield Residual(left, right, dimension)


SECTIONS = (
    "flat_punch", "normal", "adhesive", "graded_punch", "tangential", "special_functions", "foppl_schubert",
)  # fmt: skip
GUARD = 20
"""Digits carried beyond those demanded."""

Verdict = Literal["OK", "misprint", "fails"]


def agreed(residual: Any, carried: int) -> int:
    """Digits that agree, at most those carried."""
    return carried if residual == 0 else min(carried, int(-mp.log10(residual)))


@dataclass(frozen=True)
class Outcome:
    """Largest relative residuals of one formula over all draws: of its values, and of its scaling with the units.

    `units` is None where only pure numbers are compared.
    """

    values: float
    units: float | None
    carried: int

    def residual(self) -> float:
        """The larger of the residuals of the values and of the units, a pure number."""
        return max(self.values, self.units or 0.0)

    def digits(self) -> int:
        """Digits that agree, at most those carried."""
        return agreed(self.residual(), self.carried)


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
                factors = Draw(f"units of {key}")
                other = Draw(key, (factors.number(2, 20), factors.number(2, 20)))
                scaled = equation.check(other, formula)
                units = [x.in_units(y, other) for x, y in zip(residuals, scaled, strict=True)]
        return Outcome(float(max(values)), float(max(units)) if units else None, digits + GUARD)


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


def _row(number: int, digits: int, seed: int, draws: int) -> Row:
    return check(equations()[number], digits, seed, draws)


Runner: TypeAlias = Callable[[Callable[..., Row], Sequence[tuple[int, ...]]], Iterable[Row]]
"""Calls a function with each of some arguments, in order, here or elsewhere."""


def run(
    numbers: Iterable[int] | None = None, digits: int = 30, seed: int = 11, draws: int = 3, runner: Runner = starmap
) -> Iterator[Row]:
    """Check the equations (11.n) of these numbers, all if None, and give their rows one by one, in order.

    Parameters
    ----------
    numbers
        n of (11.n).
    digits
        Relative agreement demanded; 20 more are carried.
    seed, draws
        Random parameters: the seed, and how many sets of them for every equation.
    runner
        What calls for each equation; the rows do not depend on it.

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
    yield from runner(_row, [(n, digits, seed, draws) for n in wanted])


HEAD = ("equation", "verdict", "digits", "printed", "units", "corrected", "what was checked")
WIDTHS = (8, 8, 6, 7, 7, 9, 0)


def table(rows: Iterable[Row]) -> str:
    """One line per equation: number, verdict, digits, residuals, what was checked, and the right form of a misprint."""
    return "\n".join([_text(*HEAD), *map(line, rows)]) + "\n"


def _text(*cells: str) -> str:
    return "  ".join(cell.ljust(width) for cell, width in zip(cells, WIDTHS, strict=True)).rstrip()


def line(row: Row) -> str:
    """The row as the table prints it."""
    units = row.printed.units
    return _text(
        f"({row.name})",
        row.verdict,
        str(row.digits()),
        f"{row.printed.values:.1e}",
        "" if units is None else f"{units:.1e}",
        f"{row.corrected.residual():.1e}" if row.corrected else "",
        row.title + (f"; right: {row.right_form}" if row.verdict == "misprint" else ""),
    )


def report(digits: int = 30, seed: int = 11, runner: Runner = starmap) -> bool:
    """Print the table line by line; whether every equation holds as printed or as corrected."""
    started = time.perf_counter()
    rows: list[Row] = []
    print(_text(*HEAD))
    for row in run(digits=digits, seed=seed, runner=runner):
        print(line(row), flush=True)
        rows.append(row)
    verdicts = [row.verdict for row in rows]
    seconds = time.perf_counter() - started
    counts = f"{len(rows)} equations, {verdicts.count('misprint')} to be corrected, {verdicts.count('fails')} failures"
    print(f"{counts}, least agreement {min(row.digits() for row in rows)} digits, {seconds:.1f} s, seed {seed}")
    return "fails" not in verdicts
