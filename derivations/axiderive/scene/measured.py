"""The emitted module run against its check values."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from ..exits import FAILED, CommandError
from . import interface
from .check import Value
from .contact import Contact
from .detaching import State, detached

if TYPE_CHECKING:
    from .request import Request

LARGEST_ERROR = 1e-6


class RuleError(CommandError, ArithmeticError):
    """The module is off by more than any rule may be."""

    code = FAILED


@dataclass(frozen=True)
class Run:
    """What running a module says."""

    values: list[Value]
    """With the keywords each function really has."""
    errors: dict[str, float]
    """The worst relative deviation of every function."""
    detached: dict[str, State]
    """The states in which a contact with adhesion breaks, by what is held."""


def measured(text: str, values: Sequence[Value], request: Request, free: Mapping[str, float], contact: Contact) -> Run:
    """Run the text of a module against its check values.

    Raises
    ------
    RuleError
        If a value is off by more than any rule may be.
    """
    space: dict[str, Any] = {"__name__": request.module.removesuffix(".py")}
    exec(compile(text, request.module, "exec"), space)  # text of our own making
    errors: dict[str, float] = {}
    states = _states(space, contact, free, errors) if interface.PULL_OFF in request.quantities else {}
    called = []
    for value in values:
        function = space[value.function]
        code = inspect.unwrap(function).__code__
        names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        own = replace(value, keywords=tuple((k, v) for k, v in value.keywords if k in names))
        got = function(*own.fields, **dict(own.keywords))
        _compare(errors, own.function, f"{own.function}{own.fields}", got, own.wanted)
        called.append(own)
    return Run(called, errors, states)


def _compare(errors: dict[str, float], name: str, call: str, got: float, wanted: float) -> None:
    error = abs(got - wanted) / abs(wanted) if wanted else abs(got)
    if not error <= LARGEST_ERROR:
        message = (
            f"{call} gives {got!r} instead of {wanted!r}; nothing was written: the rules "
            "hold for pieces that are smooth in r, use whole powers in them"
        )
        raise RuleError(message)
    errors[name] = max(errors.get(name, 0.0), error)


def _states(
    space: Mapping[str, Any], contact: Contact, free: Mapping[str, float], errors: dict[str, float]
) -> dict[str, State]:
    """The states of pull-off by the definitions, next to those that the module finds."""
    found = {}
    for control in ("force", "depth"):
        state = space[interface.PULL_OFF](control, **free)
        wanted = detached(contact, control, state.radius) if state.radius > 0.0 else None
        if wanted is not None:
            found[control] = wanted
            for field, got, value in zip(state._fields, state, wanted, strict=True):
                _compare(errors, interface.PULL_OFF, f"pull_off({control!r}).{field}", got, value)
    return found
