"""The tower Q(lengths, functions)[f**e]: zero test, roots, inverses and signs.

The f are positive irreducible polynomials; exponents may contain symbols
(a**n).  Functions are independent generators; what relates them is left to
`identity`.
"""

from __future__ import annotations

import functools

import sympy as sp
from sympy.polys.rings import PolyElement

from .domain import NotProvedError
from .elements import LARGEST_POWER, ONE, Element, Elements, Monomial, factor_list, spelled


class Tower(Elements):
    """The field of the given expressions on a domain."""

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
        if count > LARGEST_POWER:
            message = f"a power with exponent {count} is not expanded"
            raise NotProvedError(message)
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
