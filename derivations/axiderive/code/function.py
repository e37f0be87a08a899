"""A function of a generated module as data: what it takes, its lines, and the names it rests on.

Calls, definitions and imports are laid out over lines as the formatter of the project lays them out.
"""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

TYPES = {"control": "str", "base": "str"}
"""Of parameters that are neither numbers nor arrays."""


@dataclass(frozen=True)
class Function:
    """`name(fields, needs)`: a public one takes its `needs` by keyword, a private one takes all by place.

    A parameter that brings its annotation along stands in the signature as it is.
    """

    name: str
    fields: Sequence[str]
    needs: Sequence[str]
    lines: Sequence[str]
    doc: str = ""
    """The docstring; a private function has one where its name does not say it all."""
    returns: str = "Array"
    leading: str = ""
    """A first parameter that is neither field nor number, with its annotation and default."""
    summed: bool = False
    """Whether A is a tuple of coefficients, and no array."""
    decorator: str = ""
    """What of the run time it is handed to."""

    @property
    def public(self) -> bool:
        """Whether it belongs to the interface."""
        return not self.name.startswith("_")

    @property
    def parameters(self) -> list[str]:
        """The names of all it takes, in their order."""
        return [*self.fields, *self.needs]

    def call(self, *fields: str) -> str:
        """The code of a call with these fields, or with its own where none are given."""
        return f"{self.name}({', '.join([*(fields or self.fields), *self.needs])})"

    def growth(self, *fields: str) -> str:
        """The function of its fields alone, to be integrated."""
        return f"lambda {', '.join(fields)}: {self.call(*fields)}"

    def with_parameters(self) -> str:
        """The function and what it needs besides its fields, for a rule that passes them on."""
        return f"{self.name}, ({', '.join(self.needs)}{',' if len(self.needs) == 1 else ''})"

    def text(self, imports: Sequence[str] = ()) -> str:
        """The function as Python code; `imports` are lines at its beginning."""
        head = fit(f"def {self.name}({', '.join(self._typed())}) -> {self.returns}:", 0)
        lines = [*imports, *([""] if imports else []), *self.lines]
        apart = [""] if self.doc and lines[0].startswith("def ") else []
        body = [*self._docstring(), *apart, *(part for line in lines for part in fit(line))]
        above = [f"@{self.decorator}"] if self.decorator else []
        return "\n".join([*above, *head, *(f"    {line}".rstrip() for line in body)]) + "\n"

    def _typed(self) -> list[str]:
        kind = "ArrayLike" if self.public else "Array"
        types = TYPES | ({"A": "tuple[float, ...]"} if self.summed and not self.public else {})
        fields, needs = (
            [name if name == "*" or ":" in name else f"{name}: {types.get(name, kind)}" for name in names]
            for names in (self.fields, self.needs)
        )
        apart = ["*"] if self.public and needs else []
        return [*([self.leading] if self.leading else []), *fields, *apart, *needs]

    def _docstring(self) -> list[str]:
        if not self.doc:
            return []
        first, *others = self.doc.split("\n")
        return [f'"""{first}', *others, '"""'] if others else [f'"""{first}"""']

    @cached_property
    def uses(self) -> frozenset[str]:
        """The names that mean something of the module or of the run time, those of annotations among them."""
        nodes = list(ast.walk(ast.parse(self.text())))
        names = [node for node in nodes if isinstance(node, ast.Name)]
        bound = {node.id for node in names if isinstance(node.ctx, ast.Store)}
        bound |= {node.arg for node in nodes if isinstance(node, ast.arg)}
        bound |= {node.name for node in nodes if isinstance(node, ast.FunctionDef)}
        return frozenset({node.id for node in names} - bound)


def reached(functions: Iterable[Function], roots: Iterable[Function]) -> list[Function]:
    """Those of some functions that the roots use, directly or through others, in their order."""
    known = {own.name: own for own in functions}
    found, pending = set[str](), [name for root in roots for name in root.uses]
    while pending:
        name = pending.pop()
        if name in known and name not in found:
            found.add(name)
            pending += known[name].uses
    return [own for name, own in known.items() if name in found]


LINE = 120


def call(head: str, parts: Sequence[str], tail: str = ")", indent: int = 4) -> list[str]:
    """`head(parts)tail` on one line, else its parts on a line of their own, else one part to a line.

    The lines come without the indentation of the block they stand in.
    """
    joined = ", ".join(parts)
    if indent + len(head) + 1 + len(joined) + len(tail) <= LINE:
        return [f"{head}({joined}{tail}"]
    if indent + 4 + len(joined) <= LINE:
        return [f"{head}(", f"    {joined}", tail]
    return [f"{head}(", *(f"    {part}," for part in parts), tail]


def from_import(source: str, names: Sequence[str]) -> list[str]:
    """An import, its names in the order constants, classes, functions."""
    ordered = sorted(set(names), key=_kind)
    line = f"from {source} import {', '.join(ordered)}"
    return [line] if len(line) <= LINE else [f"from {source} import (", *(f"    {name}," for name in ordered), ")"]


def _kind(name: str) -> tuple[int, str]:
    if name.isupper() and len(name) > 1:
        return 0, name
    return (1 if name[:1].isupper() else 2), name


def fit(line: str, indent: int = 4) -> list[str]:
    """A line, or its last bracket opened where it is too long for one."""
    if indent + len(line) <= LINE or ")" not in line:
        return [line]
    close = line.rindex(")")
    place = _opening(line, close)
    head, parts = line[:place], split(line[place + 1 : close])
    # a comma behind the only part of a bracket that calls nothing would make it a tuple
    if parts[-1].startswith("for ") or (len(parts) == 1 and not re.search(r"\w$", head)):
        inside = line[place + 1 : close]
        parts = [inside] if indent + 4 + len(inside) <= LINE else parts
        return [f"{head}(", *(f"    {part}" for part in parts), line[close:]]
    return call(head, parts, line[close:], indent)


def split(text: str) -> list[str]:
    """The parts between the commas outside all brackets and quotes; of what is generated the value, and the rest.

    The commas between the parameters of a lambda part nothing.
    """
    parts, depth, quoted = [""], 0, False
    for place, character in enumerate(text):
        quoted ^= character == '"'
        depth += (character in "([{") - (character in ")]}")
        if depth == 0 and text.startswith(" for ", place):
            return [text[:place], text[place + 1 :]]
        if character == "," and depth == 0 and not quoted and not re.search(r"\blambda [^:]*$", parts[-1]):
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def _opening(line: str, close: int) -> int:
    depth = 0
    for place in range(close, -1, -1):
        depth += (line[place] == ")") - (line[place] == "(")
        if depth == 0:
            return place
    message = f"unbalanced brackets in {line!r}"
    raise ValueError(message)


def literal(text: str) -> list[str]:
    """A message as adjacent string literals that fit on their lines."""
    parts = [text] if len(text) <= 109 else textwrap.wrap(text, 100, drop_whitespace=False)
    return [f'    "{part}"' for part in parts[:-1]] + [f'    "{parts[-1]}",']
