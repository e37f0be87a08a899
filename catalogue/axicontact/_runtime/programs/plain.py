"""Formulas for plain numbers: one flat function of `math` from the graph of a body.

A ufunc takes half a microsecond for one number and `math` a tenth of that, a call of a function as much
as a formula.  `np.where` becomes an if: nothing is evaluated outside its branch.  A rule is a loop over its nodes.
A body without a graph, one that iterates, runs as it is with `math` in the place of NumPy.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dis import get_instructions
from functools import cache
from operator import not_
from types import CodeType, FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from ..interface import LARGE, SMALL
from ..intervals import INSIDE
from ..nodes import gauss_legendre
from .bounds import Bound, bounds
from .trace import Lengths, Node, Path, needed, of_a_module, places, trace

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


CALL = """
def call({signature}):
    if {types} is float and {ranges}:
        try:
{lines}
        except (ArithmeticError, ValueError):
            pass
    return function({passed})
"""
ORDERS = {"require_reach": "b <= a"}
"""What a check of two parameters asks of plain numbers."""


def call_text(code: CodeType, private: FunctionType) -> tuple[str, dict[str, Any]]:
    """The short way before the function, and the names it uses."""
    names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
    fields, keywords = names[: code.co_argcount], names[code.co_argcount :]
    ranges = dict.fromkeys(fields, (SMALL, LARGE))
    ranges |= {name: (max(SMALL, INSIDE[name][0]), min(LARGE, INSIDE[name][1])) for name in keywords}
    # a third faster than in a chain
    inside = [f"{name} > {low} and {name} < {high}" for name, (low, high) in ranges.items()]
    inside += [order for check, order in ORDERS.items() if check in code.co_names]
    found, space = lines(private, ranges) or (["pass"], {})
    text = CALL.format(
        signature=", ".join([*fields, *(["*"] if keywords else []), *keywords]),
        types=" is ".join(f"{name}.__class__" for name in names),
        ranges=" and ".join(inside),
        lines=indented(found, 3),
        passed=", ".join([*fields, *(f"{name}={name}" for name in keywords)]),
    )
    return text, space


PANELS = 4
"""Panels of a rule beyond which its sum is left to the body, which carries what rounding loses."""


def is_sum(node: Node) -> bool:
    return node.name == "integral"


def loops(nodes: list[Node]) -> dict[Node, Node]:
    """The integral inside which a node changes, for those that do."""
    found: dict[Node, Node] = {}
    sums = {node.operands[2]: node for node in nodes if is_sum(node)}
    for node in nodes:
        if node in sums:
            found[node] = sums[node]
        elif not is_sum(node) and (inside := [found[x] for x in node.operands if x in found]):
            found[node] = inside[0]
    return found


@cache
def rule(lengths: Lengths) -> Callable[[float], list[tuple[float, float]]]:
    """Nodes and weights on (0, 1) for an interval of a length, in panels beyond the last one."""

    def pairs(length: float) -> list[tuple[float, float]]:
        for longest, count in lengths:
            if length <= longest:
                return _pairs(count, 1)
        panels = math.ceil(length / longest)
        if panels > PANELS:
            raise ArithmeticError
        return _pairs(count, panels)

    return pairs


@cache
def _pairs(count: int, panels: int) -> list[tuple[float, float]]:
    nodes, weights = (column.tolist() for column in gauss_legendre(count))
    panel = list(zip(nodes, weights, strict=True))
    return [((start + node) / panels, weight / panels) for start in range(panels) for node, weight in panel]


PACKAGE = __name__.partition(".")[0]
NEEDS_ARRAYS = frozenset(
    (
        "integral",
        "integral_by_panels",
        "in_groups",
        "pressure_integral",
        "gauss_legendre",
        "enumerate",
    )
)
"""Names that a body may not refer to: rules with nodes along an axis, and sums over coefficients."""


def _sqrt(x: float) -> float:
    return math.sqrt(x) if x >= 0.0 else math.nan


MATH = SimpleNamespace(
    pi=math.pi, e=math.e, inf=math.inf, nan=math.nan, float64=float,
    sqrt=_sqrt, cbrt=math.cbrt, exp=math.exp, expm1=math.expm1, log=math.log, log1p=math.log1p,
    sin=math.sin, cos=math.cos, tan=math.tan, arctan=math.atan, arctan2=math.atan2, arctanh=math.atanh,
    sinh=math.sinh, cosh=math.cosh, tanh=math.tanh, arcsinh=math.asinh,
    abs=abs, minimum=min, maximum=max, isfinite=math.isfinite, any=bool, all=bool, count_nonzero=bool,
    # bodies write it out: ~True is -2, and an error from Python 3.16 on
    logical_not=not_,
    where=lambda condition, x, y: x if condition else y,
    asarray=lambda x, dtype=None: x, full_like=lambda x, value: value,
    ones_like=lambda x: 1.0, zeros_like=lambda x: 0.0,
)  # fmt: skip
_namespaces: dict[int, dict[str, Any]] = {}


def scalar(function: FunctionType) -> Callable[..., float] | None:
    """The function of a module over plain numbers, or None if it needs arrays."""
    if _needs_arrays(function, set()):
        return None
    twin: Callable[..., float] = _namespace(function.__globals__)[function.__name__]
    return twin


def _needs_arrays(function: FunctionType, seen: set[FunctionType]) -> bool:
    seen.add(function)
    names = _names(function.__code__)
    if names & NEEDS_ARRAYS or any(_of_arrays(*attribute) for attribute in _attributes(function.__code__)):
        return True
    if any(step.opname == "IMPORT_NAME" for step in get_instructions(function.__code__)):
        return True  # what it imports has NumPy for `np`
    spaces = [function.__globals__, *(vars(m) for n in names if _own(m := function.__globals__.get(n), ModuleType))]
    called: list[Any] = [space.get(name) for space in spaces for name in names]
    return any(_needs_arrays(f, seen) for f in called if _own(f, FunctionType) and f not in seen)


def _names(code: CodeType) -> set[str]:
    inner = (_names(constant) for constant in code.co_consts if isinstance(constant, CodeType))
    return set(code.co_names).union(*inner)


def _attributes(code: CodeType) -> Iterator[tuple[str, str]]:
    """What attributes are looked up, each behind the global name it is one of, or behind none."""
    owner = ""
    for step in get_instructions(code):
        if step.opname in ("LOAD_ATTR", "LOAD_METHOD"):
            yield owner, step.argval
        owner = step.argval if step.opname == "LOAD_GLOBAL" else ""
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _attributes(constant)


def _of_arrays(owner: str, name: str) -> bool:
    """Whether plain numbers have nothing of that name: `sum` is one of NumPy, and of Python without `np` before it."""
    if owner == "np":
        return not hasattr(MATH, name)
    return hasattr(np.ndarray, name) and not any(hasattr(kind, name) for kind in (float, list, tuple))


def _own(value: Any, kind: type) -> bool:
    name = getattr(value, "__module__" if kind is FunctionType else "__name__", None)
    return isinstance(value, kind) and str(name).startswith(PACKAGE)


def _namespace(names: dict[str, Any]) -> dict[str, Any]:
    """The global names of a module with `math` for `np` and every function of the package bound to such names."""
    known = _namespaces.get(id(names))
    if known is not None:
        return known
    twin = _namespaces[id(names)] = {**names, "np": MATH}
    for name, value in names.items():
        if _own(value, FunctionType) and value.__closure__ is None:
            space = twin if value.__globals__ is names else _namespace(value.__globals__)
            twin[name] = FunctionType(value.__code__, space, value.__name__, value.__defaults__)
        elif _own(value, ModuleType):
            twin[name] = SimpleNamespace(**_namespace(vars(value)))
    return twin
