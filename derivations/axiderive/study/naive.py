"""The printed closed form handed to sympy.lambdify, as a first script does it, with scipy.special."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp
from scipy import optimize

from .. import notation as nt
from ..abel.masters import C0
from ..entry import Entry
from .given import Function
from .special_functions import FUNCTIONS, Array

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
