"""Calls with plain numbers: checked in one condition and evaluated by `math`, past the array machinery.

Checks in a loop and the way through `elementwise` take eight times as long as the formula of the pressure
under a cone; with condition and formula compiled into one function it takes one and a half times as long.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import update_wrapper
from types import CodeType, FunctionType
from typing import Any, TypeVar, cast

from ._domain import INSIDE
from ._elementwise import LARGE, SMALL

Function = TypeVar("Function", bound=Callable[..., Any])

CALL = """
def call({signature}):
    if {types} is float and {ranges}:
        try:
{lines}
        except (ArithmeticError, ValueError):
            pass
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
        # compiled when first called: a millisecond for each function is much for an import
        text, names = _text(function.__code__, function.__globals__[f"_{function.__name__}"])
        space.update(names)
        exec(text, space)  # names of our own functions, no text of anyone else
        call.__code__ = space["call"].__code__

    space: dict[str, Any] = {"function": function, "begin": begin}
    call = FunctionType(_first_call.__code__, space)
    return cast("Function", update_wrapper(call, function))


def _first_call(*fields: Any, **keywords: Any) -> Any:
    begin()  # type: ignore[name-defined]  # noqa: F821 - runs among the names of `with_math`
    return function(*fields, **keywords)  # noqa: F821


def _text(code: CodeType, private: FunctionType) -> tuple[str, dict[str, Any]]:
    """The short way before the function, and the names it uses."""
    from ._plain import indented, lines

    names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
    fields, keywords = names[: code.co_argcount], names[code.co_argcount :]
    ranges = dict.fromkeys(fields, (SMALL, LARGE))
    ranges |= {name: (max(SMALL, INSIDE[name][0]), min(LARGE, INSIDE[name][1])) for name in keywords}
    # a third faster than in a chain
    inside = [f"{name} > {low} and {name} < {high}" for name, (low, high) in ranges.items()]
    inside += [order for check, order in ORDERS.items() if check in code.co_names]
    found, space = lines(private, ranges) or (["pass"], {})
    text = CALL.format(
        signature=", ".join([*fields, *(["*"] if keywords else []), *keywords]),
        types=" is ".join(f"{name}.__class__" for name in names),
        ranges=" and ".join(inside),
        lines=indented(found, 3),
        passed=", ".join([*fields, *(f"{name}={name}" for name in keywords)]),
    )
    return text, space
