"""Incomplete Beta functions of a power-law contact as the positive integrals they come from."""

from __future__ import annotations

import sympy as sp

from ..abel.masters import IncompleteBeta
from ..notation import a, r
from .opaque import PowerDisplacement, PowerPressure, PowerPunches


def power_integrals(expr: sp.Expr) -> sp.Expr:
    """Every IncompleteBeta through an integral over the radius of the growing contact.

    With t = r/sqrt(1 - u) resp. t = r sqrt(u) in the definition of B(z; p, q):

        r**(n-1) B(1 - r^2/a^2; 1/2, (1-n)/2) = 2 int_r^a t**(n-1)/sqrt(t^2 - r^2) dt
        r**n B(a^2/r^2; (n+1)/2, 1/2) = 2 int_0^a t**n/sqrt(r^2 - t^2) dt

    and the second one by parts where a**n asin(a/r) stands against it.
    """
    if isinstance(expr, sp.Sum):
        return sp.Sum(power_integrals(expr.function), *expr.limits)
    if expr.has(sp.Sum):
        return expr.func(*(power_integrals(arg) for arg in expr.args))
    for beta in sorted(expr.atoms(IncompleteBeta), key=sp.default_sort_key):
        z, p, q = beta.args
        if p == sp.S.Half:
            n = sp.expand(1 - 2 * q)
            return _collected(expr.subs(beta, 2 * (a / r) ** (n - 1) * PowerPressure(r, a, n)))
        n = sp.expand(2 * p - 1)
        opposed = expr.subs(beta, 2 * (a / r) ** n * (sp.asin(a / r) - PowerDisplacement(r, a, n)))
        opposed = _collected(opposed)
        return (
            opposed
            if not opposed.has(sp.asin)
            else _collected(expr.subs(beta, 2 * (a / r) ** n * PowerPunches(r, a, n)))
        )
    return expr


def _collected(expr: sp.Expr) -> sp.Expr:
    terms = [sp.powsimp(sp.expand_power_base(term)) for term in sp.Add.make_args(sp.expand(sp.expand_power_base(expr)))]
    return sp.factor_terms(sp.Add(*terms))
