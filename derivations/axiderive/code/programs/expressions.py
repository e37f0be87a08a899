"""A formula over any array library, from its graph: for gradients and compilers, which follow no branch.

A gradient through `where(r < a, f(r), 0)` is NaN outside the contact wherever that of f is, because both
branches are evaluated.  Here the arguments are moved into the branch before it is evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from .graph import Node, needed
from .plain import OPERATORS, is_sum

LONGEST = 500
"""Lines beyond which an expression is not written: choices within rules and roots are written once for each."""
RULE = "nodes_along"
"""The function of `_runtime.integrals` that gives nodes and weights."""
NODES = 64
"""Nodes of a rule, for an interval of any length: those that the package takes for long ones."""
STEPS = 6
"""Newton's steps of a root. Over 24 decades six leave 7e-16 in all functions; four would leave 6e-10."""
ASIDE = {"less": (0.5, 2.0), "less_equal": (0.5, 2.0), "greater": (2.0, 0.5), "greater_equal": (2.0, 0.5)}
"""x over y where the relation holds, and where it does not."""
SIGNS = {name: sign for name, sign in OPERATORS.items() if sign not in ("and", "or")} | {
    "bitwise_and": "&", "bitwise_or": "|", "power": "**",
}  # fmt: skip
PREFIXES = {"negative": "-", "invert": "~"}


def expression(name: str, arguments: Sequence[str], result: Node) -> str | None:
    """The text of a function of the library `xp` and of the arguments; None where it would be too long."""
    writer = _Writer()
    if any(map(is_sum, needed(result))):
        writer.lines.append(f"nodes, weights = {RULE}(xp, {NODES}, {', '.join(arguments)})")
    value = _Branch(writer, {}).value(result)
    if len(writer.lines) > LONGEST:
        return None
    lines = "".join(f"    {line}\n" for line in writer.lines)
    return f"def {name}(xp, {', '.join(arguments)}):\n{lines}    return {value}\n"


class _Writer:
    """The lines of one function; names are counted."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.indent = ""
        self._behind: dict[Node, frozenset[Node]] = {}

    def name(self, value: str) -> str:
        """The name of a value on a line of its own."""
        name = f"v{len(self.lines)}"
        self.set(name, value)
        return name

    def set(self, name: str, value: str) -> None:
        """Give a name a value."""
        self.lines.append(f"{self.indent}{name} = {value}")

    def behind(self, node: Node) -> frozenset[Node]:
        """A node and all it is made of."""
        if node not in self._behind:
            self._behind[node] = frozenset((node,)).union(*(self.behind(x) for x in node.operands))
        return self._behind[node]


class _Branch:
    """Values of nodes where some are known by a name; a branch of a `where` has values of its own for one of them."""

    def __init__(self, writer: _Writer, known: dict[Node, str]) -> None:
        self.writer, self._known = writer, known

    def where(self, node: Node, name: str) -> _Branch:
        """The same where a node has another value, and all that is made of it too."""
        known = {own: text for own, text in self._known.items() if node not in self.writer.behind(own)}
        return _Branch(self.writer, known | {node: name})

    def value(self, node: Node) -> str:
        """The name of a value."""
        if node not in self._known:
            self._known[node] = self._written(node)
        return self._known[node]

    def _written(self, node: Node) -> str:
        if node.name == "number":
            return _number(float(node.value))
        if node.name == "argument":
            return str(node.value)
        if node.name == "root":
            return self._root(node)
        if is_sum(node):
            return self._sum(node)
        if node.name == "where":
            condition = self.value(node.operands[0])
            branches = (self._moved(node.operands[0], condition, holds) for holds in (True, False))
            values = [branch.value(x) for branch, x in zip(branches, node.operands[1:], strict=True)]
            return self.writer.name(f"xp.where({condition}, {', '.join(values)})")
        values = [self.value(x) for x in node.operands]
        if node.name in SIGNS:
            return self.writer.name(f" {SIGNS[node.name]} ".join(values))
        if node.name in PREFIXES:
            return self.writer.name(f"{PREFIXES[node.name]}{values[0]}")
        return self.writer.name(f"xp.{node.name}({', '.join(values)})")

    def _moved(self, relation: Node, condition: str, holds: bool) -> _Branch:
        """The branch, with what is compared with another value moved to where the branch applies."""
        if relation.name not in ASIDE or relation.operands[0].name == "number" or relation.operands[1].value == 0.0:
            return self
        x, y = map(self.value, relation.operands)
        aside = f"{ASIDE[relation.name][0 if holds else 1]!r} * {y}"
        chosen = f"{x}, {aside}" if holds else f"{aside}, {x}"
        return self.where(relation.operands[0], self.writer.name(f"xp.where({condition}, {chosen})"))

    def _sum(self, node: Node) -> str:
        """The sum over the nodes, along a first axis."""
        stop, _, variable, summand = node.operands
        length = self.value(stop)
        place = self.writer.name(f"nodes * {length}")
        inner = self.where(variable, place)
        return self.writer.name(f"{length} * xp.sum(weights * {inner.value(summand)}, axis=0)")

    def _root(self, node: Node) -> str:
        """Newton's method in logarithms, whose steps the bounds of the slope keep from running away."""
        *given, variable, curve, rate = node.operands
        value, start, largest, least, most = map(self.value, given)
        writer = self.writer
        wanted = writer.name(f"xp.where({value} > 0.0, {value}, 1.0)")
        t = writer.name(f"xp.minimum({start}, {largest})")
        writer.lines.append(f"for _ in range({STEPS}):")
        writer.indent = "    "
        inner = self.where(variable, t)
        y, slope = inner.value(curve), inner.value(rate)
        missed = writer.name(f"xp.log({wanted} / {y})")
        ends = [writer.name(f"{missed} / {bound}") for bound in (least, most)]
        step = f"xp.maximum({missed} / {slope}, xp.minimum({', '.join(ends)}))"
        step = writer.name(f"xp.minimum({step}, xp.maximum({', '.join(ends)}))")
        # at the largest radius of all the curve has no value
        step = writer.name(f"xp.where({y} < xp.inf, {step}, 0.0)")
        writer.set(t, f"xp.minimum({t} * xp.exp({step}), {largest})")
        writer.indent = ""
        return writer.name(f"xp.where({value} > 0.0, {t}, 0.0 * {value})")


def _number(value: float) -> str:
    if math.isfinite(value):
        return f"({value!r})" if value < 0.0 else repr(value)
    return "xp.nan" if math.isnan(value) else "xp.inf" if value > 0.0 else "(-xp.inf)"
