"""The rules of integration in the arithmetic of Arb, ten times as fast as mpmath's: for integrals inside integrals."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp
from flint import acb, arb, ctx, fmpq

from .rules import Number, Rule, middle

_root = sp.Function("root_of")
NATIVE: dict[str, Callable[..., arb]] = {
    "root_of": lambda x: x.sqrt(),
    "exp": lambda x: x.exp(),
    "sin": lambda x: x.sin(),
    "cos": lambda x: x.cos(),
    "tan": lambda x: x.tan(),
    "IncompleteBeta": lambda z, p, q: z.beta_lower(p, q),
}


@lru_cache(maxsize=1)
def functions() -> dict[str, Callable[..., arb]]:
    """By the name that lambdify prints."""
    from .balls import (
        FUNCTIONS,
        Ball,  # which measures a shape, as the callers of this module do
    )

    plain = Ball({}, False)

    def real(rule: Callable[..., acb]) -> Callable[..., arb]:
        return lambda *args: rule(plain, *map(acb, args)).real

    return {head.__name__: real(rule) for head, rule in FUNCTIONS.items()} | NATIVE


def ball(value: Number) -> arb:
    """The binary fraction that a number of mpmath is."""
    sign, mantissa, exponent, _ = value._mpf_
    return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))


def foreign(expr: sp.Expr) -> list[str]:
    """Names of the functions of an expression that Arb is not told."""
    return sorted({str(node.func) for node in expr.atoms(sp.Function)} - set(functions()))


@lru_cache(maxsize=512)
def _compiled(expr: sp.Expr, arguments: tuple[sp.Symbol, ...]) -> tuple[Callable[..., arb], tuple[sp.Expr, ...]]:
    """A function of the arguments and of the numbers that Python would read as floats."""
    rooted = expr.replace(
        lambda node: node.is_Pow and node.exp.is_Rational and node.exp.q == 2,
        lambda node: _root(node.base) ** node.exp.p,
    )
    unknown = foreign(rooted)
    if unknown:
        message = f"{expr} has the function {unknown[0]}, which Arb is not told; add it to balls.FUNCTIONS"
        raise ValueError(message)
    numbers = tuple(sorted((n for n in rooted.atoms(sp.Rational, sp.NumberSymbol) if not n.is_Integer), key=str))
    stand_ins = {n: sp.Symbol(f"number_{i}") for i, n in enumerate(numbers)}
    function = sp.lambdify(
        (*arguments, *stand_ins.values()), rooted.xreplace(stand_ins), modules=[functions()], cse=True
    )
    return function, numbers


def bound(expr: sp.Expr, variable: sp.Symbol, known: dict[sp.Symbol, Number]) -> Callable[[arb], arb]:
    """The expression as a function of balls, compiled when it is first called."""
    cell: list[Callable[[arb], arb]] = []

    def bind() -> Callable[[arb], arb]:
        function, numbers = _compiled(expr, (variable, *known))
        fixed = [*(ball(value) for value in known.values()), *(_constant(n) for n in numbers)]
        return lambda x: function(x, *fixed)

    def call(x: arb) -> arb:
        if not cell:
            cell.append(bind())
        return arb(cell[0](x))

    return call


def _constant(value: sp.Expr) -> arb:
    if value.is_Rational:
        return arb(fmpq(int(value.p), int(value.q)))
    return ball(value._to_mpmath(ctx.prec + 20))


def at_working_precision() -> Any:
    """Arb at the precision that mpmath has here."""
    return ctx.workprec(int(mp.mp.prec))


def sum_over_balls(
    f: Callable[[arb], arb], rule: Callable[..., Rule], of: tuple[Any, ...], start: Number, length: Number
) -> Number:
    """`rules.sum_over` for a function of balls."""
    origin, reach, total = ball(start), ball(length), arb(0)
    for x, weight in _nodes(rule, of):
        total += weight * f(origin + reach * x)
    return middle(total * abs(reach))


@lru_cache(maxsize=64)
def _nodes(rule: Callable[..., Rule], of: tuple[Any, ...]) -> tuple[tuple[arb, arb], ...]:
    return tuple((ball(x), ball(weight)) for x, weight in rule(*of))
