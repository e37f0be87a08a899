"""The printed formula as a first script has it, and its errors beside the emitted function's.

The printed closed form handed to sympy.lambdify, as a first script does it, with scipy.special.

Emitted and naive values at points in double precision, against Arb enclosures of the same closed form.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp
from scipy import optimize

from .. import notation as nt
from ..abel.masters import C0
from ..checks.comparison import inverse
from ..entry import Entry
from ..oracle.balls import NotAvailableError, enclose_value
from .report import relative
from .subject import FUNCTIONS, Array, Function, emitted, entries

Values = dict[sp.Symbol, Any]


def printed(entry: Entry) -> bool:
    """Whether there is a closed form to be handed on; what stays an integral is given to quadrature as it is."""
    return not any(case.expr.has(sp.Integral) for case in entry.cases)


def per_point(entry: Entry) -> bool:
    """Whether the naive form takes its points one by one."""
    return entry.status == "root" or any(case.expr.has(C0) for case in entry.cases)


def naive(entry: Entry, entries: dict[str, Entry]) -> Function:
    """The naive form, called with the values of its symbols; a root by brentq between the ends of its region."""
    return _at_root(entry, entries) if entry.status == "root" else _direct(entry)


def _direct(entry: Entry) -> Function:
    """One lambdified expression, a Piecewise where there are several regions."""
    regions = entry.regions()
    expr = regions[0][1]
    if len(regions) > 1:
        expr = sp.Piecewise(*((own, sp.And(*(low < high for low, high in pairs))) for pairs, own in regions))
    symbols = sorted(expr.free_symbols, key=str)
    function = sp.lambdify(symbols, expr, [FUNCTIONS, "numpy"])

    def call(values: Values) -> Array:
        with np.errstate(all="ignore"):
            try:
                # NumPy cannot join a condition on numbers with one on arrays
                return function(*np.broadcast_arrays(*(values[symbol] for symbol in symbols))) + 0.0
            except (ArithmeticError, ValueError):  # a power of floats that overflows, a root that is complex
                return np.nan

    return call


def _at_root(entry: Entry, entries: dict[str, Entry]) -> Function:
    """Brentq on the naive curve, then the naive outer formula; the stable branch begins at pull-off."""
    outer, inner = entry.composed or ("", entry.suffix)
    argument = entries[inner].quantity.arguments[0]
    curve, result = _direct(entries[argument.name]), _direct(entries[outer]) if outer else _radius
    pull_off = entries.get({nt.F: "ac", nt.d: "am"}[argument])
    chain, largest = entry.cases[0].chain, entry.profile.largest
    place = chain.index(nt.a) if nt.a in chain else 0
    # the last region reaches farthest
    above = entry.cases[-1].chain[entry.cases[-1].chain.index(nt.a) + 1 :] if nt.a in chain else ()
    bound = sp.sympify(next(iter(above), 1e6 if largest is None else largest))
    lengths = sorted(bound.free_symbols, key=str)
    highest = sp.lambdify(lengths, bound, "math")

    def one(values: Values, given: float) -> float:
        low = values[chain[place - 1]] * (1 + 1e-15) if place else 1e-12
        if pull_off is not None:
            low = max(low, float(_direct(pull_off)(values)))
        high = highest(*(values[symbol] for symbol in lengths)) * (1 - 1e-15)
        try:
            a = optimize.brentq(lambda a: curve({**values, nt.a: a}) - given, low, high, xtol=1e-300, rtol=1e-14)
        except (RuntimeError, ValueError):  # no convergence, no change of sign
            return float("nan")
        return float(result({**values, nt.a: a}))

    def call(values: Values) -> Array:
        return np.array([one(values, float(x)) for x in np.atleast_1d(values[argument])])

    return call


def _radius(values: Values) -> Array:
    return values[nt.a]


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
        """Whether the value was NaN or infinite."""
        return math.isinf(self.ulps)


def reference(problem: str, suffix: str, point: Point) -> mp.mpf | None:
    """The exact value, or None where no region holds the point, no enclosure is found, or no double is normal."""
    known = entries(problem)
    entry = known[suffix]
    try:
        if entry.status == "root":
            value = _value_at_root(known, suffix, point)
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


def _value_at_root(known: dict[str, Entry], suffix: str, point: Point) -> mp.mpf:
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
    """Relative error and error in units of the last place of a double against the exact value."""
    error = relative(got, exact)
    ulp = float(np.spacing(abs(float(exact))))
    with mp.workdps(2 * DIGITS):
        return Judged(error, float(abs(mp.mpf(got) - exact) / ulp) if math.isfinite(got) else math.inf)
