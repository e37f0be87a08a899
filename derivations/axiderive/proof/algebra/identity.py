"""Identities between functions of the tower, and values at an end of the domain.

Two elements that differ only in the spelling of functions (addition laws of
atanh, atan) are compared by one more derivative and an end value.
"""

from __future__ import annotations

import sympy as sp

from ...abel.masters import C0, Hypergeometric, IncompleteBeta
from ...notation import a
from .domain import Domain, NotProvedError, require
from .functions import as_given, canonical, margins, normal, require_analytic, sign, tower
from .tower import Element, Tower

DEPTH = 6
INFINITE = (sp.zoo, sp.nan, sp.oo, -sp.oo)


def is_zero(expr: sp.Expr, domain: Domain, depth: int = DEPTH) -> bool:
    """Whether the expression is shown to vanish on the whole domain.

    If a function survives linearly, with a coefficient c without zeros, then
    the expression is zero iff its quotient by c is constant and zero at one end.
    """
    expr = canonical(expr, domain)
    arithmetic = tower(domain, expr)
    element = arithmetic.collect(arithmetic.convert(expr))
    if not element:
        return True
    if depth == 0:
        return False
    linear = _linear_function(arithmetic, element)
    if linear is None:
        return False
    function, coefficient = linear
    inverse = arithmetic.power(coefficient, sp.S.NegativeOne)
    quotient = as_given(arithmetic.expr(arithmetic.collect(arithmetic.mul(element, inverse))), domain)
    # a derivative that vanishes makes constant only what is analytic between the point and the end
    if not analytic(quotient, domain):
        return False
    for variable in sorted(function.free_symbols, key=lambda s: (s not in domain.symbols, s != a, str(s))):
        if not is_zero(sp.diff(quotient, variable), domain, depth - 1):
            return False
        if _zero_at_an_end(quotient, variable, domain, depth - 1):
            return True
    return False


def analytic(expr: sp.Expr, domain: Domain) -> bool:
    """Whether the expression is shown to be real and analytic on the whole domain."""
    try:
        require_analytic(expr, domain)
    except NotProvedError:
        return False
    return True


def _zero_at_an_end(expr: sp.Expr, variable: sp.Symbol, domain: Domain, depth: int) -> bool:
    for value, face in domain.ends(variable):
        try:
            return is_zero(at(expr, variable, value), face, depth)
        except NotProvedError:
            continue
    return False


def _linear_function(arithmetic: Tower, element: Element) -> tuple[sp.Expr, Element] | None:
    """A function that occurs linearly and its coefficient without zeros; rather one of the lengths in the chain."""
    ring, ordered = arithmetic.ring, arithmetic.domain.symbols
    for symbol, function in sorted(arithmetic.functions.items(), key=lambda item: not item[1].free_symbols & ordered):
        generator = ring(symbol)
        if function.free_symbols and max(polynomial.degree(generator) for polynomial in element.values()) == 1:
            coefficient = {m: p.diff(generator) for m, p in element.items() if p.degree(generator) == 1}
            if arithmetic.sign(coefficient) != 0:
                return function, coefficient
    return None


def at(expr: sp.Expr, symbol: sp.Expr, value: sp.Expr, domain: Domain | None = None) -> sp.Expr:
    """The value at an end, by substitution; fails unless every part is finite and continuous there.

    The domain may tell the sign of exponents that their symbols leave open.
    """
    if domain is not None:
        expr = expr.replace(lambda node: _vanishes(node, symbol, value, domain), lambda _: sp.S.Zero)
    for node in sp.preorder_traversal(expr):
        if (node.is_Pow or node.is_Function) and node.has(symbol):
            _require_finite(node.subs(symbol, value), node, symbol, value, domain)
    return expr.subs(symbol, value)


def _vanishes(node: sp.Expr, symbol: sp.Expr, value: sp.Expr, domain: Domain) -> bool:
    """Whether a power has a vanishing base and an exponent that is positive on the domain."""
    if not (node.is_Pow and node.exp.free_symbols and not node.exp.has(symbol) and node.base.has(symbol)):
        return False
    return bool(node.base.subs(symbol, value) == 0 and sign(node.exp, domain) > 0)


def _require_finite(
    result: sp.Expr, node: sp.Expr, symbol: sp.Expr, value: sp.Expr, domain: Domain | None = None
) -> None:
    vanishing_base = result.is_Pow and result.base == 0
    if result.has(*INFINITE) or vanishing_base or _open(result, domain):
        message = f"{node} is not shown to be finite as {symbol} tends to {value}"
        raise NotProvedError(message)


def _open(result: sp.Expr, domain: Domain | None) -> bool:
    """Whether the argument is the end of the range of a function that is not shown to be finite there."""
    if isinstance(result, IncompleteBeta) and result.args[0] == 1:
        room = result.args[2]
    elif isinstance(result, Hypergeometric) and result.args[3] == 1:
        p, q, c, _ = result.args
        room = c - p - q
    else:
        return isinstance(result, C0 | sp.elliptic_f) and any(sp.expand(margin) == 0 for margin in margins(result))
    return not room.is_positive and (domain is None or sign(room, domain) <= 0)


def logarithmic(expr: sp.Expr, domain: Domain) -> sp.Expr:
    """atanh and log through logarithms of irreducible factors: singularities that cancel disappear."""
    rewritten = {}
    for function in expr.atoms(sp.log, sp.atanh):
        (x,) = function.args
        if isinstance(function, sp.log):
            rewritten[function] = _split_log(x, domain)
        else:
            rewritten[function] = _split_log(1 + x, domain) - _split_log(1 - x**2, domain) / 2
    return normal(canonical(expr.xreplace(rewritten), domain), domain)


def _split_log(argument: sp.Expr, domain: Domain) -> sp.Expr:
    """log of a product of positive factors, as it is written, as a sum over irreducible factors."""
    parts = (factor.as_base_exp() for factor in sp.Mul.make_args(argument))
    return sp.Add(*(exponent * _log_of_sum(base, domain) for base, exponent in parts))


def _log_of_sum(argument: sp.Expr, domain: Domain) -> sp.Expr:
    argument = canonical(argument, domain)
    arithmetic = tower(domain, argument)
    element = arithmetic.convert(argument)
    require(arithmetic.sign(element) > 0, "{} is not shown to be positive", argument)
    factors, rest = arithmetic.primitive(element)
    return sp.log(arithmetic.expr(rest)) + sp.Add(*(e * sp.log(f.as_expr()) for f, e in factors.items()))
