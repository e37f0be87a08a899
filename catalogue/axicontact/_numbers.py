"""Calls with plain numbers: checked in one condition and evaluated by `math`, past the array machinery.

Checks in a loop and the way through `elementwise` take eight times as long as the formula of the
pressure under a cone; with the condition compiled for the names of a function it is twice as long.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import update_wrapper
from types import CodeType, FunctionType
from typing import Any, TypeVar, cast

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

    def begin() -> None:
        # compiled when first called: a tenth of a millisecond for each function is much for an import
        space["formula"] = _formula(function.__globals__[f"_{function.__name__}"], _names(function.__code__))
        exec(_text(function.__code__), space)  # names of our own functions, no text of anyone else
        call.__code__ = space["call"].__code__

    space: dict[str, Any] = {"function": function, "begin": begin, "LEAST": LEAST, "GREATEST": GREATEST}
    call = FunctionType(_first_call.__code__, space)
    return cast("Function", update_wrapper(call, function))


def _first_call(*fields: Any, **keywords: Any) -> Any:
    begin()  # type: ignore[name-defined]  # noqa: F821 - runs among the names of `with_math`
    return function(*fields, **keywords)  # noqa: F821


def _names(code: CodeType) -> tuple[str, ...]:
    return code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]


def _text(code: CodeType) -> str:
    names = _names(code)
    fields, keywords = names[: code.co_argcount], names[code.co_argcount :]
    ranges = [f"{SMALL} < {name} < {LARGE}" for name in fields]
    ranges += [f"{max(SMALL, INSIDE[name][0])} < {name} < {min(LARGE, INSIDE[name][1])}" for name in keywords]
    ranges += [order for check, order in ORDERS.items() if check in code.co_names]
    return CALL.format(
        signature=", ".join([*fields, *(["*"] if keywords else []), *keywords]),
        types=" is ".join(f"type({name})" for name in names),
        ranges=" and ".join(ranges),
        names=", ".join(names),
        passed=", ".join([*fields, *(f"{name}={name}" for name in keywords)]),
    )


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
