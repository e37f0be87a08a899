"""One statement of a certificate: something vanishes on a domain, or is a known integral."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from ..entry import Case, Entry
from ..notation import N, coefficients, j
from . import special
from .domain import Domain, NotProvedError
from .functions import sign
from .identity import is_zero, logarithmic

Rule = tuple[tuple[str, ...], Callable[[Any], list[str]]]
"""What a quantity rests on, and what has to be shown for it."""


def require_zero(expr: sp.Expr, domain: Domain, statement: str) -> str:
    """The statement as a step of the certificate, if the expression vanishes on the domain."""
    for part in by_power(expr):
        if not is_zero(part, domain) and not (part.has(sp.log) and is_zero(logarithmic(part, domain), domain)):
            message = f"{statement} does not hold"
            raise NotProvedError(message)
    return statement


def require_integral(expr: sp.Expr, wanted: sp.Expr, variable: sp.Symbol, domain: Domain) -> str:
    """`expr` is the integral of `wanted` over 0 < variable < 1, because its functions are defined by such integrals."""
    pieces = {}
    for function in expr.atoms(sp.Function):
        found = special.integrand(function, variable)
        if found is None:
            continue
        pieces[function], margins = found
        if any(sign(margin, domain) <= 0 for margin in margins):
            message = f"the integral that defines {function} is not shown to exist"
            raise NotProvedError(message)
    stand_ins = {function: sp.Dummy("I") for function in pieces}
    linear = sp.expand(expr.xreplace(stand_ins))
    terms = [sp.diff(linear, stand_in) * pieces[function] for function, stand_in in stand_ins.items()]
    rest = linear - sp.Add(*(sp.diff(linear, stand_in) * stand_in for stand_in in stand_ins.values()))
    if not is_zero(rest, domain) or any(sp.diff(linear, s).has(*stand_ins.values()) for s in stand_ins.values()):
        message = f"{expr} is not a combination of functions whose integrals are stated"
        raise NotProvedError(message)
    return require_zero(sp.Add(*terms) - wanted, domain, f"integrand of {expr} over 0 < {variable} < 1 = {wanted}")


def summand(expr: sp.Expr) -> sp.Expr:
    """The term of a sum over powers with coefficient 1: all results are linear in the profile."""
    sums = expr.atoms(sp.Sum)
    if not sums:
        return expr
    (total,) = sums
    factor = expr.xreplace({total: j}) / j
    term = total.function / coefficients[j]
    if total.limits != ((j, 1, N),) or factor.has(j) or term.has(coefficients):
        message = f"{expr} is not a multiple of one sum over j = 1 ... N of A[j]"
        raise NotProvedError(message)
    return factor * term


def by_power(expr: sp.Expr) -> tuple[sp.Expr, ...]:
    """What has to vanish for an expression linear in sums over powers to vanish: the rest, and the term of A[j]."""
    sums = sorted(expr.atoms(sp.Sum), key=sp.default_sort_key)
    stand_ins = {total: sp.Dummy("sum") for total in sums}
    linear = expr.xreplace(stand_ins)
    factors = {total: sp.diff(linear, stand_in) for total, stand_in in stand_ins.items()}
    if any(factor.has(*stand_ins.values()) for factor in factors.values()):
        message = f"{expr} is not linear in its sums"
        raise NotProvedError(message)
    rest = linear.xreplace(dict.fromkeys(stand_ins.values(), sp.S.Zero))
    return (rest, sp.Add(*(factor * summand(total) for total, factor in factors.items()))) if sums else (rest,)


def paired(entry: Entry, plain: Entry) -> list[tuple[Case, Case]]:
    """The cases of an entry beside those of the entry it rests on, which are cases of the same regions."""
    if [case.chain for case in entry.cases] != [case.chain for case in plain.cases]:
        message = f"the cases of {entry.key} are not those of {plain.key}"
        raise NotProvedError(message)
    return list(zip(entry.cases, plain.cases, strict=True))
