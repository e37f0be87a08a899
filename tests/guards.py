"""The refusals of the prover, found in its source, and the prover without one of them.

A refusal is a condition that ends in a raise, a call for nothing but its refusal, or the raise at the end of a
function that found no answer.
"""

from __future__ import annotations

import ast
import importlib.util
import inspect
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FunctionType, ModuleType
from typing import Any

from axiderive.proof import certificate

MODULES = (
    "certificate", "frame", "compact", "complete", "adhesive", "superposed", "viscoelastic",
    "plane", "rings", "loads", "materials", "statement", "identity", "functions", "tower",
    "domain", "graded", "special",
)  # fmt: skip
ROOMS = ("axiderive.proof", "axiderive.proof.rules", "axiderive.proof.algebra")
"""What certificates are made of, and where."""


LENGTH = 60
"""How much of a message or of a call the name of a guard holds."""


@dataclass(frozen=True)
class Guard:
    """The refusal that stands at one place of a function; its name ends in what it says, or in what it asks for."""

    name: str
    module: str
    function: str
    line: int


def _module(name: str) -> ModuleType:
    room = next(one for one in ROOMS if importlib.util.find_spec(f"{one}.{name}"))
    return importlib.import_module(f"{room}.{name}")


def _raises(node: ast.stmt) -> bool:
    return isinstance(node, ast.Raise) and "NotProvedError" in ast.unparse(node)


def _refuses(node: ast.AST) -> bool:
    if isinstance(node, ast.If):
        return _raises(node.body[-1])
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        called = ast.unparse(node.value.func).rpartition(".")[2]
        return called.lstrip("_").startswith("require") or called == "on_both_sides"
    return False


def _text(function: ast.FunctionDef, refusal: ast.stmt) -> str:
    """The message without its values, or the call with two arguments where it is another's."""
    if isinstance(refusal, ast.Expr) and isinstance(refusal.value, ast.Call):
        if ast.unparse(refusal.value.func) == "require":
            return ast.literal_eval(refusal.value.args[1]).replace("{}", "...")
        return f"{ast.unparse(refusal.value.func)}({', '.join(map(ast.unparse, refusal.value.args[:2]))})"
    body = refusal.body if isinstance(refusal, ast.If) else function.body
    said = body[-2].value if isinstance(body[-2], ast.Assign) else None
    parts = said.values if isinstance(said, ast.JoinedStr) else [said]
    return "".join(part.value if isinstance(part, ast.Constant) else "..." for part in parts)


def _functions(body: list[ast.stmt], owner: str = "") -> Iterator[tuple[str, ast.FunctionDef]]:
    for node in body:
        if isinstance(node, ast.ClassDef):
            yield from _functions(node.body, f"{owner}{node.name}.")
        elif isinstance(node, ast.FunctionDef):
            yield owner + node.name, node


def found() -> Iterator[Guard]:
    """Every refusal of the modules; those of an inner function belong to the outer one."""
    for module in MODULES:
        tree = ast.parse(inspect.getsource(_module(module)))
        for function, node in _functions(tree.body):
            if function == "require":
                # which refuses what another one asks for
                continue
            inner = [each for each in ast.walk(node) if isinstance(each, ast.stmt) and _refuses(each)]
            inner += [node.body[-1]] if _raises(node.body[-1]) else []
            for each in sorted(inner, key=lambda stmt: stmt.lineno):
                yield Guard(f"{module}.{function}: {_text(node, each)[:LENGTH].strip()}", module, function, each.lineno)


class _Without(ast.NodeTransformer):
    def __init__(self, line: int) -> None:
        self.line = line

    def generic_visit(self, node: ast.AST) -> ast.AST:
        if isinstance(node, ast.stmt) and node.lineno == self.line and (_refuses(node) or _raises(node)):
            if isinstance(node, ast.If):
                # a further branch is still asked for
                node.body = [ast.copy_location(ast.Pass(), node)]
                return node
            return ast.copy_location(ast.Pass(), node)
        return super().generic_visit(node)


def _defined(module: ModuleType, function: str, source: ast.Module) -> Any:
    """The function as the source defines it, in the names of its module."""
    (node,) = (each for name, each in _functions(source.body) if name == function)
    space: dict[str, Any] = {}
    alone = ast.Module(
        body=[ast.ImportFrom(module="__future__", names=[ast.alias(name="annotations")], level=0), node],
        type_ignores=[],
    )
    exec(compile(ast.fix_missing_locations(alone), module.__file__ or "", "exec"), module.__dict__, space)
    return space[node.name]


def _plain(function: Any) -> FunctionType:
    found: FunctionType = inspect.unwrap(getattr(function, "__func__", function))
    return found


@contextmanager
def replaced(module: str, function: str, source: ast.Module) -> Iterator[None]:
    """A function of the prover runs as the source defines it, wherever it was imported or stands in a table."""
    space = _module(module)
    own: Any = space
    for name in function.split("."):
        own = inspect.getattr_static(own, name)
    target = _plain(own)
    before = target.__code__
    target.__code__ = _plain(_defined(space, function, source)).__code__
    certificate._derived.cache_clear()
    try:
        yield
    finally:
        target.__code__ = before
        certificate._derived.cache_clear()


def without(guard: Guard) -> Any:
    """The prover without one refusal."""
    tree = ast.parse(inspect.getsource(_module(guard.module)))
    (node,) = (each for name, each in _functions(tree.body) if name == guard.function)
    _Without(guard.line).visit(node)
    return replaced(guard.module, guard.function, tree)


def altered(module: str, function: str, old: str, new: str) -> Any:
    """The prover with another text at one place of a function."""
    source = inspect.getsource(_module(module))
    tree = ast.parse(source)
    (node,) = (each for name, each in _functions(tree.body) if name == function)
    lines = source.splitlines(keepends=True)
    start = sum(map(len, lines[: node.lineno - 1]))
    stop = sum(map(len, lines[: node.end_lineno]))
    assert source[start:stop].count(old) == 1, f"{old} stands once in {module}.{function}"
    text = source[:start] + source[start:stop].replace(old, new) + source[stop:]
    return replaced(module, function, ast.parse(text))
