"""Source text with the places of its nodes, and with parts of it replaced."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Sequence
from typing import Any

Edit = tuple[int, int, str]
"""First byte of a text and the byte behind its last, and what takes its place."""


class Source:
    """Python source, parsed."""

    def __init__(self, text: str) -> None:
        self.text, self.tree, self.bytes = text, ast.parse(text), text.encode()
        self.lines = text.splitlines(keepends=True)
        self.starts = [0]
        for line in self.lines:
            self.starts.append(self.starts[-1] + len(line.encode()))

    def span(self, node: Any) -> tuple[int, int]:
        """First byte of a node, decorators of a function included, and the byte behind its last."""
        first = min([node, *getattr(node, "decorator_list", [])], key=lambda n: n.lineno)
        column = 0 if first is not node else node.col_offset
        end = self.starts[node.end_lineno - 1] + node.end_col_offset
        return self.starts[first.lineno - 1] + column, end

    def source(self, node: Any) -> str:
        """The text of a node, decorators included."""
        start, end = self.span(node)
        return self.bytes[start:end].decode()

    def edited(self, edits: Iterable[Edit], start: int = 0, end: int | None = None) -> str:
        """The text between two bytes, all of it by default, with edits made; of one inside another the outer counts."""
        out, place = [], start
        for first, last, new in sorted(edits, key=lambda edit: (edit[0], -edit[1])):
            if first >= place:
                out += [self.bytes[place:first].decode(), new]
                place = last
        return "".join([*out, self.bytes[place:end].decode()])


def arguments(call: ast.Call, parameters: Sequence[str]) -> dict[str, ast.expr]:
    """The argument expressions of a call by the name of their parameter."""
    given: dict[str, ast.expr] = dict(zip(parameters, call.args, strict=False))
    return given | {keyword.arg: keyword.value for keyword in call.keywords if keyword.arg}
