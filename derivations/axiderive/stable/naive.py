"""What `lambdify` makes of the printed formula: the form that the emitted one is measured beside."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sp

from ..entry import Case, Entry
from .samples import Floats

ELEMENTARY = (
    sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.sinh, sp.cosh, sp.tanh, sp.asinh, sp.acosh,
    sp.atanh,
)  # fmt: skip


def naive(entry: Entry) -> Callable[[Floats], float] | None:
    """The value at a point by the formula of its region; None where there is none, or NumPy lacks a function of it."""
    if entry.status != "closed" or entry.composed is not None:
        return None
    short = dict(entry.profile.abbreviations)
    exprs = [case.expr.subs(short) for case in entry.cases]
    if any(expr.has(sp.Integral, sp.Sum) or not expr.atoms(sp.Function) <= _elementary(expr) for expr in exprs):
        return None
    symbols = sorted(set[Any]().union(*(expr.free_symbols for expr in exprs)), key=str)
    functions = [sp.lambdify(symbols, expr, "numpy") for expr in exprs]

    def value(values: Floats) -> float:
        known = {str(symbol): number for symbol, number in values.items()}
        chosen = next((i for i, case in enumerate(entry.cases) if _holds(case, short, known)), None)
        if chosen is None:
            return float("nan")
        with np.errstate(all="ignore"):
            return float(functions[chosen](*(np.float64(known[str(symbol)]) for symbol in symbols)))

    return value


def _elementary(expr: sp.Expr) -> set[sp.Expr]:
    return {call for call in expr.atoms(sp.Function) if isinstance(call, ELEMENTARY)}


def _holds(case: Case, short: dict[sp.Symbol, sp.Expr], known: dict[str, float]) -> bool:
    lengths = [sp.sympify(x).subs(short) for x in case.chain]
    sizes = [float(x.subs({symbol: known[str(symbol)] for symbol in x.free_symbols})) for x in lengths]
    return all(low < high for low, high in zip(sizes, sizes[1:], strict=False))
