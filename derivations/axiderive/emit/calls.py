"""How the generated functions are called, as the handbook prints it."""

from __future__ import annotations

from ..contact.systems import Problem
from ..entry import Entry
from .symbols import LETTERS


def imported(problem: Problem) -> str:
    """The import of the module of a problem."""
    folder, _, _ = problem.module.removesuffix(".py").rpartition("/")
    return f"from {folder.replace('/', '.')} import {problem.name}"


def called(problem: Problem, entry: Entry) -> str:
    """The call of the function of an entry: fields by position, parameters by name."""
    fields = [LETTERS.get(symbol, symbol.name) for symbol in entry.quantity.arguments]
    keywords = [LETTERS.get(p, str(getattr(p, "label", p))) for p in entry.parameters]
    arguments = [*fields, *(f"{name}={name}" for name in keywords if name not in fields)]
    return f"{problem.name}.{entry.quantity.function}({', '.join(arguments)})"
