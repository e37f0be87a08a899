"""Where a formula holds: an ordering of lengths, and what it says about the sign of a polynomial.

On 0 < r < b < a every point is r, b = r + b', a = r + b' + a' with positive
increments; a polynomial whose coefficients in the increments all have one sign
has that sign everywhere.  Increments bear the name of their length.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyElement


class NotProvedError(ValueError):
    """A step of a certificate that fails; the message is the reason in one sentence."""


def require(shown: object, reason: str, *about: object) -> None:
    """Refuse what is not shown: the reason has {} where it names what it is about."""
    if not shown:
        raise NotProvedError(reason.format(*about))


class Domain:
    """Positive symbols with lower bounds; a chain (r, b, a) says 0 < r < b < a.

    Several chains may share symbols as long as the largest lower bound of every
    symbol is unique (a < r and a < R leave r and R uncompared).  A number may
    start or end a chain: (1, n), (alpha, 1).
    """

    def __init__(self, *chains: Iterable[sp.Expr]) -> None:
        pairs = set()
        for chain in chains:
            members = tuple(map(sp.sympify, chain))
            pairs |= set(zip(members, members[1:], strict=False))
        self._pairs = frozenset(pairs)
        self.symbols = frozenset(member for pair in pairs for member in pair if member.is_Symbol)
        self._parents = {symbol: self._largest_lower_bound(symbol) for symbol in self.symbols}
        self._upper = {low: high for low, high in pairs if high.is_Number and low.is_Symbol}
        self.memo: dict[tuple[str, sp.Expr], Any] = {}

    def _bounds(self, symbol: sp.Expr) -> set[sp.Expr]:
        bounds: set[sp.Expr] = set()
        below = {symbol}
        while below:
            below = {low for low, high in self._pairs if high in below} - bounds
            bounds |= below
        return bounds

    def _largest_lower_bound(self, symbol: sp.Expr) -> sp.Expr:
        bounds = self._bounds(symbol)
        require(symbol not in bounds, "{} would be less than itself", symbol)
        largest = [bound for bound in bounds if bounds - {bound} <= self._bounds(bound)]
        if bounds and not largest:
            message = f"the order of the lower bounds {', '.join(sorted(map(str, bounds)))} of {symbol} is not known"
            raise NotProvedError(message)
        return largest[0] if largest else sp.S.Zero

    def parent(self, symbol: sp.Expr) -> sp.Expr:
        """The largest lower bound; 0 for a symbol that is only positive."""
        return self._parents.get(symbol, sp.S.Zero)

    def chains(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """The comparisons this domain is made of."""
        return tuple(self._pairs)

    def children(self, symbol: sp.Expr) -> list[sp.Expr]:
        """The symbols whose largest lower bound is this one, sorted by name."""
        return sorted((high for high, low in self._parents.items() if low == symbol), key=str)

    def shift(self, symbol: sp.Expr) -> sp.Expr:
        """The symbol in terms of increments."""
        parent = self.parent(symbol)
        return symbol + (self.shift(parent) if parent.is_Symbol else parent)

    def sign(self, polynomial: PolyElement) -> int:
        """+1 or -1 if all coefficients in the increments have that sign, 0 if that does not decide."""
        ring = polynomial.ring
        moved = [(ring(s), ring.from_expr(self.shift(s))) for s in ring.symbols if self.parent(s) != 0]
        shifted = polynomial.compose(moved) if moved and len(polynomial) > 1 else polynomial
        for symbol, upper in self._upper.items():
            if self.parent(symbol).is_Number and len(shifted) > 1:
                shifted = stretched_to(shifted, ring(symbol), upper - self.parent(symbol))
        if shifted and all(c > 0 for c in shifted.values()):
            return 1
        return -1 if shifted and all(c < 0 for c in shifted.values()) else 0

    def at(self, symbol: sp.Expr, value: sp.Expr) -> Domain:
        """The face symbol = value of this domain; value is the lower bound, 0 or the only upper neighbour."""
        pairs = [(self.parent(high), high) for high in self._parents if self.parent(high) != 0]
        pairs += self._upper.items()
        if value == 0:
            if self.parent(symbol) != 0:
                message = f"{symbol} cannot tend to 0 above {self.parent(symbol)}"
                raise NotProvedError(message)
            return Domain(*(pair for pair in pairs if symbol not in pair))
        renamed = ((value if low == symbol else low, value if high == symbol else high) for low, high in pairs)
        return Domain(*((low, high) for low, high in renamed if low != high))

    def ends(self, symbol: sp.Expr) -> Iterator[tuple[sp.Expr, Domain]]:
        """Boundary values the symbol may tend to while all others stay fixed."""
        parent = self.parent(symbol)
        if not parent.is_Number or parent == 0:
            yield parent, self.at(symbol, parent)
        upper = self.children(symbol)
        if len(upper) == 1:
            yield upper[0], self.at(symbol, upper[0])


def stretched_to(polynomial: PolyElement, variable: PolyElement, length: sp.Expr) -> PolyElement:
    """The polynomial with its variable in (0, length) as length m/(1 + m), times a power of 1 + m; m bears its name."""
    ring, place = polynomial.ring, polynomial.ring.gens.index(variable)
    width, degree = ring.from_expr(sp.sympify(length)), polynomial.degree(variable)
    total = ring.zero
    for powers, coefficient in polynomial.terms():
        i = powers[place]
        rest = ring({(*powers[:place], 0, *powers[place + 1 :]): coefficient})
        total += rest * (width * variable) ** i * (1 + variable) ** (degree - i)
    return total
