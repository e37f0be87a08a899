"""How the generated functions are called, read off their definitions."""

from __future__ import annotations

import ast
import doctest

from ..contact.systems import Problem
from ..entry import Entry
from .rules import PULL_OFF

Signatures = dict[str, ast.arguments]


def signatures(source: str) -> Signatures:
    """The arguments of every public function of a module."""
    functions = (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef))
    return {node.name: node.args for node in functions if not node.name.startswith("_")}


Values = dict[str, dict[str, str]]
"""Of the arguments, as they are written, by name; of every function, by name."""


def examples(source: str) -> Values:
    """With what the example of every public function of a module calls it."""
    functions = [node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
    return {node.name: _values(node) for node in functions if not node.name.startswith("_")}


def _values(function: ast.FunctionDef) -> dict[str, str]:
    shown = doctest.DocTestParser().get_examples(ast.get_docstring(function) or "")
    calls = [
        node
        for one in shown
        for node in ast.walk(ast.parse(one.source))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == function.name
    ]
    if not calls:
        message = f"{function.name} has no example; a call that runs needs the values of one"
        raise ValueError(message)
    given = dict(zip((one.arg for one in function.args.args), calls[0].args, strict=False))
    given |= {one.arg: one.value for one in calls[0].keywords if one.arg}
    return {name: ast.unparse(value) for name, value in given.items()}


def assigned(entry: Entry, known: Values) -> str:
    """The arguments of the function of an entry with the values of its example, a line each."""
    values = known[entry.quantity.function]
    return "\n".join(f"{name} = {value}" for name, value in values.items() if name != "control")


def imported(problem: Problem) -> str:
    """The import of the module of a problem."""
    folder, _, _ = problem.module.removesuffix(".py").rpartition("/")
    return f"from {folder.replace('/', '.')} import {problem.name}"


def called(problem: Problem, entry: Entry, known: Signatures) -> str:
    """The call of the function of an entry, its arguments by the names they have in print and in the signature."""
    found = known[entry.quantity.function]
    # one function gives pull-off under both controls, and the key says which
    positional = [repr(PULL_OFF[entry.suffix[-1]]) if one.arg == "control" else one.arg for one in found.args]
    keywords = [f"{one.arg}={one.arg}" for one in found.kwonlyargs]
    return f"{problem.name}.{entry.quantity.function}({', '.join([*positional, *keywords])})"
