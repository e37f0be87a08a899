"""One number per function for its doctest, computed from the exact result and not by the emitted code."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from ..abel.masters import MASTERS
from ..entry import Case, Entry
from ..notation import F, N, a, coefficients, d, r, r_peak, r_zero
from ..profiles.profile import Profile

DIGITS = 6


def numbers(profile: Profile) -> dict[sp.Symbol, sp.Rational]:
    """Values of the parameters: those of the sketch, with unit modulus."""
    values = {symbol: sp.Rational(str(value)) for symbol, value in profile.sketch.values}
    return {symbol: value for symbol, value in values.items() if symbol in profile.parameters}


def field_values(profile: Profile, entries: Mapping[str, Entry]) -> dict[sp.Symbol, sp.Rational]:
    """a or d as drawn, r near the middle, and d and F rounded from what belongs to them."""
    known = environment(profile)
    if profile.complete:
        values = {d: sp.Rational(str(profile.sketch.d)), r: known[a] * sp.Rational(3, 10)}
        depth = known | values
    else:
        radius = sp.Rational(str(profile.sketch.a))
        values = {a: radius, r: radius * sp.Rational(3, 10)}
        values[d] = rounded(value(profile, entries["d"], known | {a: radius}))
        depth = known | {a: radius}
    values[F] = rounded(value(profile, entries["F"], depth))
    return values


def environment(profile: Profile) -> dict[sp.Symbol, sp.Expr]:
    """Exact values of all symbols but fields: parameters as sketched, E_star = 1, and the abbreviations."""
    known: dict[sp.Symbol, sp.Expr] = dict(numbers(profile))
    known[sp.Symbol("E_star", positive=True)] = sp.S.One
    return known | {symbol: expr.subs(known) for symbol, expr in profile.abbreviations}


def value(profile: Profile, entry: Entry, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """The exact result at these values, to 30 digits."""
    case = _case(entry, known)
    if isinstance(case.expr, sp.Equality):
        return _root(profile, entry, known)
    return number(_plain(case.expr), known)


def number(expr: sp.Expr, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """The value by mpmath at 30 digits; a definite integral by mpmath's quadrature."""
    with mp.workdps(30):
        for integral in expr.atoms(sp.Integral):
            variable, lower, upper = integral.subs(known).limits[0]
            integrand = sp.lambdify(variable, integral.subs(known).function, NUMERIC)
            ends = [mp.mpf(str(sp.N(end, 30))) for end in (lower, upper)]
            expr = expr.subs(integral, sp.Float(str(mp.re(mp.quad(integrand, ends, maxdegree=6))), 30))
        return sp.Float(str(mp.re(function(expr, known)())), 30)


def function(expr: sp.Expr, known: Mapping[sp.Symbol, sp.Expr], *unknown: sp.Symbol) -> Callable[..., Any]:
    """The expression as a function of what is unknown, over mpmath's numbers of the digits it works with.

    Numbers put into the expression by SymPy would take ten times as long.
    """
    symbols = sorted(expr.free_symbols - {*unknown}, key=str)
    values = [mp.mpf(str(sp.N(known[symbol], 40))) for symbol in symbols]
    evaluate = sp.lambdify((*unknown, *symbols), expr, NUMERIC)
    return lambda *given: evaluate(*given, *values)


def _plain(expr: sp.Expr) -> sp.Expr:
    """A sum over powers written out for the three coefficients of the example."""
    if expr.has(sp.Sum):
        expr = expr.subs(N, len(POLYNOMIAL)).doit().subs({coefficients[j]: c for j, c in enumerate(POLYNOMIAL, 1)})
    return expr


NUMERIC = [
    {"elliptic_f": mp.ellipf, "elliptic_e": mp.ellipe, **{master.__name__: master.numeric for master in MASTERS}},
    "mpmath",
]


def shape_value(profile: Profile, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """f(r) at these values."""
    for piece in profile.pieces:
        if piece.upper is None or known[r] < sp.N(piece.upper.subs(known), 30):
            expr = piece.expr
            break
    return number(_plain(expr), known)


POLYNOMIAL = (sp.Rational(1, 10), sp.Rational(1, 4), sp.Rational(1, 20))


def _case(entry: Entry, known: Mapping[sp.Symbol, sp.Expr]) -> Case:
    for case in entry.cases:
        lengths = [sp.N(known.get(x, x) if x.is_Atom else x.subs(known), 30) for x in map(sp.sympify, case.chain)]
        if all(x < y for x, y in zip(lengths, lengths[1:], strict=False) if x.is_number and y.is_number):
            return case
    message = f"{entry.key}: no case applies at {known}"
    raise ValueError(message)


def _root(profile: Profile, entry: Entry, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """Secant in the unknown from the drawn contact radius."""
    unknown = next((ring for ring in (r_zero, r_peak) if entry.cases[-1].expr.has(ring)), a)

    def residual(x: sp.Float) -> sp.Float:
        at = {**known, unknown: x}
        expr = _case(entry, at).expr
        return number(_plain(expr.lhs - expr.rhs), at)

    start = sp.Float(str(profile.sketch.a), 40) * (sp.Rational(2, 5) if unknown == r_zero else 1)
    if unknown == r_peak:
        start = (start + known[profile.breaks[0]]) / 2
    x, y = start, start * sp.Rational(1001, 1000)
    fx, fy = residual(x), residual(y)
    for _ in range(40):
        if fx == fy or abs(x - y) < sp.Float("1e-20") * abs(y):
            break
        x, y, fx = y, y - fy * (y - x) / (fy - fx), fy
        fy = residual(y)
    return y


def rounded(number: sp.Float) -> sp.Rational:
    """The number to four significant digits, as an exact rational."""
    return sp.Rational(str(sp.Float(str(number), 4)))


def literal(number: sp.Expr) -> str:
    """The number as a Python float in text."""
    return repr(float(number))


def result(number: sp.Float) -> str:
    """The number as `round(number, 6)` prints it."""
    return repr(round(float(number), DIGITS))
