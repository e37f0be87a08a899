"""The algebra of the second prover: formulas as elements of a differential field over an ordered domain.

An element is a quotient of two polynomials of FLINT in symbols, powers of positive polynomials and functions.
It is zero if its numerator is, modulo y**q = P, or if its derivative is and its value at one end of the domain.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property, reduce
from typing import Any

from flint import fmpq, fmpq_mpoly_ctx, fmpz

from .reading import Tree, UnknownError, require, symbols
from .theory import FUNCTIONS, Condition, Equation

ROOM, PAIRS = 56, 4
"""Generators of a field; the last ones, in pairs, stand for where bounded ones are between their bounds."""
RING = fmpq_mpoly_ctx.get(tuple(f"g{i}" for i in range(ROOM)), "lex")
GENS, ONE = RING.gens(), RING.constant(1)
HALF = Fraction(1, 2)
DEPTH = 5
BOUNDS: dict[str, tuple[Fraction | int, Fraction | int]] = {
    "k": (-1, 1),
    "alpha": (0, 1),
    "tangent": (0, 1),
    "share": (0, 1),
    **dict.fromkeys(("nu", "nu_1", "nu_2"), (-1, HALF)),
}
ANY_SIGN = {*BOUNDS, "sigma", "nu", "nu_1", "nu_2", "e", "log(t)"}
"""Symbols that are not simply positive; log(t) is that of the distance to an end of the domain."""


class FinerError(Exception):
    """A power with a finer exponent is needed: the statement has to begin again."""


def used(poly: Any) -> set[int]:
    """Indices of the generators that occur in a polynomial."""
    return {i for i, degree in enumerate(poly.degrees()) if degree > 0}


def as_fraction(value: Any) -> Fraction:
    """A rational number of FLINT as a `Fraction`."""
    return Fraction(int(value.p), int(value.q))


class Element:
    """A quotient of two polynomials in the generators of a field."""

    __slots__ = ("den", "field", "num")

    def __init__(self, field: Field, num: Any, den: Any = ONE) -> None:
        num = field.reduced(num)
        if den is not ONE and den != ONE:
            den = field.reduced(den)
            require(den != 0, "a division by zero")
            if not den.is_constant():
                common = num.gcd(den)
                num, den = num / common, den / common
            lead = den.leading_coefficient()
            num, den = num / lead, den / lead
        self.field, self.num, self.den = field, num, den

    def _other(self, other: Any) -> Element:
        return other if isinstance(other, Element) else self.field.number(other)

    def __add__(self, other: Any) -> Element:
        other = self._other(other)
        if self.den == other.den:
            return Element(self.field, self.num + other.num, self.den)
        return Element(self.field, self.num * other.den + other.num * self.den, self.den * other.den)

    def __mul__(self, other: Any) -> Element:
        other = self._other(other)
        return Element(self.field, self.num * other.num, self.den * other.den)

    def __sub__(self, other: Any) -> Element:
        other = self._other(other)
        if self.den == other.den:
            return Element(self.field, self.num - other.num, self.den)
        return Element(self.field, self.num * other.den - other.num * self.den, self.den * other.den)

    def __truediv__(self, other: Any) -> Element:
        other = self._other(other)
        return Element(self.field, self.num * other.den, self.den * other.num)

    def __pow__(self, times: int) -> Element:
        num, den = (self.num, self.den) if times >= 0 else (self.den, self.num)
        return Element(self.field, num ** abs(times), den ** abs(times))

    @property
    def number(self) -> Fraction | None:
        """The value, if the element is a number."""
        if not (self.num.is_constant() and self.den.is_constant()):
            return None
        return as_fraction(self.num.leading_coefficient()) if self.num != 0 else Fraction(0)

    @property
    def name(self) -> str:
        """The quotient as text, in the keys of its generators."""
        return f"({self.field.name(self.num)})/({self.field.name(self.den)})"


class Field:
    """Formulas over one domain; `order` lists pairs (low, high) of a formula and the symbol above it."""

    def __init__(self, order: Iterable[tuple[Tree, str]], finer: dict[str, int], end: float) -> None:
        self.order, self.finer, self.end = tuple(order), finer, end
        self.free = ROOM - 2 * PAIRS
        self.kind: dict[int, tuple[Any, ...]] = {}
        self.keys: dict[str, int] = {}
        self.relations: dict[int, tuple[int, Any]] = {}
        self.positive: set[int] = set(range(self.free, ROOM))
        self.safe: set[int] = set()
        self.signs: dict[str, int | None] = {}
        self.slopes: dict[tuple[int, str], Element] = {}
        self.elements: dict[Tree, Element] = {}

    @cached_property
    def lower(self) -> list[tuple[str, Tree]]:
        """Symbols with what is below them, from above to below."""
        below = dict(reversed([(high, low) for low, high in self.order]))

        def height(name: str) -> int:
            return 1 + max(map(height, symbols(below[name])), default=0) if name in below else 0

        # equal ones in the order in which they are given
        names = sorted(dict.fromkeys(high for _, high in self.order), key=height, reverse=True)
        return [(name, below[name]) for name in names]

    def number(self, value: Any) -> Element:
        """The element of an integer, a `Fraction` or the text of one."""
        return Element(self, RING.constant(fmpq(Fraction(value).numerator, Fraction(value).denominator)))

    def reduced(self, poly: Any) -> Any:
        """The polynomial with powers of roots lowered by y**q = P."""
        if not self.relations or poly.is_constant():
            return poly
        degrees = poly.degrees()
        # from the newest on: a root may stand in the relation of a later one
        for index, (degree, relation) in reversed(self.relations.items()):
            if degrees[index] >= degree:
                poly = poly % relation
                degrees = poly.degrees()
        return poly

    def name(self, poly: Any) -> str:
        """The polynomial in the keys of its generators, which stay the same when a statement begins again."""
        names = {index: key for key, index in self.keys.items()}
        return "+".join(f"{c}" + "".join(f"*[{names[i]}]^{m}" for i, m in enumerate(e) if m) for e, c in poly.terms())

    def generator(self, key: str, kind: tuple[Any, ...], *, positive: bool, safe: bool) -> Element:
        """The generator of a key, made if it is new; `UnknownError` where room or time has run out."""
        if key not in self.keys:
            self.free -= 1
            # the clock is slow, and asked for every eighth one alone
            in_time = self.free % 8 or time.process_time() <= self.end
            require(self.free >= 0 and in_time, "no proof within the room and the time given")
            self.keys[key], self.kind[self.free], self.signs = self.free, kind, {}
            self.positive |= {self.free} if positive else set()
            self.safe |= {self.free} if safe else set()
        return Element(self, GENS[self.keys[key]])

    def symbol(self, name: str) -> Element:
        """The generator of a symbol, positive unless `ANY_SIGN` has it."""
        return self.generator(name, ("symbol", name), positive=name not in ANY_SIGN, safe=True)

    def read(self, formula: Tree, values: Mapping[str, Element] | None = None) -> Element:
        """The element of a tree, with elements for some of its symbols; one without them is read once."""
        if values or not isinstance(formula, tuple):
            return self._read(formula, values or {})
        if formula not in self.elements:
            self.elements[formula] = self._read(formula, {})
        return self.elements[formula]

    def _read(self, formula: Tree, values: Mapping[str, Element]) -> Element:
        match formula:
            case str():
                return values[formula] if formula in values else self.symbol(formula)
            case int() | Fraction():
                return self.number(formula)
            case ("Pow", base, exponent):
                return self.power(self.read(base, values), self.read(exponent, values))
            case ("exp", inner):
                return self.exp(self.read(inner, values))
            case ("Sum", term, ("Tuple", "j", 1, "N")):
                return self.read(term, values)
            case ("D", inner, str(name)):
                return self.slope(self.read(inner, values), name)
            case ("ratio", top, bottom):
                return self.read(top, values) / self.read(bottom, values)
            case ("Abs" | "sign" | "Max" as head, *_, inner) if head != "Max" or formula[1] == 0:
                return self.signed(head, self.read(inner, values))
            case ("elliptic_e" | "elliptic_f" as head, ("asin", sine), parameter):
                return self.function(head, self.read(sine, values), self.read(parameter, values))
            case ("Add" | "Mul" as head, *parts):
                elements = (self.read(part, values) for part in parts)
                return reduce(Element.__add__ if head == "Add" else Element.__mul__, elements)
            case (str(head), *arguments):
                return self.function(head, *(self.read(argument, values) for argument in arguments))
        message = f"{formula} is no formula"
        raise UnknownError(message)

    def signed(self, head: str, x: Element) -> Element:
        """Abs(x), sign(x) or Max(0, x); `UnknownError` if x is not shown to have one sign on the whole domain."""
        sign = self.sign(x)
        if sign is None:
            message = f"the sign in {head} is not shown"
            raise UnknownError(message)
        return self.number(sign) if head == "sign" else x * sign if head == "Abs" or sign == 1 else self.number(0)

    # powers and logarithms, factor by factor

    def factors(self, x: Element) -> list[tuple[Any, int]]:
        """Positive irreducible polynomials, primes among them, and their multiplicities in a positive element."""
        out, sign = [], 1
        for poly, direction in ((x.num, 1), (x.den, -1)):
            unit, found = poly.factor()
            sign *= -1 if unit < 0 else 1
            whole = as_fraction(unit)
            for number, way in ((abs(whole.numerator), direction), (whole.denominator, -direction)):
                out += [(RING.constant(prime), way * times) for prime, times in fmpz(number).factor()]
            for factor, times in found:
                own = self.poly_sign(factor)
                require(own, "the sign under a root or a logarithm is not shown")
                sign *= own**times
                out.append((factor * own, direction * times))
        require(sign >= 0 and x.num != 0, "a root or a logarithm of a number that is not positive")
        return out

    def _root(self, base: Any) -> tuple[Any, Element] | None:
        """What a polynomial is a power of, if it is a generator that stands for one."""
        (index,) = used(base) if len(used(base)) == 1 else (-1,)
        return self.kind[index][1:] if index >= 0 and base == GENS[index] and self.kind[index][0] == "power" else None

    def power(self, base: Element, exponent: Element) -> Element:
        """Base to an exponent, factor by factor; `UnknownError` if a sign that is needed is not shown."""
        number = exponent.number
        if number is not None and number.denominator == 1:
            require(number >= 0 or self.poly_sign(base.num), "a denominator may vanish")
            return base**number.numerator
        if base.num == 0 and self.sign(exponent) == 1:
            return base
        parts = [self._power(factor, exponent * times) for factor, times in self.factors(base)]
        return reduce(Element.__mul__, parts, self.number(1))

    def _power(self, base: Any, exponent: Element) -> Element:
        """A positive irreducible polynomial to a power: its own generator for each term of the exponent."""
        root = self._root(base)
        if root:
            return self._power(root[0], root[1] * exponent)
        out = self.number(1)
        for factor, unit in self.terms(exponent):
            plain = unit.number is not None
            if plain and factor.denominator == 1:
                out = out * Element(self, base) ** factor.numerator
                continue
            key = f"{self.name(base)}**{unit.name}"
            fine = self.finer.setdefault(key, factor.denominator)
            if fine % factor.denominator:
                self.finer[key] = math.lcm(fine, factor.denominator)
                raise FinerError
            found = self.generator(key, ("power", base, unit * Fraction(1, fine)), positive=True, safe=True)
            if plain:
                self.relations[self.keys[key]] = fine, found.num**fine - base
            out = out * found ** int(factor * fine)
        return out

    def terms(self, exponent: Element) -> Iterator[tuple[Fraction, Element]]:
        """Numbers times units: monomials, over the denominator where they are the rest of the division by it."""
        if any(self.kind[i][0] != "symbol" for i in used(exponent.num) | used(exponent.den)):
            message = "an exponent that is not rational"
            raise UnknownError(message)
        quotient, rest = divmod(exponent.num, exponent.den)
        for poly, den in ((quotient, ONE), (rest, exponent.den)):
            for powers, coefficient in poly.terms():
                yield as_fraction(coefficient), Element(self, RING.from_dict({powers: 1}), den)

    def log(self, x: Element) -> Element:
        """The logarithm as a sum over the factors of x; `UnknownError` if x is not shown to be positive."""
        out = self.number(0)
        for factor, times in self.factors(x):
            root = self._root(factor)
            if factor == self.symbol("exp").num:
                own = self.number(1)
            elif root:
                own = self.log(Element(self, root[0])) * root[1]
            else:
                own = self.opaque("log", Element(self, factor))
            out = out + own * times
        return out

    def exp(self, x: Element) -> Element:
        """exp(x), where multiples of logarithms in x become powers."""
        out = self.number(1)
        for index in used(x.num):
            if self.kind[index][0] == "log":
                factor = Element(self, x.num.derivative(index), x.den)
                out = out * self.power(self.kind[index][1][0], factor)
                x = x - factor * Element(self, GENS[index])
        return out * self.power(self.symbol("exp"), x)

    # functions

    def function(self, head: str, *args: Element) -> Element:
        """A function by the first equation of the table that fits, else as a generator of its own."""
        if head == "log":
            return self.log(args[0])
        known = FUNCTIONS.get(head)
        if known is None or len(args) != len(known.letters):
            message = f"{head} of {len(args)} arguments is not known"
            raise UnknownError(message)
        for equation in known.equations:
            values = self.fitted(equation, known.letters, args)
            if values is not None:
                if equation.value == "positive":
                    return self.opaque(head, *args, positive=True)
                return self.read(equation.value, values)
        if "odd" in known.flags and args[0].num.leading_coefficient() < 0:
            return self.opaque(head, args[0] * -1) * -1
        return self.opaque(head, *args)

    def fitted(self, equation: Equation, letters: Sequence[str], args: Sequence[Element]) -> dict[str, Element] | None:
        """The arguments by their letters if they are as an equation asks, else None."""
        values: dict[str, Element] = {}
        for wanted, own in zip(equation.arguments, args, strict=True):
            other = values.get(wanted) if wanted in letters else self.read(wanted)
            if other is None:
                values[wanted] = own
            elif (other - own).num != 0:
                return None
        return values if all(one.met(self.compared(one, values)) for one in equation.conditions) else None

    def compared(self, condition: Condition, values: Mapping[str, Element]) -> int | None:
        """The sign of the difference of the sides of a condition; of ceil and floor, that of the constant part."""
        match condition.left:
            case ("ceil" | "floor" as head, inner):
                constant = sum(c for c, unit in self.terms(self.read(inner, values)) if unit.number is not None)
                rounded = math.ceil(constant) if head == "ceil" else math.floor(constant)
                return self.sign(self.read(rounded) - self.read(condition.right))
        return self.sign(self.read(condition.left, values) - self.read(condition.right))

    def opaque(self, head: str, *args: Element, positive: bool = False) -> Element:
        """A function as a generator of its own, one for equal arguments."""
        known = FUNCTIONS[head]
        require(known.slopes or known.margins, "{} is not known there", head)
        for index, kind in self.kind.items():
            if kind[0] == head and all((a - b).num == 0 for a, b in zip(kind[1], args, strict=True)):
                return self._continuous(head, index in self.safe, Element(self, GENS[index]))
        values = dict(zip(known.letters, args, strict=True))
        safe = positive or all(self.sign(self.read(margin, values)) == 1 for margin in known.margins)
        safe = safe and all(map(self.analytic, args))
        positive = positive or (safe and "positive" in known.flags and self.sign(args[0]) == 1)
        key = f"{head}{[arg.name for arg in args]}"
        return self._continuous(head, safe, self.generator(key, (head, args), positive=positive, safe=safe))

    def _continuous(self, head: str, safe: bool, found: Element) -> Element:
        require(safe, "{} is not shown to be analytic", head)
        return found

    def analytic(self, x: Element) -> bool:
        """Whether the element is shown to be real-analytic on the whole domain."""
        return used(x.num) | used(x.den) <= self.safe and bool(self.poly_sign(x.den))

    # signs

    def sign(self, x: Element) -> int | None:
        """-1, 0 or 1 where that is shown to be the sign on the whole domain, otherwise None."""
        top, bottom = self.poly_sign(x.num), self.poly_sign(x.den)
        return None if top is None or not bottom else top * bottom

    def poly_sign(self, poly: Any, depth: int = DEPTH) -> int | None:
        """-1, 0 or 1 where that is shown to be the sign on the whole domain."""
        if poly.is_constant():
            return 0 if poly == 0 else 1 if poly.leading_coefficient() > 0 else -1
        key = str(poly)
        if key not in self.signs:
            unit, factors = poly.factor()
            total: int | None = 1 if unit > 0 else -1
            for factor, times in factors:
                own = self._factor_sign(factor, depth)
                total = None if own is None or total is None else total * own**times
            self.signs[key] = total
        return self.signs[key]

    def _factor_sign(self, poly: Any, depth: int) -> int | None:
        shifted = self.shifted(poly)
        if used(shifted) <= self.positive and len({c > 0 for c in shifted.coeffs()}) == 1:
            return 1 if shifted.leading_coefficient() > 0 else -1
        for index in sorted(self.relations) if depth else ():
            if poly.degrees()[index] != 1:
                continue
            # A + B y with y**q = P has the sign of the larger of |A|**q and |B|**q P
            slope = poly.derivative(index)
            rest, degree = poly - slope * GENS[index], self.relations[index][0]
            one, two = self.poly_sign(rest, depth - 1), self.poly_sign(slope, depth - 1)
            if one is None or two is None:
                continue
            if one * two >= 0:
                return one or two
            gap = self.reduced((slope * two * GENS[index]) ** degree - (rest * one) ** degree)
            larger = self.poly_sign(gap, depth - 1)
            if larger is not None:
                return larger * two
        return None

    def shifted(self, poly: Any) -> Any:
        """With each symbol replaced by what is below it plus a positive one, from above to below."""
        degrees = poly.degrees()
        for name, below in self.lower:
            index = self.keys.get(name, -1)
            if index >= 0 and degrees[index]:
                low = self.read(below)
                if not low.den.is_constant():
                    continue
                poly = poly.compose(*(g + low.num if i == index else g for i, g in enumerate(GENS)), ctx=RING)
                degrees = poly.degrees()
        for index in used(poly):
            head, *rest = self.kind.get(index, ("",))
            if head == "power" and rest[0] == self.symbol("exp").num and self.sign(rest[1]) == 1:
                # above 1
                poly = poly.compose(*(g + 1 if i == index else g for i, g in enumerate(GENS)), ctx=RING)
        pair = ROOM
        for index in sorted(used(poly)):
            head, *rest = self.kind.get(index, ("",))
            own = BOUNDS.get(str(rest[0]), (0, 0)) if head == "symbol" else (0, 0)
            low, high = self.number(own[0]).num, self.number(own[1]).num
            if head == "asin" and index in self.positive:
                high = self.symbol("pi").num / 2
            if high != 0 and pair > ROOM - 2 * PAIRS:
                pair -= 2
                poly = between(poly, index, low, high, GENS[pair], GENS[pair + 1])
        return poly

    # derivatives, limits, zero

    def slope(self, x: Element, name: str) -> Element:
        """The derivative in a symbol."""
        top, bottom = (self._poly_slope(poly, name) for poly in (x.num, x.den))
        den = Element(self, x.den)
        return top / den - Element(self, x.num) * bottom / (den * den)

    def _poly_slope(self, poly: Any, name: str) -> Element:
        out = self.number(0)
        for index in used(poly):
            if (index, name) not in self.slopes:
                self.slopes[index, name] = self._generator_slope(index, name)
            if self.slopes[index, name].num != 0:
                out = out + self.slopes[index, name] * Element(self, poly.derivative(index))
        return out

    def _generator_slope(self, index: int, name: str) -> Element:
        head, *rest = self.kind[index]
        own = Element(self, GENS[index])
        if head == "symbol":
            return self.number(1 if rest[0] == name else 0)
        if head == "power":
            base, exponent = Element(self, rest[0]), rest[1]
            growth = self.slope(base, name) * exponent / base
            change = self.slope(exponent, name)
            return own * (growth + change * self.log(base)) if change.num != 0 else own * growth
        known = FUNCTIONS[head]
        out, values = self.number(0), dict(zip(known.letters, rest[0], strict=True))
        for letter, argument in values.items():
            inner = self.slope(argument, name)
            if inner.num != 0:
                require(letter in known.slopes, "the derivative of {} in a parameter is not known", head)
                out = out + self.read(known.slopes[letter], values) * inner
        return out

    def face(self, name: str) -> tuple[Tree, Field]:
        """The lower end of a symbol and the field on that face of the domain."""
        low = next((low for low, high in self.order if high == name), 0)
        order = [(low if below == name else below, high) for below, high in self.order if high != name]
        return low, Field([pair for pair in order if pair[0] != 0], self.finer, self.end)

    def limit(self, x: Element, name: str, low: Tree, face: Field) -> Element:
        """The limit of an element as a symbol falls to the lower end of its range."""
        # late: limits are of elements of a field
        from .limits import Limit

        return Limit(self, name, low, face, 1).value(x)

    def zero(self, x: Element, depth: int = 3) -> bool:
        """Whether the element is shown to vanish on the whole domain."""
        if x.num == 0:
            return True
        if not depth or not self.analytic(x):
            return False
        functions = [i for i in sorted(used(x.num)) if self.kind[i][0] not in ("symbol", "power")]
        for index in functions:
            factor = Element(self, x.num.derivative(index))
            if x.num.degrees()[index] != 1 or not self.sign(factor):
                continue
            ratio = Element(self, x.num) / factor
            for name in self.varied(index):
                try:
                    low, face = self.face(name)
                    if self.zero(self.slope(ratio, name), depth - 1) and face.zero(
                        self.limit(ratio, name, low, face), depth - 1
                    ):
                        return True
                except UnknownError:
                    continue
        return False

    def varied(self, index: int) -> list[str]:
        """The symbols a generator depends on."""
        head, *rest = self.kind[index]
        if head == "symbol":
            return [] if rest[0] in ANY_SIGN | {"pi", "exp"} else [rest[0]]
        parts = [rest[1], Element(self, rest[0])] if head == "power" else rest[0]
        inner = {i for part in parts for i in used(part.num) | used(part.den)}
        return sorted({name for i in inner for name in self.varied(i)})


def between(poly: Any, index: int, low: Any, high: Any, u: Any, v: Any) -> Any:
    """A positive multiple of the polynomial with (low u + high v)/(u + v) for a bounded generator, u, v > 0."""
    degree, out = poly.degrees()[index], RING.constant(0)
    for powers, coefficient in poly.terms():
        rest = RING.from_dict({tuple(0 if i == index else m for i, m in enumerate(powers)): coefficient})
        out += rest * (low * u + high * v) ** int(powers[index]) * (u + v) ** int(degree - powers[index])
    return out
