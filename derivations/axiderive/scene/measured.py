"""The emitted module run against its check values."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ..exits import FAILED, CommandError
from . import interface
from .check import Value

if TYPE_CHECKING:
    from .request import Request

LARGEST_ERROR = 1e-6


class RuleError(CommandError, ArithmeticError):
    """The module is off by more than any rule may be."""

    code = FAILED


def measured(
    text: str, values: Sequence[Value], request: Request, free: Mapping[str, float]
) -> tuple[list[Value], dict[str, float]]:
    """The values with the keywords each function really has, and its worst relative deviation, found by running it.

    Raises
    ------
    RuleError
        If a value is off by more than any rule may be.
    """
    space: dict[str, Any] = {"__name__": request.module.removesuffix(".py")}
    exec(compile(text, request.module, "exec"), space)  # text of our own making
    if interface.PULL_OFF in request.quantities:
        for control in ("force", "depth"):
            space[interface.PULL_OFF](control, **free)
    errors: dict[str, float] = {}
    called = []
    for value in values:
        function = space[value.function]
        code = inspect.unwrap(function).__code__
        names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        own = replace(value, keywords=tuple((k, v) for k, v in value.keywords if k in names))
        got = function(*own.fields, **dict(own.keywords))
        error = abs(got - own.wanted) / abs(own.wanted) if own.wanted else abs(got)
        if not error <= LARGEST_ERROR:
            message = (
                f"{own.function}{own.fields} gives {got!r} instead of {own.wanted!r}; nothing was written: the rules "
                "hold for pieces that are smooth in r, use whole powers in them"
            )
            raise RuleError(message)
        errors[own.function] = max(errors.get(own.function, 0.0), error)
        called.append(own)
    return called, errors
