"""Formulas for plain numbers: one flat function of `math` from the graph of a body.

A ufunc takes half a microsecond for one number and `math` a tenth of that, a call of a function as much
as a formula.  `np.where` becomes an if: nothing is evaluated outside its branch.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import FunctionType
from typing import Any

from ._bounds import Bound, bounds
from ._elementwise import LARGE, SMALL
from ._loops import is_sum, loops, rule
from ._scalar import scalar
from ._trace import Lengths, Node, Path, needed, of_a_module, places, trace

LEAST, GREATEST = 1e-200, 1e200
"""A result between these is trusted where the bounds of a formula do not show that nothing left the range."""
CHECK = f"if not (value > {LEAST} and value < {GREATEST} or {LEAST} < -value < {GREATEST}): raise ArithmeticError"
OPERATORS = {
    "add": "+", "subtract": "-", "multiply": "*", "divide": "/", "less": "<", "less_equal": "<=", "greater": ">",
    "greater_equal": ">=", "equal": "==", "not_equal": "!=", "bitwise_and": "and", "bitwise_or": "or",
}  # fmt: skip
PREFIXES = {"negative": "-", "invert": "not "}
NAMES = {
    "power": "pow", "absolute": "abs", "arctan": "atan", "arctan2": "atan2", "arcsinh": "asinh",
    "minimum": "{0} if {0} < {1} or {0} != {0} else {1}", "maximum": "{0} if {0} > {1} or {0} != {0} else {1}",
    "square": "{0} * {0}",
}  # fmt: skip
TWICE = ("minimum", "maximum", "square")
DEEPEST = 24
"""Operations inside one another on one line; Python refuses two hundred parentheses."""
FORMULA = """
def formula({names}):
    try:
{lines}
    except (ArithmeticError, ValueError):
        return None
"""
_formulas: dict[Callable[..., Any], Callable[..., float | None] | None] = {}


def plain(function: Callable[..., Any]) -> Callable[..., float | None] | None:
    """The function over plain numbers: a result or None where it may be wrong; None if it needs arrays."""
    if function not in _formulas:
        if not of_a_module(function):
            return None
        names = function.__code__.co_varnames[: function.__code__.co_argcount]
        found = lines(function, dict.fromkeys(names, (SMALL, LARGE)))
        if found is not None:
            text, space = found
            exec(FORMULA.format(names=", ".join(names), lines=indented(text, 2)), space)  # our own functions' names
            _formulas[function] = space["formula"]
        else:
            _formulas[function] = None
    return _formulas[function]


def lines(function: FunctionType, ranges: Mapping[str, tuple[float, float]]) -> tuple[list[str], dict[str, Any]] | None:
    """The lines that return the value of a private function for arguments in `ranges`, and the names they use."""
    space = {name: value for name, value in vars(math).items() if not name.startswith("_")}
    space["abs"] = abs
    names = function.__code__.co_varnames[: function.__code__.co_argcount]
    result = trace(function, names, ())
    if result is not None:
        written = _Lines(result, ranges)
        return written.text(), space | {name: rule(lengths) for lengths, name in written.rules.items()}
    twin = scalar(function)
    if twin is None:
        return None
    return [f"value = twin({', '.join(names)})", CHECK, "return value"], space | {"twin": twin}


def indented(text: list[str], depth: int) -> str:
    return "\n".join("    " * depth + line for line in text)


class _Lines:
    """Lines of one function: what occurs once is written where it is used, the rest has a name."""

    def __init__(self, result: Node, ranges: Mapping[str, tuple[float, float]]) -> None:
        self.nodes = needed(result)
        self.loops = loops(self.nodes)
        self.paths = {node: self._outside(node, path) for node, path in places(self.nodes).items()}
        self.rules: dict[Lengths, str] = {}
        self.named = self._named()
        self.split = {choice for node in self.named for choice, _ in self.paths[node]}
        self.written: set[Node] = set()
        self.proved = _proved(self.nodes, bounds(self.nodes, ranges))

    def _outside(self, node: Node, path: Path) -> Path:
        """The choices that are made before the loop, for what does not change in it."""
        inner = [i for i, (choice, _) in enumerate(path) if choice in self.loops and node not in self.loops]
        return path[: inner[0]] if inner else path

    def _named(self) -> set[Node]:
        """What is written on a line of its own: all that occurs twice, and a branch with such lines."""
        uses, depth, found = dict.fromkeys(self.nodes, 0), dict.fromkeys(self.nodes, 0), set()
        for user in self.nodes:
            for x in user.operands:
                loop = self.loops.get(user) is not self.loops.get(x)
                uses[x] += 2 if loop or user.name in (*TWICE, "integral") or _is_square(user) else 1
        for node in self.nodes:
            if not node.operands:
                continue
            depth[node] = 1 + max(depth[x] for x in node.operands)
            if uses[node] > 1 or node in found or depth[node] > DEEPEST or node.name == "integral":
                found |= {node, *(choice for choice, _ in self.paths[node])}
                depth[node] = 0
        return {node for node in found if not self._is_first(node)}

    def text(self) -> list[str]:
        return self._returned(self.nodes[-1], (), certain=True)

    def _assigned(self, path: Path, last: Node, loop: Node | None = None) -> list[str]:
        """The lines for what is needed under these choices in this loop, but for the last one."""
        text = []
        for node in self.nodes:
            here = self.paths[node] == path and self.loops.get(node) is loop
            if here and node in self.named and node not in self.written and (node is not last or is_sum(node)):
                self.written.add(node)
                text += self._assignment(node, path)
        return text

    def _assignment(self, node: Node, path: Path) -> list[str]:
        if is_sum(node):
            return self._loop(node, path)
        if node not in self.split:
            return [f"_{node.order} = {self.expression(node)}"]
        condition, *branches = node.operands
        text = [f"if {self.of(condition)}:"]
        for branch, holds in zip(branches, (True, False), strict=True):
            inner = self._assigned((*path, (node, holds)), node, self.loops.get(node))
            inner.append(f"_{node.order} = {self.of(branch)}")
            text += [*(["else:"] if not holds else []), *(f"    {line}" for line in inner)]
        return text

    def _loop(self, node: Node, path: Path) -> list[str]:
        stop, width, variable, summand = node.operands
        name = self.rules.setdefault(node.value, f"rule{len(self.rules)}")
        inner = [
            f"_{variable.order} = node * {self.of(stop)}",
            *self._assigned(path, node, node),
            f"_{node.order}.append(weight * {self.of(summand)})",
        ]
        # summed one by one the 64 nodes of a power lose 3 units, which a pressure next to its zero takes up
        return [
            f"_{node.order} = []",
            f"for node, weight in {name}({self.of(stop)} / {self.of(width)}):",
            *(f"    {line}" for line in inner),
            f"_{node.order} = fsum(_{node.order}) * {self.of(stop)}",
        ]

    def _returned(self, node: Node, path: Path, certain: bool) -> list[str]:
        if node.name == "unless":
            condition, node = node.operands
            text = [*self._assigned(path, node), f"if {self.of(condition)}: raise ArithmeticError"]
            return text + self._returned(node, path, certain and condition in self.proved)
        text = self._assigned(path, node if self.paths[node] == path else self.nodes[-1])
        if node.name == "where" and self.paths[node] == path:
            condition, x, y = node.operands
            certain = certain and condition in self.proved
            text.append(f"if {self.of(condition)}:")
            text += [f"    {line}" for line in self._returned(x, (*path, (node, True)), certain)]
            return text + self._returned(y, (*path, (node, False)), certain)
        value = self.expression(node) if self.paths[node] == path and not is_sum(node) else self.of(node)
        if certain and (node in self.proved or node.name == "number"):
            return [*text, f"return {value}"]
        return [*text, f"value = {value}", CHECK, "return value"]

    def _is_first(self, node: Node) -> bool:
        """Whether this is minimum(x, y) where x < y has been decided."""
        chosen = [choice.operands[0] for choice, holds in self.paths[node] if holds]
        return node.name == "minimum" and any(x.name == "less" and x.operands == node.operands for x in chosen)

    def of(self, node: Node) -> str:
        if self._is_first(node):
            return self.of(node.operands[0])
        return f"_{node.order}" if node in self.named else self.expression(node)

    def expression(self, node: Node) -> str:
        if node.name == "argument":
            return str(node.value)
        if node.name == "variable":
            return f"_{node.order}"
        if node.name == "number":
            return f"({node.value!r})"
        operands = [self.of(x) for x in node.operands]
        if node.name == "where":
            return f"({operands[1]} if {operands[0]} else {operands[2]})"
        if _is_square(node):
            return f"({operands[0]} * {operands[0]})"
        if node.name in OPERATORS:
            return f"({operands[0]} {OPERATORS[node.name]} {operands[1]})"
        if node.name in PREFIXES:
            return f"({PREFIXES[node.name]}{operands[0]})"
        if node.name in TWICE:
            return f"({NAMES[node.name].format(*operands)})"
        return f"{NAMES.get(node.name, node.name)}({', '.join(operands)})"


def _is_square(node: Node) -> bool:
    return node.name == "power" and node.operands[1].name == "number" and node.operands[1].value == 2.0


def _proved(nodes: list[Node], found: Mapping[Node, Bound | None]) -> set[Node]:
    """Nodes behind which nothing leaves the range of doubles."""
    proved: set[Node] = set()
    for node in nodes:
        inside = node.logical or found[node] is not None
        if inside and all(x in proved or (node.logical and x.name == "number") for x in node.operands):
            proved.add(node)
    return proved
