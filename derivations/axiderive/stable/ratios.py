"""Quotients of Gamma functions as one function."""

from __future__ import annotations

import sympy as sp

from .opaque import DepthOverHeight, GammaRatio


def gamma_ratios(expr: sp.Expr) -> sp.Expr:
    """gamma(x + 1/2)/gamma(x) as one function."""
    if not expr.args:
        return expr
    expr = expr.func(*(gamma_ratios(arg) for arg in expr.args))
    if isinstance(expr, sp.Sum) and expr.has(DepthOverHeight):
        number, term = expr.function.as_independent(*expr.function.free_symbols, as_Add=False)
        return number * sp.Sum(term, *expr.limits)
    if not expr.is_Mul:
        return expr
    powers = dict(factor.as_base_exp() for factor in expr.args)
    for lower, power in powers.items():
        upper = sp.gamma(sp.expand(lower.args[0] + sp.S.Half)) if isinstance(lower, sp.gamma) else None
        if powers.get(upper) == -power:
            return expr / lower**power * upper**power * _ratio(lower.args[0]) ** -power
    return expr


def _ratio(argument: sp.Expr) -> sp.Expr:
    """gamma(x + 1/2)/gamma(x); of half a whole number through the double factorials it stands for."""
    degree = 2 * argument - 1
    return DepthOverHeight(degree) / sp.sqrt(sp.pi) if degree.is_integer else GammaRatio(argument)
