"""What a formula can reach: powers of two between which every operation stays, from those of the arguments.

Where all of them are known to be ordinary numbers or exactly zero, nothing can have left the range of doubles.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from .graph import Node

RANGE = 1000
"""Doubles are normal from 2**-1022 to 2**1024."""
DIGITS = 53


class Bound(NamedTuple):
    """A number is zero or 2**low <= abs(x) <= 2**high; `sign` is 0 where it may have either."""

    low: int
    high: int
    sign: int = 1
    zero: bool = False


Rule = Callable[..., "Bound | None"]


def bounds(nodes: list[Node], ranges: Mapping[str, tuple[float, float]]) -> dict[Node, Bound | None]:
    """The bound of every node, None where there is none, as for an argument whose range has zero inside."""
    found: dict[Node, Bound | None] = {}
    for node in nodes:
        found[node] = bound = _bound(node, found, ranges)
        if bound is not None and not -RANGE <= bound.low <= bound.high <= RANGE:
            found[node] = None
    return found


def _bound(node: Node, found: Mapping[Node, Bound | None], ranges: Mapping[str, tuple[float, float]]) -> Bound | None:
    if node.logical:
        return None
    if node.name == "number":
        return _number(float(node.value or 0.0))
    if node.name == "argument":
        low, high = ranges[str(node.value)]
        return Bound(math.frexp(low)[1] - 1, math.frexp(high)[1]) if low > 0.0 else None
    if node.name == "power":
        return _power(found[node.operands[0]], node.operands[1])
    known = [found[x] for x in node.operands if not x.logical]
    rule = RULES.get(node.name)
    return None if rule is None or None in known else rule(*known)


def _number(x: float) -> Bound | None:
    if not math.isfinite(x):
        return None
    if x == 0.0:
        return Bound(0, 0, 1, True)
    exponent = math.frexp(x)[1]
    return Bound(exponent - 1, exponent, -1 if x < 0.0 else 1)


def _add(x: Bound, y: Bound) -> Bound:
    if x.sign == y.sign != 0:
        low = max([z.low for z in (x, y) if not z.zero], default=min(x.low, y.low))
        return Bound(low, max(x.high, y.high) + 1, x.sign, x.zero and y.zero)
    # both are multiples of the last digit of the smaller one, and so is what is left of them
    return Bound(min(x.low, y.low) - DIGITS, max(x.high, y.high) + 1, 0, True)


def _negative(x: Bound) -> Bound:
    return x._replace(sign=-x.sign)


def _multiply(x: Bound, y: Bound) -> Bound:
    return Bound(x.low + y.low, x.high + y.high, x.sign * y.sign, x.zero or y.zero)


def _divide(x: Bound, y: Bound) -> Bound:
    # of a division by zero Python says so
    return Bound(x.low - y.high, x.high - y.low, x.sign * y.sign, x.zero)


def _power(x: Bound | None, y: Node) -> Bound | None:
    if x is None or y.name != "number" or not (x.sign == 1 or float(y.value or 0.0).is_integer()):
        return None
    exponent = float(y.value or 0.0)
    ends = sorted((exponent * x.low, exponent * x.high))
    sign = 1 if x.sign == 1 or exponent % 2.0 == 0.0 else x.sign
    return None if exponent <= 0.0 else Bound(math.floor(ends[0]) - 1, math.ceil(ends[1]) + 1, sign, x.zero)


def _root(degree: int) -> Callable[[Bound], Bound]:
    return lambda x: Bound(x.low // degree - 1, -(-x.high // degree) + 1, x.sign, x.zero)


def _either(x: Bound, y: Bound) -> Bound:
    sign = x.sign if x.sign == y.sign else 0
    return Bound(min(x.low, y.low), max(x.high, y.high), sign, x.zero or y.zero)


def _slow(highest: int) -> Rule:
    """An odd function between x/2 and 2 x near zero that grows and stays below 2**highest."""
    return lambda x: Bound(min(x.low, 0) - 1, min(x.high + 1, highest), x.sign, x.zero)


def _log1p(x: Bound) -> Bound:
    return Bound(min(x.low, 0) - 1, 10, x.sign, x.zero)


def _log(x: Bound) -> Bound | None:
    return Bound(-DIGITS - 1, 10, 0, True) if x.sign == 1 else None


def _arctan2(y: Bound, x: Bound) -> Bound:
    return Bound(min(y.low - x.high, 0) - 1, 2, y.sign, y.zero)


def _tan(x: Bound) -> Bound | None:
    # up to 2, beyond its pole; next to that no double comes closer than 2**-54
    return Bound(min(x.low, 0), 55, 0, x.zero) if x.high <= 1 else None


def _sin(x: Bound) -> Bound | None:
    return Bound(x.low - 2, 0, x.sign, x.zero) if x.high <= 1 else None


def _cos(x: Bound) -> Bound | None:
    return Bound(-1, 0) if x.high <= 0 else None


def _exponential(x: Bound, odd: bool) -> Bound | None:
    if x.high > 9:
        return None
    return Bound(min(x.low, 0) - 1, 740, x.sign, x.zero) if odd else Bound(-740, 740)


RULES: dict[str, Rule] = {
    "add": _add,
    "subtract": lambda x, y: _add(x, _negative(y)),
    "negative": _negative,
    "absolute": lambda x: x._replace(sign=1),
    "multiply": _multiply,
    "divide": _divide,
    "square": lambda x: _multiply(x, x)._replace(sign=1),
    "sqrt": lambda x: _root(2)(x)._replace(sign=1),
    "cbrt": _root(3),
    "where": _either,
    "unless": lambda x: x,
    "minimum": _either,
    "maximum": _either,
    "tan": _tan,
    "sin": _sin,
    "cos": _cos,
    "arcsinh": _slow(10),
    "arctan": _slow(1),
    "tanh": _slow(0),
    "arctan2": _arctan2,
    "log": _log,
    "log1p": _log1p,
    "exp": lambda x: _exponential(x, odd=False),
    "cosh": lambda x: _exponential(x, odd=False),
    "expm1": lambda x: _exponential(x, odd=True),
    "sinh": lambda x: _exponential(x, odd=True),
}
