"""The text of a definition with new names and without dropped parameters and annotations; the rest stays as it was."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Mapping
from typing import TYPE_CHECKING

from .inlining import returned
from .source import Edit, arguments

if TYPE_CHECKING:
    from .linking import Definition, Key, Linker, Module

WIDTH = 110


def rewritten(linker: Linker, definition: Definition, doc: str = "") -> str:
    """The text; `doc` replaces the docstring of a function."""
    return _Rewriting(linker, definition).text(doc)


def _constant(name: str, value: str) -> str:
    """A constant; a table of numbers fills its lines."""
    if "\n" not in value or "#" in value:
        return f"{name} = {value}"
    table = re.sub(r",\s*\)", ")", re.sub(r"\(\s+", "(", re.sub(r"\s+", " ", value)))
    table = re.sub(r"\(([^(), ]+)\)", r"(\1,)", table)
    return textwrap.fill(f"{name} = {table}", WIDTH, subsequent_indent="    ", break_long_words=False)


def documented(doc: str) -> list[str]:
    """The lines of a docstring; a single one that is too long goes on below."""
    if not doc:
        return []
    if "\n" not in doc:
        doc = "\n    ".join(textwrap.wrap(doc, WIDTH))
    return [f'    """{doc}"""']


def _binds_less(value: ast.expr, parent: ast.AST | None) -> bool:
    """Whether an expression needs brackets where a call stood."""
    if not isinstance(value, (ast.BinOp, ast.UnaryOp, ast.IfExp, ast.Compare, ast.Lambda)):
        return False
    if isinstance(parent, ast.BinOp):
        product = isinstance(value, ast.BinOp) and isinstance(value.op, (ast.Mult, ast.Div, ast.Pow))
        return not (product and isinstance(parent.op, (ast.Add, ast.Sub)))
    return not isinstance(parent, (ast.Return, ast.Call, ast.Assign, ast.Lambda, ast.keyword))


class _Rewriting:
    def __init__(self, linker: Linker, definition: Definition, given: Mapping[str, str] | None = None) -> None:
        self.linker, self.definition = linker, definition
        self.given = given or {}
        """What stands for a parameter, where the lines are written in the place of a call."""
        self.module: Module = definition.module
        self.before: list[str] = []
        """Lines that go before the statement being written."""
        self.parents = {
            id(child): parent for parent in ast.walk(definition.node) for child in ast.iter_child_nodes(parent)
        }
        self.keys: dict[int, Key] = {id(node): key for node, key in definition.references()}

    def text(self, doc: str) -> str:
        """The new text of a function, constant or class, the last as a namedtuple; `doc` replaces a docstring."""
        node = self.definition.node
        name = self.linker.names[self.definition.key]
        if isinstance(node, ast.Assign):
            above = [comment.strip() for comment in self._comments(node)]
            note = self.module.notes.get(self.definition.name)
            above += [f"# {note[0].lower() if note[1:2].islower() else note[0]}{note[1:]}"] if note else []
            return "\n".join([*above, _constant(name, self._render(node.value))])
        if isinstance(node, ast.ClassDef):
            rows = [s for s in node.body if isinstance(s, ast.AnnAssign) and isinstance(s.target, ast.Name)]
            fields = " ".join(ast.unparse(row.target) for row in rows)
            given = [self._render(row.value) for row in rows if row.value is not None]
            defaults = f", defaults=[{', '.join(given)}]" if given else ""
            return f'{name} = namedtuple("{name}", "{fields}"{defaults})'
        assert isinstance(node, ast.FunctionDef)
        own = self.linker.dropped[self.definition.key]
        body = list(node.body)
        if ast.get_docstring(node) is not None:
            doc, body = doc or self.module.source(body[0]).strip('"'), body[1:]
        kept = [part for arg, part in zip(node.args.args, self._arguments(node), strict=True) if arg.arg not in own]
        head = f"def {name}({', '.join(kept)}):"
        lines = [head, *documented(doc)]
        for decorator in node.decorator_list:
            lines.insert(0, f"@{ast.unparse(decorator)}")
        for statement in body:
            lines += [*self._comments(statement), *self._statement(statement)]
        return "\n".join(lines)

    def _comments(self, statement: ast.stmt) -> list[str]:
        """Comments right above a statement, and a blank line before a nested function."""
        found: list[str] = []
        line = statement.lineno - 2
        while self.module.lines[line].strip().startswith("#"):
            found.insert(0, "    " + self.module.lines[line].strip())
            line -= 1
        return found

    def _statement(self, statement: ast.stmt) -> list[str]:
        text = ("    " + self._render(statement)).splitlines()
        if isinstance(statement, ast.FunctionDef):
            return ["", *text, ""]
        lines, self.before = [*self.before, *text], []
        return lines

    def _render(self, node: ast.AST) -> str:
        """Source of a node with all edits inside it made."""
        return self.module.edited(self._edits(node), *self.module.span(node))

    def _edits(self, node: ast.AST) -> list[Edit]:
        edits = []
        for child in ast.walk(node):
            if isinstance(child, ast.Call) and self._certain(child):
                value = child.args[1]
                text = self._render(value)
                bracketed = f"({text})" if _binds_less(value, self.parents.get(id(child))) else text
                edits.append((*self.module.span(child), bracketed))
            elif isinstance(child, ast.Lambda) and (name := self._same_as(child)):
                edits.append((*self.module.span(child), name))
            elif isinstance(child, ast.Call) and id(child.func) in self.keys:
                edits += self._call(child)
            elif id(child) in self.keys:
                edits.append((*self.module.span(child), self._name(self.keys[id(child)])))
            elif isinstance(child, ast.Name) and child.id in self.given:
                edits.append((*self.module.span(child), self.given[child.id]))
            elif isinstance(child, ast.FunctionDef):
                edits += self._header(child)
            elif isinstance(child, ast.AnnAssign):
                target, annotation = self.module.span(child.target)[1], self.module.span(child.annotation)[1]
                edits.append((target, annotation, ": float" if child.value is None else ""))
        return edits

    def _certain(self, node: ast.Call) -> bool:
        """Whether this is `np.where(dgamma > 0.0, ...)` of a frozen parameter above zero."""
        if ast.unparse(node.func) != "np.where":
            return False
        known = self.linker.positive & (
            self.linker.dropped[self.definition.key] | (self.linker.frozen - self.definition.bound)
        )
        return ast.unparse(node.args[0]) in {f"{name} > 0.0" for name in known}

    def _same_as(self, node: ast.Lambda) -> str:
        """The function that `lambda t: _slope(t)` is, once nothing else is passed to it."""
        call = node.body
        if not isinstance(call, ast.Call) or call.keywords or id(call.func) not in self.keys:
            return ""
        key = self.keys[id(call.func)]
        given = arguments(call, self.linker.reached[key].parameters if key in self.linker.reached else [])
        own = self.linker.dropped.get(key, frozenset())
        left = [ast.unparse(value) for parameter, value in given.items() if parameter not in own]
        same = left == [arg.arg for arg in node.args.args] and len(given) == len(call.args)
        return self._name(key) if same and key not in self.linker.inlined else ""

    def _name(self, key: Key) -> str:
        return self.linker.names[key]

    def _call(self, call: ast.Call) -> list[Edit]:
        """The call without the arguments that are no longer taken; untouched inside if none is."""
        key = self.keys[id(call.func)]
        if key in self.linker.inlined:
            return [(*self.module.span(call), self._inlined(key, call))]
        own = self.linker.dropped.get(key, frozenset())
        if not own:
            return [(*self.module.span(call.func), self._name(key))]
        parameters = self.linker.reached[key].parameters
        kept = [self._render(value) for p, value in zip(parameters, call.args, strict=False) if p not in own]
        kept += [f"{k.arg}={self._render(k.value)}" for k in call.keywords if k.arg not in own]
        start, end = self.module.span(call)
        text = f"{self._name(key)}({', '.join(kept)})"
        column = start - self.module.starts[call.lineno - 1]
        if column + len(text) > WIDTH + 20 and len(kept) > 1:
            indent = " " * (len(line := self.module.lines[call.lineno - 1]) - len(line.lstrip()))
            text = f"{self._name(key)}(\n" + "".join(f"{indent}    {part},\n" for part in kept) + f"{indent})"
        return [(start, end, text)]

    def _inlined(self, key: Key, call: ast.Call) -> str:
        """The returned expression in place of the call."""
        parts = returned(self.linker.reached[key])
        assert parts is not None
        assignments, value = parts
        definition = self.linker.reached[key]
        passed = arguments(call, definition.parameters)
        given = {p: self._render(v) for p, v in passed.items() if p not in self.linker.dropped[key]}
        callee = _Rewriting(self.linker, definition, {p: text for p, text in given.items() if p != text})
        for assignment in assignments:
            self.before += [*callee._comments(assignment), *callee._statement(assignment)]
        text = callee._render(value)
        self.before += callee.before
        if name := self.linker.inlined[key]:
            self.before.append(f"    {name} = {text}")
            return name
        return f"({text})" if _binds_less(value, self.parents.get(id(call))) else text

    def _header(self, node: ast.FunctionDef) -> list[Edit]:
        """A nested function without annotations."""
        start = self.module.span(node)[0]
        end = self.module.bytes.index(b":\n", self._header_end(node)) + 1
        return [(start, end, f"def {node.name}({', '.join(self._arguments(node))}):")]

    def _arguments(self, node: ast.FunctionDef) -> list[str]:
        """Names with their defaults."""
        names = [arg.arg for arg in node.args.args]
        values = [None] * (len(names) - len(node.args.defaults)) + list(node.args.defaults)
        return [n if v is None else f"{n}={self._render(v)}" for n, v in zip(names, values, strict=True)]

    def _header_end(self, node: ast.FunctionDef) -> int:
        parts = [node.returns, *(arg.annotation for arg in node.args.args)]
        return max([self.module.span(part)[1] for part in parts if part is not None] or [self.module.span(node)[0]])
