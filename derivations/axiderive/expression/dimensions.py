"""Dimensions of the parameters of an expression: those that make f(r) a length, by linear algebra on its tree."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from .. import notation as nt
from .breaks import step
from .names import latex

SHARED = frozenset(["theta", "R", "R1", "R2", "b", "n", "h", "s", "wavelength"])
"""Letters that keep the unit, the domain and the meaning of the notation where these fit."""


class _InconsistentError(Exception):
    """No dimensions of the parameters make every sum homogeneous: bare numbers carry units."""


def records(tree: sp.Expr, parameters: Sequence[sp.Symbol]) -> tuple[list[nt.Notation], bool]:
    """The notation of the parameters, and whether their dimensions are known."""
    # b is the radius of a break only where it is one
    shared = [p for p in parameters if p.name in SHARED and (p.name != "b" or tree.has(step(p)))]
    given = {p: nt.describe(p).dimension.length for p in shared}
    for known in (given, {}):
        try:
            lengths = _lengths(tree, parameters, known)
        except _InconsistentError:
            continue
        return [_record(p, lengths[p], keep=p in known) for p in parameters], True
    return [_record(p, None, keep=False) for p in parameters], False


def _record(symbol: sp.Symbol, length: sp.Expr | None, *, keep: bool) -> nt.Notation:
    if keep:
        return nt.describe(symbol)
    unit = {None: "SI", 0: "1", 1: "m"}.get(length, f"m^({sp.sstr(length)})" if length is not None else "")
    dimension = nt.NUMBER if length is None else nt.Dimension(length, sp.S.Zero)
    name = symbol.name
    return nt.Notation(symbol, latex(name), dimension, unit, f"{name} > 0", "parameter of the profile")


def _lengths(
    tree: sp.Expr, parameters: Sequence[sp.Symbol], known: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    """Exponents of length, those left open set to 0."""
    unknown = {p: sp.Dummy(p.name) for p in parameters if p not in known}
    powers = {**known, **unknown, nt.r: sp.S.One}
    equations: list[sp.Expr] = []
    equations.append(_power(tree, powers, equations) - 1)
    open_ = list(unknown.values())
    conditions = [sp.expand(e) for e in equations if sp.expand(e) != 0]
    if not open_:
        if conditions:
            raise _InconsistentError
        return dict(known)
    try:
        solutions = sp.linsolve(conditions, open_) if conditions else sp.FiniteSet(tuple(open_))
    except (ValueError, sp.polys.polyerrors.PolynomialError) as error:  # a product of two unknown dimensions
        raise _InconsistentError from error
    if not solutions:
        raise _InconsistentError
    (values,) = solutions
    free = dict.fromkeys(open_, sp.S.Zero)
    return {**known, **{p: sp.sympify(v).xreplace(free) for p, v in zip(unknown, values, strict=True)}}


def _power(expr: sp.Expr, powers: Mapping[sp.Symbol, sp.Expr], equations: list[sp.Expr]) -> sp.Expr:
    """The exponent of length of an expression; what must vanish is added to the equations."""
    if expr.is_Symbol:
        return powers.get(expr, sp.S.Zero)  # a step is a number
    if expr.is_Add:
        first, *rest = (_power(arg, powers, equations) for arg in expr.args)
        equations.extend(first - other for other in rest)
        return first
    if expr.is_Mul:
        return sp.Add(*(_power(arg, powers, equations) for arg in expr.args))
    if expr.is_Pow:
        equations.append(_power(expr.exp, powers, equations))
        return sp.expand(_power(expr.base, powers, equations) * expr.exp)
    for arg in expr.args:
        equations.append(_power(arg, powers, equations))
    return sp.S.Zero
