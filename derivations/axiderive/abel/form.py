"""A result of the reduction, and the order of the lengths in it.

A result as a linear combination {master: coefficient}.

Which length is smaller: the chain of a case, as a question.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import sympy as sp


class Form(dict[sp.Expr, sp.Expr]):
    """Masters with rational (algebraic) coefficients; addition and scaling are all the engine needs."""

    @classmethod
    def of(cls, master: sp.Expr, coefficient: sp.Expr = sp.S.One) -> Form:
        """The combination of one master with its coefficient."""
        return cls({master: sp.sympify(coefficient)})

    @classmethod
    def total(cls, forms: Iterable[Form]) -> Form:
        """The sum of combinations, coefficients of the same master added; empty for none."""
        out = cls()
        for form in forms:
            out = out + form
        return out

    def __add__(self, other: Form) -> Form:
        out = Form(self)
        for master, coefficient in other.items():
            out[master] = out.get(master, sp.S.Zero) + coefficient
        return out

    def __mul__(self, scale: sp.Expr) -> Form:
        return Form({master: scale * coefficient for master, coefficient in self.items()})

    __rmul__ = __mul__

    def times(self, factor: Form | sp.Expr) -> Form:
        """Product with another combination, or with a function that belongs to the master, not to the coefficient."""
        other = factor if isinstance(factor, Form) else Form.of(factor)
        return Form.total(Form.of(mine * its, c * its_c) for mine, c in self.items() for its, its_c in other.items())

    def expr(self) -> sp.Expr:
        """Sum with factored coefficients, common factors outside; the same text in every SymPy since 1.12.

        Never `simplify`: measured on long results it saved 0-6 % of the
        operations and lengthened some.  `factor` alone merges a**k*a**(1 - k)
        only from SymPy 1.14 on, hence the explicit `powsimp`.
        """
        terms = []
        for master in sorted(self, key=sp.default_sort_key):
            coefficient = sp.factor(self[master])
            if any(power.exp.free_symbols for power in coefficient.atoms(sp.Pow)):
                coefficient = sp.powsimp(coefficient, combine="exp")
            if coefficient != 0:
                terms.append(_absorb(coefficient, master))
        plain = sp.Add(*terms)
        pulled = sp.factor_terms(plain)
        return pulled if pulled.count_ops() < plain.count_ops() else plain


def _absorb(coefficient: sp.Expr, master: sp.Expr) -> sp.Expr:
    """coefficient * master with sqrt(P)/P written as 1/sqrt(P)."""
    for factor in sp.Mul.make_args(master):
        if factor.is_Pow and factor.exp == sp.S.Half:
            multiplied = sp.factor(coefficient * factor.base)
            if sp.count_ops(sp.denom(multiplied)) < sp.count_ops(sp.denom(coefficient)):
                coefficient, master = multiplied, master / factor.base
    return coefficient * master


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
