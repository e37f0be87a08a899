"""One statement of a certificate: something vanishes on a domain, or is a known integral."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from ..abel.form import Chain
from ..entry import Case, Entry
from ..notation import N, a, coefficients, dgamma, j
from .algebra import special
from .algebra.domain import Domain, NotProvedError, require
from .algebra.functions import require_analytic, sign
from .algebra.identity import is_zero, logarithmic

Rule = tuple[tuple[str, ...], Callable[..., list[str]], *tuple[Any, ...]]
"""What a quantity rests on, what shows it, of the statements of the profile, and what that is told besides."""


def closed(entry: Entry) -> Entry:
    """The entry, if its formulas are closed."""
    if entry.status != "closed":
        reasons = {"integral": "an integral without a known closed form", "root": "the root of an equation"}
        message = f"{entry.key} is {reasons[entry.status]}"
        raise NotProvedError(message)
    return entry


def require_regions(entry: Entry, wanted: tuple[Chain, ...]) -> None:
    """Refuse an entry whose cases are not those of these regions, each once."""
    found = [case.chain for case in entry.cases]
    if len(found) != len(wanted) or set(found) != set(wanted):
        message = f"the cases of {entry.key} do not cover its regions once"
        raise NotProvedError(message)


def require_zero(expr: sp.Expr, domain: Domain, statement: str) -> str:
    """The statement as a step of the certificate, if the expression vanishes on the domain."""
    for part in by_power(expr, domain):
        require_analytic(part, domain)
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
    # a sum of multiples of the integrals, or any other function of them that its slopes make up
    require(is_zero(rest, domain), "{} is not a combination of functions whose integrals are stated", expr)
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


def by_power(expr: sp.Expr, domain: Domain) -> tuple[sp.Expr, ...]:
    """What has to vanish for an expression in sums to vanish: it without sums, and its slope along their terms.

    If the slope along the terms of every A[j] vanishes for all values of the sums, then the expression is the same at
    every combination of the terms as without sums.
    """
    sums = sorted(expr.atoms(sp.Sum), key=sp.default_sort_key)
    if not sums:
        return (expr,)
    stand_ins = {total: sp.Dummy("sum") for total in sums}
    linear = expr.xreplace(stand_ins)
    require_analytic(linear, domain)
    factors = {total: sp.diff(linear, stand_in) for total, stand_in in stand_ins.items()}
    rest = linear.xreplace(dict.fromkeys(stand_ins.values(), sp.S.Zero))
    return rest, sp.Add(*(factor * summand(total) for total, factor in factors.items()))


def paired(entry: Entry, plain: Entry) -> list[tuple[Case, Case]]:
    """The cases of an entry beside those of the entry it rests on, which are cases of the same regions."""
    if [case.chain for case in entry.cases] != [case.chain for case in plain.cases]:
        message = f"the cases of {entry.key} are not those of {plain.key}"
        raise NotProvedError(message)
    return list(zip(entry.cases, plain.cases, strict=True))


def retraction(own: Any) -> list[str]:
    """Griffith: the energy released at the edge of an adhesive contact equals the work of separation."""
    require_regions(own.entries["Dl"], ((a,),))
    shift, domain = own.entries["Dl"].cases[0].expr, own.normal.domain((a,))
    gap = own.medium.modulus * a**own.medium.k * shift**2 - 2 * sp.pi * a * dgamma
    require(sign(shift, domain) > 0, "the retraction is not shown to be positive")
    return [require_zero(gap, domain, "c_N(a) Dl^2 = 2 pi a dgamma, Dl > 0")]
