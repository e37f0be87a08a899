"""Differences that `forms` leaves: angles of two roots, and polynomials on both sides of one root.

With q^2 - p^2 a product of exact differences, asin(p/q) = atan2(p, sqrt(q^2 - p^2))
and atanh(p/q) = asinh(p/sqrt(q^2 - p^2)) hold every digit.  An algebraic sum
X + Y z with z = sqrt(hi^2 - lo^2) becomes (X^2 - Y^2 z^2)/(X - Y z).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from .forms import EvaluationForm, evaluation_form
from .opaque import Arctan2, Root, named
from .signs import Facts, cancels, sign, squares
from .variants import FULL, Variant

ROOT, CONJUGATE = named("root"), named("conjugate")


def plane_form(expr: sp.Expr, facts: Facts, variant: Variant = FULL) -> EvaluationForm:
    """The evaluation form after both rewritings, as far as the variant has them."""
    angles = exact_angles(expr, facts, variant) if "angles" in variant.rules else expr
    form = evaluation_form(angles, facts, replace(variant, closed=False))
    if form.cancels and "conjugates" in variant.rules:
        form = _conjugated(angles, facts) or form
    return replace(form, cancels=form.cancels and not variant.closed)


def exact_angles(expr: sp.Expr, facts: Facts, variant: Variant = FULL) -> sp.Expr:
    """Inverse functions of a quotient of roots through the root of the exact difference."""
    tangent = (lambda y, x: sp.atan(y / x)) if variant.quotients else Arctan2

    def opened(angle: sp.Expr) -> sp.Expr:
        top, bottom = sp.fraction(angle.args[0])
        if not any(_is_root(factor) for factor in sp.Mul.make_args(bottom)):
            return angle
        side = _root_of(bottom**2 - top**2, facts)
        if side is None:
            return angle
        if isinstance(angle, sp.atanh):
            return sp.asinh(top / side)
        return tangent(top, side) if isinstance(angle, sp.asin) else tangent(side, top)

    return expr.replace(lambda e: isinstance(e, (sp.asin, sp.acos, sp.atanh)), opened)


def _is_root(factor: sp.Expr) -> bool:
    return bool(factor.is_Pow and factor.exp == sp.S.Half and factor.base.is_Add)


def _root_of(square: sp.Expr, facts: Facts) -> sp.Expr | None:
    """sqrt of a positive product of squares and one difference of squares."""
    letters = {symbol**2: sp.Dummy(symbol.name, positive=True) for symbol in square.free_symbols}
    back = {dummy: power for power, dummy in letters.items()}
    factors = sp.Mul.make_args(sp.factor(sp.expand(square).subs(letters)).subs(back))
    root = sp.S.One
    for factor in factors:
        base, exponent = factor.as_base_exp()
        if not base.is_Add:
            root *= sp.sqrt(abs(factor) if factor.is_number else factor)
            continue
        side = sign(base, facts) if squares(base) or squares(-base) else 0
        if side == 0 or exponent != 1:
            return None
        root *= sp.sqrt(base if side > 0 else sp.expand(-base))
    return root


def _conjugated(expr: sp.Expr, facts: Facts) -> EvaluationForm | None:
    """The form of a sum with one root, its algebraic part over the conjugate; None where that is no gain."""
    radicands = {e.base for e in expr.atoms(sp.Pow) if e.base.is_Add and e.exp.is_Rational and e.exp.q == 2}
    pair = squares(next(iter(radicands))) if len(radicands) == 1 else None
    if pair is None:
        return None
    rooted = expr.replace(
        lambda e: e.is_Pow and e.base in radicands and e.exp.is_Rational and e.exp.q == 2, lambda e: ROOT ** (2 * e.exp)
    )
    scale, inside = sp.factor_terms(rooted).as_independent(sp.Add, as_Add=False)
    algebraic, angles = sp.expand(inside).as_independent(sp.Function, as_Add=True)
    opened = _over_conjugate(algebraic, pair)
    if opened is None:
        return None
    top, conjugate = opened
    value = sp.factor_terms(scale * (top / CONJUGATE + _hyperbolic(angles, pair)))
    loses = cancels(value, facts) or cancels(conjugate, facts)
    form = EvaluationForm(((ROOT, Root(*pair)), (CONJUGATE, conjugate)), value, loses)
    return None if form.cancels else form


def _over_conjugate(expr: sp.Expr, pair: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr] | None:
    """(top, conjugate) of an algebraic sum of both kinds of terms."""
    high, low = pair
    top, bottom = sp.fraction(sp.together(expr))
    whole = sp.Poly(sp.rem(sp.expand(top), ROOT**2 - high**2 + low**2, ROOT), ROOT)
    plain, slope = whole.coeff_monomial(1), whole.coeff_monomial(ROOT)
    if plain == 0 or slope == 0:
        return None
    product = sp.factor(sp.expand(plain**2 - slope**2 * (high**2 - low**2)))
    below = _in_root(plain, pair) - _in_root(slope, pair) * ROOT
    if all(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(below))):
        product, below = -product, sp.expand(-below)
    content, below = sp.factor_terms(below).as_independent(sp.Add, as_Add=False)
    content, below = (content, below) if below.is_Add else (sp.S.One, content * below)
    return product / (bottom * content), below


def _in_root(polynomial: sp.Expr, pair: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """Even powers of the longer length through the root, if only that leaves one sign."""
    high, low = pair
    if not polynomial.is_Add or len({term.could_extract_minus_sign() for term in polynomial.args}) == 1:
        return polynomial
    terms = (
        factor * high ** (power % 2) * (ROOT**2 + low**2) ** (power // 2)
        for (power,), factor in sp.Poly(polynomial, high).terms()
    )
    return sp.expand(sp.Add(*terms))


def _hyperbolic(expr: sp.Expr, pair: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """acosh(high/low) as asinh of the root."""
    high, low = pair
    return expr.subs(sp.acosh(high / low), sp.asinh(ROOT / low))
