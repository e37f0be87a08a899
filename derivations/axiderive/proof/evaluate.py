"""Results evaluated with mpmath to a stated number of digits, at exact points.

Two working precisions must agree, and the lower one starts above twice the
decades of the point: 1 - t**2 rounds to 1 for t = 1e-107 at 30, 60 and 120
digits alike, and three agreeing values of a hypergeometric function were 6 %
wrong there.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from functools import lru_cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import Case, Entry
from .shape import Number, Values, concrete, number, numeric_symbols

HIGHEST = 2000
"""Digits at which an evaluation that still does not settle is given up."""


@lru_cache(maxsize=4096)
def _compiled(expr: sp.Expr, arguments: tuple[sp.Symbol, ...]) -> Callable[..., Number]:
    own = {master.__name__: master.numeric for master in MASTERS}
    function: Callable[..., Number] = sp.lambdify(arguments, expr, modules=[own, "mpmath"], cse=True)
    return function


COMPARING = 400
"""Digits at which lengths are compared."""


def decades(values: Values) -> int:
    """How far apart, or how close, two lengths of the point are, in powers of ten."""
    lengths = [s for s in numeric_symbols(values) if nt.known(str(s)) and nt.describe(s).dimension == nt.LENGTH]
    with mp.workdps(COMPARING):
        sizes = [size for size in (number(values[s]) for s in lengths) if size]
        ratios = [x / y for x, y in itertools.combinations(sizes, 2)]
        measures = [*ratios, *(1 - ratio for ratio in ratios if ratio != 1)]
    return max((math.ceil(abs(mp.mag(x)) * math.log10(2)) for x in measures), default=0)


def evaluate(expr: sp.Expr, values: Values, digits: int) -> Number:
    """The value of expr, the same to `digits` digits at two precisions.

    Raises
    ------
    ArithmeticError
        If the value does not settle below HIGHEST digits.
    """
    function, symbols = _prepared(expr, values)
    precision = digits + 10 + 2 * decades(values)
    previous: Number | None = None
    while precision < HIGHEST:
        with mp.workdps(precision):
            value = mp.mpmathify(function(*[number(values[s]) for s in symbols]))
            if previous is not None and abs(value - previous) <= mp.mpf(10) ** -digits * abs(value):
                return _real(value, digits, expr)
        previous = value
        precision += max(20, precision // 4)
    message = f"{expr} does not settle to {digits} digits below {HIGHEST}; the point may be a zero of it"
    raise ArithmeticError(message)


def at_precision(expr: sp.Expr, values: Values) -> Number:
    """One evaluation at the working precision, for iterations; nothing is checked."""
    function, symbols = _prepared(expr, values)
    return function(*[number(values[s]) for s in symbols])


def _prepared(expr: sp.Expr, values: Values) -> tuple[Callable[..., Number], tuple[sp.Symbol, ...]]:
    plain = concrete(sp.sympify(expr), values)
    symbols = tuple(s for s in numeric_symbols(values) if plain.has(s))
    missing = plain.free_symbols - set(symbols)
    if missing:
        message = f"no value for {sorted(map(str, missing))} in {plain}; give every symbol of the result a value"
        raise ValueError(message)
    return _compiled(plain, symbols), symbols


def _real(value: Number, digits: int, expr: sp.Expr) -> Number:
    if isinstance(value, mp.mpc):
        if abs(value.imag) > mp.mpf(10) ** -digits * abs(value):
            message = f"{expr} has the complex value {mp.nstr(value, 8)}; the point lies outside its domain"
            raise ArithmeticError(message)
        return value.real
    return value


def holds(case: Case, values: Values) -> bool:
    """Whether the region of the case contains the point; lengths without a value are not compared."""
    with mp.workdps(COMPARING):
        known = [at_precision(x, values) for x in case.chain if not (x.free_symbols - set(values))]
    return all(lo < hi for lo, hi in zip(known, known[1:], strict=False))


def case_at(entry: Entry, values: Values) -> Case:
    """The case of the entry that holds at a point.

    Raises
    ------
    LookupError
        If none does.
    """
    for case in entry.cases:
        if holds(case, values):
            return case
    point = ", ".join(f"{s} = {values[s]}" for s in numeric_symbols(values))
    message = f"{entry.key}: no case holds at {point}; a point on a border belongs to no case"
    raise LookupError(message)
