"""How the generated functions are called, read off their definitions."""

from __future__ import annotations

import ast

from ..contact.systems import Problem
from ..entry import Entry
from .rules import PULL_OFF

Signatures = dict[str, ast.arguments]


def signatures(source: str) -> Signatures:
    """The arguments of every public function of a module."""
    functions = (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef))
    return {node.name: node.args for node in functions if not node.name.startswith("_")}


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
