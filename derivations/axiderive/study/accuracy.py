"""Emitted and naive values at points in double precision, against Arb enclosures of the same closed form."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from ..entry import Entry
from ..proof.balls import NotAvailableError, enclose_value
from ..proof.quadrature import inverse
from .given import Function
from .naive import naive
from .report import relative
from .special_functions import Array
from .subject import emitted, entries

Point = dict[sp.Symbol, float]
DIGITS = 22
"""Of the reference: six more than a double has."""


@dataclass(frozen=True)
class Judged:
    """One value: relative error, and error in units of the last place; infinite where it is no finite number."""

    relative: float
    ulps: float

    @property
    def lost(self) -> bool:
        return math.isinf(self.ulps)


def reference(problem: str, suffix: str, point: Point) -> mp.mpf | None:
    """The exact value, or None where no region holds the point, no enclosure is found, or no double is normal."""
    known = entries(problem)
    entry = known[suffix]
    try:
        if entry.status == "root":
            value = _at_root(known, suffix, point)
        else:
            value = enclose_value(_region(entry, point), _exact(point), DIGITS)
    except (LookupError, NotAvailableError):
        return None
    return value if sys.float_info.min <= abs(value) <= sys.float_info.max else None


def _exact(point: Point) -> dict[Any, Any]:
    return {symbol: sp.Rational(value) for symbol, value in point.items()}


def _region(entry: Entry, point: Point) -> sp.Expr:
    """The formula that holds at the point; doubles are compared as they are."""
    for case in entry.cases:
        sizes = [point[x] for x in case.chain if x in point]
        if all(low < high for low, high in zip(sizes, sizes[1:], strict=False)):
            return case.expr
    message = f"{entry.key}: no region holds the point"
    raise LookupError(message)


def _at_root(known: dict[str, Entry], suffix: str, point: Point) -> mp.mpf:
    """The inverse, near the radius of the point, at the double that is its argument."""
    with mp.workdps(3 * DIGITS):
        exact = {symbol: mp.mpf(value) for symbol, value in point.items()}
        return inverse(known, suffix, exact, DIGITS)


def judged(problem: str, suffix: str, points: Sequence[Point], exact: Sequence[mp.mpf]) -> dict[str, list[Judged]]:
    """The emitted and the naive values: of many points with arrays, of one point with numbers."""
    known = entries(problem)
    entry = known[suffix]
    found = {}
    for name, function in (("emitted", emitted(entry, problem)), ("naive", naive(entry, known))):
        iterated = name == "naive" and entry.status == "root"  # one set of numbers at a time
        alone = len(points) == 1 or iterated
        values = [_value(function, point) for point in points] if alone else _values(function, points)
        found[name] = [judge(float(got), wanted) for got, wanted in zip(values, exact, strict=True)]
    return found


def _value(function: Function, point: Point) -> float:
    try:
        return float(np.squeeze(function(point)))
    except (ArithmeticError, ValueError):  # a power of Python numbers that overflows, an argument that is refused
        return math.nan


def _values(function: Function, points: Sequence[Point]) -> Array:
    columns = {symbol: np.array([point[symbol] for point in points]) for symbol in points[0]}
    return np.broadcast_to(function(columns), len(points))


def judge(got: float, exact: mp.mpf) -> Judged:
    error = relative(got, exact)
    ulp = float(np.spacing(abs(float(exact))))
    with mp.workdps(2 * DIGITS):
        return Judged(error, float(abs(mp.mpf(got) - exact) / ulp) if math.isfinite(got) else math.inf)
