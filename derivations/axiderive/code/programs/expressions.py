"""A formula over any array library, from its graph: for gradients and compilers, which follow no branch.

A gradient through `where(r < a, f(r), 0)` is NaN outside the contact wherever that of f is, because both
branches are evaluated.  Here the arguments are moved into the branch before it is evaluated.
"""

from __future__ import annotations

import ast
import math
import re
from collections import Counter
from collections.abc import Callable, Sequence
from typing import NamedTuple

from .graph import Node
from .plain import OPERATORS

EXPRESSIONS, STEPS = "_programs.expressions", "_runtime.steps"
"""The folder of what is written here, and the module of rules and roots over any library."""
WIDEST = 100
"""What is used once stands where it is used, up to that width of a line."""
PANELS = 4
"""Panels of a rule for waves."""
ASIDE = {"less": (0.5, 2.0), "less_equal": (0.5, 2.0), "greater": (2.0, 0.5), "greater_equal": (2.0, 0.5)}
"""x over y where the relation holds, and where it does not."""
ROOT = "root"
"""An argument that says how far a radius is beyond a break, and is zero below: it is moved with the radius."""
SIGNS = {name: sign for name, sign in OPERATORS.items() if sign not in ("and", "or")} | {
    "bitwise_and": "&", "bitwise_or": "|", "power": "**",
}  # fmt: skip
PREFIXES = {"negative": "-", "invert": "~"}
NAME = re.compile(r"\bv\d+\b")


def expression(
    name: str, arguments: Sequence[str], arrays: Sequence[str], result: Node, called: Callable[[str, str], str]
) -> str:
    """The text of a function of the library `xp` and of the arguments.

    `called` is the name of a function of a module of the package; an argument that is none of the `arrays` holds
    coefficients.
    """
    axes = ", ".join(arrays)
    writer = _Writer(called, axes, result)
    writer.line(f"return {_Branch(writer, {}, axes).value(result)}")
    return ast.unparse(ast.parse("\n".join([f"def {name}(xp, {', '.join(arguments)}):", *writer.text()])))


class _Line(NamedTuple):
    """A line with the functions around it, and the one name it gives, if any."""

    around: tuple[str, ...]
    name: str
    text: str


class _Writer:
    """The lines of one function; names are counted."""

    def __init__(self, called: Callable[[str, str], str], axes: str, result: Node) -> None:
        self.called, self.result, self._early = called, result, {axes}
        self.first: list[_Line] = []
        self.lines: list[_Line] = []
        self.around: tuple[str, ...] = ()
        self._count = 0
        self._rules: dict[str, tuple[tuple[str, ...], tuple[str, str]]] = {}
        self._behind: dict[Node, frozenset[Node]] = {}

    def name(self, value: str) -> str:
        """The name of a value on a line of its own."""
        name = self.new()
        self.lines.append(_Line(self.around, name, value))
        return name

    def new(self) -> str:
        """A name for a value."""
        self._count += 1
        return f"v{self._count}"

    def line(self, text: str) -> None:
        """A line that names nothing."""
        self.lines.append(_Line(self.around, "", text))

    def function(self, given: Sequence[str], values: Callable[[], str]) -> str:
        """The name of an inner function."""
        name = f"f{len(self.lines)}"
        self.line(f"def {name}({', '.join(given)}):")
        self.around = (*self.around, name)
        self.line(f"return {values()}")
        self.around = self.around[:-1]
        return name

    def rule(self, value: str, early: str = "") -> tuple[str, str]:
        """The names of nodes and weights that a call gives; those that begin with what is known `early` come first."""
        around, names = self._rules.get(value, ((), ("", "")))
        if names[0] and self.around[: len(around)] == around:
            return names
        names = self.new(), self.new()
        first = early in self._early
        self._rules[value] = (() if first else self.around), names
        (self.first if first else self.lines).append(_Line(self._rules[value][0], "", f"{', '.join(names)} = {value}"))
        if first:
            self._early.add(names[0])
        return names

    def behind(self, node: Node) -> frozenset[Node]:
        """A node and all it is made of."""
        if node not in self._behind:
            self._behind[node] = frozenset((node,)).union(*(self.behind(x) for x in node.operands))
        return self._behind[node]

    def text(self) -> list[str]:
        """The lines, where what is used once stands where it is used."""
        lines = self.first + self.lines
        uses = Counter(name for line in lines for name in NAME.findall(line.text))
        homes = {name: line.around for line in lines for name in NAME.findall(line.text)}
        held = dict[str, str]()
        text: list[str] = []
        for line in lines:
            indent = "    " * (1 + len(line.around))
            own = line.text
            # the shortest first, as many as there is room for
            for name in sorted((x for x in NAME.findall(own) if x in held), key=lambda x: len(held[x])):
                value = held.pop(name)
                if len(own) + len(value) <= WIDEST:
                    own = re.sub(rf"\b{name}\b", f"({value})", own)
                else:
                    text.append(f"{indent}{name} = {value}")
            if line.name and uses[line.name] == 1 and homes[line.name] == line.around:
                held[line.name] = own
            else:
                text.append(f"{indent}{line.name} = {own}" if line.name else indent + own)
        return text


class _Branch:
    """Values of nodes where some are known by a name; a branch of a `where` has values of its own for one of them.

    `axes` are the names of arrays whose axes a rule precedes: those of the arguments, or nodes around it.
    """

    def __init__(self, writer: _Writer, known: dict[Node, str], axes: str) -> None:
        self.writer, self._known, self._axes = writer, known, axes

    def where(self, node: Node, name: str, axes: str = "") -> _Branch:
        """The same where a node has another value, and all that is made of it too."""
        known = {own: text for own, text in self._known.items() if node not in self.writer.behind(own)}
        return _Branch(self.writer, known | {node: name}, axes or self._axes)

    def value(self, node: Node) -> str:
        """The name of a value."""
        if node not in self._known:
            self._known[node] = self._written(node)
        return self._known[node]

    def _written(self, node: Node) -> str:
        if node.name == "number":
            return _number(float(node.value))
        if node.name in ("argument", "variable"):
            return str(node.value)
        if node.name in WRITTEN:
            return WRITTEN[node.name](self, node)
        values = [self.value(x) for x in node.operands]
        if node.name in CALLS:
            return self.writer.name(f"{self.writer.called(*node.value)}({', '.join([*CALLS[node.name], *values])})")
        if node.name in SIGNS:
            return self.writer.name(f" {SIGNS[node.name]} ".join(values))
        if node.name in PREFIXES:
            return self.writer.name(f"{PREFIXES[node.name]}{values[0]}")
        return self.writer.name(f"xp.{node.name}({', '.join(values)})")

    def _where(self, node: Node) -> str:
        condition = self.value(node.operands[0])
        branches = (self._moved(node.operands[0], condition, holds) for holds in (True, False))
        values = [branch.value(x) for branch, x in zip(branches, node.operands[1:], strict=True)]
        return self.writer.name(f"xp.where({condition}, {', '.join(values)})")

    def _moved(self, relation: Node, condition: str, holds: bool) -> _Branch:
        """The branch, with what is compared with another value moved to where the branch applies."""
        if relation.name not in ASIDE or relation.operands[0].name == "number":
            return self
        x, y = map(self.value, relation.operands)
        factor = ASIDE[relation.name][0 if holds else 1]
        aside = f"{factor!r} * {y}"
        if relation.operands[1].value == 0.0:
            if factor < 1.0:
                return self
            aside = "1.0"
        chosen = f"{x}, {aside}" if holds else f"{aside}, {x}"
        inner = self.where(relation.operands[0], self.writer.name(f"xp.where({condition}, {chosen})"))
        if relation.name != "less" or holds or aside == "1.0":
            return inner
        for root in [own for own in self.writer.behind(self.writer.result) if own.value == ROOT]:
            inner = inner.where(root, self.writer.name(f"xp.where({condition}, {y}, {self.value(root)})"))
        return inner

    def _integral(self, node: Node) -> str:
        """The sum over the nodes, along a first axis."""
        stop, _, variable, summand = node.operands
        rule = f"{self.writer.called(STEPS, 'nodes_along')}(xp, {1 if node.value else PANELS}, {self._axes})"
        length, (nodes, weights) = self.value(stop), self.writer.rule(rule, self._axes)
        inner = self.where(variable, self.writer.name(f"{nodes} * {length}"), nodes)
        return self.writer.name(f"{length} * xp.sum({weights} * {inner.value(summand)}, axis=0)")

    def _weighted(self, node: Node) -> str:
        """The same with the weights of a power."""
        stop, above, variable, summand = node.operands
        rule = f"{self.writer.called(STEPS, 'weighted_along')}(xp, {self.value(above)}, {self._axes})"
        length, (nodes, weights) = self.value(stop), self.writer.rule(rule)
        inner = self.where(variable, self.writer.name(f"{nodes} * {length}"), nodes)
        return self.writer.name(f"xp.sum({weights} * {inner.value(summand)}, axis=0)")

    def _root(self, node: Node) -> str:
        """A call that searches for the root of an inner function."""
        *given, variable, curve, rate = node.operands
        values, t = ", ".join(map(self.value, given)), self.writer.new()
        inner = self.where(variable, t)
        found = self.writer.function([t], lambda: f"{inner.value(curve)}, {inner.value(rate)}")
        return self.writer.name(f"{self.writer.called(STEPS, 'newton')}(xp, {found}, {values})")

    def _stable(self, node: Node) -> str:
        """A call that searches for the last rising branch with a value, and for the radius on it."""
        value, radii, variable, load, slope = node.operands
        values, a = f"{self.value(value)}, {self.value(radii)}", self.writer.new()
        inner = self.where(variable, a, f"{a}, {self._axes}")
        found = self.writer.function([a], lambda: f"{inner.value(load)}, {inner.value(slope)}")
        return self.writer.name(f"{self.writer.called(STEPS, 'stable')}(xp, {found}, {values})")

    def _radii(self, node: Node) -> str:
        return self.writer.name(f"{self.writer.called(STEPS, 'radii_along')}(xp, {node.value!r}, {self._axes})")

    def _terms(self, node: Node) -> str:
        """The sum of what an inner function gives for each coefficient, or the least of that."""
        coefficients, *variables, term = node.operands
        given = [str(own.value) for own in variables]
        inner = self.where(variables[0], given[0]).where(variables[1], given[1])
        found = self.writer.function(given, lambda: inner.value(term))
        terms = f"[{found}({', '.join(given)}) for {', '.join(given)} in {self._numbered(coefficients)}]"
        total = node.name == "total"
        return self.writer.name(f"sum({terms})" if total else f"{self.writer.called(STEPS, 'least')}(xp, {terms})")

    def _numbered(self, coefficients: Node) -> str:
        return f"{self.writer.called(STEPS, 'numbered')}({coefficients.value})"

    def _count(self, node: Node) -> str:
        return self.writer.name(f"len({self._numbered(node.operands[0])})")


CALLS = {"call": ("xp",), "plain": ()}
"""What a call gives a function before its arguments: one of plain numbers takes no library."""
WRITTEN = {
    "where": _Branch._where, "integral": _Branch._integral, "weighted": _Branch._weighted, "root": _Branch._root,
    "stable": _Branch._stable, "radii": _Branch._radii, "total": _Branch._terms, "least": _Branch._terms,
    "count": _Branch._count,
}  # fmt: skip


def _number(value: float) -> str:
    if math.isfinite(value):
        return f"({value!r})" if value < 0.0 else repr(value)
    return "xp.nan" if math.isnan(value) else "xp.inf" if value > 0.0 else "(-xp.inf)"
