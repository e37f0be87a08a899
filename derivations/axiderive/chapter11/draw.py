"""Random parameters of a check, seeded, in a chosen system of units."""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any

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
        share = mp.mpf(self._random.randrange(1, 10**DIGITS)) / 10**DIGITS
        return mp.mpf(lo) + (mp.mpf(hi) - mp.mpf(lo)) * share

    def integer(self, lo: int, hi: int) -> int:
        return self._random.randint(lo, hi)

    def sign(self) -> int:
        return self._random.choice((-1, 1))

    def complex(self, lo: float, hi: float, height: float = 1) -> Any:
        return mp.mpc(self.number(lo, hi), self.number(-height, height))

    def quantity(self, length: Any, force: Any, lo: float = 0.5, hi: float = 2) -> Any:
        return self.number(lo, hi) * self.factor(length, force)

    def length(self, lo: float = 0.5, hi: float = 2) -> Any:
        return self.quantity(1, 0, lo, hi)

    def force(self, lo: float = 0.5, hi: float = 2) -> Any:
        return self.quantity(0, 1, lo, hi)

    def stress(self, lo: float = 0.5, hi: float = 2) -> Any:
        return self.quantity(-2, 1, lo, hi)

    def power_sum(self, lo: float = 1.2, hi: float = 3.5, terms: int = 2) -> PowerSum:
        """A random sum of real powers that grows with r."""
        exponents = [self.number(lo, hi) for _ in range(terms)]
        return PowerSum(tuple((self.quantity(1 - n, 0), n) for n in exponents))

    def even_sum(self, terms: int = 3) -> PowerSum:
        """A random even polynomial: its pressure is a polynomial in r**2 times the root at the edge."""
        return PowerSum(tuple((self.quantity(1 - n, 0), n) for n in range(2, 2 * terms + 1, 2)))
