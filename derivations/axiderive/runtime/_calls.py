"""Text of the short way for plain numbers: condition and formula of one function, to be compiled."""

from __future__ import annotations

from types import CodeType, FunctionType
from typing import Any

from ._elementwise import LARGE, SMALL
from ._intervals import INSIDE
from ._plain import indented, lines

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


def call_text(code: CodeType, private: FunctionType) -> tuple[str, dict[str, Any]]:
    """The short way before the function, and the names it uses."""
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
