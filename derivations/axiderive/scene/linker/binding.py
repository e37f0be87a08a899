"""Parameters for which all calls of a scene have one value are bound to it, with all that this decides.

`def f(x, width=1.0)` whose calls never say another width becomes `def f(x)`, and in it `x / width` becomes `x`;
where every call says a width, it is `def f(x, width)`. A parameter that the scene freezes goes out of every function to
which only itself is passed: the constant of the same name takes its place.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import textwrap
from collections.abc import Callable, Collection, Mapping, Sequence
from copy import deepcopy
from typing import Any

from .library import (
    Program,
    arguments,
    bound,
    calls,
    documentation,
    expression,
    is_comment,
    loaded,
    parameters,
    references,
    stored,
)

WIDTH = 110
UNKNOWN = object()
GONE = ast.Pass()
"""In the place of a condition of which nothing is left."""
LEAVES = (ast.Return, ast.Break, ast.Continue, ast.Raise)
RELATIONS: Mapping[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Is: operator.is_, ast.IsNot: operator.is_not, ast.Eq: operator.eq, ast.NotEq: operator.ne,
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
}  # fmt: skip
RIGHT = {(ast.Mult, 1.0), (ast.Div, 1.0), (ast.Add, 0.0), (ast.Sub, 0.0)}
"""Operations that leave their left side as it is, but for the sign of a zero."""
LEFT = {(ast.Mult, 1.0), (ast.Add, 0.0)}
ENDS = {"np.minimum": math.inf, "np.maximum": -math.inf}


class _Binding(ast.NodeTransformer):
    """Works constants into a function: what they decide is decided."""

    def __init__(self, values: Mapping[str, ast.expr], positive: frozenset[str]) -> None:
        self.values = values
        self.certain = {f"{name} > 0.0" for name in positive & values.keys()}
        self.decided: dict[ast.AST, Any] = {}
        """Expressions that the constants decide, with their values."""

    def generic_visit(self, node: ast.AST) -> ast.AST:
        """Also without the statements that are no longer reached."""
        super().generic_visit(node)
        for name in ("body", "orelse"):
            if isinstance(block := getattr(node, name, None), list):
                setattr(node, name, _tidied(block))
        return node

    def _known(self, node: ast.AST) -> Any:
        if isinstance(node, ast.Constant):
            return node.value
        return self.decided.get(node, math.inf if ast.unparse(node) == "np.inf" else UNKNOWN)

    def _decide(self, value: Any) -> ast.expr:
        node = expression("np.inf") if value == math.inf else ast.Constant(value)
        self.decided[node] = value
        return node

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """The value of a parameter."""
        if node.id not in self.values:
            return node
        found = deepcopy(self.values[node.id])
        match found:
            case ast.UnaryOp(op=ast.USub(), operand=part):
                self.decided[found] = -self._known(part)
            case _ if (value := self._known(found)) is not UNKNOWN:
                self.decided[found] = value
        return found

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """Of a value that is known."""
        self.generic_visit(node)
        if node.operand in self.decided and isinstance(node.op, (ast.Not, ast.USub)):
            value = self.decided[node.operand]
            return self._decide(not value if isinstance(node.op, ast.Not) else -value)
        return node

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        """True or false, where both sides are known."""
        self.generic_visit(node)
        sides = [node.left, *node.comparators]
        if len(sides) == 2 and any(side in self.decided for side in sides) and type(node.ops[0]) in RELATIONS:
            values = [self._known(side) for side in sides]
            if UNKNOWN not in values:
                return self._decide(RELATIONS[type(node.ops[0])](*values))
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.AST:
        """What is left of the conditions."""
        self.generic_visit(node)
        decisive = isinstance(node.op, ast.Or)
        if any(part in self.decided and bool(self.decided[part]) == decisive for part in node.values):
            return self._decide(decisive)
        node.values = [part for part in node.values if part not in self.decided]
        return node if len(node.values) > 1 else node.values[0] if node.values else self._decide(not decisive)

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """The other side, where a value leaves it as it is."""
        self.generic_visit(node)
        for part, other, neutral in ((node.right, node.left, RIGHT), (node.left, node.right, LEFT)):
            value = self.decided.get(part)
            number = isinstance(value, float) or type(value) is int
            if number and (type(node.op), value) in neutral:
                return other
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """The side of a choice that is certain, or the only one that can be an end."""
        self.generic_visit(node)
        name = ast.unparse(node.func)
        known = [part for part in node.args if part in self.decided]
        if name == "np.where" and ast.unparse(node.args[0]) in self.certain:
            return node.args[1]
        if known and name == "np.log" and self.decided[known[0]] == math.inf:
            return self._decide(math.inf)
        if known and name in ENDS and ENDS[name] == self.decided[known[0]]:
            return next(part for part in node.args if part is not known[0])
        return node

    def visit_IfExp(self, node: ast.IfExp) -> ast.AST:
        """The branch that is taken."""
        self.generic_visit(node)
        return node if node.test not in self.decided else node.body if self.decided[node.test] else node.orelse

    def visit_If(self, node: ast.If) -> Any:
        """The statements of the branch that is taken."""
        self.generic_visit(node)
        if node.test not in self.decided:
            return node
        return (node.body if self.decided[node.test] else node.orelse) or GONE


def _tidied(block: Sequence[ast.stmt]) -> list[ast.stmt]:
    """The statements without those behind a return, and without the comment on a condition that is gone."""
    found: list[ast.stmt] = []
    for statement in block:
        while statement is GONE and found and is_comment(found[-1]):
            found.pop()
        if statement is not GONE:
            found.append(statement)
        if isinstance(statement, LEAVES):
            break
    return found


def _silent(doc: str, names: Collection[str]) -> str:
    """A docstring without the sentences after the first that speak of a parameter."""
    if not any(f"`{name}`" in doc for name in names):
        return doc

    def kept(sentences: Sequence[str]) -> list[str]:
        return [text for text in sentences if not any(f"`{name}`" in text for name in names)]

    paragraphs = [" ".join(paragraph.split()) for paragraph in doc.strip().split("\n\n")]
    first, *rest = (re.split(r"(?<=\.)\s+(?=[A-Z`])", paragraph) for paragraph in paragraphs)
    left = [first[:1] + kept(first[1:]), *map(kept, rest)]
    text = "\n\n".join(textwrap.fill(" ".join(part), WIDTH) for part in left if part)
    return textwrap.indent(text, "    ").strip() + ("\n    " if "\n" in text else "")


Values = dict[str, list[ast.expr | None]]
"""Of the parameters of a function by name; None for what is no constant."""


def bind(program: Program, frozen: frozenset[str], positive: frozenset[str]) -> None:
    """Bind these parameters, of wanted functions the frozen ones alone; of those no line asks which are positive."""
    while True:
        program.prune()
        said, left = _said(program, frozen)
        found = {key: own for key, values in said.items() if (own := _agreed(values))}
        for key, constants in found.items():
            function = program.functions[key]
            if doc := documentation(function):
                function.body[0] = ast.Expr(ast.Constant(_silent(doc, constants.keys() - frozen)))
            _Binding(constants, positive).visit(function)
        program.without({key: frozenset(constants) for key, constants in found.items()})
        if not found:
            for key, values in said.items():
                _require(program.functions[key], {name for name in values if values[name] and name not in left[key]})
            program.prune()
            return


def _defaults(function: ast.FunctionDef) -> dict[str, ast.expr]:
    """Parameters with a default."""
    head = function.args
    if head.vararg or head.kwarg or head.kwonlyargs:
        return {}
    inner = [node.arg for node in ast.walk(function) if isinstance(node, ast.arg)]
    last = zip(head.args[len(head.args) - len(head.defaults) :], head.defaults, strict=True)
    return {arg.arg: value for arg, value in last if inner.count(arg.arg) == 1}


def _said(program: Program, frozen: frozenset[str]) -> tuple[dict[str, Values], dict[str, set[str]]]:
    """By function and parameter with a default, or of a frozen name, its values, and what some call leaves out.

    Not of a function that is also handed on, nor of a parameter that gets another value inside.
    """
    functions, wanted = program.functions, set(program.wanted)
    defaults = {key: {} if key in wanted else _defaults(node) for key, node in functions.items()}
    values: dict[str, Values] = {}
    for key, function in functions.items():
        names = ({*parameters(function)} & frozen | defaults[key].keys()) - stored(function)
        values[key] = {name: [loaded(name)] if key in wanted else [] for name in sorted(names)}
    left: dict[str, set[str]] = {key: set() for key in functions}
    for node in program.trees.values():
        known, inner = {id(call.func): call for call, _ in calls(node)}, bound(node)
        for name in references(node):
            call = known.get(id(name))
            if call is None or any(isinstance(part, ast.Starred) for part in call.args):
                values.pop(name.id, None)
                continue
            given = arguments(call, parameters(functions[name.id])) if name.id in values else {}
            for parameter, own in values.get(name.id, {}).items():
                if parameter not in given:
                    left[name.id].add(parameter)
                value = given.get(parameter) or defaults[name.id][parameter]
                itself = parameter in frozen - inner and isinstance(value, ast.Name) and value.id == parameter
                own.append(value if itself or _constant(program, value, name.id) else None)
    return values, left


def _constant(program: Program, value: ast.expr, key: str) -> bool:
    """Whether it is a number, or a constant of the module of the function: a name means something there alone."""
    part = value.operand if isinstance(value, ast.UnaryOp) else value
    if isinstance(value, ast.Name) and ":" in value.id:
        same = value.id.partition(":")[0] == key.partition(":")[0]
        return same and value.id not in program.functions
    return isinstance(part, ast.Constant) or ast.unparse(part) == "np.inf"


def _agreed(values: Values) -> dict[str, ast.expr]:
    """The parameters of one value."""
    return {
        name: own[0] for name, own in values.items()
        if own and own[0] and all(value and ast.unparse(value) == ast.unparse(own[0]) for value in own)
    }  # fmt: skip


def _require(function: ast.FunctionDef, given: set[str]) -> None:
    """Take the defaults that no call leaves to stand; those after one that stays have to stay."""
    head = function.args
    while head.defaults and head.args[len(head.args) - len(head.defaults)].arg in given:
        head.defaults.pop(0)
