"""Which length is smaller: the chain of a case, as a question."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

Chain = tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Order:
    """0 < chain[0] < chain[1] < ...; lengths outside the chain are not compared."""

    chain: Chain

    def below(self, low: sp.Expr, high: sp.Expr) -> bool:
        """Whether low < high follows from the chain; `ValueError` if the chain does not decide it."""
        if low == 0:
            return True
        if low not in self.chain or high not in self.chain:
            message = f"the order of {low} and {high} is not fixed by {' < '.join(map(str, self.chain))}"
            raise ValueError(message)
        return self.chain.index(low) < self.chain.index(high)


def insert(
    chain: Chain, length: sp.Expr, above: sp.Expr | None = None, below: sp.Expr | None = None
) -> Iterator[Chain]:
    """All chains with `length` put in, above and below the given members."""
    start = chain.index(above) + 1 if above is not None else 0
    stop = chain.index(below) if below is not None else len(chain)
    for i in range(start, stop + 1):
        yield (*chain[:i], length, *chain[i:])
