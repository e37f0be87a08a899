"""Expressions as they are printed: what two terms share stands before them, a power of a root is one power."""

from __future__ import annotations

import sympy as sp

from .. import notation as nt


def tidied(expr: sp.Expr) -> sp.Expr:
    """The same value; roots, differences and polynomials of the grading in the form that is read best."""
    expr = expr.replace(lambda e: e.is_Pow and not e.exp.is_number, _one_power)
    if expr.has(nt.k):
        expr = expr.replace(lambda e: e.is_Add, _by_lengths)
    return _difference(expr) if expr.has(nt.c) else expr


def _one_power(power: sp.Pow) -> sp.Expr:
    """sqrt(d R)**(k + 3) as (d R)**((k + 3)/2)."""
    factors = [factor.as_base_exp() for factor in sp.Mul.make_args(power.base)]
    if not all(e.is_Rational for _, e in factors) or any(e.is_Integer for base, e in factors if not base.is_number):
        return power
    index = sp.ilcm(1, *(e.q for _, e in factors))
    return sp.Pow(power.base**index, power.exp / index)


def _by_lengths(total: sp.Add) -> sp.Expr:
    """a**2 k + a**2 + 2 r**2 as (k + 1) a**2 + 2 r**2."""
    lengths = sorted(total.free_symbols - {nt.k}, key=str)
    if not lengths or nt.k not in total.free_symbols or not total.is_polynomial(nt.k, *lengths):
        return total
    terms = sp.Poly(total, *lengths).terms()
    return sp.Add(*(sp.factor(number) * sp.prod(x**n for x, n in zip(lengths, powers, strict=True))
                    for powers, number in terms))  # fmt: skip


def _difference(expr: sp.Expr) -> sp.Expr:
    """A state of the contact radius less the same of the stick radius: the factors of both, then the difference."""

    def factored(total: sp.Add) -> sp.Expr:
        sums = [term.as_independent(sp.Sum, as_Add=False)[1] for term in total.args]
        common = sp.factor_terms(total)
        if not all(isinstance(one, sp.Sum) for one in sums):
            return common
        scale, rest = common.as_independent(sp.Sum, as_Add=False)
        terms = [term.as_coeff_Mul() for term in sp.Add.make_args(rest)]
        function = sp.factor_terms(sum(sign * one.function for sign, one in terms))
        return scale * sp.Sum(function, *sums[0].limits)

    return expr.replace(lambda e: e.is_Add and e.has(nt.c) and len(e.args) == 2, factored)
