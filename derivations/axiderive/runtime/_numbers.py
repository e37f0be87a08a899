"""Calls with plain numbers: checked in one condition and evaluated by `math`, past the array machinery.

Checks in a loop and the way through `elementwise` take eight times as long as the formula of the pressure
under a cone; with condition and formula compiled into one function it takes one and a half times as long.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import update_wrapper
from types import FunctionType
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])


def with_math(function: Function) -> Function:
    """The function, with a short way for floats of ordinary size inside their domains.

    The formula is the private function of the same name.  Whatever is wrong, not a float or far out is left
    to the function itself: so are results that may have left the range of doubles on the way.
    """

    def begin() -> None:
        # compiled when first called: a millisecond for each function is much for an import
        from ._calls import call_text

        text, names = call_text(function.__code__, function.__globals__[f"_{function.__name__}"])
        space.update(names)
        exec(text, space)  # names of our own functions, no text of anyone else
        call.__code__ = space["call"].__code__

    space: dict[str, Any] = {"function": function, "begin": begin}
    call = FunctionType(_first_call.__code__, space)
    return cast("Function", update_wrapper(call, function))


def _first_call(*fields: Any, **keywords: Any) -> Any:
    begin()  # type: ignore[name-defined]  # noqa: F821 - runs among the names of `with_math`
    return function(*fields, **keywords)  # noqa: F821
