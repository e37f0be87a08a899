"""The text of a function in which parameters have become constants: what they decide is decided."""

from __future__ import annotations

import ast
import math
import operator
import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .library import Definition

Edit = tuple[int, int, str]
"""First and last byte of a text, and what takes its place."""
WIDTH = 110
UNKNOWN = object()
RELATIONS: Mapping[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Is: operator.is_, ast.IsNot: operator.is_not, ast.Eq: operator.eq, ast.NotEq: operator.ne,
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
}  # fmt: skip
RIGHT = {(ast.Mult, 1.0), (ast.Div, 1.0), (ast.Add, 0.0), (ast.Sub, 0.0)}
"""Operations that leave their left side as it is."""
LEFT = {(ast.Mult, 1.0), (ast.Add, 0.0)}
OPERATIONS = (ast.BinOp, ast.UnaryOp, ast.IfExp, ast.Compare, ast.BoolOp)
ENDS = {"np.minimum": math.inf, "np.maximum": -math.inf}


def shortened(spans: Sequence[tuple[int, int]], gone: Sequence[bool]) -> list[Edit]:
    """The edits that take parts out of a list between commas."""
    kept, edits = False, list[Edit]()
    for i, (span, out) in enumerate(zip(spans, gone, strict=True)):
        if not out:
            kept = True
        elif kept:
            edits.append((spans[i - 1][1], span[1], ""))
        else:
            edits.append((span[0], spans[i + 1][0] if i + 1 < len(spans) else span[1], ""))
    return edits


class Folding:
    """A function without parameters that are `fixed` to the text of a constant."""

    def __init__(self, definition: Definition, fixed: Mapping[str, str]) -> None:
        assert definition.function is not None
        self.function, self.module, self.fixed = definition.function, definition.module, fixed
        self.parents = {id(child): node for node in ast.walk(self.function) for child in ast.iter_child_nodes(node)}

    def edits(self) -> list[Edit]:
        """All of them, also those inside others."""
        found = [*self._header(), *self._doc()]
        for node in ast.walk(self.function):
            if isinstance(node, ast.Name) and node.id in self.fixed:
                found += self._use(node)
        return found

    def _header(self) -> list[Edit]:
        args = self.function.args
        defaults = [None] * (len(args.args) - len(args.defaults)) + list(args.defaults)
        spans = [
            (self.module.span(arg)[0], self.module.span(arg if value is None else value)[1])
            for arg, value in zip(args.args, defaults, strict=True)
        ]
        return shortened(spans, [arg.arg in self.fixed for arg in args.args])

    def _doc(self) -> list[Edit]:
        """Sentences after the first that speak of a parameter go with it."""
        doc = ast.get_docstring(self.function)
        if doc is None or not any(f"`{name}`" in doc for name in self.fixed):
            return []
        first, *rest = (self._sentences(paragraph) for paragraph in doc.split("\n\n"))
        kept = [first[:1] + self._silent(first[1:]), *(self._silent(sentences) for sentences in rest)]
        text = "\n\n".join(textwrap.fill(" ".join(part), WIDTH) for part in kept if part)
        own = textwrap.indent(text, "    ").strip() + ("\n    " if "\n" in text else "")
        return [(*self.module.span(self.function.body[0]), f'"""{own}"""')]

    @staticmethod
    def _sentences(paragraph: str) -> list[str]:
        return re.split(r"(?<=\.)\s+(?=[A-Z`])", " ".join(paragraph.split()))

    def _silent(self, sentences: Sequence[str]) -> list[str]:
        return [text for text in sentences if not any(f"`{name}`" in text for name in self.fixed)]

    def _use(self, name: ast.Name) -> list[Edit]:
        """The largest expression around the name that it decides, and what becomes of the one around that."""
        node: ast.expr = name
        while isinstance(above := self.parents[id(node)], ast.expr) and self._value(above) is not UNKNOWN:
            node = above
        value = self._value(node)
        if isinstance(above, ast.If) and node is above.test and value is not UNKNOWN:
            return self._branch(above, bool(value))
        if isinstance(above, ast.IfExp) and node is above.test and value is not UNKNOWN:
            return self._only(above, above.body if value else above.orelse)
        if isinstance(above, ast.BoolOp) and len(above.values) == 2:
            return self._only(above, next(part for part in above.values if part is not node))
        if isinstance(above, ast.BinOp) and self._neutral(above, node, value):
            return self._only(above, above.left if node is above.right else above.right)
        if isinstance(above, ast.Call) and ENDS.get(ast.unparse(above.func)) == value:
            return self._only(above, next(part for part in above.args if part is not node))
        return [(*self.module.span(node), self._written(node, value))]

    def _value(self, node: ast.expr) -> Any:
        """The value of an expression that the constants decide."""
        match node:
            case ast.Name(id=name) if name in self.fixed:
                return self._value(ast.parse(self.fixed[name], mode="eval").body)
            case ast.Constant(value=value):
                return value
            case ast.UnaryOp(op=ast.Not(), operand=part):
                return UNKNOWN if (value := self._value(part)) is UNKNOWN else not value
            case ast.UnaryOp(op=ast.USub(), operand=part):
                return UNKNOWN if (value := self._value(part)) is UNKNOWN else -value
            case ast.Compare(left=left, ops=[relation], comparators=[right]) if type(relation) in RELATIONS:
                values = self._value(left), self._value(right)
                return UNKNOWN if UNKNOWN in values else RELATIONS[type(relation)](*values)
            case ast.BoolOp(op=connective, values=parts):
                decides = isinstance(connective, ast.Or)
                values = tuple(self._value(part) for part in parts)
                if any(value is not UNKNOWN and bool(value) == decides for value in values):
                    return decides
                return UNKNOWN if UNKNOWN in values else not decides
            case ast.Call(args=[part]) if ast.unparse(node.func) == "np.log":
                return math.inf if self._value(part) == math.inf else UNKNOWN
        return math.inf if ast.unparse(node) == "np.inf" else UNKNOWN

    @staticmethod
    def _neutral(above: ast.BinOp, node: ast.expr, value: Any) -> bool:
        """Whether an operation with it changes nothing but the sign of a zero."""
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            return False
        return (type(above.op), float(value)) in (RIGHT if node is above.right else LEFT)

    def _written(self, node: ast.expr, value: Any) -> str:
        if isinstance(node, ast.Name):
            return self.fixed[node.id]
        return "np.inf" if value == math.inf else repr(value)

    def _only(self, whole: ast.expr, part: ast.expr) -> list[Edit]:
        """An expression of which one part is left, in brackets where it stands in another operation."""
        (start, end), (first, last) = self.module.span(whole), self.module.span(part)
        compound = isinstance(part, OPERATIONS) and isinstance(self.parents[id(whole)], OPERATIONS)
        compound = compound and self.module.bytes[start - 1 : start] != b"("
        return [(start, first, "(" if compound else ""), (last, end, ")" if compound else "")]

    def _branch(self, statement: ast.If, holds: bool) -> list[Edit]:
        """The lines of one branch in the place of the statement, or none; what follows a return goes too."""
        taken = statement.body if holds else statement.orelse
        starts, first = self.module.starts, statement.lineno - 1
        end = statement.end_lineno or statement.lineno
        if not taken:
            while self.module.lines[first - 1].strip().startswith("#"):
                first -= 1
            return [(starts[first], starts[end], "")]
        begin = taken[0].lineno - 1
        while self.module.lines[begin - 1].strip().startswith("#"):
            begin -= 1
        stop = taken[-1].end_lineno or begin + 1
        if isinstance(taken[-1], (ast.Return, ast.Break, ast.Continue, ast.Raise)):
            end = self._last_beside(statement)
        dedented = [(starts[line], starts[line] + 4, "") for line in range(begin, stop)]
        return [(starts[first], starts[begin], ""), *dedented, (starts[stop], starts[end], "")]

    def _last_beside(self, statement: ast.stmt) -> int:
        above = self.parents[id(statement)]
        for name in ("body", "orelse"):
            beside = getattr(above, name, [])
            if statement in beside:
                return int(beside[-1].end_lineno)
        return int(statement.end_lineno or statement.lineno)
