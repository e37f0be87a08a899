"""How large an expression is: whether its numbers are finite, and its terms when multiplied out."""

from __future__ import annotations

import math

import sympy as sp


def finite(number: sp.Expr) -> bool:
    try:
        return math.isfinite(abs(complex(number.evalf(15))))
    except OverflowError:
        return False


def terms(expr: sp.Expr) -> int:
    """How many terms `expand` makes of it."""
    if expr.is_Add:
        return sum(terms(arg) for arg in expr.args)
    if expr.is_Mul:
        return math.prod(terms(arg) for arg in expr.args)
    if expr.is_Pow and expr.exp.is_Integer:
        count, power = terms(expr.base), abs(int(expr.exp))
        return math.comb(count + power - 1, power) if count > 1 else 1
    return max([1, *(terms(arg) for arg in expr.args)])
