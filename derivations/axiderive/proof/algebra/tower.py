"""The tower Q(lengths, functions)[f**e] of elements {monomial of powers f**e: polynomial}.

The f are irreducible polynomials, the e any rational or symbolic exponents (a**n).  Roots of distinct irreducible
polynomials are independent (Kummer), so that grouping by the exponents modulo 1 gives a canonical form: an element is
zero iff nothing is left.  Functions are independent generators; what relates them is left to `identity`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from .domain import Domain, NotProvedError, require, stretched_to

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


class Tower:
    """The field of the given expressions on a domain, over their symbols and functions.

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

    # powers, inverses, roots and signs

    def power(self, element: Element, exponent: sp.Expr) -> Element:
        """Any rational or symbolic power; sums of radicals only to integer and half-integer powers."""
        if exponent.is_Integer and exponent >= 0:
            return self._repeated(element, int(exponent))
        element = self.collect(element)
        require(element, "division by zero, or a root of zero")
        if len(element) == 1:
            return self._single_power(element, exponent)
        if exponent.is_Integer:
            return self._repeated(self._inverse(element), -int(exponent))
        if exponent.is_Rational and exponent.q == 2:
            return self.power(self._denested_root(element), 2 * exponent)
        message = f"a power with exponent {exponent} of a sum of radicals cannot be taken exactly"
        raise NotProvedError(message)

    def _repeated(self, element: Element, count: int) -> Element:
        require(count <= LARGEST_POWER, "a power with exponent {} is not expanded", count)
        result = {ONE: self.ring.one}
        for _ in range(count):
            result = self.mul(result, element)
        return result

    def _single_power(self, element: Element, exponent: sp.Expr) -> Element:
        ((monomial, polynomial),) = element.items()
        unit, factors = self.factors(polynomial)
        powers = dict(monomial)
        for factor, multiplicity in factors.items():
            powers[factor] = powers.get(factor, sp.S.Zero) + multiplicity
        if not exponent.is_Integer and (unit < 0 or any(self.polynomial_sign(factor) <= 0 for factor in powers)):
            message = f"the radicand {self.expr(element)} is not shown to be positive"
            raise NotProvedError(message)
        powers = {factor: spelled(power * exponent) for factor, power in powers.items()}
        sign = -1 if unit < 0 and exponent % 2 else 1
        return {frozenset((f, e) for f, e in powers.items() if e != 0): self.ring(sign)}

    def _norm(self, rational: Element, radical: Element) -> Element:
        """P^2 - Q^2 f."""
        return self.collect(self.sub(self.mul(rational, rational), self.mul(radical, radical)))

    def _inverse(self, element: Element) -> Element:
        """1/(P + Q sqrt(f)) = (P - Q sqrt(f))/(P^2 - Q^2 f), until a single class is left."""
        if len(element) == 1:
            return self._single_power(element, sp.S.NegativeOne)
        for radicand in self.radicands(element):
            rational, radical = self.split(element, radicand)
            if rational and radical:
                return self.mul(self.sub(rational, radical), self._inverse(self._norm(rational, radical)))
        message = f"{self.expr(element)} cannot be inverted exactly"
        raise NotProvedError(message)

    def _denested_root(self, element: Element) -> Element:
        """sqrt(P + Q) = x + y with x^2, y^2 = (P +- sqrt(P^2 - Q^2))/2, checked by squaring."""
        half = self.constant(sp.S.Half)
        for radicand in self.radicands(element):
            rational, radical = self.split(element, radicand)
            norm = self._root_up_to_sign(self._norm(rational, radical))
            if norm is None:
                continue
            squares = (self.mul(half, self.add(rational, norm)), self.mul(half, self.sub(rational, norm)))
            try:
                one, other = (self.power(square, sp.S.Half) for square in squares)
            except NotProvedError:
                continue
            for root in (self.add(one, other), self.sub(one, other), self.sub(other, one)):
                if self.is_zero(self.sub(self.mul(root, root), element)) and self.sign(root) > 0:
                    return self.collect(root)
        message = f"the root of {self.expr(element)} does not denest, or its sign is not known"
        raise NotProvedError(message)

    def _root_up_to_sign(self, element: Element) -> Element | None:
        """A square root of a perfect square, sign left open; None if it is none."""
        if len(element) != 1:
            return None
        ((monomial, polynomial),) = element.items()
        content, factors = factor_list(polynomial)
        powers = {factor: sp.Integer(multiplicity) for factor, multiplicity in factors}
        for factor, power in monomial:
            powers[factor] = powers.get(factor, sp.S.Zero) + power
        root = sp.sqrt(sp.QQ.to_sympy(content))
        if not root.is_Rational or any(not (power / 2).is_Integer for power in powers.values()):
            return None
        return {frozenset((f, e / 2) for f, e in powers.items() if e != 0): self.ring.from_expr(root)}

    def primitive(self, element: Element) -> tuple[dict[PolyElement, sp.Expr], Element]:
        """Positive common factors with exponents, and what remains of a sum of radicals."""
        element = self.collect(element)
        shared = {factor for monomial in element for factor, _ in monomial}
        lowest = {f: min((dict(monomial).get(f, sp.S.Zero) for monomial in element), key=sp.Float) for f in shared}
        content = self.ring.from_expr(sp.gcd_list([sp.QQ.to_sympy(p.content()) for p in element.values()]))
        common = functools.reduce(lambda one, other: one.gcd(other), element.values()).monic()
        unit, factors = self.factors(common * content)
        if any(self.polynomial_sign(factor) <= 0 for factor in (*factors, *lowest)):
            message = f"the factors of {self.expr(element)} are not shown to be positive"
            raise NotProvedError(message)
        inverse = self._single_power({frozenset(lowest.items()): common * content * unit}, sp.S.NegativeOne)
        for factor, multiplicity in factors.items():
            lowest[factor] = lowest.get(factor, sp.S.Zero) + multiplicity
        return lowest, self.collect(self.mul(element, inverse))

    def _class_sign(self, monomial: Monomial, polynomial: PolyElement) -> int:
        """Sign of one class; a factor of unknown sign leaves it open."""
        if any(self.polynomial_sign(factor) <= 0 for factor, _ in monomial):
            return 0
        sign = self.polynomial_sign(polynomial)
        if sign:
            return sign
        unit, factors = self.factors(polynomial)
        return unit if all(self.polynomial_sign(factor) > 0 for factor in factors) else 0

    def sign(self, element: Element) -> int:
        """Sign on the whole domain, 0 if unknown or zero; P + Q sqrt(f) is compared through P^2 - Q^2 f."""
        element = self.collect(element)
        signs = {self._class_sign(*item) for item in element.items()}
        if len(signs) == 1 and signs != {0}:
            return signs.pop()
        for radicand in self.radicands(element):
            rational, radical = self.split(element, radicand)
            if not rational:
                continue
            one, other = self.sign(rational), self.sign(radical)
            if one and one == other:
                return one
            if one and other:
                return one * self.sign(self._norm(rational, radical))
        return 0

    # to and from SymPy

    def convert(self, expr: sp.Expr) -> Element:
        """The element of an expression; `NotProvedError` if it is not algebraic in the lengths and functions."""
        if expr in self.generators:
            return {ONE: self.ring(self.generators[expr])}
        if expr.is_Rational:
            return self.constant(expr)
        if expr.is_Add:
            return self.add(*map(self.convert, expr.args))
        if expr.is_Mul:
            result = {ONE: self.ring.one}
            for arg in expr.args:
                result = self.mul(result, self.convert(arg))
            return result
        if expr.is_Pow:
            return self.power(self.convert(expr.base), expr.exp)
        if isinstance(expr, sp.Abs):
            return self._absolute(self.convert(expr.args[0]))
        message = f"{expr} is not an algebraic expression in lengths and functions"
        raise NotProvedError(message)

    def _absolute(self, element: Element) -> Element:
        sign = self.sign(element)
        if sign == 0:
            message = f"the sign of {self.expr(element)} is not known"
            raise NotProvedError(message)
        return self.scale(element, sign)

    def expr(self, element: Element) -> sp.Expr:
        """The element as an expression of SymPy, with the functions its symbols stand for."""
        terms = [
            polynomial.as_expr() * sp.Mul(*(f.as_expr() ** e for f, e in monomial))
            for monomial, polynomial in element.items()
        ]
        return sp.Add(*terms).xreplace(self.functions)


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
