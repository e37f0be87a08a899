"""Expressions of Python: worked out where all is known, else written in C."""

from __future__ import annotations

import ast
import math
import operator
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from ..public import FORMULAS, PROGRAMS
from ..reach import PLAIN, PRODUCTS
from ..searches import OWN
from .lines import Lines
from .natives import CONSTANTS, NATIVES
from .values import (
    Closure,
    Each,
    Growing,
    Native,
    Number,
    Record,
    Scope,
    Value,
    Whole,
    bracketed,
    is_number,
    joint,
    kind_of,
    mapped,
    missing,
    number_of,
    same_shape,
    variables_of,
)

ARITHMETIC: dict[type, tuple[str, int, Callable[[Any, Any], Any]]] = {
    ast.Add: ("+", 5, operator.add), ast.Sub: ("-", 5, operator.sub),
    ast.Mult: ("*", 6, operator.mul), ast.Div: ("/", 6, operator.truediv),
    ast.Mod: ("%", 6, operator.mod), ast.BitAnd: ("&", 2, operator.and_), ast.BitOr: ("|", 1, operator.or_),
}  # fmt: skip
COMPARED: dict[type, tuple[str, Callable[[Any, Any], Any]]] = {
    ast.Lt: ("<", operator.lt), ast.LtE: ("<=", operator.le), ast.Gt: (">", operator.gt), ast.GtE: (">=", operator.ge),
    ast.Eq: ("==", operator.eq), ast.NotEq: ("!=", operator.ne),
}  # fmt: skip


UNARY: dict[type, Callable[[Any], Any]] = {ast.USub: operator.neg, ast.UAdd: operator.pos, ast.Not: operator.not_}


class Expressions(Lines):
    """Writes expressions."""

    @abstractmethod
    def call(self, function: Value, given: list[Value], named: dict[str, Value], scope: Scope | None = None) -> Value:
        """What a function gives."""

    @abstractmethod
    def native(self, native: Native, given: Sequence[Value]) -> Value:
        """What a function gives that both languages have."""

    def expr(self, node: ast.expr, scope: Scope) -> Value:
        """The value of an expression: known, or a number of C."""
        match node:
            case ast.Constant(value):
                return value
            case ast.Name(name):
                return self.named(scope, name)
            case ast.Attribute(value, attribute):
                return self._attribute(self.expr(value, scope), attribute, scope)
            case ast.BinOp(left, kind, right):
                return self._arithmetic(kind, self.expr(left, scope), self.expr(right, scope), scope)
            case ast.UnaryOp(kind, operand):
                return self._unary(kind, self.expr(operand, scope), scope)
            case ast.BoolOp(kind, values):
                return self.truth(isinstance(kind, ast.Or), (self.expr(one, scope) for one in values))
            case ast.Compare(ast.Call(ast.Name("type")), [ast.Is()], _):
                return True
            case ast.Compare(left, kinds, others):
                return self._compare(kinds, [self.expr(one, scope) for one in (left, *others)], scope)
            case ast.IfExp(test, body, orelse):
                return self._choice(self.expr(test, scope), body, orelse, scope)
            case ast.Tuple(values):
                return tuple(self._spread(values, scope))
            case ast.List(values):
                return list(self._spread(values, scope))
            case ast.Dict(keys, values):
                return {self.expr(k, scope): self.expr(v, scope) for k, v in zip(keys, values, strict=True) if k}
            case ast.Lambda():
                return Closure(node, scope.module, scope)
            case ast.ListComp(element, [loop]) | ast.GeneratorExp(element, [loop]):
                return self._each(element, loop, scope)
            case ast.Subscript(value, place):
                return self._item(self.expr(value, scope), place, scope)
            case ast.Call(ast.Name("isinstance"), [value, _]):
                # what is known is a number of Python
                return not isinstance(self.expr(value, scope), Number)
            case ast.Call(function, given, keywords):
                named = {own.arg: self.expr(own.value, scope) for own in keywords if own.arg}
                return self.call(self.expr(function, scope), list(self._spread(given, scope)), named, scope)
        raise missing(scope, ast.unparse(node))

    def _spread(self, values: Sequence[ast.expr], scope: Scope) -> Iterator[Value]:
        for value in values:
            if isinstance(value, ast.Starred):
                yield from self._items(self.expr(value.value, scope), scope)
            else:
                yield self.expr(value, scope)

    def _items(self, value: Value, scope: Scope) -> Sequence[Value]:
        if isinstance(value, Record):
            return list(value.fields.values())
        if isinstance(value, tuple | list | range):
            return value
        raise missing(scope, f"the parts of {value!r}")

    def named(self, scope: Scope, name: str) -> Value:
        """What a name stands for, inside or outside of the function."""
        around: Scope | None = scope
        while around is not None:
            if name in around.names:
                return around.names[name]
            around = around.around
        package = self.file.package
        if name.startswith((PROGRAMS, FORMULAS)):
            return Whole(name)
        found = package.resolved(scope.module.name, name)
        if found is None:
            return NATIVES["abs"] if name == "abs" else Native(name)
        home, own = found
        if home == "functools":
            return Native(own)
        if own == "" or (home, own) == (PLAIN, "MATH"):
            return Whole("numpy" if (home, own) == (PLAIN, "MATH") else home)
        if home in ("math", "numpy"):
            return self._of_numpy(own, scope)
        if home == PLAIN and own in ("rule", "_pairs", "both", "gauss_legendre", "sqrt", "log", "log1p"):
            return NATIVES.get(own) or Native(own)
        if (home, own) == PRODUCTS:
            return Native("products")
        if (home, own) in OWN:
            return NATIVES.get(own) or Native(OWN[home, own])
        there = package.module(home)
        if there is None:
            raise missing(scope, name)
        return self.file.constant(there, own)

    def _of_numpy(self, name: str, scope: Scope) -> Value:
        if name in CONSTANTS:
            return CONSTANTS[name]
        return NATIVES.get(name) or Native(name)

    def _attribute(self, value: Value, attribute: str, scope: Scope) -> Value:
        if isinstance(value, Record):
            return value.fields[attribute]
        if not isinstance(value, Whole):
            return Native(f".{attribute}")
        if value.name in ("numpy", "math"):
            return self._of_numpy(attribute, scope)
        if value.name.startswith((PROGRAMS, FORMULAS)):
            own, node = self.file.package.formula(value.name, attribute)
            return Closure(node, own)
        home = self.file.package.module(value.name)
        if home is None:
            raise missing(scope, attribute)
        found = self.file.package.resolved(home.name, attribute)
        there = self.file.package.module(found[0]) if found else None
        if not found or there is None:
            raise missing(scope, attribute)
        return self.file.constant(there, found[1])

    def _arithmetic(self, kind: ast.operator, left: Value, right: Value, scope: Scope) -> Value:
        if isinstance(kind, ast.Pow):
            if not isinstance(left, Number) and not isinstance(right, Number):
                return left**right
            return self.native(NATIVES["pow"], [left, right])
        if isinstance(kind, ast.FloorDiv) and not isinstance(left, Number) and not isinstance(right, Number):
            return left // right
        if type(kind) not in ARITHMETIC:
            raise missing(scope, f"the operator {type(kind).__name__}")
        sign, rank, known = ARITHMETIC[type(kind)]
        if isinstance(left, tuple | list) and isinstance(right, tuple | list):
            return type(left)([*left, *right])
        if not isinstance(left, Number) and not isinstance(right, Number):
            if isinstance(left, bool | int | float) and isinstance(right, int | float) and sign == "/" and right == 0:
                return math.nan if left == 0 or left != left else math.copysign(math.inf, left)
            return known(left, right)
        if sign in "&|":
            return self.truth(sign == "|", (left, right))
        whole = {kind_of(left), kind_of(right)} == {"int"} and sign != "/"
        if sign == "%" and not whole:
            raise missing(scope, "% of numbers that are not whole")
        inner = "int" if whole else "double"
        a, b = number_of(left, inner), number_of(right, inner)
        first = a.text if a.rank >= rank else f"({a.text})"
        second = b.text if b.rank > rank and not b.text.startswith("-") else f"({b.text})"
        return Number(f"{first} {sign} {second}", inner, rank, a.names | b.names)

    def _unary(self, kind: ast.unaryop, value: Value, scope: Scope) -> Value:
        if not isinstance(value, Number):
            return UNARY[type(kind)](value)
        if isinstance(kind, ast.Not):
            return Number(f"!{bracketed(value, 9)}", "int", 8, value.names)
        return Number(f"-{bracketed(value, 9)}", value.kind, 7, value.names) if isinstance(kind, ast.USub) else value

    def truth(self, either: bool, values: Iterable[Value]) -> Value:
        """Whether either of several holds, or all of them; what is decided already is not asked for."""
        made: list[Number] = []
        value: Value = not either
        for value in values:
            if isinstance(value, Number):
                made.append(value)
            elif bool(value) is either:
                # the rest is not asked for
                if not made or either is False:
                    return value if not made else 0
                return 1
        if not made:
            return value
        sign, rank = ("||", 1) if either else ("&&", 2)
        text = f" {sign} ".join(bracketed(one, 3) for one in made)
        return Number(text, "int", rank if len(made) > 1 else made[0].rank, variables_of(made))

    def _compare(self, kinds: Sequence[ast.cmpop], values: Sequence[Value], scope: Scope) -> Value:
        made: list[Number] = []
        for left, kind, right in zip(values[:-1], kinds, values[1:], strict=True):
            if isinstance(kind, ast.Is | ast.IsNot):
                same = left is right if not isinstance(left, Number) else False
                value: Value = same is isinstance(kind, ast.Is)
            elif isinstance(left, Number) or isinstance(right, Number):
                sign, _ = COMPARED[type(kind)]
                inner = "int" if {kind_of(left), kind_of(right)} == {"int"} else "double"
                a, b = number_of(left, inner), number_of(right, inner)
                value = Number(f"{bracketed(a, 5)} {sign} {bracketed(b, 5)}", "int", 3, a.names | b.names)
            else:
                value = COMPARED[type(kind)][1](left, right)
            if isinstance(value, Number):
                made.append(value)
            elif not value:
                return False
        if not made:
            return True
        return (
            made[0] if len(made) == 1 else Number(" && ".join(one.text for one in made), "int", 2, variables_of(made))
        )

    def _choice(self, test: Value, body: ast.expr, orelse: ast.expr, scope: Scope) -> Value:
        if not isinstance(test, Number):
            return self.expr(body if test else orelse, scope)
        outer, self.lines = self.lines, []
        self.depth += 1
        scope.divided += 1
        first = self.expr(body, scope)
        firsts, self.lines = self.lines, []
        second = self.expr(orelse, scope)
        seconds, self.lines = self.lines, outer
        scope.divided -= 1
        self.depth -= 1
        if not same_shape(first, second):
            raise missing(scope, f"{ast.unparse(body)} or {ast.unparse(orelse)}")
        if not firsts and not seconds and is_number(first):
            inner = "int" if {kind_of(first), kind_of(second)} == {"int"} else "double"
            a, b = number_of(first, inner), number_of(second, inner)
            text = f"{bracketed(test, 1)} ? {bracketed(a, 1)} : {bracketed(b, 1)}"
            return Number(text, inner, 0, test.names | a.names | b.names)
        own = mapped(first, lambda one, other: self.variable("chosen", joint(one, other)), second)
        self.emit(f"if ({test.text}) {{", None, test.names)
        for place, (lines, value) in enumerate(((firsts, first), (seconds, second))):
            if place:
                self.emit("} else {")
            self.lines += lines
            self.depth += 1
            mapped(own, self.set, value)
            self.depth -= 1
        self.emit("}")
        return own

    def _each(self, element: ast.expr, loop: ast.comprehension, scope: Scope) -> Value:
        iterated = self.expr(loop.iter, scope)
        if isinstance(iterated, Number) and iterated.kind == "pairs":
            return Each(element, loop, iterated, scope)
        made = []
        for item in self._items(iterated, scope):
            inner = Scope(scope.module, scope, divided=scope.divided)
            self._name(loop.target, item, inner)
            if all(self._holds(test, inner) for test in loop.ifs):
                made.append(self.expr(element, inner))
        return tuple(made)

    def _holds(self, test: ast.expr, scope: Scope) -> bool:
        # a term that is left out where it is nothing may as well be added
        value = self.expr(test, scope)
        return isinstance(value, Number) or bool(value)

    def _name(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """Names for what is there already, without variables."""
        if isinstance(target, ast.Name):
            scope.names[target.id] = value
            return
        assert isinstance(target, ast.Tuple | ast.List)
        for one, own in zip(target.elts, self._items(value, scope), strict=True):
            self._name(one, own, scope)

    def _item(self, value: Value, place: ast.expr, scope: Scope) -> Value:
        if isinstance(value, Growing) and ast.unparse(place) in ("-1", "-2:"):
            value = (value.before, value.last)
        if isinstance(place, ast.Slice):
            ends = [None if one is None else self.expr(one, scope) for one in (place.lower, place.upper, place.step)]
            return self._items(value, scope)[slice(*ends)]
        index = self.expr(place, scope)
        if isinstance(index, Number) or not isinstance(value, tuple | list | range | dict):
            raise missing(scope, f"part {ast.unparse(place)} of something")
        return value[index]
