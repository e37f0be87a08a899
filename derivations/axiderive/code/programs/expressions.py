"""A formula over any array library, from its graph: for gradients and compilers, which follow no branch.

A gradient through `where(r < a, f(r), 0)` is NaN outside the contact wherever that of f is, because both
branches are evaluated.  Here the arguments are moved into the branch before it is evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from .graph import Node, needed
from .plain import OPERATORS

LOOPS = frozenset(("integral", "unless"))
"""Operations of a graph that are loops of the package, or hold in the branch that is mostly met alone."""
ASIDE = {"less": (0.5, 2.0), "less_equal": (0.5, 2.0), "greater": (2.0, 0.5), "greater_equal": (2.0, 0.5)}
"""x over y where the relation holds, and where it does not."""
SIGNS = {name: sign for name, sign in OPERATORS.items() if sign not in ("and", "or")} | {
    "bitwise_and": "&", "bitwise_or": "|", "power": "**",
}  # fmt: skip
PREFIXES = {"negative": "-", "invert": "~"}


def expression(name: str, arguments: Sequence[str], result: Node) -> str | None:
    """The text of a function of the library `xp` and of the arguments; None for what evaluates a rule."""
    if any(node.name in LOOPS for node in needed(result)):
        return None
    writer = _Writer()
    value = writer.branch({own: own for own in arguments}).value(result)
    lines = "".join(f"    {line}\n" for line in writer.lines)
    return f"def {name}(xp, {', '.join(arguments)}):\n{lines}    return {value}\n"


class _Writer:
    """The lines of one function; names are counted."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def name(self, value: str) -> str:
        """The name of a value on a line of its own."""
        self.lines.append(f"v{len(self.lines)} = {value}")
        return f"v{len(self.lines) - 1}"

    def branch(self, arguments: dict[str, str]) -> _Branch:
        """What is written for these arguments."""
        return _Branch(self, arguments)


class _Branch:
    """Values of nodes for some arguments; a branch of a `where` has arguments of its own."""

    def __init__(self, writer: _Writer, arguments: dict[str, str]) -> None:
        self.writer, self.arguments = writer, arguments
        self._known: dict[int, str] = {}

    def value(self, node: Node) -> str:
        """The name of a value."""
        if node.order not in self._known:
            self._known[node.order] = self._written(node)
        return self._known[node.order]

    def _written(self, node: Node) -> str:
        if node.name == "number":
            return _number(float(node.value))
        if node.name == "argument":
            return self.arguments[node.value]
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
        """The branch, with an argument that is compared with another moved to where the branch applies."""
        if relation.name not in ASIDE or any(x.name != "argument" for x in relation.operands):
            return self
        x, y = (self.arguments[operand.value] for operand in relation.operands)
        aside = f"{ASIDE[relation.name][0 if holds else 1]!r} * {y}"
        chosen = f"{x}, {aside}" if holds else f"{aside}, {x}"
        moved = self.writer.name(f"xp.where({condition}, {chosen})")
        return self.writer.branch({**self.arguments, relation.operands[0].value: moved})


def _number(value: float) -> str:
    if math.isfinite(value):
        return f"({value!r})" if value < 0.0 else repr(value)
    return "xp.nan" if math.isnan(value) else "xp.inf" if value > 0.0 else "(-xp.inf)"
