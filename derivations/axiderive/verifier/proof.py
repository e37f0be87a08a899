"""What the theory states of one quantity, looked at in every order of its lengths."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from .field import Element, Field
from .limits import Limit, Substitution
from .reading import SIGNS, Chain, Tree, UnknownError, heads, ordered, put, require, symbols, tree
from .theory import THEORY, Line, Statement, chain, pairs, statements

if TYPE_CHECKING:
    from .problem import Case, Problem

WAYS: tuple[tuple[str, tuple[tuple[Tree, str], ...]], ...] = (
    ("b*(1 + tangent**2)/(2*tangent)", ()),
    ("b*(1 + (q - 1/q)**2/2)**(1/2)", ((1, "q"),)),
)
"""A length above b in variables that make sqrt(a^2 - b^2) rational, 0 < tangent < 1 and q > 1."""


@dataclass(frozen=True)
class Domain:
    """One order of the lengths, and pairs (low, high) that are known besides."""

    order: Chain
    also: tuple[tuple[Tree, Tree], ...] = ()

    def below(self, low: Tree, high: Tree) -> bool:
        """Whether one lies below the other."""
        if low in self.order and high in self.order:
            return self.order.index(low) < self.order.index(high)
        return (low, high) in self.also

    def without(self, *members: str) -> Domain:
        """The domain of the other lengths."""
        return Domain(tuple(m for m in self.order if m not in members), self.also)


class Proof:
    """The statements about one quantity of a problem."""

    def __init__(self, problem: Problem, suffix: str) -> None:
        self.problem, self.suffix, self.section = problem, suffix, problem.section(suffix)
        self.flags = problem.flags.union(*(symbols(case.expr) for case in problem.entries[suffix]))
        self.lines = [line for line in self.section.lines if self.holds(line.conditions)]
        self.asked = [line for line in self.lines if line.word == "show"]
        self.lets: dict[str, list[Line]] = {}
        for line in [*self.lines, *THEORY.lets]:
            if line.word == "let":
                self.lets.setdefault(line.named[0], []).append(line)
        self.constants = {**problem.medium, **problem.ends}
        self.levels = [line for line in self.lines if line.word == "level"]
        self.places: dict[tuple[Tree, Domain], Tree] = {}
        self.used: list[tuple[Case, Chain, Chain]] = []

    # where lines hold

    def holds(self, conditions: Iterable[str], domain: Domain | None = None) -> bool:
        """Whether all conditions of a line are met; those on an order count where one is given."""
        return all(self._holds(text, domain) for text in conditions)

    def _holds(self, text: str, domain: Domain | None) -> bool:
        if " < " in text and domain is None:
            return True
        if text.startswith("not "):
            return not self._holds(text[4:], domain)
        if " < " in text and domain:
            return all(itertools.starmap(domain.below, itertools.pairwise(self.chained(text))))
        *other, flag = text.split(" ")
        record = self.problem.records[other[0] if other else self.suffix]
        return record["status"] == flag or flag in self.flags or bool(record.get(flag))

    def chained(self, text: str) -> Chain:
        """An order of the table; its floor is the break up to which the face is level, its end that of the profile."""
        known = self.problem.ends
        return tuple(ordered(put(m, known)) for m in chain(text) if m in known or m not in ("floor", "end"))

    def domains(self) -> list[tuple[Domain, Chain]]:
        """Every order of a, the breaks, the lengths of the profile and those that the section names.

        With it comes the order in which the case of the formula is stated: that of the lengths it depends on.
        """
        problem = self.problem
        either = [self.chained(text) for line in self.lines if line.word == "either" for text in line.text.split(" | ")]
        stated = [self.chained(line.text) for line in self.lines if line.word == "case"]
        given = [pair for line in self.lines if line.word == "given" for pair in pairs(chain(line.text))]
        out = []
        for known in either or [()]:
            part = Domain((), pairs(known))
            clauses = [[tuple(problem.breaks)], [problem.chain], [(problem.floor, "a")] if problem.floor else [()]]
            orders = [line for line in self.lines if line.word == "order" and self.holds(line.conditions, part)]
            clauses += [[self.chained(one) for one in line.text.split(" or ")] for line in orders]
            levels = {letter for line in self.levels for letter in symbols(line.named[2])}
            members = {"a", *levels, *(m for clause in clauses for one in clause for m in one)}
            own = {"a", *levels, *self.section.letters, *problem.breaks, *problem.chain}
            also = part.also + tuple((self.expand(low, part), self.expand(high, part)) for low, high in given)
            for order in itertools.permutations(sorted(members)):
                if all(any(is_part(one, order) for one in clause) for clause in clauses):
                    out.append((Domain(order, also), known or tuple(m for m in order if m in own)))
        if len(out) == 1 and "a" in levels:
            stated = [()]
        return [(domain, stated[0] if stated else case) for domain, case in out]

    def needs(self) -> list[tuple[Problem, str]]:
        """The quantities that the statements name, of this problem and of the normal contact below."""
        lets = [(name, line) for name, lines in self.lets.items() for line in lines]
        names, left = self.section.first("needs"), [*self.levels, *self.asked]
        while left:
            found = [name for formula in left.pop().formulas() for name in mentioned(formula)]
            names += [name.strip("[]") for name in found if name.startswith("[")]
            left += [line for name, line in lets if name in (one.strip("[]") for one in found)]
            lets = [(name, line) for name, line in lets if line not in left]
        quantities = {name: None for name in names if name != "f" and name not in self.lets}
        beside = {self.suffix, *self.section.first("beside")}
        sources = [self.source(name)[1:] for name in quantities]
        return [(problem, suffix) for problem, suffix in sources if problem is not self.problem or suffix not in beside]

    # formulas

    def source(self, name: str) -> tuple[str, Problem, str]:
        """What is meant by a name like normal.F or left.rp: a side or nothing, the problem and the quantity."""
        side, _, suffix = name.rpartition(".")
        problem = self.problem.plain if side == "normal" else self.problem
        if problem is None or suffix not in problem.records:
            message = "the normal contact below is not given" if problem is None else f"there is no {name}"
            raise UnknownError(message)
        return side.removeprefix("normal"), problem, suffix

    def expand(self, formula: Tree, domain: Domain) -> Tree:
        """A formula of the table with what its names stand for in a domain."""
        if not isinstance(formula, tuple):
            if formula == "own":
                return self.formula("own", [], domain, self)
            if formula == "power":
                return self.problem.power()
            return self.let(formula, [], domain) if isinstance(formula, str) else formula
        head, *parts = formula[0], *(self.expand(part, domain) for part in formula[1:])
        if not head.startswith("["):
            return (head, *parts)
        if head == "[f]":
            piece = self.problem.pieces[sum(domain.below(b, parts[0]) for b in self.problem.breaks)]
            return put(piece, {"r": parts[0], "x": parts[0]})
        if head[1:-1] in self.lets:
            return self.let(head[1:-1], parts, domain)
        side, problem, suffix = self.source(head[1:-1])
        return problem.proof(suffix).formula(side, parts, domain, self)

    def let(self, name: str, parts: list[Tree], domain: Domain) -> Tree:
        """What a name of the table stands for; the name itself where it is a symbol."""
        for line in self.lets.get(name, ()):
            _, letters, formula = line.named
            if self.holds(line.conditions, domain):
                return self.expand(put(formula, dict(zip(letters, parts, strict=True))), domain)
        return self.constants.get(name, name)

    def formula(self, side: str, parts: list[Tree], domain: Domain, asking: Proof) -> Tree:
        """The formula of this quantity in a domain, with other letters; `UnknownError` if there is not one of them."""
        section = THEORY.sections["compact", self.suffix] if side == "partial" else self.section
        values = dict(zip(section.letters, parts, strict=False))
        places = [(case, tuple(self.place(m, values, domain, asking) for m in case.chain))
                  for case in self.problem.cases(self.suffix, side)]  # fmt: skip
        found = [(case, members) for case, members in places if is_ordered(members, domain)]
        require(len(found) == 1, "not one case of {} for this order", self.suffix)
        self.used.append((*found[0], domain.order))
        expr = found[0][0].expr
        if side in ("left", "right"):
            require(isinstance(expr, tuple) and expr[0] in ("Equality", "Eq"), "it is no equation")
            expr = expr[1 if side == "left" else 2]
        return put(expr, values)

    def place(self, member: Tree, values: dict[str, Tree], domain: Domain, asking: Proof) -> Tree:
        """The length that a member of an order stands for: a quantity given for a radius, or its value at a border."""
        for name, _, level in (line.named for line in self.levels):
            (radius,) = symbols(level)
            if member == name:
                return radius
            if isinstance(member, tuple):
                if (member, domain) not in self.places:
                    self.places[member, domain] = self.border(member, name, level, radius, domain, asking)
                return self.places[member, domain]
        found = values.get(member) if isinstance(member, str) else None
        return found if isinstance(found, str) else member

    def border(self, member: Tree, name: str, level: Tree, radius: str, domain: Domain, asking: Proof) -> Tree:
        """The length x with this value of a quantity, or for a radius as its formula that radius; else what it was."""
        known, field = self.expand(level, domain), asking.problem.field(domain)
        if name in symbols(member):
            pairs = [(put(member, {name: known}), radius, radius)]
        else:
            pairs = [(put(known, {radius: x}), member, x) for x in domain.order if x != radius]
        for one, other, x in pairs:
            try:
                if field.zero(field.read(one) - field.read(other)):
                    return x
            except UnknownError:
                continue
        return member

    # what is shown

    def run(self) -> None:
        """Raises `UnknownError` unless every statement is shown in every order, each with one case of the formula."""
        for suffix in self.section.first("beside"):
            self.problem.cases(suffix, "")
        own, seen = {id(case) for case in self.problem.entries[self.suffix]}, set[int]()
        for domain, stated in self.domains():
            self.used = []
            for line in self.asked:
                if self.holds(line.conditions, domain):
                    self.check(line, domain)
            found = {
                (id(case), places) for case, places, order in self.used if order == domain.order and id(case) in own
            }
            seen |= {case for case, _ in found}
            require({places for _, places in found} == {stated}, "its cases are not every place in the order once")
        require(seen == own, "not all of its cases are looked at")

    def check(self, line: Line, domain: Domain) -> None:
        """Raises `UnknownError` unless one of the statements of a line is shown, as it is or in one of `WAYS`."""
        reasons = []
        for statement in statements(line.text):
            known = replace(domain, also=domain.also + statement.given)
            for values, place in self.ways(statement, known):
                try:
                    self.show(statement, place, values)
                except UnknownError as error:
                    reasons.append(error)
                else:
                    return
        message = f"{line.text}: {reasons[0]}"
        raise UnknownError(message)

    def ways(self, statement: Statement, domain: Domain) -> Iterator[tuple[dict[str, Tree], Domain]]:
        """The domain as it is, and for an equation with the length next to the break b in another variable."""
        yield {}, domain
        order = domain.order
        if statement.verb == "=" and "b" in order[:-1]:
            after = order[order.index("b") + 1]
            if after in ("a", "c") and not any("D" in heads(self.side(x, statement, domain)) for x in statement.sides):
                for text, more in WAYS:
                    yield {after: tree(text)}, replace(domain, also=domain.also + more)

    def side(self, formula: Tree, statement: Statement, domain: Domain) -> Tree:
        """A side of a statement with what its names stand for."""
        values = {name: self.expand(value, domain) for name, value in statement.values}
        return put(self.expand(formula, domain), values)

    def show(self, statement: Statement, domain: Domain, values: dict[str, Tree]) -> None:
        """Raises `UnknownError` unless a statement is shown in a domain, with other trees for some symbols."""
        sides = [put(self.side(formula, statement, domain), values) for formula in statement.sides]
        if statement.verb == "grows":
            self.grows(statement, sides, domain)
        elif statement.verb == "integral":
            self.integral(statement, sides[0], domain)
        elif len(sides) == 1:
            self.alone(statement.verb, sides[0], domain)
        else:
            self.compare(statement.verb, sides, domain)

    def field(self, domain: Domain) -> Field:
        """The field of a domain."""
        return self.problem.field(domain)

    def compare(self, verb: str, sides: list[Tree], domain: Domain) -> None:
        """Raises `UnknownError` unless two sides are shown to compare; with a limit, on the border."""
        home = next((side[2] for side in sides if isinstance(side, tuple) and side[0] in ("lim", "at")), "")
        one, other = (self.value(side, domain, domain.without(home)) for side in sides)
        if verb == "=":
            self.vanishes(one - other)
        elif one.field.sign(one - other) not in SIGNS[verb]:
            message = "the sign is not shown"
            raise UnknownError(message)

    def value(self, side: Tree, domain: Domain, face: Domain) -> Element:
        """The element of one side of a comparison."""
        match side:
            case ("lim", inner, name, point):
                return self.limit(inner, domain, name, point, 1)
            case ("at", inner, name, place):
                field, into = self.field(domain), self.field(face)
                return Substitution(field, into, {name: into.read(place)}).value(field.read(inner))
        return self.field(face).read(side)

    def vanishes(self, gap: Element) -> None:
        """Raises `UnknownError` unless the element is shown to be zero and is linear in the coefficients A_j."""
        index = gap.field.keys.get("A_j", -1)
        if index >= 0 and (gap.num.degrees()[index] > 1 or gap.den.degrees()[index]):
            message = "not linear in the coefficients of a polynomial"
            raise UnknownError(message)
        require(gap.field.zero(gap), "it is not shown to vanish")

    def alone(self, verb: str, formula: Tree, domain: Domain) -> None:
        """Raises `UnknownError` unless a formula is shown to be analytic, or a product of positive ones and squares."""
        field = self.field(domain)
        own = field.read(formula)
        if verb == "analytic":
            shown = field.analytic(own)
        else:
            unit, factors = own.num.factor()
            odd = [field.poly_sign(factor) or 0 for factor, times in factors if times % 2]
            shown = field.poly_sign(own.den) == 1 and (1 if unit > 0 else -1) * math.prod(odd) > 0
        require(shown, "it is not shown")

    def limit(self, formula: Tree, domain: Domain, name: str, point: Tree, way: int) -> Element:
        """The value of a formula as a length tends to its neighbour in the order, from above or from below."""
        face = self.field(domain.without(name))
        if "D" not in heads(formula):
            try:
                return face.read(put(formula, {name: point}))
            except UnknownError:
                pass
        field = self.field(domain)
        return Limit(field, name, point, face, way).value(field.read(formula))

    def grows(self, statement: Statement, sides: list[Tree], domain: Domain) -> None:
        """A formula is analytic, grows as is said, starts so where the contact begins, and does not jump at a break."""
        (whole, rate, start), name = sides, statement.name
        field = self.field(domain)
        own = field.read(whole)
        self.alone("analytic", whole, domain)
        self.vanishes(field.slope(own, name) - field.read(rate))
        i = domain.order.index(name)
        low = domain.order[i - 1] if i else 0
        value = self.limit(whole, domain, name, low, 1)
        if low in (*self.problem.breaks, *self.problem.chain) and low != self.problem.floor:
            order = (*domain.order[: i - 1], name, low, *domain.order[i + 1 :])
            swapped = replace(domain, order=order)
            other = self.side(statement.sides[0], statement, swapped)
            self.vanishes(value - self.limit(other, swapped, name, low, -1))
        else:
            self.vanishes(value - value.field.read(start))

    def integral(self, statement: Statement, whole: Tree, domain: Domain) -> None:
        """A formula is the sum of the increments of its antiderivatives, whose slopes add up to the integrand."""
        stored = self.problem.records[self.suffix]["primitives"]["@items"]
        found: Any = next((v for key, v in stored if tuple(ordered(tree(m["="])) for m in key) == domain.order), [])
        parts = [tuple(tree(one[end]["="]) for end in ("lo", "hi", "expr")) for one in found]
        ends = [0, *(m for m in domain.order[: domain.order.index("a")] if m in self.problem.breaks), "a"]
        require(all(lo in ends and hi in ends for lo, hi, _ in parts), "an antiderivative does not end at the breaks")
        total = self.field(domain).read(0)
        for lo, hi in itertools.pairwise(ends):
            i = domain.order.index(hi)
            inside = replace(domain, order=(*domain.order[:i], "x", *domain.order[i:]))
            field = self.field(inside)
            active = [expr for low, high, expr in parts if ends.index(low) <= ends.index(lo) < ends.index(high)]
            grown = field.read(0)
            for expr in active:
                self.alone("analytic", expr, inside)
                grown = grown + field.slope(field.read(expr), "x")
                # of one that spans several pieces, the increment over this one
                total = total + self.limit(expr, inside, "x", hi, -1) - self.limit(expr, inside, "x", lo, 1)
            self.vanishes(grown - field.read(put(self.side(statement.sides[1], statement, inside), {"A_j": 1})))
        field = self.field(domain)
        if "A_j" in symbols(whole):
            total = total * field.symbol("A_j")
        self.vanishes(field.read(whole) - total)


def mentioned(formula: Tree) -> set[str]:
    """All names in a formula of the table, of symbols and of what is written with letters."""
    return symbols(formula) | heads(formula)


def is_part(one: Chain, order: Chain) -> bool:
    """Whether lengths stand in an order one after the other."""
    rest = iter(order)
    return all(member in rest for member in one)


def is_ordered(members: Chain, domain: Domain) -> bool:
    """Whether the members of a case are in order in a domain."""
    return all(itertools.starmap(domain.below, itertools.pairwise(members)))
