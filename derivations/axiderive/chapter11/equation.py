"""What the chapter's equations are made of: random parameters of a check, seeded, in a chosen system of units.

The formula as printed, the check, and the comparison of two sides.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

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

    def power_sum(self, lo: float = 1.2, hi: float = 3.5, terms: int = 2) -> PowerSum:
        """A random sum of real powers that grows with r."""
        exponents = [self.number(lo, hi) for _ in range(terms)]
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
