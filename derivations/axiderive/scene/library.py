"""Generated modules as a library of definitions: what each one is, and what the names in it refer to."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

Key = tuple[str, str]
"""Module and name."""


@dataclass(frozen=True, eq=False)
class Definition:
    """A function, class or constant at the top of a module, with its text."""

    module: Module
    name: str
    node: ast.stmt

    @property
    def key(self) -> Key:
        return self.module.name, self.name

    @property
    def function(self) -> ast.FunctionDef | None:
        return self.node if isinstance(self.node, ast.FunctionDef) else None

    @property
    def parameters(self) -> list[str]:
        return [arg.arg for arg in self.function.args.args] if self.function else []

    @cached_property
    def bound(self) -> frozenset[str]:
        """Names bound anywhere inside: they do not refer to the module."""
        if self.function is None:
            return frozenset()
        found = {node.arg for node in ast.walk(self.node) if isinstance(node, ast.arg)} | self.stored
        return frozenset(found | {n.name for n in ast.walk(self.node) if isinstance(n, ast.FunctionDef)} - {self.name})

    @cached_property
    def stored(self) -> frozenset[str]:
        """Names that are given a value inside; a parameter among them is no longer what was passed."""
        names = (node for node in ast.walk(self.node) if isinstance(node, ast.Name))
        return frozenset(node.id for node in names if isinstance(node.ctx, ast.Store))

    def references(self) -> Iterator[tuple[ast.expr, Key]]:
        """Names inside that refer to definitions, annotations left out."""
        skipped = _annotations(self.node)
        for node in ast.walk(self.node):
            if id(node) in skipped:
                continue
            if isinstance(node, ast.Name) and node.id not in self.bound:
                key = self.module.resolve(node.id)
                if key is not None:
                    yield node, key
            elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                alias = self.module.aliases.get(node.value.id)
                if alias is not None:
                    yield node, (alias, node.attr)


@dataclass(eq=False)
class Module:
    """One module, parsed."""

    name: str
    text: str
    definitions: dict[str, Definition] = field(default_factory=dict)
    imported: dict[str, Key] = field(default_factory=dict)
    aliases: dict[str, str] = field(default_factory=dict)
    notes: dict[str, str] = field(default_factory=dict)
    """What the text under a constant says of it."""

    def __post_init__(self) -> None:
        self.text = _with_imports_outside(self.text)
        tree = ast.parse(self.text)
        self.lines = self.text.splitlines(keepends=True)
        self.starts = [0]
        for line in self.lines:
            self.starts.append(self.starts[-1] + len(line.encode()))
        self.bytes = self.text.encode()
        for node, below in zip(tree.body, [*tree.body[1:], None], strict=True):
            self._define(node)
            match node, below:
                case ast.Assign(targets=[ast.Name(id=name)]), ast.Expr(value=ast.Constant(value=str(note))):
                    self.notes[name] = note.splitlines()[0].rstrip(".")

    def _define(self, node: ast.stmt) -> None:
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                self.definitions[name] = Definition(self, name, node)
            case ast.Assign(targets=[ast.Name(id=name)]):
                self.definitions[name] = Definition(self, name, node)
            case ast.Assign(targets=[ast.Tuple(elts=elements)], value=ast.Tuple(elts=values)):
                for element, value in zip(elements, values, strict=True):
                    if isinstance(element, ast.Name):
                        single = ast.copy_location(ast.Assign(targets=[element], value=value), node)
                        self.definitions[element.id] = Definition(self, element.id, single)
            case ast.ImportFrom(module="normal", level=level, names=[ast.alias(name=name, asname="normal")]):
                self.aliases["normal"] = ".".join([*self.name.split(".")[:-level], "normal", name])
            case ast.ImportFrom(module=source, level=level, names=names) if level and source:
                for alias in names:
                    self.imported[alias.asname or alias.name] = (source, alias.name)

    def resolve(self, name: str) -> Key | None:
        if name in self.definitions:
            return self.name, name
        return self.imported.get(name)

    def span(self, node: Any) -> tuple[int, int]:
        """First and last byte of a node, decorators of a function included."""
        first = min([node, *getattr(node, "decorator_list", [])], key=lambda n: n.lineno)
        column = 0 if first is not node else node.col_offset
        end = self.starts[node.end_lineno - 1] + node.end_col_offset
        return self.starts[first.lineno - 1] + column, end

    def source(self, node: Any) -> str:
        start, end = self.span(node)
        return self.bytes[start:end].decode()


def _with_imports_outside(text: str) -> str:
    """The text with what functions import from the package behind it, where it is read as an import of the module."""
    lines, moved = text.splitlines(keepends=True), []
    for function in (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)):
        for node in ast.walk(function):
            if isinstance(node, ast.ImportFrom) and node.level and node.end_lineno:
                moved.append(ast.unparse(node) + "\n")
                blank = node.end_lineno < len(lines) and not lines[node.end_lineno].strip()
                lines[node.lineno - 1 : node.end_lineno + blank] = [""] * (node.end_lineno + blank - node.lineno + 1)
    return "".join([*lines, *moved])


def _annotations(node: ast.AST) -> set[int]:
    """Nodes that only the type checker reads."""
    found: set[int] = set()
    for inner in ast.walk(node):
        for name in ("annotation", "returns"):
            part = getattr(inner, name, None)
            if part is not None:
                found |= {id(n) for n in ast.walk(part)}
    return found
