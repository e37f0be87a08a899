"""The text of a tree, laid out as the formatter of the project lays it out."""

from __future__ import annotations

import ast
import json
import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence

from ...code.function import fit
from .library import documentation, source, text_in

WIDTH = 110
NEGATIVE = re.compile(r"\*\* \((-[\w.]+)\)")
SIMPLE = re.compile(r"(?<![\w.])([A-Za-z_][\w.]*|[\d.]+(?:e-?\d+)?) \*\* (-?[\w.]+(?:e-\d+)?)(?![\w.(\[])")
"""A power of which both sides are a name or a number has no spaces."""
SLICE = re.compile(r"\[:(?=\w+\()")


def written(node: ast.AST, names: Mapping[str, str]) -> str:
    """The text of a tree, with names for the keys of the library; longer than a line where it is."""
    text = source(_Written(names).visit(node))
    return SLICE.sub("[: ", SIMPLE.sub(r"\1**\2", NEGATIVE.sub(r"** \1", text)))


class _Written(ast.NodeTransformer):
    """What `ast.unparse` writes in another way than a person stands as a name in the tree."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """The name for a key."""
        return ast.Name(self.names[node.id]) if ":" in node.id else node

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        """Texts in double quotes, numbers as they were written."""
        if isinstance(node.value, str):
            return ast.Name(json.dumps(node.value, ensure_ascii=False))
        return ast.Name(node.kind) if node.kind else node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """What is generated has the brackets of the call."""
        self.generic_visit(node)
        if len(node.args) == 1 and not node.keywords and isinstance(node.args[0], ast.GeneratorExp):
            node.args = [ast.Name(source(node.args[0])[1:-1])]
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """With the brackets that the source has."""
        node.left, node.right = map(self._bracketed, (node.left, node.right))
        return node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """The same."""
        node.operand = self._bracketed(node.operand)
        return node

    def _bracketed(self, node: ast.expr) -> ast.expr:
        kept = isinstance(node, ast.BinOp) and getattr(node, "bracketed", False)
        node = self.visit(node)
        return ast.Name(f"({source(node)})") if kept else node

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.Name:
        """In double quotes."""
        return ast.Name(f'f"{"".join(map(self._part, node.values))}"')

    def _part(self, part: ast.expr) -> str:
        """A text, or a value with what says how it is written."""
        if not isinstance(part, ast.FormattedValue):
            return json.dumps(ast.literal_eval(part), ensure_ascii=False)[1:-1]
        shape = f"!{chr(part.conversion)}" if part.conversion > 0 else ""
        if isinstance(part.format_spec, ast.JoinedStr):
            shape += ":" + "".join(map(self._part, part.format_spec.values))
        # before Python 3.12 a text inside has other quotes
        return "{" + source(self.visit(part.value)).replace('"', "'") + shape + "}"

    def visit_Expr(self, node: ast.Expr) -> ast.AST:
        """A line of comment, or a docstring."""
        text = text_in(node)
        if text:
            return ast.Expr(ast.Name(text if text.startswith("#") else f'"""{text}"""'))
        return self.generic_visit(node)

    def visit_Return(self, node: ast.Return) -> ast.AST:
        """Several values without brackets."""
        self.generic_visit(node)
        node.value = _listed(node.value) if node.value else None
        return node

    def visit_Assign(self, node: ast.Assign) -> ast.AST:
        """The same where they are unpacked."""
        self.generic_visit(node)
        if isinstance(node.targets[0], ast.Tuple):
            node.targets, node.value = [*map(_listed, node.targets)], _listed(node.value)
        return node

    def _unpacking(self, node: ast.For | ast.comprehension) -> ast.AST:
        self.generic_visit(node)
        node.target = _listed(node.target)
        return node

    visit_For = visit_comprehension = _unpacking


def _listed(node: ast.expr) -> ast.expr:
    """A tuple without the brackets that some versions of Python write; on several lines it needs them."""
    if isinstance(node, ast.Tuple) and len(node.elts) > 1:
        text = ", ".join(map(source, node.elts))
        return ast.Name(text if len(text) < WIDTH else f"({text})")
    return node


def constant_text(name: str, value: ast.expr, names: Mapping[str, str]) -> str:
    """A constant; a table of numbers fills its lines."""
    line = f"{name} = {written(value, names)}"
    if isinstance(value, ast.Tuple) and len(line) > WIDTH:
        return textwrap.fill(line, WIDTH, subsequent_indent="    ", break_long_words=False)
    if isinstance(value, ast.Call) and len(line) > WIDTH:
        given = (f"    {one}," for one in _given(value, names))
        return "\n".join([f"{name} = {written(value.func, names)}(", *given, ")"])
    return "\n".join(fit(line, 0))


def _given(call: ast.Call, names: Mapping[str, str]) -> list[str]:
    """The arguments of a call, as they stand in it."""
    return [*(written(one, names) for one in call.args), *(f"{k.arg}={written(k.value, names)}" for k in call.keywords)]


def class_text(name: str, node: ast.ClassDef, names: Mapping[str, str]) -> str:
    """A class of fields, as a namedtuple."""
    rows = [s for s in node.body if isinstance(s, ast.AnnAssign)]
    fields = " ".join(ast.unparse(row.target) for row in rows)
    given = [written(row.value, names) for row in rows if row.value is not None]
    defaults = f", defaults=[{', '.join(given)}]" if given else ""
    return "\n".join(fit(f'{name} = namedtuple("{name}", "{fields}"{defaults})', 0))


def function_text(head: Sequence[str], node: ast.FunctionDef, names: Mapping[str, str], doc: str = "") -> str:
    """A function below the lines of its head; `doc` replaces its docstring."""
    own = documentation(node)
    body = node.body[1:] if own else node.body
    text = written(ast.Module(body=body, type_ignores=[]), names)
    above, lines = documented(doc or own), [*_laid_out(text)]
    return "\n".join([*head, *above, *(lines if above or lines[0] else lines[1:])])


def function_head(name: str, node: ast.FunctionDef, names: Mapping[str, str]) -> list[str]:
    """Decorators and the line of `def`."""
    return [*marks(node, names), *fit(f"def {name}({written(node.args, names)}):", 0)]


def marks(node: ast.stmt, names: Mapping[str, str]) -> list[str]:
    """The decorators of a function."""
    return [f"@{written(mark, names)}" for mark in node.decorator_list] if isinstance(node, ast.FunctionDef) else []


def documented(doc: str) -> list[str]:
    """The lines of a docstring; a single one that is too long goes on below."""
    if not doc:
        return []
    if "\n" not in doc:
        doc = "\n    ".join(textwrap.wrap(doc, WIDTH))
    return [f'    """{doc}"""']


def _laid_out(text: str) -> Iterator[str]:
    """The lines of a body, with a blank one before and behind a function inside it and its marks."""
    inside, marked = list[int](), False
    for line in filter(None, text.split("\n")):
        indent = len(line) - len(line.lstrip()) + 4
        apart, marked = line.lstrip().startswith(("def ", "@")) and not marked, line.lstrip().startswith("@")
        while inside and indent <= inside[-1]:
            inside.pop()
            apart = True
        if apart:
            yield ""
        if line.lstrip().startswith("def "):
            inside.append(indent)
        yield from (" " * indent + part for part in fit(line.lstrip(), indent))
