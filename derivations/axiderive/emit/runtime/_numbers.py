"""Calls with plain numbers: checked in one condition and evaluated by `math`, past the array machinery.

Checks in a loop and the way through `elementwise` take eight times as long as the formula of the
pressure under a cone; with the condition compiled for the names of a function it is twice as long.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, wraps
from types import CodeType
from typing import Any, TypeVar

from ._domain import INSIDE
from ._elementwise import GREATEST, LARGE, LEAST, SMALL
from ._scalar import scalar

Function = TypeVar("Function", bound=Callable[..., Any])

CALL = """
def call({signature}):
    if {types} is float and {ranges}:
        try:
            value = formula({names})
        except (ArithmeticError, ValueError):
            value = 0.0
        if LEAST < value < GREATEST or LEAST < -value < GREATEST:
            return value
    return function({passed})
"""
ORDERS = {"require_reach": "b <= a"}
"""What a check of two parameters asks of plain numbers."""


def with_math(function: Function) -> Function:
    """The function, with a short way for floats of ordinary size inside their domains.

    The formula is the private function of the same name.  Whatever is wrong, not a float or far out is left
    to the function itself: so are results that may have left the range of doubles on the way.
    """
    code = function.__code__
    fields, names = code.co_varnames[: code.co_argcount], code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
    keywords = names[len(fields) :]
    ranges = [f"{SMALL} < {name} < {LARGE}" for name in fields]
    ranges += [f"{max(SMALL, INSIDE[name][0])} < {name} < {min(LARGE, INSIDE[name][1])}" for name in keywords]
    ranges += [order for check, order in ORDERS.items() if check in code.co_names]
    space: dict[str, Any] = {"function": function, "LEAST": LEAST, "GREATEST": GREATEST}

    def first(*numbers: float) -> float:
        space["formula"] = formula = _formula(function.__globals__[f"_{function.__name__}"], names)
        return formula(*numbers)

    space["formula"] = first
    text = CALL.format(
        signature=", ".join([*fields, *(["*"] if keywords else []), *keywords]),
        types=" is ".join(f"type({name})" for name in names),
        ranges=" and ".join(ranges),
        names=", ".join(names),
        passed=", ".join([*fields, *(f"{name}={name}" for name in keywords)]),
    )
    exec(_compiled(text), space)  # the names of our own functions, no text of anyone else
    return wraps(function)(space["call"])  # type: ignore[return-value]


@cache
def _compiled(text: str) -> CodeType:
    """A tenth of a millisecond each; functions of the same arguments share it."""
    return compile(text, "<call with plain numbers>", "exec")


def _formula(private: Callable[..., Any], names: tuple[str, ...]) -> Callable[..., float]:
    """The private function over the numbers of the public one; always 0 where it needs arrays."""
    plain = scalar(private)
    if plain is None:
        return lambda *numbers: 0.0
    wanted = private.__code__.co_varnames[: private.__code__.co_argcount]
    if wanted == names:
        return plain
    places = [names.index(name) for name in wanted]
    return lambda *numbers: plain(*(numbers[place] for place in places))
