"""What the chapter's equations are made of: the formula as printed, the check, the comparison of two sides."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import mpmath as mp

from .draw import Draw


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
FOUNDATION = Dimension(-2, 1)
"""Stiffness per length of a Winkler foundation."""

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
