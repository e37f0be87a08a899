"""Arithmetic and canonical form of elements {monomial of powers f**e: polynomial}.

The f are irreducible polynomials, the e any rational or symbolic exponents.
Roots of distinct irreducible polynomials are independent (Kummer), so that
grouping by the exponents modulo 1 gives a canonical form: an element is zero
iff nothing is left.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from .domain import Domain, NotProvedError, stretched_to

Monomial = frozenset[tuple[PolyElement, sp.Expr]]
Element = dict[Monomial, PolyElement]

ONE: Monomial = frozenset()

# The largest product in the proofs of the catalogue has 60 terms, the largest polynomial factored 12; a wrong formula
# may need thousands and hours.
LARGEST_PRODUCT = 20_000
LARGEST_FACTORED = 200
LARGEST_POWER = 100


def leaves(expr: sp.Expr) -> Iterator[sp.Expr]:
    """Symbols, named numbers and outermost functions."""
    stack = [expr]
    while stack:
        node = stack.pop()
        if node.is_Symbol or node.is_NumberSymbol or (node.is_Function and not isinstance(node, sp.Abs)):
            yield node
        else:
            stack.extend(node.args)


@functools.lru_cache(maxsize=4096)
def spelled(exponent: sp.Expr) -> sp.Expr:
    """One text for equal exponents; the whole part of a fraction like n/(n + k) is split off."""
    if exponent.is_Number:
        return exponent
    top, bottom = sp.fraction(sp.cancel(exponent))
    if not bottom.free_symbols:
        return sp.expand(top / bottom)
    symbols = sorted(exponent.free_symbols, key=str)
    whole, rest = sp.div(top, bottom, *symbols)
    return sp.expand(whole) + sp.cancel(rest / bottom)


@functools.lru_cache(maxsize=4096)
def factor_list(polynomial: PolyElement) -> tuple[Any, list[tuple[PolyElement, int]]]:
    """Half of the time of a proof goes into factoring the same few differences of squares."""
    return polynomial.factor_list()


class Elements:
    """Elements over the symbols and functions of the given expressions.

    `positive` tells whether a function is positive on the domain, `below_one` whether it is less than 1.
    """

    def __init__(
        self,
        domain: Domain,
        *exprs: sp.Expr,
        positive: Callable[[sp.Expr], bool] = lambda _: False,
        below_one: Callable[[sp.Expr], bool] = lambda _: False,
    ) -> None:
        self.domain = domain
        self._positive, self._below_one = positive, below_one
        found = sorted({leaf for expr in exprs for leaf in leaves(expr)} | domain.symbols, key=sp.default_sort_key)
        self.generators = {leaf: leaf if leaf.is_Symbol else sp.Symbol(f"function_{i}") for i, leaf in enumerate(found)}
        self.functions = {symbol: leaf for leaf, symbol in self.generators.items() if symbol != leaf}
        self.ring = PolyRing(list(self.generators.values()), sp.QQ, lex)
        self._factors: dict[PolyElement, tuple[int, dict[PolyElement, int]]] = {}
        self._signs: dict[PolyElement, int] = {}

    # arithmetic

    def constant(self, value: sp.Expr) -> Element:
        """The element of a rational number; empty for zero."""
        return {ONE: self.ring.from_expr(value)} if value != 0 else {}

    def add(self, *elements: Element) -> Element:
        """The sum of any number of elements, without the terms that cancel."""
        total: Element = {}
        for element in elements:
            for monomial, polynomial in element.items():
                total[monomial] = total[monomial] + polynomial if monomial in total else polynomial
        return {monomial: polynomial for monomial, polynomial in total.items() if polynomial}

    def scale(self, element: Element, factor: int) -> Element:
        """The element times an integer."""
        return {monomial: polynomial * factor for monomial, polynomial in element.items()}

    def sub(self, left: Element, right: Element) -> Element:
        """The difference of two elements, without the terms that cancel."""
        return self.add(left, self.scale(right, -1))

    def mul(self, left: Element, right: Element) -> Element:
        """The product; `NotProvedError` if the numbers of terms multiply to more than `LARGEST_PRODUCT`."""
        if sum(map(len, left.values())) * sum(map(len, right.values())) > LARGEST_PRODUCT:
            message = "the expressions of the proof grow beyond all bounds"
            raise NotProvedError(message)
        products = ({_multiply(m1, m2): p1 * p2} for m1, p1 in left.items() for m2, p2 in right.items())
        return self.add(*products)

    # canonical form

    def collect(self, element: Element) -> Element:
        """Canonical form: exponents in [0, 1) times a polynomial over what does not divide it."""
        classes: dict[Monomial, list[tuple[dict[PolyElement, int], PolyElement]]] = {}
        for monomial, polynomial in element.items():
            fractional, whole = [], {}
            for factor, exponent in monomial:
                floor = sp.floor(exponent.as_coeff_Add()[0])
                if exponent != floor:
                    fractional.append((factor, exponent - floor))
                whole[factor] = int(floor)
            classes.setdefault(frozenset(fractional), []).append((whole, polynomial))
        out = {}
        for roots, terms in classes.items():
            lowest = {f: min(0, *(whole.get(f, 0) for whole, _ in terms)) for whole, _ in terms for f in whole}
            total = self.ring.zero
            for whole, polynomial in terms:
                for factor, low in lowest.items():
                    surplus = whole.get(factor, 0) - low
                    if surplus:
                        polynomial = polynomial * factor**surplus
                total += polynomial
            if total:
                total, below = _cancel(total, lowest)
                out[_multiply(roots, below)] = total
        return out

    def is_zero(self, element: Element) -> bool:
        """Whether nothing is left in the canonical form."""
        return not self.collect(element)

    def factors(self, polynomial: PolyElement) -> tuple[int, dict[PolyElement, int]]:
        """Unit and irreducible factors (primes included) with multiplicities.

        Factors are positive on the domain, or have a positive leading coefficient if their sign is not known.
        """
        if polynomial not in self._factors:
            if len(polynomial) > LARGEST_FACTORED:
                message = f"a polynomial with {len(polynomial)} terms is not factored"
                raise NotProvedError(message)
            content, factors = factor_list(polynomial)
            unit, out = (1 if content > 0 else -1), {}
            for factor, multiplicity in factors:
                sign = self.polynomial_sign(factor) or (1 if factor.LC > 0 else -1)
                unit *= sign**multiplicity
                out[factor * sign] = multiplicity
            for prime, multiplicity in sp.factorrat(abs(sp.QQ.to_sympy(content))).items():
                out[self.ring(prime)] = multiplicity
            self._factors[polynomial] = (unit, out)
        return self._factors[polynomial]

    def radicands(self, element: Element) -> list[PolyElement]:
        """Polynomials whose root occurs, simplest first."""
        found = {f for monomial in element for f, e in monomial if e.is_Rational and e.q == 2}
        return sorted(found, key=lambda f: (len(f), str(f)))

    def split(self, element: Element, radicand: PolyElement) -> tuple[Element, Element]:
        """The part without and the part with sqrt(radicand)."""
        with_root = {m for m in element if any(f == radicand and not e.is_Integer for f, e in m)}
        rational = {m: p for m, p in element.items() if m not in with_root}
        return rational, {m: element[m] for m in with_root}

    def polynomial_sign(self, polynomial: PolyElement) -> int:
        """+1 or -1 if that is shown to be the sign on the domain, 0 if none is."""
        if polynomial not in self._signs:
            used = {s: f for s, f in self.functions.items() if polynomial.degree(self.ring(s)) > 0}
            plain = (s for s in self.ring.symbols if s not in self.functions and polynomial.degree(self.ring(s)) > 0)
            known = all(s.is_positive for s in plain) and all(self._positive(function) for function in used.values())
            small = [self.ring(s) for s, f in used.items() if known and len(polynomial) > 1 and self._below_one(f)]
            stretched = functools.reduce(lambda f, s: stretched_to(f, s, sp.S.One), small, polynomial)
            self._signs[polynomial] = self.domain.sign(stretched) if known else 0
        return self._signs[polynomial]


def _multiply(left: Monomial, right: Monomial) -> Monomial:
    if not left or not right:
        return left or right
    powers = dict(left)
    for factor, exponent in right:
        powers[factor] = spelled(powers[factor] + exponent) if factor in powers else exponent
    return frozenset((factor, exponent) for factor, exponent in powers.items() if exponent != 0)


def _cancel(polynomial: PolyElement, lowest: dict[PolyElement, int]) -> tuple[PolyElement, Monomial]:
    """Divide by the factors with negative exponents as often as they divide."""
    below = {}
    for factor, exponent in lowest.items():
        if factor.is_ground:
            polynomial = polynomial * factor.LC**exponent
            continue
        while exponent < 0:
            quotient, remainder = polynomial.div(factor)
            if remainder:
                break
            polynomial, exponent = quotient, exponent + 1
        if exponent:
            below[factor] = sp.Integer(exponent)
    return polynomial, frozenset(below.items())
