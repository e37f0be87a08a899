"""Zero test in Q(lengths, functions)[f**e]: radicals of positive irreducible polynomials f.

An element is {monomial of powers f**e: polynomial}.  Roots of distinct
irreducible polynomials are independent (Kummer), so that grouping by the
exponents modulo 1 gives a canonical form: an element is zero iff nothing is
left.  Exponents may contain symbols (a**n).  Functions are independent
generators; what relates them is left to `identity`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from .domain import Domain, NotProvedError

Monomial = frozenset[tuple[PolyElement, sp.Expr]]
Element = dict[Monomial, PolyElement]

ONE: Monomial = frozenset()


def leaves(expr: sp.Expr) -> Iterator[sp.Expr]:
    """Symbols, named numbers and outermost functions."""
    stack = [expr]
    while stack:
        node = stack.pop()
        if node.is_Symbol or node.is_NumberSymbol or (node.is_Function and not isinstance(node, sp.Abs)):
            yield node
        else:
            stack.extend(node.args)


class Tower:
    """Arithmetic for the given expressions on a domain; `positive` tells whether a function is positive there."""

    def __init__(self, domain: Domain, *exprs: sp.Expr, positive: Callable[[sp.Expr], bool] = lambda _: False) -> None:
        self.domain = domain
        self._positive = positive
        found = sorted({leaf for expr in exprs for leaf in leaves(expr)} | domain.symbols, key=sp.default_sort_key)
        self.generators = {leaf: leaf if leaf.is_Symbol else sp.Symbol(f"function_{i}") for i, leaf in enumerate(found)}
        self.functions = {symbol: leaf for leaf, symbol in self.generators.items() if symbol != leaf}
        self.ring = PolyRing(list(self.generators.values()), sp.QQ, lex)
        self._factors: dict[PolyElement, tuple[int, dict[PolyElement, int]]] = {}
        self._signs: dict[PolyElement, int] = {}

    # arithmetic

    def constant(self, value: sp.Expr) -> Element:
        return {ONE: self.ring.from_expr(value)} if value != 0 else {}

    def add(self, *elements: Element) -> Element:
        total: Element = {}
        for element in elements:
            for monomial, polynomial in element.items():
                total[monomial] = total[monomial] + polynomial if monomial in total else polynomial
        return {monomial: polynomial for monomial, polynomial in total.items() if polynomial}

    def scale(self, element: Element, factor: int) -> Element:
        return {monomial: polynomial * factor for monomial, polynomial in element.items()}

    def sub(self, left: Element, right: Element) -> Element:
        return self.add(left, self.scale(right, -1))

    def mul(self, left: Element, right: Element) -> Element:
        products = (
            {_multiply(m1, m2): p1 * p2} for m1, p1 in left.items() for m2, p2 in right.items()
        )
        return self.add(*products)

    def power(self, element: Element, exponent: sp.Expr) -> Element:
        """Any rational or symbolic power; sums of radicals only to integer and half-integer powers."""
        if exponent.is_Integer and exponent >= 0:
            return self._repeated(element, int(exponent))
        element = self.collect(element)
        if not element:
            message = "division by zero, or a root of zero"
            raise NotProvedError(message)
        if len(element) == 1:
            return self._single_power(element, exponent)
        if exponent.is_Integer:
            return self._repeated(self._inverse(element), -int(exponent))
        if exponent.is_Rational and exponent.q == 2:
            return self.power(self._denested_root(element), 2 * exponent)
        message = f"a power with exponent {exponent} of a sum of radicals cannot be taken exactly"
        raise NotProvedError(message)

    def _repeated(self, element: Element, count: int) -> Element:
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
        powers = {factor: sp.expand(power * exponent) for factor, power in powers.items()}
        sign = -1 if unit < 0 and exponent % 2 else 1
        return {frozenset((f, e) for f, e in powers.items() if e != 0): self.ring(sign)}

    def _inverse(self, element: Element) -> Element:
        """1/(P + Q sqrt(f)) = (P - Q sqrt(f))/(P^2 - Q^2 f), until a single class is left."""
        if len(element) == 1:
            return self._single_power(element, sp.S.NegativeOne)
        for radicand in self._radicands(element):
            rational, radical = self._split(element, radicand)
            if rational and radical:
                norm = self.collect(self.sub(self.mul(rational, rational), self.mul(radical, radical)))
                return self.mul(self.sub(rational, radical), self._inverse(norm))
        message = f"{self.expr(element)} cannot be inverted exactly"
        raise NotProvedError(message)

    def _denested_root(self, element: Element) -> Element:
        """sqrt(P + Q) = x + y with x^2, y^2 = (P +- sqrt(P^2 - Q^2))/2, checked by squaring."""
        half = self.constant(sp.S.Half)
        for radicand in self._radicands(element):
            rational, radical = self._split(element, radicand)
            norm = self._root_up_to_sign(self.collect(self.sub(self.mul(rational, rational), self.mul(radical, radical))))
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
        content, factors = polynomial.factor_list()
        powers = {factor: sp.Integer(multiplicity) for factor, multiplicity in factors}
        for factor, power in monomial:
            powers[factor] = powers.get(factor, sp.S.Zero) + power
        root = sp.sqrt(sp.QQ.to_sympy(content))
        if not root.is_Rational or any(not (power / 2).is_Integer for power in powers.values()):
            return None
        return {frozenset((f, e / 2) for f, e in powers.items() if e != 0): self.ring.from_expr(root)}

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
        for fractional, terms in classes.items():
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
                out[_multiply(fractional, below)] = total
        return out

    def is_zero(self, element: Element) -> bool:
        return not self.collect(element)

    def factors(self, polynomial: PolyElement) -> tuple[int, dict[PolyElement, int]]:
        """Unit and irreducible factors (primes included) with multiplicities.

        Factors are positive on the domain, or have a positive leading coefficient if their sign is not known.
        """
        if polynomial not in self._factors:
            content, factors = polynomial.factor_list()
            unit, out = (1 if content > 0 else -1), {}
            for factor, multiplicity in factors:
                sign = self.polynomial_sign(factor) or (1 if factor.LC > 0 else -1)
                unit *= sign**multiplicity
                out[factor * sign] = multiplicity
            for prime, multiplicity in sp.factorrat(abs(sp.QQ.to_sympy(content))).items():
                out[self.ring(prime)] = multiplicity
            self._factors[polynomial] = (unit, out)
        return self._factors[polynomial]

    def _radicands(self, element: Element) -> list[PolyElement]:
        """Polynomials whose root occurs, simplest first."""
        found = {f for monomial in element for f, e in monomial if e.is_Rational and e.q == 2}
        return sorted(found, key=lambda f: (len(f), str(f)))

    def _split(self, element: Element, radicand: PolyElement) -> tuple[Element, Element]:
        """The part without and the part with sqrt(radicand)."""
        with_root = {m for m in element if any(f == radicand and not e.is_Integer for f, e in m)}
        rational = {m: p for m, p in element.items() if m not in with_root}
        return rational, {m: element[m] for m in with_root}

    def primitive(self, element: Element) -> tuple[dict[PolyElement, sp.Expr], Element]:
        """Positive common factors with exponents, and what remains of a sum of radicals."""
        element = self.collect(element)
        shared = {factor for monomial in element for factor, _ in monomial}
        lowest = {f: min((dict(monomial).get(f, sp.S.Zero) for monomial in element), key=sp.Float) for f in shared}
        content = self.ring.from_expr(sp.gcd_list([sp.QQ.to_sympy(p.content()) for p in element.values()]))
        for number, polynomial in enumerate(element.values()):
            common = polynomial.monic() if number == 0 else common.gcd(polynomial)
        unit, factors = self.factors(common * content)
        if any(self.polynomial_sign(factor) <= 0 for factor in (*factors, *lowest)):
            message = f"the factors of {self.expr(element)} are not shown to be positive"
            raise NotProvedError(message)
        inverse = self._single_power({frozenset(lowest.items()): common * content * unit}, sp.S.NegativeOne)
        for factor, multiplicity in factors.items():
            lowest[factor] = lowest.get(factor, sp.S.Zero) + multiplicity
        return lowest, self.collect(self.mul(element, inverse))

    # signs

    def polynomial_sign(self, polynomial: PolyElement) -> int:
        if polynomial not in self._signs:
            ring = self.ring
            used = [f for s, f in self.functions.items() if polynomial.degree(ring(s)) > 0]
            known = all(self._positive(function) for function in used)
            self._signs[polynomial] = self.domain.sign(polynomial) if known else 0
        return self._signs[polynomial]

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
        for radicand in self._radicands(element):
            rational, radical = self._split(element, radicand)
            if not rational:
                continue
            one, other = self.sign(rational), self.sign(radical)
            if one and one == other:
                return one
            if one and other:
                return one * self.sign(self.sub(self.mul(rational, rational), self.mul(radical, radical)))
        return 0

    # to and from SymPy

    def convert(self, expr: sp.Expr) -> Element:
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
        terms = [
            polynomial.as_expr() * sp.Mul(*(f.as_expr() ** e for f, e in monomial)) for monomial, polynomial in element.items()
        ]
        return sp.Add(*terms).xreplace(self.functions)


def _multiply(left: Monomial, right: Monomial) -> Monomial:
    if not left or not right:
        return left or right
    powers = dict(left)
    for factor, exponent in right:
        powers[factor] = powers[factor] + exponent if factor in powers else exponent
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
