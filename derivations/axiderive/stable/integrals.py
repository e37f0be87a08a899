"""Closed forms that cancel, taken back to the positive integrals they come from.

Differences of Legendre's chi functions of an arc, and incomplete Beta functions of a power-law contact.
"""

from __future__ import annotations

import sympy as sp

from ..abel.masters import IncompleteBeta, LegendreChi2
from ..notation import a, r
from .opaque import ArcStrips, PowerDisplacement, PowerPressure, PowerPunches


def arc_integrals(expr: sp.Expr) -> sp.Expr:
    """A pair chi(x) - chi(y), x and y = (a +- sqrt(a^2 - r^2))/(R + sqrt(R^2 - r^2)).

    It is int_r^a atanh(t/R)/sqrt(t^2 - r^2) dt: with chi'(x) = atanh(x)/x, x = r e^v/(R + sqrt(R^2 - r^2)) and
    t = r cosh v, both halves of the path add up to atanh(x(v)) + atanh(x(-v)) = atanh(t/R).
    """
    found = sorted(expr.atoms(LegendreChi2), key=sp.default_sort_key)
    if len(found) != 2:
        return expr
    tops, bottoms = zip(*(sp.fraction(call.args[0]) for call in found), strict=True)
    radius, half = (sum(tops) / 2, (tops[0] - tops[1]) / 2)
    lengths = [term for term in sp.Add.make_args(bottoms[0]) if term.is_Symbol]
    if bottoms[0] != bottoms[1] or not radius.is_Symbol or len(lengths) != 1:
        return expr
    (length,), square = lengths, sp.expand(tops[0] * tops[1])
    if sp.expand((bottoms[0] - length) ** 2 - length**2 + square) != 0:
        return expr
    larger, smaller = found if not half.could_extract_minus_sign() else found[::-1]
    strips = ArcStrips(sp.sqrt(square), radius, length)
    opened = sp.expand(expr.subs(larger, strips + smaller))
    if opened.has(LegendreChi2):
        return expr
    # atanh(sqrt(a^2 - r^2)/sqrt(R^2 - r^2)) keeps its digits through the root of the exact difference
    side = sp.sqrt(length**2 - radius**2)
    opened = opened.replace(sp.atanh, lambda x: sp.asinh(sp.numer(x) / side) if _leaves(x, side) else sp.atanh(x))
    return sp.factor_terms(opened)


def _leaves(quotient: sp.Expr, side: sp.Expr) -> bool:
    top, bottom = sp.fraction(quotient)
    return sp.expand(bottom**2 - top**2 - side**2) == 0


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
