"""Elements of one field in another: their limits at an end of the domain, and at another place."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flint import fmpq

from .field import Element, Field, as_fraction, used
from .reading import Tree, UnknownError, require
from .theory import FUNCTIONS


class Limit:
    """Leading powers of the distance t of a symbol to the lower end of its range."""

    def __init__(self, field: Field, name: str, low: Tree, face: Field, side: int) -> None:
        self.field, self.name, self.low, self.face = field, name, low, face
        self.known: dict[int, tuple[Element, Element]] = {}
        self.gap = ((field.symbol(name) - field.read(low)) * side).num

    def ratio(self, x: Element) -> tuple[Element, Element]:
        """The leading power of t of an element, and its coefficient; `UnknownError` if the denominator may vanish."""
        (one, top), (two, bottom) = self.leading(x.num), self.leading(x.den)
        require(self.face.sign(bottom), "a denominator may vanish at the end")
        return one - two, top / bottom

    def value(self, x: Element) -> Element:
        """The limit, as an element of the face; `UnknownError` if no finite one is shown."""
        order, ratio = self.ratio(x)
        sign = self.face.sign(order)
        if sign == 1 or (ratio.num == 0 and sign == 0):
            return self.face.number(0)
        if sign != 0 or self.face.keys.get("log(t)", -1) in used(ratio.num) | used(ratio.den):
            message = "no finite limit is shown"
            raise UnknownError(message)
        return ratio

    def leading(self, poly: Any) -> tuple[Element, Element]:
        """The lowest power of t, and its coefficient; a coefficient of zero stands for some higher power."""
        order, value = self.face.number(0), self.face.number(1)
        unit, factors = poly.factor() if poly != 0 else (fmpq(0), [])
        value = value * as_fraction(unit)
        for factor, times in factors:
            own = self._gap(factor) or self._sum(factor)
            order, value = order + own[0] * times, value * own[1] ** times
        return order, value

    def _gap(self, factor: Any) -> tuple[Element, Element] | None:
        ratio = factor / self.gap if (factor % self.gap) == 0 else None
        if ratio is None or not ratio.is_constant():
            return None
        return self.face.number(1), self.face.number(as_fraction(ratio.leading_coefficient()))

    def _sum(self, poly: Any) -> tuple[Element, Element]:
        order, total = self.face.number(0), None
        for powers, coefficient in poly.terms():
            own, value = self.face.number(0), self.face.number(as_fraction(coefficient))
            for index, times in enumerate(powers):
                if times:
                    step, factor = self.generator(index)
                    own, value = own + step * int(times), value * factor ** int(times)
            sign = self.face.sign(own - order) if total is not None else -1
            if sign is None:
                message = "powers that are not ordered"
                raise UnknownError(message)
            if sign < 0:
                order, total = own, value
            elif sign == 0 and total is not None:
                total = total + value
        assert total is not None
        return order, total

    def generator(self, index: int) -> tuple[Element, Element]:
        """The leading power of t of a generator, and its coefficient; found once."""
        if index not in self.known:
            self.known[index] = self._generator(*self.field.kind[index])
        return self.known[index]

    def _generator(self, head: str, *rest: Any) -> tuple[Element, Element]:
        face = self.face
        none = face.number(0)
        if head == "symbol":
            if rest[0] != self.name:
                return none, face.symbol(rest[0])
            return (face.number(1), face.number(1)) if self.low == 0 else (none, face.read(self.low))
        if head == "power":
            (order, value), exponent = self.leading(rest[0]), self.value(rest[1])
            require(value.num != 0, "a power of what vanishes in an unknown way")
            return order * exponent, face.power(value, exponent)
        if head == "log":
            order, value = self.leading(rest[0][0].num)
            return none, order * face.symbol("log(t)") + face.log(value) if order.num != 0 else face.log(value)
        if head == "IncompleteBeta" or "linear" in FUNCTIONS[head].flags:
            order, first = self.ratio(rest[0][0])
            if first.num != 0 and face.sign(order) == 1:
                power = self.value(rest[0][1]) if head == "IncompleteBeta" else face.number(1)
                return order * power, face.power(first, power) / power
        return none, face.function(head, *map(self.value, rest[0]))


class Substitution:
    """Elements of one field read in another, with elements for some symbols."""

    def __init__(self, field: Field, into: Field, values: Mapping[str, Element]) -> None:
        self.field, self.into, self.values = field, into, values

    def value(self, x: Element) -> Element:
        """The element in the other field, with the values put in."""
        return self._poly(x.num) / self._poly(x.den)

    def _poly(self, poly: Any) -> Element:
        out = self.into.number(0)
        for powers, coefficient in poly.terms():
            term = self.into.number(f"{coefficient}")
            for index, times in enumerate(powers):
                if times:
                    term = term * self._generator(*self.field.kind[index]) ** times
            out = out + term
        return out

    def _generator(self, head: str, *rest: Any) -> Element:
        if head == "symbol":
            return self.values.get(rest[0]) or self.into.symbol(rest[0])
        if head == "power":
            return self.into.power(self._poly(rest[0]), self.value(rest[1]))
        return self.into.function(head, *map(self.value, rest[0]))
