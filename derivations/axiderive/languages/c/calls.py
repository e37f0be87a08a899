"""Calls: of functions of C by themselves, of those written where they are called, and of what both languages have."""

from __future__ import annotations

import ast
import contextlib
import math
import operator
from abc import abstractmethod
from collections.abc import Mapping, Sequence
from functools import reduce

from ..reach import PLAIN, Module
from .expressions import Expressions
from .natives import FULL, LIKE, NATIVES, NODES, PRODUCTS, TRUTHS
from .values import (
    Closure,
    Counted,
    Each,
    Kind,
    Native,
    Number,
    Over,
    Partial,
    Record,
    Rule,
    Scope,
    SeveralValuesError,
    Value,
    bracketed,
    fields_of,
    is_number,
    kind_of,
    leaves,
    literal,
    missing,
    names_of,
    number_of,
    variables_of,
)

INLINE = 60
"""Functions within functions, at most."""


class Calls(Expressions):
    """Writes calls."""

    @abstractmethod
    def block(self, body: Sequence[ast.stmt], scope: Scope) -> None:
        """Statements, one after another."""

    def call(self, function: Value, given: list[Value], named: dict[str, Value], scope: Scope | None = None) -> Value:
        """What a function gives."""
        match function:
            case Closure():
                return self._closure(function, given, named)
            case Kind(node, module):
                fields = fields_of(node)
                defaults = {name: self.expr(value, Scope(module)) for name, value in fields.items() if value}
                return Record(defaults | dict(zip(fields, given, strict=False)) | named)
            case Partial(inner, held):
                return self.call(inner, given, {**held, **named}, scope)
            case Rule(lengths):
                return self._rule(lengths, given[0])
            case Native():
                return self._natively(function, given, named, scope or Scope(Module("", "")))
        raise missing(scope, f"a call of {function!r}")

    def _closure(self, closure: Closure, given: Sequence[Value], named: Mapping[str, Value]) -> Value:
        bound = self._bound(closure, given, named)
        parts = [leaf for value in bound.values() for leaf in leaves(value)]
        numbers = all(is_number(leaf) or isinstance(leaf, str) or leaf is None for leaf in parts)
        if closure.scope is None and numbers and any(isinstance(leaf, Number) for leaf in parts):
            try:
                name, left = self.file.function(closure, list(bound.values()))
            except SeveralValuesError:
                pass
            else:
                text = ", ".join(own.text for own in left)
                return Number(f"{name}({text})", "double", 9, variables_of(left) | {name})
        return self._inlined(closure, bound)

    def _inlined(self, closure: Closure, bound: dict[str, Value]) -> Value:
        if self.inlined >= INLINE:
            raise missing(Scope(closure.module), "functions within functions without an end")
        self.inlined += 1
        scope = Scope(closure.module, closure.scope, end=self._label("end"))
        if isinstance(closure.node, ast.Lambda):
            scope.names = bound
            value = self.expr(closure.node.body, scope)
        else:
            for name, own in bound.items():
                scope.names[name] = self._kept(name, own, None, scope)
            with contextlib.suppress(Over):
                self.block(closure.node.body, scope)
            self._place(scope.end)
            value = scope.result
        self.inlined -= 1
        return value

    def _bound(self, closure: Closure, given: Sequence[Value], named: Mapping[str, Value]) -> dict[str, Value]:
        arguments = closure.node.args
        plain = [own.arg for own in (*arguments.posonlyargs, *arguments.args)]
        outer = closure.scope or Scope(closure.module)
        values = dict(zip(plain, given, strict=False))
        if arguments.vararg:
            values[arguments.vararg.arg] = tuple(given[len(plain) :])
        values |= named
        defaults = dict(zip(plain[len(plain) - len(arguments.defaults) :], arguments.defaults, strict=True))
        defaults |= {
            own.arg: value
            for own, value in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True) if value is not None
        }  # fmt: skip
        order = names_of(arguments)
        return {name: values[name] if name in values else self.expr(defaults[name], outer) for name in order}

    def native(self, native: Native, given: Sequence[Value]) -> Value:
        """What a function of both languages gives; worked out here where all is known."""
        if native.known and not any(isinstance(one, Number) for one in given):
            try:
                return native.known(*given)
            except (OverflowError, ZeroDivisionError):
                pass
        numbers = [number_of(one) for one in given]
        text = ", ".join(own.text for own in numbers)
        return Number(f"{native.name}({text})", "double", 9, variables_of(numbers))

    def _natively(self, native: Native, given: list[Value], named: Mapping[str, Value], scope: Scope) -> Value:
        """A function of Python, NumPy or the rules that C has, or that is worked out here."""
        name, known = native.name, not any(isinstance(leaf, Number | Each) for leaf in leaves(given))
        if NATIVES.get(name) is native or native.known:
            return self.native(native, given)
        if name in LIKE:
            return given[0]
        if name in FULL:
            return FULL[name]
        if name in ("full_like", "full"):
            return given[1]
        if name in TRUTHS or name == "bool":
            return self.truth(name != "all", given[0]) if isinstance(given[0], tuple) else given[0]
        match name:
            case "hasattr":
                return False
            case "partial":
                return Partial(given[0], dict(named))
            case "getattr":
                return given[0].fields[given[1]]
            case "len":
                return len(self._items(given[0], scope))
            case "range":
                if known:
                    return range(*given)
                start, stop, step = (*given, 1)[:3] if len(given) > 1 else (0, given[0], 1)
                return Counted(start, stop, step)
            case "enumerate" if not isinstance(given[0], Number):
                return tuple(enumerate(self._items(given[0], scope), *(given[1:] or [0])))
            case "zip":
                return tuple(zip(*(self._items(one, scope) for one in given), strict=False))
            case "reversed":
                return tuple(reversed(self._items(given[0], scope)))
            case "tuple" | "list" if not isinstance(given[0], Each):
                return (list if name == "list" else tuple)(self._items(given[0], scope))
            case "reduce":
                return reduce(lambda a, b: self.call(given[0], [a, b], {}, scope), self._items(given[1], scope))
            case "logical_not":
                return self._unary(ast.Not(), given[0], scope)
            case "isfinite" | "isnan":
                return getattr(math, name)(given[0]) if known else self._test(name, given[0])
            case "where":
                return self._where(*given)
            case "prod":
                return reduce(operator.mul, self._items(given[0], scope), 1)
            case "fsum" | "sum":
                return self._sum(name, given, scope)
            case "max" | "min" if len(given) > 1 or known:
                if known:
                    return (max if name == "max" else min)(*given)
                order = Native("higher" if name == "max" else "lower")
                return reduce(lambda a, b: self._of_kind(order, a, b), given)
            case "max":
                return given[0]
            case "float" | "int":
                if known:
                    return (float if name == "float" else int)(given[0])
                own = number_of(given[0])
                return own if name == "float" else Number(f"(int){bracketed(own, 9)}", "int", 8, own.names)
            case "ldexp":
                if known:
                    return math.ldexp(*given)
                x, power = number_of(given[0]), number_of(given[1], "int")
                return Number(f"ldexp({x.text}, {power.text})", "double", 9, x.names | power.names)
            case "frexp":
                return self._frexp(given[0])
            case "floor" | "ceil":
                return getattr(math, name)(given[0]) if known else self.native(Native(name), given)
            case "clip":
                return self.native(NATIVES["minimum"], [self.native(NATIVES["maximum"], given[:2]), given[2]])
            case "rule":
                return Rule(given[0])
            case "both":
                return self._both(
                    {**dict(zip(("integrand", "stop", "width", "lengths"), given, strict=False)), **named}, scope
                )
            case "_pairs":
                return self._pairs(*given)
            case "products":
                return self._products(given[0], given[1], named["beyond"])
        raise missing(scope, name)

    def _of_kind(self, order: Native, a: Value, b: Value) -> Number:
        if {kind_of(a), kind_of(b)} == {"int"}:
            x, y = number_of(a, "int"), number_of(b, "int")
            sign = ">" if order.name == "higher" else "<"
            first, second = bracketed(x, 5), bracketed(y, 5)
            return Number(f"{first} {sign} {second} ? {first} : {second}", "int", 0, x.names | y.names)
        made: Number = self.native(order, [a, b])
        return made

    @staticmethod
    def _test(name: str, value: Value) -> Number:
        own = number_of(value)
        return Number(f"({name}({own.text}) != 0)", "int", 9, own.names)

    def _where(self, test: Value, first: Value, second: Value) -> Value:
        if not isinstance(test, Number):
            return first if test else second
        a, b = number_of(first), number_of(second)
        return Number(f"{bracketed(test, 1)} ? {bracketed(a, 1)} : {bracketed(b, 1)}", "double", 0,
                      test.names | a.names | b.names)  # fmt: skip

    def _frexp(self, value: Value) -> Value:
        if not isinstance(value, Number):
            return math.frexp(value)
        x = number_of(value)
        share, power = self.variable("share", "double"), self.variable("power", "int")
        self.set(share, Number(f"share_of({x.text})", "double", 9, x.names))
        self.set(power, Number(f"power_of({x.text})", "int", 9, x.names))
        return share, power

    def _sum(self, name: str, given: Sequence[Value], scope: Scope) -> Value:
        terms = given[0]
        if isinstance(terms, Number) and terms.kind == "sum":
            return Number(f"sum_of(&{terms.text})", "double", 9, terms.names)
        if isinstance(terms, Each):
            total = self.variable("total", "sum")
            self.emit(f"{total.text}.high = {total.text}.low = 0.0;", None, total.names)
            inner = Scope(terms.scope.module, terms.scope)
            node, weight = self._start_rule(terms.pairs)
            self._name(terms.loop.target, (node, weight), inner)
            self.depth += 1
            inner.divided += 1
            self.add_to(total, self.expr(terms.element, inner))
            self.depth -= 1
            self.emit("}")
            return Number(f"sum_of(&{total.text})", "double", 9, total.names)
        items = self._items(terms, scope)
        if name == "sum":
            start = given[1] if len(given) > 1 else 0
            return reduce(lambda a, b: self._arithmetic(ast.Add(), a, b, scope), items, start)
        if not any(isinstance(one, Number) for one in items):
            return math.fsum(items)
        total = self.variable("total", "sum")
        self.emit(f"{total.text}.high = {total.text}.low = 0.0;", None, total.names)
        for item in items:
            self.add_to(total, item)
        return Number(f"sum_of(&{total.text})", "double", 9, total.names)

    def _start_rule(self, pairs: Number) -> tuple[Number, Number]:
        """The head of a loop over the nodes of a rule, and the variables of node and weight."""
        place = self.variable("place", "int")
        node, weight = self.variable("node", "double"), self.variable("weight", "double")
        count = f"{pairs.text}.count * {pairs.text}.panels"
        head = f"for ({place.text} = 0; {place.text} < {count}; {place.text}++) {{"
        self.emit(head, None, place.names | pairs.names)
        self.depth += 1
        given = f"&{pairs.text}, {place.text}, &{weight.text}"
        needs = place.names | pairs.names | weight.names | node.names
        self.emit(f"{node.text} = node_of({given});", None, needs)
        self.depth -= 1
        return node, weight

    def _pairs(self, count: Value, panels: Value) -> Number:
        own = self.variable("nodes", "pairs")
        self._set_pairs(own, count, panels)
        return own

    def _set_pairs(self, own: Number, count: int, panels: Value) -> None:
        number = number_of(panels, "int")
        table = NODES.format(count)
        text = f"{own.text} = pairs_of({table}, {count}, {number.text});"
        self.emit(text, None, own.names | number.names | {table, "pairs_of"})

    def _both(self, given: Mapping[str, Value], scope: Scope) -> Value:
        """The integrals of both members of a pair, from the same nodes."""
        stop = self.variable("stop", "double")
        self.set(stop, given["stop"])
        lengths = given["lengths"] if "lengths" in given else self.named(Scope(self._plain()), "STRIPS")
        nodes = self._rule(lengths, self._arithmetic(ast.Div(), stop, given.get("width", 1.0), scope))
        totals = [self.variable("total", "sum") for _ in range(2)]
        for total in totals:
            self.emit(f"{total.text}.high = {total.text}.low = 0.0;", None, total.names)
        node, weight = self._start_rule(nodes)
        self.depth += 1
        scope.divided += 1
        place = self._arithmetic(ast.Mult(), node, stop, scope)
        for total, own in zip(totals, self.call(given["integrand"], [place], {}, scope), strict=True):
            self.add_to(total, self._arithmetic(ast.Mult(), weight, own, scope))
        scope.divided -= 1
        self.depth -= 1
        self.emit("}")
        return tuple(
            Number(f"sum_of(&{total.text}) * {stop.text}", "double", 6, total.names | stop.names) for total in totals
        )

    def _plain(self) -> Module:
        """The module of rules over plain numbers."""
        module = self.file.package.module(PLAIN)
        assert module is not None
        return module

    def _products(self, power: Value, count: Value, beyond: bool) -> Number:
        """The nodes of a rule for what has a power as a weight; how many there are the program may find."""
        own, weights = self.variable("nodes", "pairs"), self.variable("weights", "weights")
        sizes = PRODUCTS if isinstance(count, Number) else (int(count),)
        size, x = number_of(count, "int"), number_of(power)
        *others, table = (NODES.format(one) for one in sizes)
        for one, name in zip(sizes, others, strict=False):
            table = f"{bracketed(size, 5)} == {one} ? {name} : {table}"
        self.emit(f"{own.text} = products_of({table}, {size.text}, {x.text}, {int(beyond)}, &{weights.text});", None,
                  own.names | size.names | x.names | weights.names | {NODES.format(one) for one in sizes})  # fmt: skip
        return own

    def _rule(self, lengths: Sequence[tuple[float, int]], length: Value) -> Number:
        own = self.variable("nodes", "pairs")
        x = self.variable("length", "double")
        self.set(x, length)
        for place, (longest, count) in enumerate(lengths):
            test = f"if ({x.text} <= {literal(longest)})"
            self.emit(f"{'} else ' if place else ''}{test} {{", None, x.names)
            self.depth += 1
            self._set_pairs(own, count, 1)
            self.depth -= 1
        longest, count = lengths[-1]
        self.emit("} else {")
        self.depth += 1
        panels = Number(f"panels_of({x.text} / {literal(longest)})", "int", 9, x.names)
        self._set_pairs(own, count, panels)
        self.depth -= 1
        self.emit("}")
        return own
